//! Intersections with a closed form: lines, planes, circles, arcs, spheres, cylinders, boxes.
//!
//! Lines are infinite, with their own parameter (0 at the start, 1 at the end), and planes without bounds. All
//! solutions are found. `tolerance` is a distance: what comes nearer than that touches, and touching counts once.

use katydid_elementary::Elementary;

use super::thresholds::{ON_OTHER, PARALLEL};
use crate::{Arc, BoundingBox, Box3, Circle, Interval, Line, Plane, Point3, Vector3};

/// At most two solutions.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum UpToTwo<T> {
    /// They do not meet.
    None,
    /// One solution: a crossing or a touch.
    One(T),
    /// Two crossings, in the order of the first argument's parameter.
    Two(T, T),
}

impl<T: Copy> UpToTwo<T> {
    /// How many there are.
    pub fn count(&self) -> usize {
        self.iter().count()
    }

    /// The solutions.
    pub fn iter(&self) -> impl Iterator<Item = T> + use<T> {
        let (a, b) = match *self {
            Self::None => (None, None),
            Self::One(a) => (Some(a), None),
            Self::Two(a, b) => (Some(a), Some(b)),
        };
        a.into_iter().chain(b)
    }

    /// Those that a function turns into something.
    fn filter_map<U: Copy>(&self, f: impl FnMut(T) -> Option<U>) -> UpToTwo<U> {
        let mut found = self.iter().filter_map(f);
        match (found.next(), found.next()) {
            (Some(a), Some(b)) => UpToTwo::Two(a, b),
            (Some(a), None) => UpToTwo::One(a),
            _ => UpToTwo::None,
        }
    }
}

/// Where a line meets a circle or an arc.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LineCircleHit {
    /// The parameter on the line.
    pub on_line: f64,
    /// The angle on the circle in radians: 0…2π, for an arc within its own range.
    pub angle: f64,
}

/// How a plane meets a circle or an arc.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum PlaneCircle {
    /// At these angles in radians, ascending.
    At(UpToTwo<f64>),
    /// The circle lies in the plane.
    InPlane,
}

/// How a plane meets a sphere, or a sphere another.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SphereSection {
    /// They are apart, or one sphere lies inside the other.
    None,
    /// They touch.
    Point(Point3),
    /// They meet in a circle.
    Circle(Circle),
    /// The two spheres are the same.
    Same,
}

/// How a line meets a cylinder without ends.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum LineCylinder {
    /// At these parameters of the line.
    At(UpToTwo<f64>),
    /// The line runs on the cylinder.
    OnSurface,
}

/// How two circles meet.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum CircleCircle {
    /// At these angles in radians, one on each circle a solution, 0…2π.
    At(UpToTwo<[f64; 2]>),
    /// They are the same circle.
    Same,
}

/// How two arcs meet.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ArcArc {
    /// The angles in radians on both arcs where they cross or touch, in the order of the first.
    pub points: Vec<[f64; 2]>,
    /// The ranges of angle on the first arc that both share.
    pub overlaps: Vec<Interval>,
}

/// An angle brought into 0…2π.
fn positive(angle: f64) -> f64 {
    let a = angle.rem_euclid(std::f64::consts::TAU);
    if a >= std::f64::consts::TAU { 0.0 } else { a }
}

/// The parameters where the plane line from + t·d meets the circle of radius r about the origin; `None` for a line
/// without direction.
fn flat_line_circle(from: [f64; 2], d: [f64; 2], r: f64, tolerance: f64) -> Option<UpToTwo<f64>> {
    let length = d[0].hypotenuse(d[1]);
    if !(length > 0.0 && length.is_finite()) {
        return None;
    }
    let u = [d[0] / length, d[1] / length];
    let middle = -(from[0] * u[0] + from[1] * u[1]);
    let distance = (from[0] * u[1] - from[1] * u[0]).abs();
    Some(if distance > r + tolerance {
        UpToTwo::None
    } else if distance >= r - tolerance {
        UpToTwo::One(middle / length)
    } else {
        let half = ((r - distance) * (r + distance)).sqrt();
        UpToTwo::Two((middle - half) / length, (middle + half) / length)
    })
}

