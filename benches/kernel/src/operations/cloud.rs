//! Triangulations, cells, hulls and lines of equal height of 100,000 points.

use std::error::Error;

use katydid_geometry::cloud::{
    ConvexPolygon, Delaunay, Voronoi, convex_hull, convex_hull_3d, voronoi_cells_3d,
};
use katydid_geometry::isoline::{Metaballs, isolines};
use katydid_geometry::{BoundingBox, Interval, Plane, Point2, Point3};
use spade::{DelaunayTriangulation, Triangulation};

use super::{Operation, keep, operation};
use crate::Inputs;
use crate::timing::Contender;

/// The number of points, and of heights in a grid.
const COUNT: usize = 100_000;
/// The points a side of the grid.
const SIDE: usize = 316;
/// A side of the square and the box that the points lie in.
const SIZE: f64 = 1000.0;

/// Numbers from 0 to below 1, always the same.
fn numbers(mut state: u64) -> impl FnMut() -> f64 {
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn cloud_of(count: usize, size: f64) -> Vec<Point3> {
    let mut random = numbers(20);
    (0..count).map(|_| Point3::new(size * random(), size * random(), size * random())).collect()
}

/// Delaunay triangulation, Voronoi cells, convex hulls and lines of equal height. What is handed to a peer is in the
/// peer's own types, and what it gives is not put into ours.
///
/// # Errors
/// The kernel refuses an input.
pub fn cloud(_: &Inputs) -> Result<Vec<Operation>, Box<dyn Error>> {
    let space = cloud_of(COUNT, SIZE);
    let flat: Vec<Point2> = space.iter().map(|p| Point2::new(p.x, p.y)).collect();
    let range = Interval::new(0.0, SIZE);
    let border = ConvexPolygon::rectangle(range, range)?;
    Delaunay::new(&flat)?;
    let mut out = vec![triangulation(&flat), cells(&flat, border), hull(&flat), hull_in_space(&space)];
    let (a, b) = (space.clone(), flat);
    let bounds = BoundingBox { min: Point3::ORIGIN, max: Point3::new(SIZE, SIZE, SIZE) };
    out.push(operation(
        "100,000 Voronoi cells in space, against 100 times spade's triangulation in the plane",
        100.0,
        "spade",
        vec![
            Contender::new("katydid", 1, move || keep(voronoi_cells_3d(&a, &bounds))),
            Contender::new("spade", 1, move || keep(spade_triangulation(&b))),
        ],
    ));
    out.push(heights());
    out.push(metaballs()?);
    Ok(out)
}

fn spade_triangulation(points: &[Point2]) -> DelaunayTriangulation<spade::Point2<f64>> {
    let points = points.iter().map(|p| spade::Point2::new(p.x, p.y)).collect();
    DelaunayTriangulation::bulk_load(points).unwrap_or_default()
}

fn triangulation(flat: &[Point2]) -> Operation {
    let (a, b) = (flat.to_vec(), flat.to_vec());
    operation(
        "Delaunay triangulation of 100,000 points",
        1.5,
        "spade",
        vec![
            Contender::new("katydid", 1, move || keep(Delaunay::new(&a))),
            Contender::new("spade", 1, move || keep(spade_triangulation(&b))),
        ],
    )
}

fn cells(flat: &[Point2], border: ConvexPolygon) -> Operation {
    let (a, b) = (flat.to_vec(), flat.to_vec());
    operation(
        "Voronoi cells of 100,000 points, the peer's without a border",
        1.5,
        "spade",
        vec![
            Contender::new("katydid", 1, move || keep(Voronoi::new(&a, &border))),
            Contender::new("spade", 1, move || {
                let mesh = spade_triangulation(&b);
                let mut corners = Vec::with_capacity(6 * COUNT);
                let mut ends = Vec::with_capacity(COUNT);
                for cell in mesh.voronoi_faces() {
                    corners.extend(cell.adjacent_edges().filter_map(|e| e.from().position()));
                    ends.push(corners.len());
                }
                keep((corners, ends));
            }),
        ],
    )
}

fn hull(flat: &[Point2]) -> Operation {
    let (a, b) = (flat.to_vec(), flat.to_vec());
    let theirs: Vec<_> = b.iter().map(|p| parry2d_f64::math::Vector::new(p.x, p.y)).collect();
    operation(
        "convex hull of 100,000 points in the plane",
        1.5,
        "parry",
        vec![
            Contender::new("katydid", 1, move || keep(convex_hull(&a))),
            Contender::new("parry", 1, move || keep(parry2d_f64::transformation::convex_hull_idx(&theirs))),
        ],
    )
}

fn hull_in_space(space: &[Point3]) -> Operation {
    let ours = space.to_vec();
    let theirs: Vec<_> = space.iter().map(|p| parry3d_f64::math::Vector::new(p.x, p.y, p.z)).collect();
    operation(
        "convex hull of 100,000 points in space",
        1.5,
        "parry",
        vec![
            Contender::new("katydid", 1, move || keep(convex_hull_3d(&ours))),
            Contender::new("parry", 1, move || keep(parry3d_f64::transformation::convex_hull(&theirs))),
        ],
    )
}

/// A few waves over a grid.
fn heights() -> Operation {
    let values: Vec<f64> = (0..SIDE * SIDE)
        .map(|k| ((k % SIDE) as f64 * 0.21, (k / SIDE) as f64 * 0.17))
        .map(|(x, y)| x.sin() * y.cos() + (0.3 * (x + y)).sin())
        .collect();
    let theirs = values.clone();
    operation(
        "lines of equal height over 100,000 heights",
        1.5,
        "contour",
        vec![
            Contender::new("katydid", 1, move || keep(isolines(&values, SIDE, 0.25))),
            Contender::new("contour", 1, move || {
                keep(contour::ContourBuilder::new(SIDE, SIDE, true).lines(&theirs, &[0.25]));
            }),
        ],
    )
}

/// Balls in cells so fine that a full grid has 100,000.
fn metaballs() -> Result<Operation, Box<dyn Error>> {
    const BALLS: usize = 300;
    let size = 100.0;
    let points: Vec<Point3> = cloud_of(BALLS, size).iter().map(|p| Point3::new(p.x, p.y, 0.0)).collect();
    let (threshold, step) = (1.0, 2.0 * size / SIDE as f64);
    let field = Metaballs::new(&points, &[1.0], &Plane::XY)?;
    let full = field.clone();
    Ok(operation(
        "outlines of 300 metaballs, the peer on a full grid of 100,000",
        1.5,
        "contour",
        vec![
            Contender::new("katydid", 1, move || keep(field.isolines(threshold, step, usize::MAX))),
            Contender::new("contour", 1, move || {
                let at = |k: usize| step * k as f64 - 0.5 * size;
                let place = |k: usize| Point2::new(at(k % SIDE), at(k / SIDE));
                let values: Vec<f64> = (0..SIDE * SIDE).map(|k| full.at(place(k))).collect();
                keep(contour::ContourBuilder::new(SIDE, SIDE, true).lines(&values, &[threshold]));
            }),
        ],
    ))
}
