//! The words of the command line.

use std::net::IpAddr;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::effects::EffectsArgs;
use crate::manual::{CompletionsArgs, ManArgs};
use crate::mcp::McpArgs;
use crate::optimise::OptimiseArgs;
use crate::scripts::{ScriptArgs, StudioScriptArgs};
use crate::serve_args::ServeArgs;
use crate::solve_for::SolveForArgs;
use crate::study::StudyArgs;
use crate::sweep::SweepArgs;
use crate::web_args::WebArgs;

/// Grasshopper definitions without Rhino: run them, check them, convert them.
#[derive(Debug, Parser)]
#[command(name = "katydid", version, about, long_about = None, arg_required_else_help = true)]
#[command(after_help = "\
Examples:
  katydid run facade.gh -o facade.3dm           run it, and save the geometry for Rhino
  katydid run facade.gh --set height=3.2 --json the results with another slider value
  katydid run growth.gh --ticks 100 --json      what it has come to after 100 ticks of its timers
  katydid check projects/                       what is missing to run each file
  katydid convert facade.gh facade.kd           the same as text, to be read, written and compared
  katydid convert model.3dm model.glb           a model for other programs
  katydid info model.3dm                        what is in a model, and whether it is valid
  katydid diff old.gh new.gh                    what changed, in words
  katydid components 'Divide Curve'             help for a component
  katydid view facade.gh -o facade.png          a picture of what it makes
  katydid sweep facade.gh --plan plan.json -o study   a table of variants
  katydid effects facade.gh --of Area           which slider moves a number, and how far that holds
  katydid optimise facade.gh --minimise Area -o best   inputs that make a number small or large
  katydid solve-for facade.gh --want Area=120   where the sliders must stand for a wanted number
  katydid study study                           look at a sweep: plots, pictures, table, front
  katydid studio facade.gh                      edit it in the browser
  katydid serve                                 answer the clients of Rhino.Compute and Hops
  katydid mcp --folder projects                 tools for an assistant, which starts this by itself")]
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
    /// Convert a definition between .gh, .ghx and .kd, or a model between .3dm and other programs' files
    Convert(ConvertArgs),
    /// Tell what is in a .3dm model, and what is wrong with it
    Info(InfoArgs),
    /// Tell what changed between two definitions, in words
    Diff(DiffArgs),
    /// Set .kd files the usual way
    Fmt(FmtArgs),
    /// List the components, or show the help of one
    Components(ComponentsArgs),
    /// Make a picture of what a definition shows, or of the definition itself
    View(ViewArgs),
    /// Solve a definition at many points, into a table: grids, samples, rows of a file
    Sweep(Box<SweepArgs>),
    /// Tell which inputs move a number: here, with derivatives, and over their whole ranges, with shares
    Effects(EffectsArgs),
    /// Find the inputs that make outputs small or large (CMA-ES, NSGA-II), or what a Galapagos object asks for
    Optimise(Box<OptimiseArgs>),
    /// Find where sliders must stand for outputs to give wanted numbers or points
    SolveFor(SolveForArgs),
    /// Look at a sweep or an optimisation in the browser, also while it runs, or plot it as SVG
    Study(StudyArgs),
    /// Build the pages of a live book from a folder of Markdown and definitions
    Book(BookArgs),
    /// Open the studio in the browser: the definition on a canvas, its geometry beside it
    Studio(StudioArgs),
    /// Answer the clients of Rhino.Compute and Hops: definitions solved over HTTP
    Serve(ServeArgs),
    /// Serve an assistant over the Model Context Protocol: definitions as tools, on standard input and output
    Mcp(McpArgs),
    /// Let the scripts of files run from now on, each as long as it does not change
    Trust(TrustArgs),
    /// The packages that the Python scripts of definitions use
    Python(PythonArgs),
    /// Print what a shell needs to complete the words of this program
    Completions(CompletionsArgs),
    /// Write the manual pages of all commands into a folder
    Man(ManArgs),
    /// Answer the calls of a script's process: members of RhinoCommon, by name, in the form of katydid-members' codec
    #[command(hide = true)]
    Members(MembersArgs),
}

