//! Arithmetic of colours.

use katydid_data::Colour;
use katydid_definition::archive;

/// A colour between two, `t` of the way from the first; the alpha too.
pub fn blend(a: Colour, b: Colour, t: f64) -> Colour {
    let mix = |a: u8, b: u8| channel(f64::from(a) + (f64::from(b) - f64::from(a)) * t);
    Colour { a: mix(a.a, b.a), r: mix(a.r, b.r), g: mix(a.g, b.g), b: mix(a.b, b.b) }
}

/// A number as a channel of a colour.
pub fn channel(x: f64) -> u8 {
    // `as` takes what is outside, and NaN, to the nearest value of the type.
    x.round() as u8
}

/// A colour without transparency.
pub fn opaque(colour: Colour) -> Colour {
    Colour { a: 255, ..colour }
}

/// A colour of the archive as one of data.
pub fn of_archive(c: archive::Colour) -> Colour {
    Colour::argb(c.a, c.r, c.g, c.b)
}
