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
