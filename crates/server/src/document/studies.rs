//! What moves a result, and inputs for a wanted one: found on a clone of the engine, beside whatever else happens to the document.

use std::collections::HashMap;
use std::sync::Arc;
use std::sync::mpsc::Sender;
use std::time::Duration;

use katydid_component::Cancel;
use katydid_data::Path;
use katydid_definition::document::Document;
use katydid_session::protocol::{
    ArrowView, DerivativeView, Edit, EffectsView, EndView, Event, HereView, InputPlace, MotionView,
    RangedView, Setting, ShareView, SlopeView, Solved, SolvedInput, Target, Want,
};
use katydid_solver::Engine;
use katydid_study::{
    Derivative, Effort, Here, Output, Prepared, RangeSettings, Ranged, Slope, StudyError, Variable,
    effects_here, effects_over_range, inputs_of, motion, shown_objects, solve_for,
};
use uuid::Uuid;

use super::actor::Actor;
use super::outbox::Outbox;
use super::{ClientId, Command};

/// A drag waits so long for an answer.
const QUICK: Duration = Duration::from_millis(100);
/// Who waits for the best answer waits so long at most.
const PATIENT: Duration = Duration::from_secs(10);
/// A single solve takes no longer.
const SOLVE_TIME: Duration = Duration::from_secs(20);
/// Pairs of points for shares over whole ranges: a confidence of some hundredths.
const PAIRS: usize = 256;
/// What is told of a study that somebody ended, or that another of the same client took the place of.
const ENDED: &str = "it was ended";
/// More wanted results than this are no wish but a mistake.
const MOST_WANTS: usize = 1_000;

/// What is asked.
pub(super) enum Question {
    Effects { target: Target, with: Option<Vec<InputPlace>>, ranges: bool },
    SolveFor { wants: Vec<Want>, with: Option<Vec<InputPlace>>, quick: bool, gesture: u64 },
    Motion { input: InputPlace },
}

/// Inputs that were found for a wanted result, on their way to the document.
pub(crate) struct Found {
    client: ClientId,
    seq: u64,
    gesture: u64,
    cancel: Cancel,
    solved: Solved,
}

/// The studies that are going on, one a client.
pub(super) struct Studies {
    running: HashMap<ClientId, Cancel>,
    back: Sender<Command>,
}

impl Studies {
    pub(super) fn new(back: Sender<Command>) -> Self {
        Self { running: HashMap::new(), back }
    }

    fn begin(&mut self, client: ClientId) -> Cancel {
        self.end(client);
        let cancel = Cancel::default();
        self.running.insert(client, cancel.clone());
        cancel
    }

    /// Ends what a client waits for.
    pub(super) fn end(&mut self, client: ClientId) {
        if let Some(cancel) = self.running.remove(&client) {
            cancel.cancel();
        }
    }

    /// Ends all.
    pub(super) fn end_all(&mut self) {
        self.running.drain().for_each(|(_, cancel)| cancel.cancel());
    }
}

impl Actor {
    /// Begins a study once the results are those of the document as it stands. The answer comes when it is found.
    pub(super) fn study(&mut self, id: ClientId, seq: u64, question: Question) {
        let Some(outbox) = self.clients.get(id).map(|client| Arc::clone(&client.outbox)) else { return };
        let cancel = self.studies.begin(id);
        let back = self.studies.back.clone();
        self.inquire(Box::new(move |engine: &Engine| {
            // Who asks faster than the document is solved has one study all the same.
            if cancel.is_cancelled() {
                return outbox.put(Event::Refused { seq, reason: ENDED.to_owned() });
            }
            let asked = Asked { client: id, seq, cancel, outbox: Arc::clone(&outbox), back };
            let mut engine = engine.clone();
            engine.options_mut().limits.time = Some(SOLVE_TIME);
            // The worker goes on with the document meanwhile.
            let begun = std::thread::Builder::new()
                .name("study".to_owned())
                .spawn(move || asked.answer(engine, question));
            if let Err(error) = begun {
                outbox.put(Event::Refused { seq, reason: format!("no thread could be started: {error}") });
            }
        }));
    }

    /// Puts inputs where they were found to belong, as a part of the gesture that asked for it.
    pub(super) fn found(&mut self, Found { client, seq, gesture, cancel, solved }: Found) {
        let event = if cancel.is_cancelled() {
            Event::Refused { seq, reason: ENDED.to_owned() }
        } else {
            match solved.inputs.iter().try_for_each(|input| self.put(input, gesture)) {
                Ok(()) => Event::Solved { seq, solved },
                Err(reason) => Event::Refused { seq, reason },
            }
        };
        if let Some(client) = self.clients.get(client) {
            client.outbox.put(event);
        }
    }

