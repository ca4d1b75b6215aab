//! All components there are, by id and by name.

use std::collections::HashMap;
use std::sync::LazyLock;

use uuid::Uuid;

use crate::Component;

static BY_GUID: LazyLock<HashMap<Uuid, &'static Component>> = LazyLock::new(|| {
    let mut map = HashMap::new();
    for component in inventory::iter::<Component> {
        map.insert(component.guid, component);
        for &guid in component.also {
            map.insert(guid, component);
        }
    }
    map
});

/// The component of a type id, old ids included.
pub fn by_guid(guid: Uuid) -> Option<&'static Component> {
    BY_GUID.get(&guid).copied()
}

/// The first component of that name, in order of tab, panel and name, its newest version; a parameter only where no
/// component has the name. Case does not matter.
pub fn by_name(name: &str) -> Option<&'static Component> {
    let all = all().into_iter().filter(|c| c.name.eq_ignore_ascii_case(name));
    // The first of equals is the least.
    all.min_by_key(|c| (c.floating, c.old))
}

/// All components, ordered by tab, panel, name, age and id.
pub fn all() -> Vec<&'static Component> {
    let mut all: Vec<_> = inventory::iter::<Component>.into_iter().collect();
    all.sort_by_key(|c| (c.tab, c.panel, c.name, c.old, c.guid));
    all
}
