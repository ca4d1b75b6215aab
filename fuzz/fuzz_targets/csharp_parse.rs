#![no_main]
//! Any text is a C# program or is refused, with lines that are there.

use katydid_csharp::{Engine, Limits, Printing, Source};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &str| {
    if let Err(errors) = Engine::new(&Source::File(data), Box::new(Printing::default()), Limits::default()) {
        assert!(!errors.is_empty());
        let lines = data.split('\n').count() as u32;
        for error in errors {
            assert!(&*error.at.part != "script" || error.at.line <= lines, "{error}");
        }
    }
});
