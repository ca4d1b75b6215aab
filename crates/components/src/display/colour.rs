//! Display / Colour: colours from their parts, and back.

use katydid_component::component;
use katydid_data::Colour;
use katydid_elementary::Elementary;

/// A part of 0 to 1 as a byte; what lies outside counts as the nearer end.
fn byte(x: f64) -> u8 {
    (x.clamp(0.0, 1.0) * 255.0).round() as u8
}

fn unit(x: u8) -> f64 {
    f64::from(x) / 255.0
}

fn colour(alpha: f64, [r, g, b]: [f64; 3]) -> Colour {
    Colour { a: byte(alpha), r: byte(r), g: byte(g), b: byte(b) }
}

/// The fully coloured part of a hue, 0 to 1 round the circle from red over green and blue.
pub(crate) fn of_hue(hue: f64) -> [f64; 3] {
    let sixth = 6.0 * hue.rem_euclid(1.0);
    let rise = |from: f64| (2.0 - (sixth - from).abs()).clamp(0.0, 1.0);
    // Red has its height at both ends of the circle.
    [rise(0.0).max(rise(6.0)), rise(2.0), rise(4.0)]
}

/// The hue of red, green and blue, 0 to 1 round the circle; that of a grey is 0.
pub(crate) fn hue_of([r, g, b]: [f64; 3]) -> f64 {
    let max = r.max(g).max(b);
    let range = max - r.min(g).min(b);
    let sixth = if range == 0.0 {
        0.0
    } else if max == r {
        (g - b) / range
    } else if max == g {
        2.0 + (b - r) / range
    } else {
        4.0 + (r - g) / range
    };
    (sixth / 6.0).rem_euclid(1.0)
}

/// The hue, the largest and the smallest part of a colour.
fn hue(colour: Colour) -> (f64, f64, f64) {
    let [r, g, b] = [colour.r, colour.g, colour.b].map(unit);
    (hue_of([r, g, b]), r.max(g).max(b), r.min(g).min(b))
}

/// The byte of a part of linear light, by the transfer curve of sRGB (IEC 61966-2-1).
fn encoded(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.raised_to(1.0 / 2.4) - 0.055 }
}

/// The colour of CIE stimuli, white being that of daylight (D65) with Y = 1.
fn of_xyz(alpha: f64, [x, y, z]: [f64; 3]) -> Colour {
    let r = 3.240_454_2 * x - 1.537_138_5 * y - 0.498_531_4 * z;
    let g = -0.969_266 * x + 1.876_010_8 * y + 0.041_556 * z;
    let b = 0.055_643_4 * x - 0.204_025_9 * y + 1.057_225_2 * z;
    colour(alpha, [r, g, b].map(encoded))
}

/// The colour of CIE L*a*b* values in their usual units, L* being 0 to 100.
fn of_lab(alpha: f64, [l, a, b]: [f64; 3]) -> Colour {
    // The inverse of the cube root with its straight start (CIE 15:2004).
    let stimulus =
        |f: f64| if f > 6.0 / 29.0 { f.powi(3) } else { 3.0 * (6.0f64 / 29.0).powi(2) * (f - 4.0 / 29.0) };
    let y = (l + 16.0) / 116.0;
    let [fx, fz] = [y + a / 500.0, y - b / 200.0];
    of_xyz(alpha, [0.950_47 * stimulus(fx), stimulus(y), 1.088_83 * stimulus(fz)])
}

