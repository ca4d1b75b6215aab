//! Sets / Sets.

use katydid_component::{Context, List, Message, component};
use katydid_data::{Column, Tree, TreeBuilder, Value};

use crate::sets::key::{Key, map_for, places, same};
use crate::sets::numbered::{Numbered, picked};
use crate::sets::{integer, room};

/// Asks for room for a table of the keys of a list.
fn ask(context: &Context<'_>, list: &List<'_, Value>) -> Result<(), Message> {
    context.bytes(list.len().saturating_mul(2 * size_of::<(Key, Value)>()))
}

/// The members of some lists by their numbers.
fn numbered<const N: usize>(
    context: &Context<'_>,
    lists: [&List<'_, Value>; N],
) -> Result<Numbered<N>, Message> {
    lists.iter().try_for_each(|list| ask(context, list))?;
    Ok(Numbered::of(lists))
}

/// Whether a member is in a set, by its number.
fn has(set: &[bool], number: usize) -> bool {
    set.get(number).copied().unwrap_or(false)
}

/// Makes a set of a list: every different item once, in the order they first appear.
///
/// Numbers are the same only to the last digit; nulls are no members.
#[component(
    "98c3c63a-e78a-43ea-a111-514fcf312c95",
    name = "Create Set",
    nick = "CSet",
    at = "Sets/Sets",
    also("2cb4bf85-a282-464c-b42c-8e735d2a0a74")
)]
#[output("Set", "S", "The different items.")]
#[output("Map", "M", "For each item of the list its index in the set; a null for a null.")]
fn create_set(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
) -> Result<(Column, Vec<Option<i32>>), Message> {
    context.items(list.len().saturating_mul(2))?;
    let all = numbered(context, [&list])?;
    let members = picked(&list, &all.firsts(0, &mut all.none_seen(), |_| true));
    // Members are numbered in the order in which they come.
    let [numbers] = all.lists;
    Ok((members, numbers.into_iter().map(|number| number.map(integer)).collect()))
}

/// All members of two sets, each once: those of A, then the new ones of B.
#[component(
    "8eed5d78-7810-4ba1-968e-8a1f1db98e39",
    name = "Set Union",
    nick = "SUnion",
    at = "Sets/Sets",
    also("ab34845d-4ab9-4ff4-8870-eedd0c5594cb")
)]
#[output("Union", "U", "What is in A or in B.")]
fn set_union(
    context: &Context<'_>,
    /// The first set.
    #[port("Set A", "A")]
    a: List<Value>,
    /// The second set.
    #[port("Set B", "B")]
    b: List<Value>,
) -> Result<Column, Message> {
    let all = numbered(context, [&a, &b])?;
    let mut seen = all.none_seen();
    let (in_a, in_b) = (all.firsts(0, &mut seen, |_| true), all.firsts(1, &mut seen, |_| true));
    Ok(Column::concat(&[&picked(&a, &in_a), &picked(&b, &in_b)]))
}

/// The members that two sets have in common, in the order of A.
#[component(
    "82f19c48-9e73-43a4-ae6c-3a8368099b08",
    name = "Set Intersection",
    nick = "Intersection",
    at = "Sets/Sets",
    also("8a55f680-cf53-4634-a486-b828de92b71d")
)]
#[output("Union", "U", "What is in A and in B.")]
fn set_intersection(
    context: &Context<'_>,
    /// The first set.
    #[port("Set A", "A")]
    a: List<Value>,
    /// The second set.
    #[port("Set B", "B")]
    b: List<Value>,
) -> Result<Column, Message> {
    let all = numbered(context, [&a, &b])?;
    let in_b = all.within(1);
    Ok(picked(&a, &all.firsts(0, &mut all.none_seen(), |number| has(&in_b, number))))
}

/// The members of a set that are not in another.
#[component(
    "e3b1a10c-4d49-4140-b8e6-0b5732a26c31",
    name = "Set Difference",
    nick = "Difference",
    at = "Sets/Sets"
)]
#[output("Union", "U", "What is in A and not in B.")]
fn set_difference(
    context: &Context<'_>,
    /// The set to take from.
    #[port("Set A", "A")]
    a: List<Value>,
    /// What is taken away.
    #[port("Set B", "B")]
    b: List<Value>,
) -> Result<Column, Message> {
    let all = numbered(context, [&a, &b])?;
    let in_b = all.within(1);
    Ok(picked(&a, &all.firsts(0, &mut all.none_seen(), |number| !has(&in_b, number))))
}

