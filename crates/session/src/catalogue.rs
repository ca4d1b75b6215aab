//! The components, as the text form wants to know them.

use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

use katydid_component::{Access, Component, Port, registry};
use katydid_data::{Kind, Tree, Value};
use katydid_definition::archive::Colour;
use katydid_definition::document::{self, Branch, Material, Persistent, Stored, ids};
use katydid_definition::kd::{Catalogue, Expect, Facts, PortFacts};
use uuid::Uuid;

/// The registry of components as a catalogue for the text form.
#[derive(Debug, Clone, Copy, Default)]
pub struct Registry;

/// What was asked for of a component, by its id: a definition names a few of a thousand.
static FACTS: LazyLock<Mutex<HashMap<Uuid, Arc<Facts>>>> = LazyLock::new(Mutex::default);

/// What a name in lower case finds, for those that were asked for.
static NAMES: LazyLock<Mutex<HashMap<String, Found>>> = LazyLock::new(Mutex::default);

/// The parameter of each kind of data.
static TYPES: LazyLock<HashMap<Kind, Uuid>> = LazyLock::new(types);

/// So many names are kept. Each file brings some that there are, and may bring any number of others.
const MOST_NAMES: usize = 4096;

/// What a name without its panel means where that is not the first of that name: the one that everybody means, and the
/// one that had the name first, so that files keep their meaning when a component of a known name is added.
const MEANT: [(&str, &str); 3] =
    [("Addition", "Operators"), ("Mass Addition", "Operators"), ("Project", "Affine")];

/// What a name finds, and the parameter of that name.
#[derive(Debug, Clone, Copy, Default)]
struct Found {
    any: Option<&'static Component>,
    parameter: Option<&'static Component>,
}

impl Found {
    /// The components of a name in lower case, with or without the panel before it.
    fn of(name: &str) -> Self {
        let mut named: Vec<_> = registry::unordered().filter(|component| is_named(component, name)).collect();
        registry::sort(&mut named);
        let mut found = Self::default();
        // The first of a name is the one meant; a parameter gives way to a component.
        for component in named {
            let is_meant = MEANT.contains(&(component.name, component.panel)) && !component.old;
            if found.any.is_none_or(|any| any.floating && !component.floating) || is_meant {
                found.any = Some(component);
            }
            if component.floating {
                found.parameter = found.parameter.or(Some(component));
            }
        }
        found
    }
}

/// Whether a component has this name, which is in lower case, alone or behind its panel and a slash.
fn is_named(component: &Component, name: &str) -> bool {
    let behind_panel = || {
        let at = component.panel.len();
        name.len() == at + 1 + component.name.len()
            && name.as_bytes().get(at) == Some(&b'/')
            && name.get(..at).is_some_and(|panel| panel.eq_ignore_ascii_case(component.panel))
            && name.get(at + 1..).is_some_and(|rest| rest.eq_ignore_ascii_case(component.name))
    };
    if component.name.is_ascii() && component.panel.is_ascii() {
        return name.eq_ignore_ascii_case(component.name) || behind_panel();
    }
    name == component.name.to_lowercase()
        || name == format!("{}/{}", component.panel, component.name).to_lowercase()
}

/// The parameter of each kind of data.
fn types() -> HashMap<Kind, Uuid> {
    let mut types = HashMap::from([(Kind::Generic, ids::DATA), (Kind::Geometry, ids::GEOMETRY)]);
    let is_plain = |component: &&Component| {
        component.floating && !component.old && ["Geometry", "Primitive"].contains(&component.panel)
    };
    let mut plain: Vec<_> = registry::unordered().filter(is_plain).collect();
    registry::sort(&mut plain);
    for component in plain {
        if let Some(port) = component.outputs.first() {
            types.entry(port.kind).or_insert(component.guid);
        }
    }
    types
}

/// What is known of a component, made once.
fn known(component: &'static Component) -> Arc<Facts> {
    let mut known = FACTS.lock().unwrap_or_else(PoisonError::into_inner);
    known.entry(component.guid).or_insert_with(|| Arc::new(facts(component))).clone()
}

fn facts(component: &Component) -> Facts {
    let ports = |ports: &[Port]| ports.iter().map(port_facts).collect();
    Facts {
        guid: component.guid,
        name: component.name.to_owned(),
        nickname: component.nick.to_owned(),
        panel: component.panel.to_owned(),
        description: component.help.to_owned(),
        floating: component.floating,
        inputs: ports(component.inputs),
        outputs: ports(component.outputs),
    }
}

