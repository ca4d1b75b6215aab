//! What the client sees: the document, its geometry, its Rhino model, the form of curves and surfaces.

use std::collections::HashMap;

use katydid_session::display::{Geometry, ModelPreview, Preview, encode_model};
use katydid_session::protocol::{Event, ModelView};
use katydid_studio::{About, Analysed, Finding};
use uuid::Uuid;

use super::Document;
use crate::outgoing::{Hashes, Named};

/// What the client sees of the form of curves and surfaces.
#[derive(Debug, Default)]
pub(super) struct Seen {
    pub(super) objects: HashMap<Uuid, Named>,
    pub(super) about: Option<About>,
}

/// So many complaints about one object are told.
const MOST_COMPLAINTS: usize = 3;

fn named(geometry: Geometry) -> Named {
    Named { hash: geometry.hash, bytes: geometry.bytes }
}

fn hashes(all: &HashMap<Uuid, Named>) -> Hashes {
    all.iter().map(|(id, geometry)| (*id, Some(geometry.hash.clone()))).collect()
}

/// Takes geometry that is new; `true` where it is other than before.
fn changes(all: &mut HashMap<Uuid, Named>, object: Uuid, geometry: Option<Geometry>) -> bool {
    let now = geometry.map(named);
    let hash = now.as_ref().map(|geometry| geometry.hash.clone());
    let before = match now {
        Some(now) => all.insert(object, now),
        None => all.remove(&object),
    };
    before.map(|geometry| geometry.hash) != hash
}

impl Document {
    /// Shows the client everything that it looks at.
    pub(super) fn show_all(&mut self) {
        let state = self.editor.state(&self.within).or_else(|_| {
            // The cluster is gone: what is left is the document.
            self.within.clear();
            self.editor.state(&[])
        });
        let Ok(state) = state else { return };
        self.out.say(&Event::Document(state));
        let results = self.views(&self.within);
        let end = self.end;
        if !results.is_empty() || end.is_some() {
            self.out.say(&Event::Results {
                solution: self.number,
                within: self.within.clone(),
                results,
                finished: end.is_some(),
                cancelled: end.is_some_and(|end| end.cancelled),
                milliseconds: end.map_or(0.0, |end| end.took.as_secs_f64() * 1e3),
            });
        }
        self.out.show(self.shown.values());
        let objects = hashes(&self.shown);
        self.out.say(&Event::Preview { solution: self.number, draft: false, objects });
        self.tell_model();
        self.tell_seen(hashes(&self.seen.objects), false);
    }

    /// Draws what is due.
    pub(super) fn draw(&mut self) {
        if !self.drafts.is_due() {
            return;
        }
        let previews = self.drafts.draw(&self.engine, || true);
        let mut changed = Vec::new();
        for Preview { object, geometry, left_out } in previews {
            if changes(&mut self.shown, object, geometry) {
                changed.push(object);
            }
            self.complain(object, left_out);
        }
        if changed.is_empty() {
            return;
        }
        self.out.show(changed.iter().filter_map(|id| self.shown.get(id)));
        let hash = |id: &Uuid| (*id, self.shown.get(id).map(|geometry| geometry.hash.clone()));
        let objects = changed.iter().map(hash).collect();
        let draft = self.drafts.is_draft();
        self.out.say(&Event::Preview { solution: self.number, draft, objects });
    }

    /// Says what cannot be shown, once.
    fn complain(&mut self, object: Uuid, left_out: Vec<String>) {
        if left_out.is_empty() {
            self.left_out.remove(&object);
        } else if self.left_out.get(&object) != Some(&left_out) {
            for text in left_out.iter().take(MOST_COMPLAINTS) {
                self.notice("warning", text.clone());
            }
            self.left_out.insert(object, left_out);
        }
    }

    /// Draws the Rhino model where it is due.
    pub(super) fn show_model(&mut self) {
        if !std::mem::take(&mut self.is_model_due) {
            return;
        }
        let options = self.engine.options();
        let drawn = options.model.as_ref().and_then(|model| encode_model(model, &options.rules, || true));
        let (Some(ModelPreview { view, geometries }), Some((name, _))) = (drawn, &self.model) else { return };
        self.model_view = Some(ModelView { name: name.clone(), ..view });
        self.model_geometry = geometries.into_iter().map(named).collect();
        self.tell_model();
    }

    pub(super) fn tell_model(&mut self) {
        self.out.show(self.model_geometry.iter());
        self.out.say(&Event::Model { model: self.model_view.clone() });
    }

    /// Takes the Rhino model away.
    pub(super) fn detach(&mut self) {
        self.engine.options_mut().model = None;
        self.engine.forget();
        (self.model, self.model_view) = (None, None);
        self.model_geometry.clear();
        self.tell_model();
        self.want(super::work::Work::Solve);
    }

    /// Looks at the form of curves and surfaces where that is due.
    pub(super) fn look(&mut self) {
        if !self.analyses.is_due() {
            return;
        }
        for (_, found) in self.analyses.look(&self.engine, || true) {
            match found {
                Finding::Analysed(Analysed { is_draft, objects, about }) => {
                    let mut changed = Vec::new();
                    for (object, geometry) in objects {
                        if changes(&mut self.seen.objects, object, geometry) {
                            changed.push(object);
                        }
                    }
                    self.seen.about = Some(about);
                    let hash = |id: Uuid| (id, self.seen.objects.get(&id).map(|one| one.hash.clone()));
                    let objects = changed.into_iter().map(hash).collect();
                    self.tell_seen(objects, is_draft);
                }
                Finding::Probed(round, probes) => {
                    self.out.say(&Event::Probed { solution: self.number, round, probes });
                }
            }
        }
    }

    fn tell_seen(&mut self, objects: Hashes, draft: bool) {
        let Some(About { comb, left_out }) = self.seen.about.clone() else { return };
        self.out.show(objects.iter().filter_map(|(id, _)| self.seen.objects.get(id)));
        self.out.say(&Event::Analysed { solution: self.number, draft, objects, comb, left_out });
    }
}