/// The members that are in one of two sets only: those of A, then those of B.
#[component(
    "d2461702-3164-4894-8c10-ed1fc4b52965",
    name = "Set Difference (S)",
    nick = "ExDiff",
    at = "Sets/Sets"
)]
#[output("ExDifference", "X", "What is in A or in B, but not in both.")]
fn symmetric_difference(
    context: &Context<'_>,
    /// The first set.
    #[port("Set A", "A")]
    a: List<Value>,
    /// The second set.
    #[port("Set B", "B")]
    b: List<Value>,
) -> Result<Column, Message> {
    let all = numbered(context, [&a, &b])?;
    let (in_a, in_b) = (all.within(0), all.within(1));
    let mut seen = all.none_seen();
    let only_a = picked(&a, &all.firsts(0, &mut seen, |number| !has(&in_b, number)));
    let only_b = picked(&b, &all.firsts(1, &mut seen, |number| !has(&in_a, number)));
    Ok(Column::concat(&[&only_a, &only_b]))
}

/// The members that are in at least two of three sets, in order of their first appearance.
#[component(
    "d4136a7b-7422-4660-9404-640474bd2725",
    name = "Set Majority",
    nick = "Majority",
    at = "Sets/Sets"
)]
#[output("Result", "R", "What is in two sets or in all three.")]
fn set_majority(
    context: &Context<'_>,
    /// The first set.
    #[port("Set A", "A")]
    a: List<Value>,
    /// The second set.
    #[port("Set B", "B")]
    b: List<Value>,
    /// The third set.
    #[port("Set C", "C")]
    c: List<Value>,
) -> Result<Column, Message> {
    let all = numbered(context, [&a, &b, &c])?;
    let sets = [0, 1, 2].map(|k| all.within(k));
    let wanted = |number: usize| sets.iter().filter(|set| has(set, number)).count() > 1;
    let mut seen = all.none_seen();
    // What is in C and in another one is in A or B.
    let (in_a, in_b) = (all.firsts(0, &mut seen, wanted), all.firsts(1, &mut seen, wanted));
    Ok(Column::concat(&[&picked(&a, &in_a), &picked(&b, &in_b)]))
}

/// Tells whether two sets have no member in common.
#[component("81800098-1060-4e2b-80d4-17f835cc825f", name = "Disjoint", nick = "Disjoint", at = "Sets/Sets")]
#[output("Result", "R", "True when nothing is in both.")]
fn disjoint(
    context: &Context<'_>,
    /// The first set.
    #[port("Set A", "A")]
    a: List<Value>,
    /// The second set.
    #[port("Set B", "B")]
    b: List<Value>,
) -> Result<bool, Message> {
    let all = numbered(context, [&a, &b])?;
    Ok(!all.within(0).into_iter().zip(all.within(1)).any(|(in_a, in_b)| in_a && in_b))
}

/// Tells whether all members of B are in A too.
#[component("4cfc0bb0-0745-4772-a520-39f9bf3d99bc", name = "SubSet", nick = "SubSet", at = "Sets/Sets")]
#[output("Result", "R", "True when B is a part of A, or all of it; an empty B always is.")]
fn subset(
    context: &Context<'_>,
    /// The large set.
    #[port("Set A", "A")]
    a: List<Value>,
    /// What may be a part of it.
    #[port("Set B", "B")]
    b: List<Value>,
) -> Result<bool, Message> {
    let all = numbered(context, [&a, &b])?;
    Ok(all.within(0).into_iter().zip(all.within(1)).all(|(in_a, in_b)| in_a || !in_b))
}

/// Finds all places of a member in a list.
#[component("3ff27857-b988-417a-b495-b24c733dbd00", name = "Member Index", nick = "MIndex", at = "Sets/Sets")]
#[output("Index", "I", "The indices; none when it is not there.")]
#[output("Count", "N", "How many there are.")]
fn member_index(
    context: &Context<'_>,
    /// The list.
    #[port("Set", "S")]
    set: List<Value>,
    /// What to look for.
    #[port("Member", "M")]
    member: Value,
) -> Result<(Vec<i32>, i32), Message> {
    let found: Vec<i32> = places(context, &set, &member, usize::MAX)?.into_iter().map(integer).collect();
    let n = integer(found.len());
    Ok((found, n))
}

