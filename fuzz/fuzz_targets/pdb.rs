//! Files of the Protein Data Bank out of arbitrary bytes: no panic, and bonds between atoms that are there.
#![no_main]

use katydid_exchange::pdb;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(molecule) = pdb::read(bytes) else { return };
    assert!(molecule.atoms.iter().all(|atom| atom.point.is_finite()));
    assert!(molecule.bonds.iter().all(|[a, b]| a < b && *b < molecule.atoms.len()));
});
