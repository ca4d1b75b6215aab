//! Class TextDot (section 8), and the dots of version 2.

use katydid_geometry::Point3;

use super::major_1;
use crate::Result;
use crate::chunk::{Reader, Writer};

/// Text at a point, always turned to the viewer and of one size on the screen.
#[derive(Debug, Clone, PartialEq)]
pub struct TextDot {
    /// The middle of the text.
    pub point: Point3,
    /// The text.
    pub text: String,
    /// More text, shown when the dot is asked for it. Kept from version 60 on.
    pub secondary_text: String,
    /// The face of the font.
    pub font: String,
    /// The height of the text in points of the screen.
    pub height: i32,
    /// Drawn over everything else.
    pub always_on_top: bool,
    /// Drawn so that what lies behind shines through.
    pub transparent: bool,
    /// In bold type.
    pub bold: bool,
    /// In italic type.
    pub italic: bool,
}

impl TextDot {
    /// A dot as a new one in Rhino: 14 points high.
    pub fn new(point: Point3, text: impl Into<String>) -> Self {
        Self {
            point,
            text: text.into(),
            secondary_text: String::new(),
            font: DEFAULT_FONT.into(),
            height: DEFAULT_HEIGHT,
            always_on_top: false,
            transparent: false,
            bold: false,
            italic: false,
        }
    }
}

const WHAT: &str = "text dot";
/// What the official reader gives the dots of version 2, which have neither font nor height.
const DEFAULT_FONT: &str = "Arial";
const DEFAULT_HEIGHT: i32 = 14;

const ON_TOP: i32 = 1;
const TRANSPARENT: i32 = 2;
const BOLD: i32 = 4;
const ITALIC: i32 = 8;

pub(super) fn read(body: &mut Reader<'_>) -> Result<TextDot> {
    let minor = major_1(body, WHAT)?;
    let point = body.point(WHAT)?;
    let height = body.i32(WHAT)?;
    let text = body.string(WHAT)?;
    let font = body.string(WHAT)?;
    let bits = body.i32(WHAT)?;
    let secondary_text = if minor >= 1 { body.string(WHAT)? } else { String::new() };
    let has = |bit: i32| bits & bit != 0;
    Ok(TextDot {
        point,
        text,
        secondary_text,
        font,
        height,
        always_on_top: has(ON_TOP),
        transparent: has(TRANSPARENT),
        bold: has(BOLD),
        italic: has(ITALIC),
    })
}

/// The dots of version 2: a point and its text.
pub(super) fn read_version_2(body: &mut Reader<'_>) -> Result<TextDot> {
    major_1(body, WHAT)?;
    let point = body.point(WHAT)?;
    Ok(TextDot::new(point, body.string(WHAT)?))
}

pub(super) fn write(dot: &TextDot, w: &mut Writer) -> Result<()> {
    let newer = w.version().archive >= 60;
    w.packed_version(1, u8::from(newer));
    w.point(dot.point);
    w.i32(dot.height);
    w.string(&dot.text)?;
    w.string(&dot.font)?;
    let bit = |set: bool, bit: i32| if set { bit } else { 0 };
    w.i32(
        bit(dot.always_on_top, ON_TOP)
            | bit(dot.transparent, TRANSPARENT)
            | bit(dot.bold, BOLD)
            | bit(dot.italic, ITALIC),
    );
    if newer {
        w.string(&dot.secondary_text)?;
    }
    Ok(())
}
