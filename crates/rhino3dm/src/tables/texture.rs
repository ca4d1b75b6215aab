//! Class Texture (section 8): an image in a material and how it lies on the object.

use uuid::{Uuid, uuid};

use super::FileReference;
use crate::Result;
use crate::chunk::{Reader, Writer};
use crate::class_object::{ClassObject, UserData, write_class};
use crate::values::{IDENTITY, read_colour, read_matrix, write_colour, write_matrix};

/// An image in a material.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// The identifier.
    pub id: Uuid,
    /// The mapping channel.
    pub channel: u32,
    /// The image.
    pub file: FileReference,
    /// Whether the texture is used.
    pub enabled: bool,
    /// What the image changes.
    pub kind: TextureKind,
    /// How it is mixed with what lies under it, by its number in archives.
    pub mode: u32,
    /// The filters for images shown smaller and larger than they are.
    pub filters: [u32; 2],
    /// How the image goes on beyond its edges in u, v, w: 0 repeats it, 1 draws out its edge.
    pub wrap: [u32; 3],
    /// From texture coordinates to places in the image, row after row.
    pub transform: [f64; 16],
    /// The colour beyond the edges.
    pub border: [u8; 4],
    /// The colour that counts as transparent.
    pub transparent: [u8; 4],
    /// The texture that gives the transparency; nil for none.
    pub transparency_texture: Uuid,
    /// The least and the greatest height of a bump texture.
    pub bump_scale: [f64; 2],
    /// The constant and the four factors of blended alpha.
    pub blend_alpha: [f64; 5],
    /// The constant of blended colours.
    pub blend_colour: [u8; 4],
    /// The four factors of blended colours.
    pub blend_factors: [f64; 4],
    /// Which blending comes first.
    pub blend_order: i32,
    /// Whether the colours of the image are linear.
    pub linear: bool,
    /// User data, carried along as it is.
    pub user_data: Vec<UserData>,
}

/// What a texture changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum TextureKind {
    /// The colour.
    #[default]
    Diffuse,
    /// The height.
    Bump,
    /// What is mirrored.
    Environment,
    /// The transparency.
    Opacity,
    /// Another one, by its number in archives.
    Other(u32),
}

impl TextureKind {
    fn from_number(number: u32) -> Self {
        match number {
            1 => Self::Diffuse,
            2 => Self::Bump,
            86 => Self::Environment,
            3 => Self::Opacity,
            other => Self::Other(other),
        }
    }

    fn number(self) -> u32 {
        match self {
            Self::Diffuse => 1,
            Self::Bump => 2,
            Self::Environment => 86,
            Self::Opacity => 3,
            Self::Other(number) => number,
        }
    }
}

impl Default for Texture {
    fn default() -> Self {
        Self {
            id: Uuid::nil(),
            channel: 1,
            file: FileReference::default(),
            enabled: true,
            kind: TextureKind::default(),
            mode: MODULATE,
            filters: [LINEAR; 2],
            wrap: [0; 3],
            transform: IDENTITY,
            // Neither colour is set.
            border: [255, 255, 255, 0],
            transparent: [255, 255, 255, 0],
            transparency_texture: Uuid::nil(),
            bump_scale: [0.0, 1.0],
            blend_alpha: [1.0, 1.0, 1.0, 0.0, 0.0],
            blend_colour: [0, 0, 0, 255],
            blend_factors: [1.0, 1.0, 0.0, 0.0],
            blend_order: 0,
            linear: false,
            user_data: Vec::new(),
        }
    }
}

/// Textures are multiplied with what lies under them, and filtered linearly.
const MODULATE: u32 = 1;
const LINEAR: u32 = 1;
const CLASS: Uuid = uuid!("D6FF106D-329B-4F29-97E2-FD282A618020");
const WHAT: &str = "texture";

impl Texture {
    /// A texture of an image file.
    pub fn new(path: &str, kind: TextureKind) -> Self {
        Self { file: FileReference::from_path(path), kind, ..Self::default() }
    }

    /// Reads the class object that comes next; nothing when it is of another class.
    pub(crate) fn read(reader: &mut Reader<'_>) -> Result<Option<Self>> {
        let object = ClassObject::read(reader)?;
        let Some(mut body) = object.data.filter(|_| object.class == CLASS) else { return Ok(None) };
        let mut texture = Self::read_body(&mut body)?;
        body.finish();
        texture.user_data = object.user_data;
        Ok(Some(texture))
    }

    fn read_body(body: &mut Reader<'_>) -> Result<Self> {
        let (mut chunk, minor) = body.versioned_1(WHAT)?;
        let r = &mut chunk;
        let (id, channel, path, enabled) = (r.uuid(WHAT)?, r.u32(WHAT)?, r.string(WHAT)?, r.bool(WHAT)?);
        let mut texture = Self {
            id,
            channel,
            // Readers take the one path of before as the full one, whatever it looks like.
            file: FileReference { full_path: path, ..FileReference::default() },
            enabled,
            kind: TextureKind::from_number(r.u32(WHAT)?),
            mode: r.u32(WHAT)?,
            filters: [r.u32(WHAT)?, r.u32(WHAT)?],
            wrap: [r.u32(WHAT)?, r.u32(WHAT)?, r.u32(WHAT)?],
            transform: read_matrix(r, WHAT)?,
            border: read_colour(r, WHAT)?,
            transparent: read_colour(r, WHAT)?,
            transparency_texture: r.uuid(WHAT)?,
            bump_scale: [r.f64(WHAT)?, r.f64(WHAT)?],
            ..Self::default()
        };
        for x in &mut texture.blend_alpha {
            *x = r.f64(WHAT)?;
        }
        texture.blend_colour = read_colour(r, WHAT)?;
        for x in &mut texture.blend_factors {
            *x = r.f64(WHAT)?;
        }
        texture.blend_order = r.i32(WHAT)?;
        if minor >= 1 {
            texture.file = FileReference::read(r)?;
        }
        if minor >= 2 {
            texture.linear = r.bool(WHAT)?;
        }
        chunk.finish();
        Ok(texture)
    }

    /// Writes the class object.
    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        let minor = match w.version().archive {
            ..60 => 0,
            60..70 => 1,
            _ => 2,
        };
        write_class(w, CLASS, &self.user_data, |w| {
            w.versioned(1, minor, |w| {
                w.uuid(self.id);
                w.u32(self.channel);
                w.string(self.file.path())?;
                w.bool(self.enabled);
                w.u32(self.kind.number());
                w.u32(self.mode);
                self.filters.iter().chain(&self.wrap).for_each(|number| w.u32(*number));
                write_matrix(&self.transform, w);
                write_colour(self.border, w);
                write_colour(self.transparent, w);
                w.uuid(self.transparency_texture);
                self.bump_scale.iter().chain(&self.blend_alpha).for_each(|x| w.f64(*x));
                write_colour(self.blend_colour, w);
                self.blend_factors.iter().for_each(|x| w.f64(*x));
                w.i32(self.blend_order);
                if minor >= 1 {
                    self.file.write(w)?;
                }
                if minor >= 2 {
                    w.bool(self.linear);
                }
                Ok(())
            })
        })
    }
}
