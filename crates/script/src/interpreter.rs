//! Which Python runs scripts.

use std::path::{Path, PathBuf};

/// The variable of the environment that names the interpreter.
const VARIABLE: &str = "KATYDID_PYTHON";

/// A Python interpreter, by its path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Interpreter(pub PathBuf);

/// Finds an interpreter: the one that was named, else that of `KATYDID_PYTHON`, else a virtual environment `.venv` or
/// `venv` beside the definition, else `python3` on the path of commands.
///
/// # Errors
/// There is none; what to install, in words.
pub fn find(named: Option<&Path>, definition: Option<&Path>) -> Result<Interpreter, String> {
    let variable = std::env::var_os(VARIABLE).filter(|path| !path.is_empty());
    if let Some(path) = named {
        return there(path, "--python");
    }
    if let Some(path) = variable {
        return there(Path::new(&path), VARIABLE);
    }
    let beside = definition.and_then(Path::parent).into_iter();
    let beside = beside.flat_map(|folder| [".venv", "venv"].map(|name| folder.join(name)));
    let beside =
        beside.flat_map(|folder| ["bin/python3", "Scripts/python.exe"].map(|name| folder.join(name)));
    let found = beside.chain(on_the_path()).find(|path| path.is_file());
    found.map(|path| Interpreter(full(path))).ok_or_else(|| {
        format!(
            "There is no Python to run scripts with: install Python 3.9 or later (on Debian and Ubuntu `apt install \
             python3`, elsewhere from python.org), or name one with --python or {VARIABLE}"
        )
    })
}

fn there(path: &Path, by: &str) -> Result<Interpreter, String> {
    let is_name = path.components().count() == 1;
    let named = || on_the_path_as(path).find(|path| path.is_file());
    match if is_name { named() } else { Some(path.to_owned()).filter(|path| path.is_file()) } {
        Some(path) => Ok(Interpreter(full(path))),
        None => Err(format!("There is no Python at {}, which {by} names", path.display())),
    }
}

/// The path from the root: the process starts in a folder of its own. Links stay, since an environment is known by them.
fn full(path: PathBuf) -> PathBuf {
    std::path::absolute(&path).unwrap_or(path)
}

fn on_the_path() -> impl Iterator<Item = PathBuf> {
    ["python3", "python3.exe", "python.exe"].into_iter().flat_map(|name| on_the_path_as(Path::new(name)))
}

fn on_the_path_as(name: &Path) -> impl Iterator<Item = PathBuf> {
    let name = name.to_owned();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    folders.into_iter().map(move |folder| folder.join(&name))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    #[test]
    fn an_environment_beside_the_definition_comes_before_the_machines() {
        let folder = tempfile::tempdir().unwrap();
        let bin = folder.path().join(".venv/bin");
        std::fs::create_dir_all(&bin).unwrap();
        std::fs::write(bin.join("python3"), "").unwrap();
        let found = find(None, Some(&folder.path().join("a.gh"))).unwrap();
        assert_eq!(found.0, bin.join("python3"));
    }

    #[test]
    fn a_path_from_here_becomes_one_from_the_root() {
        let found = find(Some(Path::new("./Cargo.toml")), None).unwrap();
        assert!(found.0.is_absolute() && found.0.ends_with("Cargo.toml"), "{found:?}");
    }

    #[test]
    fn one_that_is_named_and_not_there_is_no_other() {
        let why = find(Some(Path::new("/nowhere/python3")), None).unwrap_err();
        assert!(why.contains("/nowhere/python3") && why.contains("--python"), "{why}");
    }
}
