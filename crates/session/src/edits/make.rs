//! New objects, as Grasshopper writes them.

use katydid_component::{Component, registry};
use katydid_data::DateTime;
use katydid_definition::archive::{Chunk, Colour, Decimal, ItemValue};
use katydid_definition::document::{NewPort, Object, Side, ids};
use katydid_definition::kd::{self, Catalogue, Facts, PortFacts};
use uuid::{Uuid, uuid};

use crate::view::size;
use crate::{Refusal, Registry};

const ENTWINE: Uuid = uuid!("c9785b8e-2f30-4f90-8ee3-cca710f82402");
const SORT_LIST: Uuid = uuid!("6f93d366-919f-4dda-a35e-ba03dd62799b");
const DATA_DAM: Uuid = uuid!("65283518-ad00-49d3-87fb-f76823ebb162");
const SIFT_PATTERN: Uuid = uuid!("3249222f-f536-467a-89f4-f0353fba455a");
const STREAM_GATE: Uuid = uuid!("71fcc052-6add-4d70-8d97-cfb37ea9d169");

/// A new object of a component type, its ports as they begin, without a place.
///
/// # Errors
/// When there is no such component, or it cannot begin empty, as a cluster.
pub fn object(component: Uuid, id: Uuid) -> Result<Object, Refusal> {
    match component {
        ids::GROUP => return Ok(annotation(component, "Group", "", id)),
        ids::SCRIBBLE => return Ok(scribble(id)),
        ids::CLUSTER | ids::SKETCH => {
            return Err(Refusal::Senseless("a cluster or sketch cannot begin empty".to_owned()));
        }
        ids::RELAY => return Ok(relay(id)),
        ids::CLUSTER_INPUT => return Ok(hook(component, "Cluster Input", "In", id)),
        ids::CLUSTER_OUTPUT => return Ok(hook(component, "Cluster Output", "Out", id)),
        _ => {}
    }
    let unknown = || match registry::unsupported(component) {
        Some(known) => Refusal::Senseless(format!("{} is not supported: {}", known.name, known.reason)),
        None => Refusal::Senseless(format!("there is no component with the type id {component}")),
    };
    let known = registry::by_guid(component).ok_or_else(unknown)?;
    let facts = Registry.by_guid(component).ok_or_else(unknown)?;
    let mut object = if known.floating {
        Object::new_parameter(component, known.name, known.nick, id)
    } else {
        Object::new_component(component, known.name, known.nick, id)
    };
    object.container_mut().set("Description", known.help);
    if known.floating {
        floating(&mut object, &facts)?;
    } else {
        for side in [Side::Input, Side::Output] {
            for k in 0..begins_with(known, side) {
                add(&mut object, &facts, side, k, port_id(id, side, k));
            }
        }
    }
    begin(&mut object);
    Ok(object)
}

/// The id of a port that an object begins with.
fn port_id(object: Uuid, side: Side, k: usize) -> Uuid {
    kd::derived_id(object, &format!("{} {k}", if side == Side::Input { "in" } else { "out" }))
}

/// How many ports an object of that type begins with.
fn begins_with(component: &Component, side: Side) -> usize {
    let ports = if side == Side::Input { component.inputs } else { component.outputs };
    let fixed = ports.iter().filter(|port| !port.many).count();
    if fixed == ports.len() {
        return fixed;
    }
    let many_inputs = component.has_variable_inputs();
    fixed
        + match component.guid {
            ENTWINE => 3,
            SORT_LIST | DATA_DAM => 1,
            SIFT_PATTERN | STREAM_GATE => 2,
            _ if side == Side::Input || many_inputs => 2,
            _ => 1,
        }
}

/// The values of a parameter, where it begins with some.
fn floating(object: &mut Object, facts: &Facts) -> Result<(), Refusal> {
    if let Some(values) = facts.inputs.first().and_then(|port| port.default.as_ref()) {
        object.set_persistent(0, Some(values))?;
    }
    Ok(())
}

/// Adds the port that stands at `k` on a side of objects of that type, with an id.
pub(super) fn add(object: &mut Object, facts: &Facts, side: Side, k: usize, id: Uuid) {
    let ports = if side == Side::Input { &facts.inputs } else { &facts.outputs };
    let Some(port) = port(ports, k) else { return };
    let variable = facts.is_variable();
    object.add_port(side, &NewPort { id, type_id: port.type_id.filter(|_| variable), ..port_of(port) });
}

