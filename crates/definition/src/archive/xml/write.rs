use base64::{Engine, engine::general_purpose::STANDARD as BASE64};

use super::number::{double, single};
use super::text::escape;
use crate::archive::{Chunk, DEEPEST, Item, ItemValue};
use crate::{Error, Result};

/// The text of a .ghx file, with the byte order mark that Grasshopper puts before it.
pub(in crate::archive) fn write(root: &Chunk) -> Result<String> {
    let mut out =
        String::from("\u{feff}<?xml version=\"1.0\" encoding=\"utf-8\" standalone=\"yes\"?>\n<Archive");
    names(&mut out, &root.name, root.index)?;
    out.push_str(">\n  <!--Grasshopper archive-->\n");
    contents(&mut out, root, 1)?;
    out.push_str("</Archive>");
    Ok(out)
}

fn indent(out: &mut String, level: usize) {
    (0..level).for_each(|_| out.push_str("  "));
}

/// The attributes `name` and `index`.
fn names(out: &mut String, name: &str, index: Option<i32>) -> Result<()> {
    out.push_str(" name=\"");
    escape(out, name, true);
    out.push('"');
    match index {
        None => Ok(()),
        Some(-1) => Err(Error::Unwritable("an index of −1 means none".to_owned())),
        Some(index) => {
            out.push_str(&format!(" index=\"{index}\""));
            Ok(())
        }
    }
}

/// The `<items>` and `<chunks>` of a chunk at the given indentation.
fn contents(out: &mut String, chunk: &Chunk, level: usize) -> Result<()> {
    // Two levels of indentation a chunk, and the root is at 1.
    if level > 2 * DEEPEST - 1 {
        return Err(Error::Unwritable(format!("the chunks are nested more than {DEEPEST} deep")));
    }
    if !chunk.items.is_empty() {
        indent(out, level);
        out.push_str(&format!("<items count=\"{}\">\n", chunk.items.len()));
        for item in &chunk.items {
            write_item(out, item, level + 1)?;
        }
        indent(out, level);
        out.push_str("</items>\n");
    }
    if !chunk.chunks.is_empty() {
        indent(out, level);
        out.push_str(&format!("<chunks count=\"{}\">\n", chunk.chunks.len()));
        for child in &chunk.chunks {
            indent(out, level + 1);
            out.push_str("<chunk");
            names(out, &child.name, child.index)?;
            out.push_str(">\n");
            contents(out, child, level + 2)?;
            indent(out, level + 1);
            out.push_str("</chunk>\n");
        }
        indent(out, level);
        out.push_str("</chunks>\n");
    }
    Ok(())
}

