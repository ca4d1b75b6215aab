//! Ends of curves: blended, closed, and extended until they meet something.

use katydid_geometry::biarc::biarc;
use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::intersect::{curve_curve, curve_with_surface};
use katydid_geometry::{
    Arc, BoundingBox, Curve, ExtensionStyle, Interval, Line, NurbsCurve, Point3, PolyCurve, PolylineCurve,
    Tolerance, Vector3,
};

use super::answer::Outcome;
use super::argument::{Positive, Some1, Waiting, Within};
use super::choice::{Blend, End, Extension};
use super::table::Endpoints;
use crate::Fault;
use crate::wire::GeometryBase;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("curve/extend-curve_curveend_curveextensionstyle_point3d", extended_to);
    table.add(
        "curve/createarcblend-point3d_vector3d_point3d_vector3d_double",
        |from: Point3, out: Vector3, to: Point3, into: Vector3, ratio: Positive| {
            // The ratio is that of the first arc's control polygon to the second's.
            let arcs = biarc(from, out, to, into, ratio.0 / (1.0 + ratio.0));
            Ok(arcs.and_then(|arcs| PolyCurve::new(arcs.into())).ok().map(Curve::from))
        },
    );
    table.add(
        "curve/createblendcurve-curve_double_bool_blendcontinuity_curve_double_bool_blendcontinuity",
        |a: Curve, t: f64, turn: bool, order: Blend, b: Curve, s: f64, turned: bool, last: Blend| {
            let (from, to) = (leaving(&a, t, turn)?, leaving(&b, s, turned)?);
            Ok(from.blend_to(&to.reversed(), [order.0, last.0], [1.0; 2])?)
        },
    );
    table.add("curve/makeclosed-curve_double", |c: Curve, t: Reach| {
        Ok(match closed(&c, t.0)? {
            Some(closed) => (true, closed),
            None => (c.is_closed(), c),
        })
    });
    table.add("curve/removeshortsegments-curve_double", |c: Curve, t: Within| {
        Ok(match without_short(&c, t.0)? {
            Some(rest) => (true, rest),
            None => (false, c),
        })
    });
    table.add(
        "curve/extendbyline-curve_curveend_geometrybasearray",
        |c: Curve, end: End, g: Targets, w: Waiting| extended(&c, end, ExtensionStyle::Line, &g.0, &w),
    );
    table.add(
        "curve/extendbyarc-curve_curveend_geometrybasearray",
        |c: Curve, end: End, g: Targets, w: Waiting| extended(&c, end, ExtensionStyle::Arc, &g.0, &w),
    );
    table.add(
        "curve/extend-curve_curveend_curveextensionstyle_geometrybasearray",
        |c: Curve, end: End, style: Extension, g: Targets, w: Waiting| extended(&c, end, style.0, &g.0, &w),
    );
}

type Targets = Some1<GeometryBase>;

/// A distance; 0 for any.
struct Reach(f64);

impl crate::wire::Read for Reach {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        let x = f64::read(json)?;
        if x >= 0.0 { Ok(Self(x)) } else { Err(Fault::bad_request(format!("is {x}, below 0"))) }
    }

    fn type_name() -> String {
        "Double".into()
    }
}

/// A curve that ends where another one is left, with its direction or against it, and its curvature.
fn leaving(curve: &Curve, t: f64, against: bool) -> Outcome<Curve> {
    let domain = curve.domain();
    if !domain.contains(t) {
        let Interval { start, end } = domain;
        return Err(Fault::bad_request(format!("a parameter is {t}, not {start} to {end}")));
    }
    // At the very end the side that there is counts.
    let below = t >= domain.end;
    let way =
        curve.tangent_on_side(t, below).ok_or_else(|| Fault::bad_request("a curve has no direction"))?;
    let length = 0.1 * curve.length().max(f64::MIN_POSITIVE);
    let way = way * if against { -length } else { length };
    let bend = curve.curvature_on_side(t, below) * (length * length);
    let end = curve.point_at(t);
    // The parabola with these derivatives at its end.
    Ok(NurbsCurve::bezier(&[end - way + bend * 0.5, end - way * 0.5, end])?.into())
}

