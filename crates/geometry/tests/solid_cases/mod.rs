//! Every constructor of breps on random and degenerate inputs, from a seed: one table of them all.

#![allow(unreachable_pub, dead_code, reason = "shared by tests that each use a part")]

mod edits;
pub mod inputs;
pub mod random;
mod skins;
mod solids;

use katydid_geometry::{Brep, Result, Tolerance};
use random::Random;

/// The tolerances that every constructor is given.
pub const TOLERANCE: Tolerance = Tolerance { absolute: 0.001, angle: std::f64::consts::PI / 180.0 };

/// A constructor by name, with random input for it.
pub type Case = (&'static str, fn(&mut Random) -> Result<Vec<Brep>>);

fn one(brep: Result<Brep>) -> Result<Vec<Brep>> {
    brep.map(|b| vec![b])
}

/// All constructors.
pub fn cases() -> Vec<Case> {
    [solids::cases(), skins::cases(), edits::cases()].concat()
}

/// How many seeds each constructor is given: `KATYDID_CASES`, else a few.
pub fn count(few: u64) -> u64 {
    std::env::var("KATYDID_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(few)
}
