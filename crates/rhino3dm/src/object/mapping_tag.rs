//! Which texture mapping made the texture coordinates of a mesh or a SubD (section 8).

use uuid::{Uuid, uuid};

use crate::Result;
use crate::chunk::{Reader, Writer};

const WHAT: &str = "mapping tag";
/// The mapping whose texture coordinates are the surface parameters.
const SURFACE_PARAMETERS: Uuid = uuid!("B988A6C2-61A6-45A7-AAEE-9AED7EF4E316");
/// Its checksum and the number of its kind, as openNURBS has them built in.
const SURFACE_PARAMETERS_CRC: u32 = 0xFE03_7B66;
const SURFACE_PARAMETERS_KIND: u32 = 1;

/// Names the texture mapping that texture coordinates come from.
#[derive(Debug, Clone, PartialEq)]
pub struct MappingTag {
    /// The identifier of the mapping; nil when there is none.
    pub mapping: Uuid,
    /// The checksum that the mapping had.
    pub crc: u32,
    /// What the object was transformed by since, row after row.
    pub transform: [f64; 16],
    /// The kind of mapping as archives number it: 0 for none, 1 for surface parameters.
    pub kind: u32,
}

impl Default for MappingTag {
    fn default() -> Self {
        let transform = std::array::from_fn(|i| if i % 5 == 0 { 1.0 } else { 0.0 });
        Self { mapping: Uuid::nil(), crc: 0, transform, kind: 0 }
    }
}

impl MappingTag {
    /// The tag of texture coordinates that are surface parameters.
    pub(crate) fn surface_parameters() -> Self {
        Self {
            mapping: SURFACE_PARAMETERS,
            crc: SURFACE_PARAMETERS_CRC,
            kind: SURFACE_PARAMETERS_KIND,
            ..Self::default()
        }
    }

    pub(crate) fn read(body: &mut Reader<'_>) -> Result<Self> {
        let (mut chunk, minor) = body.versioned_1(WHAT)?;
        let mut tag = Self { mapping: chunk.uuid(WHAT)?, crc: chunk.u32(WHAT)?, ..Self::default() };
        for x in &mut tag.transform {
            *x = chunk.f64(WHAT)?;
        }
        if minor >= 1 {
            tag.kind = chunk.u32(WHAT)?;
        } else if tag.mapping == SURFACE_PARAMETERS {
            tag.kind = SURFACE_PARAMETERS_KIND;
        }
        chunk.finish();
        Ok(tag)
    }

    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        w.versioned(1, 1, |w| {
            w.uuid(self.mapping);
            w.u32(self.crc);
            self.transform.iter().for_each(|x| w.f64(*x));
            w.u32(self.kind);
            Ok(())
        })
    }
}
