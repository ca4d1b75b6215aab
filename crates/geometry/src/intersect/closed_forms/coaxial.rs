//! Surfaces of revolution about one axis: the points that their profiles have in common, turned.

use katydid_elementary::Elementary;

use super::{Axis, Carrier, CarrierCurve, CarrierMeeting, Conic, parallel};
use crate::intersect::analytic::triangle;
use crate::{Circle, Plane, Tolerance};

/// A part of a profile in the half plane of the distance from the axis and the height.
#[derive(Debug, Clone, Copy)]
enum Profile {
    /// All points at a height.
    Level(f64),
    /// All points at a distance from the axis.
    Beside(f64),
    /// From the axis at a height, rising by the cosine and going out by the sine of an angle; both nappes of a cone have
    /// the two signs of the cosine.
    Ray { from: f64, sin: f64, cos: f64 },
    /// A circle about a point.
    Round { middle: [f64; 2], radius: f64 },
}

/// A point of two profiles: distance from the axis and height, and whether they are tangent there.
#[derive(Debug, Clone, Copy)]
struct Hit {
    at: [f64; 2],
    tangent: bool,
}

/// The meeting of two surfaces of revolution about one axis; the outer `None` when their axes differ, the inner when the
/// frame of a circle cannot be made.
pub(super) fn meeting(a: &Carrier, b: &Carrier, tolerance: &Tolerance) -> Option<Option<CarrierMeeting>> {
    let axis = common_axis(a, b, tolerance)?;
    let (own, other) = (profiles(a, &axis), profiles(b, &axis));
    if is_same(a, b, &axis, tolerance) {
        return Some(Some(CarrierMeeting::Same));
    }
    let mut hits: Vec<Hit> = Vec::new();
    for p in &own {
        for q in &other {
            for hit in common(p, q, tolerance.absolute)
                .or_else(|| common(q, p, tolerance.absolute))
                .unwrap_or_default()
            {
                let near = |h: &Hit| {
                    (h.at[0] - hit.at[0]).hypotenuse(h.at[1] - hit.at[1]) <= 2.0 * tolerance.absolute
                };
                // A cone's two rays begin in one point.
                if hit.at[0] >= -tolerance.absolute && !hits.iter().any(near) {
                    hits.push(hit);
                }
            }
        }
    }
    hits.sort_by(|p, q| p.at[1].total_cmp(&q.at[1]).then(p.at[0].total_cmp(&q.at[0])));
    let (mut curves, mut points) = (Vec::new(), Vec::new());
    for Hit { at: [r, z], tangent } in hits {
        if r <= tolerance.absolute {
            points.push(axis.at(z));
            continue;
        }
        let circle = Plane::from_normal(axis.at(z), axis.direction).and_then(|p| Circle::new(p, r));
        let Ok(circle) = circle else { return Some(None) };
        curves.push(CarrierCurve { conic: Conic::Circle(circle), tangent });
    }
    Some(Some(CarrierMeeting::Parts { curves, points }))
}

/// The axis about which both are surfaces of revolution.
fn common_axis(a: &Carrier, b: &Carrier, tolerance: &Tolerance) -> Option<Axis> {
    use Carrier::{Plane, Sphere};
    match (a, b) {
        (Plane(p), Plane(q)) => {
            parallel(p.z_axis, q.z_axis, tolerance).then_some(Axis { origin: p.origin, direction: p.z_axis })
        }
        (Sphere { center, .. }, Sphere { center: other, .. }) => {
            let direction = (*other - *center).unitized().unwrap_or(crate::Vector3::Z);
            Some(Axis { origin: *center, direction })
        }
        (Plane(p), Sphere { center, .. }) | (Sphere { center, .. }, Plane(p)) => {
            Some(Axis { origin: *center, direction: p.z_axis })
        }
        _ => {
            let axes = [own_axis(a), own_axis(b)];
            let axis = axes[0].or(axes[1])?;
            [a, b].iter().all(|s| turns_about(s, &axis, tolerance)).then_some(axis)
        }
    }
}

