//! Class Material (section 8), in its three layouts.

use uuid::{Uuid, uuid};

use super::texture::{Texture, TextureKind};
use super::{Component, Entry, FileReference};
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::values::{read_colour, write_colour};
use crate::{Error, Result, typecode};

/// A material. Colours are red, green, blue, alpha. What makes it physically based is in its user data.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// The identifier. A nil one gets a value of its own when written.
    pub id: Uuid,
    /// The name.
    pub name: String,
    /// Whether archives state the name though it is empty, which readers tell apart from no name.
    pub states_empty_name: bool,
    /// The program that renders it; nil for none in particular.
    pub application: Uuid,
    /// The colour under ambient light.
    pub ambient: [u8; 4],
    /// The colour.
    pub diffuse: [u8; 4],
    /// The colour it gives off.
    pub emission: [u8; 4],
    /// The colour of highlights.
    pub specular: [u8; 4],
    /// The colour of what it mirrors.
    pub reflection: [u8; 4],
    /// The colour of what is seen through it.
    pub transparent: [u8; 4],
    /// The index of refraction.
    pub refraction: f64,
    /// How much it mirrors, 0 to 1.
    pub reflectivity: f64,
    /// How sharp highlights are, 0 to 255.
    pub shine: f64,
    /// How much is seen through it, 0 to 1.
    pub transparency: f64,
    /// Images.
    pub textures: Vec<Texture>,
    /// Materials of single faces: the material and its channel.
    pub channels: Vec<(Uuid, i32)>,
    /// Whether objects may share it.
    pub shareable: bool,
    /// Whether light makes no difference.
    pub disable_lighting: bool,
    /// Whether mirroring depends on the angle, by Fresnel's equations.
    pub fresnel_reflections: bool,
    /// How blurred mirror images are, 0 to 1.
    pub reflection_glossiness: f64,
    /// How blurred what is seen through it is, 0 to 1.
    pub refraction_glossiness: f64,
    /// The index of refraction in Fresnel's equations.
    pub fresnel_refraction: f64,
    /// The render content it stands for; nil for none.
    pub render_content: Uuid,
    /// Whether the alpha of the colour image makes the object transparent.
    pub diffuse_alpha_is_transparency: bool,
    /// User data, carried along as it is.
    pub user_data: Vec<UserData>,
}

impl Default for Material {
    fn default() -> Self {
        let (black, white) = ([0, 0, 0, 255], [255; 4]);
        Self {
            id: Uuid::nil(),
            name: String::new(),
            states_empty_name: false,
            application: Uuid::nil(),
            ambient: black,
            diffuse: [126, 126, 126, 255],
            emission: black,
            specular: white,
            reflection: white,
            transparent: white,
            refraction: 1.0,
            reflectivity: 0.0,
            shine: 0.0,
            transparency: 0.0,
            textures: Vec::new(),
            channels: Vec::new(),
            shareable: false,
            disable_lighting: false,
            fresnel_reflections: false,
            reflection_glossiness: 0.0,
            refraction_glossiness: 0.0,
            fresnel_refraction: 1.56,
            render_content: Uuid::nil(),
            diffuse_alpha_is_transparency: false,
            user_data: Vec::new(),
        }
    }
}

const WHAT: &str = "material";
/// Archives of version 60 have the newest layout from this openNURBS version on.
const NEW_FROM: u32 = 2_348_833_910;
/// Before this openNURBS version the colour of what is seen through a material began as a grey by mistake.
const WHITE_FROM: u32 = 200_912_010;
const MISTAKEN_GREY: [u8; 3] = [128; 3];
/// Modes of textures in version 2 and 3: decals are not multiplied.
const OLD_DECAL: i32 = 2;
const DECAL: u32 = 2;
const MODULATE: u32 = 1;

impl Material {
    /// A material of a name and a colour.
    pub fn new(name: impl Into<String>, diffuse: [u8; 4]) -> Self {
        Self { name: name.into(), diffuse, ..Self::default() }
    }

