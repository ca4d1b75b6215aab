use std::ops::Range;
use std::sync::Arc as Shared;

use crate::{Column, Item, Path, Value};

/// A data tree: lists of items at paths. The branches stand in order of their paths, which are all different.
#[derive(Debug, Clone)]
pub struct Tree {
    pub(crate) paths: Shared<Vec<Path>>,
    /// Where each branch ends in the column; it begins where the one before ends.
    pub(crate) ends: Shared<Vec<usize>>,
    pub(crate) column: Column,
}

impl Default for Tree {
    fn default() -> Self {
        Self::empty()
    }
}

impl Tree {
    /// A tree without branches: no data at all.
    pub fn empty() -> Self {
        Self { paths: Shared::default(), ends: Shared::default(), column: Column::empty() }
    }

    /// One list at `{0}`.
    pub fn list<T: Item>(items: Vec<T>) -> Self {
        Self::branch_at(Path::zero(), T::column(items, None))
    }

    /// One item at `{0}`.
    pub fn item(value: Value) -> Self {
        Self::branch_at(Path::zero(), Column::of_values(vec![value], None))
    }

    /// One branch.
    pub fn branch_at(path: Path, column: Column) -> Self {
        Self { paths: Shared::new(vec![path]), ends: Shared::new(vec![column.len()]), column }
    }

    /// A tree of branches that already stand in order, each path once, over one column; paths and ends may be those of
    /// another tree. Falls back to sorting and joining when they do not.
    pub fn from_parts(
        paths: impl Into<Shared<Vec<Path>>>,
        ends: impl Into<Shared<Vec<usize>>>,
        column: Column,
    ) -> Self {
        Self::of_shared(paths.into(), ends.into(), column)
    }

    fn of_shared(paths: Shared<Vec<Path>>, ends: Shared<Vec<usize>>, column: Column) -> Self {
        let sound = paths.len() == ends.len()
            && ends.last().copied().unwrap_or(0) == column.len()
            && ends.is_sorted();
        debug_assert!(sound, "branch ends must rise to the column's length");
        if !sound {
            return Self::branch_at(Path::zero(), column);
        }
        let tree = Self { paths, ends, column };
        if tree.paths.is_sorted_by(|a, b| a < b) { tree } else { tree.sorted() }
    }

    /// The same branches in order of their paths, those of equal paths joined in the order they stood.
    fn sorted(self) -> Self {
        let mut order: Vec<usize> = (0..self.branch_count()).collect();
        order.sort_by(|&a, &b| self.paths[a].cmp(&self.paths[b]));
        let in_place = order.is_sorted();
        let mut paths: Vec<Path> = Vec::with_capacity(order.len());
        let mut ends: Vec<usize> = Vec::with_capacity(order.len());
        let mut indices = Vec::with_capacity(if in_place { 0 } else { self.column.len() });
        let mut total = 0;
        for b in order {
            let range = self.range(b);
            total += range.len();
            if !in_place {
                indices.extend(range);
            }
            if paths.last() == Some(&self.paths[b]) {
                if let Some(end) = ends.last_mut() {
                    *end = total;
                }
            } else {
                paths.push(self.paths[b].clone());
                ends.push(total);
            }
        }
        let column = if in_place { self.column } else { self.column.gather(&indices) };
        Self { paths: Shared::new(paths), ends: Shared::new(ends), column }
    }

    /// The paths, in order.
    pub fn paths(&self) -> &[Path] {
        &self.paths
    }

    /// The paths, for other trees that have the same.
    pub fn shared_paths(&self) -> &Shared<Vec<Path>> {
        &self.paths
    }

    /// Where each branch ends in the column, for other trees that have as long branches.
    pub fn shared_ends(&self) -> &Shared<Vec<usize>> {
        &self.ends
    }

    /// The number of branches.
    pub fn branch_count(&self) -> usize {
        self.paths.len()
    }

    /// The number of items in all branches, nulls included.
    pub fn item_count(&self) -> usize {
        self.column.len()
    }

