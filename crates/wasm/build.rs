//! How the module is linked.

/// The stack in bytes, as programs have it: nested definitions are read and solved by nested calls. The linker's own
/// default is an eighth of it.
const STACK: usize = 8 << 20;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_FAMILY").is_ok_and(|family| family.split(',').any(|one| one == "wasm")) {
        println!("cargo:rustc-cdylib-link-arg=-zstack-size={STACK}");
        // The host calls what fills the registry of components (`index.js`).
        println!("cargo:rustc-cdylib-link-arg=--export=__wasm_call_ctors");
    }
}
