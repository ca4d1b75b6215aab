use crate::Result;
use crate::archive::Chunk;
use crate::document::{Object, ids};

/// A Button.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Button {
    /// The expression it gives while nobody presses it.
    pub normal: String,
    /// The expression it gives while pressed.
    pub pressed: String,
}

impl Button {
    pub(super) fn read(container: &Chunk) -> Self {
        let text = |name, default: &str| container.str(name).unwrap_or(default).to_owned();
        Self { normal: text("ExpressionNormal", "False"), pressed: text("ExpressionPressed", "True") }
    }
}

/// The item that each kind of toggle keeps its state in.
const NAMES: [&str; 2] = ["ToggleValue", "SwitchValue"];

pub(super) fn read(container: &Chunk) -> Option<bool> {
    NAMES.iter().find_map(|name| container.bool(name))
}

impl Object {
    /// Turns a Boolean Toggle of either kind on or off.
    ///
    /// # Errors
    /// When the object is no Boolean Toggle.
    pub fn set_toggle(&mut self, on: bool) -> Result<()> {
        let name = match self.component {
            ids::BOOLEAN_TOGGLE => "ToggleValue",
            ids::BOOLEAN_TOGGLE_2 => "SwitchValue",
            _ => return Err(self.refuse("it is not a Boolean Toggle")),
        };
        self.container_mut().set(name, on);
        Ok(())
    }
}
