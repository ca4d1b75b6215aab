//! Writes every solid of models and definitions as a STEP file of its own: `write_steps FOLDER PATH…`
//!
//! For another kernel to judge: a line a solid, with tabs between the file's name, where the solid comes from, its
//! volume, how much of it the gaps between its trims and edges leave open, each face's share (from the origin), and the
//! volume with those gaps closed: faces, and ruled strips between trims and edges.

#![allow(clippy::print_stdout, reason = "an example speaks")]

use std::path::{Path, PathBuf};

use katydid_3dm::{Limits, Model, Object, RawObject};
use katydid_definition::archive::{self, Chunk};
use katydid_definition::document::OnData;
use katydid_geometry::{Brep, Curve, Point3};
use katydid_step::{Document, Part, Shape};

/// Places along a trim at which its distance from the edge is looked at.
const PLACES: u32 = 64;
/// Strips between each two knots of a trim.
const STRIPS: u32 = 64;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or("usage: write_steps FOLDER PATH…")?);
    let mut count = 0;
    for path in arguments.map(PathBuf::from) {
        let bytes = std::fs::read(&path)?;
        let (breps, tolerance) = match path.extension().and_then(|e| e.to_str()) {
            Some("3dm") => stored(&bytes),
            _ => (internalised(&bytes), 1e-3),
        };
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        for (place, brep) in breps.iter().enumerate().filter(|(_, brep)| brep.is_solid()) {
            let file = format!("{count:04}.step");
            count += 1;
            let line = told(brep, tolerance, &folder.join(&file))?;
            println!("{file}\t{name} {place}\t{line}");
        }
    }
    Ok(())
}

/// The breps of a model and its tolerance.
fn stored(bytes: &[u8]) -> (Vec<Brep>, f64) {
    let Ok(model) = Model::read(bytes, &Limits::default()) else { return (Vec::new(), 1e-3) };
    let breps = model.objects.iter().filter_map(|object| brep(&object.geometry)).collect();
    (breps, model.tolerance.absolute)
}

fn brep(object: &Object) -> Option<Brep> {
    match object {
        Object::Brep(object) => Some(object.brep.clone()),
        Object::Extrusion(object) => object.to_brep().map(|object| object.brep),
        other => Brep::from_surface(other.surface()?.into_owned()).ok(),
    }
}

/// The breps that a definition carries, each once.
fn internalised(bytes: &[u8]) -> Vec<Brep> {
    let mut found = Vec::new();
    if let Ok(archive) = archive::read(bytes, &archive::Limits::default()) {
        collect(&archive.root, &mut found);
    }
    found.dedup();
    found
}

fn collect(chunk: &Chunk, found: &mut Vec<Brep>) {
    for item in chunk.items.iter().filter(|item| item.name == "ON_Data") {
        let Some(bytes) = item.value.as_bytes() else { continue };
        let Ok(data) = OnData::read(bytes, &archive::Limits::default()) else { continue };
        let version = data.opennurbs.cast_unsigned();
        let limits = Limits::default();
        let Ok((raw, _)) = RawObject::read(data.archive3dm, version, &data.data, &limits) else { continue };
        found.extend(raw.parse(&limits).ok().as_ref().and_then(brep));
    }
    chunk.chunks.iter().for_each(|chunk| collect(chunk, found));
}

/// Writes a solid; what there is to say of it.
fn told(brep: &Brep, tolerance: f64, path: &Path) -> Result<String, Box<dyn std::error::Error>> {
    let mut document = Document { tolerance, ..Document::default() };
    document.parts.push(Part::named("solid", Shape::Brep(brep.clone().into())));
    let left_out = katydid_step::write(&document, &mut std::fs::File::create(path)?)?;
    if let Some(first) = left_out.first() {
        return Ok(format!("left out: {}", first.why));
    }
    let volume = match brep.volume_properties(1e-11, || true) {
        Ok(found) => found.amount,
        Err(error) => return Ok(format!("no volume: {error}")),
    };
    let faces = (0..brep.faces().len()).map(|face| brep.face_volume(face, Point3::ORIGIN, 1e-11));
    let faces: Vec<String> = faces.map(|v| v.map_or("?".into(), |v| format!("{v:.12e}"))).collect();
    let closed = closed(brep).map_or("?".into(), |v| format!("{v:.12e}"));
    Ok(format!("{volume:.12e}\t{:.3e}\t{}\t{closed}", open(brep), faces.join(" ")))
}

