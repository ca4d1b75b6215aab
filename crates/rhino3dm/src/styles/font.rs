//! Fonts: of dimension styles from version 60 on, and as text styles in a table of their own before.

use uuid::Uuid;

use super::TEXT_STYLE;
use crate::Result;
use crate::chunk::{Reader, Writer};
use crate::class_object::{ClassObject, write_class};

/// What text is written in.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Font {
    /// The face.
    pub(crate) face: String,
    /// The font in words.
    pub(crate) description: String,
    /// The weight as Windows numbers it: 400 is normal, 700 bold.
    pub(crate) weight: i32,
    /// The slope: 1 upright, 2 italic, 3 oblique.
    pub(crate) slope: u32,
    /// The stretch, from 1 for the narrowest to 9; 5 is medium.
    stretch: u32,
    /// Whether it is underlined, and struck through.
    lines: [bool; 2],
}

const WHAT: &str = "font";
const UTF8: u32 = 0x4000_8001;
const NORMAL: i32 = 400;
/// Fonts from this weight on are the bold ones among regular, bold, italic and bold italic.
const BOLD: i32 = 500;
/// The weights above normal that are 1 elsewhere.
const FULL_WEIGHT: f64 = 750.0;
/// The face of fonts that are not known, its name for printers and that of its normal variant.
const DEFAULT: &str = "Arial";
const DEFAULT_NAMES: [&str; 2] = ["ArialMT", "Regular"];
const UPRIGHT: u32 = 1;
const ITALIC: u32 = 2;
/// The weights of version 5, each with the first of greater ones that is no longer it.
const OLD_WEIGHTS: [(i32, i32); 3] = [(300, 350), (400, 450), (500, 600)];
/// UTF-16 units of a face in a text style.
const FACE: usize = 64;
/// How far lines are apart as a multiple of the height, which no reader takes notice of.
const LINE_FEED: f64 = 1.6;

impl Default for Font {
    fn default() -> Self {
        Self::new(DEFAULT.into(), NORMAL, false)
    }
}

impl Font {
    fn new(face: String, weight: i32, italic: bool) -> Self {
        let slope = if italic { ITALIC } else { UPRIGHT };
        Self { description: face.clone(), face, weight, slope, stretch: 5, lines: [false; 2] }
    }

    /// The weight by its hundreds, 1 to 9.
    fn weight_number(&self) -> u32 {
        u32::try_from((self.weight + 50) / 100).map_or(4, |number| number.clamp(1, 9))
    }

    /// Reads the chunk of a dimension style.
    pub(super) fn read(body: &mut Reader<'_>) -> Result<Self> {
        let (mut body, minor) = body.versioned_1(WHAT)?;
        let characteristics = body.u32(WHAT)?;
        let mut chunk = body.expect(UTF8, WHAT)?;
        // Whether there is any text.
        let face = if chunk.u8(WHAT)? == 1 {
            String::from_utf8_lossy(chunk.rest()).into_owned()
        } else {
            String::new()
        };
        chunk.finish();
        // The name for other systems.
        let elsewhere = body.string(WHAT)?;
        let mut font = Self::new(if face.is_empty() { elsewhere } else { face }, NORMAL, false);
        if characteristics % 2 == 1 {
            let [weight, slope, stretch] =
                [characteristics / 2 % 10, characteristics / 20 % 4, characteristics / 80 % 10];
            font.weight = i32::try_from(weight).unwrap_or_default() * 100;
            (font.slope, font.stretch) = (slope, stretch);
            font.lines = [characteristics / 800 % 2 == 1, characteristics / 1600 % 2 == 1];
        }
        if minor >= 1 {
            font.description = body.string(WHAT)?;
        }
        if minor >= 2 {
            font.weight = body.i32(WHAT)?;
        }
        body.finish();
        Ok(font)
    }

    /// Writes the chunk of a dimension style, the names as a machine does that has none but the default font.
    pub(super) fn write(&self, w: &mut Writer) -> Result<()> {
        let is_default = self.face == DEFAULT && self.weight == NORMAL;
        let [postscript, variant] = if is_default { DEFAULT_NAMES } else { [""; 2] };
        w.versioned(1, 6, |w| {
            let lines = u32::from(self.lines[0]) + 2 * u32::from(self.lines[1]);
            let slope_and_on = self.slope % 4 + 4 * (self.stretch % 10 + 10 * lines);
            w.u32(1 + 2 * (self.weight_number() + 10 * slope_and_on));
            w.chunk(UTF8, |w| {
                w.u8(u8::from(!self.face.is_empty()));
                w.bytes(self.face.as_bytes());
                Ok(())
            })?;
            w.string(postscript)?;
            w.string(if is_default { postscript } else { &self.face })?;
            w.i32(self.weight);
            // The weight for other systems, the size in points.
            w.f64(if self.weight == NORMAL { 0.0 } else { f64::from(self.weight - NORMAL) / FULL_WEIGHT });
            w.f64(0.0);
            w.bool(false);
            for name in
                [&self.face, "", postscript, postscript, &self.face, &self.face, &self.face, &self.face]
            {
                w.string(name)?;
            }
            w.string(variant)?;
            w.string(variant)?;
            // Classification numbers, which are not known.
            w.versioned(1, 1, |w| {
                w.bytes(&[0; 10]);
                Ok(())
            })?;
            w.u8(if self.weight >= BOLD { 2 } else { 1 });
            Ok(())
        })
    }

    /// Reads a text style.
    pub(super) fn read_style(object: &ClassObject<'_>) -> Result<Option<Self>> {
        let Some(mut body) = object.data.clone().filter(|_| object.class == TEXT_STYLE) else {
            return Ok(None);
        };
        let (major, minor) = body.packed_version(WHAT)?;
        if major != 1 {
            return Ok(None);
        }
        // Its number, and words that no reader believes.
        body.i32(WHAT)?;
        body.string(WHAT)?;
        let units =
            body.take(2 * FACE, WHAT)?.as_chunks::<2>().0.iter().map(|unit| u16::from_le_bytes(*unit));
        let face = char::decode_utf16(units.take_while(|unit| *unit != 0));
        let face = face.map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect();
        let (mut weight, mut italic) = (NORMAL, false);
        if minor >= 1 {
            weight = Some(body.i32(WHAT)?).filter(|weight| (100..=1000).contains(weight)).unwrap_or(NORMAL);
            italic = body.i32(WHAT)? != 0;
        }
        let face = if String::is_empty(&face) { DEFAULT.into() } else { face };
        Ok(Some(Self::new(face, weight, italic)))
    }

    /// Writes a text style, which versions before 60 have.
    pub(super) fn write_style(&self, number: i32, id: Uuid, w: &mut Writer) -> Result<()> {
        write_class(w, TEXT_STYLE, &[], |w| {
            w.packed_version(1, 2);
            w.i32(number);
            w.string(&self.description)?;
            let units = self.face.encode_utf16().take(FACE - 1);
            units.chain(std::iter::repeat(0)).take(FACE).for_each(|unit| w.u16(unit));
            let known = OLD_WEIGHTS.iter().find(|(_, end)| self.weight < *end);
            w.i32(if self.weight <= 0 { NORMAL } else { known.map_or(700, |(weight, _)| *weight) });
            w.i32(i32::from(self.slope == ITALIC));
            w.f64(LINE_FEED);
            w.uuid(id);
            Ok(())
        })
    }
}
