//! Conversions to and from the types of other crates, behind features of their names.

#[cfg(feature = "glam")]
mod from_glam;
#[cfg(feature = "nalgebra")]
mod from_nalgebra;
