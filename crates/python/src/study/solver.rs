use std::ffi::OsString;

use katydid_component::Cancel;
use katydid_study::{Batch, Plan, PointSolver};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::cells::points_in;
use super::{Files, failed, opened};
use crate::work::listening;

/// A definition that is prepared once, in a process of its own, and solves the points of a study that it is given.
#[pyclass(frozen, module = "katydid")]
pub(crate) struct StudySolver {
    solver: std::sync::Arc<PointSolver>,
    cancel: Cancel,
}

/// A file of a point: its path in the folder of the study, and what is in it.
type File<'py> = (String, Bound<'py, PyBytes>);

#[pymethods]
impl StudySolver {
    /// Opens the definition that the words of `katydid sweep` name; its files lie where `files` says: the definition, the model
    /// or None, the plan. The inputs are those of these names.
    #[new]
    #[pyo3(signature = (words, files, inputs))]
    fn new(
        py: Python<'_>,
        words: Vec<OsString>,
        files: Option<Files>,
        inputs: Vec<String>,
    ) -> PyResult<Self> {
        py.detach(|| {
            let call = opened(words, files)?;
            let plan = Plan::space(&call.plan, &call.document, &inputs).map_err(failed)?;
            let cancel = call.settings.cancel;
            let solver =
                PointSolver::new(call.document, call.options, &plan, cancel.clone()).map_err(failed)?;
            Ok(Self { solver: solver.into(), cancel })
        })
    }

    /// Solves points; gives their records, and their pictures and geometry by the names of the files.
    fn solve<'py>(
        &self,
        py: Python<'py>,
        points: Vec<Bound<'py, PyBytes>>,
    ) -> PyResult<(Bound<'py, PyBytes>, Vec<File<'py>>)> {
        let points = points_in(points)?;
        let solver = std::sync::Arc::clone(&self.solver);
        let work = move |_: &std::sync::mpsc::Sender<_>| solver.solve(&points);
        let Batch { records, things } = listening(py, &self.cancel, work, |_, ()| Ok(()))?.map_err(failed)?;
        let files = things.into_iter().map(|thing| (thing.name, PyBytes::new(py, &thing.bytes)));
        Ok((PyBytes::new(py, &records), files.collect()))
    }
}
