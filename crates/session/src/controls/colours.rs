//! The Colour Swatch, the Colour Picker and the Gradient.

use katydid_definition::archive::{Chunk, Colour as Argb};
use katydid_definition::document::{Object, Special, ids};
use katydid_definition::kd;
use uuid::Uuid;

use super::list::MOST_ITEMS;
use super::{FACE, Row, argb, colour, finite, part, unfit};
use crate::Refusal;
use crate::protocol::{Colour, Control, GripView};

pub(super) const SWATCH: Row = Row {
    components: &[ids::COLOUR_SWATCH],
    begin: |container| container.set("SwatchColor", Argb::new(255, 255, 255, 255)),
    view: |_, special| match special {
        Special::Colour(c) => Some(Control::Swatch { colour: colour(c) }),
        _ => None,
    },
    shape: |object, control| {
        let Control::Swatch { colour } = control else { return Ok(false) };
        object.set_colour(argb(*colour))?;
        Ok(true)
    },
    size: |_, title| Some([title + 52.0, 20.0]),
    ..FACE
};

pub(super) const PICKER: Row = Row {
    components: &[ids::COLOUR_PICKER],
    is_set_by_hand: true,
    begin: |container| container.set("PickedColour", Argb::new(255, 0, 0, 0)),
    ..SWATCH
};

pub(super) const GRADIENT: Row = Row {
    components: &[ids::GRADIENT],
    begin: |container| {
        begin(container, &[(0.0, [255, 0, 0, 255]), (0.5, [255, 255, 0, 255]), (1.0, [0, 255, 0, 255])]);
    },
    view: |_, special| {
        let Special::Gradient(gradient) = special else { return None };
        let grips = gradient.grips.iter();
        Some(Control::Gradient {
            grips: grips
                .map(|grip| GripView { at: grip.at, left: colour(grip.left), right: colour(grip.right) })
                .collect(),
            linear: gradient.linear,
        })
    },
    shape: |object, control| {
        let Control::Gradient { grips, linear } = control else { return Ok(false) };
        shape(object, grips, *linear)
    },
    size: |_, _| Some([250.0, 64.0]),
    ..FACE
};

fn shape(object: &mut Object, grips: &[GripView], linear: bool) -> Result<bool, Refusal> {
    let at: Vec<f64> = grips.iter().map(|grip| grip.at).collect();
    finite(&at)?;
    if grips.len() > MOST_ITEMS {
        return Err(unfit(object, "a gradient has at most ten thousand grips"));
    }
    let gradient = part(object, "Gradient")?;
    let old: Vec<Chunk> = gradient.children("Grip").into_iter().cloned().collect();
    gradient.remove_children("Grip");
    for (k, grip) in grips.iter().enumerate() {
        // Grips have ids of their own, which stay.
        let index = i32::try_from(k).unwrap_or(i32::MAX);
        let mut chunk = old.get(k).cloned().unwrap_or_else(|| Chunk::new("Grip"));
        chunk.index = Some(index);
        if chunk.guid("Id").is_none() {
            chunk.set("Id", kd::derived_id(Uuid::nil(), &format!("grip {k}")));
        }
        chunk.set("Factor", grip.at.clamp(0.0, 1.0));
        chunk.set_at("Colour", 0, argb(grip.left));
        chunk.set_at("Colour", 1, argb(grip.right));
        gradient.set_child(chunk);
    }
    gradient.set("GripCount", i32::try_from(grips.len()).unwrap_or(i32::MAX));
    gradient.set("Linear", linear);
    Ok(true)
}

/// A new gradient: places and colours.
fn begin(container: &mut Chunk, grips: &[(f64, Colour)]) {
    let mut gradient = Chunk::new("Gradient");
    gradient.set("GripCount", i32::try_from(grips.len()).unwrap_or(0));
    gradient.set("Linear", true);
    gradient.set("Locked", false);
    for (k, (at, colour)) in (0..).zip(grips) {
        let mut grip = Chunk::indexed("Grip", k);
        grip.set("Factor", *at);
        grip.set("Id", kd::derived_id(Uuid::nil(), &format!("grip {k}")));
        grip.set_at("Colour", 0, argb(*colour));
        grip.set_at("Colour", 1, argb(*colour));
        gradient.set_child(grip);
    }
    container.set_child(gradient);
}
