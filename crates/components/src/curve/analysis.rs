//! Curve / Analysis: what a curve is as a whole.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_geometry::{
    Arc, ArcLength, Continuity, Curve, Interval, Plane, Point3, PolylineCurve, Rectangle,
};

use super::{shared, warning};

/// The length of a curve.
#[component("c75b62fa-0a33-4da7-a5bd-03fd0068fd93", name = "Length", nick = "Len", at = "Curve/Analysis")]
#[output("Length", "L", "Its length.")]
fn length(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> f64 {
    curve.length()
}

/// The domain of a curve, and the curve over another domain. Its shape stays.
#[component(
    "ccfd6ba8-ecb1-44df-a47e-08126a653c51",
    name = "Curve Domain",
    nick = "CrvDom",
    at = "Curve/Analysis"
)]
#[output("Curve", "C", "The curve over the new domain.")]
#[output("Domain", "D", "The domain it had.")]
fn curve_domain(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The new domain, which must rise; without it the curve stays as it is.
    #[port("Domain", "D")]
    domain: Option<Interval>,
) -> Result<(Shared<Curve>, Interval), Message> {
    let changed = match domain {
        Some(domain) => curve.with_domain(domain)?,
        None => curve.clone(),
    };
    Ok((shared(changed), curve.domain()))
}

/// The domain of a curve.
#[component(
    "15ac45a8-b190-420a-bd66-e78ed6bcfaa4",
    name = "Curve Domain",
    nick = "Dom",
    at = "Curve/Analysis",
    old
)]
#[output("Domain", "D", "From the parameter of its start to that of its end.")]
fn domain_of_curve(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Interval {
    curve.domain()
}

/// Whether a curve ends where it starts.
#[component(
    "323f3245-af49-4489-8677-7a2c73664077",
    name = "Closed",
    nick = "Cls",
    at = "Curve/Analysis",
    also("f2030fa9-db3f-437e-9b50-5607db6daf87")
)]
#[output("Closed", "C", "Whether it is closed.")]
#[output("Periodic", "P", "Whether it is closed and as smooth at the seam as elsewhere.")]
fn closed(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> (bool, bool) {
    (curve.is_closed(), curve.is_periodic())
}

/// The control points, weights and knots of a curve as a NURBS curve. A periodic curve repeats its first points.
#[component(
    "424eb433-2b3a-4859-beaf-804d8af0afd7",
    name = "Control Points",
    nick = "CP",
    at = "Curve/Analysis",
    also("d7df7658-e02d-4a48-a345-2195a68db4ef")
)]
#[output("Points", "P", "The control points.")]
#[output("Weights", "W", "One weight a control point.")]
#[output("Knots", "K", "The knots, as Rhino counts them: points + degree - 1.")]
fn control_points(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<(Vec<Point3>, Vec<f64>, Vec<f64>), Message> {
    let nurbs = curve.to_nurbs()?;
    Ok((nurbs.control_points(), nurbs.weights(), nurbs.knots().to_vec()))
}

/// The polyline through the control points of a curve.
#[component(
    "66d2a68e-2f1d-43d2-a53b-c6a4d17e627b",
    name = "Control Polygon",
    nick = "CPoly",
    at = "Curve/Analysis"
)]
#[output("Polygon", "C", "The polyline; closed for a periodic curve.")]
#[output("Points", "P", "The control points, each once.")]
fn control_polygon(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<(Shared<Curve>, Vec<Point3>), Message> {
    let nurbs = curve.to_nurbs()?;
    let mut points = nurbs.distinct_control_points();
    let mut outline = points.clone();
    if nurbs.is_periodic() || (curve.is_closed() && points.first() != points.last()) {
        outline.extend(points.first().copied());
    }
    if points.len() > 2 && points.first() == points.last() {
        points.pop();
    }
    outline.dedup();
    Ok((shared(PolylineCurve::new(outline).map_err(warning)?), points))
}

/// The places where a curve is not smooth. The ends of an open curve are none.
#[component(
    "269eaa85-9997-4d77-a9ba-4c58cb45c9d3",
    name = "Discontinuity",
    nick = "Disc",
    at = "Curve/Analysis"
)]
#[output("Points", "P", "The points.")]
#[output("Parameters", "t", "Their parameters, in the curve's own domain.")]
fn discontinuity(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// 1 finds kinks, 2 also jumps of the second derivative, 3 every place where pieces meet.
    #[port("Level", "L", default = 1)]
    level: i32,
) -> Result<(Vec<Point3>, Vec<f64>), Message> {
    let parameters = match level {
        1 => curve.discontinuities(Continuity::C1, &context.tolerance()),
        2 => curve.discontinuities(Continuity::C2, &context.tolerance()),
        3 => joints(curve),
        _ => return Err(Message::error(format!("There is no level {level}: it goes from 1 to 3"))),
    };
    Ok((parameters.iter().map(|&t| curve.point_at(t)).collect(), parameters))
}

