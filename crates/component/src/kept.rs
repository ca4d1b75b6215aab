//! What components keep from one solve to the next, where somebody looks on.
//!
//! A solve gives the same whatever was solved before it. The exception is a hand: who drags a particle of a solver pulls at
//! what is there now, not at what was there at first. Whoever lets hands in has such a store; a run without one has none.

use std::any::Any;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The most states that are kept: of those put in first the oldest go.
const MOST: usize = 16;

/// States of components, told apart by what their owners say of them.
#[derive(Debug, Default)]
pub struct Kept(Mutex<Vec<Box<dyn Any + Send>>>);

impl Kept {
    fn states(&self) -> MutexGuard<'_, Vec<Box<dyn Any + Send>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The state of that type that is meant; none when there is none.
    pub fn find<T: Any + Send + Clone>(&self, is_meant: impl Fn(&T) -> bool) -> Option<T> {
        self.states()
            .iter()
            .filter_map(|state| state.downcast_ref::<T>())
            .find(|state| is_meant(state))
            .cloned()
    }

    /// Takes the states of that type out that are meant.
    pub fn forget<T: Any>(&self, is_meant: impl Fn(&T) -> bool) {
        self.states().retain(|state| !state.downcast_ref::<T>().is_some_and(&is_meant));
    }

    /// Puts a state in.
    pub fn put<T: Any + Send>(&self, state: T) {
        let mut states = self.states();
        if states.len() >= MOST {
            states.remove(0);
        }
        states.push(Box::new(state));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_is_found_by_who_it_belongs_to() {
        let kept = Kept::default();
        kept.put(7_i32);
        kept.put("seven");
        kept.put(8_i32);
        assert_eq!(kept.find(|n: &i32| *n == 8), Some(8));
        kept.forget(|n: &i32| *n == 8);
        assert_eq!(kept.find(|n: &i32| *n == 8), None);
        assert_eq!(kept.find(|_: &&str| true), Some("seven"));
        assert_eq!(kept.find(|_: &f64| true), None);
    }

    #[test]
    fn the_oldest_states_go() {
        let kept = Kept::default();
        (0..40).for_each(|n: i32| kept.put(n));
        assert_eq!(kept.find(|n: &i32| *n == 23), None);
        assert_eq!(kept.find(|n: &i32| *n == 24), Some(24));
    }
}
