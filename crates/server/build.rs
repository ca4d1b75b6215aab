//! Has the page and the book embedded anew when they were built anew.

use std::fs::File;
use std::path::Path;
use std::time::SystemTime;

fn main() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studio/dist");
    // A folder that is missing cannot be watched: an empty one can. Where none can be made, sources are read only, and no
    // page will come.
    if !page.exists() && std::fs::create_dir_all(&page).is_ok() {
        // One that is as new as this build would have the next one compile everything behind it again.
        let _ = File::open(&page).and_then(|folder| folder.set_modified(SystemTime::UNIX_EPOCH));
    }
    if page.is_dir() {
        println!("cargo:rerun-if-changed={}", page.display());
    }
    // Pages of the book that are new are embedded too.
    println!("cargo:rerun-if-changed={}", Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book").display());
    println!("cargo:rerun-if-changed=build.rs");
}
