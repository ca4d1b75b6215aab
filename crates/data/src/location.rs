/// A place on the globe.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Location {
    /// Degrees east of Greenwich; negative to the west.
    pub longitude: f64,
    /// Degrees north of the equator; negative to the south.
    pub latitude: f64,
}
