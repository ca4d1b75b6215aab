//! Rendering attributes of objects and layers (section 7): materials and texture mappings of rendering programs.

use uuid::Uuid;

use crate::Result;
use crate::chunk::{Reader, Writer};
use crate::values::{IDENTITY, read_matrix, write_matrix};

/// What rendering programs add to an object.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendering {
    /// Materials, at most one a program.
    pub materials: Vec<MaterialReference>,
    /// Texture mappings, at most one list a program.
    pub mappings: Vec<MappingReference>,
    /// Whether the object casts shadows.
    pub casts_shadows: bool,
    /// Whether shadows fall on the object.
    pub receives_shadows: bool,
    /// Whether textures are previewed with all their mappings.
    pub advanced_preview: bool,
}

impl Default for Rendering {
    fn default() -> Self {
        Self {
            materials: Vec::new(),
            mappings: Vec::new(),
            casts_shadows: true,
            receives_shadows: true,
            advanced_preview: false,
        }
    }
}

/// A material of a rendering program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MaterialReference {
    /// The program.
    pub application: Uuid,
    /// The material in front.
    pub front: Uuid,
    /// The material on the back.
    pub back: Uuid,
    /// Where the material comes from, by its number in archives.
    pub source: i32,
}

/// The texture mappings of a rendering program.
#[derive(Debug, Clone, PartialEq)]
pub struct MappingReference {
    /// The program.
    pub application: Uuid,
    /// Channel, mapping, and the transform of the object (row after row) since the mapping was made.
    pub channels: Vec<(i32, Uuid, [f64; 16])>,
}

const WHAT: &str = "rendering attributes";

/// Reads materials behind a count.
pub(crate) fn read_materials(body: &mut Reader<'_>) -> Result<Vec<MaterialReference>> {
    let count = body.count(16, WHAT)?;
    let mut materials = Vec::new();
    for _ in 0..count {
        let (mut chunk, minor) = body.versioned_1("material reference")?;
        let (application, front) = (chunk.uuid(WHAT)?, chunk.uuid(WHAT)?);
        let mut material = MaterialReference { application, front, back: Uuid::nil(), source: 0 };
        chunk.i32(WHAT)?;
        if minor >= 1 {
            (material.back, material.source) = (chunk.uuid(WHAT)?, chunk.i32(WHAT)?);
        }
        chunk.finish();
        materials.push(material);
    }
    Ok(materials)
}

/// Writes materials behind their count.
pub(crate) fn write_materials(materials: &[MaterialReference], w: &mut Writer) -> Result<()> {
    w.count(materials.len(), "materials")?;
    for material in materials {
        w.versioned(1, 1, |w| {
            w.uuid(material.application);
            w.uuid(material.front);
            w.i32(0);
            w.uuid(material.back);
            w.i32(material.source);
            Ok(())
        })?;
    }
    Ok(())
}

fn read_mapping(body: &mut Reader<'_>) -> Result<MappingReference> {
    let (mut chunk, _) = body.versioned_1("mapping reference")?;
    let mut mapping = MappingReference { application: chunk.uuid(WHAT)?, channels: Vec::new() };
    for _ in 0..chunk.count(16, WHAT)? {
        let (mut channel, minor) = chunk.versioned_1("mapping channel")?;
        let (number, id) = (channel.i32(WHAT)?, channel.uuid(WHAT)?);
        let transform = if minor >= 1 { read_matrix(&mut channel, WHAT)? } else { IDENTITY };
        channel.finish();
        mapping.channels.push((number, id, transform));
    }
    chunk.finish();
    Ok(mapping)
}

impl Rendering {
    pub(crate) fn read(body: &mut Reader<'_>) -> Result<Self> {
        let (mut chunk, minor) = body.versioned_1(WHAT)?;
        let mut rendering = Self { materials: read_materials(&mut chunk)?, ..Self::default() };
        for _ in 0..chunk.count(16, WHAT)? {
            rendering.mappings.push(read_mapping(&mut chunk)?);
        }
        if minor >= 2 {
            rendering.casts_shadows = chunk.bool(WHAT)?;
            rendering.receives_shadows = chunk.bool(WHAT)?;
        }
        if minor >= 3 {
            rendering.advanced_preview = chunk.bool(WHAT)?;
        }
        chunk.finish();
        Ok(rendering)
    }

    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        w.versioned(1, 3, |w| {
            write_materials(&self.materials, w)?;
            w.count(self.mappings.len(), "mappings")?;
            for mapping in &self.mappings {
                w.versioned(1, 0, |w| {
                    w.uuid(mapping.application);
                    w.count(mapping.channels.len(), "mapping channels")?;
                    mapping.channels.iter().try_for_each(|(number, id, transform)| {
                        w.versioned(1, 1, |w| {
                            w.i32(*number);
                            w.uuid(*id);
                            write_matrix(transform, w);
                            Ok(())
                        })
                    })
                })?;
            }
            w.bool(self.casts_shadows);
            w.bool(self.receives_shadows);
            w.bool(self.advanced_preview);
            Ok(())
        })
    }
}
