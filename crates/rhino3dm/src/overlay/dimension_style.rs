//! Dimension styles and text styles (section 8): their names and main numbers.

use uuid::{Uuid, uuid};

use crate::Result;
use crate::class_object::ClassObject;
use crate::tables::Component;

/// How dimensions look: what they are called and their main sizes, in model units.
#[derive(Debug, Clone, PartialEq)]
pub struct DimensionStyle {
    /// The identifier; nil in archives before version 50.
    pub id: Uuid,
    /// The number by which annotations of before version 60 refer to it.
    pub number: i32,
    /// The name.
    pub name: String,
    /// How far extension lines go beyond the dimension line.
    pub extension_line_extension: f64,
    /// How far extension lines begin from what is measured.
    pub extension_line_offset: f64,
    /// The length of arrowheads.
    pub arrow_length: f64,
    /// The size of centre marks.
    pub centermark_size: f64,
    /// The gap between text and lines.
    pub text_gap: f64,
    /// The height of text.
    pub text_height: f64,
}

/// The font of annotations in archives before version 60.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TextStyle {
    /// The identifier; nil in archives before version 50.
    pub id: Uuid,
    /// The number by which annotations and dimension styles refer to it.
    pub number: i32,
    /// The name.
    pub name: String,
    /// The face of the font.
    pub face: String,
    /// The weight, 400 for normal; nothing where the archive does not say.
    pub weight: Option<i32>,
    /// Whether it is italic.
    pub italic: bool,
}

/// The class of dimension styles from version 60 on, and of before.
const NEW: Uuid = uuid!("67AA51A5-791D-4BEC-8AED-D23B462B6F87");
const OLD: Uuid = uuid!("81BD83D5-7120-41C4-9A57-C449336FF12C");
const TEXT_STYLE: Uuid = uuid!("4F0F51FB-35D0-4865-9998-6D2C6A99721D");
/// Bytes of a face name: 64 UTF-16 units.
const FACE: usize = 128;

impl DimensionStyle {
    pub(crate) fn read(object: &ClassObject<'_>) -> Result<Option<Self>> {
        const WHAT: &str = "dimension style";
        let Some(mut body) = object.data.clone() else { return Ok(None) };
        match object.class {
            NEW => {
                let (mut body, _) = body.versioned_1(WHAT)?;
                let Component { id, number, name, .. } = Component::read_fields(&mut body)?;
                let mut next = || body.f64(WHAT);
                let [extension, offset, arrow] = [next()?, next()?, next()?];
                // The arrowheads of leaders.
                next()?;
                Ok(Some(Self {
                    id,
                    number,
                    name,
                    extension_line_extension: extension,
                    extension_line_offset: offset,
                    arrow_length: arrow,
                    centermark_size: next()?,
                    text_gap: next()?,
                    text_height: next()?,
                }))
            }
            OLD => {
                body.packed_version(WHAT)?;
                let (number, name) = (body.i32(WHAT)?, body.string(WHAT)?);
                let mut style = Self {
                    id: Uuid::nil(),
                    number,
                    name,
                    extension_line_extension: body.f64(WHAT)?,
                    extension_line_offset: body.f64(WHAT)?,
                    arrow_length: body.f64(WHAT)?,
                    centermark_size: body.f64(WHAT)?,
                    text_gap: body.f64(WHAT)?,
                    text_height: 0.0,
                };
                // Alignment, arrowheads, formats, resolutions and the text style.
                body.take(32, WHAT)?;
                // Version 1.0 has no height.
                if !body.is_at_end() {
                    style.text_height = body.f64(WHAT)?;
                }
                Ok(Some(style))
            }
            _ => Ok(None),
        }
    }
}

impl TextStyle {
    pub(crate) fn read(object: &ClassObject<'_>) -> Result<Option<Self>> {
        const WHAT: &str = "text style";
        let Some(mut body) = object.data.clone().filter(|_| object.class == TEXT_STYLE) else {
            return Ok(None);
        };
        let (major, minor) = body.packed_version(WHAT)?;
        if major != 1 {
            return Ok(None);
        }
        let (number, name) = (body.i32(WHAT)?, body.string(WHAT)?);
        let face = body.take(FACE, WHAT)?.as_chunks::<2>().0.iter().map(|unit| u16::from_le_bytes(*unit));
        let face = char::decode_utf16(face.take_while(|unit| *unit != 0));
        let face = face.map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect();
        let mut style = Self { id: Uuid::nil(), number, name, face, weight: None, italic: false };
        if minor >= 1 {
            style.weight = Some(body.i32(WHAT)?);
            style.italic = body.i32(WHAT)? != 0;
            // How far lines are apart.
            body.f64(WHAT)?;
        }
        if minor >= 2 {
            style.id = body.uuid(WHAT)?;
        }
        Ok(Some(style))
    }
}
