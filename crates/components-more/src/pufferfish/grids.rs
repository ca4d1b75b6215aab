//! Grids on surfaces and rectangles by parameters from 0 to 1.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Column, Path, Tree, TreeBuilder};
use katydid_geometry::{
    Curve, Direction, Interval, Mesh, MeshFace, Plane, Point3, PolylineCurve, Rectangle, Surface,
};

use super::MOST_PARTS;

/// Parameters that a list gives, as they stand.
fn parameters(list: &List<'_, f64>, name: &str) -> Result<Vec<f64>, Message> {
    let all: Vec<f64> = list.present().collect();
    if all.is_empty() || all.len() > MOST_PARTS || !all.iter().all(|t| t.is_finite()) {
        return Err(Message::error(format!("Parameters {name} must be numbers, at most {MOST_PARTS}")));
    }
    Ok(all)
}

/// Parameters of a surface's own domain.
fn on_surface(
    surface: &Surface,
    direction: Direction,
    list: &List<'_, f64>,
    name: &str,
) -> Result<Vec<f64>, Message> {
    let domain = surface.domain(direction);
    Ok(parameters(list, name)?.into_iter().map(|t| domain.at(t)).collect())
}

/// Rows of points as branches of a tree below the path of the call.
fn rows(context: &Context<'_>, rows: Vec<Column>) -> Tree {
    let mut builder = TreeBuilder::<katydid_data::Value>::new();
    let at = context.path();
    for (i, row) in rows.into_iter().enumerate() {
        builder.branch(child(&at, i));
        for value in row.iter() {
            builder.push(value);
        }
    }
    builder.finish()
}

fn child(path: &Path, i: usize) -> Path {
    path.child(i)
}

/// Outlines of the cells between points in rows.
fn outlines(points: &[Vec<Point3>]) -> Result<Vec<Shared<Curve>>, Message> {
    let mut cells = Vec::new();
    for pair in points.windows(2) {
        let [a, b] = pair else { continue };
        for (p, q) in a.windows(2).zip(b.windows(2)) {
            if let (&[p0, p1], &[q0, q1]) = (p, q) {
                cells.push(Shared::new(Curve::from(PolylineCurve::new(vec![p0, q0, q1, p1, p0])?)));
            }
        }
    }
    Ok(cells)
}

fn points_on(surface: &Surface, us: &[f64], vs: &[f64]) -> Vec<Vec<Point3>> {
    us.iter().map(|u| vs.iter().map(|v| surface.point_at(*u, *v)).collect()).collect()
}

fn room(context: &Context<'_>, us: &[f64], vs: &[f64], bytes: usize) -> Result<(), Message> {
    let count = us.len().saturating_mul(vs.len());
    context.items(count)?;
    context.bytes(count.saturating_mul(bytes))
}

/// A grid of four-sided cells on a surface. Stands for Pufferfish's Parameter Surface Grid; the order, along v first, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3052",
    name = "Parameter Surface Grid",
    nick = "ParamSrfGrid",
    at = "Pufferfish/Curve"
)]
#[output("Cells", "C", "The outlines of the cells, with straight sides.")]
#[output("Points", "P", "The corners of the grid.")]
fn surface_grid(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Where it is divided along u, from 0 to 1.
    #[port("Parameters U", "u")]
    us: List<f64>,
    /// Where it is divided along v, from 0 to 1.
    #[port("Parameters V", "v")]
    vs: List<f64>,
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>), Message> {
    let (us, vs) =
        (on_surface(surface, Direction::U, &us, "U")?, on_surface(surface, Direction::V, &vs, "V")?);
    room(context, &us, &vs, 400)?;
    let points = points_on(surface, &us, &vs);
    Ok((outlines(&points)?, points.concat()))
}

