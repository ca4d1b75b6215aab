//! Whether a curve in a parameter plane runs along a line of constant parameter.

use super::Iso;
use crate::{BoundingBox, Curve, Direction, Interval, Line, Point3, Side, Surface};

/// 2⁻³²: what openNURBS takes for zero among coordinates.
const ZERO: f64 = 2.328_306_436_538_696_3e-10;
/// The square root of the machine epsilon.
const SQRT_EPSILON: f64 = 1.490_116_119_385e-8;
/// What may stick out beyond the ends of a segment, as a fraction of its length.
const OVERHANG: f64 = 0.01;

/// How the part of a curve over `range` runs in the parameter plane of a surface.
///
/// It runs along a line of constant parameter when it is straight and no wider across than a few 10⁻⁸ of the domain;
/// this is the test of openNURBS, on which the flags in files rest.
pub fn iso_of(surface: &Surface, curve: &Curve, range: Interval) -> Iso {
    let domain = curve.domain();
    let [start, end] = [domain.normalized(range.min()), domain.normalized(range.max())];
    let inner = |x: f64| x > SQRT_EPSILON && x < 1.0 - SQRT_EPSILON;
    if start < end - SQRT_EPSILON
        && (inner(start) || inner(end))
        && let Some(range) = domain.intersection(range).filter(|r| r.is_increasing())
        && let Ok(part) = curve.trimmed(range).and_then(|part| part.to_nurbs())
    {
        return whole(surface, &part.into());
    }
    whole(surface, curve)
}

fn whole(surface: &Surface, curve: &Curve) -> Iso {
    let Some(bounds) = hull(curve) else { return Iso::None };
    let iso = of_box(surface, &bounds);
    let size = bounds.diagonal();
    let (across, along) = match iso {
        Iso::None => return Iso::None,
        Iso::InnerU | Iso::Side(Side::West | Side::East) => (size.x, size.y),
        Iso::InnerV | Iso::Side(Side::South | Side::North) => (size.y, size.x),
    };
    let tolerance = if across < ZERO && along >= 1024.0 * ZERO { ZERO } else { across };
    if is_straight(curve, tolerance) { iso } else { Iso::None }
}

/// The box around control points; around an arc itself.
pub(super) fn hull(curve: &Curve) -> Option<BoundingBox> {
    match curve {
        Curve::Arc(_) => Some(curve.bounding_box()),
        Curve::Line(c) => BoundingBox::from_points([c.line.from, c.line.to]),
        Curve::Poly(poly) => poly.segments().iter().map(hull).reduce(|a, b| Some(a?.union(&b?))).flatten(),
        _ => BoundingBox::from_points(controls(curve)?),
    }
}

fn of_box(surface: &Surface, bounds: &BoundingBox) -> Iso {
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d).ordered());
    let size = bounds.diagonal();
    let slack = [u.length() / 32.0, v.length() / 32.0];
    if size.z != 0.0 || !(size.x <= slack[0] || size.y <= slack[1]) {
        return Iso::None;
    }
    let steep = size.x * v.length() <= size.y * u.length();
    let (direction, range, slack, sides) = if steep {
        let range = Interval::new(bounds.min.x, bounds.max.x);
        (Direction::U, range, slack[0], [Side::West, Side::East])
    } else {
        let range = Interval::new(bounds.min.y, bounds.max.y);
        (Direction::V, range, slack[1], [Side::South, Side::North])
    };
    let domain = if steep { u } else { v };
    let near = |t: f64| {
        let around = around(surface, direction, t);
        // openNURBS itself is strict in one direction only.
        let above = if steep { around.start <= range.start } else { around.start < range.start };
        above && range.end <= around.end
    };
    if range.end <= domain.start + slack {
        if near(domain.start) {
            return Iso::Side(sides[0]);
        }
    } else if range.start >= domain.end - slack && near(domain.end) {
        return Iso::Side(sides[1]);
    }
    let inside = if steep { Iso::InnerU } else { Iso::InnerV };
    if near(range.middle()) { inside } else { Iso::None }
}