/// An item's value: text of its own, or fields.
enum Body {
    Text(String),
    Fields(Vec<(&'static str, String)>),
    /// Bytes in an element of this name.
    Bytes(&'static str, usize, String),
}

fn write_item(out: &mut String, item: &Item, level: usize) -> Result<()> {
    let body = body(item)?;
    indent(out, level);
    out.push_str("<item");
    names(out, &item.name, item.index)?;
    out.push_str(&format!(" type_name=\"{}\" type_code=\"{}\">", item.value.type_name(), item.value.code()));
    match body {
        Body::Text(text) => escape(out, &text, false),
        Body::Fields(fields) => {
            out.push('\n');
            for (name, text) in fields {
                indent(out, level + 1);
                out.push_str(&format!("<{name}>{text}</{name}>\n"));
            }
            indent(out, level);
        }
        Body::Bytes(name, length, text) => {
            out.push('\n');
            indent(out, level + 1);
            out.push_str(&format!("<{name} length=\"{length}\">{text}</{name}>\n"));
            indent(out, level);
        }
    }
    out.push_str("</item>\n");
    Ok(())
}

fn fields<const N: usize>(names: [&'static str; N], values: [impl ToString; N]) -> Body {
    Body::Fields(names.into_iter().zip(values.iter().map(ToString::to_string)).collect())
}

fn body(item: &Item) -> Result<Body> {
    Ok(match &item.value {
        ItemValue::Bool(value) => Body::Text(value.to_string()),
        ItemValue::Byte(value) => Body::Text(value.to_string()),
        ItemValue::Int32(value) => Body::Text(value.to_string()),
        ItemValue::Int64(value) | ItemValue::Date(value) => Body::Text(value.to_string()),
        ItemValue::Single(value) => Body::Text(single(*value)),
        ItemValue::Double(value) => Body::Text(double(*value)),
        ItemValue::Decimal(value) if value.is_valid() => Body::Text(value.to_string()),
        ItemValue::Decimal(value) => {
            let flags = value.flags;
            return Err(Error::Unwritable(format!(
                "\"{}\" is no decimal number (flags {flags:#x})",
                item.name
            )));
        }
        ItemValue::Guid(value) => Body::Text(value.to_string()),
        ItemValue::String(value) => Body::Text(value.clone()),
        ItemValue::ByteArray(bytes) => Body::Bytes("stream", bytes.len(), BASE64.encode(bytes)),
        ItemValue::Bitmap(bytes) => Body::Bytes("bitmap", bytes.len(), BASE64.encode(bytes)),
        ItemValue::DoubleArray(values) => {
            let bytes: Vec<u8> = values.iter().flat_map(|x| x.to_le_bytes()).collect();
            Body::Bytes("stream", bytes.len(), BASE64.encode(&bytes))
        }
        ItemValue::Point(v) => fields(XY, *v),
        ItemValue::PointF(v) => fields(XY, v.map(single)),
        ItemValue::Size(v) => fields(WH, *v),
        ItemValue::SizeF(v) => fields(WH, v.map(single)),
        ItemValue::Rectangle(v) => fields(XYWH, *v),
        ItemValue::RectangleF(v) => fields(XYWH, v.map(single)),
        ItemValue::Colour(c) => fields(["ARGB"], [format!("{};{};{};{}", c.a, c.r, c.g, c.b)]),
        ItemValue::Point2d(v) => fields(XY, v.map(double)),
        ItemValue::Point3d(v) => fields(XYZ, v.map(double)),
        ItemValue::Point4d(v) => fields(XYZW, v.map(double)),
        ItemValue::Interval1d(v) => fields(AB, v.map(double)),
        ItemValue::Interval2d(v) => fields(AB_UV, v.map(double)),
        ItemValue::Line(v) => fields(LINE, v.map(double)),
        ItemValue::BoundingBox(v) => fields(BOX, v.map(double)),
        ItemValue::Plane(v) => fields(PLANE, v.map(double)),
        ItemValue::Version(v) => fields(VERSION, [v.major, v.minor, v.revision]),
    })
}

pub(super) const XY: [&str; 2] = ["X", "Y"];
pub(super) const WH: [&str; 2] = ["W", "H"];
pub(super) const XYWH: [&str; 4] = ["X", "Y", "W", "H"];
pub(super) const XYZ: [&str; 3] = ["X", "Y", "Z"];
pub(super) const XYZW: [&str; 4] = ["X", "Y", "Z", "W"];
pub(super) const AB: [&str; 2] = ["A", "B"];
pub(super) const AB_UV: [&str; 4] = ["Au", "Bu", "Av", "Bv"];
pub(super) const LINE: [&str; 6] = ["Ax", "Ay", "Az", "Bx", "By", "Bz"];
/// Inferred: no file with a bounding box is known.
pub(super) const BOX: [&str; 6] = ["MinX", "MinY", "MinZ", "MaxX", "MaxY", "MaxZ"];
pub(super) const PLANE: [&str; 9] = ["Ox", "Oy", "Oz", "Xx", "Xy", "Xz", "Yx", "Yy", "Yz"];
pub(super) const VERSION: [&str; 3] = ["Major", "Minor", "Revision"];
