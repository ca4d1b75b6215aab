//! Curves made from curves: simpler, longer, shorter, in pieces.

use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::intersect::curve_with_surface;
use katydid_geometry::{
    Brep, Curve, ExtensionStyle, Interval, NurbsCurve, Plane, Point3, PolylineCurve, PolylineLimits, Surface,
    Tolerance, Vector3, Xform,
};

use super::answer::Outcome;
use super::argument::{Count, Turn, Within};
use super::choice::{Corner, End, Extension};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("curve/duplicatesegments-curve", |c: Curve| Ok(c.explode(false)?));
    table.add(
        "curve/simplify-curve_curvesimplifyoptions_double_double",
        |c: Curve, options: i32, d: Within, a: Turn| {
            if options != ALL_OPTIONS {
                return Err(Fault::not_supported("simplifying by some of the options only"));
            }
            Ok(c.simplified(&a.and(d))?)
        },
    );
    table.add("curve/fit-curve_int_double_double", |c: Curve, degree: Count<1, 11>, t: Within, _: Turn| {
        Ok(Curve::from(c.refitted(degree.0, t.0)?.curve))
    });
    table.add(
        "curve/rebuild-curve_int_int_bool",
        |c: Curve, n: Count<2, 10_000>, d: Count<1, 11>, keep: bool| {
            Ok(Curve::from(c.rebuilt(d.0, n.0, keep)?.curve))
        },
    );
    table.add(
        "curve/topolyline-curve_double_double_double_double",
        |c: Curve, t: Size, angle: Size, least: Size, most: Size| {
            to_polyline(&c, [t, angle, least, most], None)
        },
    );
    table.add(
        "curve/topolyline-curve_int_int_double_double_double_double_double_double_bool",
        |c: Curve,
         n: Segments,
         _: i32,
         angle: Size,
         _: f64,
         _: f64,
         t: Size,
         least: Size,
         most: Size,
         _: bool| { to_polyline(&c, [t, angle, least, most], Some(n)) },
    );
    table.add(
        "curve/topolyline-curve_int_int_double_double_double_double_double_double_bool_interval",
        |c: Curve,
         n: Segments,
         _: i32,
         angle: Size,
         _: f64,
         _: f64,
         t: Size,
         least: Size,
         most: Size,
         _: bool,
         part: Interval| { to_polyline(&c.sub_curve(part)?, [t, angle, least, most], Some(n)) },
    );
    table.add(
        "curve/toarcsandlines-curve_double_double_double_double",
        |c: Curve, t: Within, _: f64, _: f64, _: f64| Ok(Curve::from(c.to_arcs_and_lines(t.0)?)),
    );
    table.add(
        "curve/offset-curve_plane_double_double_curveoffsetcornerstyle",
        |c: Curve, plane: Plane, d: f64, t: Within, corner: Corner| {
            offset(&c, &plane, d, t.tolerance(), corner)
        },
    );
    table.add(
        "curve/offset-curve_point3d_vector3d_double_double_curveoffsetcornerstyle",
        |c: Curve, towards: Point3, normal: Vector3, d: f64, t: Within, corner: Corner| {
            offset_towards(&c, towards, normal, d, t.tolerance(), corner)
        },
    );
    table.add(
        "curve/offset-curve_point3d_vector3d_double_double_double_bool_curveoffsetcornerstyle_curveoffsetendstyle",
        |c: Curve, towards: Point3, normal: Vector3, d: f64, t: Within, a: Turn, loose: bool, corner: Corner, end: i32| {
            if loose || end != 0 {
                return Err(Fault::not_supported("loose offsets and offsets with closed ends"));
            }
            offset_towards(&c, towards, normal, d, a.and(t), corner)
        },
    );
    table.add("curve/trim-curve_curveend_double", trimmed);
    table.add("curve/split-curve_brep_double", |c: Curve, b: Brep, t: Within| split_by_brep(&c, b, t));
    table.add("curve/split-curve_brep_double_double", |c: Curve, b: Brep, t: Within, _: Turn| {
        split_by_brep(&c, b, t)
    });
    table.add("curve/split-curve_surface_double", |c: Curve, s: Surface, t: Within| {
        split_by_surface(&c, &s, t)
    });
    table.add("curve/split-curve_surface_double_double", |c: Curve, s: Surface, t: Within, _: Turn| {
        split_by_surface(&c, &s, t)
    });
    table.add("curve/extend-curve_double_double", |c: Curve, t0: f64, t1: f64| {
        extended_to(&c, Interval::new(t0, t1))
    });
    table.add("curve/extend-curve_interval", |c: Curve, domain: Interval| extended_to(&c, domain));
    table.add(
        "curve/extend-curve_curveend_double_curveextensionstyle",
        |c: Curve, end: End, length: Size, style: Extension| {
            let [start, end] = end.0.map(|wanted| if wanted { length.0 } else { 0.0 });
            Ok(c.extended(start, end, style.0)?)
        },
    );
    table.add("curve/projecttoplane-curve_plane", |c: Curve, plane: Plane| {
        Ok(c.transformed(&Xform::planar_projection(&plane))?)
    });
}

/// `CurveSimplifyOptions.All`: knots, lines, arcs, rationals, kinks, and merging.
const ALL_OPTIONS: i32 = 63;

/// A length or angle: finite and not below 0.
struct Size(f64);

