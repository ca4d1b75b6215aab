//! The header: which elements there are, and what each has.

use super::FORMAT;
use crate::{Error, Result};

/// How numbers are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    Little,
    Big,
}

/// The type of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    pub(super) const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub(super) const fn is_float(self) -> bool {
        matches!(self, Self::F32 | Self::F64)
    }
}

/// A number of an element, or a list of numbers with the type of its count.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) count: Option<Scalar>,
    pub(super) scalar: Scalar,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: usize,
    pub(super) properties: Vec<Property>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// Where the body begins.
    pub(super) length: usize,
    /// The lines before it.
    pub(super) lines: usize,
}

/// Headers with more lines or elements than this are no headers.
const MOST_LINES: usize = 10_000;

pub(super) fn read(bytes: &[u8]) -> Result<Header> {
    let mut length = 0;
    let mut encoding = None;
    let mut elements: Vec<Element> = Vec::new();
    for number in 1..=MOST_LINES {
        let wrong = |why: &str| Error::malformed(FORMAT, format!("line {number}"), why);
        let left = bytes.get(length..).unwrap_or_default();
        let end = left.iter().position(|b| *b == b'\n').ok_or_else(|| wrong("the header has no end"))?;
        length += end + 1;
        let line = String::from_utf8_lossy(left.get(..end).unwrap_or_default());
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        match *words.as_slice() {
            ["ply"] if number == 1 => {}
            _ if number == 1 => return Err(wrong("it does not begin with the line 'ply'")),
            ["format", "ascii", _] => encoding = Some(Encoding::Ascii),
            ["format", "binary_little_endian", _] => encoding = Some(Encoding::Little),
            ["format", "binary_big_endian", _] => encoding = Some(Encoding::Big),
            ["format", ..] => return Err(wrong("the form is none of the three there are")),
            ["element", name, count] => {
                let count = count.parse().map_err(|_| wrong("an element needs a count"))?;
                elements.push(Element { name: name.to_owned(), count, properties: Vec::new() });
            }
            ["property", ref of @ ..] => {
                let property =
                    property(of).ok_or_else(|| wrong("a property needs a type that is known, and a name"))?;
                let element =
                    elements.last_mut().ok_or_else(|| wrong("a property before the first element"))?;
                element.properties.push(property);
            }
            ["end_header"] => {
                let encoding = encoding.ok_or_else(|| wrong("the header names no form"))?;
                return Ok(Header { encoding, elements, length, lines: number });
            }
            // Comments, obj_info, empty lines.
            _ => {}
        }
    }
    Err(Error::malformed(FORMAT, "the header", "it has too many lines"))
}

fn property(words: &[&str]) -> Option<Property> {
    match *words {
        ["list", count, scalar, name] => {
            let count = Scalar::named(count).filter(|count| !count.is_float())?;
            Some(Property { name: name.to_owned(), count: Some(count), scalar: Scalar::named(scalar)? })
        }
        [scalar, name] => {
            Some(Property { name: name.to_owned(), count: None, scalar: Scalar::named(scalar)? })
        }
        _ => None,
    }
}
