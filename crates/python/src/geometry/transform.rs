use katydid_geometry::{Point3, Xform};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use super::repr::numbers;
use super::{Brep, Curve, Mesh, Plane, PlaneLike, Point, PointLike, SubD, Surface, Vector, VectorLike};
use crate::errors::{GeometryError, kernel};

/// An affine or projective map of space: four rows of four numbers, for columns of coordinates.
///
/// `a @ b` is b first, then a. `a @ x` applies it to a point, a vector, a plane, geometry, or an array of points of shape
/// (n, 3).
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Transform(pub(crate) Xform);

/// What a transform may be applied to.
#[derive(FromPyObject)]
pub(crate) enum Transformable<'py> {
    Transform(Transform),
    Point(Point),
    Vector(Vector),
    Plane(Plane),
    Curve(Curve),
    Surface(Surface),
    Brep(Brep),
    Mesh(Mesh),
    SubD(SubD),
    Other(Bound<'py, PyAny>),
}

#[pymethods]
impl Transform {
    /// The transform of four rows of four numbers; the identity without any.
    #[new]
    #[pyo3(signature = (rows=None))]
    fn new(rows: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let Some(rows) = rows else { return Ok(Self(Xform::IDENTITY)) };
        let rows = match crate::arrays::rows_in(rows, |row: [f64; 4]| row)? {
            Some(rows) => rows,
            None => {
                rows.extract().map_err(|_| PyTypeError::new_err("four rows of four numbers are expected"))?
            }
        };
        let rows: [[f64; 4]; 4] =
            rows.try_into().map_err(|_| PyTypeError::new_err("four rows of four numbers are expected"))?;
        Ok(Self(Xform { rows }))
    }

    /// The move along a vector.
    #[staticmethod]
    fn translation(vector: VectorLike) -> Self {
        Self(Xform::translation(vector.0))
    }

    /// The rotation by an angle in radians about an axis through a centre, by the right-hand rule.
    #[staticmethod]
    #[pyo3(signature = (angle, axis=VectorLike(katydid_geometry::Vector3::Z), center=PointLike(Point3::ORIGIN)))]
    fn rotation(angle: f64, axis: VectorLike, center: PointLike) -> PyResult<Self> {
        Xform::rotation(angle, axis.0, center.0).map(Self).map_err(kernel)
    }

    /// The scaling by a factor about a centre.
    #[staticmethod]
    #[pyo3(signature = (factor, center=PointLike(Point3::ORIGIN)))]
    fn scale(factor: f64, center: PointLike) -> Self {
        Self(Xform::scale(center.0, factor))
    }

    /// The reflection in a plane.
    #[staticmethod]
    fn mirror(plane: PlaneLike) -> Self {
        Self(Xform::mirror(&plane.0))
    }

    /// The map that takes one plane to another, axis to axis.
    #[staticmethod]
    fn plane_to_plane(source: PlaneLike, target: PlaneLike) -> Self {
        Self(Xform::plane_to_plane(&source.0, &target.0))
    }

    /// The projection onto a plane, at right angles.
    #[staticmethod]
    fn planar_projection(plane: PlaneLike) -> Self {
        Self(Xform::planar_projection(&plane.0))
    }

    /// The four rows.
    #[getter]
    fn rows(&self) -> [[f64; 4]; 4] {
        self.0.rows
    }

    /// The determinant.
    #[getter]
    fn determinant(&self) -> f64 {
        self.0.determinant()
    }

    /// The transform that undoes this one.
    fn inverse(&self) -> PyResult<Self> {
        self.0
            .inverse()
            .map(Self)
            .ok_or_else(|| GeometryError::new_err("a transform that flattens has no inverse"))
    }

    fn __matmul__<'py>(&self, py: Python<'py>, thing: Transformable<'py>) -> PyResult<Bound<'py, PyAny>> {
        let xform = &self.0;
        Ok(match thing {
            Transformable::Transform(other) => Bound::new(py, Self(*xform * other.0))?.into_any(),
            Transformable::Point(point) => Bound::new(py, Point(xform.point(point.0)))?.into_any(),
            Transformable::Vector(vector) => Bound::new(py, Vector(xform.vector(vector.0)))?.into_any(),
            Transformable::Plane(plane) => {
                Bound::new(py, Plane(plane.0.transformed(xform).map_err(kernel)?))?.into_any()
            }
            Transformable::Curve(curve) => Bound::new(py, curve.transformed(self)?)?.into_any(),
            Transformable::Surface(surface) => Bound::new(py, surface.transformed(self)?)?.into_any(),
            Transformable::Brep(brep) => Bound::new(py, brep.transformed(self)?)?.into_any(),
            Transformable::Mesh(mesh) => Bound::new(py, mesh.transformed(self)?)?.into_any(),
            Transformable::SubD(subd) => Bound::new(py, subd.transformed(self)?)?.into_any(),
            Transformable::Other(points) => {
                let mut points = crate::arrays::points_in(&points)?;
                xform.transform_points(&mut points);
                crate::arrays::points_out(py, &points)?
            }
        })
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get() == self)
    }

    fn __hash__(&self, py: Python<'_>) -> PyResult<isize> {
        pyo3::types::PyTuple::new(py, self.0.rows.concat())?.hash()
    }

    fn __repr__(&self) -> String {
        let rows = self.0.rows.map(|row| format!("[{}]", numbers(row)));
        format!("Transform([{}])", rows.join(", "))
    }

    fn __getnewargs__(&self) -> ([[f64; 4]; 4],) {
        (self.0.rows,)
    }
}