/// Makes a colour of the CIE values L*, a* and b*, each divided by 100. What screens cannot show is the nearest they can.
#[component(
    "f922ed44-6e4a-44a0-8b4b-4b4a46bdfe29",
    name = "Colour L*ab",
    nick = "L*AB",
    at = "Display/Colour"
)]
#[output("Colour", "C", "The colour.")]
fn colour_lab(
    /// Opacity: 0 is clear, 1 solid.
    #[port("Alpha", "A", default = 1.0)]
    alpha: f64,
    /// Lightness, 0 to 1.
    #[port("Luminance", "L", default = 0.5)]
    luminance: f64,
    /// From green, -1, to red, 1.
    #[port("A", "A", default = 0.0)]
    a: f64,
    /// From blue, -1, to yellow, 1.
    #[port("B", "B", default = 0.0)]
    b: f64,
) -> Colour {
    of_lab(alpha, [luminance, a, b].map(|x| 100.0 * x))
}

/// Makes a colour of the CIE values lightness, chroma and hue. What screens cannot show is the nearest they can.
#[component("75a07554-8a2c-4d87-81b9-d854f498509d", name = "Colour LCH", nick = "LCH", at = "Display/Colour")]
#[output("Colour", "C", "The colour.")]
fn colour_lch(
    /// Opacity: 0 is clear, 1 solid.
    #[port("Alpha", "A", default = 1.0)]
    alpha: f64,
    /// Lightness, 0 to 1.
    #[port("Luminance", "L", default = 0.5)]
    luminance: f64,
    /// Strength of the colour, 0 to 1.
    #[port("Chroma", "C", default = 0.5)]
    chroma: f64,
    /// Hue, 0 to 1 round the circle.
    #[port("Hue", "H", default = 0.0)]
    hue: f64,
) -> Colour {
    let (sin, cos) = (std::f64::consts::TAU * hue).sine_cosine();
    of_lab(alpha, [luminance, chroma * cos, chroma * sin].map(|x| 100.0 * x))
}

/// Makes a colour of CIE 1931 stimuli. What screens cannot show is the nearest they can.
#[component("77185dc2-2f18-469d-9686-00f5b6049195", name = "Colour XYZ", nick = "XYZ", at = "Display/Colour")]
#[output("Colour", "C", "The colour.")]
fn colour_xyz(
    /// Opacity: 0 is clear, 1 solid.
    #[port("Alpha", "A", default = 1.0)]
    alpha: f64,
    /// The stimulus X, 0 to 1.
    #[port("X", "X", default = 0.5)]
    x: f64,
    /// The stimulus Y, which is the brightness, 0 to 1.
    #[port("Y", "Y", default = 0.5)]
    y: f64,
    /// The stimulus Z, 0 to 1.
    #[port("Z", "Z", default = 0.5)]
    z: f64,
) -> Colour {
    of_xyz(alpha, [x, y, z])
}

/// Adds two colours channel by channel; what is too bright is white.
#[component(
    "60327ca4-c548-40e6-a11f-3c6759582f13",
    name = "Addition",
    nick = "Add",
    at = "Display/Colour",
    old
)]
#[output("Colour", "C", "The sum.")]
fn addition_of_colours(
    /// One colour.
    #[port("Colour A", "A")]
    a: Colour,
    /// The other.
    #[port("Colour B", "B")]
    b: Colour,
) -> Colour {
    let sum = |a: u8, b: u8| a.saturating_add(b);
    Colour { a: sum(a.a, b.a), r: sum(a.r, b.r), g: sum(a.g, b.g), b: sum(a.b, b.b) }
}

/// A colour between two, or beyond them, channel by channel.
#[component(
    "8b4da37d-1124-436a-9de2-952e4224a220",
    name = "Blend Colours",
    nick = "BlendCol",
    at = "Vector/Colour"
)]
#[output("Colour", "C", "The colour.")]
fn blend_colours(
    /// The colour at 0.
    #[port("Colour A", "A")]
    a: Colour,
    /// The colour at 1.
    #[port("Colour B", "B")]
    b: Colour,
    /// Where between them.
    #[port("Factor", "F", default = 0.5)]
    factor: f64,
) -> Colour {
    let mix = |a: u8, b: u8| unit(a) + (unit(b) - unit(a)) * factor;
    colour(mix(a.a, b.a), [mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)])
}

