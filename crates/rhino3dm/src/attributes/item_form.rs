//! Attributes as items (section 7, archives from version 5 on): a code and a payload each, codes ascending, only
//! what differs from the default.

use uuid::Uuid;

use super::{Attributes, COLOUR_FROM_OBJECT, ObjectMode, StoredAttributes};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result, colour, typecode};

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
const LINETYPE_SOURCE: u8 = 17;
const GROUPS: u8 = 18;

pub(super) fn read(body: &mut Reader<'_>, stored: &mut StoredAttributes) -> Result<()> {
    let offset = body.offset();
    let (major, _) = body.packed_version(WHAT)?;
    if major != 2 {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    let attributes = &mut stored.attributes;
    attributes.id = body.uuid(WHAT)?;
    stored.layer_number = body.i32(WHAT)?;
    let (mut own_colour, mut colour_source) = ([0, 0, 0, 255], 0);
    loop {
        match body.u8(WHAT)? {
            NAME => attributes.name = body.string("object name")?,
            URL => attributes.url = body.string("object address")?,
            LINETYPE | MATERIAL => {
                body.i32(WHAT)?;
            }
            RENDERING => {
                body.expect(typecode::ANONYMOUS, "rendering attributes")?;
            }
            COLOUR => own_colour = colour::from_archive(body.colour(WHAT)?),
            PLOT_COLOUR => {
                body.colour(WHAT)?;
            }
            PLOT_WEIGHT => {
                body.f64(WHAT)?;
            }
            ARROWHEADS | PLOT_COLOUR_SOURCE..=LINETYPE_SOURCE => {
                body.u8(WHAT)?;
            }
            WIRE_DENSITY => attributes.wire_density = body.i32(WHAT)?,
            VISIBLE => attributes.visible = body.bool(WHAT)?,
            MODE => attributes.mode = ObjectMode::from_code(body.u8(WHAT)?),
            COLOUR_SOURCE => colour_source = body.u8(WHAT)?,
            GROUPS => attributes.groups = body.ints("groups")?,
            // The end, or something beyond what is read here: items have no length, so nothing after it can be.
            _ => break,
        }
    }
    attributes.colour = (colour_source == COLOUR_FROM_OBJECT).then_some(own_colour);
    Ok(())
}

pub(super) fn write(attributes: &Attributes, id: Uuid, w: &mut Writer) -> Result<()> {
    w.packed_version(2, 0);
    w.uuid(id);
    w.count(attributes.layer, "layers")?;
    for (code, text) in [(NAME, &attributes.name), (URL, &attributes.url)] {
        if !text.is_empty() {
            w.u8(code);
            w.string(text)?;
        }
    }
    if let Some(own) = attributes.colour {
        w.u8(COLOUR);
        w.colour(colour::to_archive(own));
    }
    if attributes.wire_density != 1 {
        w.u8(WIRE_DENSITY);
        w.i32(attributes.wire_density);
    }
    if !attributes.visible {
        w.u8(VISIBLE);
        w.bool(false);
    }
    if attributes.mode != ObjectMode::Normal {
        w.u8(MODE);
        w.u8(attributes.mode.code());
    }
    if attributes.colour.is_some() {
        w.u8(COLOUR_SOURCE);
        w.u8(COLOUR_FROM_OBJECT);
    }
    if !attributes.groups.is_empty() {
        w.u8(GROUPS);
        w.count(attributes.groups.len(), "groups")?;
        attributes.groups.iter().for_each(|group| w.i32(*group));
    }
    w.u8(0);
    Ok(())
}
