//! Writing an archive (section 10): header, comment, every table a reader asks for, end mark.

use std::borrow::Cow;
use std::collections::HashSet;
use std::io::Write;

use uuid::Uuid;

use crate::chunk::Writer;
use crate::model::{Model, ModelObject};
use crate::read::{RecordCodes, SIGNATURE};
use crate::settings::{self, StoredUnits};
use crate::version::Version;
use crate::{Error, Layer, Result, class_ids, layer, object, typecode};

impl Model {
    /// The archive of version 4, 50, 60, 70 or 80 as bytes. The same model gives the same bytes: objects and
    /// layers without an identifier, or with one that another has already, get one made from their place and
    /// content.
    ///
    /// # Errors
    /// Another version, an object on a layer that is not there, a kept object whose bytes do not fit the version,
    /// or more data than the format can count.
    pub fn write(&self, version: i32) -> Result<Vec<u8>> {
        let mut w = Writer::new(Version::for_writing(version)?);
        w.bytes(SIGNATURE);
        w.bytes(format!("{version:>8}").as_bytes());
        w.chunk(typecode::COMMENT, |w| {
            w.bytes(b" Written by Katydid.\x1A\0");
            Ok(())
        })?;
        self.write_tables(&mut w)?;
        let wide = w.version().is_wide();
        // The end mark counts itself.
        let length = w.len() + if wide { 12 + 8 } else { 8 + 4 };
        w.chunk(typecode::END_OF_FILE, |w| {
            if wide {
                w.bytes(&(length as u64).to_le_bytes());
            } else {
                let short = u32::try_from(length).map_err(|_| Error::CannotWrite {
                    what: format!("an archive of {length} bytes"),
                    version,
                    why: "archives of this version end at 4 GiB".into(),
                })?;
                w.u32(short);
            }
            Ok(())
        })?;
        Ok(w.into_bytes())
    }

    /// [`Model::write`] into any destination.
    ///
    /// # Errors
    /// As [`Model::write`], and when the destination fails.
    pub fn write_to(&self, version: i32, destination: &mut impl Write) -> Result<()> {
        destination.write_all(&self.write(version)?)?;
        Ok(())
    }

    fn write_tables(&self, w: &mut Writer) -> Result<()> {
        self.write_properties(w)?;
        table(w, typecode::SETTINGS_TABLE, |w| {
            w.chunk(typecode::UNITS, |w| {
                let stored = StoredUnits {
                    units: self.units,
                    scale: self.unit_scale.clone(),
                    tolerance: self.tolerance,
                    relative_tolerance: self.relative_tolerance,
                };
                settings::write_units(&stored, w)
            })
        })?;
        for empty in [
            typecode::BITMAP_TABLE,
            typecode::TEXTURE_MAPPING_TABLE,
            typecode::MATERIAL_TABLE,
            typecode::LINETYPE_TABLE,
        ] {
            table(w, empty, |_| Ok(()))?;
        }
        let layers = self.layers_to_write();
        table(w, typecode::LAYER_TABLE, |w| write_layers(&layers, w))?;
        table(w, typecode::GROUP_TABLE, |_| Ok(()))?;
        if w.version().archive < 60 {
            table(w, typecode::FONT_TABLE, |_| Ok(()))?;
        }
        table(w, typecode::DIMENSION_STYLE_TABLE, |_| Ok(()))?;
        let mut ids = Ids::default();
        // Identifiers are unique over lights and objects together.
        table(w, typecode::LIGHT_TABLE, |w| {
            self.lights.iter().enumerate().try_for_each(|(place, light)| {
                write_record(light, place, layers.len(), &mut ids, typecode::LIGHT_RECORD, w)
            })
        })?;
        table(w, typecode::HATCH_PATTERN_TABLE, |_| Ok(()))?;
        table(w, typecode::INSTANCE_DEFINITION_TABLE, |_| Ok(()))?;
        table(w, typecode::OBJECT_TABLE, |w| {
            self.objects.iter().enumerate().try_for_each(|(place, object)| {
                write_record(object, place, layers.len(), &mut ids, typecode::OBJECT_RECORD, w)
            })
        })?;
        table(w, typecode::HISTORY_TABLE, |_| Ok(()))
    }

