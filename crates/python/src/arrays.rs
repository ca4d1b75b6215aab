//! Arrays in and out: NumPy's where NumPy is installed, else lists and tuples.

use std::sync::OnceLock;

use katydid_geometry::{Point3, Vector3};
use numpy::{
    PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArray,
    PyUntypedArrayMethods,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyList;

use crate::geometry::{Point, PointLike};

/// Whether NumPy can be had. Its interface must not be asked for where it cannot.
pub(crate) fn has_numpy(py: Python<'_>) -> bool {
    static THERE: OnceLock<bool> = OnceLock::new();
    match THERE.get() {
        Some(there) => *there,
        None => {
            let there = py.import("numpy").is_ok();
            *THERE.get_or_init(|| there)
        }
    }
}

/// Whether an object is an array of NumPy's, without importing NumPy for it.
pub(crate) fn is_array(object: &Bound<'_, PyAny>) -> bool {
    let loaded = || object.py().import("sys")?.getattr("modules")?.contains("numpy");
    loaded().unwrap_or(false) && has_numpy(object.py()) && object.cast::<PyUntypedArray>().is_ok()
}

/// Numbers as an array of shape (n,).
pub(crate) fn numbers_out<'py>(py: Python<'py>, numbers: &[f64]) -> PyResult<Bound<'py, PyAny>> {
    if has_numpy(py) {
        return Ok(PyArray1::from_slice(py, numbers).into_any());
    }
    Ok(PyList::new(py, numbers)?.into_any())
}

/// Whole numbers as an array of shape (n,).
pub(crate) fn integers_out<'py>(py: Python<'py>, numbers: &[i32]) -> PyResult<Bound<'py, PyAny>> {
    if has_numpy(py) {
        return Ok(PyArray1::from_slice(py, numbers).into_any());
    }
    Ok(PyList::new(py, numbers)?.into_any())
}

/// Truth values as an array of shape (n,).
pub(crate) fn booleans_out<'py>(py: Python<'py>, flags: &[bool]) -> PyResult<Bound<'py, PyAny>> {
    if has_numpy(py) {
        return Ok(PyArray1::from_slice(py, flags).into_any());
    }
    Ok(PyList::new(py, flags)?.into_any())
}

/// Rows of numbers as an array of shape (n, N): one copy.
pub(crate) fn rows_out<'py, const N: usize, T: numpy::Element + Copy>(
    py: Python<'py>,
    count: usize,
    rows: impl Iterator<Item = [T; N]>,
) -> PyResult<Bound<'py, PyAny>> {
    let array = PyArray2::<T>::zeros(py, [count, N], false);
    {
        let mut places = array.readwrite();
        let places = places.as_slice_mut().map_err(|error| PyValueError::new_err(error.to_string()))?;
        for (place, row) in places.chunks_exact_mut(N).zip(rows) {
            place.copy_from_slice(&row);
        }
    }
    Ok(array.into_any())
}

/// Points as an array of shape (n, 3).
pub(crate) fn points_out<'py>(py: Python<'py>, points: &[Point3]) -> PyResult<Bound<'py, PyAny>> {
    if has_numpy(py) {
        return rows_out(py, points.len(), points.iter().map(|p| [p.x, p.y, p.z]));
    }
    Ok(PyList::new(py, points.iter().map(|p| Point(*p)))?.into_any())
}

/// Vectors as an array of shape (n, 3).
pub(crate) fn vectors_out<'py>(py: Python<'py>, vectors: &[Vector3]) -> PyResult<Bound<'py, PyAny>> {
    if has_numpy(py) {
        return rows_out(py, vectors.len(), vectors.iter().map(|v| [v.x, v.y, v.z]));
    }
    Ok(PyList::new(py, vectors.iter().map(|v| crate::geometry::Vector(*v)))?.into_any())
}

/// An array of doubles that lies in one piece, of what is an array of any numbers.
fn as_doubles<'py>(object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    object.py().import("numpy")?.call_method1("ascontiguousarray", (object, "float64"))
}

/// Numbers, from an array or any sequence.
pub(crate) fn numbers_in(object: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    if is_array(object) {
        let array = as_doubles(object)?;
        let array = array.cast::<PyArrayDyn<f64>>()?;
        if array.ndim() != 1 {
            let shape = array.shape();
            return Err(PyValueError::new_err(format!("an array of shape (n,) is expected, not {shape:?}")));
        }
        let array: PyReadonlyArray1<'_, f64> = array.extract()?;
        return Ok(array.as_slice().map_err(|error| PyValueError::new_err(error.to_string()))?.to_vec());
    }
    object
        .extract()
        .map_err(|_| PyTypeError::new_err("numbers are expected: an array of shape (n,), or a list"))
}

/// Rows of `N` numbers from an array of shape (n, N), each made into what it stands for: one copy. None for what is no
/// array.
pub(crate) fn rows_in<const N: usize, T>(
    object: &Bound<'_, PyAny>,
    make: impl Fn([f64; N]) -> T,
) -> PyResult<Option<Vec<T>>> {
    if !is_array(object) {
        return Ok(None);
    }
    let array = as_doubles(object)?;
    let array = array.cast::<PyArrayDyn<f64>>()?;
    if array.ndim() != 2 || array.shape().get(1) != Some(&N) {
        let shape = array.shape();
        return Err(PyValueError::new_err(format!("an array of shape (n, {N}) is expected, not {shape:?}")));
    }
    let array: PyReadonlyArray2<'_, f64> = array.extract()?;
    let numbers = array.as_slice().map_err(|error| PyValueError::new_err(error.to_string()))?;
    let (rows, _) = numbers.as_chunks::<N>();
    Ok(Some(rows.iter().map(|row| make(*row)).collect()))
}

/// Points, from an array of shape (n, 3) or any sequence of points.
pub(crate) fn points_in(object: &Bound<'_, PyAny>) -> PyResult<Vec<Point3>> {
    if let Some(points) = rows_in(object, |[x, y, z]| Point3::new(x, y, z))? {
        return Ok(points);
    }
    let points: Vec<PointLike> = object.extract().map_err(|_| {
        PyTypeError::new_err("points are expected: an array of shape (n, 3), or a list of points")
    })?;
    Ok(points.into_iter().map(|point| point.0).collect())
}

/// Pairs of parameters, from an array of shape (n, 2) or any sequence of pairs.
pub(crate) fn pairs_in(object: &Bound<'_, PyAny>) -> PyResult<Vec<[f64; 2]>> {
    if let Some(pairs) = rows_in(object, |pair: [f64; 2]| pair)? {
        return Ok(pairs);
    }
    let pairs: Vec<(f64, f64)> = object.extract().map_err(|_| {
        PyTypeError::new_err("pairs are expected: an array of shape (n, 2), or a list of pairs")
    })?;
    Ok(pairs.into_iter().map(|(u, v)| [u, v]).collect())
}
