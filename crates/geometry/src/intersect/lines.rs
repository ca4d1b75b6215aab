//! Lines and planes, without ends.

use super::thresholds::{PARALLEL, PARALLEL_SQUARED};
use crate::{Line, Plane, Point3};

/// The parameters on both infinite lines where they come nearest to each other; `None` when they are parallel or one
/// has no length. Where the lines cross, both parameters give the crossing.
pub fn line_line(a: &Line, b: &Line) -> Option<(f64, f64)> {
    let (u, v) = (a.unit_direction()?, b.unit_direction()?);
    let n = u.cross(v);
    let squared = n.length_squared();
    // sin² of the angle between them: below this the crossing has no correct digit left.
    if !(squared > PARALLEL_SQUARED) {
        return None;
    }
    let w = b.from - a.from;
    let s = w.cross(v).dot(n) / squared;
    let t = w.cross(u).dot(n) / squared;
    Some((s / a.length(), t / b.length()))
}

/// The parameter on the infinite line where it meets the plane; `None` when it runs parallel to the plane.
pub fn line_plane(line: &Line, plane: &Plane) -> Option<f64> {
    let (from, to) = (plane.signed_distance(line.from), plane.signed_distance(line.to));
    let along = line.unit_direction()?.dot(plane.z_axis);
    if !(along.abs() > PARALLEL) || from == to {
        return None;
    }
    let t = from / (from - to);
    t.is_finite().then_some(t)
}

/// The line in which two planes meet: it starts near their origins, and its direction is the cross product of the
/// normals, second times first, as openNURBS has it. `None` when they are parallel.
pub fn plane_plane(a: &Plane, b: &Plane) -> Option<Line> {
    let direction = b.z_axis.cross(a.z_axis);
    let middle = a.origin.lerp(b.origin, 0.5);
    let across = Plane::from_normal(middle, direction).ok()?;
    let from = three_planes(a, b, &across)?;
    Some(Line::new(from, from + direction))
}

/// The point that three planes have in common; `None` when they have none or more than one.
pub fn three_planes(a: &Plane, b: &Plane, c: &Plane) -> Option<Point3> {
    let (n1, n2, n3) = (a.z_axis, b.z_axis, c.z_axis);
    let determinant = n1.dot(n2.cross(n3));
    if !(determinant.abs() > PARALLEL) {
        return None;
    }
    // Measured from the first origin, so that distances stay small far from the world's origin.
    let (d2, d3) = (n2.dot(b.origin - a.origin), n3.dot(c.origin - a.origin));
    let p = a.origin + (n3.cross(n1) * d2 + n1.cross(n2) * d3) / determinant;
    p.is_finite().then_some(p)
}
