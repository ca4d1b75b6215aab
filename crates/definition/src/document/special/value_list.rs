use crate::Result;
use crate::archive::Chunk;
use crate::document::{Object, ids};

/// A Value List.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ValueList {
    /// How many items can be chosen, and how.
    pub mode: ListMode,
    /// The items.
    pub items: Vec<ValueListItem>,
}

/// How a Value List is chosen from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ListMode {
    /// Any number of items.
    CheckList,
    /// One, from a menu.
    DropDown,
    /// One, by stepping.
    Sequence,
    /// One, by stepping around.
    Cycle,
}

/// An item of a [`ValueList`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ValueListItem {
    /// What its author reads.
    pub name: String,
    /// The expression whose value the list gives: text stands in quotes.
    pub expression: String,
    /// Whether it is chosen.
    pub selected: bool,
}

impl ValueList {
    pub(super) fn read(container: &Chunk) -> Self {
        let item = |chunk: &Chunk| ValueListItem {
            name: chunk.str("Name").unwrap_or_default().to_owned(),
            expression: chunk.str("Expression").unwrap_or_default().to_owned(),
            selected: chunk.bool("Selected").unwrap_or(false),
        };
        Self {
            mode: match container.i32("ListMode") {
                Some(0) => ListMode::CheckList,
                Some(2) => ListMode::Sequence,
                Some(3) => ListMode::Cycle,
                _ => ListMode::DropDown,
            },
            items: container.children("ListItem").into_iter().map(item).collect(),
        }
    }
}

impl Object {
    /// Chooses the items of a Value List with these indices, and no others.
    ///
    /// # Errors
    /// When the object is no Value List, has no item of such an index, or takes exactly one.
    pub fn select(&mut self, chosen: &[usize]) -> Result<()> {
        if self.component != ids::VALUE_LIST {
            return Err(self.refuse("it is not a Value List"));
        }
        let list = ValueList::read(self.container());
        if let Some(index) = chosen.iter().find(|index| **index >= list.items.len()) {
            return Err(self.refuse(format!("there is no item {index} among {}", list.items.len())));
        }
        if list.mode != ListMode::CheckList && chosen.len() != 1 {
            return Err(self.refuse(format!("it takes exactly one item, not {}", chosen.len())));
        }
        let chunks = &mut self.container_mut().chunks;
        let mut items: Vec<_> =
            chunks.iter_mut().filter(|chunk| chunk.name == "ListItem" && chunk.index.is_some()).collect();
        items.sort_by_key(|chunk| chunk.index);
        for (index, item) in items.into_iter().enumerate() {
            item.set("Selected", chosen.contains(&index));
        }
        Ok(())
    }

    /// Chooses the item of a Value List with this name.
    ///
    /// # Errors
    /// As for [`select`](Self::select), and when no item has the name.
    pub fn select_named(&mut self, name: &str) -> Result<()> {
        let list = ValueList::read(self.container());
        let names = || list.items.iter().map(|item| item.name.as_str());
        let index = names().position(|other| other == name);
        let index = index.or_else(|| names().position(|other| other.eq_ignore_ascii_case(name)));
        match index {
            Some(index) => self.select(&[index]),
            None if self.component == ids::VALUE_LIST => {
                let all = names().take(20).collect::<Vec<_>>().join(", ");
                Err(self.refuse(format!("there is no item \"{name}\"; it has {all}")))
            }
            None => Err(self.refuse("it is not a Value List")),
        }
    }
}
