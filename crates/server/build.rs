//! Has the page and the book embedded anew when they were built anew.

use std::path::Path;

fn main() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studio/dist");
    // A folder that is missing cannot be watched: an empty one can. Where none can be made, sources are read only, and no
    // page will come.
    let _ = std::fs::create_dir_all(&page);
    if page.is_dir() {
        println!("cargo:rerun-if-changed={}", page.display());
    }
    // Pages of the book that are new are embedded too.
    println!("cargo:rerun-if-changed={}", Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book").display());
    println!("cargo:rerun-if-changed=build.rs");
}
