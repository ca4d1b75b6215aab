//! From the numbers by which an archive refers to entries of its tables to places in lists.
//!
//! Entries state numbers of their own, but readers of today count: number 3 is the fourth entry, whatever it states.

/// The entries of one table.
#[derive(Debug, Default)]
pub(crate) struct Numbers {
    /// The place of each in its list; nothing for one that could not be read.
    places: Vec<Option<usize>>,
    count: usize,
}

impl Numbers {
    /// Notes the next entry.
    pub(crate) fn push(&mut self) {
        self.places.push(Some(self.count));
        self.count += 1;
    }

    /// Notes an entry that could not be read.
    pub(crate) fn skip(&mut self) {
        self.places.push(None);
    }

    /// The place of the entry that a number means.
    pub(crate) fn find(&self, number: usize) -> Option<usize> {
        self.places.get(number).copied().flatten()
    }

    /// The same, where a number beyond the last entry means the first.
    pub(crate) fn find_or_first(&self, number: usize) -> Option<usize> {
        self.places.get(number).or(self.places.first()).copied().flatten()
    }

    /// The same for a number inside an object: one below zero or beyond the last entry stays, −1 stands for an entry
    /// that could not be read.
    pub(crate) fn place(&self, number: i32) -> i32 {
        match usize::try_from(number).ok().and_then(|number| self.places.get(number)) {
            Some(Some(place)) => i32::try_from(*place).unwrap_or(number),
            Some(None) => -1,
            None => number,
        }
    }
}

/// The entries of all tables that attributes, layers and objects refer to.
#[derive(Debug, Default)]
pub(crate) struct Places {
    pub(crate) layers: Numbers,
    pub(crate) materials: Numbers,
    pub(crate) linetypes: Numbers,
    pub(crate) groups: Numbers,
    pub(crate) hatch_patterns: Numbers,
}
