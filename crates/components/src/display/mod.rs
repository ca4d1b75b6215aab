//! The Display tab: colours, and what is drawn over the model.
//!
//! What only draws gives no data: such components take their inputs and leave the drawing to the viewer.

mod annotation;
pub(crate) mod colour;
mod dimensions;
mod drawing;
mod graphs;
mod preview;
mod symbol;
mod vector;

pub(crate) use colour::{hue_of, of_hue};
