//! The settings table (section 5): units, tolerances, and what new objects get.

use crate::choices::write_place;
use crate::chunk::{Chunk, Writer};
use crate::places::Places;
use crate::{RenderSettings, Result, colour, typecode};

/// What a model is worked on with: what new objects get.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// Whether and how lengths are shown: 0 as decimals, 1 as fractions, 2 as feet and inches.
    pub length_display: i32,
    /// How many digits are shown.
    pub length_digits: i32,
    /// The absolute and the angle tolerance as the archive has them, where one of them cannot be any: it is written
    /// back for as long as the model has the default in its place.
    pub impossible_tolerances: Option<[f64; 2]>,
    /// The layer of new objects, an index into [`Model::layers`](crate::Model::layers).
    pub current_layer: Option<usize>,
    /// The material of new objects, an index into [`Model::materials`](crate::Model::materials), and where their
    /// material comes from by its number in archives; nothing when the archive says neither.
    pub current_material: Option<(Option<usize>, i32)>,
    /// The colour of new objects as red, green, blue, alpha, and where their colour comes from by its number in
    /// archives; nothing when the archive says neither.
    pub current_colour: Option<([u8; 4], i32)>,
    /// The isocurves a span of new objects.
    pub current_wire_density: Option<i32>,
    /// How the model is rendered; nothing when the archive does not say.
    pub render: Option<RenderSettings>,
}

impl Default for Settings {
    /// Decimals with three digits, nothing current.
    fn default() -> Self {
        Self {
            length_display: 0,
            length_digits: 3,
            impossible_tolerances: None,
            current_layer: None,
            current_material: None,
            current_colour: None,
            current_wire_density: None,
            render: None,
        }
    }
}

impl Settings {
    /// Reads a record of the table; gives whether it was one that is known.
    pub(crate) fn read(&mut self, record: &Chunk<'_>) -> Result<bool> {
        let mut body = record.body.clone();
        match record.typecode {
            typecode::CURRENT_LAYER => self.current_layer = usize::try_from(record.value).ok(),
            typecode::CURRENT_WIRE_DENSITY => self.current_wire_density = i32::try_from(record.value).ok(),
            typecode::CURRENT_MATERIAL => {
                const WHAT: &str = "current material";
                let material = usize::try_from(body.i32(WHAT)?).ok();
                self.current_material = Some((material, body.i32(WHAT)?));
            }
            typecode::CURRENT_COLOUR => {
                const WHAT: &str = "current colour";
                let rgba = colour::from_archive(body.colour(WHAT)?);
                self.current_colour = Some((rgba, body.i32(WHAT)?));
            }
            typecode::RENDER_SETTINGS => self.render = Some(RenderSettings::read(&mut body)?),
            _ => return Ok(false),
        }
        body.finish();
        Ok(true)
    }

    /// Turns the numbers of the current layer and material into places in their tables.
    pub(crate) fn place(&mut self, places: &Places) {
        self.current_layer = self.current_layer.and_then(|number| places.layers.find(number));
        if let Some((material, _)) = &mut self.current_material {
            *material = material.and_then(|number| places.materials.find(number));
        }
    }

    /// Writes the records that are known.
    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        if let Some(layer) = self.current_layer {
            w.short(typecode::CURRENT_LAYER, i64::try_from(layer).unwrap_or_default());
        }
        if let Some((material, source)) = self.current_material {
            w.chunk(typecode::CURRENT_MATERIAL, |w| {
                write_place(material, "materials", w)?;
                w.i32(source);
                Ok(())
            })?;
        }
        if let Some((rgba, source)) = self.current_colour {
            w.chunk(typecode::CURRENT_COLOUR, |w| {
                w.colour(colour::to_archive(rgba));
                w.i32(source);
                Ok(())
            })?;
        }
        if let Some(density) = self.current_wire_density {
            w.short(typecode::CURRENT_WIRE_DENSITY, i64::from(density));
        }
        if let Some(render) = &self.render {
            w.chunk(typecode::RENDER_SETTINGS, |w| render.write(w))?;
        }
        Ok(())
    }
}
