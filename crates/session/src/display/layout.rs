//! Parts as bytes: the head in JSON, then the arrays.

use katydid_data::Path;
use katydid_elementary::Elementary;
use katydid_geometry::{BoundingBox, Point3};
use uuid::Uuid;

use super::Geometry;
use super::parts::{Group, Parts, Stretch};
use crate::protocol::{
    PREVIEW_MAGIC, PREVIEW_VERSION, Part, PartKind, Piece, PreviewHeader, Slice, SliceType,
};

/// Arrays begin at multiples of this.
const ALIGNMENT: usize = 8;
/// Farther from the origin nothing is drawn: single precision ends soon after.
const FARTHEST: f64 = 1e30;

/// The bytes of an object's geometry; nothing when it shows none. `branches` are those that the origins of its parts
/// count.
pub(crate) fn bytes(object: Uuid, branches: &[Path], parts: Parts, is_draft: bool) -> Option<Geometry> {
    let groups: Vec<Group> = parts.groups.into_iter().filter(|group| !group.points.is_empty()).collect();
    let triangles =
        groups.iter().filter(|group| group.kind == PartKind::Mesh).map(|g| g.indices.len() / 3).sum();
    let bounds = BoundingBox::from_points(groups.iter().flat_map(|group| group.points.iter().copied()))?;
    let origin = origin(&bounds);
    let mut arrays = Arrays { bytes: Vec::new() };
    let mut parts = Vec::with_capacity(groups.len());
    for group in &groups {
        add(group, branches, origin, &mut arrays, &mut parts);
    }
    let header = PreviewHeader {
        object,
        origin: [origin.x, origin.y, origin.z],
        bounds: Some([bounds.min, bounds.max].map(|p| [p.x, p.y, p.z])),
        draft: is_draft,
        parts,
    };
    let bytes = joined(&header, &arrays.bytes)?;
    let hash = blake3::hash(&bytes);
    let hash = hash.to_hex().get(..32)?.to_owned();
    Some(Geometry { hash, bytes, is_draft, triangles })
}

/// The middle of what is shown, rounded, so that it stays where it is while things move a little: to an eighth of the
/// size, by a power of two, which single precision keeps exactly.
fn origin(bounds: &BoundingBox) -> Point3 {
    let size = bounds.diagonal().length();
    let middle = bounds.min.lerp(bounds.max, 0.5);
    if !(size > 0.0 && size.is_finite()) {
        return if middle.is_finite() { middle } else { Point3::ORIGIN };
    }
    let step = (size / 8.0).logarithm_2().ceil().power_of_two();
    let round = |x: f64| Some((x / step).round() * step).filter(|x| x.is_finite()).unwrap_or(0.0);
    Point3::new(round(middle.x), round(middle.y), round(middle.z))
}

/// Adds a group's arrays, and the one or two parts that it is.
fn add(group: &Group, branches: &[Path], origin: Point3, arrays: &mut Arrays, parts: &mut Vec<Part>) {
    let positions = arrays.positions(&group.points, origin);
    let colours = (group.colours.len() == group.points.len()).then(|| arrays.colours(&group.colours));
    let pieces = |stretches: &[Stretch]| pieces(stretches, branches);
    let part = |kind| Part {
        kind,
        colour: group.colour,
        width: group.width,
        positions,
        normals: None,
        colours: None,
        values: None,
        range: None,
        mean: None,
        mean_range: None,
        indices: None,
        texts: Vec::new(),
        text_height: group.text_height,
        pieces: Vec::new(),
    };
    let is_mesh = group.kind == PartKind::Mesh;
    if !is_mesh || !group.indices.is_empty() {
        let values = |list: &[f32]| (list.len() == group.points.len()).then(|| list.to_vec());
        let [gaussian, mean] = [values(&group.gaussian), values(&group.mean)];
        let normals = is_mesh && group.normals.len() == group.points.len();
        let indexed = !matches!(group.kind, PartKind::Points | PartKind::ControlPoints | PartKind::Texts);
        parts.push(Part {
            normals: normals.then(|| arrays.singles(group.normals.as_flattened())),
            colours,
            range: gaussian.as_deref().map(range),
            values: gaussian.map(|list| arrays.singles(&list)),
            mean_range: mean.as_deref().map(range),
            mean: mean.map(|list| arrays.singles(&list)),
            indices: indexed.then(|| arrays.indices(&group.indices, group.points.len())),
            texts: group.texts.clone(),
            pieces: pieces(&group.stretches),
            ..part(group.kind)
        });
    }
    if !group.edges.is_empty() {
        // Edges of a mesh stand on the mesh's own positions.
        parts.push(Part {
            indices: Some(arrays.indices(&group.edges, group.points.len())),
            pieces: pieces(&group.edge_stretches),
            ..part(PartKind::Edges)
        });
    }
}