    fn write_properties(&self, w: &mut Writer) -> Result<()> {
        table(w, typecode::PROPERTIES_TABLE, |w| {
            w.short(typecode::OPENNURBS_VERSION, i64::from(w.version().opennurbs));
            if !self.notes.is_empty() {
                w.chunk(typecode::NOTES, |w| {
                    w.packed_version(1, 1);
                    w.i32(0);
                    w.string(&self.notes)?;
                    // Shown, in a window of no particular place, not locked.
                    w.i32(1);
                    w.bytes(&[0; 16]);
                    w.bool(false);
                    Ok(())
                })?;
            }
            w.chunk(typecode::APPLICATION, |w| {
                w.packed_version(1, 0);
                w.string("Katydid")?;
                w.string("")?;
                w.string(env!("CARGO_PKG_VERSION"))
            })
        })
    }

    fn layers_to_write(&self) -> Cow<'_, [Layer]> {
        if self.layers.is_empty() { vec![Layer::new("Default")].into() } else { (&self.layers).into() }
    }
}

/// A table with its end mark.
fn table(w: &mut Writer, typecode: u32, records: impl FnOnce(&mut Writer) -> Result<()>) -> Result<()> {
    w.chunk(typecode, |w| {
        records(w)?;
        w.short(typecode::END_OF_TABLE, 0);
        Ok(())
    })
}

fn write_layers(layers: &[Layer], w: &mut Writer) -> Result<()> {
    let mut ids = Ids::default();
    for (place, layer) in layers.iter().enumerate() {
        let id = ids.take(layer.id, place, layer.name.as_bytes());
        w.chunk(typecode::LAYER_RECORD, |w| {
            object::write_class(w, class_ids::LAYER, &[], |w| layer::write(layer, place, id, w))
        })?;
    }
    Ok(())
}

fn write_record(
    object: &ModelObject,
    place: usize,
    layers: usize,
    ids: &mut Ids,
    typecode: u32,
    w: &mut Writer,
) -> Result<()> {
    let attributes = &object.attributes;
    if attributes.layer >= layers {
        return Err(Error::CannotWrite {
            what: format!("object {place}"),
            version: w.version().archive,
            why: format!("it lies on layer {}, but there are {layers} layers", attributes.layer),
        });
    }
    let is_object = typecode == typecode::OBJECT_RECORD;
    let codes = if is_object { RecordCodes::OBJECT } else { RecordCodes::LIGHT };
    w.chunk(typecode, |w| {
        if is_object {
            let kind = class_ids::object_type(object.geometry.class());
            w.short(typecode::OBJECT_RECORD_TYPE, i64::from(kind));
        }
        let start = w.len();
        object.geometry.write(w, &object.user_data)?;
        let id = ids.take(attributes.id, place, w.since(start));
        attributes.write(w, id, codes.attributes, codes.user_data)?;
        w.short(codes.end, 0);
        Ok(())
    })
}

/// The identifiers given out so far.
#[derive(Debug, Default)]
struct Ids(HashSet<Uuid>);

impl Ids {
    /// The wanted identifier, or one made from a place and some content when it is nil or taken.
    fn take(&mut self, wanted: Uuid, place: usize, content: &[u8]) -> Uuid {
        if !wanted.is_nil() && self.0.insert(wanted) {
            return wanted;
        }
        let mut round = place as u64;
        loop {
            let id = made_id(round, content);
            if self.0.insert(id) {
                return id;
            }
            round = round.wrapping_add(1 << 32);
        }
    }
}

/// An identifier of version 8 (custom, RFC 9562) from the FNV-1a hash of a number and some bytes.
fn made_id(number: u64, content: &[u8]) -> Uuid {
    const BASIS: u128 = 0x6C62_272E_07BB_0142_62B8_2175_6295_C58D;
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013B;
    let bytes = content.iter().copied().chain(number.to_le_bytes());
    let hash = bytes.fold(BASIS, |hash, byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME));
    uuid::Builder::from_custom_bytes(hash.to_be_bytes()).into_uuid()
}
