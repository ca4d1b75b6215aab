//! New objects, as Grasshopper would write them.

use uuid::Uuid;

use super::port::{Access, PortPlace, Side};
use super::{Object, Persistent};
use crate::archive::{Chunk, ItemValue};

/// A port to be added to an object.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct NewPort {
    /// The id; it must be new in the document.
    pub id: Uuid,
    /// The name in full.
    pub name: String,
    /// The short name.
    pub nickname: String,
    /// What it takes or gives.
    pub description: String,
    /// How much of a tree the object takes at once.
    pub access: Access,
    /// Whether the object runs when no data comes.
    pub optional: bool,
    /// The parameter type. An object with a variable signature needs it; in others it is not stored.
    pub type_id: Option<Uuid>,
    /// The values it begins with.
    pub persistent: Option<Persistent>,
}

impl Object {
    /// A floating parameter: a slider, a panel, a Point parameter. What else it holds is up to
    /// [`container_mut`](Self::container_mut).
    pub fn new_parameter(component: Uuid, name: &str, nickname: &str, id: Uuid) -> Self {
        let mut object = Self::new_component(component, name, nickname, id);
        let container = object.container_mut();
        container.set("Optional", false);
        container.set("SourceCount", 0);
        object.refresh();
        object
    }

    /// A component without ports; [`add_port`](Self::add_port) gives it some.
    pub fn new_component(component: Uuid, name: &str, nickname: &str, id: Uuid) -> Self {
        let mut object = Self::new(component, name);
        let container = object.container_mut();
        container.set("Description", "");
        container.set("InstanceGuid", id);
        container.set("Name", name);
        container.set("NickName", nickname);
        object.refresh();
        object
    }

    /// Puts the object on the canvas: bounds x, y, width, height and the point it hangs from, in pixels.
    pub fn set_place(&mut self, bounds: [f32; 4], pivot: [f32; 2]) {
        let container = self.container_mut();
        if container.child("Attributes").is_none() {
            container.set_child(Chunk::new("Attributes"));
        }
        if let Some(attributes) = container.child_mut("Attributes") {
            attributes.set("Bounds", ItemValue::RectangleF(bounds));
            attributes.set("Pivot", ItemValue::PointF(pivot));
        }
        self.refresh();
    }

    /// Adds a port after those of its side and gives its index. With a `type_id`, or on an object whose
    /// signature is variable already, the port goes into the variable signature.
    pub fn add_port(&mut self, side: Side, port: &NewPort) -> usize {
        let variable = self.variable || port.type_id.is_some();
        let container = self.container_mut();
        if variable {
            if container.child("ParameterData").is_none() {
                let mut parameters = Chunk::new("ParameterData");
                parameters.set("InputCount", 0);
                parameters.set("OutputCount", 0);
                container.set_child(parameters);
            }
            if let Some(parameters) = container.child_mut("ParameterData") {
                let k = next(parameters, side.variable());
                let type_id = port.type_id.unwrap_or(super::ids::DATA);
                parameters.set(side.count(), k.saturating_add(1));
                parameters.set_at(side.type_id(), k, type_id);
                parameters.set_child(port.to_chunk(PortPlace::Variable(side, k)));
            }
        } else {
            let k = next(container, side.fixed());
            container.set_child(port.to_chunk(PortPlace::Fixed(side, k)));
        }
        self.refresh();
        self.ports(side).len().saturating_sub(1)
    }
}

/// The index after the largest among chunks of this name.
fn next(parent: &Chunk, name: &str) -> i32 {
    let indices = parent.chunks.iter().filter(|chunk| chunk.name == name).filter_map(|chunk| chunk.index);
    indices.max().map_or(0, |largest| largest.saturating_add(1))
}

impl NewPort {
    fn to_chunk(&self, place: PortPlace) -> Chunk {
        let (name, k) = match place {
            PortPlace::Own => ("Container", None),
            PortPlace::Fixed(side, k) => (side.fixed(), Some(k)),
            PortPlace::Variable(side, k) => (side.variable(), Some(k)),
        };
        let mut chunk = Chunk { name: name.to_owned(), index: k, ..Chunk::default() };
        chunk.set("Description", self.description.as_str());
        chunk.set("InstanceGuid", self.id);
        chunk.set("Name", self.name.as_str());
        chunk.set("NickName", self.nickname.as_str());
        chunk.set("Optional", self.optional);
        chunk.set("SourceCount", 0);
        match self.access {
            Access::Item => {}
            Access::List => chunk.set("Access", 1),
            Access::Tree => chunk.set("Access", 2),
        }
        if let Some(values) = &self.persistent {
            chunk.set_child(values.to_chunk(self.type_id.is_some_and(super::ids::takes_several)));
        }
        chunk
    }
}
