//! Chance, the same for the same seed.

use katydid_component::{Context, List, Message, component};
use katydid_data::{Column, Value};
use katydid_geometry::Interval;

use crate::sets::dotnet_random::DotNetRandom;
use crate::sets::{count, integer};

/// Random numbers in a domain, or whole numbers with both ends among them.
fn draw(
    context: &Context<'_>,
    range: Interval,
    number: i32,
    seed: i32,
    whole: bool,
) -> Result<Vec<Value>, Message> {
    let n = count(number, "Number")?;
    context.items(n)?;
    let mut random = DotNetRandom::new(seed);
    if !whole {
        let length = range.end - range.start;
        return Ok((0..n).map(|_| Value::Number(range.start + length * random.next_double())).collect());
    }
    // Casts of numbers saturate: a domain beyond all integers ends where they do.
    let end = |x: f64| x.round_ties_even() as i32;
    let (low, high) = (end(range.start), end(range.end));
    Ok((0..n).map(|_| Value::Integer(random.next_between(low, high))).collect())
}

/// Random numbers in a domain; the same seed gives the same numbers always.
///
/// A setting makes them whole numbers, with both ends of the domain among them.
#[component("2ab17f9a-d852-4405-80e1-938c5e57e78d", name = "Random", nick = "Random", at = "Sets/Sequence")]
#[output("Random", "R", "The numbers.")]
fn random(
    context: &Context<'_>,
    /// Where the numbers lie.
    #[port("Range", "R", default = Interval::new(0.0, 1.0))]
    range: Interval,
    /// How many numbers, 0 or more.
    #[port("Number", "N", default = 1)]
    number: i32,
    /// Another seed gives other numbers.
    #[port("Seed", "S", default = 2)]
    seed: i32,
) -> Result<Vec<Value>, Message> {
    let whole = context.settings().child("ValueTable").and_then(|table| table.bool("Integers"));
    draw(context, range, number, seed, whole.unwrap_or(false))
}

/// Random numbers in a domain; the same seed gives the same numbers always.
#[component(
    "b7e4e0ef-a01d-48c4-93be-2a12d4417e22",
    name = "Random",
    nick = "Random",
    at = "Sets/Sequence",
    old
)]
#[output("Range", "R", "The numbers.")]
fn random_with_integers(
    context: &Context<'_>,
    /// Where the numbers lie.
    #[port("Range", "R", default = Interval::new(0.0, 1.0))]
    range: Interval,
    /// How many numbers, 0 or more.
    #[port("Number", "N", default = 1)]
    number: i32,
    /// Another seed gives other numbers.
    #[port("Seed", "S", default = 2)]
    seed: i32,
    /// Whole numbers, with both ends of the domain among them.
    #[port("Integers", "I", default = false)]
    integers: bool,
) -> Result<Vec<Value>, Message> {
    draw(context, range, number, seed, integers)
}

/// Random whole numbers between two others, both ends included; the same seed gives the same numbers always.
#[component("a12dddbf-bb49-4ef4-aeb8-5653bc882cbd", name = "RandomEx", nick = "RndEx", at = "Sets/Sequence")]
#[output("Values", "V", "The numbers.")]
fn random_ex(
    context: &Context<'_>,
    /// The smallest number.
    #[port("Min", "L0")]
    min: i32,
    /// The largest number.
    #[port("Max", "L1")]
    max: i32,
    /// How many numbers, 0 or more.
    #[port("Count", "N")]
    number: i32,
    /// Another seed gives other numbers.
    #[port("Seed", "S")]
    seed: i32,
) -> Result<Vec<i32>, Message> {
    let n = count(number, "Count")?;
    context.items(n)?;
    let mut random = DotNetRandom::new(seed);
    Ok((0..n).map(|_| random.next_between(min, max)).collect())
}

/// Shuffles a list, a little or thoroughly; the same seed gives the same order always.
///
/// Each item gets a random key within a share of the list's length around its place, and the items are sorted by
/// these keys: 0 leaves the order as it is, 1 shuffles almost completely.
#[component("f02a20f6-bb49-4e3d-b155-8ed5d3c6b000", name = "Jitter", nick = "Jitter", at = "Sets/Sequence")]
#[output("Values", "V", "The shuffled list.")]
#[output("Indices", "I", "For each item its index in the list that came in.")]
fn jitter(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// How much: from 0 to 1.
    #[port("Jitter", "J", default = 1.0)]
    strength: f64,
    /// Another seed gives another order.
    #[port("Seed", "S", default = 2)]
    seed: i32,
) -> Result<(Column, Vec<i32>), Message> {
    context.items(list.len().saturating_mul(2))?;
    if !strength.is_finite() {
        return Err(Message::error("Jitter is not a number"));
    }
    let mut random = DotNetRandom::new(seed);
    let reach = strength.abs() * list.len() as f64;
    let mut keys: Vec<(f64, usize)> =
        (0..list.len()).map(|i| (i as f64 - reach + 2.0 * reach * random.next_double(), i)).collect();
    keys.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let order: Vec<usize> = keys.into_iter().map(|(_, i)| i).collect();
    Ok((list.gather(&order), order.into_iter().map(integer).collect()))
}

/// Leaves out a number of items by chance; the others keep their order. The same seed leaves out the same items
/// always.
#[component(
    "455925fd-23ff-4e57-a0e7-913a4165e659",
    name = "Random Reduce",
    nick = "Reduce",
    at = "Sets/Sequence"
)]
#[output("List", "L", "The items that are left.")]
fn random_reduce(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// How many items go: none when negative, all when there are no more.
    #[port("Reduction", "R")]
    reduction: i32,
    /// Another seed leaves out others.
    #[port("Seed", "S", default = 1)]
    seed: i32,
) -> Result<Vec<Option<Value>>, Message> {
    let n = list.len();
    context.items(n)?;
    let reduction = usize::try_from(reduction).unwrap_or(0);
    if reduction >= n {
        return Ok(Vec::new());
    }
    let mut random = DotNetRandom::new(seed);
    let mut left = Left::all(n);
    for gone in 0..reduction {
        left.take(random.next_below(n - gone));
    }
    Ok(list.iter().zip(left.flags).filter_map(|(item, left)| left.then_some(item)).collect())
}

