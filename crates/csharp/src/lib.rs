//! C# as script components use it: read, checked, compiled to operations on registers, and run within limits.
//!
//! No geometry lives here, and nothing that reaches files, sockets or threads. The host says by [`Host`] which types a
//! program may use beyond the library, takes what it prints, and can end it at any time. The same program gives the
//! same output on every machine.
//!
//! ```
//! use katydid_csharp::{Engine, Limits, Printing, Source};
//!
//! let source = "class P { static void Main() { System.Console.WriteLine(7 / 2); } }";
//! let host = Printing::default();
//! let printed = host.text.clone();
//! let mut engine = Engine::new(&Source::File(source), Box::new(host), Limits::default()).map_err(|e| e[0].to_string())?;
//! engine.run_main().map_err(|e| e.to_string())?;
//! assert_eq!(*printed.lock().map_err(|e| e.to_string())?, "3\n");
//! # Ok::<(), String>(())
//! ```

mod bind;
mod bound;
mod decimal;
mod diagnostic;
mod emit;
mod engine;
mod host;
mod library;
mod program;
pub mod sema;
mod source;
mod syntax;
mod vb;
pub mod vm;

pub use diagnostic::Diagnostic;
pub use engine::{Engine, Failure, Parts, Source};
pub use host::{Host, Printing};
pub use library::Cx;
pub use source::Location;
pub use vm::value::Value;
pub use vm::{Limits, Raise, Stop};
