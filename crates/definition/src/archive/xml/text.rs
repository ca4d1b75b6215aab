//! From bytes to text, and the five named characters of XML.

use std::borrow::Cow;

use crate::{Error, Place, Result};

const UTF8_MARK: &[u8] = b"\xef\xbb\xbf";

/// Whether the first sign after a byte order mark and blanks is `<`, in UTF-8 or UTF-16.
pub(in crate::archive) fn looks_like_xml(bytes: &[u8]) -> bool {
    if utf16(bytes).is_some() {
        return true;
    }
    let rest = bytes.strip_prefix(UTF8_MARK).unwrap_or(bytes);
    rest.iter().find(|b| !b.is_ascii_whitespace()) == Some(&b'<')
}

/// How two bytes make a unit of UTF-16.
type Unit = fn([u8; 2]) -> u16;

/// The text behind the byte order mark, and how to read it, when it is surely in UTF-16.
fn utf16(bytes: &[u8]) -> Option<(&[u8], Unit)> {
    match bytes {
        [0xff, 0xfe, rest @ ..] => Some((rest, u16::from_le_bytes)),
        [0xfe, 0xff, rest @ ..] => Some((rest, u16::from_be_bytes)),
        [b'<', 0, ..] => Some((bytes, u16::from_le_bytes)),
        [0, b'<', ..] => Some((bytes, u16::from_be_bytes)),
        _ => None,
    }
}

/// The text, without its byte order mark.
pub(super) fn decode(bytes: &[u8], limit: usize) -> Result<Cow<'_, str>> {
    if bytes.len() > limit {
        return Err(Error::Limit {
            place: Place::File,
            offset: limit,
            what: "the length of the XML text",
            limit,
        });
    }
    let Some((units, unit)) = utf16(bytes) else {
        let rest = bytes.strip_prefix(UTF8_MARK).unwrap_or(bytes);
        let skipped = bytes.len() - rest.len();
        return std::str::from_utf8(rest)
            .map(Cow::Borrowed)
            .map_err(|error| Error::at(Place::File, skipped + error.valid_up_to(), "it is not valid UTF-8"));
    };
    let pairs = units.as_chunks::<2>();
    if !pairs.1.is_empty() {
        return Err(Error::at(Place::File, bytes.len(), "the UTF-16 text ends in the middle of a character"));
    }
    let text: std::result::Result<String, _> =
        char::decode_utf16(pairs.0.iter().map(|pair| unit(*pair))).collect();
    text.map(Cow::Owned).map_err(|_| Error::at(Place::File, 0, "it is not valid UTF-16"))
}

/// The character that `&name;` stands for; only XML's own five and numbers are known.
pub(super) fn reference(name: &str) -> Option<char> {
    match name {
        "lt" => Some('<'),
        "gt" => Some('>'),
        "amp" => Some('&'),
        "apos" => Some('\''),
        "quot" => Some('"'),
        _ => {
            let number = name.strip_prefix('#')?;
            let code = match number.strip_prefix(['x', 'X']) {
                Some(hex) => u32::from_str_radix(hex, 16),
                None => number.parse(),
            };
            char::from_u32(code.ok()?)
        }
    }
}

/// An attribute's value with its references resolved; blanks of any kind become spaces, as XML wants it.
pub(super) fn attribute(raw: &str) -> std::result::Result<String, String> {
    let mut value = String::with_capacity(raw.len());
    let mut rest = raw;
    while let Some((before, after)) = rest.split_once('&') {
        value.extend(before.chars().map(blank));
        let (name, after) = after.split_once(';').ok_or("a lone & in an attribute")?;
        value.push(reference(name).ok_or_else(|| format!("&{name}; is not a known character"))?);
        rest = after;
    }
    value.extend(rest.chars().map(blank));
    Ok(value)
}

fn blank(c: char) -> char {
    if matches!(c, '\t' | '\r' | '\n') { ' ' } else { c }
}

/// Writes text between elements. Whatever a reader would change or refuse becomes a numeric reference.
pub(super) fn escape(out: &mut String, text: &str, in_attribute: bool) {
    for c in text.chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '"' if in_attribute => out.push_str("&quot;"),
            '\n' | '\t' if !in_attribute => out.push(c),
            '\u{0}'..='\u{1f}' | '\u{7f}'..='\u{9f}' | '\u{2028}' | '\u{fffe}' | '\u{ffff}' => {
                out.push_str(&format!("&#x{:X};", u32::from(c)));
            }
            _ => out.push(c),
        }
    }
}
