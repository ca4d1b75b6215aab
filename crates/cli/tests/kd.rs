//! The text form at the command line: convert, fmt, diff, run.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::path::{Path, PathBuf};
use std::time::Duration;

use common::{katydid, said, shared, text, within};
use serde_json::Value;

const GHX: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/attractor.ghx");
const KD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/attractor.kd");

/// What the objects of a file give, without the time they took, by id.
fn results(file: &str) -> Option<Vec<Value>> {
    let words = ["run", file, "--json=values", "--limit-seconds", "20"];
    let output = within(Duration::from_secs(60), &words)?;
    let report: Value = serde_json::from_slice(&output.stdout).ok()?;
    let mut objects = report["objects"].as_array()?.clone();
    for object in &mut objects {
        object["milliseconds"] = Value::Null;
    }
    Some(objects)
}

fn printed(words: &[&str]) -> (Option<i32>, String) {
    let output = katydid(words);
    (output.status.code(), String::from_utf8(output.stdout).unwrap())
}

#[test]
fn the_example_is_the_same_in_both_forms() {
    let circles = |file: &str| {
        let objects = results(file).unwrap();
        objects.into_iter().find(|object| object["nickname"] == "Circles").unwrap()["outputs"].clone()
    };
    assert_eq!(circles(GHX), circles(KD));
    assert_eq!(katydid(&["fmt", "--check", KD]).status.code(), Some(0));
    let (code, words) = printed(&["diff", GHX, KD]);
    // The text keeps in its inputs what the components begin with; the other was written without.
    let told = |line: &&str| !line.contains("value behind the wire none → ");
    assert_eq!(
        (code, words.lines().filter(told).collect::<Vec<_>>()),
        (Some(1), vec!["+ inputs (Group): added"])
    );
}

#[test]
fn definitions_come_back_the_same_from_the_text() {
    let Some(root) = shared("data/gh") else { return };
    let index = std::fs::read_to_string(root.join("index.csv")).unwrap();
    let files: Vec<PathBuf> =
        index.lines().skip(1).filter_map(|line| Some(root.join(line.split(',').next()?))).collect();
    assert_eq!(files.len(), 273);
    let folder = tempfile::tempdir().unwrap();
    let (there, back) = (folder.path().join("there.kd"), folder.path().join("back.ghx"));
    // The definition crate's tests compare all files; here every so many is solved as well.
    for file in files.iter().step_by(if cfg!(debug_assertions) { 9 } else { 1 }) {
        for (from, to) in [(file.as_path(), there.as_path()), (&there, &back)] {
            let output = katydid(&["convert", text(from), text(to)]);
            assert_eq!(output.status.code(), Some(0), "{}: {}", file.display(), said(&output));
        }
        let (code, words) = printed(&["diff", "--layout", text(file), text(&back)]);
        assert_eq!((code, words.as_str()), (Some(0), ""), "{}", file.display());
        assert_eq!(katydid(&["fmt", "--check", text(&there)]).status.code(), Some(0), "{}", file.display());
        if let Some(before) = results(text(file)) {
            assert_eq!(results(text(&there)), Some(before.clone()), "{}", file.display());
            assert_eq!(results(text(&back)), Some(before), "{}", file.display());
        }
    }
}

#[test]
fn converting_says_what_stays_behind() {
    let folder = tempfile::tempdir().unwrap();
    let (kd, gh) = (folder.path().join("a.kd"), folder.path().join("a.gh"));
    std::fs::write(&kd, "units metres\n# a comment\na = Number(1)\nb = Panel(a)\n").unwrap();
    let output = katydid(&["convert", text(&kd), text(&gh)]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    for what in ["left out: the unit, meters", "left out: the comments", "2 objects that had no place"] {
        assert!(said(&output).contains(what), "{}", said(&output));
    }
    let (code, words) = printed(&["diff", text(&kd), text(&gh)]);
    assert_eq!((code, words.as_str()), (Some(0), ""));
    let report = katydid(&["run", text(&kd), "--json"]);
    assert_eq!(serde_json::from_slice::<Value>(&report.stdout).unwrap()["units"], "Meters");
    let report = katydid(&["run", text(&kd), "--json", "--units", "feet"]);
    assert_eq!(serde_json::from_slice::<Value>(&report.stdout).unwrap()["units"], "Feet");
    assert_eq!(katydid(&["check", text(folder.path())]).status.code(), Some(0));
}

#[test]
fn faults_are_told_with_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let kd = folder.path().join("a.kd");
    std::fs::write(&kd, "A = Construct Pont(1)\nB = Move(C)\n").unwrap();
    let output = katydid(&["run", text(&kd)]);
    assert_eq!(output.status.code(), Some(2));
    for part in [
        "2 things are wrong",
        "line 1, column 5: there is no component called Construct Pont",
        "did you mean Construct Point?",
        "line 2, column 10: no object is called C",
        "  2 | B = Move(C)",
    ] {
        assert!(said(&output).contains(part), "{}", said(&output));
    }
}

