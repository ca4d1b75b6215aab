//! What rewrites paths and leaves the items where they are, and the joining of trees.

use katydid_geometry::CancellationToken;

use crate::{Column, Path, Tree};

impl Tree {
    /// All items in one branch at `path`, in order. No data stays no data.
    #[must_use]
    pub fn flatten_to(&self, path: Path) -> Self {
        if self.is_empty() {
            return self.clone();
        }
        Self::branch_at(path, self.column.clone())
    }

    /// All items in one branch at `{0}`.
    #[must_use]
    pub fn flatten(&self) -> Self {
        self.flatten_to(Path::zero())
    }

    /// Every item in a branch of its own: item i of `{p}` goes to `{p;i}`. An empty branch stays as it is.
    #[must_use]
    pub fn graft(&self) -> Self {
        // Whoever has this done looks whether to go on.
        if !CancellationToken::has_room(
            self.item_count().saturating_mul(size_of::<Path>() + size_of::<usize>()),
        ) {
            return Self::empty();
        }
        let mut paths = Vec::with_capacity(self.item_count());
        let mut ends = Vec::with_capacity(self.item_count());
        for branch in self.branches() {
            let range = branch.range();
            if range.is_empty() {
                paths.push(branch.path().clone());
                ends.push(range.end);
            }
            for (i, at) in range.enumerate() {
                paths.push(branch.path().child(i));
                ends.push(at + 1);
            }
        }
        Self::from_parts(paths, ends, self.column.clone())
    }

    /// The tree without the path elements that are equal in all branches: everywhere, or with `front` only
    /// those before the first that differs. A single branch goes to `{0}`, and no path loses all its elements.
    #[must_use]
    pub fn simplify(&self, front: bool) -> Self {
        let Some(first) = self.paths.first() else { return self.clone() };
        if self.branch_count() == 1 {
            return Self::branch_at(Path::zero(), self.column.clone());
        }
        let shortest = self.paths.iter().map(Path::len).min().unwrap_or(0);
        let same_length = self.paths.iter().all(|p| p.len() == first.len());
        let is_shared = |k: usize| self.paths.iter().all(|p| p.elements().get(k) == first.elements().get(k));
        let shared: Vec<bool> = (0..shortest).map(is_shared).collect();
        // Elements at equal places can be told apart from the front only, unless all paths have one length.
        let lead = shared.iter().take_while(|shared| **shared).count();
        let drop = |k: usize| if front || !same_length { k < lead } else { shared.get(k) == Some(&true) };
        let paths: Vec<Path> = self
            .paths
            .iter()
            .map(|path| {
                let kept: Path =
                    path.elements().iter().enumerate().filter(|&(k, _)| !drop(k)).map(|(_, &e)| e).collect();
                if kept.is_empty() { path.elements().last().copied().into_iter().collect() } else { kept }
            })
            .collect();
        Self::from_parts(paths, self.ends.clone(), self.column.clone())
    }

    /// Every branch with its items in reverse order.
    #[must_use]
    pub fn reverse_branches(&self) -> Self {
        let indices: Vec<usize> = (0..self.branch_count()).flat_map(|b| self.range(b).rev()).collect();
        Self { paths: self.paths.clone(), ends: self.ends.clone(), column: self.column.gather(&indices) }
    }

    /// The same branches under other paths, given in branch order; equal ones are joined.
    #[must_use]
    pub fn with_paths(&self, paths: Vec<Path>) -> Self {
        if paths.len() != self.branch_count() {
            return self.clone();
        }
        Self::from_parts(paths, self.ends.clone(), self.column.clone())
    }

