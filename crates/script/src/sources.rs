//! The Python sources that the process runs, which are part of the program.

use std::io;
use std::path::Path;

use rust_embed::RustEmbed;

#[derive(RustEmbed)]
#[folder = "$CARGO_MANIFEST_DIR/../../python/katydid"]
#[include = "*.py"]
struct Worker;

/// What guards the process before any of its modules is loaded.
const GUARD: &str = include_str!("guard.py");

/// Writes the sources into a folder: `guard.py`, and `katydid/` with `worker.py` in it.
pub(crate) fn write(folder: &Path) -> io::Result<()> {
    std::fs::write(folder.join("guard.py"), GUARD)?;
    for name in Worker::iter() {
        let path = folder.join("katydid").join(&*name);
        let file = Worker::get(&name).ok_or_else(|| io::Error::other("a source is missing"))?;
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent)?;
        }
        std::fs::write(path, file.data)?;
    }
    Ok(())
}

/// Whether the worker is part of this program.
pub(crate) fn are_there() -> bool {
    Worker::get("worker.py").is_some()
}
