//! Curves made from points, or between curves.

use katydid_geometry::{
    Arc, Curve, Interval, KnotSpacing, NurbsCurve, Point3, Tolerance, TweenMatch, Vector3,
    intersect::curve_curve, join_curves,
};
use serde_json::Value as Json;

use super::answer::Outcome;
use super::argument::{Count, Positive, Some1, Turn, Within, choice};
use super::choice::Blend;
use super::table::Endpoints;
use crate::Fault;
use crate::wire::Read;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("curve/createinterpolatedcurve-point3darray_int", |points: Points, degree: Degree| {
        interpolated(&points.0, degree, Knots::CHORD, None, None)
    });
    table.add(
        "curve/createinterpolatedcurve-point3darray_int_curveknotstyle",
        |points: Points, degree: Degree, knots: Knots| interpolated(&points.0, degree, knots, None, None),
    );
    table.add(
        "curve/createinterpolatedcurve-point3darray_int_curveknotstyle_vector3d_vector3d",
        |points: Points, degree: Degree, knots: Knots, start: Vector3, end: Vector3| {
            interpolated(&points.0, degree, knots, Some(start), Some(end))
        },
    );
    table.add("curve/createmeancurve-curve_curve", |a: Curve, b: Curve| Ok(Curve::from(a.mean_with(&b)?)));
    table.add("curve/createmeancurve-curve_curve_double", |a: Curve, b: Curve, _: Turn| {
        Ok(Curve::from(a.mean_with(&b)?))
    });
    table.add("curve/createblendcurve-curve_curve_blendcontinuity", |a: Curve, b: Curve, order: Blend| {
        Ok(a.blend_to(&b, [order.0; 2], [1.0; 2])?)
    });
    table.add(
        "curve/createblendcurve-curve_curve_blendcontinuity_double_double",
        |a: Curve, b: Curve, order: Blend, first: f64, second: f64| {
            Ok(a.blend_to(&b, [order.0; 2], [first, second])?)
        },
    );
    table.add("curve/createfillet-curve_curve_double_double_double", fillet_arc);
    let control_points = |a: Curve, b: Curve, n: Between| tweens(&a, &b, n, TweenMatch::ControlPoints);
    table.add("curve/createtweencurves-curve_curve_int", control_points);
    table.add("curve/createtweencurveswithmatching-curve_curve_int", control_points);
    table.add(
        "curve/createtweencurveswithmatching-curve_curve_int_double",
        |a: Curve, b: Curve, n: Between, _: Within| tweens(&a, &b, n, TweenMatch::ControlPoints),
    );
    table.add(
        "curve/createtweencurves-curve_curve_int_double",
        |a: Curve, b: Curve, n: Between, _: Within| tweens(&a, &b, n, TweenMatch::ControlPoints),
    );
    table.add(
        "curve/createtweencurveswithsampling-curve_curve_int_int",
        |a: Curve, b: Curve, n: Between, samples: Samples| tweens(&a, &b, n, TweenMatch::Lengths(samples.0)),
    );
    table.add(
        "curve/createtweencurveswithsampling-curve_curve_int_int_double",
        |a: Curve, b: Curve, n: Between, samples: Samples, _: Within| {
            tweens(&a, &b, n, TweenMatch::Lengths(samples.0))
        },
    );
    let default = Tolerance::default().absolute;
    table.add("curve/joincurves-curvearray", move |c: Vec<Curve>| Ok(join_curves(&c, default, false)));
    table.add("curve/joincurves-curvearray_double", |c: Vec<Curve>, t: Within| {
        Ok(join_curves(&c, t.0, false))
    });
    table.add("curve/joincurves-curvearray_double_bool", |c: Vec<Curve>, t: Within, keep: bool| {
        Ok(join_curves(&c, t.0, keep))
    });
    table.add(
        "curve/createfilletcornerscurve-curve_double_double_double",
        |c: Curve, radius: Positive, t: Within, a: Turn| Ok(c.fillet_corners(radius.0, &a.and(t))?.0),
    );
    table.add(
        "curve/createfilletcurves-curve_point3d_curve_point3d_double_bool_bool_bool_double_double",
        fillet_curves,
    );
}

type Points = Some1<Point3>;
type Degree = Count<1, 11>;
type Between = Count<1, 10_000>;
type Samples = Count<2, 10_000>;

/// `CurveKnotStyle`: the spacing of parameters, and whether the curve is periodic.
#[derive(Clone, Copy)]
struct Knots(KnotSpacing, bool);

impl Knots {
    const CHORD: Self = Self(KnotSpacing::Chord, false);
}