/// What is known of the port that stands at `k`, with its own name where one stands for many.
fn port(ports: &[PortFacts], k: usize) -> Option<PortFacts> {
    let fixed = ports.iter().filter(|port| !port.many).count();
    if k < fixed {
        return ports.get(k).cloned();
    }
    let many = ports.last().filter(|port| port.many)?;
    let name = |first: &str| kd::counted(first, k - fixed);
    Some(PortFacts { name: name(&many.name), nickname: name(&many.nickname), ..many.clone() })
}

/// The port as it is added.
fn port_of(port: PortFacts) -> NewPort {
    NewPort {
        id: Uuid::nil(),
        name: port.name,
        nickname: port.nickname,
        description: port.description,
        access: port.access,
        optional: port.optional,
        type_id: port.type_id,
        persistent: port.default,
    }
}

/// Puts an object on the canvas with its middle at a point, in its natural size.
pub(super) fn place(object: &mut Object, at: [f32; 2]) {
    let [w, h] = size::natural(object);
    let [dx, dy] = size::hang(object, [w, h]);
    let corner = [(at[0] - 0.5 * w).round(), (at[1] - 0.5 * h).round()];
    if object.component == ids::SCRIBBLE {
        super::objects::shape_scribble(object, corner);
        return;
    }
    object.set_place([corner[0], corner[1], w, h], [corner[0] + dx, corner[1] + dy]);
}

/// Gives an object that is on the canvas the size that its names and ports ask for; its left top corner stays.
pub(super) fn fit(object: &mut Object) {
    let (Some([x, y, ..]), false) = (object.bounds, object.is_annotation()) else { return };
    let [w, h] = size::natural(object);
    let [dx, dy] = size::hang(object, [w, h]);
    let places: Vec<_> = object.inputs.iter().chain(&object.outputs).map(|port| port.place).collect();
    if !object.is_floating() {
        // The ports stand elsewhere now; where is plain from the object's own bounds.
        let container = object.container_mut();
        for place in places {
            if let Some(chunk) = place.find_mut(container) {
                chunk.remove_children("Attributes");
            }
        }
    }
    object.set_place([x, y, w, h], [x + dx, y + dy]);
}

fn annotation(component: Uuid, name: &str, nickname: &str, id: Uuid) -> Object {
    let mut object = Object::new_component(component, name, nickname, id);
    object.container_mut().set_child(Chunk::new("Attributes"));
    if component == ids::GROUP {
        let container = object.container_mut();
        container.set("Border", 1);
        container.set("Colour", Colour::new(150, 170, 135, 255));
        container.set("ID_Count", 0);
    }
    object.refresh();
    object
}

fn scribble(id: Uuid) -> Object {
    let mut object = annotation(ids::SCRIBBLE, "Scribble", "Scribble", id);
    let container = object.container_mut();
    container.set("Text", "Doubleclick Me!");
    container.set("Font", "Microsoft Sans Serif");
    container.set("Size", ItemValue::Single(25.0));
    container.set("Bold", false);
    container.set("Italic", false);
    object.refresh();
    object
}

fn relay(id: Uuid) -> Object {
    let mut object = Object::new_parameter(ids::RELAY, "Relay", "", id);
    object.container_mut().set("Description", "A wire relay object");
    object.container_mut().set("Access", 2);
    object.refresh();
    object
}

fn hook(component: Uuid, name: &str, nickname: &str, id: Uuid) -> Object {
    Object::new_parameter(component, name, nickname, id)
}

/// A number as those controls keep it that count in tenths.
pub(super) fn decimal(x: f64, places: u32) -> ItemValue {
    Decimal::from_f64(x, places).map_or(ItemValue::Double(x), ItemValue::Decimal)
}

