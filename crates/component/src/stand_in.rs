//! Components that stand for those of plug-ins: found by id, else by the plug-in's and the object's names.
//!
//! Files tell an object's type by a GUID. Where no file at hand shows the GUID that a plug-in gave a component, the
//! names in the file still tell it: the library's, the component's and its ports'.

use katydid_data::Tree;
use uuid::Uuid;

use crate::{Component, Port, registry};

/// A plug-in of Grasshopper whose objects some components here answer to. Their tab has its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plugin {
    /// The plug-in's name, which is also the tab of its components.
    pub name: &'static str,
    /// Who made the plug-in.
    pub author: &'static str,
    /// What a library's name begins with, in small letters and digits only.
    pub library: &'static str,
    /// Whether its objects are there for the reader of the canvas only, and compute nothing.
    pub only_notes: bool,
}

inventory::collect!(Plugin);

/// All plug-ins that components stand for.
pub fn plugins() -> impl Iterator<Item = &'static Plugin> {
    inventory::iter::<Plugin>.into_iter()
}

/// The plug-in whose components stand in that tab.
pub fn plugin_of_tab(tab: &str) -> Option<&'static Plugin> {
    plugins().find(|plugin| plugin.name == tab)
}

/// The plug-in that a library of a file belongs to.
pub fn plugin_of_library(library: &str) -> Option<&'static Plugin> {
    let library = plain(library);
    let known = plugins().filter(|plugin| library.starts_with(plugin.library));
    // Of tabs with components of one library the one that is called as the library.
    known.max_by_key(|plugin| (plugin.library.len(), plain(plugin.name) == plugin.library))
}

/// A name in small letters and digits only: versions of plug-ins differ in spaces and capitals.
fn plain(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// The names of a port in a file: in full, and the short one.
pub type PortNames<'a> = (&'a str, &'a str);

/// The component that an object of a file runs.
#[derive(Debug, Clone)]
pub struct StandIn {
    /// The component.
    pub component: &'static Component,
    /// For each input of the object the number of the component's; `None` where each is its own.
    inputs: Option<Vec<Option<usize>>>,
    /// For each output likewise.
    outputs: Option<Vec<Option<usize>>>,
}

impl StandIn {
    /// The component's port behind input `k` of the object.
    pub fn input(&self, k: usize) -> Option<&'static Port> {
        self.component.input(self.input_place(k)?)
    }

    /// The number of the component's input behind input `k` of the object.
    pub fn input_place(&self, k: usize) -> Option<usize> {
        match &self.inputs {
            None => Some(k),
            Some(places) => places.get(k).copied().flatten(),
        }
    }

    /// The number of the component's output behind output `k` of the object.
    pub fn output_place(&self, k: usize) -> Option<usize> {
        match &self.outputs {
            None => Some(k),
            Some(places) => places.get(k).copied().flatten(),
        }
    }

    /// Whether the component was found by names, so that its ports may stand in another order.
    pub fn is_by_name(&self) -> bool {
        self.inputs.is_some()
    }
}

impl From<&'static Component> for StandIn {
    fn from(component: &'static Component) -> Self {
        Self { component, inputs: None, outputs: None }
    }
}

/// The component for an object of a type, by its id, else by the names of library, object and ports. None where it is
/// neither one of Grasshopper's own nor one of a plug-in that is stood for.
pub fn stand_in(
    guid: Uuid,
    library: Option<&str>,
    name: &str,
    inputs: &[PortNames<'_>],
    outputs: &[PortNames<'_>],
) -> Option<StandIn> {
    if let Some(component) = registry::by_guid(guid) {
        return Some(StandIn::from(component));
    }
    let plugin = plugin_of_library(library?)?;
    let wanted = plain(name);
    // Weaverbird's components are called "Weaverbird's …" in files.
    let short = wanted.strip_prefix(&format!("{}s", plugin.library)).unwrap_or(&wanted);
    // A library may have had components that went on as a plug-in of their own: they stand in the tab of that one.
    let tabs: Vec<&str> = plugins().filter(|p| p.library == plugin.library).map(|p| p.name).collect();
    let found = registry::all().into_iter().filter(|c| tabs.contains(&c.tab)).filter(|c| {
        let own = plain(c.name);
        own == wanted || own == short || plain(c.nick) == wanted
    });
    // Of versions with other ports the one with most names in common.
    let component = found.max_by_key(|c| {
        let places = places(inputs, c.inputs);
        (places.iter().filter(|place| place.is_some()).count(), !c.old)
    })?;
    Some(StandIn {
        component,
        inputs: Some(places(inputs, component.inputs)),
        outputs: Some(places(outputs, component.outputs)),
    })
}

/// For each port in a file the number of the declared one: by name, else by the short name, else by its place where
/// nobody else has that. Where the last declared one stands for any number of ports, the others are such ones.
fn places(ports: &[PortNames<'_>], declared: &[Port]) -> Vec<Option<usize>> {
    let mut taken = vec![false; declared.len()];
    let mut places: Vec<Option<usize>> = vec![None; ports.len()];
    let rounds: [fn(&PortNames<'_>, &Port) -> bool; 2] = [
        |port, own| plain(port.0) == plain(own.name),
        |port, own| plain(port.1) == plain(own.nick) || plain(port.0) == plain(own.nick),
    ];
    for same in rounds {
        for (port, place) in ports.iter().zip(&mut places).filter(|(_, place)| place.is_none()) {
            let free = declared
                .iter()
                .enumerate()
                .find(|(j, own)| taken.get(*j).is_some_and(|taken| !*taken) && same(port, own));
            if let Some((j, _)) = free {
                *place = Some(j);
                if let Some(taken) = taken.get_mut(j) {
                    *taken = true;
                }
            }
        }
    }
    let many = declared.last().is_some_and(|last| last.many);
    let mut next = declared.len();
    for (k, place) in places.iter_mut().enumerate().filter(|(_, place)| place.is_none()) {
        match taken.get_mut(k) {
            Some(taken) if !*taken => {
                *taken = true;
                *place = Some(k);
            }
            // Of the last port there are as many as come, wherever they stand.
            _ if many => {
                *place = Some(next);
                next += 1;
            }
            _ => {}
        }
    }
    places
}

impl StandIn {
    /// Data by the object's inputs put in the order of the component's; what no input of the object brings has its
    /// default.
    pub fn arranged(&self, trees: Vec<Tree>) -> Vec<Tree> {
        let Some(places) = &self.inputs else { return trees };
        let most = places.iter().flatten().max().map_or(0, |most| most + 1).max(self.component.inputs.len());
        let mut arranged: Vec<Option<Tree>> = vec![None; most];
        for (tree, place) in trees.into_iter().zip(places) {
            if let Some(slot) = place.and_then(|j| arranged.get_mut(j)) {
                *slot = Some(tree);
            }
        }
        let default =
            |j: usize| self.component.input(j).and_then(|port| port.default).map(|default| default());
        arranged
            .into_iter()
            .enumerate()
            .map(|(j, tree)| tree.or_else(|| default(j)).unwrap_or_default())
            .collect()
    }

    /// The inputs of the component that must have data and that no input of the object, of which there are so many,
    /// brings.
    pub fn is_short_of_inputs(&self, count: usize) -> bool {
        let mut unfed = self.component.inputs.iter().enumerate().filter(|(j, port)| {
            let fed = match &self.inputs {
                None => *j < count,
                Some(places) => places.contains(&Some(*j)),
            };
            !fed && !port.many && !port.optional && port.default.is_none()
        });
        unfed.next().is_some()
    }
}
