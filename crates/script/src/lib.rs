//! Script components in Python: GhPython, IronPython, and the Python 3 and generic Script components of Rhino 8.
//!
//! One process runs all Python components of a document, and stays warm between solves ([`Python`]). A component's
//! iterations go to it in one message; what the script calls of RhinoCommon is answered here, by the member table
//! (`katydid-members`), while the geometry stays on this side. A process that dies is started again for the next script.
//!
//! In a web page there are no processes: only C# and VB run there, in the page's own module.
//!
//! A script is somebody's program. Nothing here runs one unless it was allowed ([`Permission`]); the process has an empty
//! environment, a folder of its own, limits of memory, time, files and processes, and no network, as far as the system
//! offers that ([`Fence`] says how far).

mod components;
#[cfg(not(target_family = "wasm"))]
mod conductor;
mod csharp;
#[cfg(not(target_family = "wasm"))]
pub mod environment;
#[cfg(not(target_family = "wasm"))]
mod fence;
mod from_script;
#[cfg(not(target_family = "wasm"))]
mod interpreter;
mod keeper;
#[cfg(not(target_family = "wasm"))]
mod needs;
mod outputs;
#[cfg(not(target_family = "wasm"))]
mod permission;
#[cfg(not(target_family = "wasm"))]
mod process;
mod registry;
mod reply;
#[cfg(not(target_family = "wasm"))]
mod sources;
mod task;
mod to_script;

#[cfg(not(target_family = "wasm"))]
pub use conductor::{Python, PythonMaker};
pub use csharp::{CSharp, CSharpMaker, faults as csharp_faults};
#[cfg(not(target_family = "wasm"))]
pub use fence::Fence;
#[cfg(not(target_family = "wasm"))]
pub use interpreter::{Interpreter, find};
#[cfg(not(target_family = "wasm"))]
pub use needs::{Examiner, Needs};
#[cfg(not(target_family = "wasm"))]
pub use permission::{Permission, Trusted, fingerprint};
#[cfg(not(target_family = "wasm"))]
pub use process::Bounds;
pub use registry::host;
