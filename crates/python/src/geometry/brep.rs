use std::sync::Arc;

use katydid_geometry::brep::{FilletBlend, FilletRail};
use katydid_geometry::{
    BoundingBox as Bounds, Brep as Kernel, Containment, MassProperties, MeshSettings, construct,
};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;

use super::cuboid::BoundingBox;
use super::state::{self, Reduced, reduced};
use super::{Curve, Mesh, PlaneLike, Point, PointLike, Surface, Transform, Vector, VectorLike, tolerance};
use crate::arrays::points_out;
use crate::errors::{GeometryError, kernel};
use crate::work::interruptible;

/// How exact areas and volumes are, in proportion.
const EXACT: f64 = 1e-9;

/// Faces on trimmed surfaces, joined along edges: a solid where they enclose a volume.
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Brep(pub(crate) Arc<Kernel>);

impl From<Kernel> for Brep {
    fn from(brep: Kernel) -> Self {
        Self(Arc::new(brep))
    }
}

fn all(breps: Vec<Kernel>) -> Vec<Brep> {
    breps.into_iter().map(Brep::from).collect()
}

impl Brep {
    fn place(&self, what: &str, place: usize, count: usize) -> PyResult<usize> {
        if place < count {
            Ok(place)
        } else {
            Err(PyIndexError::new_err(format!("there are {count} {what}, no {place}")))
        }
    }

    fn volume_properties(&self, py: Python<'_>) -> PyResult<MassProperties> {
        if !self.0.is_solid() {
            return Err(GeometryError::new_err("a Brep that is open encloses no volume"));
        }
        let brep = self.0.clone();
        interruptible(py, move || brep.volume_properties(EXACT, || true))
    }

    fn area_properties(&self, py: Python<'_>) -> PyResult<MassProperties> {
        let brep = self.0.clone();
        interruptible(py, move || brep.area_properties(EXACT, || true))
    }
}

#[pymethods]
impl Brep {
    /// How many faces there are.
    #[getter]
    fn face_count(&self) -> usize {
        self.0.faces().len()
    }

    /// How many edges there are.
    #[getter]
    fn edge_count(&self) -> usize {
        self.0.edges().len()
    }