/// Where pieces meet within a curve: vertices, simple knots, joints.
fn joints(curve: &Curve) -> Vec<f64> {
    let mut all = match curve {
        Curve::Line(_) | Curve::Arc(_) => Vec::new(),
        Curve::Polyline(c) => c.parameters().to_vec(),
        Curve::Nurbs(c) => c.span_parameters(),
        Curve::Poly(c) => {
            let inner = c.segments().iter().enumerate().flat_map(|(i, segment)| {
                joints(segment).into_iter().map(move |s| c.from_segment_parameter(i, s))
            });
            c.parameters().iter().copied().chain(inner).collect()
        }
    };
    let own = curve.domain();
    all.retain(|&t| t > own.start && t < own.end);
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// Whether a curve lies in a plane.
#[component("5816ec9c-f170-4c59-ac44-364401ff84cd", name = "Planar", nick = "Planar", at = "Curve/Analysis")]
#[output("Planar", "p", "Whether some plane holds it, within the document's tolerance.")]
#[output("Plane", "P", "That plane, or the one that fits best.")]
#[output("Deviation", "D", "The largest distance of the curve from it.")]
fn planar(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<(bool, Plane, f64), Message> {
    let plane = curve.plane(context.tolerance().absolute);
    let fit = match plane {
        Some(plane) => plane,
        None => Plane::fit(&curve.hull_points()).map_err(warning)?.0,
    };
    let heights = curve.bounding_box_in(&fit).z;
    // The box is measured along the normal from the plane's own origin.
    let deviation = heights.start.abs().max(heights.end.abs());
    Ok((plane.is_some(), fit, deviation))
}

/// Three middles of a polyline: of its corners, of its edges and of its area.
///
/// Only curves of straight segments have corners. The area's is missing when the outline is open or not flat.
#[component(
    "59e94548-cefd-4774-b3de-48142fc783fb",
    name = "Polygon Center",
    nick = "PCen",
    at = "Curve/Analysis",
    also("87e7f480-14dc-4478-b1e6-2b8b035d9edc")
)]
#[output("Center(V)", "Cv", "The mean of the corners.")]
#[output("Center(E)", "Ce", "The mean of the edges, each as heavy as it is long.")]
#[output("Center(A)", "Ca", "The centroid of the area inside.")]
fn polygon_center(
    context: &Context<'_>,
    /// The polyline.
    #[port("Polyline", "P")]
    curve: &Curve,
) -> Result<(Point3, Point3, Option<Point3>), Message> {
    let points = curve.as_polyline().ok_or_else(|| Message::error("This curve is no polyline"))?;
    let closed =
        points.len() > 2 && points.first().zip(points.last()).is_some_and(|(a, b)| a.distance_to(*b) < 1e-9);
    let corners = if closed { points.get(1..).unwrap_or(&[]) } else { points.as_slice() };
    let first = corners.first().copied().unwrap_or(Point3::ORIGIN);
    let mean =
        first + corners.iter().map(|p| *p - first).sum::<katydid_geometry::Vector3>() / corners.len() as f64;
    let (mut sum, mut weight) = (katydid_geometry::Vector3::ZERO, 0.0);
    for pair in points.windows(2) {
        if let [a, b] = pair {
            sum += (a.lerp(*b, 0.5) - first) * a.distance_to(*b);
            weight += a.distance_to(*b);
        }
    }
    let edges = if weight > 0.0 { first + sum / weight } else { mean };
    let area = curve.area_and_centroid(context.tolerance().absolute).ok().map(|(_, center)| center);
    Ok((mean, edges, area))
}

