#![no_main]
//! The body of a VB component is run within small limits: an end, an exception or a stop.

use katydid_csharp::{Engine, Limits, Parts, Printing, Source};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &str| {
    let source = Source::Basic(Parts {
        using: "",
        body: data,
        additional: "",
        parameters: "dynamic x, ref object A",
        usual: "using System; using System.Collections.Generic; using System.Linq;",
        base: "",
    });
    let limits = Limits { steps: 300_000, bytes: 16 << 20, depth: 300, output: 1 << 16 };
    let Ok(mut engine) = Engine::new(&source, Box::new(Printing::default()), limits) else { return };
    let Ok(object) = engine.create("Script_Instance") else { return };
    let method = engine.method("Script_Instance", "RunScript").zip(engine.type_named("", "Script_Instance"));
    if let Some((method, owner)) = method {
        let x = engine.state().text("7");
        let _ = engine.call_with_refs(method, owner, &[object, x], &[katydid_csharp::Value::Null]);
    }
});
