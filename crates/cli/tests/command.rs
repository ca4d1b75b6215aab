//! The command line as a user meets it: exit codes, what goes where, `--set`, `-o`, JSON.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use common::{katydid, said, text};
use serde_json::Value;

const EXAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/attractor.ghx");

fn report(words: &[&str]) -> Value {
    let output = katydid(words);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn object<'a>(report: &'a Value, nickname: &str) -> &'a Value {
    let mut objects = report["objects"].as_array().unwrap().iter();
    objects.find(|o| o["nickname"] == nickname).unwrap()
}

#[test]
fn the_example_runs_and_reports() {
    let report = report(&["run", EXAMPLE, "--json"]);
    assert_eq!(report["units"], "Millimeters");
    let circles = object(&report, "Circles");
    assert_eq!((&circles["status"], &circles["kind"]), (&"ok".into(), &"component".into()));
    let output = &circles["outputs"][0];
    assert_eq!(
        (&output["name"], &output["nickname"], &output["type"]),
        (&"Circle".into(), &"C".into(), &"Circle".into())
    );
    let branch = &output["branches"][0];
    assert_eq!(branch["path"], "{0}");
    assert_eq!(branch["items"].as_array().unwrap().len(), 13 * 10);
    assert!(branch["items"][0].as_str().unwrap().starts_with("Circle(R:"));
}

#[test]
fn set_changes_a_slider_by_nickname_and_by_id() {
    let report = report(&["run", EXAMPLE, "--json=values", "--set", "columns=3", "--set", "rows=1"]);
    let circles = object(&report, "Circles");
    assert_eq!(circles["outputs"][0]["branches"][0]["items"].as_array().unwrap().len(), 4 * 2);
    let id = object(&report, "columns")["id"].as_str().unwrap().to_owned();
    let again = self::report(&["run", EXAMPLE, "--json", "--set", &format!("{id}=1"), "--set", "rows=1"]);
    assert_eq!(object(&again, "Circles")["outputs"][0]["branches"][0]["items"].as_array().unwrap().len(), 4);
}

#[test]
fn a_wrong_set_says_what_is_there() {
    for (set, reason) in [
        ("colums=3", "did you mean 'columns'?"),
        ("columns=many", "it is not a number"),
        ("columns=61", "the slider goes from 0 to 60"),
    ] {
        let output = katydid(&["run", EXAMPLE, "--set", set]);
        assert_eq!(output.status.code(), Some(2));
        assert!(said(&output).contains(reason), "{}", said(&output));
    }
}

#[test]
fn geometry_is_saved_for_other_programs() {
    let folder = tempfile::tempdir().unwrap();
    let (model, obj) = (folder.path().join("a.3dm"), folder.path().join("a.obj"));
    let output = katydid(&["run", EXAMPLE, "-o", text(&model), "-o", text(&obj)]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let read = katydid_3dm::Model::read(&std::fs::read(&model).unwrap(), &Default::default()).unwrap();
    assert_eq!((read.archive_version, read.objects.len()), (70, 130));
    assert_eq!(read.layers[0].name, "Circles");
    assert!(std::fs::read_to_string(&obj).unwrap().contains("o Circles"));
    let wrong = katydid(&["run", EXAMPLE, "-o", "a.dwg"]);
    assert_eq!(wrong.status.code(), Some(2));
}

#[test]
fn limits_are_messages_on_the_object() {
    let output = katydid(&["run", EXAMPLE, "--limit-items", "50"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("More than 50 items"), "{}", said(&output));
}

#[test]
fn threads_do_not_change_the_results() {
    let on = |threads: &str| {
        let mut report = report(&["run", EXAMPLE, "--json=values", "--threads", threads]);
        for object in report["objects"].as_array_mut().unwrap() {
            object["milliseconds"] = Value::Null;
        }
        report["objects"].clone()
    };
    assert_eq!(on("1"), on("2"));
}

#[test]
fn components_answer_to_names_and_ids() {
    let all: Vec<Value> = serde_json::from_slice(&katydid(&["components", "--json"]).stdout).unwrap();
    assert!(all.len() > 100);
    let help = katydid(&["components", "Construct Point"]);
    let text = String::from_utf8(help.stdout).unwrap();
    assert!(text.contains("X coordinate") && text.contains("Vector / Point"), "{text}");
    assert!(!text.contains('\u{1b}'), "no colours without a terminal");
    assert_eq!(katydid(&["components", "No Such Thing"]).status.code(), Some(2));
}

#[test]
fn a_file_that_is_not_there_is_exit_code_2() {
    let output = katydid(&["run", "nowhere.gh"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("there is no such file"));
    assert_eq!(katydid(&["run"]).status.code(), Some(2));
}
