//! A document being worked on: it is edited, undone, solved, shown, reported and baked.
//!
//! An [`Editor`] holds the document that counts, and its history. Every edit gives a [`Change`] with the difference
//! between the document before and after, and all who follow the document take that: a solver's engine, the
//! [`journal`], and faces, which get it as a patch in the words of the [`protocol`]. A [`Session`] is an editor with an
//! engine that follows it, for whoever sets inputs and wants results.
//!
//! Nothing here knows where requests come from: no sockets, no files but the journal's, and
//! [`write_file`], by which everybody who writes a file writes it whole or not at all. The command line, the server
//! and the studio all stand on this.
//!
//! ```
//! use katydid_definition::document::Document;
//! use katydid_session::Session;
//!
//! let mut session = Session::new(Document::new(), Default::default());
//! session.solve();
//! assert!(session.report().objects.is_empty());
//! assert!(!session.undo());
//! ```

pub mod analysis;
mod bake;
mod catalogue;
mod change;
mod check;
mod controls;
pub mod display;
mod editor;
mod edits;
mod explain;
mod input;
pub mod journal;
#[cfg(not(target_family = "wasm"))]
mod output_file;
pub mod protocol;
mod report;
mod results;
mod scripts;
mod session;
mod solution;
mod streams;
mod view;

pub use bake::{BakeOptions, Baked, bake};
pub use catalogue::Registry;
pub use change::{Change, Refusal};
pub use check::{Check, KnownOfPlugin, MissingOutput, Outputs, ScriptObject, Unsupported, check};
pub use editor::{About, Editor, NoResults, Results, content as cluster_content, edit_inside};
pub use edits::new_object;
pub use explain::{explain, explainable, nurbs_of};
pub use input::{InputError, assign as assign_input, find as find_input, inputs, nearest};
#[cfg(not(target_family = "wasm"))]
pub use output_file::{OutputFile, remove_unfinished, write_file};
pub use report::{Items, Report};
pub use results::{Digits, result_view, rows, structure};
pub use scripts::{imports, scripts};
pub use session::Session;
pub use solution::{Reports, Solution};
pub use streams::{PanelStream, panel_streams, write_panel};
