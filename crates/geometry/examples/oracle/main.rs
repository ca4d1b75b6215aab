//! Compares the kernel with the answers of other kernels, case by case.
//!
//! ```text
//! cargo run --release -p katydid-geometry --example oracle -- FILE.json…
//! ```
//!
//! Each file is one JSON object: a list of cases for every kind. For each kind it prints how many cases there are,
//! how many agree in every field and the largest error among the numbers compared, as a part of their magnitude; then
//! each disagreement with the case's id. The exit status is 1 when there is one, 2 when a file cannot be read.
//!
//! What counts as agreement: evaluation within 1e-13 of the magnitude, knots and control points of constructions
//! within 1e-14, a closest point no farther than the reference's by 1e-9, and of intersections all and no more.
//! Fields that end in `_occ` are another kernel's opinion and are not looked at.

mod conics;
mod curves;
mod intersections;
mod measures;
mod meets;
mod primitives;
mod read;
mod report;
mod surface_pairs;
mod surfaces;
mod xforms;

use std::io::Write;
use std::process::ExitCode;

use report::Kind;
use serde_json::Value;

/// Compares one case; an error says what in the file could not be understood.
type Compare = fn(&Value, &mut report::Case) -> Result<(), String>;

/// What can be compared, by the name of the list in the file.
const KINDS: &[(&str, Compare)] = &[
    ("curves", curves::compare),
    ("conics", conics::compare),
    ("xforms", xforms::compare),
    ("intersections", intersections::compare),
    ("surfaces", surfaces::compare),
    ("primitives", primitives::compare),
    ("length", measures::length),
    ("closest_curve", measures::closest_curve),
    ("closest_surface", measures::closest_surface),
    ("curvature", measures::curvature),
    ("area", measures::area),
    ("curve_curve_2d", meets::curve_curve),
    ("curve_surface", meets::curve_surface),
    ("cases", surface_pairs::branches),
    ("surface_surface", surface_pairs::points),
];

/// Kinds of the same files that belong to solids.
const NOT_PART: &[&str] = &["solids", "tessellation"];

fn main() -> ExitCode {
    let files: Vec<String> = std::env::args().skip(1).collect();
    if files.is_empty() {
        eprintln!("usage: oracle FILE.json…");
        return ExitCode::from(2);
    }
    match compare_files(&files, &mut std::io::stdout().lock()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

/// Whether all cases of all files agree.
fn compare_files(files: &[String], out: &mut impl Write) -> Result<bool, String> {
    let mut agreed = true;
    for file in files {
        let text = std::fs::read_to_string(file).map_err(|e| format!("{file}: {e}"))?;
        let data: Value = serde_json::from_str(&text).map_err(|e| format!("{file}: {e}"))?;
        writeln!(out, "{file}").map_err(|e| e.to_string())?;
        agreed &= compare_file(&data, out).map_err(|e| e.to_string())?;
    }
    Ok(agreed)
}

/// Whether all cases of a file agree.
fn compare_file(data: &Value, out: &mut impl Write) -> std::io::Result<bool> {
    let Some(kinds) = data.as_object() else {
        writeln!(out, "  no object of lists of cases")?;
        return Ok(false);
    };
    let mut agreed = true;
    for (name, cases) in kinds {
        if name == "meta" {
            continue;
        }
        let list = cases.as_array().map_or(&[][..], Vec::as_slice);
        let Some((_, compare)) = KINDS.iter().find(|k| k.0 == name) else {
            let why = if NOT_PART.contains(&name.as_str()) { "not part" } else { "not part: unknown kind" };
            writeln!(out, "{name:>16}: {:4} cases, {why}", list.len())?;
            continue;
        };
        let mut kind = Kind::default();
        for (i, value) in list.iter().enumerate() {
            let id = value["id"].as_str().map_or_else(|| format!("{name}[{i}]"), str::to_owned);
            kind.run(id, |case| compare(value, case));
        }
        agreed &= kind.write(name, out)?;
    }
    Ok(agreed)
}
