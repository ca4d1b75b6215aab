//! The controls: objects with settings of their own, and a face that shows or sets them. Each kind is one [`Row`], in the file
//! of its family: what clients see of it, how what they send back is put into the file's chunks, what a new one begins with, how
//! large it is. Everything that a session does with a control it asks the row.

mod annotations;
mod colours;
mod dials;
mod genes;
mod graph;
mod list;
mod moments;
mod panel;
mod parts;
mod slider;
mod switches;
mod texts;
mod trees;

use katydid_definition::archive::Chunk;
use katydid_definition::document::{Object, Special, ids};
use uuid::Uuid;

use crate::Refusal;
use crate::protocol::Control;

pub(crate) use annotations::{border, is_flat};
pub(crate) use dials::turn;
pub(crate) use moments::set_clock;
pub(crate) use parts::{argb, colour, decimal, finite, part, short, unfit};

/// What a session knows of one kind of control.
pub(crate) struct Row {
    /// The component types that are such a control.
    components: &'static [Uuid],
    /// Whether it is drawn with a face of its own, rather than as a capsule or a parameter.
    pub(crate) has_face: bool,
    /// Whether it hangs from the corner of its rectangle, rather than from the middle of a capsule.
    pub(crate) hangs_from_corner: bool,
    /// Whether its user alone sets it: no wire goes in.
    pub(crate) is_set_by_hand: bool,
    /// Whether its rectangle grows and shrinks with its contents.
    pub(crate) grows: bool,
    /// Puts the settings of a new one into its container, by the measures of Grasshopper.
    pub(crate) begin: fn(&mut Chunk),
    /// What clients see of it; none for settings of another kind, or that clients do not see.
    view: fn(&Object, Special) -> Option<Control>,
    /// Puts what a client sent into an object; false for a control of another kind.
    shape: fn(&mut Object, &Control) -> Result<bool, Refusal>,
    /// The width and height of a new one, in canvas units, with the width of its title; none for those of a capsule.
    size: fn(&Special, f32) -> Option<[f32; 2]>,
}

/// What most rows have in common: an object like any other, with settings that nobody sees.
const PLAIN: Row = Row {
    components: &[],
    has_face: false,
    hangs_from_corner: false,
    is_set_by_hand: false,
    grows: false,
    begin: |_| {},
    view: |_, _| None,
    shape: |_, _| Ok(false),
    size: |_, _| None,
};

/// A rectangle with a face, of a size of its own.
const FACE: Row = Row { has_face: true, hangs_from_corner: true, ..PLAIN };

/// The controls. A new one is a row here, its `Special` in `katydid-definition` and its variant of [`Control`].
static ROWS: [Row; 27] = [
    slider::SLIDER,
    panel::PANEL,
    switches::TOGGLE,
    switches::TOGGLE_2,
    switches::BUTTON,
    colours::SWATCH,
    colours::PICKER,
    colours::GRADIENT,
    list::VALUE_LIST,
    dials::MD_SLIDER,
    dials::KNOB,
    dials::DIGITS,
    moments::CALENDAR,
    moments::CLOCK,
    genes::GENE_POOL,
    graph::GRAPH_MAPPER,
    texts::IMAGE_SAMPLER,
    texts::EXPRESSION,
    trees::PATH_MAPPER,
    trees::CHERRY_PICKER,
    trees::RECORDER,
    annotations::GROUP,
    annotations::SCRIBBLE,
    annotations::SKETCH,
    Row { components: &[ids::TRIGGER], ..PLAIN },
    Row { components: &[ids::DATA_DAM], hangs_from_corner: true, ..PLAIN },
    Row { components: &[ids::GALAPAGOS], hangs_from_corner: true, ..PLAIN },
];

/// The row of a component type; none for one that is no control, or that only its settings tell.
pub(crate) fn of(component: Uuid) -> Option<&'static Row> {
    ROWS.iter().find(|row| row.components.contains(&component))
}

/// The row and the settings of an object that has some: inputs that a caller is asked for are told by these alone.
pub(crate) fn settings(object: &Object) -> Option<(&'static Row, Special)> {
    let special = object.special()?;
    Some((of(object.component).unwrap_or(&texts::CONTEXTUAL), special))
}

/// What clients see of an object's settings.
pub(crate) fn view(object: &Object) -> Option<Control> {
    let (row, special) = settings(object)?;
    (row.view)(object, special)
}

/// The width and height of a new control, with the width of its title; none for those of a capsule.
pub(crate) fn size(object: &Object, title: f32) -> Option<[f32; 2]> {
    let (row, special) = settings(object)?;
    (row.size)(&special, title)
}

/// Puts the settings of a control into an object.
///
/// # Errors
/// The object is no control of that kind, or a number or text is out of range.
pub(crate) fn shape(object: &mut Object, control: &Control) -> Result<(), Refusal> {
    let row = settings(object).map(|(row, _)| row);
    let fits = row.map_or(Ok(false), |row| (row.shape)(object, control))?;
    if fits { Ok(()) } else { Err(unfit(object, "it is not a control of that kind")) }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::ROWS;

    #[test]
    fn a_component_has_one_row() {
        let mut seen = HashSet::new();
        for row in &ROWS {
            assert!(!row.components.is_empty());
            assert!(row.components.iter().all(|id| seen.insert(*id)));
        }
    }
}
