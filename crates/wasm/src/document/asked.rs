//! What the client asks, and what becomes of it.

use std::sync::Arc;

use katydid_geometry::explain::Algorithm;
use katydid_session::protocol::{Ask, Edit, Event, Request, Setting};
use katydid_session::{Digits, Refusal, Solution, rows};
use katydid_solver::Inputs;
use katydid_studio::pictures;
use katydid_studio::study::Question;
use uuid::Uuid;

use super::work::Work;
use super::{CLIENT, Document};

/// The client looks at so many objects at most, besides all that are shown.
const MOST_LOOKED_AT: usize = 10_000;
/// It asks about so many places at most.
const MOST_PROBES: usize = 64;

/// What an answer says.
enum Answer {
    /// It is done; these objects were made.
    Done(Vec<Uuid>),
    /// This is it.
    Event(Box<Event>),
    /// It comes when it is found.
    Later,
}

impl Document {
    /// Carries out a request, given as the JSON that a socket would bring. What cannot be read is told as a notice.
    pub fn ask(&mut self, text: &str, progress: super::work::Progress) {
        let Request { seq, ask } = match serde_json::from_str(text) {
            Ok(request) => request,
            Err(error) => return self.notice("error", format!("this request cannot be read: {error}")),
        };
        // These show data as they stand after the edits before them.
        if matches!(ask, Ask::Rows { .. } | Ask::Pictures { .. }) && self.wanted.is_some() {
            self.work(progress);
        }
        let event = match self.carry_out(seq, ask) {
            Ok(Answer::Done(made)) => Event::Done { seq, revision: self.editor.revision(), made },
            Ok(Answer::Event(event)) => *event,
            Ok(Answer::Later) => return,
            Err(reason) => Event::Refused { seq, reason },
        };
        self.out.say(&event);
    }

