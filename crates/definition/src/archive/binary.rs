//! The binary tree: little-endian, no lengths per chunk, items before chunks.

use uuid::Uuid;

use super::{Archive, Chunk, Colour, Cursor, DEEPEST, Decimal, Encoding, Item, ItemValue, Limits, Version};
use crate::{Error, Place, Result};

/// The fewest bytes that a chunk takes: an empty name and three numbers.
const SMALLEST_CHUNK: usize = 13;
/// The fewest bytes that an item takes: an empty name, two numbers and one byte of value.
const SMALLEST_ITEM: usize = 10;

struct Reader<'a> {
    at: Cursor<'a>,
    limits: &'a Limits,
    nodes: usize,
    padded_lengths: usize,
}

pub(super) fn read(bytes: &[u8], limits: &Limits) -> Result<Archive> {
    let mut reader = Reader { at: Cursor::new(bytes, Place::Inflated), limits, nodes: 0, padded_lengths: 0 };
    let root = reader.tree()?;
    let mut archive = Archive::new(root, Encoding::Binary);
    if reader.at.remaining() > 0 {
        archive.notes.push(format!("{} bytes after the end of the tree were ignored", reader.at.remaining()));
    }
    if reader.padded_lengths > 0 {
        let n = reader.padded_lengths;
        archive.notes.push(format!("{n} text lengths are longer than they need to be"));
    }
    Ok(archive)
}

