//! Vertices, edges, trims, loops and faces.

use std::num::NonZeroU128;

use katydid_geometry::Side;
use katydid_geometry::brep::{CurvePart, Edge, Face, Iso, Loop, LoopKind, Trim, TrimKind, Vertex};
use uuid::Uuid;

use super::lists::{read_list, write_list};
use crate::chunk::{Reader, Writer};
use crate::version::Version;
use crate::{Error, Result, colour};

/// Files written by an older openNURBS store no domain of edges and trims.
const DOMAIN_FROM: u32 = 200_206_180;
/// A colour that is not set.
const NO_COLOUR: [u8; 4] = [0xFF; 4];

fn has_domain(version: Version) -> bool {
    version.archive >= 3 && version.opennurbs >= DOMAIN_FROM
}

/// A place in a list; negative numbers are none.
fn read_place(list: &mut Reader<'_>, what: &'static str) -> Result<Option<usize>> {
    Ok(usize::try_from(list.i32(what)?).ok())
}

fn read_places(list: &mut Reader<'_>, what: &'static str) -> Result<Vec<usize>> {
    let offset = list.offset();
    let place =
        |i: i32| usize::try_from(i).map_err(|_| Error::malformed(offset, what, format!("{i} is no place")));
    list.ints(what)?.into_iter().map(place).collect()
}

/// An item begins with its own place, or −1 when it is deleted.
fn read_deleted(list: &mut Reader<'_>, place: usize, what: &'static str) -> Result<bool> {
    let offset = list.offset();
    let own = list.i32(what)?;
    if own != -1 && usize::try_from(own).ok() != Some(place) {
        list.context().warn(offset, format!("{what} {place} calls itself {own}"));
    }
    Ok(own == -1)
}

fn write_place(place: Option<usize>, w: &mut Writer) -> Result<()> {
    match place {
        Some(place) => w.count(place, "parts of a brep"),
        None => {
            w.i32(-1);
            Ok(())
        }
    }
}

fn write_places(places: &[usize], w: &mut Writer) -> Result<()> {
    w.count(places.len(), "parts of a brep")?;
    places.iter().try_for_each(|place| write_place(Some(*place), w))
}

fn write_own(place: usize, deleted: bool, w: &mut Writer) -> Result<()> {
    write_place((!deleted).then_some(place), w)
}

pub(super) fn read_vertices(body: &mut Reader<'_>) -> Result<Vec<Vertex>> {
    const WHAT: &str = "brep vertex";
    let (mut list, _, count) = read_list(body, 40, WHAT)?;
    let mut vertices = Vec::with_capacity(count);
    for place in 0..count {
        vertices.push(Vertex {
            deleted: read_deleted(&mut list, place, WHAT)?,
            point: list.point(WHAT)?,
            edges: read_places(&mut list, WHAT)?,
            tolerance: list.f64(WHAT)?,
        });
    }
    list.finish();
    Ok(vertices)
}

pub(super) fn write_vertices(vertices: &[Vertex], w: &mut Writer) -> Result<()> {
    write_list(0, vertices.len(), w, |w| {
        for (place, vertex) in vertices.iter().enumerate() {
            write_own(place, vertex.deleted, w)?;
            w.point(vertex.point);
            write_places(&vertex.edges, w)?;
            w.f64(vertex.tolerance);
        }
        Ok(())
    })
}

pub(super) fn read_edges(body: &mut Reader<'_>) -> Result<Vec<Edge>> {
    const WHAT: &str = "brep edge";
    let (mut list, _, count) = read_list(body, 48, WHAT)?;
    let has_domain = has_domain(list.version());
    let mut edges = Vec::with_capacity(count);
    for place in 0..count {
        let deleted = read_deleted(&mut list, place, WHAT)?;
        let curve = read_place(&mut list, WHAT)?;
        let reversed = list.i32(WHAT)? != 0;
        let range = list.interval(WHAT)?;
        let vertices = [read_place(&mut list, WHAT)?, read_place(&mut list, WHAT)?];
        let trims = read_places(&mut list, WHAT)?;
        let tolerance = list.f64(WHAT)?;
        let domain = if has_domain { list.interval(WHAT)? } else { range };
        let part = CurvePart { curve, range, reversed, domain };
        edges.push(Edge { part, vertices, trims, tolerance, deleted });
    }
    list.finish();
    Ok(edges)
}

