//! Writing scenes to files, with what belongs beside them.

use std::path::Path;

use katydid_exchange::{Format, LeftOut, Options, Scene};

use crate::output::write_file_with;

/// Writes a scene whole or not at all; an OBJ of things with colours gets its file of materials beside it. Gives what the
/// format could not hold.
pub(crate) fn write(
    scene: &Scene,
    format: Format,
    mut options: Options,
    path: &Path,
) -> Result<Vec<LeftOut>, String> {
    let failed = |path: &Path, error: katydid_exchange::Error| format!("{}: {error}", path.display());
    let materials = path.with_extension("mtl");
    let has_materials = format == Format::Obj && katydid_exchange::needs_materials(scene);
    if has_materials {
        options.materials = materials.file_name().map(|name| name.to_string_lossy().into_owned());
        write_file_with(&materials, |out| {
            katydid_exchange::write_materials(scene, out).map_err(|error| failed(&materials, error))
        })?;
    }
    let mut lost = Vec::new();
    write_file_with(path, |out| {
        lost = katydid_exchange::write(scene, format, &options, out).map_err(|error| failed(path, error))?;
        Ok(())
    })
    .inspect_err(|_| {
        // Materials of a file that is not there are of no use.
        if has_materials {
            let _ = std::fs::remove_file(&materials);
        }
    })?;
    Ok(lost)
}
