//! A reader of previews of its own, from the words of the layout.

#![allow(dead_code, reason = "each test uses a part")]

use katydid_geometry::Point3;
use katydid_session::display::Geometry;
use katydid_session::protocol::{
    PREVIEW_MAGIC, PREVIEW_VERSION, Part, PartKind, PreviewHeader, Slice, SliceType,
};

/// A preview taken apart.
pub(crate) struct Read {
    pub(crate) header: PreviewHeader,
    pub(crate) arrays: Vec<u8>,
}

impl Read {
    pub(crate) fn new(geometry: &Geometry) -> Self {
        let bytes = &geometry.bytes;
        let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
        assert_eq!(number(0), PREVIEW_MAGIC);
        assert_eq!(number(4), u32::from(PREVIEW_VERSION));
        let length = number(8) as usize;
        let header: PreviewHeader = serde_json::from_slice(&bytes[12..12 + length]).unwrap();
        let start = (12 + length).next_multiple_of(8);
        assert!(bytes[12 + length..start].iter().all(|byte| *byte == b' '));
        Self { header, arrays: bytes[start..].to_vec() }
    }

    pub(crate) fn part(&self, kind: PartKind) -> &Part {
        let mut parts = self.header.parts.iter().filter(|part| part.kind == kind);
        let part = parts.next().unwrap_or_else(|| panic!("no {kind:?}"));
        assert!(parts.next().is_none(), "several of {kind:?}");
        part
    }

    pub(crate) fn bytes(&self, slice: &Slice, size: usize) -> Vec<&[u8]> {
        assert_eq!(slice.offset % 8, 0);
        let start = slice.offset as usize;
        self.arrays[start..start + size * slice.count as usize].chunks(size).collect()
    }

    pub(crate) fn singles(&self, slice: &Slice) -> Vec<f32> {
        assert_eq!(slice.kind, SliceType::F32);
        self.bytes(slice, 4).iter().map(|b| f32::from_le_bytes((*b).try_into().unwrap())).collect()
    }

    pub(crate) fn colours(&self, part: &Part) -> Vec<[u8; 4]> {
        let bytes = self.bytes(part.colours.as_ref().unwrap(), 1).concat();
        bytes.chunks(4).map(|colour| colour.try_into().unwrap()).collect()
    }

    pub(crate) fn points(&self, part: &Part) -> Vec<Point3> {
        let o = self.header.origin;
        let point =
            |p: &[f32]| Point3::new(o[0] + f64::from(p[0]), o[1] + f64::from(p[1]), o[2] + f64::from(p[2]));
        self.singles(&part.positions).chunks(3).map(point).collect()
    }

    pub(crate) fn indices(&self, part: &Part) -> Vec<usize> {
        let slice = part.indices.as_ref().unwrap();
        match slice.kind {
            SliceType::U16 => self
                .bytes(slice, 2)
                .iter()
                .map(|b| usize::from(u16::from_le_bytes((*b).try_into().unwrap())))
                .collect(),
            SliceType::U32 => self
                .bytes(slice, 4)
                .iter()
                .map(|b| u32::from_le_bytes((*b).try_into().unwrap()) as usize)
                .collect(),
            other => panic!("{other:?}"),
        }
    }

    /// The segments or triangles of a part.
    pub(crate) fn drawn(&self, part: &Part, corners: usize) -> Vec<Vec<Point3>> {
        let points = self.points(part);
        self.indices(part).chunks(corners).map(|of| of.iter().map(|i| points[*i]).collect()).collect()
    }

    pub(crate) fn length(&self, part: &Part) -> f64 {
        self.drawn(part, 2).iter().map(|line| line[0].distance_to(line[1])).sum()
    }

    pub(crate) fn area(&self, part: &Part) -> f64 {
        self.drawn(part, 3).iter().map(|t| (t[1] - t[0]).cross(t[2] - t[0]).length() / 2.0).sum()
    }
}
