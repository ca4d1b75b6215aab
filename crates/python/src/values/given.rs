//! Python's values as those of a definition.

use katydid_data::{Colour as DataColour, Column, Complex, DateTime, Items, Kind, Path, Tree as Data, Value};
use katydid_geometry::{Interval as Range, Point3};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyComplex, PyDict, PyFloat, PyInt, PyString, PyTuple};

use super::{Colour, Item, Tree};
use crate::arrays::{is_array, points_in};
use crate::geometry::{Box, Brep, Curve, Interval, Mesh, Plane, Point, SubD, Surface, Transform, Vector};

/// How deep lists may lie in lists: a path is no longer.
const DEPTH: usize = 16;

/// A Python object as the data of an input that takes a kind of values.
///
/// A tree is a `Tree`, or a dict of lists by paths. An array or a list is one branch; a list of lists is a branch for
/// each. Anything else is one item. Where points or vectors are asked for, three numbers are one.
pub(crate) fn given(object: &Bound<'_, PyAny>, kind: Kind) -> PyResult<Data> {
    if let Ok(tree) = object.cast::<Tree>() {
        return Ok(tree.get().0.clone());
    }
    if let Ok(branches) = object.cast::<PyDict>() {
        let mut parts = Vec::with_capacity(branches.len());
        for (path, items) in branches {
            parts.push((super::tree::path(&path)?, column(&items, kind)?));
        }
        parts.sort_by(|a, b| a.0.cmp(&b.0));
        return Ok(joined(&parts));
    }
    let mut parts = Vec::new();
    branches(object, kind, &mut Vec::new(), &mut parts)?;
    Ok(joined(&parts))
}

/// One tree of branches.
fn joined(parts: &[(Path, Column)]) -> Data {
    if let [(path, column)] = parts {
        return Data::branch_at(path.clone(), column.clone());
    }
    let trees: Vec<Data> =
        parts.iter().map(|(path, column)| Data::branch_at(path.clone(), column.clone())).collect();
    Data::merge(trees.iter())
}

/// The branches of lists in lists, each at the places that lead to it.
fn branches(
    object: &Bound<'_, PyAny>,
    kind: Kind,
    at: &mut Vec<i32>,
    parts: &mut Vec<(Path, Column)>,
) -> PyResult<()> {
    if at.len() > DEPTH {
        return Err(PyValueError::new_err(format!("lists lie more than {DEPTH} deep in lists")));
    }
    if !is_array(object) && is_list(object) && !is_point(object, kind) {
        let mut lists = Vec::new();
        for inner in object.try_iter()? {
            let inner = inner?;
            if !(is_list(&inner) || is_array(&inner)) || is_point(&inner, kind) {
                lists.clear();
                break;
            }
            lists.push(inner);
        }
        if !lists.is_empty() {
            for (place, inner) in lists.iter().enumerate() {
                at.push(i32::try_from(place).map_err(|_| crate::errors::too_large(place))?);
                branches(inner, kind, at, parts)?;
                at.pop();
            }
            return Ok(());
        }
    } else if is_array(object) && !takes_rows(object, kind)? {
        // An array of more dimensions has a branch for each of its rows.
        for (place, row) in object.try_iter()?.enumerate() {
            at.push(i32::try_from(place).map_err(|_| crate::errors::too_large(place))?);
            branches(&row?, kind, at, parts)?;
            at.pop();
        }
        return Ok(());
    }
    let path = if at.is_empty() { Path::zero() } else { Path::from(at.as_slice()) };
    parts.push((path, column(object, kind)?));
    Ok(())
}

/// Whether an array is one branch: numbers in a row, or points in rows of three where points are taken.
fn takes_rows(array: &Bound<'_, PyAny>, kind: Kind) -> PyResult<bool> {
    let shape: Vec<usize> = array.getattr("shape")?.extract()?;
    Ok(match shape.as_slice() {
        [] | [_] => true,
        [_, 3] => !is_number(kind),
        _ => false,
    })
}

/// Whether inputs of a kind take numbers, so that rows of three are no points.
fn is_number(kind: Kind) -> bool {
    matches!(kind, Kind::Number | Kind::Integer | Kind::Boolean | Kind::Text | Kind::Complex)
}

/// A list or a tuple.
fn is_list(object: &Bound<'_, PyAny>) -> bool {
    object.is_instance_of::<pyo3::types::PyList>() || object.is_instance_of::<PyTuple>()
}

/// Three numbers where a point is asked for, two where a range is.
fn is_point(object: &Bound<'_, PyAny>, kind: Kind) -> bool {
    match kind {
        Kind::Point | Kind::Vector | Kind::Plane => object.extract::<[f64; 3]>().is_ok(),
        Kind::Domain => object.extract::<[f64; 2]>().is_ok(),
        _ => false,
    }
}

/// One branch.
fn column(object: &Bound<'_, PyAny>, kind: Kind) -> PyResult<Column> {
    if is_array(object) {
        return array(object, kind);
    }
    if !is_list(object) || is_point(object, kind) {
        return Ok(Column::of_options(vec![value(object, kind)?]));
    }
    let items = object.try_iter()?.map(|item| value(&item?, kind)).collect::<PyResult<Vec<_>>>()?;
    Ok(Column::of_options(items))
}

