//! What is in a model, in lines or as JSON.

use std::collections::BTreeMap;

use katydid_3dm::{Model, Validity, outline};
use serde_json::{Value, json};

use super::kind_name;
use crate::args::InfoArgs;
use crate::output::{BOLD, DIM, GREEN, RED, YELLOW, printable, say};

/// Faults and warnings beyond this many are only counted.
const MOST_LINES: usize = 20;

/// What is wrong or odd about an object.
struct Fault {
    place: usize,
    class: String,
    name: String,
    id: String,
    why: String,
}

/// What is counted and looked at.
pub(super) struct Summary {
    /// The tables in the order of the file, and how many records each has.
    tables: Vec<(String, usize)>,
    /// For each layer how many objects lie on it.
    on_layer: Vec<usize>,
    classes: BTreeMap<String, usize>,
    faults: Vec<Fault>,
    /// Objects that are valid, but not as somebody may have meant them.
    remarks: Vec<Fault>,
    /// Objects of classes whose validity nobody can tell yet.
    unjudged: usize,
}

impl Summary {
    pub(super) fn of(model: &Model, tables: Vec<(String, usize)>) -> Self {
        let mut on_layer = vec![0; model.layers.len()];
        for object in model.objects.iter().chain(&model.lights) {
            if let Some(count) = object.attributes.layer.and_then(|layer| on_layer.get_mut(layer)) {
                *count += 1;
            }
        }
        let (mut faults, mut remarks, mut unjudged) = (Vec::new(), Vec::new(), 0);
        for (place, object) in model.objects.iter().enumerate() {
            let told = |why| Fault {
                place,
                class: object.geometry.class_name(),
                name: object.attributes.name.clone(),
                id: object.attributes.id.to_string(),
                why,
            };
            match object.geometry.validity() {
                Validity::Valid => remarks.extend(object.geometry.remarks().into_iter().map(told)),
                Validity::Unknown => unjudged += 1,
                Validity::Invalid(why) => faults.push(told(why)),
            }
        }
        Self { tables, on_layer, classes: model.counts(), faults, remarks, unjudged }
    }

    pub(super) fn to_json(&self, args: &InfoArgs, model: &Model, size: usize) -> Value {
        let layers: Vec<Value> = model
            .layers
            .iter()
            .zip(&self.on_layer)
            .enumerate()
            .map(|(i, (layer, objects))| {
                json!({
                    "path": model.layer_path(i),
                    "objects": objects,
                    "visible": layer.visible,
                    "locked": layer.locked,
                    "colour": layer.colour,
                })
            })
            .collect();
        let told = |list: &[Fault]| -> Vec<Value> {
            let one = |f: &Fault| json!({ "object": f.place, "id": f.id, "class": f.class, "name": f.name, "why": f.why });
            list.iter().map(one).collect()
        };
        let warnings = model.warnings.iter().map(|w| {
            json!({ "kind": kind_name(w.kind), "offset": w.offset, "path": w.path.to_string(), "message": w.message })
        });
        let tables: serde_json::Map<String, Value> =
            self.tables.iter().map(|(name, count)| (name.clone(), json!(count))).collect();
        json!({
            "file": args.file.display().to_string(),
            "bytes": size,
            "version": model.archive_version,
            "openNurbs": model.opennurbs_version,
            "application": model.application,
            "units": unit_name(model),
            "metres": model.unit_scale.as_ref().map(|scale| scale.metres),
            "absoluteTolerance": model.tolerance.absolute,
            "angleTolerance": model.tolerance.angle,
            "relativeTolerance": model.relative_tolerance,
            "tables": tables,
            "layers": layers,
            "objects": self.classes,
            "invalid": told(&self.faults),
            "remarks": told(&self.remarks),
            "notJudged": self.unjudged,
            "skipped": model.skipped,
            "warnings": warnings.collect::<Vec<_>>(),
        })
    }

