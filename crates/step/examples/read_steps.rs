//! Reads STEP files and says what was left out and what is wrong with the breps: `read_steps [--measure] PATH…`
//!
//! With `--measure` a line a brep, for another kernel to judge: with tabs between the file, how many faces it has,
//! whether it is closed, and its volume in millimetres, of an open one its area.

#![allow(clippy::print_stdout, reason = "an example tells what it found")]

use katydid_step::{Shape, read};

fn main() -> std::io::Result<()> {
    let (mut files, mut refused, mut invalid) = (0, 0, 0);
    let is_measured = std::env::args().any(|word| word == "--measure");
    for path in std::env::args().skip(1).filter(|word| word != "--measure") {
        files += 1;
        let document = match read(&std::fs::read(&path)?) {
            Ok(document) => document,
            Err(error) => {
                refused += 1;
                println!("{path}: not read: {error}");
                continue;
            }
        };
        refused += usize::from(!document.left_out.is_empty());
        for left_out in &document.left_out {
            println!("{path}: left out: {left_out:?}");
        }
        for (place, part) in document.parts.iter().enumerate() {
            let Shape::Brep(brep) = &part.shape else { continue };
            if is_measured {
                println!("{path}\t{}\t{}", brep.faces().len(), measured(brep, document.metres));
            }
            let faults = brep.faults();
            invalid += usize::from(!faults.is_empty());
            for fault in faults.iter().take(4) {
                println!("{path}: part {place}: {fault}");
            }
        }
    }
    println!("{files} files, {refused} with parts left out, {invalid} invalid breps");
    Ok(())
}

/// Closed or open, and the volume or the area.
fn measured(brep: &katydid_geometry::Brep, metres: f64) -> String {
    let scale = metres * 1e3;
    let (word, found, factor) = if brep.is_solid() {
        ("closed", brep.volume_properties(1e-11, || true), scale.powi(3))
    } else {
        ("open", brep.area_properties(1e-11, || true), scale.powi(2))
    };
    found.map_or_else(
        |error| format!("{word}\t{error}"),
        |found| format!("{word}\t{:.12e}", found.amount * factor),
    )
}
