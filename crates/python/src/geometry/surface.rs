use std::sync::Arc;

use katydid_3dm::Object;
use katydid_geometry::{
    Direction, NurbsSurface, Plane as Frame, PlaneSurface, Point3, Quadrant, Surface as Kernel, Vector3,
    construct,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::cuboid::BoundingBox;
use super::state::{self, Reduced, reduced};
use super::{
    Brep, Curve, Interval, IntervalLike, Mesh, Plane, PlaneLike, Point, PointLike, Transform, Vector,
    tolerance,
};
use crate::arrays::{numbers_in, numbers_out, pairs_in, points_in, points_out, rows_out, vectors_out};
use crate::errors::{GeometryError, kernel};
use crate::work::interruptible;

/// A surface without trims: a plane, an extrusion or sum, a revolution, or a NURBS surface.
///
/// Parameters are those of its two `domains`. Functions ending in `s` take pairs of parameters, an array of shape (n, 2).
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surface(pub(crate) Arc<Kernel>);

impl From<Kernel> for Surface {
    fn from(surface: Kernel) -> Self {
        Self(Arc::new(surface))
    }
}

/// A direction by its letter.
fn direction(letter: &str) -> PyResult<Direction> {
    match letter {
        "u" => Ok(Direction::U),
        "v" => Ok(Direction::V),
        other => Err(PyValueError::new_err(format!("a direction is \"u\" or \"v\", not {other:?}"))),
    }
}

#[pymethods]
impl Surface {
    /// The rectangle of a plane over ranges along its axes.
    #[staticmethod]
    fn plane(plane: PlaneLike, x: IntervalLike, y: IntervalLike) -> PyResult<Self> {
        PlaneSurface::new(plane.0, x.0, y.0).map(|surface| Kernel::from(surface).into()).map_err(kernel)
    }

    /// The NURBS surface of a grid of control points, an array of shape (rows, columns, 3): u runs along the rows.
    /// Knots are uniform.
    #[staticmethod]
    #[pyo3(signature = (points, degree=(3, 3)))]
    fn nurbs(points: &Bound<'_, PyAny>, degree: (usize, usize)) -> PyResult<Self> {
        let rows: Vec<Bound<'_, PyAny>> = points.try_iter()?.collect::<PyResult<_>>()?;
        let rows: Vec<Vec<Point3>> = rows.iter().map(points_in).collect::<PyResult<_>>()?;
        let across = rows.first().map_or(0, Vec::len);
        if rows.iter().any(|row| row.len() != across) {
            return Err(PyValueError::new_err("rows of control points are of different lengths"));
        }
        let counts = [rows.len(), across];
        let made = NurbsSurface::clamped_uniform(degree.into(), counts, &rows.concat()).map_err(kernel)?;
        Ok(Kernel::from(made).into())
    }

    /// What it is: "plane", "sum", "revolution" or "nurbs".
    #[getter]
    fn kind(&self) -> &'static str {
        match &*self.0 {
            Kernel::Plane(_) => "plane",
            Kernel::Sum(_) => "sum",
            Kernel::Revolution(_) => "revolution",
            Kernel::Nurbs(_) => "nurbs",
        }
    }

    /// The ranges of the two parameters.
    #[getter]
    fn domains(&self) -> (Interval, Interval) {
        (Interval(self.0.domain(Direction::U)), Interval(self.0.domain(Direction::V)))
    }

    /// The area in square units.
    #[getter]
    fn area(&self, py: Python<'_>) -> PyResult<f64> {
        let surface = self.0.clone();
        interruptible(py, move || surface.area()).map(|area| area.area)
    }

    /// The mean of all its points.
    #[getter]
    fn centroid(&self, py: Python<'_>) -> PyResult<Point> {
        let surface = self.0.clone();
        interruptible(py, move || surface.area()).map(|area| Point(area.centroid))
    }

    /// The box along the world's axes around it.
    #[getter]
    fn bounding_box(&self) -> PyResult<BoundingBox> {
        self.0.bounding_box().map(BoundingBox).map_err(kernel)
    }

    /// Whether it closes along u, and along v.
    #[getter]
    fn is_closed(&self) -> (bool, bool) {
        (self.0.is_closed(Direction::U), self.0.is_closed(Direction::V))
    }

    /// The point at parameters.
    fn point_at(&self, u: f64, v: f64) -> Point {
        Point(self.0.point_at(u, v))
    }

    /// The points at pairs of parameters, an array of shape (n, 2), as an array of shape (n, 3).
    fn points_at<'py>(&self, py: Python<'py>, uv: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let uv = pairs_in(uv)?;
        let points: Vec<Point3> = py.detach(|| uv.iter().map(|[u, v]| self.0.point_at(*u, *v)).collect());
        points_out(py, &points)
    }

    /// The points of a grid of parameters: arrays of shape (n,) and (m,) give an array of shape (n * m, 3), v the quicker.
    fn grid_points<'py>(
        &self,
        py: Python<'py>,
        u: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (us, vs) = (numbers_in(u)?, numbers_in(v)?);
        let points: Vec<Point3> = py.detach(|| match &*self.0 {
            Kernel::Nurbs(surface) => surface.points_grid(&us, &vs),
            surface => us.iter().flat_map(|u| vs.iter().map(|v| surface.point_at(*u, *v))).collect(),
        });
        points_out(py, &points)
    }

    /// The normal of length 1 at parameters.
    fn normal_at(&self, u: f64, v: f64) -> PyResult<Vector> {
        let normal = self.0.normal_at(u, v).map(Vector);
        normal.ok_or_else(|| GeometryError::new_err("the surface has no normal there"))
    }

    /// The normals at pairs of parameters, an array of shape (n, 2), as an array of shape (n, 3); zero where there is none.
    fn normals_at<'py>(&self, py: Python<'py>, uv: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let uv = pairs_in(uv)?;
        let normal = |[u, v]: &[f64; 2]| self.0.normal_at(*u, *v).unwrap_or(Vector3::ZERO);
        let normals: Vec<Vector3> = py.detach(|| uv.iter().map(normal).collect());
        vectors_out(py, &normals)
    }

    /// The plane that touches the surface at parameters, its x axis along u.
    fn frame_at(&self, u: f64, v: f64) -> PyResult<Plane> {
        let plane: Option<Frame> = self.0.frame_at(u, v);
        plane.map(Plane).ok_or_else(|| GeometryError::new_err("the surface has no normal there"))
    }

    /// The derivative by u so many times and by v so many times, at parameters; of order 8 at most together.
    #[pyo3(signature = (u, v, du=1, dv=0))]
    fn derivative_at(&self, u: f64, v: f64, du: usize, dv: usize) -> PyResult<Vector> {
        match du.checked_add(dv) {
            Some(order) if order <= 8 => {
                Ok(Vector(self.0.derivatives(u, v, order, Quadrant::default()).get(du, dv)))
            }
            _ => Err(PyValueError::new_err("derivatives are of order 8 at most")),
        }
    }

    /// The principal curvatures at parameters in 1/units, the larger first.
    fn curvatures_at(&self, u: f64, v: f64) -> PyResult<(f64, f64)> {
        self.0.curvature_at(u, v).map(|curvature| curvature.principal.into()).map_err(kernel)
    }

    /// The Gaussian and the mean curvature at parameters.
    fn gaussian_and_mean_at(&self, u: f64, v: f64) -> PyResult<(f64, f64)> {
        self.0.curvature_at(u, v).map(|curvature| (curvature.gaussian, curvature.mean)).map_err(kernel)
    }

    /// The nearest place to a point: the parameters, the point there, and the distance.
    fn closest_point(&self, py: Python<'_>, point: PointLike) -> PyResult<((f64, f64), Point, f64)> {
        let surface = self.0.clone();
        let found = interruptible(py, move || surface.closest_point(point.0))?;
        Ok(((found.u, found.v), Point(found.point), found.distance))
    }

    /// The nearest places to points, an array of shape (n, 3): arrays of parameters (n, 2), points (n, 3), distances (n,).
    fn closest_points<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
    ) -> PyResult<[Bound<'py, PyAny>; 3]> {
        let points = points_in(points)?;
        let surface = self.0.clone();
        let found = interruptible(py, move || surface.closest_points(&points))?;
        let there: Vec<Point3> = found.iter().map(|found| found.point).collect();
        let distances: Vec<f64> = found.iter().map(|found| found.distance).collect();
        let pairs = found.iter().map(|found| [found.u, found.v]);
        let parameters = if crate::arrays::has_numpy(py) {
            rows_out(py, found.len(), pairs)?
        } else {
            pyo3::types::PyList::new(py, pairs.map(|[u, v]| (u, v)))?.into_any()
        };
        Ok([parameters, points_out(py, &there)?, numbers_out(py, &distances)?])
    }

    /// The curve along "u" or "v" at a value of the other parameter.
    fn isocurve(&self, along: &str, constant: f64) -> PyResult<Curve> {
        self.0.isocurve(direction(along)?, constant).map(Curve::from).map_err(kernel)
    }

    /// The part over ranges of the parameters.
    fn trimmed(&self, u: IntervalLike, v: IntervalLike) -> PyResult<Self> {
        self.0.sub_surface(u.0, v.0).map(Self::from).map_err(kernel)
    }

    /// The surface with "u" or "v" run through the other way.
    fn reversed(&self, along: &str) -> PyResult<Self> {
        Ok(self.0.reversed(direction(along)?).into())
    }

    /// The surface with its parameters exchanged.
    fn transposed(&self) -> Self {
        self.0.transposed().into()
    }

    /// The surface at a distance along its normals, within a tolerance.
    #[pyo3(signature = (distance, tolerance=0.001))]
    fn offset(&self, py: Python<'_>, distance: f64, tolerance: f64) -> PyResult<Self> {
        let surface = self.0.clone();
        let work = move || construct::offset_surface(&surface, distance, &self::tolerance(tolerance));
        interruptible(py, work).map(Self::from)
    }

    /// A mesh of it; see `Brep.to_mesh`.
    #[pyo3(signature = (tolerance=None))]
    fn to_mesh(&self, py: Python<'_>, tolerance: Option<f64>) -> PyResult<Mesh> {
        self.to_brep()?.to_mesh(py, tolerance)
    }

    /// The Brep of one face that it is.
    pub(crate) fn to_brep(&self) -> PyResult<Brep> {
        katydid_geometry::Brep::from_surface((*self.0).clone()).map(Brep::from).map_err(kernel)
    }

    /// The same surface as a NURBS surface.
    fn to_nurbs(&self) -> PyResult<Self> {
        self.0.to_nurbs().map(|surface| Kernel::from(surface).into()).map_err(kernel)
    }

    /// The surface under a transform.
    pub(crate) fn transformed(&self, transform: &Transform) -> PyResult<Self> {
        self.0.transformed(&transform.0).map(Self::from).map_err(kernel)
    }

    /// The form that rhino3dm and Rhino.Compute speak, as JSON text.
    pub(crate) fn to_json(&self) -> PyResult<String> {
        state::form(Object::Surface((*self.0).clone()))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| *other.get() == *self)
    }

    fn __repr__(&self) -> String {
        let [u, v] = Direction::BOTH.map(|d| self.0.domain(d));
        format!("<Surface: {}, u {}..{}, v {}..{}>", self.kind(), u.start, u.end, v.start, v.end)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced(py, self.to_json()?, "Surface")
    }
}
