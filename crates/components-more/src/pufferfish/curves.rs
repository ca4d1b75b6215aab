//! Curves: tweens, curves built anew, closed, offset and measured.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Kind, Value};
use katydid_geometry::{
    Box3, Curve, Interval, Line, NurbsCurve, OffsetCorner, Plane, Point3, Rectangle, join_curves,
};

use super::MOST_PARTS;
use super::mix::Mix;
use super::weights::{Way, between, pairs, weights};

/// How curves are prepared before they are blended.
#[derive(Debug, Clone, Copy)]
struct Match {
    refit: Option<i32>,
    sample: Option<i32>,
}

impl Match {
    /// The curve as it is blended.
    fn ready(self, context: &Context<'_>, curve: &Shared<Curve>) -> Result<Shared<Curve>, Message> {
        if let Some(count) = self.sample.filter(|n| *n > 0) {
            let count = usize::try_from(count).unwrap_or(0).min(MOST_PARTS);
            if count < 2 {
                return Err(Message::error("Point Sample needs at least two points"));
            }
            context.items(count)?;
            return Ok(Shared::new(Curve::from(sampled(curve, count)?)));
        }
        if let Some(degree) = self.refit.filter(|n| *n > 0) {
            let degree = usize::try_from(degree).unwrap_or(3).min(11);
            let fitted = curve.refitted(degree, context.tolerance().absolute)?;
            return Ok(Shared::new(Curve::from(fitted.curve)));
        }
        Ok(curve.clone())
    }
}

/// The degree of a curve whose control points are points of another one.
const SAMPLED_DEGREE: usize = 3;

/// A curve whose control points are so many points of another one with equal lengths between them. A closed curve is followed by a
/// periodic one, which has no corner where it begins.
fn sampled(curve: &Curve, count: usize) -> Result<NurbsCurve, Message> {
    if curve.is_closed() && count >= SAMPLED_DEGREE {
        let mut points = curve.points_at(&curve.divide_by_count(count)?);
        // A uniform cubic begins beside its second control point.
        points.rotate_right(1);
        return Ok(NurbsCurve::periodic_uniform(SAMPLED_DEGREE, &points)?);
    }
    let mut points = curve.points_at(&curve.divide_by_count(count - 1)?);
    points.resize(count, curve.end());
    Ok(NurbsCurve::clamped_uniform(SAMPLED_DEGREE.min(count - 1), &points)?)
}

/// A curve between two. Stands for Pufferfish's Tween Two Curves.
///
/// Points of equal parameters are blended: exactly where control points of both have the same weights over common knots, as those of
/// circles have, else within the tolerance. Polylines are matched by length.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f302a",
    name = "Tween Two Curves",
    nick = "Twn2Crvs",
    at = "Pufferfish/Curve"
)]
#[output("Tween", "T", "The curve between.")]
fn two(
    context: &Context<'_>,
    /// What factor 0 gives.
    #[port("Curve A", "A")]
    a: Shared<Curve>,
    /// What factor 1 gives.
    #[port("Curve B", "B")]
    b: Shared<Curve>,
    /// 0 gives A, 1 gives B; other numbers go beyond them.
    #[port("Factor", "F", default = 0.5)]
    factor: f64,
    /// The degree of curves that are fitted to these first, within the tolerance; none when 0 or nothing is given.
    #[port("Refit", "R", optional)]
    refit: Option<i32>,
    /// So many points at equal lengths become the control points; none when 0 or nothing is given.
    #[port("Point Sample", "P", optional)]
    sample: Option<i32>,
) -> Result<Shared<Curve>, Message> {
    if !factor.is_finite() {
        return Err(Message::error("The factor is not finite"));
    }
    let way = Match { refit, sample };
    let parts = [(way.ready(context, &a)?, 1.0 - factor), (way.ready(context, &b)?, factor)];
    Mix::mix(&parts, context.tolerance().absolute)
}

