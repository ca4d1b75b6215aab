//! Values of the archive, as they are written in settings and details.

use base64::{Engine, engine::general_purpose::STANDARD as BASE64};

use super::ast::RawValue;
use super::lexer::Kind;
use super::parser::{Parsed, Parser};
use super::problem::Fault;
use super::text;
use crate::archive::{Colour, ItemValue, Version};

/// Reads a value.
pub(super) fn parse(p: &mut Parser<'_>) -> Parsed<RawValue> {
    let token = p.peek();
    let value = match token.kind {
        Kind::Text | Kind::Raw => ItemValue::String(p.string("a text")?),
        Kind::Guid => ItemValue::Guid(p.guid()?),
        Kind::Number if token.text.bytes().all(|b| b.is_ascii_digit() || b == b'-') => {
            ItemValue::Int32(p.integer("a whole number that fits 32 bits")?)
        }
        Kind::Number => ItemValue::Double(p.double()?),
        Kind::Word => {
            if matches!(token.text, "nan" | "inf") {
                return Ok(RawValue::Value(ItemValue::Double(p.double()?)));
            }
            p.at += 1;
            match token.text {
                "true" => ItemValue::Bool(true),
                "false" => ItemValue::Bool(false),
                "base64" => ItemValue::String(BASE64.encode(p.string("a text")?)),
                "bytes" if p.peek().kind == Kind::Data => return Ok(RawValue::Bytes(p.data_number()?)),
                "bitmap" if p.peek().kind == Kind::Data => return Ok(RawValue::Bitmap(p.data_number()?)),
                "decimal" => {
                    let number = p.peek();
                    match number.text.parse() {
                        Ok(decimal) if number.kind == Kind::Number => {
                            p.at += 1;
                            ItemValue::Decimal(decimal)
                        }
                        _ => return p.expected("a decimal number"),
                    }
                }
                "rgb" => ItemValue::Colour(colour(p)?),
                word => match typed(p, word)? {
                    Some(value) => value,
                    None => {
                        p.at -= 1;
                        return p.expected("a value of the archive");
                    }
                },
            }
        }
        _ => return p.expected("a value"),
    };
    Ok(RawValue::Value(value))
}

/// `rgb(r, g, b)`, with an opacity from 0 to 255 where it is not solid; the word is taken already.
fn colour(p: &mut Parser<'_>) -> Parsed<Colour> {
    p.expect("(", "before red, green and blue")?;
    let mut parts = [0, 0, 0, 255];
    for (k, part) in parts.iter_mut().enumerate() {
        *part = p.integer("a number from 0 to 255")?;
        if !p.eat(",") && k >= 2 {
            break;
        }
    }
    p.expect(")", "after the colour")?;
    let [r, g, b, a] = parts;
    Ok(Colour { a, r, g, b })
}

fn doubles<const N: usize>(p: &mut Parser<'_>) -> Parsed<[f64; N]> {
    let mut values = [0.0; N];
    for x in &mut values {
        *x = p.double()?;
    }
    Ok(values)
}

fn singles<const N: usize>(p: &mut Parser<'_>) -> Parsed<[f32; N]> {
    Ok(doubles::<N>(p)?.map(|x| x as f32))
}

fn integers<const N: usize>(p: &mut Parser<'_>) -> Parsed<[i32; N]> {
    let mut values = [0; N];
    for n in &mut values {
        *n = p.integer("a whole number")?;
    }
    Ok(values)
}

/// A value behind the word for its type; nothing when there is no such word.
fn typed(p: &mut Parser<'_>, word: &str) -> Parsed<Option<ItemValue>> {
    Ok(Some(match word {
        "byte" => ItemValue::Byte(p.integer("a number from 0 to 255")?),
        "long" => ItemValue::Int64(p.integer("a whole number")?),
        "single" => {
            // Read at its own width: rounding twice could miss the nearest.
            let token = p.peek();
            let x = token.text.parse().ok().filter(|_| token.kind == Kind::Number);
            match x {
                Some(x) => {
                    p.at += 1;
                    ItemValue::Single(x)
                }
                None => ItemValue::Single(p.double()? as f32),
            }
        }
        "date" => ItemValue::Date(p.integer("a whole number")?),
        "doubles" => {
            let mut values = Vec::new();
            p.expect("[", "before the numbers")?;
            while !p.eat("]") {
                values.push(p.double()?);
                p.eat(",");
            }
            ItemValue::DoubleArray(values)
        }
        "pixel" => ItemValue::Point(integers(p)?),
        "spot" => ItemValue::PointF(singles(p)?),
        "pixels" => ItemValue::Size(integers(p)?),
        "size" => ItemValue::SizeF(singles(p)?),
        "frame" => ItemValue::Rectangle(integers(p)?),
        "rectangle" => ItemValue::RectangleF(singles(p)?),
        "uv" => ItemValue::Point2d(doubles(p)?),
        "point" => ItemValue::Point3d(doubles(p)?),
        "xyzw" => ItemValue::Point4d(doubles(p)?),
        "interval" => ItemValue::Interval1d(doubles(p)?),
        "intervals" => ItemValue::Interval2d(doubles(p)?),
        "line" => ItemValue::Line(Box::new(doubles(p)?)),
        "bounds" => ItemValue::BoundingBox(Box::new(doubles(p)?)),
        "plane" => ItemValue::Plane(Box::new(doubles(p)?)),
        "version" => {
            let [major, minor, revision] = integers(p)?;
            ItemValue::Version(Version { major, minor, revision })
        }
        _ => return Ok(None),
    }))
}

