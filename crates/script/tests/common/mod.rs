//! Definitions with scripts, solved as the command line does.

#![allow(dead_code, reason = "each test file uses its own part")]

use std::sync::Arc;
use std::time::Duration;

use katydid_component::{Cancel, Limits};
use katydid_data::{Tree, Value};
use katydid_script::{Bounds, CSharp, Python, find};
use katydid_session::{Registry, Session};
use katydid_solver::{ObjectReport, Options};

/// A definition of the lines, to be solved with the machine's Python. Without one the test fails, and says so.
pub(crate) fn session(lines: &str) -> Session {
    session_with(lines, Bounds::default(), Limits::default(), Cancel::default())
}

/// The same, where C# and VB run too.
pub(crate) fn session_of_every_language(lines: &str) -> Session {
    let scripts = CSharp::beside(python(Bounds::default()));
    session_by(lines, Options { scripts: Some(Arc::new(scripts)), ..Options::default() })
}

/// The same, of a definition that lies somewhere.
pub(crate) fn session_of(lines: &str, path: std::path::PathBuf) -> Session {
    let python = Python::new(find(None, None), Bounds::default()).of(Some(path));
    session_by(lines, Options { scripts: Some(Arc::new(python)), ..Options::default() })
}

pub(crate) fn python(bounds: Bounds) -> Arc<Python> {
    let interpreter = find(None, None);
    if let Err(why) = &interpreter {
        panic!("these tests need a Python: {why}");
    }
    Arc::new(Python::new(interpreter, bounds))
}

pub(crate) fn session_with(lines: &str, bounds: Bounds, limits: Limits, cancel: Cancel) -> Session {
    session_by(lines, Options { scripts: Some(python(bounds)), limits, cancel, ..Options::default() })
}

fn session_by(lines: &str, options: Options) -> Session {
    katydid_components::link();
    let text = format!("katydid 1\n{lines}\n");
    let definition =
        katydid_definition::kd::read(&text, &Registry).unwrap_or_else(|problems| panic!("{problems}"));
    Session::new(definition.document, options)
}

/// The lines of a GhPython component whose code stands in it.
pub(crate) fn gh_python(name: &str, inputs: &str, outputs: &str, code: &str, settings: &str) -> String {
    let code: String = code.lines().map(|line| format!("        {line}\n")).collect();
    format!(
        "{name} = `GhPython Script` @410755b1-224a-4c1e-a407-bf32fb45ea7e({inputs}) variable -> {outputs} {{\n    \
         CodeInput = \"\"\"\n{code}        \"\"\"\n    HideInput = true\n{settings}}}"
    )
}

pub(crate) fn report<'a>(session: &'a Session, name: &str) -> &'a ObjectReport {
    let objects = &session.document().objects;
    let place = objects.iter().position(|object| object.title() == name);
    let place = place.unwrap_or_else(|| panic!("there is no {name}"));
    session.engine().report(place).unwrap_or_else(|| panic!("{name} was not solved"))
}

pub(crate) fn tree<'a>(session: &'a Session, name: &str, output: usize) -> &'a Tree {
    let report = report(session, name);
    report
        .outputs
        .get(output)
        .unwrap_or_else(|| panic!("{name} has no output {output}: {:?}", report.messages))
}

/// The branches of an output: paths with the numbers in them.
pub(crate) fn numbers(session: &Session, name: &str, output: usize) -> Vec<(String, Vec<f64>)> {
    let number = |item: Option<Value>| match item {
        Some(Value::Number(x)) => x,
        Some(Value::Integer(whole)) => whole.into(),
        other => panic!("{other:?} is no number: {:?}", report(session, name).messages),
    };
    let branches = tree(session, name, output).branches();
    branches.map(|branch| (branch.path().to_string(), branch.iter().map(number).collect())).collect()
}

pub(crate) fn values(session: &Session, name: &str, output: usize) -> Vec<Option<Value>> {
    tree(session, name, output).column().iter().collect()
}

pub(crate) fn messages(session: &Session, name: &str) -> Vec<String> {
    report(session, name)
        .messages
        .iter()
        .map(|message| format!("{}: {}", message.level, message.text))
        .collect()
}

pub(crate) fn within(seconds: u64) -> Limits {
    Limits { time: Some(Duration::from_secs(seconds)), ..Limits::default() }
}
