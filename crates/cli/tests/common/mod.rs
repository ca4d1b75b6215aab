//! Running the command as a user does.

#![allow(dead_code, reason = "each test uses a part")]

pub(crate) mod pictures;
pub(crate) mod server;

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// The shared test data, or nothing with a line that says so.
pub(crate) fn shared(path: &str) -> Option<PathBuf> {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared")).join(path);
    if path.exists() {
        return Some(path);
    }
    assert!(std::env::var_os("KATYDID_REQUIRE_SHARED").is_none(), "{} is absent", path.display());
    println!("skipped: {} is absent", path.display());
    None
}

/// The definitions in a folder and the folders in it, in order.
pub(crate) fn definitions(folder: &Path) -> Vec<PathBuf> {
    let mut entries: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    entries.sort();
    let mut all = Vec::new();
    for path in entries {
        if path.is_dir() {
            all.extend(definitions(&path));
        } else if path.extension().is_some_and(|e| e == "gh" || e == "ghx") {
            all.push(path);
        }
    }
    all
}

/// A compute server on a free port, and where it listens.
pub(crate) fn serving(words: &[&str]) -> (Child, String) {
    let (child, url) =
        listening(Command::new(env!("CARGO_BIN_EXE_katydid")).args(["serve", "--port", "0"]).args(words));
    (child, host_of(&url))
}

/// A program that says first where it listens, and that address.
pub(crate) fn listening(command: &mut Command) -> (Child, String) {
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
    let mut url = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut url).unwrap();
    (child, url.trim().to_owned())
}

/// Host and port of an address.
pub(crate) fn host_of(url: &str) -> String {
    url.trim_start_matches("http://").trim_end_matches('/').to_owned()
}

/// The command with these words.
pub(crate) fn katydid(words: &[&str]) -> Output {
    within(Duration::from_secs(120), words).expect("the command hangs")
}

/// The command with these words; nothing when it takes longer than that, and is stopped.
pub(crate) fn within(time: Duration, words: &[&str]) -> Option<Output> {
    let mut child = Command::new(env!("CARGO_BIN_EXE_katydid"))
        .args(words)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // The pipes are read while it runs: a full pipe would stop it.
    let mut out = child.stdout.take().unwrap();
    let mut err = child.stderr.take().unwrap();
    let read = |pipe: &mut dyn std::io::Read| {
        let mut bytes = Vec::new();
        pipe.read_to_end(&mut bytes).unwrap();
        bytes
    };
    std::thread::scope(|scope| {
        let stdout = scope.spawn(move || read(&mut out));
        let stderr = scope.spawn(move || read(&mut err));
        let start = Instant::now();
        let status = loop {
            if let Some(status) = child.try_wait().unwrap() {
                break Some(status);
            }
            if start.elapsed() > time {
                child.kill().unwrap();
                child.wait().unwrap();
                break None;
            }
            std::thread::sleep(Duration::from_millis(3));
        };
        let (stdout, stderr) = (stdout.join().unwrap(), stderr.join().unwrap());
        status.map(|status| Output { status, stdout, stderr })
    })
}

/// What was printed on standard error.
pub(crate) fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A path as text.
pub(crate) fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}
