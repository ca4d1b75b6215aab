//! B-splines.

use super::entity::Record;
use super::place::Space;
use crate::Result;
use katydid_geometry::{Curve, MAX_DEGREE, NurbsCurve, NurbsSurface, Point3};

/// Keywords of b-splines, and how their knots are told.
const CURVES: [&str; 4] =
    ["B_SPLINE_CURVE_WITH_KNOTS", "QUASI_UNIFORM_CURVE", "UNIFORM_CURVE", "BEZIER_CURVE"];
const SURFACES: [&str; 4] =
    ["B_SPLINE_SURFACE_WITH_KNOTS", "QUASI_UNIFORM_SURFACE", "UNIFORM_SURFACE", "BEZIER_SURFACE"];

pub(super) fn is_curve(keyword: &str) -> bool {
    CURVES.contains(&keyword)
}

pub(super) fn is_surface(keyword: &str) -> bool {
    SURFACES.contains(&keyword)
}

/// The records of a b-spline: its net, its knots and its kind.
struct Records<'a> {
    net: Record<'a>,
    /// Where the attributes of the net begin.
    at: usize,
    kind: Record<'a>,
    /// Where the multiplicities are, for the kind with knots.
    knots_at: usize,
    weights: Option<Record<'a>>,
}

fn records<'a>(
    space: &Space<'a>,
    id: u64,
    kinds: [&str; 4],
    names: [&str; 2],
    own: usize,
) -> Result<Records<'a>> {
    let first = space.file.record(id)?;
    let kind = kinds.iter().find_map(|kind| space.file.part(id, kind));
    if !space.file.is_complex(id) {
        let kind = kind.ok_or_else(|| first.refuse("it is not supported"))?;
        return Ok(Records { net: first, at: 1, kind, knots_at: 1 + own, weights: None });
    }
    let net = space.file.part(id, names[0]).ok_or_else(|| first.refuse("it is not supported"))?;
    // Without a kind the knots are those of one Bézier piece.
    let kind = kind.unwrap_or(net);
    Ok(Records { net, at: 0, kind, knots_at: 0, weights: space.file.part(id, names[1]) })
}

/// Knots in the textbook form, the superfluous first and last dropped.
fn knots(
    kind: &Record<'_>,
    counts: &[usize],
    values: &[f64],
    degree: usize,
    points: usize,
) -> Result<Vec<f64>> {
    let total = counts.iter().fold(0_usize, |sum, n| sum.saturating_add(*n));
    if total != points + degree + 1 || counts.len() != values.len() {
        return Err(kind.refuse(format!("{points} points of degree {degree} do not have {total} knots")));
    }
    let all: Vec<f64> = counts.iter().zip(values).flat_map(|(n, t)| std::iter::repeat_n(*t, *n)).collect();
    Ok(all.get(1..all.len().saturating_sub(1)).unwrap_or(&[]).to_vec())
}

/// Knots that follow from the kind.
fn usual_knots(kind: &Record<'_>, degree: usize, points: usize) -> Result<Vec<f64>> {
    let spans = points.saturating_sub(degree);
    if kind.keyword.starts_with("UNIFORM") {
        return Ok((0..points + degree - 1).map(|k| k as f64).collect());
    }
    if kind.keyword.starts_with("QUASI") {
        let inner = (1..spans).map(|k| k as f64);
        let ends = |t: f64| std::iter::repeat_n(t, degree);
        return Ok(ends(0.0).chain(inner).chain(ends(spans as f64)).collect());
    }
    if !(points - 1).is_multiple_of(degree) {
        return Err(kind.refuse(format!("{points} points make no Bézier pieces of degree {degree}")));
    }
    Ok((0..=(points - 1) / degree).flat_map(|k| std::iter::repeat_n(k as f64, degree)).collect())
}

fn checked(record: &Record<'_>, degree: usize, points: usize) -> Result<()> {
    if degree == 0 || degree > MAX_DEGREE {
        return Err(record.refuse(format!("degree {degree} is not from 1 to {MAX_DEGREE}")));
    }
    if points <= degree {
        return Err(record.refuse(format!("{points} points are too few for degree {degree}")));
    }
    Ok(())
}

pub(super) fn curve(space: &Space<'_>, id: u64) -> Result<Curve> {
    let r = records(space, id, CURVES, ["B_SPLINE_CURVE", "RATIONAL_B_SPLINE_CURVE"], 5)?;
    let degree = r.net.count(r.at)?;
    let points: Vec<Point3> =
        r.net.references(r.at + 1)?.into_iter().map(|p| space.point(p)).collect::<Result<_>>()?;
    checked(&r.net, degree, points.len())?;
    let knots = if r.kind.keyword == CURVES[0] {
        knots(&r.kind, &r.kind.counts(r.knots_at)?, &r.kind.reals(r.knots_at + 1)?, degree, points.len())?
    } else {
        usual_knots(&r.kind, degree, points.len())?
    };
    let curve = match r.weights {
        Some(weights) => NurbsCurve::with_weights(degree, &points, &weights.reals(0)?, knots),
        None => NurbsCurve::new(degree, points, knots),
    };
    let curve = curve.and_then(|curve| curve.clamped()).map_err(|error| r.net.refuse(error))?;
    Ok(curve.into())
}

pub(super) fn surface(space: &Space<'_>, id: u64) -> Result<NurbsSurface> {
    let r = records(space, id, SURFACES, ["B_SPLINE_SURFACE", "RATIONAL_B_SPLINE_SURFACE"], 7)?;
    let degrees = [r.net.count(r.at)?, r.net.count(r.at + 1)?];
    let rows = r.net.reference_grid(r.at + 2)?;
    let counts = [rows.len(), rows.first().map_or(0, Vec::len)];
    if rows.iter().any(|row| row.len() != counts[1]) {
        return Err(r.net.refuse("its rows of points have different lengths"));
    }
    for d in 0..2 {
        checked(&r.net, degrees[d], counts[d])?;
    }
    let points: Vec<Point3> = rows.iter().flatten().map(|p| space.point(*p)).collect::<Result<_>>()?;
    let knots = |d: usize| {
        if r.kind.keyword == SURFACES[0] {
            let at = r.knots_at + d;
            self::knots(&r.kind, &r.kind.counts(at)?, &r.kind.reals(at + 2)?, degrees[d], counts[d])
        } else {
            usual_knots(&r.kind, degrees[d], counts[d])
        }
    };
    let knots = [knots(0)?, knots(1)?];
    let surface = match r.weights {
        Some(weights) => {
            let weights: Vec<f64> = weights.real_grid(0)?.concat();
            NurbsSurface::with_weights(degrees, counts, &points, &weights, knots)
        }
        None => NurbsSurface::new(degrees, counts, points, knots),
    };
    let clamped = surface
        .and_then(|s| s.clamped(katydid_geometry::Direction::U)?.clamped(katydid_geometry::Direction::V));
    clamped.map_err(|error| r.net.refuse(error))
}
