//! Printing: results to standard output, messages to standard error, colours only on a terminal.

use std::fs;
use std::io::Write;
use std::path::Path;

use anstyle::{AnsiColor, Style};

pub(crate) const RED: Style = AnsiColor::Red.on_default().bold();
pub(crate) const YELLOW: Style = AnsiColor::Yellow.on_default().bold();
pub(crate) const GREEN: Style = AnsiColor::Green.on_default();
pub(crate) const DIM: Style = Style::new().dimmed();
pub(crate) const BOLD: Style = Style::new().bold();

/// A line on standard output. A reader that has gone away is no error.
pub(crate) fn say(line: &str) {
    let _ = writeln!(anstream::stdout().lock(), "{line}");
}

/// A line on standard error.
pub(crate) fn note(line: &str) {
    let _ = writeln!(anstream::stderr().lock(), "{line}");
}

/// Why the command could not be done.
pub(crate) fn complain(error: &str) {
    note(&format!("{RED}error{RED:#}: {error}"));
}

/// Writes a file whole or not at all: beside it first, then in its place.
pub(crate) fn write_file(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("{}: {}", path.display(), super::source::plain(&error));
    write_file_with(path, |out| out.write_all(bytes).map_err(failed))
}

/// The same for a file that is written piece by piece.
pub(crate) fn write_file_with(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), String>,
) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("{}: {}", path.display(), super::source::plain(&error));
    let mut beside = path.as_os_str().to_owned();
    beside.push(".part");
    let beside = Path::new(&beside);
    let mut file = fs::File::create(beside).map_err(failed)?;
    let written = write(&mut file);
    drop(file);
    written.and_then(|()| fs::rename(beside, path).map_err(failed)).inspect_err(|_| {
        let _ = fs::remove_file(beside);
    })
}

/// The extension in lower case, without the dot.
pub(crate) fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
}

/// A name without what a terminal would act upon.
pub(crate) fn printable(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
