//! The geometry that scripts hold, by number.

use std::collections::HashMap;

use crate::Fault;
use crate::shape::{Geometry, Shape};

/// The most objects that scripts may hold at once.
const MOST: usize = 4_000_000;

#[derive(Debug)]
struct Held {
    geometry: Geometry,
    /// How many lists of this object are held: `mesh.Vertices` outlives the script's `mesh`.
    lists: usize,
    /// Whether the script has let go of it.
    released: bool,
}

/// The geometry that scripts hold, by number. A number is never given twice.
#[derive(Debug, Default)]
pub struct Handles {
    last: u64,
    held: HashMap<u64, Held>,
}

impl Handles {
    /// A new number for geometry.
    ///
    /// # Errors
    /// Too much is held already.
    pub fn add(&mut self, shape: Shape) -> Result<u64, Fault> {
        self.hold(shape.into())
    }

    /// A new number for geometry with the texts that it carries.
    ///
    /// # Errors
    /// Too much is held already.
    pub fn add_geometry(&mut self, geometry: &Geometry) -> Result<u64, Fault> {
        self.hold(geometry.clone())
    }

    fn hold(&mut self, geometry: Geometry) -> Result<u64, Fault> {
        if self.held.len() >= MOST {
            return Err(Fault::too_large(format!("a script holds more than {MOST} objects")));
        }
        if let Shape::List(_, of) = &geometry.shape
            && let Some(owner) = self.held.get_mut(of)
        {
            owner.lists += 1;
        }
        self.last += 1;
        let geometry = Geometry { id: self.last, ..geometry };
        self.held.insert(self.last, Held { geometry, lists: 0, released: false });
        Ok(self.last)
    }

    /// What a number stands for.
    pub fn get(&self, id: u64) -> Option<&Shape> {
        self.held.get(&id).map(|held| &held.geometry.shape)
    }

    /// What a number stands for, with the texts that it carries.
    pub fn geometry(&self, id: u64) -> Option<Geometry> {
        self.held.get(&id).map(|held| held.geometry.clone())
    }

    /// Lets a number stand for something else. What it becomes keeps the texts, unless it brings its own.
    pub fn set(&mut self, id: u64, changed: Geometry) {
        if let Some(held) = self.held.get_mut(&id) {
            held.geometry.become_changed(changed);
        }
    }

    /// Forgets a number; an object that a list is of stays for as long as the list.
    pub fn release(&mut self, id: u64) {
        let Some(held) = self.held.get_mut(&id) else { return };
        if held.lists > 0 {
            held.released = true;
            return;
        }
        let gone = self.held.remove(&id).map(|held| held.geometry.shape);
        if let Some(Shape::List(_, of)) = gone
            && let Some(owner) = self.held.get_mut(&of)
        {
            owner.lists -= 1;
            if owner.released {
                self.release(of);
            }
        }
    }

    /// How many objects are held.
    pub fn len(&self) -> usize {
        self.held.len()
    }

    /// Whether nothing is held.
    pub fn is_empty(&self) -> bool {
        self.held.is_empty()
    }
}