/// The shortest and the longest part of a curve between its kinks.
#[component(
    "f88a6cd9-1035-4361-b896-4f2dfe79272d",
    name = "Segment Lengths",
    nick = "LenSeg",
    at = "Curve/Analysis"
)]
#[output("Shortest Length", "Sl", "The length of the shortest.")]
#[output("Shortest Domain", "Sd", "Its domain.")]
#[output("Longest Length", "Ll", "The length of the longest.")]
#[output("Longest Domain", "Ld", "Its domain.")]
fn segment_lengths(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<(f64, Interval, f64, Interval), Message> {
    let own = curve.domain();
    let mut cuts = vec![own.start];
    cuts.extend(curve.discontinuities(Continuity::G1, &context.tolerance()));
    cuts.push(own.end);
    cuts.dedup();
    let lengths = ArcLength::new(curve);
    let parts: Vec<(f64, Interval)> = cuts
        .windows(2)
        .filter_map(|w| match w {
            [a, b] => Some((lengths.length_at(*b) - lengths.length_at(*a), Interval::new(*a, *b))),
            _ => None,
        })
        .collect();
    let shortest = parts.iter().min_by(|a, b| a.0.total_cmp(&b.0));
    let longest = parts.iter().reduce(|best, part| if part.0 > best.0 { part } else { best });
    match (shortest, longest) {
        (Some(s), Some(l)) => Ok((s.0, s.1, l.0, l.1)),
        _ => Err(Message::warning("The curve has no length")),
    }
}

/// The plane, the radius and the angles of an arc or circle.
#[component(
    "23862862-049a-40be-b558-2418aacbd916",
    name = "Deconstruct Arc",
    nick = "DArc",
    at = "Curve/Analysis"
)]
#[output("Base Plane", "B", "Its plane; the origin is the centre.")]
#[output("Radius", "R", "Its radius.")]
#[output("Angle", "A", "Its angles from the plane's x axis, in radians.")]
fn deconstruct_arc(
    /// The arc.
    #[port("Arc", "A")]
    arc: Arc,
) -> (Plane, f64, Interval) {
    (arc.circle.plane, arc.circle.radius, arc.angle)
}

/// The centre and the radius of an arc or circle.
#[component("afff17ed-5975-460b-9883-525ae0677088", name = "Center", nick = "Cen", at = "Curve/Analysis")]
#[output("Center", "C", "Its centre.")]
#[output("Radius", "R", "Its radius.")]
fn center(
    /// The arc.
    #[port("Arc", "A")]
    arc: Arc,
) -> (Point3, f64) {
    (arc.circle.plane.origin, arc.circle.radius)
}

