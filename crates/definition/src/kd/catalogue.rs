use std::sync::Arc;

use uuid::Uuid;

use crate::document::{Access, Persistent, ids};

/// What is known about components. The text form needs it to write `Move(A, V)` instead of ids and lists of ports;
/// this crate knows no components, so whoever does lends it the catalogue.
pub trait Catalogue {
    /// The component of this type id, old ids included.
    fn by_guid(&self, guid: Uuid) -> Option<Arc<Facts>>;

    /// The component of this name, which may have its panel and a slash before it where several have the name:
    /// `Grid/Square`. With `parameter` the floating parameter of this name, else a parameter only where
    /// no component has the name.
    fn by_name(&self, name: &str, parameter: bool) -> Option<Arc<Facts>>;

    /// All names, to find what a misspelt one may have meant.
    fn names(&self) -> Vec<String>;
}

/// A catalogue without components. Sliders, panels, groups, clusters and the like are known all the same.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoCatalogue;

impl Catalogue for NoCatalogue {
    fn by_guid(&self, _: Uuid) -> Option<Arc<Facts>> {
        None
    }

    fn by_name(&self, _: &str, _: bool) -> Option<Arc<Facts>> {
        None
    }

    fn names(&self) -> Vec<String> {
        Vec::new()
    }
}

/// A component as the text form sees it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Facts {
    /// The type id that new objects get.
    pub guid: Uuid,
    /// The name in full.
    pub name: String,
    /// The short name.
    pub nickname: String,
    /// The panel of the ribbon, which tells components of the same name apart.
    pub panel: String,
    /// What it does.
    pub description: String,
    /// Whether it is a floating parameter: an object that is its own port.
    pub floating: bool,
    /// The inputs; of a floating parameter one, itself.
    pub inputs: Vec<PortFacts>,
    /// The outputs.
    pub outputs: Vec<PortFacts>,
}

impl Facts {
    /// Whether ports can be added and removed on some side, which the archive keeps in another way.
    pub fn is_variable(&self) -> bool {
        self.inputs.iter().chain(&self.outputs).any(|port| port.many)
    }
}

/// A port as the text form sees it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PortFacts {
    /// The name in full.
    pub name: String,
    /// The short name.
    pub nickname: String,
    /// What it takes or gives.
    pub description: String,
    /// How much of a tree the component takes at once.
    pub access: Access,
    /// Whether the component runs without data here.
    pub optional: bool,
    /// Whether it stands for any number of ports; such a one comes last.
    pub many: bool,
    /// What a plain number or three coordinates mean here.
    pub expect: Expect,
    /// The parameter type, for variable signatures.
    pub type_id: Option<Uuid>,
    /// The values that it begins with.
    pub default: Option<Persistent>,
}

/// What a plain number, or three coordinates, mean on a port.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Expect {
    /// `3` is whole, `3.0` is not, `(1, 2, 3)` is a point.
    #[default]
    Anything,
    /// `3` is a number like `3.0`.
    Number,
    /// `(1, 2, 3)` is a vector.
    Vector,
}

/// The catalogue that was lent, and what this crate knows by itself.
pub(super) struct Known<'a>(pub(super) &'a dyn Catalogue);

/// The objects with settings of their own, which the document knows: id, name, whether it is a parameter, nickname.
const OWN: [(Uuid, &str, bool, &str); 14] = [
    (ids::NUMBER_SLIDER, "Number Slider", true, ""),
    (ids::PANEL, "Panel", true, ""),
    (ids::BOOLEAN_TOGGLE, "Boolean Toggle", true, "Toggle"),
    (ids::VALUE_LIST, "Value List", true, "List"),
    (ids::COLOUR_SWATCH, "Colour Swatch", true, "Swatch"),
    (ids::BUTTON, "Button", true, ""),
    (ids::DATA, "Data", true, "Data"),
    (ids::GEOMETRY, "Geometry", true, "Geo"),
    (ids::RELAY, "Relay", true, "Relay"),
    (ids::CLUSTER_INPUT, "Cluster Input", true, "In"),
    (ids::CLUSTER_OUTPUT, "Cluster Output", true, "Out"),
    (ids::SCRIBBLE, "Scribble", false, "Scribble"),
    (ids::SKETCH, "Sketch", false, "Sketch"),
    (ids::CLUSTER, "Cluster", false, "Cluster"),
];

fn own(found: impl Fn(&(Uuid, &str, bool, &str)) -> bool) -> Option<Arc<Facts>> {
    let (guid, name, floating, nickname) = OWN.iter().find(|entry| found(entry))?;
    let port =
        PortFacts { name: (*name).to_owned(), nickname: (*nickname).to_owned(), ..PortFacts::default() };
    // A cluster's ports are those of the objects inside.
    let many = PortFacts { many: true, type_id: Some(ids::DATA), ..PortFacts::default() };
    let (inputs, outputs) = match (*guid, *floating) {
        (ids::CLUSTER, _) => (vec![many.clone()], vec![many]),
        (_, true) => (vec![port.clone()], vec![port]),
        _ => (Vec::new(), Vec::new()),
    };
    Some(Arc::new(Facts {
        guid: *guid,
        name: (*name).to_owned(),
        nickname: (*nickname).to_owned(),
        panel: String::new(),
        description: String::new(),
        floating: *floating,
        inputs,
        outputs,
    }))
}

impl Known<'_> {
    pub(super) fn by_guid(&self, guid: Uuid) -> Option<Arc<Facts>> {
        self.0.by_guid(guid).or_else(|| own(|entry| entry.0 == guid))
    }

    pub(super) fn by_name(&self, name: &str, parameter: bool) -> Option<Arc<Facts>> {
        let facts = self.0.by_name(name, parameter).filter(|facts| !parameter || facts.floating);
        facts.or_else(|| own(|entry| entry.1.eq_ignore_ascii_case(name) && (!parameter || entry.2)))
    }

    pub(super) fn names(&self) -> Vec<String> {
        let mut names = self.0.names();
        names.extend(OWN.iter().map(|entry| entry.1.to_owned()));
        names
    }

    /// How to call a component so that its name finds this id: whether its panel stands before the name, and whether
    /// it is to be a parameter.
    pub(super) fn name_of(&self, facts: &Facts, guid: Uuid) -> Option<(bool, bool)> {
        let finds = |name: &str, parameter: bool| {
            facts.guid == guid && self.by_name(name, parameter).is_some_and(|found| found.guid == guid)
        };
        let qualified = format!("{}/{}", facts.panel, facts.name);
        [(false, false), (false, true), (true, false)].into_iter().find(|(panel, parameter)| {
            finds(if *panel { &qualified } else { &facts.name }, *parameter)
                && !(*panel && facts.panel.is_empty())
        })
    }
}
