use katydid_geometry::Plane as Frame;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use super::repr::numbers;
use super::{Point, PointLike, Transform, Vector, VectorLike};
use crate::errors::kernel;

/// A plane with an origin and two axes of length 1 at right angles; the third, its normal, follows from them.
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Plane(pub(crate) Frame);

/// A plane; or a point, for the plane through it along the world's x and y; or nothing, for the world's xy plane.
pub(crate) struct PlaneLike(pub(crate) Frame);

impl<'a, 'py> FromPyObject<'a, 'py> for PlaneLike {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        if object.is_none() {
            return Ok(Self(Frame::XY));
        }
        if let Ok(plane) = object.cast::<Plane>() {
            return Ok(Self(plane.get().0));
        }
        match object.extract::<PointLike>() {
            Ok(point) => Ok(Self(Frame::XY.with_origin(point.0))),
            Err(_) => Err(PyTypeError::new_err("a plane or a point is expected")),
        }
    }
}

#[pymethods]
impl Plane {
    /// The plane at an origin along an x axis, with the y axis on the side of `y_axis`; or, where no axes are given,
    /// with a normal.
    #[new]
    #[pyo3(signature = (origin=None, x_axis=None, y_axis=None, *, normal=None))]
    fn new(
        origin: Option<PointLike>,
        x_axis: Option<VectorLike>,
        y_axis: Option<VectorLike>,
        normal: Option<VectorLike>,
    ) -> PyResult<Self> {
        let origin = origin.map_or(katydid_geometry::Point3::ORIGIN, |point| point.0);
        let plane = match (x_axis, y_axis, normal) {
            (Some(x), Some(y), None) => Frame::from_axes(origin, x.0, y.0).map_err(kernel)?,
            (None, None, Some(normal)) => Frame::from_normal(origin, normal.0).map_err(kernel)?,
            (None, None, None) => Frame::XY.with_origin(origin),
            _ => return Err(PyTypeError::new_err("a plane takes both its axes, or its normal alone")),
        };
        if !plane.is_finite() {
            return Err(kernel(katydid_geometry::Error::NotFinite("plane")));
        }
        Ok(Self(plane))
    }

    /// The world's xy plane.
    #[staticmethod]
    fn xy() -> Self {
        Self(Frame::XY)
    }

    /// The world's yz plane.
    #[staticmethod]
    fn yz() -> PyResult<Self> {
        use katydid_geometry::{Point3, Vector3};
        Frame::from_axes(Point3::ORIGIN, Vector3::Y, Vector3::Z).map(Self).map_err(kernel)
    }

    /// The world's zx plane.
    #[staticmethod]
    fn zx() -> PyResult<Self> {
        use katydid_geometry::{Point3, Vector3};
        Frame::from_axes(Point3::ORIGIN, Vector3::Z, Vector3::X).map(Self).map_err(kernel)
    }

    /// The plane through three points: the origin at the first, the x axis towards the second.
    #[staticmethod]
    fn from_points(a: PointLike, b: PointLike, c: PointLike) -> PyResult<Self> {
        Frame::from_points(a.0, b.0, c.0).map(Self).map_err(kernel)
    }

    /// The plane with the least squares of distances from points, an array of shape (n, 3), and the largest distance.
    #[staticmethod]
    fn fit(points: &Bound<'_, PyAny>) -> PyResult<(Self, f64)> {
        let points = crate::arrays::points_in(points)?;
        Frame::fit(&points).map(|(plane, distance)| (Self(plane), distance)).map_err(kernel)
    }

    /// The origin.
    #[getter]
    fn origin(&self) -> Point {
        Point(self.0.origin)
    }

    /// The first axis.
    #[getter]
    fn x_axis(&self) -> Vector {
        Vector(self.0.x_axis)
    }

    /// The second axis.
    #[getter]
    fn y_axis(&self) -> Vector {
        Vector(self.0.y_axis)
    }

    /// The normal.
    #[getter]
    fn normal(&self) -> Vector {
        Vector(self.0.z_axis)
    }

    /// The point at coordinates along the axes.
    #[pyo3(signature = (u, v, w=0.0))]
    fn point_at(&self, u: f64, v: f64, w: f64) -> Point {
        Point(self.0.at(u, v, w))
    }

    /// The coordinates of a point along the three axes.
    fn coordinates(&self, point: PointLike) -> (f64, f64, f64) {
        self.0.coordinates(point.0).into()
    }

    /// The distance of a point from the plane, positive on the side of the normal.
    fn signed_distance(&self, point: PointLike) -> f64 {
        self.0.signed_distance(point.0)
    }

    /// The point of the plane nearest to a point.
    fn closest_point(&self, point: PointLike) -> Point {
        Point(self.0.closest_point(point.0))
    }

    /// The plane with its normal the other way.
    fn flipped(&self) -> Self {
        Self(self.0.flipped())
    }

    /// The plane turned about its normal by an angle in radians.
    fn rotated(&self, angle: f64) -> Self {
        Self(self.0.rotated(angle))
    }

    /// The plane moved along its normal.
    fn offset(&self, distance: f64) -> Self {
        Self(self.0.offset(distance))
    }

    /// The plane under a transform.
    fn transformed(&self, transform: &Transform) -> PyResult<Self> {
        self.0.transformed(&transform.0).map(Self).map_err(kernel)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get() == self)
    }

    fn __hash__(&self, py: Python<'_>) -> PyResult<isize> {
        pyo3::types::PyTuple::new(py, self.row())?.hash()
    }

    fn __repr__(&self) -> String {
        let [o, x, y, _] = self.parts();
        format!("Plane(({}), ({}), ({}))", numbers(o), numbers(x), numbers(y))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Vec<f64>,))> {
        // Its axes come back to the last bit, which those of `Plane(...)` need not.
        Ok((py.get_type::<Self>().getattr("_of_numbers")?, (self.row(),)))
    }

    #[staticmethod]
    fn _of_numbers(numbers: [f64; 12]) -> Self {
        let v = |k: usize| {
            let at = |i: usize| numbers.get(3 * k + i).copied().unwrap_or(f64::NAN);
            katydid_geometry::Vector3::new(at(0), at(1), at(2))
        };
        Self(Frame { origin: v(0).to_point(), x_axis: v(1), y_axis: v(2), z_axis: v(3) })
    }
}

impl Plane {
    fn parts(&self) -> [[f64; 3]; 4] {
        let Frame { origin: o, x_axis: x, y_axis: y, z_axis: z } = self.0;
        [[o.x, o.y, o.z], [x.x, x.y, x.z], [y.x, y.y, y.z], [z.x, z.y, z.z]]
    }

    fn row(&self) -> Vec<f64> {
        self.parts().concat()
    }
}
