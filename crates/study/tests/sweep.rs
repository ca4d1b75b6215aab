//! Sweeps against closed forms: the same bytes for any number of workers, and after any interruption.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use katydid_component::Cancel;
use katydid_definition::document::Document;
use katydid_definition::kd;
use katydid_session::Registry;
use katydid_solver::Options;
use katydid_study::{Plan, PlanFile, Settings, StudyError, Summary, sweep};

const TEXT: &str = "katydid 1\nx = Number Slider(1, 0.00..2.00)\nn = Number Slider(3, 1..5)\n\
    root = Expression(\"Sqrt(x - 1) * n\", x = x, n = n)\nsum = Addition(x, n)\nResult = Panel(sum)\n";

fn document() -> Document {
    katydid_components::link();
    kd::read(TEXT, &Registry).unwrap().document
}

fn run(plan: &str, folder: &Path, settings: &Settings, stop_after: u64) -> Result<Summary, StudyError> {
    let document = document();
    let plan = Plan::bind(&PlanFile::parse(plan).unwrap(), &document)?;
    let cancel = settings.cancel.clone();
    sweep(document, Options::default(), &plan, folder, settings, |now| {
        if now.solved >= stop_after {
            cancel.cancel();
        }
    })
}

fn workers(workers: usize) -> Settings {
    Settings { workers, cancel: Cancel::default(), ..Settings::default() }
}

fn tables(folder: &Path) -> BTreeMap<&'static str, Vec<u8>> {
    ["table.parquet", "data.csv", "failed.csv"]
        .into_iter()
        .map(|n| (n, fs::read(folder.join(n)).unwrap()))
        .collect()
}

const PLAN: &str = r#"{"inputs": {"x": {"steps": 21}, "n": {}}, "outputs": ["sum", "Result"]}"#;

#[test]
fn rows_are_the_closed_form_for_any_number_of_workers() {
    let folders: Vec<_> = [1, 2, 8].map(|n| (n, tempfile::tempdir().unwrap())).into();
    for (n, folder) in &folders {
        let summary = run(PLAN, folder.path(), &workers(*n), u64::MAX).unwrap();
        assert_eq!((summary.progress.points, summary.progress.solved, summary.progress.had), (105, 105, 0));
    }
    let first = tables(folders[0].1.path());
    for (_, folder) in &folders {
        assert!(tables(folder.path()) == first);
    }
    let text = String::from_utf8(first["data.csv"].clone()).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("in:x,in:n,out:sum,out:Result,point,status,reason"));
    for (k, line) in lines.enumerate() {
        let cells: Vec<&str> = line.split(',').collect();
        let [x, n, sum, shown]: [f64; 4] = [0, 1, 2, 3].map(|at| cells[at].parse().unwrap());
        assert!((x - 0.1 * (k / 5) as f64).abs() < 1e-12 && n == (1 + k % 5) as f64, "{line}");
        assert!(sum == x + n && shown == sum, "{line}");
    }
}

#[test]
fn what_was_solved_is_not_solved_again() {
    let whole = tempfile::tempdir().unwrap();
    run(PLAN, whole.path(), &workers(1), u64::MAX).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let mut solved = 0;
    for _ in 0..4 {
        assert!(matches!(run(PLAN, folder.path(), &workers(2), 20), Err(StudyError::Stopped)));
        assert!(!folder.path().join("data.csv").exists());
        solved += 20;
    }
    let summary = run(PLAN, folder.path(), &workers(2), u64::MAX).unwrap();
    assert_eq!(summary.progress.had + summary.progress.solved, 105);
    assert!(summary.progress.had >= solved, "{summary:?}");
    assert!(tables(folder.path()) == tables(whole.path()));
    // A larger plan of the same study only adds what is new; points that round to the same value are one.
    let larger = PLAN.replace("21", "401");
    let summary = run(&larger, folder.path(), &workers(2), u64::MAX).unwrap();
    assert_eq!((summary.progress.points, summary.progress.solved), (2005, 5 * (201 - 21)));
}

#[test]
fn rows_without_results_say_why_and_the_rest_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.csv"), "in:x,in:n\n1.25,2\n0.5,2\n9,2\nno,2\n1.25,2\n").unwrap();
    let path = folder.path().join("p.csv");
    let plan = format!(r#"{{"sample": "rows", "rows": {path:?}, "outputs": ["root"]}}"#);
    let summary = run(&plan, folder.path(), &workers(2), u64::MAX).unwrap();
    assert_eq!((summary.progress.solved, summary.progress.had, summary.failed_rows), (4, 1, 3));
    let text = fs::read_to_string(folder.path().join("data.csv")).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[1], "1.25,2,1,0,ok,");
    assert!(lines[2].starts_with("0.5,2,") && lines[2].contains("root"), "{text}");
    assert!(lines[3].contains("refused") && lines[3].contains("0 to 2"), "{text}");
    assert!(lines[4].contains("refused"), "{text}");
    assert_eq!(lines[5], "1.25,2,1,4,ok,");
    assert_eq!(fs::read_to_string(folder.path().join("failed.csv")).unwrap().lines().count(), 4);
}

#[test]
fn pictures_and_geometry_have_the_same_names_for_the_same_points() {
    katydid_components::link();
    let text = "katydid 1\nr = Number Slider(2, 1..4)\nc = Circle(plane((0, 0, 0)), r)\n";
    let plan = r#"{"inputs": {"r": {}}, "pictures": true, "geometry": "glb"}"#;
    let sorted = |folder: &Path, name: &str| {
        let mut names: Vec<_> =
            fs::read_dir(folder.join(name)).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    };
    let folders = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    for (n, folder) in folders.iter().enumerate() {
        let document = kd::read(text, &Registry).unwrap().document;
        let plan = Plan::bind(&PlanFile::parse(plan).unwrap(), &document).unwrap();
        let summary =
            sweep(document, Options::default(), &plan, folder.path(), &workers(n + 1), |_| {}).unwrap();
        assert_eq!((summary.progress.solved, summary.failed_rows), (4, 0));
    }
    let [a, b] = folders.each_ref().map(|folder| folder.path());
    assert!(tables(a) == tables(b));
    assert_eq!(sorted(a, "geometry").len(), 4);
    assert_eq!(sorted(a, "geometry"), sorted(b, "geometry"));
    assert_eq!(sorted(a, "pictures"), sorted(b, "pictures"));
}
