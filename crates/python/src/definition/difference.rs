//! What differs between two definitions.

use std::path::PathBuf;

use katydid_definition::diff::{Options, compare};
use pyo3::prelude::*;

use super::{Definition, source};

/// One thing that differs between two definitions.
#[pyclass(frozen, get_all, module = "katydid")]
#[derive(Debug, Clone)]
pub(crate) struct Change {
    /// What sort of change it is: "added", "removed", "wires", "value" and so on.
    kind: String,
    /// The clusters that it is in, from the outside in.
    clusters: Vec<String>,
    /// The object, as its author calls it; empty where the change is the document's.
    object: String,
    /// The object's id.
    id: Option<String>,
    /// What happened to it, in words.
    text: String,
}

#[pymethods]
impl Change {
    fn __str__(&self) -> String {
        if self.object.is_empty() { self.text.clone() } else { format!("{}: {}", self.object, self.text) }
    }

    fn __repr__(&self) -> String {
        format!("<Change {}>", self.__str__())
    }
}

/// A definition, or the file of one.
#[derive(FromPyObject)]
pub(crate) enum Either<'py> {
    Open(PyRef<'py, Definition>),
    File(PathBuf),
}

impl Either<'_> {
    fn document(self) -> PyResult<katydid_definition::document::Document> {
        match self {
            Self::Open(definition) => Ok(definition.document()),
            Self::File(path) => Ok(source::read(&path)?.document),
        }
    }
}

/// What changed from one definition to another, each an open one or a file. Places on the canvas count where `layout`.
#[pyfunction]
#[pyo3(signature = (old, new, *, layout=false))]
pub(crate) fn diff(old: Either<'_>, new: Either<'_>, layout: bool) -> PyResult<Vec<Change>> {
    let (old, new) = (old.document()?, new.document()?);
    let changes = compare(&old, &new, &Options { layout });
    Ok(changes
        .into_iter()
        .map(|change| Change {
            kind: change.kind.name().to_owned(),
            clusters: change.clusters,
            object: change.object,
            id: change.id.map(|id| id.to_string()),
            text: change.text,
        })
        .collect())
}
