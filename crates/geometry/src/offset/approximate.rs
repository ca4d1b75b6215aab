//! The offset of a smooth NURBS curve by certified cubics.

use katydid_elementary::Elementary;

use crate::offset::thresholds::{OFFSET_ROUNDING, SHORTEST_SPAN, STANDS_STILL};
use crate::polynomial::Polynomial;
use crate::thresholds;
use crate::{Error, NurbsCurve, Plane, Point3, Result};

/// A control point in the plane, homogeneous: (wx, wy, w).
type Flat = [f64; 3];

/// Halvings of one span at most; beyond it the piece is shorter than rounding allows to improve.
const DEPTH: u32 = 40;

/// Cubics of one offset at most, besides some for every span: a curve so wild at a tolerance so small is refused.
const MOST_CUBICS: usize = 3000;

/// One cubic piece of the offset over a part of the curve's domain.
struct Cubic {
    range: [f64; 2],
    points: [[f64; 2]; 4],
}

/// The right offset of a curve without kinks that lies parallel to the plane, as curves between the cusps where it
/// would turn inside out. Every point is within `tolerance` of the exact offset of the point at its parameter.
pub(super) fn offset_nurbs(
    curve: &NurbsCurve,
    plane: &Plane,
    distance: f64,
    tolerance: f64,
) -> Result<Vec<NurbsCurve>> {
    let breaks = curve.span_parameters();
    let mut runs: Vec<Vec<Cubic>> = vec![Vec::new()];
    let mut height = 0.0;
    let mut budget = MOST_CUBICS + 16 * breaks.len();
    for (points, w) in curve.beziers_between(&breaks)?.iter().zip(breaks.windows(2)) {
        let flat: Vec<Flat> = points
            .iter()
            .map(|p| {
                let place = crate::nurbs::project(*p);
                let [x, y, z] = plane.coordinates(place);
                height = z;
                [x * p[3], y * p[3], p[3]]
            })
            .collect();
        let whole = [w[0], w[1]];
        let mut before = 0.0;
        let mut ends = inversions(&flat, distance);
        ends.push(1.0);
        for end in ends {
            if end - before > SHORTEST_SPAN {
                let middle = 0.5 * (before + end);
                if speed_factor(&flat, middle, distance) > 0.0 {
                    let part = cut(&flat, before, end);
                    let at = |x: f64| whole[0] + (whole[1] - whole[0]) * x;
                    let out = runs.last_mut();
                    if let Some(out) = out {
                        approximate(part, [at(before), at(end)], distance, tolerance, (out, &mut budget))?;
                    }
                } else if runs.last().is_some_and(|r| !r.is_empty()) {
                    runs.push(Vec::new());
                }
            }
            before = end;
        }
    }
    let place = |p: [f64; 2]| plane.at(p[0], p[1], height);
    runs.iter().filter(|r| !r.is_empty()).map(|r| joined(r, place, tolerance)).collect()
}

/// The cubics of a run as one curve, thinned.
fn joined(run: &[Cubic], place: impl Fn([f64; 2]) -> Point3, tolerance: f64) -> Result<NurbsCurve> {
    let mut points: Vec<Point3> = Vec::with_capacity(3 * run.len() + 1);
    let mut knots: Vec<f64> = Vec::with_capacity(3 * run.len() + 3);
    for c in run {
        if points.is_empty() {
            points.push(place(c.points[0]));
            knots.extend([c.range[0]; 3]);
        }
        points.extend(c.points[1..].iter().map(|&p| place(p)));
        knots.extend([c.range[1]; 3]);
    }
    let whole = NurbsCurve::new(3, points, knots)?;
    Ok(whole.remove_knots(0.5 * tolerance)?.curve)
}

/// Where the offset has a cusp: 1 + dκ = 0, among the roots of d²(T × T′)²w⁴ − (T·T)³ with T = w²C′.
fn inversions(points: &[Flat], distance: f64) -> Vec<f64> {
    let (first, reach) = unit(points);
    let weight = points.iter().map(|p| p[2]).fold(0.0, f64::max);
    if !(reach > 0.0) {
        return Vec::new();
    }
    let scaled: Vec<Flat> = points
        .iter()
        .map(|p| {
            [
                (p[0] - first[0] * p[2]) / (reach * weight),
                (p[1] - first[1] * p[2]) / (reach * weight),
                p[2] / weight,
            ]
        })
        .collect();
    let (_, w, t) = hodograph(&scaled);
    let turn = turn(&t);
    let squared = t[0].times(&t[0]).plus(&t[1].times(&t[1]));
    let w2 = w.times(&w);
    let bend = turn.times(&turn).times(&w2.times(&w2)).scaled((distance / reach).powi(2));
    let cube = squared.times(&squared).times(&squared);
    bend.minus(&cube).roots(thresholds::POLYNOMIAL_ZERO * bend.size().max(cube.size()))
}

