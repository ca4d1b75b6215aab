//! What a version 1 archive says about the whole model: program, notes, units, layers.

use super::attributes::colour_bytes;
use super::{text, typecode as code};
use crate::chunk::Reader;
use crate::{Layer, Model, Result, colour, settings, typecode};

const WHAT: &str = "units of version 1";
/// The last unit that version 1 knows.
const LAST_UNIT: i32 = 10;

/// The program that a comment names: behind `Interface:`, up to its version.
pub(super) fn application(comment: &[u8]) -> String {
    let comment = String::from_utf8_lossy(comment);
    let comment = comment.trim_end_matches(['\0', '\x1A']);
    let Some((_, name)) = split_at_ignoring_case(comment, "Interface:") else { return String::new() };
    let name = name.trim_start();
    let name = name.split('(').next().unwrap_or_default();
    let name = name.trim_end_matches(|c: char| c <= ' ' || c == '-');
    match split_at_ignoring_case(name, "Rhinoceros") {
        Some(("", rest)) => {
            let version: &str = rest.trim_start();
            let end = version.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(version.len());
            let length = name.len() - version.len() + end;
            name.get(..length).unwrap_or(name).trim_end().to_owned()
        }
        _ => name.to_owned(),
    }
}

/// What stands before and behind a word of ASCII letters, in whatever case.
fn split_at_ignoring_case<'a>(whole: &'a str, word: &str) -> Option<(&'a str, &'a str)> {
    let at = whole.as_bytes().windows(word.len()).position(|w| w.eq_ignore_ascii_case(word.as_bytes()))?;
    Some((whole.get(..at)?, whole.get(at + word.len()..)?))
}

/// Notes: the window they stand in, then the text.
pub(super) fn read_notes(mut body: Reader<'_>) -> Result<String> {
    body.take(20, "notes")?;
    text::counted(&mut body, "notes")
}

/// Units and tolerances.
pub(super) fn read_units(mut body: Reader<'_>, model: &mut Model) -> Result<()> {
    body.i32(WHAT)?;
    let number = body.i32(WHAT)?;
    let number = if (0..=LAST_UNIT).contains(&number) { number } else { 0 };
    // The angle comes last here, and second in later versions.
    let (absolute, relative, angle) = (body.f64(WHAT)?, body.f64(WHAT)?, body.f64(WHAT)?);
    let stored = settings::stored_units(number, [absolute, angle, relative], None);
    model.units = stored.units;
    model.unit_scale = stored.scale;
    model.tolerance = stored.tolerance;
    model.relative_tolerance = stored.relative_tolerance;
    Ok(())
}

/// A layer: a chunk a property.
pub(super) fn read_layer(mut chunks: Reader<'_>) -> Result<Layer> {
    let mut layer = Layer::default();
    while chunks.left() >= 8 {
        let mut chunk = chunks.chunk()?;
        match chunk.typecode {
            code::LAYER_NAME => layer.name = text::counted(&mut chunk.body, "layer name")?,
            code::COLOUR => layer.colour = colour::from_archive(colour_bytes(chunk.value)),
            code::LAYER_STATE => {
                layer.visible = chunk.value != 1;
                layer.locked = chunk.value == 2;
            }
            typecode::END_OF_TABLE => break,
            _ => {}
        }
    }
    Ok(layer)
}
