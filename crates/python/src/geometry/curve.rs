use std::sync::Arc;

use katydid_3dm::Object;
use katydid_geometry::{Curve as Kernel, Point3, Vector3};
use pyo3::prelude::*;

use super::cuboid::BoundingBox;
use super::state::{self, Reduced, reduced};
use super::{Interval, IntervalLike, Plane, PlaneLike, Point, PointLike, Transform, Vector, VectorLike};
use crate::arrays::{numbers_in, numbers_out, points_in, points_out, vectors_out};
use crate::errors::{GeometryError, kernel};

/// A curve: a line, an arc, a polyline, a NURBS curve, or several joined. It never changes; what edits it gives another.
///
/// Parameters are those of its `domain`. Functions ending in `s` take arrays of parameters of shape (n,), and give arrays
/// of shape (n,) or (n, 3).
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve(pub(crate) Arc<Kernel>);

impl From<Kernel> for Curve {
    fn from(curve: Kernel) -> Self {
        Self(Arc::new(curve))
    }
}

impl Curve {
    /// What kind of curve it is, in the field's word.
    pub(crate) fn word(&self) -> &'static str {
        match &*self.0 {
            Kernel::Line(_) => "line",
            Kernel::Arc(arc) if arc.is_circle() => "circle",
            Kernel::Arc(_) => "arc",
            Kernel::Polyline(_) => "polyline",
            Kernel::Nurbs(_) => "nurbs",
            Kernel::Poly(_) => "polycurve",
        }
    }
}

fn no_direction() -> PyErr {
    GeometryError::new_err("the curve has no direction there")
}

