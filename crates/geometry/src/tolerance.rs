use crate::{Error, Result};

/// How near is near enough.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Distance in model units.
    pub absolute: f64,
    /// Angle in radians.
    pub angle: f64,
}

impl Default for Tolerance {
    /// 0.001 units and 1°, what a definition gets when nobody says otherwise.
    fn default() -> Self {
        Self { absolute: 0.001, angle: std::f64::consts::PI / 180.0 }
    }
}

impl Tolerance {
    /// The distance, for work that cannot do without one.
    ///
    /// # Errors
    /// It is not greater than 0, or NaN.
    pub(crate) fn positive_distance(&self) -> Result<f64> {
        let value = self.absolute;
        if value > 0.0 {
            Ok(value)
        } else {
            Err(Error::OutOfRange { what: "tolerance", value, must: "greater than 0" })
        }
    }
}
