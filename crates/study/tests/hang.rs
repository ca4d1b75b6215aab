//! Points that hang and take no notice of their time: named in their rows, the rest goes on, the sweep ends.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::fs;
use std::sync::Arc;
use std::time::Duration;

use katydid_component::Limits;
use katydid_data::{Tree, Value};
use katydid_definition::document::ScriptLanguage;
use katydid_definition::kd;
use katydid_session::Registry;
use katydid_solver::{Options, ScriptDone, ScriptTask, Scripts, Unrun};
use katydid_study::{Plan, PlanFile, Settings, StudyError, Summary, sweep};

/// Doubles a number, and never comes back for those from 3 to so many.
#[derive(Debug)]
struct Stubborn(f64);

impl Scripts for Stubborn {
    fn runs(&self, _: &ScriptLanguage) -> bool {
        true
    }

    fn run(&self, task: &ScriptTask<'_>) -> Result<ScriptDone, Unrun> {
        let number = task.inputs.first().and_then(|(_, tree)| tree.column().iter().next().flatten());
        let Some(Value::Number(x)) = number else { return Ok(ScriptDone::default()) };
        if (3.0..=self.0).contains(&x) {
            loop {
                std::thread::park();
            }
        }
        let outputs = vec![Tree::empty(), Tree::item(Value::Number(2.0 * x))];
        Ok(ScriptDone { outputs, messages: Vec::new() })
    }
}

fn run(folder: &std::path::Path, stubborn: f64, workers: usize) -> Result<Summary, StudyError> {
    katydid_components::link();
    let text = "katydid 1\ns = Number Slider(1, 0..60)\n\
        twice = `GhPython Script` @410755b1-224a-4c1e-a407-bf32fb45ea7e(x = s) variable -> out, a {\n    \
        CodeInput = \"a = x * 2\"\n    HideInput = true\n}\n";
    let document = kd::read(text, &Registry).unwrap().document;
    let plan = r#"{"inputs": {"s": {}}, "outputs": ["twice.a"]}"#;
    let plan = Plan::bind(&PlanFile::parse(plan).unwrap(), &document).unwrap();
    let limits = Limits { time: Some(Duration::from_millis(500)), ..Limits::default() };
    let options = Options { scripts: Some(Arc::new(Stubborn(stubborn))), limits, ..Options::default() };
    let settings = Settings { workers, grace: Some(Duration::from_millis(100)), ..Settings::default() };
    sweep(document, options, &plan, folder, &settings, |_| {})
}

#[test]
fn points_that_hang_are_lost_and_the_rest_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let summary = run(folder.path(), 5.0, 2).unwrap();
    assert_eq!((summary.progress.solved, summary.failed_rows), (61, 3));
    let text = fs::read_to_string(folder.path().join("data.csv")).unwrap();
    for (k, line) in text.lines().skip(1).enumerate() {
        if (3..=5).contains(&k) {
            assert!(line.starts_with(&format!("{k},,{k},lost,\"it gave no answer for ")), "{line}");
        } else {
            assert_eq!(line, format!("{k},{},{k},ok,", 2 * k));
        }
    }
    // The study is free for whoever goes on with it: nothing is left to solve.
    let again = run(folder.path(), 5.0, 2).unwrap();
    assert_eq!((again.progress.solved, again.progress.had), (0, 61));
}

#[test]
fn where_everything_hangs_the_sweep_ends_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let error = run(folder.path(), 60.0, 8).unwrap_err().to_string();
    assert!(error.contains("points hang and cannot be ended"), "{error}");
    // What is solved or lost is kept.
    let summary = run(folder.path(), 0.0, 2).unwrap();
    assert!(summary.progress.had >= 16 && summary.failed_rows >= 16, "{summary:?}");
}
