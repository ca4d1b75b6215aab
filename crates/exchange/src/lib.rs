//! Geometry in other programs' files: OBJ, STL, PLY, glTF, GLB and STEP to read and write, SVG to write.
//!
//! A [`Scene`] is what is to be written: points, curves, meshes, areas and text with names, colours and layers, most often made of a
//! [`Model`](katydid_3dm::Model). [`write()`] sends it to any destination piece by piece, and tells what the format
//! could not hold. [`read()`] gives the scene that a file holds.
//!
//! Shapefiles ([`shp`]) and molecules ([`pdb`]) are no scenes, and are read as what they are.
//!
//! What belongs here: file formats and the way from a model to a scene. Shapes and their computation are
//! [`katydid_geometry`]'s. Files that nobody vouches for give an [`Error`], never a panic, and no count in them makes
//! room for more than their bytes can fill.
//!
//! ```
//! use katydid_exchange::{Format, Options, Scene, Shape, Thing, read, write};
//! use katydid_geometry::Point3;
//!
//! let mut scene = Scene::default();
//! scene.things.push(Thing::named("anchor", Shape::Points(vec![Point3::new(1.0, 2.0, 3.0)].into())));
//! let mut file = Vec::new();
//! let left_out = write(&scene, Format::Obj, &Options::default(), &mut file)?;
//! assert!(left_out.is_empty());
//! assert!(String::from_utf8_lossy(&file).contains("o anchor\nv 1 2 3\np 1\n"));
//! assert_eq!(read(&file, Format::Obj)?.things.len(), 1);
//! # Ok::<(), katydid_exchange::Error>(())
//! ```

mod error;
mod format;
mod gltf;
mod obj;
pub mod pdb;
mod piece;
mod ply;
mod scene;
pub mod shp;
mod step;
mod stl;
mod svg;
mod text;
mod view;

pub use error::{Error, Result};
pub use format::{Format, Options, needs_materials, read, read_with, write, write_materials};
pub use scene::{Conversion, Fill, Label, LabelSize, Layer, LeftOut, PointSet, Region, Scene, Shape, Thing};
pub use view::View;
