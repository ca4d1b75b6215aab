//! Curve / Analysis and Division: places on curves, and cuts with rows of planes.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Gather, Item, Path, Tree, TreeBuilder};
use katydid_geometry::{Curve, Interval, KnotSpacing, NurbsCurve, Plane, Point3, Vector3};

use super::{measured, warning};
use crate::intersect::planes;

/// A point on a curve that slides along it by hand, stored as a part of the curve's length.
#[component(
    "7f6a9d34-0470-4bb7-aadd-07496bcbe572",
    name = "Point On Curve",
    nick = "CurvePoint",
    at = "Curve/Analysis",
    floating
)]
#[output("Point", "P", "The point.", kind = Point)]
fn point_on_curve(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C", optional, kind = Curve)]
    curves: &Tree,
) -> Result<Tree, Message> {
    let fraction = context.settings().f64("parameter").filter(|x| x.is_finite()).unwrap_or(0.5);
    let column = curves.column();
    let mut points = Gather::<Point3>::with_capacity(column.len());
    for i in 0..column.len() {
        context.check()?;
        let point = Shared::<Curve>::get(column, i).map(|curve| {
            let t = curve.parameter_at_normalized_length(fraction.clamp(0.0, 1.0));
            curve.point_at(t.unwrap_or_else(|| curve.domain().at(fraction)))
        });
        points.push(point);
    }
    Ok(curves.with_column(points.finish()))
}

/// Draws the curvature of a curve as hairs across it: the more it bends, the longer they are.
#[component(
    "7376fe41-74ec-497e-b367-1ffe5072608b",
    name = "Curvature Graph",
    nick = "CrvGraph",
    at = "Curve/Analysis"
)]
fn curvature_graph(
    /// The curve.
    #[port("Curve", "C")]
    _curve: &Curve,
    /// How many hairs each smooth part has.
    #[port("Density", "D", default = 10)]
    _density: i32,
    /// How long the hairs are; 100 for the curvature itself.
    #[port("Scale", "S", default = 105)]
    _scale: i32,
) {
}

/// The point of a curve that reaches `height` along a direction, where that is the farthest it reaches.
fn touch(curve: &Curve, direction: Vector3, height: f64, tolerance: f64) -> Result<Point3, Message> {
    let plane = Plane::from_normal((direction * height).to_point(), direction)?;
    let t = curve.intersect_plane(&plane, tolerance)?.first().copied();
    Ok(curve.point_at(t.unwrap_or(curve.domain().start)))
}

/// The highest and the lowest point of a curve along the normal of a plane. Of several, the first along the curve.
#[component(
    "ebd6c758-19ae-4d74-aed7-b8a0392ff743",
    name = "Extremes",
    nick = "X-tremez",
    at = "Curve/Analysis"
)]
#[output("Highest", "H", "The highest point.")]
#[output("Lowest", "L", "The lowest point.")]
fn extremes(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The plane whose normal points up.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> Result<(Point3, Point3), Message> {
    let up = plane.z_axis;
    let range = curve.extent_along(up);
    let tolerance =
        1e-9 * range.start.abs().max(range.end.abs()).max(curve.bounding_box().diagonal().length());
    Ok((touch(curve, up, range.end, tolerance)?, touch(curve, up, range.start, tolerance)?))
}

/// On which side of a curve a point lies, looking along the curve against the normal of a plane.
#[component(
    "bb2e13da-09ca-43fd-bef8-8d71f3653af9",
    name = "Curve Side",
    nick = "Side",
    at = "Curve/Analysis"
)]
#[output("Side", "S", "-1 on the left, 1 on the right, 0 on the curve.")]
#[output("Left", "L", "Whether it lies on the left.")]
#[output("Right", "R", "Whether it lies on the right.")]
fn curve_side(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The point.
    #[port("Point", "P")]
    point: Point3,
    /// The plane in which left and right are seen.
    #[port("Plane", "Pl", default = Plane::XY)]
    plane: Plane,
) -> Result<(i32, bool, bool), Message> {
    let near = curve.closest_point(point)?;
    let (domain, t) = (curve.domain(), near.parameter);
    // At a kink both directions count.
    let side = |below| curve.tangent_on_side(t, below).unwrap_or(Vector3::ZERO);
    let tangent = match (t <= domain.start, t >= domain.end) {
        (true, false) if !curve.is_closed() => side(false),
        (false, true) if !curve.is_closed() => side(true),
        (true, _) | (_, true) => {
            let before = curve.tangent_on_side(domain.end, true).unwrap_or(Vector3::ZERO);
            before + curve.tangent_on_side(domain.start, false).unwrap_or(Vector3::ZERO)
        }
        _ => side(true) + side(false),
    };
    let away = tangent.cross(point - near.point).dot(plane.z_axis);
    let on = near.distance <= context.tolerance().absolute || away == 0.0;
    Ok(match (on, away > 0.0) {
        (true, _) => (0, false, false),
        (false, true) => (-1, true, false),
        (false, false) => (1, false, true),
    })
}

