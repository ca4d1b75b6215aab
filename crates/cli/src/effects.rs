//! `katydid effects`.

use clap::Args;
use katydid_component::Cancel;
use katydid_study::thresholds::POINT_TIME;
use katydid_study::{
    Derivative, Here, Output, Prepared, RangeSettings, Ranged, Slope, StudyError, Variable, effects_here,
    effects_over_range, inputs_of,
};
use serde_json::{Value, json};

use crate::args::DefinitionArgs;
use crate::output::{note, print};
use crate::{open, ticks};

#[derive(Debug, Args)]
#[command(after_help = "\
Two answers: what a small move of each slider does here, with an error bound and from where to where it holds; and what
share each input has in the output over all their ranges (Sobol), with the mean size of its effect (Morris). The exit code
is 0, or 2 when the file could not be opened, the output is not one number, or the call was wrong.")]
pub(crate) struct EffectsArgs {
    #[command(flatten)]
    definition: DefinitionArgs,

    /// The number that is looked at: an object by nickname or id, or one of its outputs, Area.Centroid
    #[arg(long, value_name = "OUTPUT")]
    of: String,

    /// The inputs, with commas between; all that the output hangs on when not given
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    with: Vec<String>,

    /// Only what small moves do
    #[arg(long)]
    here: bool,

    /// Solves over the ranges are so many times the number of inputs and two more; 0 for none
    #[arg(long, value_name = "N", default_value_t = 256)]
    pairs: usize,

    /// What random numbers begin with
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// How many points are solved side by side; as many as the machine has processors when not given
    #[arg(long, value_name = "N")]
    workers: Option<usize>,

    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

pub(crate) fn effects(args: &EffectsArgs) -> Result<u8, String> {
    if args.definition.ticks.is_some() {
        return Err("--ticks: runs in time are not supported here".to_owned());
    }
    let text = |error: StudyError| error.to_string();
    let cancel = Cancel::default();
    ticks::on_interrupt(cancel.clone());
    let mut session = open::session(&args.definition)?;
    let options = session.options_mut();
    options.progress = None;
    options.skip_unread = true;
    options.cancel = cancel.clone();
    options.limits.time = options.limits.time.or(Some(POINT_TIME));
    let options = options.clone();
    let document = session.document().clone();
    let output = Output::find(&document, &args.of).map_err(text)?;
    let variables =
        chosen(&args.with, || inputs_of(&document, &output), |name| Variable::find(&document, name))?;
    if variables.is_empty() {
        return Err(format!("'{}' hangs on no slider, gene pool, toggle or list", args.of));
    }
    let prepared = Prepared::new(document, options, variables, vec![output]);
    let (value, here) = effects_here(&prepared, &cancel).map_err(text)?;
    let settings = RangeSettings {
        pairs: args.pairs,
        seed: args.seed,
        workers: args.workers.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from)),
        cancel,
    };
    let wide = !args.here && args.pairs > 0;
    let ranged = wide.then(|| effects_over_range(&prepared, &settings)).transpose().map_err(text)?;
    if args.json {
        let all = json!({
            "output": args.of,
            "value": value,
            "here": here.iter().map(here_json).collect::<Vec<_>>(),
            "range": ranged.as_ref().map(|(inputs, solved, failed)| json!({
                "points": solved, "without_number": failed, "seed": args.seed,
                "inputs": inputs.iter().map(ranged_json).collect::<Vec<_>>(),
            })),
        });
        print(&format!("{all}\n"));
        return Ok(0);
    }
    print(&format!("{} = {value}\n\nHere\n", args.of));
    let rows = here.iter().map(|here| {
        let [from, to] = match &here.holds {
            Some([a, b]) => [end(a), end(b)],
            None => [String::new(), String::new()],
        };
        vec![here.name.clone(), here.at.to_string(), slope(&here.slope), from, to]
    });
    table(&["input", "at", "change of the output for 1", "from", "to"], rows.collect());
    if let Some((inputs, solved, failed)) = ranged {
        print(&format!("\nOver the whole ranges ({solved} points)\n"));
        if failed > 0 {
            note(&format!("{failed} points gave no number and do not count"));
        }
        let rows = inputs.iter().map(|input| {
            let [alone, total] = input.share.map_or(["-".to_owned(), "-".to_owned()], |share| {
                [
                    format!("{:.3} \u{b1} {:.3}", share.alone, share.alone_confidence),
                    format!("{:.3} \u{b1} {:.3}", share.total, share.total_confidence),
                ]
            });
            let size = input
                .screening
                .map_or("-".to_owned(), |s| format!("{:.4} \u{b1} {:.4}", s.size, s.confidence));
            vec![input.name.clone(), alone, total, size]
        });
        table(&["input", "share alone", "share with others", "mean effect"], rows.collect());
    }
    Ok(0)
}

