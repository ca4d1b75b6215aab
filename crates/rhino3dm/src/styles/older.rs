//! The form of dimension styles before version 60, with the user data that version 50 adds.

use uuid::{Uuid, uuid};

use super::{Font, Length, OLDER, Style, field, overrides};
use crate::chunk::{Reader, Writer};
use crate::class_object::{ClassObject, UserData, write_class};
use crate::version::Version;
use crate::{Result, class_ids};

const WHAT: &str = "dimension style";
/// The user data with what version 50 added.
const EXTRA: Uuid = uuid!("513FDE53-7284-4065-8601-06CEA8B28D6F");
/// openNURBS reads every style of before version 60 with this distance between parallel dimension lines.
const BASELINE: f64 = 3.0;
/// The heights of tolerances of styles without the user data.
const TOLERANCE_HEIGHT: f64 = 0.7;
/// Formats and digits of angles in second lengths, which nobody sets.
const ALTERNATE_ANGLES: [i32; 2] = [0, 2];
const LENGTH_FORMATS: [usize; 2] = [11, 19];

/// Whether user data belongs to the form, which writes it anew.
pub(super) fn holds(data: &UserData) -> bool {
    data.class == EXTRA
}

/// Reads the style, when the class object is one of this form. Fonts are by number, the unit is that of the model.
pub(super) fn read(object: &ClassObject<'_>, fonts: &[Option<Font>], model: i32) -> Result<Option<Style>> {
    let Some(mut body) = object.data.clone().filter(|_| object.class == OLDER) else { return Ok(None) };
    let (_, minor) = body.packed_version(WHAT)?;
    let mut style = Style {
        baseline: BASELINE,
        tolerance_height: TOLERANCE_HEIGHT,
        alternate: Length::MODEL,
        ..Style::default()
    };
    let formats = read_fields(&mut style, minor, &mut body, fonts)?;
    for data in object.user_data.iter().filter(|data| holds(data)) {
        data.with_body(|body| read_extra(&mut style, body))?;
    }
    let factors = [style.length.factor, style.alternate.factor];
    style.length = Length::from_older(formats[0], factors[0], model);
    style.alternate = Length::from_older(formats[1], factors[1], model);
    (style.text_orientation, style.text_location, style.text_angle) = match style.text_display {
        1 => (1, 1, 1),
        3 => (0, 1, 1),
        4 => (0, 1, 0),
        _ => (0, 0, 1),
    };
    Ok(Some(style))
}

/// The body; gives the formats of lengths and of second lengths.
fn read_fields(
    style: &mut Style,
    minor: u8,
    body: &mut Reader<'_>,
    fonts: &[Option<Font>],
) -> Result<[i32; 2]> {
    let mut formats = [0; 2];
    (style.number, style.name) = (body.i32(WHAT)?, body.string(WHAT)?);
    style.extension = [body.f64(WHAT)?, body.f64(WHAT)?];
    let arrow = body.f64(WHAT)?;
    style.arrow = [arrow, style.arrow[1]];
    (style.centre_mark, style.gap) = (body.f64(WHAT)?, body.f64(WHAT)?);
    style.text_display = body.i32(WHAT)?;
    style.arrow_kinds[0] = newer_arrow(body.i32(WHAT)?);
    // The unit of angles.
    body.i32(WHAT)?;
    formats[0] = body.i32(WHAT)?;
    // How angles are shown.
    body.i32(WHAT)?;
    let length_digits = body.i32(WHAT)?;
    style.digits = [body.i32(WHAT)?, length_digits];
    let font = usize::try_from(body.i32(WHAT)?).ok().and_then(|number| fonts.get(number)?.clone());
    style.font = font.unwrap_or_default();
    if minor >= 1 {
        style.height = body.f64(WHAT)?;
    }
    if minor >= 2 {
        style.length.factor = body.f64(WHAT)?;
        let [prefix, suffix] = [body.string(WHAT)?, body.string(WHAT)?];
        style.shows_alternate = body.bool(WHAT)?;
        style.alternate.factor = body.f64(WHAT)?;
        formats[1] = body.i32(WHAT)?;
        style.alternate_digits = body.i32(WHAT)?;
        body.take(8, "angles of second lengths")?;
        style.affixes = [prefix, suffix, body.string(WHAT)?, body.string(WHAT)?];
        body.i32(WHAT)?;
    }
    if minor >= 3 {
        style.id = body.uuid(WHAT)?;
    }
    if minor >= 4 {
        style.line_extension = body.f64(WHAT)?;
    }
    if minor >= 5 {
        style.arrow[1] = body.f64(WHAT)?;
        style.arrow_kinds[1] = newer_arrow(body.i32(WHAT)?);
        style.suppressed = [body.bool(WHAT)?, body.bool(WHAT)?];
    }
    Ok(formats)
}

