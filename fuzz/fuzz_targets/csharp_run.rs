#![no_main]
//! Statements are run within small limits: an end, an exception or a stop.

use katydid_csharp::{Engine, Limits, Printing, Source};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &str| {
    let source = format!(
        "using System; using System.Collections.Generic; using System.Linq; class P {{ static void Main() {{ {data} }} }}"
    );
    let limits = Limits { steps: 300_000, bytes: 16 << 20, depth: 300, output: 1 << 16 };
    if let Ok(mut engine) = Engine::new(&Source::File(&source), Box::new(Printing::default()), limits) {
        let _ = engine.run_main();
    }
});