/// Curves between neighbours of a set. Stands for Pufferfish's Tween Consecutive Curves.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f302b",
    name = "Tween Consecutive Curves",
    nick = "TwnConCrvs",
    at = "Pufferfish/Curve"
)]
#[output("Tween", "T", "The curves between.")]
fn consecutive(
    context: &Context<'_>,
    /// The set.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// 0 gives the first of each two neighbours, 1 the second; other numbers go beyond them along the line of the two.
    #[port("Factor", "F", default = 0.5)]
    factor: f64,
    /// Whether the set goes on from its last curve to its first.
    #[port("Loopback", "L", default = false)]
    closed: bool,
    /// 0 goes straight between neighbours, others by cubics.
    #[port("Interpolation Type", "I", default = 0)]
    kind: i32,
    /// The degree of curves that are fitted to these first; none when 0 or nothing is given.
    #[port("Refit", "R", optional)]
    refit: Option<i32>,
    /// So many points at equal lengths become the control points; none when 0 or nothing is given.
    #[port("Point Sample", "P", optional)]
    sample: Option<i32>,
) -> Result<Vec<Shared<Curve>>, Message> {
    let way = Match { refit, sample };
    let curves: Vec<Shared<Curve>> =
        curves.present().map(|curve| way.ready(context, &curve)).collect::<Result<_, _>>()?;
    let way = Way { normalized: false, closed, smooth: kind > 0 };
    pairs(curves.len(), closed)
        .into_iter()
        .map(|pair| {
            context.check()?;
            blend(context, &curves, between(curves.len(), pair, factor, way)?)
        })
        .collect()
}

/// Curves of a set blended by shares.
fn blend(
    context: &Context<'_>,
    curves: &[Shared<Curve>],
    shares: Vec<(usize, f64)>,
) -> Result<Shared<Curve>, Message> {
    // A share of nothing still makes curves compatible, so that it is left out only where one curve is all.
    let shares = match shares.iter().find(|(_, share)| *share == 1.0) {
        Some(whole) => vec![*whole],
        None => shares,
    };
    let parts: Vec<(Shared<Curve>, f64)> =
        shares.into_iter().filter_map(|(i, share)| Some((curves.get(i)?.clone(), share))).collect();
    Mix::mix(&parts, context.tolerance().absolute)
}

/// A curve on the way through a set. Stands for Pufferfish's Tween Through Curves.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f302c",
    name = "Tween Through Curves",
    nick = "TwnThruCrvs",
    at = "Pufferfish/Curve"
)]
#[output("Tween", "T", "The curve at the factor.")]
fn through(
    context: &Context<'_>,
    /// The set.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// 0 gives the first curve, 1 the last.
    #[port("Factor", "F", default = 0.5)]
    factor: f64,
    /// Whether the factor goes from 0 to 1; else it counts the curves.
    #[port("Normalized", "N", default = true)]
    normalized: bool,
    /// Whether the way is divided by its length, which is not supported.
    #[port("Equalized", "E", default = false)]
    equalized: bool,
    /// Whether the set goes on from its last curve to its first.
    #[port("Loopback", "L", default = false)]
    closed: bool,
    /// 0 goes straight between neighbours, others by cubics.
    #[port("Interpolation Type", "I", default = 0)]
    kind: i32,
    /// The degree of curves that are fitted to these first; none when 0 or nothing is given.
    #[port("Refit", "R", optional)]
    refit: Option<i32>,
    /// So many points at equal lengths become the control points; none when 0 or nothing is given.
    #[port("Point Sample", "P", optional)]
    sample: Option<i32>,
) -> Result<Shared<Curve>, Message> {
    super::tween::unsupported(context, equalized, false);
    let way = Match { refit, sample };
    let curves: Vec<Shared<Curve>> =
        curves.present().map(|curve| way.ready(context, &curve)).collect::<Result<_, _>>()?;
    let way = Way { normalized, closed, smooth: kind > 0 };
    blend(context, &curves, weights(curves.len(), factor, way)?)
}

