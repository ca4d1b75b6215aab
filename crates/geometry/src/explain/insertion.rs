//! Knot insertion.

use super::combine::{between, controls, divided};
use super::spline::inside;
use super::{Algorithm, Explanation, Number, Quantity, Round, Step};
use crate::{Error, NurbsCurve, Result, span_index};

/// A knot put into a NURBS curve once more than it is there: `degree` control points at most are replaced by one more, and
/// the curve stays as it is. Control points are P0 and so on, the new ones Q0 and so on, knots U0 and so on as textbooks
/// count them.
///
/// # Errors
/// The parameter is outside the domain or an end of it, or a knot of full multiplicity already.
///
/// Source: Boehm 1980; Piegl and Tiller, *The NURBS Book*, 2nd edition, section 5.2.
pub fn knot_insertion(curve: &NurbsCurve, t: f64) -> Result<Explanation> {
    inside(curve, t)?;
    let (degree, domain) = (curve.degree(), curve.domain());
    if t == domain.start || t == domain.end {
        return Err(Error::OutOfRange {
            what: "the knot",
            value: t,
            must: "inside the domain, not at an end",
        });
    }
    let multiplicity = curve.knots().iter().filter(|knot| **knot == t).count();
    if multiplicity >= degree {
        return Err(Error::OutOfRange {
            what: "the knot",
            value: t,
            must: "not of full multiplicity already",
        });
    }
    let knots: Vec<Number> = curve.textbook_knots().into_iter().map(Number::given).collect();
    let at = Number::given(t);
    let points = controls(curve, |i| format!("P{i}"));
    let first = span_index(curve.knots(), degree, t, false);
    // New are the points from first + 1 to first + degree − multiplicity, counted from 0.
    let (low, high) = (first + 1, first + degree - multiplicity);
    let (mut shares, mut steps) = (Vec::new(), Vec::new());
    let mut all: Vec<Quantity> = Vec::with_capacity(points.len() + 1);
    for i in 0..=points.len() {
        let name = format!("Q{i}");
        if i < low || i > high {
            let kept = if i < low { points.get(i) } else { points.get(i - 1) };
            all.extend(kept.map(|point| Quantity::new(name, divided(&point.numbers))));
            continue;
        }
        let (from, to) = (knots[i], knots[i + degree]);
        let share = at.minus(from).over(to.minus(from));
        let rule = format!("(u − U{i}) / (U{} − U{i})", i + degree);
        let made = Quantity::new(format!("share of {name}"), vec![share]);
        shares.push(Step { made, rule, terms: Vec::new() });
        let (point, step) = between(name.clone(), &points[i - 1], &points[i], share);
        steps.push(step);
        all.push(Quantity::new(name, divided(&point.numbers)));
    }
    let mut given: Vec<Quantity> = points.iter().map(|point| point.quantity()).collect();
    given.push(Quantity::new("U", knots.clone()));
    given.push(Quantity::new("u", vec![at]));
    let place = knots.iter().position(|knot| knot.value > t).unwrap_or(knots.len());
    let mut more = knots;
    more.insert(place, at);
    all.push(Quantity::new("U", more));
    let rounds = vec![Round { steps: shares }, Round { steps }];
    Ok(Explanation { algorithm: Algorithm::KnotInsertion, given, rounds, result: all })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Point3;

    #[test]
    fn the_curve_stays_as_it_is() {
        let points: Vec<Point3> =
            (0..7).map(|i| Point3::new(f64::from(i), f64::from(i * i % 5), f64::from(i % 3))).collect();
        let knots = vec![0.0, 0.0, 0.0, 0.25, 0.5, 0.5, 1.0, 1.0, 1.0];
        let curve = NurbsCurve::new(3, points, knots).unwrap();
        for u in [0.1, 0.25, 0.4, 0.5, 0.9] {
            let told = knot_insertion(&curve, u).unwrap();
            let (knots, points) = told.result.split_last().unwrap();
            let points: Vec<Point3> = points
                .iter()
                .map(|q| Point3::new(q.numbers[0].value, q.numbers[1].value, q.numbers[2].value))
                .collect();
            let all: Vec<f64> = knots.numbers.iter().map(|n| n.value).collect();
            let more = NurbsCurve::new(3, points, all[1..all.len() - 1].to_vec()).unwrap();
            for k in 0..=50 {
                let t = f64::from(k) / 50.0;
                assert!((more.point_at(t) - curve.point_at(t)).length() < 1e-12, "{u} {t}");
            }
        }
        assert!(knot_insertion(&curve, 0.0).is_err());
        assert!(knot_insertion(&curve, 2.0).is_err());
    }
}
