//! What a solved definition shows, in the model's own space: the geometry of objects whose preview is on, and what
//! display components draw.
//!
//! Pictures and the studio's viewport are made from it.
//!
//! ```
//! use katydid_data::cast::Rules;
//! use katydid_data::{Colour, Tree};
//! use katydid_definition::document::{Object, ids};
//! use katydid_geometry::Point3;
//! use katydid_scene::{Look, Painter};
//!
//! let rules = Rules::default();
//! let mut painter = Painter::for_picture(&rules, Look::of(Colour::rgb(150, 0, 0)));
//! painter.object(&Object::new(ids::DATA, "Data"), &[Tree::list(vec![Point3::ORIGIN])], Vec::new);
//! assert!(painter.scene.things.is_empty(), "the object has no port that shows it");
//! ```

#![allow(
    clippy::neg_cmp_op_on_partial_ord,
    reason = "!(x > limit) is how a NaN is refused together with the too small"
)]

mod block;
mod clip;
pub mod colour;
mod display;
mod facets;
pub mod font;
mod form;
mod gradients;
mod leader;
mod painter;
mod rows;
mod solids;
mod values;

pub use block::Block;
pub use facets::{Bend, Facets};
pub use form::{Form, Legend, Look, Origin, Place, Scene, Thing, tessellated};
pub use gradients::legends;
pub use painter::{Painter, draws_inputs, is_shown};