/// Makes a colour of whole numbers from 0 to 255. Numbers outside count as the nearer end.
#[component("49d2e200-b34e-4e1c-82a3-07feb4cb9378", name = "Colour RGB", nick = "RGB", at = "Display/Colour")]
#[output("Colour", "C", "The colour.")]
fn colour_rgb(
    /// Opacity: 0 is clear, 255 solid.
    #[port("Alpha", "A", default = 255)]
    alpha: i32,
    /// Red.
    #[port("Red", "R", default = 0)]
    red: i32,
    /// Green.
    #[port("Green", "G", default = 0)]
    green: i32,
    /// Blue.
    #[port("Blue", "B", default = 0)]
    blue: i32,
) -> Colour {
    let byte = |x: i32| x.clamp(0, 255) as u8;
    Colour { a: byte(alpha), r: byte(red), g: byte(green), b: byte(blue) }
}

/// Makes a colour of numbers from 0 to 1. Numbers outside count as the nearer end.
#[component(
    "f35132c0-c298-4b9c-b446-42e960f52677",
    name = "Colour RGB (f)",
    nick = "fRGB",
    at = "Display/Colour"
)]
#[output("Colour", "C", "The colour.")]
fn colour_rgb_of_fractions(
    /// Opacity: 0 is clear, 1 solid.
    #[port("Alpha", "A", default = 1.0)]
    alpha: f64,
    /// Red.
    #[port("Red", "R", default = 0.0)]
    red: f64,
    /// Green.
    #[port("Green", "G", default = 0.0)]
    green: f64,
    /// Blue.
    #[port("Blue", "B", default = 0.0)]
    blue: f64,
) -> Colour {
    colour(alpha, [red, green, blue])
}

/// Makes a colour of hue, saturation and luminance, each from 0 to 1. The hue goes round: 1 is red as 0 is.
#[component("a45d68b3-c299-4b17-bdae-7975f216cec6", name = "Colour HSL", nick = "HSL", at = "Display/Colour")]
#[output("Colour", "C", "The colour.")]
fn colour_hsl(
    /// Opacity: 0 is clear, 1 solid.
    #[port("Alpha", "A", default = 1.0)]
    alpha: f64,
    /// Hue: 0 is red, a third green, two thirds blue.
    #[port("Hue", "H", default = 0.0)]
    hue: f64,
    /// Saturation: 0 is grey, 1 a full colour.
    #[port("Saturation", "S", default = 1.0)]
    saturation: f64,
    /// Luminance: 0 is black, 1 white, and between them the colour is at its fullest.
    #[port("Luminance", "L", default = 0.5)]
    luminance: f64,
) -> Colour {
    of_hsl(alpha, hue, saturation, luminance)
}

/// The colour of hue, saturation and luminance.
pub(crate) fn of_hsl(alpha: f64, hue: f64, saturation: f64, luminance: f64) -> Colour {
    let (s, l) = (saturation.clamp(0.0, 1.0), luminance.clamp(0.0, 1.0));
    let chroma = s * (1.0 - (2.0 * l - 1.0).abs());
    colour(alpha, of_hue(hue).map(|x| l + chroma * (x - 0.5)))
}

/// Makes a colour of hue, saturation and value, each from 0 to 1. The hue goes round: 1 is red as 0 is.
#[component("5958a658-20c2-4a2b-86ba-4d1b81bf5348", name = "Colour HSV", nick = "HSV", at = "Display/Colour")]
#[output("Colour", "C", "The colour.")]
fn colour_hsv(
    /// Opacity: 0 is clear, 1 solid.
    #[port("Alpha", "A", default = 1.0)]
    alpha: f64,
    /// Hue: 0 is red, a third green, two thirds blue.
    #[port("Hue", "H", default = 0.0)]
    hue: f64,
    /// Saturation: 0 is grey, 1 a full colour.
    #[port("Saturation", "S", default = 1.0)]
    saturation: f64,
    /// Value: 0 is black, 1 the colour at its brightest.
    #[port("Value", "V", default = 1.0)]
    value: f64,
) -> Colour {
    let (s, v) = (saturation.clamp(0.0, 1.0), value.clamp(0.0, 1.0));
    colour(alpha, of_hue(hue).map(|x| v * (1.0 - s * (1.0 - x))))
}

