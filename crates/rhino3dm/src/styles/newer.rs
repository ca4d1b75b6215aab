//! The form of dimension styles from version 60 on.

use uuid::Uuid;

use super::{Font, NEWER, Style, overrides};
use crate::Result;
use crate::chunk::{Reader, Writer};
use crate::class_object::{ClassObject, UserData, write_class};
use crate::tables::Component;

const WHAT: &str = "dimension style";
/// What stands for no number.
const NO_NUMBER: i32 = -2_147_483_647;
/// Units of styles: millimetres, or inches in models of such units (inches, feet, yards, miles).
const MILLIMETRES: i32 = 2;
const INCHES: i32 = 8;
const OF_INCHES: [i32; 4] = [8, 9, 10, 19];
/// What is in the names of styles in these units.
const METRIC_NAME: char = 'm';
const INCH_NAMES: [&str; 8] = ["in", "ft", "foot", "feet", "yd", "yard", "\"", "'"];
/// How styles of before version 60 look beyond what they say: tolerances and fractions as multiples of the height.
const FRACTION: f64 = 0.6;
const STACKED: f64 = 0.7;
/// Lengths leave out feet when there are none.
const ZERO_FEET: i32 = 4;
/// The comma or point in numbers.
const POINT: i32 = 0x2E;

/// Reads the style, when the class object is one of this form.
pub(super) fn read(object: &ClassObject<'_>) -> Result<Option<Style>> {
    let Some(mut body) = object.data.clone().filter(|_| object.class == NEWER) else { return Ok(None) };
    let (mut body, minor) = body.versioned_1(WHAT)?;
    let Component { id, number, name, .. } = Component::read_fields(&mut body)?;
    let mut style = Style { id, number, name, ..Style::default() };
    read_looks(&mut style, &mut body)?;
    read_colours(&mut style, &mut body)?;
    if minor >= 1 {
        read_leaders(&mut style, &mut body)?;
    }
    if minor >= 2 {
        style.font = Font::read(&mut body)?;
    }
    if minor >= 3 {
        read_mask(&mut style, &mut body)?;
    }
    if minor >= 4 {
        read_places(&mut style, &mut body)?;
    }
    if minor >= 5 {
        body.take(8, "units of lengths")?;
    }
    if minor >= 6 {
        (style.length.display, style.alternate.display) = (body.i32(WHAT)?, body.i32(WHAT)?);
    }
    body.finish();
    Ok(Some(style))
}

/// Sizes, texts, tolerances and the mask: up to the style that this one was made from.
fn read_looks(style: &mut Style, body: &mut Reader<'_>) -> Result<()> {
    style.extension = [body.f64(WHAT)?, body.f64(WHAT)?];
    style.arrow = [body.f64(WHAT)?, body.f64(WHAT)?];
    (style.centre_mark, style.gap, style.height) = (body.f64(WHAT)?, body.f64(WHAT)?, body.f64(WHAT)?);
    style.text_display = body.i32(WHAT)?;
    (style.text_orientation, style.text_location, style.text_angle) = match style.text_display {
        1 => (1, 1, 0),
        3 => (0, 1, 1),
        4 => (0, 1, 0),
        _ => (0, 0, 1),
    };
    // How angles are shown.
    body.i32(WHAT)?;
    // Formats of before the displays; feet and inches have two numbers.
    style.length.display = body.i32(WHAT)?.min(2);
    style.digits = [body.i32(WHAT)?, body.i32(WHAT)?];
    // A text style, of use in early files only.
    body.i32(WHAT)?;
    style.length.factor = body.f64(WHAT)?;
    style.shows_alternate = body.bool(WHAT)?;
    style.alternate.factor = body.f64(WHAT)?;
    style.alternate.display = body.i32(WHAT)?.min(2);
    style.alternate_digits = body.i32(WHAT)?;
    for affix in &mut style.affixes {
        *affix = body.string(WHAT)?;
    }
    style.line_extension = body.f64(WHAT)?;
    style.suppressed = [body.bool(WHAT)?, body.bool(WHAT)?];
    style.parent = body.uuid(WHAT)?;
    body.i32(WHAT)?;
    if body.bool(WHAT)? {
        let count = body.count(1, WHAT)?;
        style.own = body.take(count, WHAT)?.iter().map(|own| *own != 0).collect();
    }
    (style.tolerance, style.tolerance_digits) = (body.i32(WHAT)?, body.i32(WHAT)?);
    style.tolerances = [body.f64(WHAT)?, body.f64(WHAT)?];
    (style.tolerance_height, style.baseline) = (body.f64(WHAT)?, body.f64(WHAT)?);
    style.mask = body.bool(WHAT)?;
    style.mask_source = body.i32(WHAT)?;
    style.mask_colour = body.colour(WHAT)?;
    (style.scale, style.scale_source) = (body.f64(WHAT)?, body.i32(WHAT)?);
    style.source = body.uuid(WHAT)?;
    Ok(())
}

