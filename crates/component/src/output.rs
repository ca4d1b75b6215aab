//! Where results go: each kind of output collects what the iterations give, and makes a tree of it.

use katydid_data::{Column, Gather, Item, Path, Tree};

use crate::matching::Matching;

/// One result for each of the ports that an output port stands for, in port order.
#[derive(Debug, Clone, PartialEq)]
pub struct Each<T>(pub Vec<T>);

/// An item or a list, as a component's settings say. Without a list anywhere it is as with items; else every iteration
/// has a branch of its own, and an item or no result is a list of one.
#[derive(Debug, Clone, PartialEq)]
pub enum ItemOrList<T> {
    /// One item.
    Item(Option<T>),
    /// A list.
    List(Vec<Option<T>>),
}

/// Collects one output's results over a run of iterations.
#[doc(hidden)]
pub trait Sink: Send + Sized + 'static {
    /// What one iteration gives.
    type Result;

    /// Nothing yet. `ports` is the number of ports this output stands for.
    fn new(capacity: usize, ports: usize) -> Self;
    /// The result of the next iteration; `None` when it gave none.
    fn push(&mut self, result: Option<Self::Result>);
    /// The results of the iterations behind these.
    fn append(&mut self, other: Self);
    /// The number of items the result of one iteration holds, for the budget.
    fn count(result: &Self::Result) -> usize;
    /// The bytes that an item takes here; 0 where it is mostly shared with others.
    const ITEM_BYTES: usize;
    /// The bytes that the trees take besides what is here.
    fn finishing(&self, matching: &Matching<'_>) -> usize;
    /// The trees, one a port.
    fn finish(self, matching: &Matching<'_>) -> Vec<Tree>;
}

/// One item an iteration: all iterations of a branch set share its path.
#[derive(Debug)]
pub struct Items<T: Item>(Gather<T>);

impl<T: Item> Sink for Items<T> {
    type Result = Option<T>;
    const ITEM_BYTES: usize = size_of::<T>();

    fn new(capacity: usize, _: usize) -> Self {
        Self(Gather::with_capacity(capacity))
    }

    #[inline]
    fn push(&mut self, result: Option<Option<T>>) {
        self.0.push(result.flatten());
    }

    fn append(&mut self, other: Self) {
        self.0.append(other.0);
    }

    fn count(_: &Option<T>) -> usize {
        1
    }

    fn finishing(&self, _: &Matching<'_>) -> usize {
        0
    }

    fn finish(self, matching: &Matching<'_>) -> Vec<Tree> {
        vec![Tree::from_parts(matching.paths.clone(), matching.ends.clone(), self.0.finish())]
    }
}

/// The list that one iteration gives.
#[doc(hidden)]
#[derive(Debug, Clone)]
pub enum ListOf<T> {
    /// Without nulls.
    Full(Vec<T>),
    /// With nulls.
    Gaps(Vec<Option<T>>),
    /// As a column.
    Column(Column),
}

impl<T> ListOf<T> {
    fn len(&self) -> usize {
        match self {
            Self::Full(list) => list.len(),
            Self::Gaps(list) => list.len(),
            Self::Column(column) => column.len(),
        }
    }
}

/// A list an iteration: each goes to a branch of its own, one element longer when any input takes items.
#[derive(Debug)]
pub struct Lists<T: Item> {
    /// A first list that is a column already; nothing is gathered while it stands alone.
    whole: Option<Column>,
    items: Gather<T>,
    ends: Vec<usize>,
}

impl<T: Item> Lists<T> {
    fn len(&self) -> usize {
        self.whole.as_ref().map_or_else(|| self.items.len(), Column::len)
    }

    fn gather(&mut self) -> &mut Gather<T> {
        if let Some(column) = self.whole.take() {
            (0..column.len()).for_each(|i| self.items.push(T::get(&column, i)));
        }
        &mut self.items
    }
}

impl<T: Item> Sink for Lists<T> {
    type Result = ListOf<T>;
    const ITEM_BYTES: usize = size_of::<T>();

    fn new(_: usize, _: usize) -> Self {
        Self { whole: None, items: Gather::default(), ends: Vec::new() }
    }

    fn push(&mut self, result: Option<ListOf<T>>) {
        match result {
            Some(ListOf::Column(column)) if self.len() == 0 => self.whole = Some(column),
            Some(ListOf::Column(column)) => {
                let gather = self.gather();
                (0..column.len()).for_each(|i| gather.push(T::get(&column, i)));
            }
            Some(ListOf::Full(list)) => self.gather().extend(list),
            Some(ListOf::Gaps(list)) => {
                let gather = self.gather();
                list.into_iter().for_each(|item| gather.push(item));
            }
            None => {}
        }
        self.ends.push(self.len());
    }

    fn append(&mut self, mut other: Self) {
        let before = self.len();
        if self.ends.is_empty() {
            *self = other;
            return;
        }
        if before == 0 {
            self.whole = other.whole.take();
            self.items = other.items;
        } else {
            other.gather();
            self.gather().append(other.items);
        }
        self.ends.extend(other.ends.into_iter().map(|end| end + before));
    }

    fn count(result: &ListOf<T>) -> usize {
        result.len()
    }

    fn finishing(&self, matching: &Matching<'_>) -> usize {
        if matching.grows { self.ends.len().saturating_mul(size_of::<Path>()) } else { 0 }
    }

    fn finish(self, matching: &Matching<'_>) -> Vec<Tree> {
        let column = self.whole.unwrap_or_else(|| self.items.finish());
        vec![list_tree(column, self.ends, matching)]
    }
}

/// An item or a list an iteration.
#[derive(Debug)]
pub struct ItemsOrLists<T: Item> {
    items: Gather<T>,
    ends: Vec<usize>,
    /// Whether any iteration gave a list.
    lists: bool,
}

impl<T: Item> Sink for ItemsOrLists<T> {
    type Result = ItemOrList<T>;
    const ITEM_BYTES: usize = size_of::<T>();

    fn new(capacity: usize, _: usize) -> Self {
        Self { items: Gather::with_capacity(capacity), ends: Vec::with_capacity(capacity), lists: false }
    }

    fn push(&mut self, result: Option<ItemOrList<T>>) {
        match result {
            Some(ItemOrList::Item(item)) => self.items.push(item),
            Some(ItemOrList::List(list)) => {
                self.lists = true;
                list.into_iter().for_each(|item| self.items.push(item));
            }
            None => self.items.push(None),
        }
        self.ends.push(self.items.len());
    }

    fn append(&mut self, other: Self) {
        let before = self.items.len();
        self.items.append(other.items);
        self.ends.extend(other.ends.into_iter().map(|end| end + before));
        self.lists |= other.lists;
    }

    fn count(result: &ItemOrList<T>) -> usize {
        match result {
            ItemOrList::Item(_) => 1,
            ItemOrList::List(list) => list.len(),
        }
    }

    fn finishing(&self, matching: &Matching<'_>) -> usize {
        let grows = self.lists && matching.grows;
        if grows { self.ends.len().saturating_mul(size_of::<Path>()) } else { 0 }
    }

    fn finish(self, matching: &Matching<'_>) -> Vec<Tree> {
        if self.lists {
            return vec![list_tree(self.items.finish(), self.ends, matching)];
        }
        Items(self.items).finish(matching)
    }
}

/// Lists, given by where each ends, at the paths that the iterations have.
fn list_tree(column: Column, ends: Vec<usize>, matching: &Matching<'_>) -> Tree {
    if !matching.grows {
        // Where no input takes items a branch set is one iteration.
        return Tree::from_parts(matching.paths.clone(), ends, column);
    }
    let mut paths = Vec::with_capacity(ends.len());
    for (set, path) in matching.paths.iter().enumerate() {
        paths.extend((0..matching.set_range(set).len()).map(|i| path.child(i)));
    }
    Tree::from_parts(paths, ends, column)
}

/// A tree of its own of few items takes some hundred bytes: so many are joined at a time, while the others come.
const FEW: usize = 1024;

/// A whole tree an iteration; those of several iterations are joined.
#[derive(Debug, Default)]
pub struct Trees {
    trees: Vec<Tree>,
    /// How many of the last are small and not joined yet.
    small: usize,
}

impl Trees {
    /// The small ones at the end become one. Whether some trees are joined before the others makes no difference:
    /// those of equal paths follow one another as before.
    fn join(&mut self) {
        if self.small > 1 {
            let first = self.trees.len().saturating_sub(self.small);
            let joined = Tree::merge(self.trees.get(first..).unwrap_or_default());
            self.trees.truncate(first);
            self.trees.push(joined);
        }
        self.small = 0;
    }
}

impl Sink for Trees {
    type Result = Tree;
    const ITEM_BYTES: usize = 0;

    fn new(_: usize, _: usize) -> Self {
        Self::default()
    }

    fn push(&mut self, result: Option<Tree>) {
        let Some(tree) = result else { return };
        // What is large is mostly shared with an input: it is not copied before all are there.
        let is_small = tree.item_count().max(tree.branch_count()) <= FEW;
        if !is_small || self.small >= FEW {
            self.join();
        }
        self.small += usize::from(is_small);
        self.trees.push(tree);
    }

    fn append(&mut self, other: Self) {
        self.join();
        self.trees.extend(other.trees);
        self.small = other.small;
    }

    fn count(_: &Tree) -> usize {
        // A tree's items are mostly shared with an input; components that make new ones ask the budget.
        0
    }

    fn finishing(&self, _: &Matching<'_>) -> usize {
        let is_many = self.trees.len() > 1;
        let weights = self.trees.iter().filter(|_| is_many).map(Tree::copied_weight);
        weights.fold(0, usize::saturating_add)
    }

    fn finish(self, _: &Matching<'_>) -> Vec<Tree> {
        vec![Tree::merge(&self.trees)]
    }
}

macro_rules! each {
    ($(#[$doc:meta])* $name:ident, $sink:ty, $result:ty) => {
        $(#[$doc])*
        #[derive(Debug)]
        pub struct $name<T: Item>(Vec<$sink>, std::marker::PhantomData<T>);

        impl<T: Item> Sink for $name<T> {
            type Result = Vec<$result>;
            const ITEM_BYTES: usize = <$sink>::ITEM_BYTES;

            fn new(capacity: usize, ports: usize) -> Self {
                Self((0..ports).map(|_| <$sink>::new(capacity, 1)).collect(), std::marker::PhantomData)
            }

            fn push(&mut self, result: Option<Self::Result>) {
                let mut results = result.map(Vec::into_iter);
                for sink in &mut self.0 {
                    sink.push(results.as_mut().and_then(Iterator::next));
                }
            }

            fn append(&mut self, other: Self) {
                for (mine, theirs) in self.0.iter_mut().zip(other.0) {
                    mine.append(theirs);
                }
            }

            fn count(result: &Self::Result) -> usize {
                result.iter().map(<$sink>::count).sum()
            }

            fn finishing(&self, matching: &Matching<'_>) -> usize {
                self.0.iter().map(|sink| sink.finishing(matching)).fold(0, usize::saturating_add)
            }

            fn finish(self, matching: &Matching<'_>) -> Vec<Tree> {
                self.0.into_iter().flat_map(|sink| sink.finish(matching)).collect()
            }
        }
    };
}

each!(
    /// One item an iteration on each of several ports.
    EachItems, Items<T>, Option<T>
);
each!(
    /// One list an iteration on each of several ports.
    EachLists, Lists<T>, ListOf<T>
);

/// One tree an iteration on each of several ports.
#[derive(Debug)]
pub struct EachTrees(Vec<Trees>);

impl Sink for EachTrees {
    type Result = Vec<Tree>;
    const ITEM_BYTES: usize = 0;

    fn new(capacity: usize, ports: usize) -> Self {
        Self((0..ports).map(|_| Trees::new(capacity, 1)).collect())
    }

    fn push(&mut self, result: Option<Vec<Tree>>) {
        let mut results = result.map(Vec::into_iter);
        for sink in &mut self.0 {
            sink.push(results.as_mut().and_then(Iterator::next));
        }
    }

    fn append(&mut self, other: Self) {
        for (mine, theirs) in self.0.iter_mut().zip(other.0) {
            mine.append(theirs);
        }
    }

    fn count(_: &Vec<Tree>) -> usize {
        0
    }

    fn finishing(&self, matching: &Matching<'_>) -> usize {
        self.0.iter().map(|sink| sink.finishing(matching)).fold(0, usize::saturating_add)
    }

    fn finish(self, matching: &Matching<'_>) -> Vec<Tree> {
        self.0.into_iter().flat_map(|sink| sink.finish(matching)).collect()
    }
}

/// All outputs of a component side by side.
#[doc(hidden)]
pub trait Sinks: Send + Sized + 'static {
    /// What one iteration gives.
    type Results;
    /// Nothing yet; `ports` is the number of outputs the object has.
    fn new(capacity: usize, ports: usize) -> Self;
    /// The results of the next iteration.
    fn push(&mut self, results: Option<Self::Results>);
    /// The results of the iterations behind these.
    fn append(&mut self, other: Self);
    /// The number of items in the results of one iteration.
    fn count(results: &Self::Results) -> usize;
    /// The most bytes that an item of one of the outputs takes.
    const ITEM_BYTES: usize;
    /// The bytes that the results of one iteration take.
    fn bytes(results: &Self::Results) -> usize;
    /// The bytes that the trees take besides what is here.
    fn finishing(&self, matching: &Matching<'_>) -> usize;
    /// The trees of all outputs.
    fn finish(self, matching: &Matching<'_>) -> Vec<Tree>;
}

macro_rules! sinks {
    ($($name:ident $index:tt),*; $n:expr) => {
        impl<$($name: Sink),*> Sinks for ($($name,)*) {
            type Results = ($($name::Result,)*);
            const ITEM_BYTES: usize = {
                let mut most = 0;
                $(if $name::ITEM_BYTES > most {
                    most = $name::ITEM_BYTES;
                })*
                most
            };
            fn new(capacity: usize, ports: usize) -> Self {
                // Only the last output stands for many: it has what the others leave.
                let rest = (ports + 1).saturating_sub($n).max(1);
                ($($name::new(capacity, if $index + 1 == $n { rest } else { 1 }),)*)
            }

            #[inline]
            fn push(&mut self, results: Option<Self::Results>) {
                match results {
                    Some(results) => { $(self.$index.push(Some(results.$index));)* }
                    None => { $(self.$index.push(None);)* }
                }
            }
            fn append(&mut self, other: Self) {
                $(self.$index.append(other.$index);)*
            }
            fn count(results: &Self::Results) -> usize {
                0 $(+ $name::count(&results.$index))*
            }
            fn bytes(results: &Self::Results) -> usize {
                0 $(+ $name::count(&results.$index) * $name::ITEM_BYTES)*
            }
            fn finishing(&self, matching: &Matching<'_>) -> usize {
                [$(self.$index.finishing(matching)),*].into_iter().fold(0, usize::saturating_add)
            }

            fn finish(self, matching: &Matching<'_>) -> Vec<Tree> {
                let trees: [Vec<Tree>; $n] = [$(self.$index.finish(matching)),*];
                trees.into_iter().flatten().collect()
            }
        }
    };
}

/// A component without outputs.
impl Sinks for () {
    type Results = ();
    const ITEM_BYTES: usize = 0;
    fn new(_: usize, _: usize) -> Self {}
    fn push(&mut self, _: Option<()>) {}
    fn append(&mut self, (): Self) {}
    fn count((): &()) -> usize {
        0
    }
    fn bytes((): &()) -> usize {
        0
    }
    fn finishing(&self, _: &Matching<'_>) -> usize {
        0
    }
    fn finish(self, _: &Matching<'_>) -> Vec<Tree> {
        Vec::new()
    }
}

sinks!(A 0; 1);
sinks!(A 0, B 1; 2);
sinks!(A 0, B 1, C 2; 3);
sinks!(A 0, B 1, C 2, D 3; 4);
sinks!(A 0, B 1, C 2, D 3, E 4; 5);
sinks!(A 0, B 1, C 2, D 3, E 4, F 5; 6);
sinks!(A 0, B 1, C 2, D 3, E 4, F 5, G 6; 7);
sinks!(A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7; 8);
sinks!(A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7, I 8; 9);
sinks!(A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7, I 8, J 9; 10);