/// Makes a colour of printing inks, each from 0 to 1.
#[component(
    "17af01a5-a846-4769-9478-de1df65a0afa",
    name = "Colour CMYK",
    nick = "CMYK",
    at = "Display/Colour"
)]
#[output("Colour", "C", "The colour.")]
fn colour_cmyk(
    /// Cyan, which takes red away.
    #[port("Cyan", "C", default = 0.0)]
    cyan: f64,
    /// Magenta, which takes green away.
    #[port("Magenta", "M", default = 0.0)]
    magenta: f64,
    /// Yellow, which takes blue away.
    #[port("Yellow", "Y", default = 1.0)]
    yellow: f64,
    /// Black.
    #[port("Key", "K", default = 0.0)]
    key: f64,
) -> Colour {
    let left = |ink: f64| 1.0 - ink.clamp(0.0, 1.0);
    colour(1.0, [cyan, magenta, yellow].map(|ink| left(ink) * left(key)))
}

/// Takes a colour apart into numbers from 0 to 1.
#[component(
    "350f7d03-a48f-4121-bcee-328cfe1ed9ef",
    name = "Split ARGB",
    nick = "ARGB",
    at = "Display/Colour"
)]
#[output("Alpha", "A", "Opacity.")]
#[output("Red", "R", "Red.")]
#[output("Green", "G", "Green.")]
#[output("Blue", "B", "Blue.")]
fn split_argb(
    /// The colour.
    #[port("Colour", "C")]
    colour: Colour,
) -> (f64, f64, f64, f64) {
    (unit(colour.a), unit(colour.r), unit(colour.g), unit(colour.b))
}

/// Takes a colour apart into hue, saturation and luminance, each from 0 to 1. A grey has hue 0.
#[component(
    "0a1331c8-c58d-4b3f-a886-47051532e35e",
    name = "Split AHSL",
    nick = "AHSL",
    at = "Display/Colour"
)]
#[output("Alpha", "A", "Opacity.")]
#[output("Hue", "H", "Hue.")]
#[output("Saturation", "S", "Saturation.")]
#[output("Luminance", "L", "Luminance.")]
fn split_ahsl(
    /// The colour.
    #[port("Colour", "C")]
    colour: Colour,
) -> (f64, f64, f64, f64) {
    let (hue, max, min) = hue(colour);
    let luminance = 0.5 * (max + min);
    let most = 1.0 - (2.0 * luminance - 1.0).abs();
    let saturation = if max == min { 0.0 } else { (max - min) / most };
    (unit(colour.a), hue, saturation, luminance)
}

