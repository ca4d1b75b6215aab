use katydid_geometry::{BoundingBox as Bounds, Box3, construct};
use pyo3::prelude::*;

use super::repr::numbers;
use super::{Brep, Interval, IntervalLike, Plane, PlaneLike, Point, PointLike};
use crate::arrays::points_out;
use crate::errors::kernel;

/// A box along the world's axes: what geometry is inside of.
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BoundingBox(pub(crate) Bounds);

#[pymethods]
impl BoundingBox {
    /// The box between two opposite corners.
    #[new]
    fn new(a: PointLike, b: PointLike) -> PyResult<Self> {
        let bounds = Bounds::from_points([a.0, b.0]).filter(|_| a.0.is_finite() && b.0.is_finite());
        bounds.map(Self).ok_or_else(|| kernel(katydid_geometry::Error::NotFinite("corner")))
    }

    /// The box around points, an array of shape (n, 3).
    #[staticmethod]
    fn of_points(points: &Bound<'_, PyAny>) -> PyResult<Option<Self>> {
        Ok(Bounds::from_points(crate::arrays::points_in(points)?).map(Self))
    }

    /// The corner with the smallest coordinates.
    #[getter]
    fn min(&self) -> Point {
        Point(self.0.min)
    }

    /// The corner with the largest coordinates.
    #[getter]
    fn max(&self) -> Point {
        Point(self.0.max)
    }

    /// The middle.
    #[getter]
    fn center(&self) -> Point {
        Point(self.0.center())
    }

    /// The length of the diagonal.
    #[getter]
    fn diagonal(&self) -> f64 {
        self.0.diagonal().length()
    }

    fn __contains__(&self, point: PointLike) -> bool {
        self.0.contains(point.0)
    }

    /// The box around both.
    fn union(&self, other: &Self) -> Self {
        Self(self.0.union(&other.0))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get() == self)
    }

    fn __repr__(&self) -> String {
        let (a, b) = (self.0.min, self.0.max);
        format!("BoundingBox(({}), ({}))", numbers([a.x, a.y, a.z]), numbers([b.x, b.y, b.z]))
    }

    fn __getnewargs__(&self) -> (Point, Point) {
        (Point(self.0.min), Point(self.0.max))
    }
}

/// A box in a plane's frame, by its ranges along the three axes.
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Box(pub(crate) Box3);

#[pymethods]
impl Box {
    /// The box in a frame with ranges along its axes.
    #[new]
    fn new(plane: PlaneLike, x: IntervalLike, y: IntervalLike, z: IntervalLike) -> PyResult<Self> {
        let ranges = [x.0, y.0, z.0];
        if !(plane.0.is_finite() && ranges.iter().all(|range| range.is_finite())) {
            return Err(kernel(katydid_geometry::Error::NotFinite("box")));
        }
        Ok(Self(Box3 { plane: plane.0, x: x.0, y: y.0, z: z.0 }))
    }

    /// The frame.
    #[getter]
    fn plane(&self) -> Plane {
        Plane(self.0.plane)
    }

    /// The range along the x axis.
    #[getter]
    fn x(&self) -> Interval {
        Interval(self.0.x)
    }

    /// The range along the y axis.
    #[getter]
    fn y(&self) -> Interval {
        Interval(self.0.y)
    }

    /// The range along the z axis.
    #[getter]
    fn z(&self) -> Interval {
        Interval(self.0.z)
    }

    /// The middle.
    #[getter]
    fn center(&self) -> Point {
        Point(self.0.center())
    }

    /// The area of the six sides.
    #[getter]
    fn area(&self) -> f64 {
        self.0.area()
    }

    /// The volume.
    #[getter]
    fn volume(&self) -> f64 {
        self.0.volume()
    }

    /// The eight corners as an array of shape (8, 3).
    #[getter]
    fn corners<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        points_out(py, &self.0.corners())
    }

    /// The solid of its six sides.
    #[pyo3(name = "to_brep")]
    fn brep(&self) -> PyResult<Brep> {
        construct::box_brep(&self.0).map(Brep::from).map_err(kernel)
    }

    /// Whether a point is inside, or outside by no more than the tolerance.
    #[pyo3(signature = (point, tolerance=0.0))]
    fn contains(&self, point: PointLike, tolerance: f64) -> bool {
        self.0.contains(point.0, tolerance)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get() == self)
    }

    fn __repr__(&self) -> String {
        let Box3 { x, y, z, .. } = self.0;
        format!("<Box: {} x {} x {}>", x.length().abs(), y.length().abs(), z.length().abs())
    }

    fn __getnewargs__(&self) -> (Plane, Interval, Interval, Interval) {
        (self.plane(), self.x(), self.y(), self.z())
    }
}
