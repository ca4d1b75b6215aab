//! What the worker drew, on its way to the clients.

use std::collections::HashMap;
use std::sync::Arc;

use katydid_session::display::Preview;
use katydid_studio::{About, Analysed};
use uuid::Uuid;

use super::ClientId;
use super::actor::Actor;
use crate::geometry::Geometry;

/// What a client sees of the form of curves and surfaces.
#[derive(Debug, Default)]
pub(super) struct Seen {
    pub(super) objects: HashMap<Uuid, Arc<Geometry>>,
    pub(super) about: About,
}

impl Actor {
    /// Tells clients the geometry that is new. Whether there is any.
    pub(super) fn publish_previews(&mut self, solution: u64, is_draft: bool, previews: Vec<Preview>) -> bool {
        let mut changes = Vec::new();
        for Preview { object, geometry, left_out } in previews {
            let before = self.shown.remove(&object);
            let now = geometry.map(|geometry| self.shared.geometries.keep(geometry.hash, geometry.bytes));
            let same =
                before.as_ref().map(|geometry| &geometry.hash) == now.as_ref().map(|geometry| &geometry.hash);
            if let Some(now) = &now {
                self.shown.insert(object, Arc::clone(now));
            }
            if let Some(before) = before.filter(|_| !same) {
                self.shared.geometries.release(before);
            }
            if !same {
                changes.push((object, now));
            }
            self.complain(object, left_out);
        }
        self.clients.iter().for_each(|client| client.outbox.previews(solution, is_draft, &changes));
        !changes.is_empty()
    }

    /// Tells a client the analysis that it wanted to see.
    pub(super) fn publish_analysis(&mut self, solution: u64, id: ClientId, found: Analysed) {
        let Some(client) = self.clients.get(id) else { return };
        let seen = self.analysed.entry(id).or_default();
        let mut changes = Vec::new();
        for (object, geometry) in found.objects {
            let now = geometry.map(|geometry| self.shared.geometries.keep(geometry.hash, geometry.bytes));
            let before = match &now {
                Some(now) => seen.objects.insert(object, Arc::clone(now)),
                None => seen.objects.remove(&object),
            };
            if before.as_ref().map(|geometry| &geometry.hash) != now.as_ref().map(|geometry| &geometry.hash) {
                changes.push((object, now));
                before.into_iter().for_each(|before| self.shared.geometries.release(before));
            }
        }
        seen.about = found.about;
        client.outbox.analysed(solution, found.is_draft, &changes, &seen.about);
    }

    /// Says what cannot be shown, once.
    fn complain(&mut self, object: Uuid, left_out: Vec<String>) {
        if left_out.is_empty() {
            self.left_out.remove(&object);
        } else if self.left_out.get(&object) != Some(&left_out) {
            for text in left_out.iter().take(3) {
                self.notice("warning", text.clone());
            }
            self.left_out.insert(object, left_out);
        }
    }
}
