//! Goals-Mesh: areas, volumes, and evenness.

use std::collections::HashSet;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, Mesh, Point3, Vector3};

use super::folds::project;
use super::goal::finite;
use super::lines::stretch;
use super::loads::triangles;
use super::{Goal, Pull, Rule};

/// A triangle with surface tension: the force on a corner is the slope of its area.
#[derive(Debug)]
struct Film {
    strength: f64,
}

impl Rule for Film {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let [a, b, c] = points else { return };
        let Some(normal) = (*b - *a).cross(*c - *a).unitized() else { return };
        let corners = [(*a, *b, *c), (*b, *c, *a), (*c, *a, *b)];
        for ((p, q, r), pull) in corners.into_iter().zip(pulls) {
            let across = r - q;
            // Half the opposite side, turned in the plane: down the slope of the area (U. Pinkall and K. Polthier, *Computing
            // discrete minimal surfaces*, 1993). A third of the height is a move that all three can make together.
            let slope = across.cross(normal) * 0.5;
            let base = across.length();
            if base > 0.0 {
                let height = (p - q).cross(across).length() / base;
                let move_ = slope * (2.0 / base) * (height / 3.0);
                if height > 0.0 {
                    let sign = if slope.dot(p - q) > 0.0 { -1.0 } else { 1.0 };
                    *pull = Pull::new(move_ * sign, self.strength * 1.5 * base / height);
                }
            }
        }
    }
}

fn film(points: Vec<Point3>, strength: f64) -> Result<Value, Message> {
    Goal::item("Kangaroo goal: SoapFilm", points, Film { strength })
}

/// Makes the area of a mesh small, as a soap film does: a goal for each triangle; quads are two. The force on a vertex is the
/// strength times the slope of the area. Stands for Kangaroo 2's SoapFilm.
#[component(
    "76ab889c-8593-4892-861d-a80b5311a981",
    name = "SoapFilm",
    nick = "SG",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("Soap", "S", "The goals, for a solver, in order of the triangles.")]
fn soap_film(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The strength: the tension of the film.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Vec<Value>, Message> {
    let strength = finite(strength, "The strength")?;
    let triangles = triangles(mesh);
    context.items(triangles.len())?;
    triangles.into_iter().map(|t| film(t.to_vec(), strength)).collect()
}

/// Makes the area of a triangle small, as a soap film does. Stands for an earlier SoapFilm of Kangaroo 2.
#[component(
    "0c68b153-3c88-4e62-9827-f3793c013f88",
    name = "SoapFilm",
    nick = "SG",
    at = "Kangaroo2/Goals-Mesh",
    old
)]
#[output("Soap", "S", "The goal, for a solver.")]
fn soap_triangle(
    /// The three corners.
    #[port("Pts", "Pts")]
    points: List<Point3>,
    /// The strength: the tension of the film.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let points: Vec<Point3> = points.present().collect();
    if points.len() != 3 {
        return Err(Message::error(format!("A triangle has 3 corners, not {}", points.len())));
    }
    film(points, finite(strength, "The strength")?)
}

/// A mesh that encloses a volume.
#[derive(Debug)]
struct Volume {
    triangles: Vec<[u32; 3]>,
    volume: f64,
    strength: f64,
}

impl Rule for Volume {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let Some(middle) = Point3::mean(points) else { return };
        let mut slopes = vec![Vector3::ZERO; points.len()];
        let mut volume = 0.0;
        for &corners in &self.triangles {
            let at = |i: u32| points.get(i as usize).map_or(Vector3::ZERO, |p| *p - middle);
            let [a, b, c] = corners.map(at);
            volume += a.dot(b.cross(c)) / 6.0;
            for (i, slope) in corners.into_iter().zip([b.cross(c), c.cross(a), a.cross(b)]) {
                if let Some(sum) = slopes.get_mut(i as usize) {
                    *sum += slope / 6.0;
                }
            }
        }
        project(&slopes, volume - self.volume, self.strength, pulls);
    }
}

