//! EdiTree: lists cut into parts, and parts of trees. Names and ports are those of public lists, which also tell what each does.

use std::sync::Arc as Shared;

use katydid_component::{Context, ManyTrees, Message, component};
use katydid_data::{Tree, Value};

use crate::branches::{Branches, items, of};
use crate::model_objects::first;

/// The first whole number of a tree, at least 1.
fn positive(tree: &Tree, name: &str) -> Result<usize, Message> {
    let Some(Value::Integer(number)) = first(tree) else {
        return Err(Message::error(format!("{name} is missing")));
    };
    let count = usize::try_from(number).ok().filter(|count| *count > 0);
    count.ok_or_else(|| Message::error(format!("{name} is {number}: it must be at least 1")))
}

/// Cuts each branch into chunks of one size, and what is left.
fn cut(tree: &Tree, size: impl Fn(usize) -> usize, most: usize) -> (Tree, Tree) {
    let (mut chunks, mut rest) = (Branches::default(), Branches::default());
    for branch in tree.branches() {
        let items = of(&branch);
        let size = size(items.len());
        let whole = items.len().checked_div(size).unwrap_or(0).min(most);
        for (number, chunk) in items.chunks(size.max(1)).take(whole).enumerate() {
            chunks.extend(branch.path().child(number), chunk.iter().cloned());
        }
        let left = items.get(whole.saturating_mul(size)..).unwrap_or_default();
        if !left.is_empty() {
            rest.extend(branch.path().clone(), left.iter().cloned());
        }
    }
    (chunks.tree(), rest.tree())
}

/// Divides lists into so many lists of one length; what is left is the remainder. Stands for EdiTree's Divide List.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2e01",
    name = "Divide List",
    nick = "Divide List",
    at = "EdiTree/EdiTree"
)]
#[output("Chunk", "C", "A branch for each of the lists.", kind = Generic)]
#[output("Remainder", "R", "The items that are left.", kind = Generic)]
fn divide(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L", kind = Generic)]
    list: &Tree,
    /// The number of lists, at least 1.
    #[port("Number", "N", kind = Integer)]
    number: &Tree,
) -> Result<(Tree, Tree), Message> {
    let number = positive(number, "Number")?;
    context.items(list.item_count())?;
    Ok(cut(list, |length| length / number, number))
}

/// Cuts lists into lists of a size; what is left is the remainder. Stands for EdiTree's Partition List Adv.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2e02",
    name = "Partition List Adv",
    nick = "Partition",
    at = "EdiTree/EdiTree"
)]
#[output("Chunk", "C", "A branch for each of the lists.", kind = Generic)]
#[output("Remainder", "R", "The items that are left.", kind = Generic)]
fn partition(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L", kind = Generic)]
    list: &Tree,
    /// The number of items in each list, at least 1.
    #[port("Size", "S", kind = Integer)]
    size: &Tree,
) -> Result<(Tree, Tree), Message> {
    let size = positive(size, "Size")?;
    context.items(list.item_count())?;
    Ok(cut(list, |_| size, usize::MAX))
}

/// Cuts lists before items of some places. Stands for EdiTree's Split List Multi; that places count in each branch, and those outside
/// the list cut nothing, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2e03",
    name = "Split List Multi",
    nick = "Split Multi",
    at = "EdiTree/EdiTree"
)]
#[output("Chunks", "C", "A branch for each part.", kind = Generic)]
fn split(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L", kind = Generic)]
    list: &Tree,
    /// The places of the items that parts begin with, from 0.
    #[port("Index", "N", kind = Integer)]
    places: &Tree,
) -> Result<Tree, Message> {
    context.items(list.item_count())?;
    let mut places: Vec<usize> = items(places)
        .filter_map(|place| match place {
            Some(Value::Integer(place)) => usize::try_from(place).ok(),
            _ => None,
        })
        .collect();
    places.sort_unstable();
    places.dedup();
    let mut chunks = Branches::default();
    for branch in list.branches() {
        let items = of(&branch);
        let inner = places.iter().copied().filter(|place| *place > 0 && *place < items.len());
        let ends: Vec<usize> = inner.chain([items.len()]).collect();
        let mut start = 0;
        for (number, end) in ends.into_iter().enumerate() {
            chunks.extend(
                branch.path().child(number),
                items.get(start..end).unwrap_or_default().iter().cloned(),
            );
            start = end;
        }
    }
    Ok(chunks.tree())
}