/// Colours, weights, rounding and arrowheads; the older form has the arrowheads alone.
fn read_colours(style: &mut Style, body: &mut Reader<'_>) -> Result<()> {
    // Colours with their sources, and the same in print; weights with their sources; a fixed length and whether it
    // counts; a rotation, digits of tolerances and a height of theirs.
    body.take(2 * (4 + 16) + 2 + 16 + 9 + 20, WHAT)?;
    // Arrows left out, moved text, symbols of arcs, fractions, rounding, zeros left out, second lengths below.
    body.take(2 + 8 + 12 + 24 + 16 + 1, WHAT)?;
    let first = body.i32(WHAT)?;
    body.i32(WHAT)?;
    style.arrow_kinds = [first, body.i32(WHAT)?];
    // Blocks of arrowheads.
    body.take(48, WHAT)?;
    Ok(())
}

fn read_leaders(style: &mut Style, body: &mut Reader<'_>) -> Result<()> {
    // What leaders show, and alignments of before.
    body.take(12, WHAT)?;
    style.leader_angle = body.i32(WHAT)?;
    // Their curve, and an angle.
    body.take(12, WHAT)?;
    style.has_landing = body.bool(WHAT)?;
    style.landing = body.f64(WHAT)?;
    // Alignments of before, whether text is drawn forward and ordinates have signs.
    body.take(10, WHAT)?;
    // The scale in words, the unit.
    body.chunk()?;
    body.i32(WHAT)?;
    Ok(())
}

fn read_mask(style: &mut Style, body: &mut Reader<'_>) -> Result<()> {
    let (mut body, _) = body.versioned_1("mask of text")?;
    style.mask = body.bool(WHAT)?;
    style.mask_source = body.i32(WHAT)?;
    style.mask_colour = body.colour(WHAT)?;
    style.mask_border = body.f64(WHAT)?;
    body.finish();
    Ok(())
}

fn read_places(style: &mut Style, body: &mut Reader<'_>) -> Result<()> {
    style.text_location = body.i32(WHAT)?;
    body.i32(WHAT)?;
    style.text_vertical = body.i32(WHAT)?;
    // Other alignments and orientations.
    body.take(20, WHAT)?;
    style.text_orientation = body.i32(WHAT)?;
    body.i32(WHAT)?;
    style.text_angle = body.i32(WHAT)?;
    body.i32(WHAT)?;
    body.bool(WHAT)?;
    Ok(())
}

/// Writes a style that came from an archive before version 60, in a model of the given unit: what it does not say is
/// what such styles do.
pub(super) fn write(style: &Style, user_data: &[UserData], model: i32, w: &mut Writer) -> Result<()> {
    write_class(w, NEWER, user_data, |w| {
        w.versioned(1, 9, |w| {
            Component::new(style.id, style.number, &style.name).write_fields(w)?;
            write_looks(style, w)?;
            write_colours(style, w);
            write_leaders(style, model, w)?;
            style.font.write(w)?;
            write_mask(style, w)?;
            write_places(style, w);
            Ok(())
        })
    })
}

