//! Points and vectors as arrays of numbers.

use katydid_geometry::{Plane, Point3, Vector3};

pub(crate) fn point(p: Point3) -> [f64; 3] {
    [p.x, p.y, p.z]
}

pub(crate) fn vector(v: Vector3) -> [f64; 3] {
    [v.x, v.y, v.z]
}

pub(crate) fn points(points: &[Point3]) -> Vec<[f64; 3]> {
    points.iter().copied().map(point).collect()
}

pub(crate) fn vectors(vectors: &[Vector3]) -> Vec<[f64; 3]> {
    vectors.iter().copied().map(vector).collect()
}

pub(crate) fn plane(plane: &Plane) -> [[f64; 3]; 4] {
    [point(plane.origin), vector(plane.x_axis), vector(plane.y_axis), vector(plane.z_axis)]
}
