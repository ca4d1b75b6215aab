//! Models in files: .3dm and other programs' forms.

use std::path::{Path, PathBuf};

use katydid_3dm::{
    Attributes, BrepObject, Limits, MeshObject, Model as Kernel, ModelObject as Archived, Object, SubDObject,
};
use katydid_data::Value;
use katydid_exchange::{Conversion, Format, Options, Scene};
use katydid_geometry::Units;
use pyo3::exceptions::{PyIndexError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::definition::extension;
use crate::errors::file;
use crate::geometry::{Brep, Curve, Mesh, Point, SubD, Surface};
use crate::values::{Colour, Item, to_python};

/// Files larger than this are not read.
const LARGEST: u64 = 4 << 30;

/// One object of a model: its geometry, and what is said of it.
#[pyclass(frozen, get_all, module = "katydid")]
pub(crate) struct ModelObject {
    /// The geometry.
    geometry: Py<PyAny>,
    /// The name; may be empty.
    name: String,
    /// The layer, with those it lies under: "Walls::Outer".
    layer: String,
    /// Its own colour; none where it has that of its layer.
    color: Option<Colour>,
}

#[pymethods]
impl ModelObject {
    /// Geometry with a name, a layer and a colour.
    #[new]
    #[pyo3(signature = (geometry, *, name="", layer="Default", color=None))]
    fn new(geometry: Py<PyAny>, name: &str, layer: &str, color: Option<Colour>) -> Self {
        Self { geometry, name: name.to_owned(), layer: layer.to_owned(), color }
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!("<ModelObject '{}' on '{}': {}>", self.name, self.layer, self.geometry.bind(py).repr()?))
    }
}

/// What a file holds: a sequence of objects.
#[pyclass(frozen, sequence, module = "katydid")]
pub(crate) struct Model {
    /// The objects.
    #[pyo3(get)]
    objects: Vec<Py<ModelObject>>,
    /// The length unit, such as "Millimeters".
    #[pyo3(get)]
    units: String,
    /// The distance within which things count as one.
    #[pyo3(get)]
    tolerance: f64,
    /// What could not be read, in words.
    #[pyo3(get)]
    left_out: Vec<String>,
}

#[pymethods]
impl Model {
    /// The geometry of all objects.
    #[getter]
    fn geometry(&self, py: Python<'_>) -> Vec<Py<PyAny>> {
        self.objects.iter().map(|object| object.get().geometry.clone_ref(py)).collect()
    }

    fn __len__(&self) -> usize {
        self.objects.len()
    }

    fn __getitem__(&self, py: Python<'_>, index: isize) -> PyResult<Py<ModelObject>> {
        let count = self.objects.len();
        let place = if index < 0 { index.checked_add_unsigned(count) } else { Some(index) };
        let found =
            place.and_then(|place| usize::try_from(place).ok()).and_then(|place| self.objects.get(place));
        found
            .map(|object| object.clone_ref(py))
            .ok_or_else(|| PyIndexError::new_err(format!("there are {count} objects")))
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        PyTuple::new(py, self.objects.iter().map(|object| object.bind(py)))?.call_method0("__iter__")
    }

    fn __repr__(&self) -> String {
        format!("<Model: {} objects, {}>", self.objects.len(), self.units)
    }
}

/// Reads a model: .3dm, .step, .obj, .stl, .ply, .glb or .gltf.
///
/// What a .3dm file holds and cannot be read is skipped, and told by `left_out`.
#[pyfunction]
pub(crate) fn read(py: Python<'_>, path: PathBuf) -> PyResult<Model> {
    let (model, left_out) = py.detach(|| read_model(&path))?;
    let mut objects = Vec::with_capacity(model.objects.len());
    for object in &model.objects {
        let value = match &object.geometry {
            // As what it was written as, and not as what a definition makes of it.
            Object::Brep(brep) => Some(Bound::new(py, Brep::from(brep.brep.clone()))?.into_any()),
            geometry => Value::from_object(geometry.clone(), &object.user_data)
                .map(|value| to_python(py, Some(&value)))
                .transpose()?,
        };
        let Some(geometry) = value else { continue };
        let attributes = &object.attributes;
        let color = attributes.colour.map(|[r, g, b, a]| Colour(katydid_data::Colour::argb(a, r, g, b)));
        let layer = attributes.layer.and_then(|layer| model.layer_path(layer)).unwrap_or_default();
        let object = ModelObject { geometry: geometry.unbind(), name: attributes.name.clone(), layer, color };
        objects.push(Py::new(py, object)?);
    }
    Ok(Model { objects, units: model.units.name().to_owned(), tolerance: model.tolerance.absolute, left_out })
}

