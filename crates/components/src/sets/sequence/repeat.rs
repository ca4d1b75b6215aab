//! Giving items more than once.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;

use crate::sets::count;

/// Gives a list several times: the whole list again and again, or each item several times in a row.
#[component(
    "dd8134c0-109b-4012-92be-51d843edfff7",
    name = "Duplicate Data",
    nick = "Dup",
    at = "Sets/Sequence"
)]
#[output("Data", "D", "The longer list.")]
fn duplicate_data(
    context: &Context<'_>,
    /// The list.
    #[port("Data", "D")]
    data: List<Value>,
    /// How often, 0 or more.
    #[port("Number", "N", default = 2)]
    number: i32,
    /// True for the whole list again and again, false for each item by itself.
    #[port("Order", "O", default = true)]
    order: bool,
) -> Result<Vec<Option<Value>>, Message> {
    let n = count(number, "Number")?;
    context.items(data.len().saturating_mul(n))?;
    context.bytes(data.len().saturating_mul(n).saturating_mul(2 * size_of::<Value>()))?;
    Ok(if order {
        (0..n).flat_map(|_| data.iter()).collect()
    } else {
        data.iter().flat_map(|item| std::iter::repeat_n(item, n)).collect()
    })
}

/// Gives a list several times, each item several times in a row. An early form of Duplicate Data.
#[component(
    "e6e344aa-f45b-43d5-a2d9-9cf8e8e608dc",
    name = "Duplicate data [OBSOLETE]",
    nick = "Dup",
    at = "Sets/Sequence",
    old
)]
#[output("Data", "D", "The longer list.")]
fn early_duplicate_data(
    context: &Context<'_>,
    /// The list.
    #[port("Data", "D")]
    data: List<Value>,
    /// How often, 0 or more.
    #[port("Number", "N", default = 2)]
    number: i32,
) -> Result<Vec<Option<Value>>, Message> {
    let n = count(number, "Number")?;
    context.items(data.len().saturating_mul(n))?;
    context.bytes(data.len().saturating_mul(n).saturating_mul(2 * size_of::<Value>()))?;
    Ok(data.iter().flat_map(|item| std::iter::repeat_n(item, n)).collect())
}

/// Sends a list one way or the other. An early form of Stream Gate.
#[component(
    "fbcf0d42-c9a5-4ca5-8d5b-567fb54abc43",
    name = "Split [OBSOLETE]",
    nick = "Split",
    at = "Sets/Sequence",
    old
)]
#[output("False", "F", "The items where the pattern is false.")]
#[output("True", "T", "The items where the pattern is true.")]
fn early_split(
    /// The list.
    #[port("Data", "D")]
    data: List<Value>,
    /// Where the items go: one value for all.
    #[port("Boolean", "B")]
    to_true: bool,
) -> (Vec<Option<Value>>, Vec<Option<Value>>) {
    if to_true { (Vec::new(), data.to_vec()) } else { (data.to_vec(), Vec::new()) }
}

/// Gives a list over and over until it has a given length; a longer list is cut.
#[component(
    "c40dc145-9e36-4a69-ac1a-6d825c654993",
    name = "Repeat Data",
    nick = "Repeat",
    at = "Sets/Sequence"
)]
#[output("Data", "D", "The list of that length.")]
fn repeat_data(
    context: &Context<'_>,
    /// The list.
    #[port("Data", "D")]
    data: List<Value>,
    /// The length wanted, 0 or more.
    #[port("Length", "L")]
    length: i32,
) -> Result<Vec<Option<Value>>, Message> {
    let length = count(length, "Length")?;
    if data.is_empty() {
        if length > 0 {
            context.warn("The list is empty: there is nothing to repeat");
        }
        return Ok(Vec::new());
    }
    context.items(length)?;
    context.bytes(length.saturating_mul(2 * size_of::<Value>()))?;
    Ok((0..length).map(|i| data.get(i % data.len())).collect())
}

/// Gives each item as often as a number says; the numbers are used over and over.
#[component(
    "5fa4e736-0d82-4af0-97fb-30a79f4cbf41",
    name = "Stack Data",
    nick = "Stack",
    at = "Sets/Sequence"
)]
#[output("Data", "D", "The longer list.")]
fn stack_data(
    context: &Context<'_>,
    /// The list.
    #[port("Data", "D")]
    data: List<Value>,
    /// How often each item comes, 0 or more.
    #[port("Stack", "S")]
    stack: List<i32>,
) -> Result<Vec<Option<Value>>, Message> {
    if stack.is_empty() {
        return Err(Message::error("The list of numbers is empty"));
    }
    let mut result = Vec::new();
    for (i, item) in data.iter().enumerate() {
        let n = count(stack.get(i % stack.len()).unwrap_or(0), "Stack")?;
        context.items(result.len().saturating_add(n))?;
        context.bytes(n.saturating_mul(2 * size_of::<Value>()))?;
        result.extend(std::iter::repeat_n(item, n));
    }
    Ok(result)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn duplicates_in_both_orders() {
        let early = Trial::of("Duplicate data [OBSOLETE]").list([1, 2]).item(3);
        assert_eq!(early.texts(0), ["{0;0}: 1, 1, 1, 2, 2, 2"]);
        let split = |to: bool| Trial::of("Split [OBSOLETE]").list([1, 2]).item(to).run().outputs;
        let texts = katydid_component::testing::texts;
        assert_eq!(
            (texts(&split(true)[0]), texts(&split(true)[1])),
            (vec!["{0;0}:".into()], vec!["{0;0}: 1, 2".into()])
        );
        assert_eq!(texts(&split(false)[0]), ["{0;0}: 1, 2"]);
        let dup = |n: i32, order: bool| Trial::of("Duplicate Data").list([1, 2]).item(n).item(order);
        assert_eq!(dup(2, true).texts(0), ["{0;0}: 1, 2, 1, 2"]);
        assert_eq!(dup(2, false).texts(0), ["{0;0}: 1, 1, 2, 2"]);
        assert_eq!(dup(0, true).texts(0), ["{0;0}:"]);
        assert_eq!(dup(-2, true).message(), "Number is negative: -2");
        assert!(dup(i32::MAX, true).message().contains("items"));
    }

    #[test]
    fn repeats_to_a_length() {
        let repeat = |n: i32| Trial::of("Repeat Data").list(["10", "20", "30"]).item(n);
        assert_eq!(repeat(7).texts(0), ["{0;0}: 10, 20, 30, 10, 20, 30, 10"]);
        assert_eq!(repeat(2).texts(0), ["{0;0}: 10, 20"]);
        assert_eq!(repeat(0).texts(0), ["{0;0}:"]);
        assert!(repeat(-1).message().contains("negative"));
        let nothing = Trial::of("Repeat Data").list::<f64>([]).item(3);
        assert_eq!(nothing.message(), "The list is empty: there is nothing to repeat");
    }

    #[test]
    fn stacks_by_a_pattern() {
        let stack = |n: &[i32]| Trial::of("Stack Data").list([1, 2, 3]).list(n.iter().copied());
        assert_eq!(stack(&[2, 0]).texts(0), ["{0}: 1, 1, 3, 3"]);
        assert!(stack(&[]).message().contains("empty"));
        assert!(stack(&[-1]).message().contains("negative"));
        assert!(stack(&[i32::MAX]).message().contains("items"));
    }
}
