//! What moves a result, and inputs for a wanted one: found on a clone of the engine, beside whatever else happens to the document.

use std::collections::HashMap;
use std::sync::Arc;
use std::sync::mpsc::Sender;

use katydid_component::Cancel;
use katydid_session::protocol::{EffectsView, Event, InputPlace, Solved, SolvedInput, Target, Want};
use katydid_solver::Engine;
pub(super) use katydid_studio::study::Question;
use katydid_studio::study::{self, ENDED, Posed, told};
use katydid_study::{RangeSettings, effects_here, effects_over_range, solve_for};

use super::actor::Actor;
use super::outbox::Outbox;
use super::{ClientId, Command};

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
            // What a hand drags meanwhile is not the study's, nor the other way round.
            engine.options_mut().kept = None;
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

    fn put(&mut self, input: &SolvedInput, gesture: u64) -> Result<(), String> {
        let edit = study::edit_of(input);
        let within = &input.input.within;
        let change =
            self.editor.apply(&edit, Some(gesture), within).map_err(|refusal| refusal.to_string())?;
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
                study::motion_view(engine, input, &self.cancel).map(|motion| Event::Motion { seq, motion })
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
        let Posed { prepared, places } = Posed::effects(engine, target, with, self.cancel.clone())?;
        let here = effects_here(&prepared, &self.cancel).map_err(told)?;
        let ranged = if ranges {
            let workers = std::thread::available_parallelism().map_or(1, usize::from);
            let settings = RangeSettings {
                pairs: study::PAIRS,
                seed: study::SEED,
                workers,
                cancel: self.cancel.clone(),
            };
            effects_over_range(&prepared, &settings).map_err(told)?
        } else {
            (Vec::new(), 0, 0)
        };
        Ok(study::effects_view(&places, here, ranged))
    }

    fn solve_for(
        &self,
        engine: Engine,
        wants: &[Want],
        with: Option<&[InputPlace]>,
        quick: bool,
    ) -> Result<Solved, String> {
        let (Posed { prepared, places }, wanted) = Posed::wanted(engine, wants, with, self.cancel.clone())?;
        let solution = solve_for(&prepared, &wanted, study::effort(quick), &self.cancel).map_err(told)?;
        Ok(study::solved_view(&places, prepared.variables(), solution))
    }
}