fn read_model(path: &Path) -> PyResult<(Kernel, Vec<String>)> {
    let extension = extension(path);
    if extension == "3dm" {
        let bytes = crate::definition::bytes(path, LARGEST)?;
        let model = Kernel::read(&bytes, &Limits::default()).map_err(|error| file(path, error))?;
        let left_out = model.warnings.iter().map(ToString::to_string).collect();
        return Ok((model, left_out));
    }
    let Some(format) = Format::from_extension(&extension) else {
        return Err(file(path, format!("models that end with .{extension} are not read")));
    };
    let bytes = crate::definition::bytes(path, LARGEST)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let scene = katydid_exchange::read_with(&bytes, format, &mut |name| {
        // The files that a .gltf names lie beside it; nothing elsewhere is opened.
        let beside = Path::new(name);
        let is_beside = beside.components().all(|part| matches!(part, std::path::Component::Normal(_)));
        let unsupported = katydid_exchange::Error::Unsupported;
        if !is_beside {
            return Err(unsupported(format!("data outside the folder of the file: {name}")));
        }
        std::fs::read(folder.join(beside)).map_err(|error| unsupported(format!("{name}: {error}")))
    });
    let scene = scene.map_err(|error| file(path, error))?;
    let left_out = scene.left_out.iter().map(ToString::to_string).collect();
    Ok((scene.to_model(), left_out))
}

/// Writes geometry, or objects with names, layers and colours, or a whole model: .3dm, .step, .obj, .stl, .ply, .glb,
/// .gltf or .svg. Gives what the form cannot hold, in words.
///
/// `units` is the name of a length unit in English, as "millimeters"; `tolerance` how far meshes and polylines may be from
/// what they stand for.
#[pyfunction]
#[pyo3(signature = (path, objects, *, units="millimeters", tolerance=0.001))]
pub(crate) fn write(
    py: Python<'_>,
    path: PathBuf,
    objects: &Bound<'_, PyAny>,
    units: &str,
    tolerance: f64,
) -> PyResult<Vec<String>> {
    let unit = katydid_data::units::named(units);
    let units: Units =
        unit.ok_or_else(|| PyValueError::new_err(format!("there is no unit called {units:?}")))?;
    let mut model = Kernel { units, ..Kernel::default() };
    model.tolerance.absolute = tolerance;
    if let Ok(object) = geometry(objects) {
        add(&mut model, object, "", "Default", None);
    } else {
        for object in objects.try_iter()? {
            let object = object?;
            match object.cast::<ModelObject>() {
                Ok(named) => {
                    let named = named.get();
                    let geometry = geometry(named.geometry.bind(py))?;
                    add(&mut model, geometry, &named.name, &named.layer, named.color);
                }
                Err(_) => add(&mut model, geometry(&object)?, "", "Default", None),
            }
        }
    }
    if model.layers.is_empty() {
        model.layer_at("Default");
    }
    py.detach(|| write_model(&model, &path))
}

fn add(model: &mut Kernel, geometry: Object, name: &str, layer: &str, color: Option<Colour>) {
    let layer = model.layer_at(layer);
    let colour = color.map(|color| [color.0.r, color.0.g, color.0.b, color.0.a]);
    let attributes =
        Attributes { name: name.to_owned(), layer: Some(layer), colour, ..Attributes::default() };
    model.objects.push(Archived { attributes, ..geometry.into() });
}

/// A Python object as an object of a model.
fn geometry(object: &Bound<'_, PyAny>) -> PyResult<Object> {
    if let Ok(point) = object.cast::<Point>() {
        return Ok(Object::Point(point.get().0));
    }
    if let Ok(curve) = object.cast::<Curve>() {
        return Ok(Object::Curve((*curve.get().0).clone()));
    }
    if let Ok(surface) = object.cast::<Surface>() {
        return Ok(Object::Surface((*surface.get().0).clone()));
    }
    if let Ok(brep) = object.cast::<Brep>() {
        return Ok(Object::Brep(std::boxed::Box::new(BrepObject::from((*brep.get().0).clone()))));
    }
    if let Ok(mesh) = object.cast::<Mesh>() {
        return Ok(Object::Mesh(std::boxed::Box::new(MeshObject::from(&*mesh.get().0))));
    }
    if let Ok(subd) = object.cast::<SubD>() {
        return Ok(Object::SubD(std::boxed::Box::new(SubDObject::from(&*subd.get().0))));
    }
    if let Ok(item) = object.cast::<Item>()
        && let Value::Kept(raw) = &item.get().0
    {
        return Ok(Object::Kept((**raw).clone()));
    }
    let name = object.get_type().name()?;
    Err(PyTypeError::new_err(format!("a {name} is no geometry that a model holds")))
}

/// Writes a model whole or not at all; gives what the form cannot hold.
pub(crate) fn write_model(model: &Kernel, path: &Path) -> PyResult<Vec<String>> {
    let extension = extension(path);
    let (bytes, left_out) = if extension == "3dm" {
        let (bytes, losses) = model.write_what_fits(70).map_err(|error| file(path, error))?;
        (bytes, losses.iter().map(ToString::to_string).collect())
    } else {
        let Some(format) = Format::from_extension(&extension) else {
            return Err(file(path, format!("models that end with .{extension} are not written")));
        };
        let conversion = Conversion { exact: format.is_exact(), ..Conversion::default() };
        let scene = Scene::from_model_with(model, &conversion);
        let mut bytes = Vec::new();
        let lost = katydid_exchange::write(&scene, format, &Options::default(), &mut bytes);
        let lost = lost.map_err(|error| file(path, error))?;
        (bytes, lost.iter().map(ToString::to_string).collect())
    };
    katydid_session::write_file(path, &bytes).map_err(|error| file(path, error))?;
    Ok(left_out)
}