/// The vertices of a mesh with those in one place taken as one, and its triangles in their numbers.
fn merged(mesh: &Mesh) -> (Vec<Point3>, Vec<[u32; 3]>) {
    let first = mesh.merged_indices();
    let mut numbers = vec![0_u32; first.len()];
    let mut points = Vec::new();
    for (i, (p, m)) in mesh.vertices().iter().zip(&first).enumerate() {
        if i == *m as usize {
            if let (Some(slot), Ok(n)) = (numbers.get_mut(i), u32::try_from(points.len())) {
                *slot = n;
            }
            points.push(*p);
        }
    }
    let number = |i: u32| {
        let own = first.get(i as usize).copied().unwrap_or(i);
        numbers.get(own as usize).copied().unwrap_or(0)
    };
    let triangles = mesh.faces().iter().flat_map(|face| face.triangles()).map(|t| t.map(number)).collect();
    (points, triangles)
}

/// Keeps the volume that a mesh encloses. Stands for Kangaroo 2's Volume.
#[component(
    "26efde70-0c5c-4181-af3e-1a767d64b449",
    name = "Volume",
    nick = "Volume",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("V", "V", "The goal, for a solver.")]
fn volume(
    /// The mesh; an open one is closed by a point in its middle.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The volume, in cubic units; the one that it has when nothing is given.
    #[port("Volume", "V", optional)]
    volume: Option<f64>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let (points, triangles) = merged(mesh);
    let middle = Point3::mean(&points).unwrap_or(Point3::ORIGIN);
    let own =
        mesh.triangles().map(|[a, b, c]| (a - middle).dot((b - middle).cross(c - middle)) / 6.0).sum::<f64>();
    let volume = finite(volume.unwrap_or(own), "The volume")?;
    Goal::item(
        "Kangaroo goal: Volume",
        points,
        Volume { triangles, volume, strength: finite(strength, "The strength")? },
    )
}

/// A flat polygon of an area.
#[derive(Debug)]
struct Area {
    area: f64,
    strength: f64,
}

impl Rule for Area {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let n = points.len();
        let at = |i: usize| points.get(i % n.max(1)).copied().unwrap_or(Point3::ORIGIN);
        let origin = at(0);
        let whole = (0..n).fold(Vector3::ZERO, |sum, i| sum + (at(i) - origin).cross(at(i + 1) - origin));
        let Some(normal) = whole.unitized() else { return };
        let slopes: Vec<Vector3> = (0..n).map(|i| (at(i + 1) - at(i + n - 1)).cross(normal) * 0.5).collect();
        project(&slopes, 0.5 * whole.length() - self.area, self.strength, pulls);
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        let mut points = points.to_vec();
        points.extend(points.first().copied());
        super::utility::polyline(points)
    }
}

/// Brings a closed polyline to an area. Stands for Kangaroo 2's PolygonArea.
#[component(
    "f4b4e68f-150f-4c3f-bc52-cf5ec4047f79",
    name = "PolygonArea",
    nick = "PolygonArea",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("A", "A", "The goal, for a solver.")]
fn polygon_area(
    /// The polyline.
    #[port("Polyline", "Polyline")]
    curve: &Curve,
    /// The area, in square units.
    #[port("Area", "Area", default = 1.0)]
    area: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let mut points = curve.as_polyline().ok_or_else(|| Message::error("The curve is not a polyline"))?;
    if points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    if points.len() < 3 {
        return Err(Message::error("A polygon has at least 3 corners"));
    }
    let rule = Area { area: finite(area, "The area")?, strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: PolygonArea", points, rule)
}

/// A point pulled to the mean of its neighbours, which are pushed back as much together; within the surface only it moves alone,
/// as what would be within its own tangent plane leads the neighbours out of theirs, and the surface would grow.
#[derive(Debug)]
struct Smooth {
    tangential: bool,
    strength: f64,
}

impl Rule for Smooth {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let (Some((p, around)), Some((own, others))) = (points.split_first(), pulls.split_first_mut()) else {
            return;
        };
        let Some(mean) = Point3::mean(around) else { return };
        let mut way = mean - *p;
        if self.tangential {
            let n = around.len();
            let at = |i: usize| around.get(i % n).copied().unwrap_or(*p) - *p;
            let normal = (0..n).fold(Vector3::ZERO, |sum, i| sum + at(i).cross(at(i + 1)));
            if let Some(normal) = normal.unitized() {
                way = way - normal * way.dot(normal);
            }
        }
        *own = Pull::new(way * 0.5, self.strength);
        if self.tangential {
            return;
        }
        let back = way * (-0.5 / around.len() as f64);
        others.fill(Pull::new(back, self.strength));
    }
}