/// The mean of the corners of a polyline. An early form of the component of the same name.
#[component(
    "7bd7b551-ca79-4f01-b95a-7e9ab876f24d",
    name = "Polygon Center",
    nick = "PCen",
    at = "Curve/Analysis",
    old
)]
#[output("Center", "C", "The mean of the corners.")]
fn early_polygon_center(
    /// The polyline.
    #[port("Polyline", "P")]
    curve: &Curve,
) -> Result<Point3, Message> {
    let points = curve.as_polyline().ok_or_else(|| Message::error("This curve is no polyline"))?;
    let corners = match points.as_slice() {
        [first, .., last] if points.len() > 2 && first.distance_to(*last) < 1e-9 => {
            points.get(1..).unwrap_or(&[])
        }
        all => all,
    };
    let first = corners.first().copied().unwrap_or(Point3::ORIGIN);
    Ok(first + corners.iter().map(|p| *p - first).sum::<Vector3>() / corners.len().max(1) as f64)
}

fn interpolated(
    context: &Context<'_>,
    vertices: &List<'_, Point3>,
    degree: i32,
    [start, end]: [Vector3; 2],
    spacing: KnotSpacing,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    let degree =
        usize::try_from(degree).map_err(|_| Message::error(format!("Degree is negative: {degree}")))?;
    if degree != 3 {
        context.warn("Directions at the ends are kept by curves of degree 3 only");
    }
    let points: Vec<Point3> = vertices.present().collect();
    let some = |v: Vector3| v.unitized().map(|_| v);
    Ok(measured(NurbsCurve::interpolate(degree, &points, spacing, some(start), some(end)).map_err(warning)?))
}

/// A smooth curve through points with given directions at its ends. An early form of the component of the same name.
#[component(
    "50870118-be51-4872-ab3c-410d79f2356e",
    name = "Interpolate (t)",
    nick = "IntCrv(t)",
    at = "Curve/Spline",
    old
)]
#[output("Curve", "C", "The curve.")]
#[output("Length", "L", "Its length.")]
#[output("Domain", "D", "Its domain.")]
fn early_interpolate_t(
    context: &Context<'_>,
    /// The points.
    #[port("Vertices", "V")]
    vertices: List<Point3>,
    /// The degree; directions count with 3 only.
    #[port("Degree", "D", default = 3)]
    degree: i32,
    /// The direction in which the curve leaves the first point; zero for a free end.
    #[port("Tangent Start", "Ts")]
    start: Vector3,
    /// The direction in which it reaches the last point; zero for a free end.
    #[port("Tangent End", "Te")]
    end: Vector3,
    /// How parameters grow from point to point: 0 evenly, 1 by distance, 2 by its square root.
    #[port("KnotStyle", "K", default = 1)]
    style: i32,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    let spacing = match style {
        0 => KnotSpacing::Uniform,
        1 => KnotSpacing::Chord,
        2 => KnotSpacing::SquareRootChord,
        other => return Err(Message::error(format!("KnotStyle is {other}, which must be between 0 and 2"))),
    };
    interpolated(context, &vertices, degree, [start, end], spacing)
}

