//! Inputs and outputs as the canvas shows them.

use katydid_component::{Component, registry};
use katydid_data::Kind;
use katydid_definition::document::{Access, Mapping, Object, Port, PortPlace, Side, TypeHint, WireDisplay};

use crate::protocol::{MappingView, PortView, WireView};
use crate::view::size;

/// The ports of one side.
pub(super) fn ports(object: &Object, side: Side) -> Vec<PortView> {
    if !size::shows(object, side) {
        return Vec::new();
    }
    let component = registry::by_guid(object.component);
    let places = size::grips(object, side);
    let ports = object.ports(side).iter().enumerate();
    ports
        .map(|(k, port)| view(object, component, side, k, port, places.get(k).copied().unwrap_or(0.0)))
        .collect()
}

fn view(
    object: &Object,
    component: Option<&Component>,
    side: Side,
    k: usize,
    port: &Port,
    at: f32,
) -> PortView {
    let declared = component.and_then(|c| if side == Side::Input { c.input(k) } else { c.output(k) });
    // A floating parameter is one port: its modifiers stand with its input and work on what it gives.
    let shown = if object.is_floating() { object.inputs.first().unwrap_or(port) } else { port };
    let m = &shown.modifiers;
    PortView {
        id: port.id,
        name: port.name.clone(),
        nickname: if port.nickname.is_empty() { port.name.clone() } else { port.nickname.clone() },
        kind: kind(port, declared.map(|d| d.kind)).name().to_owned(),
        access: match (port.access, declared.map(|d| d.access)) {
            (Access::Tree, _) | (_, Some(katydid_component::Access::Tree)) => "tree",
            (Access::List, _) | (_, Some(katydid_component::Access::List)) => "list",
            _ => "item",
        }
        .to_owned(),
        optional: port.optional || declared.is_some_and(|d| d.optional),
        at,
        sources: if side == Side::Input { port.sources.clone() } else { Vec::new() },
        wire: match shown.wire_display {
            WireDisplay::Normal => WireView::Normal,
            WireDisplay::Faint => WireView::Faint,
            WireDisplay::Hidden => WireView::Hidden,
        },
        mapping: match m.mapping {
            Mapping::None => MappingView::None,
            Mapping::Flatten => MappingView::Flatten,
            Mapping::Graft => MappingView::Graft,
        },
        reverse: m.reverse,
        simplify: m.simplify,
        reparameterize: m.reparameterize,
        invert: m.invert,
        degrees: m.degrees,
        unitize: m.unitize,
        expression: m.expression.clone(),
        kept: if side == Side::Input { kept(object, port) } else { 0 },
        principal: side == Side::Input && object.principal == Some(k),
        removable: is_removable(object, component, side, k, port),
        hint: TypeHint::chosen(port.type_hint).map(|hint| hint.name.to_owned()),
    }
}

/// The type of a port's items: the component's own word for it, else that of its parameter type.
pub(crate) fn kind(port: &Port, declared: Option<Kind>) -> Kind {
    declared.or_else(|| parameter_kind(port.type_id?)).unwrap_or(Kind::Generic)
}

/// The type of the items of a floating parameter of that type id.
pub(crate) fn parameter_kind(type_id: uuid::Uuid) -> Option<Kind> {
    registry::by_guid(type_id)?.outputs.first().map(|port| port.kind)
}

/// How many values are kept in a port.
fn kept(object: &Object, port: &Port) -> u32 {
    if !port.has_persistent {
        return 0;
    }
    // Counted without being read: there may be a whole model in a port.
    let Some(chunk) = port.chunk(object.container()) else { return 0 };
    let count = match chunk.child("PersistentData") {
        Some(data) => data.children("Branch").into_iter().map(|branch| branch.children("Item").len()).sum(),
        None => chunk.children("Data").len(),
    };
    u32::try_from(count).unwrap_or(u32::MAX)
}

/// Whether a port can be taken away: of a variable side, and not the last that the component needs.
pub(crate) fn is_removable(
    object: &Object,
    component: Option<&Component>,
    side: Side,
    k: usize,
    port: &Port,
) -> bool {
    let PortPlace::Variable(..) = port.place else { return false };
    let fixed = port.chunk(object.container()).is_some_and(|chunk| chunk.bool("Mutable") == Some(false));
    !fixed && is_variable(object, component, side) && k >= least(component, side)
}

/// Whether ports of that side can be added.
pub(crate) fn is_variable(object: &Object, component: Option<&Component>, side: Side) -> bool {
    let Some(component) = component else { return object.script().is_some() };
    let ports = if side == Side::Input { component.inputs } else { component.outputs };
    ports.last().is_some_and(|port| port.many)
}

/// How many ports of that side are fixed.
fn least(component: Option<&Component>, side: Side) -> usize {
    let ports = component.map_or(&[][..], |c| if side == Side::Input { c.inputs } else { c.outputs });
    ports.iter().filter(|port| !port.many).count()
}
