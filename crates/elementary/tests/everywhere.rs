//! What computes uses the functions of this crate: the standard library's differ from one system to the next.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::fs;
use std::path::{Path, PathBuf};

/// The functions that the system's library has in a form of its own.
const SYSTEM: [&str; 24] = [
    "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh",
    "exp", "exp2", "exp_m1", "ln", "ln_1p", "log2", "log10", "cbrt", "hypot", "powf", "sin_cos",
];

/// The crates whose results count. Others serve, wait or print.
const CRATES: [&str; 17] = [
    "geometry",
    "rhino3dm",
    "step",
    "exchange",
    "data",
    "expression",
    "definition",
    "component",
    "components",
    "components-more",
    "solver",
    "scene",
    "session",
    "members",
    "csharp",
    "script",
    "picture",
];

/// A quaternion's exponential and logarithm are functions of our own; the cameras of version 1 have the bits that the official
/// reader gives them, which asks the system.
const OTHERS: [&str; 2] = ["geometry/src/quaternion.rs", "rhino3dm/src/v1/view.rs"];

fn sources(folder: &Path, all: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            if name != "tests" {
                sources(&path, all);
            }
        } else if name.ends_with(".rs") && !name.ends_with("tests.rs") {
            all.push(path);
        }
    }
}

/// The text before the tests that stand at the end of a file.
fn computing(text: &str) -> &str {
    text.find("\n#[cfg(test)]\n").map_or(text, |at| &text[..at])
}

#[test]
fn nothing_that_computes_asks_the_systems_library() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let mut all = Vec::new();
    for name in CRATES {
        sources(&crates.join(name).join("src"), &mut all);
    }
    assert!(all.len() > 500, "{}", all.len());
    let mut found = Vec::new();
    for path in all {
        if OTHERS.iter().any(|other| path.ends_with(other)) {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        for (at, line) in computing(&text).lines().enumerate() {
            let code = line.split("//").next().unwrap_or_default();
            // Types of our own may have functions of such names without arguments: those of a quaternion, say.
            let is_asked = |name: &&str| {
                let mut rest = code;
                while let Some(k) = rest.find(&format!(".{name}(")) {
                    let before = rest[..k].chars().next_back().unwrap_or(' ');
                    if !before.is_whitespace() || rest[..k].trim().is_empty() {
                        return true;
                    }
                    rest = &rest[k + 1..];
                }
                let path = format!("f64::{name}");
                code.match_indices(&path).any(|(at, _)| {
                    let next = code[at + path.len()..].chars().next();
                    !next.is_some_and(|next| next.is_alphanumeric() || next == '_')
                })
            };
            if let Some(name) = SYSTEM.iter().find(|name| is_asked(name)) {
                found.push(format!("{}:{}: {name}", path.display(), at + 1));
            }
        }
    }
    assert!(
        found.is_empty(),
        "katydid_elementary has these with the same bits everywhere:\n{}",
        found.join("\n")
    );
}
