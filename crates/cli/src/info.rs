//! `katydid info`.

use std::collections::BTreeMap;

use katydid_3dm::{Limits, Model, Object, OutlineContent, OutlineCrc, outline};
use serde_json::{Value, json};

use crate::args::InfoArgs;
use crate::output::{BOLD, DIM, GREEN, RED, YELLOW, say};
use crate::source;

/// How deep the tree is shown when nobody says: tables, their records, and what records are made of.
const USUAL_DEPTH: usize = 2;
/// Faults and warnings beyond this many are only counted.
const MOST_LINES: usize = 20;

pub(crate) fn info(args: &InfoArgs) -> Result<u8, String> {
    let bytes = source::bytes(&args.file)?;
    if args.tree {
        return tree(args, &bytes);
    }
    let failed = |error: &dyn std::fmt::Display| format!("{}: {error}", args.file.display());
    let model = Model::read(&bytes, &Limits::default()).map_err(|error| failed(&error))?;
    let report = Report::of(&model, tables(&bytes).map_err(|error| failed(&error))?);
    if args.json {
        let text = report.to_json(args, &model, bytes.len());
        say(&serde_json::to_string(&text).map_err(|error| error.to_string())?);
    } else {
        report.print(args, &model, bytes.len());
    }
    Ok(u8::from(!report.faults.is_empty() || !model.warnings.is_empty()))
}

/// An object that is not valid.
struct Fault {
    place: usize,
    class: String,
    name: String,
    id: String,
    why: String,
}

/// What is counted and looked at.
struct Report {
    /// The tables in the order of the file, and how many records each has.
    tables: Vec<(String, usize)>,
    /// For each layer how many objects lie on it.
    on_layer: Vec<usize>,
    classes: BTreeMap<String, usize>,
    faults: Vec<Fault>,
    /// Objects of classes whose validity nobody can tell yet.
    unjudged: usize,
}

impl Report {
    fn of(model: &Model, tables: Vec<(String, usize)>) -> Self {
        let mut on_layer = vec![0; model.layers.len()];
        for object in model.objects.iter().chain(&model.lights) {
            if let Some(count) = object.attributes.layer.and_then(|layer| on_layer.get_mut(layer)) {
                *count += 1;
            }
        }
        let (mut faults, mut unjudged) = (Vec::new(), 0);
        for (place, object) in model.objects.iter().enumerate() {
            match validity(&object.geometry) {
                Validity::Valid => {}
                Validity::Unknown => unjudged += 1,
                Validity::Invalid(why) => faults.push(Fault {
                    place,
                    class: object.geometry.class_name(),
                    name: object.attributes.name.clone(),
                    id: object.attributes.id.to_string(),
                    why,
                }),
            }
        }
        Self { tables, on_layer, classes: model.counts(), faults, unjudged }
    }