fn port_facts(port: &Port) -> PortFacts {
    PortFacts {
        name: port.name.to_owned(),
        nickname: port.nick.to_owned(),
        description: port.help.to_owned(),
        access: match port.access {
            Access::Item => document::Access::Item,
            Access::List => document::Access::List,
            Access::Tree => document::Access::Tree,
        },
        optional: port.optional,
        many: port.many,
        expect: match port.kind {
            Kind::Number => Expect::Number,
            Kind::Vector => Expect::Vector,
            _ => Expect::Anything,
        },
        type_id: TYPES.get(&port.kind).copied(),
        default: port.default.and_then(|default| persistent(&default())),
    }
}

/// The values a port begins with; nothing where one of them cannot be kept in a file.
fn persistent(tree: &Tree) -> Option<Persistent> {
    let branch = |k: usize| {
        let path = tree.paths().get(k)?.elements().to_vec();
        let items =
            tree.branch(k)?.iter().map(|item| item.map_or(Some(Stored::Null), |value| stored(&value)));
        Some(Branch { path, items: items.collect::<Option<_>>()? })
    };
    Some(Persistent { branches: (0..tree.branch_count()).map(branch).collect::<Option<_>>()? })
}

fn colour(c: katydid_data::Colour) -> Colour {
    Colour::new(c.a, c.r, c.g, c.b)
}

pub(crate) fn stored(value: &Value) -> Option<Stored> {
    Some(match value {
        Value::Boolean(b) => Stored::Boolean(*b),
        Value::Integer(n) => Stored::Integer(*n),
        Value::Number(x) => Stored::Number(*x),
        Value::Complex(c) => Stored::Complex([c.re, c.im]),
        Value::Text(text) => Stored::Text(text.to_string()),
        Value::Colour(c) => Stored::Colour(colour(*c)),
        Value::Time(time) => Stored::Time(time.ticks),
        Value::Guid(id) => Stored::Guid(*id),
        Value::Domain(i) => Stored::Domain(*i),
        Value::Domain2(d) => Stored::Domain2([d.u, d.v]),
        Value::Point(p) => Stored::Point(*p),
        Value::Vector(v) => Stored::Vector(*v),
        Value::Plane(p) => Stored::Plane(Box::new(**p)),
        Value::Line(l) => Stored::Line(Box::new(**l)),
        Value::Circle(c) => Stored::Circle(Box::new(**c)),
        Value::Arc(a) => Stored::Arc(Box::new(**a)),
        Value::Rectangle(r) => Stored::Rectangle(Box::new(**r)),
        Value::Box(b) => Stored::Box(Box::new(**b)),
        Value::MeshFace(face) => {
            let index = |k: u32| i32::try_from(k).ok();
            Stored::MeshFace(match face {
                katydid_geometry::MeshFace::Triangle([a, b, c]) => [index(*a)?, index(*b)?, index(*c)?, -1],
                katydid_geometry::MeshFace::Quad([a, b, c, d]) => {
                    [index(*a)?, index(*b)?, index(*c)?, index(*d)?]
                }
            })
        }
        Value::Path(path) => Stored::Path(path.elements().to_vec()),
        Value::Material(m) => Stored::Material(Box::new(Material {
            diffuse: colour(m.diffuse),
            specular: colour(m.specular),
            emission: colour(m.emission),
            transparency: m.transparency,
            shine: m.shine,
        })),
        _ => return None,
    })
}

impl Catalogue for Registry {
    fn by_guid(&self, guid: Uuid) -> Option<Arc<Facts>> {
        registry::by_guid(guid).map(known)
    }

    fn by_name(&self, name: &str, parameter: bool) -> Option<Arc<Facts>> {
        let name = name.to_lowercase();
        let mut names = NAMES.lock().unwrap_or_else(PoisonError::into_inner);
        let found = match names.get(&name) {
            Some(found) => *found,
            None => {
                let found = Found::of(&name);
                if names.len() < MOST_NAMES {
                    names.insert(name, found);
                }
                found
            }
        };
        drop(names);
        if parameter { found.parameter } else { found.any }.map(known)
    }

    fn names(&self) -> Vec<String> {
        registry::all().into_iter().map(|component| component.name.to_owned()).collect()
    }
}
