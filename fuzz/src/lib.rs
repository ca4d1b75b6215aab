//! What several fuzz targets share.

use katydid_exchange::{Format, Options, read, write};

/// Reads a model file. What was read is written in the same format and read again, which must go well: a file of ours is
/// never refused. Coordinates that a format cannot hold are for the writer to refuse.
pub fn there_and_back(bytes: &[u8], format: Format) {
    let Ok(scene) = read(bytes, format) else { return };
    let mut file = Vec::new();
    if write(&scene, format, &Options::default(), &mut file).is_ok() {
        read(&file, format).unwrap();
    }
}
