use std::path::PathBuf;
use std::sync::Arc;

use katydid_compute::definition::Interface;
use katydid_session::{BakeOptions, bake};
use katydid_solver::{Engine, Summary};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyTuple};

use super::picture::{self, Look};
use super::{Message, Output, output};
use crate::errors::SolveError;
use crate::values::Tree;

/// The results of a solve: a mapping of the names of outputs to trees.
///
/// Any other object of the definition is found by what its author calls it, or by its id, too.
#[pyclass(frozen, mapping, module = "katydid")]
pub(crate) struct Solution {
    engine: Arc<Engine>,
    interface: Arc<Interface>,
    outputs: Arc<Vec<Output>>,
    summary: Summary,
}

impl Solution {
    pub(super) fn new(
        engine: Arc<Engine>,
        interface: Arc<Interface>,
        outputs: Arc<Vec<Output>>,
        summary: Summary,
    ) -> Self {
        Self { engine, interface, outputs, summary }
    }

    /// The engine with the results; a copy shares them.
    pub(super) fn engine(&self) -> Engine {
        Engine::clone(&self.engine)
    }

    fn find(&self, name: &str) -> Option<Tree> {
        let plain = name.strip_prefix("RH_OUT:").map_or(name, str::trim);
        let output = self.outputs.iter().find(|output| output.name() == plain);
        output
            .map(|output| output.tree(&self.engine))
            .or_else(|| output::anywhere(&self.engine, name))
            .map(Tree)
    }
}

#[pymethods]
impl Solution {
    /// What the components say, errors, warnings and remarks, in the order of the definition.
    #[getter]
    fn messages(&self) -> Vec<Message> {
        Message::all(&self.engine)
    }

    /// Whether no component reported an error.
    #[getter]
    fn ok(&self) -> bool {
        !self.messages().iter().any(Message::is_error)
    }

    /// The solution itself; raises `SolveError` with all errors where there are any.
    fn check(slf: PyRef<'_, Self>) -> PyResult<PyRef<'_, Self>> {
        let errors: Vec<String> = slf.messages().iter().filter(|m| m.is_error()).map(Message::line).collect();
        if errors.is_empty() { Ok(slf) } else { Err(SolveError::new_err(errors.join("\n"))) }
    }

    /// How long the solve took, in milliseconds.
    #[getter]
    fn milliseconds(&self) -> f64 {
        1e3 * self.summary.time.as_secs_f64()
    }

    /// How many objects were computed; the others had their results from before.
    #[getter]
    fn solved(&self) -> usize {
        self.summary.solved
    }

    /// The names of the outputs.
    fn keys(&self) -> Vec<String> {
        self.outputs.iter().map(|output| output.name().to_owned()).collect()
    }

    /// The trees of the outputs.
    fn values(&self) -> Vec<Tree> {
        self.outputs.iter().map(|output| Tree(output.tree(&self.engine))).collect()
    }

    /// Names and trees of the outputs.
    fn items(&self) -> Vec<(String, Tree)> {
        self.keys().into_iter().zip(self.values()).collect()
    }

    /// The tree of an output or object, or what is given in its place.
    #[pyo3(signature = (name, default=None))]
    fn get<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        default: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        match self.find(name) {
            Some(tree) => Ok(Some(Bound::new(py, tree)?.into_any())),
            None => Ok(default),
        }
    }

    fn __getitem__(&self, name: &str) -> PyResult<Tree> {
        self.find(name).ok_or_else(|| {
            let names = self.keys().join("', '");
            PyKeyError::new_err(format!("no output or object is called '{name}'; the outputs are '{names}'"))
        })
    }

    fn __contains__(&self, name: &str) -> bool {
        self.find(name).is_some()
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        PyTuple::new(py, self.keys())?.call_method0("__iter__")
    }

    fn __len__(&self) -> usize {
        self.outputs.len()
    }

    fn __bool__(&self) -> bool {
        true
    }

    /// A picture of what the definition shows, as PNG. `view` is "perspective", "top", "front", "right" or "iso".
    #[pyo3(signature = (size=(800, 600), *, view=None))]
    fn picture<'py>(
        &self,
        py: Python<'py>,
        size: (u32, u32),
        view: Option<&str>,
    ) -> PyResult<Bound<'py, PyBytes>> {
        picture::result(py, self.engine(), &Look::new(size, view)?)
    }

    /// What the definition shows, or what is marked as output, as one binary glTF file.
    fn to_glb<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        picture::glb(py, self.engine())
    }

    /// Writes what is marked as output, or, where nothing is, what the definition shows, to a file: .3dm, .step, .obj,
    /// .stl, .ply, .glb, .gltf or .svg. Gives what the form cannot hold, in words.
    fn write(&self, py: Python<'_>, path: PathBuf) -> PyResult<Vec<String>> {
        let engine = self.engine();
        py.detach(|| {
            let baked = bake(&engine, BakeOptions::default());
            let mut left_out = baked.left_out;
            left_out.extend(crate::files::write_model(&baked.model, &path)?);
            Ok(left_out)
        })
    }

    fn __repr__(&self) -> String {
        let errors = self.messages().iter().filter(|message| message.is_error()).count();
        let problems = if self.interface.problems.is_empty() { "" } else { ", names that are not unique" };
        format!(
            "<Solution: {} outputs, {errors} errors, {:.1} ms{problems}>",
            self.outputs.len(),
            self.milliseconds()
        )
    }
}
