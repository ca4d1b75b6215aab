//! Refusals made.

use crate::error::{FaceName, Refusal, RefusalClass};
use crate::{Error, Point3, cancellation};

impl Refusal {
    /// A refusal about some faces at a place; where nobody waits any more, the work was stopped.
    pub(super) fn at(class: RefusalClass, faces: &[FaceName], place: Option<Point3>) -> Error {
        if cancellation::was_given_up() {
            return Error::Stopped;
        }
        Error::Refused(Box::new(Self { class, faces: faces.to_vec(), place }))
    }
}

impl RefusalClass {
    /// Whether what is refused may be places that are near each other by chance, so that a finer tolerance tells them apart.
    pub(super) fn may_be_chance(self) -> bool {
        matches!(self, Self::UnclosedSplit | Self::UndecidedPoint | Self::Unclosed | Self::Unsound)
    }
}
