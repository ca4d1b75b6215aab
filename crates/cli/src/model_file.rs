//! Opening .3dm models: whole, or as far as they can be read.

use std::path::Path;

use katydid_3dm::{Error, Limits, Model, WarningKind};

use crate::output::{YELLOW, note, printable};

/// What was skipped is told in so many lines; beyond that it is only counted.
const MOST_LINES: usize = 20;

/// A model of which nothing is broken; when lenient, what can be read of one.
pub(crate) fn read(path: &Path, bytes: &[u8], lenient: bool) -> Result<Model, String> {
    let limits = Limits::default();
    let read = if lenient { Model::read(bytes, &limits) } else { Model::read_strict(bytes, &limits) };
    read.map_err(|error| {
        let hint = match error.reason() {
            Error::NotAnArchive { .. } | Error::UnsupportedVersion(_) => "",
            _ if lenient => "",
            _ => "\nsomething in the file is broken: --lenient reads what can be read, and tells what is skipped",
        };
        format!("{}: {}{hint}", path.display(), printable(&error.to_string()))
    })
}

/// Tells on standard error what was odd in a model, and what of it could not be read; gives whether anything could not.
pub(crate) fn tell(path: &Path, model: &Model) -> bool {
    let is_skipped = |kind| kind == WarningKind::LeftOut;
    for warning in model.warnings.iter().take(MOST_LINES) {
        let word = if is_skipped(warning.kind) { "skipped" } else { "warning" };
        note(&format!("{YELLOW}{word}{YELLOW:#}: {}: {}", path.display(), printable(&warning.to_string())));
    }
    if model.warnings.len() > MOST_LINES {
        note(&format!(
            "… and {} more: katydid info --lenient --json has them all",
            model.warnings.len() - MOST_LINES
        ));
    }
    for (table, count) in &model.skipped {
        note(&format!("{YELLOW}skipped{YELLOW:#}: {}: {count} × {table} record in all", path.display()));
    }
    !model.skipped.is_empty() || model.warnings.iter().any(|warning| is_skipped(warning.kind))
}
