//! What clients ask, and what becomes of it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use katydid_geometry::explain::Algorithm;
use katydid_session::protocol::{Ask, Edit, Event, Request, Setting};
use katydid_session::{Digits, Refusal, Solution, rows};
use katydid_solver::Inputs;
use katydid_studio::pictures;
use uuid::Uuid;

use super::actor::Actor;
use super::solving::Work;
use super::studies::Question;
use super::worker::Job;
use super::{ClientId, Download};
use crate::files::{self, Form};

/// A client looks at so many objects at most, besides all that are shown.
const MOST_LOOKED_AT: usize = 10_000;
/// A client asks about so many places at most.
const MOST_PROBES: usize = 64;

/// Which rows of which data.
struct Wanted {
    port: Uuid,
    from: u32,
    count: u32,
    digits: Digits,
}

/// What an answer says.
enum Answer {
    /// It is done; these objects were made.
    Done(Vec<Uuid>),
    /// This is it.
    Event(Box<Event>),
    /// It comes later.
    Later,
}

impl Actor {
    /// Carries out what a client asks, and answers.
    pub(super) fn asked(&mut self, id: ClientId, Request { seq, ask }: Request) {
        let answer = self.carry_out(id, seq, ask);
        let event = match answer {
            Ok(Answer::Done(made)) => Event::Done { seq, revision: self.editor.revision(), made },
            Ok(Answer::Event(event)) => *event,
            Ok(Answer::Later) => return,
            Err(reason) => Event::Refused { seq, reason },
        };
        if let Some(client) = self.clients.get(id) {
            client.outbox.put(event);
        }
    }

    fn carry_out(&mut self, id: ClientId, seq: u64, ask: Ask) -> Result<Answer, String> {
        let told = |refusal: Refusal| refusal.to_string();
        let mut made = Vec::new();
        self.look_at_scripts(id, &ask);
        match ask {
            // Nobody keeps or takes back that a button is held: only the solver hears of it.
            Ask::Edit { edit: Edit::Set { object, to: Setting::Press { down } }, within, .. } => {
                let difference = self.editor.press(object, down, &within).map_err(told)?;
                let _ = self.jobs.send(Job::Press(difference));
                self.want(Work::Solve);
            }
            // The same of a particle that is dragged. What is let go is let go for a hand that is gone, too.
            Ask::Edit { edit: Edit::Set { object, to: Setting::Grab { held } }, within, .. } => {
                let difference = self.editor.grab(object, held, &within).map_err(told)?;
                if let Some(client) = self.clients.get_mut(id) {
                    client.holds(object, held.is_some());
                }
                let _ = self.jobs.send(Job::Drag(difference));
                self.want(Work::Solve);
            }
            Ask::Edit { edit, gesture, within } => {
                let document = Arc::clone(self.editor.document());
                let report = |id| self.reports.get(&id).cloned();
                let model = self.model.model().map(Arc::clone);
                let solution = Solution::new(&document, &report).beside(model.as_deref());
                let change = self.editor.apply_with(&edit, gesture, &within, &solution).map_err(told)?;
                made.clone_from(&change.made);
                self.publish(&change);
            }
            Ask::Abandon { gesture } => {
                // What is being found for the gesture must not move sliders after it was taken back.
                self.studies.end(id);
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
                let _ = self.jobs.send(Job::Forget);
                self.solving.want(Work::Solve, &self.jobs);
            }
            Ask::Cancel => self.solving.cancel(),
            Ask::Lock { on } => {
                self.editor.about_mut().locked = on;
                self.publish_document();
                self.want(Work::Solve);
            }
            Ask::Enter { within } => {
                self.editor.state(&within).map_err(told)?;
                self.clients.get_mut(id).into_iter().for_each(|client| client.within.clone_from(&within));
                self.show_all(id);
            }
            Ask::Rows { port, from, count, exact, within } => {
                let wanted = Wanted { port, from, count, digits: Digits::of(exact) };
                return self.rows(id, seq, wanted, &within);
            }
            Ask::Explain { object, algorithm } => return self.explain(id, seq, object, algorithm.as_deref()),
            Ask::Effects { target, with, ranges } => {
                self.study(id, seq, Question::Effects { target, with, ranges });
                return Ok(Answer::Later);
            }
            Ask::SolveFor { wants, with, quick, gesture } => {
                self.study(id, seq, Question::SolveFor { wants, with, quick, gesture });
                return Ok(Answer::Later);
            }
            Ask::Motion { input } => {
                self.study(id, seq, Question::Motion { input });
                return Ok(Answer::Later);
            }
            Ask::EndStudy => self.studies.end(id),
            Ask::Nurbs { port } => return Ok(self.nurbs(id, seq, port)),
            Ask::Pictures { port, within } => return Ok(self.pictures(id, seq, port, within)),
            Ask::Copy { objects, within } => {
                let text = self.editor.copy(&objects, &within).map_err(told)?;
                return Ok(Answer::Event(Box::new(Event::Copied { seq, text })));
            }
            Ask::Scripts => {
                let scripts = katydid_session::scripts(self.editor.document());
                return Ok(Answer::Event(Box::new(Event::Scripts { seq, scripts })));
            }
            Ask::AllowScripts { run, keep } => self.allow_scripts(id, run, keep)?,
            Ask::Save { path } => self.save(path)?,
            Ask::DetachModel => self.detach_model(),
            Ask::Settle { keep } => {
                let change = self.editor.settle(keep);
                self.publish(&change);
                self.publish_document();
            }
            Ask::Draft { on } => {
                self.clients.get_mut(id).into_iter().for_each(|client| client.drags = on);
                self.set_draft();
            }
            Ask::Analyse { analysis } => {
                let objects = analysis.as_ref().and_then(|view| view.objects.as_ref()).map_or(0, Vec::len);
                if objects > MOST_LOOKED_AT {
                    return Err(format!("no more than {MOST_LOOKED_AT} objects are looked at"));
                }
                let _ = self.jobs.send(Job::Analyse(id, analysis));
                self.solving.want(Work::Draw, &self.jobs);
            }
            Ask::Probe { round, probes } => {
                if probes.len() > MOST_PROBES {
                    return Err(format!("no more than {MOST_PROBES} places are looked at"));
                }
                let _ = self.jobs.send(Job::Probe(id, round, probes));
                self.solving.want(Work::Draw, &self.jobs);
            }
        }
        Ok(Answer::Done(made))
    }

