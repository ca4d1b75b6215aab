//! De Casteljau's and de Boor's algorithm.

use super::combine::{between, controls, divided};
use super::{Algorithm, Explanation, Number, Quantity, Round, Step};
use crate::{Error, NurbsCurve, Result, span_index};

/// De Casteljau's algorithm on a curve of one span, at a parameter of its domain: round after round, each two neighbours
/// become the point that divides their line as the parameter divides the domain. Rational curves go through it in
/// homogeneous form (x w, y w, z w, w).
///
/// The points of a cubic have the names A to D, M to O, P and Q, and R; others have numbers.
///
/// # Errors
/// The curve has knots inside or is not clamped, or the parameter is outside the domain.
///
/// Source: Farin, *Curves and Surfaces for CAGD*, 5th edition, section 4.2.
pub fn de_casteljau(curve: &NurbsCurve, t: f64) -> Result<Explanation> {
    let (degree, domain) = (curve.degree(), curve.domain());
    inside(curve, t)?;
    let ends = |k: f64| k == domain.start || k == domain.end;
    if curve.point_count() != degree + 1 || !curve.knots().iter().all(|k| ends(*k)) {
        let why = "it has knots inside, or is not clamped: it is no Bézier curve".to_owned();
        return Err(Error::Invalid { what: "curve", why });
    }
    let name = |round: usize, i: usize| match (degree, round) {
        (3, 0) => letter(b"ABCD", i),
        (3, 1) => letter(b"MNO", i),
        (3, 2) => letter(b"PQ", i),
        (3, 3) => "R".to_owned(),
        (_, 0) => format!("P{i}"),
        _ => format!("P{i},{round}"),
    };
    let [start, end, at] = [domain.start, domain.end, t].map(Number::given);
    let share = at.minus(start).over(end.minus(start));
    let mut points = controls(curve, |i| name(0, i));
    let mut given: Vec<Quantity> = points.iter().map(|point| point.quantity()).collect();
    given.push(Quantity::new("t", vec![share]));
    let mut rounds = Vec::with_capacity(degree);
    for round in 1..=degree {
        let pairs = points.windows(2).enumerate();
        let made = pairs.map(|(i, pair)| between(name(round, i), &pair[0], &pair[1], share));
        let (next, steps) = made.unzip();
        points = next;
        rounds.push(Round { steps });
    }
    let numbers = points.first().map_or_else(Vec::new, |point| divided(&point.numbers));
    let result = vec![Quantity::new("C(t)", numbers)];
    Ok(Explanation { algorithm: Algorithm::DeCasteljau, given, rounds, result })
}

/// De Boor's algorithm on a NURBS curve at a parameter of its domain. Control points are P0, P1 and so on, knots U0, U1 and
/// so on as textbooks count them, with one more at each end than openNURBS keeps (no step needs those two). Each round has
/// the shares, then the points.
///
/// # Errors
/// The parameter is outside the domain.
///
/// Source: Piegl and Tiller, *The NURBS Book*, 2nd edition, section 5.2 and equation 5.15 with full multiplicity.
pub fn de_boor(curve: &NurbsCurve, t: f64) -> Result<Explanation> {
    inside(curve, t)?;
    let degree = curve.degree();
    let knots: Vec<Number> = curve.textbook_knots().into_iter().map(Number::given).collect();
    let from_below = t >= curve.domain().end;
    let first = span_index(curve.knots(), degree, t, from_below);
    let at = Number::given(t);
    let mut points = controls(curve, |i| format!("P{i}"));
    points = points.into_iter().skip(first).take(degree + 1).collect();
    let mut given: Vec<Quantity> = points.iter().map(|point| point.quantity()).collect();
    given.push(Quantity::new("U", knots.clone()));
    given.push(Quantity::new("u", vec![at]));
    let mut letters = names();
    let mut rounds = Vec::with_capacity(degree);
    for round in 1..=degree {
        let (mut shares, mut steps, mut next) = (Vec::new(), Vec::new(), Vec::new());
        for (i, pair) in points.windows(2).enumerate() {
            // The new point belongs to control point `first + round + i`, counted from 0.
            let (low, high) = (first + round + i, first + i + degree + 1);
            let (from, to) = (knots[low], knots[high]);
            let share = at.minus(from).over(to.minus(from));
            let name = letters.next().unwrap_or_default();
            let rule = format!("(u − U{low}) / (U{high} − U{low})");
            let made = Quantity::new(format!("share of {name}"), vec![share]);
            shares.push(Step { made, rule, terms: Vec::new() });
            let (point, step) = between(name, &pair[0], &pair[1], share);
            steps.push(step);
            next.push(point);
        }
        points = next;
        rounds.push(Round { steps: shares.into_iter().chain(steps).collect() });
    }
    let numbers = points.first().map_or_else(Vec::new, |point| divided(&point.numbers));
    let result = vec![Quantity::new("C(u)", numbers)];
    Ok(Explanation { algorithm: Algorithm::DeBoor, given, rounds, result })
}

