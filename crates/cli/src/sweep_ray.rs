//! `katydid sweep --ray`: the Python package solves the points on a cluster.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Program;
use crate::sweep::SweepArgs;

/// Prints which of the packages are there, each on a line; older versions of Python than 3.9 are told by their number.
const ASK: &str = "\
import importlib.util as u, sys
print('%d.%d' % sys.version_info[:2])
for name in ('katydid', 'ray'):
    print(u.find_spec(name) is not None)
try:
    from katydid._katydid import __version__
    print(__version__)
except ImportError as error:
    print(error)
";
/// The module of the package that takes the words of `katydid sweep`.
const MODULE: &str = "katydid.studies";

/// Calls the module with the words of this call; its exit code is ours.
pub(crate) fn sweep(args: &SweepArgs, address: &str, program: &Program) -> Result<u8, String> {
    let python = python(args, program)?;
    check(&python)?;
    let mut command = Command::new(&python);
    command
        .args(["-m", MODULE, "--engine", "ray", "--address", address, "--"])
        .args(program.words_of_sweep());
    let status = command.status().map_err(|error| format!("{}: {error}", python.display()))?;
    status.code().and_then(|code| u8::try_from(code).ok()).ok_or_else(|| {
        "the process that ran the sweep was ended from outside; the same command goes on where it stopped"
            .to_owned()
    })
}

/// The Python that this command runs in; else that which runs scripts.
fn python(args: &SweepArgs, program: &Program) -> Result<PathBuf, String> {
    if let Some(python) = program.python() {
        return Ok(python);
    }
    let found = katydid_script::find(args.definition.scripts.python.as_deref(), Some(&args.definition.file));
    found.map(|interpreter| interpreter.0).map_err(|error| format!("--ray: {error}"))
}

/// An error that says what is missing, before anything is started.
fn check(python: &Path) -> Result<(), String> {
    let place = python.display();
    let failed = |why: &dyn std::fmt::Display| format!("--ray: {place} does not run: {why}");
    let asked = Command::new(python).args(["-c", ASK]).output().map_err(|error| failed(&error))?;
    if !asked.status.success() {
        return Err(failed(&String::from_utf8_lossy(&asked.stderr).trim()));
    }
    let text = String::from_utf8_lossy(&asked.stdout);
    let mut lines = text.lines().map(str::trim);
    let mut next = || lines.next().unwrap_or_default();
    let (version, katydid, ray, ours) = (next(), next(), next(), next());
    let install =
        |what: &str| format!("--ray: {place} (Python {version}) has no {what}: pip install \"katydid[ray]\"");
    match (katydid, ray) {
        ("True", "True") if ours == env!("CARGO_PKG_VERSION") => Ok(()),
        ("True", "True") => Err(format!(
            "--ray: the package of {place} is not that of this program, {}: {ours}",
            env!("CARGO_PKG_VERSION")
        )),
        ("True", _) => Err(install("package ray")),
        _ => Err(install("package katydid")),
    }
}

/// The words behind `sweep` without `--ray ADDRESS`.
pub(crate) fn without_ray(words: &[OsString]) -> Vec<OsString> {
    let mut kept = Vec::new();
    let mut words = words.iter().skip_while(|word| *word != "sweep").skip(1);
    while let Some(word) = words.next() {
        if word == "--ray" {
            words.next();
        } else if !word.to_string_lossy().starts_with("--ray=") {
            kept.push(word.clone());
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_words_are_handed_on_without_the_address() {
        let words = |text: &str| -> Vec<OsString> { text.split(' ').map(OsString::from).collect() };
        let wanted = words("a.kd --plan p.json -o out --retry");
        for text in [
            "sweep a.kd --plan p.json --ray auto -o out --retry",
            "-m katydid sweep a.kd --ray=10.0.0.1:6379 --plan p.json -o out --retry",
        ] {
            assert_eq!(without_ray(&words(text)), wanted);
        }
    }
}
