//! Trees put together branch by branch, whatever the order in which items come.

use std::collections::BTreeMap;

use katydid_data::{Branch, Path, Tree, TreeBuilder, Value};

/// Branches that are filled in any order; the tree has them in the order of their paths.
#[derive(Default)]
pub(crate) struct Branches(BTreeMap<Path, Vec<Option<Value>>>);

impl Branches {
    /// Adds an item to a branch.
    pub(crate) fn push(&mut self, path: Path, item: Option<Value>) {
        self.0.entry(path).or_default().push(item);
    }

    /// Adds a branch, or items to it.
    pub(crate) fn extend(&mut self, path: Path, items: impl IntoIterator<Item = Option<Value>>) {
        self.0.entry(path).or_default().extend(items);
    }

    pub(crate) fn tree(self) -> Tree {
        let mut builder = TreeBuilder::<Value>::new();
        for (path, items) in self.0 {
            builder.branch(path);
            items.into_iter().for_each(|item| builder.push(item));
        }
        builder.finish()
    }
}

/// A tree with the paths of another one, whose branches are filled anew.
pub(crate) fn refilled<'a, Items>(tree: &'a Tree, fill: impl Fn(usize, Branch<'a>) -> Items) -> Tree
where
    Items: IntoIterator<Item = Option<Value>>,
{
    let mut made = TreeBuilder::<Value>::new();
    for (place, branch) in tree.branches().enumerate() {
        made.branch(branch.path().clone());
        fill(place, branch).into_iter().for_each(|item| made.push(item));
    }
    made.finish()
}

/// All items of a tree, one branch after the other.
pub(crate) fn items(tree: &Tree) -> impl Iterator<Item = Option<Value>> {
    (0..tree.item_count()).map(|at| tree.column().get(at))
}

/// The items of a branch.
pub(crate) fn of(branch: &Branch<'_>) -> Vec<Option<Value>> {
    branch.iter().collect()
}
