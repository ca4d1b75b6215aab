//! Pictures and models of what definitions and geometry show.

use katydid_data::{Column, Path, Tree, Value};
use katydid_definition::kd;
use katydid_exchange::{Conversion, Format, Options as Written, Scene};
use katydid_picture::{Options, View};
use katydid_session::{BakeOptions, Registry, bake};
use katydid_solver::Engine;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::errors::{GeometryError, KatydidError};
use crate::work::interruptible;

/// How a picture looks.
pub(crate) struct Look(Options);

impl Look {
    pub(crate) fn new(size: (u32, u32), view: Option<&str>) -> PyResult<Self> {
        let view = match view {
            None => None,
            Some("perspective") => Some(View::Perspective),
            Some("top") => Some(View::Top),
            Some("front") => Some(View::Front),
            Some("right") => Some(View::Right),
            Some("iso") => Some(View::Isometric),
            Some(other) => {
                let names = "\"perspective\", \"top\", \"front\", \"right\" or \"iso\"";
                return Err(PyValueError::new_err(format!("view is {names}, not {other:?}")));
            }
        };
        Ok(Self(Options { size: size.into(), view, ..Options::default() }))
    }
}

fn png<'py>(
    py: Python<'py>,
    draw: impl FnOnce() -> Result<Vec<u8>, katydid_picture::Error> + Send + 'static,
) -> PyResult<Bound<'py, PyBytes>> {
    let drawn = interruptible(py, move || Ok(draw()))?;
    Ok(PyBytes::new(py, &drawn.map_err(|error| KatydidError::new_err(error.to_string()))?))
}

/// A picture of what a solved definition shows.
pub(super) fn result<'py>(py: Python<'py>, engine: Engine, look: &Look) -> PyResult<Bound<'py, PyBytes>> {
    let look = look.0.clone();
    png(py, move || katydid_picture::result(&engine, &look).drawing.to_png())
}

/// A picture of a definition's canvas, no larger than a size.
pub(super) fn canvas(py: Python<'_>, engine: Engine, size: (u32, u32)) -> PyResult<Bound<'_, PyBytes>> {
    let size = [f64::from(size.0), f64::from(size.1)];
    png(py, move || katydid_picture::canvas(&engine, &Options::default()).fitted(size).to_png())
}

/// What a solved definition shows, as one binary glTF file.
pub(super) fn glb(py: Python<'_>, engine: Engine) -> PyResult<Bound<'_, PyBytes>> {
    let made = interruptible(py, move || {
        let model = bake(&engine, BakeOptions::default()).model;
        let scene = Scene::from_model_with(&model, &Conversion::default());
        let mut bytes = Vec::new();
        Ok(katydid_exchange::write(&scene, Format::Glb, &Written::default(), &mut bytes).map(|_| bytes))
    })?;
    Ok(PyBytes::new(py, &made.map_err(|error| GeometryError::new_err(error.to_string()))?))
}

/// A definition that shows geometry, and nothing else.
fn showing(objects: &[Bound<'_, PyAny>]) -> PyResult<Engine> {
    let mut values: Vec<Option<Value>> = Vec::with_capacity(objects.len());
    for object in objects {
        let tree = crate::values::given(object, katydid_data::Kind::Geometry)?;
        values.extend(tree.column().iter());
    }
    let read = kd::read("geometry = Geometry()\n", &Registry);
    let document = read.map_err(|problems| KatydidError::new_err(problems.to_string()))?.document;
    let mut engine = Engine::new(document, katydid_solver::Options::default());
    engine.give(0, 0, Some(Tree::branch_at(Path::zero(), Column::of_options(values))));
    engine.solve();
    Ok(engine)
}

/// A picture of geometry, as PNG.
#[pyfunction]
#[pyo3(signature = (objects, size=(800, 600), *, view=None))]
pub(crate) fn geometry_picture<'py>(
    py: Python<'py>,
    objects: Vec<Bound<'py, PyAny>>,
    size: (u32, u32),
    view: Option<&str>,
) -> PyResult<Bound<'py, PyBytes>> {
    result(py, showing(&objects)?, &Look::new(size, view)?)
}

/// Geometry as one binary glTF file, for viewers.
#[pyfunction]
pub(crate) fn geometry_glb<'py>(
    py: Python<'py>,
    objects: Vec<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyBytes>> {
    glb(py, showing(&objects)?)
}