/// The inputs that were named, or else all.
pub(crate) fn chosen(
    names: &[String],
    all: impl FnOnce() -> Result<Vec<Variable>, StudyError>,
    find: impl Fn(&str) -> Result<Variable, StudyError>,
) -> Result<Vec<Variable>, String> {
    if names.is_empty() {
        return all().map_err(|error| error.to_string());
    }
    names.iter().map(|name| find(name.trim()).map_err(|error| error.to_string())).collect()
}

fn end(end: &katydid_study::End) -> String {
    if end.is_limit { end.at.to_string() } else { format!("{} ({})", end.at, end.why) }
}

fn bounded(derivative: &Derivative) -> String {
    format!("{:.9} \u{b1} {:.1e}", derivative.value, derivative.error)
}

fn slope(slope: &Slope) -> String {
    let side = |side: &Option<Derivative>| side.as_ref().map_or("unknown".to_owned(), bounded);
    let step = |change: &Option<f64>| change.map_or("none".to_owned(), |change| format!("{change:+}"));
    match slope {
        Slope::Even(derivative) => bounded(derivative),
        Slope::Corner([left, right]) => format!("a corner: {} before, {} behind", side(left), side(right)),
        Slope::Steps { step: by, change: [down, up] } => {
            format!("{} for {by} less, {} for {by} more", step(down), step(up))
        }
        Slope::Jump => "it jumps here".to_owned(),
    }
}

fn here_json(here: &Here) -> Value {
    let derivative = |d: &Derivative| json!({"value": d.value, "error": d.error});
    let slope = match &here.slope {
        Slope::Even(d) => json!({"kind": "even", "derivative": derivative(d)}),
        Slope::Corner(sides) => {
            let [left, right] = sides.each_ref().map(|side| side.as_ref().map(derivative));
            json!({"kind": "corner", "left": left, "right": right})
        }
        Slope::Steps { step, change: [down, up] } => {
            json!({"kind": "steps", "step": step, "down": down, "up": up})
        }
        Slope::Jump => json!({"kind": "jump"}),
    };
    let holds = here.holds.as_ref().map(|ends| {
        ends.each_ref().map(|end| json!({"at": end.at, "why": end.why, "is_limit": end.is_limit}))
    });
    json!({"input": here.name, "at": here.at, "slope": slope, "holds": holds})
}

fn ranged_json(input: &Ranged) -> Value {
    json!({
        "input": input.name,
        "share": input.share.map(|s| json!({
            "alone": s.alone, "alone_confidence": s.alone_confidence,
            "total": s.total, "total_confidence": s.total_confidence,
        })),
        "screening": input.screening.map(|s| json!({
            "size": s.size, "confidence": s.confidence, "mean": s.mean, "deviation": s.deviation,
        })),
    })
}

/// Prints rows in columns.
pub(crate) fn table(header: &[&str], rows: Vec<Vec<String>>) {
    let mut all = vec![header.iter().map(|cell| (*cell).to_owned()).collect::<Vec<_>>()];
    all.extend(rows);
    let width = |column: usize| all.iter().filter_map(|row| row.get(column)).map(|c| c.chars().count()).max();
    let widths: Vec<usize> = (0..header.len()).map(|column| width(column).unwrap_or(0)).collect();
    for row in &all {
        let cells: Vec<String> =
            row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
        print(&format!("  {}\n", cells.join("  ").trim_end()));
    }
}