    fn read_looks(&mut self, body: &mut Reader<'_>) -> Result<()> {
        self.application = body.uuid(WHAT)?;
        for colour in [
            &mut self.ambient,
            &mut self.diffuse,
            &mut self.emission,
            &mut self.specular,
            &mut self.reflection,
            &mut self.transparent,
        ] {
            *colour = read_colour(body, WHAT)?;
        }
        let numbers = [&mut self.refraction, &mut self.reflectivity, &mut self.shine, &mut self.transparency];
        for number in numbers {
            *number = body.f64(WHAT)?;
        }
        let (mut textures, _) = body.versioned_1("textures")?;
        for _ in 0..textures.count(16, "textures")? {
            self.textures.extend(Texture::read(&mut textures)?);
        }
        textures.finish();
        Ok(())
    }

    /// Colours have no transparency from version 60 on, whatever is stored.
    fn forget_alphas(&mut self) {
        for colour in [
            &mut self.ambient,
            &mut self.diffuse,
            &mut self.emission,
            &mut self.specular,
            &mut self.reflection,
            &mut self.transparent,
        ] {
            colour[3] = 255;
        }
    }

    fn write_looks(&self, w: &mut Writer) -> Result<()> {
        w.uuid(self.application);
        for colour in
            [self.ambient, self.diffuse, self.emission, self.specular, self.reflection, self.transparent]
        {
            write_colour(colour, w);
        }
        for number in [self.refraction, self.reflectivity, self.shine, self.transparency] {
            w.f64(number);
        }
        w.versioned(1, 0, |w| {
            w.count(self.textures.len(), "textures")?;
            self.textures.iter().try_for_each(|texture| texture.write(w))
        })
    }

    fn read_channels(&mut self, body: &mut Reader<'_>) -> Result<()> {
        let count = body.count(20, WHAT)?;
        self.channels = (0..count).map(|_| Ok((body.uuid(WHAT)?, body.i32(WHAT)?))).collect::<Result<_>>()?;
        Ok(())
    }

    fn write_channels(&self, w: &mut Writer) -> Result<()> {
        w.count(self.channels.len(), "material channels")?;
        for (id, channel) in &self.channels {
            w.uuid(*id);
            w.i32(*channel);
        }
        Ok(())
    }

    fn read_fresnel(&mut self, body: &mut Reader<'_>) -> Result<()> {
        self.fresnel_reflections = body.bool(WHAT)?;
        self.reflection_glossiness = body.f64(WHAT)?;
        self.refraction_glossiness = body.f64(WHAT)?;
        self.fresnel_refraction = body.f64(WHAT)?;
        Ok(())
    }

    /// Version 60 and later.
    fn read_new(body: &mut Reader<'_>) -> Result<Self> {
        let (mut chunk, _) = body.versioned_1(WHAT)?;
        let component = Component::read_bits(&mut chunk)?;
        let mut material = Self { id: component.id, name: component.name, ..Self::default() };
        material.states_empty_name = component.states_empty_name;
        material.read_looks(&mut chunk)?;
        material.forget_alphas();
        material.read_channels(&mut chunk)?;
        material.shareable = chunk.bool(WHAT)?;
        material.disable_lighting = chunk.bool(WHAT)?;
        material.read_fresnel(&mut chunk)?;
        material.render_content = chunk.uuid(WHAT)?;
        material.diffuse_alpha_is_transparency = chunk.bool(WHAT)?;
        chunk.finish();
        Ok(material)
    }

    /// Version 4 and 50.
    fn read_middle(body: &mut Reader<'_>) -> Result<Self> {
        let version = body.version();
        let (mut chunk, minor) = body.versioned_1(WHAT)?;
        let id = chunk.uuid(WHAT)?;
        chunk.i32("material number")?;
        let mut material = Self { id, name: chunk.string("material name")?, ..Self::default() };
        material.states_empty_name = material.name.is_empty();
        material.read_looks(&mut chunk)?;
        let seen_through = material.transparent.first_chunk::<3>();
        if version.opennurbs < WHITE_FROM && seen_through == Some(&MISTAKEN_GREY) {
            material.transparent = material.diffuse;
        }
        if minor >= 1 {
            chunk.string("material library")?;
        }
        if minor >= 2 {
            material.read_channels(&mut chunk)?;
        }
        if minor >= 3 {
            material.shareable = chunk.bool(WHAT)?;
            material.disable_lighting = chunk.bool(WHAT)?;
        }
        if minor >= 4 {
            material.read_fresnel(&mut chunk)?;
        }
        if minor >= 5 {
            material.render_content = chunk.uuid(WHAT)?;
        }
        if minor >= 6 {
            material.diffuse_alpha_is_transparency = chunk.bool(WHAT)?;
        }
        chunk.finish();
        Ok(material)
    }

