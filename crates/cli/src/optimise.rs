//! `katydid optimise`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use katydid_component::Cancel;
use katydid_definition::document::Document;
use katydid_study::thresholds::POINT_TIME;
use katydid_study::{
    Best, Bound, Constraint, Goal, Method, Objective, OptimiseSettings, Output, Settings, StudyError,
    Variable, galapagos, inputs_of, optimise as search,
};

use crate::args::DefinitionArgs;
use crate::effects::table;
use crate::output::{GREEN, YELLOW, note, print};
use crate::sweep::{Line, definition_file, identity};
use crate::{convert, open, progress, ticks};

#[derive(Debug, Args)]
#[command(after_help = "\
Without --minimise and --maximise, the definition's Galapagos object says what is moved and what is to be small or large.
All points that were solved are in the folder's tables, as those of a sweep; the same command goes on where it stopped.

The exit code is 0 when a point was found at which all constraints hold, 1 when none was, 2 when a file could not be opened
or written or the call was wrong.")]
pub(crate) struct OptimiseArgs {
    #[command(flatten)]
    definition: DefinitionArgs,

    /// An output that is to be small: an object by nickname or id, or one of its outputs
    #[arg(long, value_name = "OUTPUT")]
    minimise: Vec<String>,

    /// An output that is to be large
    #[arg(long, value_name = "OUTPUT")]
    maximise: Vec<String>,

    /// An output that must stay at or below a number
    #[arg(long, value_name = "OUTPUT=NUMBER", value_parser = bound)]
    at_most: Vec<(String, f64)>,

    /// An output that must stay at or above a number
    #[arg(long, value_name = "OUTPUT=NUMBER", value_parser = bound)]
    at_least: Vec<(String, f64)>,

    /// The inputs that are moved, with commas between; all that the outputs hang on when not given
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    with: Vec<String>,

    /// CMA-ES for one goal, NSGA-II for several or for toggles and lists; chosen by that when not given
    #[arg(long, value_name = "METHOD")]
    method: Option<MethodName>,

    /// How many points NSGA-II keeps
    #[arg(long, value_name = "N", default_value_t = 100)]
    population: usize,

    /// How many different points are solved at most
    #[arg(long, value_name = "N", default_value_t = 1000)]
    evaluations: usize,

    /// End after so many points that brought nothing better
    #[arg(long, value_name = "N")]
    patience: Option<usize>,

    /// What random numbers begin with
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// How many points are solved side by side; as many as the machine has processors when not given
    #[arg(long, value_name = "N")]
    workers: Option<usize>,

    /// The folder of the study
    #[arg(short, long = "output", value_name = "FOLDER")]
    output: PathBuf,