/// Where a line meets a circle in space: it may cross the circle's plane there or run in it.
pub fn line_circle(line: &Line, circle: &Circle, tolerance: f64) -> UpToTwo<LineCircleHit> {
    let Some(direction) = line.unit_direction() else { return UpToTwo::None };
    let (plane, length) = (&circle.plane, line.length());
    let [fx, fy, fz] = plane.coordinates(line.from);
    let [dx, dy, dz] = [plane.x_axis, plane.y_axis, plane.z_axis].map(|axis| direction.dot(axis));
    let hit = |s: f64| {
        let angle = positive((fy + s * dy).arctangent_of(fx + s * dx));
        LineCircleHit { on_line: s / length, angle }
    };
    let across = flat_line_circle([fx, fy], [dx, dy], circle.radius, tolerance).unwrap_or(UpToTwo::None);
    // Where the line meets the cylinder over the circle, it must be at the circle's height.
    let level = across.filter_map(|s| ((fz + s * dz).abs() <= tolerance).then(|| hit(s)));
    if level != UpToTwo::None || dz == 0.0 {
        return level;
    }
    // A steep line: the crossing with the plane decides.
    let s = -fz / dz;
    let off = (fx + s * dx).hypotenuse(fy + s * dy) - circle.radius;
    if off.abs() <= tolerance { UpToTwo::One(hit(s)) } else { UpToTwo::None }
}

/// An angle of the circle as one within the arc; within `tolerance` of an end it is that end.
fn on_arc(arc: &Arc, angle: f64, tolerance: f64) -> Option<f64> {
    let turn = std::f64::consts::TAU;
    let slack = tolerance / arc.circle.radius;
    let (low, high) = (arc.angle.min(), arc.angle.max());
    let a = angle + ((low - angle) / turn).ceil() * turn;
    if a <= high {
        Some(a)
    } else if a - high <= slack {
        Some(high)
    } else if low - (a - turn) <= slack {
        Some(low)
    } else {
        None
    }
}

/// Where a line meets an arc.
pub fn line_arc(line: &Line, arc: &Arc, tolerance: f64) -> UpToTwo<LineCircleHit> {
    line_circle(line, &arc.circle, tolerance)
        .filter_map(|hit| on_arc(arc, hit.angle, tolerance).map(|angle| LineCircleHit { angle, ..hit }))
}

/// The parameters of a line on a sphere.
pub fn line_sphere(line: &Line, center: Point3, radius: f64, tolerance: f64) -> UpToTwo<f64> {
    let Some(direction) = line.unit_direction() else { return UpToTwo::None };
    let from = line.from - center;
    let middle = -from.dot(direction);
    let distance = from.cross(direction).length();
    let length = line.length();
    if distance > radius + tolerance {
        UpToTwo::None
    } else if distance >= radius - tolerance {
        UpToTwo::One(middle / length)
    } else {
        let half = ((radius - distance) * (radius + distance)).sqrt();
        UpToTwo::Two((middle - half) / length, (middle + half) / length)
    }
}

/// Where a line meets the cylinder without ends through a circle.
pub fn line_cylinder(line: &Line, circle: &Circle, tolerance: f64) -> LineCylinder {
    let none = LineCylinder::At(UpToTwo::None);
    let Some(direction) = line.unit_direction() else { return none };
    let (plane, r) = (&circle.plane, circle.radius);
    let [fx, fy, fz] = plane.coordinates(line.from);
    let [dx, dy, dz] = [plane.x_axis, plane.y_axis, plane.z_axis].map(|axis| direction.dot(axis));
    // Parallel to the axis, up to rounding: it turns by less than the tolerance over many radii.
    if dx.hypotenuse(dy) <= PARALLEL || dx.hypotenuse(dy) * (r + fz.abs()) <= ON_OTHER * tolerance {
        let on = (fx.hypotenuse(fy) - r).abs() <= tolerance && dz != 0.0;
        return if on { LineCylinder::OnSurface } else { none };
    }
    let length = line.length();
    let across = flat_line_circle([fx, fy], [dx, dy], r, tolerance).unwrap_or(UpToTwo::None);
    LineCylinder::At(across.filter_map(|s| Some(s / length)))
}

/// The range of a line's parameters inside a box along the world axes grown by `tolerance`; `None` when it passes by.
/// A line that touches an edge or a corner has a range of length 0 or nearly so.
///
/// The slab method (T. Kay & J. Kajiya, *Ray tracing complex scenes*, SIGGRAPH 1986).
pub fn line_bounding_box(line: &Line, bounds: &BoundingBox, tolerance: f64) -> Option<Interval> {
    let grown = |low: f64, high: f64| Interval::new(low - tolerance, high + tolerance);
    let (a, b) = (bounds.min, bounds.max);
    let slabs = [grown(a.x, b.x), grown(a.y, b.y), grown(a.z, b.z)];
    slab_range(line.from.into(), line.direction().into(), slabs)
}

/// The range of a line's parameters inside a box in any position, as [`line_bounding_box`].
pub fn line_box(line: &Line, solid: &Box3, tolerance: f64) -> Option<Interval> {
    let grown = |r: Interval| Interval::new(r.min() - tolerance, r.max() + tolerance);
    let (p, d) = (&solid.plane, line.direction());
    let direction = [p.x_axis, p.y_axis, p.z_axis].map(|axis| d.dot(axis));
    slab_range(p.coordinates(line.from), direction, [grown(solid.x), grown(solid.y), grown(solid.z)])
}

