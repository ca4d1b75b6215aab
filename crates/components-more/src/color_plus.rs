//! ColorPlus: gradients and swatches.
//!
//! Its palettes are tables of its author's choice, which no file holds: they are not supported.

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
}
