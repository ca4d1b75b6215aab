//! `katydid view`: every row of the book has a picture, and it is the one that was looked at.
//!
//! The pictures that were looked at lie in `tests/pictures`. `KATYDID_REFRESH_PICTURES=1 cargo test -p katydid --test
//! view` draws them anew; look at each before it is kept.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::fs;
use std::path::{Path, PathBuf};

use common::{katydid, said, text};

const BOOK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book");
const PICTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/pictures");
/// The rows that only compute: their picture is that of their canvas.
const WITHOUT_GEOMETRY: [&str; 3] = ["M1", "V11", "V9"];
/// Rows whose canvas is kept too.
const CANVASES: [&str; 2] = ["C5", "N11"];

fn rows() -> Vec<(String, PathBuf)> {
    let folders = fs::read_dir(BOOK).unwrap().map(|entry| entry.unwrap().path());
    let folders = folders.filter(|path| path.join("definition.kd").exists());
    let name = |path: &Path| path.file_name().unwrap().to_str().unwrap().to_owned();
    let mut rows: Vec<_> = folders.map(|path| (name(&path), path.join("definition.kd"))).collect();
    rows.sort();
    rows
}

/// Draws `file` and holds it to the picture of that name.
fn looked_at(name: &str, file: &Path, words: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let (png, svg) = (folder.path().join("picture.png"), folder.path().join("picture.svg"));
    let mut call = vec!["view", text(file), "-o", text(&png), "-o", text(&svg)];
    call.extend(words);
    let output = katydid(&call);
    let told = said(&output);
    assert_eq!((output.status.code(), told.as_str()), (Some(0), ""), "{name}");
    let written = fs::read_to_string(&svg).unwrap();
    // Thousands of faces are put in as pixels.
    let drawn = written.contains("<path") || written.contains("<image");
    assert!(written.starts_with("<svg") && drawn && written.ends_with("</svg>\n"), "{name}");
    let kept = Path::new(PICTURES).join(format!("{name}.png"));
    if std::env::var_os("KATYDID_REFRESH_PICTURES").is_some() {
        fs::create_dir_all(PICTURES).unwrap();
        fs::copy(&png, &kept).unwrap();
    }
    common::pictures::assert_alike(name, &png, &kept);
}

#[test]
fn every_row_of_the_book_looks_as_it_did() {
    for (row, file) in rows() {
        if !WITHOUT_GEOMETRY.contains(&row.as_str()) {
            looked_at(&row, &file, &["--size", "320x200"]);
        }
    }
}

#[test]
fn every_canvas_of_the_book_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    for (row, file) in rows() {
        let kept = WITHOUT_GEOMETRY.contains(&row.as_str()) || CANVASES.contains(&row.as_str());
        if kept {
            looked_at(&format!("{row}-canvas"), &file, &["--canvas", "--size", "640x480"]);
            continue;
        }
        let svg = folder.path().join(format!("{row}.svg"));
        let output = katydid(&["view", text(&file), "--canvas", "-o", text(&svg)]);
        assert_eq!((output.status.code(), said(&output).as_str()), (Some(0), ""), "{row}");
        let written = fs::read_to_string(&svg).unwrap();
        // The note at the top names the row.
        assert!(written.contains(&format!(">{row} · ")), "{row}");
    }
}

#[test]
fn no_picture_is_kept_of_a_row_that_is_gone() {
    let rows: Vec<String> = rows().into_iter().map(|(row, _)| row).collect();
    for entry in fs::read_dir(PICTURES).unwrap() {
        let name = entry.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned();
        let row = name.strip_suffix("-canvas").unwrap_or(&name);
        assert!(rows.iter().any(|r| r == row), "{name}");
    }
}

#[test]
fn nothing_to_show_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let svg = folder.path().join("picture.svg");
    let file = Path::new(BOOK).join("M1/definition.kd");
    let output = katydid(&["view", text(&file), "-o", text(&svg)]);
    assert_eq!(output.status.code(), Some(0));
    assert!(said(&output).contains("nothing to show"), "{}", said(&output));
    assert!(fs::read_to_string(&svg).unwrap().contains("Nothing to show"));
}

#[test]
fn a_wrong_call_is_told() {
    let file = Path::new(BOOK).join("V1/definition.kd");
    let folder = tempfile::tempdir().unwrap();
    let (svg, jpg) = (folder.path().join("a.svg"), folder.path().join("a.jpg"));
    for (words, told) in [
        (vec!["-o", text(&jpg)], ".svg or .png"),
        (vec![], "--output"),
        (vec!["-o", text(&svg), "--size", "0x7"], "WIDTHxHEIGHT"),
        (vec!["-o", text(&svg), "--background", "pale"], "--background pale"),
        (vec!["-o", text(&svg), "--set", "nobody=1"], "no input is called 'nobody'"),
        (vec!["-o", text(&svg), "--canvas", "--grid"], "--grid"),
        (vec!["-o", text(&svg), "--hidden-lines", "often"], "hide, dash, show"),
        (vec!["-o", text(&svg), "--canvas", "--hidden-lines", "dash"], "--hidden-lines"),
    ] {
        let mut call = vec!["view", text(&file)];
        call.extend(words);
        let output = katydid(&call);
        assert_eq!(output.status.code(), Some(2), "{told}");
        assert!(said(&output).contains(told), "{}", said(&output));
        assert!(!svg.exists());
    }
}

#[test]
fn what_is_set_is_seen() {
    let file = Path::new(BOOK).join("C1/definition.kd");
    let folder = tempfile::tempdir().unwrap();
    let draw = |name: &str, words: &[&str]| {
        let svg = folder.path().join(name);
        let mut call = vec!["view", text(&file), "-o", text(&svg)];
        call.extend(words);
        assert_eq!(katydid(&call).status.code(), Some(0));
        fs::read(&svg).unwrap()
    };
    let plain = draw("a.svg", &[]);
    assert_eq!(plain, draw("b.svg", &["--view", "top"]));
    assert_ne!(plain, draw("c.svg", &["--set", "middle=-3"]));
    assert_ne!(plain, draw("d.svg", &["--view", "iso", "--grid", "--axes"]));
    let clear = String::from_utf8(draw("e.svg", &["--background", "none"])).unwrap();
    assert!(!clear.contains("<rect"));
}

#[test]
fn lines_behind_faces_are_drawn_as_asked() {
    let file = Path::new(BOOK).join("V12/definition.kd");
    let folder = tempfile::tempdir().unwrap();
    let svg = folder.path().join("a.svg");
    let drawn = |words: &[&str]| {
        let mut call = vec!["view", text(&file), "-o", text(&svg)];
        call.extend(words);
        assert_eq!(katydid(&call).status.code(), Some(0));
        fs::read_to_string(&svg).unwrap()
    };
    let has = |written: &str| (written.contains("Hidden lines"), written.contains("stroke-dasharray"));
    assert_eq!(has(&drawn(&[])), (false, false));
    assert_eq!(has(&drawn(&["--hidden-lines", "hide"])), (false, false));
    assert_eq!(has(&drawn(&["--hidden-lines", "show"])), (true, false));
    assert_eq!(has(&drawn(&["--hidden-lines", "dash"])), (true, true));
}
