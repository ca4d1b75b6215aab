//! ColorPlus: gradients, swatches, and colours mixed and written as numbers.
//!
//! Its palettes and sets are tables and numbers of modes of its author's choice, which neither files nor lists tell: they are not
//! supported.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Colour;

/// A colour between others at equal places, from 0 at the first to 1 at the last. Parts of red, green, blue and alpha are mixed
/// straight; other modes are not supported. Stands for ColorPlus's Construct Gradient; that Sample is the place to read is our
/// reading.
#[component(
    "444bf971-da2c-45cb-b4df-b8d24de02e71",
    name = "Construct Gradient",
    nick = "Gradient",
    at = "ColorPlus/Gradient"
)]
#[output("Color", "C", "The colour.")]
fn construct_gradient(
    context: &Context<'_>,
    /// The colours.
    #[port("Colors", "C")]
    colours: List<Colour>,
    /// Where each colour stands, from 0 to 1; at equal distances when there are none.
    #[port("Parameter", "P", optional)]
    places: List<f64>,
    /// Where to read, from 0 to 1.
    #[port("Sample", "S", default = 0.5)]
    samples: List<f64>,
    /// How colours are mixed: 0 straight; others are not supported.
    #[port("Interpolation Mode", "M", default = 0)]
    modes: List<i32>,
) -> Result<Vec<Colour>, Message> {
    if modes.iter().flatten().any(|mode| mode != 0) {
        context.tell(Message::remark("Not supported: other modes than 0; colours are mixed straight"));
    }
    let colours: Vec<Colour> = colours.iter().flatten().collect();
    let given: Vec<f64> = places.iter().flatten().collect();
    if colours.is_empty() {
        return Err(Message::error("There are no colours"));
    }
    if given.iter().any(|place| !place.is_finite()) {
        return Err(Message::error("A parameter is no finite number"));
    }
    let equal = given.len() != colours.len();
    if equal && !given.is_empty() {
        context.warn("There must be as many parameters as colours: they stand at equal distances");
    }
    let last = (colours.len() - 1).max(1) as f64;
    let place = |i: usize| if equal { i as f64 / last } else { given.get(i).copied().unwrap_or(1.0) };
    let mut stops: Vec<(f64, Colour)> = colours.iter().enumerate().map(|(i, c)| (place(i), *c)).collect();
    stops.sort_by(|a, b| a.0.total_cmp(&b.0));
    context.items(samples.len())?;
    samples.iter().flatten().map(|sample| read(&stops, sample)).collect()
}

/// The colour at a place of stops in order.
fn read(stops: &[(f64, Colour)], sample: f64) -> Result<Colour, Message> {
    if !sample.is_finite() {
        return Err(Message::error("A sample is no finite number"));
    }
    let next = stops.partition_point(|stop| stop.0 < sample);
    let before = next.checked_sub(1).and_then(|i| stops.get(i));
    Ok(match (before, stops.get(next)) {
        (Some(&(s, a)), Some(&(t, b))) => {
            let part = (sample - s) / (t - s);
            let mix = |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * part).round() as u8;
            Colour { a: mix(a.a, b.a), r: mix(a.r, b.r), g: mix(a.g, b.g), b: mix(a.b, b.b) }
        }
        (Some(&(_, only)), None) | (None, Some(&(_, only))) => only,
        (None, None) => return Err(Message::error("There are no colours")),
    })
}

/// The mean of each channel of some colours. Stands for ColorPlus's Average Colors.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3c01",
    name = "Average Colors",
    nick = "AvgClr",
    at = "ColorPlus/Colour"
)]
#[output("Color", "C", "The mean.")]
fn average_colors(
    /// The colours.
    #[port("Colors", "C")]
    colours: List<Colour>,
) -> Result<Colour, Message> {
    let (mut sums, mut count) = ([0_u64; 4], 0_u64);
    for colour in colours.present() {
        count += 1;
        for (sum, channel) in sums.iter_mut().zip([colour.a, colour.r, colour.g, colour.b]) {
            *sum += u64::from(channel);
        }
    }
    if count == 0 {
        return Err(Message::error("There are no colours"));
    }
    let [a, r, g, b] = sums.map(|sum| u8::try_from((2 * sum + count) / (2 * count)).unwrap_or(u8::MAX));
    Ok(Colour { a, r, g, b })
}

/// A colour between two, channel by channel. Stands for ColorPlus's Tween Colors.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3c02",
    name = "Tween Colors",
    nick = "TweenClr",
    at = "ColorPlus/Colour"
)]
#[output("Color", "C", "The colour.")]
fn tween_colors(
    /// What 0 gives.
    #[port("Source", "S")]
    source: Colour,
    /// What 1 gives.
    #[port("Target", "T")]
    target: Colour,
    /// From 0 to 1; what lies beyond gives the nearer of the two.
    #[port("Parameter", "P", default = 0.5)]
    parameter: f64,
) -> Result<Colour, Message> {
    read(&[(0.0, source), (1.0, target)], parameter)
}

/// The opposite of a colour: each of red, green and blue becomes what it lacks of 255. Stands for ColorPlus's Invert Color.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3c03",
    name = "Invert Color",
    nick = "Invert",
    at = "ColorPlus/Colour"
)]
#[output("Color", "C", "The opposite, as opaque.")]
fn invert_color(
    /// The colour.
    #[port("Color", "C")]
    colour: Colour,
) -> Colour {
    Colour { a: colour.a, r: 255 - colour.r, g: 255 - colour.g, b: 255 - colour.b }
}

