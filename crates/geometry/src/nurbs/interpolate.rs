//! Curves through points.

use super::NurbsCurve;
use super::evaluate::basis;
use super::knots::{MAX_DEGREE, span_index};
use super::refine::make_knots_periodic;
use crate::linear::Banded;
use crate::{Error, Point3, Result, Vector3};

/// How far apart the parameters of neighbouring points are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum KnotSpacing {
    /// 1 each.
    Uniform,
    /// Their distance.
    #[default]
    Chord,
    /// The square root of their distance (E. Lee, *Choosing nodes in parametric curve interpolation*, CAD 21, 1989).
    SquareRootChord,
}

impl NurbsCurve {
    /// The curve of a degree through points, in order, with the spacing of their parameters.
    ///
    /// Degree 3 is the cubic that Rhino makes: knots at the points, n + 2 control points, and at each end, unless a
    /// tangent is given, the direction of the parabola through the first three points; the second control point
    /// lies a third of the first chord away. Other degrees have n control points and averaged knots (P&T, *The
    /// NURBS Book*, §9.2.1); there the tangents are not used. Points that repeat the one before are left out.
    ///
    /// # Errors
    /// Fewer than two different points, a degree outside 1…31, a point that is not finite, or, beside degree 3, no
    /// more points than the degree.
    pub fn interpolate(
        degree: usize,
        points: &[Point3],
        spacing: KnotSpacing,
        start_tangent: Option<Vector3>,
        end_tangent: Option<Vector3>,
    ) -> Result<Self> {
        let points = distinct(degree, points)?;
        let parameters = parameters(&points, spacing);
        match degree {
            1 => Self::new(1, points, parameters),
            3 => cubic(&points, &parameters, start_tangent, end_tangent),
            _ => averaged(degree, &points, &parameters),
        }
    }

    /// The periodic curve of an odd degree through points: smooth where it closes. A last point that repeats the
    /// first is left out.
    ///
    /// # Errors
    /// As [`NurbsCurve::interpolate`]; fewer than three points; an even degree.
    pub fn interpolate_periodic(degree: usize, points: &[Point3], spacing: KnotSpacing) -> Result<Self> {
        let mut points = distinct(degree, points)?;
        if points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        let n = points.len();
        if n < 3.max(degree) {
            return Err(Error::Invalid {
                what: "points to interpolate",
                why: format!(
                    "a closed curve of degree {degree} needs {} different ones, got {n}",
                    3.max(degree)
                ),
            });
        }
        if degree == 1 {
            points.extend(points.first().copied());
            let parameters = parameters(&points, spacing);
            return Self::new(1, points, parameters);
        }
        if degree.is_multiple_of(2) {
            return Err(Error::Unsupported("periodic interpolation of even degree"));
        }
        let mut closed = points.clone();
        closed.extend(points.first().copied());
        let inner = parameters(&closed, spacing);
        let outer = degree - 1;
        let mut knots = vec![0.0; inner.len() + 2 * outer];
        knots[outer..outer + inner.len()].copy_from_slice(&inner);
        make_knots_periodic(degree, &mut knots);
        // Unknown i is control point i + (degree − 1)/2, the one that acts most at point i, so that the matrix is
        // strong on its diagonal; folding 0, n−1, 1, n−2, … makes the cyclic band an ordinary one.
        let shift = outer / 2;
        let fold = |i: usize| if 2 * i < n { 2 * i } else { 2 * (n - 1 - i) + 1 };
        let mut system = Banded::new(n, (2 * shift + 3).min(n), points.iter().map(|_| [0.0; 3]).collect());
        let mut values = [0.0; MAX_DEGREE + 1];
        for (i, p) in points.iter().enumerate() {
            let t = inner[i];
            let j = span_index(&knots, degree, t, false);
            basis(degree, &knots, j, t, &mut values);
            for (k, &value) in values.iter().enumerate().take(degree) {
                system.add(fold(i), fold((j + k + n - shift) % n), value);
            }
            system.set_right(fold(i), (*p).into());
        }
        let solved =
            system.solve().ok_or(Error::degenerate("points", "the interpolation has no solution"))?;
        let controls = (0..n + degree).map(|i| solved[fold((i + n - shift) % n)].into()).collect();
        Self::new(degree, controls, knots)
    }
}

/// The points without immediate repetitions.
fn distinct(degree: usize, points: &[Point3]) -> Result<Vec<Point3>> {
    if degree == 0 || degree > MAX_DEGREE {
        return Err(Error::OutOfRange { what: "degree", value: degree as f64, must: "from 1 to 31" });
    }
    if !points.iter().all(|p| p.is_finite()) {
        return Err(Error::NotFinite("point to interpolate"));
    }
    let mut points = points.to_vec();
    points.dedup();
    if points.len() < 2 {
        return Err(Error::Invalid {
            what: "points to interpolate",
            why: format!("there must be at least 2 different ones, got {}", points.len()),
        });
    }
    Ok(points)
}

