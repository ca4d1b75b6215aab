//! Asking, and what is asked about.

use katydid_compute::wire::{Read, Wire};
use katydid_compute::{Bounds, Fault, geometry};
use katydid_geometry::{
    BoundingBox, Box3, Brep, Circle, Curve, Interval, Line, Mesh, Plane, PlaneSurface, Point3, Sphere,
    Surface, construct,
};
use serde_json::{Value as Json, json};

pub(crate) fn object<T: Wire>(value: &T) -> Json {
    value.to_json(70).unwrap()
}

pub(crate) fn asked_with(path: &str, query: &[(&str, &str)], arguments: &Json) -> Result<Json, Fault> {
    let query = geometry::Query::read(query.iter().copied())?;
    let reply = geometry::call(path, &query, arguments.to_string().as_bytes(), &Bounds::default())?;
    Ok(reply.json.unwrap_or(Json::Null))
}

pub(crate) fn asked(path: &str, arguments: &Json) -> Result<Json, Fault> {
    asked_with(path, &[], arguments)
}

pub(crate) fn ask(path: &str, arguments: Json) -> Json {
    asked(path, &arguments).unwrap_or_else(|fault| panic!("{path}: {fault}"))
}

pub(crate) fn refused(path: &str, arguments: Json) -> Fault {
    match asked(path, &arguments) {
        Ok(json) => panic!("{path} answered {json}"),
        Err(fault) => fault,
    }
}

pub(crate) fn number(json: &Json) -> f64 {
    json.as_f64().unwrap_or_else(|| panic!("{json} is no number"))
}

pub(crate) fn near(json: &Json, expected: f64) {
    let x = number(json);
    assert!((x - expected).abs() <= 1e-6 * expected.abs().max(1.0), "{x} is not {expected}");
}

pub(crate) fn at(json: &Json, expected: [f64; 3]) {
    let p = Point3::read(json).unwrap();
    assert!(p.distance_to(Point3::from(expected)) < 1e-6, "{p:?} is not {expected:?}");
}

pub(crate) fn curves(json: &Json) -> Vec<Curve> {
    Vec::read(json).unwrap()
}

pub(crate) fn circle(x: f64, radius: f64) -> Curve {
    Circle::new(Plane::XY.with_origin(Point3::new(x, 0.0, 0.0)), radius).unwrap().into()
}

pub(crate) fn c1() -> Json {
    object(&circle(0.0, 5.0))
}

pub(crate) fn c2() -> Json {
    object(&circle(3.0, 5.0))
}

pub(crate) fn line() -> Json {
    object(&Curve::from(Line::new(Point3::new(-10.0, 0.0, 0.0), Point3::new(10.0, 0.0, 0.0))))
}

pub(crate) fn ball(x: f64, radius: f64) -> Brep {
    construct::sphere(&Sphere::around(Point3::new(x, 0.0, 0.0), radius).unwrap()).unwrap()
}

pub(crate) fn cube() -> Box3 {
    BoundingBox { min: Point3::ORIGIN, max: Point3::new(1.0, 2.0, 3.0) }.into()
}

pub(crate) fn cube_brep() -> Json {
    object(&construct::box_brep(&cube()).unwrap())
}

pub(crate) fn cube_mesh() -> Json {
    object(&Mesh::cuboid(&cube(), 1, 1, 1).unwrap())
}

pub(crate) fn floor() -> Surface {
    PlaneSurface::new(Plane::XY, Interval::new(0.0, 4.0), Interval::new(0.0, 3.0)).unwrap().into()
}

pub(crate) fn square(size: f64) -> Json {
    json!([[0, 0, 0], [size, 0, 0], [size, size, 0], [0, size, 0], [0, 0, 0]])
}

/// The area between two circles of radius r whose centres are d apart, common to both.
pub(crate) fn lens(r: f64, d: f64) -> f64 {
    2.0 * r * r * (d / (2.0 * r)).acos() - 0.5 * d * (4.0 * r * r - d * d).sqrt()
}