/// A smooth curve that follows another one with evenly spaced control points. Stands for Pufferfish's Rebuild Curve.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f302d",
    name = "Rebuild Curve",
    nick = "RebCrv",
    at = "Pufferfish/Curve"
)]
#[output("Rebuilt", "R", "The new curve.")]
fn rebuild(
    context: &Context<'_>,
    /// The curve to follow.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The number of control points; as many as the curve has when nothing is given.
    #[port("Count", "P", optional)]
    count: Option<i32>,
    /// The degree; that of the curve when nothing is given.
    #[port("Degree", "D", optional)]
    degree: Option<i32>,
    /// The domain; that of the curve when nothing is given.
    #[port("Domain", "I", optional)]
    domain: Option<Interval>,
    /// Whether the directions at the ends are kept.
    #[port("End Tangents", "E", default = false)]
    tangents: bool,
) -> Result<Shared<Curve>, Message> {
    let nurbs = curve.to_nurbs()?;
    let whole = |n: Option<i32>, own: usize| n.map_or(own, |n| usize::try_from(n).unwrap_or(0));
    let count = whole(count, nurbs.point_count());
    if !(2..=MOST_PARTS).contains(&count) {
        return Err(Message::error(format!("{count} control points make no curve")));
    }
    let degree = whole(degree, nurbs.degree()).clamp(1, 11).min(count - 1);
    context.items(count)?;
    let rebuilt = Curve::from(curve.rebuilt(degree, count, tangents)?.curve);
    let domain = domain.unwrap_or_else(|| curve.domain());
    Ok(Shared::new(rebuilt.with_domain(domain)?))
}

/// Closes an open curve. Stands for Pufferfish's Close Curve; closing by meeting ends moves both to their middle.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f302e",
    name = "Close Curve",
    nick = "ClsCrv",
    at = "Pufferfish/Curve"
)]
#[output("Closed", "C", "The curve.")]
#[output("Result Boolean", "R", "Whether it was closed.")]
fn close(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: Shared<Curve>,
    /// 0 by a line, 1 by a curve with the same tangents, 2 with the same curvatures too, 3 by moving the ends together.
    #[port("Close Type", "T", default = 0)]
    kind: i32,
    /// How far the closing curve swings out.
    #[port("Bulge", "B", default = 1.0)]
    bulge: f64,
    /// The greatest gap that is closed, in units; 0 closes any.
    #[port("Tolerance", "t", default = 0.0)]
    most: f64,
) -> Result<(Shared<Curve>, bool), Message> {
    let tolerance = context.tolerance();
    let gap = curve.start().distance_to(curve.end());
    if curve.is_closed() || curve.is_linear(tolerance.absolute) || (most > 0.0 && gap > most) {
        return Ok((curve, false));
    }
    if kind == 3 {
        let middle = curve.start().lerp(curve.end(), 0.5);
        let nurbs = curve.to_nurbs()?.clamped()?;
        let last = nurbs.point_count() - 1;
        let closed = nurbs.with_control_point(0, middle)?.with_control_point(last, middle)?;
        return Ok((Shared::new(Curve::from(closed)), true));
    }
    let piece = match kind {
        0 => Curve::from(Line::new(curve.end(), curve.start())),
        1 => curve.blend_to(&curve, [1, 1], [bulge, bulge])?,
        _ => curve.blend_to(&curve, [2, 2], [bulge, bulge])?,
    };
    let joined = join_curves(&[(*curve).clone(), piece], tolerance.absolute, true);
    let closed = joined.into_iter().next().ok_or_else(|| Message::error("The curve was not closed"))?;
    let is_closed = closed.is_closed();
    Ok((Shared::new(closed), is_closed))
}

