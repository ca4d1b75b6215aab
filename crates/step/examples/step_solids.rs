//! Writes breps of every constructor on seeded inputs, each as a STEP file of its own: `step_solids FOLDER [COUNT
//! [CONSTRUCTOR…]]`
//!
//! For another kernel to judge (`python-tests/step/test_solids.py`): a line a brep, with tabs between the file's name,
//! the constructor and seed, whether it is closed, how many faces it has, and its volume, of an open one its area.

#![allow(clippy::print_stdout, reason = "an example speaks")]

#[path = "../../geometry/tests/solid_cases/mod.rs"]
mod solid_cases;

use std::path::PathBuf;

use katydid_geometry::Brep;
use katydid_step::{Document, Part, Shape, write};
use solid_cases::random::Random;

/// How exactly volumes and areas are told, in parts of the size.
const FRACTION: f64 = 1e-11;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or("usage: step_solids FOLDER [COUNT [CONSTRUCTOR…]]")?);
    let count: u64 = arguments.next().map_or(Ok(100), |n| n.parse())?;
    let only: Vec<String> = arguments.collect();
    for (name, make) in solid_cases::cases() {
        if !only.is_empty() && !only.iter().any(|wanted| wanted == name) {
            continue;
        }
        for seed in 0..count {
            for (place, brep) in make(&mut Random::of(seed)).into_iter().flatten().enumerate() {
                let file = format!("{}-{seed}-{place}.step", name.replace(' ', "-"));
                let mut document =
                    Document { tolerance: solid_cases::TOLERANCE.absolute, ..Document::default() };
                document.parts.push(Part::named(name, Shape::Brep(brep.clone().into())));
                let left_out = write(&document, &mut std::fs::File::create(folder.join(&file))?)?;
                let figures =
                    left_out.first().map_or_else(|| told(&brep), |left| format!("left out: {}", left.why));
                println!("{file}\t{name}/{seed}/{place}\t{figures}");
            }
        }
    }
    Ok(())
}

/// Closed or open, how many faces, and the volume or the area.
fn told(brep: &Brep) -> String {
    let closed = brep.is_solid();
    let measured = if closed {
        brep.volume_properties(FRACTION, || true)
    } else {
        brep.area_properties(FRACTION, || true)
    };
    let word = if closed { "closed" } else { "open" };
    match measured {
        Ok(found) => format!("{word}\t{}\t{:.12e}", brep.faces().len(), found.amount),
        Err(error) => format!("not measured: {error}"),
    }
}
