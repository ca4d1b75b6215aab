//! Printing: results to standard output, messages to standard error, colours only on a terminal.

use std::io::{ErrorKind, Write};
use std::path::Path;
use std::sync::OnceLock;

use anstyle::{AnsiColor, Style};
use katydid_component::shortened;
use katydid_session::OutputFile;

pub(crate) const RED: Style = AnsiColor::Red.on_default().bold();
pub(crate) const YELLOW: Style = AnsiColor::Yellow.on_default().bold();
pub(crate) const GREEN: Style = AnsiColor::Green.on_default();
pub(crate) const DIM: Style = Style::new().dimmed();
pub(crate) const BOLD: Style = Style::new().bold();

/// Why standard output could not be written, from the first time that it could not.
static UNWRITTEN: OnceLock<String> = OnceLock::new();

/// A line on standard output. Whether it was written is asked once, by [`printed`]; after a failure nothing more is
/// tried.
pub(crate) fn say(line: &str) {
    if UNWRITTEN.get().is_none() {
        keep(writeln!(anstream::stdout().lock(), "{line}"));
    }
}

/// Text on standard output as it is: nothing in it is taken for a colour.
pub(crate) fn print(text: &str) {
    keep(std::io::stdout().lock().write_all(text.as_bytes()));
}

/// Whether all that was to be printed was.
///
/// # Errors
/// When standard output could not be written, as on a full disk. A reader that has gone away is no error: it has what it
/// wanted.
pub(crate) fn printed() -> Result<(), String> {
    keep(std::io::stdout().flush());
    match UNWRITTEN.get() {
        Some(why) => Err(format!("standard output could not be written: {why}")),
        None => Ok(()),
    }
}

fn keep(written: std::io::Result<()>) {
    if let Err(error) = written
        && error.kind() != ErrorKind::BrokenPipe
    {
        let _ = UNWRITTEN.set(error.to_string());
    }
}

/// A line on standard error; numbers of very many digits are shortened.
pub(crate) fn note(line: &str) {
    let _ = writeln!(anstream::stderr().lock(), "{}", shortened(line));
}

/// Why the command could not be done.
pub(crate) fn complain(error: &str) {
    note(&format!("{RED}error{RED:#}: {error}"));
}

/// Writes a file whole or not at all.
pub(crate) fn write_file(path: &Path, bytes: &[u8]) -> Result<(), String> {
    katydid_session::write_file(path, bytes).map_err(|error| failed(path, &error))
}

/// The same for a file that is written piece by piece.
pub(crate) fn write_file_with(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), String>,
) -> Result<(), String> {
    let mut file = OutputFile::create(path).map_err(|error| failed(path, &error))?;
    write(&mut file)?;
    file.finish().map_err(|error| failed(path, &error))
}

/// What failed, with the file.
pub(crate) fn failed(path: &Path, error: &std::io::Error) -> String {
    format!("{}: {}", path.display(), crate::source::plain(error))
}

/// The extension in lower case, without the dot.
pub(crate) fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
}

/// A name without what a terminal would act upon.
pub(crate) fn printable(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
