//! Manual pages and completions: every command that help lists has its page and is completed.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::collections::BTreeSet;

use common::{katydid, text};

/// What was printed on standard output.
fn printed(output: &std::process::Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// The commands as `katydid --help` lists them.
fn commands() -> BTreeSet<String> {
    let help = printed(&katydid(&["--help"]));
    let list = help.split("Commands:").nth(1).unwrap().split("Options:").next().unwrap();
    let names: BTreeSet<String> = list
        .lines()
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next().map(str::to_owned))
        .filter(|name| name != "help")
        .collect();
    assert!(names.len() > 15 && names.contains("run"), "{names:?}");
    names
}

#[test]
fn every_command_has_a_manual_page() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("man");
    assert_eq!(katydid(&["man", "-o", text(&out)]).status.code(), Some(0));
    let mut pages: BTreeSet<String> = std::fs::read_dir(&out)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    assert!(pages.remove("katydid.1"));
    for name in commands() {
        assert!(pages.remove(&format!("katydid-{name}.1")), "{name} has no page");
    }
    // What is left are the commands below a command.
    assert_eq!(Vec::from_iter(pages), ["katydid-python-add.1", "katydid-python-sync.1"]);
    let run = std::fs::read_to_string(out.join("katydid-run.1")).unwrap();
    assert!(run.starts_with(".ie") || run.contains(".TH katydid-run 1"), "{run}");
    assert!(run.contains("\\-\\-output"), "{run}");
}

#[test]
fn shells_complete_every_command() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = katydid(&["completions", shell]);
        assert_eq!(script.status.code(), Some(0), "{shell}");
        let script = printed(&script);
        for name in commands() {
            assert!(script.contains(&name), "{shell} does not know {name}");
        }
    }
    assert_eq!(katydid(&["completions", "teletype"]).status.code(), Some(2));
}
