//! `katydid man` and `katydid completions`: what a system's packages hold beside the program, made from the words of the
//! command line themselves.

use std::path::{Path, PathBuf};

use clap::{Args, Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;

use crate::args::Katydid;
use crate::output::{failed, print, write_file};

/// Where manual pages go.
#[derive(Debug, Args)]
pub(crate) struct ManArgs {
    /// The folder for katydid.1 and a page for each command, such as katydid-run.1
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
}

/// Which shell completes words.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  katydid completions bash > ~/.local/share/bash-completion/completions/katydid
  katydid completions fish > ~/.config/fish/completions/katydid.fish")]
pub(crate) struct CompletionsArgs {
    /// The shell
    shell: Shell,
}

pub(crate) fn man(args: &ManArgs) -> Result<u8, String> {
    std::fs::create_dir_all(&args.output).map_err(|error| failed(&args.output, &error))?;
    // Building gives each command below another the whole name, by which pages refer to each other.
    let mut whole = Katydid::command();
    whole.build();
    pages(&whole, &args.output)?;
    Ok(0)
}

/// Writes the page of a command, and those of the commands below it.
fn pages(command: &Command, folder: &Path) -> Result<(), String> {
    let name = command.get_display_name().unwrap_or_else(|| command.get_name());
    let path = folder.join(format!("{name}.1"));
    let mut page = Vec::new();
    Man::new(command.clone()).render(&mut page).map_err(|error| failed(&path, &error))?;
    write_file(&path, &page)?;
    let mut shown =
        command.get_subcommands().filter(|below| !below.is_hide_set() && below.get_name() != "help");
    shown.try_for_each(|below| pages(below, folder))
}

pub(crate) fn completions(args: &CompletionsArgs) -> Result<u8, String> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Katydid::command(), "katydid", &mut script);
    print(&String::from_utf8_lossy(&script));
    Ok(0)
}
