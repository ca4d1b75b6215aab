//! What components draw that give no data: each is found by its id.

mod dimensions;
pub(crate) mod hatches;
mod preview;
mod tags;
mod vectors;

use katydid_component::{Component, plugin_of_tab, registry};
use katydid_definition::document::Object;
use uuid::Uuid;

use super::Painter;
use super::rows::Row;

/// Draws what an object shows in one iteration.
pub(crate) type Draw = fn(&mut Painter<'_>, &Object, &Row<'_>);

/// The component that an object runs, where that draws, and how.
pub(crate) fn of(object: &Object) -> Option<(&'static Component, Draw)> {
    if let Some(component) = registry::by_guid(object.component) {
        return Some((component, by_id(component.guid)?));
    }
    // A plug-in's component whose id no file at hand shows is told by its name; libraries are not known here, but nobody else
    // calls a component that is drawn so.
    object.lib?;
    let mut named = registry::unordered()
        .filter(|known| known.name.eq_ignore_ascii_case(object.name.trim()))
        .filter(|known| plugin_of_tab(known.tab).is_some());
    named.find_map(|component| Some((component, by_id(component.guid)?)))
}

fn by_id(guid: Uuid) -> Option<Draw> {
    let all: [&[(Uuid, Draw)]; 5] =
        [vectors::DRAWN, preview::DRAWN, tags::DRAWN, dimensions::DRAWN, hatches::DRAWN];
    all.into_iter().flatten().find(|(id, _)| *id == guid).map(|(_, draw)| *draw)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ELSEWHERE: [&str; 15] = [
        "Context Bake",
        "Context Print",
        "Data Output",
        "Viewport Display",
        "PersistentValues",
        "Test Crash",
        // Seen on the canvas; and what would write files, and says that definitions write none.
        "Prev Image",
        "Preview Colors",
        "Itemize Colors",
        "Export ASC",
        "Export DF",
        "Export XYZ",
        "KML Exporter",
        // What it puts into the model is seen once it is baked.
        "Bake Geometry",
        "Modify Object Attributes",
    ];

    #[test]
    fn plugins_components_of_unknown_ids_are_drawn_by_their_names() {
        katydid_components::link();
        let mut object = Object::new(Uuid::from_u128(0x7357), "ScreenText");
        object.name = "Screen-Oriented Text".into();
        assert!(of(&object).is_none());
        object.lib = Some(Uuid::from_u128(0x11b));
        assert_eq!(of(&object).map(|(component, _)| component.nick), Some("ScreenText"));
        object.name = "Custom Preview".into();
        assert!(of(&object).is_none());
    }

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
