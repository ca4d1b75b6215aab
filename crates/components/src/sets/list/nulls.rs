//! Nulls and invalid items in lists.

use std::sync::Arc;

use katydid_component::{Context, List, ManyItems, Message, component};
use katydid_data::Value;

use crate::sets::{integer, is_invalid};

/// Tells whether an item is null, or cannot be worked with.
///
/// Invalid is a number, point, vector, domain or plane with a part that is infinite or not a number.
#[component(
    "c74efd0e-7fe3-4c2d-8c9d-295c5672fb13",
    name = "Null Item",
    nick = "Null",
    at = "Sets/List",
    also("66fbaae1-0fcf-4dbf-bcba-4395d8f6a3e6")
)]
#[output("Null Flags", "N", "True where there is no item.")]
#[output("Invalid Flags", "X", "True where there is an item that is not valid.")]
#[output("Description", "D", "What is there, in words.")]
fn null_item(
    /// The item, or a null.
    #[port("Item", "I", optional)]
    item: Option<Value>,
) -> (bool, bool, Arc<str>) {
    let Some(item) = item else { return (true, false, "Null item".into()) };
    let invalid = is_invalid(&item);
    let quality = if invalid { "Invalid" } else { "Valid" };
    (false, invalid, format!("{quality} {}", item.kind()).into())
}

/// Puts other items in the places of nulls and of items that are not valid.
///
/// The replacements are used in turn, over and over. Without any, the list stays as it is.
#[component(
    "f3230ecb-3631-4d6f-86f2-ef4b2ed37f45",
    name = "Replace Nulls",
    nick = "NullRep",
    at = "Sets/List"
)]
#[output("Items", "I", "The list without gaps.")]
#[output("Count", "N", "How many items were replaced.")]
fn replace_nulls(
    context: &Context<'_>,
    /// The list.
    #[port("Items", "I")]
    items: List<Value>,
    /// What to put in the gaps.
    #[port("Replacements", "R")]
    replacements: List<Value>,
) -> Result<(Vec<Option<Value>>, i32), Message> {
    context.items(items.len())?;
    if replacements.is_empty() {
        return Ok((items.to_vec(), 0));
    }
    let mut replaced = 0;
    let result = items
        .iter()
        .map(|item| match item.filter(|item| !is_invalid(item)) {
            Some(item) => Some(item),
            None => {
                replaced += 1;
                replacements.get((replaced - 1) % replacements.len())
            }
        })
        .collect();
    Ok((result, integer(replaced)))
}

/// Joins several lists to one with as few nulls as can be: at each place it takes the first input that has an
/// item there.
#[component(
    "e7c80ff6-0299-4303-be36-3080977c14a1",
    name = "Combine Data",
    nick = "Combine",
    at = "Sets/List"
)]
#[output("Result", "R", "The items.")]
#[output("Index", "I", "The number of the input that each comes from; -1 where all are null.")]
fn combine_data(
    /// A list with gaps.
    #[port("Input 0", "0", optional)]
    inputs: ManyItems<Value>,
) -> (Option<Value>, i32) {
    let found = inputs.into_iter().enumerate().find_map(|(k, item)| Some((k, item?)));
    match found {
        Some((k, item)) => (Some(item), integer(k)),
        None => (None, -1),
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn null_item_knows_three_states() {
        let trial = || Trial::of("Null Item").gaps([Some(1.0), None, Some(f64::NAN)]);
        assert_eq!(trial().texts(0), ["{0}: False, True, False"]);
        assert_eq!(trial().texts(1), ["{0}: False, False, True"]);
        assert_eq!(trial().texts(2), ["{0}: Valid Number, Null item, Invalid Number"]);
    }

    #[test]
    fn replacements_are_used_in_turn() {
        let trial = || Trial::of("Replace Nulls").gaps([None, Some("a"), None, None]);
        assert_eq!(trial().list(["x", "y"]).texts(0), ["{0}: x, a, y, x"]);
        assert_eq!(trial().list(["x", "y"]).texts(1), ["{0}: 3"]);
        assert_eq!(trial().list::<f64>([]).texts(0), ["{0}: null, a, null, null"]);
    }

    #[test]
    fn combine_takes_the_first_that_is_there() {
        let trial =
            || Trial::of("Combine Data").gaps([None, Some(1), None]).gaps([Some(2), Some(3), None]).texts(0);
        assert_eq!(trial(), ["{0}: 2, 1, null"]);
        let index = Trial::of("Combine Data").gaps([None, Some(1), None]).gaps([Some(2), Some(3), None]);
        assert_eq!(index.texts(1), ["{0}: 1, 0, -1"]);
    }
}
