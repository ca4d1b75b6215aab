//! The words of the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

/// Grasshopper definitions without Rhino: run them, check them, convert them.
#[derive(Debug, Parser)]
#[command(name = "katydid", version, about, long_about = None, arg_required_else_help = true)]
#[command(after_help = "\
Examples:
  katydid run facade.gh -o facade.3dm           run it, and save the geometry for Rhino
  katydid run facade.gh --set height=3.2 --json the results with another slider value
  katydid check projects/                       what is missing to run each file
  katydid convert facade.gh facade.ghx          the readable form of the same file
  katydid components 'Divide Curve'             help for a component")]
pub(crate) struct Katydid {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run a definition, and write its geometry or its results
    Run(RunArgs),
    /// Tell which objects a file needs, and whether each is supported
    Check(CheckArgs),
    /// Convert a definition between .gh and .ghx
    Convert(ConvertArgs),
    /// List the components, or show the help of one
    Components(ComponentsArgs),
}

#[derive(Debug, Args)]
#[command(after_help = "\
The exit code is 0 when every object that could run did so without an error, 1 when a component reported an
error, 2 when the file could not be opened or the call was wrong. Messages go to standard error.")]
pub(crate) struct RunArgs {
    /// The definition: .gh or .ghx
    pub(crate) file: PathBuf,

    /// Set a slider, panel, toggle, value list, Get input or RH_IN group by nickname or id; a JSON array sets a list
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment)]
    pub(crate) set: Vec<(String, String)>,

    /// Save the geometry: .3dm, .obj or .stl. What is previewed, or what Context Bake or an RH_OUT group marks
    #[arg(short, long = "output", value_name = "OUT")]
    pub(crate) output: Vec<PathBuf>,

    /// Print the results as one JSON object: items as a panel shows them, or with =values in full precision
    #[arg(long, value_name = "FORM", num_args = 0..=1, default_missing_value = "texts", require_equals = true)]
    pub(crate) json: Option<JsonForm>,

    /// Print how long each object took, the slowest first
    #[arg(long)]
    pub(crate) timings: bool,

    /// The number of threads; as many as the machine has processors when not given
    #[arg(long, value_name = "N")]
    pub(crate) threads: Option<usize>,

    /// The most items one object may put out
    #[arg(long, value_name = "N")]
    pub(crate) limit_items: Option<u64>,

    /// The most bytes one object's texts may take
    #[arg(long, value_name = "N")]
    pub(crate) limit_bytes: Option<u64>,

    /// The most seconds the solve may take
    #[arg(long, value_name = "SECONDS")]
    pub(crate) limit_seconds: Option<f64>,

    /// The length unit of the document
    #[arg(long, value_name = "UNIT", default_value = "millimeters")]
    pub(crate) units: UnitName,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum JsonForm {
    Texts,
    Values,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum UnitName {
    None,
    Microns,
    Millimeters,
    Centimeters,
    Meters,
    Kilometers,
    Inches,
    Feet,
    Yards,
    Miles,
}

impl From<UnitName> for katydid_geometry::Units {
    fn from(name: UnitName) -> Self {
        match name {
            UnitName::None => Self::None,
            UnitName::Microns => Self::Microns,
            UnitName::Millimeters => Self::Millimeters,
            UnitName::Centimeters => Self::Centimeters,
            UnitName::Meters => Self::Meters,
            UnitName::Kilometers => Self::Kilometers,
            UnitName::Inches => Self::Inches,
            UnitName::Feet => Self::Feet,
            UnitName::Yards => Self::Yards,
            UnitName::Miles => Self::Miles,
        }
    }
}

#[derive(Debug, Args)]
#[command(after_help = "\
The exit code is 0 when all files can run whole, 1 when some object is not supported, 2 when a file cannot be
opened. Folders are searched for .gh and .ghx files.")]
pub(crate) struct CheckArgs {
    /// Files and folders
    #[arg(required = true, value_name = "PATH")]
    pub(crate) paths: Vec<PathBuf>,

    /// Print an array with one object a file
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct ConvertArgs {
    /// The definition to read: .gh, .ghx or .ghuser
    pub(crate) from: PathBuf,
    /// The file to write: .gh or .ghx
    pub(crate) to: PathBuf,
}

#[derive(Debug, Args)]
pub(crate) struct ComponentsArgs {
    /// A name or part of one, or an id; everything when not given
    pub(crate) name: Option<String>,

    /// Print JSON: every id that is answered to, old ones too
    #[arg(long)]
    pub(crate) json: bool,
}

fn assignment(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() => Ok((name.trim().to_owned(), value.to_owned())),
        _ => Err("expected NAME=VALUE".to_owned()),
    }
}
