//! A script that does not stop when it is told to.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

use katydid_component::Message;
use katydid_definition::document::ScriptLanguage;
use katydid_solver::{ScriptDone, ScriptMaker, ScriptTask, Scripts, Unrun};
use tokio::time::sleep;

/// A definition whose one script runs until somebody opens the gate.
pub(crate) const STUCK: &str = r#"katydid 1
s = Number Slider(21, 0..100)
held = `GhPython Script` @410755b1-224a-4c1e-a407-bf32fb45ea7e(x = s) variable -> out, a {
    CodeInput = "a = x"
    HideInput = true
}
"RH_IN:s": s
"RH_OUT:a": held
"#;

/// Holds scripts back until it is opened. It heeds neither cancellation nor time.
#[derive(Debug, Clone, Default)]
pub(crate) struct Gate(Arc<Held>);

#[derive(Debug, Default)]
struct Held {
    is_open: Mutex<bool>,
    opened: Condvar,
    /// Whether a script has come to it.
    has_come: AtomicBool,
}

impl Gate {
    pub(crate) fn open(&self) {
        *self.0.is_open.lock().unwrap() = true;
        self.0.opened.notify_all();
    }

    /// Waits until a script has come to it.
    pub(crate) async fn holds(&self) {
        while !self.0.has_come.load(Ordering::SeqCst) {
            sleep(Duration::from_millis(5)).await;
        }
    }
}

impl ScriptMaker for Gate {
    fn make(&self) -> Arc<dyn Scripts> {
        Arc::new(self.clone())
    }
}

impl Scripts for Gate {
    fn runs(&self, _: &ScriptLanguage) -> bool {
        true
    }

    fn run(&self, _: &ScriptTask<'_>) -> Result<ScriptDone, Unrun> {
        self.0.has_come.store(true, Ordering::SeqCst);
        let mut is_open = self.0.is_open.lock().unwrap();
        while !*is_open {
            is_open = self.0.opened.wait(is_open).unwrap();
        }
        Err(Unrun::Failed(Message::error("the gate was opened")))
    }
}
