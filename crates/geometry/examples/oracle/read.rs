//! Kernel values out of the files.

use katydid_geometry::{
    BoundingBox, Interval, Line, NurbsCurve, NurbsSurface, Plane, Point3, Vector3, Xform,
};
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

pub(crate) fn integer(v: &Value) -> Read<usize> {
    v.as_u64().and_then(|x| usize::try_from(x).ok()).map_or_else(|| wrong("an integer", v), Ok)
}

pub(crate) fn truth(v: &Value) -> Read<bool> {
    v.as_bool().map_or_else(|| wrong("true or false", v), Ok)
}

pub(crate) fn text(v: &Value) -> Read<&str> {
    v.as_str().map_or_else(|| wrong("a text", v), Ok)
}

pub(crate) fn list(v: &Value) -> Read<&Vec<Value>> {
    v.as_array().map_or_else(|| wrong("a list", v), Ok)
}

pub(crate) fn numbers(v: &Value) -> Read<Vec<f64>> {
    list(v)?.iter().map(number).collect()
}

/// A point of two or three coordinates.
pub(crate) fn point(v: &Value) -> Read<Point3> {
    match *numbers(v)?.as_slice() {
        [x, y] => Ok(Point3::new(x, y, 0.0)),
        [x, y, z] => Ok(Point3::new(x, y, z)),
        _ => wrong("a point", v),
    }
}

pub(crate) fn vector(v: &Value) -> Read<Vector3> {
    point(v).map(Point3::to_vector)
}

pub(crate) fn vectors(v: &Value) -> Read<Vec<Vector3>> {
    list(v)?.iter().map(vector).collect()
}

pub(crate) fn interval(v: &Value) -> Read<Interval> {
    match *numbers(v)?.as_slice() {
        [a, b] => Ok(Interval::new(a, b)),
        _ => wrong("an interval", v),
    }
}

pub(crate) fn line(v: &Value) -> Read<Line> {
    Ok(Line::new(point(&v[0])?, point(&v[1])?))
}

pub(crate) fn plane(v: &Value) -> Read<Plane> {
    Ok(Plane {
        origin: point(&v[0])?,
        x_axis: vector(&v[1])?,
        y_axis: vector(&v[2])?,
        z_axis: vector(&v[3])?,
    })
}

/// Six numbers: the smallest corner, then the largest.
pub(crate) fn bounding_box(v: &Value) -> Read<BoundingBox> {
    match *numbers(v)?.as_slice() {
        [a, b, c, d, e, f] => Ok(BoundingBox { min: Point3::new(a, b, c), max: Point3::new(d, e, f) }),
        _ => wrong("a box", v),
    }
}

/// Sixteen numbers, row by row.
pub(crate) fn xform(v: &Value) -> Read<Xform> {
    let n = numbers(v)?;
    if n.len() != 16 {
        return wrong("a 4×4 matrix", v);
    }
    Ok(Xform { rows: std::array::from_fn(|i| std::array::from_fn(|j| n[4 * i + j])) })
}

/// Control points in homogeneous form; those of plane curves get z = 0.
pub(crate) fn controls(v: &Value) -> Read<Vec<[f64; 4]>> {
    let (dimension, rational) = (integer(&v["dim"])?, integer(&v["rat"])? == 1);
    list(&v["cv"])?
        .iter()
        .map(|cv| match (dimension, rational, numbers(cv)?.as_slice()) {
            (2, false, &[x, y]) => Ok([x, y, 0.0, 1.0]),
            (2, true, &[x, y, w]) => Ok([x, y, 0.0, w]),
            (3, false, &[x, y, z]) => Ok([x, y, z, 1.0]),
            (3, true, &[x, y, z, w]) => Ok([x, y, z, w]),
            _ => wrong("a control point", cv),
        })
        .collect()
}

pub(crate) fn curve(v: &Value) -> Read<NurbsCurve> {
    let degree = integer(&v["order"])?.saturating_sub(1);
    let (points, knots) = (controls(v)?, numbers(&v["knots"])?);
    let made = if integer(&v["rat"])? == 1 {
        NurbsCurve::rational(degree, points, knots)
    } else {
        let points = points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
        NurbsCurve::new(degree, points, knots)
    };
    made.map_err(|e| e.to_string())
}

/// Orders, knots and counts in pairs, for u and for v; control points with v running fastest.
pub(crate) fn surface(v: &Value) -> Read<NurbsSurface> {
    let pair = |v: &Value| Ok::<_, String>([integer(&v[0])?, integer(&v[1])?]);
    let degrees = pair(&v["order"])?.map(|o| o.saturating_sub(1));
    let knots = [numbers(&v["knots"][0])?, numbers(&v["knots"][1])?];
    let points = controls(v)?;
    let made = if integer(&v["rat"])? == 1 {
        NurbsSurface::rational(degrees, pair(&v["n"])?, points, knots)
    } else {
        let points = points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
        NurbsSurface::new(degrees, pair(&v["n"])?, points, knots)
    };
    made.map_err(|e| e.to_string())
}