/// A smooth curve through points with given directions at its ends. The earliest form of the component of the same
/// name.
#[component(
    "e8e00fbb-9710-4cfa-a60f-2aae50b79d06",
    name = "Interpolate (t)",
    nick = "IntCrv(t)",
    at = "Curve/Spline",
    old
)]
#[output("Curve", "C", "The curve.")]
#[output("Length", "L", "Its length.")]
#[output("Domain", "D", "Its domain.")]
fn earliest_interpolate_t(
    context: &Context<'_>,
    /// The points.
    #[port("Vertices", "V")]
    vertices: List<Point3>,
    /// The degree; directions count with 3 only.
    #[port("Degree", "D", default = 3)]
    degree: i32,
    /// The direction in which the curve leaves the first point; zero for a free end.
    #[port("Tangent Start", "Ts")]
    start: Vector3,
    /// The direction in which it reaches the last point; zero for a free end.
    #[port("Tangent End", "Te")]
    end: Vector3,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    interpolated(context, &vertices, degree, [start, end], KnotSpacing::Chord)
}

/// The places where a curve meets planes: a branch of points and one of parameters for each plane.
fn cuts(context: &Context<'_>, curve: &Curve, planes: &[Plane]) -> Result<(Tree, Tree), Message> {
    let start: Path = context.path().child(context.iteration());
    let (mut points, mut parameters) = (TreeBuilder::<Point3>::new(), TreeBuilder::<f64>::new());
    for (k, plane) in planes.iter().enumerate() {
        context.check()?;
        context.items(k)?;
        let path = start.child(k);
        points.branch(path.clone());
        parameters.branch(path);
        for t in planes::places_in(context, curve, plane)? {
            points.push(Some(curve.point_at(t)));
            parameters.push(Some(t));
        }
    }
    Ok((points.finish(), parameters.finish()))
}

/// Cuts a curve with parallel planes at equal distances: those through a point and at every multiple of the distance
/// on both sides of it that meet the curve's extent.
#[component(
    "88cff285-7f5e-41b3-96d5-9588ff9a52b1",
    name = "Contour",
    nick = "Contour",
    at = "Curve/Division"
)]
#[output("Contours", "C", "The points, a branch for each plane, in the direction of the normal.")]
#[output("Parameters", "t", "The parameters on the curve there.")]
fn contour(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// A point that a plane goes through.
    #[port("Point", "P")]
    point: Point3,
    /// The normal of the planes; its length does not matter.
    #[port("Direction", "N", default = Vector3::Z)]
    direction: Vector3,
    /// The distance from plane to plane, above 0.
    #[port("Distance", "D")]
    distance: f64,
) -> Result<(Tree, Tree), Message> {
    let first = Plane::from_normal(point, direction)?;
    let extent = curve.extent_along(first.z_axis);
    let at = point.to_vector().dot(first.z_axis);
    let heights = Interval::new(extent.start - at, extent.end - at);
    cuts(context, curve, &planes::row(context, &first, heights, distance)?)
}

