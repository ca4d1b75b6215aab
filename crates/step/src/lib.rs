//! STEP files: exact geometry for other programs, written and read.
//!
//! A [`Document`] is what a file holds: points, curves and breps with names, colours and layers, in one unit.
//! [`write()`] makes an exchange structure (ISO 10303-21) of the schema AP214; [`read()`] takes those of AP203, AP214
//! and AP242. Assemblies are read flat: every part where it stands.
//!
//! What belongs here: the file format, and the way between its entities and the kernel's types. Shapes and their
//! computation are [`katydid_geometry`]'s. Files that nobody vouches for give an [`Error`] that names the entity, never
//! a panic, and no count in them makes room for more than their bytes can fill.
//!
//! ```
//! use katydid_geometry::{Brep, Point3, Sphere};
//! use katydid_step::{Document, Part, Shape, read, write};
//!
//! let ball = Brep::from_surface(Sphere::around(Point3::ORIGIN, 5.0)?.into())?;
//! let mut document = Document::default();
//! document.parts.push(Part::named("ball", Shape::Brep(ball.into())));
//! let mut file = Vec::new();
//! assert!(write(&document, &mut file)?.is_empty());
//! let again = read(&file)?;
//! assert_eq!(again.parts[0].name, "ball");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod document;
mod error;
mod part21;
mod read;
mod write;

pub use document::{Document, LeftOut, Part, Shape};
pub use error::{Error, Result};
pub use read::{Limits, read, read_with};
pub use write::write;