impl Read for Knots {
    fn read(json: &Json) -> Result<Self, Fault> {
        choice(
            json,
            "knot style",
            &[
                ("Uniform", Self(KnotSpacing::Uniform, false)),
                ("Chord", Self::CHORD),
                ("ChordSquareRoot", Self(KnotSpacing::SquareRootChord, false)),
                ("UniformPeriodic", Self(KnotSpacing::Uniform, true)),
                ("ChordPeriodic", Self(KnotSpacing::Chord, true)),
                ("ChordSquareRootPeriodic", Self(KnotSpacing::SquareRootChord, true)),
            ],
        )
    }

    fn type_name() -> String {
        "CurveKnotStyle".into()
    }
}

/// The curve through points; a tangent of length 0 counts as none. Periodic ones close of themselves.
fn interpolated(
    points: &[Point3],
    Count(degree): Degree,
    Knots(spacing, periodic): Knots,
    start: Option<Vector3>,
    end: Option<Vector3>,
) -> Outcome<Curve> {
    if periodic {
        let mut ring = points.to_vec();
        if ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        return Ok(NurbsCurve::interpolate_periodic(degree, &ring, spacing)?.into());
    }
    let given = |tangent: Option<Vector3>| tangent.filter(|v| v.length() > 0.0);
    Ok(NurbsCurve::interpolate(degree, points, spacing, given(start), given(end))?.into())
}

/// Curves at equal shares of the way from one to another.
fn tweens(a: &Curve, b: &Curve, Count(count): Between, matching: TweenMatch) -> Outcome<Vec<Curve>> {
    let share = |k: usize| k as f64 / (count + 1) as f64;
    (1..=count).map(|k| Ok(a.tween(b, share(k), matching)?.into())).collect()
}

/// Two curves with an arc between them: joined, or cut back beside the arc, or as the arc alone. Of each curve that
/// side of their crossing stays on which its point lies.
#[expect(clippy::too_many_arguments, reason = "those of RhinoCommon")]
fn fillet_curves(
    first: Curve,
    near_first: Point3,
    second: Curve,
    near_second: Point3,
    radius: Positive,
    join: bool,
    trim: bool,
    _extend_by_arc: bool,
    distance: Within,
    angle: Turn,
) -> Outcome<Vec<Curve>> {
    let tolerance = angle.and(distance);
    let before = side_of_corner(&first, &second, near_first, distance)?;
    let after = side_of_corner(&second, &first, near_second, distance)?.reversed();
    let corner = before.fillet_with(&after, radius.0, &tolerance)?;
    let all = vec![corner.before, corner.piece.clone(), corner.after];
    Ok(match (join, trim) {
        (true, _) => join_curves(&all, distance.0, false),
        (false, true) => all,
        (false, false) => vec![corner.piece],
    })
}

/// The arc alone, on the side of a parameter of either curve; `None` where there is none of that radius.
fn fillet_arc(
    first: Curve,
    second: Curve,
    radius: Positive,
    on_first: f64,
    on_second: f64,
) -> Outcome<Option<Arc>> {
    let tolerance = Within(Tolerance::default().absolute);
    let before = side_of_corner(&first, &second, first.point_at(on_first), tolerance)?;
    let after = side_of_corner(&second, &first, second.point_at(on_second), tolerance)?.reversed();
    let corner = before.fillet_with(&after, radius.0, &tolerance.tolerance()).ok();
    Ok(corner.and_then(|corner| match corner.piece {
        Curve::Arc(piece) => Some(piece.arc),
        _ => None,
    }))
}

/// The part of a curve that ends where it meets another, on the side of a point.
fn side_of_corner(curve: &Curve, other: &Curve, near: Point3, tolerance: Within) -> Outcome<Curve> {
    let domain = curve.domain();
    let picked = curve.closest_point(near)?.parameter;
    let found = curve_curve(curve, other, tolerance.0)?;
    let corner =
        found.crossings.iter().map(|c| c.a).min_by(|a, b| (a - picked).abs().total_cmp(&(b - picked).abs()));
    let corner = corner.ok_or_else(|| Fault::bad_request("the curves do not meet"))?;
    let least = 1e-9 * domain.length();
    let towards_start = if corner <= domain.start + least {
        false
    } else if corner >= domain.end - least {
        true
    } else {
        picked < corner
    };
    Ok(if towards_start {
        curve.sub_curve(Interval::new(domain.start, corner.min(domain.end)))?
    } else {
        curve.sub_curve(Interval::new(corner.max(domain.start), domain.end))?.reversed()
    })
}
