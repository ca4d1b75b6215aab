use katydid_geometry::Point3;
use pyo3::exceptions::{PyIndexError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use super::repr::numbers;
use super::{Transform, Vector, VectorLike};

/// A location in space: three coordinates in model units.
///
/// Wherever a point is asked for, any three numbers will do: a tuple, a list, a row of an array.
#[pyclass(frozen, sequence, from_py_object, module = "katydid")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Point(pub(crate) Point3);

/// A point, or any three numbers.
pub(crate) struct PointLike(pub(crate) Point3);

impl<'a, 'py> FromPyObject<'a, 'py> for PointLike {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(point) = object.cast::<Point>() {
            return Ok(Self(point.get().0));
        }
        three(&object).map(|[x, y, z]| Self(Point3::new(x, y, z))).ok_or_else(|| not("point", &object))
    }
}

/// Three numbers of a sequence.
pub(crate) fn three(object: &Bound<'_, PyAny>) -> Option<[f64; 3]> {
    if let Ok(three) = object.extract::<(f64, f64, f64)>() {
        return Some(three.into());
    }
    object.extract::<[f64; 3]>().ok()
}

/// The error for an object of another type.
pub(crate) fn not(what: &str, object: &Bound<'_, PyAny>) -> PyErr {
    let name = object.get_type().name().map_or_else(|_| "?".to_owned(), |name| name.to_string());
    PyTypeError::new_err(format!("a {what} or three numbers are expected, not {name}"))
}

#[pymethods]
impl Point {
    /// The point at three coordinates.
    #[new]
    #[pyo3(signature = (x=0.0, y=0.0, z=0.0))]
    fn new(x: f64, y: f64, z: f64) -> Self {
        Self(Point3::new(x, y, z))
    }

    /// The first coordinate.
    #[getter]
    fn x(&self) -> f64 {
        self.0.x
    }

    /// The second coordinate.
    #[getter]
    fn y(&self) -> f64 {
        self.0.y
    }

    /// The third coordinate.
    #[getter]
    fn z(&self) -> f64 {
        self.0.z
    }

    /// The distance to another point.
    fn distance_to(&self, other: PointLike) -> f64 {
        self.0.distance_to(other.0)
    }

    /// The point at `t` on the way to another one: this one at 0, the other at 1.
    fn lerp(&self, other: PointLike, t: f64) -> Self {
        Self(self.0.lerp(other.0, t))
    }

    /// The point under a transform.
    fn transformed(&self, transform: &Transform) -> Self {
        Self(transform.0.point(self.0))
    }

    fn __add__(&self, vector: VectorLike) -> Self {
        Self(self.0 + vector.0)
    }

    fn __sub__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = other.py();
        if let Ok(vector) = other.cast::<Vector>() {
            return Ok(Bound::new(py, Self(self.0 - vector.get().0))?.into_any());
        }
        let point: PointLike = other.extract()?;
        Ok(Bound::new(py, Vector(self.0 - point.0))?.into_any())
    }

    fn __len__(&self) -> usize {
        3
    }

    fn __getitem__(&self, index: isize) -> PyResult<f64> {
        coordinate([self.0.x, self.0.y, self.0.z], index)
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        PyTuple::new(py, [self.0.x, self.0.y, self.0.z])?.call_method0("__iter__")
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get() == self)
    }

    fn __hash__(&self, py: Python<'_>) -> PyResult<isize> {
        PyTuple::new(py, [self.0.x, self.0.y, self.0.z])?.hash()
    }

    fn __repr__(&self) -> String {
        format!("Point({})", numbers([self.0.x, self.0.y, self.0.z]))
    }

    fn __getnewargs__(&self) -> (f64, f64, f64) {
        (self.0.x, self.0.y, self.0.z)
    }
}

/// One of three coordinates, from the end for a negative index.
pub(crate) fn coordinate(all: [f64; 3], index: isize) -> PyResult<f64> {
    let place = if index < 0 { index + 3 } else { index };
    let found = usize::try_from(place).ok().and_then(|place| all.get(place));
    found.copied().ok_or_else(|| PyIndexError::new_err("a point and a vector have three coordinates"))
}