fn read_extra(style: &mut Style, body: &mut Reader<'_>) -> Result<()> {
    let (mut body, minor) = body.versioned_1(WHAT)?;
    style.parent = body.uuid(WHAT)?;
    let count = body.count(1, WHAT)?;
    let own: Vec<bool> = body.take(count, WHAT)?.iter().map(|own| *own != 0).collect();
    if !style.parent.is_nil() {
        style.own = overrides::to_newer(&own);
        let format = own.get(LENGTH_FORMATS[0]).copied().unwrap_or_default();
        if let Some(display) = style.own.get_mut(field::LENGTH_DISPLAY).filter(|_| format) {
            *display = true;
        }
    }
    (style.tolerance, style.tolerance_digits) = (body.i32(WHAT)?, body.i32(WHAT)?);
    // A style of tolerances that was never made is none.
    style.tolerance = if (0..=3).contains(&style.tolerance) { style.tolerance } else { 0 };
    style.tolerances = [body.f64(WHAT)?, body.f64(WHAT)?];
    style.tolerance_height = body.f64(WHAT)?;
    // The distance between dimension lines, which openNURBS passes over.
    body.f64(WHAT)?;
    if minor >= 1 {
        style.mask = body.bool(WHAT)?;
        style.mask_source = i32::from(body.i32(WHAT)? == 1);
        style.mask_colour = body.colour(WHAT)?;
    }
    if minor >= 2 {
        (style.scale, style.scale_source) = (body.f64(WHAT)?, body.i32(WHAT)?);
    }
    if minor >= 3 {
        style.source = body.uuid(WHAT)?;
    }
    body.finish();
    Ok(())
}

/// Writes a style under a number, which is that of its text style as well, in a model of the given unit.
pub(super) fn write(
    style: &Style,
    number: i32,
    user_data: &[UserData],
    model: i32,
    w: &mut Writer,
) -> Result<()> {
    let extra = extra(style, w.version())?;
    let all: Vec<UserData> = extra.into_iter().chain(user_data.iter().cloned()).collect();
    // Version 4 has no scale: it is part of all sizes.
    let scale = if w.version().archive < 5 { style.scale } else { 1.0 };
    let (format, factor) = style.length.to_older(model);
    let (alternate_format, alternate_factor) = style.alternate.to_older(model);
    write_class(w, OLDER, &all, |w| {
        w.packed_version(1, 5);
        w.i32(number);
        w.string(&style.name)?;
        style.extension.iter().for_each(|size| w.f64(size * scale));
        [style.arrow[0], style.centre_mark, style.gap].iter().for_each(|size| w.f64(size * scale));
        w.i32(style.text_display());
        w.i32(older_arrow(style.arrow_kinds[0]));
        w.i32(0);
        w.i32(format);
        w.i32(0);
        w.i32(style.digits[1]);
        w.i32(style.digits[0]);
        w.i32(number);
        w.f64(style.height * scale);
        w.f64(factor);
        w.string(&style.affixes[0])?;
        w.string(&style.affixes[1])?;
        w.bool(style.shows_alternate);
        w.f64(alternate_factor);
        w.i32(alternate_format);
        w.i32(style.alternate_digits);
        ALTERNATE_ANGLES.iter().for_each(|number| w.i32(*number));
        w.string(&style.affixes[2])?;
        w.string(&style.affixes[3])?;
        w.i32(0);
        w.uuid(style.id);
        w.f64(style.line_extension * scale);
        w.f64(style.arrow[1] * scale);
        w.i32(older_arrow(style.arrow_kinds[1]));
        style.suppressed.iter().for_each(|suppressed| w.bool(*suppressed));
        Ok(())
    })
}

/// The user data that version 50 has beside the style.
fn extra(style: &Style, version: Version) -> Result<Option<UserData>> {
    if version.archive < 5 {
        return Ok(None);
    }
    let mut own = overrides::to_older(&style.own);
    for (place, field) in LENGTH_FORMATS.into_iter().zip(field::LENGTH_DISPLAY..) {
        if let Some(own) = own.get_mut(place) {
            *own = style.owns(field);
        }
    }
    let mut data = UserData::core(EXTRA, 0, version, |w| {
        w.versioned(1, 3, |w| {
            w.uuid(style.parent);
            w.count(own.len(), "numbers")?;
            own.iter().for_each(|own| w.bool(*own));
            w.i32(if (0..=3).contains(&style.tolerance) { style.tolerance } else { 0 });
            w.i32(style.tolerance_digits);
            style.tolerances.iter().for_each(|tolerance| w.f64(*tolerance));
            w.f64(style.tolerance_height);
            w.f64(style.baseline);
            w.bool(style.mask);
            w.i32(i32::from(style.mask_source == 1));
            w.colour(style.mask_colour);
            w.f64(style.scale);
            w.i32(style.scale_source);
            w.uuid(style.source);
            Ok(())
        })
    })?;
    data.application = class_ids::OPENNURBS_5_APPLICATION;
    Ok(Some(data))
}

/// Arrowheads since version 60: none and blocks of one's own come first.
fn newer_arrow(older: i32) -> i32 {
    if (0..=7).contains(&older) { older + 2 } else { 2 }
}

fn older_arrow(newer: i32) -> i32 {
    if (2..=9).contains(&newer) { newer - 2 } else { 0 }
}