/// A book and where its pages go.
#[derive(Debug, Args)]
pub(crate) struct BookArgs {
    /// The folder of the book: contents.md, and a folder a page with page.md and its definitions
    #[arg(value_name = "FOLDER")]
    pub(crate) folder: PathBuf,

    /// The folder for the pages; without it the book is only checked
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
}

/// The files whose scripts may run.
#[derive(Debug, Args)]
pub(crate) struct TrustArgs {
    /// The files, after you have looked at their scripts
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
}

/// The packages of Python scripts.
#[derive(Debug, Args)]
pub(crate) struct PythonArgs {
    #[command(subcommand)]
    pub(crate) command: PythonCommand,
}

/// What is done with the packages.
#[derive(Debug, Subcommand)]
pub(crate) enum PythonCommand {
    /// Install packages beside a definition: an environment (.venv) and a lock file with versions and hashes
    #[command(after_help = "\
Examples:
  katydid python add numpy --file facade.gh
  katydid python add \"scipy==1.11.4\" ./wheels/own-1.0-py3-none-any.whl
  katydid python add --file facade.gh        what the `# r:` lines of its scripts ask for")]
    Add(PythonAddArgs),
    /// Make the environment again as the lock file says
    Sync(PythonSyncArgs),
}

/// Which packages, and where.
#[derive(Debug, Args)]
pub(crate) struct PythonAddArgs {
    /// The packages, as pip takes them; without any, those that the definition's `# r:` lines ask for
    #[arg(value_name = "PACKAGE", required_unless_present = "file")]
    pub(crate) packages: Vec<String>,

    #[command(flatten)]
    pub(crate) place: PythonSyncArgs,
}

/// Which environment.
#[derive(Debug, Args)]
pub(crate) struct PythonSyncArgs {
    /// The definition beside which the environment lies; else it is that of the working folder
    #[arg(long, value_name = "DEFINITION")]
    pub(crate) file: Option<PathBuf>,

    /// The Python that a new environment is made from
    #[arg(long, value_name = "PATH")]
    pub(crate) python: Option<PathBuf>,
}

/// How a script's process calls.
#[derive(Debug, Args)]
pub(crate) struct MembersArgs {
    /// Read calls from the standard input and write answers to the standard output
    #[arg(long, required = true)]
    pub(crate) stdio: bool,
}

/// A definition that is to be solved, and with what.
#[derive(Debug, Args)]
pub(crate) struct DefinitionArgs {
    /// The definition: .gh, .ghx or .kd
    pub(crate) file: PathBuf,

    /// The Rhino model (.3dm) with the objects that the definition refers to; its unit and tolerance count
    #[arg(long, value_name = "MODEL")]
    pub(crate) model: Option<PathBuf>,

    /// Read what can be read of a broken model, and tell what is skipped
    #[arg(long, requires = "model")]
    pub(crate) lenient: bool,

    /// Set a slider, panel, toggle, value list, calendar, clock, Get input or RH_IN group by nickname or id; a JSON array sets a list
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment)]
    pub(crate) set: Vec<(String, String)>,

    /// The most seconds the solve may take, with all its ticks
    #[arg(long, value_name = "SECONDS")]
    pub(crate) limit_seconds: Option<f64>,

    /// Run the definition in time: solve it once, then go through N moments at which a Trigger fires or a Data Dam
    /// lets data through; the last state counts
    #[arg(long, value_name = "N")]
    pub(crate) ticks: Option<u64>,

    /// The length unit of the document; when not given, that of a .kd file or of the model, else millimeters
    #[arg(long, value_name = "UNIT")]
    pub(crate) units: Option<UnitName>,

    #[command(flatten)]
    pub(crate) web: WebArgs,

    #[command(flatten)]
    pub(crate) scripts: ScriptArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "\
The exit code is 0 when every object that could run did so without an error, 1 when a component reported an
error, 2 when the file could not be opened or the call was wrong. Messages go to standard error.")]
pub(crate) struct RunArgs {
    #[command(flatten)]
    pub(crate) definition: DefinitionArgs,

