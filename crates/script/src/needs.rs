//! What a script needs that is not here, told without running it.

use std::time::{Duration, Instant};

use katydid_data::cast::Rules;
use katydid_definition::document::{Script, ScriptLanguage};
use katydid_members::{Host, Value};

use crate::interpreter::Interpreter;
use crate::process::{Bounds, Heard, Process};

/// How long looking at one script may take.
const LONGEST: Duration = Duration::from_secs(20);

/// What a script needs that is not here.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Needs {
    /// Packages that cannot be imported.
    pub modules: Vec<String>,
    /// Packages that `# r:` and `# requirements:` lines ask for and that are not installed.
    pub packages: Vec<String>,
    /// Members of RhinoCommon, Grasshopper and the like, by full name.
    pub members: Vec<String>,
    /// Why the text is no Python, with the line.
    pub error: Option<String>,
}

impl Needs {
    /// Whether everything is here.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

/// Looks at scripts, and runs none.
#[derive(Debug)]
pub struct Examiner {
    process: Process,
    host: Host,
}

impl Examiner {
    /// One with an interpreter of its own.
    ///
    /// # Errors
    /// It could not be started.
    pub fn new(interpreter: &Interpreter) -> Result<Self, String> {
        Ok(Self {
            process: Process::start(interpreter, &Bounds::default())?,
            host: crate::host(Rules::default()),
        })
    }

    /// What a script in Python needs.
    ///
    /// # Errors
    /// The process ended, or took too long.
    pub fn needs(&mut self, script: &Script) -> Result<Needs, String> {
        let language = match script.language {
            ScriptLanguage::IronPython => "python2",
            _ => "python3",
        };
        let text = Value::from(script.text.as_str());
        let question = Value::map([("needs", text), ("language", Value::from(language))]);
        let question = self.host.encode(&question).map_err(|fault| fault.message)?;
        let end = Instant::now() + LONGEST;
        let go_on = || Instant::now() < end;
        self.process.send(question, go_on);
        while go_on() {
            let bytes = match self.process.hear(Duration::from_millis(100)) {
                Heard::Message(bytes) => bytes,
                Heard::Nothing => continue,
                Heard::Ended(how) => return Err(format!("the Python process ended: {how}")),
            };
            let message = self.host.decode(&bytes).map_err(|error| error.to_string())?;
            if let Some(needs) = read(&message) {
                return Ok(needs);
            }
            if let Some(answer) = self.host.respond_to(message) {
                self.process.send(answer, go_on);
            }
        }
        Err(format!("looking at a script took more than {} seconds", LONGEST.as_secs()))
    }
}

fn read(message: &Value) -> Option<Needs> {
    let Value::List(words) = message else { return None };
    let [Value::Text(name), answer] = words.as_slice() else { return None };
    if name != "done" {
        return None;
    }
    let texts = |key: &str| {
        let items = answer.get(key).and_then(Value::items).unwrap_or_default();
        items.iter().filter_map(|item| item.as_text().map(str::to_owned)).collect()
    };
    let error = answer.get("error").and_then(Value::as_text).map(str::to_owned);
    Some(Needs { modules: texts("modules"), packages: texts("packages"), members: texts("members"), error })
}
