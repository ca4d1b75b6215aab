//! Taking items out of a list by their places.

use katydid_component::{Context, Each, List, Message, component};
use katydid_data::{Column, Value};
use katydid_geometry::Interval;

use crate::sets::key::places;
use crate::sets::{integer, place};

/// Item `i`, or a warning why there is none.
fn item(context: &Context<'_>, list: &List<'_, Value>, i: i64, wrap: bool) -> Option<Value> {
    match place(i, list.len(), wrap) {
        Some(at) => list.get(at),
        None => {
            context.warn(match () {
                () if list.is_empty() => "The list is empty: there is no item to take",
                () if i < 0 => "The index is negative, before the first item",
                () => "The index lies behind the last item",
            });
            None
        }
    }
}

/// Takes the item at an index out of a list; the first has index 0.
///
/// With Wrap the list is counted round and round, so that -1 is the last item; without it an index outside
/// gives a null and a warning. Further outputs give the items before and behind that place.
#[component("59daf374-bc21-4a5e-8282-5504fb7ae9ae", name = "List Item", nick = "Item", at = "Sets/List")]
#[output("Item", "i", "The item at the index.")]
fn list_item(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// Which item; the first is 0.
    #[port("Index", "i", default = 0)]
    index: i32,
    /// Count round and round.
    #[port("Wrap", "W", default = true)]
    wrap: bool,
) -> Result<Each<Option<Value>>, Message> {
    // The output that gives the index itself; the one before it gives the item before.
    let base = *context.prepared(|| Ok(context.settings().i32("BaseOutputIndex").unwrap_or(0)))?;
    let first = i64::from(index) - i64::from(base);
    Ok(Each((first..).take(context.output_count()).map(|i| item(context, &list, i, wrap)).collect()))
}

/// Takes the item at an index out of a list; the first has index 0.
///
/// An index outside gives a null and a warning, unless Wrap counts round and round.
#[component(
    "285ddd8a-5398-4a3e-b3c2-361025711a51",
    name = "List Item",
    nick = "Item",
    at = "Sets/List",
    also("6e2ba21a-2252-42f4-8d3f-f5e0f49cc4ef"),
    old
)]
#[output("Element", "E", "The item at the index.")]
fn list_item_fixed(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// Which item; the first is 0.
    #[port("Index", "i", default = 0)]
    index: i32,
    /// Count round and round.
    #[port("Wrap", "W", default = false)]
    wrap: bool,
) -> Option<Value> {
    item(context, &list, index.into(), wrap)
}

/// The number of items in a list, nulls included.
#[component("1817fd29-20ae-4503-b542-f0fb651e67d7", name = "List Length", nick = "Lng", at = "Sets/List")]
#[output("Length", "L", "How many items there are; 0 for an empty list.")]
fn list_length(
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
) -> i32 {
    integer(list.len())
}

/// Finds the first place of an item in a list.
///
/// Items are compared by value, without tolerance; curves, meshes and other large shapes are found only when
/// they are the very same object.
#[component("a759fd55-e6be-4673-8365-c28d5b52c6c0", name = "Item Index", nick = "Index", at = "Sets/List")]
#[output("Index", "i", "The index of the first such item; -1 when there is none.")]
fn item_index(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// What to look for.
    #[port("Item", "i")]
    item: Value,
) -> Result<i32, Message> {
    Ok(places(context, &list, &item, 1)?.first().map_or(-1, |&i| integer(i)))
}

/// Cuts a list in two before an index.
#[component("9ab93e1a-ebdf-4090-9296-b000cff7b202", name = "Split List", nick = "Split", at = "Sets/List")]
#[output("List A", "A", "The items before the index; none when it is 0 or negative.")]
#[output("List B", "B", "The item at the index and all behind it.")]
fn split_list(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// Where to cut: the index of the first item of B.
    #[port("Index", "i")]
    index: i32,
) -> Result<(Vec<Option<Value>>, Vec<Option<Value>>), Message> {
    context.items(list.len())?;
    let at = usize::try_from(index).unwrap_or(0).min(list.len());
    Ok((list.iter().take(at).collect(), list.iter().skip(at).collect()))
}

/// Takes a run of items out of a list: from the start of a domain of indices to its end, both included.
///
/// The ends are rounded. A domain that falls gives the items backwards. With Wrap the list is counted round and
/// round; without it indices outside are left out.
#[component("b333ff42-93bd-406b-8e17-15780719b6ec", name = "Sub List", nick = "SubSet", at = "Sets/List")]
#[output("List", "L", "The items.")]
#[output("Index", "I", "The index of each in the list.")]
fn sub_list(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// The first and the last index.
    #[port("Domain", "D")]
    domain: Interval,
    /// Count round and round.
    #[port("Wrap", "W", default = true)]
    wrap: bool,
) -> Result<(Column, Vec<i32>), Message> {
    if domain.start.is_nan() || domain.end.is_nan() {
        return Err(Message::error("The domain has an end that is no number"));
    }
    if list.is_empty() {
        return Ok((Column::nulls(0), Vec::new()));
    }
    // Beyond this no list reaches; it keeps the sums below inside 64 bits.
    const FAR: f64 = 1e15;
    let end = |x: f64| x.round_ties_even().clamp(-FAR, FAR) as i64;
    let (from, to) = (end(domain.start), end(domain.end));
    let (mut low, mut high) = (from.min(to), from.max(to));
    if !wrap {
        low = low.max(0);
        high = high.min(i64::try_from(list.len()).unwrap_or(i64::MAX) - 1);
    }
    let length = usize::try_from((high - low + 1).max(0)).unwrap_or(usize::MAX);
    context.items(length.saturating_mul(2))?;
    let places: Vec<usize> = (low..=high).filter_map(|i| place(i, list.len(), wrap)).collect();
    let places = if from <= to { places } else { places.into_iter().rev().collect() };
    Ok((list.gather(&places), places.into_iter().map(integer).collect()))
}

