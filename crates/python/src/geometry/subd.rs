use std::sync::Arc;

use katydid_geometry::subd::{FromMesh, SubD as Kernel, SubDNet, SubDVertex};
use katydid_geometry::{BoundingBox as Bounds, Point3};
use pyo3::prelude::*;

use super::cuboid::BoundingBox;
use super::state::{self, Reduced, reduced};
use super::{Brep, Mesh, Transform};
use crate::arrays::points_out;
use crate::errors::{GeometryError, kernel};
use crate::work::interruptible;

/// The most times that a net is divided for a mesh: each makes four faces of one.
const MOST_LEVELS: u32 = 8;

/// A subdivision surface (Catmull-Clark) by its control net, with creases.
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SubD(pub(crate) Arc<Kernel>);

impl From<SubDNet> for SubD {
    fn from(net: SubDNet) -> Self {
        Self(Arc::new(Kernel::new(net)))
    }
}

#[pymethods]
impl SubD {
    /// The surface whose control net is a mesh. Edges where the mesh is not welded become creases where `creases`;
    /// vertices on the border of a single face become corners where `corners`.
    #[new]
    #[pyo3(signature = (mesh, *, creases=true, corners=true))]
    fn new(mesh: &Mesh, creases: bool, corners: bool) -> PyResult<Self> {
        SubDNet::from_mesh(&mesh.0, &FromMesh { creases, corners }).map(Self::from).map_err(kernel)
    }

    /// The control points as an array of shape (n, 3).
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let points: Vec<Point3> = self.0.net().vertices().iter().map(|vertex| vertex.point).collect();
        points_out(py, &points)
    }

    /// Where the control points come to lie on the surface, as an array of shape (n, 3).
    #[getter]
    fn limit_points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        points_out(py, &self.0.vertex_limits())
    }

    /// How many faces the net has.
    #[getter]
    fn face_count(&self) -> usize {
        self.0.net().faces().len()
    }

    /// How many edges the net has.
    #[getter]
    fn edge_count(&self) -> usize {
        self.0.net().edges().len()
    }

    /// The box along the world's axes around the control points, and so around the surface.
    #[getter]
    fn bounding_box(&self) -> PyResult<BoundingBox> {
        let points = self.0.net().vertices().iter().map(|vertex| vertex.point);
        let bounds = Bounds::from_points(points).map(BoundingBox);
        bounds.ok_or_else(|| GeometryError::new_err("a SubD without vertices has no box"))
    }

    /// A mesh with its vertices on the surface, the net divided so many times: 8 at most.
    #[pyo3(signature = (levels=3))]
    pub(crate) fn to_mesh(&self, py: Python<'_>, levels: u32) -> PyResult<Mesh> {
        if levels > MOST_LEVELS {
            return Err(GeometryError::new_err(format!(
                "levels is {levels}, which must be {MOST_LEVELS} at most"
            )));
        }
        let subd = self.0.clone();
        interruptible(py, move || subd.limit_mesh(levels)).map(Mesh::from)
    }

    /// The control net as a mesh.
    fn to_control_mesh(&self) -> PyResult<Mesh> {
        self.0.net().to_mesh().map(Mesh::from).map_err(kernel)
    }

    /// A Brep of bicubic faces within a tolerance.
    #[pyo3(signature = (tolerance=0.001))]
    fn to_brep(&self, py: Python<'_>, tolerance: f64) -> PyResult<Brep> {
        let subd = self.0.clone();
        interruptible(py, move || subd.to_brep(tolerance)).map(Brep::from)
    }

    /// The surface under a transform.
    pub(crate) fn transformed(&self, transform: &Transform) -> PyResult<Self> {
        let net = self.0.net();
        let moved =
            |vertex: &SubDVertex| SubDVertex { point: transform.0.point(vertex.point), ..vertex.clone() };
        let vertices = net.vertices().iter().map(moved).collect();
        SubDNet::from_parts(vertices, net.edges().to_vec(), net.faces().to_vec())
            .map(Self::from)
            .map_err(kernel)
    }

    /// The form that rhino3dm and Rhino.Compute speak, as JSON text.
    pub(crate) fn to_json(&self) -> PyResult<String> {
        state::subd(&self.0)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| *other.get() == *self)
    }

    fn __repr__(&self) -> String {
        format!("<SubD: {} vertices, {} faces>", self.0.net().vertices().len(), self.face_count())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced(py, self.to_json()?, "SubD")
    }
}
