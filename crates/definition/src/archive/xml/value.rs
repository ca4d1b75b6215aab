//! An item's value from its text and fields.

use base64::alphabet;
use base64::engine::{DecodePaddingMode, Engine, GeneralPurpose, GeneralPurposeConfig};
use uuid::Uuid;

use super::number::{read_double, read_single};
use super::read::{ItemParts, clip};
use super::write::{AB, AB_UV, BOX, LINE, PLANE, VERSION, WH, XY, XYWH, XYZ, XYZW};
use crate::archive::value::TYPES;
use crate::archive::{Colour, Item, ItemValue, Version};

type Found<T> = std::result::Result<T, String>;

const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// The type code of a type name.
pub(super) fn code_of(type_name: &str) -> Option<i32> {
    TYPES.iter().find(|(_, name)| *name == type_name).map(|(code, _)| *code)
}

/// The item, or why its value cannot be read.
pub(super) fn build(mut parts: ItemParts) -> Found<Item> {
    let value =
        value(&mut parts).map_err(|reason| format!("the item \"{}\": {reason}", clip(&parts.name)))?;
    Ok(Item { name: parts.name, index: parts.index, value })
}

fn value(parts: &mut ItemParts) -> Found<ItemValue> {
    if parts.code == 10 {
        return Ok(ItemValue::String(std::mem::take(&mut parts.text)));
    }
    let text = parts.text.trim();
    let doubles = |name: &str| field(parts, name, read_double);
    let singles = |name: &str| field(parts, name, read_single);
    let whole = |name: &str| field(parts, name, |text| text.parse::<i32>().ok());
    Ok(match parts.code {
        1 => ItemValue::Bool(number(text, boolean)?),
        2 => ItemValue::Byte(number(text, |t| t.parse().ok())?),
        3 => ItemValue::Int32(number(text, |t| t.parse().ok())?),
        4 => ItemValue::Int64(number(text, |t| t.parse().ok())?),
        5 => ItemValue::Single(number(text, read_single)?),
        6 => ItemValue::Double(number(text, read_double)?),
        7 => ItemValue::Decimal(text.parse()?),
        8 => ItemValue::Date(number(text, |t| t.parse().ok())?),
        9 => ItemValue::Guid(number(text, |t| Uuid::try_parse(t).ok())?),
        20 => ItemValue::ByteArray(bytes(parts, "stream")?),
        21 => {
            let bytes = bytes(parts, "stream")?;
            let (numbers, rest) = bytes.as_chunks::<8>();
            if !rest.is_empty() {
                return Err(format!("{} bytes are no array of numbers", bytes.len()));
            }
            ItemValue::DoubleArray(numbers.iter().map(|number| f64::from_le_bytes(*number)).collect())
        }
        30 => ItemValue::Point(all(XY, whole)?),
        31 => ItemValue::PointF(all(XY, singles)?),
        32 => ItemValue::Size(all(WH, whole)?),
        33 => ItemValue::SizeF(all(WH, singles)?),
        34 => ItemValue::Rectangle(all(XYWH, whole)?),
        35 => ItemValue::RectangleF(all(XYWH, singles)?),
        36 => ItemValue::Colour(field(parts, "ARGB", colour)?),
        37 => ItemValue::Bitmap(bytes(parts, "bitmap")?),
        50 => ItemValue::Point2d(all(XY, doubles)?),
        51 => ItemValue::Point3d(all(XYZ, doubles)?),
        52 => ItemValue::Point4d(all(XYZW, doubles)?),
        60 => ItemValue::Interval1d(all(AB, doubles)?),
        61 => ItemValue::Interval2d(all(AB_UV, doubles)?),
        70 => ItemValue::Line(Box::new(all(LINE, doubles)?)),
        71 => ItemValue::BoundingBox(Box::new(all(BOX, doubles)?)),
        72 => ItemValue::Plane(Box::new(all(PLANE, doubles)?)),
        80 => {
            let [major, minor, revision] = all(VERSION, whole)?;
            ItemValue::Version(Version { major, minor, revision })
        }
        code => return Err(format!("{code} is not a known item type")),
    })
}

fn number<T>(text: &str, read: impl FnOnce(&str) -> Option<T>) -> Found<T> {
    read(text).ok_or_else(|| format!("\"{}\" is not a value of its type", clip(text)))
}

fn boolean(text: &str) -> Option<bool> {
    if text.eq_ignore_ascii_case("true") || text == "1" {
        Some(true)
    } else if text.eq_ignore_ascii_case("false") || text == "0" {
        Some(false)
    } else {
        None
    }
}

fn colour(text: &str) -> Option<Colour> {
    let mut parts = text.split(';').map(|part| part.trim().parse::<u8>().ok());
    let mut next = || parts.next().flatten();
    let colour = Colour { a: next()?, r: next()?, g: next()?, b: next()? };
    parts.next().is_none().then_some(colour)
}

fn find<'a>(parts: &'a ItemParts, name: &str) -> Found<&'a str> {
    let found = parts.fields.iter().find(|(field, _)| field == name);
    found.map(|(_, text)| text.as_str()).ok_or_else(|| format!("it has no <{name}>"))
}

fn field<T>(parts: &ItemParts, name: &str, read: impl FnOnce(&str) -> Option<T>) -> Found<T> {
    number(find(parts, name)?.trim(), read).map_err(|reason| format!("<{name}>: {reason}"))
}

fn all<const N: usize, T: Copy + Default>(
    names: [&str; N],
    mut read: impl FnMut(&str) -> Found<T>,
) -> Found<[T; N]> {
    let mut values = [T::default(); N];
    for (value, name) in values.iter_mut().zip(names) {
        *value = read(name)?;
    }
    Ok(values)
}

/// Base64 text, which may be broken into lines.
fn bytes(parts: &ItemParts, name: &str) -> Found<Vec<u8>> {
    let text = find(parts, name)?;
    let decoded = if text.bytes().any(|b| b.is_ascii_whitespace()) {
        BASE64.decode(text.split_ascii_whitespace().collect::<String>())
    } else {
        BASE64.decode(text)
    };
    decoded.map_err(|error| format!("<{name}> is not base64: {error}"))
}