/// What controls are when they are new, by the measures of Grasshopper.
fn begin(object: &mut Object) {
    let component = object.component;
    let container = object.container_mut();
    match component {
        ids::NUMBER_SLIDER => {
            let mut slider = Chunk::new("Slider");
            slider.set("Digits", 3);
            slider.set("GripDisplay", 1);
            slider.set("Interval", 0);
            slider.set("Max", 1.0);
            slider.set("Min", 0.0);
            slider.set("SnapCount", 0);
            slider.set("Value", 0.25);
            container.set_child(slider);
        }
        ids::PANEL => {
            container.set("ScrollRatio", 0.0);
            container.set("UserText", "Double click to edit panel content…");
            let mut panel = Chunk::new("PanelProperties");
            panel.set("Colour", Colour::new(255, 255, 250, 90));
            for (name, on) in [
                ("DrawIndices", true),
                ("DrawPaths", true),
                ("Multiline", true),
                ("SpecialCodes", false),
                ("Stream", false),
                ("Wrap", true),
            ] {
                panel.set(name, on);
            }
            container.set_child(panel);
        }
        ids::BOOLEAN_TOGGLE => container.set("ToggleValue", false),
        ids::BOOLEAN_TOGGLE_2 => container.set("SwitchValue", false),
        ids::BUTTON => {
            container.set("ExpressionNormal", "False");
            container.set("ExpressionPressed", "True");
        }
        ids::COLOUR_SWATCH => container.set("SwatchColor", Colour::new(255, 255, 255, 255)),
        ids::COLOUR_PICKER => container.set("PickedColour", Colour::new(255, 0, 0, 0)),
        ids::VALUE_LIST => {
            let items = ["One", "Two", "Three", "Four"];
            for (k, name) in (0..).zip(items) {
                let mut item = Chunk::indexed("ListItem", k);
                item.set("Expression", (k + 1).to_string());
                item.set("Name", name);
                item.set("Selected", k == 0);
                container.set_child(item);
            }
            container.set("ListCount", 4);
            container.set("ListMode", 1);
        }
        ids::MD_SLIDER => {
            container.set("SliderMode", 2);
            container.set("slider_value", ItemValue::Point3d([0.5, 0.5, 0.5]));
            for axis in ["x_domain", "y_domain", "z_domain"] {
                container.set(axis, ItemValue::Interval1d([0.0, 1.0]));
            }
        }
        ids::CONTROL_KNOB => {
            let mut dial = Chunk::new("DialData");
            dial.set("Decimals", 2);
            dial.set("Limit", false);
            dial.set("Maximum", 100.0);
            dial.set("Minimum", 0.0);
            dial.set("Range", 10.0);
            dial.set("Value", 0.0);
            container.set_child(dial);
        }
        ids::DIGIT_SCROLLER => {
            let mut scroller = Chunk::new("Scroller");
            scroller.set("Digits", 12);
            scroller.set("Prefix", "");
            scroller.set("Radix", 6);
            scroller.set("Suffix", "");
            scroller.set("Value", decimal(0.0, 6));
            container.set_child(scroller);
        }
        // The hand that places one sets it to the present.
        ids::CALENDAR => {
            let day = DateTime::on([2000, 1, 1]).unwrap_or_default();
            container.set("LocalDate", ItemValue::Date(day.ticks + 1));
            let mut attributes = Chunk::new("Attributes");
            attributes.set("DisplayMonth", decimal(1.0, 0));
            attributes.set("DisplayYear", decimal(2000.0, 0));
            container.set_child(attributes);
        }
        ids::CLOCK => container.set("LocalTime", ItemValue::Date(DateTime::DAY / 2)),
        ids::GENE_POOL => {
            let mut pool = Chunk::new("GeneData");
            pool.set("Count", 10);
            pool.set("Decimals", 2);
            pool.set("Maximum", 100.0);
            pool.set("Minimum", 0.0);
            for k in 0..10 {
                pool.set_at("Value", k, decimal(50.0, 2));
            }
            container.set_child(pool);
        }
        ids::GRAPH_MAPPER => {
            let mut domain = Chunk::new("Domain");
            for (name, x) in [("x0", 0.0), ("x1", 1.0), ("y0", 0.0), ("y1", 1.0)] {
                domain.set(name, x);
            }
            let mut graph = Chunk::new("LocalGraph");
            graph.set("LockGrips", false);
            graph.set_child(domain);
            container.set_child(graph);
        }
        ids::GRADIENT => super::lists::put_gradient(
            container,
            &[(0.0, [255, 0, 0, 255]), (0.5, [255, 255, 0, 255]), (1.0, [0, 255, 0, 255])],
        ),
        ids::EXPRESSION => container.set("Expression", "x + y"),
        ids::DATA_RECORDER => {
            container.set("RecordData", true);
            container.set("DataLimit", -1);
        }
        ids::PATH_MAPPER => {
            let mut rules = Chunk::new("lexers");
            rules.set("lexer_count", 0);
            container.set_child(rules);
        }
        ids::CHERRY_PICKER => {
            let mut path = Chunk::new("TreePath");
            path.set("path", "{0}");
            container.set_child(path);
            container.set("ListIndex", 0);
        }
        ids::IMAGE_SAMPLER => {
            container.set("FilePath", "");
            container.set("SaveInFile", false);
            container.set("Filter", "Colour");
            for (name, x) in [("Umin", 0.0), ("Umax", 1.0), ("Vmin", 0.0), ("Vmax", 1.0)] {
                container.set(name, x);
            }
        }
        _ => {}
    }
    object.refresh();
}
