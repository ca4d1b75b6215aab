//! What stands in for scripts that may not run.

use crate::script::{ScriptDone, ScriptTask, Scripts, Unrun};
use katydid_definition::document::ScriptLanguage;

/// Runs no script, and says of each what to do about it.
#[derive(Debug, Clone)]
pub struct Refused {
    /// What to do, as the end of a sentence.
    advice: String,
}

impl Refused {
    /// Scripts are refused with this advice: `run it with --allow-scripts`, say.
    pub fn new(advice: impl Into<String>) -> Self {
        Self { advice: advice.into() }
    }
}

impl Scripts for Refused {
    fn runs(&self, language: &ScriptLanguage) -> bool {
        matches!(language, ScriptLanguage::Python3 | ScriptLanguage::IronPython)
    }

    fn run(&self, task: &ScriptTask<'_>) -> Result<ScriptDone, Unrun> {
        let (title, language) = (task.object.title(), &task.script.language);
        Err(Unrun::Unsupported(format!(
            "{title}: this {language} script was not run, since a script is a program that could do anything here: \
             {}",
            self.advice
        )))
    }
}