/// The parameters that openNURBS does not tell from `t`.
fn around(surface: &Surface, direction: Direction, t: f64) -> Interval {
    let mut domain = surface.domain(direction).ordered();
    // In the first and last span of a NURBS surface, or of a NURBS curve that a surface is made of, only that span
    // counts.
    let (knots, degree) = match surface {
        Surface::Nurbs(nurbs) => (nurbs.knots(direction), nurbs.degree(direction)),
        _ => match generator(surface, direction) {
            Some(Curve::Nurbs(curve)) => (curve.knots(), curve.degree()),
            _ => (&[][..], 0),
        },
    };
    let last = knots.len().saturating_sub(degree + 1);
    match (knots.get(degree), knots.get(last)) {
        (Some(&first), _) if t < first => domain.end = first,
        (_, Some(&last)) if t > last => domain.start = last,
        _ => {}
    }
    let t = domain.clamp(t);
    let length = domain.length();
    let wide = length * 8.0 * SQRT_EPSILON + (domain.start.abs() + domain.end.abs()) * f64::EPSILON;
    let wide = if wide >= length { 0.5 * length } else { wide };
    Interval::new(t - wide, t + wide)
}

/// The curve that runs in a direction of a surface, where the surface is made of curves.
fn generator(surface: &Surface, direction: Direction) -> Option<&Curve> {
    match surface {
        Surface::Sum(sum) => Some(&sum.curves()[direction.index()]),
        Surface::Revolution(turned) if turned.angle_direction() != direction => Some(turned.profile()),
        _ => None,
    }
}

/// The points that lie in order along a straight curve; none for a curve that has an arc in it.
fn controls(curve: &Curve) -> Option<Vec<Point3>> {
    Some(match curve {
        Curve::Line(c) => vec![c.line.from, c.line.to],
        Curve::Polyline(c) => c.points().to_vec(),
        Curve::Nurbs(c) => c.control_points(),
        Curve::Arc(_) => return None,
        Curve::Poly(c) => {
            let lists: Option<Vec<Vec<Point3>>> = c.segments().iter().map(controls).collect();
            lists?.concat()
        }
    })
}

/// Whether the control points lie within `tolerance` of the segment from start to end, without turning back.
pub(super) fn is_straight(curve: &Curve, tolerance: f64) -> bool {
    if let Curve::Nurbs(c) = curve
        && !c.is_clamped()
    {
        return false;
    }
    if let Curve::Line(c) = curve {
        let square = (c.line.to - c.line.from).dot(c.line.to - c.line.from);
        return square.is_finite() && square > 0.0;
    }
    let Some(points) = controls(curve) else { return false };
    let (Some(&from), Some(&to)) = (points.first(), points.last()) else { return false };
    let line = Line::new(from, to);
    let direction = to - from;
    let square = direction.dot(direction);
    if !(square.is_finite() && square > 0.0) {
        return false;
    }
    let tolerance = if tolerance > 0.0 { tolerance } else { ZERO };
    // In the order of operations of openNURBS: files hold curves that its rounding decides about.
    let per_length = direction * (1.0 / square);
    let mut reached = 0.0_f64;
    points.get(1..points.len() - 1).unwrap_or_default().iter().all(|p| {
        let (before, after) = (*p - from, *p - to);
        let t = if before.dot(before) <= after.dot(after) {
            before.dot(per_length)
        } else {
            1.0 + after.dot(per_length)
        };
        let foot = line.at(t);
        let apart = *p - foot;
        let left = tolerance * tolerance - apart.x * apart.x - apart.y * apart.y - apart.z * apart.z;
        let on_line = (-OVERHANG..=1.0 + OVERHANG).contains(&t) && left >= 0.0;
        reached = reached.max(t.min(1.0));
        let back = (t < reached || t > 1.0) && !(foot.distance_to(line.at(reached)) <= tolerance);
        on_line && !back
    })
}
