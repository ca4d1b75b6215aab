//! What hangs on what: the inputs that an output can depend on.

use katydid_definition::document::{Document, Special};

use crate::{Output, StudyError, Variable};

/// Which objects lead to `target` by wires, itself among them.
pub(crate) fn upstream(document: &Document, target: usize) -> Vec<bool> {
    let lookup = document.lookup();
    let mut found = vec![false; document.objects.len()];
    let mut stack = vec![target];
    while let Some(at) = stack.pop() {
        let Some(seen) = found.get_mut(at) else { continue };
        if std::mem::replace(seen, true) {
            continue;
        }
        let ports = document.objects.get(at).into_iter().flat_map(|object| &object.inputs);
        let sources = ports.flat_map(|port| &port.sources);
        stack.extend(sources.filter_map(|id| lookup.output(*id)).map(|from| from.object));
    }
    found
}

/// The sliders, numbers of gene pools, toggles and lists that an output hangs on, in the order of the document. Those whose
/// names others have too go by their ids.
///
/// # Errors
/// None of them could be read.
pub fn inputs_of(document: &Document, output: &Output) -> Result<Vec<Variable>, StudyError> {
    let reached = upstream(document, output.object());
    let mut found = Vec::new();
    for (index, object) in document.objects.iter().enumerate() {
        if reached.get(index) != Some(&true) {
            continue;
        }
        let title = object.title();
        let same = document.objects.iter().filter(|other| other.title() == title).count();
        let name = if same > 1 || title.is_empty() { object.id.to_string() } else { title.to_owned() };
        match object.special() {
            Some(Special::Slider(_) | Special::Toggle(_) | Special::ValueList(_)) => {
                found.push(Variable::of(document, index, None, name)?);
            }
            Some(Special::GenePool(pool)) => {
                for gene in 0..pool.values.len() {
                    found.push(Variable::of(document, index, Some(gene), format!("{name}.{gene}"))?);
                }
            }
            _ => {}
        }
    }
    Ok(found)
}