/// An array of numbers, truth values or texts in a row, or of points in rows of three.
fn array(object: &Bound<'_, PyAny>, kind: Kind) -> PyResult<Column> {
    let dimensions: usize = object.getattr("ndim")?.extract()?;
    if dimensions == 0 {
        return column(&object.call_method0("item")?, kind);
    }
    if dimensions == 2 {
        let points = points_in(object)?;
        if kind == Kind::Vector {
            return Ok(Column::new(
                Items::Vectors(points.into_iter().map(Point3::to_vector).collect::<Vec<_>>().into()),
                None,
            ));
        }
        return Ok(Column::new(Items::Points(points.into()), None));
    }
    let letter: String = object.getattr("dtype")?.getattr("kind")?.extract()?;
    match letter.as_str() {
        "f" => Ok(Column::new(Items::Numbers(crate::arrays::numbers_in(object)?.into()), None)),
        _ => column(&object.call_method0("tolist")?, kind),
    }
}

/// One item; none for `None`.
fn value(object: &Bound<'_, PyAny>, kind: Kind) -> PyResult<Option<Value>> {
    if object.is_none() {
        return Ok(None);
    }
    if let Some(value) = plain(object)? {
        return Ok(Some(value));
    }
    if let Some(value) = geometry(object)? {
        return Ok(Some(value));
    }
    if let (Kind::Domain, Ok([a, b])) = (kind, object.extract::<[f64; 2]>()) {
        return Ok(Some(Value::Domain(Range::new(a, b))));
    }
    if let Ok([x, y, z]) = object.extract::<[f64; 3]>() {
        let point = Point3::new(x, y, z);
        return Ok(Some(if kind == Kind::Vector {
            Value::Vector(point.to_vector())
        } else {
            Value::Point(point)
        }));
    }
    match foreign(object)? {
        Some(value) => Ok(Some(value)),
        None => {
            let name = object.get_type().name()?;
            Err(PyTypeError::new_err(format!("a {name} is nothing that a definition takes")))
        }
    }
}

/// What needs no class of ours.
fn plain(object: &Bound<'_, PyAny>) -> PyResult<Option<Value>> {
    if object.is_instance_of::<PyBool>() {
        return Ok(Some(Value::Boolean(object.extract()?)));
    }
    if object.is_instance_of::<PyInt>() {
        // A definition counts with 32 bits; what is more is a number.
        return Ok(Some(match object.extract::<i32>() {
            Ok(whole) => Value::Integer(whole),
            Err(_) => Value::Number(object.extract()?),
        }));
    }
    if object.is_instance_of::<PyFloat>() {
        return Ok(Some(Value::Number(object.extract()?)));
    }
    if object.is_instance_of::<PyString>() {
        return Ok(Some(Value::text(object.extract::<String>()?)));
    }
    if let Ok(z) = object.cast::<PyComplex>() {
        use pyo3::types::PyComplexMethods;
        return Ok(Some(Value::Complex(Complex { re: z.real(), im: z.imag() })));
    }
    Ok(None)
}

/// Classes of this package.
fn geometry(object: &Bound<'_, PyAny>) -> PyResult<Option<Value>> {
    macro_rules! first {
        ($($class:ty, |$thing:ident| $value:expr;)*) => {
            $(if let Ok($thing) = object.cast::<$class>() {
                let $thing = $thing.get();
                return Ok(Some($value));
            })*
        };
    }
    first! {
        Point, |point| Value::Point(point.0);
        Vector, |vector| Value::Vector(vector.0);
        Plane, |plane| Value::from(plane.0);
        Interval, |range| Value::Domain(range.0);
        Box, |shape| Value::from(shape.0);
        Curve, |curve| Value::Curve(curve.0.clone());
        Surface, |surface| Value::Surface(surface.0.clone());
        Brep, |brep| Value::from_shared_brep(brep.0.clone());
        Mesh, |mesh| Value::Mesh(mesh.0.clone());
        SubD, |subd| crate::geometry::subd_value(&subd.0)?;
        Transform, |xform| Value::from(xform.0);
        Colour, |colour| Value::Colour(DataColour { ..colour.0 });
        Item, |item| item.0.clone();
    }
    Ok(None)
}

/// Numbers of NumPy, identifiers, moments.
fn foreign(object: &Bound<'_, PyAny>) -> PyResult<Option<Value>> {
    let class = object.get_type();
    let (module, name) = (class.module()?.to_string(), class.name()?.to_string());
    match (module.as_str(), name.as_str()) {
        ("uuid", "UUID") => {
            let id = uuid::Uuid::parse_str(&object.str()?.to_string());
            Ok(id.ok().map(Value::Guid))
        }
        ("datetime", "datetime") => {
            let datetime = object.py().import("datetime")?;
            let first = datetime.getattr("datetime")?.getattr("min")?;
            let passed =
                object.call_method1("replace", pyo3::types::PyTuple::empty(object.py()))?.sub(first)?;
            let step = datetime.getattr("timedelta")?.call1((0, 0, 1))?;
            let microseconds: i64 = passed.floor_div(step)?.extract()?;
            Ok(microseconds.checked_mul(10).map(|ticks| Value::Time(DateTime { ticks })))
        }
        ("numpy", _) if object.hasattr("item")? => plain(&object.call_method0("item")?),
        _ => Ok(None),
    }
}
