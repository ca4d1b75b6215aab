//! The document: objects, ports, wires, groups and clusters, and the formats it is kept in.
//!
//! [`archive`] reads and writes the tree of chunks and items that .gh, .ghx and .ghuser files hold; nothing in
//! it knows what an object is. [`document`] is the view of that tree as objects, ports and wires. The tree
//! stays the truth: a chunk that nobody here understands is saved as it came. [`kd`] is the same as text that people
//! write and compare. Nothing in this crate solves.
//!
//! ```
//! use katydid_definition::archive::{self, Archive, Chunk, Limits};
//!
//! let mut root = Chunk::new("Root");
//! root.set("Greeting", "good evening");
//! let bytes = archive::write_gh(&root)?;
//! let archive: Archive = archive::read(&bytes, &Limits::default())?;
//! assert_eq!(archive.root.str("Greeting"), Some("good evening"));
//! # Ok::<(), katydid_definition::Error>(())
//! ```

pub mod archive;
pub mod diff;
pub mod document;
mod error;
pub mod kd;

pub use error::{Error, Place, Result};