    fn carry_out(&mut self, seq: u64, ask: Ask) -> Result<Answer, String> {
        let told = |refusal: Refusal| refusal.to_string();
        let mut made = Vec::new();
        match ask {
            // Nobody keeps or takes back that a button is held: only the solver hears of it.
            Ask::Edit { edit: Edit::Set { object, to: Setting::Press { down } }, within, .. } => {
                let difference = self.editor.press(object, down, &within).map_err(told)?;
                // One that does not fit is of a button that is gone.
                let _ = self.engine.apply(&difference);
                self.want(Work::Solve);
            }
            // The same of a particle that is dragged.
            Ask::Edit { edit: Edit::Set { object, to: Setting::Grab { held } }, within, .. } => {
                let difference = self.editor.grab(object, held, &within).map_err(told)?;
                if self.engine.apply(&difference).is_ok() {
                    difference.put.iter().for_each(|(at, _)| self.engine.expire(*at));
                }
                self.want(Work::Solve);
            }
            Ask::Edit { edit, gesture, within } => {
                let document = Arc::clone(self.editor.document());
                let report = |id| self.reports.get(&id).cloned();
                let model = self.model.as_ref().map(|(_, model)| Arc::clone(model));
                let solution = Solution::new(&document, &report).beside(model.as_deref());
                let change = self.editor.apply_with(&edit, gesture, &within, &solution).map_err(told)?;
                made.clone_from(&change.made);
                self.publish(&change);
            }
            Ask::Abandon { gesture } => {
                // What is being found for the gesture must not move sliders after it was taken back.
                self.end_study();
                let change = self.editor.abandon(gesture);
                self.publish(&change);
            }
            Ask::Undo => {
                let change = self.editor.undo().ok_or("there is nothing to undo")?;
                self.publish(&change);
            }
            Ask::Redo => {
                let change = self.editor.redo().ok_or("there is nothing to redo")?;
                self.publish(&change);
            }
            Ask::Recompute => {
                self.engine.forget();
                self.wanted = Some(Work::Solve);
            }
            // No request is heard while a solve is running: what is left is not to begin another.
            Ask::Cancel => self.wanted = self.wanted.map(|_| Work::Draw),
            Ask::Lock { on } => {
                self.editor.about_mut().locked = on;
                self.publish_document();
                self.want(Work::Solve);
            }
            Ask::Enter { within } => {
                self.editor.state(&within).map_err(told)?;
                self.within = within;
                self.show_all();
            }
            Ask::Rows { port, from, count, exact, within } => {
                let page =
                    self.rows(port, [from, count], Digits::of(exact), &within).ok_or("it has no data")?;
                return Ok(Answer::Event(Box::new(Event::Rows { seq, page })));
            }
            Ask::Pictures { port, within } => {
                let report = |id| self.reports.get(&id).cloned();
                let tree = Solution::new(self.editor.document(), &report).data(port, &within);
                let tree = tree.ok_or("it has no data")?;
                let pictures = pictures(&tree, &self.engine.options().files, &self.style());
                return Ok(Answer::Event(Box::new(Event::Pictures { seq, pictures })));
            }
            Ask::Copy { objects, within } => {
                let text = self.editor.copy(&objects, &within).map_err(told)?;
                return Ok(Answer::Event(Box::new(Event::Copied { seq, text })));
            }
            Ask::Scripts => {
                let scripts = katydid_session::scripts(self.editor.document());
                return Ok(Answer::Event(Box::new(Event::Scripts { seq, scripts })));
            }
            Ask::AllowScripts { .. } => {
                return Err(
                    "scripts in Python are not supported in a page; `katydid run` runs them".to_owned()
                );
            }
            Ask::Save { .. } => {
                return Err("a page has no files of its own: download the definition instead".to_owned());
            }
            Ask::Explain { object, algorithm } => {
                let algorithm = algorithm
                    .map(|name| {
                        Algorithm::from_name(&name).ok_or_else(|| format!("there is no algorithm {name}"))
                    })
                    .transpose()?;
                let objects = &self.engine.document().objects;
                let place =
                    objects.iter().position(|one| one.id == object).ok_or("there is no such object")?;
                let told = katydid_session::explain(&self.engine, place, algorithm)?;
                return Ok(Answer::Event(Box::new(Event::Explained { seq, explanation: (&told).into() })));
            }
            Ask::Effects { target, with, ranges } => {
                self.study(seq, Question::Effects { target, with, ranges });
                return Ok(Answer::Later);
            }
            Ask::SolveFor { wants, with, quick, gesture } => {
                self.study(seq, Question::SolveFor { wants, with, quick, gesture });
                return Ok(Answer::Later);
            }
            Ask::Motion { input } => {
                self.study(seq, Question::Motion { input });
                return Ok(Answer::Later);
            }
            Ask::EndStudy => self.end_study(),
            Ask::Nurbs { port } => {
                let at = self.engine.document().lookup().output(port).ok_or("there is no such output")?;
                let curve = katydid_session::nurbs_of(&self.engine, at.object, at.port)?;
                return Ok(Answer::Event(Box::new(Event::Nurbs { seq, curve })));
            }
            Ask::DetachModel => self.detach(),
            Ask::Settle { keep } => {
                let change = self.editor.settle(keep);
                self.publish(&change);
                self.publish_document();
            }
            Ask::Draft { on } => {
                self.drafts.set_draft(on);
                self.analyses.set_draft(on);
                if !on {
                    self.want(Work::Draw);
                }
            }
            Ask::Analyse { analysis } => {
                let objects = analysis.as_ref().and_then(|view| view.objects.as_ref()).map_or(0, Vec::len);
                if objects > MOST_LOOKED_AT {
                    return Err(format!("no more than {MOST_LOOKED_AT} objects are looked at"));
                }
                self.analyses.analyse(CLIENT, analysis);
                self.drafts.set_colours(self.analyses.has_colours());
                self.want(Work::Draw);
            }
            Ask::Probe { round, probes } => {
                if probes.len() > MOST_PROBES {
                    return Err(format!("no more than {MOST_PROBES} places are looked at"));
                }
                self.analyses.probe(CLIENT, round, probes);
                self.want(Work::Draw);
            }
        }
        Ok(Answer::Done(made))
    }

    /// Rows of an output; those of an input with what it keeps and makes of its data.
    fn rows(
        &self,
        port: Uuid,
        range: [u32; 2],
        digits: Digits,
        within: &[Uuid],
    ) -> Option<katydid_session::protocol::Page> {
        let style = self.style();
        if !within.is_empty() || self.editor.lookup().output(port).is_some() {
            let report = |id| self.reports.get(&id).cloned();
            let solution = Solution::new(self.editor.document(), &report);
            return solution.rows(port, within, range, digits, &style);
        }
        let mut objects = self.engine.document().objects.iter().enumerate();
        let (at, k) = objects
            .find_map(|(at, object)| Some((at, object.inputs.iter().position(|input| input.id == port)?)))?;
        let tree = Inputs::new(&self.engine).of(at).into_iter().nth(k)?;
        Some(rows(&tree, range, digits, &style))
    }
}
