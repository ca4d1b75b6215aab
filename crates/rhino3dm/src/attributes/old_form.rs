//! Attributes of archives before version 5 (section 7): all fields in a fixed order.

use uuid::Uuid;

use super::{Attributes, COLOUR_FROM_OBJECT, ObjectMode, StoredAttributes};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result, colour};

const WHAT: &str = "object attributes";

pub(super) fn read(body: &mut Reader<'_>, stored: &mut StoredAttributes) -> Result<()> {
    let offset = body.offset();
    let (major, minor) = body.packed_version(WHAT)?;
    if major != 1 {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    let attributes = &mut stored.attributes;
    attributes.id = body.uuid(WHAT)?;
    stored.layer_number = body.i32(WHAT)?;
    body.i32("material")?;
    let own_colour = colour::from_archive(body.colour(WHAT)?);
    // A line style that was never used.
    body.take(20, WHAT)?;
    attributes.wire_density = body.i32(WHAT)?;
    attributes.mode = ObjectMode::from_code(body.u8(WHAT)?);
    let colour_source = body.u8(WHAT)?;
    body.take(2, WHAT)?;
    attributes.colour = (colour_source == COLOUR_FROM_OBJECT).then_some(own_colour);
    attributes.name = body.string("object name")?;
    attributes.url = body.string("object address")?;
    if minor >= 1 {
        attributes.groups = body.ints("groups")?;
    }
    // Version 2 has no such field: hidden objects have the mode only.
    attributes.visible = if minor >= 2 { body.bool(WHAT)? } else { attributes.mode != ObjectMode::Hidden };
    Ok(())
}

pub(super) fn write(attributes: &Attributes, id: Uuid, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 7);
    w.uuid(id);
    w.count(attributes.layer, "layers")?;
    w.i32(-1);
    w.colour(attributes.colour.map_or([0; 4], colour::to_archive));
    w.bytes(&[0; 12]);
    w.f64(1.0);
    w.i32(attributes.wire_density);
    w.u8(attributes.mode.code());
    w.u8(if attributes.colour.is_some() { COLOUR_FROM_OBJECT } else { 0 });
    w.bytes(&[0; 2]);
    w.string(&attributes.name)?;
    w.string(&attributes.url)?;
    w.count(attributes.groups.len(), "groups")?;
    attributes.groups.iter().for_each(|group| w.i32(*group));
    w.bool(attributes.visible);
    // No display references and no decoration; plot colour and plot weight by layer.
    w.i32(0);
    w.i32(0);
    w.u8(0);
    w.colour([0; 4]);
    w.u8(0);
    w.f64(0.0);
    // Default linetype, model space, no page references.
    w.i32(-1);
    w.u8(0);
    w.i32(0);
    // Rendering attributes: no materials, no mappings, casts and receives shadows.
    w.versioned(1, 3, |w| {
        w.i32(0);
        w.i32(0);
        w.bytes(&[1, 1, 0]);
        Ok(())
    })
}
