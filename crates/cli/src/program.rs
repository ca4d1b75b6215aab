use std::ffi::OsString;
use std::path::PathBuf;

use katydid_server::compute::Command;

/// How this program is started again, as the process behind a compute server.
#[derive(Debug, Clone)]
pub struct Program {
    file: Result<PathBuf, String>,
    words: Vec<OsString>,
    /// Whether the file is a Python interpreter that has the command for a module.
    is_python: bool,
}

impl Program {
    /// The program that runs, called with the same words (without its name).
    pub fn this(words: Vec<OsString>) -> Self {
        // By that name it is found when it has been replaced since.
        let file = if cfg!(target_os = "linux") {
            Ok(PathBuf::from("/proc/self/exe"))
        } else {
            std::env::current_exe().map_err(|error| format!("where the program is cannot be told: {error}"))
        };
        Self { file, words, is_python: false }
    }

    /// A Python interpreter that runs the command with these words: `-m katydid` and so on.
    pub fn python_with(file: PathBuf, words: Vec<OsString>) -> Self {
        Self { file: Ok(file), words, is_python: true }
    }

    /// The call with one more word.
    pub(crate) fn again(&self, word: &str) -> Result<Command, String> {
        let mut words = self.words.clone();
        words.push(word.into());
        Ok(Command { program: self.file.clone()?, words })
    }

    /// The Python interpreter, where it is one that runs the command.
    pub(crate) fn python(&self) -> Option<PathBuf> {
        self.file.clone().ok().filter(|_| self.is_python)
    }

    /// The words behind `sweep`, without `--ray` and its address.
    pub(crate) fn words_of_sweep(&self) -> Vec<OsString> {
        crate::sweep_ray::without_ray(&self.words)
    }
}
