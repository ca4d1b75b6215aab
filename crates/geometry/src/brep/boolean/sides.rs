//! Which operands hold the places just behind and just before a part of a face. With a thousand operands each place lies
//! in few of them: these are listed.

/// The operands in which a place lies, in order.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Inside(Vec<usize>);

impl Inside {
    /// Whether an operand holds the place.
    pub(super) fn has(&self, operand: usize) -> bool {
        self.0.binary_search(&operand).is_ok()
    }

    /// Says of an operand whether it holds the place.
    pub(super) fn set(&mut self, operand: usize, inside: bool) {
        match (self.0.binary_search(&operand), inside) {
            (Err(place), true) => self.0.insert(place, operand),
            (Ok(place), false) => {
                self.0.remove(place);
            }
            _ => {}
        }
    }

    /// Whether no operand holds the place.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// For every one of so many operands whether it holds the place.
    pub(super) fn of_all(&self, count: usize) -> Vec<bool> {
        let mut out = vec![false; count];
        for operand in &self.0 {
            out.get_mut(*operand).into_iter().for_each(|inside| *inside = true);
        }
        out
    }
}

/// Where the two sides of a region lie.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Sides {
    /// The operands that hold the places just behind the region, on the side of its own operand.
    pub(super) behind: Inside,
    /// Those that hold the places just before it.
    pub(super) before: Inside,
}

impl Sides {
    /// Whether an operand's boundary is here: it holds one side alone.
    pub(super) fn is_on(&self, operand: usize) -> bool {
        self.behind.has(operand) != self.before.has(operand)
    }
}
