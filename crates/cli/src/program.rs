use std::ffi::OsString;
use std::path::PathBuf;

use katydid_server::compute::Command;

/// How this program is started again, as the process behind a compute server.
#[derive(Debug, Clone)]
pub struct Program {
    file: Result<PathBuf, String>,
    words: Vec<OsString>,
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
        Self { file, words }
    }

    /// Another program that runs the command with these words: Python with `-m katydid`, say.
    pub fn other(file: PathBuf, words: Vec<OsString>) -> Self {
        Self { file: Ok(file), words }
    }

    /// The call with one more word.
    pub(crate) fn again(&self, word: &str) -> Result<Command, String> {
        let mut words = self.words.clone();
        words.push(word.into());
        Ok(Command { program: self.file.clone()?, words })
    }
}