/// Refuses what is no parameter of the curve.
pub(super) fn inside(curve: &NurbsCurve, t: f64) -> Result<()> {
    let domain = curve.domain();
    if !t.is_finite() {
        return Err(Error::NotFinite("the parameter"));
    }
    if !(domain.start <= t && t <= domain.end) {
        return Err(Error::OutOfRange { what: "the parameter", value: t, must: "inside the domain" });
    }
    Ok(())
}

fn letter(letters: &[u8], i: usize) -> String {
    letters.get(i).map(|letter| char::from(*letter).to_string()).unwrap_or_default()
}

/// A, B and so on to Z without P, which is a control point, then A1, B1 and so on.
pub(super) fn names() -> impl Iterator<Item = String> {
    (0..).flat_map(|turn: usize| {
        let letters = ('A'..='Z').filter(|c| *c != 'P' && *c != 'U');
        letters.map(move |c| if turn == 0 { c.to_string() } else { format!("{c}{turn}") })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Point3;

    fn row_c10() -> NurbsCurve {
        let points = [[0, 0], [0, 15], [15, 30], [30, 15], [45, 0], [60, 15], [75, 30]];
        let points = points.map(|[x, y]| Point3::new(f64::from(x), f64::from(y), 0.0)).to_vec();
        NurbsCurve::new(3, points, vec![0.0, 0.0, 0.0, 0.25, 0.5, 0.75, 1.0, 1.0, 1.0]).unwrap()
    }

    /// The numbers of the book's worked example, exactly.
    #[test]
    fn de_boor_as_the_book_has_it() {
        let told = de_boor(&row_c10(), 0.4).unwrap();
        let shares: Vec<String> = told
            .rounds
            .iter()
            .flat_map(|round| &round.steps)
            .filter(|step| step.terms.is_empty())
            .map(|step| step.made.to_string())
            .collect();
        let expected = ["A = 4/5", "B = 8/15", "C = 1/5", "D = 4/5", "E = 3/10", "F = 3/5"];
        assert_eq!(shares, expected.map(|text| format!("share of {text}")));
        let steps: Vec<String> = told
            .rounds
            .iter()
            .flat_map(|r| &r.steps)
            .filter(|s| !s.terms.is_empty())
            .map(|s| {
                let terms: Vec<String> = s.terms.iter().map(|(f, n)| format!("{f}{n}")).collect();
                format!("{}={}", s.made.name, terms.join("+"))
            })
            .collect();
        let expected = [
            "A=1/5P1+4/5P2",
            "B=7/15P2+8/15P3",
            "C=4/5P3+1/5P4",
            "D=1/5A+4/5B",
            "E=7/10B+3/10C",
            "F=2/5D+3/5E",
        ];
        assert_eq!(steps, expected);
    }

    #[test]
    fn points_are_those_of_the_curve() {
        let curve = row_c10();
        for k in 0..=100 {
            let t = f64::from(k) / 100.0;
            let told = de_boor(&curve, t).unwrap();
            let p = curve.point_at(t);
            for (told, is) in told.result[0].numbers.iter().zip([p.x, p.y, p.z]) {
                assert!((told.value - is).abs() <= 1e-12 * 75.0, "{t}: {told} {is}");
            }
        }
        assert!(de_boor(&curve, 1.5).is_err());
        assert!(de_boor(&curve, f64::NAN).is_err());
        assert!(de_casteljau(&curve, 0.5).is_err());
    }

    #[test]
    fn rational_curves_are_divided_at_the_end() {
        // A quarter of the unit circle: the middle of its parameters is at 45 degrees.
        let w = 0.5_f64.sqrt();
        let points = [Point3::new(1.0, 0.0, 0.0), Point3::new(1.0, 1.0, 0.0), Point3::new(0.0, 1.0, 0.0)];
        let curve = NurbsCurve::with_weights(2, &points, &[1.0, w, 1.0], vec![0.0, 0.0, 1.0, 1.0]).unwrap();
        let told = de_casteljau(&curve, 0.5).unwrap();
        assert!((told.result[0].numbers[0].value - w).abs() < 1e-15);
        assert!((told.result[0].numbers[1].value - w).abs() < 1e-15);
        // Weights that are all 1 say nothing: points are told as they are.
        let plain = NurbsCurve::with_weights(2, &points, &[1.0; 3], vec![0.0, 0.0, 1.0, 1.0]).unwrap();
        let told = de_casteljau(&plain, 0.5).unwrap();
        let points: Vec<_> =
            told.rounds.iter().flat_map(|round| &round.steps).map(|step| &step.made).collect();
        assert!(!points.is_empty() && points.iter().all(|made| made.numbers.len() == 3), "{points:?}");
    }
}