    /// Rows of an output at once; those of an input, with what it keeps and makes of its data, when the worker comes
    /// to it.
    fn rows(
        &mut self,
        id: ClientId,
        seq: u64,
        Wanted { port, from, count, digits }: Wanted,
        within: &[Uuid],
    ) -> Result<Answer, String> {
        let style = self.style();
        if !within.is_empty() || self.editor.lookup().output(port).is_some() {
            let report = |id| self.reports.get(&id).cloned();
            let solution = Solution::new(self.editor.document(), &report);
            let page = solution.rows(port, within, [from, count], digits, &style).ok_or("it has no data")?;
            return Ok(Answer::Event(Box::new(Event::Rows { seq, page })));
        }
        let Some(outbox) = self.clients.get(id).map(|client| Arc::clone(&client.outbox)) else {
            return Ok(Answer::Later);
        };
        let inquiry = move |engine: &katydid_solver::Engine| {
            let objects = engine.document().objects.iter().enumerate();
            let place = objects
                .filter_map(|(at, object)| {
                    Some((at, object.inputs.iter().position(|input| input.id == port)?))
                })
                .next();
            let tree = place.and_then(|(at, k)| Inputs::new(engine).of(at).into_iter().nth(k));
            outbox.put(match tree {
                Some(tree) => Event::Rows { seq, page: rows(&tree, [from, count], digits, &style) },
                None => Event::Refused { seq, reason: "it has no data".to_owned() },
            });
        };
        self.inquire(Box::new(inquiry));
        Ok(Answer::Later)
    }

    /// How the result of an object comes about, when the worker comes to it.
    fn explain(
        &mut self,
        id: ClientId,
        seq: u64,
        object: Uuid,
        algorithm: Option<&str>,
    ) -> Result<Answer, String> {
        let algorithm = algorithm
            .map(|name| Algorithm::from_name(name).ok_or_else(|| format!("there is no algorithm {name}")))
            .transpose()?;
        let Some(outbox) = self.clients.get(id).map(|client| Arc::clone(&client.outbox)) else {
            return Ok(Answer::Later);
        };
        self.inquire(Box::new(move |engine: &katydid_solver::Engine| {
            let place = engine.document().objects.iter().position(|one| one.id == object);
            let told = place.ok_or_else(|| "there is no such object".to_owned());
            outbox.put(match told.and_then(|place| katydid_session::explain(engine, place, algorithm)) {
                Ok(told) => Event::Explained { seq, explanation: (&told).into() },
                Err(reason) => Event::Refused { seq, reason },
            });
        }));
        Ok(Answer::Later)
    }

