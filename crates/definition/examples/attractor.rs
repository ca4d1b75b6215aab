//! Writes the definition that the README runs: circles on a grid, larger the nearer they are to a point.
//!
//! `cargo run -p katydid-definition --example attractor > examples/attractor.ghx`

#![allow(clippy::expect_used, reason = "what is written here is known to fit")]

use katydid_definition::archive::{Chunk, ItemValue};
use katydid_definition::document::{Document, Mapping, NewPort, Object, Persistent, Side, Stored};
use katydid_geometry::Plane;
use uuid::{Uuid, uuid};

/// A document that is being written, with ids that are the same each time.
struct Sheet {
    document: Document,
    next: u128,
}

/// What an input has.
enum Input {
    Wire(Uuid),
    Plane,
    Number(f64),
}

impl Sheet {
    fn id(&mut self) -> Uuid {
        self.next += 1;
        Uuid::from_u128(0x4b61_7479_6469_6400_8000_0000_0000_0000 + self.next)
    }

    fn slider(&mut self, name: &str, value: f64, max: f64, digits: i32, at: [f32; 2]) -> Uuid {
        let id = self.id();
        let guid = uuid!("57da07bd-ecab-415d-9d86-af36d7073abc");
        let mut object = Object::new_parameter(guid, "Number Slider", name, id);
        let mut slider = Chunk::new("Slider");
        slider.set("Digits", digits);
        slider.set("GripDisplay", 1);
        slider.set("Interval", if digits == 0 { 1 } else { 0 });
        slider.set("Max", max);
        slider.set("Min", 0.0);
        slider.set("SnapCount", 0);
        slider.set("Value", value);
        object.container_mut().set_child(slider);
        object.refresh();
        object.set_place([at[0], at[1], 200.0, 20.0], at);
        self.document.objects.push(object);
        id
    }

    /// A component with its ports; gives the ids of its outputs.
    fn component(
        &mut self,
        guid: Uuid,
        [name, nickname]: [&str; 2],
        at: [f32; 2],
        inputs: &[(&str, &str, Input)],
        outputs: &[(&str, &str)],
    ) -> Vec<Uuid> {
        let id = self.id();
        let mut object = Object::new_component(guid, name, nickname, id);
        for (name, nickname, input) in inputs {
            let stored = match input {
                Input::Wire(_) => None,
                Input::Plane => Some(Stored::Plane(Box::new(Plane::XY))),
                Input::Number(x) => Some(Stored::Number(*x)),
            };
            let persistent = stored.map(Persistent::item);
            let k = object.add_port(Side::Input, &NewPort { persistent, ..self.port(name, nickname) });
            if let Input::Wire(source) = input {
                object.set_sources(k, &[*source]).expect("the input was just added");
            }
        }
        let mut ids = Vec::new();
        for (name, nickname) in outputs {
            let port = self.port(name, nickname);
            ids.push(port.id);
            object.add_port(Side::Output, &port);
        }
        object.set_place([at[0] - 30.0, at[1] - 30.0, 90.0, 60.0], at);
        self.document.objects.push(object);
        ids
    }

    fn port(&mut self, name: &str, nickname: &str) -> NewPort {
        NewPort { id: self.id(), name: name.to_owned(), nickname: nickname.to_owned(), ..NewPort::default() }
    }
}

fn main() {
    let mut sheet = Sheet { document: Document::new(), next: 0 };
    let spacing = sheet.slider("spacing", 10.0, 40.0, 2, [40.0, 40.0]);
    let columns = sheet.slider("columns", 12.0, 60.0, 0, [40.0, 80.0]);
    let rows = sheet.slider("rows", 9.0, 60.0, 0, [40.0, 120.0]);
    let x = sheet.slider("attractor x", 35.0, 200.0, 2, [40.0, 200.0]);
    let y = sheet.slider("attractor y", 55.0, 200.0, 2, [40.0, 240.0]);
    let smallest = sheet.slider("smallest", 0.8, 10.0, 2, [40.0, 320.0]);
    let largest = sheet.slider("largest", 4.6, 10.0, 2, [40.0, 360.0]);

    let grid = sheet.component(
        uuid!("717a1e25-a075-4530-bc80-d43ecc2500d9"),
        ["Square", "SqGrid"],
        [330.0, 80.0],
        &[
            ("Plane", "P", Input::Plane),
            ("Size", "S", Input::Wire(spacing)),
            ("Extent X", "Ex", Input::Wire(columns)),
            ("Extent Y", "Ey", Input::Wire(rows)),
        ],
        &[("Cells", "C"), ("Points", "P")],
    );
    if let Some(object) = sheet.document.objects.last_mut() {
        object.set_mapping(Side::Output, 1, Mapping::Flatten).expect("the output was just added");
    }
    let attractor = sheet.component(
        uuid!("3581f42a-9592-4549-bd6b-1c0fc39d067b"),
        ["Construct Point", "Pt"],
        [330.0, 220.0],
        &[
            ("X coordinate", "X", Input::Wire(x)),
            ("Y coordinate", "Y", Input::Wire(y)),
            ("Z coordinate", "Z", Input::Number(0.0)),
        ],
        &[("Point", "Pt")],
    );
    let distance = sheet.component(
        uuid!("93b8e93d-f932-402c-b435-84be04d87666"),
        ["Distance", "Dist"],
        [480.0, 160.0],
        &[("Point A", "A", Input::Wire(grid[1])), ("Point B", "B", Input::Wire(attractor[0]))],
        &[("Distance", "D")],
    );
    let bounds = sheet.component(
        uuid!("f44b92b0-3b5b-493a-86f4-fd7408c3daf3"),
        ["Bounds", "Bnd"],
        [600.0, 240.0],
        &[("Numbers", "N", Input::Wire(distance[0]))],
        &[("Domain", "I")],
    );
    // The nearest circle is the largest: the target runs downwards.
    let radii = sheet.component(
        uuid!("d1a28e95-cf96-4936-bf34-8bf142d731bf"),
        ["Construct Domain", "Dom"],
        [600.0, 340.0],
        &[("Domain start", "A", Input::Wire(largest)), ("Domain end", "B", Input::Wire(smallest))],
        &[("Domain", "I")],
    );
    let mapped = sheet.component(
        uuid!("2fcc2743-8339-4cdf-a046-a1f17439191d"),
        ["Remap Numbers", "ReMap"],
        [720.0, 200.0],
        &[
            ("Value", "V", Input::Wire(distance[0])),
            ("Source", "S", Input::Wire(bounds[0])),
            ("Target", "T", Input::Wire(radii[0])),
        ],
        &[("Mapped", "R"), ("Clipped", "C")],
    );
    sheet.component(
        uuid!("807b86e3-be8d-4970-92b5-f8cdcb45b06b"),
        ["Circle", "Circles"],
        [860.0, 120.0],
        &[("Plane", "P", Input::Wire(grid[1])), ("Radius", "R", Input::Wire(mapped[0]))],
        &[("Circle", "C")],
    );
    // Only the circles are shown.
    for object in &mut sheet.document.objects {
        if object.nickname != "Circles" && !object.is_floating() {
            object.set_hidden(true);
        }
    }
    let definition = sheet.document.tree_mut().child_mut("Definition");
    if let Some(properties) = definition.and_then(|d| d.child_mut("DefinitionProperties")) {
        properties.set("Name", "Attractor");
        properties.set("Description", "Circles on a grid, larger the nearer they are to a point");
        properties.set("Date", ItemValue::Date(639_000_000_000_000_000));
    }
    print!("{}", sheet.document.to_ghx().expect("everything in it can be written"));
}