    pub(super) fn print(&self, args: &InfoArgs, model: &Model, size: usize) {
        say(&format!(
            "{BOLD}{}{BOLD:#}: {size} bytes, version {}",
            args.file.display(),
            model.archive_version
        ));
        let by = if model.application.is_empty() { "an unnamed program" } else { &model.application };
        let by = printable(by);
        say(&format!("  written by  {by} {DIM}(openNURBS {}){DIM:#}", model.opennurbs_version));
        say(&format!(
            "  units       {}; tolerance {} absolute, {:.3}° angle, {} % relative",
            unit_name(model),
            model.tolerance.absolute,
            model.tolerance.angle.to_degrees(),
            100.0 * model.relative_tolerance
        ));
        let tables: Vec<String> =
            self.tables.iter().filter(|(_, n)| *n > 0).map(|(name, n)| format!("{name} {n}")).collect();
        say(&format!("  tables      {}", if tables.is_empty() { "none".into() } else { tables.join(", ") }));
        say(&format!("{BOLD}layers{BOLD:#}"));
        for (i, (layer, objects)) in model.layers.iter().zip(&self.on_layer).enumerate() {
            let path = model.layer_path(i).unwrap_or_default();
            let state = match (layer.visible, layer.locked) {
                (false, _) => " (hidden)",
                (true, true) => " (locked)",
                (true, false) => "",
            };
            say(&format!("  {objects:>8}  {}{DIM}{state}{DIM:#}", printable(&path)));
        }
        say(&format!("{BOLD}objects{BOLD:#}"));
        for (class, count) in &self.classes {
            say(&format!("  {count:>8}  {class}"));
        }
        self.print_faults(model);
    }

    pub(super) fn has_faults(&self) -> bool {
        !self.faults.is_empty()
    }

    fn print_faults(&self, model: &Model) {
        let line = |fault: &Fault| {
            let name =
                if fault.name.is_empty() { String::new() } else { format!(" '{}'", printable(&fault.name)) };
            format!("{}{name} ({}): {}", fault.class, fault.id, fault.why)
        };
        for fault in self.faults.iter().take(MOST_LINES) {
            say(&format!("{RED}invalid{RED:#}: {}", line(fault)));
        }
        more(self.faults.len(), "invalid objects");
        for remark in self.remarks.iter().take(MOST_LINES) {
            say(&format!("{YELLOW}remark{YELLOW:#}: {}", line(remark)));
        }
        more(self.remarks.len(), "remarks");
        for warning in model.warnings.iter().take(MOST_LINES) {
            say(&format!(
                "{YELLOW}{}{YELLOW:#}: {}",
                kind_name(warning.kind),
                printable(&warning.to_string())
            ));
        }
        more(model.warnings.len(), "warnings");
        for (table, count) in &model.skipped {
            say(&format!("{YELLOW}skipped{YELLOW:#}: {count} × {table} record in all"));
        }
        if self.faults.is_empty() {
            let judged = model.objects.len() - self.unjudged;
            let rest = if self.unjudged > 0 {
                format!("; {} of classes that are not judged", self.unjudged)
            } else {
                String::new()
            };
            say(&format!("{GREEN}{judged} objects are valid{GREEN:#}{rest}"));
        }
    }
}

fn more(count: usize, what: &str) {
    if count > MOST_LINES {
        say(&format!("… and {} more {what}", count - MOST_LINES));
    }
}

fn unit_name(model: &Model) -> String {
    match &model.unit_scale {
        Some(scale) => scale.name.clone(),
        None => model.units.name().to_owned(),
    }
}

/// The tables of an archive in its order, and the records in each.
pub(super) fn tables(bytes: &[u8]) -> Result<Vec<(String, usize)>, katydid_3dm::Error> {
    let mut tables: Vec<(String, usize)> = Vec::new();
    outline(bytes, 1, |chunk| {
        let table = chunk.name.and_then(|name| name.strip_suffix(" table"));
        match (chunk.depth, table) {
            (0, Some(table)) => tables.push((table.to_owned(), 0)),
            (1, _) if chunk.name != Some("end of table") => {
                if let Some((_, count)) = tables.last_mut() {
                    *count += 1;
                }
            }
            _ => {}
        }
    })?;
    Ok(tables)
}
