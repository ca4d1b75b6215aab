//! Pairs of spheres and cylinders whose common curves lie in planes.

use crate::{Cylinder, Plane, Sphere, Surface, Vector3};

/// What lies on such a surface is off by no more than this part of the size.
const EXACT: f64 = 1e-10;
/// Nearer to tangency than this part of the size, planes say nothing.
const CLEAR: f64 = 1e-6;

/// The planes in which the whole common curve of two surfaces lies, where the closed form is known: the radical plane of two
/// spheres and of two parallel cylinders, circles of a sphere about the axis of a cylinder, and both ellipses of equal
/// cylinders whose axes meet. `None` for all other pairs, and for those that are tangent or nearly so.
///
/// Source: the pencil of two quadrics holds their difference, which is linear or splits into two planes in these cases
/// (D. Eberly, *Intersection of Cylinders*; H. Coxeter, *Introduction to Geometry*, 6.5, for the radical plane).
pub(crate) fn common_planes(a: &Surface, b: &Surface) -> Option<Vec<Plane>> {
    match (form(a)?, form(b)?) {
        (Form::Sphere(p), Form::Sphere(q)) => spheres(&p, &q),
        (Form::Cylinder(p), Form::Cylinder(q)) => cylinders(&p, &q),
        (Form::Sphere(p), Form::Cylinder(q)) | (Form::Cylinder(q), Form::Sphere(p)) => sphere_in(&p, &q),
    }
}

enum Form {
    Sphere(Sphere),
    Cylinder(Cylinder),
}

fn form(surface: &Surface) -> Option<Form> {
    let size = surface.bounding_box().ok()?.diagonal().length();
    let sphere = surface.as_sphere(EXACT * size).map(Form::Sphere);
    sphere.or_else(|| surface.as_cylinder(EXACT * size).map(Form::Cylinder))
}

/// The plane across `way` at a distance along it where the squared distances to both centres differ as those of the radii.
fn radical(from: crate::Point3, way: Vector3, radii: [f64; 2]) -> Option<Vec<Plane>> {
    let d = way.length();
    let [r, s] = radii;
    let size = r.max(s);
    if !(d > CLEAR * size) || d > (r + s) * (1.0 - CLEAR) || d < (r - s).abs() + CLEAR * size {
        return None;
    }
    let along = 0.5 * (d * d + r * r - s * s) / d;
    Some(vec![Plane::from_normal(from + way * (along / d), way).ok()?])
}

fn spheres(p: &Sphere, q: &Sphere) -> Option<Vec<Plane>> {
    radical(p.plane.origin, q.plane.origin - p.plane.origin, [p.radius, q.radius])
}

fn cylinders(p: &Cylinder, q: &Cylinder) -> Option<Vec<Plane>> {
    let (a, b) = (p.plane.z_axis, q.plane.z_axis);
    let between = q.plane.origin - p.plane.origin;
    let size = p.radius.max(q.radius);
    let cross = a.cross(b);
    if cross.length() <= EXACT {
        return radical(p.plane.origin, between - a * between.dot(a), [p.radius, q.radius]);
    }
    let meet = between.dot(cross.unitized()?).abs() <= EXACT * (size + between.length());
    if !meet || (p.radius - q.radius).abs() > EXACT * size || cross.length() < CLEAR {
        return None;
    }
    // The axes meet where the way along the first is (w × b)·n / n².
    let along = between.cross(b).dot(cross) / cross.length_squared();
    let center = p.plane.origin + a * along;
    Some(vec![Plane::from_normal(center, a + b).ok()?, Plane::from_normal(center, a - b).ok()?])
}

fn sphere_in(p: &Sphere, q: &Cylinder) -> Option<Vec<Plane>> {
    let axis = q.plane.z_axis;
    let way = p.plane.origin - q.plane.origin;
    let off = way - axis * way.dot(axis);
    if off.length() > EXACT * p.radius || q.radius > p.radius * (1.0 - CLEAR) {
        return None;
    }
    let half = (p.radius * p.radius - q.radius * q.radius).sqrt();
    let at = |h: f64| Plane::from_normal(p.plane.origin + axis * h, axis).ok();
    Some(vec![at(half)?, at(-half)?])
}