#[test]
fn differences_are_told_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| -> PathBuf {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path
    };
    let old = write(
        "old.kd",
        "r = Number Slider(5, 0..10)\ns = Number Slider(1, 0..10)\np = Construct Point(r, 2)\n\
         say = Panel(\"hello\")\ngone = Number(1)\ngroup g: r, p\n\
         c = Cluster(r) inside {\n a = Cluster Input()\n b = Cluster Output(a)\n}\n",
    );
    let new = write(
        "new.kd",
        "r = Number Slider(7, 0..10)\ns = Number Slider(1, 0..12)\np = Construct Point(s, 3 |graft) disabled\n\
         say = Panel(\"hello you\")\nfresh = Number(1)\ngroup g: r, s\n\
         c = Cluster(r) inside {\n a = Cluster Input()\n b = Cluster Output(a |flatten)\n}\n\
         layout {\n r: 10 10\n}\n",
    );
    let (code, words) = printed(&["diff", text(&old), text(&new)]);
    assert_eq!(code, Some(1));
    for line in [
        "~ r (Number Slider): value 5 → 7",
        "~ s (Number Slider): settings 0..10 → 0..12",
        "~ p (Construct Point): disabled",
        "~ p (Construct Point): X coordinate rewired from r to s",
        "~ p (Construct Point): Y coordinate value 2 → 3",
        "~ p (Construct Point): Y coordinate graft added",
        "~ say (Panel): text \"hello\" → \"hello you\"",
        "+ fresh (Number): added",
        "- gone (Number): removed",
        "~ g (Group): s (Number Slider) joined the group",
        "~ g (Group): p (Construct Point) left the group",
        "~ c (Cluster) › b (Cluster Output): flatten added",
    ] {
        assert!(words.lines().any(|other| other == line), "{line}\n{words}");
    }
    assert_eq!(words.lines().count(), 12, "{words}");
    let (_, words) = printed(&["diff", text(&old), text(&new), "--layout"]);
    assert!(words.contains("r (Number Slider): placed on the canvas"), "{words}");
    let (_, json) = printed(&["diff", text(&old), text(&new), "--json"]);
    let list: Vec<Value> = serde_json::from_str(&json).unwrap();
    assert_eq!((list.len(), &list[0]["kind"]), (12, &"value".into()));
    assert_eq!(katydid(&["diff", text(&old), "nowhere.gh"]).status.code(), Some(2));
    assert_eq!(katydid(&["diff", text(&old), text(&old)]).status.code(), Some(0));
}

#[test]
fn fmt_sets_files_and_checks_them() {
    let folder = tempfile::tempdir().unwrap();
    let (kd, bad): (PathBuf, PathBuf) = (folder.path().join("a.kd"), folder.path().join("bad.kd"));
    std::fs::write(&kd, "A=Number( 1 )   # one\n").unwrap();
    std::fs::write(&bad, "A = = Number(1)\n").unwrap();
    let (code, named) = printed(&["fmt", "--check", text(&kd)]);
    assert_eq!((code, named.trim()), (Some(1), text(&kd)));
    let read = |path: &Path| std::fs::read_to_string(path).unwrap();
    assert_eq!(read(&kd), "A=Number( 1 )   # one\n");
    let output = katydid(&["fmt", text(&bad), text(&kd)]);
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    assert!(said(&output).contains("line 1, column 5"), "{}", said(&output));
    assert_eq!(read(&kd), "A = Number(1) # one\n", "the others are set all the same");
    assert_eq!(katydid(&["fmt", "--check", text(&kd)]).status.code(), Some(0));
    let output = katydid(&["fmt", "-"]);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(0), 0), "nothing in, nothing out");
    assert_eq!(katydid(&["fmt", GHX]).status.code(), Some(2));
}

#[test]
fn modifiers_of_parameters_and_sliders_work_on_what_they_give() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("modified.kd");
    let lines = ["a = Number([1, 2, 3] |graft |{x*2})", "b = Number(a |flatten |reverse)", "c = Panel(b)"];
    std::fs::write(&file, lines.join("\n")).unwrap();
    let output = katydid(&["run", text(&file), "--json"]);
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let branches = |k: usize| report["objects"][k]["outputs"][0]["branches"].clone();
    assert_eq!(branches(0).as_array().unwrap().len(), 3);
    assert_eq!(branches(2)[0]["items"], serde_json::json!(["6", "4", "2"]));
}

#[test]
fn a_bare_name_that_several_have_means_what_the_text_form_says() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("names.kd");
    std::fs::write(
        &file,
        "a = Addition(3, 4)\nb = Mass Addition([1, 2, 3])\nc = Colour/Addition(rgb(1, 2, 3), rgb(4, 5, 6))\n",
    )
    .unwrap();
    let output = katydid(&["run", text(&file), "--json"]);
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let first = |k: usize| report["objects"][k]["outputs"][0]["branches"][0]["items"][0].clone();
    assert_eq!([first(0), first(1), first(2)], ["7", "6", "5,7,9"].map(serde_json::Value::from));
}
