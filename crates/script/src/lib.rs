//! Script components in Python: GhPython, IronPython, and the Python 3 and generic Script components of Rhino 8.
//!
//! One process runs all Python components of a document, and stays warm between solves ([`Python`]). A component's
//! iterations go to it in one message; what the script calls of RhinoCommon is answered here, by the member table
//! (`katydid-members`), while the geometry stays on this side. A process that dies is started again for the next script.
//!
//! A script is somebody's program. Nothing here runs one unless it was allowed ([`Permission`]); the process has an empty
//! environment, a folder of its own, limits of memory, time, files and processes, and no network, as far as the system
//! offers that ([`Fence`] says how far).

mod components;
mod conductor;
mod csharp;
pub mod environment;
mod fence;
mod from_script;
mod interpreter;
mod keeper;
mod needs;
mod outputs;
mod permission;
mod process;
mod registry;
mod reply;
mod sources;
mod task;
mod to_script;

pub use conductor::{Python, PythonMaker};
pub use csharp::{CSharp, CSharpMaker, faults as csharp_faults};
pub use fence::Fence;
pub use interpreter::{Interpreter, find};
pub use needs::{Examiner, Needs};
pub use permission::{Permission, Trusted, fingerprint};
pub use process::Bounds;
pub use registry::host;
