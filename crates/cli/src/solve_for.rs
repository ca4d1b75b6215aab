//! `katydid solve-for`.

use std::path::PathBuf;

use clap::Args;
use katydid_component::Cancel;
use katydid_study::thresholds::POINT_TIME;
use katydid_study::{Cell, Effort, Output, Prepared, Variable, inputs_of, solve_for as find};

use crate::args::DefinitionArgs;
use crate::effects::{chosen, table};
use crate::output::print;
use crate::{convert, open, ticks};

#[derive(Debug, Args)]
#[command(after_help = "\
The search begins where the sliders stand, and finds what is best near there. Sliders of whole numbers are not moved.

The exit code is 0 when the wanted numbers are reached as nearly as the digits of the sliders show, 1 when the nearest is further
away, 2 when the file could not be opened or the call was wrong.")]
pub(crate) struct SolveForArgs {
    #[command(flatten)]
    definition: DefinitionArgs,

    /// An output and the number that it is to give; a point is three numbers with commas between
    #[arg(long, value_name = "OUTPUT=NUMBER", required = true, value_parser = wanted)]
    want: Vec<(String, Vec<f64>)>,

    /// The sliders that may move, with commas between; all without whole numbers that the outputs hang on when not given
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    with: Vec<String>,

    /// How far the outputs may be from what is wanted, together
    #[arg(long, value_name = "DISTANCE", default_value_t = 1e-3)]
    within: f64,

    /// A copy of the definition with the sliders as found: .gh, .ghx or .kd
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
}

pub(crate) fn solve_for(args: &SolveForArgs) -> Result<u8, String> {
    if args.definition.ticks.is_some() {
        return Err("--ticks: runs in time are not supported here".to_owned());
    }
    let cancel = Cancel::default();
    ticks::on_interrupt(cancel.clone());
    let mut session = open::session(&args.definition)?;
    let options = session.options_mut();
    options.progress = None;
    options.skip_unread = true;
    options.cancel = cancel.clone();
    options.limits.time = options.limits.time.or(Some(POINT_TIME));
    let options = options.clone();
    let mut document = session.document().clone();
    let found = args.want.iter().map(|(name, _)| Output::find(&document, name));
    let outputs: Vec<Output> = found.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
    let all = || {
        let mut all: Vec<Variable> = Vec::new();
        for output in &outputs {
            let even = |variable: &Variable| variable.limits().is_some() && variable.step().is_none();
            for variable in inputs_of(&document, output)?.into_iter().filter(even) {
                if all.iter().all(|other| other.name != variable.name) {
                    all.push(variable);
                }
            }
        }
        Ok(all)
    };
    let variables = chosen(&args.with, all, |name| Variable::find(&document, name))?;
    let wanted: Vec<f64> = args.want.iter().flat_map(|(_, numbers)| numbers.iter().copied()).collect();
    let prepared = Prepared::new(document.clone(), options, variables.clone(), outputs);
    let solution = find(&prepared, &wanted, Effort::default(), &cancel).map_err(|error| error.to_string())?;
    let rows = variables.iter().zip(&solution.inputs);
    table(&["input", "value"], rows.map(|(v, x)| vec![v.name.clone(), x.to_string()]).collect());
    print("\n");
    let mut numbers = solution.numbers.iter();
    let rows = args.want.iter().map(|(name, wanted)| {
        let given: Vec<String> = numbers.by_ref().take(wanted.len()).map(ToString::to_string).collect();
        let wanted: Vec<String> = wanted.iter().map(ToString::to_string).collect();
        vec![name.clone(), wanted.join(", "), given.join(", ")]
    });
    table(&["output", "wanted", "given"], rows.collect());
    if let Some(path) = &args.write {
        for (variable, x) in variables.iter().zip(&solution.inputs) {
            variable.write(&mut document, &Cell::Number(*x)).map_err(|error| error.to_string())?;
        }
        convert::write_document(&document, path)?;
    }
    Ok(u8::from(solution.off > args.within))
}

fn wanted(text: &str) -> Result<(String, Vec<f64>), String> {
    let wrong = || "expected OUTPUT=NUMBER, or OUTPUT=X,Y,Z for a point".to_owned();
    let (name, numbers) = text.rsplit_once('=').ok_or_else(wrong)?;
    let numbers: Option<Vec<f64>> =
        numbers.split(',').map(|x| x.trim().parse().ok().filter(|x: &f64| x.is_finite())).collect();
    Ok((name.trim().to_owned(), numbers.ok_or_else(wrong)?))
}
