//! From the numbers by which an archive refers to entries of its tables to places in lists.

use std::collections::HashMap;

/// The numbers of one table's entries.
#[derive(Debug, Default)]
pub(crate) struct Numbers {
    places: HashMap<usize, usize>,
    count: usize,
}

impl Numbers {
    /// Notes the number of the next entry. The first entry of a number is the one that is meant.
    pub(crate) fn push(&mut self, number: i32) {
        if let Ok(number) = usize::try_from(number) {
            self.places.entry(number).or_insert(self.count);
        }
        self.count += 1;
    }

    /// The place of the entry that a number means.
    pub(crate) fn find(&self, number: usize) -> Option<usize> {
        self.places.get(&number).copied()
    }
}

/// The numbers of all tables that attributes and layers refer to.
#[derive(Debug, Default)]
pub(crate) struct Places {
    pub(crate) layers: Numbers,
    pub(crate) materials: Numbers,
    pub(crate) linetypes: Numbers,
    pub(crate) groups: Numbers,
}
