use katydid_geometry::Vector3;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use super::point::{coordinate, not, three};
use super::repr::numbers;
use super::{Point, Transform};
use crate::errors::GeometryError;

/// A direction with a length: three coordinates in model units.
///
/// Wherever a vector is asked for, any three numbers will do.
#[pyclass(frozen, sequence, from_py_object, module = "katydid")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Vector(pub(crate) Vector3);

/// A vector, or any three numbers.
pub(crate) struct VectorLike(pub(crate) Vector3);

impl<'a, 'py> FromPyObject<'a, 'py> for VectorLike {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(vector) = object.cast::<Vector>() {
            return Ok(Self(vector.get().0));
        }
        if object.cast::<Point>().is_ok() {
            return Err(not("vector", &object));
        }
        three(&object).map(|[x, y, z]| Self(Vector3::new(x, y, z))).ok_or_else(|| not("vector", &object))
    }
}

#[pymethods]
impl Vector {
    /// The vector with three coordinates.
    #[new]
    #[pyo3(signature = (x=0.0, y=0.0, z=0.0))]
    fn new(x: f64, y: f64, z: f64) -> Self {
        Self(Vector3::new(x, y, z))
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

    /// The length.
    #[getter]
    fn length(&self) -> f64 {
        self.0.length()
    }

    /// The vector of length 1 in the same direction.
    fn unitized(&self) -> PyResult<Self> {
        self.0
            .unitized()
            .map(Self)
            .ok_or_else(|| GeometryError::new_err("a vector without length has no direction"))
    }

    /// The scalar product.
    fn dot(&self, other: VectorLike) -> f64 {
        self.0.dot(other.0)
    }

    /// The vector product: perpendicular to both, by the right-hand rule.
    fn cross(&self, other: VectorLike) -> Self {
        Self(self.0.cross(other.0))
    }

    /// The angle to another vector in radians, from 0 to π.
    fn angle_to(&self, other: VectorLike) -> PyResult<f64> {
        let angle = self.0.angle_to(other.0);
        angle.ok_or_else(|| GeometryError::new_err("a vector without length has no angle"))
    }

    /// The vector turned about an axis by an angle in radians, by the right-hand rule.
    fn rotated(&self, angle: f64, axis: VectorLike) -> PyResult<Self> {
        let turned = self.0.rotated(angle, axis.0).map(Self);
        turned.ok_or_else(|| GeometryError::new_err("an axis without length has no direction"))
    }

    /// The vector under the linear part of a transform.
    fn transformed(&self, transform: &Transform) -> Self {
        Self(transform.0.vector(self.0))
    }

    fn __add__<'py>(&self, other: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = other.py();
        if let Ok(point) = other.cast::<Point>() {
            return Ok(Bound::new(py, Point(point.get().0 + self.0))?.into_any());
        }
        let other: VectorLike = other.extract()?;
        Ok(Bound::new(py, Self(self.0 + other.0))?.into_any())
    }

    fn __sub__(&self, other: VectorLike) -> Self {
        Self(self.0 - other.0)
    }

    fn __mul__(&self, factor: f64) -> Self {
        Self(self.0 * factor)
    }

    fn __rmul__(&self, factor: f64) -> Self {
        Self(self.0 * factor)
    }

    fn __truediv__(&self, divisor: f64) -> PyResult<Self> {
        if divisor == 0.0 {
            return Err(pyo3::exceptions::PyZeroDivisionError::new_err("a vector is divided by zero"));
        }
        Ok(Self(self.0 * (1.0 / divisor)))
    }

    fn __neg__(&self) -> Self {
        Self(self.0 * -1.0)
    }

    fn __abs__(&self) -> f64 {
        self.0.length()
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
        format!("Vector({})", numbers([self.0.x, self.0.y, self.0.z]))
    }

    fn __getnewargs__(&self) -> (f64, f64, f64) {
        (self.0.x, self.0.y, self.0.z)
    }
}
