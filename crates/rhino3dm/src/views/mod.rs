//! Views, construction planes and page settings: read, and written anew where an archive has none.

mod plain;
mod view;

pub(crate) use plain::{PlainPlane, PlainView, plane_of, write_plain_page};
pub use view::{ConstructionPlane, View, ViewProjection};
pub(crate) use view::{PLANE, VIEW};
