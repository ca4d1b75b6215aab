//! The folder of a study is read while it is made and after; what is broken in it is named, and nothing leads out of it.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

use std::fs;
use std::path::Path;

use katydid_component::Cancel;
use katydid_definition::document::{Document, Special};
use katydid_definition::kd;
use katydid_session::Registry;
use katydid_solver::Options;
use katydid_study::{
    Cell, DefinitionFile, Goal, Kind, Method, Objective, OptimiseSettings, Output, Plan, PlanFile, Row,
    Settings, State, StudyFolder, Variable, optimise, sweep,
};

const TEXT: &str = "katydid 1\nx = Number Slider(1, 0.00..2.00)\nn = Number Slider(3, 1..5)\n\
    root = Expression(\"Sqrt(x - 1) * n\", x = x, n = n)\nsum = Addition(x, n)\n";
const PLAN: &str = r#"{"inputs": {"x": {"steps": 21}, "n": {}}, "outputs": ["sum", "root"]}"#;

fn document() -> Document {
    katydid_components::link();
    kd::read(TEXT, &Registry).unwrap().document
}

fn settings() -> Settings {
    let definition = DefinitionFile { file: "/somewhere/roots.kd".into(), ..DefinitionFile::default() };
    Settings { workers: 2, definition: Some(definition), ..Settings::default() }
}

/// Makes the sweep of the plan; `tell` is called after each point with the number of points that are solved.
fn make(folder: &Path, cancel: &Cancel, mut tell: impl FnMut(u64)) -> bool {
    let document = document();
    let plan = Plan::bind(&PlanFile::parse(PLAN).unwrap(), &document).unwrap();
    let settings = Settings { cancel: cancel.clone(), ..settings() };
    sweep(document, Options::default(), &plan, folder, &settings, |now| tell(now.solved)).is_ok()
}

fn opened(folder: &Path) -> StudyFolder {
    let mut folder = StudyFolder::open(folder, 1000).unwrap();
    folder.refresh().unwrap();
    folder
}

fn is_right(row: &Row) {
    let [x, n, sum] = [0, 1, 2].map(|at| row.number(at).unwrap());
    assert!((sum - x - n).abs() < 1e-12, "{row:?}");
    assert_eq!(row.is_good(), x >= 1.0, "{row:?}");
    assert_eq!(row.reason.is_empty(), x >= 1.0, "{row:?}");
    assert_eq!(row.point, (x * 50.0).round() as u64 + n as u64 - 1);
}

#[test]
fn rows_are_there_while_the_sweep_runs_and_stay_when_it_is_stopped() {
    let folder = tempfile::tempdir().unwrap();
    let mut seen = opened(folder.path());
    assert_eq!((seen.state(), seen.rows().len()), (State::Empty, 0));
    let cancel = Cancel::default();
    let mut counts = Vec::new();
    let ended = make(folder.path(), &cancel, |solved| {
        seen.refresh().unwrap();
        assert_eq!(seen.state(), State::Running);
        counts.push(seen.rows().len());
        if solved == 60 {
            cancel.cancel();
        }
    });
    assert!(!ended);
    assert!(counts.is_sorted() && counts.iter().all(|count| *count <= 61), "{counts:?}");
    seen.refresh().unwrap();
    assert_eq!((seen.state(), seen.rows().len()), (State::Stopped, 60));
    assert_eq!(seen.about().unwrap().points, 105);
    let generation = seen.generation();
    // The same command goes on; what was solved before is there again, and then the tables are.
    assert!(make(folder.path(), &Cancel::default(), |_| ()));
    seen.refresh().unwrap();
    assert_eq!((seen.state(), seen.rows().len(), seen.row_count()), (State::Done, 105, 105));
    assert!(seen.generation() > generation);
    seen.rows().iter().for_each(is_right);
    assert!(!folder.path().join("points.jsonl").exists());
    let names: Vec<(&str, Kind)> = seen.columns().iter().map(|one| (one.name.as_str(), one.kind)).collect();
    assert_eq!(
        names,
        [("x", Kind::Input), ("n", Kind::Input), ("sum", Kind::Output), ("root", Kind::Output)]
    );
    let before = seen.generation();
    seen.refresh().unwrap();
    assert_eq!(seen.generation(), before, "what did not change is not read again");
    // Without the Parquet file the CSV file has the same rows.
    let rows = seen.rows().to_vec();
    fs::remove_file(folder.path().join("table.parquet")).unwrap();
    let read = opened(folder.path());
    for (a, b) in rows.iter().zip(read.rows()) {
        assert_eq!(
            (a.point, &a.status, &a.reason, &a.cells[..3]),
            (b.point, &b.status, &b.reason, &b.cells[..3])
        );
    }
}

