//! Intersect / Mathematical: lines, planes, and where curves meet them.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Curve, Line, Mesh, Plane, Point3, Vector3, intersect, region};

use super::planes;
use crate::prepared;

/// A place in a plane's coordinates.
fn coordinates(plane: &Plane, p: Point3) -> Point3 {
    let [u, v, _] = plane.coordinates(p);
    Point3::new(u, v, 0.0)
}

/// The parameters at which a curve meets a line without ends, in order. A stretch that they share counts with its two
/// ends.
fn on_line(context: &Context<'_>, curve: &Curve, line: Line) -> Result<Vec<f64>, Message> {
    let line = line.beside(&curve.bounding_box());
    let line = line.ok_or_else(|| Message::error("The line has no direction"))?;
    let found = intersect::curve_curve(curve, &Curve::from(line), context.tolerance().absolute)?;
    let mut places: Vec<f64> = found.crossings.iter().map(|c| c.a).collect();
    places.extend(found.overlaps.iter().flat_map(|o| [o.a.start, o.a.end]));
    places.sort_by(f64::total_cmp);
    Ok(places)
}

/// Where a curve meets a line without ends, in the order of the curve.
///
/// A stretch that they share counts with its two ends. Nothing is found where they pass each other by more than the
/// tolerance.
#[component(
    "0e3173b6-91c6-4845-a748-e45d4fdbc262",
    name = "Curve | Line",
    nick = "CLX",
    at = "Intersect/Mathematical"
)]
#[output("Points", "P", "The points.")]
#[output("Params", "t", "Their parameters on the curve.")]
#[output("Count", "N", "How many there are.")]
fn curve_line(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The line; it goes on beyond its ends.
    #[port("Line", "L")]
    line: Line,
) -> Result<(Vec<Point3>, Vec<f64>, i32), Message> {
    let places = on_line(context, curve, line)?;
    let n = i32::try_from(places.len()).unwrap_or(i32::MAX);
    Ok((curve.points_at(&places), places, n))
}

/// Where a curve meets a line without ends. Another form of the component of the same name.
#[component(
    "9396be03-8159-43bf-b3e7-2c86c8d04fc0",
    name = "Curve | Line",
    nick = "CLX",
    at = "Intersect/Mathematical",
    old
)]
#[output("Points", "P", "The points.")]
#[output("Params", "t", "Their parameters on the curve.")]
#[output("Count", "N", "How many there are.")]
fn curve_line_first(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The line.
    #[port("Line", "L")]
    line: Line,
    /// Whether only the first meeting along the line is wanted, from far behind its start.
    #[port("First", "F", default = false)]
    first: bool,
) -> Result<(Vec<Point3>, Vec<f64>, i32), Message> {
    let mut places = on_line(context, curve, line)?;
    if first {
        let along = |t: f64| line.closest_parameter(curve.point_at(t));
        places = places.into_iter().min_by(|&a, &b| along(a).total_cmp(&along(b))).into_iter().collect();
    }
    let n = i32::try_from(places.len()).unwrap_or(i32::MAX);
    Ok((curve.points_at(&places), places, n))
}

/// Where a curve meets a line without ends. An early form of Curve | Line.
#[component(
    "ddaea1a9-d6bd-4a18-ac11-8a4993954a03",
    name = "Curve | Line [OBSOLETE]",
    nick = "CLX",
    at = "Intersect/Mathematical",
    old
)]
#[output("Points", "P", "The points.")]
#[output("Params", "t", "Their parameters on the curve.")]
fn early_curve_line(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The line; it goes on beyond its ends.
    #[port("Line", "L")]
    line: Line,
) -> Result<(Vec<Point3>, Vec<f64>), Message> {
    let places = on_line(context, curve, line)?;
    Ok((curve.points_at(&places), places))
}

/// Where a curve meets a plane, in the order of the curve.
///
/// A stretch that lies in the plane counts with its two ends.
#[component(
    "b7c12ed1-b09a-4e15-996f-3fa9f3f16b1c",
    name = "Curve | Plane",
    nick = "PCX",
    at = "Intersect/Mathematical"
)]
#[output("Points", "P", "The points.")]
#[output("Params C", "t", "Their parameters on the curve.")]
#[output("Params P", "uv", "Their coordinates in the plane.")]
fn curve_plane(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The plane, without end.
    #[port("Plane", "P")]
    plane: Plane,
) -> Result<(Vec<Point3>, Vec<f64>, Vec<Point3>), Message> {
    let places = planes::places_in(context, curve, &plane)?;
    let points: Vec<Point3> = places.iter().map(|&t| curve.point_at(t)).collect();
    let uv = points.iter().map(|&p| coordinates(&plane, p)).collect();
    Ok((points, places, uv))
}

