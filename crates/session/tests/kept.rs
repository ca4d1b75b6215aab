//! Definitions that broke Katydid once: each still gives what it says. `kept/README.md` tells how one is written.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use std::fs;
use std::path::{Path, PathBuf};

use katydid_definition::archive::{self, Limits};
use katydid_definition::document::Document;
use katydid_definition::kd;
use katydid_session::{Registry, Session};
use serde_json::Value;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/kept");

/// What must come of a definition.
#[derive(Debug)]
enum Expected {
    /// The texts of an output, branch by branch.
    Texts { object: String, output: String, texts: String },
    /// The only item of an output, as a number.
    Number { object: String, output: String, number: f64, within: f64 },
    /// A part of a message of an object.
    Message { object: String, part: String },
}

impl Expected {
    fn read(line: &str) -> Self {
        let Some((place, value)) = line.split_once(" = ") else {
            let (object, part) = line.split_once(": ").expect("an object, and a part of its message");
            return Self::Message { object: object.to_owned(), part: part.to_owned() };
        };
        let (object, output) = place.split_once('.').expect("an object and its output");
        let (object, output) = (object.to_owned(), output.to_owned());
        match value.split_once(" within ") {
            Some((number, within)) => {
                let [number, within] = [number, within].map(|text| text.parse().expect("a number"));
                Self::Number { object, output, number, within }
            }
            None => Self::Texts { object, output, texts: value.to_owned() },
        }
    }

    /// What is other than that, in words.
    fn fault(&self, texts: &Value, values: &Value) -> Option<String> {
        match self {
            Self::Texts { object, output, texts: wanted } => {
                let found = branches(texts, object, output);
                (found != *wanted).then(|| format!("{object}.{output} is {found}, not {wanted}"))
            }
            Self::Number { object, output, number, within } => {
                let items: Vec<&Value> = items(values, object, output).collect();
                let [one] = items.as_slice() else {
                    return Some(format!("{object}.{output} has {} items, not 1", items.len()));
                };
                let found = one.as_f64().unwrap_or(f64::NAN);
                let is_near = (found - number).abs() <= *within;
                (!is_near).then(|| format!("{object}.{output} is {found}, not {number} within {within}"))
            }
            Self::Message { object, part } => {
                let found = messages(one(texts, object));
                let is_there = found.iter().any(|text| text.contains(part.as_str()));
                (!is_there).then(|| format!("{object} says {found:?}, not {part:?}"))
            }
        }
    }
}

fn list<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value[key].as_array().map(Vec::as_slice).unwrap_or_default()
}

/// The object of that label in a report.
fn one<'a>(report: &'a Value, label: &str) -> &'a Value {
    let found = list(report, "objects").iter().find(|object| object["nickname"] == label);
    found.unwrap_or_else(|| panic!("there is no object {label}"))
}

fn output<'a>(report: &'a Value, label: &str, name: &str) -> &'a Value {
    let found = list(one(report, label), "outputs").iter().find(|output| output["name"] == name);
    found.unwrap_or_else(|| panic!("{label} has no output {name}"))
}

fn items<'a>(report: &'a Value, label: &str, name: &str) -> impl Iterator<Item = &'a Value> {
    list(output(report, label, name), "branches").iter().flat_map(|branch| list(branch, "items"))
}

fn branches(report: &Value, label: &str, name: &str) -> String {
    let of_branch = |branch: &Value| {
        let items: Vec<&str> = list(branch, "items").iter().filter_map(Value::as_str).collect();
        format!("{}: {}", branch["path"].as_str().unwrap(), items.join(", "))
    };
    let all: Vec<String> = list(output(report, label, name), "branches").iter().map(of_branch).collect();
    all.join(" | ")
}

/// The warnings and errors of an object.
fn messages(object: &Value) -> Vec<&str> {
    let loud = list(object, "messages").iter().filter(|message| message["level"] != "remark");
    loud.filter_map(|message| message["text"].as_str()).collect()
}

/// What is wrong with the results of a definition.
fn faults(document: Document, expected: &[Expected]) -> Vec<String> {
    let mut session = Session::new(document, Default::default());
    session.solve();
    let texts = serde_json::to_value(session.report()).unwrap();
    let values = serde_json::to_value(session.report_with(katydid_session::Items::Values)).unwrap();
    let mut found: Vec<String> = expected.iter().filter_map(|one| one.fault(&texts, &values)).collect();
    for object in list(&texts, "objects") {
        let may_complain = expected.iter().any(
            |one| matches!(one, Expected::Message { object: label, .. } if object["nickname"] == label.as_str()),
        );
        let loud = messages(object);
        if !may_complain && !loud.is_empty() {
            found.push(format!("{} says {loud:?}", object["nickname"]));
        }
    }
    found
}

fn files() -> Vec<PathBuf> {
    let all = fs::read_dir(FOLDER).unwrap().map(|entry| entry.unwrap().path());
    let mut all: Vec<PathBuf> = all.filter(|path| path.extension().is_some_and(|e| e == "kd")).collect();
    all.sort();
    all
}

fn kept(path: &Path) -> Vec<String> {
    let text = fs::read_to_string(path).unwrap();
    let of = |word: &str| -> Vec<String> {
        text.lines().filter_map(|line| line.strip_prefix(word)).map(|rest| rest.trim().to_owned()).collect()
    };
    let (reasons, expected) = (of("# Fault:"), of("# Expect:"));
    if reasons.len() != 1 || expected.is_empty() {
        return vec!["it does not say what was wrong, and what must come of it".to_owned()];
    }
    let expected: Vec<Expected> = expected.iter().map(|line| Expected::read(line)).collect();
    let document = match kd::read(&text, &Registry) {
        Ok(definition) => definition.document,
        Err(problems) => return vec![problems.to_string()],
    };
    let bytes = archive::write_gh(&document.to_archive().root).unwrap();
    let again = Document::read(&bytes, &Limits::default()).unwrap();
    let mut found = faults(document, &expected);
    found.extend(faults(again, &expected).into_iter().map(|fault| format!("read from .gh: {fault}")));
    found
}

#[test]
fn what_broke_it_once_is_right() {
    katydid_components::link();
    let files = files();
    assert!(files.len() >= 20, "{} files", files.len());
    let told: Vec<String> = files
        .iter()
        .flat_map(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            kept(path).into_iter().map(move |fault| format!("{name}: {fault}"))
        })
        .collect();
    assert!(told.is_empty(), "{}", told.join("\n"));
}

#[test]
fn what_is_wrong_is_told() {
    katydid_components::link();
    let document = kd::read("zero = Negative(1)\nhalf = Division(1, 0)\n", &Registry).unwrap().document;
    let wrong = ["zero.Result = {0}: 0", "zero.Result = 1 within 0.5", "zero: nothing of the kind"];
    let expected: Vec<Expected> = wrong.iter().map(|line| Expected::read(line)).collect();
    let found = faults(document, &expected);
    assert_eq!(found.len(), 4, "{found:?}");
}
