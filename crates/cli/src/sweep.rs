//! `katydid sweep`.

use std::io::{IsTerminal, Write};
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Args;
use katydid_geometry::Units;
use katydid_study::{DefinitionFile, Plan, Progress, sweep as solve_all};

use crate::args::DefinitionArgs;
use crate::output::{GREEN, YELLOW, note};
use crate::sweep_call::SweepCall;
use crate::{Program, progress, source, sweep_ray, ticks};

/// The line changes at most this often.
const PAUSE: Duration = Duration::from_millis(200);

#[derive(Debug, Args)]
#[command(after_help = "\
A plan is JSON:
  {\"inputs\": {\"height\": {\"from\": 2, \"to\": 6, \"steps\": 9}, \"corners\": [3, 4, 6]}, \"outputs\": [\"Area\"]}
docs/studies.md says what else it may have. The same command goes on where it was stopped, and solves no point twice.

The exit code is 0 when every point has results, 1 when some have none (failed.csv says why), 2 when a file could not be
opened or written or the call was wrong.")]
pub(crate) struct SweepArgs {
    #[command(flatten)]
    pub(crate) definition: DefinitionArgs,

    /// Which points: a .json file
    #[arg(long, value_name = "PLAN")]
    pub(crate) plan: PathBuf,

    /// The folder of the study
    #[arg(short, long = "output", value_name = "FOLDER")]
    pub(crate) output: PathBuf,

    /// How many points are solved side by side; as many as the machine has processors when not given
    #[arg(long, value_name = "N")]
    pub(crate) workers: Option<usize>,

    /// The most bytes that a point may take; when not given, 4 GiB and 1 GiB for each object
    #[arg(long, value_name = "N")]
    pub(crate) limit_bytes: Option<u64>,

    /// Solve points again that failed before
    #[arg(long)]
    pub(crate) retry: bool,

    /// Solve the points on a Ray cluster, through the Python package: its address, as 10.0.0.5:6379 or ray://10.0.0.5:10001;
    /// auto for the cluster that this machine belongs to, local for one that is started for this
    #[arg(long, value_name = "ADDRESS")]
    pub(crate) ray: Option<String>,
}

pub(crate) fn sweep(args: &SweepArgs, program: &Program) -> Result<u8, String> {
    if let Some(address) = &args.ray {
        return sweep_ray::sweep(args, address, program);
    }
    let SweepCall { document, options, plan, settings, .. } = SweepCall::of(args)?;
    let plan = Plan::bind(&plan, &document).map_err(|error| error.to_string())?;
    ticks::on_interrupt(settings.cancel.clone());
    let mut line = Line::new();
    let summary = solve_all(document, options, &plan, &args.output, &settings, |now| line.show(now));
    progress::clear();
    let summary = summary.map_err(|error| error.to_string())?;
    let Progress { points, had, solved, elapsed, .. } = summary.progress;
    let rate = rate(solved, elapsed);
    note(&format!(
        "{GREEN}{points}{GREEN:#} points: {solved} solved now, {had} known before, {:.1} s{rate}",
        elapsed.as_secs_f64()
    ));
    if summary.failed_rows > 0 {
        let path = args.output.join("failed.csv");
        note(&format!(
            "{YELLOW}{} without results{YELLOW:#}: {} says why",
            summary.failed_rows,
            path.display()
        ));
    }
    Ok(u8::from(summary.failed_rows > 0))
}

/// What the results hang on besides the plan: the files, and how they are read.
pub(crate) fn identity(args: &DefinitionArgs) -> Result<Vec<u8>, String> {
    let mut bytes = source::bytes(&args.file)?;
    if let Some(model) = &args.model {
        bytes.extend(source::bytes(model)?);
    }
    let DefinitionArgs { set, units, lenient, .. } = args;
    bytes.extend(format!("{set:?} {units:?} {lenient}").into_bytes());
    Ok(bytes)
}

/// The definition, for whoever opens a point of the study in the studio later; `None` where it came over standard input.
pub(crate) fn definition_file(args: &DefinitionArgs) -> Option<DefinitionFile> {
    let whole = |path: &PathBuf| path.canonicalize().ok().filter(|path| path.is_file());
    let DefinitionArgs { file, model, units, set, .. } = args;
    Some(DefinitionFile {
        file: whole(file)?,
        model: model.as_ref().and_then(whole),
        units: units.map(|units| Units::from(units).name().to_owned()),
        set: set.clone(),
    })
}

fn rate(solved: u64, elapsed: Duration) -> String {
    #[allow(clippy::cast_precision_loss, reason = "points are fewer than 2^53")]
    let rate = solved as f64 / elapsed.as_secs_f64();
    if solved > 0 && rate.is_finite() { format!(", {rate:.0} points a second") } else { String::new() }
}

/// A line on a terminal with the rate and the time left.
pub(crate) struct Line {
    is_terminal: bool,
    shown: Instant,
}

impl Line {
    pub(crate) fn new() -> Self {
        Self { is_terminal: std::io::stderr().is_terminal(), shown: Instant::now() }
    }

    #[allow(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a bar of few characters"
    )]
    pub(crate) fn show(&mut self, now: &Progress) {
        /// Characters of the bar.
        const WIDTH: usize = 24;
        if !self.is_terminal || self.shown.elapsed() < PAUSE {
            return;
        }
        self.shown = Instant::now();
        let done = now.had + now.solved;
        let left =
            now.points.saturating_sub(done) as f64 * now.elapsed.as_secs_f64() / now.solved.max(1) as f64;
        let filled = (WIDTH as f64 * done as f64 / now.points.max(1) as f64) as usize;
        let bar: String = (0..WIDTH).map(|k| if k < filled { '#' } else { '.' }).collect();
        let failed = if now.failed > 0 { format!(", {} failed", now.failed) } else { String::new() };
        let _ = write!(
            std::io::stderr(),
            "\r\x1b[K[{bar}] {done} of {}{}{failed}, {left:.0} s left",
            now.points,
            rate(now.solved, now.elapsed)
        );
    }
}
