//! All components there are, by id and by name.

use std::collections::HashMap;
use std::sync::LazyLock;

use foldhash::fast::RandomState;
use uuid::Uuid;

use crate::{Component, plugin_of_tab};

/// By id: made once a process, before anything runs, and so with a hash that is quick. The ids are the program's own.
static BY_GUID: LazyLock<HashMap<Uuid, &'static Component, RandomState>> = LazyLock::new(|| {
    // About every other component has an earlier id too.
    let mut map = HashMap::with_capacity_and_hasher(2 * count(), RandomState::default());
    for component in unordered() {
        map.insert(component.guid, component);
        for &guid in component.also {
            map.insert(guid, component);
        }
    }
    map
});

/// A component of Grasshopper that is known and is not here.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unsupported {
    /// Its type id.
    pub guid: Uuid,
    /// Its name.
    pub name: &'static str,
    /// Why it is not here: half a sentence that follows a colon.
    pub reason: &'static str,
}

/// A list of such components, to be submitted to the registry as a whole.
#[derive(Debug, Clone, Copy)]
pub struct UnsupportedList(&'static [Unsupported]);

impl Unsupported {
    /// A list as the registry takes it.
    pub const fn list(list: &'static [Self]) -> UnsupportedList {
        UnsupportedList(list)
    }
}

inventory::collect!(UnsupportedList);

/// Why there is no component of a type id, where that is known.
pub fn unsupported(guid: Uuid) -> Option<&'static Unsupported> {
    all_unsupported().find(|known| known.guid == guid)
}

/// All components that are known and are not here.
pub fn all_unsupported() -> impl Iterator<Item = &'static Unsupported> {
    inventory::iter::<UnsupportedList>.into_iter().flat_map(|list| list.0)
}

/// The component of a type id, old ids included.
pub fn by_guid(guid: Uuid) -> Option<&'static Component> {
    BY_GUID.get(&guid).copied()
}

/// The first component of that name, in order of tab, panel and name, its newest version; a parameter only where no
/// component has the name, one that stands for a plug-in's only where nothing of Grasshopper's own has it. Case does not
/// matter.
pub fn by_name(name: &str) -> Option<&'static Component> {
    let mut all: Vec<_> = unordered().filter(|c| c.name.eq_ignore_ascii_case(name)).collect();
    sort(&mut all);
    // The first of equals is the least.
    all.into_iter().min_by_key(|c| (plugin_of_tab(c.tab).is_some(), c.floating, c.old))
}

/// All components, ordered by tab, panel, name, age and id; those that stand for plug-ins' after Grasshopper's own.
pub fn all() -> Vec<&'static Component> {
    let mut all: Vec<_> = unordered().collect();
    sort(&mut all);
    all
}

/// Brings some components into the order of [`all`].
pub fn sort(components: &mut [&'static Component]) {
    components
        .sort_by_cached_key(|c| (plugin_of_tab(c.tab).is_some(), c.tab, c.panel, c.name, c.old, c.guid));
}

/// All components in no order.
pub fn unordered() -> impl Iterator<Item = &'static Component> {
    inventory::iter::<Component>.into_iter()
}

/// How many components there are.
pub fn count() -> usize {
    unordered().count()
}
