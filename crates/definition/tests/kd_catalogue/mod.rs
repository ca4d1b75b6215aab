//! A few components, as a program would lend them.

use std::sync::Arc;

use katydid_definition::document::{Access, Persistent, Stored, ids};
use katydid_definition::kd::{Catalogue, Expect, Facts, PortFacts};
use katydid_geometry::{Plane, Vector3};
use uuid::{Uuid, uuid};

/// Construct Point, Vector XYZ, Move, Square, List Item, Merge, Addition, Expression and a few parameters.
pub(crate) struct Few;

fn port(name: &str, nickname: &str) -> PortFacts {
    PortFacts { name: name.to_owned(), nickname: nickname.to_owned(), ..PortFacts::default() }
}

fn number(name: &str, nickname: &str, default: Option<f64>) -> PortFacts {
    let default = default.map(|x| Persistent::item(Stored::Number(x)));
    PortFacts { expect: Expect::Number, default, ..port(name, nickname) }
}

fn of(guid: Uuid, name: &str, nickname: &str, inputs: Vec<PortFacts>, outputs: Vec<PortFacts>) -> Facts {
    let (name, nickname) = (name.to_owned(), nickname.to_owned());
    let panel = if name == "Square" { "Grid" } else { "" }.to_owned();
    Facts { guid, name, nickname, panel, inputs, outputs, ..Facts::default() }
}

fn parameter(guid: Uuid, name: &str, expect: Expect) -> Facts {
    let port = PortFacts { expect, type_id: Some(guid), ..port(name, name) };
    Facts { floating: true, ..of(guid, name, name, vec![port.clone()], vec![port]) }
}

fn all() -> Vec<Facts> {
    let many = |name, nick| PortFacts { many: true, type_id: Some(ids::DATA), ..port(name, nick) };
    let zero = Some(0.0);
    let plane = Persistent::item(Stored::Plane(Box::new(Plane::XY)));
    let index = Persistent::item(Stored::Integer(0));
    let motion = Persistent::item(Stored::Vector(Vector3::new(0.0, 0.0, 10.0)));
    vec![
        of(
            uuid!("3581f42a-9592-4549-bd6b-1c0fc39d067b"),
            "Construct Point",
            "Pt",
            vec![
                number("X coordinate", "X", zero),
                number("Y coordinate", "Y", zero),
                number("Z coordinate", "Z", zero),
            ],
            vec![port("Point", "Pt")],
        ),
        of(
            uuid!("56b92eab-d121-43f7-94d3-6cd8f0ddead8"),
            "Vector XYZ",
            "Vec",
            vec![
                number("X component", "X", zero),
                number("Y component", "Y", zero),
                number("Z component", "Z", zero),
            ],
            vec![port("Vector", "V"), number("Length", "L", None)],
        ),
        of(
            uuid!("e9eb1dcf-92f6-4d4d-84ae-96222d60f56b"),
            "Move",
            "Move",
            vec![
                port("Geometry", "G"),
                PortFacts { expect: Expect::Vector, default: Some(motion), ..port("Motion", "T") },
            ],
            vec![port("Geometry", "G"), port("Transform", "X")],
        ),
        of(
            uuid!("717a1e25-a075-4530-bc80-d43ecc2500d9"),
            "Square",
            "SqGrid",
            vec![
                PortFacts { default: Some(plane), ..port("Plane", "P") },
                number("Size", "S", Some(1.0)),
                number("Extent X", "Ex", Some(5.0)),
                number("Extent Y", "Ey", Some(5.0)),
            ],
            vec![port("Cells", "C"), port("Points", "P")],
        ),
        of(
            uuid!("59daf374-bc21-4a5e-8282-5504fb7ae9ae"),
            "List Item",
            "Item",
            vec![
                PortFacts { access: Access::List, ..port("List", "L") },
                PortFacts { default: Some(index), ..port("Index", "i") },
                PortFacts { default: Some(Persistent::item(Stored::Boolean(true))), ..port("Wrap", "W") },
            ],
            vec![port("Element", "E")],
        ),
        of(
            uuid!("3cadddef-1e2b-4c09-9390-0e8f78f7609f"),
            "Merge",
            "Merge",
            vec![many("Data 1", "D1")],
            vec![PortFacts { access: Access::Tree, ..port("Result", "R") }],
        ),
        of(
            uuid!("6f93d366-919f-4dda-a35e-ba03dd62799b"),
            "Sort List",
            "Sort",
            vec![port("Keys", "K"), many("Values A", "A")],
            vec![port("Keys", "K"), many("Values A", "A")],
        ),
        of(
            uuid!("a0d62394-a118-422d-abb3-6af115c75b25"),
            "Addition",
            "A+B",
            vec![port("A", "A"), port("B", "B")],
            vec![port("Result", "R")],
        ),
        of(
            ids::EXPRESSION,
            "Expression",
            "Expression",
            vec![many("Variable x", "x")],
            vec![port("Result", "R")],
        ),
        parameter(uuid!("3e8ca6be-fda8-4aaf-b5c0-3c54c8bb7312"), "Number", Expect::Number),
        parameter(uuid!("fbac3e32-f100-4292-8692-77240a42fd1a"), "Point", Expect::Anything),
        parameter(ids::GEOMETRY_PIPELINE, "Geometry Pipeline", Expect::Anything),
    ]
}

impl Catalogue for Few {
    fn by_guid(&self, guid: Uuid) -> Option<Arc<Facts>> {
        all().into_iter().find(|facts| facts.guid == guid).map(Arc::new)
    }

    fn by_name(&self, name: &str, parameter: bool) -> Option<Arc<Facts>> {
        let called = |facts: &Facts| {
            let qualified = format!("{}/{}", facts.panel, facts.name);
            facts.name.eq_ignore_ascii_case(name) || qualified.eq_ignore_ascii_case(name)
        };
        let fits = |facts: &Facts| called(facts) && (facts.floating || !parameter);
        all().into_iter().find(fits).map(Arc::new)
    }

    fn names(&self) -> Vec<String> {
        all().into_iter().map(|facts| facts.name).collect()
    }
}
