//! The outputs of a definition, and which of them would be missing with what is not supported.

use std::collections::{BTreeSet, HashMap};

use katydid_definition::document::{Document, Object, Special, ids};
use katydid_solver::is_note;
use serde::Serialize;
use uuid::Uuid;

use super::Unsupported;
use super::hanging::{Hanging, Missing};

/// What a definition gives, and how much of it does not need what is not supported.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Default)]
pub struct Outputs {
    /// How many outputs there are.
    pub count: usize,
    /// Whether the definition marks them: Context Bake, Context Print, groups called `RH_OUT`. Where it does not, outputs are
    /// what no wire leads on from.
    pub marked: bool,
    /// How many need nothing that is not supported, and so are whole.
    pub whole: usize,
    /// The others, in the order of the file.
    pub missing: Vec<MissingOutput>,
}

/// An output that would be missing, or wrong.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct MissingOutput {
    /// What it is called: the label of its group, the name of its input, else the object's title.
    pub name: String,
    /// The type of its object.
    pub component: String,
    /// The id of its object.
    pub id: Uuid,
    /// The names of what is not supported and it needs, most used first.
    pub needs: Vec<String>,
}

/// An output: its name and the place of its object.
struct Output {
    name: String,
    object: usize,
}

impl Outputs {
    /// Looks at all outputs of a document; counts in each unsupported type how many hang on it.
    pub(super) fn of(document: &Document, unsupported: &mut [Unsupported]) -> Self {
        let mut missing = Missing::new();
        for (place, kind) in unsupported.iter_mut().enumerate() {
            kind.outputs = 0;
            kind.objects.iter().for_each(|id| missing.entry(*id).or_default().push(place));
        }
        let marked = marked(document);
        let (is_marked, outputs) = if marked.is_empty() { (false, ends(document)) } else { (true, marked) };
        let mut found = Self { count: outputs.len(), marked: is_marked, ..Self::default() };
        let hanging = Hanging::of(document, &missing);
        for output in outputs {
            let needs = hanging.at(output.object).missing;
            let Some(object) = document.objects.get(output.object).filter(|_| !needs.is_empty()) else {
                found.whole += 1;
                continue;
            };
            let mut names = Vec::new();
            for place in needs.iter() {
                if let Some(kind) = unsupported.get_mut(place) {
                    kind.outputs += 1;
                    names.push(kind.name.clone());
                }
            }
            let (component, id) = (object.name.clone(), object.id);
            found.missing.push(MissingOutput { name: output.name, component, id, needs: names });
        }
        found
    }
}

/// The outputs that a definition marks.
fn marked(document: &Document) -> Vec<Output> {
    let lookup = document.lookup();
    let mut outputs = Vec::new();
    for (index, object) in document.objects.iter().enumerate() {
        if object.locked {
            continue;
        }
        if [ids::CONTEXT_BAKE, ids::CONTEXT_PRINT].contains(&object.component) {
            let name = object.inputs.first().map_or_else(|| object.title(), |port| &port.nickname);
            outputs.push(Output { name: name.to_owned(), object: index });
        }
        if let Some(Special::Group(group)) = object.special()
            && group.marks_output()
        {
            // Ids that lead nowhere are left over from objects that are gone.
            let first = group.members.iter().find_map(|id| lookup.object(*id));
            outputs.extend(first.map(|object| Output { name: group.marked_name().to_owned(), object }));
        }
    }
    outputs
}

/// The objects that no wire leads on from: components, and parameters that read something. Annotations and what is disabled give
/// nothing.
fn ends(document: &Document) -> Vec<Output> {
    let read: BTreeSet<Uuid> = document.wires().map(|wire| wire.from).collect();
    let mut titles: HashMap<&str, usize> = HashMap::new();
    let is_end = |object: &Object| {
        let reads = object.inputs.iter().any(|port| !port.sources.is_empty());
        !object.locked
            && !object.is_annotation()
            && !is_note(document, object)
            && object.outputs.iter().all(|port| !read.contains(&port.id))
            && (reads || !object.is_floating())
    };
    let all = document.objects.iter().enumerate().filter(|(_, object)| is_end(object));
    let mut outputs = Vec::new();
    for (index, object) in all {
        // Panels have one name as a rule: their numbers tell them apart.
        let number = titles.entry(object.title()).or_default();
        *number += 1;
        let name =
            if *number == 1 { object.title().to_owned() } else { format!("{} {number}", object.title()) };
        outputs.push(Output { name, object: index });
    }
    outputs
}
