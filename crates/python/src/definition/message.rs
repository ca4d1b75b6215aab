use katydid_component::Level;
use katydid_solver::Engine;
use pyo3::prelude::*;

/// What a component says of its run.
#[pyclass(frozen, get_all, module = "katydid")]
#[derive(Debug, Clone)]
pub(crate) struct Message {
    /// "error", "warning" or "remark".
    level: &'static str,
    /// What it says.
    text: String,
    /// The name of the component.
    component: String,
    /// What its author calls it.
    nickname: String,
    /// The id of the object in the definition.
    id: String,
}

impl Message {
    /// The messages of all objects, in the order of the document.
    pub(super) fn all(engine: &Engine) -> Vec<Self> {
        let mut all = Vec::new();
        for (index, object) in engine.document().objects.iter().enumerate() {
            for message in engine.report(index).into_iter().flat_map(|report| &report.messages) {
                all.push(Self {
                    level: match message.level {
                        Level::Error => "error",
                        Level::Warning => "warning",
                        Level::Remark => "remark",
                    },
                    text: message.text.to_string(),
                    component: object.name.clone(),
                    nickname: object.title().to_owned(),
                    id: object.id.to_string(),
                });
            }
        }
        all
    }

    /// Whether it is an error.
    pub(super) fn is_error(&self) -> bool {
        self.level == "error"
    }

    /// The line that tells it.
    pub(super) fn line(&self) -> String {
        format!("{}: {} ({}): {}", self.level, self.nickname, self.id, self.text)
    }
}

#[pymethods]
impl Message {
    fn __str__(&self) -> String {
        self.line()
    }

    fn __repr__(&self) -> String {
        format!("<Message {}>", self.line())
    }
}
