use crate::Colour;

/// How a point is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Symbol {
    /// The number of the shape, as Rhino counts point styles: 0 square, 2 active point, 3 cross, 4 circle and so on.
    pub style: i32,
    /// The size in pixels; of the inner shape too where it has one.
    pub size: [f64; 2],
    /// The turn in radians.
    pub rotation: f64,
    /// The colour inside.
    pub fill: Colour,
    /// The colour of the outline.
    pub edge: Colour,
    /// The width of the outline in pixels.
    pub width: f64,
    /// Whether sizes follow the resolution of the screen.
    pub adjust: bool,
}

impl Default for Symbol {
    /// A pink cross.
    fn default() -> Self {
        let pink = Colour::rgb(255, 105, 180);
        Self { style: 3, size: [12.0, 12.0], rotation: 0.0, fill: pink, edge: pink, width: 1.0, adjust: true }
    }
}
