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

/// Only where a folder is given, only into that folder, and under the name of the file alone.
#[test]
fn panels_are_streamed_where_it_is_allowed() {
    let folder = tempfile::tempdir().unwrap();
    let (definition, out) = (folder.path().join("a.kd"), folder.path().join("out"));
    std::fs::create_dir(&out).unwrap();
    let path = r"..\\..\\elsewhere\\numbers.txt";
    let lines = format!(
        "katydid 1\nn = Series(1, 0.5, 3)\nshown = Panel(n, stream = \"{path}\")\nday = Calendar(\"2025-05-28\")\nlate = Clock(\"23:05:09\")\n\
         times = Panel(Merge(day, late), stream = \"times.txt\")\n"
    );
    std::fs::write(&definition, &lines).unwrap();
    let without = katydid(&["run", text(&definition)]);
    assert_eq!(without.status.code(), Some(0), "{}", said(&without));
    assert!(said(&without).contains("2 panels stream to files"), "{}", said(&without));
    assert_eq!(std::fs::read_dir(&out).unwrap().count(), 0);
    let with = katydid(&["run", text(&definition), "--panels", text(&out)]);
    assert_eq!(with.status.code(), Some(0), "{}", said(&with));
    assert_eq!(std::fs::read_to_string(out.join("numbers.txt")).unwrap(), "1\n1.5\n2\n");
    let times = "2025-05-28 00:00:00\n0001-01-01 23:05:09\n";
    assert_eq!(std::fs::read_to_string(out.join("times.txt")).unwrap(), times);
    assert_eq!(std::fs::read_dir(&out).unwrap().count(), 2);
    let set =
        ["run", text(&definition), "--panels", text(&out), "--set", "day=2024-02-29", "--set", "late=07:30"];
    assert_eq!(katydid(&set).status.code(), Some(0));
    let times = "2024-02-29 00:00:00\n0001-01-01 07:30:00\n";
    assert_eq!(std::fs::read_to_string(out.join("times.txt")).unwrap(), times);
    let wrong = katydid(&["run", text(&definition), "--set", "day=2023-02-29"]);
    assert_eq!(wrong.status.code(), Some(2));
    assert!(said(&wrong).contains("a day is written 2025-05-28"), "{}", said(&wrong));

    // One name for two files, no name, no folder.
    std::fs::write(&definition, lines.replace("times.txt", "NUMBERS.TXT")).unwrap();
    let twice = katydid(&["run", text(&definition), "--panels", text(&out)]);
    assert_eq!(twice.status.code(), Some(2));
    assert!(said(&twice).contains("another panel streams to"), "{}", said(&twice));
    std::fs::write(&definition, lines.replace("times.txt", "..")).unwrap();
    let nameless = katydid(&["run", text(&definition), "--panels", text(&out)]);
    assert!(said(&nameless).contains("has no name of a file"), "{}", said(&nameless));
    let nowhere = katydid(&["run", text(&definition), "--panels", text(&out.join("none"))]);
    assert_eq!(nowhere.status.code(), Some(2));
}
