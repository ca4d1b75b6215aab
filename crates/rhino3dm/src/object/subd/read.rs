use super::additions::Additions;
use super::{
    PackRectangle, Reference, StoredEdge, StoredFace, StoredPart, StoredVertex, SubDLevel, SubDObject,
    SubDPacking, WHAT,
};
use crate::chunk::Reader;
use crate::object::MappingTag;
use crate::{Error, Result, colour, typecode};

/// Up to this openNURBS version displacements were stored that mean nothing: 7.0 of 12 June 2019.
const DISPLACEMENTS_FROM: u32 = 0x8000_0000 + ((7 * 128) * 65536 + 19 * 367 + 163) * 4;
/// The least bytes a part takes: number, identifier, level and an end mark.
const LEAST_PART: usize = 11;

/// Reads the body of a SubD.
pub(in crate::object) fn read(body: &mut Reader<'_>) -> Result<SubDObject> {
    let offset = body.offset();
    let mut subd = SubDObject::default();
    match body.u8(WHAT)? {
        0 => return Ok(subd),
        1 => {}
        other => return Err(Error::malformed(offset, WHAT, format!("its first byte is {other}"))),
    }
    let (mut chunk, minor) = body.versioned_1(WHAT)?;
    let level_count = chunk.count(1, WHAT)?;
    // The greatest identifiers, which follow from the parts, and a box that is no longer used.
    chunk.take(12 + 48, WHAT)?;
    for _ in 0..level_count {
        subd.levels.push(read_level(&mut chunk)?);
    }
    if minor >= 1 {
        subd.texture_coordinates = chunk.u8(WHAT)?;
        subd.mapping = MappingTag::read(&mut chunk)?;
    }
    if minor >= 2 {
        subd.symmetry = Some(verbatim(&mut chunk)?);
    }
    if minor >= 3 {
        subd.serial_number = u64::from_le_bytes(chunk.array(WHAT)?);
    }
    if minor >= 4 {
        subd.packing = SubDPacking {
            symmetric: chunk.bool(WHAT)?,
            id: chunk.uuid(WHAT)?,
            hashed: chunk.bool(WHAT)?,
            hash: Some(verbatim(&mut chunk)?),
        };
    }
    chunk.finish();
    Ok(subd)
}

/// The body of an anonymous chunk, with its checksum, as it is. Versions from 60 on lay it out the same way.
fn verbatim(chunk: &mut Reader<'_>) -> Result<Vec<u8>> {
    let inner = chunk.chunk()?;
    if inner.typecode != typecode::ANONYMOUS {
        return Err(Error::malformed(inner.offset, WHAT, "a chunk of another kind stands here"));
    }
    Ok(inner.whole.to_vec())
}

fn read_level(body: &mut Reader<'_>) -> Result<SubDLevel> {
    let (mut chunk, minor) = body.versioned_1("SubD level")?;
    let mut level = SubDLevel { index: chunk.u16(WHAT)?, ..SubDLevel::default() };
    // The kind of subdivision, of which there is one, and the box of the control points, which follows from them.
    chunk.take(3 + 48, WHAT)?;
    let offset = chunk.offset();
    let mut marks = [0; 4];
    for mark in &mut marks {
        *mark = chunk.u32(WHAT)?;
    }
    let [vertices, edges, faces, end] = marks;
    if vertices != 1 || vertices > edges || edges > faces || faces > end {
        return Err(Error::malformed(offset, WHAT, format!("its parts are numbered from {marks:?}")));
    }
    level.vertices = read_parts(&mut chunk, vertices..edges, read_vertex)?;
    level.edges = read_parts(&mut chunk, edges..faces, read_edge)?;
    level.faces = read_parts(&mut chunk, faces..end, read_face)?;
    if minor >= 1 {
        // Whether a mesh follows; none is written.
        chunk.u8(WHAT)?;
    }
    chunk.finish();
    Ok(level)
}