fn slab_range(from: [f64; 3], d: [f64; 3], slabs: [Interval; 3]) -> Option<Interval> {
    if d == [0.0; 3] {
        return None;
    }
    let mut range = Interval::new(f64::NEG_INFINITY, f64::INFINITY);
    for ((from, d), slab) in from.iter().zip(d).zip(slabs) {
        if d == 0.0 {
            if !slab.contains(*from) {
                return None;
            }
            continue;
        }
        let (s, t) = ((slab.start - from) / d, (slab.end - from) / d);
        range = Interval::new(range.start.max(s.min(t)), range.end.min(s.max(t)));
    }
    (range.start <= range.end).then_some(range)
}

/// Where a plane meets a circle.
pub fn plane_circle(plane: &Plane, circle: &Circle, tolerance: f64) -> PlaneCircle {
    // Height above the plane: h + r (a cos θ + b sin θ).
    let frame = &circle.plane;
    let h = plane.signed_distance(frame.origin);
    let (a, b) = (frame.x_axis.dot(plane.z_axis), frame.y_axis.dot(plane.z_axis));
    let reach = circle.radius * a.hypotenuse(b);
    if h.abs() + reach <= tolerance {
        return PlaneCircle::InPlane;
    }
    let low = b.arctangent_of(a);
    PlaneCircle::At(if h.abs() > reach + tolerance {
        UpToTwo::None
    } else if h.abs() >= reach - tolerance {
        UpToTwo::One(positive(if h > 0.0 { low + std::f64::consts::PI } else { low }))
    } else {
        // cos(θ − low) = −h / reach; by the half chord, which keeps its digits near a touch.
        let half = ((reach - h) * (reach + h)).sqrt().arctangent_of(-h);
        let (s, t) = (positive(low - half), positive(low + half));
        UpToTwo::Two(s.min(t), s.max(t))
    })
}

/// Where a plane meets an arc.
pub fn plane_arc(plane: &Plane, arc: &Arc, tolerance: f64) -> PlaneCircle {
    let PlaneCircle::At(angles) = plane_circle(plane, &arc.circle, tolerance) else {
        return PlaneCircle::InPlane;
    };
    PlaneCircle::At(match angles.filter_map(|a| on_arc(arc, a, tolerance)) {
        UpToTwo::Two(s, t) => UpToTwo::Two(s.min(t), s.max(t)),
        other => other,
    })
}

/// Where a plane cuts a sphere; the circle has the plane's axes.
pub fn plane_sphere(plane: &Plane, center: Point3, radius: f64, tolerance: f64) -> SphereSection {
    let h = plane.signed_distance(center);
    let foot = center - plane.z_axis * h;
    if h.abs() > radius + tolerance {
        return SphereSection::None;
    }
    if h.abs() >= radius - tolerance {
        return SphereSection::Point(foot);
    }
    let r = ((radius - h) * (radius + h)).sqrt();
    Circle::new(plane.with_origin(foot), r).map_or(SphereSection::None, SphereSection::Circle)
}

/// Where two spheres meet, each a centre and a radius; the circle's normal leads from the first to the second.
pub fn sphere_sphere(a: (Point3, f64), b: (Point3, f64), tolerance: f64) -> SphereSection {
    let (between, ra, rb) = (b.0 - a.0, a.1, b.1);
    let distance = between.length();
    if distance + (ra - rb).abs() <= tolerance {
        return SphereSection::Same;
    }
    let Some(normal) = between.unitized() else { return SphereSection::None };
    if distance > ra + rb + tolerance || distance < (ra - rb).abs() - tolerance {
        return SphereSection::None;
    }
    let (along, half) = triangle(distance, ra, rb);
    let center = a.0 + normal * along;
    if distance >= ra + rb - tolerance || distance <= (ra - rb).abs() + tolerance {
        // On the smaller sphere, where the touching point is known best.
        let point = if ra <= rb {
            a.0 + normal * ra.copysign(along)
        } else {
            b.0 - normal * rb.copysign(distance - along)
        };
        return SphereSection::Point(point);
    }
    let circle = Plane::from_normal(center, normal).and_then(|p| Circle::new(p, half));
    circle.map_or(SphereSection::None, SphereSection::Circle)
}

/// Of the triangle with base `d` and the sides `ra` and `rb` over it: where the height stands on the base, measured
/// from the first corner, and the height, by W. Kahan's stable form of Heron's formula.
pub(super) fn triangle(d: f64, ra: f64, rb: f64) -> (f64, f64) {
    let along = 0.5 * (d + (ra - rb) * (ra + rb) / d);
    let mut s = [d, ra, rb];
    s.sort_by(|x, y| y.total_cmp(x));
    let [a, b, c] = s;
    let square = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    (along, 0.5 * square.max(0.0).sqrt() / d)
}

