//! Objects that need somebody at a canvas: a solve takes no notice of them, and says so.

use katydid_definition::document::{Document, Object, ids};

/// A message for each object that does nothing in a single solve: optimisers, which wait for a click, and timers, which
/// wait for a clock.
pub(crate) fn idle_objects(document: &Document) -> Vec<String> {
    let message = |object: &Object| {
        let why = match object.component {
            ids::GALAPAGOS => {
                "Galapagos does not search: a request is one solve with the values that it brings; katydid optimise searches"
            }
            ids::TRIGGER => "The trigger does not fire: a request is one solve; katydid run --ticks fires it",
            _ => return None,
        };
        Some(format!("{why}: component \"{}\" ({})", object.name, object.id))
    };
    document.objects.iter().filter_map(message).collect()
}
