//! Archives and single objects out of arbitrary bytes: no panic, no runaway memory.
#![no_main]

use katydid_3dm::{BrepSummary, Limits, Model, Object};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let limits = Limits { inflated: 1 << 26, ..Limits::default() };
    let strict = Model::read_strict(bytes, &limits);
    if let Ok(model) = Model::read(bytes, &limits) {
        for object in &model.objects {
            if let Object::Kept(raw) = &object.geometry {
                let _ = BrepSummary::read(raw);
            }
        }
        for version in [4, 50, 60, 70, 80] {
            if let Ok(written) = model.write(version) {
                // Objects kept as bytes may be broken inside, but none is lost.
                let again = Model::read(&written, &Limits::default()).unwrap();
                assert_eq!(again.objects.len(), model.objects.len());
            }
        }
    } else {
        // What cannot be read at all cannot be read strictly.
        assert!(strict.is_err());
    }
    // The first byte chooses the archive version, so that one corpus covers both chunk widths.
    if let Some((choice, data)) = bytes.split_first() {
        let version = [4, 50, 60, 70, 80][usize::from(*choice) % 5];
        let opennurbs = if version < 60 { 201_001_010 } else { -1_870_000_000 };
        let _ = Object::from_on_data(version, opennurbs, data);
    }
});
