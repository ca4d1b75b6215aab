//! Prints what archives and single objects hold, one JSON object a line, for comparison with other readers.
//!
//! `dump FILE.3dm…` prints a line an object of each archive; `dump OBJECTS.jsonl` reads lines with the members
//! `archive3dm`, `opennurbs` and `data` (base64), the form rhino3dm encodes objects in, and prints a line each.

mod annotation;
mod brep;
mod curve;
mod geometry;
mod mesh;
mod numbers;
mod surface;
mod tables;

use base64::Engine;
use katydid_3dm::{Limits, Model, ModelObject};
use serde_json::{Value, json};

use geometry::geometry;
use tables::{attributes, tables};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for path in std::env::args().skip(1) {
        if path.ends_with(".jsonl") {
            for line in std::fs::read_to_string(&path)?.lines() {
                println!("{}", encoded_object(&serde_json::from_str(line)?));
            }
        } else {
            archive(&path)?;
        }
    }
    Ok(())
}

fn archive(path: &str) -> Result<(), Box<dyn std::error::Error>> {
    let model = match Model::read(&std::fs::read(path)?, &Limits::default()) {
        Ok(model) => model,
        Err(error) => {
            println!("{}", json!({"file": path, "error": error.to_string()}));
            return Ok(());
        }
    };
    let tolerances = [model.tolerance.absolute, model.tolerance.angle];
    let [absolute, angle] = model.settings.impossible_tolerances.unwrap_or(tolerances);
    let warnings: Vec<String> = model.warnings.iter().map(ToString::to_string).collect();
    println!(
        "{}",
        json!({"file": path, "version": model.archive_version, "units": model.units.name(), "notes": model.notes,
            "application": model.application,
            "absolute": absolute, "angle": angle, "tables": tables(&model),
            "objects": model.objects.len(), "lights": model.lights.len(), "skipped": model.skipped,
            "warnings": warnings})
    );
    for object in model.objects.iter().chain(&model.lights) {
        let mut line = attributes(&object.attributes);
        line["geometry"] = geometry(&object.geometry);
        println!("{line}");
    }
    Ok(())
}

fn encoded_object(form: &Value) -> Value {
    let number = |key: &str| form[key].as_i64().and_then(|n| i32::try_from(n).ok()).unwrap_or_default();
    let data = form["data"].as_str().unwrap_or_default();
    let Ok(data) = base64::engine::general_purpose::STANDARD.decode(data) else {
        return json!({"error": "the data is not base64"});
    };
    match ModelObject::from_on_data(number("archive3dm"), number("opennurbs"), &data) {
        Ok(object) => {
            let written = object.to_on_data(60).map(|w| {
                let again = ModelObject::from_on_data(w.archive3dm, w.opennurbs, &w.data);
                json!({"version": 10000, "archive3dm": w.archive3dm, "opennurbs": w.opennurbs,
                    "data": base64::engine::general_purpose::STANDARD.encode(&w.data),
                    "read_back_equal": again.is_ok_and(|back| back == object)})
            });
            json!({"geometry": geometry(&object.geometry), "written": written.ok()})
        }
        Err(error) => json!({"error": error.to_string()}),
    }
}