#[test]
fn the_inputs_of_a_row_are_set_in_the_definition() {
    let folder = tempfile::tempdir().unwrap();
    assert!(make(folder.path(), &Cancel::default(), |_| ()));
    let seen = opened(folder.path());
    let file = seen.about().unwrap().definition.as_ref().unwrap().file.clone();
    assert_eq!(file, Path::new("/somewhere/roots.kd"));
    let mut document = document();
    seen.place(seen.row(57).unwrap(), &mut document).unwrap();
    let values: Vec<f64> = document
        .objects
        .iter()
        .filter_map(|object| match object.special() {
            Some(Special::Slider(slider)) => Some(slider.value),
            _ => None,
        })
        .collect();
    assert_eq!(values, [1.1, 3.0]);
    assert!(seen.row(105).is_none());
    let mut other = kd::read("katydid 1\nx = Number Slider(1, 0.00..0.50)\n", &Registry).unwrap().document;
    let why = seen.place(seen.row(57).unwrap(), &mut other).unwrap_err().to_string();
    assert!(why.contains("0.5"), "{why}");
}

#[test]
fn a_search_says_what_it_is_for() {
    let folder = tempfile::tempdir().unwrap();
    let document = document();
    let variables = ["x", "n"].map(|name| Variable::find(&document, name).unwrap()).to_vec();
    let outputs = ["sum", "root"].map(|name| Output::find(&document, name).unwrap()).to_vec();
    let objective = |output, goal| Objective { output, goal };
    let settings = OptimiseSettings {
        objectives: vec![objective(0, Goal::Least), objective(1, Goal::Near(2.5))],
        constraints: Vec::new(),
        method: Method::Nsga2(8),
        evaluations: 30,
        patience: None,
        seed: 1,
        study: settings(),
    };
    let mut most = 0;
    let mut seen = StudyFolder::open(folder.path(), 1000).unwrap();
    optimise(document, Options::default(), variables, outputs, folder.path(), &settings, |_| {
        seen.refresh().unwrap();
        most = most.max(seen.rows().len());
    })
    .unwrap();
    seen.refresh().unwrap();
    assert!(most <= seen.rows().len() && seen.rows().len() == 30);
    let goals = &seen.about().unwrap().goals;
    assert_eq!((goals[0].output.as_str(), goals[0].goal), ("sum", Goal::Least));
    assert_eq!((goals[1].output.as_str(), goals[1].goal), ("root", Goal::Near(2.5)));
    let numbers: Vec<u64> = seen.rows().iter().map(|row| row.point).collect();
    assert_eq!(numbers, (0..30).collect::<Vec<_>>());
}

#[test]
fn a_line_that_is_half_written_waits_and_a_broken_one_is_named() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("study.json"), r#"{"inputs":["x"],"outputs":["y"],"points":9}"#).unwrap();
    let path = folder.path().join("points.jsonl");
    let line = r#"{"point":0,"in":[1],"out":["NaN"],"status":"not-finite","reason":"'y' is NaN"}"#;
    let whole = format!("{line}\n{}\n", line.replace(":0,", ":1,"));
    for cut in 0..=whole.len() {
        fs::write(&path, &whole[..cut]).unwrap();
        let mut seen = opened(folder.path());
        assert_eq!(seen.rows().len(), whole[..cut].matches('\n').count());
        assert_eq!(seen.state(), State::Stopped);
        fs::write(&path, &whole).unwrap();
        seen.refresh().unwrap();
        assert_eq!(seen.rows().iter().map(|row| row.point).collect::<Vec<_>>(), [0, 1], "{cut}");
        assert!(seen.columns()[1].is_number);
        assert_eq!(seen.rows()[1].cells, [Cell::Number(1.0), Cell::Text("NaN".to_owned())]);
    }
    for broken in ["{}\n", "\n", "[]\n", "{\"point\":-1}\n", "\u{0}\n"] {
        fs::write(&path, format!("{whole}{broken}")).unwrap();
        let mut seen = StudyFolder::open(folder.path(), 10).unwrap();
        let why = seen.refresh().unwrap_err().to_string();
        assert!(why.contains("points.jsonl") && why.contains("byte"), "{why}");
        assert_eq!(seen.rows().len(), 2, "what was whole is shown");
    }
    fs::remove_file(folder.path().join("study.json")).unwrap();
    assert!(StudyFolder::open(folder.path(), 10).unwrap().refresh().is_err());
    fs::write(folder.path().join("study.json"), "{").unwrap();
    let why = StudyFolder::open(folder.path(), 10).unwrap().refresh().unwrap_err().to_string();
    assert!(why.contains("study.json"), "{why}");
}