/// The branches of a tree whose paths begin with some numbers. Stands for EdiTree's SubTree; that an input without a number takes any
/// is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2e04",
    name = "SubTree",
    nick = "SubTree",
    at = "EdiTree/EdiTree"
)]
#[output("Path", "P", "The paths of the branches.", kind = Text)]
#[output("SubTree", "S", "The branches, at their paths.", kind = Generic)]
fn sub_tree(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T", kind = Generic)]
    tree: &Tree,
    /// The numbers, from the first one of the paths on; any number of inputs.
    #[port("A", "A", kind = Integer, optional)]
    numbers: ManyTrees<'_>,
) -> Result<(Tree, Tree), Message> {
    context.items(tree.item_count())?;
    let wanted: Vec<Option<i32>> = numbers
        .iter()
        .map(|tree| match first(tree) {
            Some(Value::Integer(number)) => Some(number),
            _ => None,
        })
        .collect();
    let fits = |path: &[i32]| {
        let mut given = wanted.iter().enumerate();
        given.all(|(at, number)| number.is_none_or(|number| path.get(at) == Some(&number)))
    };
    let mut found = Branches::default();
    let mut paths: Vec<Shared<str>> = Vec::new();
    for branch in tree.branches().filter(|branch| fits(branch.path().elements())) {
        paths.push(branch.path().to_string().into());
        found.extend(branch.path().clone(), of(&branch));
    }
    if paths.is_empty() {
        context.warn("No path begins with these numbers");
    }
    Ok((Tree::list(paths), found.tree()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn lists_are_divided() {
        let divided = |k: usize| Trial::of("Divide List").list([0, 1, 2, 3, 4, 5, 6]).item(3).texts(k);
        assert_eq!(divided(0), ["{0;0}: 0, 1", "{0;1}: 2, 3", "{0;2}: 4, 5"]);
        assert_eq!(divided(1), ["{0}: 6"]);
        let more = |k: usize| Trial::of("Divide List").list([0, 1]).item(3).texts(k);
        assert_eq!(more(1), ["{0}: 0, 1"]);
        assert!(more(0).is_empty());
        assert!(Trial::of("Divide List").list([0]).item(0).message().contains("at least 1"));
    }

    #[test]
    fn lists_are_cut_by_size() {
        let cut = |k: usize| Trial::of("Partition List Adv").list([0, 1, 2, 3, 4]).item(2).texts(k);
        assert_eq!(cut(0), ["{0;0}: 0, 1", "{0;1}: 2, 3"]);
        assert_eq!(cut(1), ["{0}: 4"]);
    }

    #[test]
    fn lists_are_cut_at_places() {
        let cut = Trial::of("Split List Multi").list([0, 1, 2, 3, 4]).list([3, 1, 3, 9, -1, 0]);
        assert_eq!(cut.texts(0), ["{0;0}: 0", "{0;1}: 1, 2", "{0;2}: 3, 4"]);
        let whole = Trial::of("Split List Multi").list([0, 1]).list([7]).texts(0);
        assert_eq!(whole, ["{0;0}: 0, 1"]);
    }

    #[test]
    fn branches_are_found_by_numbers() {
        let tree = [("{0;0}", [1]), ("{0;1}", [2]), ("{1;0}", [3]), ("{1;0;4}", [4])];
        let one = |k: usize| Trial::of("SubTree").branches(tree).item(1).texts(k);
        assert_eq!(one(0), ["{0}: {1;0}, {1;0;4}"]);
        assert_eq!(one(1), ["{1;0}: 3", "{1;0;4}: 4"]);
        let two = Trial::of("SubTree").branches(tree).item(0).item(1).texts(1);
        assert_eq!(two, ["{0;1}: 2"]);
        assert!(Trial::of("SubTree").branches(tree).item(5).message().contains("No path begins"));
    }
}
