//! Numbers out of buffers, every place checked against the bytes that are there.

use super::file::{Accessor, File, SparsePart, malformed};
use crate::Result;

/// Rows that stand nowhere in the file, all zero: more of them than this are refused.
const MOST_ZEROS: usize = 1 << 22;

impl File<'_> {
    /// The rows of an accessor with so many numbers each; shares where its numbers are normalised.
    pub(super) fn rows<const N: usize>(&self, accessor: usize) -> Result<Vec<[f64; N]>> {
        let (accessor, place) = self.accessor(accessor)?;
        let width = match accessor.r#type.as_str() {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            other => return Err(malformed(place, format!("{} is not expected", other.escape_debug()))),
        };
        let number = Number::of(accessor.component_type)
            .ok_or_else(|| malformed(place.clone(), "its numbers are of no type that is known"))?;
        let mut rows = match accessor.buffer_view {
            Some(view) => {
                let size = width * number.size();
                let (bytes, stride) = self.view(view, accessor.byte_offset, &place)?;
                let stride = stride.unwrap_or(size).max(1);
                let needed = accessor
                    .count
                    .checked_sub(1)
                    .map_or(Some(0), |n| n.checked_mul(stride)?.checked_add(size));
                if needed.is_none_or(|needed| needed > bytes.len()) {
                    return Err(malformed(
                        place,
                        format!("{} rows do not fit into its buffer", accessor.count),
                    ));
                }
                let rows = (0..accessor.count).map(|i| bytes.get(i * stride..).unwrap_or_default());
                rows.map(|row| number.row(row, width, accessor.normalized)).collect()
            }
            None if accessor.count <= MOST_ZEROS => vec![[0.0; N]; accessor.count],
            None => return Err(malformed(place, "it has no numbers")),
        };
        if let Some(sparse) = &accessor.sparse {
            let indices = Number::of(sparse.indices.component_type)
                .ok_or_else(|| malformed(place.clone(), "its indices are of no type that is known"))?;
            let numbers = self.part(&sparse.indices, sparse.count, indices.size(), &place)?;
            let values = self.part(&sparse.values, sparse.count, width * number.size(), &place)?;
            let values = values.chunks_exact(width * number.size());
            for (index, value) in numbers.chunks_exact(indices.size()).zip(values) {
                let row = rows.get_mut(indices.one(index) as usize);
                *row.ok_or_else(|| malformed(place.clone(), "an index beyond its rows"))? =
                    number.row(value, width, accessor.normalized);
            }
        }
        Ok(rows)
    }

    /// The indices of a primitive.
    pub(super) fn indices(&self, accessor: usize) -> Result<Vec<u32>> {
        let rows = self.rows::<1>(accessor)?;
        Ok(rows.into_iter().map(|[index]| index as u32).collect())
    }

    fn accessor(&self, index: usize) -> Result<(&Accessor, String)> {
        let place = format!("accessor {index}");
        let accessor =
            self.json.accessors.get(index).ok_or_else(|| malformed(place.clone(), "it is not there"))?;
        Ok((accessor, place))
    }

    /// The bytes of a view from an offset on, and its stride.
    fn view(&self, index: usize, offset: usize, place: &str) -> Result<(&[u8], Option<usize>)> {
        let found = self.json.buffer_views.get(index).and_then(|view| {
            let buffer = self.buffers.get(view.buffer)?;
            let end = view.byte_offset.checked_add(view.byte_length)?;
            Some((buffer.get(view.byte_offset..end)?.get(offset..)?, view.byte_stride))
        });
        found.ok_or_else(|| malformed(place, self.beyond(index)))
    }

    /// Why the bytes of a view are not there, with the buffer where they should be.
    fn beyond(&self, view: usize) -> String {
        let buffer = self.json.buffer_views.get(view).map(|view| view.buffer);
        let known = buffer.and_then(|place| Some((place, self.json.buffers.get(place)?)));
        match (known, buffer) {
            (Some((place, buffer)), _) => format!("its bytes are beyond the end of {}", buffer.title(place)),
            (None, Some(place)) => format!("its bytes are in buffer {place}, which is not there"),
            (None, None) => format!("its bytes are in view {view}, which is not there"),
        }
    }

    fn part(&self, part: &SparsePart, count: usize, size: usize, place: &str) -> Result<&[u8]> {
        let (bytes, _) = self.view(part.buffer_view, part.byte_offset, place)?;
        let needed = count.checked_mul(size).and_then(|needed| bytes.get(..needed));
        needed.ok_or_else(|| malformed(place, self.beyond(part.buffer_view)))
    }
}

/// The type of a number in a buffer.
#[derive(Debug, Clone, Copy)]
enum Number {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Number {
    fn of(component_type: u32) -> Option<Self> {
        Some(match component_type {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return None,
        })
    }

    const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// What a share of 1 is stored as.
    const fn whole(self) -> f64 {
        match self {
            Self::I8 => 127.0,
            Self::U8 => 255.0,
            Self::I16 => 32767.0,
            Self::U16 => 65535.0,
            Self::U32 | Self::F32 => 1.0,
        }
    }

    /// The number that some bytes begin with; 0 when there are too few.
    fn one(self, bytes: &[u8]) -> f64 {
        let number = match self {
            Self::I8 => bytes.first_chunk().map(|b| i8::from_le_bytes(*b).into()),
            Self::U8 => bytes.first_chunk().map(|b| u8::from_le_bytes(*b).into()),
            Self::I16 => bytes.first_chunk().map(|b| i16::from_le_bytes(*b).into()),
            Self::U16 => bytes.first_chunk().map(|b| u16::from_le_bytes(*b).into()),
            Self::U32 => bytes.first_chunk().map(|b| u32::from_le_bytes(*b).into()),
            Self::F32 => bytes.first_chunk().map(|b| f32::from_le_bytes(*b).into()),
        };
        number.unwrap_or(0.0)
    }

    fn row<const N: usize>(self, bytes: &[u8], width: usize, normalized: bool) -> [f64; N] {
        let mut row = [0.0; N];
        let whole = if normalized { self.whole() } else { 1.0 };
        let places = bytes.chunks_exact(self.size());
        for (x, place) in row.iter_mut().take(width).zip(places) {
            *x = (self.one(place) / whole).max(if normalized { -1.0 } else { f64::NEG_INFINITY });
        }
        row
    }
}
