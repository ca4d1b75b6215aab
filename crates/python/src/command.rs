use std::ffi::OsString;
use std::path::PathBuf;

use katydid_cli::Program;
use pyo3::prelude::*;

/// Runs the command `katydid` with words, the name of the program first; gives its exit code.
///
/// A server starts itself a second time: as `interpreter -m katydid`, with the same words.
#[pyfunction]
pub(crate) fn run_command(py: Python<'_>, words: Vec<OsString>, interpreter: PathBuf) -> u8 {
    let module = ["-m".into(), "katydid".into()];
    let again = module.into_iter().chain(words.iter().skip(1).cloned()).collect();
    py.detach(|| katydid_cli::run_command(words, &Program::python_with(interpreter, again)))
}
