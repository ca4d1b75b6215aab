//! The modules of the kernel stand in layers: each imports only what stands before it, so there are no rings.
#![allow(clippy::unwrap_used, reason = "a failing test may panic")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The layers and their modules. A module may import those before it, in its own layer too. Where something needs a module
/// that comes later, it belongs further down in this list: an `impl` block may stand in another module than its type.
const LAYERS: [(&str, &[&str]); 7] = [
    (
        "numbers, vectors and polynomials",
        &[
            "thresholds",
            "interval",
            "units",
            "hash",
            "vector",
            "vector2",
            "point",
            "point2",
            "error",
            "cancellation",
            "parallel",
            "tolerance",
            "bernstein",
            "polynomial",
            "linear",
            "matrix",
            "quadrature",
            "moments",
        ],
    ),
    (
        "planes, maps, boxes, lines and circles",
        &[
            "plane",
            "xform",
            "quaternion",
            "bounding_box",
            "line",
            "rectangle",
            "box3",
            "box_tree",
            "box_pairs",
            "circle",
            "ellipse",
            "tangent",
            "tangent_arc",
        ],
    ),
    (
        "curves and surfaces",
        &[
            "nurbs",
            "curve",
            "tangent_circle",
            "swing",
            "catenary",
            "hanging_chain",
            "biarc",
            "isoline",
            "surface",
            "chart",
            "trace",
        ],
    ),
    ("meshes and clouds", &["mesh", "cloud", "twisted_box", "isosurface", "substrate", "field"]),
    (
        "intersections and regions",
        &["intersect", "offset", "pull", "region", "longest_rectangle", "lettering"],
    ),
    ("Breps", &["brep", "meshing", "subd", "morph", "silhouette", "drawing"]),
    ("construction, and forms for other crates", &["construct", "explain", "serde_forms", "foreign"]),
];

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

/// The text without comments and without the tests at its end.
fn code(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
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

/// The modules in which a file stands, from the root on.
fn place(src: &Path, file: &Path) -> Vec<String> {
    let below = file.strip_prefix(src).unwrap().with_extension("");
    let mut names: Vec<String> = below.iter().map(|n| n.to_string_lossy().into_owned()).collect();
    if names.last().is_some_and(|n| n == "mod") {
        names.pop();
    }
    names
}

/// The modules in files of their own that are for tests alone.
fn test_modules(src: &Path, files: &[PathBuf]) -> Vec<Vec<String>> {
    let mut out = Vec::new();
    for file in files {
        let text = std::fs::read_to_string(file).unwrap();
        for part in text.split("#[cfg(test)]\n").skip(1) {
            let line = part.lines().next().unwrap_or_default().trim();
            if let Some(name) = line.strip_suffix(';').and_then(|l| l.rsplit_once("mod ")) {
                let mut at = place(src, file);
                at.push(name.1.to_owned());
                out.push(at);
            }
        }
    }
    out
}

#[test]
fn modules_import_what_stands_before_them() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let lib = code(&src.join("lib.rs"));
    let modules: BTreeSet<&str> =
        lib.lines().filter_map(|l| l.trim().split_once("mod ")?.1.strip_suffix(';')).collect();
    let order: Vec<&str> = LAYERS.iter().flat_map(|(_, names)| names.iter().copied()).collect();
    assert_eq!(order.len(), modules.len(), "each module stands once in the list");
    let rank: BTreeMap<&str, usize> = order.iter().enumerate().map(|(k, name)| (*name, k)).collect();
    assert!(modules.iter().all(|name| rank.contains_key(name)), "{modules:?}");
    // What the crate's root takes over from a module is that module's.
    let mut owners: BTreeMap<&str, &str> = modules.iter().map(|m| (*m, *m)).collect();
    for (at, _) in lib.match_indices("use ") {
        let line = lib[at + 4..].split(';').next().unwrap_or_default();
        let mut names = line.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|w| !w.is_empty());
        if let Some(module) = names.next().filter(|m| modules.contains(m)) {
            owners.extend(names.map(|name| (name, module)));
        }
    }
    let mut files = Vec::new();
    sources(&src, &mut files);
    assert!(files.len() > 400);
    let tests = test_modules(&src, &files);
    let (mut seen, mut wrong) = (0, BTreeSet::new());
    for file in &files {
        let at = place(&src, file);
        if at.len() == 1 && at[0] == "lib" || tests.iter().any(|t| at.starts_with(t)) {
            continue;
        }
        let text = code(file);
        let absolute = text.match_indices("crate::").map(|(k, found)| k + found.len());
        // As many steps up as the file is deep lead to the root; modules within a file only make it deeper.
        let up = "super::".repeat(at.len());
        let relative = text.match_indices(&up).map(|(k, found)| k + found.len());
        for start in absolute.chain(relative) {
            for name in first_words(&text[start..]) {
                let Some(owner) = owners.get(name).filter(|owner| **owner != at[0]) else { continue };
                seen += 1;
                if rank[owner] > rank[at[0].as_str()] {
                    wrong.insert(format!("{} imports {owner}: {}", at[0], file.display()));
                }
            }
        }
    }
    assert!(seen > 2000, "{seen}");
    assert!(wrong.is_empty(), "{wrong:#?}");
}
