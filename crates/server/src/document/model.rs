//! The Rhino model beside a document, and what clients see of it.

use std::sync::Arc;

use katydid_component::RhinoModel;
use katydid_session::display::ModelPreview;
use katydid_session::protocol::{Event, ModelView};

use super::{Attached, Outbox};
use crate::geometry::{Geometries, Geometry};

/// The model beside a document, if there is one.
#[derive(Debug, Default)]
pub(super) struct Beside {
    attached: Option<Attached>,
    /// What clients see of it, once it is drawn.
    view: Option<ModelView>,
    /// The geometry of its layers: held as long as they are shown.
    geometries: Vec<Arc<Geometry>>,
}

impl Beside {
    pub(super) fn new(attached: Option<Attached>) -> Self {
        Self { attached, ..Self::default() }
    }

    /// Another model takes the place of the one before, which is shown until this one is drawn.
    pub(super) fn attach(&mut self, attached: Attached) {
        self.attached = Some(attached);
    }

    /// There is none any more.
    pub(super) fn detach(&mut self, all: &Geometries) {
        self.attached = None;
        self.view = None;
        self.release(all);
    }

    pub(super) fn model(&self) -> Option<&Arc<RhinoModel>> {
        self.attached.as_ref().map(|attached| &attached.model)
    }

    /// The name of its file.
    pub(super) fn name(&self) -> Option<&str> {
        self.attached.as_ref().map(|attached| attached.name.as_str())
    }

    /// Takes what was drawn of it; it may be gone by then.
    pub(super) fn show(&mut self, ModelPreview { view, geometries }: ModelPreview, all: &Geometries) {
        let Some(name) = self.attached.as_ref().map(|attached| attached.name.clone()) else { return };
        self.view = Some(ModelView { name, ..view });
        let now = geometries.into_iter().map(|geometry| all.keep(geometry.hash, geometry.bytes)).collect();
        std::mem::replace(&mut self.geometries, now).into_iter().for_each(|before| all.release(before));
    }

    /// Tells a client of it, or that there is none.
    pub(super) fn tell(&self, outbox: &Outbox) {
        outbox.put(Event::Model { model: self.view.clone() });
    }

    /// Nothing of it is shown any more.
    pub(super) fn release(&mut self, all: &Geometries) {
        self.geometries.drain(..).for_each(|geometry| all.release(geometry));
    }
}
