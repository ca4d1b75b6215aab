//! Attributes as items (section 7, archives from version 5 on): a code and a payload each, codes ascending, only
//! what differs from the default.

use uuid::Uuid;

use super::{
    ActiveSpace, Arrowheads, Attributes, BLACK, Clipping, LinetypeChoice, ObjectMode, Source, write_place,
};
use crate::chunk::{Reader, Writer};
use crate::tables::{Linetype, Rendering, SectionStyle};
use crate::values::{
    read_colour, read_id_list, read_id_pairs, read_matrix, write_colour, write_id_list, write_id_pairs,
    write_matrix,
};
use crate::{Error, Result};

const WHAT: &str = "object attributes";

const NAME: u8 = 1;
const URL: u8 = 2;
const LINETYPE: u8 = 3;
const MATERIAL: u8 = 4;
const RENDERING: u8 = 5;
const COLOUR: u8 = 6;
const PLOT_COLOUR: u8 = 7;
const PLOT_WEIGHT: u8 = 8;
const ARROWHEADS: u8 = 9;
const WIRE_DENSITY: u8 = 10;
const VISIBLE: u8 = 11;
const MODE: u8 = 12;
const COLOUR_SOURCE: u8 = 13;
const PLOT_COLOUR_SOURCE: u8 = 14;
const PLOT_WEIGHT_SOURCE: u8 = 15;
const MATERIAL_SOURCE: u8 = 16;
const LINETYPE_SOURCE: u8 = 17;
const GROUPS: u8 = 18;
const SPACE: u8 = 19;
const VIEWPORT: u8 = 20;
const DISPLAY_MODES: u8 = 21;
const DISPLAY_ORDER: u8 = 22;
/// Caps, joins and a clipping source, each written by betas of version 8 for a while.
const DEAD: std::ops::RangeInclusive<u8> = 23..=27;
const CLIPPING: u8 = 28;
const SECTION_SOURCE: u8 = 29;
const SECTION_HATCH: u8 = 30;
const SECTION_HATCH_SCALE: u8 = 31;
const SECTION_HATCH_ROTATION: u8 = 32;
const LINETYPE_SCALE: u8 = 33;
const HATCH_BACKGROUND: u8 = 34;
const HATCH_BOUNDARY: u8 = 35;
const FRAME: u8 = 36;
const SECTION_FILL_RULE: u8 = 37;
const OWN_LINETYPE: u8 = 38;
const SECTION_STYLE: u8 = 39;
const CLIPPING_LABEL: u8 = 40;
const CLIPPING_CUTS: u8 = 41;