    fn to_json(&self, args: &InfoArgs, model: &Model, size: usize) -> Value {
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
        let faults = self.faults.iter().map(
            |f| json!({ "object": f.place, "id": f.id, "class": f.class, "name": f.name, "why": f.why }),
        );
        let warnings = model.warnings.iter().map(|w| json!({ "offset": w.offset, "message": w.message }));
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
            "invalid": faults.collect::<Vec<_>>(),
            "notJudged": self.unjudged,
            "skipped": model.skipped,
            "warnings": warnings.collect::<Vec<_>>(),
        })
    }

    fn print(&self, args: &InfoArgs, model: &Model, size: usize) {
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

    fn print_faults(&self, model: &Model) {
        for fault in self.faults.iter().take(MOST_LINES) {
            let name =
                if fault.name.is_empty() { String::new() } else { format!(" '{}'", printable(&fault.name)) };
            say(&format!("{RED}invalid{RED:#}: {}{name} ({}): {}", fault.class, fault.id, fault.why));
        }
        more(self.faults.len(), "invalid objects");
        for warning in model.warnings.iter().take(MOST_LINES) {
            say(&format!("{YELLOW}warning{YELLOW:#}: {}", printable(&warning.to_string())));
        }
        more(model.warnings.len(), "warnings");
        for (table, count) in &model.skipped {
            say(&format!("{YELLOW}skipped{YELLOW:#}: {count} × {table} record"));
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

/// A name without what a terminal would act upon.
fn printable(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

fn unit_name(model: &Model) -> String {
    match &model.unit_scale {
        Some(scale) => scale.name.clone(),
        None => model.units.name().to_owned(),
    }
}

enum Validity {
    Valid,
    Invalid(String),
    Unknown,
}

/// Curves, surfaces and point clouds that the kernel does not take are kept as bytes, so those it took are valid.
fn validity(object: &Object) -> Validity {
    match object {
        Object::Mesh(mesh) => match mesh.to_mesh().and_then(|mesh| mesh.check()) {
            Ok(()) => Validity::Valid,
            Err(error) => Validity::Invalid(error.to_string()),
        },
        Object::Kept(raw) => match raw.parse(&Limits::default()) {
            Ok(_) => Validity::Unknown,
            Err(error) => Validity::Invalid(error.to_string()),
        },
        Object::Brep(object) => match object.brep.faults().as_slice() {
            [] if object.odd_curves_3d.is_empty() && object.odd_surfaces.is_empty() => Validity::Valid,
            [] => Validity::Invalid("it has curves or surfaces that make no sense".into()),
            [fault] => Validity::Invalid(fault.to_string()),
            [fault, others @ ..] => Validity::Invalid(format!("{fault}; and {} more", others.len())),
        },
        Object::CurveForm(form) => match form.to_curve() {
            Ok(_) => Validity::Valid,
            Err(error) => Validity::Invalid(error.to_string()),
        },
        Object::SurfaceForm(form) => match form.to_surface() {
            Ok(_) => Validity::Valid,
            Err(error) => Validity::Invalid(error.to_string()),
        },
        Object::Point(p) if !p.is_finite() => Validity::Invalid("a coordinate is not a finite number".into()),
        Object::Point(_) | Object::PointCloud(_) | Object::Curve(_) | Object::Surface(_) => Validity::Valid,
        _ => Validity::Unknown,
    }
}

/// The tables of an archive in its order, and the records in each.
fn tables(bytes: &[u8]) -> Result<Vec<(String, usize)>, katydid_3dm::Error> {
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

fn tree(args: &InfoArgs, bytes: &[u8]) -> Result<u8, String> {
    let mut wrong = 0;
    let mut chunks = Vec::new();
    let walked = outline(bytes, args.depth.unwrap_or(USUAL_DEPTH), |chunk| {
        let (content, crc) = match chunk.content {
            OutlineContent::Value(value) => (format!("= {value}"), ""),
            OutlineContent::Body { length, crc } => {
                wrong += usize::from(crc == OutlineCrc::Wrong);
                (format!("{length} bytes"), crc_name(crc))
            }
        };
        if args.json {
            chunks.push(json!({
                "offset": chunk.offset,
                "depth": chunk.depth,
                "typecode": format!("{:08X}", chunk.typecode),
                "name": chunk.name,
                "class": chunk.class,
                "value": match chunk.content { OutlineContent::Value(value) => Some(value), OutlineContent::Body { .. } => None },
                "length": match chunk.content { OutlineContent::Body { length, .. } => Some(length), OutlineContent::Value(_) => None },
                "crc": crc,
            }));
            return;
        }
        let indent = "  ".repeat(chunk.depth);
        let class = chunk.class.map(|class| format!(" {GREEN}{class}{GREEN:#}")).unwrap_or_default();
        let crc = match crc {
            "wrong" => format!(" {RED}CRC wrong{RED:#}"),
            "" | "none" => String::new(),
            other => format!(" {DIM}CRC {other}{DIM:#}"),
        };
        let name = chunk.name.unwrap_or("unknown");
        say(&format!(
            "{:>10}  {indent}{name}{class} {DIM}{:08X}{DIM:#} {content}{crc}",
            chunk.offset, chunk.typecode
        ));
    });
    let walked = walked.map_err(|error| format!("{}: {error}", args.file.display()))?;
    if args.json {
        let broken = walked.broken.iter().map(|(offset, why)| json!({ "offset": offset, "why": why }));
        let all = json!({
            "file": args.file.display().to_string(),
            "version": walked.version,
            "start": walked.start,
            "ended": walked.ended,
            "broken": broken.collect::<Vec<_>>(),
            "chunks": chunks,
        });
        say(&serde_json::to_string(&all).map_err(|error| error.to_string())?);
    } else {
        for (offset, why) in &walked.broken {
            say(&format!("{offset:>10}  {RED}broken{RED:#}: {why}"));
        }
        if !walked.ended {
            say(&format!("{:>10}  {RED}broken{RED:#}: the archive has no end mark", bytes.len()));
        }
    }
    Ok(u8::from(wrong > 0 || !walked.broken.is_empty() || !walked.ended))
}

fn crc_name(crc: OutlineCrc) -> &'static str {
    match crc {
        OutlineCrc::Absent => "none",
        OutlineCrc::Right => "right",
        OutlineCrc::Wrong => "wrong",
        OutlineCrc::Unknown => "not checked",
    }
}