/// Cuts a curve with parallel planes: at offsets from a plane, or, without offsets, at distances from plane to plane.
#[component(
    "3e7e4827-6edd-4e10-93ac-cc234414d2b9",
    name = "Contour (ex)",
    nick = "Contour",
    at = "Curve/Division"
)]
#[output("Contours", "C", "The points, a branch for each plane.")]
#[output("Parameters", "t", "The parameters on the curve there.")]
fn contour_ex(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The plane that the others are parallel to.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The places of the planes along the plane's normal.
    #[port("Offsets", "O", optional)]
    offsets: List<f64>,
    /// How far each plane is from the one before, the first from the plane itself.
    #[port("Distances", "D", optional)]
    distances: List<f64>,
) -> Result<(Tree, Tree), Message> {
    cuts(context, curve, &planes::placed(&plane, &offsets, &distances)?)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Circle, Line, Plane, Point3, Vector3};

    const O: Point3 = Point3::ORIGIN;

    fn p(x: f64, y: f64) -> Point3 {
        Point3::new(x, y, 0.0)
    }

    fn circle() -> Circle {
        Circle { plane: Plane::XY, radius: 2.0 }
    }

    #[test]
    fn a_point_slides_by_length() {
        let line = Line::new(O, p(8.0, 0.0));
        assert_eq!(Trial::of("Point On Curve").item(line).texts(0), ["{0}: {4, 0, 0}"]);
        let quarter =
            Trial::of("Point On Curve").setting("parameter", 0.25).list([line, Line::new(O, p(0.0, 4.0))]);
        assert_eq!(quarter.texts(0), ["{0}: {2, 0, 0}, {0, 1, 0}"]);
        assert!(Trial::of("Point On Curve").texts(0).is_empty());
    }

    #[test]
    fn heights_and_sides() {
        let plane = Plane::from_normal(O, Vector3::Y).unwrap();
        let out = Trial::of("Extremes").item(circle()).item(plane).run().outputs;
        assert_eq!(
            (texts(&out[0])[0].as_str(), texts(&out[1])[0].as_str()),
            ("{0}: {0, 2, 0}", "{0}: {-0, -2, 0}")
        );
        let flat = Trial::of("Extremes").item(circle()).texts(0);
        assert_eq!(flat, ["{0}: {2, 0, 0}"]);
        let line = Line::new(O, p(4.0, 0.0));
        let side = |q: Point3| Trial::of("Curve Side").item(line).item(q).texts(0);
        assert_eq!(
            [side(p(1.0, 1.0)), side(p(1.0, -1.0)), side(p(9.0, 0.0)), side(p(2.0, 0.0))].concat(),
            ["{0}: -1", "{0}: 1", "{0}: 0", "{0}: 0"]
        );
        // Counter-clockwise: inside is left.
        assert_eq!(Trial::of("Curve Side").item(circle()).item(O).texts(1), ["{0}: True"]);
        assert_eq!(Trial::of("Curve Side").item(circle()).item(p(5.0, 0.0)).texts(2), ["{0}: True"]);
        assert!(Trial::of("Curvature Graph").item(circle()).run().outputs.is_empty());
    }

    #[test]
    fn cuts_with_planes() {
        let line = Line::new(p(0.5, 0.0), p(3.0, 0.0));
        let cut = || {
            Trial::of_guid("88cff285-7f5e-41b3-96d5-9588ff9a52b1").item(line).item(O).item(Vector3::X * 7.0)
        };
        assert_eq!(
            cut().item(1.0).texts(0),
            ["{0;0;0}: {1, 0, 0}", "{0;0;1}: {2, 0, 0}", "{0;0;2}: {3, 0, 0}"]
        );
        assert_eq!(cut().item(2.0).texts(1), ["{0;0;0}: 0.6"]);
        assert!(cut().item(0.0).message().contains("greater than 0"));
        assert!(cut().item(1e-300).message().contains("too many"));
        let plane = Plane::from_normal(O, Vector3::X).unwrap();
        let ex = || Trial::of_guid("3e7e4827-6edd-4e10-93ac-cc234414d2b9").item(circle()).item(plane);
        let out = ex().list([0.0, 5.0]).run().outputs;
        assert_eq!(out[0].item_count(), 2);
        assert_eq!(out[0].branch_count(), 2);
        let steps = ex().list::<f64>([]).list([1.0, 0.5]).run().outputs;
        assert_eq!((steps[0].item_count(), steps[0].branch_count()), (4, 2));
        assert!(ex().message().contains("needed"));
    }

    #[test]
    fn early_forms() {
        let square =
            katydid_geometry::PolylineCurve::new(vec![O, p(4.0, 0.0), p(4.0, 2.0), p(0.0, 2.0), O]).unwrap();
        let square = katydid_geometry::Curve::from(square);
        let center = Trial::of_guid("7bd7b551-ca79-4f01-b95a-7e9ab876f24d").item(square);
        assert_eq!(center.texts(0), ["{0}: {2, 1, 0}"]);
        for guid in ["50870118-be51-4872-ab3c-410d79f2356e", "e8e00fbb-9710-4cfa-a60f-2aae50b79d06"] {
            let trial = || Trial::of_guid(guid).list([O, p(4.0, 0.0)]);
            let straight = trial().item(3).item(Vector3::X).item(Vector3::X);
            assert_eq!(straight.texts(1), ["{0}: 4"]);
            assert!(trial().item(1).item(Vector3::X).item(Vector3::X).message().contains("degree 3 only"));
        }
    }
}
