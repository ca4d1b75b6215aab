//! Wb Smoothen: vertices moved to the means of their neighbours.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Point3, Vector3};

use super::each;
use super::subdivision::Naked;
use crate::polygons::Polygons;

/// The most steps.
const MOST_STEPS: i32 = 10_000;

/// The neighbours that each point goes to the mean of; none for those that stay.
fn neighbours(polygons: &Polygons, naked: Naked) -> Vec<Vec<usize>> {
    let edges = polygons.edges();
    let boundary = polygons.naked_vertices();
    let mut faces = vec![0; polygons.points.len()];
    for &i in polygons.faces.iter().flatten() {
        if let Some(count) = faces.get_mut(i) {
            *count += 1;
        }
    }
    let rings = polygons.rings().into_iter().enumerate();
    rings
        .map(|(i, ring)| {
            if !boundary.contains(&i) {
                return ring;
            }
            let corner = faces.get(i).is_some_and(|count| *count == 1);
            if naked == Naked::Fixed || naked == Naked::CornerFixed && corner {
                return Vec::new();
            }
            let along = |j: &usize| edges.number(i, *j).is_some_and(|e| edges.is_naked(e));
            ring.into_iter().filter(along).collect()
        })
        .collect()
}

fn means(points: &[Point3], neighbours: &[Vec<usize>]) -> Vec<Point3> {
    let mean = |(p, near): (&Point3, &Vec<usize>)| {
        let sum =
            near.iter().filter_map(|&j| points.get(j)).fold(Vector3::ZERO, |sum, q| sum + q.to_vector());
        if near.is_empty() { *p } else { Point3::ORIGIN + sum / near.len() as f64 }
    };
    points.iter().zip(neighbours).map(mean).collect()
}

fn steps(level: i32) -> Result<i32, Message> {
    if (0..=MOST_STEPS).contains(&level) {
        Ok(level)
    } else {
        Err(Message::error(format!("The level is {level}: it must be from 0 to {MOST_STEPS}")))
    }
}

/// The smoothed points, and a part of the first ones.
fn thinned(polygons: Polygons, smooth: Vec<Point3>, thin: f64) -> Result<Polygons, Message> {
    if !thin.is_finite() {
        return Err(Message::error("The thinning is not finite"));
    }
    let points = polygons.points.iter().zip(smooth).map(|(p, q)| q.lerp(*p, thin)).collect();
    Ok(Polygons { points, faces: polygons.faces })
}

/// Moves each vertex to the mean of its neighbours, again and again. Stands for Weaverbird's Laplacian Smoothing; what thinning
/// does is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b21",
    name = "Laplacian Smoothing",
    nick = "wbLaplacian",
    at = "Weaverbird/Wb Smoothen"
)]
#[output(
    "Output Mesh/Curves",
    "O",
    "The results: meshes from meshes, closed polylines from closed polylines."
)]
fn laplacian(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Curves", "M")]
    bodies: List<Value>,
    /// The number of steps.
    #[port("Level", "L", default = 1)]
    level: i32,
    /// What becomes of naked edges: 0 they stay, 1 they are smoothed along themselves, 2 the same but corners stay.
    #[port("Smooth Naked Edges", "S", default = 1)]
    naked: i32,
    /// How much of the first mesh the result has: 0 nothing, 1 all.
    #[port("Thin", "T", default = 0.0)]
    thin: f64,
) -> Result<Vec<Value>, Message> {
    let (naked, level) = (Naked::of(naked)?, steps(level)?);
    each(context, &bodies, |body| {
        let near = neighbours(&body, naked);
        let mut points = body.points.clone();
        for _ in 0..level {
            context.check()?;
            points = means(&points, &near);
        }
        thinned(body, points, thin)
    })
}

