use katydid_component::registry;
use katydid_compute::definition::{Data, Interface};
use katydid_data::{Kind, Tree};
use katydid_definition::document::Document;
use katydid_solver::{Engine, Inputs};
use pyo3::prelude::*;
use uuid::Uuid;

/// What a definition gives.
#[pyclass(frozen, module = "katydid")]
#[derive(Debug, Clone)]
pub(crate) struct Output {
    /// The name by which a solution has it.
    #[pyo3(get)]
    name: String,
    /// The name of the type of its values.
    #[pyo3(get)]
    kind: &'static str,
    /// Whether the author marked it as an output: Context Bake, Context Print, or a group called `RH_OUT:name`.
    #[pyo3(get)]
    marked: bool,
    data: Data,
}

impl Output {
    /// The outputs that are marked; where there are none, those that no wire leads on from.
    pub(super) fn all(document: &Document, interface: &Interface) -> Vec<Self> {
        let marked: Vec<Self> = interface
            .outputs
            .iter()
            .map(|output| Self {
                name: output.name.trim_start_matches("RH_OUT:").trim().to_owned(),
                kind: output.type_name,
                marked: true,
                data: output.data,
            })
            .collect();
        if marked.is_empty() { ends(document) } else { marked }
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// What it has in a solved definition.
    pub(super) fn tree(&self, engine: &Engine) -> Tree {
        tree(engine, self.data)
    }
}

fn tree(engine: &Engine, data: Data) -> Tree {
    let found = match data {
        Data::Given { object, output } => {
            engine.report(object).and_then(|report| report.outputs.get(output).cloned())
        }
        Data::Taken { object, input } => Inputs::new(engine).of(object).into_iter().nth(input),
    };
    found.unwrap_or_default()
}

/// The outputs from which no wire leads on.
fn ends(document: &Document) -> Vec<Output> {
    let read: std::collections::HashSet<Uuid> = document
        .objects
        .iter()
        .flat_map(|object| &object.inputs)
        .flat_map(|port| port.sources.iter().copied())
        .collect();
    let mut all = Vec::new();
    for (at, object) in document.objects.iter().enumerate().filter(|(_, object)| !object.is_annotation()) {
        let is_read = object.outputs.iter().any(|port| read.contains(&port.id));
        if is_read || object.outputs.is_empty() {
            continue;
        }
        for (output, port) in object.outputs.iter().enumerate() {
            let component =
                registry::by_guid(object.component).and_then(|component| component.output(output));
            let name = match object.outputs.len() {
                1 => object.title().to_owned(),
                _ => format!("{}.{}", object.title(), port.name),
            };
            let kind = component.map_or(Kind::Generic, |port| port.kind).name();
            all.push(Output { name, kind, marked: false, data: Data::Given { object: at, output } });
        }
    }
    all
}

/// The data of an object by what its author calls it or by its id; of one of its outputs by `name.output`.
pub(super) fn anywhere(engine: &Engine, name: &str) -> Option<Tree> {
    let objects = &engine.document().objects;
    let id = Uuid::parse_str(name.trim().trim_matches(['{', '}'])).ok();
    let of = |name: &str| {
        objects.iter().position(|object| {
            Some(object.id) == id || (!object.outputs.is_empty() && object.title() == name)
        })
    };
    if let Some(object) = of(name) {
        return Some(tree(engine, Data::Given { object, output: 0 }));
    }
    let (title, wanted) = name.rsplit_once('.')?;
    let object = of(title)?;
    let output = objects
        .get(object)?
        .outputs
        .iter()
        .position(|port| port.name == wanted || port.nickname == wanted)?;
    Some(tree(engine, Data::Given { object, output }))
}

#[pymethods]
impl Output {
    fn __repr__(&self) -> String {
        format!("<Output '{}': {}>", self.name, self.kind)
    }
}