/// Leaves out every item that is equal to the one before it.
///
/// With Wrap the first item counts as following the last, and the last goes when they are equal.
#[component(
    "190d042c-2270-4bc1-81c0-4f90c170c9c9",
    name = "Delete Consecutive",
    nick = "DCon",
    at = "Sets/Sets"
)]
#[output("Set", "S", "The list without repetitions in a row.")]
#[output("Count", "N", "How many items were left out.")]
fn delete_consecutive(
    context: &Context<'_>,
    /// The list.
    #[port("Set", "S")]
    set: List<Value>,
    /// Compare the last item with the first, too.
    #[port("Wrap", "W", default = false)]
    wrap: bool,
) -> Result<(Vec<Option<Value>>, i32), Message> {
    context.items(set.len())?;
    let mut kept: Vec<Option<Value>> = Vec::new();
    for item in set.iter() {
        if kept.last().is_none_or(|last| !same(last.as_ref(), item.as_ref())) {
            kept.push(item);
        }
    }
    if let (true, [first, .., last]) = (wrap, kept.as_slice())
        && same(first.as_ref(), last.as_ref())
    {
        kept.pop();
    }
    let gone = integer(set.len() - kept.len());
    Ok((kept, gone))
}

/// Puts other members in the place of given ones.
///
/// To each member to be found belongs the replacement at the same place; the last serves for all others. Without
/// replacements the members become nulls.
#[component(
    "bafac914-ede4-4a59-a7b2-cc41bc3de961",
    name = "Replace Members",
    nick = "Replace",
    at = "Sets/Sets"
)]
#[output("Result", "R", "The list with the new members.")]
fn replace_members(
    context: &Context<'_>,
    /// The list.
    #[port("Set", "S")]
    set: List<Value>,
    /// What goes.
    #[port("Find", "F")]
    find: List<Value>,
    /// What comes instead.
    #[port("Replace", "R", optional)]
    replace: List<Value>,
) -> Result<Vec<Option<Value>>, Message> {
    context.items(set.len())?;
    ask(context, &find)?;
    let mut places = map_for(find.len());
    for (k, item) in find.iter().enumerate() {
        places.entry(Key::of(item.as_ref())).or_insert(k);
    }
    let last = replace.len().saturating_sub(1);
    let swap = |item: Option<Value>| match places.get(&Key::of(item.as_ref())) {
        Some(&k) => replace.get(k.min(last)),
        None => item,
    };
    Ok(set.iter().map(swap).collect())
}

/// Finds the value that belongs to a key: keys and values are two lists, place by place.
///
/// Of several equal keys the first counts. Without such a key the result is null, with a warning.
#[component(
    "1edcc3cf-cf84-41d4-8204-561162cfe510",
    name = "Key/Value Search",
    nick = "KeySearch",
    at = "Sets/Sets"
)]
#[output("Result", "R", "The value.")]
fn key_value_search(
    context: &Context<'_>,
    /// The keys.
    #[port("Keys", "K")]
    keys: List<Value>,
    /// The value of each key.
    #[port("Values", "V")]
    values: List<Value>,
    /// The key to look for.
    #[port("Search", "S")]
    search: Value,
) -> Result<Option<Value>, Message> {
    let Some(&i) = places(context, &keys, &search, 1)?.first() else {
        context.warn("A key is not among the keys");
        return Ok(None);
    };
    Ok(values.get(i))
}