/// Where two lines without ends come nearest to each other.
///
/// Parameters are 0 at the start of a line and 1 at its end. Parallel lines have no such place: a warning.
#[component(
    "6d4b82a7-8c1d-4bec-af7b-ca321ba4beb1",
    name = "Line | Line",
    nick = "LLX",
    at = "Intersect/Mathematical"
)]
#[output("Param A", "tA", "The parameter on the first line.")]
#[output("Param B", "tB", "The parameter on the second line.")]
#[output("Point A", "pA", "The point on the first line.")]
#[output("Point B", "pB", "The point on the second line.")]
fn line_line(
    /// A line.
    #[port("Line 1", "A")]
    a: Line,
    /// Another line.
    #[port("Line 2", "B")]
    b: Line,
) -> Result<(f64, f64, Point3, Point3), Message> {
    let (s, t) = intersect::line_line(&a, &b).ok_or_else(|| Message::warning("The lines are parallel"))?;
    Ok((s, t, a.at(s), b.at(t)))
}

/// Where a line without ends meets a plane.
///
/// The parameter is 0 at the start of the line and 1 at its end. A parallel line has no such place: a warning.
#[component(
    "75d0442c-1aa3-47cf-bd94-457b42c16e9f",
    name = "Line | Plane",
    nick = "PLX",
    at = "Intersect/Mathematical"
)]
#[output("Point", "P", "The point.")]
#[output("Param L", "t", "Its parameter on the line.")]
#[output("Param P", "uv", "Its coordinates in the plane.")]
fn line_plane(
    /// The line.
    #[port("Line", "L")]
    line: Line,
    /// The plane, without end.
    #[port("Plane", "P")]
    plane: Plane,
) -> Result<(Point3, f64, Point3), Message> {
    let t = intersect::line_plane(&line, &plane);
    let t = t.ok_or_else(|| Message::warning("The line is parallel to the plane"))?;
    let point = line.at(t);
    Ok((point, t, coordinates(&plane, point)))
}

fn meet(a: &Plane, b: &Plane) -> Result<Line, Message> {
    intersect::plane_plane(a, b).ok_or_else(|| Message::warning("The planes are parallel"))
}

/// The line in which two planes meet; it has no particular length.
///
/// Parallel planes have none: a warning.
#[component(
    "290cf9c4-0711-4704-851e-4c99e3343ac5",
    name = "Plane | Plane",
    nick = "PPX",
    at = "Intersect/Mathematical"
)]
#[output("Line", "L", "A piece of the line.")]
fn plane_plane(
    /// A plane.
    #[port("Plane A", "A")]
    a: Plane,
    /// Another plane.
    #[port("Plane B", "B")]
    b: Plane,
) -> Result<Line, Message> {
    meet(&a, &b)
}

/// The point that three planes have in common, and the lines in which two of them meet.
///
/// What does not exist, because planes are parallel, is null with a warning.
#[component(
    "f1ea5a4b-1a4f-4cf4-ad94-1ecfb9302b6e",
    name = "Plane | Plane | Plane",
    nick = "3PX",
    at = "Intersect/Mathematical"
)]
#[output("Point", "Pt", "The point.")]
#[output("Line AB", "AB", "A piece of the line of the first two planes.")]
#[output("Line AC", "AC", "A piece of the line of the first and the third plane.")]
#[output("Line BC", "BC", "A piece of the line of the last two planes.")]
fn plane_plane_plane(
    context: &Context<'_>,
    /// A plane.
    #[port("Plane A", "A")]
    a: Plane,
    /// Another plane.
    #[port("Plane B", "B")]
    b: Plane,
    /// A third plane.
    #[port("Plane C", "C")]
    c: Plane,
) -> (Option<Point3>, Option<Line>, Option<Line>, Option<Line>) {
    let point = intersect::three_planes(&a, &b, &c);
    if point.is_none() {
        context.warn("The planes have no single point in common");
    }
    let line = |p: &Plane, q: &Plane| intersect::plane_plane(p, q);
    (point, line(&a, &b), line(&a, &c), line(&b, &c))
}