    /// The corners as an array of shape (n, 3).
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        points_out(py, &self.0.vertices().iter().map(|vertex| vertex.point).collect::<Vec<_>>())
    }

    /// The edges as curves; an edge without a length is left out.
    #[getter]
    fn edges(&self) -> PyResult<Vec<Curve>> {
        let edges = (0..self.0.edges().len()).map(|place| self.0.edge_as_curve(place).map_err(kernel));
        Ok(edges.collect::<PyResult<Vec<_>>>()?.into_iter().flatten().map(Curve::from).collect())
    }

    /// The faces, each as a Brep of its own.
    #[getter]
    fn faces(&self) -> PyResult<Vec<Self>> {
        (0..self.0.faces().len())
            .map(|place| self.0.sub_brep(&[place]).map(Self::from).map_err(kernel))
            .collect()
    }

    /// The surface that a face lies on, without its trims.
    fn face_surface(&self, face: usize) -> PyResult<Surface> {
        let face = self.place("faces", face, self.0.faces().len())?;
        let surface = self.0.face_surface(face).cloned().map(Surface::from);
        surface.ok_or_else(|| GeometryError::new_err("the face has no surface"))
    }

    /// Whether it encloses a volume.
    #[getter]
    fn is_solid(&self) -> bool {
        self.0.is_solid()
    }

    /// Whether it keeps to all rules of its kind.
    #[getter]
    fn is_valid(&self) -> bool {
        self.0.is_valid()
    }

    /// The area of all faces in square units.
    #[getter]
    fn area(&self, py: Python<'_>) -> PyResult<f64> {
        Ok(self.area_properties(py)?.amount)
    }

    /// The volume of a solid in cubic units.
    #[getter]
    fn volume(&self, py: Python<'_>) -> PyResult<f64> {
        Ok(self.volume_properties(py)?.amount)
    }

    /// The mean of all points: of the volume of a solid, else of the area.
    #[getter]
    fn centroid(&self, py: Python<'_>) -> PyResult<Point> {
        let found = if self.0.is_solid() { self.volume_properties(py) } else { self.area_properties(py) };
        Ok(Point(found?.centroid))
    }

    /// The box along the world's axes around it.
    #[getter]
    fn bounding_box(&self) -> PyResult<BoundingBox> {
        let bounds: Option<Bounds> = self.0.bounds_of_faces();
        bounds.map(BoundingBox).ok_or_else(|| GeometryError::new_err("a Brep without faces has no box"))
    }

    /// Where edges have a face on one side only, as curves.
    #[getter]
    fn naked_edges(&self) -> PyResult<Vec<Curve>> {
        let edges = self.0.naked_edges().into_iter().map(|place| self.0.edge_as_curve(place).map_err(kernel));
        Ok(edges.collect::<PyResult<Vec<_>>>()?.into_iter().flatten().map(Curve::from).collect())
    }

    /// The nearest place to a point: the point, the distance, and the normal there.
    fn closest_point(&self, py: Python<'_>, point: PointLike) -> PyResult<(Point, f64, Option<Vector>)> {
        let brep = self.0.clone();
        let found = interruptible(py, move || brep.closest_point(point.0))?;
        Ok((Point(found.point), found.distance, found.normal.map(Vector)))
    }

    /// Whether a point is in a solid: 1 inside, 0 on its faces, -1 outside.
    #[pyo3(signature = (point, tolerance=0.001))]
    fn contains(&self, py: Python<'_>, point: PointLike, tolerance: f64) -> PyResult<i8> {
        let brep = self.0.clone();
        Ok(match interruptible(py, move || brep.contains(point.0, tolerance))? {
            Containment::Outside => -1,
            Containment::On => 0,
            Containment::Inside => 1,
        })
    }

    /// The curves in which a plane cuts it.
    #[pyo3(signature = (plane, tolerance=0.001))]
    fn section(&self, py: Python<'_>, plane: PlaneLike, tolerance: f64) -> PyResult<Vec<Curve>> {
        let brep = self.0.clone();
        let found = interruptible(py, move || brep.section(&plane.0, &self::tolerance(tolerance)))?;
        if !found.complete {
            return Err(GeometryError::new_err("the section could not be found on every face"));
        }
        Ok(found.curves.into_iter().map(Curve::from).collect())
    }

    /// The parts on both sides of a plane, first those that its normal points away from.
    #[pyo3(signature = (plane, tolerance=0.001))]
    fn split(&self, py: Python<'_>, plane: PlaneLike, tolerance: f64) -> PyResult<(Vec<Self>, Vec<Self>)> {
        let brep = self.0.clone();
        let work = move || brep.split_by_plane(&plane.0, &self::tolerance(tolerance), || true);
        let [below, above] = interruptible(py, work)?;
        Ok((all(below), all(above)))
    }

    /// Breps joined along naked edges that run together within a tolerance.
    #[staticmethod]
    #[pyo3(signature = (breps, tolerance=0.001))]
    fn join(py: Python<'_>, breps: Vec<Self>, tolerance: f64) -> PyResult<Vec<Self>> {
        let breps: Vec<Kernel> = breps.iter().map(|brep| (*brep.0).clone()).collect();
        interruptible(py, move || Kernel::join(&breps, &self::tolerance(tolerance)))
            .map(|joined| all(joined.breps))
    }

    /// The Brep with its flat openings closed, and how many were.
    #[pyo3(signature = (tolerance=0.001))]
    fn capped(&self, py: Python<'_>, tolerance: f64) -> PyResult<(Self, usize)> {
        let brep = self.0.clone();
        let (made, count) = interruptible(py, move || brep.capped(&self::tolerance(tolerance)))?;
        Ok((made.into(), count))
    }

    /// The Brep with edges rounded: their places, and a radius or one for each. `blend` is "arc", "smooth" or "chamfer".
    #[pyo3(signature = (edges, radius, *, blend="arc", tolerance=0.001))]
    fn filleted(
        &self,
        py: Python<'_>,
        edges: Vec<usize>,
        radius: &Bound<'_, PyAny>,
        blend: &str,
        tolerance: f64,
    ) -> PyResult<Self> {
        let radii = match radius.extract::<f64>() {
            Ok(radius) => vec![radius; edges.len()],
            Err(_) => crate::arrays::numbers_in(radius)?,
        };
        if radii.len() != edges.len() {
            return Err(PyValueError::new_err(format!("{} edges have {} radii", edges.len(), radii.len())));
        }
        let count = self.0.edges().len();
        let edges =
            edges.into_iter().map(|edge| self.place("edges", edge, count)).collect::<PyResult<Vec<_>>>()?;
        let blend = match blend {
            "arc" => FilletBlend::Arc,
            "smooth" => FilletBlend::Smooth,
            "chamfer" => FilletBlend::Chamfer,
            other => {
                return Err(PyValueError::new_err(format!(
                    "blend is \"arc\", \"smooth\" or \"chamfer\", not {other:?}"
                )));
            }
        };
        let edges: Vec<(usize, f64)> = edges.into_iter().zip(radii).collect();
        let brep = self.0.clone();
        let work = move || brep.filleted(&edges, blend, FilletRail::default(), &self::tolerance(tolerance));
        interruptible(py, work).map(Self::from)
    }

    /// The Brep moved along a direction, and what it passes through, as a solid.
    #[pyo3(signature = (direction, tolerance=0.001))]
    fn extruded(&self, py: Python<'_>, direction: VectorLike, tolerance: f64) -> PyResult<Self> {
        let brep = self.0.clone();
        let work = move || construct::extrude_brep(&brep, direction.0, &self::tolerance(tolerance));
        interruptible(py, work).map(Self::from)
    }

    /// Breps at a distance along the normals.
    #[pyo3(signature = (distance, tolerance=0.001))]
    fn offset(&self, py: Python<'_>, distance: f64, tolerance: f64) -> PyResult<Vec<Self>> {
        let brep = self.0.clone();
        let work = move || construct::offset_brep(&brep, distance, true, &self::tolerance(tolerance));
        interruptible(py, work).map(all)
    }

    /// The Brep with its normals the other way.
    fn flipped(&self) -> Self {
        (*self.0).clone().flipped().into()
    }

    /// A mesh, its faces joined along the edges. Without a tolerance it is as fine as Rhino shades with: about 0.0005 of
    /// the size.
    #[pyo3(signature = (tolerance=None))]
    pub(crate) fn to_mesh(&self, py: Python<'_>, tolerance: Option<f64>) -> PyResult<Mesh> {
        let settings = tolerance.map_or_else(MeshSettings::default, MeshSettings::within);
        let brep = self.0.clone();
        interruptible(py, move || brep.mesh(&settings)?.welded()).map(Mesh::from)
    }

    /// The Brep under a transform.
    pub(crate) fn transformed(&self, transform: &Transform) -> PyResult<Self> {
        self.0.transformed(&transform.0).map(Self::from).map_err(kernel)
    }

    /// The form that rhino3dm and Rhino.Compute speak, as JSON text.
    pub(crate) fn to_json(&self) -> PyResult<String> {
        state::brep(&self.0)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| *other.get() == *self)
    }

    fn __repr__(&self) -> String {
        let word = if self.0.is_solid() { "solid" } else { "open" };
        format!("<Brep: {word}, {} faces, {} edges>", self.face_count(), self.edge_count())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced(py, self.to_json()?, "Brep")
    }
}
