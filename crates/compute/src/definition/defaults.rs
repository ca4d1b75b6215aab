//! What the inputs of a definition have when nobody fills them in.

use std::collections::HashSet;

use katydid_component::registry;
use katydid_data::Tree;
use katydid_definition::document::{Document, Lookup};
use katydid_solver::{Engine, Options};

use super::Input;

/// The data of each input: what it keeps, or what comes over its wires from parameters, sliders, panels and lists,
/// through relays. What would have to be computed is left out, as Rhino.Compute leaves it out.
pub(super) fn of(document: &Document, inputs: &[Input]) -> Vec<Tree> {
    let lookup = document.lookup();
    let mut needed = HashSet::new();
    let at_rest: Vec<bool> =
        inputs.iter().map(|input| gather(document, &lookup, input.object, &mut needed)).collect();
    let mut part = Document::new();
    let mut places: Vec<usize> = needed.into_iter().collect();
    places.sort_unstable();
    part.objects = places.iter().filter_map(|place| document.objects.get(*place).cloned()).collect();
    let mut engine = Engine::new(part, Options::default());
    engine.solve();
    let tree = |input: &Input| {
        let place = places.binary_search(&input.object).ok()?;
        engine.report(place)?.outputs.get(input.port).cloned()
    };
    let default = |(input, at_rest): (&Input, bool)| {
        if at_rest { tree(input) } else { of_component(document, input) }
    };
    inputs.iter().zip(at_rest).map(default).map(Option::unwrap_or_default).collect()
}

/// What a component has at an input that nobody wired.
fn of_component(document: &Document, input: &Input) -> Option<Tree> {
    let object = document.objects.get(input.object).filter(|object| !object.is_floating())?;
    let port = registry::by_guid(object.component)?.input(input.port)?;
    port.default.map(|default| default())
}

/// Adds an object and all that it reads; `false` when a component or a loop is among them, in which case nothing is
/// added.
fn gather(document: &Document, lookup: &Lookup, object: usize, needed: &mut HashSet<usize>) -> bool {
    let mut found = HashSet::new();
    let mut stack = vec![object];
    while let Some(at) = stack.pop() {
        let Some(object) = document.objects.get(at).filter(|object| object.is_floating()) else {
            return false;
        };
        if !found.insert(at) {
            continue;
        }
        let sources = object.inputs.iter().flat_map(|port| &port.sources);
        stack.extend(sources.filter_map(|source| lookup.output(*source)).map(|port| port.object));
    }
    needed.extend(found);
    true
}
