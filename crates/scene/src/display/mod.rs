//! What components draw that give no data: each is found by its id.

mod dimensions;
pub(crate) mod hatches;
mod preview;
mod tags;
mod vectors;

use katydid_component::registry;
use katydid_definition::document::Object;
use uuid::Uuid;

use super::Painter;
use super::rows::Row;

/// Draws what an object shows in one iteration.
pub(crate) type Draw = fn(&mut Painter<'_>, &Object, &Row<'_>);

/// How an object draws; `None` for one that does not.
pub(crate) fn of(object: &Object) -> Option<Draw> {
    let component = registry::by_guid(object.component)?;
    let all: [&[(Uuid, Draw)]; 5] =
        [vectors::DRAWN, preview::DRAWN, tags::DRAWN, dimensions::DRAWN, hatches::DRAWN];
    all.into_iter().flatten().find(|(id, _)| *id == component.guid).map(|(_, draw)| *draw)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ELSEWHERE: [&str; 13] = [
        "Context Bake",
        "Context Print",
        "Data Output",
        "Viewport Display",
        "PersistentValues",
        "Test Crash",
        // Seen on the canvas; and what would write files, and says that definitions write none.
        "Prev Image",
        "Preview Colors",
        "Export ASC",
        "Export DF",
        "Export XYZ",
        "KML Exporter",
        // What it puts into the model is seen once it is baked.
        "Bake Geometry",
    ];

    /// A component without outputs is there to be seen in the model, but for those that hand data to who runs the
    /// definition, are seen on the canvas, or only say something.
    #[test]
    fn what_gives_no_data_is_drawn() {
        katydid_components::link();
        let drawn = |id: Uuid| of(&Object::new(id, "")).is_some();
        let silent: Vec<&str> = registry::all()
            .into_iter()
            .filter(|component| component.outputs.is_empty() && !component.inputs.is_empty())
            .filter(|component| !drawn(component.guid))
            .map(|component| component.name)
            .filter(|name| !ELSEWHERE.contains(name))
            .collect();
        assert_eq!(silent, Vec::<&str>::new());
    }
}