    /// Whether there is no branch. A tree with an empty branch is not empty.
    pub fn is_empty(&self) -> bool {
        self.paths.is_empty()
    }

    /// All items of all branches.
    pub fn column(&self) -> &Column {
        &self.column
    }

    /// Where branch `b` lies in the column; an empty range for a branch that does not exist.
    #[inline]
    pub fn range(&self, b: usize) -> Range<usize> {
        let end = self.ends.get(b).copied().unwrap_or(0);
        let start = if b == 0 { 0 } else { self.ends.get(b - 1).copied().unwrap_or(0) };
        start.min(end)..end
    }

    /// Branch `b`.
    pub fn branch(&self, b: usize) -> Option<Branch<'_>> {
        Some(Branch { path: self.paths.get(b)?, tree: self, range: self.range(b) })
    }

    /// All branches in order.
    pub fn branches(&self) -> impl Iterator<Item = Branch<'_>> {
        (0..self.branch_count()).filter_map(|b| self.branch(b))
    }

    /// The same branches over other items, one for one.
    #[must_use]
    pub fn with_column(&self, column: Column) -> Self {
        debug_assert_eq!(column.len(), self.column.len(), "one item for each");
        if column.len() != self.column.len() {
            return self.clone();
        }
        Self { paths: self.paths.clone(), ends: self.ends.clone(), column }
    }
}

/// Trees are equal when their paths, branches, items and nulls are.
impl PartialEq for Tree {
    fn eq(&self, other: &Self) -> bool {
        self.paths == other.paths && self.ends == other.ends && self.column.iter().eq(other.column.iter())
    }
}

/// One list of a tree, with its path.
#[derive(Debug, Clone)]
pub struct Branch<'a> {
    path: &'a Path,
    tree: &'a Tree,
    range: Range<usize>,
}

impl<'a> Branch<'a> {
    /// The path of the branch.
    pub fn path(&self) -> &'a Path {
        self.path
    }

    /// Where it lies in the tree's column.
    pub fn range(&self) -> Range<usize> {
        self.range.clone()
    }

    /// The number of places, nulls included.
    pub fn len(&self) -> usize {
        self.range.len()
    }

    /// Whether the branch has no places.
    pub fn is_empty(&self) -> bool {
        self.range.is_empty()
    }

    /// Item `i` of the branch; `None` where it is null and outside.
    pub fn get(&self, i: usize) -> Option<Value> {
        let at = self.range.start.checked_add(i)?;
        if self.range.contains(&at) { self.tree.column.get(at) } else { None }
    }

    /// The items, nulls as `None`.
    pub fn iter(&self) -> impl Iterator<Item = Option<Value>> + use<'a> {
        let tree = self.tree;
        self.range.clone().map(move |i| tree.column.get(i))
    }
}

/// Builds a tree branch by branch, in any order; equal paths are joined in the order they were added.
#[derive(Debug, Clone)]
pub struct TreeBuilder<T: Item> {
    paths: Vec<Path>,
    ends: Vec<usize>,
    items: crate::Gather<T>,
}

impl<T: Item> Default for TreeBuilder<T> {
    fn default() -> Self {
        Self { paths: Vec::new(), ends: Vec::new(), items: crate::Gather::default() }
    }
}

impl<T: Item> TreeBuilder<T> {
    /// A tree without branches.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a branch; what is pushed from now on goes there.
    pub fn branch(&mut self, path: Path) {
        let end = self.items.len();
        self.paths.push(path);
        self.ends.push(end);
    }

    /// Adds an item, or a null, to the last branch; before any branch it opens `{0}`.
    pub fn push(&mut self, item: Option<T>) {
        if self.paths.is_empty() {
            self.branch(Path::zero());
        }
        self.items.push(item);
        if let Some(end) = self.ends.last_mut() {
            *end += 1;
        }
    }

    /// The tree.
    pub fn finish(self) -> Tree {
        Tree::from_parts(self.paths, self.ends, self.items.finish())
    }
}
