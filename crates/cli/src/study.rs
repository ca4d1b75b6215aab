//! `katydid study`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use katydid_server::{Config, StudyConfig};
use katydid_study::{Goal, Plot, PlotOptions, StudyFolder, plot};

use crate::args::token;
use crate::output::{note, print, write_file};
use crate::scripts::StudioScriptArgs;
use crate::studio;

/// A plot as a file has at most so many points: more are a black area.
const MOST_DRAWN: usize = 20_000;

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  katydid study best                                      the page, also while the sweep or search runs
  katydid study best --svg parallel -o best.svg           a line a point
  katydid study best --svg scatter --x height --y Volume --colour floors -o volume.svg
  katydid study best --svg front --minimise Area --maximise Volume -o front.svg

The page is on this machine alone. docs/studies.md says what is on it.")]
pub(crate) struct StudyArgs {
    /// The folder of a sweep or an optimisation, or one with a data.csv for Design Explorer
    folder: PathBuf,

    /// The definition whose points are opened in the studio; that which the folder names when not given
    #[arg(long, value_name = "FILE")]
    definition: Option<PathBuf>,

    /// Write a plot in place of opening the page
    #[arg(long, value_name = "PLOT")]
    svg: Option<PlotName>,

    /// The file of the plot; standard output when not given
    #[arg(short, long = "output", value_name = "FILE", requires = "svg")]
    output: Option<PathBuf>,

    /// The column from left to right, and of a histogram
    #[arg(long, value_name = "COLUMN", requires = "svg")]
    x: Option<String>,

    /// The column from bottom to top
    #[arg(long, value_name = "COLUMN", requires = "svg")]
    y: Option<String>,

    /// The column that colours tell
    #[arg(long, visible_alias = "color", value_name = "COLUMN", requires = "svg")]
    colour: Option<String>,

    /// An output that is to be small, for a front; the study's goals when none is given
    #[arg(long, value_name = "COLUMN", requires = "svg")]
    minimise: Vec<String>,

    /// An output that is to be large, for a front
    #[arg(long, value_name = "COLUMN", requires = "svg")]
    maximise: Vec<String>,

    /// The port; 0 for any that is free
    #[arg(long, value_name = "N", default_value_t = 6510)]
    port: u16,

    /// What whoever uses the page must know; made by chance when none is given
    #[arg(long, value_name = "TOKEN", value_parser = token)]
    token: Option<String>,

    /// Only print the address
    #[arg(long)]
    no_open: bool,

    #[command(flatten)]
    scripts: StudioScriptArgs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum PlotName {
    Parallel,
    Scatter,
    Histogram,
    Front,
}

pub(crate) fn study(args: &StudyArgs) -> Result<u8, String> {
    if let Some(name) = args.svg {
        return svg(args, name);
    }
    let config = Config {
        port: args.port,
        token: args.token.clone(),
        study: Some(StudyConfig { folder: args.folder.clone(), definition: args.definition.clone() }),
        state: Config::usual_state(),
        scripts: Some(args.scripts.for_studio()),
        ..Config::default()
    };
    studio::serve(config, args.no_open)
}

fn svg(args: &StudyArgs, name: PlotName) -> Result<u8, String> {
    let told = |error: katydid_study::StudyError| error.to_string();
    let mut folder = StudyFolder::open(&args.folder, MOST_DRAWN).map_err(told)?;
    folder.refresh().map_err(told)?;
    let goals = |names: &[String], goal: Goal| -> Vec<(String, Goal)> {
        names.iter().map(|name| (name.clone(), goal)).collect()
    };
    let options = PlotOptions {
        x: args.x.clone(),
        y: args.y.clone(),
        colour: args.colour.clone(),
        goals: [goals(&args.minimise, Goal::Least), goals(&args.maximise, Goal::Most)].concat(),
    };
    let which = match name {
        PlotName::Parallel => Plot::Parallel,
        PlotName::Scatter => Plot::Scatter,
        PlotName::Histogram => Plot::Histogram,
        PlotName::Front => Plot::Front,
    };
    let text = plot(&folder, which, &options).map_err(told)?;
    let Some(path) = &args.output else {
        print(&text);
        return Ok(0);
    };
    write_file(path, text.as_bytes())?;
    note(&format!("{}: {} points", path.display(), folder.row_count()));
    Ok(0)
}