fn write_looks(style: &Style, w: &mut Writer) -> Result<()> {
    let doubles = |w: &mut Writer, numbers: &[f64]| numbers.iter().for_each(|x| w.f64(*x));
    doubles(w, &style.extension);
    doubles(w, &style.arrow);
    doubles(w, &[style.centre_mark, style.gap, style.height]);
    w.i32(style.text_display());
    w.i32(0);
    w.i32(style.length.format());
    style.digits.iter().for_each(|digits| w.i32(*digits));
    w.i32(NO_NUMBER);
    w.f64(style.length.factor);
    w.bool(style.shows_alternate);
    w.f64(style.alternate.factor);
    w.i32(style.alternate.format());
    w.i32(style.alternate_digits);
    for affix in &style.affixes {
        w.string(affix)?;
    }
    w.f64(style.line_extension);
    style.suppressed.iter().for_each(|suppressed| w.bool(*suppressed));
    w.uuid(style.parent);
    let own = style.own.iter().filter(|own| **own).count();
    w.count(own, "numbers of its own")?;
    w.bool(own > 0);
    if own > 0 {
        w.count(overrides::NEWER, "numbers")?;
        let all = style.own.iter().copied().chain(std::iter::repeat(false));
        all.take(overrides::NEWER).for_each(|own| w.bool(own));
    }
    w.i32(style.tolerance);
    w.i32(style.tolerance_digits);
    doubles(w, &style.tolerances);
    doubles(w, &[style.tolerance_height, style.baseline]);
    w.bool(style.mask);
    w.i32(style.mask_source);
    w.colour(style.mask_colour);
    w.f64(style.scale);
    w.i32(style.scale_source);
    w.uuid(style.source);
    Ok(())
}

fn write_colours(style: &Style, w: &mut Writer) {
    // Colours are those of the layer, weights of the object.
    w.bytes(&[0; 2 * (4 + 16) + 2 + 16]);
    // A fixed length of extension lines, not in force.
    w.f64(1.0);
    w.bool(false);
    w.f64(0.0);
    w.i32(4);
    w.f64(FRACTION);
    w.bytes(&[0; 2 + 8]);
    w.f64(STACKED);
    w.i32(1);
    w.bytes(&[0; 24]);
    // Zeros that are left out: with feet and inches those of feet.
    w.i32(0);
    w.i32(0);
    w.i32(if style.length.format() == 2 { ZERO_FEET } else { 0 });
    w.i32(0);
    w.bool(false);
    let [arrow, leader] = style.arrow_kinds;
    [arrow, arrow, leader].iter().for_each(|kind| w.i32(*kind));
    [Uuid::nil(); 3].iter().for_each(|block| w.uuid(*block));
}

fn write_leaders(style: &Style, model: i32, w: &mut Writer) -> Result<()> {
    // Leaders show text, from its top left, and the middle of its first line; they run straight.
    let angle = i32::from(!matches!(style.text_display, 1 | 4));
    [1, 3, 4, angle, 1].iter().for_each(|number| w.i32(*number));
    w.f64(0.0);
    w.bool(false);
    w.f64(style.height);
    w.i32(0);
    w.i32(0);
    w.bool(true);
    w.bool(true);
    write_scale(style.scale, w)?;
    w.i32(unit_of(&style.name, model));
    Ok(())
}

/// The unit of a style of before version 60, as openNURBS tells it by its name, else by the model.
fn unit_of(name: &str, model: i32) -> i32 {
    let name = name.to_lowercase();
    if name.contains(METRIC_NAME) {
        MILLIMETRES
    } else if INCH_NAMES.iter().any(|part| name.contains(part)) || OF_INCHES.contains(&model) {
        INCHES
    } else {
        MILLIMETRES
    }
}

