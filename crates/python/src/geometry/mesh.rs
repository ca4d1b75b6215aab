use std::sync::Arc;

use katydid_geometry::{Mesh as Kernel, MeshFace, Point3, Vector3};
use numpy::{PyArrayDyn, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyList;

use super::cuboid::BoundingBox;
use super::state;
use super::{Point, Transform};
use crate::arrays::{has_numpy, is_array, points_in, points_out, rows_in, rows_out, vectors_out};
use crate::errors::{GeometryError, kernel};

/// Vertices, and faces of three or four of them.
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Mesh(pub(crate) Arc<Kernel>);

impl From<Kernel> for Mesh {
    fn from(mesh: Kernel) -> Self {
        Self(Arc::new(mesh))
    }
}

/// Places of vertices by face, as Python writes them.
type Corners = Vec<Vec<u32>>;

/// A face of three or four corners; where the last two are one, of three.
fn face(corners: &[u32]) -> PyResult<MeshFace> {
    match *corners {
        [a, b, c] => Ok(MeshFace::Triangle([a, b, c])),
        [a, b, c, d] if c == d => Ok(MeshFace::Triangle([a, b, c])),
        [a, b, c, d] => Ok(MeshFace::Quad([a, b, c, d])),
        _ => Err(PyValueError::new_err(format!("a face has three or four corners, not {}", corners.len()))),
    }
}

fn faces_in(object: &Bound<'_, PyAny>) -> PyResult<Vec<MeshFace>> {
    if !is_array(object) {
        let faces: Corners = object.extract().map_err(|_| {
            PyTypeError::new_err("faces are an array of shape (n, 3) or (n, 4), or a list of places")
        })?;
        return faces.iter().map(|corners| face(corners)).collect();
    }
    // Places are whole numbers that are not negative: an array of anything else is refused, and not rounded.
    let kind: String = object.getattr("dtype")?.getattr("kind")?.extract()?;
    let size: usize = object.getattr("size")?.extract()?;
    if !["i", "u"].contains(&kind.as_str()) && size > 0 {
        return Err(PyTypeError::new_err("faces are places of vertices: whole numbers"));
    }
    let array = object.py().import("numpy")?.call_method1("ascontiguousarray", (object, "int64"))?;
    let array = array.cast::<PyArrayDyn<i64>>()?;
    let width = array.shape().get(1).copied().unwrap_or(0);
    if array.ndim() != 2 || !(3..=4).contains(&width) {
        let shape = array.shape();
        return Err(PyValueError::new_err(format!("faces have shape (n, 3) or (n, 4), not {shape:?}")));
    }
    let array: PyReadonlyArray2<'_, i64> = array.extract()?;
    let places = array.as_slice().map_err(|error| PyValueError::new_err(error.to_string()))?;
    let place = |place: &i64| {
        u32::try_from(*place).map_err(|_| PyValueError::new_err(format!("there is no vertex {place}")))
    };
    places
        .chunks_exact(width)
        .map(|corners| face(&corners.iter().map(place).collect::<PyResult<Vec<_>>>()?))
        .collect()
}

/// Colours as an array of shape (n, 3) or (n, 4) of numbers from 0 to 255.
fn colours_in(object: &Bound<'_, PyAny>) -> PyResult<Vec<[u8; 4]>> {
    let byte = |x: f64| x.clamp(0.0, 255.0).round() as u8;
    if is_array(object)
        && object.getattr("shape")?.get_item(1).and_then(|n| n.extract::<usize>()).ok() == Some(3)
    {
        let colours = rows_in(object, |[r, g, b]: [f64; 3]| [byte(r), byte(g), byte(b), 255])?;
        return Ok(colours.unwrap_or_default());
    }
    match rows_in(object, |colour: [f64; 4]| colour.map(byte))? {
        Some(colours) => Ok(colours),
        None => object.extract(),
    }
}

#[pymethods]
impl Mesh {
    /// The mesh of vertices, an array of shape (n, 3), and faces, places of vertices in an array of shape (m, 3) or (m, 4),
    /// or a list of both kinds. A face of four with its last two corners the same is a triangle.
    ///
    /// Normals have shape (n, 3); colours, from 0 to 255, shape (n, 3) or (n, 4) with opacity.
    #[new]
    #[pyo3(signature = (vertices, faces, *, normals=None, colors=None))]
    fn new(
        vertices: &Bound<'_, PyAny>,
        faces: &Bound<'_, PyAny>,
        normals: Option<&Bound<'_, PyAny>>,
        colors: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let normals = normals.map(points_in).transpose()?.unwrap_or_default();
        let normals: Vec<Vector3> = normals.into_iter().map(Point3::to_vector).collect();
        let colours = colors.map(colours_in).transpose()?.unwrap_or_default();
        Kernel::from_parts(points_in(vertices)?, faces_in(faces)?, normals, colours)
            .map(Self::from)
            .map_err(kernel)
    }

    /// The vertices as an array of shape (n, 3).
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        points_out(py, self.0.vertices())
    }

    /// The faces as places of vertices, an array of shape (m, 4); the last two corners of a triangle are the same.
    #[getter]
    fn faces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let quad = |face: &MeshFace| match *face {
            MeshFace::Triangle([a, b, c]) => [a, b, c, c],
            MeshFace::Quad(corners) => corners,
        };
        if has_numpy(py) {
            return rows_out(py, self.0.faces().len(), self.0.faces().iter().map(quad));
        }
        Ok(PyList::new(py, self.0.faces().iter().map(|face| face.indices().to_vec()))?.into_any())
    }

    /// The faces cut into triangles, as places of vertices in an array of shape (k, 3).
    #[getter]
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let triangles: Vec<[u32; 3]> = self.0.faces().iter().flat_map(|face| face.triangles()).collect();
        if has_numpy(py) {
            return rows_out(py, triangles.len(), triangles.into_iter());
        }
        Ok(PyList::new(py, triangles)?.into_any())
    }

    /// The normals at the vertices as an array of shape (n, 3): those that it has, or means of its faces' normals.
    #[getter]
    fn normals<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        if self.0.normals().is_empty() {
            return vectors_out(py, &py.detach(|| self.0.vertex_normals()));
        }
        vectors_out(py, self.0.normals())
    }

    /// The normals of the faces as an array of shape (m, 3).
    #[getter]
    fn face_normals<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        vectors_out(py, &py.detach(|| self.0.face_normals()))
    }

    /// The colours of the vertices as an array of shape (n, 4), from 0 to 255; none where it has none.
    #[getter]
    fn colors<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let colours = self.0.colours();
        if colours.is_empty() {
            return Ok(None);
        }
        if has_numpy(py) {
            return rows_out::<4, u8>(py, colours.len(), colours.iter().copied()).map(Some);
        }
        Ok(Some(PyList::new(py, colours.iter().map(|[r, g, b, a]| (*r, *g, *b, *a)))?.into_any()))
    }

    /// The area in square units.
    #[getter]
    fn area(&self, py: Python<'_>) -> f64 {
        py.detach(|| self.0.area())
    }

    /// The volume in cubic units of a closed mesh; negative where its normals point inward.
    #[getter]
    fn volume(&self, py: Python<'_>) -> PyResult<f64> {
        if !self.0.is_closed() {
            return Err(GeometryError::new_err("a mesh that is open encloses no volume"));
        }
        Ok(py.detach(|| self.0.volume()))
    }

    /// The mean of all points: of the volume of a closed mesh, else of the area.
    #[getter]
    fn centroid(&self) -> PyResult<Point> {
        let of_volume = self.0.is_closed().then(|| self.0.volume_and_centroid().1).flatten();
        let found = of_volume.or_else(|| self.0.area_and_centroid().1);
        found.map(Point).ok_or_else(|| GeometryError::new_err("a mesh without area has no centroid"))
    }

    /// Whether every edge has a face on both sides.
    #[getter]
    fn is_closed(&self) -> bool {
        self.0.is_closed()
    }

    /// Whether no edge has more than two faces.
    #[getter]
    fn is_manifold(&self) -> bool {
        self.0.is_manifold()
    }

    /// The box along the world's axes around it; none for a mesh without vertices.
    #[getter]
    fn bounding_box(&self) -> Option<BoundingBox> {
        self.0.bounding_box().map(BoundingBox)
    }

    /// The mesh under a transform.
    pub(crate) fn transformed(&self, transform: &Transform) -> PyResult<Self> {
        self.0.transformed(&transform.0).map(Self::from).map_err(kernel)
    }

    /// The form that rhino3dm and Rhino.Compute speak, as JSON text.
    pub(crate) fn to_json(&self) -> PyResult<String> {
        state::mesh(&self.0)
    }

    fn __len__(&self) -> usize {
        self.0.faces().len()
    }

    fn __bool__(&self) -> bool {
        true
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| *other.get() == *self)
    }

    fn __repr__(&self) -> String {
        format!("<Mesh: {} vertices, {} faces>", self.0.vertices().len(), self.0.faces().len())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<state::Reduced<'py>> {
        state::reduced(py, self.to_json()?, "Mesh")
    }
}
