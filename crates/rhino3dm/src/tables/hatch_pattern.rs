//! Class HatchPattern (section 8).

use uuid::{Uuid, uuid};

use super::{Component, Entry};
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::values::{read_pair, write_pair};
use crate::{Error, Result, typecode};

/// A pattern that hatches are filled with.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct HatchPattern {
    /// The identifier. A nil one gets a value of its own when written.
    pub id: Uuid,
    /// The name.
    pub name: String,
    /// A description.
    pub description: String,
    /// What it fills with.
    pub fill: HatchFill,
    /// User data, carried along as it is.
    pub user_data: Vec<UserData>,
}

/// What a hatch pattern fills with.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum HatchFill {
    /// One colour.
    #[default]
    Solid,
    /// Families of parallel lines.
    Lines(Vec<HatchLine>),
    /// A gradient, which the hatch describes.
    Gradient,
}

/// A family of parallel, dashed lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct HatchLine {
    /// The angle from the x axis in radians.
    pub angle: f64,
    /// A point on one of the lines.
    pub base: [f64; 2],
    /// From a line to the next: along the lines, and across.
    pub offset: [f64; 2],
    /// Lengths of dashes (positive) and gaps (negative); none for a continuous line.
    pub dashes: Vec<f64>,
}

/// The number by which archives know each fill.
const SOLID: i32 = 0;
const LINES: i32 = 1;
const GRADIENT: i32 = 2;
/// Version 60 archives have the older layout up to this openNURBS version.
const OLD_UNTIL: u32 = 2_348_833_956;

const WHAT: &str = "hatch pattern";

impl HatchPattern {
    fn read_old(body: &mut Reader<'_>) -> Result<Self> {
        let offset = body.offset();
        let (major, minor) = body.packed_version(WHAT)?;
        if major != 1 {
            return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
        }
        body.i32("hatch pattern number")?;
        let kind = body.i32(WHAT)?;
        let (name, description) = (body.string("hatch pattern name")?, body.string("description")?);
        let mut pattern = Self { name, description, ..Self::default() };
        if kind == LINES {
            let mut lines = Vec::new();
            for _ in 0..body.count(45, WHAT)? {
                lines.push(HatchLine::read(body)?);
            }
            pattern.fill = HatchFill::Lines(lines);
        }
        if minor >= 2 {
            pattern.id = body.uuid(WHAT)?;
        }
        Ok(pattern)
    }

    fn read_new(body: &mut Reader<'_>) -> Result<Self> {
        let (mut chunk, _) = body.versioned_1(WHAT)?;
        let component = Component::read_bits(&mut chunk)?;
        let kind = chunk.i32(WHAT)?;
        let description = chunk.string("description")?;
        let mut pattern = Self { id: component.id, name: component.name, description, ..Self::default() };
        let mut chunks = chunk.expect(typecode::ANONYMOUS, WHAT)?;
        let mut lines = Vec::new();
        for _ in 0..chunks.count(45, WHAT)? {
            lines.push(HatchLine::read(&mut chunks)?);
        }
        chunks.finish();
        match kind {
            LINES => pattern.fill = HatchFill::Lines(lines),
            GRADIENT => pattern.fill = HatchFill::Gradient,
            _ => {}
        }
        chunk.finish();
        Ok(pattern)
    }

    fn kind(&self) -> i32 {
        match self.fill {
            HatchFill::Solid => SOLID,
            HatchFill::Lines(_) => LINES,
            HatchFill::Gradient => GRADIENT,
        }
    }

    fn lines(&self) -> &[HatchLine] {
        if let HatchFill::Lines(lines) = &self.fill { lines } else { &[] }
    }

    fn write_lines(&self, w: &mut Writer) -> Result<()> {
        w.count(self.lines().len(), "hatch lines")?;
        self.lines().iter().try_for_each(|line| line.write(w))
    }
}

impl HatchLine {
    fn read(body: &mut Reader<'_>) -> Result<Self> {
        const WHAT: &str = "hatch line";
        // One of two forms, whatever the pattern around it.
        if body.peek_typecode() == Some(typecode::ANONYMOUS) {
            let (mut chunk, _) = body.versioned_1(WHAT)?;
            let line = Self::read_fields(&mut chunk)?;
            chunk.finish();
            return Ok(line);
        }
        body.packed_version(WHAT)?;
        Self::read_fields(body)
    }

    fn read_fields(body: &mut Reader<'_>) -> Result<Self> {
        const WHAT: &str = "hatch line";
        Ok(Self {
            angle: body.f64(WHAT)?,
            base: read_pair(body, WHAT)?,
            offset: read_pair(body, WHAT)?,
            dashes: body.doubles(WHAT)?,
        })
    }

    fn write(&self, w: &mut Writer) -> Result<()> {
        if w.version().archive < 60 {
            w.packed_version(1, 1);
            return self.write_fields(w);
        }
        w.versioned(1, 0, |w| self.write_fields(w))
    }

    fn write_fields(&self, w: &mut Writer) -> Result<()> {
        w.f64(self.angle);
        write_pair(self.base, w);
        write_pair(self.offset, w);
        w.doubles(&self.dashes)
    }
}

impl Entry for HatchPattern {
    const CLASS: Uuid = uuid!("064E7C91-35F6-4734-A446-79FF7CD659E1");
    const WHAT: &'static str = WHAT;

    fn read(body: &mut Reader<'_>) -> Result<Self> {
        let version = body.version();
        let old = version.archive < 60 || version.archive == 60 && version.opennurbs <= OLD_UNTIL;
        // Between the two only a look tells.
        let chunked = body.peek_typecode() == Some(typecode::ANONYMOUS);
        if old && !chunked { Self::read_old(body) } else { Self::read_new(body) }
    }

    fn write(&self, number: i32, id: Uuid, w: &mut Writer) -> Result<()> {
        if w.version().archive < 60 {
            w.packed_version(1, 2);
            w.i32(number);
            // Gradients came with version 70.
            w.i32(if self.fill == HatchFill::Gradient { SOLID } else { self.kind() });
            w.string(&self.name)?;
            w.string(&self.description)?;
            if self.kind() == LINES {
                self.write_lines(w)?;
            }
            w.uuid(id);
            return Ok(());
        }
        w.versioned(1, 0, |w| {
            Component::new(id, number, &self.name).write_bits(w)?;
            w.i32(self.kind());
            w.string(&self.description)?;
            w.chunk(typecode::ANONYMOUS, |w| self.write_lines(w))
        })
    }
}