fn own_axis(surface: &Carrier) -> Option<Axis> {
    match surface {
        Carrier::Cylinder { axis, .. } | Carrier::Cone { axis, .. } | Carrier::Torus { axis, .. } => {
            Some(*axis)
        }
        Carrier::Plane(_) | Carrier::Sphere { .. } => None,
    }
}

fn turns_about(surface: &Carrier, axis: &Axis, tolerance: &Tolerance) -> bool {
    let passes = |p| axis.split(p).1.length() <= tolerance.absolute;
    match surface {
        Carrier::Plane(p) => parallel(p.z_axis, axis.direction, tolerance),
        Carrier::Sphere { center, .. } => passes(*center),
        Carrier::Cylinder { axis: own, .. }
        | Carrier::Cone { axis: own, .. }
        | Carrier::Torus { axis: own, .. } => {
            parallel(own.direction, axis.direction, tolerance) && passes(own.origin)
        }
    }
}

fn profiles(surface: &Carrier, axis: &Axis) -> Vec<Profile> {
    let height = |p| axis.split(p).0;
    match surface {
        Carrier::Plane(p) => vec![Profile::Level(height(p.origin))],
        Carrier::Sphere { center, radius } => {
            vec![Profile::Round { middle: [0.0, height(*center)], radius: *radius }]
        }
        Carrier::Cylinder { radius, .. } => vec![Profile::Beside(*radius)],
        Carrier::Cone { axis: own, half_angle } => {
            let (sin, cos) = half_angle.sine_cosine();
            [cos, -cos].map(|cos| Profile::Ray { from: height(own.origin), sin, cos }).to_vec()
        }
        Carrier::Torus { axis: own, major_radius, minor_radius } => {
            vec![Profile::Round { middle: [*major_radius, height(own.origin)], radius: *minor_radius }]
        }
    }
}

fn is_same(a: &Carrier, b: &Carrier, axis: &Axis, tolerance: &Tolerance) -> bool {
    use Carrier::{Cone, Cylinder, Plane, Sphere, Torus};
    let near = |x: f64, y: f64| (x - y).abs() <= tolerance.absolute;
    let level = |p, q| near(axis.split(p).0, axis.split(q).0);
    match (a, b) {
        (Plane(p), Plane(q)) => level(p.origin, q.origin),
        (Sphere { center: p, radius: r }, Sphere { center: q, radius: s }) => level(*p, *q) && near(*r, *s),
        (Cylinder { radius: r, .. }, Cylinder { radius: s, .. }) => near(*r, *s),
        (Cone { axis: p, half_angle: r }, Cone { axis: q, half_angle: s }) => {
            level(p.origin, q.origin) && (r - s).abs() <= tolerance.angle
        }
        (
            Torus { axis: p, major_radius: r, minor_radius: s },
            Torus { axis: q, major_radius: t, minor_radius: u },
        ) => level(p.origin, q.origin) && near(*r, *t) && near(*s, *u),
        _ => false,
    }
}