    /// Save the geometry: .3dm, .step, .obj, .stl, .ply, .glb, .gltf or .svg. What is previewed, or what Context Bake or an RH_OUT group marks
    #[arg(short, long = "output", value_name = "OUT")]
    pub(crate) output: Vec<PathBuf>,

    /// In .3dm files, write geometry that repeats at other places as a block and references to it
    #[arg(long)]
    pub(crate) blocks: bool,

    /// Write what panels stream to files, into this folder: only the names of the files that a definition gives count
    #[arg(long, value_name = "FOLDER")]
    pub(crate) panels: Option<PathBuf>,

    /// Print the results as one JSON object: items as a panel shows them, or with =values in full precision
    #[arg(long, value_name = "FORM", num_args = 0..=1, default_missing_value = "texts", require_equals = true)]
    pub(crate) json: Option<JsonForm>,

    /// Print how long each object took, the slowest first
    #[arg(long)]
    pub(crate) timings: bool,

    /// Print the steps of the objects whose result the kernel can tell step by step (Evaluate Curve, closest points, planes from axes, products of matrices), or with =NAME of one object
    #[arg(long, value_name = "NAME", num_args = 0..=1, default_missing_value = "", require_equals = true)]
    pub(crate) explain: Option<String>,

    /// The number of threads; as many as the machine has processors when not given
    #[arg(long, value_name = "N")]
    pub(crate) threads: Option<usize>,

    /// The most items one object may put out
    #[arg(long, value_name = "N")]
    pub(crate) limit_items: Option<u64>,

    /// The most bytes that the solve may take; when not given, 4 GiB and 1 GiB for each object
    #[arg(long, value_name = "N")]
    pub(crate) limit_bytes: Option<u64>,
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
opened. Folders are searched for .gh, .ghx and .kd files.")]
pub(crate) struct CheckArgs {
    /// Files and folders
    #[arg(required = true, value_name = "PATH")]
    pub(crate) paths: Vec<PathBuf>,

    /// Print an array with one object a file
    #[arg(long)]
    pub(crate) json: bool,

    /// The Python whose packages scripts would find; no script is run. As for `run` when not given
    #[arg(long, value_name = "PATH")]
    pub(crate) python: Option<PathBuf>,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Models: .3dm (any version), .step, .obj, .stl, .ply, .glb and .gltf are read; .3dm, .step, .obj, .stl, .ply, .glb,
.gltf and .svg are written. What the new file cannot hold is told by class and count on standard error.

A .3dm file in which anything is broken is refused with the place and the reason, unless --lenient is given.

The exit code is 0 when the file was written, 1 when it was written but --lenient had to skip something, 2 when a file
could not be opened or written or the call was wrong.")]
pub(crate) struct ConvertArgs {
    /// The file to read: a definition (.gh, .ghx, .kd, .ghuser) or a model (.3dm, .step, .obj, .stl, .ply, .glb, .gltf)
    pub(crate) from: PathBuf,
    /// The file to write: .gh, .ghx or .kd for a definition, .3dm, .step, .obj, .stl, .ply, .glb, .gltf or .svg for a model
    pub(crate) to: PathBuf,

    /// The version of a .3dm file: 4 to 8, or 40 to 80; as it was when not given
    #[arg(long, value_name = "VERSION", value_parser = archive_version)]
    pub(crate) version: Option<i32>,

    /// How far facets and polylines may be from surfaces and curves, in the model's unit
    #[arg(long, value_name = "DISTANCE", value_parser = distance)]
    pub(crate) tolerance: Option<f64>,

    /// Write .stl and .ply as text
    #[arg(long)]
    pub(crate) ascii: bool,

    /// Where an .svg drawing is seen from; from above when not given
    #[arg(long, value_name = "VIEW")]
    pub(crate) view: Option<DrawingView>,

    /// Take hidden objects along
    #[arg(long)]
    pub(crate) hidden: bool,