impl Reader<'_> {
    /// The tree, walked with a stack of its own: the chunks begun, each with how many more stand inside it.
    fn tree(&mut self) -> Result<Chunk> {
        let mut open: Vec<(Chunk, usize)> = Vec::new();
        open.push(self.chunk()?);
        loop {
            let depth = open.len();
            let Some((_, left)) = open.last_mut() else {
                return Err(self.at.error("there is no root chunk"));
            };
            if *left > 0 {
                *left -= 1;
                if depth >= self.limits.depth() {
                    let limit = self.limits.depth();
                    let (place, offset) = (Place::Inflated, self.at.offset());
                    return Err(Error::Limit {
                        place,
                        offset,
                        what: "the depth of chunks inside chunks",
                        limit,
                    });
                }
                let next = self.chunk()?;
                open.push(next);
            } else if let Some((done, _)) = open.pop() {
                match open.last_mut() {
                    Some((parent, _)) => parent.chunks.push(done),
                    None => return Ok(done),
                }
            }
        }
    }

    /// A chunk's name, index and items, and how many chunks follow inside it.
    fn chunk(&mut self) -> Result<(Chunk, usize)> {
        self.limits.count(&mut self.nodes, Place::Inflated, self.at.offset())?;
        let name = self.text("a chunk's name")?;
        let index = self.index()?;
        let items = self.count("an item count", SMALLEST_ITEM)?;
        let chunks = self.count("a chunk count", SMALLEST_CHUNK)?;
        let mut chunk = Chunk { name, index, items: Vec::new(), chunks: Vec::new() };
        // What the file announces is believed only up to a point: an item here is larger than in the file.
        chunk.items.reserve_exact(items.min(1024));
        chunk.chunks.reserve_exact(chunks.min(1024));
        for _ in 0..items {
            let item = self.item()?;
            chunk.items.push(item);
        }
        Ok((chunk, chunks))
    }

    /// A count of things that each take at least `size` of the bytes that remain.
    fn count(&mut self, what: &str, size: usize) -> Result<usize> {
        let at = self.at.offset();
        let n = self.at.count(what)?;
        let most = self.at.remaining() / size;
        if n > most {
            return Err(Error::at(
                Place::Inflated,
                at,
                format!("{what} of {n} is more than the rest of the data can hold ({most})"),
            ));
        }
        Ok(n)
    }

    fn item(&mut self) -> Result<Item> {
        self.limits.count(&mut self.nodes, Place::Inflated, self.at.offset())?;
        let name = self.text("an item's name")?;
        let index = self.index()?;
        let at = self.at.offset();
        let code = self.at.i32("an item's type")?;
        let value = self.value(code, at)?;
        Ok(Item { name, index, value })
    }

    fn index(&mut self) -> Result<Option<i32>> {
        let index = self.at.i32("an index")?;
        Ok((index != -1).then_some(index))
    }

    fn text(&mut self, what: &str) -> Result<String> {
        let (text, padded) = self.at.text(what)?;
        self.padded_lengths += usize::from(padded);
        Ok(text.to_owned())
    }

    fn bytes(&mut self, what: &str) -> Result<Vec<u8>> {
        let n = self.at.count("a byte count")?;
        Ok(self.at.take(n, what)?.to_vec())
    }

    fn i32s<const N: usize>(&mut self) -> Result<[i32; N]> {
        let mut values = [0; N];
        for value in &mut values {
            *value = self.at.i32("a whole number")?;
        }
        Ok(values)
    }

    fn f32s<const N: usize>(&mut self) -> Result<[f32; N]> {
        let mut values = [0.0; N];
        for value in &mut values {
            *value = f32::from_le_bytes(self.at.array("a number")?);
        }
        Ok(values)
    }

    fn f64(&mut self) -> Result<f64> {
        Ok(f64::from_le_bytes(self.at.array("a number")?))
    }

    fn f64s<const N: usize>(&mut self) -> Result<[f64; N]> {
        let mut values = [0.0; N];
        for value in &mut values {
            *value = self.f64()?;
        }
        Ok(values)
    }

    fn value(&mut self, code: i32, at: usize) -> Result<ItemValue> {
        Ok(match code {
            1 => match self.at.u8("a boolean")? {
                0 => ItemValue::Bool(false),
                1 => ItemValue::Bool(true),
                n => {
                    let at = self.at.offset() - 1;
                    return Err(Error::at(Place::Inflated, at, format!("a boolean is {n}, not 0 or 1")));
                }
            },
            2 => ItemValue::Byte(self.at.u8("a byte")?),
            3 => ItemValue::Int32(self.at.i32("a whole number")?),
            4 => ItemValue::Int64(i64::from_le_bytes(self.at.array("a whole number")?)),
            5 => ItemValue::Single(f32::from_le_bytes(self.at.array("a number")?)),
            6 => ItemValue::Double(self.f64()?),
            7 => {
                let [low, middle, high, flags] = self.i32s()?.map(i32::cast_unsigned);
                ItemValue::Decimal(Decimal { low, middle, high, flags })
            }
            8 => ItemValue::Date(i64::from_le_bytes(self.at.array("a date")?)),
            9 => ItemValue::Guid(Uuid::from_bytes_le(self.at.array("a GUID")?)),
            10 => ItemValue::String(self.text("a text")?),
            20 => ItemValue::ByteArray(self.bytes("a byte array")?),
            21 => {
                let n = self.count("a count of numbers", 8)?;
                ItemValue::DoubleArray((0..n).map(|_| self.f64()).collect::<Result<_>>()?)
            }
            30 => ItemValue::Point(self.i32s()?),
            31 => ItemValue::PointF(self.f32s()?),
            32 => ItemValue::Size(self.i32s()?),
            33 => ItemValue::SizeF(self.f32s()?),
            34 => ItemValue::Rectangle(self.i32s()?),
            35 => ItemValue::RectangleF(self.f32s()?),
            36 => {
                let [b, g, r, a] = self.at.array("a colour")?;
                ItemValue::Colour(Colour { a, r, g, b })
            }
            37 => ItemValue::Bitmap(self.bytes("a bitmap")?),
            50 => ItemValue::Point2d(self.f64s()?),
            51 => ItemValue::Point3d(self.f64s()?),
            52 => ItemValue::Point4d(self.f64s()?),
            60 => ItemValue::Interval1d(self.f64s()?),
            61 => ItemValue::Interval2d(self.f64s()?),
            70 => ItemValue::Line(Box::new(self.f64s()?)),
            71 => ItemValue::BoundingBox(Box::new(self.f64s()?)),
            72 => ItemValue::Plane(Box::new(self.f64s()?)),
            80 => {
                let [major, minor, revision] = self.i32s()?;
                ItemValue::Version(Version { major, minor, revision })
            }
            // Items carry no length, so nothing after an unknown one can be found.
            _ => return Err(Error::at(Place::Inflated, at, format!("{code} is not a known item type"))),
        })
    }
}

pub(super) fn write(root: &Chunk) -> Result<Vec<u8>> {
    let mut out = Vec::new();
    write_chunk(&mut out, root, 1)?;
    Ok(out)
}