/// The curve continued at one end to a point: by a line straight to it, or by the arc that leaves in the direction of the
/// end. `None` at both ends or at none, of closed curves, and where no such piece leads there.
fn extended_to(
    curve: Curve,
    End(ends): End,
    Extension(style): Extension,
    point: Point3,
) -> Outcome<Option<Curve>> {
    if curve.is_closed() || ends[0] == ends[1] {
        return Ok(None);
    }
    // Always at the end.
    let turned = if ends[0] { curve.reversed() } else { curve };
    let (last, from) = (turned.domain().end, turned.end());
    let piece = match style {
        ExtensionStyle::Line => Line::new(from, point).into(),
        ExtensionStyle::Arc => {
            let Some(way) = turned.tangent_on_side(last, true) else { return Ok(None) };
            match Arc::from_start_direction_end(from, way, point) {
                Ok(arc) => arc.into(),
                // Straight ahead the arc is a line.
                Err(_) if way.cross(point - from).length() <= 1e-9 * point.distance_to(from) => {
                    if way.dot(point - from) <= 0.0 {
                        return Ok(None);
                    }
                    Line::new(from, point).into()
                }
                Err(_) => return Ok(None),
            }
        }
        ExtensionStyle::Smooth => {
            return Err(Fault::not_supported("smooth extensions to points"));
        }
    };
    if point.distance_to(from) <= 1e-12 * (1.0 + from.to_vector().length()) {
        return Ok(None);
    }
    let whole: Curve = PolyCurve::new(vec![turned, piece])?.into();
    Ok(Some(if ends[0] { whole.reversed() } else { whole }))
}

/// The curve with its end moved to its start; `None` where it is closed, or cannot be, or the gap is wider than a reach
/// above 0.
fn closed(curve: &Curve, reach: f64) -> Outcome<Option<Curve>> {
    let (start, gap) = (curve.start(), curve.start().distance_to(curve.end()));
    if curve.is_closed() || (reach > 0.0 && gap > reach) {
        return Ok(None);
    }
    // What would collapse stays open.
    let few = match curve {
        Curve::Line(_) => true,
        Curve::Polyline(line) => line.points().len() < 4,
        Curve::Nurbs(nurbs) => nurbs.point_count() < 4,
        Curve::Arc(_) => false,
        Curve::Poly(chain) => chain.segments().len() < 2,
    };
    if few || curve.is_linear(1e-9 * curve.length()) { Ok(None) } else { ending_at(curve, start).map(Some) }
}

/// The curve with its end elsewhere.
fn ending_at(curve: &Curve, end: Point3) -> Outcome<Curve> {
    Ok(match curve {
        Curve::Line(own) => Line::new(own.line.from, end).into(),
        Curve::Polyline(own) => {
            let (mut points, parameters) = own.clone().into_parts();
            if let Some(last) = points.last_mut() {
                *last = end;
            }
            PolylineCurve::with_parameters(points, parameters)?.into()
        }
        Curve::Poly(own) => {
            let (mut segments, parameters) = own.clone().into_parts();
            if let Some(last) = segments.last_mut() {
                *last = ending_at(last, end)?;
            }
            PolyCurve::with_parameters(segments, parameters)?.into()
        }
        other => {
            let nurbs = other.to_nurbs()?.clamped()?;
            nurbs.with_control_point(nurbs.point_count().saturating_sub(1), end)?.into()
        }
    })
}

/// A chain without segments shorter than a length; `None` when there are none. The ends stay.
fn without_short(curve: &Curve, least: f64) -> Outcome<Option<Curve>> {
    match curve {
        Curve::Polyline(line) => {
            let points = line.points();
            let mut kept: Vec<Point3> = Vec::with_capacity(points.len());
            for p in points {
                if kept.last().is_none_or(|last| last.distance_to(*p) >= least) {
                    kept.push(*p);
                }
            }
            if kept.len() == points.len() {
                return Ok(None);
            }
            if kept.last() != points.last() {
                // The last corner gives way to the end.
                if kept.len() > 1 {
                    kept.pop();
                }
                kept.extend(points.last());
            }
            Ok((kept.len() > 1).then(|| PolylineCurve::new(kept)).transpose()?.map(Curve::from))
        }
        Curve::Poly(chain) => {
            let (start, end) = (curve.start(), curve.end());
            let segments = chain.segments();
            let mut kept: Vec<Curve> = segments.iter().filter(|s| s.length() >= least).cloned().collect();
            if kept.len() == segments.len() || kept.is_empty() {
                return Ok(None);
            }
            // Each begins where the one before it ends, the first and the last where the chain does.
            let mut at = start;
            for segment in &mut kept {
                if segment.start() != at {
                    *segment = ending_at(&segment.reversed(), at)?.reversed();
                }
                at = segment.end();
            }
            if let Some(last) = kept.last_mut().filter(|last| last.end() != end) {
                *last = ending_at(last, end)?;
            }
            Ok(Some(PolyCurve::new(kept)?.into()))
        }
        _ => Ok(None),
    }
}

