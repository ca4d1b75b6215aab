//! Geometry in other programs' files: OBJ and STL for now.
//!
//! A [`Scene`] is what is to be written; [`write()`] gives the bytes, and says what the format cannot hold.
//!
//! ```
//! use katydid_exchange::{Format, Scene, Shape, Thing, write};
//! use katydid_geometry::Point3;
//!
//! let mut scene = Scene::default();
//! scene.things.push(Thing { name: "anchor".into(), shape: Shape::Point(Point3::new(1.0, 2.0, 3.0)) });
//! assert!(String::from_utf8(write(&scene, Format::Obj).bytes).unwrap().contains("v 1 2 3"));
//! ```

mod obj;
mod scene;
mod stl;

pub use scene::{Scene, Shape, Thing};

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Format {
    /// Wavefront OBJ: points, polylines, meshes.
    #[default]
    Obj,
    /// STL, binary: meshes as triangles.
    Stl,
}

impl Format {
    /// The format of files with that extension, without the dot and in lower case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        match extension {
            "obj" => Some(Self::Obj),
            "stl" => Some(Self::Stl),
            _ => None,
        }
    }
}

/// A file, and what is not in it.
#[derive(Debug, Clone, Default)]
pub struct Written {
    /// The bytes.
    pub bytes: Vec<u8>,
    /// What the format cannot hold, in words.
    pub left_out: Vec<String>,
}

/// The scene in that format.
pub fn write(scene: &Scene, format: Format) -> Written {
    match format {
        Format::Obj => obj::write(scene),
        Format::Stl => stl::write(scene),
    }
}
