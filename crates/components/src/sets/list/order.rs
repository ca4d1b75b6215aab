//! The order of a list.

use katydid_component::{Context, Each, List, ManyLists, Message, component};
use katydid_data::{Column, Path, Tree, TreeBuilder, Value};

use super::ascending::ascending;
use crate::sets::room;

/// Turns a list round: the last item becomes the first.
#[component("6ec97ea8-c559-47a2-8d0f-ce80c794d1f4", name = "Reverse List", nick = "Rev", at = "Sets/List")]
#[output("List", "L", "The items from back to front.")]
fn reverse_list(
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
) -> Column {
    list.gather(&(0..list.len()).rev().collect::<Vec<_>>())
}

/// Moves all items of a list towards its front, or with a negative shift towards its back.
///
/// With Wrap what falls off at one end comes in again at the other; without it, it is gone.
#[component("4fdfe351-6c07-47ce-9fb9-be027fb62186", name = "Shift List", nick = "Shift", at = "Sets/List")]
#[output("List", "L", "The moved list.")]
fn shift_list(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// By how many places.
    #[port("Shift", "S", default = 1)]
    shift: i32,
    /// Bring in again what falls off.
    #[port("Wrap", "W", default = true)]
    wrap: bool,
) -> Result<Column, Message> {
    let n = list.len();
    context.items(n)?;
    let size = usize::try_from(shift.unsigned_abs()).unwrap_or(usize::MAX);
    let places: Vec<usize> = if !wrap {
        let kept = n.saturating_sub(size);
        let first = if shift > 0 { n - kept } else { 0 };
        (first..first + kept).collect()
    } else if n == 0 {
        Vec::new()
    } else {
        let first = if shift > 0 { size % n } else { (n - size % n) % n };
        (first..n).chain(0..first).collect()
    };
    Ok(list.gather(&places))
}

/// Cuts a list into pieces of given sizes, each in a branch of its own.
///
/// The sizes are used in turn, over and over; the last piece may be short. A size below 1 is an error.
#[component(
    "5a93246d-2595-4c28-bc2d-90657634f92a",
    name = "Partition List",
    nick = "Partition",
    at = "Sets/List"
)]
#[output("Chunks", "C", "The pieces; the path is one element longer, the number of the piece.")]
fn partition_list(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// The sizes, 1 or more.
    #[port("Size", "S", default = [3, 2])]
    sizes: List<i32>,
) -> Result<Tree, Message> {
    room(context, list.len())?;
    let sizes: Vec<usize> = sizes
        .present()
        .map(|size| match usize::try_from(size) {
            Ok(size) if size > 0 => Ok(size),
            _ => Err(Message::error(format!("A piece cannot have {size} items"))),
        })
        .collect::<Result<_, _>>()?;
    if sizes.is_empty() {
        return Err(Message::error("There is no size to cut the list by"));
    }
    let path: Path = context.path();
    let mut chunks = TreeBuilder::<Value>::new();
    let mut items = list.iter();
    for (k, &size) in sizes.iter().cycle().enumerate() {
        if items.len() == 0 {
            break;
        }
        chunks.branch(path.child(k));
        items.by_ref().take(size).for_each(|item| chunks.push(item));
    }
    Ok(chunks.finish())
}

/// Sorts a list of numbers from small to large, and other lists along with it.
///
/// Equal keys keep their order. Keys that are null or not a number are left out with a warning, and so are the
/// values beside them. A list of values should be as long as the keys: what is missing becomes null.
#[component(
    "6f93d366-919f-4dda-a35e-ba03dd62799b",
    name = "Sort List",
    nick = "Sort",
    at = "Sets/List",
    also("cacb2c64-61b5-46db-825d-c61d5d09cc08", "2b2628ea-3f43-4ce9-8435-9a045d54b5c6")
)]
#[output("Keys", "K", "The sorted numbers.")]
#[output("Values A", "A", "The values in the order of their keys.")]
fn sort_list(
    context: &Context<'_>,
    /// The numbers to sort by.
    #[port("Keys", "K")]
    keys: List<f64>,
    /// Values to be put in the same order.
    #[port("Values A", "A", optional)]
    values: ManyLists<Value>,
) -> Result<(Vec<f64>, Each<Column>), Message> {
    context.items(keys.len().saturating_mul(values.len() + 1))?;
    let (sorted_keys, indices) = match keys.as_slice().filter(|keys| !keys.iter().any(|x| x.is_nan())) {
        Some(keys) => {
            let indices = ascending(keys, || context.check().is_ok());
            given_up(context, &indices)?;
            (indices.iter().filter_map(|&i| keys.get(i).copied()).collect(), indices)
        }
        None => {
            let numbers = keys.iter().enumerate();
            let (numbers, places): (Vec<f64>, Vec<usize>) =
                numbers.filter_map(|(i, key)| Some((key.filter(|x| !x.is_nan())?, i))).unzip();
            if numbers.len() < keys.len() {
                context.warn("Some keys are null or not a number: they are left out");
            }
            let order = ascending(&numbers, || context.check().is_ok());
            given_up(context, &order)?;
            let keys: Vec<f64> = order.iter().filter_map(|&k| numbers.get(k).copied()).collect();
            (keys, order.iter().filter_map(|&k| places.get(k).copied()).collect())
        }
    };
    let sorted = values.iter().enumerate().map(|(k, list)| {
        if list.is_empty() && !context.has_data(k + 1) {
            return Column::nulls(0);
        }
        if list.len() != keys.len() {
            context.warn("A list of values is not as long as the list of keys");
        }
        list.gather(&indices)
    });
    let sorted = sorted.collect();
    Ok((sorted_keys, Each(sorted)))
}

