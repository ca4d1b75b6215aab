//! Lists: numbers of items.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;

fn count_of(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

/// The number of the last item of a list: its length less one. Stands for Pufferfish's Last Index.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3037",
    name = "Last Index",
    nick = "Last",
    at = "Pufferfish/List"
)]
#[output("Last Index", "i", "The number; -1 for an empty list.")]
fn last_index(
    /// The list.
    #[port("List", "L", optional)]
    list: List<Value>,
) -> i32 {
    count_of(list.len()) - 1
}

/// The numbers of the items of a list, from 0. Stands for Pufferfish's List Indices.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3038",
    name = "List Indices",
    nick = "Indices",
    at = "Pufferfish/List"
)]
#[output("Indices", "i", "The numbers.")]
fn list_indices(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L", optional)]
    list: List<Value>,
) -> Result<Vec<i32>, Message> {
    context.items(list.len())?;
    Ok((0..count_of(list.len())).collect())
}

/// So many numbers from 0 to 1 or to another end.
fn range(context: &Context<'_>, steps: i32, end: f64) -> Result<Vec<f64>, Message> {
    let count = usize::try_from(steps).ok().filter(|n| *n > 0);
    let count = count.ok_or_else(|| Message::error("There must be at least one step"))?;
    context.items(count)?;
    Ok((0..=count).map(|i| end * i as f64 / count as f64).collect())
}

/// Numbers from 0 to 1 in equal steps. Stands for Pufferfish's Reparameterized Range.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3039",
    name = "Reparameterized Range",
    nick = "RepaRange",
    at = "Pufferfish/Number"
)]
#[output("Range", "R", "The numbers, one more than steps.")]
fn unit_range(
    context: &Context<'_>,
    /// The number of steps.
    #[port("Steps", "N", default = 10)]
    steps: i32,
) -> Result<Vec<f64>, Message> {
    range(context, steps, 1.0)
}

/// Numbers from 0 to the number of a list's last item, in equal steps. Stands for Pufferfish's Last Index Range; the ports are our
/// reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f303a",
    name = "Last Index Range",
    nick = "LastRange",
    at = "Pufferfish/Number"
)]
#[output("Range", "R", "The numbers, one more than steps.")]
fn last_index_range(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L", optional)]
    list: List<Value>,
    /// The number of steps.
    #[port("Steps", "N", default = 10)]
    steps: i32,
) -> Result<Vec<f64>, Message> {
    range(context, steps, list.len().saturating_sub(1) as f64)
}

/// Numbers from 0 to a list's length, in equal steps. Stands for Pufferfish's List Length Range; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f303b",
    name = "List Length Range",
    nick = "LengRange",
    at = "Pufferfish/Number"
)]
#[output("Range", "R", "The numbers, one more than steps.")]
fn list_length_range(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L", optional)]
    list: List<Value>,
    /// The number of steps.
    #[port("Steps", "N", default = 10)]
    steps: i32,
) -> Result<Vec<f64>, Message> {
    range(context, steps, list.len() as f64)
}
