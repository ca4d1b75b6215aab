//! All the points of a curve that are nearer to a given one than their neighbours.

use katydid_elementary::Elementary;

use super::Curve;
use super::closest::CurvePoint;
use super::piece::{Piece, Shape};
use crate::bernstein::{BUDGET, binomial, halves, squared_distance};
use crate::curve::thresholds::SLOPE_NOISE;
use crate::thresholds;
use crate::{Error, Point3, Result};

/// What happens to the distance along a piece: minima strictly inside, and which way it goes at the ends.
pub(crate) struct Course {
    /// In the piece's own parameter.
    pub(crate) inside: Vec<f64>,
    /// −1 when the distance falls from the start on, 1 when it rises, 0 when it stays the same.
    pub(crate) start: f64,
    /// −1 when the distance falls towards the end, 1 when it rises, 0 when it stays the same.
    pub(crate) end: f64,
}

fn sign(x: f64, noise: f64) -> f64 {
    if x.abs() <= noise { 0.0 } else { x.signum() }
}

/// Segments: the foot of the perpendicular.
fn along_segment(a: Point3, b: Point3, q: Point3) -> Course {
    let d = b - a;
    let x = (q - a).dot(d) / d.length_squared();
    let noise = SLOPE_NOISE;
    let inside = if x > 0.0 && x < 1.0 { vec![x] } else { Vec::new() };
    if !x.is_finite() {
        return Course { inside: Vec::new(), start: 0.0, end: 0.0 };
    }
    // A foot at an end is a minimum there: the distance rises from it.
    Course {
        inside,
        start: if x <= noise { 1.0 } else { -1.0 },
        end: if x >= 1.0 - noise { -1.0 } else { 1.0 },
    }
}

/// Arcs: the angle of q, once for each turn that reaches it.
fn along_arc(arc: &crate::Arc, q: Point3) -> Course {
    let [x, y, _] = arc.circle.plane.coordinates(q);
    let tiny = thresholds::FEW_ROUNDINGS * arc.circle.radius;
    if x.abs() <= tiny && y.abs() <= tiny {
        return Course { inside: Vec::new(), start: 0.0, end: 0.0 };
    }
    let direction = y.arctangent_of(x);
    let (low, high) = (arc.angle.min(), arc.angle.max());
    let turn = std::f64::consts::TAU;
    let first = direction + ((low - direction) / turn).ceil() * turn;
    let inside = (first > low && first < high).then_some(first);
    let forward = if arc.angle.start <= arc.angle.end { 1.0 } else { -1.0 };
    // At an end that is nearest or farthest itself, as just inside.
    let slope = |angle: f64, inward: f64| {
        let (sine, cosine) = (angle - direction).sine_cosine();
        match forward * sign(sine, thresholds::FEW_ROUNDINGS) {
            0.0 if cosine > 0.0 => inward,
            0.0 => -inward,
            slope => slope,
        }
    };
    let (start, end) = (slope(arc.angle.start, 1.0), slope(arc.angle.end, -1.0));
    Course { inside: inside.into_iter().collect(), start, end }
}

/// Spans: the zeros of the derivative from negative to positive, isolated by sign changes of its Bernstein
/// coefficients (J. Lane & R. Riesenfeld, *Bounds on a polynomial*, BIT 21, 1981).
pub(crate) fn along_span(points: &[[f64; 4]], q: Point3, budget: &mut u32) -> Course {
    let f = squared_distance(points, q);
    let n = f.len().saturating_sub(1);
    let rational = f.iter().any(|c| c[1] != f[0][1]);
    // The numerator of the derivative: N′W − NW′, where W is not constant (the rational hodograph's formula).
    let slopes: Vec<[f64; 1]> = if rational {
        let degree = 2 * n - 2;
        (0..=degree)
            .map(|k| {
                let terms = (k + 1).saturating_sub(n)..=k / 2;
                let sum: f64 = terms
                    .map(|i| {
                        let j = k + 1 - i;
                        let s = (j - i) as f64 * binomial(n, i) * binomial(n, j);
                        s * (f[i][1] * f[j][0] - f[j][1] * f[i][0])
                    })
                    .sum();
                [sum / binomial(degree, k)]
            })
            .collect()
    } else {
        f.windows(2).map(|w| [n as f64 * (w[1][0] - w[0][0])]).collect()
    };
    let weight = if rational { f.iter().fold(0.0_f64, |m, c| m.max(c[1])) } else { 1.0 };
    let size = f.iter().fold(0.0_f64, |m, c| m.max(c[0].abs()));
    let noise = thresholds::FEW_ROUNDINGS * n as f64 * size * weight;
    let signs = |c: &[[f64; 1]]| {
        let (mut changes, mut before, mut first) = (0, 0.0, 0.0);
        for x in c {
            let s = sign(x[0], noise);
            if s != 0.0 {
                changes += u32::from(before != 0.0 && s != before);
                if first == 0.0 {
                    first = s;
                }
                before = s;
            }
        }
        (changes, first, before)
    };
    let (_, start, end) = signs(&slopes);
    let mut inside = Vec::new();
    let mut stack = vec![(slopes, 0.0, 1.0, 0_u32)];
    while let Some((c, a, b, depth)) = stack.pop() {
        *budget = budget.saturating_sub(1);
        let (changes, first, last) = signs(&c);
        if changes == 0 {
            continue;
        }
        let middle = 0.5 * (a + b);
        if changes == 1 || depth >= 40 || *budget == 0 {
            if first < 0.0 && last > 0.0 {
                inside.push(a + (b - a) * rising_zero(&c));
            }
            continue;
        }
        let (left, right) = halves(&c);
        // A zero where the range is halved shows in neither half.
        if left.last().is_some_and(|x| sign(x[0], noise) == 0.0)
            && signs(&left).2 < 0.0
            && signs(&right).1 > 0.0
        {
            inside.push(middle);
        }
        stack.push((right, middle, b, depth + 1));
        stack.push((left, a, middle, depth + 1));
    }
    Course { inside, start, end }
}