/// Isocurves of a surface at parameters. Stands for Pufferfish's Parameter Curve Divide Surface; the outputs are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3053",
    name = "Parameter Curve Divide Surface",
    nick = "ParamCrvDivSrf",
    at = "Pufferfish/Curve"
)]
#[output("Curves U", "U", "The curves that run along u.", kind = Curve)]
#[output("Curves V", "V", "The curves that run along v.", kind = Curve)]
fn surface_curves(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Where curves along v stand, from 0 to 1.
    #[port("Parameters U", "u", optional)]
    us: List<f64>,
    /// Where curves along u stand, from 0 to 1.
    #[port("Parameters V", "v", optional)]
    vs: List<f64>,
) -> Result<(Vec<Shared<Curve>>, Vec<Shared<Curve>>), Message> {
    context.items(us.len().saturating_add(vs.len()))?;
    let curves = |list: &List<'_, f64>, across: Direction, along: Direction| {
        let domain = surface.domain(across);
        list.present()
            .map(|t| {
                context.check()?;
                Ok(Shared::new(surface.isocurve(along, domain.clamp(domain.at(t)))?))
            })
            .collect::<Result<Vec<_>, Message>>()
    };
    Ok((curves(&vs, Direction::V, Direction::U)?, curves(&us, Direction::U, Direction::V)?))
}

/// A grid of points on a surface. Stands for Pufferfish's Parameter Point Divide Surface.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3054",
    name = "Parameter Point Divide Surface",
    nick = "ParamPtDivSrf",
    at = "Pufferfish/Point"
)]
#[output("Points", "P", "The points, a branch for each parameter of u.", kind = Point)]
fn surface_points(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Parameters of u, from 0 to 1.
    #[port("Parameters U", "u")]
    us: List<f64>,
    /// Parameters of v, from 0 to 1.
    #[port("Parameters V", "v")]
    vs: List<f64>,
) -> Result<Tree, Message> {
    let (us, vs) =
        (on_surface(surface, Direction::U, &us, "U")?, on_surface(surface, Direction::V, &vs, "V")?);
    room(context, &us, &vs, 24)?;
    let column = |row: Vec<Point3>| <Point3 as katydid_data::Item>::column(row, None);
    Ok(rows(context, points_on(surface, &us, &vs).into_iter().map(column).collect()))
}

/// A grid of planes on a surface, with z along its normals. Stands for Pufferfish's Parameter Plane Divide Surface.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3055",
    name = "Parameter Plane Divide Surface",
    nick = "ParamPlnDivSrf",
    at = "Pufferfish/Plane"
)]
#[output("Planes", "Pl", "The planes, a branch for each parameter of u; null where there is no normal.", kind = Plane)]
fn surface_planes(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Parameters of u, from 0 to 1.
    #[port("Parameters U", "u")]
    us: List<f64>,
    /// Parameters of v, from 0 to 1.
    #[port("Parameters V", "v")]
    vs: List<f64>,
) -> Result<Tree, Message> {
    let (us, vs) =
        (on_surface(surface, Direction::U, &us, "U")?, on_surface(surface, Direction::V, &vs, "V")?);
    room(context, &us, &vs, 100)?;
    let row = |u: f64| {
        let planes: Vec<Option<Plane>> = vs.iter().map(|v| surface.frame_at(u, *v)).collect();
        Column::of_options(planes.into_iter().map(|plane| plane.map(katydid_data::Value::from)).collect())
    };
    Ok(rows(context, us.iter().map(|u| row(*u)).collect()))
}

/// A point of a surface at parameters from 0 to 1. Stands for Pufferfish's Parameter Point On Surface; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3056",
    name = "Parameter Point On Surface",
    nick = "ParamPtOnSrf",
    at = "Pufferfish/Point"
)]
#[output("Point", "P", "The point.")]
fn surface_point(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The parameter of u.
    #[port("Parameter U", "u", default = 0.5)]
    u: f64,
    /// The parameter of v.
    #[port("Parameter V", "v", default = 0.5)]
    v: f64,
) -> Point3 {
    surface.point_at(surface.domain(Direction::U).at(u), surface.domain(Direction::V).at(v))
}

/// A plane on a surface at parameters from 0 to 1. Stands for Pufferfish's Parameter Plane On Surface; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3057",
    name = "Parameter Plane On Surface",
    nick = "ParamPlnOnSrf",
    at = "Pufferfish/Plane"
)]
#[output("Plane", "Pl", "The plane, with z along the normal; null where there is none.")]
fn surface_plane(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The parameter of u.
    #[port("Parameter U", "u", default = 0.5)]
    u: f64,
    /// The parameter of v.
    #[port("Parameter V", "v", default = 0.5)]
    v: f64,
) -> Option<Plane> {
    surface.frame_at(surface.domain(Direction::U).at(u), surface.domain(Direction::V).at(v))
}