/// Where a ray first meets a mesh.
#[component(
    "4c02a168-9aba-4f42-8951-2719f24d391f",
    name = "Mesh | Ray",
    nick = "MeshRay",
    at = "Intersect/Mathematical"
)]
#[output("Point", "X", "The first point of the mesh on the ray; null when there is none.")]
#[output("Hit", "H", "Whether there is one.")]
fn mesh_ray(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: Shared<Mesh>,
    /// Where the ray begins.
    #[port("Point", "P")]
    start: Point3,
    /// Its direction; the length does not count.
    #[port("Direction", "D")]
    direction: Vector3,
) -> Result<(Option<Point3>, bool), Message> {
    // Mostly many rays are sent at one mesh: its tree is made once.
    let hits = prepared::mesh(context, &mesh)?.tree.line_hits(start, direction, [0.0, f64::INFINITY])?;
    let first = hits.first().map(|hit| hit.point);
    Ok((first, first.is_some()))
}

/// The part of a plane around its origin that other planes cut off.
///
/// It is convex and its outline runs counter-clockwise about the normal. Planes parallel to it bound nothing. When the
/// planes leave the part open, or one of them goes through the origin, there is none: a warning.
#[component(
    "80e3614a-25ae-43e7-bb0a-760e68ade864",
    name = "Plane Region",
    nick = "PlReg",
    at = "Intersect/Mathematical"
)]
#[output("Region", "R", "The outline.")]
fn plane_region(
    /// The plane.
    #[port("Plane", "P")]
    plane: Plane,
    /// The planes that bound the region.
    #[port("Bounds", "B")]
    bounds: List<Plane>,
) -> Result<Shared<Curve>, Message> {
    let bounds: Vec<Plane> = bounds.iter().flatten().collect();
    let cell = region::plane_cell(&plane, &bounds).map_err(|e| Message::warning(e.to_string()))?;
    Ok(Shared::new(cell.into()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Box3, Circle, Interval, Line, Mesh, Plane, Point3, Vector3};

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    fn line(a: Point3, b: Point3) -> Line {
        Line::new(a, b)
    }

    #[test]
    fn curves_with_lines_and_planes() {
        let circle = Circle { plane: Plane::XY, radius: 5.0 };
        let through =
            || Trial::of("Curve | Line").item(circle).item(line(p(-9.0, 3.0, 0.0), p(9.0, 3.0, 0.0)));
        assert_eq!(through().texts(0), ["{0;0}: {4, 3, 0}, {-4, 3, 0}"]);
        assert_eq!(through().texts(2), ["{0}: 2"]);
        let old =
            |guid: &str| Trial::of_guid(guid).item(circle).item(line(p(-9.0, 3.0, 0.0), p(9.0, 3.0, 0.0)));
        let first = old("9396be03-8159-43bf-b3e7-2c86c8d04fc0").item(true);
        assert_eq!(first.texts(0), ["{0;0}: {-4, 3, 0}"]);
        let early = old("ddaea1a9-d6bd-4a18-ac11-8a4993954a03");
        assert_eq!(early.texts(0), ["{0;0}: {4, 3, 0}, {-4, 3, 0}"]);
        // The line goes on beyond its ends.
        let short = Trial::of("Curve | Line").item(circle).item(line(p(0.0, 3.0, 0.0), p(9.0, 3.0, 0.0)));
        assert_eq!(short.texts(0), ["{0;0}: {4, 3, 0}, {-4, 3, 0}"]);
        let along = Trial::of("Curve | Line").item(line(p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0)));
        assert_eq!(along.item(line(p(1.0, 0.0, 0.0), p(9.0, 0.0, 0.0))).texts(1), ["{0;0}: 0, 1"]);

        let upright = Plane { origin: p(3.0, 0.0, 0.0), ..Plane::YZ };
        let cut = || Trial::of("Curve | Plane").item(circle).item(upright);
        assert_eq!(cut().texts(0), ["{0;0}: {3, 4, 0}, {3, -4, 0}"]);
        assert_eq!(cut().texts(2), ["{0;0}: {4, 0, 0}, {-4, 0, 0}"]);
        let apart = Trial::of("Curve | Plane").item(circle).item(Plane::XY.offset(1.0));
        assert_eq!(apart.run().outputs[0].item_count(), 0);
    }

    #[test]
    fn lines_and_planes() {
        let lines = || {
            Trial::of("Line | Line")
                .item(line(p(0.0, 0.0, 0.0), p(2.0, 0.0, 0.0)))
                .item(line(p(3.0, -1.0, 1.0), p(3.0, 1.0, 1.0)))
        };
        let all: Vec<String> = (0..4).map(|k| lines().texts(k).join("")).collect();
        assert_eq!(all, ["{0}: 1.5", "{0}: 0.5", "{0}: {3, 0, 0}", "{0}: {3, 0, 1}"]);
        let x = line(p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0));
        assert!(Trial::of("Line | Line").item(x).item(x).message().contains("parallel"));

        let drop =
            || Trial::of("Line | Plane").item(line(p(1.0, 2.0, 4.0), p(1.0, 2.0, 2.0))).item(Plane::XY);
        let all: Vec<String> = (0..3).map(|k| drop().texts(k).join("")).collect();
        assert_eq!(all, ["{0}: {1, 2, 0}", "{0}: 2", "{0}: {1, 2, 0}"]);
        assert!(Trial::of("Line | Plane").item(x).item(Plane::XY).message().contains("parallel"));

        let three =
            || Trial::of("Plane | Plane | Plane").item(Plane::XY.offset(3.0)).item(Plane::YZ).item(Plane::XZ);
        assert_eq!(three().texts(0), ["{0}: {0, 0, 3}"]);
        assert_eq!(three().texts(3), ["{0}: Line(L:1.00 mm)"]);
        let parallel = Trial::of("Plane | Plane | Plane").item(Plane::XY).item(Plane::XY).item(Plane::XZ);
        assert_eq!(parallel.texts(1), ["{0}: null"]);
        assert!(Trial::of("Plane | Plane").item(Plane::XY).item(Plane::XY).message().contains("parallel"));
        assert_eq!(
            Trial::of("Plane | Plane").item(Plane::XY).item(Plane::XZ).texts(0),
            ["{0}: Line(L:1.00 mm)"]
        );
    }

    #[test]
    fn rays_on_meshes() {
        let unit = Interval::new(0.0, 1.0);
        let cube = Mesh::cuboid(&Box3 { plane: Plane::XY, x: unit, y: unit, z: unit }, 1, 1, 1).unwrap();
        let ray = |z: f64| {
            Trial::of("Mesh | Ray").item(cube.clone()).item(p(0.25, 0.5, 9.0)).item(Vector3::new(0.0, 0.0, z))
        };
        assert_eq!(ray(-2.0).texts(0), ["{0}: {0.25, 0.5, 1}"]);
        assert_eq!(
            (ray(2.0).texts(0), ray(2.0).texts(1)),
            (vec!["{0}: null".into()], vec!["{0}: False".into()])
        );
        // From inside and from the face itself, and without a direction.
        let from = |z: f64, along: f64| {
            let trial = Trial::of("Mesh | Ray").item(cube.clone()).item(p(0.25, 0.5, z));
            trial.item(Vector3::new(0.0, 0.0, along)).texts(0)
        };
        assert_eq!(from(0.5, 3.0), ["{0}: {0.25, 0.5, 1}"]);
        assert_eq!(from(1.0, 3.0), ["{0}: {0.25, 0.5, 1}"]);
        assert_eq!(from(0.5, 0.0), ["{0}: null"]);
    }

    #[test]
    fn cells_of_planes() {
        let wall = |x: f64, y: f64| Plane::from_normal(p(x, y, 0.0), Vector3::new(x, y, 0.0)).unwrap();
        let room = |walls: Vec<Plane>| Trial::of("Plane Region").item(Plane::XY).list(walls);
        let walls = || vec![wall(2.0, 0.0), wall(-2.0, 0.0), wall(0.0, 1.0), wall(0.0, -1.0), wall(9.0, 9.0)];
        let cell = || {
            Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93")
                .tree(room(walls()).run().outputs[0].clone())
        };
        assert_eq!(cell().texts(0), ["{0}: 12"]);
        assert!(room(walls()[..3].to_vec()).message().contains("open"));
    }
}