/// Offsets a curve in a plane, to one side or both. Stands for Pufferfish's Offset Curve; ends are capped by lines only.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f302f",
    name = "Offset Curve",
    nick = "OffCrv",
    at = "Pufferfish/Curve"
)]
#[output("Offset", "O", "The offsets.")]
fn offset(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The plane; the curve's own, or the world's xy, when nothing is given.
    #[port("Plane", "Pl", optional)]
    plane: Option<Plane>,
    /// The distance, in units.
    #[port("Distance", "D", default = 1.0)]
    distance: f64,
    /// A second distance, of the other sign for the other side.
    #[port("Both Sides", "B", optional)]
    other: Option<f64>,
    /// What happens at kinks: 0 sharp, 1 round, 2 smooth, 3 chamfer.
    #[port("Kinks", "K", default = 0)]
    kinks: i32,
    /// How the ends of two offsets are joined: 0 not, others by lines.
    #[port("Cap Type", "T", default = 0)]
    cap: i32,
) -> Result<Vec<Shared<Curve>>, Message> {
    let tolerance = context.tolerance();
    let plane = plane.or_else(|| curve.plane(tolerance.absolute)).unwrap_or(Plane::XY);
    let corner = match kinks {
        0 => OffsetCorner::Sharp,
        1 => OffsetCorner::Round,
        2 => OffsetCorner::Smooth,
        _ => OffsetCorner::Chamfer,
    };
    let of = |distance: f64| curve.offset(&plane, distance, corner, &tolerance);
    let mut curves = of(distance)?;
    if let Some(other) = other.filter(|d| *d != 0.0) {
        let second = of(other)?;
        if let (true, [a], [b]) = (cap > 0 && !curve.is_closed(), curves.as_slice(), second.as_slice()) {
            let ends = [Line::new(a.end(), b.end()), Line::new(b.start(), a.start())].map(Curve::from);
            let pieces = [a.clone(), b.clone()].into_iter().chain(ends).collect::<Vec<_>>();
            curves = join_curves(&pieces, tolerance.absolute, false);
        } else {
            curves.extend(second);
        }
    }
    Ok(curves.into_iter().map(Shared::new).collect())
}

/// The middle of a curve by its length or by its domain. Stands for Pufferfish's Curve Middle Point; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3030",
    name = "Curve Middle Point",
    nick = "CrvMidPt",
    at = "Pufferfish/Point"
)]
#[output("Middle Point", "M", "The point.")]
fn middle(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// Whether the middle of the domain is meant, not that of the length.
    #[port("Domain", "D", default = false)]
    domain: bool,
) -> Result<Point3, Message> {
    let t = if domain { Some(curve.domain().middle()) } else { curve.parameter_at_normalized_length(0.5) };
    t.map(|t| curve.point_at(t)).ok_or_else(|| Message::error("The curve has no middle"))
}

/// The degree of a curve. Stands for Pufferfish's Curve Degree.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3031",
    name = "Curve Degree",
    nick = "CrvDeg",
    at = "Pufferfish/Curve"
)]
#[output("Degree", "D", "The degree.")]
fn degree(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<i32, Message> {
    Ok(i32::try_from(curve.to_nurbs()?.degree()).unwrap_or(i32::MAX))
}

/// Whether a curve is straight. Stands for Pufferfish's Is Curve Linear.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3032",
    name = "Is Curve Linear",
    nick = "CrvLinr",
    at = "Pufferfish/Curve"
)]
#[output("Linear", "L", "Whether it is straight.")]
fn is_linear(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// How far it may stray, in units; the document's tolerance when nothing is given.
    #[port("Tolerance", "t", optional)]
    tolerance: Option<f64>,
) -> bool {
    curve.is_linear(tolerance.unwrap_or(context.tolerance().absolute))
}

/// A curve over another domain. Stands for Pufferfish's Remap Curve Domain; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3033",
    name = "Remap Curve Domain",
    nick = "ReCrvDom",
    at = "Pufferfish/Curve"
)]
#[output("Remapped", "R", "The curve.")]
fn remap(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The domain.
    #[port("Domain", "D", default = Interval::UNIT)]
    domain: Interval,
    /// A curve whose domain is taken instead.
    #[port("Guide", "G", optional)]
    guide: Option<Shared<Curve>>,
) -> Result<Shared<Curve>, Message> {
    let domain = guide.map_or(domain, |guide| guide.domain());
    Ok(Shared::new(curve.with_domain(domain)?))
}

