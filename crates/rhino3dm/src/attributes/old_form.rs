//! Attributes of archives before version 5 (section 7): all fields in a fixed order.

use uuid::{Uuid, uuid};

use super::Attributes;
use super::item_form::{read_groups, write_groups};
use crate::choices::{ActiveSpace, Arrowheads, LinetypeChoice, ObjectMode, Source, write_place};
use crate::chunk::{Reader, Writer};
use crate::tables::Rendering;
use crate::values::{read_colour, read_id_pairs, write_colour, write_id_pairs};
use crate::{Error, Result};

const WHAT: &str = "object attributes";
/// The display mode that stands for being on a page.
const ON_PAGE: Uuid = uuid!("9BBB37E9-2131-4FB8-B9C6-5524859B98B8");
/// From this openNURBS version on the line style says nothing about arrowheads.
const OWN_ARROWHEADS_FROM: u32 = 200_503_170;

pub(super) fn read(body: &mut Reader<'_>, attributes: &mut Attributes) -> Result<()> {
    let offset = body.offset();
    let (major, minor) = body.packed_version(WHAT)?;
    if major != 1 {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    attributes.id = body.uuid(WHAT)?;
    attributes.layer = usize::try_from(body.i32(WHAT)?).ok();
    attributes.material = usize::try_from(body.i32("material")?).ok();
    let own_colour = read_colour(body, WHAT)?;
    let [pattern, _] = body.array(WHAT)?;
    let version = body.version();
    if version.archive < 4 || version.opennurbs < OWN_ARROWHEADS_FROM {
        attributes.arrowheads = Arrowheads::from_code(pattern);
    }
    // The rest of a line style that was never used.
    body.take(18, WHAT)?;
    attributes.wire_density = body.i32(WHAT)?;
    attributes.mode = ObjectMode::from_code(body.u8(WHAT)?);
    attributes.set_colour(own_colour, Source::from_code(body.u8(WHAT)?));
    attributes.linetype_source = Source::from_code(body.u8(WHAT)?);
    attributes.material_source = Source::from_code(body.u8(WHAT)?);
    attributes.name = body.string("object name")?;
    attributes.url = body.string("object address")?;
    if minor >= 1 {
        attributes.groups = read_groups(body)?;
    }
    // Version 2 has no such field: hidden objects have the mode only.
    attributes.visible = if minor >= 2 { body.bool(WHAT)? } else { attributes.mode != ObjectMode::Hidden };
    if minor >= 3 {
        attributes.display_modes = read_id_pairs(body, WHAT)?;
    }
    if minor >= 4 {
        let [arrowheads, ..] = body.array::<4>(WHAT)?;
        attributes.arrowheads = Arrowheads::from_code(arrowheads);
        attributes.plot_colour_source = Source::from_code(body.u8(WHAT)?);
        attributes.plot_colour = read_colour(body, WHAT)?;
        attributes.plot_weight_source = Source::from_code(body.u8(WHAT)?);
        attributes.plot_weight = body.f64(WHAT)?;
    }
    if minor >= 5 {
        attributes.linetype = LinetypeChoice::from_number(body.i32(WHAT)?);
    }
    if minor >= 6 {
        attributes.space = if body.u8(WHAT)? == 1 { ActiveSpace::Page } else { ActiveSpace::Model };
        let modes = read_id_pairs(body, WHAT)?;
        let (pages, modes): (Vec<_>, Vec<_>) = modes.into_iter().partition(|(_, mode)| *mode == ON_PAGE);
        attributes.viewport = pages.last().map_or(Uuid::nil(), |(page, _)| *page);
        attributes.display_modes = modes;
    }
    if minor >= 7 {
        attributes.rendering = Rendering::read(body)?;
    }
    Ok(())
}

pub(super) fn write(attributes: &Attributes, id: Uuid, w: &mut Writer) -> Result<()> {
    let (colour, colour_source) = attributes.stored_colour();
    let arrowheads = attributes.arrowheads.code();
    w.packed_version(1, 8);
    w.uuid(id);
    write_place(attributes.layer, "layers", w)?;
    write_place(attributes.material, "materials", w)?;
    write_colour(colour, w);
    w.bytes(&[arrowheads, 0, 0, 0]);
    w.f64(0.0);
    w.f64(1.0);
    w.i32(attributes.wire_density);
    w.u8(attributes.mode.code());
    w.u8(colour_source.code());
    w.u8(attributes.linetype_source.code());
    w.u8(attributes.material_source.code());
    w.string(&attributes.name)?;
    w.string(&attributes.url)?;
    write_groups(&attributes.groups, w)?;
    w.bool(attributes.visible);
    write_id_pairs(&attributes.display_modes, w)?;
    w.i32(i32::from(arrowheads));
    w.u8(attributes.plot_colour_source.code());
    write_colour(attributes.plot_colour, w);
    w.u8(attributes.plot_weight_source.code());
    w.f64(attributes.plot_weight);
    attributes.linetype.write(w)?;
    let on_page = attributes.space == ActiveSpace::Page;
    w.bool(on_page);
    let mut modes = attributes.display_modes.clone();
    if on_page && !attributes.viewport.is_nil() {
        modes.insert(0, (attributes.viewport, ON_PAGE));
    }
    write_id_pairs(&modes, w)?;
    attributes.rendering.write(w)
}
