//! What objects read, asked for after a solve.

use katydid_data::Tree;
use katydid_definition::document::Lookup;

use crate::{Engine, collect};

/// The data that objects of a solved document take in. Solving keeps outputs only; who draws what an object shows and
/// does not give on, as Vector Display does, asks here.
#[derive(Debug)]
pub struct Inputs<'a> {
    engine: &'a Engine,
    lookup: Lookup,
}

impl<'a> Inputs<'a> {
    /// The inputs of the objects of that engine's document.
    pub fn new(engine: &'a Engine) -> Self {
        Self { engine, lookup: engine.document().lookup() }
    }

    /// The data of each input of object `index`, cast to the input's type and after its modifiers: from its wires,
    /// else what the file keeps, else the component's default. An input without data is an empty tree; no trees for an
    /// object that is not there.
    pub fn of(&self, index: usize) -> Vec<Tree> {
        let Some(object) = self.engine.document().objects.get(index) else { return Vec::new() };
        let found = crate::of_object(self.engine.document(), object);
        let options = self.engine.options();
        let mut inputs = Vec::with_capacity(object.inputs.len());
        for (k, port) in object.inputs.iter().enumerate() {
            let declared = found.as_ref().and_then(|found| found.input(k));
            if let Some(tree) = self.engine.given.get(&(index, k)) {
                inputs.push(collect::brought(object, port, declared, tree, options).tree);
                continue;
            }
            let source = |id: &uuid::Uuid| {
                let from = self.lookup.output(*id)?;
                self.engine.report(from.object)?.outputs.get(from.port)
            };
            let wired: Vec<&Tree> = port.sources.iter().filter_map(source).collect();
            inputs.push(collect::port(object, port, declared, &wired, options).tree);
        }
        let Some(found) = found else { return inputs };
        let mut inputs = found.arranged(inputs);
        // An old file may know fewer inputs than the component has today.
        let missing = found.component.inputs.iter().skip(inputs.len());
        let defaults = missing.filter(|port| !port.many).map(|port| port.default);
        inputs.extend(defaults.map(|default| default.map_or_else(Tree::empty, |default| default())));
        inputs
    }
}
