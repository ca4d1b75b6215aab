//! The modules of the crate stand in layers: none imports, over whatever others, one that imports it.
#![allow(clippy::unwrap_used, reason = "a failing test may panic")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The text without comments and without the tests at its end.
fn code(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

fn sources(at: &Path, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(at).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs")
            && path.file_stem().is_some_and(|s| s != "tests")
        {
            out.push(path);
        }
    }
}

/// The first word of a text.
fn word(text: &str) -> &str {
    let text = text.trim_start();
    &text[..text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len())]
}

/// The first words of what stands in braces at the start of a text, or its first word.
fn first_words(text: &str) -> Vec<&str> {
    let Some(inside) = text.strip_prefix('{') else { return vec![word(text)] };
    let (mut depth, mut start, mut out) = (0, 0, Vec::new());
    for (i, c) in inside.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => {
                out.push(word(&inside[start..i]));
                break;
            }
            '}' => depth -= 1,
            ',' if depth == 0 => {
                out.push(word(&inside[start..i]));
                start = i + 1;
            }
            _ => {}
        }
    }
    out.retain(|w| !w.is_empty());
    out
}

/// All words of an import, in braces or not.
fn words(text: &str) -> Vec<&str> {
    let end = text.find(';').unwrap_or(text.len());
    text[..end].split(|c: char| !c.is_alphanumeric() && c != '_').filter(|w| !w.is_empty()).collect()
}

#[test]
fn no_module_imports_itself_over_others() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let lib = code(&src.join("lib.rs"));
    let modules: BTreeSet<&str> =
        lib.lines().filter_map(|l| l.trim().split_once("mod ")?.1.strip_suffix(';')).collect();
    assert!(modules.len() > 30);
    // What the crate's root takes over from a module is that module's.
    let mut owners: BTreeMap<&str, &str> = modules.iter().map(|m| (*m, *m)).collect();
    for (at, _) in lib.match_indices("use ") {
        let all = words(&lib[at + 4..]);
        if let Some((module, names)) = all.split_first()
            && modules.contains(module)
        {
            owners.extend(names.iter().map(|name| (*name, *module)));
        }
    }
    let mut imports: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for module in &modules {
        let mut files = Vec::new();
        let single = src.join(format!("{module}.rs"));
        if single.exists() {
            files.push(single);
        }
        if src.join(module).is_dir() {
            sources(&src.join(module), &mut files);
        }
        assert!(!files.is_empty(), "{module}");
        let own = imports.entry(module).or_default();
        for file in files {
            let text = code(&file);
            for (at, found) in text.match_indices("crate::") {
                for name in first_words(&text[at + found.len()..]) {
                    own.extend(owners.get(name).filter(|owner| *owner != module));
                }
            }
        }
    }
    // Modules that import none of those left are taken away until none can be.
    loop {
        let free: Vec<&str> = imports
            .iter()
            .filter(|(_, own)| own.iter().all(|m| !imports.contains_key(m)))
            .map(|(m, _)| *m)
            .collect();
        if free.is_empty() {
            break;
        }
        imports.retain(|m, _| !free.contains(m));
    }
    assert!(imports.is_empty(), "rings, and what stands on them: {imports:#?}");
}
