//! The items of lists as numbers of the members they are.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::Arc;

use foldhash::fast::RandomState;
use katydid_component::List;
use katydid_data::{Column, Value};

use crate::sets::key::{Key, bits};

/// Lists whose items are numbers instead: equal items of all of them have the same one, counted from 0 in the order of
/// their first appearance. So sets of anything are sets of small integers, and an item is hashed once.
pub(super) struct Numbered<const N: usize> {
    /// The number of each item of each list; `None` for a null.
    pub(super) lists: [Vec<Option<usize>>; N],
    /// How many members there are in all lists together.
    pub(super) count: usize,
}

impl<const N: usize> Numbered<N> {
    /// What is equal is as in [`Key`]; texts and numbers by themselves are told apart without one.
    pub(super) fn of(lists: [&List<'_, Value>; N]) -> Self {
        let texts = lists.map(List::slice_of::<Arc<str>>);
        if texts.iter().all(Option::is_some) {
            return Self::by(texts.map(|list| list.unwrap_or_default().iter().map(|text| Some(&**text))));
        }
        let numbers = lists.map(List::slice_of::<f64>);
        if numbers.iter().all(Option::is_some) {
            return Self::by(numbers.map(|list| list.unwrap_or_default().iter().map(|x| Some(bits(*x)))));
        }
        let integers = lists.map(List::slice_of::<i32>);
        if integers.iter().all(Option::is_some) {
            return Self::by(integers.map(|list| list.unwrap_or_default().iter().copied().map(Some)));
        }
        Self::by(lists.map(|list| list.iter().map(|item| item.map(|item| Key::of(Some(&item))))))
    }

    fn by<K: Hash + Eq>(lists: [impl Iterator<Item = Option<K>>; N]) -> Self {
        let room = lists.iter().map(|list| list.size_hint().0).max().unwrap_or(0);
        let mut numbers: HashMap<K, usize, RandomState> =
            HashMap::with_capacity_and_hasher(room, RandomState::default());
        let mut number = |key| {
            let next = numbers.len();
            *numbers.entry(key).or_insert(next)
        };
        let lists = lists.map(|list| list.map(|key| key.map(&mut number)).collect());
        Self { lists, count: numbers.len() }
    }

    /// Which members are in list `k`, by their numbers.
    pub(super) fn within(&self, k: usize) -> Vec<bool> {
        let mut within = vec![false; self.count];
        for number in self.lists.get(k).into_iter().flatten().flatten() {
            if let Some(place) = within.get_mut(*number) {
                *place = true;
            }
        }
        within
    }

    /// The places in list `k` of the first items of the members for which `keep` says so, each member once over all
    /// calls with the same `seen`.
    pub(super) fn firsts(&self, k: usize, seen: &mut Seen, keep: impl Fn(usize) -> bool) -> Vec<usize> {
        let mut firsts = Vec::new();
        for (place, number) in self.lists.get(k).into_iter().flatten().enumerate() {
            if let Some(number) = number.filter(|number| keep(*number) && seen.is_first(*number)) {
                debug_assert!(number < self.count);
                firsts.push(place);
            }
        }
        firsts
    }

    /// No members that were seen.
    pub(super) fn none_seen(&self) -> Seen {
        Seen(vec![false; self.count])
    }
}

/// The members that came before.
pub(super) struct Seen(Vec<bool>);

impl Seen {
    fn is_first(&mut self, number: usize) -> bool {
        self.0.get_mut(number).is_some_and(|seen| !std::mem::replace(seen, true))
    }
}

/// The items of a list at some places, as one typed run where they have one type.
pub(super) fn picked(list: &List<'_, Value>, places: &[usize]) -> Column {
    let column = list.gather(places);
    match column.items() {
        katydid_data::Items::Values(_) => Column::of_options(column.iter().collect()),
        _ => column,
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    /// Sets of texts, numbers and integers go another way than those of several types: the answers are the same.
    #[test]
    fn plain_and_mixed_lists_agree() {
        let sets = ["Set Union", "Set Intersection", "Set Difference", "Set Difference (S)", "Set Majority"];
        let a = |i: i32| (i * 7) % 13;
        let b = |i: i32| (i * 5 + 3) % 11;
        for name in sets {
            let texts = |f: fn(i32) -> String| {
                let trial = Trial::of(name).list((0..20).map(|i| f(a(i)))).list((0..20).map(|i| f(b(i))));
                if name == "Set Majority" { trial.list((0..5).map(f)) } else { trial }.texts(0)
            };
            let numbers = Trial::of(name).list((0..20).map(a)).list((0..20).map(|i| f64::from(b(i))));
            let mixed = if name == "Set Majority" { numbers.list(0..5) } else { numbers };
            assert_eq!(texts(|i| i.to_string()), mixed.texts(0), "{name}");
        }
    }
}