/// Whether two circles lie in one plane within `tolerance` where they are.
fn coplanar(a: &Circle, b: &Circle, tolerance: f64) -> bool {
    let (na, nb) = (a.plane.z_axis, b.plane.z_axis);
    let reach = a.radius.max(b.radius);
    na.cross(nb).length() * reach <= tolerance && a.plane.signed_distance(b.center()).abs() <= tolerance
}

/// Where two circles in space meet.
pub fn circle_circle(a: &Circle, b: &Circle, tolerance: f64) -> CircleCircle {
    let angle = |c: &Circle, p: Point3| {
        let [x, y, _] = c.plane.coordinates(p);
        positive(y.arctangent_of(x))
    };
    if !coplanar(a, b, tolerance) {
        let meet = |tolerance_of_plane: f64| {
            let PlaneCircle::At(angles) = plane_circle(&b.plane, a, tolerance_of_plane) else {
                return UpToTwo::None;
            };
            angles.filter_map(|t| {
                let p = a.at(t);
                let on = angle(b, p);
                (b.at(on).distance_to(p) <= tolerance).then_some([t, on])
            })
        };
        // Where the plane all but touches the circle its two crossings count as one place between them, and the other
        // circle may go through either of the two and miss that.
        let found = meet(tolerance);
        return CircleCircle::At(if found.count() == 0 { meet(0.0) } else { found });
    }
    let [x, y, _] = a.plane.coordinates(b.center());
    let (distance, ra, rb) = (x.hypotenuse(y), a.radius, b.radius);
    if distance + (ra - rb).abs() <= tolerance {
        return CircleCircle::Same;
    }
    if distance == 0.0 || distance > ra + rb + tolerance || distance < (ra - rb).abs() - tolerance {
        return CircleCircle::At(UpToTwo::None);
    }
    let toward = y.arctangent_of(x);
    let (along, half) = triangle(distance, ra, rb);
    let touches = distance >= ra + rb - tolerance || distance <= (ra - rb).abs() + tolerance;
    let turn = if touches {
        if along < 0.0 { std::f64::consts::PI } else { 0.0 }
    } else {
        half.arctangent_of(along)
    };
    let hit = |t: f64| [positive(t), angle(b, a.at(t))];
    if touches {
        return CircleCircle::At(UpToTwo::One(hit(toward + turn)));
    }
    let (s, t) = (hit(toward - turn), hit(toward + turn));
    CircleCircle::At(if s[0] <= t[0] { UpToTwo::Two(s, t) } else { UpToTwo::Two(t, s) })
}

/// Where two arcs in space meet; arcs of one circle may share ranges.
pub fn arc_arc(a: &Arc, b: &Arc, tolerance: f64) -> ArcArc {
    let mut out = ArcArc::default();
    match circle_circle(&a.circle, &b.circle, tolerance) {
        CircleCircle::At(hits) => {
            for [s, t] in hits.iter() {
                if let (Some(s), Some(t)) = (on_arc(a, s, tolerance), on_arc(b, t, tolerance)) {
                    out.points.push([s, t]);
                }
            }
        }
        CircleCircle::Same => share(a, b, tolerance, &mut out),
    }
    out.points.sort_by(|p, q| p[0].total_cmp(&q[0]));
    out
}

/// What two arcs of one circle have in common.
fn share(a: &Arc, b: &Arc, tolerance: f64, out: &mut ArcArc) {
    let turn = std::f64::consts::TAU;
    // The angle on a is `offset` ± the angle on b.
    let same_way = a.circle.plane.z_axis.dot(b.circle.plane.z_axis) > 0.0;
    let x: Vector3 = b.circle.plane.x_axis;
    let offset = x.dot(a.circle.plane.y_axis).arctangent_of(x.dot(a.circle.plane.x_axis));
    let sign = if same_way { 1.0 } else { -1.0 };
    let there = Interval::new(offset + sign * b.angle.min(), offset + sign * b.angle.max()).ordered();
    let slack = tolerance / a.circle.radius;
    let (low, high) = (a.angle.min(), a.angle.max());
    let first = ((low - there.end) / turn).floor();
    for k in 0..4 {
        let shift = (first + f64::from(k)) * turn;
        let (s, t) = ((there.start + shift).max(low), (there.end + shift).min(high));
        if t - s > slack {
            out.overlaps.push(Interval::new(s, t));
        } else if t - s >= -slack {
            let middle = (0.5 * (s + t)).clamp(low, high);
            let on_b = sign * (middle - shift - offset);
            out.points.push([middle, on_b.clamp(b.angle.min(), b.angle.max())]);
        }
    }
    // Two full circles cut at different places share the whole circle.
    if a.is_circle() && b.is_circle() {
        *out = ArcArc { points: Vec::new(), overlaps: vec![Interval::new(low, high)] };
    }
}
