use super::{
    PackRectangle, Reference, StoredEdge, StoredFace, StoredPart, StoredVertex, SubDLevel, SubDObject,
};
use crate::chunk::Writer;
use crate::{Error, Result, colour, typecode};

/// The body of the chunk of a symmetry that is none, and of a hash of nothing: version and first byte.
const NO_SYMMETRY: (i32, u8) = (4, 0);
const NO_HASH: (i32, u8) = (1, 1);

/// Writes the body of a SubD.
pub(in crate::object) fn write(subd: &SubDObject, w: &mut Writer) -> Result<()> {
    w.bool(!subd.levels.is_empty());
    if subd.levels.is_empty() {
        return Ok(());
    }
    let newer = w.version().archive >= 70;
    w.versioned(1, if newer { 4 } else { 0 }, |w| {
        w.count(subd.levels.len(), "levels")?;
        let greatest = |ids: fn(&SubDLevel) -> u32| subd.levels.iter().map(ids).max().unwrap_or(0);
        w.u32(greatest(|level| level.vertices.iter().map(|v| v.part.id).max().unwrap_or(0)));
        w.u32(greatest(|level| level.edges.iter().map(|e| e.part.id).max().unwrap_or(0)));
        w.u32(greatest(|level| level.faces.iter().map(|f| f.part.id).max().unwrap_or(0)));
        w.empty_box();
        for level in &subd.levels {
            write_level(level, w)?;
        }
        if newer {
            w.u8(subd.texture_coordinates);
            subd.mapping.write(w)?;
            write_verbatim(subd.symmetry.as_deref(), NO_SYMMETRY, w)?;
            w.bytes(&subd.serial_number.to_le_bytes());
            w.bool(subd.packing.symmetric);
            w.uuid(subd.packing.id);
            w.bool(subd.packing.hashed);
            write_verbatim(subd.packing.hash.as_deref(), NO_HASH, w)?;
        }
        Ok(())
    })
}

/// A chunk whose body is kept as it was, or one that says there is nothing.
fn write_verbatim(body: Option<&[u8]>, (minor, nothing): (i32, u8), w: &mut Writer) -> Result<()> {
    match body {
        Some(body) => w.foreign_chunk(typecode::ANONYMOUS, body),
        None => w.versioned(1, minor, |w| {
            w.u8(nothing);
            Ok(())
        }),
    }
}

fn write_level(level: &SubDLevel, w: &mut Writer) -> Result<()> {
    w.versioned(1, 1, |w| {
        w.u16(level.index);
        w.bytes(&[4, 4, 4]);
        // openNURBS forgets the box of a level when it reads one, and writes this.
        w.empty_box();
        let mut next = 1_u32;
        w.u32(next);
        for count in [level.vertices.len(), level.edges.len(), level.faces.len()] {
            let end = u32::try_from(count).ok().and_then(|count| next.checked_add(count));
            next = end.ok_or_else(|| too_many(count, w))?;
            w.u32(next);
        }
        let mut number = 0;
        for vertex in &level.vertices {
            write_part(&vertex.part, &mut number, w);
            write_vertex(vertex, w)?;
        }
        for edge in &level.edges {
            write_part(&edge.part, &mut number, w);
            write_edge(edge, w)?;
        }
        for face in &level.faces {
            write_part(&face.part, &mut number, w);
            write_face(face, w)?;
        }
        // No mesh.
        w.u8(0);
        Ok(())
    })
}

fn too_many(count: usize, w: &Writer) -> Error {
    Error::CannotWrite {
        what: format!("a SubD with {count} parts in one list"),
        version: w.version().archive,
        why: "the format cannot count so many".into(),
    }
}

