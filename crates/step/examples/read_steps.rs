//! Reads STEP files and says what was left out and what is wrong with the breps: `read_steps PATH…`

#![allow(clippy::print_stdout, reason = "an example tells what it found")]

use katydid_step::{Shape, read};

fn main() -> std::io::Result<()> {
    let (mut files, mut refused, mut invalid) = (0, 0, 0);
    for path in std::env::args().skip(1) {
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
