//! The Sets tab: lists, sequences, sets and trees.

#![allow(clippy::type_complexity, reason = "the result types of components are written out: they are ports")]

pub(crate) mod dotnet_random;
mod key;
mod list;
mod members;
mod numbered;
mod sequence;
mod similar;
mod text;
mod tree;

use katydid_component::{Context, Message};
use katydid_data::Value;

/// A count that a user gave.
///
/// # Errors
/// When it is negative, with the port's name.
pub(crate) fn count(n: i32, port: &str) -> Result<usize, Message> {
    usize::try_from(n).map_err(|_| Message::error(format!("{port} is negative: {n}")))
}

/// The number of something as an integer item.
pub(crate) fn integer(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

/// The place of index `i` in a list of `n` items, counted on round and round with `wrap`; `None` when it lies
/// outside, and always in an empty list.
fn place(i: i64, n: usize, wrap: bool) -> Option<usize> {
    let length = i64::try_from(n).ok().filter(|&n| n > 0)?;
    let at = if wrap { i.rem_euclid(length) } else { i };
    usize::try_from(at).ok().filter(|&at| at < n)
}

/// Asks for a tree of `n` items before it is given out. Unlike lists, trees of several iterations are not
/// counted when they are put out, so their room is taken here.
fn room(context: &Context<'_>, n: usize) -> Result<(), Message> {
    /// What one place of a column takes at most.
    const BYTES: usize = 32;
    context.items(n)?;
    context.bytes(n.saturating_mul(BYTES))
}

/// Whether an item has a part that is infinite or not a number.
fn is_invalid(value: &Value) -> bool {
    !match value {
        Value::Number(x) => x.is_finite(),
        Value::Complex(z) => z.re.is_finite() && z.im.is_finite(),
        Value::Domain(d) => d.start.is_finite() && d.end.is_finite(),
        Value::Point(p) => p.is_finite(),
        Value::Vector(v) => v.is_finite(),
        Value::Plane(p) => p.is_finite(),
        Value::Line(line) => line.is_finite(),
        _ => true,
    }
}
