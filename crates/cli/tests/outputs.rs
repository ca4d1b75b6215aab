//! What is printed and written: whole, or an error that is said.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]
#![cfg(unix)]

mod common;

use std::fs::{self, File};
use std::io::Write;
use std::process::{Command, Output, Stdio};

use common::{katydid, said, text};

const EXAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/attractor.ghx");

/// Runs the command with a standard output of ours; `input` is what it reads.
fn printing_to(out: Stdio, words: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_katydid"))
        .args(words)
        .stdin(Stdio::piped())
        .stdout(out)
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Commands that read nothing close it.
    let _ = child.stdin.take().unwrap().write_all(input);
    child.wait_with_output().unwrap()
}

/// Every command that prints, with what it reads.
fn printing(folder: &std::path::Path) -> Vec<(Vec<String>, &'static [u8])> {
    let (model, wild) = (folder.join("a.3dm"), folder.join("wild.kd"));
    assert_eq!(katydid(&["run", EXAMPLE, "-o", text(&model)]).status.code(), Some(0));
    let set = b"katydid 1\nr = Number Slider(2.0, 0..10)\n";
    fs::write(&wild, "katydid 1\nr   =   Number Slider(2.0, 0..10)\n").unwrap();
    let calls: &[&[&str]] = &[
        &["run", EXAMPLE, "--json"],
        &["run", EXAMPLE, "--json=values"],
        &["run", EXAMPLE, "--timings"],
        &["check", EXAMPLE],
        &["check", "--json", EXAMPLE],
        &["info", text(&model)],
        &["info", "--json", text(&model)],
        &["info", "--tree", text(&model)],
        &["info", "--tree", "--json", text(&model)],
        &["diff", EXAMPLE, text(&wild)],
        &["diff", "--json", EXAMPLE, text(&wild)],
        &["fmt", "--check", text(&wild)],
        &["fmt", "-"],
        &["components"],
        &["components", "--json"],
        &["components", "Divide Curve"],
        &["--help"],
        &["run", "--help"],
        &["--version"],
    ];
    calls.iter().map(|words| (words.iter().map(|&word| word.to_owned()).collect(), set.as_slice())).collect()
}

#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_printed_is_an_error_that_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let mut calls = printing(folder.path());
    for server in ["serve", "studio"] {
        let mut words = vec![server.to_owned(), "--port".to_owned(), "0".to_owned()];
        words.extend((server == "studio").then(|| "--no-open".to_owned()));
        calls.push((words, b""));
    }
    for (words, input) in calls {
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let full = File::options().write(true).open("/dev/full").unwrap();
        let output = printing_to(full.into(), &words, input);
        assert_eq!(output.status.code(), Some(2), "{words:?}: {}", said(&output));
        assert!(said(&output).contains("could not be written"), "{words:?}: {}", said(&output));
        assert!(!said(&output).contains("panicked"), "{words:?}: {}", said(&output));
    }
}

#[test]
fn a_reader_that_has_gone_away_is_no_error() {
    let folder = tempfile::tempdir().unwrap();
    for (words, input) in printing(folder.path()) {
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let usual = printing_to(Stdio::null(), &words, input);
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = printing_to(writer.into(), &words, input);
        assert_eq!(output.status.code(), usual.status.code(), "{words:?}: {}", said(&output));
        for word in ["error", "panicked", "pipe"] {
            assert!(!said(&output).contains(word), "{words:?}: {}", said(&output));
        }
    }
}

#[test]
fn a_link_that_somebody_placed_beside_an_output_is_not_followed() {
    let folder = tempfile::tempdir().unwrap();
    let victim = folder.path().join("victim");
    fs::write(&victim, "mine").unwrap();
    for name in ["a.3dm", "a.obj", "a.svg", "a.kd"] {
        let out = folder.path().join(name);
        std::os::unix::fs::symlink(&victim, folder.path().join(format!("{name}.part"))).unwrap();
        let words = match name {
            "a.kd" => vec!["convert", EXAMPLE, text(&out)],
            "a.svg" => vec!["view", EXAMPLE, "-o", text(&out)],
            _ => vec!["run", EXAMPLE, "-o", text(&out)],
        };
        let output = katydid(&words);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", said(&output));
        assert!(fs::metadata(&out).unwrap().len() > 100, "{name}");
        assert_eq!(fs::read(&victim).unwrap(), b"mine", "{name}");
    }
}

#[test]
fn runs_that_write_the_same_output_do_not_mix_it() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("a.obj");
    let size = |columns: &str| {
        let set = format!("columns={columns}");
        let output = katydid(&["run", EXAMPLE, "--set", &set, "-o", text(&out)]);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        fs::read(&out).unwrap()
    };
    let wanted = [size("60"), size("3")];
    std::thread::scope(|scope| {
        for columns in ["60", "3", "60", "3"] {
            let size = &size;
            let wanted = &wanted;
            scope.spawn(move || {
                for _ in 0..3 {
                    assert!(wanted.contains(&size(columns)), "the file is one of the two, whole");
                }
            });
        }
    });
    let names: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert!(names.iter().all(|name| !name.to_string_lossy().ends_with(".part")), "{names:?}");
}

#[test]
fn what_no_wire_reads_is_saved() {
    let folder = tempfile::tempdir().unwrap();
    let (definition, model) = (folder.path().join("grid.kd"), folder.path().join("grid.3dm"));
    // 3 × 4 cells, and the 4 × 5 points at their corners.
    fs::write(&definition, "katydid 1\nr = Rectangular(_, 2, 1, 3, 4)\n").unwrap();
    let saved = said(&katydid(&["run", text(&definition), "-o", text(&model)]));
    assert!(saved.contains("32 objects written"), "{saved}");
}