    /// Version 2 and 3, behind the version byte.
    fn read_old(body: &mut Reader<'_>, minor: u8) -> Result<Self> {
        let mut material = Self {
            ambient: read_colour(body, WHAT)?,
            diffuse: read_colour(body, WHAT)?,
            emission: read_colour(body, WHAT)?,
            specular: read_colour(body, WHAT)?,
            ..Self::default()
        };
        material.shine = single(body.f64(WHAT)?).clamp(0.0, 255.0);
        material.transparency = body.f64(WHAT)?.clamp(0.0, 1.0);
        // Shadows, wires and a line style, which were never used.
        body.take(28, WHAT)?;
        for kind in [TextureKind::Diffuse, TextureKind::Bump, TextureKind::Environment] {
            let path = body.string("image name")?;
            let mode = body.i32(WHAT)?;
            body.i32("bitmap")?;
            let height = if kind == TextureKind::Bump { body.f64(WHAT)? } else { 1.0 };
            if path.is_empty() {
                continue;
            }
            // These versions call every path a full one.
            let file = FileReference { full_path: path, ..FileReference::default() };
            let mut texture = Texture { file, kind, ..Texture::default() };
            texture.mode = if mode == OLD_DECAL { DECAL } else { MODULATE };
            texture.bump_scale[1] = height;
            material.textures.push(texture);
        }
        body.i32("material number")?;
        material.application = body.uuid(WHAT)?;
        body.string("material library")?;
        material.name = body.string("material name")?;
        material.states_empty_name = material.name.is_empty();
        if minor >= 1 {
            material.id = body.uuid(WHAT)?;
            material.reflection = read_colour(body, WHAT)?;
            material.transparent = read_colour(body, WHAT)?;
            material.refraction = body.f64(WHAT)?;
        }
        Ok(material)
    }
}

/// The number in single precision, in which programs of old kept it.
pub(crate) fn single(x: f64) -> f64 {
    #[allow(clippy::cast_possible_truncation, reason = "the loss of digits is what is wanted")]
    let single = x as f32;
    f64::from(single)
}

impl Entry for Material {
    const CLASS: Uuid = uuid!("60B5DBBC-E660-11D3-BFE4-0010830122F0");
    const WHAT: &'static str = WHAT;

    fn read(body: &mut Reader<'_>) -> Result<Self> {
        let version = body.version();
        if version.archive >= 60 && version.opennurbs >= NEW_FROM {
            return Self::read_new(body);
        }
        let offset = body.offset();
        match body.packed_version(WHAT)? {
            (1, minor) => Self::read_old(body, minor),
            (2, _) => Self::read_middle(body),
            (major, _) => Err(Error::malformed(offset, WHAT, format!("major version {major} is not known"))),
        }
    }

    fn write(&self, number: i32, id: Uuid, w: &mut Writer) -> Result<()> {
        if w.version().archive < 60 {
            w.packed_version(2, 0);
            return w.versioned(1, 3, |w| {
                w.uuid(id);
                w.i32(number);
                w.string(&self.name)?;
                self.write_looks(w)?;
                w.string("")?;
                self.write_channels(w)?;
                w.bool(self.shareable);
                w.bool(self.disable_lighting);
                Ok(())
            });
        }
        w.chunk(typecode::ANONYMOUS, |w| {
            w.i32(1);
            w.i32(0);
            let component = Component::new(id, number, &self.name);
            Component { states_empty_name: self.states_empty_name, ..component }.write_bits(w)?;
            self.write_looks(w)?;
            self.write_channels(w)?;
            w.bool(self.shareable);
            w.bool(self.disable_lighting);
            w.bool(self.fresnel_reflections);
            w.f64(self.reflection_glossiness);
            w.f64(self.refraction_glossiness);
            w.f64(self.fresnel_refraction);
            w.uuid(self.render_content);
            w.bool(self.diffuse_alpha_is_transparency);
            Ok(())
        })
    }
}
