//! Who shows a document, and which part of it.

use std::collections::HashMap;
use std::sync::Arc;

use uuid::Uuid;

use super::{ClientId, Outbox};

/// Somebody who shows the document.
#[derive(Debug)]
pub(super) struct Client {
    pub(super) outbox: Arc<Outbox>,
    /// The clusters that lead to what it shows.
    pub(super) within: Vec<Uuid>,
    /// Whether something is dragged there.
    pub(super) drags: bool,
    /// The Grabs for which it drags particles.
    grabs: Vec<Uuid>,
    pub(super) standing: Standing,
}

impl Client {
    /// Notes that it drags a particle for a Grab, or has let it go.
    pub(super) fn holds(&mut self, grab: Uuid, is_held: bool) {
        self.grabs.retain(|held| *held != grab);
        if is_held {
            self.grabs.push(grab);
        }
    }
}

/// Whose page shows a document.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Standing {
    /// Whoever is at this machine: they answer for what runs on it.
    Owner,
    /// Somebody who joined from another.
    Guest,
}

/// All who show the document.
#[derive(Debug, Default)]
pub(super) struct Clients(HashMap<ClientId, Client>);

impl Clients {
    pub(super) fn join(&mut self, id: ClientId, outbox: Arc<Outbox>, standing: Standing) {
        self.0.insert(id, Client { outbox, within: Vec::new(), drags: false, grabs: Vec::new(), standing });
    }

    /// Somebody is gone; gives the Grabs for which it still dragged particles.
    pub(super) fn leave(&mut self, id: ClientId) -> Vec<Uuid> {
        self.0.remove(&id).map(|client| client.grabs).unwrap_or_default()
    }

    pub(super) fn get(&self, id: ClientId) -> Option<&Client> {
        self.0.get(&id)
    }

    pub(super) fn get_mut(&mut self, id: ClientId) -> Option<&mut Client> {
        self.0.get_mut(&id)
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &Client> {
        self.0.values()
    }

    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    /// Whether something is dragged anywhere.
    pub(super) fn drags(&self) -> bool {
        self.iter().any(|client| client.drags)
    }

    /// The parts of the document that are shown, each once.
    pub(super) fn places(&self) -> Vec<Vec<Uuid>> {
        let mut places: Vec<Vec<Uuid>> = self.iter().map(|client| client.within.clone()).collect();
        places.sort();
        places.dedup();
        places
    }

    /// Those who show that part.
    pub(super) fn at<'a>(&'a self, within: &'a [Uuid]) -> impl Iterator<Item = (ClientId, &'a Client)> {
        self.0.iter().filter(move |(_, client)| client.within == within).map(|(id, client)| (*id, client))
    }
}
