//! The `katydid` command: opens files, hands them to the session, and prints what comes back.
//!
//! It is a library so that the Python package carries the same command as the program `katydid`.

mod args;
mod book;
mod check;
mod components;
mod convert;
mod convert_model;
mod diff;
mod effects;
mod explain;
mod fmt;
mod info;
mod manual;
mod mcp;
mod members;
mod model_file;
mod open;
mod optimise;
mod output;
mod program;
mod progress;
mod python;
mod run;
mod scene_file;
mod scripts;
mod serve;
mod serve_args;
mod serving;
mod solve_for;
mod source;
mod studio;
mod study;
mod sweep;
mod sweep_call;
mod sweep_ray;
mod ticks;
mod view;
mod web_args;

use std::ffi::OsString;

use clap::Parser;

pub use program::Program;
pub use sweep_call::{CallFiles, SweepCall};

use crate::args::{Command, Katydid};

/// The call was wrong, or something could not be opened or written.
const EXIT_USAGE: u8 = 2;

/// Runs the command that the words ask for, the name of the program first; gives the exit code.
///
/// The program must have [`katydid_memory::Counting`] for its allocator, or the limits of memory do not hold.
pub fn run_command(words: Vec<OsString>, program: &Program) -> u8 {
    let Katydid { command } = match Katydid::try_parse_from(&words) {
        Ok(words) => words,
        Err(error) => return explained(&error),
    };
    katydid_components::link();
    let result = match &command {
        Command::Run(args) => run::run(args),
        Command::Check(args) => check::check(args),
        Command::Convert(args) => convert::convert(args),
        Command::Info(args) => info::info(args),
        Command::Diff(args) => diff::diff(args),
        Command::Fmt(args) => fmt::fmt(args),
        Command::Components(args) => components::components(args),
        Command::View(args) => view::view(args),
        Command::Book(args) => book::book(args),
        Command::Sweep(args) => sweep::sweep(args, program),
        Command::Effects(args) => effects::effects(args),
        Command::Optimise(args) => optimise::optimise(args),
        Command::SolveFor(args) => solve_for::solve_for(args),
        Command::Study(args) => study::study(args),
        Command::Studio(args) => studio::studio(args),
        Command::Serve(args) => serve::serve(args, program),
        Command::Mcp(args) => mcp::mcp(args),
        Command::Trust(args) => scripts::trust(args),
        Command::Python(args) => python::python(args),
        Command::Completions(args) => manual::completions(args),
        Command::Man(args) => manual::man(args),
        Command::Members(args) => members::members(args),
    };
    // What was to be printed and was not is an error, whatever else went well.
    match result.and_then(|code| output::printed().map(|()| code)) {
        Ok(code) => code,
        Err(error) => {
            output::complain(&error);
            EXIT_USAGE
        }
    }
}

/// Prints help, the version, or what was wrong with the call.
fn explained(error: &clap::Error) -> u8 {
    let unwritten = error.print().is_err_and(|error| error.kind() != std::io::ErrorKind::BrokenPipe);
    match output::printed() {
        Ok(()) if !unwritten => u8::try_from(error.exit_code()).unwrap_or(EXIT_USAGE),
        Ok(()) => {
            output::complain("the help could not be written");
            EXIT_USAGE
        }
        Err(why) => {
            output::complain(&why);
            EXIT_USAGE
        }
    }
}
