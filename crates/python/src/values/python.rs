//! Values of a definition as Python's.

use std::sync::Arc;

use katydid_data::{Column, Items, Value};
use katydid_geometry::Curve as KernelCurve;
use pyo3::prelude::*;
use pyo3::types::{PyComplex, PyList, PyTuple};

use super::{Colour, Item};
use crate::arrays::{booleans_out, integers_out, numbers_out, points_out, vectors_out};
use crate::geometry::{Box, Brep, Curve, Interval, Mesh, Plane, Point, SubD, Surface, Transform, Vector};

/// A value as Python has it; `None` for none.
pub(crate) fn to_python<'py>(py: Python<'py>, value: Option<&Value>) -> PyResult<Bound<'py, PyAny>> {
    let Some(value) = value else { return Ok(py.None().into_bound(py)) };
    let curve = |curve: KernelCurve| PyResult::Ok(Bound::new(py, Curve::from(curve))?.into_any());
    Ok(match value {
        Value::Boolean(flag) => flag.into_pyobject(py)?.to_owned().into_any(),
        Value::Integer(whole) => whole.into_pyobject(py)?.into_any(),
        Value::Number(x) => x.into_pyobject(py)?.into_any(),
        Value::Complex(z) => PyComplex::from_doubles(py, z.re, z.im).into_any(),
        Value::Text(text) => (**text).into_pyobject(py)?.into_any(),
        Value::Colour(colour) => Bound::new(py, Colour(*colour))?.into_any(),
        Value::Time(moment) => moment_to_python(py, moment.ticks)?,
        Value::Guid(id) => py.import("uuid")?.getattr("UUID")?.call1((id.to_string(),))?,
        Value::Domain(range) => Bound::new(py, Interval(*range))?.into_any(),
        Value::Path(path) => PyTuple::new(py, path.elements())?.into_any(),
        Value::Point(point) => Bound::new(py, Point(*point))?.into_any(),
        Value::Vector(vector) => Bound::new(py, Vector(*vector))?.into_any(),
        Value::Plane(plane) => Bound::new(py, Plane(**plane))?.into_any(),
        Value::Line(line) => curve((**line).into())?,
        Value::Circle(circle) => curve((**circle).into())?,
        Value::Arc(arc) => curve((**arc).into())?,
        Value::Rectangle(rectangle) => match rectangle.to_polyline() {
            Ok(polyline) => curve(polyline.into())?,
            Err(_) => opaque(py, value)?,
        },
        Value::Box(shape) => Bound::new(py, Box(**shape))?.into_any(),
        Value::Curve(curve) => Bound::new(py, Curve(curve.clone()))?.into_any(),
        Value::Surface(surface) => Bound::new(py, Surface(surface.clone()))?.into_any(),
        Value::Brep(brep) => Bound::new(py, Brep(brep.clone()))?.into_any(),
        Value::Mesh(mesh) => Bound::new(py, Mesh(mesh.clone()))?.into_any(),
        Value::Transform(_) | Value::Compound(_) => match value.as_transform() {
            Some(xform) => Bound::new(py, Transform(xform))?.into_any(),
            None => opaque(py, value)?,
        },
        Value::Kept(_) => kept(py, value)?,
        _ => opaque(py, value)?,
    })
}

fn opaque<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(Bound::new(py, Item(value.clone()))?.into_any())
}

/// Geometry that is kept as it was written, as what can be made of it.
fn kept<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    if let Some(Ok(subd)) = value.subd() {
        return Ok(Bound::new(py, SubD(Arc::new(subd)))?.into_any());
    }
    match value.brep() {
        Some(Ok(brep)) => Ok(Bound::new(py, Brep(brep))?.into_any()),
        _ => opaque(py, value),
    }
}

/// A moment, which .NET counts in steps of 100 ns from the year 1 on, as a datetime; what is less than a microsecond is cut.
fn moment_to_python(py: Python<'_>, ticks: i64) -> PyResult<Bound<'_, PyAny>> {
    let datetime = py.import("datetime")?;
    let first = datetime.getattr("datetime")?.getattr("min")?;
    let passed = datetime.getattr("timedelta")?.call1((0, 0, ticks / 10))?;
    first.add(passed)
}

/// A column: numbers, whole numbers, truth values, points and vectors without gaps as an array, all else as a list.
pub(crate) fn column_to_python<'py>(
    py: Python<'py>,
    column: &Column,
    range: std::ops::Range<usize>,
) -> PyResult<Bound<'py, PyAny>> {
    if !column.has_nulls() {
        match column.items() {
            Items::Numbers(all) => return numbers_out(py, all.get(range).unwrap_or_default()),
            Items::Integers(all) => return integers_out(py, all.get(range).unwrap_or_default()),
            Items::Booleans(all) => return booleans_out(py, all.get(range).unwrap_or_default()),
            Items::Points(all) => return points_out(py, all.get(range).unwrap_or_default()),
            Items::Vectors(all) => return vectors_out(py, all.get(range).unwrap_or_default()),
            _ => {}
        }
    }
    let items = PyList::empty(py);
    for place in range {
        items.append(to_python(py, column.get(place).as_ref())?)?;
    }
    Ok(items.into_any())
}
