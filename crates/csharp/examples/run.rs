//! Runs a C# program: `cargo run -p katydid-csharp --example run -- program.cs`. Prints what it prints; errors go to
//! the error output, with exit code 1.

use std::io::Write;
use std::process::ExitCode;
use std::time::{SystemTime, UNIX_EPOCH};

use katydid_csharp::{Engine, Host, Limits, Source};

struct Terminal;

impl Host for Terminal {
    fn write(&mut self, text: &str) {
        let _ = std::io::stdout().write_all(text.as_bytes());
    }

    fn now(&mut self) -> Option<i64> {
        const TICKS_TO_1970: i64 = 621_355_968_000_000_000;
        let since = SystemTime::now().duration_since(UNIX_EPOCH).ok()?;
        Some(TICKS_TO_1970 + i64::try_from(since.as_nanos() / 100).ok()?)
    }
}

fn main() -> ExitCode {
    let Some(path) = std::env::args().nth(1) else {
        eprintln!("run PROGRAM.cs");
        return ExitCode::from(2);
    };
    let text = match std::fs::read_to_string(&path) {
        Ok(text) => text,
        Err(error) => {
            eprintln!("{path}: {error}");
            return ExitCode::from(2);
        }
    };
    let mut engine = match Engine::new(&Source::File(&text), Box::new(Terminal), Limits::default()) {
        Ok(engine) => engine,
        Err(errors) => {
            for error in errors {
                eprintln!("{error}");
            }
            return ExitCode::FAILURE;
        }
    };
    match engine.run_main() {
        Ok(_) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{failure}");
            ExitCode::FAILURE
        }
    }
}
