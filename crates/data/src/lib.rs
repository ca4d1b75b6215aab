//! What a wire carries: values, typed columns, data trees; how one type becomes another, and how a panel
//! shows each.
//!
//! A [`Tree`] is a list of branches with integer [`Path`]s. All branches together are one contiguous
//! [`Column`] of one type plus the branches' ends, as Arrow lays out a list array: flattening or grafting a
//! tree rewrites paths and ends and shares the items. Mixed lists fall back to a column of [`Value`]s. A null
//! holds its place in a list.
//!
//! ```
//! use katydid_data::{Path, Tree};
//! let tree: Tree = Tree::list(vec![1.0, 2.0, 3.0]);
//! assert_eq!(tree.branch_count(), 1);
//! let grafted = tree.graft();
//! assert_eq!(grafted.paths()[2], Path::from([0, 2]));
//! ```

mod brep;
pub mod cast;
mod colour;
mod column;
mod complex;
mod compound;
mod content;
mod domain2;
mod face;
pub mod formula;
mod group;
mod item;
mod kind;
mod location;
mod loft_options;
mod material;
mod mesh_settings;
mod path;
mod projection;
mod quad_settings;
mod run;
mod symbol;
pub mod text;
mod time;
mod transform;
mod tree;
mod tree_shape;
pub mod units;
mod value;
mod weight;

pub use colour::Colour;
pub use column::{Column, Items};
pub use complex::Complex;
pub use compound::Compound;
pub use content::{
    Atom, BlockDefinition, BlockInstance, Content, Filter, Keeper, ModelLayer, ModelLinetype, ModelMaterial,
    ModelObject, Token, Visibility,
};
pub use domain2::Domain2;
pub use face::Face;
pub use group::Group;
pub use item::{Geometry, Item};
pub use kind::Kind;
pub use location::Location;
pub use loft_options::LoftOptions;
pub use material::Material;
pub use mesh_settings::MeshSettings;
pub use path::{ParsePathError, Path};
pub use projection::Projection;
pub use quad_settings::QuadSettings;
pub use run::{Gather, Run, ValueRun};
pub use symbol::Symbol;
pub use time::DateTime;
pub use transform::TransformError;
pub use tree::{Branch, Tree, TreeBuilder};
pub use value::Value;
