//! Curves through points.

use super::NurbsCurve;
use super::evaluate::basis;
use super::knots::{MAX_DEGREE, span_index};
use super::refine::make_knots_periodic;
use crate::linear::Banded;
use crate::nurbs::thresholds::KNOT_STEP;
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
    /// lies a third of the first chord away. Other degrees have as many control points as points and tangents,
    /// and averaged knots (P&T, *The NURBS Book*, §9.2.1 and 9.2.2); the speed along a given tangent is that of the
    /// chord beside it. Degree 1 has no use for tangents. Points that repeat the one before are left out.
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
            _ => averaged(degree, &points, &parameters, start_tangent, end_tangent),
        }
    }

    /// The periodic curve through points: smooth where it closes. A last point that repeats the first is left out.
    /// With an odd degree the knots lie at the points and the curve starts at the first; with an even degree they lie
    /// halfway between them, and it starts between the last and the first.
    ///
    /// # Errors
    /// As [`NurbsCurve::interpolate`]; fewer points than three or than the degree.
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
        let mut closed = points.clone();
        closed.extend(points.first().copied());
        let places = parameters(&closed, spacing);
        // Odd degrees have their knots at the points, even ones halfway between them: otherwise the system of evenly
        // spaced points would have no solution.
        let even = degree.is_multiple_of(2);
        let mut inner = places.clone();
        if even {
            let before = 0.5 * (places[n] - places[n - 1]);
            inner[0] = places[0] - before;
            (1..n).for_each(|i| inner[i] = 0.5 * (places[i - 1] + places[i]));
            inner[n] = places[n] - before;
        }
        let outer = degree - 1;
        let mut knots = vec![0.0; inner.len() + 2 * outer];
        knots[outer..outer + inner.len()].copy_from_slice(&inner);
        make_knots_periodic(degree, &mut knots);
        // Unknown i is the control point that acts most at point i, so that the matrix is strong on its diagonal;
        // folding 0, n−1, 1, n−2, … makes the cyclic band an ordinary one.
        let shift = degree / 2;
        let fold = |i: usize| if 2 * i < n { 2 * i } else { 2 * (n - 1 - i) + 1 };
        let mut system = Banded::new(n, (2 * shift + 3).min(n), points.iter().map(|_| [0.0; 3]).collect())?;
        let mut values = [0.0; MAX_DEGREE + 1];
        for (i, p) in points.iter().enumerate() {
            let t = places[i];
            let j = span_index(&knots, degree, t, false);
            basis(degree, &knots, j, t, &mut values);
            for (k, &value) in values.iter().enumerate().take(if even { degree + 1 } else { degree }) {
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
        t = if next > t { next } else { t + t.abs().max(1.0) * KNOT_STEP };
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
    let mut system = Banded::new(n + 2, 1, right)?;
    for i in [0, 1, n, n + 1] {
        system.add(i, i, 1.0);
    }
    let mut values = [0.0; MAX_DEGREE + 1];
    for (i, &u) in t.iter().enumerate().take(n - 1).skip(1) {
        // Point i is the knot at which span i begins.
        basis(3, &knots, i, u, &mut values);
        for (k, &value) in values.iter().enumerate().take(3) {
            system.add(i + 1, i + k, value);
        }
    }
    let solved = system
        .solve_totally_positive()
        .ok_or(Error::degenerate("points", "the interpolation has no solution"))?;
    NurbsCurve::new(3, solved.into_iter().map(Point3::from).collect(), knots)
}

fn averaged(
    degree: usize,
    points: &[Point3],
    t: &[f64],
    start: Option<Vector3>,
    end: Option<Vector3>,
) -> Result<NurbsCurve> {
    let (start, end) = (start.and_then(Vector3::unitized), end.and_then(Vector3::unitized));
    let n = points.len();
    let count = n + usize::from(start.is_some()) + usize::from(end.is_some());
    if count <= degree {
        return Err(Error::Invalid {
            what: "points to interpolate",
            why: format!(
                "degree {degree} needs at least {} different ones with the tangents, got {count}",
                degree + 1
            ),
        });
    }
    // A tangent counts as a second condition at its end (P&T, eq. 9.9).
    let mut places = Vec::with_capacity(count);
    places.extend(start.map(|_| t[0]));
    places.extend_from_slice(t);
    places.extend(end.map(|_| t[n - 1]));
    let mut knots = vec![t[0]; degree];
    knots.extend((1..count - degree).map(|i| places[i..i + degree].iter().sum::<f64>() / degree as f64));
    knots.extend(std::iter::repeat_n(t[n - 1], degree));
    let mut system = Banded::new(count, degree, vec![[0.0; 3]; count])?;
    let mut values = [0.0; MAX_DEGREE + 1];
    let first = usize::from(start.is_some());
    for (i, (&u, &p)) in t.iter().zip(points).enumerate() {
        let row = match i {
            0 => 0,
            _ if i == n - 1 => count - 1,
            _ => i + first,
        };
        let j = span_index(&knots, degree, u, i == n - 1);
        basis(degree, &knots, j, u, &mut values);
        for (k, &value) in values.iter().enumerate().take(degree + 1) {
            if value != 0.0 {
                system.add(row, j + k, value);
            }
        }
        system.set_right(row, p.into());
    }
    // The control point beside an end is the end's neighbour along the tangent.
    let reach = |width: f64, i: usize, k: usize| {
        points[i].distance_to(points[k]) / (t[i] - t[k]).abs() * width / degree as f64
    };
    if let Some(unit) = start {
        let second = points[0] + unit * reach(knots[degree] - knots[0], 0, 1);
        system.add(1, 1, 1.0);
        system.set_right(1, second.into());
    }
    if let Some(unit) = end {
        let m = knots.len();
        let before = points[n - 1] - unit * reach(knots[m - 1] - knots[m - 1 - degree], n - 1, n - 2);
        system.add(count - 2, count - 2, 1.0);
        system.set_right(count - 2, before.into());
    }
    let solved = system
        .solve_totally_positive()
        .ok_or(Error::degenerate("points", "the interpolation has no solution"))?;
    NurbsCurve::new(degree, solved.into_iter().map(Point3::from).collect(), knots)
}