    fn put(&mut self, SolvedInput { input, value, .. }: &SolvedInput, gesture: u64) -> Result<(), String> {
        let to = match input.gene {
            Some(index) => Setting::Gene { index, value: *value },
            None => Setting::Number { value: *value },
        };
        let edit = Edit::Set { object: input.object, to };
        let change =
            self.editor.apply(&edit, Some(gesture), &input.within).map_err(|refusal| refusal.to_string())?;
        self.publish(&change);
        Ok(())
    }
}

/// A study that a client waits for.
struct Asked {
    client: ClientId,
    seq: u64,
    cancel: Cancel,
    outbox: Arc<Outbox>,
    back: Sender<Command>,
}

impl Asked {
    fn answer(self, engine: Engine, question: Question) {
        let seq = self.seq;
        let found = match question {
            Question::Effects { target, with, ranges } => self
                .effects(engine, &target, with.as_deref(), ranges)
                .map(|effects| Event::Effects { seq, effects }),
            Question::Motion { input } => {
                self.motion(engine, input).map(|motion| Event::Motion { seq, motion })
            }
            Question::SolveFor { wants, with, quick, gesture } => {
                match self.solve_for(engine, &wants, with.as_deref(), quick) {
                    Ok(solved) => {
                        let Self { client, seq, cancel, back, .. } = self;
                        // Where the document is closed, nobody waits.
                        let _ = back.send(Command::Found(Found { client, seq, gesture, cancel, solved }));
                        return;
                    }
                    Err(reason) => Err(reason),
                }
            }
        };
        self.outbox.put(found.unwrap_or_else(|reason| Event::Refused { seq, reason }));
    }

    fn effects(
        &self,
        engine: Engine,
        target: &Target,
        with: Option<&[InputPlace]>,
        ranges: bool,
    ) -> Result<EffectsView, String> {
        let output = output(engine.document(), target)?;
        let variables = chosen(engine.document(), std::slice::from_ref(&output), with)?;
        let places = places(engine.document(), &variables);
        let prepared = Prepared::of_engine(engine, self.cancel.clone(), variables, vec![output]);
        let (value, here) = effects_here(&prepared, &self.cancel).map_err(told)?;
        let (ranged, points, failed) = if ranges {
            let workers = std::thread::available_parallelism().map_or(1, usize::from);
            let settings = RangeSettings { pairs: PAIRS, seed: 1, workers, cancel: self.cancel.clone() };
            effects_over_range(&prepared, &settings).map_err(told)?
        } else {
            (Vec::new(), 0, 0)
        };
        let place = |one: &Here| places.get(one.variable).cloned();
        Ok(EffectsView {
            value,
            here: here.iter().filter_map(|one| Some(here_view(place(one)?, one))).collect(),
            ranged: places.iter().zip(&ranged).map(|(place, one)| ranged_view(place.clone(), one)).collect(),
            points: [points, failed].map(|count| u32::try_from(count).unwrap_or(u32::MAX)),
        })
    }

    fn solve_for(
        &self,
        engine: Engine,
        wants: &[Want],
        with: Option<&[InputPlace]>,
        quick: bool,
    ) -> Result<Solved, String> {
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
        let places = places(engine.document(), &variables);
        let prepared = Prepared::of_engine(engine, self.cancel.clone(), variables, outputs);
        let effort = Effort { time: Some(if quick { QUICK } else { PATIENT }), ..Effort::default() };
        let solution = solve_for(&prepared, &wanted, effort, &self.cancel).map_err(told)?;
        let names = prepared.variables().iter().map(|variable| variable.name.clone());
        let inputs = places
            .into_iter()
            .zip(names)
            .zip(&solution.inputs)
            .map(|((input, name), value)| SolvedInput { input, name, value: *value })
            .collect();
        Ok(Solved { off: solution.off, numbers: solution.numbers, inputs })
    }

    fn motion(&self, engine: Engine, input: InputPlace) -> Result<MotionView, String> {
        let document = engine.document();
        let variables = vec![variable(document, &input)?];
        let objects = shown_objects(document);
        let ids: Vec<Uuid> = document.objects.iter().map(|object| object.id).collect();
        let prepared = Prepared::of_engine(engine, self.cancel.clone(), variables, Vec::new());
        let found = motion(&prepared, &objects, &self.cancel).map_err(told)?;
        let moving = found.arrows.iter().filter(|arrow| arrow.by.length() > 0.0);
        let arrows = moving.map(|arrow| ArrowView { at: arrow.at.into(), by: arrow.by.into() }).collect();
        let left_out = found.left_out.iter().filter_map(|at| ids.get(*at).copied()).collect();
        Ok(MotionView { arrows, left_out })
    }
}

fn told(error: StudyError) -> String {
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
