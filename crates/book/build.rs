//! Has the script of the pages embedded anew when it was built anew.

use std::path::Path;

fn main() {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studio/dist/learn");
    // A folder that is missing cannot be watched: an empty one can. Where none can be made, sources are read only, and no
    // script will come.
    let _ = std::fs::create_dir_all(&script);
    if script.is_dir() {
        println!("cargo:rerun-if-changed={}", script.display());
    }
    println!("cargo:rerun-if-changed=build.rs");
}