/// The inner vertices of a mesh, each followed by its neighbours in order around it. Vertices in one place are one.
pub(super) fn rings(mesh: &Mesh) -> Vec<Vec<Point3>> {
    let topology = crate::polygons::Polygons::of_mesh(mesh);
    let naked: HashSet<usize> = topology.naked_vertices();
    let rings = topology.rings();
    let at = |i: usize| topology.points.get(i).copied();
    rings
        .into_iter()
        .enumerate()
        .filter(|(i, ring)| !naked.contains(i) && ring.len() > 2)
        .map(|(i, ring)| std::iter::once(i).chain(ring).filter_map(at).collect())
        .collect()
}

fn smoothing(
    context: &Context<'_>,
    mesh: &Mesh,
    tangential: bool,
    strength: f64,
) -> Result<Vec<Value>, Message> {
    let strength = finite(strength, "The strength")?;
    context.items(mesh.vertices().len())?;
    let goal = |ring| Goal::item("Kangaroo goal: Smooth", ring, Smooth { tangential, strength });
    rings(mesh).into_iter().map(goal).collect()
}

/// Pulls the inner vertices of a mesh to the means of their neighbours: a goal for each. Stands for Kangaroo 2's Smooth.
#[component(
    "0b7b2ba2-7ecd-4f33-b138-883f6e96d08c",
    name = "Smooth",
    nick = "Smooth",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("P", "P", "The goals, for a solver, in order of the inner vertices.")]
fn smooth(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Vec<Value>, Message> {
    smoothing(context, mesh, false, strength)
}

/// Pulls the inner vertices of a mesh to the means of their neighbours, within the surface only: a goal for each. Stands for
/// Kangaroo 2's TangentialSmooth.
#[component(
    "72dadfdd-3be9-44e3-a352-9343f3d5d3b1",
    name = "TangentialSmooth",
    nick = "TSmooth",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("P", "P", "The goals, for a solver, in order of the inner vertices.")]
fn tangential_smooth(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Vec<Value>, Message> {
    smoothing(context, mesh, true, strength)
}

/// Four corners of two triangles whose incircles touch: opposite sides of the quadrilateral around them have equal sums.
#[derive(Debug)]
struct Incircles {
    strength: f64,
}

impl Rule for Incircles {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let [start, end, first, second] = points else { return };
        // Around the edge: start, first, end, second. Incircles touch in one point where |s f| + |e g| = |f e| + |g s|.
        let sides = [(0, 2, 1.0), (1, 3, 1.0), (2, 1, -1.0), (3, 0, -1.0)];
        let at = [*start, *end, *first, *second];
        let point = |i: usize| at.get(i).copied().unwrap_or(Point3::ORIGIN);
        let lack: f64 = sides.iter().map(|(i, j, sign)| sign * point(*i).distance_to(point(*j))).sum();
        let mut sums = [Vector3::ZERO; 4];
        for (i, j, sign) in sides {
            let mut two = [Pull::NONE; 2];
            let length = point(i).distance_to(point(j));
            stretch(&[point(i), point(j)], length - sign * lack / 4.0, 1.0, &mut two);
            for (k, pull) in [i, j].into_iter().zip(two) {
                if let Some(sum) = sums.get_mut(k) {
                    *sum += pull.by;
                }
            }
        }
        for (pull, sum) in pulls.iter_mut().zip(sums) {
            *pull = Pull::new(sum, self.strength);
        }
    }
}

/// Makes the incircles of two triangles on an edge touch each other. Stands for an earlier TangentIncircles of Kangaroo 2.
#[component(
    "56e9e40d-6d2f-4daf-9316-034f30cf24a0",
    name = "TangentIncircles",
    nick = "TangentIncircles",
    at = "Kangaroo2/Goals-Mesh",
    old
)]
#[output("TI", "TI", "The goal, for a solver.")]
fn tangent_incircles(
    /// The start of the edge.
    #[port("EdgeStart", "EdgeStart")]
    start: Point3,
    /// The end of the edge.
    #[port("EdgeEnd", "EdgeEnd")]
    end: Point3,
    /// The tip of the first triangle.
    #[port("Tip1", "Tip1")]
    first: Point3,
    /// The tip of the second triangle.
    #[port("Tip2", "Tip2")]
    second: Point3,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let rule = Incircles { strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: TangentIncircles", vec![start, end, first, second], rule)
}