    /// Read what can be read of a broken .3dm file, and tell what is skipped
    #[arg(long)]
    pub(crate) lenient: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum DrawingView {
    Top,
    Bottom,
    Front,
    Back,
    Right,
    Left,
    Isometric,
}

impl From<DrawingView> for katydid_exchange::View {
    fn from(view: DrawingView) -> Self {
        match view {
            DrawingView::Top => Self::Top,
            DrawingView::Bottom => Self::Bottom,
            DrawingView::Front => Self::Front,
            DrawingView::Back => Self::Back,
            DrawingView::Right => Self::Right,
            DrawingView::Left => Self::Left,
            DrawingView::Isometric => Self::Isometric,
        }
    }
}

#[derive(Debug, Args)]
#[command(after_help = "\
A file in which anything is broken is refused with the place and the reason, unless --lenient or --tree is given.

The exit code is 0 when all is well, 1 when an object is not valid or something was odd or skipped, 2 when the file cannot
be opened, is broken, or is no .3dm file.")]
pub(crate) struct InfoArgs {
    /// The model: .3dm
    pub(crate) file: PathBuf,

    /// Print one JSON object
    #[arg(long)]
    pub(crate) json: bool,

    /// Read what can be read of a broken file, and tell what is skipped
    #[arg(long)]
    pub(crate) lenient: bool,

    /// Show what the file is made of instead: every chunk with its offset, name, class, length and checksum
    #[arg(long, conflicts_with = "lenient")]
    pub(crate) tree: bool,

    /// How deep the tree is shown, 0 for the tables alone; 2 when not given
    #[arg(long, value_name = "N", requires = "tree")]
    pub(crate) depth: Option<usize>,
}

#[derive(Debug, Args)]
#[command(after_help = "\
The exit code is 0 when nothing differs, 1 when something does, 2 when a file cannot be opened. The files may be of
different formats. Where things stand on the canvas does not count, unless --layout is given.")]
pub(crate) struct DiffArgs {
    /// The definition as it was
    pub(crate) old: PathBuf,
    /// The definition as it is
    pub(crate) new: PathBuf,

    /// Tell also what moved on the canvas
    #[arg(long)]
    pub(crate) layout: bool,

    /// Print an array with one object a change
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "\
The exit code is 0 when all is well, 1 when --check finds a file that is not set the usual way, 2 when a file cannot
be opened or is no text of the form.")]
pub(crate) struct FmtArgs {
    /// .kd files; - reads standard input and writes standard output
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,

    /// Change nothing; name the files that would change
    #[arg(long)]
    pub(crate) check: bool,
}

#[derive(Debug, Args)]
pub(crate) struct ComponentsArgs {
    /// A name or part of one, or an id; everything when not given
    pub(crate) name: Option<String>,

    /// Print JSON: every id that is answered to, old ones too
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "\
The exit code is 0 when every object that could run did so without an error, 1 when a component reported an
error (the picture is made all the same), 2 when the file could not be opened or the call was wrong.")]
pub(crate) struct ViewArgs {
    #[command(flatten)]
    pub(crate) definition: DefinitionArgs,

    /// The picture: .svg or .png
    #[arg(short, long = "output", value_name = "OUT", required = true)]
    pub(crate) output: Vec<PathBuf>,

    /// Draw the definition itself, with its wires, panels and groups
    #[arg(long)]
    pub(crate) canvas: bool,

    /// Where to look from; from above when everything is flat, else in perspective, when not given
    #[arg(long, value_name = "VIEW", conflicts_with = "canvas")]
    pub(crate) view: Option<ViewName>,

    /// Width and height in pixels; 1200x800, or as large as the canvas is, when not given
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub(crate) size: Option<[u32; 2]>,

    /// Draw the axes
    #[arg(long, conflicts_with = "canvas")]
    pub(crate) axes: bool,

    /// Draw a grid
    #[arg(long, conflicts_with = "canvas")]
    pub(crate) grid: bool,