/// Takes a colour apart into hue, saturation and value, each from 0 to 1. A grey has hue 0.
#[component(
    "d84d2c2a-2813-4667-afb4-46642581e5f9",
    name = "Split AHSV",
    nick = "AHSV",
    at = "Display/Colour"
)]
#[output("Alpha", "A", "Opacity.")]
#[output("Hue", "H", "Hue.")]
#[output("Saturation", "S", "Saturation.")]
#[output("Value", "V", "Value.")]
fn split_ahsv(
    /// The colour.
    #[port("Colour", "C")]
    colour: Colour,
) -> (f64, f64, f64, f64) {
    let (hue, max, min) = hue(colour);
    let saturation = if max == 0.0 { 0.0 } else { (max - min) / max };
    (unit(colour.a), hue, saturation, max)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Colour, Value};

    fn made<const N: usize>(name: &str, parts: [f64; N]) -> String {
        parts.into_iter().fold(Trial::of(name), Trial::item).texts(0).concat().replace("{0}: ", "")
    }

    #[test]
    fn colours_from_their_parts() {
        assert_eq!(made("Colour RGB", [255.0, 300.0, -4.0, 7.0]), "255,0,7");
        assert_eq!(made("Colour RGB (f)", [0.0, 1.0, 0.5, 0.0]), "255,128,0 (0)");
        assert_eq!(made("Colour HSL", [1.0, 0.0, 1.0, 0.5]), "255,0,0");
        assert_eq!(made("Colour HSL", [1.0, 1.0 / 3.0, 1.0, 0.25]), "0,128,0");
        assert_eq!(made("Colour HSL", [1.0, 0.7, 0.0, 1.0]), "255,255,255");
        assert_eq!(made("Colour HSL", [1.0, 1.0 / 12.0, 1.0, 0.5]), "255,128,0");
        assert_eq!(made("Colour HSV", [1.0, -1.0 / 3.0, 0.5, 1.0]), "128,128,255");
        assert_eq!(made("Colour HSV", [1.0, 11.0 / 12.0, 1.0, 1.0]), "255,0,128");
        assert_eq!(made("Colour CMYK", [0.0, 0.0, 1.0, 0.0]), "255,255,0");
        assert_eq!(made("Colour CMYK", [0.0, 1.0, 0.0, 0.5]), "128,0,128");
    }

    #[test]
    fn colours_from_what_eyes_see() {
        // The CIE values of sRGB's white, red and blue for daylight (D65).
        assert_eq!(made("Colour XYZ", [1.0, 0.950_47, 1.0, 1.088_83]), "255,255,255");
        assert_eq!(made("Colour XYZ", [1.0, 0.412_456_4, 0.212_672_9, 0.019_333_9]), "255,0,0");
        assert_eq!(made("Colour L*ab", [1.0, 1.0, 0.0, 0.0]), "255,255,255");
        assert_eq!(made("Colour L*ab", [1.0, 0.532_408, 0.800_925, 0.672_032]), "255,0,0");
        assert_eq!(made("Colour L*ab", [0.0, 0.0, 0.0, 0.0]), "0,0,0 (0)");
        // Blue: L* 32.297, chroma 133.81, hue 306.285 degrees.
        assert_eq!(made("Colour LCH", [1.0, 0.322_97, 1.338_08, 306.285 / 360.0]), "0,0,255");
    }

    #[test]
    fn sums_and_blends() {
        let (a, b) = (Colour::rgb(200, 10, 0), Colour::rgb(100, 20, 0));
        let sum = Trial::of_guid("60327ca4-c548-40e6-a11f-3c6759582f13").item(a).item(b);
        assert_eq!(sum.texts(0), ["{0}: 255,30,0"]);
        let blend = |t: f64| Trial::of("Blend Colours").item(a).item(b).item(t).texts(0).concat();
        assert_eq!(
            [blend(0.0), blend(0.5), blend(-1.0)].join(" "),
            "{0}: 200,10,0 {0}: 150,15,0 {0}: 255,0,0"
        );
    }

    #[test]
    fn splitting_undoes_making() {
        for rgb in
            [[255, 0, 0], [10, 200, 30], [0, 0, 0], [255, 255, 255], [90, 12, 240], [7, 7, 7], [250, 3, 251]]
        {
            let colour = Colour::argb(51, rgb[0], rgb[1], rgb[2]);
            for (split, join) in
                [("Split ARGB", "Colour RGB (f)"), ("Split AHSL", "Colour HSL"), ("Split AHSV", "Colour HSV")]
            {
                let parts = Trial::of(split).item(colour).run().outputs;
                let joined = parts.into_iter().fold(Trial::of(join), Trial::tree).run();
                assert_eq!(joined.outputs[0].column().get(0), Some(Value::Colour(colour)), "{split}");
            }
        }
    }
}
