//! Writes every solid of models and definitions as a STEP file of its own: `write_steps FOLDER PATH…`
//!
//! For another kernel to judge: a line a solid, with tabs between the file's name, where the solid comes from, its
//! volume, how much of it the gaps between its trims and edges leave open, and each face's share as seen from the origin
//! with what it changes by along x, y and z: another kernel may look from elsewhere.

#![allow(clippy::print_stdout, reason = "an example speaks")]

use std::path::{Path, PathBuf};

use katydid_3dm::{Limits, Model, Object, RawObject};
use katydid_definition::archive::{self, Chunk};
use katydid_definition::document::OnData;
use katydid_geometry::{Brep, Curve, Point3, Vector3};
use katydid_step::{Document, Part, Shape};

/// Places along a trim at which its distance from the edge is looked at.
const PLACES: u32 = 64;

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
    let faces: Vec<String> =
        (0..brep.faces().len()).map(|face| share(brep, face).unwrap_or("?".into())).collect();
    Ok(format!("{volume:.12e}\t{:.3e}\t{}", open(brep), faces.join(" ")))
}

/// The share of a face in the volume seen from the origin, and by how much it is less for each unit that one looks from
/// farther along x, y and z.
fn share(brep: &Brep, face: usize) -> Option<String> {
    let size = brep.bounds_of_faces()?.diagonal().length();
    let from = |point: Point3| brep.face_volume(face, point, 1e-11).ok();
    let own = from(Point3::ORIGIN)?;
    let mut out = format!("{own:.12e}");
    for axis in [Vector3::X, Vector3::Y, Vector3::Z] {
        let less = (own - from((axis * size).to_point())?) / size;
        out.push_str(&format!(",{less:.12e}"));
    }
    Some(out)
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
