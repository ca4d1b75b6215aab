//! Swatches, pickers and gradients.

use katydid_component::{Context, Message, component};
use katydid_data::{Colour, Tree};
use katydid_definition::archive;

fn colour(stored: archive::Colour) -> Colour {
    Colour { a: stored.a, r: stored.r, g: stored.g, b: stored.b }
}

fn missing() -> Message {
    Message::error("No colour is stored in this object")
}

/// A colour.
#[component(
    "9c53bac0-ba66-40bd-8154-ce9829b9db1a",
    name = "Colour Swatch",
    nick = "Swatch",
    at = "Params/Input",
    floating
)]
#[output("Colour", "C", "The colour.")]
fn colour_swatch(
    context: &Context<'_>,
    /// Not used: the colour is stored in the swatch.
    #[port("Colour", "C", optional, kind = Colour)]
    _data: &Tree,
) -> Result<Colour, Message> {
    context.settings().colour("SwatchColor").map(colour).ok_or_else(missing)
}

/// A colour, put together from its parts by hand.
#[component(
    "339c0ee1-cf11-444f-8e10-65c9150ea755",
    name = "Colour Picker",
    nick = "Colour",
    at = "Params/Input",
    floating
)]
#[output("Colour", "C", "The colour.")]
fn colour_picker(
    context: &Context<'_>,
    /// Not used: the colour is stored in the picker.
    #[port("Colour", "C", optional, kind = Colour)]
    _data: &Tree,
) -> Result<Colour, Message> {
    context.settings().colour("PickedColour").map(colour).ok_or_else(missing)
}

/// A place in a gradient with its colours to the left and to the right.
struct Grip {
    at: f64,
    left: Colour,
    right: Colour,
}

/// The colours of a gradient: constant outside its grips, blended between them.
struct Blend {
    grips: Vec<Grip>,
    linear: bool,
}

impl Blend {
    fn read(context: &Context<'_>) -> Result<Self, Message> {
        let chunk = context.settings().child("Gradient").ok_or_else(missing)?;
        let grip = |grip: &archive::Chunk| {
            let left = grip.colour_at("Colour", 0)?;
            let right = grip.colour_at("Colour", 1).unwrap_or(left);
            Some(Grip { at: grip.f64("Factor")?, left: colour(left), right: colour(right) })
        };
        let mut grips: Vec<Grip> = chunk.children("Grip").into_iter().filter_map(grip).collect();
        grips.sort_by(|a, b| a.at.total_cmp(&b.at));
        Ok(Self { grips, linear: chunk.bool("Linear").unwrap_or(false) })
    }

    fn at(&self, t: f64) -> Option<Colour> {
        let after = self.grips.partition_point(|grip| grip.at <= t);
        let (before, after) = (after.checked_sub(1).and_then(|k| self.grips.get(k)), self.grips.get(after));
        let (a, b) = match (before, after) {
            (Some(a), Some(b)) => (a, b),
            (None, Some(first)) => return Some(first.left),
            (Some(last), None) => return Some(last.right),
            (None, None) => return None,
        };
        let x = (t - a.at) / (b.at - a.at);
        let x = if self.linear { x } else { x * x * (3.0 - 2.0 * x) };
        let mix = |a: u8, b: u8| (f64::from(a) + x * (f64::from(b) - f64::from(a))).round() as u8;
        let (a, b) = (a.right, b.left);
        Some(Colour { a: mix(a.a, b.a), r: mix(a.r, b.r), g: mix(a.g, b.g), b: mix(a.b, b.b) })
    }
}

/// Gives the colour that a number has in a gradient between two limits; beyond them it is that of the limit.
#[component(
    "6da9f120-3ad0-4b6e-9fe0-f8cde3a649b7",
    name = "Gradient",
    nick = "Gradient",
    at = "Params/Input"
)]
#[output("Colour", "C", "The colour.")]
fn gradient(
    context: &Context<'_>,
    /// The number at the gradient's left end.
    #[port("Lower limit", "L0", default = 0.0)]
    lower: f64,
    /// The number at the gradient's right end; it may be the smaller one.
    #[port("Upper limit", "L1", default = 1.0)]
    upper: f64,
    /// The number to find the colour of.
    #[port("Parameter", "t")]
    t: f64,
) -> Result<Option<Colour>, Message> {
    let blend = context.prepared(|| Blend::read(context))?;
    let x = if lower == upper { f64::from(u8::from(t > lower)) } else { (t - lower) / (upper - lower) };
    Ok(blend.at(if x.is_nan() { 0.0 } else { x.clamp(0.0, 1.0) }))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_definition::archive::{Chunk, Colour};

    #[test]
    fn colours_are_stored() {
        let red = Colour::new(255, 200, 10, 0);
        assert_eq!(Trial::of("Colour Swatch").setting("SwatchColor", red).texts(0), ["{0}: 200,10,0"]);
        let clear = Colour::new(120, 200, 10, 0);
        assert_eq!(
            Trial::of("Colour Picker").setting("PickedColour", clear).texts(0),
            ["{0}: 200,10,0 (120)"]
        );
        assert_eq!(Trial::of("Colour Swatch").message(), "No colour is stored in this object");
    }

    fn gradient(linear: bool) -> Chunk {
        let mut chunk = Chunk::new("Gradient");
        chunk.set("Linear", linear);
        for (k, (at, left, right)) in (0..).zip([(0.5, 100, 200), (0.0, 0, 0), (1.0, 0, 50)]) {
            let mut grip = Chunk::indexed("Grip", k);
            grip.set("Factor", at);
            grip.set_at("Colour", 0, Colour::new(255, left, left, left));
            grip.set_at("Colour", 1, Colour::new(255, right, right, right));
            chunk.set_child(grip);
        }
        let mut settings = Chunk::default();
        settings.set_child(chunk);
        settings
    }

    #[test]
    fn gradients_blend_between_their_grips() {
        let at = |linear, limits: [f64; 2], t: f64| {
            let trial = Trial::of("Gradient").settings(gradient(linear));
            trial.item(limits[0]).item(limits[1]).item(t).texts(0).concat()
        };
        assert_eq!(at(true, [0.0, 10.0], 2.5), "{0}: 50,50,50");
        assert_eq!(at(true, [10.0, 0.0], 2.5), "{0}: 100,100,100");
        assert_eq!(at(true, [0.0, 1.0], 0.5), "{0}: 200,200,200");
        assert_eq!(at(true, [0.0, 1.0], 9.0), "{0}: 50,50,50");
        assert_eq!(at(true, [0.0, 1.0], -9.0), "{0}: 0,0,0");
        assert_eq!(at(false, [0.0, 1.0], 0.125), "{0}: 16,16,16");
        assert_eq!(at(true, [1.0, 1.0], 1.0), "{0}: 0,0,0");
    }
}
