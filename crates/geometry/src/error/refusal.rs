//! Why a boolean gave no result.

use std::fmt;

use crate::Point3;

/// The kinds of cases that are refused rather than answered wrongly.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum RefusalClass {
    /// An operand is not closed, and has no inside.
    OpenOperand,
    /// What two faces do where they touch was not decided.
    Tangency,
    /// Two faces lie nearly upon each other, or overlap in a part that has no name.
    NearCoincidence,
    /// The search for common curves of two faces did not come to an end.
    Unfinished,
    /// The curves on a face do not divide it into regions.
    UnclosedSplit,
    /// Whether a region lies inside an operand was not decided.
    UndecidedPoint,
    /// The regions that were chosen do not close.
    Unclosed,
    /// The result failed the check of its parts.
    Unsound,
    /// Too many faces or pairs of faces.
    TooLarge,
}

impl RefusalClass {
    /// What it means, in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::OpenOperand => "an operand is not closed",
            Self::Tangency => "what the faces do where they touch is not decided",
            Self::NearCoincidence => "the faces lie nearly upon each other",
            Self::Unfinished => "the search for common curves did not come to an end",
            Self::UnclosedSplit => "the curves on the face do not divide it",
            Self::UndecidedPoint => "whether a part lies inside is not decided",
            Self::Unclosed => "the parts that belong to the result do not close",
            Self::Unsound => "the result would not be sound",
            Self::TooLarge => "there are too many faces",
        }
    }
}

/// A face of an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FaceName {
    /// The operand's place among all of the call.
    pub operand: usize,
    /// The face's place in the operand.
    pub face: usize,
}

/// A boolean that was refused: its class, the faces and the place.
#[derive(Debug, Clone, PartialEq)]
pub struct Refusal {
    /// The kind of case.
    pub class: RefusalClass,
    /// The faces that it is about.
    pub faces: Vec<FaceName>,
    /// A point where it is.
    pub place: Option<Point3>,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.class.words())?;
        write_where(f, &self.faces, self.place)
    }
}

/// Writes which faces something is about, and where it is.
pub(crate) fn write_where(
    f: &mut fmt::Formatter<'_>,
    faces: &[FaceName],
    place: Option<Point3>,
) -> fmt::Result {
    for (k, name) in faces.iter().enumerate() {
        let before = if k == 0 { ": " } else { " and " };
        write!(f, "{before}face {} of operand {}", name.face, name.operand)?;
    }
    if let Some(p) = place {
        write!(f, ", near ({:.6}, {:.6}, {:.6})", p.x, p.y, p.z)?;
    }
    Ok(())
}