/// Smooths a mesh without making it much smaller (J. Vollmer, R. Mencl and H. Müller, *Improved Laplacian smoothing of noisy
/// surface meshes*, 1999). Stands for Weaverbird's LaplacianHC Smoothing; which of its numbers is which of the paper's is our
/// reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b22",
    name = "LaplacianHC Smoothing",
    nick = "wbLaplacianHC",
    at = "Weaverbird/Wb Smoothen"
)]
#[output(
    "Output Mesh/Curves",
    "O",
    "The results: meshes from meshes, closed polylines from closed polylines."
)]
fn laplacian_hc(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Curves", "M")]
    bodies: List<Value>,
    /// The number of steps.
    #[port("Level", "L", default = 1)]
    level: i32,
    /// What becomes of naked edges: 0 they stay, 1 they are smoothed along themselves, 2 the same but corners stay.
    #[port("Smooth Naked Edges", "S", default = 1)]
    naked: i32,
    /// How much the place at first counts beside the one before the step, from 0 to 1: α of the paper.
    #[port("Partial-Original", "P", default = 0.0)]
    original: f64,
    /// How much a vertex is moved back by its own move beside those of its neighbours, from 0 to 1: β of the paper.
    #[port("Orientation", "O", default = 0.0)]
    own_part: f64,
    /// How far vertices are moved back, from 0 to 1; 0 is plain Laplacian smoothing.
    #[port("Volume-Saving activation", "A", default = 1.0)]
    activation: f64,
    /// How much of the first mesh the result has: 0 nothing, 1 all.
    #[port("Thin", "T", default = 0.0)]
    thin: f64,
) -> Result<Vec<Value>, Message> {
    let (naked, level) = (Naked::of(naked)?, steps(level)?);
    if !(original.is_finite() && own_part.is_finite() && activation.is_finite()) {
        return Err(Message::error("A number is not finite"));
    }
    each(context, &bodies, |body| {
        let near = neighbours(&body, naked);
        let mut points = body.points.clone();
        for _ in 0..level {
            context.check()?;
            let moved = means(&points, &near);
            let wanted = body.points.iter().zip(&points).map(|(first, last)| last.lerp(*first, original));
            let off: Vec<Vector3> = moved.iter().zip(wanted).map(|(p, q)| *p - q).collect();
            let back = |(i, near): (usize, &Vec<usize>)| {
                let own = off.get(i).copied().unwrap_or(Vector3::ZERO);
                let sum = near.iter().filter_map(|&j| off.get(j)).fold(Vector3::ZERO, |sum, d| sum + *d);
                let mean = if near.is_empty() { Vector3::ZERO } else { sum / near.len() as f64 };
                (own * own_part + mean * (1.0 - own_part)) * activation
            };
            let back: Vec<Vector3> = near.iter().enumerate().map(back).collect();
            let stays = |i: usize| near.get(i).is_none_or(Vec::is_empty);
            points = moved
                .iter()
                .zip(back)
                .enumerate()
                .map(|(i, (p, b))| if stays(i) { *p } else { *p + b * -1.0 })
                .collect();
        }
        thinned(body, points, thin)
    })
}

/// Moves each vertex to the mean of itself and its neighbours, again and again. Stands for Weaverbird's Blur Mesh; which mean it
/// takes is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b23",
    name = "Blur Mesh",
    nick = "wbBlur",
    at = "Weaverbird/Wb Smoothen"
)]
#[output(
    "Output Mesh/Curves",
    "O",
    "The results: meshes from meshes, closed polylines from closed polylines."
)]
fn blur(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Curves", "M")]
    bodies: List<Value>,
    /// The number of steps.
    #[port("Level", "L", default = 1)]
    level: i32,
    /// How much of the first mesh the result has: 0 nothing, 1 all.
    #[port("Thin", "T", default = 0.0)]
    thin: f64,
) -> Result<Vec<Value>, Message> {
    let level = steps(level)?;
    each(context, &bodies, |body| {
        let mut near = body.rings();
        for (i, ring) in near.iter_mut().enumerate().filter(|(_, ring)| !ring.is_empty()) {
            ring.push(i);
        }
        let mut points = body.points.clone();
        for _ in 0..level {
            context.check()?;
            points = means(&points, &near);
        }
        thinned(body, points, thin)
    })
}