/// The first point and the largest extent from it.
fn unit(points: &[Flat]) -> ([f64; 2], f64) {
    let place = |p: &Flat| [p[0] / p[2], p[1] / p[2]];
    let first = points.first().map_or([0.0; 2], place);
    let reach = points
        .iter()
        .map(place)
        .fold(0.0_f64, |m, p| m.max((p[0] - first[0]).abs()).max((p[1] - first[1]).abs()));
    (first, reach)
}

/// Numerator, weight, and w² times the derivative.
fn hodograph(points: &[Flat]) -> ([Polynomial; 2], Polynomial, [Polynomial; 2]) {
    let row = |i: usize| Polynomial::new(points.iter().map(|p| p[i]).collect());
    let numerator = [row(0), row(1)];
    let first = points.first().map_or(1.0, |p| p[2]);
    if points.iter().all(|p| p[2] == first) {
        let t = [0, 1].map(|i| numerator[i].derivative().scaled(first));
        return (numerator, Polynomial::constant(first), t);
    }
    let w = row(2);
    let dw = w.derivative();
    let t = [0, 1].map(|i| numerator[i].derivative().times(&w).minus(&numerator[i].times(&dw)));
    (numerator, w, t)
}

fn turn(t: &[Polynomial; 2]) -> Polynomial {
    let (dx, dy) = (t[0].derivative(), t[1].derivative());
    t[0].times(&dy).minus(&t[1].times(&dx))
}

/// 1 + dκ inside a span: how much faster the offset runs than the curve; negative where it runs backwards.
fn speed_factor(points: &[Flat], x: f64, distance: f64) -> f64 {
    1.0 + distance * end_data(&cut(points, x, 1.0)).2
}

/// At the start of a Bézier curve: the point, the derivative, and the signed curvature.
fn end_data(points: &[Flat]) -> ([f64; 2], [f64; 2], f64) {
    let place = |p: &Flat| [p[0] / p[2], p[1] / p[2]];
    let degree = points.len().saturating_sub(1) as f64;
    let [Some(p0), Some(p1)] = [points.first(), points.get(1)] else { return ([0.0; 2], [0.0; 2], 0.0) };
    let (a, b) = (place(p0), place(p1));
    let leg = [b[0] - a[0], b[1] - a[1]];
    let speed = degree * p1[2] / p0[2];
    let derivative = [leg[0] * speed, leg[1] * speed];
    let curvature = points.get(2).map_or(0.0, |p2| {
        let c = place(p2);
        let area = leg[0] * (c[1] - b[1]) - leg[1] * (c[0] - b[0]);
        let length = leg[0].hypotenuse(leg[1]);
        (degree - 1.0) / degree * p0[2] * p2[2] / (p1[2] * p1[2]) * area / (length * length * length)
    });
    (a, derivative, if curvature.is_finite() { curvature } else { 0.0 })
}

/// The part of a Bézier curve between two parameters, by de Casteljau's algorithm.
fn cut(points: &[Flat], from: f64, to: f64) -> Vec<Flat> {
    let split = |points: &[Flat], x: f64| -> (Vec<Flat>, Vec<Flat>) {
        let mut row = points.to_vec();
        let n = row.len();
        let mut left = Vec::with_capacity(n);
        for level in 0..n {
            left.push(row[0]);
            for i in 0..n - 1 - level {
                row[i] = std::array::from_fn(|c| (1.0 - x) * row[i][c] + x * row[i + 1][c]);
            }
        }
        (left, row)
    };
    let right = if from > 0.0 { split(points, from).1 } else { points.to_vec() };
    if to >= 1.0 { right } else { split(&right, (to - from) / (1.0 - from)).0 }
}

/// Halves until every cubic is certified.
fn approximate(
    points: Vec<Flat>,
    range: [f64; 2],
    distance: f64,
    tolerance: f64,
    (out, budget): (&mut Vec<Cubic>, &mut usize),
) -> Result<()> {
    let mut stack = vec![(points, range, 0)];
    while let Some((points, range, depth)) = stack.pop() {
        let cubic = hermite(&points, distance);
        let fine = cubic.is_some_and(|c| certified(&points, &c, distance, 0.35 * tolerance));
        let middle = 0.5 * (range[0] + range[1]);
        let last = depth >= DEPTH || !(range[0] < middle && middle < range[1]);
        match cubic {
            Some(points) if fine || last => out.push(Cubic { range, points }),
            None if last => {}
            _ => {
                *budget = budget.checked_sub(1).ok_or_else(|| Error::Invalid {
                    what: "curve to offset",
                    why: format!("the tolerance {tolerance} needs more than {MOST_CUBICS} cubics"),
                })?;
                stack.push((cut(&points, 0.5, 1.0), [middle, range[1]], depth + 1));
                stack.push((cut(&points, 0.0, 0.5), [range[0], middle], depth + 1));
            }
        }
    }
    Ok(())
}

