//! Pairs of items that stand in a fixed relation in a tree.

use std::collections::HashMap;
use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_data::{Path, Tree};

use super::offset::Offset;
use crate::sets::{place, room};

/// For each item of `a` its partner in `b`: both at the path of the item of `a`. Items without a partner drop
/// out, and so do branches without any pair.
fn pairs(
    context: &Context<'_>,
    [a, b]: [&Tree; 2],
    offset: &str,
    wrap_paths: bool,
    wrap_items: bool,
) -> Result<(Tree, Tree), Message> {
    let offset = Offset::parse(offset)?;
    let extent = if wrap_paths { extents(b) } else { HashMap::new() };
    let mut paths = Vec::new();
    let mut ends = Vec::new();
    let (mut first, mut second) = (Vec::new(), Vec::new());
    room(context, a.item_count().saturating_mul(2))?;
    for branch in a.branches() {
        let Some(mut target) = offset.apply(branch.path()) else { continue };
        if let Some(extent) = extent.get(&target.len()) {
            for (element, &(low, high)) in target.iter_mut().zip(extent) {
                let (x, low, high) = (i64::from(*element), i64::from(low), i64::from(high));
                *element = i32::try_from(low + (x - low).rem_euclid(high - low + 1)).unwrap_or(*element);
            }
        }
        let Ok(other) = b.paths().binary_search(&Path::from(target.as_slice())) else { continue };
        let other = b.range(other);
        let before = first.len();
        for (i, at) in (0_i64..).zip(branch.range()) {
            if let Some(partner) = place(i + i64::from(offset.item), other.len(), wrap_items) {
                first.push(at);
                second.push(other.start + partner);
            }
        }
        if first.len() > before {
            paths.push(branch.path().clone());
            ends.push(first.len());
        }
    }
    let items = Tree::from_parts(paths.clone(), ends.clone(), a.column().gather(&first));
    Ok((items, Tree::from_parts(paths, ends, b.column().gather(&second))))
}

/// For each length of path the smallest and largest number at each place.
fn extents(tree: &Tree) -> HashMap<usize, Vec<(i32, i32)>> {
    let mut extents: HashMap<usize, Vec<(i32, i32)>> = HashMap::new();
    for path in tree.paths() {
        let extent = extents
            .entry(path.len())
            .or_insert_with(|| path.elements().iter().map(|&element| (element, element)).collect());
        for ((low, high), &element) in extent.iter_mut().zip(path.elements()) {
            *low = element.min(*low);
            *high = element.max(*high);
        }
    }
    extents
}

/// Pairs each item of a tree with another that stands at a fixed offset from it.
///
/// The offset `{0;+1}[-1]` means one more in the last path element and one less in the index; path offsets count
/// from the end of the path. Items without a partner are left out.
#[component(
    "fac0d5be-e3ff-4bbb-9742-ec9a54900d41",
    name = "Relative Item",
    nick = "RelItem",
    at = "Sets/Tree"
)]
#[output("Item A", "A", "The items that have a partner, at their paths.")]
#[output("Item B", "B", "Their partners, at the same paths.")]
fn relative_item(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
    /// From the item to its partner.
    #[port("Offset", "O")]
    offset: Arc<str>,
    /// Count path elements round and round, between the smallest and the largest there are.
    #[port("Wrap Paths", "Wp", default = false)]
    wrap_paths: bool,
    /// Count the items of a branch round and round.
    #[port("Wrap Items", "Wi", default = false)]
    wrap_items: bool,
) -> Result<(Tree, Tree), Message> {
    pairs(context, [tree, tree], &offset, wrap_paths, wrap_items)
}

/// Pairs each item of a tree with one of another tree that stands at a fixed offset from its place.
///
/// The offset `{0;+1}[-1]` means one more in the last path element and one less in the index; path offsets count
/// from the end of the path. Items without a partner are left out.
#[component(
    "2653b135-4df1-4a6b-820c-55e2ad3bc1e0",
    name = "Relative Items",
    nick = "RelItem2",
    at = "Sets/Tree"
)]
#[output("Item A", "A", "The items of the first tree that have a partner, at their paths.")]
#[output("Item B", "B", "Their partners in the second tree, at the same paths.")]
fn relative_items(
    context: &Context<'_>,
    /// The first tree.
    #[port("Tree A", "A")]
    a: &Tree,
    /// The tree of the partners.
    #[port("Tree B", "B")]
    b: &Tree,
    /// From the place of an item to that of its partner.
    #[port("Offset", "O")]
    offset: Arc<str>,
    /// Count path elements round and round, between the smallest and the largest there are.
    #[port("Wrap Paths", "Wp", default = false)]
    wrap_paths: bool,
    /// Count the items of a branch round and round.
    #[port("Wrap Items", "Wi", default = false)]
    wrap_items: bool,
) -> Result<(Tree, Tree), Message> {
    pairs(context, [a, b], &offset, wrap_paths, wrap_items)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    fn grid(offset: &str, wrap_paths: bool, wrap_items: bool) -> [Vec<String>; 2] {
        [0, 1].map(|k| {
            let tree = Trial::of("Relative Item").branches([("{0;0}", [1, 2, 3]), ("{0;1}", [4, 5, 6])]);
            tree.item(offset).item(wrap_paths).item(wrap_items).texts(k)
        })
    }

    #[test]
    fn partners_in_one_tree() {
        assert_eq!(
            grid("{0}[+1]", false, false),
            [
                ["{0;0}: 1, 2", "{0;1}: 4, 5"].map(String::from).to_vec(),
                ["{0;0}: 2, 3", "{0;1}: 5, 6"].map(String::from).to_vec(),
            ]
        );
        assert_eq!(
            grid("{+1}[+1]", false, false),
            [vec!["{0;0}: 1, 2".into()], vec!["{0;0}: 5, 6".to_owned()]]
        );
        assert_eq!(grid("{+1}[0]", true, false)[1], ["{0;0}: 4, 5, 6", "{0;1}: 1, 2, 3"]);
        assert_eq!(grid("{0}[-1]", false, true)[1], ["{0;0}: 3, 1, 2", "{0;1}: 6, 4, 5"]);
        assert!(grid("{0;0;0}[0]", false, false)[0].is_empty());
        let bad = Trial::of("Relative Item").item(1).item("next");
        assert_eq!(bad.message(), "'next' is no offset such as {0;+1}[-1]");
    }

    #[test]
    fn partners_in_another_tree() {
        let trial = Trial::of("Relative Items")
            .branches([("{0}", [1, 2])])
            .branches([("{0}", ["a"]), ("{1}", ["b"])]);
        assert_eq!(trial.item("{1}[0]").texts(1), ["{0}: b"]);
    }
}
