//! What hangs on what: the inputs that an output can depend on.

use katydid_definition::document::{Document, Object, Special, ids};

use crate::{Output, StudyError, Variable, inside};

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

/// An object that leads to something.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Reached {
    /// The places of the clusters that it is inside of, each in the document inside the one before, and its own at the end.
    pub(crate) path: Vec<usize>,
    /// Its name behind those of the clusters, or its id where others have the name too.
    pub(crate) name: String,
}

/// The objects that lead to any of some, which `targets` names by their paths, in the order of the document. Those inside a
/// cluster come before it. Clusters that cannot be opened have none.
pub(crate) fn reached(document: &Document, targets: &[Vec<usize>]) -> Vec<Reached> {
    let mut found = Vec::new();
    collect(
        document,
        targets,
        &Reached { path: Vec::new(), name: String::new() },
        &mut found,
        &mut |_, _| {},
    );
    found
}

/// Calls `meet` with each of them and its object, too.
fn collect(
    document: &Document,
    targets: &[Vec<usize>],
    around: &Reached,
    found: &mut Vec<Reached>,
    meet: &mut dyn FnMut(&Reached, &Object),
) {
    let leading: Vec<Vec<bool>> =
        targets.iter().filter_map(|path| Some(upstream(document, *path.first()?))).collect();
    for (index, object) in document.objects.iter().enumerate() {
        if !leading.iter().any(|set| set.get(index) == Some(&true)) {
            continue;
        }
        let own = title_or_id(document, object);
        let name = if around.path.is_empty() { own } else { format!("{}/{own}", around.name) };
        let one = Reached { path: [around.path.as_slice(), &[index]].concat(), name };
        if let Some(inner) = opened(object) {
            let targets = targets_inside(&inner, index, targets);
            collect(&inner, &targets, &one, found, meet);
        }
        meet(&one, object);
        found.push(one);
    }
}

/// The document inside, where the object is a cluster that can be opened.
fn opened(object: &Object) -> Option<Document> {
    inside::is_cluster(object).then(|| inside::content(object).ok())?
}

/// What is asked for inside the cluster at `index`: what paths lead to in it, and its outputs, unless nothing else is asked for.
fn targets_inside(inner: &Document, index: usize, targets: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let deeper = |path: &Vec<usize>| match path.split_first() {
        Some((first, rest)) if *first == index && !rest.is_empty() => Some(rest.to_vec()),
        _ => None,
    };
    let mut found: Vec<Vec<usize>> = targets.iter().filter_map(deeper).collect();
    if found.len() < targets.len() {
        let outputs = inner.objects.iter().enumerate().filter(|(_, o)| o.component == ids::CLUSTER_OUTPUT);
        found.extend(outputs.map(|(at, _)| vec![at]));
    }
    found
}

/// The sliders, numbers of gene pools, toggles and lists that an output hangs on, in the order of the document, those inside
/// clusters where their cluster stands. Those whose names others have too go by their ids.
///
/// # Errors
/// One of them could not be read.
pub fn inputs_of(document: &Document, output: &Output) -> Result<Vec<Variable>, StudyError> {
    let targets: [Vec<usize>; 1] = [output.path().collect()];
    let outside = Reached { path: Vec::new(), name: String::new() };
    let mut found = Vec::new();
    collect(document, &targets, &outside, &mut Vec::new(), &mut |one, object| match object.special() {
        Some(Special::Slider(_) | Special::Toggle(_) | Special::ValueList(_)) => {
            found.push(Variable::at(object, one.path.clone(), None, one.name.clone()));
        }
        Some(Special::GenePool(pool)) => {
            let gene =
                |gene| Variable::at(object, one.path.clone(), Some(gene), format!("{}.{gene}", one.name));
            found.extend((0..pool.values.len()).map(gene));
        }
        _ => {}
    });
    found.into_iter().collect()
}

/// The name of an object, or its id where others have the name too.
pub(crate) fn title_or_id(document: &Document, object: &Object) -> String {
    let title = object.title();
    let same = document.objects.iter().filter(|other| other.title() == title).count();
    if same > 1 || title.is_empty() { object.id.to_string() } else { title.to_owned() }
}