/// Parts whose numbers go on one after another.
fn read_parts<T>(
    chunk: &mut Reader<'_>,
    numbers: std::ops::Range<u32>,
    read: impl Fn(&mut Reader<'_>, StoredPart) -> Result<T>,
) -> Result<Vec<T>> {
    let count = numbers.len();
    chunk.check_count(count, LEAST_PART, WHAT)?;
    let mut parts = Vec::with_capacity(count);
    for number in numbers {
        let offset = chunk.offset();
        let stated = chunk.u32(WHAT)?;
        if stated != number {
            return Err(Error::malformed(offset, WHAT, format!("part {number} calls itself {stated}")));
        }
        let part = read_part(chunk)?;
        parts.push(read(chunk, part)?);
    }
    Ok(parts)
}

fn read_part(body: &mut Reader<'_>) -> Result<StoredPart> {
    let mut part = StoredPart { id: body.u32(WHAT)?, level: body.u16(WHAT)?, ..StoredPart::default() };
    if body.version().archive < 70 {
        part.saved_point = read_marked(body)?;
        part.displacement = read_marked(body)?;
        if body.version().opennurbs <= DISPLACEMENTS_FROM {
            part.displacement = None;
        }
        return Ok(part);
    }
    let mut additions = Additions::of(body);
    if additions.next(body, 24)? {
        part.displacement = Some(triple(body)?);
    }
    if additions.next(body, 4)? {
        part.group = body.u32(WHAT)?;
    }
    if additions.next(body, 5)? {
        part.symmetry_next = Some(read_reference(body)?);
    }
    additions.finish(body)?;
    Ok(part)
}

/// Three numbers behind a mark that is not 0. They count when it is 4.
fn read_marked(body: &mut Reader<'_>) -> Result<Option<[f64; 3]>> {
    let mark = body.u8(WHAT)?;
    let numbers = if mark == 0 { None } else { Some(triple(body)?) };
    Ok(numbers.filter(|_| mark == 4))
}

fn triple(body: &mut Reader<'_>) -> Result<[f64; 3]> {
    Ok([body.f64(WHAT)?, body.f64(WHAT)?, body.f64(WHAT)?])
}

fn pair(body: &mut Reader<'_>) -> Result<[f64; 2]> {
    Ok([body.f64(WHAT)?, body.f64(WHAT)?])
}

fn read_reference(body: &mut Reader<'_>) -> Result<Reference> {
    Ok(Reference { number: body.u32(WHAT)?, flags: body.u8(WHAT)? })
}

fn read_references(body: &mut Reader<'_>) -> Result<Vec<Reference>> {
    let count = usize::from(body.u16(WHAT)?);
    body.check_count(count, 5, WHAT)?;
    (0..count).map(|_| read_reference(body)).collect()
}

fn read_vertex(body: &mut Reader<'_>, part: StoredPart) -> Result<StoredVertex> {
    let tag = body.u8(WHAT)?;
    let point = triple(body)?;
    // The counts of edges and faces, which are stated again with them.
    body.take(4, WHAT)?;
    if body.u8(WHAT)? != 0 {
        // Points of the limit surface, each with two tangents, a normal and a face.
        let count = body.count(12 * 8 + 5, WHAT)?;
        body.take(count.saturating_mul(12 * 8 + 5), WHAT)?;
    }
    let vertex =
        StoredVertex { part, tag, point, edges: read_references(body)?, faces: read_references(body)? };
    end_part(body)?;
    Ok(vertex)
}

/// The end of a part that has no additions of its own.
fn end_part(body: &mut Reader<'_>) -> Result<()> {
    if body.version().archive >= 70 {
        return Additions::of(body).finish(body);
    }
    let offset = body.offset();
    match body.u8(WHAT)? {
        0 => Ok(()),
        other => Err(Error::malformed(offset, WHAT, format!("a part ends with {other}, not 0"))),
    }
}

fn read_edge(body: &mut Reader<'_>, part: StoredPart) -> Result<StoredEdge> {
    let tag = body.u8(WHAT)?;
    // The count of faces, which is stated again with them.
    body.take(2, WHAT)?;
    let sector_coefficients = pair(body)?;
    let sharpness = body.f64(WHAT)?;
    let ends = read_references(body)?;
    let end = |i: usize| ends.get(i).copied().unwrap_or_default();
    let mut edge = StoredEdge {
        part,
        tag,
        sector_coefficients,
        sharpness: [sharpness; 2],
        vertices: [end(0), end(1)],
        faces: read_references(body)?,
    };
    if body.version().archive < 80 {
        end_part(body)?;
        return Ok(edge);
    }
    let mut additions = Additions::of(body);
    if additions.next(body, 8)? {
        edge.sharpness[1] = body.f64(WHAT)?;
    }
    additions.finish(body)?;
    Ok(edge)
}

fn read_face(body: &mut Reader<'_>, part: StoredPart) -> Result<StoredFace> {
    let mut face = StoredFace { part, level_zero_face: body.u32(WHAT)?, ..StoredFace::default() };
    // The parent, which is no longer kept, and the count of edges, which is stated again with them.
    body.take(4 + 2, WHAT)?;
    face.edges = read_references(body)?;
    if body.version().archive < 70 {
        end_part(body)?;
        return Ok(face);
    }
    let mut additions = Additions::of(body);
    if additions.next(body, 34)? {
        face.pack_rectangle = Some(PackRectangle {
            kind: body.u8(WHAT)?,
            quarter_turns: body.u8(WHAT)?,
            origin: pair(body)?,
            size: pair(body)?,
        });
    }
    if additions.next(body, 4)? {
        face.material_channel = body.i32(WHAT)?;
    }
    if additions.next(body, 4)? {
        face.colour = Some(colour::from_archive(body.colour(WHAT)?));
    }
    if additions.next(body, 4)? {
        face.pack = body.u32(WHAT)?;
    }
    if additions.next(body, 4)? {
        face.texture_points = read_texture_points(body, &mut additions, face.edges.len())?;
    }
    additions.finish(body)?;
    Ok(face)
}

/// A point an edge, in pieces of ten.
fn read_texture_points(
    body: &mut Reader<'_>,
    additions: &mut Additions,
    count: usize,
) -> Result<Vec<[f64; 3]>> {
    let offset = body.offset();
    let pieces = body.u32(WHAT)?;
    if u64::from(pieces) != (count / 10) as u64 {
        let why = format!("{pieces} pieces of texture points for {count} edges");
        return Err(Error::malformed(offset, WHAT, why));
    }
    let mut points = Vec::with_capacity(count);
    while points.len() < count {
        let piece = (count - points.len()).min(10);
        let size = u8::try_from(24 * piece).unwrap_or(240);
        if !additions.next(body, size)? {
            return Err(Error::malformed(body.offset(), WHAT, "texture points are missing"));
        }
        for _ in 0..piece {
            points.push(triple(body)?);
        }
    }
    Ok(points)
}
