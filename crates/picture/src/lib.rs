//! Pictures of a solved definition: of what it makes ([`result`]), and of the definition itself on its canvas
//! ([`canvas`]).
//!
//! Both give a [`Drawing`], a list of outlines, texts and faces in pixels, which is written as SVG or PNG. A result
//! goes from the solver's values to a scene in the model's space, through a camera to the picture's; what hides what is
//! found when the file is written: by the painter's order with faces split where they cross for SVG, by a depth buffer
//! for PNG. No GPU, no window, no fonts of the machine: the same input gives the same bytes.
//!
//! ```
//! use katydid_definition::document::Document;
//! use katydid_picture::{Options, result};
//! use katydid_solver::Engine;
//!
//! let mut engine = Engine::new(Document::new(), Default::default());
//! engine.solve();
//! let picture = result(&engine, &Options::default());
//! assert!(picture.is_empty);
//! assert!(picture.drawing.to_svg().starts_with("<svg"));
//! ```

#![allow(
    clippy::needless_range_loop,
    clippy::neg_cmp_op_on_partial_ord,
    reason = "coordinates read best with indices; !(x > limit) is how a NaN is refused together with the too small"
)]

mod camera;
mod canvas;
mod clip;
pub mod drawing;
mod error;
mod font;
mod hidden;
mod order;
mod project;
mod raster;
mod result;
mod svg;

use katydid_data::Colour;

pub use camera::View;
pub use canvas::canvas;
pub use drawing::Drawing;
pub use error::Error;
pub use result::{Paint, Picture, result, result_with};

/// How a picture is made.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Where to look from; when not given, from above where everything lies on a plane of equal height, else in
    /// perspective.
    pub view: Option<View>,
    /// Whether the axes are drawn: lines through the origin, and arrows in a corner.
    pub axes: bool,
    /// Whether a grid is drawn.
    pub grid: bool,
    /// Whether the colours of gradients are explained.
    pub legend: bool,
    /// What becomes of the stretches of lines that lie behind faces.
    pub hidden_lines: HiddenLines,
    /// The colour of the ground; none for a clear one.
    pub background: Option<Colour>,
    /// The title; the definition's own name when it is empty.
    pub title: String,
}

/// What becomes of the stretches of lines that lie behind faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum HiddenLines {
    /// They shine through clear faces, and opaque ones hide them.
    #[default]
    Natural,
    /// They are left out, behind clear faces too.
    Hide,
    /// They are dashed, behind opaque faces too.
    Dash,
    /// They are drawn as if there were no faces.
    Show,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            size: [1200, 800],
            view: None,
            axes: false,
            grid: false,
            legend: false,
            hidden_lines: HiddenLines::default(),
            background: Some(Colour::rgb(255, 255, 255)),
            title: String::new(),
        }
    }
}

impl Drawing {
    /// The picture as SVG.
    pub fn to_svg(&self) -> String {
        svg::write(self)
    }

    /// The picture as PNG.
    ///
    /// # Errors
    /// The picture is not at least a pixel large, or larger than 16 384 pixels each way or 134 million in all.
    pub fn to_png(&self) -> Result<Vec<u8>, Error> {
        raster::png(self)
    }
}
