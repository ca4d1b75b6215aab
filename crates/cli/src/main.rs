//! The program `katydid`.

use std::process::ExitCode;

/// Counts the memory that solves take, so that their limits hold.
#[global_allocator]
static ALLOCATOR: katydid_memory::Counting = katydid_memory::Counting;

fn main() -> ExitCode {
    let words: Vec<_> = std::env::args_os().collect();
    let program = katydid_cli::Program::this(words.iter().skip(1).cloned().collect());
    ExitCode::from(katydid_cli::run_command(words, &program))
}
