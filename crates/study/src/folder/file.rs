//! Files of a study's folder that are shown: pictures and geometry, and nothing that leads out of it.

use std::path::{Path, PathBuf};

/// The ends of the names of files that are handed out.
const ENDS: [&str; 14] =
    ["png", "jpg", "jpeg", "webp", "gif", "3dm", "glb", "gltf", "obj", "stl", "ply", "step", "stp", "3mf"];

/// The file of that name, which a table has: its parts are joined by `/`.
///
/// `None` for what is not there, what lies outside of the folder by its name or by a link, and what is neither a picture nor
/// geometry.
pub(super) fn find(folder: &Path, name: &str) -> Option<PathBuf> {
    let is_plain = |part: &str| {
        !part.is_empty()
            && !part.starts_with('.')
            && !part.contains(['\\', ':', '\0'])
            && !part.ends_with('.')
    };
    if !name.split('/').all(is_plain) {
        return None;
    }
    let end = Path::new(name).extension()?.to_str()?.to_ascii_lowercase();
    if !ENDS.contains(&end.as_str()) {
        return None;
    }
    let real = folder.canonicalize().ok()?;
    let file = real.join(name).canonicalize().ok()?;
    (file.starts_with(&real) && file.is_file()).then_some(file)
}
