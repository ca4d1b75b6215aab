//! Curves: lengths, and parameters and points by length.

use katydid_geometry::{ArcLength, Curve, Interval, Point3};

use super::answer::Outcome;
use super::argument::{Count, Positive, Within};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("curve/getlength-curve", |c: Curve| Ok(c.length()));
    table.add("curve/getlength-curve_double", |c: Curve, f: Fraction| Ok(c.length_within(f.0)));
    table.add("curve/getlength-curve_interval", |c: Curve, part: Interval| length_of_part(&c, part));
    table.add("curve/getlength-curve_double_interval", |c: Curve, _: Fraction, part: Interval| {
        length_of_part(&c, part)
    });
    table.add("curve/isshort-curve_double", |c: Curve, t: Within| Ok(c.length() <= t.0));
    table.add("curve/isshort-curve_double_interval", |c: Curve, t: Within, part: Interval| {
        Ok(length_of_part(&c, part)? <= t.0)
    });
    table.add("curve/lengthparameter-curve_double_double", |c: Curve, l: f64| by_length(&c, l, None));
    table.add("curve/lengthparameter-curve_double_double_double", |c: Curve, l: f64, _: Fraction| {
        by_length(&c, l, None)
    });
    table.add("curve/lengthparameter-curve_double_double_interval", |c: Curve, l: f64, part: Interval| {
        by_length(&c, l, Some(part))
    });
    table.add(
        "curve/lengthparameter-curve_double_double_double_interval",
        |c: Curve, l: f64, _: Fraction, part: Interval| by_length(&c, l, Some(part)),
    );
    table
        .add("curve/normalizedlengthparameter-curve_double_double", |c: Curve, s: f64| by_share(&c, s, None));
    table.add(
        "curve/normalizedlengthparameter-curve_double_double_double",
        |c: Curve, s: f64, _: Fraction| by_share(&c, s, None),
    );
    table.add(
        "curve/normalizedlengthparameter-curve_double_double_interval",
        |c: Curve, s: f64, part: Interval| by_share(&c, s, Some(part)),
    );
    table.add(
        "curve/normalizedlengthparameter-curve_double_double_double_interval",
        |c: Curve, s: f64, _: Fraction, part: Interval| by_share(&c, s, Some(part)),
    );
    table.add(
        "curve/normalizedlengthparameters-curve_doublearray_double",
        |c: Curve, s: Vec<f64>, _: Within| by_shares(&c, &s, None),
    );
    table.add(
        "curve/normalizedlengthparameters-curve_doublearray_double_double",
        |c: Curve, s: Vec<f64>, _: Within, _: Fraction| by_shares(&c, &s, None),
    );
    table.add(
        "curve/normalizedlengthparameters-curve_doublearray_double_interval",
        |c: Curve, s: Vec<f64>, _: Within, part: Interval| by_shares(&c, &s, Some(part)),
    );
    table.add(
        "curve/normalizedlengthparameters-curve_doublearray_double_double_interval",
        |c: Curve, s: Vec<f64>, _: Within, _: Fraction, part: Interval| by_shares(&c, &s, Some(part)),
    );
    table.add("curve/pointatlength-curve_double", |c: Curve, length: f64| {
        Ok(c.parameter_at_length(length).map(|t| c.point_at(t)))
    });
    table.add("curve/pointatnormalizedlength-curve_double", |c: Curve, share: f64| {
        Ok(c.parameter_at_normalized_length(share).map(|t| c.point_at(t)))
    });
    table.add("curve/dividebycount-curve_int_bool", |c: Curve, n: Parts, ends: bool| by_count(&c, n, ends));
    table.add("curve/dividebycount-curve_int_bool_point3darray", |c: Curve, n: Parts, ends: bool| {
        by_count(&c, n, ends).map(|ts| with_points(&c, ts))
    });
    table.add("curve/dividebylength-curve_double_bool", |c: Curve, l: Positive, ends: bool| {
        by_steps(&c, l, ends, false)
    });
    table.add(
        "curve/dividebylength-curve_double_bool_bool",
        |c: Curve, l: Positive, ends: bool, back: bool| by_steps(&c, l, ends, back),
    );
    table.add("curve/dividebylength-curve_double_bool_point3darray", |c: Curve, l: Positive, ends: bool| {
        by_steps(&c, l, ends, false).map(|ts| with_optional_points(&c, ts))
    });
    table.add(
        "curve/dividebylength-curve_double_bool_bool_point3darray",
        |c: Curve, l: Positive, ends: bool, back: bool| {
            by_steps(&c, l, ends, back).map(|ts| with_optional_points(&c, ts))
        },
    );
    table.add("curve/divideequidistant-curve_double", |c: Curve, distance: Positive| {
        let parameters = c.divide_by_distance(distance.0)?;
        Ok(parameters.into_iter().map(|t| c.point_at(t)).collect::<Vec<Point3>>())
    });
}

