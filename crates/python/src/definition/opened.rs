use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::SystemTime;

use katydid_component::{Cancel, Origin, Trust};
use katydid_compute::definition::Interface;
use katydid_data::DateTime;
use katydid_data::cast::Rules;
use katydid_script::{Bounds as ScriptBounds, CSharp, PythonMaker, find};
use katydid_solver::{Engine, Options, Progress, Refused, ScriptMaker, Summary};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::limits::Bounds;
use super::picture::Look;
use super::{Input, Output, Solution, input, picture, source};
use crate::errors::{InputError, file};
use crate::work::{Said, listening};

/// A Grasshopper definition.
///
/// It keeps its last results: a solve computes only what hangs on the inputs that changed. Several threads may solve it at
/// once.
#[pyclass(frozen, module = "katydid")]
pub(crate) struct Definition {
    path: PathBuf,
    state: Mutex<State>,
}

/// The document, its last results, and what was given for them.
#[derive(Clone)]
struct State {
    engine: Engine,
    given: Vec<usize>,
    interface: Arc<Interface>,
    outputs: Arc<Vec<Output>>,
    /// Counts the changes of the document: results of the one before are not kept.
    version: u64,
}

impl State {
    fn new(engine: Engine, version: u64) -> Self {
        let interface = Interface::of(engine.document());
        let outputs = Output::all(engine.document(), &interface);
        Self {
            engine,
            given: Vec::new(),
            interface: Arc::new(interface),
            outputs: Arc::new(outputs),
            version,
        }
    }
}

/// The moment by the clock of the machine, in UTC.
fn now() -> Option<DateTime> {
    DateTime::since_1970(SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).ok()?)
}

