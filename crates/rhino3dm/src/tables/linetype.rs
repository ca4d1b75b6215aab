//! Class Linetype (section 8).

use uuid::{Uuid, uuid};

use super::{Component, Entry};
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::values::{NO_NUMBER, read_pairs, write_pair};
use crate::{Error, Result, typecode};

/// How a line is drawn: a pattern of dashes and gaps, and the form of its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Linetype {
    /// The identifier. A nil one gets a value of its own when written in a table.
    pub id: Uuid,
    /// The name.
    pub name: String,
    /// Dashes and gaps in turn; one dash alone is a continuous line.
    pub segments: Vec<LinetypeSegment>,
    /// The ends of lines. Archives before version 60 have none of this and the following.
    pub cap: LineCap,
    /// The corners of lines.
    pub join: LineJoin,
    /// The width in `width_units`.
    pub width: f64,
    /// The number of the unit of the width; 0 for pixels.
    pub width_units: u8,
    /// Pairs of a parameter from 0 to 1 along the line and a width there.
    pub taper: Vec<[f64; 2]>,
    /// Whether the pattern is in model units whatever the view.
    pub model_distances: bool,
    /// User data, carried along as it is.
    pub user_data: Vec<UserData>,
}

/// A part of a linetype's pattern.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinetypeSegment {
    /// Its length in millimetres of paper or model units.
    pub length: f64,
    /// Whether nothing is drawn.
    pub is_gap: bool,
}

/// The ends of lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[allow(missing_docs, reason = "the names say it")]
pub enum LineCap {
    #[default]
    Round,
    Flat,
    Square,
}

/// The corners of lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[allow(missing_docs, reason = "the names say it")]
pub enum LineJoin {
    #[default]
    Round,
    Miter,
    Bevel,
}

impl Default for Linetype {
    fn default() -> Self {
        Self {
            id: Uuid::nil(),
            name: String::new(),
            segments: vec![LinetypeSegment { length: 1.0, is_gap: false }],
            cap: LineCap::default(),
            join: LineJoin::default(),
            width: 1.0,
            width_units: 0,
            taper: Vec::new(),
            model_distances: false,
            user_data: Vec::new(),
        }
    }
}

const CAP: u8 = 1;
const JOIN: u8 = 2;
const WIDTH: u8 = 3;
const WIDTH_UNITS: u8 = 4;
const TAPER: u8 = 5;
const MODEL_DISTANCES: u8 = 6;

impl Linetype {
    /// A linetype of a name from the lengths of dashes and gaps in turn, a dash first.
    pub fn new(name: impl Into<String>, lengths: &[f64]) -> Self {
        let segments = lengths.iter().enumerate();
        let segments = segments.map(|(i, length)| LinetypeSegment { length: *length, is_gap: i % 2 == 1 });
        Self { name: name.into(), segments: segments.collect(), ..Self::default() }
    }

    /// A linetype inside of something else.
    pub(crate) fn read_inside(body: &mut Reader<'_>) -> Result<Self> {
        <Self as Entry>::read(body)
    }

    /// A linetype inside of something else, which keeps what identifier it has.
    pub(crate) fn write_inside(&self, w: &mut Writer) -> Result<()> {
        Entry::write(self, NO_NUMBER, self.id, w)
    }

    fn read_segments(&mut self, body: &mut Reader<'_>) -> Result<()> {
        let count = body.count(12, Self::WHAT)?;
        self.segments.clear();
        for _ in 0..count {
            let length = body.f64(Self::WHAT)?;
            self.segments.push(LinetypeSegment { length, is_gap: body.u32(Self::WHAT)? == 1 });
        }
        Ok(())
    }

    fn read_items(&mut self, body: &mut Reader<'_>) -> Result<()> {
        const WHAT: &str = Linetype::WHAT;
        loop {
            match body.u8(WHAT)? {
                CAP => {
                    self.cap = match body.u8(WHAT)? {
                        1 => LineCap::Flat,
                        2 => LineCap::Square,
                        _ => LineCap::Round,
                    }
                }
                JOIN => {
                    self.join = match body.u8(WHAT)? {
                        1 => LineJoin::Miter,
                        2 => LineJoin::Bevel,
                        _ => LineJoin::Round,
                    }
                }
                WIDTH => self.width = body.f64(WHAT)?,
                WIDTH_UNITS => self.width_units = body.u8(WHAT)?,
                TAPER => self.taper = read_pairs(body, WHAT)?,
                MODEL_DISTANCES => self.model_distances = body.bool(WHAT)?,
                // The end, or something newer: items have no length.
                _ => return Ok(()),
            }
        }
    }

    fn write_segments(&self, w: &mut Writer) -> Result<()> {
        w.count(self.segments.len(), "linetype segments")?;
        for segment in &self.segments {
            w.f64(segment.length);
            w.u32(u32::from(segment.is_gap));
        }
        Ok(())
    }

    fn write_items(&self, w: &mut Writer) -> Result<()> {
        if self.cap != LineCap::Round {
            w.bytes(&[CAP, if self.cap == LineCap::Flat { 1 } else { 2 }]);
        }
        if self.join != LineJoin::Round {
            w.bytes(&[JOIN, if self.join == LineJoin::Miter { 1 } else { 2 }]);
        }
        if (self.width - 1.0).abs() > f64::EPSILON {
            w.u8(WIDTH);
            w.f64(self.width);
        }
        if self.width_units != 0 {
            w.bytes(&[WIDTH_UNITS, self.width_units]);
        }
        if !self.taper.is_empty() {
            w.u8(TAPER);
            w.count(self.taper.len(), "taper points")?;
            self.taper.iter().for_each(|pair| write_pair(*pair, w));
        }
        if self.model_distances {
            w.bytes(&[MODEL_DISTANCES, 1]);
        }
        w.u8(0);
        Ok(())
    }
}

impl Entry for Linetype {
    const CLASS: Uuid = uuid!("26F10A24-7D13-4F05-8FDA-8E364DAF8EA6");
    const WHAT: &'static str = "linetype";

    fn read(body: &mut Reader<'_>) -> Result<Self> {
        let offset = body.offset();
        let (mut chunk, major, minor) = body.versioned(Self::WHAT)?;
        let mut linetype = Self::default();
        match major {
            1 => {
                chunk.i32("linetype number")?;
                linetype.name = chunk.string("linetype name")?;
                linetype.read_segments(&mut chunk)?;
                if minor >= 1 {
                    linetype.id = chunk.uuid(Self::WHAT)?;
                }
            }
            2 => {
                let component = Component::read_fields(&mut chunk)?;
                (linetype.id, linetype.name) = (component.id, component.name);
                linetype.read_segments(&mut chunk)?;
                if minor >= 1 {
                    linetype.read_items(&mut chunk)?;
                }
            }
            _ => {
                let why = format!("major version {major} is not known");
                return Err(Error::malformed(offset, Self::WHAT, why));
            }
        }
        chunk.finish();
        Ok(linetype)
    }

    fn write(&self, number: i32, id: Uuid, w: &mut Writer) -> Result<()> {
        if w.version().archive < 60 {
            return w.versioned(1, 1, |w| {
                w.i32(number);
                w.string(&self.name)?;
                self.write_segments(w)?;
                w.uuid(id);
                Ok(())
            });
        }
        w.chunk(typecode::ANONYMOUS, |w| {
            w.i32(2);
            w.i32(3);
            Component::new(id, number, &self.name).write_fields(w)?;
            self.write_segments(w)?;
            self.write_items(w)
        })
    }
}
