//! Writes every solid of models and definitions as a STEP file of its own: `write_steps FOLDER PATH…`
//!
//! For another kernel to judge: a line a solid, with tabs between the file's name, where the solid comes from, and its
//! volume or why there is none.

#![allow(clippy::print_stdout, reason = "an example speaks")]

use std::path::{Path, PathBuf};

use katydid_3dm::{Limits, Model, Object, RawObject};
use katydid_definition::archive::{self, Chunk};
use katydid_definition::document::OnData;
use katydid_geometry::Brep;
use katydid_step::{Document, Part, Shape};

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

/// Writes a solid; its volume, or why there is none.
fn told(brep: &Brep, tolerance: f64, path: &Path) -> Result<String, Box<dyn std::error::Error>> {
    let mut document = Document { tolerance, ..Document::default() };
    document.parts.push(Part::named("solid", Shape::Brep(brep.clone().into())));
    let left_out = katydid_step::write(&document, &mut std::fs::File::create(path)?)?;
    if let Some(first) = left_out.first() {
        return Ok(format!("left out: {}", first.why));
    }
    Ok(match brep.volume_properties(1e-11, || true) {
        Ok(found) => format!("{:.12e}", found.amount),
        Err(error) => format!("no volume: {error}"),
    })
}
