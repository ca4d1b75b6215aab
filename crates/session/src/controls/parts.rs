//! Numbers, texts and colours on their way into a file.

use katydid_definition::archive::{Chunk, Colour as Argb, Decimal, ItemValue};
use katydid_definition::document::Object;

use crate::Refusal;
use crate::protocol::Colour;

/// The most letters of a text that a control holds.
const MOST_LETTERS: usize = 10_000_000;

/// The red, green, blue and alpha of a colour.
pub(crate) fn colour(c: Argb) -> Colour {
    [c.r, c.g, c.b, c.a]
}

/// The archive's order of a colour's parts.
pub(crate) fn argb([r, g, b, a]: Colour) -> Argb {
    Argb::new(a, r, g, b)
}

pub(crate) fn unfit(object: &Object, reason: &str) -> Refusal {
    Refusal::Unfit { object: object.title().to_owned(), reason: reason.to_owned() }
}

pub(crate) fn short(text: &str) -> Result<&str, Refusal> {
    if text.len() <= MOST_LETTERS {
        Ok(text)
    } else {
        Err(Refusal::Senseless(format!("a text has at most {MOST_LETTERS} bytes")))
    }
}

/// Refuses numbers that are not finite.
pub(crate) fn finite(numbers: &[f64]) -> Result<(), Refusal> {
    if numbers.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(Refusal::Senseless("a number must be finite".to_owned()))
    }
}

/// The chunk of a control's settings, which is made where it is missing.
pub(crate) fn part<'a>(object: &'a mut Object, name: &str) -> Result<&'a mut Chunk, Refusal> {
    let gone = unfit(object, "its settings are missing");
    let container = object.container_mut();
    if container.child(name).is_none() {
        container.set_child(Chunk::new(name));
    }
    container.child_mut(name).ok_or(gone)
}

/// A number as those controls keep it that count in tenths.
pub(crate) fn decimal(x: f64, places: u32) -> ItemValue {
    Decimal::from_f64(x, places).map_or(ItemValue::Double(x), ItemValue::Decimal)
}

/// A number in the form that is there.
pub(super) fn number(chunk: &mut Chunk, name: &str, x: f64) {
    let value = match chunk.item(name) {
        Some(ItemValue::Decimal(old)) => decimal(x, old.scale().max(6)),
        Some(ItemValue::Single(_)) => ItemValue::Single(x as f32),
        Some(ItemValue::Int32(_)) if x.fract() == 0.0 && x.abs() < 2e9 => ItemValue::Int32(x as i32),
        _ => ItemValue::Double(x),
    };
    chunk.set(name, value);
}
