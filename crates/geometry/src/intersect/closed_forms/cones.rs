//! Cylinders and cones whose common curves are plane: around one sphere, moved along, or from one apex.

use katydid_elementary::Elementary;

use super::{Axis, Carrier, CarrierCurve, CarrierMeeting, Conic, parallel, plane_sections};
use crate::{Plane, Point3, Tolerance, Vector3};

/// A linear function of place: its gradient, and its value at a point that the context names.
#[derive(Debug, Clone, Copy)]
struct Linear {
    gradient: Vector3,
    value: f64,
}

/// The meeting of two cylinders or cones about different axes.
pub(super) fn meeting(a: &Carrier, b: &Carrier, tolerance: &Tolerance) -> Option<CarrierMeeting> {
    let (p, q) = (axis_of(a)?, axis_of(b)?);
    if let (Carrier::Cone { half_angle: r, .. }, Carrier::Cone { half_angle: s, .. }) = (a, b) {
        if p.origin.distance_to(q.origin) <= tolerance.absolute {
            return from_one_apex(&p, &q, [*r, *s], tolerance);
        }
        if parallel(p.direction, q.direction, tolerance) && (r - s).abs() <= tolerance.angle {
            return moved(a, &p, &q, *r, tolerance);
        }
    }
    around_one_sphere([a, b], [&p, &q], tolerance)
}

fn axis_of(surface: &Carrier) -> Option<Axis> {
    match surface {
        Carrier::Cylinder { axis, .. } | Carrier::Cone { axis, .. } => Some(*axis),
        _ => None,
    }
}

/// The radius of the sphere about a point of the axis that a cylinder or cone is tangent to along a circle, and the linear
/// function L that is 0 in the plane of that circle, such that the surface is |x − center|² − radius² = L².
fn inscribed(surface: &Carrier, center: Point3) -> Option<(f64, Linear)> {
    match surface {
        Carrier::Cylinder { axis, radius } => {
            Some((*radius, Linear { gradient: axis.direction, value: 0.0 }))
        }
        Carrier::Cone { axis, half_angle } => {
            let (sin, cos) = half_angle.sine_cosine();
            let height = axis.split(center).0;
            let value = height * sin * sin / cos;
            Some((height.abs() * sin, Linear { gradient: axis.direction / cos, value }))
        }
        _ => None,
    }
}

/// Both surfaces are tangent to one sphere: the difference of L₁² and L₂² is the product of two planes.
fn around_one_sphere(
    surfaces: [&Carrier; 2],
    axes: [&Axis; 2],
    tolerance: &Tolerance,
) -> Option<CarrierMeeting> {
    let [p, q] = axes;
    let across = p.direction.cross(q.direction);
    if across.length() <= tolerance.angle {
        return None;
    }
    let between = q.origin - p.origin;
    if between.dot(across.unitized()?).abs() > tolerance.absolute {
        return None;
    }
    let center = p.at(between.cross(q.direction).dot(across) / across.length_squared());
    let [(r, f), (s, g)] = [inscribed(surfaces[0], center)?, inscribed(surfaces[1], center)?];
    if (r - s).abs() > tolerance.absolute || r <= tolerance.absolute {
        return None;
    }
    let (mut curves, mut points) = (Vec::new(), Vec::new());
    for sign in [-1.0, 1.0] {
        let normal = f.gradient + g.gradient * sign;
        let unit = normal.unitized()?;
        let origin = center - unit * ((f.value + g.value * sign) / normal.length());
        let plane = Plane::from_normal(origin, unit).ok()?;
        // A cylinder before a cone: its sections are the simpler ones.
        let on = surfaces.iter().find(|s| matches!(s, Carrier::Cylinder { .. })).unwrap_or(&surfaces[0]);
        let CarrierMeeting::Parts { curves: own, points: apexes } = section(&plane, on, tolerance)? else {
            return None;
        };
        // A plane that touches one of them along a ruling touches the other one there, too.
        curves.extend(own);
        points.extend(apexes);
    }
    Some(CarrierMeeting::Parts { curves, points })
}

