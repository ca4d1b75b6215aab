use std::cmp::Ordering;

use super::ItemValue;

/// A node of the tree: named items and further chunks.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chunk {
    /// The name. Chunks of one kind share it and differ in the index.
    pub name: String,
    /// The index, where the chunk has one.
    pub index: Option<i32>,
    /// The items, in the file's order.
    pub items: Vec<Item>,
    /// The chunks inside, in the file's order.
    pub chunks: Vec<Chunk>,
}

/// A named value in a chunk.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// The name.
    pub name: String,
    /// The index, where the item has one.
    pub index: Option<i32>,
    /// The value.
    pub value: ItemValue,
}

/// Name first, then index: the order in which Grasshopper writes.
fn order(a: (&str, Option<i32>), b: (&str, Option<i32>)) -> Ordering {
    a.0.cmp(b.0).then_with(|| a.1.cmp(&b.1))
}

impl Chunk {
    /// An empty chunk without index.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// An empty chunk with an index.
    pub fn indexed(name: impl Into<String>, index: i32) -> Self {
        Self { name: name.into(), index: Some(index), ..Self::default() }
    }

    /// The value of the first item of this name without index.
    pub fn item(&self, name: &str) -> Option<&ItemValue> {
        self.item_where(name, None)
    }

    /// The value of the first item of this name and index.
    pub fn item_at(&self, name: &str, index: i32) -> Option<&ItemValue> {
        self.item_where(name, Some(index))
    }

    fn item_where(&self, name: &str, index: Option<i32>) -> Option<&ItemValue> {
        self.items.iter().find(|item| item.index == index && item.name == name).map(|item| &item.value)
    }

    /// All items of this name that have an index, by rising index.
    pub fn list(&self, name: &str) -> Vec<(i32, &ItemValue)> {
        let mut list: Vec<_> = self
            .items
            .iter()
            .filter(|item| item.name == name)
            .filter_map(|item| item.index.map(|index| (index, &item.value)))
            .collect();
        list.sort_by_key(|(index, _)| *index);
        list
    }

    /// The first chunk of this name without index.
    pub fn child(&self, name: &str) -> Option<&Chunk> {
        self.chunks.iter().find(|chunk| chunk.index.is_none() && chunk.name == name)
    }

    /// The first chunk of this name and index.
    pub fn child_at(&self, name: &str, index: i32) -> Option<&Chunk> {
        self.chunks.iter().find(|chunk| chunk.index == Some(index) && chunk.name == name)
    }

    /// As [`child`](Self::child), to be changed.
    pub fn child_mut(&mut self, name: &str) -> Option<&mut Chunk> {
        self.chunks.iter_mut().find(|chunk| chunk.index.is_none() && chunk.name == name)
    }

    /// As [`child_at`](Self::child_at), to be changed.
    pub fn child_at_mut(&mut self, name: &str, index: i32) -> Option<&mut Chunk> {
        self.chunks.iter_mut().find(|chunk| chunk.index == Some(index) && chunk.name == name)
    }

    /// All chunks of this name that have an index, by rising index.
    pub fn children(&self, name: &str) -> Vec<&Chunk> {
        let mut list: Vec<_> =
            self.chunks.iter().filter(|chunk| chunk.index.is_some() && chunk.name == name).collect();
        list.sort_by_key(|chunk| chunk.index);
        list
    }

    /// Gives the item of this name a value. An item that is there keeps its place; a new one goes where the
    /// order by name wants it.
    pub fn set(&mut self, name: &str, value: impl Into<ItemValue>) {
        self.set_where(name, None, value.into());
    }

    /// As [`set`](Self::set), for an item with index.
    pub fn set_at(&mut self, name: &str, index: i32, value: impl Into<ItemValue>) {
        self.set_where(name, Some(index), value.into());
    }

    fn set_where(&mut self, name: &str, index: Option<i32>, value: ItemValue) {
        if let Some(item) = self.items.iter_mut().find(|item| item.index == index && item.name == name) {
            item.value = value;
            return;
        }
        let after = |item: &Item| order((&item.name, item.index), (name, index)) == Ordering::Greater;
        let at = self.items.iter().position(after).unwrap_or(self.items.len());
        self.items.insert(at, Item { name: name.to_owned(), index, value });
    }

    /// Takes out every item of this name, with and without index; whether there was any.
    pub fn remove(&mut self, name: &str) -> bool {
        let before = self.items.len();
        self.items.retain(|item| item.name != name);
        self.items.len() != before
    }

    /// Puts a chunk in the place of the one with the same name and index, or where the order by name wants it.
    pub fn set_child(&mut self, chunk: Chunk) {
        let key = (chunk.name.as_str(), chunk.index);
        if let Some(old) = self.chunks.iter_mut().find(|old| (old.name.as_str(), old.index) == key) {
            *old = chunk;
            return;
        }
        let at = self.place(key);
        self.chunks.insert(at, chunk);
    }

    /// Where a new chunk goes.
    fn place(&self, key: (&str, Option<i32>)) -> usize {
        let after = |other: &Chunk| order((&other.name, other.index), key) == Ordering::Greater;
        self.chunks.iter().position(after).unwrap_or(self.chunks.len())
    }

    /// Takes out every chunk of this name, with and without index; whether there was any.
    pub fn remove_children(&mut self, name: &str) -> bool {
        let before = self.chunks.len();
        self.chunks.retain(|chunk| chunk.name != name);
        self.chunks.len() != before
    }

    /// How many chunks and items stand in the tree, this chunk included.
    pub fn count_nodes(&self) -> usize {
        1 + self.items.len() + self.chunks.iter().map(Chunk::count_nodes).sum::<usize>()
    }
}

impl Item {
    /// An item without index.
    pub fn new(name: impl Into<String>, value: impl Into<ItemValue>) -> Self {
        Self { name: name.into(), index: None, value: value.into() }
    }

    /// An item with an index.
    pub fn indexed(name: impl Into<String>, index: i32, value: impl Into<ItemValue>) -> Self {
        Self { name: name.into(), index: Some(index), value: value.into() }
    }
}