/// Where a polynomial that changes its sign once, upwards, is 0: by halving.
fn rising_zero(c: &[[f64; 1]]) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if crate::bernstein::value(c, middle)[0] < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Newton's method on (C − q)·C′ from a good start; a step is taken only while the distance does not grow.
fn polish(piece: &Piece<'_>, start: f64, q: Point3) -> f64 {
    let mut u = start;
    let mut squared = (piece.point(u) - q).length_squared();
    for _ in 0..8 {
        let [c, d1, d2] = piece.jet(u);
        let r = c - q.to_vector();
        let slope = d1.length_squared() + r.dot(d2);
        if !(slope > 0.0) {
            break;
        }
        let next = piece.own.clamp(u - r.dot(d1) / slope);
        let found = (piece.point(next) - q).length_squared();
        if next == u || found > squared {
            break;
        }
        (u, squared) = (next, found);
    }
    u
}

impl Curve {
    /// All points of the curve that are nearest to `q` among their neighbours on it, the nearest first: the feet of
    /// perpendiculars where the distance has a minimum, corners, and ends of an open curve. Where the distance stays
    /// the same over a whole piece (the centre of an arc), that piece's start stands for it.
    ///
    /// Finds all of them, by the sign changes of the derivative's Bernstein coefficients; minima shallower than
    /// 10⁻¹⁴ of the squared distance are lost in rounding. Equally near ones all appear.
    ///
    /// # Errors
    /// `q` is not finite, or so far away that the square of the distance overflows.
    pub fn local_closest_points(&self, q: Point3) -> Result<Vec<CurvePoint>> {
        if !q.is_finite() {
            return Err(Error::NotFinite("point to project on the curve"));
        }
        let pieces = self.pieces();
        if !pieces.iter().all(|p| (p.start() - q).length_squared().is_finite()) {
            return Err(Error::NotFinite("square of the distance to the curve"));
        }
        let mut budget = BUDGET;
        let mut out: Vec<CurvePoint> = Vec::new();
        let mut add = |piece: &Piece<'_>, own: f64| {
            let point = piece.point(own);
            let distance = point.distance_to(q);
            out.push(CurvePoint { parameter: piece.whole_parameter(own), point, distance });
        };
        let mut courses = Vec::with_capacity(pieces.len());
        for piece in &pieces {
            let course = match piece.shape {
                Shape::Segment(a, b) => along_segment(a, b, q),
                Shape::Arc(arc) => along_arc(arc, q),
                Shape::Span(curve, j) => {
                    let mut points = Vec::new();
                    curve.push_bezier(j, &mut points);
                    let mut course = along_span(&points, q, &mut budget);
                    for x in &mut course.inside {
                        *x = polish(piece, piece.own.at(*x), q);
                    }
                    course
                }
            };
            for &own in &course.inside {
                add(piece, own);
            }
            courses.push(course);
        }
        // Joints: a minimum where the distance does not rise towards it nor fall away from it.
        let closed = self.is_closed();
        let falls_before = |i: usize| courses.get(i).is_none_or(|c| c.end <= 0.0);
        for (i, (piece, course)) in pieces.iter().zip(&courses).enumerate() {
            let flat = course.start == 0.0 && course.end == 0.0;
            let before = match i.checked_sub(1) {
                Some(k) => falls_before(k),
                None => !closed || falls_before(pieces.len() - 1),
            };
            if course.start >= 0.0 && before && (course.start > 0.0 || flat) {
                add(piece, piece.own.start);
            }
        }
        if let (Some(piece), Some(course)) = (pieces.last(), courses.last())
            && !closed
            && course.end < 0.0
        {
            add(piece, piece.own.end);
        }
        // A minimum at a joint may also show just inside.
        out.sort_by(|a, b| a.parameter.total_cmp(&b.parameter));
        let near = thresholds::SAME_PARAMETER * self.domain().length();
        out.dedup_by(|b, a| {
            let same = b.parameter - a.parameter <= near;
            if same && b.distance < a.distance {
                *a = *b;
            }
            same
        });
        out.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        Ok(out)
    }
}
