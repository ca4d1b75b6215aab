//! What moves a result, and inputs for a wanted one: the page's questions, and answers in its words.

use std::time::Duration;

use katydid_component::Cancel;
use katydid_data::Path;
use katydid_definition::document::Document;
use katydid_session::protocol::{
    ArrowView, DerivativeView, Edit, EffectsView, EndView, HereView, InputPlace, MotionView, RangedView,
    Setting, ShareView, SlopeView, Solved, SolvedInput, Target, Want,
};
use katydid_solver::Engine;
use katydid_study::{
    Derivative, Effort, Here, Output, Prepared, Ranged, Slope, Solution, StudyError, Variable, inputs_of,
    motion, shown_objects,
};
use uuid::Uuid;

/// Pairs of points for shares over whole ranges: a confidence of some hundredths.
pub const PAIRS: usize = 256;
/// What their random numbers begin with: whoever answers, the shares are the same.
pub const SEED: u64 = 1;
/// A drag waits so long for an answer.
const QUICK: Duration = Duration::from_millis(100);
/// Who waits for the best answer waits so long at most.
const PATIENT: Duration = Duration::from_secs(10);
/// A single solve takes no longer.
const SOLVE_TIME: Duration = Duration::from_secs(20);
/// What is told of a study that somebody ended, or that another of the same client took the place of.
pub const ENDED: &str = "it was ended";
/// More wanted results than this are no wish but a mistake.
const MOST_WANTS: usize = 1_000;

/// What is asked.
#[derive(Debug, Clone, PartialEq)]
pub enum Question {
    /// What moves a result: where the definition stands, and over the whole ranges of all inputs if `ranges` is set.
    Effects {
        /// The result.
        target: Target,
        /// The inputs that are looked at; all that the result hangs on, where none are named.
        with: Option<Vec<InputPlace>>,
        /// Whether whole ranges are looked at too.
        ranges: bool,
    },
    /// Inputs for wanted results.
    SolveFor {
        /// The results.
        wants: Vec<Want>,
        /// The inputs that may move; all of even numbers, where none are named.
        with: Option<Vec<InputPlace>>,
        /// Whether a drag waits for it.
        quick: bool,
        /// The gesture that it is a part of.
        gesture: u64,
    },
    /// How places of the shown geometry move with an input.
    Motion {
        /// The input.
        input: InputPlace,
    },
}

/// How long inputs for a wanted result are looked for.
pub fn effort(quick: bool) -> Effort {
    Effort { time: Some(if quick { QUICK } else { PATIENT }), ..Effort::default() }
}

/// A definition made ready for a question.
#[derive(Debug)]
pub struct Posed {
    /// The definition with its inputs and results found.
    pub prepared: Prepared,
    /// Where the inputs are in the document, in their order.
    pub places: Vec<InputPlace>,
}

impl Posed {
    /// Makes ready for what moves a result.
    ///
    /// # Errors
    /// There is no such result or input.
    pub fn effects(
        engine: Engine,
        target: &Target,
        with: Option<&[InputPlace]>,
        cancel: Cancel,
    ) -> Result<Self, String> {
        let output = output(engine.document(), target)?;
        let variables = chosen(engine.document(), std::slice::from_ref(&output), with)?;
        Ok(Self::new(engine, cancel, variables, vec![output]))
    }

    /// Makes ready for wanted results, and gives their numbers one after another.
    ///
    /// # Errors
    /// There is no such result or input, or a number that cannot be wanted.
    pub fn wanted(
        engine: Engine,
        wants: &[Want],
        with: Option<&[InputPlace]>,
        cancel: Cancel,
    ) -> Result<(Self, Vec<f64>), String> {
        if wants.is_empty() || wants.len() > MOST_WANTS {
            return Err(format!("from 1 to {MOST_WANTS} results can be wanted"));
        }
        let outputs: Vec<Output> =
            wants.iter().map(|want| output(engine.document(), &want.target)).collect::<Result<_, _>>()?;
        let wanted: Vec<f64> = wants.iter().flat_map(|want| want.numbers.iter().copied()).collect();
        if let Some(odd) = wanted.iter().find(|x| !x.is_finite()) {
            return Err(format!("{odd} cannot be wanted"));
        }
        let mut variables = chosen(engine.document(), &outputs, with)?;
        if with.is_none() {
            variables.retain(|variable| variable.step().is_none() && variable.limits().is_some());
        }
        Ok((Self::new(engine, cancel, variables, outputs), wanted))
    }

    fn new(mut engine: Engine, cancel: Cancel, variables: Vec<Variable>, outputs: Vec<Output>) -> Self {
        let places = places(engine.document(), &variables);
        engine.options_mut().limits.time = Some(SOLVE_TIME);
        Self { prepared: Prepared::of_engine(engine, cancel, variables, outputs), places }
    }
}

/// What moves a result, by the places of the inputs: the number and what each input does where it stands; what each does over the
/// ranges, how many points were solved for that, and how many of them gave no number.
pub fn effects_view(
    places: &[InputPlace],
    (value, here): (f64, Vec<Here>),
    (ranged, points, failed): (Vec<Ranged>, usize, usize),
) -> EffectsView {
    let place = |one: &Here| places.get(one.variable).cloned();
    EffectsView {
        value,
        here: here.iter().filter_map(|one| Some(here_view(place(one)?, one))).collect(),
        ranged: places.iter().zip(&ranged).map(|(place, one)| ranged_view(place.clone(), one)).collect(),
        points: [points, failed].map(|count| u32::try_from(count).unwrap_or(u32::MAX)),
    }
}

