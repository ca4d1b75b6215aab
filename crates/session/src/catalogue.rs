//! The components, as the text form wants to know them.

use std::collections::HashMap;
use std::sync::{Arc, LazyLock};

use katydid_component::{Access, Component, Port, registry};
use katydid_data::{Kind, Tree, Value};
use katydid_definition::archive::Colour;
use katydid_definition::document::{self, Branch, Material, Persistent, Stored, ids};
use katydid_definition::kd::{Catalogue, Expect, Facts, PortFacts};
use uuid::Uuid;

/// The registry as a catalogue for the text form.
#[derive(Debug, Clone, Copy, Default)]
pub struct Registry;

/// What is known of each component, by its address in the registry.
static FACTS: LazyLock<HashMap<Uuid, Arc<Facts>>> = LazyLock::new(|| {
    let types = types();
    registry::all()
        .into_iter()
        .map(|component| (component.guid, Arc::new(facts(component, &types))))
        .collect()
});

/// What a name without its panel means where that is not the first of that name: the one that everybody means, and the
/// one that had the name first, so that files keep their meaning when a component of a known name is added.
const MEANT: [(&str, &str); 3] =
    [("Addition", "Operators"), ("Mass Addition", "Operators"), ("Project", "Affine")];

/// By name in lower case, with and without the panel before it: what the name finds, and the parameter of that name.
static NAMES: LazyLock<HashMap<String, (Uuid, Option<Uuid>)>> = LazyLock::new(|| {
    let mut names: HashMap<String, (&Component, Option<Uuid>)> = HashMap::new();
    // The first of a name is the one meant; a parameter gives way to a component.
    for component in registry::all() {
        let parameter = component.floating.then_some(component.guid);
        for name in [component.name.to_owned(), format!("{}/{}", component.panel, component.name)] {
            let (found, floating) = names.entry(name.to_lowercase()).or_insert((component, parameter));
            let is_meant = MEANT.contains(&(component.name, component.panel)) && !component.old;
            if found.floating && !component.floating || is_meant {
                *found = component;
            }
            *floating = floating.or(parameter);
        }
    }
    names.into_iter().map(|(name, (component, floating))| (name, (component.guid, floating))).collect()
});

/// The parameter of each kind of data.
fn types() -> HashMap<Kind, Uuid> {
    let mut types = HashMap::from([(Kind::Generic, ids::DATA), (Kind::Geometry, ids::GEOMETRY)]);
    for component in registry::all() {
        let plain = component.floating && ["Geometry", "Primitive"].contains(&component.panel);
        if let Some(port) = component.outputs.first().filter(|_| plain && !component.old) {
            types.entry(port.kind).or_insert(component.guid);
        }
    }
    types
}

fn facts(component: &Component, types: &HashMap<Kind, Uuid>) -> Facts {
    let ports = |ports: &[Port]| ports.iter().map(|port| port_facts(port, types)).collect();
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

fn port_facts(port: &Port, types: &HashMap<Kind, Uuid>) -> PortFacts {
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
        type_id: types.get(&port.kind).copied(),
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
        FACTS.get(&registry::by_guid(guid)?.guid).cloned()
    }

    fn by_name(&self, name: &str, parameter: bool) -> Option<Arc<Facts>> {
        let (any, floating) = NAMES.get(&name.to_lowercase())?;
        FACTS.get(if parameter { floating.as_ref()? } else { any }).cloned()
    }

    fn names(&self) -> Vec<String> {
        registry::all().into_iter().map(|component| component.name.to_owned()).collect()
    }
}
