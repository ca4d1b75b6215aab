//! Sets of small numbers: which of the missing component types data hangs on.

/// So many numbers are told apart; those beyond share the last one, so that the size of a set has a bound.
const MOST: usize = 1024;

/// A set of numbers.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Causes(Vec<u64>);

impl Causes {
    /// Puts a number into it.
    pub(super) fn insert(&mut self, number: usize) {
        let number = number.min(MOST - 1);
        let word = number / 64;
        if self.0.len() <= word {
            self.0.resize(word + 1, 0);
        }
        if let Some(bits) = self.0.get_mut(word) {
            *bits |= 1 << (number % 64);
        }
    }

    /// Puts all numbers of another into it; tells whether one was new.
    pub(super) fn join(&mut self, other: &Self) -> bool {
        if self.0.len() < other.0.len() {
            self.0.resize(other.0.len(), 0);
        }
        let mut grew = false;
        for (own, new) in self.0.iter_mut().zip(&other.0) {
            grew |= *new & !*own != 0;
            *own |= new;
        }
        grew
    }

    /// Whether there is no number in it.
    pub(super) fn is_empty(&self) -> bool {
        self.0.iter().all(|bits| *bits == 0)
    }

    /// The numbers, the smallest first.
    pub(super) fn iter(&self) -> impl Iterator<Item = usize> {
        self.0.iter().enumerate().flat_map(|(word, bits)| {
            (0..64).filter(move |bit| bits >> bit & 1 == 1).map(move |bit| word * 64 + bit)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(numbers: &[usize]) -> Causes {
        let mut set = Causes::default();
        numbers.iter().for_each(|n| set.insert(*n));
        set
    }

    #[test]
    fn numbers_go_in_once() {
        let mut set = of(&[3, 200, 3]);
        assert_eq!(set.iter().collect::<Vec<_>>(), [3, 200]);
        assert!(!set.join(&of(&[200])));
        assert!(set.join(&of(&[64])));
        assert_eq!(set.iter().collect::<Vec<_>>(), [3, 64, 200]);
        assert!(of(&[]).is_empty() && !set.is_empty());
    }

    #[test]
    fn a_set_has_a_bound() {
        assert_eq!(of(&[usize::MAX, 5000]).iter().collect::<Vec<_>>(), [MOST - 1]);
    }
}
