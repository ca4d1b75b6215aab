//! The extension module of the Python package `katydid`: definitions, their data, geometry, files, and the command line.
//!
//! What belongs here: the way between Python's objects and ours. What is computed is the kernel's, the solver's and the
//! session's business.

#![allow(
    clippy::needless_pass_by_value,
    clippy::trivially_copy_pass_by_ref,
    reason = "the macros of PyO3 hand arguments over by value, and ask for `&self`"
)]

mod arrays;
mod command;
mod definition;
mod errors;
mod files;
mod geometry;
mod host;
mod study;
mod values;
mod work;

use pyo3::prelude::*;

/// Counts the memory that solves take, so that their limits hold.
#[global_allocator]
static ALLOCATOR: katydid_memory::Counting = katydid_memory::Counting;

/// Definitions, geometry and files of Katydid. Use it through the package `katydid`.
#[pymodule]
mod _katydid {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::command::run_command;
    #[pymodule_export]
    use crate::definition::{
        Change, Definition, Input, Message, Output, Solution, diff, geometry_glb, geometry_picture,
    };
    #[pymodule_export]
    use crate::errors::{
        FileError, GeometryError, InputError, KatydidError, LimitError, NotSupportedError, SolveError,
    };
    #[pymodule_export]
    use crate::files::{Model, ModelObject, read, write};
    #[pymodule_export]
    use crate::geometry::{
        BoundingBox, Box, Brep, Curve, Interval, Mesh, Plane, Point, SubD, Surface, Transform, Vector, cone,
        cylinder, extrude, intersect, loft, pipe, planar_faces, rebuild, revolve, sphere, sweep, torus,
    };
    #[pymodule_export]
    use crate::host::Host;
    #[pymodule_export]
    use crate::study::{StudyCore, StudySolver};
    #[pymodule_export]
    use crate::values::{Colour, Item, Tree};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        katydid_components::link();
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