/// A colour as pages of the web write it: #RRGGBB, two digits to the base 16 for each of red, green and blue. Stands for ColorPlus's To
/// Hex; that opacity is left out is our reading.
#[component("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3c04", name = "To Hex", nick = "ToHex", at = "ColorPlus/Colour")]
#[output("Hex", "H", "The text.")]
fn to_hex(
    /// The colour.
    #[port("Color", "C")]
    colour: Colour,
) -> Shared<str> {
    format!("#{:02X}{:02X}{:02X}", colour.r, colour.g, colour.b).into()
}

/// A colour as one number, as OLE has it: red and 256 times green and 65536 times blue. Stands for ColorPlus's To Ole.
#[component("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3c05", name = "To Ole", nick = "ToOle", at = "ColorPlus/Colour")]
#[output("Integer", "I", "The number, from 0 to 16777215.")]
fn to_ole(
    /// The colour.
    #[port("Color", "C")]
    colour: Colour,
) -> i32 {
    i32::from_be_bytes([0, colour.b, colour.g, colour.r])
}

/// The opaque colour of a number, as OLE has it: red and 256 times green and 65536 times blue. Stands for ColorPlus's Colour Ole.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3c06",
    name = "Colour Ole",
    nick = "Ole",
    at = "ColorPlus/Colour"
)]
#[output("Color", "C", "The colour.")]
fn colour_ole(
    /// The number, from 0 to 16777215.
    #[port("Integer", "I")]
    number: i32,
) -> Result<Colour, Message> {
    match number.to_be_bytes() {
        [0, b, g, r] => Ok(Colour::rgb(r, g, b)),
        _ => Err(Message::error(format!("The number is {number}: it must be from 0 to 16777215"))),
    }
}

/// Shows colours one below the other on the canvas of the plug-in; here a panel shows them. Stands for ColorPlus's Itemize Colors.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3c07",
    name = "Itemize Colors",
    nick = "ClrItems",
    at = "ColorPlus/Preview"
)]
fn itemize_colors(
    /// The colours.
    #[port("Colors", "C", optional)]
    _colours: List<Colour>,
) {
}

/// Shows colours on the canvas of the plug-in; here a panel shows them. Stands for ColorPlus's Preview Colors.
#[component(
    "b87a9170-582b-4676-8afd-1c88a4de559d",
    name = "Preview Colors",
    nick = "Preview",
    at = "ColorPlus/Preview"
)]
fn preview_colors(
    /// The colours.
    #[port("Colors", "C", optional)]
    _colours: List<Colour>,
) {
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Colour;

    #[test]
    fn colours_between_colours() {
        let trial = |samples: [f64; 4]| {
            let colours = [Colour::rgb(0, 0, 0), Colour::rgb(100, 0, 0), Colour::rgb(100, 200, 0)];
            Trial::of("Construct Gradient").list(colours).default().list(samples).texts(0)
        };
        assert_eq!(trial([0.0, 0.25, 0.75, 2.0]), ["{0}: 0,0,0, 50,0,0, 100,100,0, 100,200,0"]);
    }

    #[test]
    fn places_of_colours() {
        let colours = [Colour::rgb(0, 0, 0), Colour::rgb(100, 0, 0)];
        let trial = || Trial::of("Construct Gradient").list(colours).list([0.5, 1.0]);
        assert_eq!(trial().list([0.25, 0.75]).texts(0), ["{0}: 0,0,0, 50,0,0"]);
        assert!(trial().list([f64::NAN]).message().contains("finite"));
    }

    #[test]
    fn colours_are_mixed() {
        let of = |colours: &[Colour]| Trial::of("Average Colors").list(colours.to_vec());
        let [black, red] = [Colour::rgb(0, 0, 0), Colour::rgb(255, 10, 0)];
        assert_eq!(of(&[black, red]).texts(0), ["{0}: 128,5,0"]);
        assert_eq!(of(&[black, black, red]).texts(0), ["{0}: 85,3,0"]);
        assert_eq!(of(&[red]).texts(0), ["{0}: 255,10,0"]);
        let none: [Option<Colour>; 1] = [None];
        assert_eq!(Trial::of("Average Colors").gaps(none).message(), "There are no colours");
        let tween = |at: f64| Trial::of("Tween Colors").item(black).item(Colour::rgb(200, 100, 0)).item(at);
        assert_eq!(tween(0.25).texts(0), ["{0}: 50,25,0"]);
        assert_eq!(tween(-1.0).texts(0), ["{0}: 0,0,0"]);
        assert_eq!(tween(2.0).texts(0), ["{0}: 200,100,0"]);
        assert!(tween(f64::NAN).message().contains("finite"));
        assert_eq!(Trial::of("Invert Color").item(red).texts(0), ["{0}: 0,245,255"]);
    }

    #[test]
    fn colours_as_texts_and_numbers() {
        assert_eq!(Trial::of("To Hex").item(Colour::rgb(255, 10, 0)).texts(0), ["{0}: #FF0A00"]);
        assert_eq!(Trial::of("To Ole").item(Colour::rgb(1, 2, 3)).texts(0), ["{0}: 197121"]);
        assert_eq!(Trial::of("To Ole").item(Colour::rgb(255, 255, 255)).texts(0), ["{0}: 16777215"]);
        let back = |number: i32| Trial::of("Colour Ole").item(number);
        assert_eq!(back(197_121).texts(0), ["{0}: 1,2,3"]);
        assert_eq!(back(0).texts(0), ["{0}: 0,0,0"]);
        for number in [-1, 16_777_216, i32::MIN] {
            assert!(back(number).message().contains("from 0 to 16777215"), "{number}");
        }
    }
}
