//! Links the program at a fixed address, and functions that are alike once, where that is known to work.
//!
//! The tables of components hold some hundred thousand addresses. In a program that may be loaded anywhere each of them is written anew
//! at every start, which touches megabytes of memory: half of the time that a small definition takes. Libraries, stack and heap
//! are placed at random as before; the program itself is safe Rust.
//!
//! Of generic functions many are compiled to the same instructions. LLVM's linker, which Rust brings along, folds them into one; others
//! do not know the option, so it is tried on an empty program.

use std::path::Path;
use std::process::Command;

/// Functions with the same instructions become one.
const FOLDED: &str = "-Wl,--icf=all";

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=RUSTFLAGS");
    let is = |key: &str, value: &str| std::env::var(key).is_ok_and(|found| found == value);
    if is("CARGO_CFG_TARGET_OS", "linux")
        && is("CARGO_CFG_TARGET_ENV", "gnu")
        && is("CARGO_CFG_TARGET_ARCH", "x86_64")
    {
        println!("cargo:rustc-link-arg-bins=-no-pie");
        // Tests wait for the linker; what is published is to be small.
        if is("PROFILE", "release") && links_with(FOLDED) {
            println!("cargo:rustc-link-arg-bins={FOLDED}");
        }
    }
}

/// Whether a program can be linked with an option.
fn links_with(option: &str) -> bool {
    let (Some(rustc), Some(folder), Ok(target)) =
        (std::env::var_os("RUSTC"), std::env::var_os("OUT_DIR"), std::env::var("TARGET"))
    else {
        return false;
    };
    let (source, program) = (Path::new(&folder).join("empty.rs"), Path::new(&folder).join("empty"));
    if std::fs::write(&source, "fn main() {}\n").is_err() {
        return false;
    }
    let mut command = Command::new(rustc);
    let flags = std::env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    command.args(flags.split('\u{1f}').filter(|flag| !flag.is_empty()));
    command.args(["--edition=2024", "--target", &target, "-C"]).arg(format!("link-arg={option}"));
    // The linker that cargo was told to use, where it was.
    if let Ok(linker) = std::env::var("RUSTC_LINKER") {
        command.arg("-C").arg(format!("linker={linker}"));
    }
    command.arg("-o").arg(program).arg(source);
    command.output().is_ok_and(|output| output.status.success())
}
