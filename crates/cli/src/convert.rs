//! `katydid convert`.

use std::path::Path;

use katydid_definition::archive::{self, Limits};
use katydid_definition::document::Document;
use katydid_definition::kd;

use crate::args::ConvertArgs;
use crate::convert_model::{self, is_model, readable_extensions};
use crate::output::{YELLOW, extension, note, write_file};
use crate::source;
use katydid_session::Registry;

pub(crate) fn convert(args: &ConvertArgs) -> Result<u8, String> {
    let (from, to) = (extension(&args.from), extension(&args.to));
    if is_model(&from) || is_model(&to) {
        return convert_model::convert(args);
    }
    let is_plain = !(args.ascii || args.hidden || args.lenient);
    if args.version.is_some() || args.tolerance.is_some() || args.view.is_some() || !is_plain {
        return Err(
            "--version, --tolerance, --ascii, --view, --hidden and --lenient are for models".to_owned()
        );
    }
    if !is_definition(&to) {
        return Err(format!("{}: a definition is written as .gh, .ghx or .kd", args.to.display()));
    }
    if !is_definition(&from) {
        let forms = "a definition is read from .gh, .ghx, .ghuser or .kd";
        return Err(format!("{}: {forms}, a model from {}", args.from.display(), readable_extensions()));
    }
    let bytes = match (from.as_str(), to.as_str()) {
        ("kd", "kd") => {
            let text = source::text(&args.from, source::bytes(&args.from)?)?;
            kd::format(&text).map_err(|problems| source::pointed(&args.from, &problems))?.into_bytes()
        }
        ("kd", _) => from_text(args, &to)?,
        (_, "kd") => to_text(args)?,
        _ => between_archives(args, &to)?,
    };
    write_file(&args.to, &bytes)?;
    Ok(0)
}

fn is_definition(extension: &str) -> bool {
    ["gh", "ghx", "ghuser", "kd"].contains(&extension)
}

fn failed(path: &Path, error: &dyn std::fmt::Display) -> String {
    format!("{}: {error}", path.display())
}

fn remark(path: &Path, what: &str) {
    note(&format!("{YELLOW}note{YELLOW:#}: {}: {what}", path.display()));
}

/// The tree of an archive in the other encoding.
fn between_archives(args: &ConvertArgs, to: &str) -> Result<Vec<u8>, String> {
    let archive = archive::read(&source::bytes(&args.from)?, &Limits::default())
        .map_err(|error| failed(&args.from, &error))?;
    for text in &archive.notes {
        remark(&args.from, text);
    }
    encode(args, &archive.root, to)
}

fn encode(args: &ConvertArgs, root: &archive::Chunk, to: &str) -> Result<Vec<u8>, String> {
    let bytes =
        if to == "ghx" { archive::write_ghx(root).map(String::into_bytes) } else { archive::write_gh(root) };
    bytes.map_err(|error| failed(&args.to, &error))
}

fn to_text(args: &ConvertArgs) -> Result<Vec<u8>, String> {
    let document = Document::read(&source::bytes(&args.from)?, &Limits::default())
        .map_err(|error| failed(&args.from, &error))?;
    for text in &document.notes {
        remark(&args.from, text);
    }
    let written = kd::write(&document, &Registry).map_err(|error| failed(&args.from, &error))?;
    for what in &written.left_out {
        remark(&args.to, &format!("left out: {what}"));
    }
    Ok(written.text.into_bytes())
}

fn from_text(args: &ConvertArgs, to: &str) -> Result<Vec<u8>, String> {
    if to == "ghuser" {
        return Err("a .ghuser file holds one object, not a definition: use .gh or .ghx".to_owned());
    }
    let mut definition = source::definition(&args.from)?;
    if let Some(units) = definition.units {
        remark(
            &args.to,
            &format!("left out: the unit, {}, which only a .kd file keeps", units.name().to_lowercase()),
        );
    }
    let text = source::text(&args.from, source::bytes(&args.from)?)?;
    if kd::has_comments(&text) {
        remark(&args.to, "left out: the comments");
    }
    let placed = kd::arrange(&mut definition.document);
    if placed > 0 {
        remark(&args.to, &format!("{placed} objects that had no place on the canvas were given one"));
    }
    encode(args, &definition.document.to_archive().root, to)
}

/// Writes a definition in the form that the path's extension names.
pub(crate) fn write_document(document: &Document, path: &Path) -> Result<(), String> {
    let bytes = match extension(path).as_str() {
        "kd" => kd::write(document, &Registry).map_err(|error| failed(path, &error))?.text.into_bytes(),
        "ghx" => archive::write_ghx(&document.to_archive().root)
            .map_err(|error| failed(path, &error))?
            .into_bytes(),
        "gh" => archive::write_gh(&document.to_archive().root).map_err(|error| failed(path, &error))?,
        _ => return Err(format!("{}: a definition is written as .gh, .ghx or .kd", path.display())),
    };
    write_file(path, &bytes)
}
