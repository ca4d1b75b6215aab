//! Every surface as one NURBS surface.

use super::Surface;
use crate::{NurbsSurface, Result};

impl Surface {
    /// The exact NURBS form over the same domains. Where a circle is involved, only the joints and middles of its
    /// spans keep their parameters.
    ///
    /// # Errors
    /// A degenerate profile, or a number overflows.
    pub fn to_nurbs(&self) -> Result<NurbsSurface> {
        match self {
            Self::Plane(s) => s.to_nurbs(),
            Self::Sum(s) => s.to_nurbs(),
            Self::Revolution(s) => s.to_nurbs(),
            Self::Nurbs(s) => Ok(s.clone()),
        }
    }
}
