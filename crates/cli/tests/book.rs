//! The definitions of the book: each runs without a warning and gives the numbers that stand beside it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use common::{katydid, said, text};
use serde_json::Value;

const BOOK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book");

/// The rows that have a folder, by their ids.
fn rows() -> Vec<(String, PathBuf)> {
    definitions(Path::new(BOOK))
}

/// Figures that no row has, by number, and those of pages that the guide lacks, by name.
fn figures() -> Vec<(String, PathBuf)> {
    ["figures", "more"].iter().flat_map(|folder| definitions(&Path::new(BOOK).join(folder))).collect()
}

/// The folders with a definition in a folder, by their names.
fn definitions(folder: &Path) -> Vec<(String, PathBuf)> {
    let mut rows: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.join("definition.kd").exists())
        .map(|path| (path.file_name().unwrap().to_str().unwrap().to_owned(), path.join("definition.kd")))
        .collect();
    rows.sort();
    rows
}

/// What every output gives, all branches in a row: by `object` for its first, by `object.port` for each.
fn outputs(file: &Path, form: &str) -> BTreeMap<String, Vec<Value>> {
    outputs_with(file, &[form])
}

fn outputs_with(file: &Path, words: &[&str]) -> BTreeMap<String, Vec<Value>> {
    let words: Vec<&str> = ["run", text(file)].into_iter().chain(words.iter().copied()).collect();
    let output = katydid(&words);
    let told = said(&output);
    assert_eq!((output.status.code(), told.as_str()), (Some(0), ""), "{}", file.display());
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    let mut found = BTreeMap::new();
    for object in report["objects"].as_array().unwrap() {
        let name = object["nickname"].as_str().unwrap();
        let messages = object["messages"].as_array().unwrap();
        assert!(messages.is_empty(), "{}: {name}: {messages:?}", file.display());
        for (place, port) in object["outputs"].as_array().unwrap().iter().enumerate() {
            let branches = port["branches"].as_array().unwrap().iter();
            let items: Vec<Value> =
                branches.flat_map(|branch| branch["items"].as_array().unwrap().clone()).collect();
            found.insert(format!("{name}.{}", port["nickname"].as_str().unwrap()), items.clone());
            if place == 0 {
                found.insert(name.to_owned(), items);
            }
        }
    }
    found
}

/// Numbers agree to a billionth of their size, and to as much where they are smaller than 1.
fn agrees(found: &Value, expected: &Value) -> bool {
    match (found, expected) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap(), b.as_f64().unwrap());
            (a - b).abs() <= 1e-9 * b.abs().max(1.0)
        }
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| agrees(a, b))
        }
        _ => found == expected,
    }
}

#[test]
fn every_row_and_figure_gives_its_numbers() {
    let (rows, figures) = (rows(), figures());
    assert!(!rows.is_empty() && !figures.is_empty());
    for (row, file) in rows.into_iter().chain(figures) {
        let expected = std::fs::read_to_string(file.with_file_name("expected.json")).unwrap();
        let expected: Value = serde_json::from_str(&expected).unwrap();
        assert!(expected["from"].is_string(), "{row}: where the numbers come from");
        let (texts, values) = (outputs(&file, "--json"), outputs(&file, "--json=values"));
        let expected = expected["expect"].as_object().unwrap();
        assert!(!expected.is_empty(), "{row}");
        for (name, items) in expected {
            let place = format!("{row}: {name}");
            let shown = texts.get(name).unwrap_or_else(|| panic!("{place}: there is no such output"));
            let items = items.as_array().unwrap();
            assert_eq!(shown.len(), items.len(), "{place}: {shown:?}");
            for (index, item) in items.iter().enumerate() {
                // A text is what a panel shows; anything else is compared as the value it is.
                let found = if item.is_string() { &shown[index] } else { &values[name][index] };
                assert!(agrees(found, item), "{place}, item {index}: {found}, not {item}");
            }
        }
    }
}

/// The rows whose work a script does too, as the book's own scripts did (row S4): the same numbers.
#[test]
fn scripts_give_the_numbers_of_their_rows() {
    for row in ["M5", "M8", "M9", "N7", "N8", "N9", "N10"] {
        let folder = Path::new(BOOK).join(row);
        let expected = std::fs::read_to_string(folder.join("expected.json")).unwrap();
        let expected: Value = serde_json::from_str(&expected).unwrap();
        let file = folder.join("script.kd");
        let allowed = |form| outputs_with(&file, &[form, "--allow-scripts"]);
        let (texts, values) = (allowed("--json"), allowed("--json=values"));
        let mut compared = 0;
        for (name, items) in expected["expect"].as_object().unwrap() {
            let Some(shown) = texts.get(name) else { continue };
            let items = items.as_array().unwrap();
            assert_eq!(shown.len(), items.len(), "{row}: {name}: {shown:?}");
            for (index, item) in items.iter().enumerate() {
                let found = if item.is_string() { &shown[index] } else { &values[name][index] };
                assert!(agrees(found, item), "{row}: {name}, item {index}: {found}, not {item}");
            }
            compared += 1;
        }
        assert!(compared >= 2, "{row}: {compared} outputs have the names of the row's");
    }
}

