//! The `katydid` command: opens files, hands them to the session, and prints what comes back.

mod args;
mod check;
mod components;
mod convert;
mod convert_model;
mod diff;
mod fmt;
mod info;
mod model_file;
mod open;
mod output;
mod progress;
mod run;
mod scene_file;
mod serve;
mod serve_args;
mod serving;
mod source;
mod studio;
mod ticks;
mod view;
mod web_args;

use std::process::ExitCode;

use clap::Parser;

use crate::args::{Command, Katydid};

/// Counts the memory that solves take, so that their limits hold.
#[global_allocator]
static ALLOCATOR: katydid_memory::Counting = katydid_memory::Counting;

/// The call was wrong, or a file could not be opened.
const EXIT_USAGE: u8 = 2;

fn main() -> ExitCode {
    let Katydid { command } = Katydid::parse();
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
        Command::Studio(args) => studio::studio(args),
        Command::Serve(args) => serve::serve(args),
    };
    match result {
        Ok(code) => ExitCode::from(code),
        Err(error) => {
            output::complain(&error);
            ExitCode::from(EXIT_USAGE)
        }
    }
}