fn write_chunk(out: &mut Vec<u8>, chunk: &Chunk, depth: usize) -> Result<()> {
    if depth > DEEPEST {
        return Err(Error::Unwritable(format!("the chunks are nested more than {DEEPEST} deep")));
    }
    write_text(out, &chunk.name)?;
    write_index(out, chunk.index)?;
    write_count(out, chunk.items.len())?;
    write_count(out, chunk.chunks.len())?;
    for item in &chunk.items {
        write_text(out, &item.name)?;
        write_index(out, item.index)?;
        out.extend(item.value.code().to_le_bytes());
        write_value(out, &item.value)?;
    }
    chunk.chunks.iter().try_for_each(|child| write_chunk(out, child, depth + 1))
}

fn write_index(out: &mut Vec<u8>, index: Option<i32>) -> Result<()> {
    if index == Some(-1) {
        return Err(Error::Unwritable("an index of −1 means none".to_owned()));
    }
    out.extend(index.unwrap_or(-1).to_le_bytes());
    Ok(())
}

fn write_count(out: &mut Vec<u8>, n: usize) -> Result<()> {
    let n =
        i32::try_from(n).map_err(|_| Error::Unwritable(format!("a count of {n} needs more than 31 bits")))?;
    out.extend(n.to_le_bytes());
    Ok(())
}

fn write_text(out: &mut Vec<u8>, text: &str) -> Result<()> {
    let mut n = i32::try_from(text.len())
        .map_err(|_| Error::Unwritable(format!("a text of {} bytes needs more than 31 bits", text.len())))?
        .cast_unsigned();
    while n >= 0x80 {
        out.push((n & 0x7f | 0x80).to_le_bytes()[0]);
        n >>= 7;
    }
    out.push(n.to_le_bytes()[0]);
    out.extend_from_slice(text.as_bytes());
    Ok(())
}

fn write_bytes(out: &mut Vec<u8>, bytes: &[u8]) -> Result<()> {
    write_count(out, bytes.len())?;
    out.extend_from_slice(bytes);
    Ok(())
}

fn i32s(out: &mut Vec<u8>, values: &[i32]) {
    values.iter().for_each(|value| out.extend(value.to_le_bytes()));
}

fn f32s(out: &mut Vec<u8>, values: &[f32]) {
    values.iter().for_each(|value| out.extend(value.to_le_bytes()));
}

fn f64s(out: &mut Vec<u8>, values: &[f64]) {
    values.iter().for_each(|value| out.extend(value.to_le_bytes()));
}

fn write_value(out: &mut Vec<u8>, value: &ItemValue) -> Result<()> {
    match value {
        ItemValue::Bool(value) => out.push(u8::from(*value)),
        ItemValue::Byte(value) => out.push(*value),
        ItemValue::Int32(value) => i32s(out, &[*value]),
        ItemValue::Int64(value) | ItemValue::Date(value) => out.extend(value.to_le_bytes()),
        ItemValue::Single(value) => f32s(out, &[*value]),
        ItemValue::Double(value) => f64s(out, &[*value]),
        ItemValue::Decimal(d) => i32s(out, &[d.low, d.middle, d.high, d.flags].map(u32::cast_signed)),
        ItemValue::Guid(guid) => out.extend(guid.to_bytes_le()),
        ItemValue::String(text) => write_text(out, text)?,
        ItemValue::ByteArray(bytes) | ItemValue::Bitmap(bytes) => write_bytes(out, bytes)?,
        ItemValue::DoubleArray(values) => {
            write_count(out, values.len())?;
            f64s(out, values);
        }
        ItemValue::Point(v) | ItemValue::Size(v) => i32s(out, v),
        ItemValue::PointF(v) | ItemValue::SizeF(v) => f32s(out, v),
        ItemValue::Rectangle(v) => i32s(out, v),
        ItemValue::RectangleF(v) => f32s(out, v),
        ItemValue::Colour(c) => out.extend([c.b, c.g, c.r, c.a]),
        ItemValue::Point2d(v) | ItemValue::Interval1d(v) => f64s(out, v),
        ItemValue::Point3d(v) => f64s(out, v),
        ItemValue::Point4d(v) | ItemValue::Interval2d(v) => f64s(out, v),
        ItemValue::Line(v) | ItemValue::BoundingBox(v) => f64s(out, v.as_slice()),
        ItemValue::Plane(v) => f64s(out, v.as_slice()),
        ItemValue::Version(v) => i32s(out, &[v.major, v.minor, v.revision]),
    }
    Ok(())
}
