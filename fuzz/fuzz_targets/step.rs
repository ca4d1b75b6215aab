//! STEP files out of arbitrary bytes: no panic, no runaway memory; what is read can be written and read again.
#![no_main]

use katydid_step::{Limits, read_with, write};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let limits = Limits { entities: 10_000, parts: 1000 };
    let Ok(document) = read_with(bytes, &limits) else { return };
    let mut file = Vec::new();
    if write(&document, &mut file).is_ok() {
        read_with(&file, &Limits::default()).unwrap();
    }
});