pub(super) fn read(body: &mut Reader<'_>, attributes: &mut Attributes) -> Result<()> {
    let offset = body.offset();
    let (major, _) = body.packed_version(WHAT)?;
    if major != 2 {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    attributes.id = body.uuid(WHAT)?;
    attributes.layer = usize::try_from(body.i32(WHAT)?).ok();
    let (mut own_colour, mut colour_source) = (BLACK, Source::Layer);
    loop {
        match body.u8(WHAT)? {
            COLOUR => own_colour = read_colour(body, WHAT)?,
            COLOUR_SOURCE => colour_source = Source::from_code(body.u8(WHAT)?),
            code @ NAME..=DISPLAY_ORDER => read_item(code, body, attributes)?,
            code if DEAD.contains(&code) => {
                body.u8(WHAT)?;
            }
            code @ CLIPPING..=CLIPPING_CUTS => read_late_item(code, body, attributes)?,
            // The end, or something newer: items have no length, so nothing after it can be read.
            _ => break,
        }
    }
    attributes.set_colour(own_colour, colour_source);
    Ok(())
}

/// Items of every archive.
fn read_item(code: u8, body: &mut Reader<'_>, attributes: &mut Attributes) -> Result<()> {
    match code {
        NAME => attributes.name = body.string("object name")?,
        URL => attributes.url = body.string("object address")?,
        LINETYPE => attributes.linetype = LinetypeChoice::from_number(body.i32(WHAT)?),
        MATERIAL => attributes.material = usize::try_from(body.i32(WHAT)?).ok(),
        RENDERING => attributes.rendering = Rendering::read(body)?,
        PLOT_COLOUR => attributes.plot_colour = read_colour(body, WHAT)?,
        PLOT_WEIGHT => attributes.plot_weight = body.f64(WHAT)?,
        ARROWHEADS => attributes.arrowheads = Arrowheads::from_code(body.u8(WHAT)?),
        WIRE_DENSITY => attributes.wire_density = body.i32(WHAT)?,
        VISIBLE => attributes.visible = body.bool(WHAT)?,
        MODE => attributes.mode = ObjectMode::from_code(body.u8(WHAT)?),
        PLOT_COLOUR_SOURCE => attributes.plot_colour_source = Source::from_code(body.u8(WHAT)?),
        PLOT_WEIGHT_SOURCE => attributes.plot_weight_source = Source::from_code(body.u8(WHAT)?),
        MATERIAL_SOURCE => attributes.material_source = Source::from_code(body.u8(WHAT)?),
        LINETYPE_SOURCE => attributes.linetype_source = Source::from_code(body.u8(WHAT)?),
        GROUPS => attributes.groups = read_groups(body)?,
        SPACE => attributes.space = ActiveSpace::from_code(body.u8(WHAT)?),
        VIEWPORT => attributes.viewport = body.uuid(WHAT)?,
        DISPLAY_MODES => attributes.display_modes = read_id_pairs(body, WHAT)?,
        _ => attributes.display_order = body.i32(WHAT)?,
    }
    Ok(())
}

/// Items that came with version 8.
fn read_late_item(code: u8, body: &mut Reader<'_>, attributes: &mut Attributes) -> Result<()> {
    match code {
        CLIPPING => {
            let clipping = attributes.clipping.get_or_insert_default();
            clipping.none = body.bool(WHAT)?;
            clipping.planes = read_id_list(body, WHAT)?;
        }
        SECTION_SOURCE => attributes.section_source = body.u8(WHAT)?,
        SECTION_HATCH => section(attributes).hatch = Some(body.i32(WHAT)?),
        SECTION_HATCH_SCALE => section(attributes).hatch_scale = Some(body.f64(WHAT)?),
        SECTION_HATCH_ROTATION => section(attributes).hatch_rotation = Some(body.f64(WHAT)?),
        LINETYPE_SCALE => attributes.linetype_scale = body.f64(WHAT)?,
        HATCH_BACKGROUND => attributes.hatch_background = Some(read_colour(body, WHAT)?),
        HATCH_BOUNDARY => attributes.hatch_boundary = body.bool(WHAT)?,
        FRAME => attributes.frame = Some(read_matrix(body, WHAT)?),
        SECTION_FILL_RULE => section(attributes).fill_rule = Some(body.u8(WHAT)?),
        OWN_LINETYPE => attributes.own_linetype = Some(Box::new(Linetype::read_inside(body)?)),
        SECTION_STYLE => attributes.section_style = Some(Box::new(SectionStyle::read(body)?)),
        CLIPPING_LABEL => attributes.clipping_label = body.u8(WHAT)?,
        _ => attributes.clipping.get_or_insert_default().planes_cut = body.bool(WHAT)?,
    }
    Ok(())
}

/// The section style, which betas of version 8 wrote piece by piece.
fn section(attributes: &mut Attributes) -> &mut SectionStyle {
    attributes.section_style.get_or_insert_default()
}

/// Groups behind their count; numbers that cannot be any are left out.
pub(super) fn read_groups(body: &mut Reader<'_>) -> Result<Vec<usize>> {
    let numbers = body.ints("groups")?;
    Ok(numbers.into_iter().filter_map(|number| usize::try_from(number).ok()).collect())
}

pub(super) fn write_groups(groups: &[usize], w: &mut Writer) -> Result<()> {
    w.count(groups.len(), "groups")?;
    groups.iter().try_for_each(|group| w.count(*group, "groups"))
}

pub(super) fn write(attributes: &Attributes, id: Uuid, w: &mut Writer) -> Result<()> {
    w.packed_version(2, 13);
    w.uuid(id);
    write_place(attributes.layer, "layers", w)?;
    write_items(attributes, w)?;
    write_late_items(attributes, w)?;
    w.u8(0);
    Ok(())
}

fn write_items(attributes: &Attributes, w: &mut Writer) -> Result<()> {
    for (code, text) in [(NAME, &attributes.name), (URL, &attributes.url)] {
        if !text.is_empty() {
            w.u8(code);
            w.string(text)?;
        }
    }
    if attributes.linetype != LinetypeChoice::Continuous {
        w.u8(LINETYPE);
        attributes.linetype.write(w)?;
    }
    if attributes.material.is_some() {
        w.u8(MATERIAL);
        write_place(attributes.material, "materials", w)?;
    }
    if attributes.rendering != Rendering::default() {
        w.u8(RENDERING);
        attributes.rendering.write(w)?;
    }
    let (colour, colour_source) = attributes.stored_colour();
    for (code, colour) in [(COLOUR, colour), (PLOT_COLOUR, attributes.plot_colour)] {
        if colour != BLACK {
            w.u8(code);
            write_colour(colour, w);
        }
    }
    if attributes.plot_weight != 0.0 {
        w.u8(PLOT_WEIGHT);
        w.f64(attributes.plot_weight);
    }
    write_byte(ARROWHEADS, attributes.arrowheads.code(), 0, w);
    if attributes.wire_density != 1 {
        w.u8(WIRE_DENSITY);
        w.i32(attributes.wire_density);
    }
    write_byte(VISIBLE, u8::from(attributes.visible), 1, w);
    write_byte(MODE, attributes.mode.code(), 0, w);
    for (code, source) in [
        (COLOUR_SOURCE, colour_source),
        (PLOT_COLOUR_SOURCE, attributes.plot_colour_source),
        (PLOT_WEIGHT_SOURCE, attributes.plot_weight_source),
        (MATERIAL_SOURCE, attributes.material_source),
        (LINETYPE_SOURCE, attributes.linetype_source),
    ] {
        write_byte(code, source.code(), 0, w);
    }
    if !attributes.groups.is_empty() {
        w.u8(GROUPS);
        write_groups(&attributes.groups, w)?;
    }
    write_byte(SPACE, attributes.space.code(), ActiveSpace::Model.code(), w);
    if !attributes.viewport.is_nil() {
        w.u8(VIEWPORT);
        w.uuid(attributes.viewport);
    }
    if !attributes.display_modes.is_empty() {
        w.u8(DISPLAY_MODES);
        write_id_pairs(&attributes.display_modes, w)?;
    }
    if attributes.display_order != 0 {
        w.u8(DISPLAY_ORDER);
        w.i32(attributes.display_order);
    }
    Ok(())
}

fn write_late_items(attributes: &Attributes, w: &mut Writer) -> Result<()> {
    if let Some(Clipping { none, planes, .. }) = &attributes.clipping {
        w.u8(CLIPPING);
        w.bool(*none);
        write_id_list(planes, w)?;
    }
    write_byte(SECTION_SOURCE, attributes.section_source, 0, w);
    if (attributes.linetype_scale - 1.0).abs() > f64::EPSILON {
        w.u8(LINETYPE_SCALE);
        w.f64(attributes.linetype_scale);
    }
    if let Some(background) = attributes.hatch_background {
        w.u8(HATCH_BACKGROUND);
        write_colour(background, w);
    }
    write_byte(HATCH_BOUNDARY, u8::from(attributes.hatch_boundary), 0, w);
    if let Some(frame) = &attributes.frame {
        w.u8(FRAME);
        write_matrix(frame, w);
    }
    if let Some(linetype) = &attributes.own_linetype {
        w.u8(OWN_LINETYPE);
        linetype.write_inside(w)?;
    }
    if let Some(style) = &attributes.section_style {
        w.u8(SECTION_STYLE);
        style.write(w)?;
    }
    write_byte(CLIPPING_LABEL, attributes.clipping_label, 0, w);
    if attributes.clipping.as_ref().is_some_and(|clipping| !clipping.planes_cut) {
        w.bytes(&[CLIPPING_CUTS, 0]);
    }
    Ok(())
}

/// An item of one byte, unless that is the default.
fn write_byte(code: u8, value: u8, default: u8, w: &mut Writer) {
    if value != default {
        w.bytes(&[code, value]);
    }
}
