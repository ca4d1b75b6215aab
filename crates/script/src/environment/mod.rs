//! The packages of a definition: a virtual environment beside it, and a lock file with exact versions and hashes.
//!
//! It is pip that resolves and installs. Its report (`pip install --dry-run --report`, a stable format since pip 22.2) says
//! which archive of each package it would take; the lock holds those, and is what gets installed, with `--require-hashes`.

mod lock;

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

pub use lock::{Locked, Requirement};

use crate::interpreter::Interpreter;

/// The name of the lock file, beside the definition.
pub const LOCK: &str = "python-packages.lock";

/// The virtual environment of a folder, and its lock.
#[derive(Debug, Clone)]
pub struct Environment {
    folder: PathBuf,
}

impl Environment {
    /// That of the definitions in a folder.
    pub fn of_folder(folder: &Path) -> Self {
        Self { folder: folder.to_owned() }
    }

    /// Where its lock file lies.
    pub fn lock_file(&self) -> PathBuf {
        self.folder.join(LOCK)
    }

    /// Where the environment itself lies.
    pub fn place(&self) -> PathBuf {
        self.folder.join(".venv")
    }

    fn python(&self) -> PathBuf {
        self.place().join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python3" })
    }

    /// What the lock file holds; nothing where there is none.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn locked(&self) -> Result<Locked, String> {
        let file = self.lock_file();
        match std::fs::read_to_string(&file) {
            Ok(text) => Ok(Locked::read(&text)),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Locked::default()),
            Err(error) => Err(format!("{} could not be read: {error}", file.display())),
        }
    }

    /// Adds packages to those that were asked for before, and installs all of them. The lock file changes when that went
    /// well, and not before.
    ///
    /// # Errors
    /// A requirement that is none, and what pip says.
    pub fn add(&self, base: &Interpreter, packages: &[Requirement]) -> Result<Locked, String> {
        let asked = lock::merged(&self.locked()?.asked, packages);
        self.make(base)?;
        let mut words: Vec<OsString> =
            ["install", "--dry-run", "--ignore-installed", "--report", "-"].map(Into::into).into();
        words.extend(asked.iter().map(|one| one.text().into()));
        let locked = Locked::of_report(&self.pip(&words)?, asked)?;
        self.install(&locked)?;
        Ok(locked)
    }

    /// Makes the environment as the lock file says.
    ///
    /// # Errors
    /// There is no lock file, and what pip says.
    pub fn sync(&self, base: &Interpreter) -> Result<Locked, String> {
        let locked = self.locked()?;
        if locked.lines.is_empty() {
            return Err(format!("there is no {LOCK} in {}", self.folder.display()));
        }
        self.make(base)?;
        self.install(&locked)?;
        Ok(locked)
    }

    fn install(&self, locked: &Locked) -> Result<(), String> {
        let failed =
            |error: &std::io::Error| format!("{} could not be written: {error}", self.lock_file().display());
        let mut file = tempfile::Builder::new()
            .prefix(".python-packages")
            .tempfile_in(&self.folder)
            .map_err(|error| failed(&error))?;
        file.write_all(locked.text().as_bytes()).map_err(|error| failed(&error))?;
        let words = ["install", "--require-hashes", "--no-deps", "-r"].map(OsString::from);
        let words: Vec<OsString> = words.into_iter().chain([file.path().into()]).collect();
        self.pip(&words)?;
        file.persist(self.lock_file()).map_err(|error| failed(&error.error))?;
        Ok(())
    }

    /// The environment, with pip in it.
    fn make(&self, base: &Interpreter) -> Result<(), String> {
        if !self.python().is_file() {
            let place = self.place();
            let made = output(Command::new(&base.0).args(["-I", "-m", "venv"]).arg(&place));
            made.map_err(|why| {
                format!(
                    "{} could not be made (on Debian and Ubuntu: apt install python3-venv): {why}",
                    place.display()
                )
            })?;
        }
        // An environment that another program made may lack it.
        if output(Command::new(self.python()).args(["-I", "-m", "pip", "--version"])).is_err() {
            output(Command::new(self.python()).args(["-I", "-m", "ensurepip"]))
                .map_err(|why| format!("{} has no pip: {why}", self.place().display()))?;
        }
        Ok(())
    }

    fn pip(&self, words: &[OsString]) -> Result<Vec<u8>, String> {
        let mut command = Command::new(self.python());
        command.args(["-I", "-m", "pip", "--disable-pip-version-check", "--no-input", "--quiet"]).args(words);
        output(&mut command)
    }
}

/// What a program prints; where it fails, the last lines of what it said.
fn output(command: &mut Command) -> Result<Vec<u8>, String> {
    let outcome = command.stdin(Stdio::null()).output();
    let name = || command.get_program().to_string_lossy().into_owned();
    let outcome = outcome.map_err(|error| format!("{} could not be started: {error}", name()))?;
    if outcome.status.success() {
        return Ok(outcome.stdout);
    }
    let said = String::from_utf8_lossy(&outcome.stderr);
    let lines: Vec<&str> = said.lines().filter(|line| !line.trim().is_empty()).collect();
    let last = lines.get(lines.len().saturating_sub(4)..).unwrap_or_default().join("\n");
    Err(if last.is_empty() { format!("{} ended with {}", name(), outcome.status) } else { last })
}
