use std::collections::HashMap;

use uuid::Uuid;

use super::{Document, Object, Side};

/// A wire: one entry in an input's list of sources.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Wire {
    /// The id of the output it comes from.
    pub from: Uuid,
    /// The index of the object it goes to.
    pub object: usize,
    /// The index of the input there.
    pub input: usize,
    /// The how-manieth source of that input it is.
    pub k: usize,
}

/// A port by its place in the document.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct PortRef {
    /// The index of the object.
    pub object: usize,
    /// The side.
    pub side: Side,
    /// The index among the ports of that side.
    pub port: usize,
}

/// Finds objects and ports by id. Of two with the same id the first counts.
#[derive(Debug, Clone, Default)]
pub struct Lookup {
    objects: HashMap<Uuid, usize>,
    inputs: HashMap<Uuid, PortRef>,
    outputs: HashMap<Uuid, PortRef>,
}

impl Lookup {
    /// The index of the object with this id.
    pub fn object(&self, id: Uuid) -> Option<usize> {
        self.objects.get(&id).copied()
    }

    /// The input with this id.
    pub fn input(&self, id: Uuid) -> Option<PortRef> {
        self.inputs.get(&id).copied()
    }

    /// The output with this id: what a wire's start names.
    pub fn output(&self, id: Uuid) -> Option<PortRef> {
        self.outputs.get(&id).copied()
    }
}

impl Document {
    /// All wires, by the objects they go to.
    pub fn wires(&self) -> impl Iterator<Item = Wire> {
        self.objects.iter().enumerate().flat_map(|(object, at)| {
            at.inputs.iter().enumerate().flat_map(move |(input, port)| {
                port.sources.iter().enumerate().map(move |(k, from)| Wire { from: *from, object, input, k })
            })
        })
    }

    /// The maps from ids to objects and ports, as the document stands now.
    pub fn lookup(&self) -> Lookup {
        let mut lookup = Lookup::default();
        for (index, object) in self.objects.iter().enumerate() {
            lookup.objects.entry(object.id).or_insert(index);
            for side in [Side::Input, Side::Output] {
                let map = if side == Side::Input { &mut lookup.inputs } else { &mut lookup.outputs };
                for (k, port) in object.ports(side).iter().enumerate() {
                    map.entry(port.id).or_insert(PortRef { object: index, side, port: k });
                }
            }
        }
        lookup
    }

    /// What is not as it should be, in plain words: ids used twice, wires from nowhere, groups of nothing.
    pub fn problems(&self) -> Vec<String> {
        let mut problems = self.notes.clone();
        if let Some(announced) = self.announced
            && usize::try_from(announced) != Ok(self.numbers.len())
        {
            problems.push(format!("the file announces {announced} objects and has {}", self.numbers.len()));
        }
        let lookup = self.lookup();
        for (index, object) in self.objects.iter().enumerate() {
            if object.component.is_nil() {
                problems.push(format!("{} has no component type", describe(object, index)));
            }
            if object.id.is_nil() {
                problems.push(format!("{} has no id", describe(object, index)));
            } else if let Some(other) = lookup.object(object.id).filter(|other| *other != index) {
                let first = self.objects.get(other).map(|object| describe(object, other)).unwrap_or_default();
                problems.push(format!("{} has the same id as {first}", describe(object, index)));
            }
            for (k, port) in object.outputs.iter().enumerate() {
                let found = lookup.output(port.id);
                if !object.is_floating() && found.is_some_and(|p| p.object != index || p.port != k) {
                    let name = &port.name;
                    problems
                        .push(format!("{}: the id of output {name} is used twice", describe(object, index)));
                }
            }
        }
        for wire in self.wires() {
            if lookup.output(wire.from).is_some() {
                continue;
            }
            let Some(object) = self.objects.get(wire.object) else { continue };
            let input = object.inputs.get(wire.input).map_or("", |port| port.name.as_str());
            let why = match (lookup.input(wire.from), lookup.object(wire.from)) {
                (Some(_), _) => "an input, not an output",
                (_, Some(_)) => "an object, not one of its outputs",
                _ => "something that is not in the document",
            };
            problems.push(format!("{}: a wire into {input} comes from {why}", describe(object, wire.object)));
        }
        problems
    }
}

/// The object's name and number, to find it by.
fn describe(object: &Object, index: usize) -> String {
    if object.title().is_empty() {
        format!("object {index}")
    } else {
        format!("{} ({index})", object.title())
    }
}
