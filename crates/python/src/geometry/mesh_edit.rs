//! What is done to meshes, and asked of them.

use katydid_geometry::{
    Decimation, Mesh as Kernel, MeshTree, Point3, QuadOptions, RemeshOptions, Smoothing, Solid,
};
use pyo3::prelude::*;

use super::{Mesh, PlaneLike, Point, PointLike, VectorLike};
use crate::arrays::{numbers_out, points_in, points_out};
use crate::errors::kernel;
use crate::work::interruptible;

/// The most faces that there may be on the way of a remeshing.
const MOST_FACES: usize = 4_000_000;

impl Mesh {
    /// A boolean of two solids.
    fn boolean(
        &self,
        py: Python<'_>,
        other: &Self,
        make: fn(&Solid, &Solid) -> katydid_geometry::Result<Solid>,
    ) -> PyResult<Self> {
        let (a, b) = (self.0.clone(), other.0.clone());
        interruptible(py, move || make(&Solid::new(&a)?, &Solid::new(&b)?)?.to_mesh()).map(Self::from)
    }
}

#[pymethods]
impl Mesh {
    /// The solid of both closed meshes together.
    fn union(&self, py: Python<'_>, other: &Self) -> PyResult<Self> {
        self.boolean(py, other, Solid::union)
    }

    /// This closed mesh without what is in the other.
    fn difference(&self, py: Python<'_>, other: &Self) -> PyResult<Self> {
        self.boolean(py, other, Solid::difference)
    }

    /// What is in both closed meshes.
    fn intersection(&self, py: Python<'_>, other: &Self) -> PyResult<Self> {
        self.boolean(py, other, Solid::intersection)
    }

    fn __or__(&self, py: Python<'_>, other: &Self) -> PyResult<Self> {
        self.union(py, other)
    }

    fn __sub__(&self, py: Python<'_>, other: &Self) -> PyResult<Self> {
        self.difference(py, other)
    }

    fn __and__(&self, py: Python<'_>, other: &Self) -> PyResult<Self> {
        self.intersection(py, other)
    }

    /// Several meshes as one; vertices are not joined.
    #[staticmethod]
    fn join(meshes: Vec<Self>) -> PyResult<Self> {
        let meshes: Vec<Kernel> = meshes.iter().map(|mesh| (*mesh.0).clone()).collect();
        Kernel::join(&meshes).map(Self::from).map_err(kernel)
    }

    /// The connected parts.
    fn pieces(&self) -> PyResult<Vec<Self>> {
        Ok(self.0.pieces().map_err(kernel)?.into_iter().map(Self::from).collect())
    }

    /// The mesh with its faces the other way round.
    fn flipped(&self) -> Self {
        self.0.flipped().into()
    }

    /// The mesh with vertices in one place joined where faces meet at no more than an angle in radians.
    #[pyo3(signature = (angle=std::f64::consts::PI))]
    fn welded(&self, angle: f64) -> Self {
        self.0.welded(angle).into()
    }

    /// The mesh with fewer triangles: about so many.
    #[pyo3(signature = (faces, *, max_error=f64::INFINITY))]
    fn decimated(&self, py: Python<'_>, faces: usize, max_error: f64) -> PyResult<Self> {
        let mesh = self.0.clone();
        let work = move || mesh.decimated(&Decimation { faces, max_error }, || true);
        interruptible(py, work).map(Self::from)
    }

    /// The mesh smoothed: each vertex drawn towards the mean of its neighbours, so many times.
    #[pyo3(signature = (iterations=1, strength=0.5, *, keep_naked=false))]
    fn smoothed(&self, py: Python<'_>, iterations: usize, strength: f64, keep_naked: bool) -> PyResult<Self> {
        let mesh = self.0.clone();
        let options = Smoothing { strength, skip_naked: keep_naked, iterations, limit: None };
        interruptible(py, move || mesh.smoothed(&options, || true)).map(Self::from)
    }

    /// Triangles with edges of about one length; edges sharper than `crease`, in radians, stay.
    #[pyo3(signature = (length, *, iterations=10, crease=None))]
    fn remeshed(
        &self,
        py: Python<'_>,
        length: f64,
        iterations: usize,
        crease: Option<f64>,
    ) -> PyResult<Self> {
        let mesh = self.0.clone();
        let options = RemeshOptions { length, iterations, crease, points: Vec::new(), limit: MOST_FACES };
        interruptible(py, move || mesh.remeshed(&options, None)).map(|made| made.mesh.into())
    }

    /// Quads, about so many; edges sharper than `crease`, in radians, stay.
    #[pyo3(signature = (count, *, crease=None))]
    fn quad_remeshed(&self, py: Python<'_>, count: usize, crease: Option<f64>) -> PyResult<Self> {
        let mesh = self.0.clone();
        let options = QuadOptions { crease, ..QuadOptions::new(count) };
        interruptible(py, move || mesh.quad_remeshed(&options)).map(Self::from)
    }

    /// The mesh moved along its normals.
    fn offset(&self, py: Python<'_>, distance: f64) -> PyResult<Self> {
        let mesh = self.0.clone();
        interruptible(py, move || mesh.offset(distance)).map(Self::from)
    }

    /// The polylines in which a plane cuts it, each an array of shape (n, 3).
    fn section<'py>(&self, py: Python<'py>, plane: PlaneLike) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let lines = py.detach(|| self.0.section(&plane.0)).map_err(kernel)?;
        lines.iter().map(|line| points_out(py, line)).collect()
    }

    /// The nearest place to a point: the point, the distance, and the face.
    fn closest_point(&self, point: PointLike) -> PyResult<(Point, f64, usize)> {
        let found = self.0.closest_point(point.0).map_err(kernel)?;
        Ok((Point(found.point), found.distance, found.face))
    }

    /// The nearest places to points, an array of shape (n, 3): arrays of points (n, 3) and of distances (n,).
    fn closest_points<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
    ) -> PyResult<[Bound<'py, PyAny>; 2]> {
        let points = points_in(points)?;
        let mesh = self.0.clone();
        let found = interruptible(py, move || {
            let tree = MeshTree::new(&mesh);
            points.iter().map(|point| tree.closest(*point)).collect::<katydid_geometry::Result<Vec<_>>>()
        })?;
        let there: Vec<Point3> = found.iter().map(|found| found.point).collect();
        let distances: Vec<f64> = found.iter().map(|found| found.distance).collect();
        Ok([points_out(py, &there)?, numbers_out(py, &distances)?])
    }

    /// Where a ray meets it: for each place the distance in lengths of the direction, the point and the face, in order.
    fn ray_hits(&self, origin: PointLike, direction: VectorLike) -> PyResult<Vec<(f64, Point, usize)>> {
        let hits =
            MeshTree::new(&self.0).line_hits(origin.0, direction.0, [0.0, f64::INFINITY]).map_err(kernel)?;
        Ok(hits.into_iter().map(|hit| (hit.t, Point(hit.point), hit.face)).collect())
    }
}