fn write_mask(style: &Style, w: &mut Writer) -> Result<()> {
    w.versioned(1, 1, |w| {
        w.bool(style.mask);
        w.i32(style.mask_source);
        w.colour(style.mask_colour);
        w.f64(style.gap);
        // No frame.
        w.i32(0);
        Ok(())
    })
}

/// Where text stands and how it is turned, units, and what came last.
fn write_places(style: &Style, w: &mut Writer) {
    let to_view = i32::from(style.text_display == 1);
    w.i32(style.text_location);
    // Radii: in the line, and horizontal.
    w.i32(1);
    // Text hangs from its left; leaders meet the middle of its first line.
    [0, 0, 1, 0].iter().for_each(|alignment| w.i32(*alignment));
    [0, to_view, style.text_orientation, to_view].iter().for_each(|orientation| w.i32(*orientation));
    w.i32(style.text_angle);
    w.i32(0);
    w.bool(false);
    w.i32(style.length.unit());
    w.i32(style.alternate.unit());
    w.i32(style.length.display);
    w.i32(style.alternate.display);
    // Centre marks are marks; the line is drawn always; text and arrows fit as they do.
    w.i32(1);
    w.bool(true);
    w.i32(0);
    w.i32(0);
    w.i32(POINT);
}

/// The scale in words: a length on paper, and one in the model.
fn write_scale(scale: f64, w: &mut Writer) -> Result<()> {
    let words = seventeen_digits(scale);
    w.versioned(1, 1, |w| {
        w.f64(1.0 / scale);
        w.f64(scale);
        // Locale and units of where it was typed.
        [0; 3].iter().for_each(|context| w.i32(*context));
        w.string(&format!("1 = {words}"))?;
        write_length(1.0, "1", w)?;
        write_length(scale, &words, w)?;
        // Whether it is a number to one, one to a number, or neither.
        let is_whole = |ratio: f64| ratio.fract() == 0.0;
        w.i32(if is_whole(scale) || is_whole(1.0 / scale) { 0 } else { 2 });
        Ok(())
    })
}

fn write_length(length: f64, words: &str, w: &mut Writer) -> Result<()> {
    w.versioned(1, 1, |w| {
        w.f64(length);
        // No unit: one that is one metre and has no name.
        w.versioned(1, 0, |w| {
            w.i32(0);
            w.f64(1.0);
            w.string("")
        })?;
        w.i32(2);
        w.i32(0);
        w.string(words)?;
        w.i32(3);
        Ok(())
    })
}

/// A number in as many digits as tell it from every other, zeros at the end left out: `%.17g` of C.
fn seventeen_digits(number: f64) -> String {
    let scientific = format!("{number:.16e}");
    let Some((digits, exponent)) = scientific.split_once('e') else { return scientific };
    let trimmed = |text: &str| {
        if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        } else {
            text.to_owned()
        }
    };
    match exponent.parse::<i32>() {
        Ok(power @ -4..17) => {
            trimmed(&format!("{number:.*}", usize::try_from(16 - power).unwrap_or_default()))
        }
        Ok(power) => format!("{}e{}{:02}", trimmed(digits), if power < 0 { '-' } else { '+' }, power.abs()),
        Err(_) => scientific,
    }
}

#[cfg(test)]
mod tests {
    use super::seventeen_digits;

    #[test]
    fn numbers_are_written_as_c_writes_them() {
        for (number, words) in [
            (1.0, "1"),
            (2.5, "2.5"),
            (0.1, "0.10000000000000001"),
            (0.827_442_835_330_452_8, "0.82744283533045282"),
            (1e-5, "1.0000000000000001e-05"),
            (1e17, "1e+17"),
            (123_456.75, "123456.75"),
        ] {
            assert_eq!(seventeen_digits(number), words);
        }
    }
}