/// Why there is no order, where it was given up.
fn given_up(context: &Context<'_>, order: &[usize]) -> Result<(), Message> {
    if order.is_empty() { context.check() } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn reverse_keeps_nulls() {
        assert_eq!(Trial::of("Reverse List").gaps([Some(1), None, Some(3)]).texts(0), ["{0}: 3, null, 1"]);
        assert_eq!(Trial::of("Reverse List").list::<f64>([]).texts(0), ["{0}:"]);
    }

    #[test]
    fn shift_moves_towards_the_front() {
        let shift =
            |s: i32, wrap: bool| Trial::of("Shift List").list([0, 1, 2, 3, 4, 5]).item(s).item(wrap).texts(0);
        assert_eq!(shift(1, false), ["{0;0}: 1, 2, 3, 4, 5"]);
        assert_eq!(shift(-2, false), ["{0;0}: 0, 1, 2, 3"]);
        assert_eq!(shift(6, false), ["{0;0}:"]);
        assert_eq!(shift(i32::MIN, false), ["{0;0}:"]);
        assert_eq!(shift(2, true), ["{0;0}: 2, 3, 4, 5, 0, 1"]);
        assert_eq!(shift(-7, true), ["{0;0}: 5, 0, 1, 2, 3, 4"]);
        assert_eq!(shift(i32::MIN, true), ["{0;0}: 4, 5, 0, 1, 2, 3"]);
        assert_eq!(Trial::of("Shift List").list::<f64>([]).item(3).texts(0), ["{0;0}:"]);
    }

    #[test]
    fn partition_cuts_into_branches() {
        let five = || Trial::of("Partition List").list([1, 2, 3, 4, 5]);
        assert_eq!(five().item(4).texts(0), ["{0;0}: 1, 2, 3, 4", "{0;1}: 5"]);
        assert_eq!(five().texts(0), ["{0;0}: 1, 2, 3", "{0;1}: 4, 5"]);
        assert_eq!(five().list([1, 2]).texts(0), ["{0;0}: 1", "{0;1}: 2, 3", "{0;2}: 4", "{0;3}: 5"]);
        assert_eq!(five().item(0).message(), "A piece cannot have 0 items");
        assert_eq!(five().list::<i32>([]).message(), "There is no size to cut the list by");
    }

    #[test]
    fn sorting_is_stable_and_takes_values_along() {
        let trial =
            || Trial::of("Sort List").list([3.0, 1.0, 3.0, 2.0]).list(["a", "b", "c", "d"]).outputs(2);
        assert_eq!(trial().texts(0), ["{0}: 1, 2, 3, 3"]);
        assert_eq!(trial().texts(1), ["{0}: b, d, a, c"]);
        let gaps = Trial::of("Sort List").gaps([Some(2.0), None, Some(1.0)]).list(["a", "b", "c"]).run();
        assert_eq!(katydid_component::testing::texts(&gaps.outputs[1]), ["{0}: c, a"]);
        assert!(gaps.messages[0].text.starts_with("Some keys"));
        let short = Trial::of("Sort List").list([2.0, 1.0]).list(["a"]);
        assert_eq!(short.texts(1), ["{0}: null, a"]);
    }

    #[test]
    fn a_million_keys_are_sorted_at_once() {
        let keys = (0..1_000_000_i64).map(|i| ((i * 7919) % 1_000_003) as f64);
        let sorted = Trial::of("Sort List").list(keys).run();
        assert!(katydid_data::Item::slice(sorted.outputs[0].column()).is_some_and(|s: &[f64]| s.is_sorted()));
    }
}
