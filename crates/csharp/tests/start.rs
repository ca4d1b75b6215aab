//! What starting a program costs once the library has been read.

use std::time::{Duration, Instant};

use katydid_csharp::{Engine, Limits, Printing, Source};

#[test]
fn the_next_program_starts_at_once() {
    let source = Source::File("class P { static void Main() { } }");
    let start = || {
        let begun = Instant::now();
        let ended = Engine::new(&source, Box::new(Printing::default()), Limits::default())
            .map_err(|e| e[0].to_string())
            .and_then(|mut engine| engine.run_main().map(|_| ()).map_err(|e| e.to_string()));
        assert_eq!(ended, Ok(()));
        begun.elapsed()
    };
    let first = start();
    let next = (0..20).map(|_| start()).min().unwrap_or(Duration::MAX);
    println!("first {first:?}, next {next:?}");
    assert!(next < first / 2, "first {first:?}, next {next:?}");
}
