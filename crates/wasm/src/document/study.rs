//! What moves a result, and inputs for a wanted one: found in slices, on a clone of the engine, beside all else that the client asks.

use std::time::Duration;

use katydid_component::Cancel;
use katydid_session::protocol::{Event, InputPlace, Solved, SolvedInput};
use katydid_solver::Engine;
use katydid_studio::study::{self, ENDED, PAIRS, Posed, Question, SEED, told};
use katydid_study::{Effort, Here, Inquiry};

use super::Document;

/// Requests wait no longer than this and a solve.
const SLICE: Duration = Duration::from_millis(30);

/// A question that the client waits for an answer to.
#[derive(Debug)]
pub(super) struct Study {
    seq: u64,
    stage: Stage,
}

#[derive(Debug)]
enum Stage {
    Asked(Question),
    Here { search: Search, ranges: bool },
    Ranges { search: Search, here: (f64, Vec<Here>) },
    Wanted { search: Search, wanted: Vec<f64>, effort: Effort, gesture: u64 },
}

/// A definition that is asked, and where its inputs are in the document.
#[derive(Debug)]
struct Search {
    inquiry: Inquiry,
    places: Vec<InputPlace>,
}

/// What a slice came to.
enum Slice {
    /// It goes on so.
    More(Box<Stage>),
    /// What the client is told.
    Told(Box<Event>),
    /// Inputs for a wanted result, and the gesture that puts them there.
    Found(Solved, u64),
}

impl Slice {
    fn more(stage: Stage) -> Self {
        Self::More(Box::new(stage))
    }

    fn tell(event: Event) -> Self {
        Self::Told(Box::new(event))
    }
}

impl From<Posed> for Search {
    fn from(Posed { prepared, places }: Posed) -> Self {
        Self { inquiry: Inquiry::new(prepared), places }
    }
}

impl Document {
    /// Begins a study, once the results are those of the document as it stands. It takes the place of one that is going on.
    pub(super) fn study(&mut self, seq: u64, question: Question) {
        self.end_study();
        self.study = Some(Study { seq, stage: Stage::Asked(question) });
    }

    /// Ends the study that is going on.
    pub(super) fn end_study(&mut self) {
        if let Some(Study { seq, .. }) = self.study.take() {
            self.out.say(&Event::Refused { seq, reason: ENDED.to_owned() });
        }
    }

    /// A slice of the study that is going on.
    pub(super) fn study_on(&mut self) {
        let Some(Study { seq, stage }) = self.study.take() else { return };
        let event = match stage.slice(&self.engine, seq) {
            Ok(Slice::More(stage)) => return self.study = Some(Study { seq, stage: *stage }),
            Ok(Slice::Told(event)) => *event,
            Ok(Slice::Found(solved, gesture)) => {
                let mut inputs = solved.inputs.iter();
                match inputs.try_for_each(|input| self.put(input, gesture)) {
                    Ok(()) => Event::Solved { seq, solved },
                    Err(reason) => Event::Refused { seq, reason },
                }
            }
            Err(reason) => Event::Refused { seq, reason },
        };
        self.out.say(&event);
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

impl Stage {
    fn slice(self, engine: &Engine, seq: u64) -> Result<Slice, String> {
        match self {
            Self::Asked(question) => {
                let mut engine = engine.clone();
                // What a hand drags meanwhile is not the study's, nor the other way round.
                engine.options_mut().kept = None;
                begin(question, engine, seq)
            }
            Self::Here { mut search, ranges } => {
                let Some(here) = search.inquiry.effects_here(SLICE) else {
                    return Ok(Slice::more(Self::Here { search, ranges }));
                };
                let here = here.map_err(told)?;
                if ranges {
                    return Ok(Slice::more(Self::Ranges { search, here }));
                }
                let effects = study::effects_view(&search.places, here, (Vec::new(), 0, 0));
                Ok(Slice::tell(Event::Effects { seq, effects }))
            }
            Self::Ranges { mut search, here } => {
                let Some(ranged) = search.inquiry.effects_over_range(PAIRS, SEED, SLICE) else {
                    return Ok(Slice::more(Self::Ranges { search, here }));
                };
                let effects = study::effects_view(&search.places, here, ranged.map_err(told)?);
                Ok(Slice::tell(Event::Effects { seq, effects }))
            }
            Self::Wanted { mut search, wanted, effort, gesture } => {
                let Some(found) = search.inquiry.solve_for(&wanted, effort, SLICE) else {
                    return Ok(Slice::more(Self::Wanted { search, wanted, effort, gesture }));
                };
                let variables = search.inquiry.prepared().variables();
                let solved = study::solved_view(&search.places, variables, found.map_err(told)?);
                Ok(Slice::Found(solved, gesture))
            }
        }
    }
}

/// Makes the definition ready for a question. Motion takes three solves: it is answered at once.
fn begin(question: Question, engine: Engine, seq: u64) -> Result<Slice, String> {
    let cancel = Cancel::default();
    Ok(match question {
        Question::Effects { target, with, ranges } => {
            let search = Posed::effects(engine, &target, with.as_deref(), cancel)?.into();
            Slice::more(Stage::Here { search, ranges })
        }
        Question::SolveFor { wants, with, quick, gesture } => {
            let (posed, wanted) = Posed::wanted(engine, &wants, with.as_deref(), cancel)?;
            let effort = study::effort(quick);
            Slice::more(Stage::Wanted { search: posed.into(), wanted, effort, gesture })
        }
        Question::Motion { input } => {
            let motion = study::motion_view(engine, input, &cancel)?;
            Slice::tell(Event::Motion { seq, motion })
        }
    })
}
