//! The exceptions of the package. Each is a [`KatydidError`], and its text names the thing and the reason.

use std::fmt::Display;

use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyMemoryError};
use pyo3::prelude::*;

create_exception!(
    katydid,
    KatydidError,
    PyException,
    "What went wrong in Katydid; all its exceptions are of this class."
);
create_exception!(katydid, FileError, KatydidError, "A file cannot be read or written.");
create_exception!(
    katydid,
    InputError,
    KatydidError,
    "There is no such input, or it does not take that value."
);
create_exception!(katydid, SolveError, KatydidError, "Components of a definition reported errors.");
create_exception!(katydid, LimitError, KatydidError, "A limit of time, memory or items was reached.");
create_exception!(katydid, GeometryError, KatydidError, "Geometry that cannot be made of what was given.");
create_exception!(katydid, NotSupportedError, KatydidError, "What Katydid does not do, by its name.");

/// What the kernel refused, as an exception.
pub(crate) fn kernel(error: katydid_geometry::Error) -> PyErr {
    match error {
        katydid_geometry::Error::Unsupported(what) => {
            NotSupportedError::new_err(format!("not supported: {what}"))
        }
        error => GeometryError::new_err(error.to_string()),
    }
}

/// A file that cannot be used, with its name.
pub(crate) fn file(path: &std::path::Path, why: impl Display) -> PyErr {
    FileError::new_err(format!("{}: {why}", path.display()))
}

/// Numbers in a Python object are no numbers, or too many for the memory.
pub(crate) fn too_large(count: usize) -> PyErr {
    PyMemoryError::new_err(format!("{count} items are more than there is memory for"))
}
