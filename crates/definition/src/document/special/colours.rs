use crate::Result;
use crate::archive::{Chunk, Colour};
use crate::document::{Object, ids};

/// The colours of a Gradient.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradient {
    /// The grips, in the file's order.
    pub grips: Vec<Grip>,
    /// Whether colours between grips change evenly; else smoothly.
    pub linear: bool,
    /// Whether the grips are locked on the canvas.
    pub locked: bool,
}

/// A place in a [`Gradient`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grip {
    /// Where, from 0 at the left to 1 at the right.
    pub at: f64,
    /// The colour just left of it.
    pub left: Colour,
    /// The colour just right of it.
    pub right: Colour,
}

impl Gradient {
    pub(super) fn read(container: &Chunk) -> Option<Self> {
        let chunk = container.child("Gradient")?;
        let grip = |grip: &Chunk| {
            let left = grip.colour_at("Colour", 0)?;
            let right = grip.colour_at("Colour", 1).unwrap_or(left);
            Some(Grip { at: grip.f64("Factor")?, left, right })
        };
        Some(Self {
            grips: chunk.children("Grip").into_iter().filter_map(grip).collect(),
            linear: chunk.bool("Linear").unwrap_or(false),
            locked: chunk.bool("Locked").unwrap_or(false),
        })
    }
}

/// The colour of a swatch or picker.
pub(super) fn read(container: &Chunk) -> Option<Colour> {
    container.colour("SwatchColor").or_else(|| container.colour("PickedColour"))
}

impl Object {
    /// Gives a Colour Swatch or Colour Picker its colour.
    ///
    /// # Errors
    /// When the object is neither.
    pub fn set_colour(&mut self, colour: Colour) -> Result<()> {
        let name = match self.component {
            ids::COLOUR_SWATCH => "SwatchColor",
            ids::COLOUR_PICKER => "PickedColour",
            _ => return Err(self.refuse("it is not a Colour Swatch or Colour Picker")),
        };
        self.container_mut().set(name, colour);
        Ok(())
    }
}