/// Writes a value; bytes go into the data that the closure keeps.
pub(super) fn print(
    value: &ItemValue,
    name: &str,
    indent: usize,
    keep: &mut dyn FnMut(&[u8]) -> u32,
) -> String {
    match value {
        ItemValue::Bool(b) => b.to_string(),
        ItemValue::Byte(n) => format!("byte {n}"),
        ItemValue::Int32(n) => n.to_string(),
        ItemValue::Int64(n) => format!("long {n}"),
        ItemValue::Single(x) => format!("single {}", single(*x)),
        ItemValue::Double(x) => double(*x),
        ItemValue::Decimal(d) => format!("decimal {d}"),
        ItemValue::Date(ticks) => format!("date {ticks}"),
        ItemValue::Guid(id) => format!("@{id}"),
        ItemValue::String(string) => match base64_text(name, string) {
            Some(inside) => format!("base64 {}", string_form(&inside, indent)),
            None => string_form(string, indent),
        },
        ItemValue::ByteArray(bytes) => format!("bytes ${}", keep(bytes)),
        ItemValue::Bitmap(bytes) => format!("bitmap ${}", keep(bytes)),
        ItemValue::DoubleArray(values) => {
            format!("doubles [{}]", values.iter().map(|x| double(*x)).collect::<Vec<_>>().join(", "))
        }
        ItemValue::Point(v) => numbers("pixel", v),
        ItemValue::PointF(v) => words("spot", v, single),
        ItemValue::Size(v) => numbers("pixels", v),
        ItemValue::SizeF(v) => words("size", v, single),
        ItemValue::Rectangle(v) => numbers("frame", v),
        ItemValue::RectangleF(v) => words("rectangle", v, single),
        ItemValue::Colour(c) => colour_form(*c),
        ItemValue::Point2d(v) => words("uv", v, double),
        ItemValue::Point3d(v) => words("point", v, double),
        ItemValue::Point4d(v) => words("xyzw", v, double),
        ItemValue::Interval1d(v) => words("interval", v, double),
        ItemValue::Interval2d(v) => words("intervals", v, double),
        ItemValue::Line(v) => words("line", v.as_slice(), double),
        ItemValue::BoundingBox(v) => words("bounds", v.as_slice(), double),
        ItemValue::Plane(v) => words("plane", v.as_slice(), double),
        ItemValue::Version(v) => format!("version {} {} {}", v.major, v.minor, v.revision),
    }
}

/// A number of 64 bits with a point or an exponent in it, so that it is no whole number.
pub(super) fn double(x: f64) -> String {
    if x.is_nan() {
        return "nan".to_owned();
    }
    format!("{x:?}")
}

/// A number of 32 bits, without a point where it needs none.
pub(super) fn single(x: f32) -> String {
    if x.is_nan() {
        return "nan".to_owned();
    }
    let text = format!("{x:?}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

/// `rgb(…)`.
pub(super) fn colour_form(Colour { a, r, g, b }: Colour) -> String {
    if a == 255 { format!("rgb({r}, {g}, {b})") } else { format!("rgb({r}, {g}, {b}, {a})") }
}

/// A text in quotes, over several lines where it reads better.
pub(super) fn string_form(string: &str, indent: usize) -> String {
    if text::suits_raw(string) { text::raw(string, indent) } else { text::quote(string, '"') }
}

fn numbers(word: &str, values: &[i32]) -> String {
    words(word, values, |n| n.to_string())
}

fn words<T: Copy>(word: &str, values: &[T], form: impl Fn(T) -> String) -> String {
    let values: Vec<String> = values.iter().map(|x| form(*x)).collect();
    format!("{word} {}", values.join(" "))
}

/// The text inside of a script that Rhino 8 keeps in base64.
fn base64_text(name: &str, string: &str) -> Option<String> {
    if name != "Text" || string.is_empty() {
        return None;
    }
    let inside = String::from_utf8(BASE64.decode(string).ok()?).ok()?;
    (BASE64.encode(&inside) == string && !inside.contains('\u{feff}')).then_some(inside)
}

/// A fault about a piece of data that is not there.
pub(super) fn missing_data(n: u32, at: usize, len: usize) -> Fault {
    Fault::new(at, len, format!("there is no ${n} in the data block"))
}
