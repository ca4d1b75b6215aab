//! Which objects are to be drawn anew, and the drawing of them.

use std::collections::{HashMap, HashSet};

use katydid_definition::document::Document;
use katydid_session::display::{self, DRAFT_TRIANGLES, Fineness, Preview, Shown};
use katydid_solver::{Engine, Inputs};
use uuid::Uuid;

/// What of the geometry is up to date.
#[derive(Debug, Default)]
pub struct Drafts {
    /// The objects whose geometry is older than their data.
    stale: HashSet<Uuid>,
    /// The objects that were drawn more coarsely than the document asks for.
    coarse: HashSet<Uuid>,
    /// The objects that show something.
    drawn: HashSet<Uuid>,
    is_draft: bool,
    /// Whether drafts have the normals and curvatures of their surfaces.
    has_colours: bool,
}

impl Drafts {
    /// These objects have other data, or are shown otherwise.
    pub fn touch(&mut self, objects: impl IntoIterator<Item = Uuid>) {
        self.stale.extend(objects);
    }

    /// Everything is to be drawn anew.
    pub fn touch_all(&mut self, document: &Document) {
        self.stale.extend(document.objects.iter().map(|object| object.id));
    }

    /// Whether things are being dragged.
    pub fn set_draft(&mut self, is_draft: bool) {
        self.is_draft = is_draft;
    }

    /// Whether somebody looks at colours of curvatures, or at stripes.
    pub fn set_colours(&mut self, has_colours: bool) {
        self.has_colours = has_colours;
    }

    /// Whether what is drawn now is as coarse as it may be.
    pub fn is_draft(&self) -> bool {
        self.is_draft
    }

    /// Whether there is something to draw.
    pub fn is_due(&self) -> bool {
        !self.stale.is_empty() || !self.is_draft && !self.coarse.is_empty()
    }

    /// Draws what is due; what `go_on` denies stays due. Objects that are gone come back without geometry.
    pub fn draw(&mut self, engine: &Engine, go_on: impl Fn() -> bool + Sync) -> Vec<Preview> {
        let mut due = self.stale.clone();
        if !self.is_draft {
            due.extend(&self.coarse);
        }
        let document = engine.document();
        let mut previews = Vec::new();
        let places: HashMap<Uuid, usize> =
            document.objects.iter().enumerate().rev().map(|(at, object)| (object.id, at)).collect();
        let inputs = Inputs::new(engine);
        let mut read = Vec::new();
        let mut chosen = Vec::new();
        for id in due {
            let Some(&at) = places.get(&id) else {
                previews.push(Preview { object: id, geometry: None, left_out: Vec::new() });
                continue;
            };
            let Some(object) = document.objects.get(at) else { continue };
            match engine.report(at) {
                Some(report) if display::is_shown(object) => {
                    read.push(if display::draws_inputs(object) { inputs.of(at) } else { Vec::new() });
                    chosen.push((object, report));
                }
                None if display::is_shown(object) => {}
                _ => previews.push(Preview { object: id, geometry: None, left_out: Vec::new() }),
            }
        }
        let shown: Vec<Shown<'_>> = chosen
            .iter()
            .zip(&read)
            .map(|((object, report), inputs)| Shown { object, outputs: &report.outputs, inputs })
            .collect();
        let fineness = if self.is_draft {
            Fineness::Draft { triangles: DRAFT_TRIANGLES, exact: self.has_colours }
        } else {
            Fineness::of_document(document.header.preview_mesh_type)
        };
        previews.extend(display::encode(&shown, &engine.options().rules, fineness, go_on));
        previews.retain(|preview| self.note(preview));
        previews
    }

    /// Takes note of what was drawn; `false` for what showed nothing and still does.
    fn note(&mut self, preview: &Preview) -> bool {
        self.stale.remove(&preview.object);
        self.coarse.remove(&preview.object);
        if preview.geometry.as_ref().is_some_and(|geometry| geometry.is_draft) && self.is_draft {
            self.coarse.insert(preview.object);
        }
        if preview.geometry.is_some() {
            self.drawn.insert(preview.object);
            true
        } else {
            self.drawn.remove(&preview.object) || !preview.left_out.is_empty()
        }
    }
}