    /// The branches of all trees together: equal paths are joined, in the order of the trees.
    pub fn merge<'a>(trees: impl IntoIterator<Item = &'a Self>) -> Self {
        let trees: Vec<&Self> = trees.into_iter().filter(|t| !t.is_empty()).collect();
        if let [one] = trees.as_slice() {
            return (*one).clone();
        }
        let mut paths = Vec::new();
        let mut ends = Vec::new();
        let mut offset = 0;
        for tree in &trees {
            paths.extend(tree.paths.iter().cloned());
            ends.extend(tree.ends.iter().map(|end| end + offset));
            offset += tree.item_count();
        }
        let columns: Vec<&Column> = trees.iter().map(|t| &t.column).collect();
        Self::from_parts(paths, ends, Column::concat(&columns))
    }

    /// The branches for which `keep` says so.
    #[must_use]
    pub fn filter_branches(&self, mut keep: impl FnMut(usize) -> bool) -> Self {
        let kept: Vec<usize> = (0..self.branch_count()).filter(|&b| keep(b)).collect();
        if kept.len() == self.branch_count() {
            return self.clone();
        }
        let mut paths = Vec::with_capacity(kept.len());
        let mut ends = Vec::with_capacity(kept.len());
        let mut indices = Vec::new();
        for b in kept {
            indices.extend(self.range(b));
            paths.extend(self.paths.get(b).cloned());
            ends.push(indices.len());
        }
        Self::from_parts(paths, ends, self.column.gather(&indices))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{TreeBuilder, Value};

    fn tree(branches: &[(&[i32], &[f64])]) -> Tree {
        let mut builder = TreeBuilder::<f64>::new();
        for (path, items) in branches {
            builder.branch(Path::from(*path));
            for &item in *items {
                builder.push(Some(item));
            }
        }
        builder.finish()
    }

    fn shape(tree: &Tree) -> Vec<(String, usize)> {
        tree.branches().map(|b| (b.path().to_string(), b.len())).collect()
    }

    #[test]
    fn graft_adds_the_item_index() {
        let t = tree(&[(&[0], &[1.0, 2.0]), (&[1], &[]), (&[2], &[3.0])]).graft();
        let expected = [("{0;0}", 1), ("{0;1}", 1), ("{1}", 0), ("{2;0}", 1)];
        assert_eq!(shape(&t), expected.map(|(p, n)| (p.to_owned(), n)));
    }

    #[test]
    fn flatten_goes_to_zero_and_no_data_stays_no_data() {
        assert_eq!(shape(&tree(&[(&[3, 1], &[1.0]), (&[3, 2], &[2.0])]).flatten()), [("{0}".to_owned(), 2)]);
        assert!(Tree::empty().flatten().is_empty());
    }

    #[test]
    fn simplify_drops_what_all_paths_share() {
        let t = tree(&[(&[0, 0, 0], &[1.0]), (&[0, 0, 1], &[2.0])]);
        assert_eq!(shape(&t.simplify(false)), [("{0}".to_owned(), 1), ("{1}".to_owned(), 1)]);
        let tail = tree(&[(&[0, 0, 5], &[1.0]), (&[0, 1, 5], &[2.0])]);
        assert_eq!(shape(&tail.simplify(false)), [("{0}".to_owned(), 1), ("{1}".to_owned(), 1)]);
        assert_eq!(shape(&tail.simplify(true)), [("{0;5}".to_owned(), 1), ("{1;5}".to_owned(), 1)]);
        assert_eq!(shape(&tree(&[(&[0, 4, 0], &[1.0])]).simplify(false)), [("{0}".to_owned(), 1)]);
    }

    #[test]
    fn merging_joins_equal_paths_in_order() {
        let a = tree(&[(&[0], &[1.0]), (&[2], &[2.0])]);
        let b = tree(&[(&[0], &[3.0]), (&[1], &[4.0])]);
        let m = Tree::merge([&a, &b]);
        let expected = [("{0}", 2), ("{1}", 1), ("{2}", 1)];
        assert_eq!(shape(&m), expected.map(|(p, n)| (p.to_owned(), n)));
        assert_eq!(
            m.branch(0).unwrap().iter().collect::<Vec<_>>(),
            [1.0, 3.0].map(|x| Some(Value::Number(x)))
        );
    }

    fn any_tree() -> impl Strategy<Value = Tree> {
        let branch = (prop::collection::vec(0..3i32, 1..4), prop::collection::vec(-9.0..9.0, 0..4));
        prop::collection::vec(branch, 0..6).prop_map(|branches| {
            let mut builder = TreeBuilder::<f64>::new();
            for (path, items) in branches {
                builder.branch(Path::from(path.as_slice()));
                items.into_iter().for_each(|x| builder.push(Some(x)));
            }
            builder.finish()
        })
    }

    proptest! {
        #[test]
        fn every_shape_change_keeps_all_items(t in any_tree()) {
            for changed in [t.flatten(), t.graft(), t.simplify(false), t.simplify(true), t.reverse_branches()] {
                prop_assert_eq!(changed.item_count(), t.item_count());
                prop_assert!(changed.paths().is_sorted_by(|a, b| a < b));
            }
            prop_assert_eq!(t.reverse_branches().reverse_branches(), t.clone());
            // Among paths of several lengths a grafted branch can move behind one that it stood before.
            if t.paths().iter().all(|p| p.len() == t.paths()[0].len()) {
                prop_assert_eq!(t.graft().flatten(), t.flatten());
            }
        }

        #[test]
        fn merging_is_associative(a in any_tree(), b in any_tree(), c in any_tree()) {
            prop_assert_eq!(Tree::merge([&Tree::merge([&a, &b]), &c]), Tree::merge([&a, &Tree::merge([&b, &c])]));
        }
    }
}
