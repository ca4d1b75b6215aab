//! Links the program at a fixed address where that is known to work.
//!
//! The tables of components hold some hundred thousand addresses. In a program that may be loaded anywhere each of them is written anew
//! at every start, which touches megabytes of memory: half of the time that a small definition takes. Libraries, stack and heap
//! are placed at random as before; the program itself is safe Rust.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let is = |key: &str, value: &str| std::env::var(key).is_ok_and(|found| found == value);
    if is("CARGO_CFG_TARGET_OS", "linux")
        && is("CARGO_CFG_TARGET_ENV", "gnu")
        && is("CARGO_CFG_TARGET_ARCH", "x86_64")
    {
        println!("cargo:rustc-link-arg-bins=-no-pie");
    }
}
