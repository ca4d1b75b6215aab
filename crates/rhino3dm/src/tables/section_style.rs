//! Class SectionStyle (section 8): how an object looks where a clipping plane cuts it.

use uuid::Uuid;

use super::Component;
use super::linetype::Linetype;
use crate::chunk::{Reader, Writer};
use crate::places::Places;
use crate::values::{NO_NUMBER, read_colours, write_colour};
use crate::{Error, Result};

/// How an object looks where it is cut. What is nothing is as a program's default has it. Pairs of colours are
/// for the screen and for print, as red, green, blue, alpha.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SectionStyle {
    /// The identifier; nil for a style that only one object or layer has.
    pub id: Uuid,
    /// The name; empty for a style that only one object or layer has.
    pub name: String,
    /// How the background is filled, by its number in archives.
    pub background: Option<u8>,
    /// The colours of the background.
    pub background_colours: Option<[[u8; 4]; 2]>,
    /// Whether the boundary is drawn.
    pub boundary_visible: Option<bool>,
    /// The colours of the boundary.
    pub boundary_colours: Option<[[u8; 4]; 2]>,
    /// How much wider than other curves the boundary is.
    pub boundary_width_scale: Option<f64>,
    /// Which sections are filled, by its number in archives.
    pub fill_rule: Option<u8>,
    /// The hatch pattern as an index into [`Model::hatch_patterns`](crate::Model::hatch_patterns); below 0 for none.
    pub hatch: Option<i32>,
    /// The scale of the hatch.
    pub hatch_scale: Option<f64>,
    /// The turn of the hatch in radians.
    pub hatch_rotation: Option<f64>,
    /// The colours of the hatch.
    pub hatch_colours: Option<[[u8; 4]; 2]>,
    /// The linetype of the boundary.
    pub boundary_linetype: Option<Box<Linetype>>,
}

const WHAT: &str = "section style";

impl SectionStyle {
    /// Turns the number of the hatch pattern into its place.
    pub(crate) fn place(&mut self, places: &Places) {
        self.hatch = self.hatch.map(|number| places.hatch_patterns.place(number));
    }

    pub(crate) fn read(body: &mut Reader<'_>) -> Result<Self> {
        let offset = body.offset();
        let (mut chunk, major, _) = body.versioned(WHAT)?;
        if major != 1 {
            return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
        }
        let component = Component::read_fields(&mut chunk)?;
        let mut style = Self { id: component.id, name: component.name, ..Self::default() };
        loop {
            match chunk.u8(WHAT)? {
                1 => style.background = Some(chunk.u8(WHAT)?),
                2 => style.background_colours = Some(read_colours(&mut chunk, WHAT)?),
                3 => style.boundary_visible = Some(chunk.bool(WHAT)?),
                4 => style.boundary_colours = Some(read_colours(&mut chunk, WHAT)?),
                5 => style.boundary_width_scale = Some(chunk.f64(WHAT)?),
                6 => style.fill_rule = Some(chunk.u8(WHAT)?),
                7 => style.hatch = Some(chunk.i32(WHAT)?),
                8 => style.hatch_scale = Some(chunk.f64(WHAT)?),
                9 => style.hatch_rotation = Some(chunk.f64(WHAT)?),
                10 => style.hatch_colours = Some(read_colours(&mut chunk, WHAT)?),
                11 => style.boundary_linetype = Some(Box::new(Linetype::read_inside(&mut chunk)?)),
                // The end, or something newer: items have no length.
                _ => break,
            }
        }
        chunk.finish();
        Ok(style)
    }

    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        w.versioned(1, 1, |w| {
            Component::new(self.id, NO_NUMBER, &self.name).write_fields(w)?;
            byte(1, self.background, w);
            colours(2, self.background_colours, w);
            byte(3, self.boundary_visible.map(u8::from), w);
            colours(4, self.boundary_colours, w);
            number(5, self.boundary_width_scale, w);
            byte(6, self.fill_rule, w);
            if let Some(hatch) = self.hatch {
                w.u8(7);
                w.i32(hatch);
            }
            number(8, self.hatch_scale, w);
            number(9, self.hatch_rotation, w);
            colours(10, self.hatch_colours, w);
            if let Some(linetype) = &self.boundary_linetype {
                w.u8(11);
                linetype.write_inside(w)?;
            }
            w.u8(0);
            Ok(())
        })
    }
}

fn byte(code: u8, value: Option<u8>, w: &mut Writer) {
    if let Some(value) = value {
        w.bytes(&[code, value]);
    }
}

fn number(code: u8, value: Option<f64>, w: &mut Writer) {
    if let Some(value) = value {
        w.u8(code);
        w.f64(value);
    }
}

fn colours(code: u8, value: Option<[[u8; 4]; 2]>, w: &mut Writer) {
    if let Some(pair) = value {
        w.u8(code);
        pair.iter().for_each(|colour| write_colour(*colour, w));
    }
}
