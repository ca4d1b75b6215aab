use std::marker::PhantomData;
use std::ops::Range;

use katydid_data::{Column, Item, Tree, Value};
use smallvec::SmallVec;

/// Tells the lists of a call apart; see [`List::key`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ListKey {
    column: usize,
    range: Range<usize>,
}

/// One branch of a port with list access.
#[derive(Debug, Clone)]
pub struct List<'a, T: Item> {
    column: &'a Column,
    range: Range<usize>,
    items: PhantomData<T>,
}

impl<'a, T: Item> List<'a, T> {
    pub(crate) fn new(column: &'a Column, range: Range<usize>) -> Self {
        Self { column, range, items: PhantomData }
    }

    /// The number of places, nulls included.
    pub fn len(&self) -> usize {
        self.range.len()
    }

    /// Whether the list has no places.
    pub fn is_empty(&self) -> bool {
        self.range.is_empty()
    }

    /// Item `i`; `None` where it is null and outside.
    #[inline]
    pub fn get(&self, i: usize) -> Option<T> {
        let at = self.range.start.checked_add(i)?;
        if at < self.range.end { T::get(self.column, at) } else { None }
    }

    /// The items in order, nulls as `None`.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = Option<T>> + ExactSizeIterator + use<'_, T> {
        self.range.clone().map(|i| T::get(self.column, i))
    }

    /// The items that are not null, in order.
    pub fn present(&self) -> impl DoubleEndedIterator<Item = T> + use<'_, T> {
        self.iter().flatten()
    }

    /// The items as they lie, when there is no null among them.
    pub fn as_slice(&self) -> Option<&'a [T]> {
        self.slice_of()
    }

    /// The items as they lie, when all are of type `U` and there is no null among them.
    pub fn slice_of<U: Item>(&self) -> Option<&'a [U]> {
        let no_nulls = self
            .column
            .null_mask()
            .is_none_or(|n| n.get(self.range.clone()).is_some_and(|n| !n.contains(&true)));
        if no_nulls { U::slice(self.column)?.get(self.range.clone()) } else { None }
    }

    /// Which list it is: the same for every iteration of a call that is given the same branch, and for no other.
    pub fn key(&self) -> ListKey {
        ListKey { column: std::ptr::from_ref(self.column).addr(), range: self.range.clone() }
    }

    /// All items with their gaps.
    pub fn to_vec(&self) -> Vec<Option<T>> {
        self.iter().collect()
    }
}

impl List<'_, Value> {
    /// The items at `indices`, as a column of their own; an index outside gives a null.
    pub fn gather(&self, indices: &[usize]) -> Column {
        let Range { start, end } = self.range;
        if start == 0 && end == self.column.len() {
            return self.column.gather(indices);
        }
        // Beyond the list the column goes on.
        let place = |i: &usize| start.checked_add(*i).filter(|&at| at < end).unwrap_or(usize::MAX);
        self.column.gather(&indices.iter().map(place).collect::<Vec<_>>())
    }
}

/// The items of the ports that one port stands for, in port order; `None` for a port without data or a null.
pub type ManyItems<T> = SmallVec<[Option<T>; 4]>;
/// The lists of the ports that one port stands for, in port order; empty for a port without data.
pub type ManyLists<'a, T> = SmallVec<[List<'a, T>; 4]>;
/// The trees of the ports that one port stands for, in port order.
pub type ManyTrees<'a> = SmallVec<[&'a Tree; 4]>;

/// The data of one iteration.
#[derive(Debug)]
pub struct Row<'a> {
    pub(crate) inputs: &'a [Tree],
    /// Where this branch set's branch of each input lies.
    pub(crate) ranges: &'a [Range<usize>],
    /// The number of the iteration in the branch set.
    pub(crate) i: usize,
}

impl<'a> Row<'a> {
    /// The item of input `k`: the last one again when the list is shorter than the others.
    #[inline]
    pub fn item<T: Item>(&self, k: usize) -> Option<T> {
        let range = self.ranges.get(k)?;
        let last = range.len().checked_sub(1)?;
        T::get(self.inputs.get(k)?.column(), range.start + self.i.min(last))
    }

    /// The branch of input `k`.
    pub fn list<T: Item>(&self, k: usize) -> List<'a, T> {
        static NONE: std::sync::LazyLock<Column> = std::sync::LazyLock::new(Column::empty);
        match (self.inputs.get(k), self.ranges.get(k)) {
            (Some(tree), Some(range)) => List::new(tree.column(), range.clone()),
            _ => List::new(&NONE, 0..0),
        }
    }

    /// All data of input `k`.
    pub fn tree(&self, k: usize) -> &'a Tree {
        static NONE: std::sync::LazyLock<Tree> = std::sync::LazyLock::new(Tree::empty);
        self.inputs.get(k).unwrap_or(&NONE)
    }

    /// The items of input `k` and all behind it.
    pub fn many_items<T: Item>(&self, k: usize) -> ManyItems<T> {
        (k..self.inputs.len()).map(|k| self.item(k)).collect()
    }

    /// The branches of input `k` and all behind it.
    pub fn many_lists<T: Item>(&self, k: usize) -> ManyLists<'a, T> {
        (k..self.inputs.len()).map(|k| self.list(k)).collect()
    }

    /// The trees of input `k` and all behind it.
    pub fn many_trees(&self, k: usize) -> ManyTrees<'a> {
        (k..self.inputs.len()).map(|k| self.tree(k)).collect()
    }
}