/// Pairs two sets of the same size, member by member, each pair in a branch of its own.
#[component(
    "deffaf1e-270a-4c15-a693-9216b68afd4a",
    name = "Carthesian Product",
    nick = "CProd",
    at = "Sets/Sets"
)]
#[output("Product", "P", "A branch for each pair; the path is one element longer, the number of the pair.")]
fn cartesian_product(
    context: &Context<'_>,
    /// The first members.
    #[port("Set A", "A")]
    a: List<Value>,
    /// The second members, as many as A has.
    #[port("Set B", "B")]
    b: List<Value>,
) -> Result<Tree, Message> {
    if a.len() != b.len() {
        return Err(Message::error(format!("The sets differ in size: {} and {}", a.len(), b.len())));
    }
    room(context, a.len().saturating_mul(2))?;
    let path = context.path();
    let mut pairs = TreeBuilder::<Value>::new();
    for (i, (a, b)) in a.iter().zip(b.iter()).enumerate() {
        pairs.branch(path.child(i));
        pairs.push(a);
        pairs.push(b);
    }
    Ok(pairs.finish())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    fn two(name: &str) -> Vec<String> {
        Trial::of(name).list([3, 1, 3, 2]).list([2.0, 4.0, 3.0, 4.0]).texts(0)
    }

    #[test]
    fn set_operations() {
        assert_eq!(two("Set Union"), ["{0}: 3, 1, 2, 4"]);
        assert_eq!(two("Set Intersection"), ["{0}: 3, 2"]);
        assert_eq!(two("Set Difference"), ["{0}: 1"]);
        assert_eq!(two("Set Difference (S)"), ["{0}: 1, 4"]);
        assert_eq!(two("Disjoint"), ["{0}: False"]);
        assert_eq!(Trial::of("Disjoint").list([1, 2]).list::<f64>([]).texts(0), ["{0}: True"]);
        assert_eq!(Trial::of("SubSet").list([1, 2, 3]).list([3, 3, 1]).texts(0), ["{0}: True"]);
        assert_eq!(Trial::of("SubSet").list([1, 2, 3]).list([3, 4]).texts(0), ["{0}: False"]);
        let majority = Trial::of("Set Majority").list([1, 2, 3]).list([4, 3, 5]).list([5, 1, 9]);
        assert_eq!(majority.texts(0), ["{0}: 1, 3, 5"]);
    }

    #[test]
    fn a_set_has_each_item_once() {
        let list = || Trial::of("Create Set").list(["b", "a", "b", "B"]);
        assert_eq!(list().texts(0), ["{0}: b, a, B"]);
        assert_eq!(list().texts(1), ["{0}: 0, 1, 0, 2"]);
        assert_eq!(Trial::of("Create Set").gaps([None, Some(1)]).texts(1), ["{0}: null, 0"]);
    }

    #[test]
    fn members_are_found() {
        let list = || Trial::of("Member Index").list([5, 6, 5]);
        assert_eq!(list().list([5.0, 7.0]).texts(0), ["{0;0}: 0, 2", "{0;1}:"]);
        assert_eq!(list().list([5.0, 7.0]).texts(1), ["{0}: 2, 0"]);
        let search = || Trial::of("Key/Value Search").list(["a", "b", "a"]).list([1, 2, 3]);
        assert_eq!(search().list(["b", "a"]).texts(0), ["{0}: 2, 1"]);
        assert_eq!(search().item("c").message(), "A key is not among the keys");
        assert_eq!(search().item("c").texts(0), ["{0}: null"]);
    }

    #[test]
    fn many_searches_are_as_good_as_few() {
        let n = 100_000;
        let set = || (0..2 * n).map(move |i| i % n);
        let found = Trial::of("Member Index").list(set()).list((0..n).rev()).run();
        let indices: &[i32] = katydid_data::Item::slice(found.outputs[0].column()).unwrap();
        assert_eq!(indices.len(), 200_000);
        assert_eq!(indices[..4], [n - 1, 2 * n - 1, n - 2, 2 * n - 2]);
        let trial = Trial::of("Item Index").list(set()).list((0..n).rev()).run();
        let indices: &[i32] = katydid_data::Item::slice(trial.outputs[0].column()).unwrap();
        assert!(indices.iter().copied().eq((0..n).rev()));
    }

    #[test]
    fn repetitions_in_a_row_go() {
        let list = || Trial::of("Delete Consecutive").list([1, 1, 2, 2, 1, 1]);
        assert_eq!(
            (list().texts(0), list().texts(1)),
            (vec!["{0;0}: 1, 2, 1".into()], vec!["{0}: 3".into()])
        );
        assert_eq!(list().item(true).texts(0), ["{0;0}: 1, 2"]);
        assert_eq!(Trial::of("Delete Consecutive").list([1, 1]).item(true).texts(0), ["{0;0}: 1"]);
    }

    #[test]
    fn members_are_replaced() {
        let list = || Trial::of("Replace Members").list([1, 2, 3, 2]);
        assert_eq!(list().list([2, 3]).list(["x", "y"]).texts(0), ["{0}: 1, x, y, x"]);
        assert_eq!(list().list([2, 3]).item("x").texts(0), ["{0}: 1, x, x, x"]);
        assert_eq!(list().list([2]).texts(0), ["{0}: 1, null, 3, null"]);
    }

    #[test]
    fn pairs_member_by_member() {
        let trial = Trial::of("Carthesian Product").list([1, 2]).list(["a", "b"]);
        assert_eq!(trial.texts(0), ["{0;0}: 1, a", "{0;1}: 2, b"]);
        let odd = Trial::of("Carthesian Product").list([1, 2]).list(["a"]);
        assert_eq!(odd.message(), "The sets differ in size: 2 and 1");
    }

    #[test]
    fn large_sets_take_no_longer_than_they_must() {
        let n = 300_000;
        let trial = Trial::of("Set Difference (S)").list((0..n).map(f64::from)).list((1..=n).map(f64::from));
        assert_eq!(trial.texts(0), ["{0}: 0, 300000"]);
    }
}