/// The number of a part, which counts on from the last, and what all parts have.
fn write_part(part: &StoredPart, number: &mut u32, w: &mut Writer) {
    *number += 1;
    w.u32(*number);
    w.u32(part.id);
    w.u16(part.level);
    if w.version().archive < 70 {
        for numbers in [part.saved_point, part.displacement] {
            w.addition(4, numbers, |w, numbers| numbers.iter().for_each(|x| w.f64(*x)));
        }
        return;
    }
    w.addition(24, part.displacement, |w, numbers| numbers.iter().for_each(|x| w.f64(*x)));
    w.addition(4, Some(part.group).filter(|group| *group > 0), Writer::u32);
    w.addition(5, part.symmetry_next, write_reference);
    w.end_of_additions();
}

fn write_reference(w: &mut Writer, reference: Reference) {
    w.u32(reference.number);
    w.u8(reference.flags);
}

/// How many references follow.
fn short(count: usize, w: &Writer) -> Result<u16> {
    u16::try_from(count).map_err(|_| too_many(count, w))
}

fn write_references(references: &[Reference], w: &mut Writer) -> Result<()> {
    w.u16(short(references.len(), w)?);
    references.iter().for_each(|reference| write_reference(w, *reference));
    Ok(())
}

/// The end of a part that has no additions of its own.
fn end_part(w: &mut Writer) {
    if w.version().archive < 70 {
        w.u8(0);
    } else {
        w.end_of_additions();
    }
}

fn write_vertex(vertex: &StoredVertex, w: &mut Writer) -> Result<()> {
    w.u8(vertex.tag);
    vertex.point.iter().for_each(|x| w.f64(*x));
    w.u16(short(vertex.edges.len(), w)?);
    w.u16(short(vertex.faces.len(), w)?);
    // No points of the limit surface.
    w.u8(0);
    write_references(&vertex.edges, w)?;
    write_references(&vertex.faces, w)?;
    end_part(w);
    Ok(())
}

fn write_edge(edge: &StoredEdge, w: &mut Writer) -> Result<()> {
    w.u8(edge.tag);
    w.u16(short(edge.faces.len(), w)?);
    edge.sector_coefficients.iter().for_each(|x| w.f64(*x));
    w.f64(edge.sharpness[0]);
    write_references(&edge.vertices, w)?;
    write_references(&edge.faces, w)?;
    if w.version().archive >= 80 {
        w.addition(8, Some(edge.sharpness[1]), Writer::f64);
    }
    end_part(w);
    Ok(())
}

fn write_face(face: &StoredFace, w: &mut Writer) -> Result<()> {
    w.u32(face.level_zero_face);
    // The parent, which is no longer kept.
    w.u32(0);
    w.u16(short(face.edges.len(), w)?);
    write_references(&face.edges, w)?;
    if w.version().archive >= 70 {
        write_face_additions(face, w)?;
    }
    end_part(w);
    Ok(())
}

fn write_face_additions(face: &StoredFace, w: &mut Writer) -> Result<()> {
    w.addition(34, face.pack_rectangle, write_pack_rectangle);
    w.addition(4, Some(face.material_channel).filter(|channel| *channel > 0), Writer::i32);
    w.addition(4, face.colour.map(colour::to_archive), Writer::colour);
    w.addition(4, Some(face.pack).filter(|pack| *pack > 0), Writer::u32);
    let count = face.edges.len();
    let has_texture = count > 0 && face.texture_points.len() == count;
    let pieces = u32::try_from(count / 10).map_err(|_| too_many(count, w))?;
    w.addition(4, has_texture.then_some(pieces), Writer::u32);
    if has_texture {
        for piece in face.texture_points.chunks(10) {
            let size = u8::try_from(24 * piece.len()).unwrap_or(240);
            w.addition(size, Some(piece), |w, piece| piece.as_flattened().iter().for_each(|x| w.f64(*x)));
        }
    }
    Ok(())
}

fn write_pack_rectangle(w: &mut Writer, rectangle: PackRectangle) {
    w.u8(rectangle.kind);
    w.u8(rectangle.quarter_turns);
    rectangle.origin.iter().chain(&rectangle.size).for_each(|x| w.f64(*x));
}