impl crate::wire::Read for Size {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        let x = f64::read(json)?;
        if x >= 0.0 { Ok(Self(x)) } else { Err(Fault::bad_request(format!("is {x}, below 0"))) }
    }

    fn type_name() -> String {
        "Double".into()
    }
}

/// How many segments a polyline has at least; 0 or less leaves it to the other limits.
type Segments = i32;

/// A polyline within a distance and an angle, with segments from a least to a greatest length; 0 is no limit. Without
/// distance and angle, of so many segments.
fn to_polyline(curve: &Curve, limits: [Size; 4], segments: Option<Segments>) -> Outcome<PolylineCurve> {
    let [distance, angle, shortest, longest] = limits.map(|size| size.0);
    let above = |x: f64| (x > 0.0).then_some(x);
    let count = segments.filter(|n| *n > 0 && distance == 0.0 && angle == 0.0);
    if let Some(count) = count {
        let count = count.min(1_000_000);
        let at = |k| curve.point_at(curve.domain().at(f64::from(k) / f64::from(count)));
        return Ok(PolylineCurve::new((0..=count).map(at).collect())?);
    }
    let size = curve.bounding_box().diagonal().length();
    let limits = PolylineLimits {
        // Without a distance the others say how fine it is.
        distance: above(distance)
            .unwrap_or(if angle > 0.0 || longest > 0.0 { size } else { 0.001 })
            .max(1e-12),
        angle: above(angle),
        shortest,
        longest: above(longest),
    };
    Ok(curve.to_polyline(&limits)?)
}

fn offset(
    curve: &Curve,
    plane: &Plane,
    distance: f64,
    t: Tolerance,
    corner: Corner,
) -> Outcome<Option<Vec<Curve>>> {
    let found = curve.offset(plane, distance, corner.0, &t)?;
    Ok((!found.is_empty()).then_some(found))
}

/// The offset on the side on which a point lies.
fn offset_towards(
    curve: &Curve,
    towards: Point3,
    normal: Vector3,
    distance: f64,
    tolerance: Tolerance,
    corner: Corner,
) -> Outcome<Option<Vec<Curve>>> {
    let plane = Plane::from_normal(curve.start(), normal)?;
    let near = curve.closest_point(towards)?;
    let tangent =
        curve.tangent_at(near.parameter).ok_or_else(|| Fault::bad_request("curve has no direction"))?;
    let right = tangent.cross(plane.z_axis);
    let side = right.dot(towards - near.point);
    if side == 0.0 {
        return Err(Fault::bad_request("directionPoint lies on neither side of the curve"));
    }
    offset(curve, &plane, distance.abs() * side.signum(), tolerance, corner)
}

/// The curve without a length at its start, its end or both; `None` when nothing is left.
fn trimmed(curve: Curve, side: End, length: f64) -> Outcome<Option<Curve>> {
    if length < 0.0 {
        return Err(Fault::bad_request(format!("length is {length}, below 0")));
    }
    let whole = curve.length();
    let [start, end] = side.0.map(|wanted| if wanted { length } else { 0.0 });
    let (from, to) = (curve.parameter_at_length(start), curve.parameter_at_length(whole - end));
    match (from, to) {
        (Some(from), Some(to)) if start + end < whole && from < to => {
            Ok(Some(curve.trimmed(Interval::new(from, to))?))
        }
        _ => Ok(None),
    }
}

/// The pieces between parameters; a curve that is not cut is one piece.
fn pieces(curve: &Curve, mut at: Vec<f64>) -> Outcome<Vec<Curve>> {
    let domain = curve.domain();
    let least = 1e-9 * domain.length();
    at.retain(|t| curve.is_closed() || (*t > domain.start + least && *t < domain.end - least));
    at.sort_by(f64::total_cmp);
    at.dedup_by(|b, a| (*b - *a).abs() <= least);
    if at.is_empty() { Ok(vec![curve.clone()]) } else { Ok(curve.split_at(&at)?) }
}

fn split_by_brep(curve: &Curve, cutter: Brep, tolerance: Within) -> Outcome<Vec<Curve>> {
    let found = ClosestOnBrep::new(cutter.into())?.curve_crossings(curve, tolerance.0)?;
    let ends = found.overlaps.iter().flat_map(|overlap| [overlap.start, overlap.end]);
    pieces(curve, found.crossings.iter().map(|c| c.t).chain(ends).collect())
}

fn split_by_surface(curve: &Curve, cutter: &Surface, tolerance: Within) -> Outcome<Vec<Curve>> {
    let found = curve_with_surface(curve, cutter, tolerance.0)?;
    let ends = found.overlaps.iter().flat_map(|overlap| [overlap.t.start, overlap.t.end]);
    pieces(curve, found.crossings.iter().map(|c| c.t).chain(ends).collect())
}

/// The curve over a larger domain: lines and arcs go on as they are, others by their last polynomials.
fn extended_to(curve: &Curve, domain: Interval) -> Outcome<Curve> {
    let own = curve.domain();
    if domain.start > own.start || domain.end < own.end {
        return Err(Fault::bad_request("domain does not hold the curve's own"));
    }
    match curve {
        Curve::Line(_) | Curve::Arc(_) => {
            let speed = curve.length() / own.length();
            let (start, end) = ((own.start - domain.start) * speed, (domain.end - own.end) * speed);
            Ok(curve.extended(start, end, ExtensionStyle::Smooth)?)
        }
        other => {
            let nurbs: NurbsCurve = other.to_nurbs()?;
            Ok(nurbs.extended_to(domain)?.into())
        }
    }
}
