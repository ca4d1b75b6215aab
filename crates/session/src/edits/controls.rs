//! Sliders, panels, lists and all else that has a face of its own.

use katydid_definition::document::{Object, ids};

use super::{bounded, objects, scripts};
use crate::Refusal;
use crate::controls::{self, argb, finite, short, unfit};
use crate::editor::Draft;
use crate::protocol::{Control, Setting};
use crate::view::size;

/// Gives a control a new value.
pub(super) fn set(draft: &mut Draft<'_>, id: uuid::Uuid, to: &Setting) -> Result<(), Refusal> {
    let object = draft.object(id)?;
    let before = object.clone();
    match to {
        Setting::Number { value } => {
            finite(&[*value])?;
            match object.component {
                ids::NUMBER_SLIDER => object.set_slider(*value).map(drop)?,
                _ => controls::turn(object, *value)?,
            }
        }
        Setting::Text { text } => object.set_panel_text(short(text)?)?,
        Setting::Switch { on } => object.set_toggle(*on)?,
        // The session keeps this for as long as the button is held: nothing of the document changes.
        Setting::Press { .. } if object.component == ids::BUTTON => {}
        Setting::Press { .. } => return Err(unfit(object, "it is not a Button")),
        // The same for as long as a particle is dragged.
        Setting::Grab { .. } if ids::GRABS.contains(&object.component) => {}
        Setting::Grab { .. } => return Err(unfit(object, "it is not a Grab")),
        Setting::Choose { chosen } => {
            bounded(chosen)?;
            let mut chosen: Vec<usize> = chosen.iter().filter_map(|k| usize::try_from(*k).ok()).collect();
            chosen.sort_unstable();
            chosen.dedup();
            object.select(&chosen)?;
        }
        Setting::Colour { colour } => object.set_colour(argb(*colour))?,
        Setting::Place { value } => object.set_md_slider(*value)?,
        Setting::Gene { index, value } => {
            finite(&[*value])?;
            object.set_gene(usize::try_from(*index).unwrap_or(usize::MAX), *value)?;
        }
        Setting::Date { date } => object.set_calendar(*date)?,
        Setting::Time { seconds } => controls::set_clock(object, *seconds)?,
    }
    if *object == before {
        *object = before;
    } else {
        object.refresh();
    }
    Ok(())
}

/// Gives a control another form.
pub(super) fn reshape(draft: &mut Draft<'_>, id: uuid::Uuid, control: &Control) -> Result<(), Refusal> {
    let object = draft.object(id)?;
    let natural = size::natural(object);
    let before = object.clone();
    shape(object, control)?;
    if *object == before {
        *object = before;
        return Ok(());
    }
    // A list becomes as wide as its items; a pool as high.
    let grows = controls::of(object.component).is_some_and(|row| row.grows);
    let (now, bounds) = (size::natural(object), object.bounds);
    if let (true, Some([x, y, w, h])) = (grows, bounds) {
        let pivot = object.pivot.unwrap_or([x, y]);
        let grown = [(w + now[0] - natural[0]).max(40.0), (h + now[1] - natural[1]).max(16.0)];
        object.set_place([x, y, grown[0], grown[1]], pivot);
    }
    if object.component == ids::SCRIBBLE
        && matches!(control, Control::Scribble { corners, .. } if controls::is_flat(corners))
    {
        let corner = object.container().canvas_point("Ca").unwrap_or_default();
        objects::shape_scribble(object, corner);
    }
    Ok(())
}

/// Puts the settings of a control into an object.
pub(super) fn shape(object: &mut Object, control: &Control) -> Result<(), Refusal> {
    match control {
        Control::Script { text, additional, using, .. } => {
            scripts::write(object, text, [additional.as_deref(), using.as_deref()])?;
        }
        _ => controls::shape(object, control)?,
    }
    object.refresh();
    Ok(())
}