    /// Explain the colours of gradients
    #[arg(long, conflicts_with = "canvas")]
    pub(crate) legend: bool,

    /// What becomes of lines behind faces; when not given, they shine through clear faces and opaque ones hide them
    #[arg(long, value_name = "CHOICE", conflicts_with = "canvas")]
    pub(crate) hidden_lines: Option<HiddenLinesName>,

    /// The colour of the ground: white, black, none, #rrggbb, or three numbers to 255
    #[arg(long, value_name = "COLOUR", default_value = "white")]
    pub(crate) background: String,
}

#[derive(Debug, Args)]
#[command(after_help = "\
The studio runs until Ctrl+C. What was not saved is kept, and comes back when the file is opened again.

The exit code is 0 when it was ended, 2 when the port is taken or the file could not be opened.")]
pub(crate) struct StudioArgs {
    /// The definition to open: .gh, .ghx or .kd; the start page when not given
    pub(crate) file: Option<PathBuf>,

    /// The Rhino model (.3dm) with the objects that the definition refers to; its unit and tolerance count
    #[arg(long, value_name = "MODEL", requires = "file")]
    pub(crate) model: Option<PathBuf>,

    /// The port; 0 for any that is free
    #[arg(long, value_name = "N", default_value_t = 6510)]
    pub(crate) port: u16,

    /// The address to listen on; 0.0.0.0 for all. Others can join then, with the token
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1")]
    pub(crate) host: IpAddr,

    /// What whoever uses the studio must know; made by chance when none is given
    #[arg(long, value_name = "TOKEN", value_parser = token)]
    pub(crate) token: Option<String>,

    /// A folder whose files definitions may read that were sent or that others can join; those that you open by their
    /// path here, and nobody else can join, read what you may read
    #[arg(long = "files", value_name = "FOLDER")]
    pub(crate) files: Vec<PathBuf>,

    /// Only print the address
    #[arg(long)]
    pub(crate) no_open: bool,

    /// Show the inputs and the model alone
    #[arg(long, requires = "file")]
    pub(crate) player: bool,

    /// Let the program of an assistant on this machine (`katydid mcp --studio`) read and edit what is open here
    #[arg(long)]
    pub(crate) allow_assistant: bool,

    /// The folder of a book to show at /learn, in place of Katydid's own
    #[arg(long, value_name = "FOLDER")]
    pub(crate) book: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) scripts: StudioScriptArgs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum HiddenLinesName {
    /// Leave them out
    Hide,
    /// Dash them
    Dash,
    /// Draw them as if there were no faces
    Show,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ViewName {
    Perspective,
    Top,
    Front,
    Right,
    Iso,
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let side = |side: &str| side.trim().parse().ok().filter(|n| (1..=16_384).contains(n));
    let sizes = text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some([side(w)?, side(h)?]));
    sizes.ok_or_else(|| "expected WIDTHxHEIGHT, each from 1 to 16384".to_owned())
}

fn archive_version(text: &str) -> Result<i32, String> {
    match text {
        "4" | "40" => Ok(4),
        "5" | "50" => Ok(50),
        "6" | "60" => Ok(60),
        "7" | "70" => Ok(70),
        "8" | "80" => Ok(80),
        _ => Err("expected 4, 5, 6, 7 or 8, or ten times that".to_owned()),
    }
}

pub(crate) fn token(text: &str) -> Result<String, String> {
    let is_plain = text.bytes().all(|b| b.is_ascii_alphanumeric() || b"-_.~".contains(&b));
    if text.len() >= 8 && is_plain {
        Ok(text.to_owned())
    } else {
        Err("expected 8 or more letters, digits, or any of - _ . ~".to_owned())
    }
}

fn distance(text: &str) -> Result<f64, String> {
    let number: Option<f64> = text.parse().ok();
    number.filter(|x| *x > 0.0 && x.is_finite()).ok_or_else(|| "expected a number above 0".to_owned())
}

fn assignment(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() => Ok((name.trim().to_owned(), value.to_owned())),
        _ => Err("expected NAME=VALUE".to_owned()),
    }
}
