//! The text form: reading never panics, what is read can be written, and formatting settles.

#![no_main]

use katydid_definition::kd::{self, NoCatalogue};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(text) = std::str::from_utf8(data) else { return };
    if let Ok(tidy) = kd::format(text) {
        assert_eq!(kd::format(&tidy).as_deref(), Ok(tidy.as_str()), "formatting settles");
    }
    match kd::read(text, &NoCatalogue) {
        Ok(read) => {
            let Ok(written) = kd::write(&read.document, &NoCatalogue) else { return };
            let again = kd::read(&written.text, &NoCatalogue).expect("what was written can be read");
            assert_eq!(again.document.objects.len(), read.document.objects.len());
        }
        Err(problems) => assert!(!problems.list.is_empty() && !problems.to_string().is_empty()),
    }
});
