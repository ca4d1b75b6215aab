//! Which items of several inputs meet: as when a component runs, once per branch set and in it once per item set,
//! where the last branch and the last item repeat.

use std::ops::Range;

use katydid_component::{Access, Matching, Ranges};
use katydid_data::{Column, Item, Path, Tree};

/// The data of one iteration.
pub(crate) struct Row<'a> {
    inputs: &'a [Tree],
    ranges: &'a [Range<usize>],
    /// The path that the component's results have in this iteration.
    pub(crate) path: &'a Path,
    /// The place of the iteration among those of its branch set.
    pub(crate) index: usize,
}

/// Calls `each` for every iteration that a component with these inputs makes.
pub(crate) fn for_each(inputs: &[Tree], access: &[Access], mut each: impl FnMut(&Row<'_>)) {
    let of = |k: usize| access.get(k).copied().unwrap_or(Access::Item);
    let access: Vec<Access> = (0..inputs.len()).map(of).collect();
    let matching = Matching::new(inputs, &access, None);
    let mut ranges = Ranges::new();
    for i in 0..matching.iterations() {
        let set = matching.set_of(i);
        let Some(path) = matching.paths().get(set) else { continue };
        let index = i - matching.set_range(set).start;
        matching.ranges(set, &mut ranges);
        each(&Row { inputs, ranges: &ranges, path, index });
    }
}

impl Row<'_> {
    /// The item of input `k`.
    pub(crate) fn item<T: Item>(&self, k: usize) -> Option<T> {
        let range = self.ranges.get(k)?;
        let last = range.len().checked_sub(1)?;
        T::get(self.inputs.get(k)?.column(), range.start + self.index.min(last))
    }

    /// The items of input `k`'s branch that are not null.
    pub(crate) fn list<T: Item>(&self, k: usize) -> Vec<T> {
        let column = |k: usize| self.inputs.get(k).map(Tree::column);
        let get =
            |column: &Column, range: &Range<usize>| range.clone().filter_map(|i| T::get(column, i)).collect();
        column(k).zip(self.ranges.get(k)).map(|(column, range)| get(column, range)).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_repeats() {
        let inputs = [Tree::list(vec![1.0, 2.0, 3.0]), Tree::list(vec![10.0, 20.0])];
        let mut seen = Vec::new();
        for_each(&inputs, &[Access::Item, Access::Item], |row| {
            seen.push((row.item::<f64>(0).unwrap(), row.item::<f64>(1).unwrap()));
        });
        assert_eq!(seen, [(1.0, 10.0), (2.0, 20.0), (3.0, 20.0)]);
        let mut lists = Vec::new();
        for_each(&[inputs[0].graft(), inputs[1].clone()], &[Access::List, Access::List], |row| {
            lists.push((row.list::<f64>(0), row.list::<f64>(1).len()));
        });
        assert_eq!(lists, [(vec![1.0], 2), (vec![2.0], 2), (vec![3.0], 2)]);
    }
}
