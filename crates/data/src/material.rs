use crate::Colour;

/// How a preview paints geometry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// The colour of the lit surface.
    pub diffuse: Colour,
    /// The colour of its highlights.
    pub specular: Colour,
    /// The colour it gives off without light.
    pub emission: Colour,
    /// 0 is opaque, 1 cannot be seen.
    pub transparency: f64,
    /// 0 is dull, 1 is polished.
    pub shine: f64,
}

impl From<Colour> for Material {
    /// A plain material of that colour; its alpha becomes transparency.
    fn from(colour: Colour) -> Self {
        Self {
            diffuse: Colour { a: 255, ..colour },
            specular: Colour::rgb(255, 255, 255),
            emission: Colour::default(),
            transparency: 1.0 - f64::from(colour.a) / 255.0,
            shine: 0.5,
        }
    }
}