#[test]
fn every_row_is_set_the_usual_way() {
    for (row, file) in rows() {
        let output = katydid(&["fmt", "--check", text(&file)]);
        assert_eq!(output.status.code(), Some(0), "{row}: {}", said(&output));
    }
}

#[test]
fn every_row_comes_back_from_an_archive() {
    let folder = tempfile::tempdir().unwrap();
    for (row, file) in rows() {
        let archive = folder.path().join(format!("{row}.ghx"));
        let output = katydid(&["convert", text(&file), text(&archive)]);
        assert_eq!(output.status.code(), Some(0), "{row}: {}", said(&output));
        assert_eq!(outputs(&archive, "--json"), outputs(&file, "--json"), "{row}");
    }
}

#[test]
fn the_index_names_every_row() {
    let index = std::fs::read_to_string(Path::new(BOOK).join("README.md")).unwrap();
    let named: BTreeSet<String> = index
        .lines()
        .filter_map(|line| line.strip_prefix("| [")?.split_once(']').map(|(row, _)| row.to_owned()))
        .collect();
    assert_eq!(named, rows().into_iter().map(|(row, _)| row).collect::<BTreeSet<_>>());
}

#[test]
fn matrices_that_do_not_fit_are_refused() {
    let file = Path::new(BOOK).join("M1/mismatch.kd");
    let output = katydid(&["run", text(&file)]);
    assert_eq!(output.status.code(), Some(1));
    let told = said(&output);
    assert!(told.contains("[2×4] · [3×4]: the columns of the first must match the rows"), "{told}");
}

/// A reader drags the sliders: to both ends of each, nothing fails.
#[test]
fn every_slider_goes_to_its_ends() {
    for (row, file) in rows() {
        for line in std::fs::read_to_string(&file).unwrap().lines() {
            let Some((name, rest)) = line.split_once(" = Number Slider(") else { continue };
            let range = rest.split(", ").nth(1).unwrap().trim_end_matches(')');
            let (from, to) = range.split_once("..").unwrap();
            for end in [from, to] {
                let set = format!("{name}={end}");
                let output = katydid(&["run", text(&file), "--set", &set, "--json"]);
                let told = said(&output);
                assert_eq!((output.status.code(), told.as_str()), (Some(0), ""), "{row}: {set}");
            }
        }
    }
}

/// Every object has a place, and no two that work stand on one another.
#[test]
fn every_row_opens_readable() {
    for (row, file) in rows() {
        let source = std::fs::read_to_string(&file).unwrap();
        let layout = source.split("\nlayout {\n").nth(1).unwrap_or_else(|| panic!("{row}: no layout"));
        let places: Vec<(&str, [f64; 4])> = layout
            .lines()
            .filter_map(|line| {
                let (name, rest) = line.split_once(": ")?;
                let numbers = rest.split_once('[')?.1.trim_end_matches(']');
                let numbers: Vec<f64> = numbers.split(' ').map(|n| n.parse().unwrap()).collect();
                Some((name.trim(), numbers.try_into().unwrap()))
            })
            .collect();
        assert!(places.len() > 3, "{row}");
        for (index, (name, [x, y, w, h])) in places.iter().enumerate() {
            for (other, [x2, y2, w2, h2]) in &places[index + 1..] {
                let apart = x + w <= *x2 || x2 + w2 <= *x || y + h <= *y2 || y2 + h2 <= *y;
                assert!(apart, "{row}: {name} and {other} overlap");
            }
        }
    }
}

/// The steps of de Boor's construction, with the book's own numbers as exact fractions.
#[test]
fn the_steps_of_a_point_are_told() {
    let file = Path::new(BOOK).join("C10/definition.kd");
    let output = katydid(&["run", text(&file), "--explain"]);
    let told = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{told}");
    for line in ["share of B = (u − U3) / (U6 − U3) = 8/15", "B = 7/15 P2 + 8/15 P3", "F = 2/5 D + 3/5 E"]
    {
        assert!(told.contains(line), "{line}: {told}");
    }
    let none = katydid(&["run", text(&file), "--explain=nothing"]);
    assert_eq!(none.status.code(), Some(2));
}

#[test]
fn a_book_of_ones_own_is_built_or_its_faults_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("one");
    std::fs::create_dir(&page).unwrap();
    std::fs::copy(Path::new(BOOK).join("C9/definition.kd"), page.join("definition.kd")).unwrap();
    let contents = "---\ntitle: Mine\nsummary: Small.\n---\n\n## Chapter\n\n- one\n";
    std::fs::write(folder.path().join("contents.md"), contents).unwrap();
    let words = "---\ntitle: One\nsummary: A page.\n---\n\nR is {{ R }}.\n\n\
        ```figure\nid: main\ncontrols: t\nsay: R is {{ R }}.\nalt: A curve.\n```\n";
    std::fs::write(page.join("page.md"), words).unwrap();
    let out = folder.path().join("out");
    let output = katydid(&["book", text(folder.path()), "-o", text(&out)]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let html = std::fs::read_to_string(out.join("one/index.html")).unwrap();
    assert!(html.contains("(0.91, 1.13, 0)"), "{html}");
    std::fs::write(page.join("page.md"), words.replace("{{ R }}.\n\n", "{{ S }}.\n\n")).unwrap();
    let output = katydid(&["book", text(folder.path())]);
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("one/page.md:6: the definition has no output 'S'"), "{}", said(&output));
}