pub(super) fn write_edges(edges: &[Edge], w: &mut Writer) -> Result<()> {
    write_list(0, edges.len(), w, |w| {
        for (place, edge) in edges.iter().enumerate() {
            write_own(place, edge.deleted, w)?;
            write_place(edge.part.curve, w)?;
            w.i32(i32::from(edge.part.reversed));
            w.interval(edge.part.range);
            edge.vertices.iter().try_for_each(|vertex| write_place(*vertex, w))?;
            write_places(&edge.trims, w)?;
            w.f64(edge.tolerance);
            w.interval(edge.part.domain);
        }
        Ok(())
    })
}

pub(super) fn read_trims(body: &mut Reader<'_>) -> Result<Vec<Trim>> {
    const WHAT: &str = "brep trim";
    let (mut list, _, count) = read_list(body, 132, WHAT)?;
    let has_domain = has_domain(list.version());
    let mut trims = Vec::with_capacity(count);
    for place in 0..count {
        // openNURBS does not take a trim for deleted.
        read_deleted(&mut list, place, WHAT)?;
        trims.push(read_trim(&mut list, has_domain)?);
    }
    list.finish();
    Ok(trims)
}

/// A trim behind its own place.
pub(crate) fn read_trim(list: &mut Reader<'_>, has_domain: bool) -> Result<Trim> {
    const WHAT: &str = "brep trim";
    let curve = read_place(list, WHAT)?;
    let range = list.interval(WHAT)?;
    let edge = read_place(list, WHAT)?;
    let vertices = [read_place(list, WHAT)?, read_place(list, WHAT)?];
    let reversed = list.i32(WHAT)? != 0;
    let kind = trim_kind(list.i32(WHAT)?);
    let iso = iso(list.i32(WHAT)?);
    let in_loop = read_place(list, WHAT)?;
    let tolerance = [list.f64(WHAT)?, list.f64(WHAT)?];
    let mut part = CurvePart { curve, range, reversed: false, domain: range };
    if has_domain {
        part.domain = list.interval(WHAT)?;
        part.reversed = list.take(32, WHAT)?.first() == Some(&1);
    } else {
        // Points at its ends.
        list.take(48, WHAT)?;
    }
    let older_tolerances = [list.f64(WHAT)?, list.f64(WHAT)?];
    Ok(Trim {
        part,
        edge,
        reversed,
        vertices,
        kind,
        iso,
        in_loop,
        tolerance,
        older_tolerances,
        deleted: false,
    })
}

pub(super) fn write_trims(trims: &[Trim], w: &mut Writer) -> Result<()> {
    write_list(0, trims.len(), w, |w| {
        for (place, trim) in trims.iter().enumerate() {
            write_own(place, trim.deleted, w)?;
            write_place(trim.part.curve, w)?;
            w.interval(trim.part.range);
            write_place(trim.edge, w)?;
            trim.vertices.iter().try_for_each(|vertex| write_place(*vertex, w))?;
            w.i32(i32::from(trim.reversed));
            w.i32(trim_kind_number(trim.kind));
            w.i32(iso_number(trim.iso));
            write_place(trim.in_loop, w)?;
            trim.tolerance.iter().for_each(|t| w.f64(*t));
            w.interval(trim.part.domain);
            w.u8(u8::from(trim.part.reversed));
            w.bytes(&[0; 31]);
            trim.older_tolerances.iter().for_each(|t| w.f64(*t));
        }
        Ok(())
    })
}

fn trim_kind(number: i32) -> TrimKind {
    match number {
        1 => TrimKind::Boundary,
        2 => TrimKind::Mated,
        3 => TrimKind::Seam,
        4 => TrimKind::Singular,
        _ => TrimKind::Unknown,
    }
}

fn trim_kind_number(kind: TrimKind) -> i32 {
    match kind {
        TrimKind::Unknown => 0,
        TrimKind::Boundary => 1,
        TrimKind::Mated => 2,
        TrimKind::Seam => 3,
        TrimKind::Singular => 4,
    }
}