/// Two cones of one angle with parallel axes: their equations differ by a linear function.
fn moved(a: &Carrier, p: &Axis, q: &Axis, half_angle: f64, tolerance: &Tolerance) -> Option<CarrierMeeting> {
    let way = q.origin - p.origin;
    let (height, aside) = p.split(q.origin);
    let (sin, cos) = half_angle.sine_cosine();
    // |x|² cos² − (x·w)² = |x − way|² cos² − (x·w − height)²
    let normal = way * (cos * cos) - p.direction * height;
    let value = 0.5 * (way.length_squared() * cos * cos - height * height);
    if (aside.length() * cos - height.abs() * sin).abs() <= tolerance.absolute {
        // One apex lies on the other cone: they touch along the ruling through both.
        let line = Axis { origin: p.origin, direction: way.unitized()? };
        return Some(CarrierMeeting::curves(vec![CarrierCurve { conic: Conic::Line(line), tangent: true }]));
    }
    let unit = normal.unitized()?;
    let plane = Plane::from_normal(p.origin + unit * (value / normal.length()), unit).ok()?;
    section(&plane, a, tolerance)
}

/// Rulings that both cones have: their directions have given angles with both axes.
fn from_one_apex(p: &Axis, q: &Axis, angles: [f64; 2], tolerance: &Tolerance) -> Option<CarrierMeeting> {
    let n = p.direction.cross(q.direction).unitized()?;
    let mut curves = Vec::new();
    for sign in [1.0, -1.0] {
        let other = q.direction * sign;
        let between = p.direction.cross(other).length().arctangent_of(p.direction.dot(other));
        // Two caps of a unit sphere, the angle between their middles known.
        let [r, s] = angles;
        let in_plane = |turn: f64| {
            let beside = n.cross(p.direction) * sign;
            p.direction * turn.cosine() + beside * turn.sine()
        };
        let ruling = |direction: Vector3, tangent: bool| CarrierCurve {
            conic: Conic::Line(Axis { origin: p.origin, direction }),
            tangent,
        };
        let near = tolerance.angle;
        if between > r + s + near || between < (r - s).abs() - near {
            continue;
        }
        if between >= r + s - near {
            curves.push(ruling(in_plane(r), true));
        } else if between <= (r - s).abs() + near {
            curves.push(ruling(in_plane(if r > s { r } else { -r }), true));
        } else {
            // Direction x p + y b + z n with x = cos r, and its product with the other axis cos s.
            let (sin, cos) = between.sine_cosine();
            let x = r.cosine();
            let y = (s.cosine() - x * cos) / sin;
            // z² = sin² r − y², as a product of sines of half sums, which keeps its digits near a touch.
            let [u, v] = [0.5 * (r + s + between), 0.5 * (r + s - between)];
            let [k, l] = [0.5 * (between + r - s), 0.5 * (between - r + s)];
            let z = 2.0 * (u.sine() * v.sine() * k.sine() * l.sine()).max(0.0).sqrt() / sin;
            let beside = n.cross(p.direction) * sign;
            for z in [-z, z] {
                curves.push(ruling((p.direction * x + beside * y + n * z).unitized()?, false));
            }
        }
    }
    if curves.is_empty() {
        Some(CarrierMeeting::point(p.origin))
    } else {
        Some(CarrierMeeting::curves(curves))
    }
}

/// A plane's section of a cylinder or cone, also one across its axis.
fn section(plane: &Plane, surface: &Carrier, tolerance: &Tolerance) -> Option<CarrierMeeting> {
    let flat = Carrier::Plane(*plane);
    if let Some(met) = super::coaxial::meeting(&flat, surface, tolerance) {
        return met;
    }
    match surface {
        Carrier::Cylinder { axis, radius } => plane_sections::of_cylinder(plane, axis, *radius, tolerance),
        Carrier::Cone { axis, half_angle } => plane_sections::of_cone(plane, axis, *half_angle, tolerance),
        _ => None,
    }
}