fn parameters(points: &[Point3], spacing: KnotSpacing) -> Vec<f64> {
    let mut t = 0.0;
    let mut out = vec![0.0];
    for w in points.windows(2) {
        let chord = w[0].distance_to(w[1]);
        let step = match spacing {
            KnotSpacing::Uniform => 1.0,
            KnotSpacing::Chord => chord,
            KnotSpacing::SquareRootChord => chord.sqrt(),
        };
        let next = t + step;
        // A chord too short to move the sum must still move the parameter.
        t = if next > t { next } else { t + t.abs().max(1.0) * 1e-12 };
        out.push(t);
    }
    out
}

/// The unit direction at `a` of the parabola through three points at parameters 0, h0, h0 + h1 (Bessel's rule).
fn parabola_direction(a: Point3, b: Point3, c: Point3, h0: f64, h1: f64) -> Option<Vector3> {
    let (v0, v1) = ((b - a) / h0, (c - b) / h1);
    (v0 - (v1 - v0) * (h0 / (h0 + h1))).unitized()
}

fn cubic(points: &[Point3], t: &[f64], start: Option<Vector3>, end: Option<Vector3>) -> Result<NurbsCurve> {
    let n = points.len();
    let direction = |given: Option<Vector3>, forward: bool| -> Option<Vector3> {
        let at = |i: usize| if forward { i } else { n - 1 - i };
        if let Some(unit) = given.and_then(Vector3::unitized) {
            return Some(if forward { unit } else { -unit });
        }
        let (a, b) = (points[at(0)], points[at(1)]);
        if n == 2 {
            return (b - a).unitized();
        }
        let (h0, h1) = ((t[at(1)] - t[at(0)]).abs(), (t[at(2)] - t[at(1)]).abs());
        parabola_direction(a, b, points[at(2)], h0, h1).or_else(|| (b - a).unitized())
    };
    let no_direction = Error::degenerate("points", "the curve has no direction at an end");
    let (first, last) = (points[0], points[n - 1]);
    let second = first
        + direction(start, true).ok_or_else(|| no_direction.clone())? * (points[1].distance_to(first) / 3.0);
    let before = last + direction(end, false).ok_or(no_direction)? * (points[n - 2].distance_to(last) / 3.0);
    let mut knots = vec![t[0]; 2];
    knots.extend_from_slice(t);
    knots.extend([t[n - 1]; 2]);
    let mut right: Vec<[f64; 3]> = Vec::with_capacity(n + 2);
    right.extend([<[f64; 3]>::from(first), second.into()]);
    right.extend(points[1..n - 1].iter().map(|&p| <[f64; 3]>::from(p)));
    right.extend([<[f64; 3]>::from(before), last.into()]);
    let mut system = Banded::new(n + 2, 1, right);
    for i in [0, 1, n, n + 1] {
        system.add(i, i, 1.0);
    }
    let mut values = [0.0; MAX_DEGREE + 1];
    for (i, &u) in t.iter().enumerate().take(n - 1).skip(1) {
        let j = span_index(&knots, 3, u, false);
        basis(3, &knots, j, u, &mut values);
        for (k, &value) in values.iter().enumerate().take(3) {
            system.add(i + 1, j + k, value);
        }
    }
    let solved = system.solve().ok_or(Error::degenerate("points", "the interpolation has no solution"))?;
    NurbsCurve::new(3, solved.into_iter().map(Point3::from).collect(), knots)
}

fn averaged(degree: usize, points: &[Point3], t: &[f64]) -> Result<NurbsCurve> {
    let n = points.len();
    if n <= degree {
        return Err(Error::Invalid {
            what: "points to interpolate",
            why: format!("degree {degree} needs at least {} different ones, got {n}", degree + 1),
        });
    }
    let mut knots = vec![t[0]; degree];
    knots.extend((1..n - degree).map(|i| t[i..i + degree].iter().sum::<f64>() / degree as f64));
    knots.extend(std::iter::repeat_n(t[n - 1], degree));
    let mut system = Banded::new(n, degree, points.iter().map(|&p| p.into()).collect());
    let mut values = [0.0; MAX_DEGREE + 1];
    for (i, &u) in t.iter().enumerate() {
        let j = span_index(&knots, degree, u, i == n - 1);
        basis(degree, &knots, j, u, &mut values);
        for (k, &value) in values.iter().enumerate().take(degree + 1) {
            if value != 0.0 {
                system.add(i, j + k, value);
            }
        }
    }
    let solved = system.solve().ok_or(Error::degenerate("points", "the interpolation has no solution"))?;
    NurbsCurve::new(degree, solved.into_iter().map(Point3::from).collect(), knots)
}
