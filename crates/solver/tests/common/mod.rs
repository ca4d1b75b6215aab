//! Writes small definitions down in tests.

#![allow(dead_code, reason = "each test uses a part")]

use katydid_component::{Component, registry};
use katydid_definition::document::{Branch, Document, NewPort, Object, Persistent, Side, Stored};
use uuid::Uuid;

/// What an input has.
pub(crate) enum Input {
    /// Wires from outputs.
    Wires(Vec<Uuid>),
    /// Values of its own.
    Values(Vec<Stored>),
    /// Nothing.
    Nothing,
}

/// A wire from one output.
pub(crate) fn wire(id: Uuid) -> Input {
    Input::Wires(vec![id])
}

/// One number.
pub(crate) fn number(x: f64) -> Input {
    Input::Values(vec![Stored::Number(x)])
}

/// One value.
pub(crate) fn value(stored: Stored) -> Input {
    Input::Values(vec![stored])
}

/// A definition that is being written.
pub(crate) struct Sheet {
    /// What is written so far.
    pub(crate) document: Document,
    next: u128,
}

impl Default for Sheet {
    fn default() -> Self {
        katydid_components::link();
        Self { document: Document::new(), next: 0 }
    }
}

impl Sheet {
    fn id(&mut self) -> Uuid {
        self.next += 1;
        Uuid::from_u128(self.next)
    }

    /// Adds a component with its inputs, and gives the ids of its outputs.
    pub(crate) fn add(&mut self, name: &str, inputs: Vec<Input>) -> Vec<Uuid> {
        let component: &Component = registry::by_name(name).unwrap_or_else(|| panic!("no component {name}"));
        let id = self.id();
        if component.floating {
            let mut object = Object::new_parameter(component.guid, name, component.nick, id);
            for input in inputs {
                fill(&mut object, 0, input);
            }
            self.document.objects.push(object);
            return vec![id];
        }
        let mut object = Object::new_component(component.guid, name, component.nick, id);
        for (k, input) in inputs.into_iter().enumerate() {
            let declared = component.input(k).unwrap();
            let port = NewPort {
                id: self.id(),
                name: declared.name.to_owned(),
                nickname: declared.nick.to_owned(),
                ..NewPort::default()
            };
            object.add_port(Side::Input, &port);
            fill(&mut object, k, input);
        }
        let mut ids = Vec::new();
        for declared in component.outputs {
            let port = NewPort { id: self.id(), name: declared.name.to_owned(), ..NewPort::default() };
            object.add_port(Side::Output, &port);
            ids.push(port.id);
        }
        self.document.objects.push(object);
        ids
    }
}

pub(crate) fn fill(object: &mut Object, k: usize, input: Input) {
    match input {
        Input::Wires(ids) => object.set_sources(k, &ids).unwrap(),
        Input::Values(items) => {
            let persistent = Persistent { branches: vec![Branch { path: vec![0], items }] };
            object.set_persistent(k, Some(&persistent)).unwrap();
        }
        Input::Nothing => {}
    }
}