/// The curve extended at its start, its end or both until it meets one of the shapes; `None` when it meets none.
fn extended(
    curve: &Curve,
    ends: End,
    style: ExtensionStyle,
    targets: &[GeometryBase],
    waiting: &Waiting,
) -> Outcome<Option<Curve>> {
    if curve.is_closed() {
        return Err(Fault::bad_request("the curve is closed: it has no ends"));
    }
    let mut bounds = curve.bounding_box();
    for target in targets {
        bounds = bounds.union(&extent(target)?);
    }
    // So far away nothing is left to meet.
    let reach = 2.0 * bounds.diagonal().length();
    let [at_start, at_end] = ends.0;
    let mut out = curve.clone();
    if at_end {
        out = met(&out, style, reach, targets, waiting)?.unwrap_or(out);
    }
    if at_start {
        let back = out.reversed();
        out = met(&back, style, reach, targets, waiting)?.map_or(out, |longer| longer.reversed());
    }
    Ok((out != *curve).then_some(out))
}

fn extent(target: &GeometryBase) -> Outcome<BoundingBox> {
    match target {
        GeometryBase::Curve(curve) => Ok(curve.bounding_box()),
        GeometryBase::Surface(surface) => Ok(surface.bounding_box()?),
        GeometryBase::Brep(brep) => {
            brep.bounds_of_faces().ok_or_else(|| Fault::bad_request("geometry has a brep without faces"))
        }
        _ => Err(Fault::bad_request("geometry has what is no curve, surface or brep")),
    }
}

/// The curve with its end at the first of the shapes that its extension meets.
fn met(
    curve: &Curve,
    style: ExtensionStyle,
    reach: f64,
    targets: &[GeometryBase],
    waiting: &Waiting,
) -> Outcome<Option<Curve>> {
    let domain = curve.domain();
    let long = lengthened(curve, style, reach)?;
    let tolerance = Tolerance::default().absolute;
    // Where it meets the curve's own end is no extension.
    let least = domain.end + 1e-9 * (long.domain().end - domain.end);
    let extension = long.sub_curve(Interval::new(domain.end, long.domain().end))?;
    let mut nearest: Option<f64> = None;
    for target in targets {
        waiting.check()?;
        let found: Vec<f64> = match target {
            GeometryBase::Curve(other) => {
                let found = curve_curve(&extension, other, tolerance)?;
                let overlaps = found.overlaps.iter().map(|overlap| overlap.a.start);
                found.crossings.iter().map(|crossing| crossing.a).chain(overlaps).collect()
            }
            GeometryBase::Surface(surface) => {
                let found = curve_with_surface(&extension, surface, tolerance)?;
                found.crossings.iter().map(|crossing| crossing.t).collect()
            }
            GeometryBase::Brep(brep) => {
                let found =
                    ClosestOnBrep::new(brep.clone().into())?.curve_crossings(&extension, tolerance)?;
                found.crossings.iter().map(|crossing| crossing.t).collect()
            }
            _ => Vec::new(),
        };
        for t in found.into_iter().filter(|t| *t > least) {
            nearest = Some(nearest.map_or(t, |best| best.min(t)));
        }
    }
    nearest.map(|t| Ok(long.trimmed(Interval::new(domain.start, t))?)).transpose()
}

/// The curve extended at its end by a length; arcs by less than a turn in all, and others by as much as they can be.
fn lengthened(curve: &Curve, style: ExtensionStyle, reach: f64) -> Outcome<Curve> {
    let mut length = reach;
    let mut last = None;
    for _ in 0..24 {
        match curve.extended(0.0, length, style) {
            Ok(longer) => return Ok(longer),
            Err(error) => last = Some(error),
        }
        length *= 0.7;
    }
    Err(last.map_or_else(|| Fault::failed("the curve cannot be extended"), Fault::from))
}
