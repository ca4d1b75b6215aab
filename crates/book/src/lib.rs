//! A live book: pages of Markdown whose figures are definitions.
//!
//! [`Book::read`] takes the files of a folder ([`Files`]), [`Book::build`] makes the pages: HTML that reads without a script,
//! with stills of the figures, formulas as MathML and values from a run of each definition; a script beside them makes the
//! figures move. The same files give the same bytes. How pages are written is told in `book/FORMAT.md`.

mod assets;
mod block;
mod build;
mod contents;
mod exercise;
mod fault;
mod figure;
mod files;
mod front;
mod html;
mod links;
mod markdown;
mod maths;
mod page;
mod palette;
mod read;
mod solved;
mod steps;
mod still;
mod value;
mod words;

pub use build::Site;
pub use fault::Fault;
pub use files::Files;
pub use palette::Hue;
pub use read::Book;
