//! Text and filled regions: what drawings show, and most formats of geometry do not hold.

use katydid_geometry::{Curve, Point3, Vector3, Xform};

/// Text that lies in a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The text; lines end in `\n`.
    pub text: String,
    /// The point it stands at.
    pub point: Point3,
    /// The direction in which it reads, and its upward direction. As long as the text is stretched: 1 for not at all.
    pub axes: [Vector3; 2],
    /// How large it is.
    pub size: LabelSize,
    /// Where the point is from left to right: 0 at the start of the lines, 1 at their end.
    pub across: f64,
    /// Where the point is from below: 0 at the foot of the last line, 1 at the top of the first.
    pub upward: f64,
    /// The face of its font; empty when none is known.
    pub font: String,
}

/// How large text is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LabelSize {
    /// The height of capital letters in the scene's units.
    Units(f64),
    /// Turned to the viewer, and of the same size wherever the eye is: a height in points of the screen.
    Screen(f64),
}

impl Label {
    /// Whether its numbers can be drawn.
    pub(crate) fn is_finite(&self) -> bool {
        let height = match self.size {
            LabelSize::Units(height) | LabelSize::Screen(height) => height,
        };
        let [right, up] = self.axes;
        self.point.is_finite() && right.is_finite() && up.is_finite() && height.is_finite() && height > 0.0
    }

    /// The text after a motion; nothing when its numbers overflow.
    pub(super) fn moved(&self, motion: &Xform) -> Option<Self> {
        let axes = match self.size {
            LabelSize::Units(_) => self.axes.map(|axis| motion.vector(axis)),
            LabelSize::Screen(_) => self.axes,
        };
        let moved = Self { point: motion.point(self.point), axes, ..self.clone() };
        moved.is_finite().then_some(moved)
    }
}

/// A region of a plane within closed curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// The curves that bound it. What lies within an odd number of them is inside.
    pub boundaries: Vec<Curve>,
    /// What it is filled with.
    pub fill: Fill,
}

/// What a region is filled with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fill {
    /// One colour.
    #[default]
    Solid,
    /// Lines or a gradient, for which a tint stands.
    Pattern,
}