/// The intervals between parameters in whatever order.
fn intervals_between(mut parameters: Vec<f64>) -> Vec<Interval> {
    parameters.sort_by(f64::total_cmp);
    parameters.dedup();
    parameters
        .windows(2)
        .filter_map(|pair| match pair {
            [a, b] => Some(Interval::new(*a, *b)),
            _ => None,
        })
        .collect()
}

/// The parts of a surface between parameters. Stands for Pufferfish's Parameter Subdivide Surface; that parameters count in rising order
/// is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3058",
    name = "Parameter Subdivide Surface",
    nick = "ParamSubDivSrf",
    at = "Pufferfish/Surface"
)]
#[output("Surfaces", "S", "The parts, along v first.")]
fn subdivide(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Where it is divided along u, from 0 to 1, in any order.
    #[port("Parameters U", "u")]
    us: List<f64>,
    /// Where it is divided along v, from 0 to 1, in any order.
    #[port("Parameters V", "v")]
    vs: List<f64>,
) -> Result<Vec<Shared<Surface>>, Message> {
    let (us, vs) =
        (on_surface(surface, Direction::U, &us, "U")?, on_surface(surface, Direction::V, &vs, "V")?);
    room(context, &us, &vs, 1000)?;
    let (us, vs) = (intervals_between(us), intervals_between(vs));
    if us.is_empty() || vs.is_empty() {
        context.warn("There are no parts: it takes two different parameters each way");
    }
    let mut parts = Vec::new();
    for u in &us {
        for v in &vs {
            context.check()?;
            parts.push(Shared::new(surface.sub_surface(*u, *v)?));
        }
    }
    Ok(parts)
}

/// A mesh of rows of points.
pub(super) fn mesh_of_rows(points: &[Vec<Point3>], triangulate: bool) -> Result<Mesh, Message> {
    let across = points.first().map_or(0, Vec::len);
    if points.len() < 2 || across < 2 {
        return Err(Message::error("A mesh needs at least two parameters each way"));
    }
    let number = |i: usize, j: usize| u32::try_from(i * across + j).unwrap_or(u32::MAX);
    let mut faces = Vec::new();
    for i in 1..points.len() {
        for j in 1..across {
            let [a, b, c, d] = [number(i - 1, j - 1), number(i, j - 1), number(i, j), number(i - 1, j)];
            if triangulate {
                faces.extend([MeshFace::Triangle([a, b, c]), MeshFace::Triangle([a, c, d])]);
            } else {
                faces.push(MeshFace::Quad([a, b, c, d]));
            }
        }
    }
    Ok(Mesh::new(points.concat(), faces)?.with_normals())
}

/// A mesh on a surface. Stands for Pufferfish's Parameter Surface Mesh.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3059",
    name = "Parameter Surface Mesh",
    nick = "ParamSrfMsh",
    at = "Pufferfish/Mesh"
)]
#[output("Mesh", "M", "The mesh.")]
fn surface_mesh(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Where it is divided along u, from 0 to 1.
    #[port("Parameters U", "u")]
    us: List<f64>,
    /// Where it is divided along v, from 0 to 1.
    #[port("Parameters V", "v")]
    vs: List<f64>,
    /// Whether faces are triangles.
    #[port("Triangulate", "T", default = false)]
    triangulate: bool,
) -> Result<Shared<Mesh>, Message> {
    let (us, vs) =
        (on_surface(surface, Direction::U, &us, "U")?, on_surface(surface, Direction::V, &vs, "V")?);
    room(context, &us, &vs, 100)?;
    Ok(Shared::new(mesh_of_rows(&points_on(surface, &us, &vs), triangulate)?))
}

/// Points of a rectangle at parameters.
fn in_rectangle(rectangle: &Rectangle, xs: &[f64], ys: &[f64]) -> Vec<Vec<Point3>> {
    let at = |x: f64, y: f64| rectangle.plane.at(rectangle.x.at(x), rectangle.y.at(y), 0.0);
    xs.iter().map(|x| ys.iter().map(|y| at(*x, *y)).collect()).collect()
}