/// The volume inside the faces and the strips that join each trim to its edge: that of a shell without gaps, which is
/// the same seen from anywhere. Where edges lie on their faces better than trims do, it is the solid's to the square of
/// the gaps.
fn closed(brep: &Brep) -> Option<f64> {
    let centre = brep.bounds_of_faces()?.center();
    let mut volume = 0.0;
    for (place, face) in brep.faces().iter().enumerate().filter(|(_, face)| !face.deleted) {
        let sign = if face.reversed { -1.0 } else { 1.0 };
        let trims = face.loops.iter().filter_map(|l| brep.loops().get(*l)).flat_map(|l| &l.trims);
        let strips: f64 = trims.filter_map(|trim| strip_share(brep, place, *trim, centre)).sum();
        volume += brep.face_volume(place, centre, 1e-11).ok()? + sign * strips;
    }
    Some(volume.abs())
}

/// The share of the strip from a trim to its edge in the volume seen from a point.
fn strip_share(brep: &Brep, face: usize, place: usize, from: Point3) -> Option<f64> {
    let trim = brep.trims().get(place)?;
    let edge: Curve = brep.edge_as_curve(trim.edge?).ok()??;
    let edge = if trim.reversed { edge.reversed() } else { edge };
    let surface = brep.face_surface(face)?;
    let flat = brep.trim_as_curve(place).ok()??.to_nurbs().ok()?;
    let mut places: Vec<f64> = Vec::new();
    for window in flat.span_parameters().windows(2) {
        let step = (window[1] - window[0]) / f64::from(STRIPS);
        places.extend((0..STRIPS).map(|k| window[0] + step * f64::from(k)));
    }
    places.push(flat.domain().end);
    let last = places.len().checked_sub(1)?;
    let pair = |k: usize| {
        let uv = flat.point_at(*places.get(k)?);
        let image = surface.point_at(uv.x, uv.y);
        let beside = match k {
            0 => edge.start(),
            k if k == last => edge.end(),
            _ => edge.point_at(edge.closest_point(image).ok()?.parameter),
        };
        Some((image - from, beside - from))
    };
    let mut sum = 0.0;
    let (mut a, mut b) = pair(0)?;
    for k in 1..=last {
        let (c, d) = pair(k)?;
        sum += c.dot(a.cross(b)) + c.dot(b.cross(d));
        (a, b) = (c, d);
    }
    Some(sum / 6.0)
}

/// A bound of the volume that lies between the faces and the edges, seen from the middle of the solid: a third of its
/// half diagonal, times the strips between trims and edges.
fn open(brep: &Brep) -> f64 {
    let size = brep.bounds_of_faces().map_or(0.0, |bounds| bounds.diagonal().length());
    let strips: f64 = (0..brep.trims().len()).filter_map(|trim| strip(brep, trim)).sum();
    strips * 0.5 * size / 3.0
}

/// The area between a trim and its edge.
fn strip(brep: &Brep, place: usize) -> Option<f64> {
    let trim = brep.trims().get(place)?;
    let edge: Curve = brep.edge_as_curve(trim.edge?).ok()??;
    let surface = brep.face_surface(brep.loops().get(trim.in_loop?)?.face?)?;
    let flat = brep.trim_as_curve(place).ok()??;
    let domain = flat.domain();
    let image = |k: u32| {
        let uv = flat.point_at(domain.at(f64::from(k) / f64::from(PLACES)));
        surface.point_at(uv.x, uv.y)
    };
    let gap = |p: Point3| edge.closest_point(p).map(|found| found.distance).ok();
    let mut area = 0.0;
    for k in 0..PLACES {
        let (a, b) = (image(k), image(k + 1));
        area += 0.5 * (gap(a)? + gap(b)?) * a.distance_to(b);
    }
    Some(area)
}
