//! Attributes of version 1: chunks around an object's geometry, one a property.

use katydid_geometry::Vector3;

use super::{text, typecode as code};
use crate::chunk::Reader;
use crate::tables::single;
use crate::{Attributes, FileReference, Material, Result, Texture, TextureKind, typecode};

const WHAT: &str = "attributes";
/// The colour that means there is none.
const NO_COLOUR: u32 = 0x00FF_FFFF;
/// The shine of what shines most; it is stored in hundredths of it.
const MOST_SHINE: f64 = 255.0;

/// What points are when they are more than points.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Extra {
    /// An arrow, from the point along the vector.
    Arrow(Vector3),
    /// A text dot.
    Dot(String),
}

/// What the chunks beside an object's geometry say.
#[derive(Debug, Default)]
pub(super) struct Stated {
    pub(super) attributes: Attributes,
    /// Its material, when it says anything about one.
    pub(super) material: Option<Material>,
    pub(super) extra: Option<Extra>,
}

impl Stated {
    /// Reads chunks up to the one whose typecode is `end`, which is left to be read, or past the end of a table.
    pub(super) fn read(chunks: &mut Reader<'_>, end: Option<u32>) -> Result<Self> {
        let mut stated = Self::default();
        while chunks.left() >= 8 && chunks.peek_typecode() != end {
            let chunk = chunks.chunk()?;
            if chunk.typecode == typecode::END_OF_TABLE {
                break;
            }
            let (context, at) = (chunk.body.context(), chunk.offset);
            if let Err(error) = stated.take(chunk.typecode, chunk.value, chunk.body) {
                context.left_out(at, "an attribute", error);
            }
        }
        Ok(stated)
    }

    fn take(&mut self, typecode: u32, value: i64, mut body: Reader<'_>) -> Result<()> {
        match typecode {
            code::OBJECT_UUID => {
                self.attributes.id = body.uuid("object identifier")?;
                body.finish();
            }
            code::LAYER_REFERENCE => {
                if let Ok(layer) = usize::try_from(value) {
                    self.attributes.layer = Some(layer);
                }
            }
            code::WIRE_DENSITY => {
                if let Some(density) = i32::try_from(value).ok().filter(|density| *density > 0) {
                    self.attributes.wire_density = density;
                }
            }
            code::NAME => {
                let name = text::counted(&mut body, "object name")?;
                if !name.is_empty() {
                    self.attributes.name = name;
                }
            }
            code::EXTRA => self.take_extra(&mut body)?,
            _ => self.take_material(typecode, value, body)?,
        }
        Ok(())
    }

    /// Its material, white until it says otherwise.
    fn material(&mut self) -> &mut Material {
        self.material.get_or_insert_with(|| Material { diffuse: [255; 4], ..Material::default() })
    }

    fn take_material(&mut self, typecode: u32, value: i64, mut body: Reader<'_>) -> Result<()> {
        match typecode {
            code::COLOUR => {
                let [red, green, blue, shine] = colour_bytes(value);
                if u32::from_le_bytes([red, green, blue, shine]) != NO_COLOUR {
                    let material = self.material();
                    material.diffuse = [red, green, blue, 255];
                    material.shine = single((f64::from(shine) / 100.0 * MOST_SHINE).min(MOST_SHINE));
                }
            }
            code::TRANSPARENCY => {
                if let Some(part) = u8::try_from(value).ok().filter(|part| *part > 0) {
                    self.material().transparency = f64::from(part) / 255.0;
                }
            }
            code::TEXTURE => {
                let file = text::counted(&mut body, "texture")?;
                if !file.is_empty() {
                    self.material().textures.push(texture(file, TextureKind::Diffuse));
                }
            }
            code::BUMP => {
                let file = text::counted(&mut body, "bump map")?;
                if !file.is_empty() {
                    self.material().textures.push(texture(file, TextureKind::Bump));
                }
            }
            code::MATERIAL_NAME if body.i32("material")? == 1 => {
                let name = text::counted(&mut body, "material name")?;
                if !name.is_empty() {
                    self.material().name = name;
                }
            }
            // An object's own colour is stored but never in force: every object shows its layer's.
            code::DISPLAY_COLOUR => {
                let [red, green, blue, _] = colour_bytes(value);
                self.attributes.unused_colour = [red, green, blue, 255];
            }
            _ => {}
        }
        Ok(())
    }

    /// Data of programs, named by a word.
    fn take_extra(&mut self, body: &mut Reader<'_>) -> Result<()> {
        let name_length = body.count(1, WHAT)?;
        let data_length = body.i32(WHAT)?;
        let name = text::of(body.take(name_length, WHAT)?);
        if name.eq_ignore_ascii_case("RhAnnotateArrow") && data_length == 24 {
            self.extra = Some(Extra::Arrow(body.vector("arrow")?));
        } else if name.eq_ignore_ascii_case("RhAnnotateDot")
            && let Ok(length @ 1..) = usize::try_from(data_length)
        {
            self.extra = Some(Extra::Dot(text::of(body.take(length, "text dot")?)));
        }
        // The layer that a hidden or locked object lay on before is stored here, too; openNURBS passes it over.
        Ok(())
    }
}

/// An image under a name.
fn texture(path: String, kind: TextureKind) -> Texture {
    let file = FileReference { full_path: path, ..FileReference::default() };
    Texture { file, kind, ..Texture::default() }
}

/// The four bytes of a colour in a short chunk.
pub(super) fn colour_bytes(value: i64) -> [u8; 4] {
    let [red, green, blue, rest, ..] = value.to_le_bytes();
    [red, green, blue, rest]
}
