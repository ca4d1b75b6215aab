use std::sync::{Mutex, PoisonError};

use katydid_data::cast::Rules;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// The functions of RhinoCommon that Python's `Rhino.Geometry` calls: what `katydid members --stdio` answers, without a
/// process of its own. `katydid.backend` speaks with it.
#[pyclass(frozen, module = "katydid")]
pub(crate) struct Host(Mutex<katydid_members::Host>);

#[pymethods]
impl Host {
    /// A host that holds no geometry yet.
    #[new]
    fn new() -> Self {
        Self(Mutex::new(katydid_script::host(Rules::default())))
    }

    /// Answers a message of `katydid.codec`, without its length; nothing for one that has no answer.
    fn answer<'py>(&self, py: Python<'py>, message: &[u8]) -> Option<Bound<'py, PyBytes>> {
        let answer = py.detach(|| self.0.lock().unwrap_or_else(PoisonError::into_inner).answer(message));
        answer.map(|answer| PyBytes::new(py, &answer))
    }
}