#[pymethods]
impl Curve {
    /// What it is: "line", "arc", "circle", "polyline", "nurbs" or "polycurve".
    #[getter]
    fn kind(&self) -> &'static str {
        self.word()
    }

    /// The range of the parameter.
    #[getter]
    fn domain(&self) -> Interval {
        Interval(self.0.domain())
    }

    /// The first point.
    #[getter]
    fn start(&self) -> Point {
        Point(self.0.start())
    }

    /// The last point.
    #[getter]
    fn end(&self) -> Point {
        Point(self.0.end())
    }

    /// The length in model units.
    #[getter]
    fn length(&self, py: Python<'_>) -> f64 {
        py.detach(|| self.0.length())
    }

    /// Whether it ends where it begins.
    #[getter]
    fn is_closed(&self) -> bool {
        self.0.is_closed()
    }

    /// Whether it goes on smoothly over its ends, as a periodic NURBS curve does.
    #[getter]
    fn is_periodic(&self) -> bool {
        self.0.is_periodic()
    }

    /// The box along the world's axes around it.
    #[getter]
    fn bounding_box(&self) -> BoundingBox {
        BoundingBox(self.0.bounding_box())
    }

    /// The point at a parameter.
    fn point_at(&self, t: f64) -> Point {
        Point(self.0.point_at(t))
    }

    /// The points at parameters, an array of shape (n,), as an array of shape (n, 3).
    fn points_at<'py>(&self, py: Python<'py>, t: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let t = numbers_in(t)?;
        let points = py.detach(|| self.0.points_at(&t));
        points_out(py, &points)
    }

    /// The direction of length 1 at a parameter.
    fn tangent_at(&self, t: f64) -> PyResult<Vector> {
        self.0.tangent_at(t).map(Vector).ok_or_else(no_direction)
    }

    /// The directions of length 1 at parameters, an array of shape (n,), as an array of shape (n, 3); zero where the curve
    /// has none.
    fn tangents_at<'py>(&self, py: Python<'py>, t: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let t = numbers_in(t)?;
        let tangents: Vec<Vector3> =
            py.detach(|| t.iter().map(|t| self.0.tangent_at(*t).unwrap_or(Vector3::ZERO)).collect());
        vectors_out(py, &tangents)
    }

    /// The derivatives of order 1, 2 … `count` by the parameter, at most 64.
    #[pyo3(signature = (t, count=1))]
    fn derivatives_at(&self, t: f64, count: usize) -> Vec<Vector> {
        self.0.derivatives(t, count, false).1.into_iter().map(Vector).collect()
    }

    /// The curvature vector at a parameter: towards the centre of the osculating circle, as long as 1/radius.
    fn curvature_at(&self, t: f64) -> Vector {
        Vector(self.0.curvature_at(t))
    }

    /// The curvature vectors at parameters, an array of shape (n,), as an array of shape (n, 3).
    fn curvatures_at<'py>(&self, py: Python<'py>, t: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let t = numbers_in(t)?;
        let vectors: Vec<Vector3> = py.detach(|| t.iter().map(|t| self.0.curvature_at(*t)).collect());
        vectors_out(py, &vectors)
    }

    /// The torsion at a parameter in 1/units.
    fn torsion_at(&self, t: f64) -> f64 {
        self.0.torsion_at(t)
    }

    /// The plane at a parameter with the tangent for its x axis and the curvature for its y axis.
    fn frame_at(&self, t: f64) -> PyResult<Plane> {
        self.0.frame_at(t).map(Plane).ok_or_else(no_direction)
    }

    /// Planes across the curve at parameters, an array of shape (n,), that turn about it as little as can be.
    fn perpendicular_frames(&self, t: &Bound<'_, PyAny>) -> PyResult<Vec<Option<Plane>>> {
        let t = numbers_in(t)?;
        Ok(self.0.perpendicular_frames(&t).into_iter().map(|plane| plane.map(Plane)).collect())
    }

    /// The length from the start to a parameter, or between two.
    #[pyo3(signature = (domain))]
    fn length_between(&self, py: Python<'_>, domain: IntervalLike) -> f64 {
        py.detach(|| self.0.length_between(domain.0))
    }

    /// The parameter at a length from the start, or of a fraction of the length where `normalized`.
    #[pyo3(signature = (length, *, normalized=false))]
    fn parameter_at_length(&self, py: Python<'_>, length: f64, normalized: bool) -> PyResult<f64> {
        let found = py.detach(|| {
            if normalized {
                self.0.parameter_at_normalized_length(length)
            } else {
                self.0.parameter_at_length(length)
            }
        });
        found.ok_or_else(|| GeometryError::new_err("the curve is not that long, or the length is negative"))
    }

    /// Parameters that divide the curve into so many parts of equal length, as an array of shape (n,).
    ///
    /// An open curve has both its ends among them; a closed one its seam once.
    fn divide<'py>(&self, py: Python<'py>, count: usize) -> PyResult<Bound<'py, PyAny>> {
        let t = py.detach(|| self.0.divide_by_count(count)).map_err(kernel)?;
        numbers_out(py, &t)
    }

    /// Parameters at equal lengths from the start on, as an array of shape (n,).
    fn divide_by_length<'py>(&self, py: Python<'py>, length: f64) -> PyResult<Bound<'py, PyAny>> {
        let t = py.detach(|| self.0.divide_by_length(length)).map_err(kernel)?;
        numbers_out(py, &t)
    }

    /// The nearest place to a point: the parameter, the point there, and the distance.
    fn closest_point(&self, py: Python<'_>, point: PointLike) -> PyResult<(f64, Point, f64)> {
        let found = py.detach(|| self.0.closest_point(point.0)).map_err(kernel)?;
        Ok((found.parameter, Point(found.point), found.distance))
    }

    /// The nearest places to points, an array of shape (n, 3): arrays of parameters (n,), points (n, 3), distances (n,).
    fn closest_points<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
    ) -> PyResult<[Bound<'py, PyAny>; 3]> {
        let points = points_in(points)?;
        let curve = self.0.clone();
        let found = crate::work::interruptible(py, move || curve.closest_points(&points))?;
        let column = |of: fn(&katydid_geometry::CurvePoint) -> f64| found.iter().map(of).collect::<Vec<_>>();
        let there: Vec<Point3> = found.iter().map(|found| found.point).collect();
        Ok([
            numbers_out(py, &column(|found| found.parameter))?,
            points_out(py, &there)?,
            numbers_out(py, &column(|found| found.distance))?,
        ])
    }

    /// The plane that the curve lies in; none where it lies in none within the tolerance.
    #[pyo3(signature = (tolerance=0.001))]
    fn plane(&self, tolerance: f64) -> Option<Plane> {
        self.0.plane(tolerance).map(Plane)
    }

    /// The area that a closed planar curve encloses, and its centroid.
    #[pyo3(signature = (tolerance=0.001))]
    fn area_and_centroid(&self, tolerance: f64) -> PyResult<(f64, Point)> {
        self.0.area_and_centroid(tolerance).map(|(area, centroid)| (area, Point(centroid))).map_err(kernel)
    }

    /// Whether a point is inside a closed curve as seen in a plane: 1 inside, 0 on the curve, -1 outside.
    #[pyo3(signature = (point, plane=None, tolerance=0.001))]
    fn contains(&self, point: PointLike, plane: Option<PlaneLike>, tolerance: f64) -> PyResult<i8> {
        let plane =
            plane.map_or_else(|| self.0.plane(tolerance).unwrap_or(katydid_geometry::Plane::XY), |p| p.0);
        let side = self.0.contains_in_plane(point.0, &plane, tolerance).map_err(kernel)?;
        Ok(match side {
            katydid_geometry::Containment::Outside => -1,
            katydid_geometry::Containment::On => 0,
            katydid_geometry::Containment::Inside => 1,
        })
    }

    /// The parameters at which the curve goes farthest in a direction or turns back, in order.
    fn turning_points(&self, direction: VectorLike) -> PyResult<Vec<f64>> {
        self.0.turning_points(direction.0).map_err(kernel)
    }

    /// The curve under a transform.
    pub(crate) fn transformed(&self, transform: &Transform) -> PyResult<Self> {
        self.0.transformed(&transform.0).map(Self::from).map_err(kernel)
    }

    /// The form that rhino3dm and Rhino.Compute speak, as JSON text.
    pub(crate) fn to_json(&self) -> PyResult<String> {
        state::form(Object::Curve((*self.0).clone()))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| *other.get() == *self)
    }

    fn __repr__(&self) -> String {
        format!("<Curve: {}, length {}>", self.word(), super::repr::number(self.0.length()))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced(py, self.to_json()?, "Curve")
    }
}