/// What was found for wanted results, by the inputs and their places.
pub fn solved_view(places: &[InputPlace], variables: &[Variable], solution: Solution) -> Solved {
    let inputs = places
        .iter()
        .zip(variables)
        .zip(&solution.inputs)
        .map(|((input, variable), value)| SolvedInput {
            input: input.clone(),
            name: variable.name.clone(),
            value: *value,
        })
        .collect();
    Solved { off: solution.off, numbers: solution.numbers, inputs }
}

/// The edit that puts an input where it was found to belong.
pub fn edit_of(SolvedInput { input, value, .. }: &SolvedInput) -> Edit {
    let to = match input.gene {
        Some(index) => Setting::Gene { index, value: *value },
        None => Setting::Number { value: *value },
    };
    Edit::Set { object: input.object, to }
}

/// How places of the shown geometry move with an input.
///
/// # Errors
/// There is no such input, it cannot be moved evenly, or somebody asked to stop.
pub fn motion_view(mut engine: Engine, input: InputPlace, cancel: &Cancel) -> Result<MotionView, String> {
    engine.options_mut().limits.time = Some(SOLVE_TIME);
    let document = engine.document();
    let variables = vec![variable(document, &input)?];
    let objects = shown_objects(document);
    let ids: Vec<Uuid> = document.objects.iter().map(|object| object.id).collect();
    let prepared = Prepared::of_engine(engine, cancel.clone(), variables, Vec::new());
    let found = motion(&prepared, &objects, cancel).map_err(told)?;
    let moving = found.arrows.iter().filter(|arrow| arrow.by.length() > 0.0);
    let arrows = moving.map(|arrow| ArrowView { at: arrow.at.into(), by: arrow.by.into() }).collect();
    let left_out = found.left_out.iter().filter_map(|at| ids.get(*at).copied()).collect();
    Ok(MotionView { arrows, left_out })
}

/// Why a study has no answer, in words.
pub fn told(error: StudyError) -> String {
    match error {
        StudyError::Stopped => ENDED.to_owned(),
        error => error.to_string(),
    }
}

fn output(document: &Document, Target { within, output, item }: &Target) -> Result<Output, String> {
    let found = Output::of_ids(document, within, *output).map_err(told)?;
    match item {
        None => Ok(found),
        Some(item) => {
            let path: Path = item.path.parse().map_err(|_| format!("{} is no path", item.path))?;
            Ok(found.only(path, usize::try_from(item.index).unwrap_or(usize::MAX)))
        }
    }
}

fn variable(
    document: &Document,
    InputPlace { within, object, gene }: &InputPlace,
) -> Result<Variable, String> {
    let gene = gene.map(|gene| usize::try_from(gene).unwrap_or(usize::MAX));
    Variable::of_ids(document, within, *object, gene).map_err(told)
}

/// The inputs that are named, else all that the outputs hang on.
fn chosen(
    document: &Document,
    outputs: &[Output],
    with: Option<&[InputPlace]>,
) -> Result<Vec<Variable>, String> {
    if let Some(with) = with {
        return with.iter().map(|input| variable(document, input)).collect();
    }
    let mut all: Vec<Variable> = Vec::new();
    for output in outputs {
        for found in inputs_of(document, output).map_err(told)? {
            let is_same = |other: &Variable| other.is_beside(&found) && other.gene() == found.gene();
            if !all.iter().any(is_same) {
                all.push(found);
            }
        }
    }
    Ok(all)
}

fn places(document: &Document, variables: &[Variable]) -> Vec<InputPlace> {
    let place = |variable: &Variable| {
        let (within, object) = variable.ids(document).unwrap_or_default();
        InputPlace { within, object, gene: variable.gene().and_then(|gene| u32::try_from(gene).ok()) }
    };
    variables.iter().map(place).collect()
}

fn derivative(Derivative { value, error }: Derivative) -> DerivativeView {
    DerivativeView { value, error }
}

fn here_view(input: InputPlace, here: &Here) -> HereView {
    let slope = match here.slope {
        Slope::Even(by) => SlopeView::Even { by: derivative(by) },
        Slope::Corner([left, right]) => {
            SlopeView::Corner { left: left.map(derivative), right: right.map(derivative) }
        }
        Slope::Steps { step, change: [down, up] } => SlopeView::Steps { step, down, up },
        Slope::Jump => SlopeView::Jump,
    };
    let end = |end: &katydid_study::End| EndView { at: end.at, why: end.why.clone(), is_limit: end.is_limit };
    let holds = here.holds.as_ref().map(|[from, to]| [end(from), end(to)]);
    HereView { input, name: here.name.clone(), at: here.at, slope, holds }
}

fn ranged_view(input: InputPlace, ranged: &Ranged) -> RangedView {
    let share = ranged.share.map(|share| ShareView {
        alone: [share.alone, share.alone_confidence],
        total: [share.total, share.total_confidence],
    });
    RangedView { input, name: ranged.name.clone(), share, mean: ranged.screening.map(|found| found.size) }
}
