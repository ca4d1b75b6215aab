use std::collections::HashMap;

use katydid_definition::document::{Difference, Document, Object};
use uuid::Uuid;

/// The objects that a step puts, takes away, shows or hides. What else a step makes of them is found when they are
/// solved; where they stand on the canvas does not count.
pub fn touched(difference: &Difference, before: &Document) -> Vec<Uuid> {
    let old: HashMap<Uuid, &Object> = difference
        .removed
        .iter()
        .filter_map(|at| before.objects.get(*at))
        .map(|object| (object.id, object))
        .collect();
    let new: HashMap<Uuid, &Object> = difference.put.iter().map(|(_, object)| (object.id, object)).collect();
    let changed = |id: &&Uuid| match (old.get(*id), new.get(*id)) {
        (Some(old), Some(new)) => !shown_alike(old, new),
        _ => true,
    };
    old.keys().chain(new.keys().filter(|id| !old.contains_key(*id))).filter(changed).copied().collect()
}

fn shown_alike(old: &Object, new: &Object) -> bool {
    let hidden = |object: &Object| object.outputs.iter().map(|port| port.hidden).collect::<Vec<_>>();
    (old.hidden, old.locked, old.component) == (new.hidden, new.locked, new.component)
        && hidden(old) == hidden(new)
}