impl Definition {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// An engine with inputs given, and nothing given but them.
    fn given(&self, inputs: &[(String, Bound<'_, PyAny>)]) -> PyResult<State> {
        let mut state = self.state().clone();
        let mut trees = Vec::with_capacity(inputs.len());
        for (name, brought) in inputs {
            let document = state.engine.document();
            let at = katydid_session::find_input(document, name)
                .map_err(|error| InputError::new_err(error.to_string()))?;
            let Some(object) = document.objects.get(at) else { continue };
            trees.push((at, input::data(object, brought, &state.engine.options().rules)?));
        }
        for at in std::mem::take(&mut state.given) {
            if trees.iter().all(|(other, _)| *other != at) {
                state.engine.give(at, 0, None);
            }
        }
        for (at, tree) in trees {
            state.engine.give(at, 0, Some(tree));
            state.given.push(at);
        }
        Ok(state)
    }

    fn solved(
        &self,
        py: Python<'_>,
        inputs: &[(String, Bound<'_, PyAny>)],
        bounds: &Bounds,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Solution> {
        let State { mut engine, given, interface, outputs, version } = self.given(inputs)?;
        let cancel = Cancel::default();
        let options = engine.options_mut();
        options.limits = bounds.limits;
        options.cancel = cancel.clone();
        let wanted = progress.is_some();
        let work = move |say: &std::sync::mpsc::Sender<Said<Progress, (Engine, Summary)>>| {
            if wanted {
                let say = Mutex::new(say.clone());
                engine.options_mut().progress = Some(Arc::new(move |progress: &Progress| {
                    let say = say.lock().unwrap_or_else(PoisonError::into_inner);
                    // Only fails when nobody waits any more.
                    let _ = say.send(Said::News(progress.clone()));
                }));
            }
            let summary = engine.solve();
            engine.options_mut().progress = None;
            (engine, summary)
        };
        let tell = |_: Python<'_>, news: Progress| match progress {
            Some(progress) => progress.call1((news.done, news.total, news.name)).map(drop),
            None => Ok(()),
        };
        let (engine, summary) = listening(py, &cancel, work, tell)?;
        bounds.check(&engine, &summary)?;
        let engine = Arc::new(engine);
        let mut state = self.state();
        if state.version == version {
            state.engine = Engine::clone(&engine);
            state.given = given;
        }
        drop(state);
        Ok(Solution::new(engine, interface, outputs, summary))
    }

    /// What runs the scripts of a definition: those in Python where they are allowed, the others in any case.
    fn scripts(path: &Path, allowed: bool, python: Option<&Path>) -> Arc<dyn katydid_solver::Scripts> {
        let with_permission: Arc<dyn katydid_solver::Scripts> = if allowed {
            let bounds = ScriptBounds { memory: 4 << 30, ..ScriptBounds::default() };
            let definition = Some(std::path::absolute(path).unwrap_or_else(|_| path.to_owned()));
            PythonMaker { interpreter: find(python, Some(path)), bounds, definition }.make()
        } else {
            Arc::new(Refused::new("look at it, then open the definition with allow_scripts=True"))
        };
        Arc::new(CSharp::beside(with_permission))
    }
}

/// Names and values of a dict.
fn pairs<'py>(dict: Option<&Bound<'py, PyDict>>) -> PyResult<Vec<(String, Bound<'py, PyAny>)>> {
    dict.into_iter().flatten().map(|(name, value)| Ok((name.extract()?, value))).collect()
}

#[pymethods]
impl Definition {
    /// Opens a definition: a .gh, .ghx or .kd file. `katydid.open` is the same.
    ///
    /// Its Python scripts run only where `allow_scripts` says so: they are programs, and may do what you may. They run in
    /// a process of their own, with the interpreter `python`.
    #[new]
    #[pyo3(signature = (path, *, allow_scripts=false, python=None))]
    fn new(py: Python<'_>, path: PathBuf, allow_scripts: bool, python: Option<PathBuf>) -> PyResult<Self> {
        let read = py.detach(|| source::read(&path))?;
        let mut rules = Rules { now: now(), ..Rules::default() };
        rules.units = read.units.unwrap_or(rules.units);
        let files = Trust::own(Vec::new()).files(Origin::File(&path));
        let options = Options {
            rules,
            // Who opens a definition may read their own files; its paths start where it lies.
            files: files.clone(),
            // Definitions on other servers are asked for by nobody here: what Hops says of it is the command line's.
            remote: Some(katydid_compute::hops(&katydid_compute::Settings { files, ..Default::default() })),
            scripts: Some(Self::scripts(&path, allow_scripts, python.as_deref())),
            ..Options::default()
        };
        let state = State::new(Engine::new(read.document, options), 0);
        Ok(Self { path, state: Mutex::new(state) })
    }

    /// The file.
    #[getter]
    fn path(&self) -> PathBuf {
        self.path.clone()
    }

    /// The title that its author gave it, else the name of the file.
    #[getter]
    fn name(&self) -> String {
        let name = self.state().engine.document().header.name.clone();
        let stem =
            || self.path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        if name.is_empty() { stem() } else { name }
    }

    /// What it can be given, what is marked as input first.
    #[getter]
    fn inputs(&self) -> Vec<Input> {
        let state = self.state();
        Input::all(state.engine.document(), &state.interface)
    }

    /// What it gives: what is marked as output, or, where nothing is, what no wire leads on from.
    #[getter]
    fn outputs(&self) -> Vec<Output> {
        self.state().outputs.to_vec()
    }

    /// Whether `set` has changed it since it was opened.
    #[getter]
    fn is_changed(&self) -> bool {
        self.state().version > 0
    }

    /// What is wrong with its inputs and outputs, in words: two of one name, say.
    #[getter]
    fn problems(&self) -> Vec<String> {
        self.state().interface.problems.clone()
    }

    /// How many objects it has, notes and groups among them.
    fn __len__(&self) -> usize {
        self.state().engine.document().objects.len()
    }

    fn __bool__(&self) -> bool {
        true
    }

    /// Solves it with inputs by their names, as keywords or in a dict; what is not named has what the definition says. The
    /// definition itself does not change.
    ///
    /// An input takes one item, a list, an array, a dict of lists by paths, or a `Tree`. `progress` is called with the
    /// objects done, the objects to do, and the name of the last; an exception in it ends the solve, as Ctrl+C does.
    ///
    /// Errors of components are no exceptions: `messages` and `check()` of the solution tell them. Raises `InputError`,
    /// and `LimitError` where `time_limit`, in seconds, or `byte_limit` is reached.
    #[pyo3(signature = (inputs=None, *, time_limit=None, byte_limit=None, item_limit=None, progress=None, **named))]
    #[expect(clippy::too_many_arguments, reason = "they are keywords in Python")]
    fn solve(
        &self,
        py: Python<'_>,
        inputs: Option<&Bound<'_, PyDict>>,
        time_limit: Option<f64>,
        byte_limit: Option<u64>,
        item_limit: Option<u64>,
        progress: Option<&Bound<'_, PyAny>>,
        named: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Solution> {
        let mut all = pairs(inputs)?;
        all.extend(pairs(named)?);
        let bounds = Bounds::new(time_limit, byte_limit, item_limit)?;
        self.solved(py, &all, &bounds, progress)
    }

    /// Changes an input of the definition itself, as one does on its canvas, so that `save` keeps it.
    fn set(&self, name: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
        let failed = |error: katydid_session::InputError| InputError::new_err(error.to_string());
        let text = value.str()?.to_string();
        let mut state = self.state();
        let mut document = state.engine.document().clone();
        let at = katydid_session::find_input(&document, name).map_err(failed)?;
        if let Some(object) = document.objects.get_mut(at) {
            katydid_session::assign_input(object, &text).map_err(failed)?;
        }
        let options = state.engine.options().clone();
        let version = state.version + 1;
        *state = State::new(Engine::new(document, options), version);
        Ok(())
    }

    /// Saves the definition as .gh, .ghx or .kd, whole or not at all; gives what the form cannot hold, in words.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<Vec<String>> {
        let document = self.state().engine.document().clone();
        py.detach(|| {
            let (bytes, left_out) = source::write(&document, &path)?;
            katydid_session::write_file(&path, &bytes).map_err(|error| file(&path, error))?;
            Ok(left_out)
        })
    }

    /// A picture as PNG: of what the definition shows with its own inputs, or of its canvas where `canvas`.
    ///
    /// `view` is "perspective", "top", "front", "right" or "iso"; without one it is found.
    #[pyo3(signature = (size=(800, 600), *, canvas=false, view=None))]
    fn picture<'py>(
        &self,
        py: Python<'py>,
        size: (u32, u32),
        canvas: bool,
        view: Option<&str>,
    ) -> PyResult<Bound<'py, pyo3::types::PyBytes>> {
        let solution = self.solved(py, &[], &Bounds::new(None, None, None)?, None)?;
        if canvas {
            return picture::canvas(py, solution.engine(), size);
        }
        picture::result(py, solution.engine(), &Look::new(size, view)?)
    }

    fn __repr__(&self) -> String {
        let state = self.state();
        let (inputs, outputs) = (state.interface.inputs.len(), state.outputs.len());
        let count = state.engine.document().objects.len();
        drop(state);
        format!("<Definition '{}': {count} objects, {inputs} marked inputs, {outputs} outputs>", self.name())
    }
}

impl Definition {
    /// The document as it stands.
    pub(super) fn document(&self) -> katydid_definition::document::Document {
        self.state().engine.document().clone()
    }
}
