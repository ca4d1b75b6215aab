//! What a version 1 archive says about the whole model: program, notes, units, layers.

use super::attributes::colour_bytes;
use super::{text, typecode as code};
use crate::chunk::Reader;
use crate::unit_scale::stored_units;
use crate::{Layer, Model, Preview, Result, Revision, StoredBuffer, Time, colour, typecode};

const WHAT: &str = "units of version 1";
/// The last unit that version 1 knows.
const LAST_UNIT: i32 = 10;

/// Where Rhinoceros was to be found.
const RHINOCEROS: &str = "Rhinoceros";
const RHINOCEROS_URL: &str = "http://www.rhino3d.com";

/// The program that a comment names: behind `Interface:`, up to its version; more about it follows.
pub(super) fn read_comment(comment: &[u8], model: &mut Model) {
    let comment = String::from_utf8_lossy(comment);
    let comment = comment.trim_end_matches(['\0', '\x1A']);
    let Some((_, program)) = split_at_ignoring_case(comment, "Interface:") else { return };
    let program = program.trim_start_matches(is_space);
    let program = match program.split_once('(') {
        Some((program, _)) => program.trim_end_matches(is_space_or_dash),
        None => program,
    };
    let (mut name, mut details) = (program, "");
    if let Some(("", rest)) = split_at_ignoring_case(program, RHINOCEROS) {
        let version = rest.trim_start_matches(is_space);
        let behind = version.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
        RHINOCEROS_URL.clone_into(&mut model.properties.application_url);
        if behind.starts_with(is_space) {
            name = program.get(..program.len() - behind.len()).unwrap_or(program);
            details = behind.trim_start_matches(is_space_or_dash);
        }
    }
    if !name.is_empty() {
        name.clone_into(&mut model.application);
    }
    if !details.is_empty() {
        details.clone_into(&mut model.properties.application_details);
    }
}

fn is_space(c: char) -> bool {
    c <= ' '
}

fn is_space_or_dash(c: char) -> bool {
    is_space(c) || c == '-'
}

/// What stands before and behind a word of ASCII letters, in whatever case.
fn split_at_ignoring_case<'a>(whole: &'a str, word: &str) -> Option<(&'a str, &'a str)> {
    let at = whole.as_bytes().windows(word.len()).position(|w| w.eq_ignore_ascii_case(word.as_bytes()))?;
    Some((whole.get(..at)?, whole.get(at + word.len()..)?))
}

/// Notes: the window they stand in, then the text.
pub(super) fn read_notes(mut body: Reader<'_>, model: &mut Model) -> Result<()> {
    const WHAT: &str = "notes";
    let window = &mut model.properties.notes_window;
    window.visible = body.i32(WHAT)? != 0;
    for edge in &mut window.frame {
        *edge = body.i32(WHAT)?;
    }
    model.notes = text::counted(&mut body, WHAT)?;
    Ok(())
}

/// The summary: who made and changed the archive, and when.
pub(super) fn read_summary(mut body: Reader<'_>, model: &mut Model) -> Result<()> {
    const WHAT: &str = "summary";
    let mut revision = Revision { created_by: text::counted(&mut body, WHAT)?, ..Revision::default() };
    revision.created = Time::read(&mut body)?;
    body.i32(WHAT)?;
    revision.edited_by = text::counted(&mut body, WHAT)?;
    revision.edited = Time::read(&mut body)?;
    body.i32(WHAT)?;
    revision.count = body.i32(WHAT)?;
    body.finish();
    model.properties.revision = Some(revision);
    Ok(())
}

/// A small picture: a Windows bitmap without its file header.
pub(super) fn read_preview(mut body: Reader<'_>, model: &mut Model) -> Result<()> {
    let header = body.array("preview")?;
    model.properties.preview =
        Some(Preview { header, pieces: vec![StoredBuffer::new(body.rest().to_vec())] });
    Ok(())
}

/// Units and tolerances.
pub(super) fn read_units(mut body: Reader<'_>, model: &mut Model) -> Result<()> {
    body.i32(WHAT)?;
    let number = body.i32(WHAT)?;
    let number = if (0..=LAST_UNIT).contains(&number) { number } else { 0 };
    // The angle comes last here, and second in later versions.
    let (absolute, relative, angle) = (body.f64(WHAT)?, body.f64(WHAT)?, body.f64(WHAT)?);
    let stored = stored_units(number, [absolute, angle, relative], None);
    model.units = stored.units;
    model.unit_scale = stored.scale;
    model.tolerance = stored.tolerance;
    model.relative_tolerance = stored.relative_tolerance;
    model.settings.impossible_tolerances = stored.impossible;
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
