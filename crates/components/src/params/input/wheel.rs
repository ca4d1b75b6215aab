//! The colour wheel.

use std::f64::consts::TAU;

use katydid_component::{Context, Message, component};
use katydid_data::{Colour, Kind, Tree, TreeBuilder, Value, cast};
use katydid_definition::archive::Chunk;

use crate::display::colour::of_hsl;

/// A palette of colours that go together, from hues on a wheel.
///
/// Each number that comes in asks for as many colours; without one there is a colour for each hue. The colours take the
/// hues in turn; those of one hue go in even steps from the less to the more saturated and from the darker to the
/// lighter of the two limits that are stored. How Grasshopper makes its palette of them is not documented; the width of
/// the sectors, which is stored too, is left aside.
#[component(
    "51a2ede9-8f8c-4fdf-a375-999c2062eab7",
    name = "Colour Wheel",
    nick = "Wheel",
    at = "Params/Input",
    floating
)]
#[output("Colour Wheel", "Wheel", "The colours.", kind = Colour)]
fn colour_wheel(
    context: &Context<'_>,
    /// How many colours to give, at least 0.
    #[port("Colour Wheel", "Wheel", optional, kind = Integer)]
    data: &Tree,
) -> Result<Tree, Message> {
    let wheel = context
        .settings()
        .child("ColourGrips")
        .and_then(Wheel::read)
        .ok_or_else(|| Message::error("No colours are stored in this object"))?;
    let mut builder = TreeBuilder::<Value>::new();
    if data.is_empty() {
        builder.branch(context.path());
        wheel.colours(wheel.hues.len()).for_each(|c| builder.push(Some(c.into())));
    }
    for branch in data.branches() {
        builder.branch(branch.path().clone());
        for item in branch.iter() {
            let number = item.and_then(|item| cast::value(&item, Kind::Integer, context.rules()));
            let Some(Value::Integer(n)) = number else {
                builder.push(None);
                continue;
            };
            let count = usize::try_from(n).map_err(|_| Message::error("A palette has at least 0 colours"))?;
            context.items(count)?;
            wheel.colours(count).for_each(|c| builder.push(Some(c.into())));
        }
    }
    context.tell(Message::remark(
        "How the palette follows from the wheel is not documented: here its hues are taken in turn",
    ));
    Ok(builder.finish())
}

/// The hues on the wheel, and the limits of what is made of them.
struct Wheel {
    /// From 0 to 1 round the circle.
    hues: Vec<f64>,
    saturation: [f64; 2],
    luminance: [f64; 2],
}

impl Wheel {
    /// The grips are angles in radians. The style is ten times the number of hues in the one file that is known.
    fn read(chunk: &Chunk) -> Option<Self> {
        let grips: Vec<f64> = (0..4).map_while(|k| chunk.f64_at("Grip", k)).collect();
        let wanted = chunk.i32("Style").and_then(|style| usize::try_from(style / 10).ok());
        let count = wanted.filter(|n| (1..=grips.len()).contains(n)).unwrap_or(grips.len());
        let hues: Vec<f64> = grips.iter().take(count).map(|angle| (angle / TAU).rem_euclid(1.0)).collect();
        let limits = |name: &str| {
            let [low, high] = [0, 1].map(|k| chunk.f64_at(name, k));
            let pair = [low?, high?].map(|x| x.clamp(0.0, 1.0));
            pair.iter().all(|x| x.is_finite()).then_some(pair)
        };
        let sound = !hues.is_empty() && hues.iter().all(|hue| hue.is_finite());
        sound.then_some(())?;
        Some(Self { hues, saturation: limits("Sat")?, luminance: limits("Lum")? })
    }

    fn colours(&self, count: usize) -> impl Iterator<Item = Colour> {
        let rounds = count.div_ceil(self.hues.len());
        (0..count).map(move |k| {
            let (round, place) = (k / self.hues.len(), k % self.hues.len());
            let t = if rounds > 1 { round as f64 / (rounds - 1) as f64 } else { 0.5 };
            let [s, l] = [self.saturation, self.luminance].map(|[a, b]| a + t * (b - a));
            of_hsl(1.0, self.hues.get(place).copied().unwrap_or(0.0), s, l)
        })
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_definition::archive::Chunk;

    fn wheel() -> Chunk {
        let mut chunk = Chunk::new("ColourGrips");
        for (k, third) in (0..).zip([0.0, 1.0, 2.0]) {
            chunk.set_at("Grip", k, third * std::f64::consts::TAU / 3.0);
        }
        for (k, (low, high)) in (0..).zip([(1.0, 0.0), (1.0, 1.0)]) {
            chunk.set_at("Sat", k, low);
            chunk.set_at("Lum", k, high);
        }
        let mut settings = Chunk::default();
        chunk.set("Style", 30);
        settings.set_child(chunk);
        settings
    }

    #[test]
    fn hues_are_taken_in_turn() {
        let of = |n: i32| Trial::of("Colour Wheel").settings(wheel()).item(n).texts(0);
        assert_eq!(of(2), ["{0}: 255,0,0, 0,255,0"]);
        // From black to white, and back to the first hue.
        assert_eq!(of(6), ["{0}: 0,0,0, 0,0,0, 0,0,0, 255,255,255, 255,255,255, 255,255,255"]);
        assert_eq!(of(0), ["{0}:"]);
        assert_eq!(Trial::of("Colour Wheel").settings(wheel()).texts(0), ["{0}: 255,0,0, 0,255,0, 0,0,255"]);
        let negative = Trial::of("Colour Wheel").settings(wheel()).item(-1);
        assert!(negative.message().contains("at least 0"));
        assert!(Trial::of("Colour Wheel").item(1).message().contains("stored"));
    }
}