/// The cubic with the exact ends and end derivatives of the offset; `None` where the curve has no direction.
fn hermite(points: &[Flat], distance: f64) -> Option<[[f64; 2]; 4]> {
    let backwards: Vec<Flat> = points.iter().rev().copied().collect();
    let side = |points: &[Flat], sign: f64| -> Option<([f64; 2], [f64; 2])> {
        let (p, d, k) = end_data(points);
        // A curve that stands still at its end leaves it towards the next control point.
        let legs = points.iter().map(|q| [q[0] / q[2] - p[0], q[1] / q[2] - p[1]]);
        let reach = legs.clone().map(|v| v[0].hypotenuse(v[1])).fold(0.0, f64::max);
        let direction = legs.clone().find(|v| v[0].hypotenuse(v[1]) > STANDS_STILL * reach)?;
        let length = direction[0].hypotenuse(direction[1]);
        let unit = [direction[0] / length, direction[1] / length];
        // Walked backwards, right is left and curvature changes its sign: its product with the distance does not.
        let d_side = sign * distance;
        let factor = 1.0 + d_side * k;
        let place = [p[0] + d_side * unit[1], p[1] - d_side * unit[0]];
        let still = legs.clone().nth(1).is_some_and(|v| v[0].hypotenuse(v[1]) <= STANDS_STILL * reach);
        let speed =
            if still { [0, 1].map(|i| unit[i] * d_side * swing(points)) } else { d.map(|x| x * factor) };
        Some((place, speed.map(|x| x / 3.0)))
    };
    let (a, da) = side(points, 1.0)?;
    let (b, db) = side(&backwards, -1.0)?;
    let out = [a, [a[0] + da[0], a[1] + da[1]], [b[0] + db[0], b[1] + db[1]], b];
    out.iter().flatten().all(|x| x.is_finite()).then_some(out)
}

/// How fast the direction turns at the start of a Bézier curve that stands still there, its first two points in one
/// place: with C = P + At² + Bt³ + … the limit of κ|C′| is 3/2 A × B/A² (derived).
fn swing(points: &[Flat]) -> f64 {
    let [p0, _, p2, p3, ..] = points else { return 0.0 };
    let from = |p: &Flat| [p[0] / p[2] - p0[0] / p0[2], p[1] / p[2] - p0[1] / p0[2]];
    let n = (points.len() - 1) as f64;
    let (a, b) = (from(p2), from(p3));
    let (a_size, b_size) = (0.5 * n * (n - 1.0) * p2[2], n * (n - 1.0) * (n - 2.0) / 6.0 * p3[2]);
    let area = a[0] * b[1] - a[1] * b[0];
    let turning = 1.5 * b_size * area / (a_size * (a[0] * a[0] + a[1] * a[1]));
    if turning.is_finite() { turning } else { 0.0 }
}

/// Whether a cubic O is within `error` of the offset along the tangent and across it, at every parameter: with
/// V = w(O − C), T = w²C′ and R = T turned to the right, that is (V·T)² ≤ e²w²T·T and
/// (|d| − e)²w²T·T ≤ (V·R)² ≤ (|d| + e)²w²T·T with V·R on the right side.
fn certified(points: &[Flat], cubic: &[[f64; 2]; 4], distance: f64, error: f64) -> bool {
    let (n, w, t) = hodograph(points);
    let o = [0, 1].map(|i| Polynomial::new(cubic.iter().map(|p| p[i]).collect()));
    let v = [0, 1].map(|i| o[i].times(&w).minus(&n[i]));
    let along = v[0].times(&t[0]).plus(&v[1].times(&t[1]));
    let across = v[0].times(&t[1]).minus(&v[1].times(&t[0])).scaled(distance.signum());
    let bound = t[0].times(&t[0]).plus(&t[1].times(&t[1])).times(&w.times(&w));
    let (far, near) = (distance.abs() + error, distance.abs() - error);
    let rounding =
        thresholds::FEW_ROUNDINGS * distance.abs().max(error) * bound.size() * distance.abs().max(error)
            + OFFSET_ROUNDING * error * error * bound.size();
    let squared = across.times(&across);
    along.times(&along).minus(&bound.scaled(error * error)).stays_below(rounding, 3)
        && across.scaled(-1.0).stays_below(thresholds::ROUNDING * across.size(), 3)
        && squared.minus(&bound.scaled(far * far)).stays_below(rounding, 3)
        && (near <= 0.0 || bound.scaled(near * near).minus(&squared).stays_below(rounding, 3))
}