/// A flat mesh in a rectangle. Stands for Pufferfish's Parameter Plane Mesh.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f305a",
    name = "Parameter Plane Mesh",
    nick = "ParamPlnMsh",
    at = "Pufferfish/Mesh"
)]
#[output("Mesh", "M", "The mesh.")]
fn plane_mesh(
    context: &Context<'_>,
    /// The rectangle.
    #[port("Rectangle", "R")]
    rectangle: Rectangle,
    /// Where it is divided along x, from 0 to 1.
    #[port("Parameters X", "x")]
    xs: List<f64>,
    /// Where it is divided along y, from 0 to 1.
    #[port("Parameters Y", "y")]
    ys: List<f64>,
    /// Whether faces are triangles.
    #[port("Triangulate", "T", default = false)]
    triangulate: bool,
) -> Result<Shared<Mesh>, Message> {
    let (xs, ys) = (parameters(&xs, "X")?, parameters(&ys, "Y")?);
    room(context, &xs, &ys, 100)?;
    Ok(Shared::new(mesh_of_rows(&in_rectangle(&rectangle, &xs, &ys), triangulate)?))
}

/// A grid of rectangles in a rectangle. Stands for Pufferfish's Parameter Rectangle Grid; the order, along y first, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f305b",
    name = "Parameter Rectangle Grid",
    nick = "ParamRecGrid",
    at = "Pufferfish/Curve"
)]
#[output("Cells", "C", "The cells.")]
#[output("Points", "P", "The corners of the grid.")]
fn rectangle_grid(
    context: &Context<'_>,
    /// The rectangle.
    #[port("Rectangle", "R")]
    rectangle: Rectangle,
    /// Where it is divided along x, from 0 to 1.
    #[port("Parameters X", "x")]
    xs: List<f64>,
    /// Where it is divided along y, from 0 to 1.
    #[port("Parameters Y", "y")]
    ys: List<f64>,
) -> Result<(Vec<Rectangle>, Vec<Point3>), Message> {
    let (xs, ys) = (parameters(&xs, "X")?, parameters(&ys, "Y")?);
    room(context, &xs, &ys, 200)?;
    let between = |list: &[f64], side: Interval| -> Vec<Interval> {
        let pair = |pair: &[f64]| match pair {
            [a, b] => Some(Interval::new(side.at(*a), side.at(*b))),
            _ => None,
        };
        list.windows(2).filter_map(pair).collect()
    };
    let (columns, rows) = (between(&xs, rectangle.x), between(&ys, rectangle.y));
    let cells = columns.iter().flat_map(|x| rows.iter().map(move |y| (*x, *y)));
    let cells = cells.map(|(x, y)| Rectangle { plane: rectangle.plane, x, y });
    Ok((cells.collect(), in_rectangle(&rectangle, &xs, &ys).concat()))
}

/// A net of curves on a surface: each goes over one side and under the next, as a wave, so that neighbours meet. Stands for Pufferfish's
/// Net On Surface; that curves swing by half their distance is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f305c",
    name = "Net On Surface",
    nick = "NetSrf",
    at = "Pufferfish/Curve"
)]
#[output("Curves", "C", "The curves.")]
fn net(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The number of curves.
    #[port("Count U", "U", default = 10)]
    curves: i32,
    /// The number of waves of each.
    #[port("Count V", "V", default = 10)]
    waves: i32,
    /// Whether curves run along u, not along v.
    #[port("Flip", "F", default = false)]
    flip: bool,
) -> Result<Vec<Shared<Curve>>, Message> {
    let count = |n: i32| usize::try_from(n).ok().filter(|n| (1..=MOST_PARTS).contains(n));
    let (Some(curves), Some(waves)) = (count(curves), count(waves)) else {
        return Err(Message::error("There must be at least one curve and one wave"));
    };
    context.items(curves)?;
    context.bytes(curves.saturating_mul(waves).saturating_mul(200))?;
    let (u, v) = (surface.domain(Direction::U), surface.domain(Direction::V));
    (0..curves)
        .map(|i| {
            context.check()?;
            // Points lie in turns half a step before and behind the middle of the curve's strip; neighbours mirror each other.
            let points: Vec<Point3> = (0..=2 * waves)
                .map(|j| {
                    let side = if (i + j) % 2 == 0 { 0.0 } else { 1.0 };
                    let (a, b) = ((i as f64 + side) / curves as f64, j as f64 / (2 * waves) as f64);
                    let (a, b) = if flip { (b, a) } else { (a, b) };
                    surface.point_at(u.at(a), v.at(b))
                })
                .collect();
            let curve = katydid_geometry::NurbsCurve::interpolate(
                3,
                &points,
                katydid_geometry::KnotSpacing::Chord,
                None,
                None,
            )?;
            Ok(Shared::new(Curve::from(curve)))
        })
        .collect()
}
