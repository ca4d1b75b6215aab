//! Sets of variables that have values.

/// What is assigned at a point; everything, where the point cannot be reached.
#[derive(Debug, Clone, Default)]
pub(super) struct Assigned {
    words: Vec<u64>,
    dead: bool,
}

impl Assigned {
    /// At a point that cannot be reached.
    pub(super) fn dead() -> Self {
        Self { words: Vec::new(), dead: true }
    }

    /// The first so many.
    pub(super) fn all(count: usize) -> Self {
        Self { words: vec![u64::MAX; count.div_ceil(64)], dead: false }
    }

    pub(super) fn is_dead(&self) -> bool {
        self.dead
    }

    /// From here on nothing is reached.
    pub(super) fn die(&mut self) {
        self.dead = true;
    }

    pub(super) fn has(&self, at: usize) -> bool {
        self.dead || self.words.get(at / 64).is_some_and(|word| word >> (at % 64) & 1 == 1)
    }

    pub(super) fn set(&mut self, at: usize) {
        if self.words.len() <= at / 64 {
            self.words.resize(at / 64 + 1, 0);
        }
        self.words[at / 64] |= 1 << (at % 64);
    }

    pub(super) fn clear(&mut self, at: usize) {
        if let Some(word) = self.words.get_mut(at / 64) {
            *word &= !(1 << (at % 64));
        }
    }

    /// Two ways come together: what is assigned on both.
    pub(super) fn meet(&mut self, other: &Self) {
        if other.dead {
            return;
        }
        if self.dead {
            *self = other.clone();
            return;
        }
        self.words.truncate(other.words.len());
        for (word, with) in self.words.iter_mut().zip(&other.words) {
            *word &= with;
        }
    }

    /// Both ways are gone: what is assigned on one of them.
    pub(super) fn join(&mut self, other: &Self) {
        self.dead |= other.dead;
        if self.words.len() < other.words.len() {
            self.words.resize(other.words.len(), 0);
        }
        for (word, with) in self.words.iter_mut().zip(&other.words) {
            *word |= with;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Assigned;

    #[test]
    fn ways_meet_and_join() {
        let (mut a, mut b) = (Assigned::default(), Assigned::default());
        a.set(3);
        a.set(70);
        b.set(70);
        let mut both = a.clone();
        both.meet(&b);
        assert!(both.has(70) && !both.has(3), "only what both have");
        b.join(&a);
        assert!(b.has(70) && b.has(3), "what one has");
        both.meet(&Assigned::dead());
        assert!(both.has(70) && !both.has(3), "a way that is not gone changes nothing");
        let mut dead = Assigned::dead();
        assert!(dead.has(1000), "where nothing comes, everything is assigned");
        dead.meet(&a);
        assert!(!dead.has(1000) && dead.has(3), "the other way counts");
    }
}