/// The plane of a rectangle and where it lies in it.
#[component(
    "e5c33a79-53d5-4f2b-9a97-d3d45c780edc",
    name = "Deconstuct Rectangle",
    nick = "DRec",
    at = "Curve/Analysis"
)]
#[output("Base Plane", "B", "Its plane.")]
#[output("X Interval", "X", "From where to where it reaches along the plane's x axis.")]
#[output("Y Interval", "Y", "From where to where it reaches along its y axis.")]
fn deconstuct_rectangle(
    /// The rectangle.
    #[port("Rectangle", "R")]
    rectangle: Rectangle,
) -> (Plane, Interval, Interval) {
    let Rectangle { plane, x, y } = rectangle;
    (plane, x, y)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Circle, Curve, Interval, Line, Plane, Point3, PolylineCurve, Rectangle};

    fn polyline(points: &[[f64; 3]]) -> Curve {
        PolylineCurve::new(points.iter().map(|&p| p.into()).collect()).unwrap().into()
    }

    fn circle() -> Circle {
        Circle { plane: Plane::XY, radius: 2.0 }
    }

    #[test]
    fn lengths_and_domains() {
        let line = Line::new(Point3::ORIGIN, Point3::new(4.0, 0.0, 0.0));
        assert_eq!(Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93").item(line).texts(0), ["{0}: 4"]);
        assert_eq!(Trial::of("Curve Domain").item(circle()).texts(1), ["{0}: 0 To 12.566371"]);
        let changed = Trial::of("Curve Domain").item(line).item(Interval::new(1.0, 2.0)).run();
        assert_eq!(texts(&changed.outputs[1]), ["{0}: 0 To 1"]);
        let old = Trial::of_guid("15ac45a8-b190-420a-bd66-e78ed6bcfaa4").tree(changed.outputs[0].clone());
        assert_eq!(old.texts(0), ["{0}: 1 To 2"]);
        let corner = || polyline(&[[0.0; 3], [4.0, 0.0, 0.0], [4.0, 3.0, 0.0]]);
        let parts = Trial::of("Segment Lengths").item(corner()).run();
        assert_eq!([0, 1, 2].map(|k| texts(&parts.outputs[k]).join("")), ["{0}: 3", "{0}: 1 To 2", "{0}: 4"]);
        assert_eq!(Trial::of("Discontinuity").item(corner()).texts(1), ["{0;0}: 1"]);
        assert_eq!(Trial::of("Discontinuity").item(corner()).item(3).texts(1), ["{0;0}: 1"]);
        assert!(Trial::of("Discontinuity").item(corner()).item(7).message().contains("level"));
    }

    #[test]
    fn kinds_of_curves() {
        let closed = Trial::of("Closed").item(circle()).run();
        assert_eq!(texts(&closed.outputs[1]), ["{0}: True"]);
        assert_eq!(Trial::of("Control Points").item(circle()).run().outputs[0].item_count(), 9);
        let polygon = Trial::of("Control Polygon").item(circle()).run();
        assert_eq!(polygon.outputs[1].item_count(), 8);
        assert_eq!(Trial::of("Planar").item(circle()).texts(0), ["{0}: True"]);
        let bent = polyline(&[[0.0; 3], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 4.0]]);
        assert_eq!(Trial::of("Planar").item(bent).texts(0), ["{0}: False"]);
    }

    #[test]
    fn middles_and_parts() {
        let triangle = polyline(&[[0.0; 3], [6.0, 0.0, 0.0], [0.0, 6.0, 0.0], [0.0; 3]]);
        let middle = Trial::of("Polygon Center").item(triangle).run();
        assert_eq!(texts(&middle.outputs[0]), ["{0}: {2, 2, 0}"]);
        assert_eq!(texts(&middle.outputs[2]), ["{0}: {2, 2, 0}"]);
        let open = polyline(&[[0.0; 3], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]]);
        assert_eq!(Trial::of("Polygon Center").item(open.clone()).texts(1), ["{0}: {3, 1, 0}"]);
        assert_eq!(Trial::of("Polygon Center").item(open).texts(2), ["{0}: null"]);
        assert!(Trial::of("Polygon Center").item(circle()).message().contains("no polyline"));
        assert_eq!(Trial::of("Deconstruct Arc").item(circle()).texts(2), ["{0}: 0 To 6.283185"]);
        assert_eq!(Trial::of("Center").item(circle()).texts(1), ["{0}: 2"]);
        let r = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 2.0), y: Interval::new(1.0, 5.0) };
        assert_eq!(Trial::of("Deconstuct Rectangle").item(r).texts(2), ["{0}: 1 To 5"]);
    }
}
