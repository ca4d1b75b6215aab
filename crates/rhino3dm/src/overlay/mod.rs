//! What kept records say, read out of them: views, construction planes, page settings, dimension and text styles,
//! texture mappings, history, embedded files.
//! The records stay as they are and are what is written.

mod bitmap;
mod dimension_style;
mod history;
mod page;
mod texture_mapping;

pub(crate) use bitmap::RENDERING;
pub use bitmap::{EmbeddedFile, EmbeddedForm};
pub use dimension_style::{DimensionStyle, TextStyle};
pub use history::{HistoryRecord, HistoryValue, HistoryValues, ObjectReference};
pub use page::{EarthAnchor, PageSettings};
pub use texture_mapping::{MappingKind, TextureMapping};
