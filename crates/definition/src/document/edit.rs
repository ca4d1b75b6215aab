//! Changes to an object in place: the chunk is changed where it must be and nowhere else.

use uuid::Uuid;

use super::port::{Mapping, Port, Side};
use super::{Object, Persistent, ids};
use crate::archive::{Chunk, ItemValue};
use crate::{Error, Result};

impl Object {
    /// The error of an edit that the object does not take.
    pub(super) fn refuse(&self, reason: impl Into<String>) -> Error {
        Error::Edit { object: self.title().to_owned(), reason: reason.into() }
    }

    /// Gives the object a nickname.
    pub fn set_nickname(&mut self, nickname: &str) {
        self.container_mut().set("NickName", nickname);
        self.refresh();
    }

    /// Gives the object an id.
    pub fn set_id(&mut self, id: Uuid) {
        self.container_mut().set("InstanceGuid", id);
        self.refresh();
    }

    /// Disables or enables the object.
    pub fn set_locked(&mut self, locked: bool) {
        self.flag("Locked", locked);
    }

    /// Turns the preview off or on.
    pub fn set_hidden(&mut self, hidden: bool) {
        self.flag("Hidden", hidden);
    }

    /// Grasshopper writes these flags only when they are set.
    fn flag(&mut self, name: &str, on: bool) {
        let container = self.container_mut();
        if on {
            container.set(name, true);
        } else {
            container.remove(name);
        }
        self.refresh();
    }

    /// Moves the object on the canvas, by pixels.
    pub fn move_by(&mut self, dx: f32, dy: f32) {
        let moved = |chunk: &mut Chunk| {
            let Some(attributes) = chunk.child_mut("Attributes") else { return };
            if let Some([x, y, w, h]) = attributes.canvas_rectangle("Bounds") {
                attributes.set("Bounds", ItemValue::RectangleF([x + dx, y + dy, w, h]));
            }
            if let Some([x, y]) = attributes.canvas_point("Pivot") {
                attributes.set("Pivot", ItemValue::PointF([x + dx, y + dy]));
            }
        };
        let places: Vec<_> = self.inputs.iter().chain(&self.outputs).map(|port| port.place).collect();
        let floating = self.is_floating();
        let container = self.container_mut();
        moved(container);
        if !floating {
            places.into_iter().filter_map(|place| place.find_mut(container).map(moved)).count();
        }
        self.refresh();
    }

    /// The chunk of a port, to be changed.
    fn port_mut(&mut self, side: Side, k: usize) -> Result<(Port, &mut Chunk)> {
        let Some(port) = self.ports(side).get(k).cloned() else {
            return Err(self.refuse(format!("there is no {side:?} {k}").to_lowercase()));
        };
        let error = self.refuse("the port's chunk is gone");
        let chunk = port.place.find_mut(self.container_mut()).ok_or(error)?;
        Ok((port, chunk))
    }

    /// Wires an input to these outputs, in this order, in place of what it was wired to.
    ///
    /// # Errors
    /// When there is no such input.
    pub fn set_sources(&mut self, input: usize, sources: &[Uuid]) -> Result<()> {
        let (_, chunk) = self.port_mut(Side::Input, input)?;
        chunk.remove("Source");
        for (k, source) in (0..).zip(sources) {
            chunk.set_at("Source", k, *source);
        }
        chunk.set("SourceCount", i32::try_from(sources.len()).unwrap_or(i32::MAX));
        self.refresh();
        Ok(())
    }

    /// Sets flatten or graft on a port.
    ///
    /// # Errors
    /// When there is no such port.
    pub fn set_mapping(&mut self, side: Side, port: usize, mapping: Mapping) -> Result<()> {
        let (_, chunk) = self.port_mut(side, port)?;
        match mapping {
            Mapping::None => {
                chunk.remove("Mapping");
            }
            Mapping::Flatten => chunk.set("Mapping", 1),
            Mapping::Graft => chunk.set("Mapping", 2),
        }
        self.refresh();
        Ok(())
    }

    /// Keeps values in an input, in place of those it kept; `None` takes them out. Wires into the input are left
    /// as they are and go before these values.
    ///
    /// # Errors
    /// When there is no such input.
    pub fn set_persistent(&mut self, input: usize, values: Option<&Persistent>) -> Result<()> {
        let component = self.component;
        let (port, chunk) = self.port_mut(Side::Input, input)?;
        let several = [ids::DATA, ids::GEOMETRY];
        let type_names = port.type_id.is_some_and(|id| several.contains(&id))
            || several.contains(&component)
            || chunk.child("PersistentData").is_some_and(has_type_names);
        // The plain list of Grasshopper 0.6 makes way for the tree.
        if chunk.remove("PersistentCount") {
            chunk.remove_children("Data");
        }
        match values {
            Some(values) => chunk.set_child(values.to_chunk(type_names)),
            None => {
                chunk.remove_children("PersistentData");
            }
        }
        self.refresh();
        Ok(())
    }
}

/// Whether the items of a `PersistentData` chunk say their types.
fn has_type_names(data: &Chunk) -> bool {
    let items = data.chunks.iter().flat_map(|branch| &branch.chunks);
    items.into_iter().any(|item| item.item("TypeName").is_some())
}

/// Puts a number where one is, in the width that is there; where none is, in 64 bits.
pub(super) fn set_number(chunk: &mut Chunk, name: &str, x: f64) -> Option<()> {
    let value = match chunk.item(name) {
        Some(ItemValue::Decimal(old)) => {
            let places = (0..=old.scale().max(15)).find(|scale| {
                crate::archive::Decimal::from_f64(x, *scale).is_some_and(|decimal| decimal.to_f64() == x)
            });
            ItemValue::Decimal(crate::archive::Decimal::from_f64(x, places.unwrap_or(15))?)
        }
        Some(ItemValue::Single(_)) => ItemValue::Single(x as f32),
        Some(ItemValue::Int32(_)) if x.fract() == 0.0 && x.abs() <= f64::from(i32::MAX) => {
            ItemValue::Int32(x as i32)
        }
        _ => ItemValue::Double(x),
    };
    chunk.set(name, value);
    Some(())
}
