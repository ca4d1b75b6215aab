//! Putting items into a list and in the place of others.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;

use crate::sets::place;

/// Index by index the item that belongs to it; the shorter of the two lists gives its last again. Without any
/// items it is nulls.
fn pairs(items: &List<'_, Value>, indices: &List<'_, i32>) -> Vec<(i64, Option<Value>)> {
    let Some(last_index) = indices.len().checked_sub(1) else { return Vec::new() };
    let last_item = items.len().saturating_sub(1);
    (0..items.len().max(indices.len()))
        .filter_map(|k| Some((i64::from(indices.get(k.min(last_index))?), items.get(k.min(last_item)))))
        .collect()
}

/// Puts items into a list in front of the items at given indices, which count in the list as it comes in.
///
/// Several items at one index go in as a block. Without items, nulls are put in. With Wrap the indices count
/// round and round, the place behind the last item among them; without it an index behind the end fills the
/// list up with nulls, and a negative one is left out with a warning.
#[component("e2039b07-d3f3-40f8-af88-d74fed238727", name = "Insert Items", nick = "Ins", at = "Sets/List")]
#[output("List", "L", "The list with the items in it.")]
fn insert_items(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// What to put in.
    #[port("Item", "I", optional)]
    items: List<Value>,
    /// Where: an index for each item.
    #[port("Indices", "i")]
    indices: List<i32>,
    /// Count round and round.
    #[port("Wrap", "W", default = true)]
    wrap: bool,
) -> Result<Vec<Option<Value>>, Message> {
    let mut inserts: Vec<(usize, Option<Value>)> = Vec::new();
    for (i, item) in pairs(&items, &indices) {
        let at = if wrap { place(i, list.len() + 1, true) } else { usize::try_from(i).ok() };
        match at {
            Some(at) => inserts.push((at, item)),
            None => context.warn("A negative index is left out"),
        }
    }
    inserts.sort_by_key(|&(at, _)| at);
    let length = list.len().max(inserts.last().map_or(0, |&(at, _)| at));
    context.items(length.saturating_add(inserts.len()))?;
    let mut result = Vec::with_capacity(length + inserts.len());
    let mut taken = 0;
    for (at, item) in inserts {
        result.extend((taken..at).map(|i| list.get(i)));
        taken = at;
        result.push(item);
    }
    result.extend((taken..list.len()).map(|i| list.get(i)));
    Ok(result)
}

/// Puts items in the place of those at given indices.
///
/// Without items, nulls are put there. With Wrap the indices count round and round; without it an index outside
/// is left out with a warning. Of several items for one index the last stays.
#[component(
    "7a218bfb-b93d-4c1f-83d3-5a0b909dd60b",
    name = "Replace Items",
    nick = "Replace",
    at = "Sets/List"
)]
#[output("List", "L", "The list with the new items.")]
fn replace_items(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// The new items.
    #[port("Item", "I", optional)]
    items: List<Value>,
    /// Where: an index for each item.
    #[port("Indices", "i", optional)]
    indices: List<i32>,
    /// Count round and round.
    #[port("Wrap", "W", default = false)]
    wrap: bool,
) -> Result<Vec<Option<Value>>, Message> {
    context.items(list.len())?;
    let mut result = list.to_vec();
    for (i, item) in pairs(&items, &indices) {
        match place(i, list.len(), wrap).and_then(|at| result.get_mut(at)) {
            Some(old) => *old = item,
            None => context.warn("An index lies outside the list: it is left out"),
        }
    }
    Ok(result)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn one_index_takes_a_block() {
        let tens = || Trial::of("Insert Items").list([0, 10, 20, 30, 40, 50]);
        let block = tens().list(["A", "B", "C"]).item(3);
        assert_eq!(block.texts(0), ["{0;0}: 0, 10, 20, A, B, C, 30, 40, 50"]);
        let two = tens().list(["A", "B"]).list([4, 2]);
        assert_eq!(two.texts(0), ["{0;0}: 0, 10, B, 20, 30, A, 40, 50"]);
    }

    #[test]
    fn an_index_at_the_end_appends_and_wraps() {
        let three =
            |i: i32, wrap: bool| Trial::of("Insert Items").list([1, 2, 3]).item("x").item(i).item(wrap);
        assert_eq!(three(3, true).texts(0), ["{0;0}: 1, 2, 3, x"]);
        assert_eq!(three(-1, true).texts(0), ["{0;0}: 1, 2, 3, x"]);
        assert_eq!(three(4, true).texts(0), ["{0;0}: x, 1, 2, 3"]);
        assert_eq!(three(5, false).texts(0), ["{0;0}: 1, 2, 3, null, null, x"]);
        assert_eq!(three(-1, false).texts(0), ["{0;0}: 1, 2, 3"]);
        assert!(three(i32::MAX, false).message().contains("items"));
        let nulls = Trial::of("Insert Items").list([1, 2]).tree(katydid_data::Tree::empty()).list([0, 2]);
        assert_eq!(nulls.texts(0), ["{0;0}: null, 1, 2, null"]);
    }

    #[test]
    fn replace_changes_places() {
        let three =
            |i: i32, wrap: bool| Trial::of("Replace Items").list([1, 2, 3]).item("x").item(i).item(wrap);
        assert_eq!(three(1, false).texts(0), ["{0;0}: 1, x, 3"]);
        assert_eq!(three(-1, true).texts(0), ["{0;0}: 1, 2, x"]);
        assert_eq!(three(-1, false).texts(0), ["{0;0}: 1, 2, 3"]);
        assert!(three(3, false).message().contains("outside"));
        let nulls = Trial::of("Replace Items").list([1, 2, 3]).tree(katydid_data::Tree::empty()).list([0, 2]);
        assert_eq!(nulls.texts(0), ["{0;0}: null, 2, null"]);
        let none = Trial::of("Replace Items").list([1, 2, 3]).item("x");
        assert_eq!(none.texts(0), ["{0;0}: 1, 2, 3"]);
    }
}
