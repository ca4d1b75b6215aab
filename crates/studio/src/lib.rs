//! What the studio's page asks for besides the session itself, whoever answers: a server, or the engine in the page.
//!
//! Which objects are to be drawn anew ([`Drafts`]), what is seen of the form of curves and surfaces ([`Analyses`]), small
//! pictures, files of definitions and of what they make, the components as the page lists them ([`catalogue`]), and the
//! definitions to start from ([`Gallery`]). Nothing here knows of sockets, threads or a disk.

mod analyses;
pub mod catalogue;
mod drafts;
mod export;
mod form;
mod frame;
mod gallery;
mod portrait;
pub mod study;
mod thumbnails;
mod touched;

pub use analyses::{About, Analysed, Analyses, ClientId, Finding};
pub use drafts::Drafts;
pub use export::{Wishes, export};
pub use form::{Form, read, write};
pub use frame::{framed_size, write_frame};
pub use gallery::Gallery;
pub use portrait::portrait;
pub use thumbnails::pictures;
pub use touched::touched;