/// A fractional tolerance: above 0 and below 1; 0 is Rhino's default.
struct Fraction(f64);

impl crate::wire::Read for Fraction {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        let x = f64::read(json)?;
        if !(0.0..1.0).contains(&x) {
            return Err(Fault::bad_request(format!("is {x}, not a fraction from 0 to 1")));
        }
        Ok(Self(if x > 0.0 { x } else { 1e-8 }))
    }

    fn type_name() -> String {
        "Double".into()
    }
}

/// How many parts a curve is divided into.
type Parts = Count<1, 1_000_000>;

/// The part of a domain that a range means.
fn part_of(curve: &Curve, part: Interval) -> Outcome<Interval> {
    part.ordered()
        .intersection(curve.domain())
        .ok_or_else(|| Fault::bad_request("subdomain lies outside the domain of the curve"))
}

fn length_of_part(curve: &Curve, part: Interval) -> Outcome<f64> {
    Ok(curve.length_between(part_of(curve, part)?))
}

/// The parameter at a length from the start of a part, if it is as long as that.
fn by_length(curve: &Curve, length: f64, part: Option<Interval>) -> Outcome<(bool, f64)> {
    let measure = ArcLength::new(curve);
    let part = part.map_or(Ok(curve.domain()), |part| part_of(curve, part))?;
    let (from, to) = (measure.length_at(part.start), measure.length_at(part.end));
    // A length that is too long by rounding is the whole.
    let slack = 1e-9 * (to - from);
    if length < -slack || length > to - from + slack {
        return Ok((false, 0.0));
    }
    Ok((true, measure.parameter_at((from + length).clamp(from, to))))
}

fn by_share(curve: &Curve, share: f64, part: Option<Interval>) -> Outcome<(bool, f64)> {
    let whole = match part {
        Some(part) => length_of_part(curve, part)?,
        None => curve.length(),
    };
    by_length(curve, share * whole, part)
}

/// The parameters at shares of the length; `None` when one lies outside.
fn by_shares(curve: &Curve, shares: &[f64], part: Option<Interval>) -> Outcome<Option<Vec<f64>>> {
    let found: Outcome<Vec<(bool, f64)>> = shares.iter().map(|&share| by_share(curve, share, part)).collect();
    Ok(found?.into_iter().map(|(inside, t)| inside.then_some(t)).collect())
}

/// The parameters of points that divide a curve into parts of equal length.
fn by_count(curve: &Curve, Count(parts): Parts, ends: bool) -> Outcome<Vec<f64>> {
    let mut parameters = curve.divide_by_count(parts)?;
    if !ends {
        parameters.remove(0);
        if !curve.is_closed() {
            parameters.pop();
        }
    }
    Ok(parameters)
}

/// The parameters of points at steps along a curve, from the start or from the end; `None` when a step is longer than
/// the curve.
fn by_steps(curve: &Curve, Positive(step): Positive, ends: bool, back: bool) -> Outcome<Option<Vec<f64>>> {
    if step > curve.length() {
        return Ok(None);
    }
    let turned = if back { curve.reversed() } else { curve.clone() };
    let mut parameters = turned.divide_by_length(step)?;
    if !ends && !parameters.is_empty() {
        parameters.remove(0);
    }
    if back {
        let (own, other) = (curve.domain(), turned.domain());
        for t in &mut parameters {
            *t = own.at(1.0 - other.normalized(*t));
        }
    }
    Ok(Some(parameters))
}

fn with_points(curve: &Curve, parameters: Vec<f64>) -> (Vec<f64>, Vec<Point3>) {
    let points = parameters.iter().map(|&t| curve.point_at(t)).collect();
    (parameters, points)
}

fn with_optional_points(
    curve: &Curve,
    parameters: Option<Vec<f64>>,
) -> (Option<Vec<f64>>, Option<Vec<Point3>>) {
    parameters.map(|ts| with_points(curve, ts)).unzip()
}