fn iso(number: i32) -> Iso {
    match number {
        1 => Iso::InnerU,
        2 => Iso::InnerV,
        3 => Iso::Side(Side::West),
        4 => Iso::Side(Side::South),
        5 => Iso::Side(Side::East),
        6 => Iso::Side(Side::North),
        _ => Iso::None,
    }
}

fn iso_number(iso: Iso) -> i32 {
    match iso {
        Iso::None => 0,
        Iso::InnerU => 1,
        Iso::InnerV => 2,
        Iso::Side(Side::West) => 3,
        Iso::Side(Side::South) => 4,
        Iso::Side(Side::East) => 5,
        Iso::Side(Side::North) => 6,
    }
}

pub(super) fn read_loops(body: &mut Reader<'_>) -> Result<Vec<Loop>> {
    const WHAT: &str = "brep loop";
    let (mut list, _, count) = read_list(body, 16, WHAT)?;
    let mut loops = Vec::with_capacity(count);
    for place in 0..count {
        let deleted = read_deleted(&mut list, place, WHAT)?;
        let trims = read_places(&mut list, WHAT)?;
        let kind = match list.i32(WHAT)? {
            1 => LoopKind::Outer,
            2 => LoopKind::Inner,
            3 => LoopKind::Slit,
            _ => LoopKind::Unknown,
        };
        loops.push(Loop { trims, kind, face: read_place(&mut list, WHAT)?, deleted });
    }
    list.finish();
    Ok(loops)
}

pub(super) fn write_loops(loops: &[Loop], w: &mut Writer) -> Result<()> {
    write_list(0, loops.len(), w, |w| {
        for (place, chain) in loops.iter().enumerate() {
            write_own(place, chain.deleted, w)?;
            write_places(&chain.trims, w)?;
            w.i32(match chain.kind {
                LoopKind::Unknown => 0,
                LoopKind::Outer => 1,
                LoopKind::Inner => 2,
                LoopKind::Slit => 3,
            });
            write_place(chain.face, w)?;
        }
        Ok(())
    })
}

pub(super) fn read_faces(body: &mut Reader<'_>) -> Result<Vec<Face>> {
    const WHAT: &str = "brep face";
    let (mut list, minor, count) = read_list(body, 20, WHAT)?;
    let mut faces = Vec::with_capacity(count);
    for place in 0..count {
        faces.push(Face {
            deleted: read_deleted(&mut list, place, WHAT)?,
            loops: read_places(&mut list, WHAT)?,
            surface: read_place(&mut list, WHAT)?,
            reversed: list.i32(WHAT)? != 0,
            material_channel: u32::try_from(list.i32(WHAT)?).unwrap_or(0),
            id: None,
            colour: None,
        });
    }
    if minor >= 1 {
        for face in &mut faces {
            face.id = NonZeroU128::new(list.uuid(WHAT)?.as_u128());
        }
    }
    if minor >= 2 && list.bool(WHAT)? {
        for face in &mut faces {
            let stored = Some(list.colour(WHAT)?).filter(|colour| *colour != NO_COLOUR);
            face.colour = stored.map(colour::from_archive);
        }
    }
    list.finish();
    Ok(faces)
}

pub(super) fn write_faces(faces: &[Face], w: &mut Writer) -> Result<()> {
    let has_colours = w.version().archive >= 70;
    write_list(if has_colours { 2 } else { 1 }, faces.len(), w, |w| {
        for (place, face) in faces.iter().enumerate() {
            write_own(place, face.deleted, w)?;
            write_places(&face.loops, w)?;
            write_place(face.surface, w)?;
            w.i32(i32::from(face.reversed));
            w.i32(i32::try_from(face.material_channel).unwrap_or(i32::MAX));
        }
        for face in faces {
            w.uuid(face.id.map_or(Uuid::nil(), |id| Uuid::from_u128(id.get())));
        }
        if has_colours {
            let any = faces.iter().any(|face| face.colour.is_some());
            w.bool(any);
            let stored = |face: &Face| face.colour.map_or(NO_COLOUR, colour::to_archive);
            let colours = faces.iter().filter(|_| any).map(stored);
            colours.for_each(|colour| w.colour(colour));
        }
        Ok(())
    })
}