    /// The control points and knots of a curve, when the worker comes to it.
    fn nurbs(&mut self, id: ClientId, seq: u64, port: Uuid) -> Answer {
        let Some(outbox) = self.clients.get(id).map(|client| Arc::clone(&client.outbox)) else {
            return Answer::Later;
        };
        self.inquire(Box::new(move |engine: &katydid_solver::Engine| {
            let place = engine.document().lookup().output(port);
            let told = place.ok_or_else(|| "there is no such output".to_owned());
            outbox.put(match told.and_then(|at| katydid_session::nurbs_of(engine, at.object, at.port)) {
                Ok(curve) => Event::Nurbs { seq, curve },
                Err(reason) => Event::Refused { seq, reason },
            });
        }));
        Answer::Later
    }

    /// Small pictures of the data of a port, when the worker comes to it: it knows which files the document may read.
    fn pictures(&mut self, id: ClientId, seq: u64, port: Uuid, within: Vec<Uuid>) -> Answer {
        let style = self.style();
        let Some(outbox) = self.clients.get(id).map(|client| Arc::clone(&client.outbox)) else {
            return Answer::Later;
        };
        let inquiry = move |engine: &katydid_solver::Engine| {
            let document = engine.document();
            let report = |id: Uuid| {
                let place = document.objects.iter().position(|object| object.id == id)?;
                engine.report(place).cloned()
            };
            let tree = Solution::new(document, &report).data(port, &within);
            outbox.put(match tree {
                Some(tree) => {
                    let pictures = pictures(&tree, &engine.options().files, &style);
                    Event::Pictures { seq, pictures }
                }
                None => Event::Refused { seq, reason: "it has no data".to_owned() },
            });
        };
        self.inquire(Box::new(inquiry));
        Answer::Later
    }

    /// Saves the document where it is kept, or at a path of this machine.
    fn save(&mut self, path: Option<String>) -> Result<(), String> {
        let path = match path {
            Some(_) if !self.shared.trust.names_paths() => {
                return Err(
                    "files of the server's machine cannot be named from here: download it instead".to_owned()
                );
            }
            Some(path) => named(&path)?,
            None => self.path.clone().ok_or("it was never saved: give it a name")?,
        };
        let form = Form::of(&path).ok_or("a definition is saved as .gh, .ghx or .kd")?;
        let (bytes, left_out) = files::write(form, self.editor.document())?;
        katydid_session::write_file(&path, &bytes)
            .map_err(|error| format!("{}: {}", self.shared.trust.told(&path), files::plain(&error)))?;
        for what in left_out.iter().take(10) {
            self.notice("warning", format!("left out: {what}"));
        }
        let path = std::fs::canonicalize(&path).unwrap_or(path);
        let told = self.shared.trust.told(&path);
        let about = self.editor.about_mut();
        about.name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        about.path = Some(told);
        self.keeper.saved(&mut self.editor, &path, blake3::hash(&bytes));
        self.scripting.saved(&bytes, &path);
        if let Some(recent) = &self.shared.recent {
            recent.note(&path);
        }
        self.path = Some(path);
        self.publish_document();
        Ok(())
    }

    /// The document in a form, for a browser to keep.
    pub(super) fn bytes(&self, form: Form) -> Result<Download, String> {
        let (bytes, _) = files::write(form, self.editor.document())?;
        let about = self.editor.about();
        let name = if about.name.is_empty() { "definition" } else { &about.name };
        let stem = Path::new(name).file_stem().map(|stem| stem.to_string_lossy().into_owned());
        Ok(Download { name: format!("{}.{}", stem.unwrap_or_default(), form.extension()), bytes })
    }
}

/// A path that somebody typed.
fn named(path: &str) -> Result<PathBuf, String> {
    let typed = path.trim();
    if typed.is_empty() || typed.contains('\0') {
        return Err("give it a name".to_owned());
    }
    let path = match typed.strip_prefix("~/").zip(std::env::var_os("HOME")) {
        Some((rest, home)) => PathBuf::from(home).join(rest),
        None => PathBuf::from(typed),
    };
    if !path.is_absolute() {
        return Err(format!("{typed}: name the folder too, from the root on"));
    }
    Ok(path)
}
