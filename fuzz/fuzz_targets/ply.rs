//! PLY files out of arbitrary bytes: no panic, no runaway memory; what is read can be written and read again.
#![no_main]

use katydid_exchange::Format;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| katydid_fuzz::there_and_back(bytes, Format::Ply));