    /// A copy of the definition with its inputs at the best point: .gh, .ghx or .kd
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum MethodName {
    Cma,
    Nsga2,
}

/// What is asked for, bound to a document.
struct Problem {
    variables: Vec<Variable>,
    outputs: Vec<Output>,
    objectives: Vec<Objective>,
    constraints: Vec<Constraint>,
}

pub(crate) fn optimise(args: &OptimiseArgs) -> Result<u8, String> {
    if args.definition.ticks.is_some() {
        return Err("--ticks: runs in time are not supported here".to_owned());
    }
    if args.workers == Some(0) {
        return Err("--workers must be at least 1".to_owned());
    }
    let mut session = open::session(&args.definition)?;
    let options = session.options_mut();
    options.progress = None;
    options.limits.time = options.limits.time.or(Some(POINT_TIME));
    let options = options.clone();
    let document = session.document().clone();
    let problem = problem(args, &document).map_err(|error| error.to_string())?;
    let has_choices = problem.variables.iter().any(|variable| variable.limits().is_none());
    let method = match args.method {
        Some(MethodName::Cma) => Method::Cma,
        None if problem.objectives.len() == 1 && !has_choices => Method::Cma,
        Some(MethodName::Nsga2) | None => Method::Nsga2(args.population),
    };
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let settings = OptimiseSettings {
        objectives: problem.objectives,
        constraints: problem.constraints,
        method,
        evaluations: args.evaluations,
        patience: args.patience,
        seed: args.seed,
        study: Settings {
            workers: args.workers.unwrap_or(processors),
            retry: false,
            identity: identity(&args.definition)?,
            definition: definition_file(&args.definition),
            grace: None,
            cancel: Cancel::default(),
        },
    };
    ticks::on_interrupt(settings.study.cancel.clone());
    let mut line = Line::new();
    let (variables, outputs) = (problem.variables, problem.outputs);
    let found = search(
        document.clone(),
        options,
        variables.clone(),
        outputs.clone(),
        &args.output,
        &settings,
        |now| line.show(now),
    );
    progress::clear();
    let found = found.map_err(|error| error.to_string())?;
    let done = found.progress;
    note(&format!(
        "{GREEN}{}{GREEN:#} points: {} solved now, {} known before, {:.1} s; {}",
        done.points,
        done.solved,
        done.had,
        done.elapsed.as_secs_f64(),
        found.ended
    ));
    show(&found.best, &variables, &outputs);
    let Some(best) = found.best.first().filter(|best| best.holds) else {
        note(&format!("{YELLOW}at no point all constraints hold{YELLOW:#}, or none has results"));
        return Ok(1);
    };
    if let Some(path) = &args.write {
        let mut copy = document;
        for (variable, cell) in variables.iter().zip(&best.inputs) {
            variable.write(&mut copy, cell).map_err(|error| error.to_string())?;
        }
        convert::write_document(&copy, path)?;
    }
    Ok(0)
}

fn problem(args: &OptimiseArgs, document: &Document) -> Result<Problem, StudyError> {
    let mut problem = Problem {
        variables: Vec::new(),
        outputs: Vec::new(),
        objectives: Vec::new(),
        constraints: Vec::new(),
    };
    if args.minimise.is_empty() && args.maximise.is_empty() {
        let (variables, output, goal) = galapagos(document)?;
        (problem.variables, problem.outputs) = (variables, vec![output]);
        problem.objectives.push(Objective { output: 0, goal });
    }
    let mut place = |name: &str| -> Result<usize, StudyError> {
        if let Some(at) = problem.outputs.iter().position(|output| output.name == name) {
            return Ok(at);
        }
        problem.outputs.push(Output::find(document, name)?);
        Ok(problem.outputs.len() - 1)
    };
    for (names, goal) in [(&args.minimise, Goal::Least), (&args.maximise, Goal::Most)] {
        for name in names {
            problem.objectives.push(Objective { output: place(name)?, goal });
        }
    }
    for (name, x) in &args.at_most {
        problem.constraints.push(Constraint { output: place(name)?, bound: Bound::AtMost(*x) });
    }
    for (name, x) in &args.at_least {
        problem.constraints.push(Constraint { output: place(name)?, bound: Bound::AtLeast(*x) });
    }
    if !args.with.is_empty() {
        let named = args.with.iter().map(|name| Variable::find(document, name.trim()));
        problem.variables = named.collect::<Result<_, _>>()?;
    } else if problem.variables.is_empty() {
        for output in &problem.outputs {
            for variable in inputs_of(document, output)? {
                if problem.variables.iter().all(|other| other.name != variable.name) {
                    problem.variables.push(variable);
                }
            }
        }
    }
    Ok(problem)
}

/// Prints the best points, at most so many.
fn show(best: &[Best], variables: &[Variable], outputs: &[Output]) {
    /// Rows of a front that are printed; the table has all.
    const MOST: usize = 20;
    let names = variables.iter().map(|variable| variable.name.as_str());
    let header: Vec<&str> =
        ["point"].into_iter().chain(names).chain(outputs.iter().map(|output| output.name.as_str())).collect();
    let rows = best.iter().take(MOST).map(|best| {
        let cells = best.inputs.iter().chain(&best.outputs).map(ToString::to_string);
        std::iter::once(best.point.to_string()).chain(cells).collect()
    });
    table(&header, rows.collect());
    if best.len() > MOST {
        print(&format!("  and {} more that no other is better than\n", best.len() - MOST));
    }
}

fn bound(text: &str) -> Result<(String, f64), String> {
    let wrong = || "expected OUTPUT=NUMBER".to_owned();
    let (name, number) = text.split_once('=').ok_or_else(wrong)?;
    let number: f64 = number.trim().parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(wrong)?;
    Ok((name.trim().to_owned(), number))
}