/// The items still there, found by their number among those: a binary indexed tree (Fenwick 1994), in which
/// place i counts the items of the run of `i & -i` places that ends there.
struct Left {
    counts: Vec<usize>,
    flags: Vec<bool>,
}

impl Left {
    fn all(n: usize) -> Self {
        Self { counts: (0..=n).map(|i| i & i.wrapping_neg()).collect(), flags: vec![true; n] }
    }

    /// Takes out the item that has `k` others before it.
    fn take(&mut self, k: usize) {
        let n = self.flags.len();
        let mut place = 0;
        let mut before = k;
        let mut step = n.checked_ilog2().map_or(0, |bits| 1 << bits);
        while step > 0 {
            let next = place + step;
            if let Some(&count) = self.counts.get(next).filter(|&&count| count <= before) {
                place = next;
                before -= count;
            }
            step /= 2;
        }
        let Some(flag) = self.flags.get_mut(place) else { return };
        *flag = false;
        let mut i = place + 1;
        while let Some(count) = self.counts.get_mut(i) {
            *count = count.saturating_sub(1);
            i += i & i.wrapping_neg();
        }
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_definition::archive::Chunk;

    use super::*;

    #[test]
    fn random_is_that_of_dotnet() {
        let trial = Trial::of("Random").item("20").item(10).item(1);
        assert_eq!(
            trial.texts(0),
            [concat!(
                "{0;0}: 4.973372, 2.21488, 9.340214, 15.432082, 13.150378, ",
                "8.655652, 7.081675, 18.877246, 2.025329, 12.849111"
            )]
        );
        let both = Trial::of("Random").default().item(1).list([1, -1]);
        assert_eq!(both.texts(0), ["{0;0}: 0.248669", "{0;1}: 0.248669"]);
        assert_eq!(Trial::of("Random").default().item(0).texts(0), ["{0;0}:"]);
        assert!(Trial::of("Random").default().item(-1).message().contains("negative"));
        assert!(Trial::of("Random").default().item(i32::MAX).message().contains("items"));
    }

    #[test]
    fn whole_numbers_reach_both_ends() {
        let mut table = Chunk::new("ValueTable");
        table.set("Integers", true);
        let mut settings = Chunk::default();
        settings.set_child(table);
        let trial = Trial::of("Random").item(Interval::new(0.0, 1.0)).item(6).item(1).settings(settings);
        assert_eq!(trial.texts(0), ["{0;0}: 0, 0, 0, 1, 1, 0"]);
        let old =
            Trial::of_guid("b7e4e0ef-a01d-48c4-93be-2a12d4417e22").item(Interval::new(3.0, 1.0)).item(50);
        let drawn = old.default().item(true).run();
        let drawn: Vec<_> = drawn.outputs[0].column().iter().flatten().collect();
        assert!([1, 2, 3].iter().all(|&i| drawn.contains(&Value::Integer(i))));
        assert_eq!(
            Trial::of("RandomEx").item(0).item(9).item(10).item(1).texts(0),
            ["{0;0}: 2, 1, 4, 7, 6, 4, 3, 9, 1, 6"]
        );
    }

    #[test]
    fn jitter_keeps_all_items() {
        let list = || Trial::of("Jitter").list([10, 11, 12, 13, 14, 15, 16, 17]);
        assert_eq!(list().item(0.0).texts(1), ["{0;0}: 0, 1, 2, 3, 4, 5, 6, 7"]);
        let shuffled = list().run();
        let indices: Vec<i32> = katydid_data::Item::slice(shuffled.outputs[1].column()).unwrap().to_vec();
        let mut sorted = indices.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, [0, 1, 2, 3, 4, 5, 6, 7]);
        assert_ne!(indices, sorted);
        for (k, i) in indices.into_iter().enumerate() {
            assert_eq!(shuffled.outputs[0].column().get(k), Some(Value::Integer(10 + i)));
        }
        assert_eq!(list().item(f64::INFINITY).message(), "Jitter is not a number");
    }

    #[test]
    fn reducing_removes_that_many_in_order() {
        let reduce = |n: i32| Trial::of("Random Reduce").list(0..9).item(n).item(3);
        assert_eq!(reduce(0).texts(0), ["{0;0}: 0, 1, 2, 3, 4, 5, 6, 7, 8"]);
        assert_eq!(reduce(-5).run().outputs[0].item_count(), 9);
        assert_eq!(reduce(9).texts(0), ["{0;0}:"]);
        let five = reduce(4).run();
        let kept: Vec<i32> = katydid_data::Item::slice(five.outputs[0].column()).unwrap().to_vec();
        assert_eq!(kept.len(), 5);
        assert!(kept.is_sorted());
        // The same as removing from a list one by one.
        let mut random = DotNetRandom::new(3);
        let mut list: Vec<i32> = (0..9).collect();
        for _ in 0..4 {
            list.remove(random.next_below(list.len()));
        }
        assert_eq!(kept, list);
    }

    #[test]
    fn half_a_million_go_at_once() {
        let half = Trial::of("Random Reduce").list((0..1_000_000).map(f64::from)).item(500_000).run();
        assert_eq!(half.outputs[0].item_count(), 500_000);
    }
}