/// Stretches of one branch that follow each other and take as much each are one piece: of many points, a piece each would
/// be longer than the points.
fn pieces(stretches: &[Stretch], branches: &[Path]) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let mut branch = None;
    for Stretch { origin, start, count } in stretches {
        let [start, count] = [*start, *count].map(|n| u32::try_from(n).unwrap_or(u32::MAX));
        if let Some(last) = pieces.last_mut()
            && branch == Some(origin.branch)
            && (last.output, last.count) == (origin.output, count)
            && last.index.checked_add(last.items) == Some(origin.index)
            && last.count.checked_mul(last.items).and_then(|n| n.checked_add(last.start)) == Some(start)
        {
            last.items += 1;
            continue;
        }
        branch = Some(origin.branch);
        let path = branches.get(origin.branch as usize).map(ToString::to_string).unwrap_or_default();
        pieces.push(Piece { output: origin.output, path, index: origin.index, start, count, items: 1 });
    }
    pieces
}

fn range(values: &[f32]) -> [f64; 2] {
    let ends = values.iter().fold([f32::INFINITY, f32::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)]);
    ends.map(f64::from)
}

/// The arrays one after the other.
struct Arrays {
    bytes: Vec<u8>,
}

impl Arrays {
    fn put<const N: usize>(
        &mut self,
        kind: SliceType,
        count: usize,
        numbers: impl Iterator<Item = [u8; N]>,
    ) -> Slice {
        self.bytes.resize(self.bytes.len().next_multiple_of(ALIGNMENT), 0);
        let offset = self.bytes.len();
        self.bytes.reserve(N * count);
        numbers.for_each(|number| self.bytes.extend_from_slice(&number));
        let small = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        Slice { kind, offset: small(offset), count: small(count) }
    }

    fn positions(&mut self, points: &[Point3], origin: Point3) -> Slice {
        let single = |x: f64| (x.clamp(-FARTHEST, FARTHEST) as f32).to_le_bytes();
        let numbers = points.iter().map(|p| {
            let [x, y, z] = [p.x - origin.x, p.y - origin.y, p.z - origin.z].map(single);
            let mut bytes = [0; 12];
            for (slot, byte) in bytes.iter_mut().zip(x.into_iter().chain(y).chain(z)) {
                *slot = byte;
            }
            bytes
        });
        self.put(SliceType::F32, 3 * points.len(), numbers)
    }

    fn singles(&mut self, numbers: &[f32]) -> Slice {
        self.put(SliceType::F32, numbers.len(), numbers.iter().map(|x| x.to_le_bytes()))
    }

    fn colours(&mut self, colours: &[[u8; 4]]) -> Slice {
        self.put(SliceType::U8, 4 * colours.len(), colours.iter().copied())
    }

    /// Indices into so many points, in as few bytes as they need.
    fn indices(&mut self, indices: &[u32], points: usize) -> Slice {
        if points <= usize::from(u16::MAX) {
            self.put(SliceType::U16, indices.len(), indices.iter().map(|i| (*i as u16).to_le_bytes()))
        } else {
            self.put(SliceType::U32, indices.len(), indices.iter().map(|i| i.to_le_bytes()))
        }
    }
}

fn joined(header: &PreviewHeader, arrays: &[u8]) -> Option<Vec<u8>> {
    let head = serde_json::to_vec(header).ok()?;
    let length = u32::try_from(head.len()).ok()?;
    // Offsets are 32 bits.
    u32::try_from(arrays.len()).ok()?;
    let mut bytes = Vec::with_capacity(12 + head.len() + ALIGNMENT + arrays.len());
    bytes.extend(PREVIEW_MAGIC.to_le_bytes());
    bytes.extend(PREVIEW_VERSION.to_le_bytes());
    bytes.extend(0_u16.to_le_bytes());
    bytes.extend(length.to_le_bytes());
    bytes.extend(head);
    bytes.resize(bytes.len().next_multiple_of(ALIGNMENT), b' ');
    bytes.extend_from_slice(arrays);
    Some(bytes)
}