/// What two profiles have in common, on the side of the axis or not; `None` for an order of kinds that is not listed.
fn common(p: &Profile, q: &Profile, tolerance: f64) -> Option<Vec<Hit>> {
    use Profile::{Beside, Level, Ray, Round};
    let one = |r: f64, z: f64| vec![Hit { at: [r, z], tangent: false }];
    Some(match (*p, *q) {
        (Level(_), Level(_)) | (Beside(_), Beside(_)) => Vec::new(),
        (Level(z), Beside(r)) => one(r, z),
        (Level(z), Ray { from, sin, cos }) => outwards((z - from) / cos * sin, z, tolerance),
        (Beside(r), Ray { from, sin, cos }) => one(r, from + r / sin * cos),
        (Level(z), Round { middle, radius }) => chord(z - middle[1], radius, tolerance)
            .map(|(w, t)| Hit { at: [middle[0] + w, z], tangent: t })
            .collect(),
        (Beside(r), Round { middle, radius }) => chord(r - middle[0], radius, tolerance)
            .map(|(w, t)| Hit { at: [r, middle[1] + w], tangent: t })
            .collect(),
        (Ray { from, sin, cos }, Round { middle, radius }) => {
            let way = [middle[0], middle[1] - from];
            let (along, off) = (way[0] * sin + way[1] * cos, way[0] * cos - way[1] * sin);
            chord(off, radius, tolerance)
                .flat_map(|(w, tangent)| {
                    let s = along + w;
                    let at = [s * sin, from + s * cos];
                    if s < -tolerance { None } else { Some(Hit { at, tangent }) }
                })
                .collect()
        }
        (Ray { from, sin, cos }, Ray { from: other, sin: sin2, cos: cos2 }) => {
            rays([from, other], [sin, sin2], [cos, cos2], tolerance)
        }
        (Round { middle, radius }, Round { middle: other, radius: second }) => {
            rounds([middle, other], [radius, second], tolerance)
        }
        _ => return None,
    })
}

/// A point of a ray, unless it lies behind its start.
fn outwards(r: f64, z: f64, tolerance: f64) -> Vec<Hit> {
    if r < -tolerance { Vec::new() } else { vec![Hit { at: [r, z], tangent: false }] }
}

/// Where a line at a distance from the middle of a circle meets it: places along the line from the foot of the middle.
fn chord(off: f64, radius: f64, tolerance: f64) -> impl Iterator<Item = (f64, bool)> {
    let off = off.abs();
    let out = if off > radius + tolerance {
        vec![]
    } else if off >= radius - tolerance {
        vec![(0.0, true)]
    } else {
        let half = ((radius - off) * (radius + off)).sqrt();
        vec![(-half, false), (half, false)]
    };
    out.into_iter()
}

fn rays(from: [f64; 2], sin: [f64; 2], cos: [f64; 2], tolerance: f64) -> Vec<Hit> {
    let between = from[1] - from[0];
    let across = cos[0] * sin[1] - sin[0] * cos[1];
    if between.abs() <= tolerance {
        return vec![Hit { at: [0.0, from[0]], tangent: false }];
    }
    // (s sin₁, from₁ + s cos₁) on the other ray.
    let s = between * sin[1] / across;
    let t = between * sin[0] / across;
    if !(s.is_finite() && t.is_finite() && s > 0.0 && t > 0.0) {
        return Vec::new();
    }
    vec![Hit { at: [s * sin[0], from[0] + s * cos[0]], tangent: false }]
}

fn rounds(middles: [[f64; 2]; 2], radii: [f64; 2], tolerance: f64) -> Vec<Hit> {
    let way = [middles[1][0] - middles[0][0], middles[1][1] - middles[0][1]];
    let (d, [r, s]) = (way[0].hypotenuse(way[1]), radii);
    if d == 0.0 || d > r + s + tolerance || d < (r - s).abs() - tolerance {
        return Vec::new();
    }
    let unit = way.map(|x| x / d);
    let at = |along: f64, half: f64, tangent: bool| Hit {
        at: [
            middles[0][0] + unit[0] * along - unit[1] * half,
            middles[0][1] + unit[1] * along + unit[0] * half,
        ],
        tangent,
    };
    if d >= r + s - tolerance {
        return vec![at(r * d / (r + s), 0.0, true)];
    }
    if d <= (r - s).abs() + tolerance {
        // On the smaller circle, where the place is known best.
        return vec![if r <= s { at(-r, 0.0, true) } else { at(d + s, 0.0, true) }];
    }
    let (along, half) = triangle(d, r, s);
    vec![at(along, -half, false), at(along, half, false)]
}
