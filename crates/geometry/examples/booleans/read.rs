//! Kernel values out of the files.

use katydid_geometry::{Interval, Plane, Point3, Vector3};
use serde_json::Value;

/// What was read, or what is wrong with it.
pub(crate) type Read<T> = Result<T, String>;

fn wrong<T>(what: &str, v: &Value) -> Read<T> {
    let text: String = v.to_string().chars().take(60).collect();
    Err(format!("not {what}: {text}"))
}

pub(crate) fn number(v: &Value) -> Read<f64> {
    v.as_f64().map_or_else(|| wrong("a number", v), Ok)
}

pub(crate) fn text(v: &Value) -> Read<&str> {
    v.as_str().map_or_else(|| wrong("a text", v), Ok)
}

pub(crate) fn list(v: &Value) -> Read<&Vec<Value>> {
    v.as_array().map_or_else(|| wrong("a list", v), Ok)
}

pub(crate) fn numbers<const N: usize>(v: &Value) -> Read<[f64; N]> {
    let all: Vec<f64> = list(v)?.iter().map(number).collect::<Read<_>>()?;
    all.try_into().map_or_else(|_| wrong("so many numbers", v), Ok)
}

pub(crate) fn vector(v: &Value) -> Read<Vector3> {
    numbers::<3>(v).map(|[x, y, z]| Vector3::new(x, y, z))
}

pub(crate) fn point(v: &Value) -> Read<Point3> {
    numbers::<3>(v).map(Point3::from)
}

pub(crate) fn interval(v: &Value) -> Read<Interval> {
    numbers::<2>(v).map(|[a, b]| Interval::new(a, b))
}

/// A frame of origin, normal and x axis.
pub(crate) fn frame(v: &Value) -> Read<Plane> {
    let (z, x) = (vector(&v["z"])?, vector(&v["x"])?);
    Plane::from_axes(point(&v["o"])?, x, z.cross(x)).map_err(|e| e.to_string())
}

/// The texts of a list.
pub(crate) fn names(v: &Value) -> Read<Vec<&str>> {
    list(v)?.iter().map(text).collect()
}