/// A curve over the domain 0 to 1. Stands for Pufferfish's Reparameterize Curve.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3034",
    name = "Reparameterize Curve",
    nick = "ReparamCrv",
    at = "Pufferfish/Curve"
)]
#[output("Reparameterized", "R", "The curve.")]
fn reparameterize(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<Shared<Curve>, Message> {
    Ok(Shared::new(curve.with_domain(Interval::UNIT)?))
}

/// The length of a curve up to a point, or to a parameter. Stands for Pufferfish's Curve Length At; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3035",
    name = "Curve Length At",
    nick = "CrvLenAt",
    at = "Pufferfish/Curve"
)]
#[output("Length", "L", "The length, in units.")]
fn length_at(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The point; the nearest of the curve counts.
    #[port("Point", "P", optional)]
    point: Option<Point3>,
    /// The parameter, where no point is given.
    #[port("Parameter", "t", optional)]
    parameter: Option<f64>,
) -> Result<f64, Message> {
    let t = match (point, parameter) {
        (Some(p), _) => curve.closest_point(p)?.parameter,
        (None, Some(t)) => t,
        (None, None) => return Err(Message::warning("A point or a parameter is needed")),
    };
    Ok(curve.length_between(Interval::new(curve.domain().start, curve.domain().clamp(t))))
}

/// A rectangle round geometry, along a plane: one for all, or one for each. Stands for Pufferfish's Bounding Rectangle.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3036",
    name = "Bounding Rectangle",
    nick = "BRec",
    at = "Pufferfish/Curve"
)]
#[output("Bounding", "B", "The rectangles.")]
#[output("Dimension X", "X", "Their sizes along x.")]
#[output("Dimension Y", "Y", "Their sizes along y.")]
fn bounding_rectangle(
    context: &Context<'_>,
    /// The geometry.
    #[port("Geometry", "G")]
    geometry: List<Geometry>,
    /// The plane along which the rectangles lie.
    #[port("Plane", "Pl", default = Plane::XY)]
    plane: Plane,
    /// The axis across the rectangles: 0 is z, 1 is y, 2 is x.
    #[port("Axis", "A", default = 0)]
    axis: i32,
    /// Where along the axis they lie: 0 at the start of the geometry, 1 at its end.
    #[port("Slide", "S", default = 0.0)]
    slide: f64,
    /// Whether one rectangle goes round all.
    #[port("Union", "U", default = true)]
    union: bool,
) -> Result<(Vec<Rectangle>, Vec<f64>, Vec<f64>), Message> {
    let Plane { origin, x_axis, y_axis, z_axis } = plane;
    let frame = match axis {
        0 => plane,
        1 => Plane::from_axes(origin, x_axis, z_axis)?,
        _ => Plane::from_axes(origin, y_axis, z_axis)?,
    };
    let mut boxes: Vec<Box3> = Vec::new();
    for Geometry(value) in geometry.present() {
        context.check()?;
        boxes.extend(bounds(context, &value, &frame)?);
    }
    if union && let Some(first) = boxes.first().copied() {
        let all = boxes.iter().fold(first, |all, b| Box3 {
            plane: all.plane,
            x: all.x.union(b.x),
            y: all.y.union(b.y),
            z: all.z.union(b.z),
        });
        boxes = vec![all];
    }
    let rectangle = |b: &Box3| {
        let plane = frame.with_origin(frame.at(0.0, 0.0, b.z.at(slide)));
        Rectangle { plane, x: b.x, y: b.y }
    };
    Ok((
        boxes.iter().map(rectangle).collect(),
        boxes.iter().map(|b| b.x.length()).collect(),
        boxes.iter().map(|b| b.y.length()).collect(),
    ))
}

/// The box of one thing in a frame.
fn bounds(context: &Context<'_>, value: &Value, frame: &Plane) -> Result<Option<Box3>, Message> {
    let cast = |kind| katydid_data::cast::value(value, kind, context.rules());
    if let Value::Point(p) = value {
        return Ok(Box3::around(frame, [*p]));
    }
    if let Value::Mesh(mesh) = value {
        return Ok(Box3::around(frame, mesh.vertices().iter().copied()));
    }
    if let Value::Surface(surface) = value {
        return Ok(Some(surface.bounding_box_in(frame)?));
    }
    Ok(match cast(Kind::Curve) {
        Some(Value::Curve(curve)) => Some(curve.bounding_box_in(frame)),
        _ => match cast(Kind::Brep).and_then(|made| made.brep()) {
            Some(brep) => Some(brep.map_err(Message::error)?.bounding_box_in(frame)?),
            None => None,
        },
    })
}