#[test]
fn a_table_that_is_cut_off_or_changed_anywhere_is_refused_or_read_and_never_ends_the_program() {
    let folder = tempfile::tempdir().unwrap();
    assert!(make(folder.path(), &Cancel::default(), |_| ()));
    let path = folder.path().join("table.parquet");
    let whole = fs::read(&path).unwrap();
    let mut seen = opened(folder.path());
    for cut in (0..whole.len()).step_by(whole.len() / 40) {
        fs::write(&path, &whole[..cut]).unwrap();
        let why = seen.refresh().unwrap_err().to_string();
        assert!(why.contains("table.parquet"), "{why}");
        assert_eq!(seen.rows().len(), 105, "what was read before is kept");
    }
    let mut read = 0;
    for at in (0..whole.len()).step_by(7) {
        let mut bytes = whole.clone();
        bytes[at] ^= 0x55;
        fs::write(&path, &bytes).unwrap();
        let mut seen = StudyFolder::open(folder.path(), 50).unwrap();
        read += usize::from(seen.refresh().is_ok());
        assert!(seen.rows().len() <= 50);
    }
    assert!(read > 0 && read < whole.len() / 7, "{read}");
}

#[test]
fn tables_of_other_programs_are_read_and_thinned() {
    let folder = tempfile::tempdir().unwrap();
    let mut text = "In:Width,OUT:Area,Rating,img,img2,threeD\n".to_owned();
    (0..1000).for_each(|k| text.push_str(&format!("{k},{},good,p/{k}.png,q.png,a.json\n", k * k)));
    fs::write(folder.path().join("data.csv"), text).unwrap();
    let mut seen = StudyFolder::open(folder.path(), 100).unwrap();
    seen.refresh().unwrap();
    assert_eq!((seen.state(), seen.row_count(), seen.rows().len()), (State::Done, 1000, 63));
    assert!(seen.about().is_none());
    let names: Vec<&str> = seen.columns().iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names, ["Width", "Area", "Rating"]);
    for (k, row) in seen.rows().iter().enumerate() {
        assert_eq!(row.point, 16 * k as u64);
        assert_eq!(row.number(1), Some((row.point * row.point) as f64));
        assert!(row.is_good() && row.picture == format!("p/{}.png", row.point));
    }
    assert!(StudyFolder::open(&folder.path().join("no"), 1).is_err());
    assert!(StudyFolder::open(&folder.path().join("data.csv"), 1).is_err());
}

#[test]
fn files_are_those_of_the_folder_alone() {
    let outside = tempfile::tempdir().unwrap();
    fs::write(outside.path().join("secret.png"), "secret").unwrap();
    let folder = outside.path().join("study");
    fs::create_dir_all(folder.join("pictures")).unwrap();
    fs::create_dir_all(folder.join(".hidden")).unwrap();
    for name in
        ["pictures/a.png", "pictures/b.PNG", "g.glb", "notes.txt", "study.json", ".hidden/a.png", ".a.png"]
    {
        fs::write(folder.join(name), "here").unwrap();
    }
    fs::create_dir(folder.join("pictures/folder.png")).unwrap();
    let seen = StudyFolder::open(&folder, 1).unwrap();
    for name in ["pictures/a.png", "pictures/b.PNG", "g.glb"] {
        assert!(seen.file(name).is_some(), "{name}");
    }
    let absolute = outside.path().join("secret.png").to_string_lossy().into_owned();
    let mut refused: Vec<String> = [
        "",
        "/",
        ".",
        "..",
        "../secret.png",
        "pictures/../../secret.png",
        "pictures/../pictures/a.png",
        "./g.glb",
        "pictures//a.png",
        "/pictures/a.png",
        "pictures\\a.png",
        "..\\secret.png",
        "C:a.png",
        "pictures/a.png\0",
        "notes.txt",
        "study.json",
        ".hidden/a.png",
        ".a.png",
        "pictures/folder.png",
        "pictures/none.png",
        "pictures",
        "pictures/%2e%2e/%2e%2e/secret.png",
        "pictures/a.png.",
        "pictures/... /a.png",
    ]
    .map(str::to_owned)
    .to_vec();
    refused.push(absolute);
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(outside.path().join("secret.png"), folder.join("pictures/link.png"))
            .unwrap();
        std::os::unix::fs::symlink(outside.path(), folder.join("out")).unwrap();
        std::os::unix::fs::symlink(folder.join("pictures/a.png"), folder.join("inner.png")).unwrap();
        refused.extend(["pictures/link.png", "out/secret.png"].map(str::to_owned));
        assert!(seen.file("inner.png").is_some(), "a link that stays inside is one of the folder's files");
    }
    for name in refused {
        assert_eq!(seen.file(&name), None, "{name:?}");
    }
}
