//! What a component is: typed ports, the function behind them, and how data trees are matched to its inputs.
//!
//! A component is one plain function with the [`component`] attribute. The attribute reads ports, access and
//! help off the signature, writes the loop over the data, and enters the component in the [`registry`].
//!
//! ```
//! use katydid_component::component;
//! use katydid_geometry::Point3;
//!
//! /// The straight distance between two points.
//! #[component("00000000-0000-0000-0000-00000000d157", name = "Doc Distance", nick = "Dist", at = "Doc/Tests")]
//! #[output("Distance", "D", "The distance, in the units of the points.")]
//! fn doc_distance(
//!     /// The first point.
//!     #[port("Point A", "A")]
//!     a: Point3,
//!     /// The second point.
//!     #[port("Point B", "B")]
//!     b: Point3,
//! ) -> f64 {
//!     a.distance_to(b)
//! }
//!
//! assert_eq!(katydid_component::registry::by_name("Doc Distance").unwrap().inputs.len(), 2);
//! ```

mod baker;
mod budget;
mod call;
mod context;
mod files;
mod input;
mod iterate;
mod kept;
mod matching;
mod message;
mod outbox;
mod output;
mod pace;
mod port;
pub mod registry;
mod rhino_content;
mod rhino_model;
mod shortened;
mod stand_in;
pub mod stored;
pub mod testing;
mod trust;
pub mod whole;

pub use baker::{Baker, baker};
pub use budget::{Budget, Cancel, Deadline, Limits};
pub use call::{Call, Outcome};
pub use context::Context;
pub use files::Files;
pub use input::{List, ListKey, ManyItems, ManyLists, ManyTrees};
pub use katydid_component_macros::component;
pub use katydid_memory::Account;
pub use kept::Kept;
pub use matching::{Matching, Ranges};
pub use message::{Level, Message, ModelLack, Notes};
pub use outbox::{OutFile, Outbox, file_name};
pub use output::{Each, ItemOrList};
pub use port::{Access, Component, Port};
pub use rhino_model::{RhinoModel, RhinoObject};
pub use shortened::shortened;
pub use stand_in::{Plugin, PortNames, StandIn, plugin_of_library, plugin_of_tab, plugins, stand_in};
pub use trust::{Origin, Trust};

/// What the [`component`] attribute writes code against; not for use by hand.
#[doc(hidden)]
pub mod parts {
    pub use inventory;
    pub use katydid_data::{Item, Kind, Tree, Value};
    pub use uuid::Uuid;

    pub use crate::input::Row;
    pub use crate::iterate::run;
    pub use crate::output::{EachItems, EachLists, EachTrees, Items, ItemsOrLists, ListOf, Lists, Trees};
    pub use crate::port::default_tree;
}