#[cfg(test)]
mod tests {
    use katydid_component::{Limits, testing::Trial};

    use super::*;

    #[test]
    fn list_item_takes_one_an_index() {
        let tens = ["0.0", "10.0", "20.0", "30.0", "40.0", "50.0"];
        assert_eq!(Trial::of("List Item").list(tens).item(2).texts(0), ["{0}: 20.0"]);
        assert_eq!(Trial::of("List Item").list(tens).list([2, 4, -1]).texts(0), ["{0}: 20.0, 40.0, 50.0"]);
        let outside = Trial::of("List Item").list(tens).list([2, 6]).item(false).run();
        assert!(outside.outputs[0].column().is_null(1));
        assert_eq!(outside.messages[0].text, "The index lies behind the last item");
        let empty = Trial::of("List Item").list::<f64>([]).item(0);
        assert_eq!(empty.message(), "The list is empty: there is no item to take");
        assert_eq!(Trial::of("List Item").gaps([Some(1), None]).item(1).texts(0), ["{0}: null"]);
    }

    #[test]
    fn list_item_has_neighbours() {
        let trial =
            || Trial::of("List Item").list([5, 6, 7]).item(0).outputs(3).setting("BaseOutputIndex", 1);
        assert_eq!(trial().texts(0), ["{0}: 7"]);
        assert_eq!(trial().texts(1), ["{0}: 5"]);
        assert_eq!(trial().texts(2), ["{0}: 6"]);
    }

    #[test]
    fn the_old_list_item_does_not_wrap() {
        let old = || Trial::of_guid("285ddd8a-5398-4a3e-b3c2-361025711a51").list([5, 6, 7]);
        assert_eq!(old().item(3).texts(0), ["{0}: null"]);
        assert_eq!(old().item(1).texts(0), ["{0}: 6"]);
        assert_eq!(old().item(3).item(true).texts(0), ["{0}: 5"]);
    }

    #[test]
    fn lengths_count_nulls() {
        assert_eq!(Trial::of("List Length").gaps([Some(1), None]).texts(0), ["{0}: 2"]);
        assert_eq!(Trial::of("List Length").list::<f64>([]).texts(0), ["{0}: 0"]);
    }

    #[test]
    fn item_index_is_the_first_or_minus_one() {
        let list = || Trial::of("Item Index").list([3.0, 1.0, 2.0, 1.0]);
        assert_eq!(list().list([1.0, 4.0]).texts(0), ["{0}: 1, -1"]);
        assert_eq!(list().item(2).texts(0), ["{0}: 2"]);
    }

    #[test]
    fn split_list_grows_the_path() {
        let split = |i: i32, k: usize| Trial::of("Split List").list([1, 2, 3]).item(i).texts(k);
        assert_eq!((split(1, 0), split(1, 1)), (vec!["{0;0}: 1".into()], vec!["{0;0}: 2, 3".into()]));
        assert_eq!((split(-4, 0), split(9, 1)), (vec!["{0;0}:".to_owned()], vec!["{0;0}:".to_owned()]));
    }

    #[test]
    fn sub_list_keeps_both_ends() {
        let sub = |a: f64, b: f64, wrap: bool, k: usize| {
            Trial::of("Sub List").list([10, 11, 12, 13, 14]).item(Interval::new(a, b)).item(wrap).texts(k)
        };
        assert_eq!(sub(1.0, 3.0, true, 0), ["{0;0}: 11, 12, 13"]);
        assert_eq!(sub(3.0, 5.0, true, 0), ["{0;0}: 13, 14, 10"]);
        assert_eq!(sub(3.0, 5.0, true, 1), ["{0;0}: 3, 4, 0"]);
        assert_eq!(sub(3.0, 5.0, false, 0), ["{0;0}: 13, 14"]);
        assert_eq!(sub(2.0, 0.0, false, 0), ["{0;0}: 12, 11, 10"]);
        assert_eq!(sub(-9.0, -2.0, false, 0), ["{0;0}:"]);
        assert_eq!(sub(f64::NEG_INFINITY, f64::INFINITY, false, 1), ["{0;0}: 0, 1, 2, 3, 4"]);
        let endless = Trial::of("Sub List").list([1]).item(Interval::new(0.0, 1e300));
        assert!(endless.limits(Limits::default()).message().contains("items"));
    }
}
