//! Thresholds have names and reasons: the kernel's sources are read for small numbers that have none. A threshold has its
//! place in the `thresholds.rs` of its folder, or of the kernel where many have use of it; in a module of one file it is a
//! constant at the top.
#![allow(clippy::unwrap_used, reason = "a failing test may panic")]

use std::path::{Path, PathBuf};

fn sources(at: &Path, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(at).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
}

/// The lines with numbers such as 1e-9 that are neither constants nor comments nor tests.
fn raw(path: &Path) -> Vec<String> {
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    if name.contains("test") || name == "families.rs" || name == "thresholds.rs" {
        return Vec::new();
    }
    let text = std::fs::read_to_string(path).unwrap();
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    text.lines()
        .map(|line| line.split("//").next().unwrap_or_default())
        .filter(|code| !code.contains("const ") && has_small_number(code))
        .map(|code| format!("{}: {}", path.display(), code.trim()))
        .collect()
}

fn has_small_number(code: &str) -> bool {
    let bytes = code.as_bytes();
    code.match_indices("e-").any(|(i, _)| {
        i > 0 && bytes[i - 1].is_ascii_digit() && bytes.get(i + 2).is_some_and(u8::is_ascii_digit)
    })
}

#[test]
fn thresholds_have_names() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut all = Vec::new();
    sources(&src, &mut all);
    assert!(all.len() > 100);
    let found: Vec<String> = all.iter().flat_map(|path| raw(path)).collect();
    assert!(found.is_empty(), "{found:#?}");
}
