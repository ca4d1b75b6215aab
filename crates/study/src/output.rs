//! The results that a study keeps of each point.

use katydid_component::Message;
use katydid_data::{Path, Tree};
use katydid_definition::document::{Document, Lookup, Object, Special, ids};
use katydid_solver::{Engine, Inputs, ObjectReport};
use uuid::Uuid;

use crate::{Cell, StudyError, inside};

/// A result that a study keeps.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Output {
    /// What it is called in the plan and in tables.
    pub name: String,
    /// The places of the clusters that it is inside of, the outermost first, each in the document inside the one before.
    within: Vec<usize>,
    source: Source,
    /// The branch and the place of the only item that is looked at; all where none is named.
    item: Option<(Path, usize)>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Source {
    /// What an object gives at an output.
    Given { object: usize, output: usize },
    /// What an object takes at its first input.
    Taken { object: usize },
}

impl Output {
    /// The output of that name: a label of a group marked `RH_OUT`, a nickname or id of an object, or one of its outputs
    /// behind a dot, by nickname, name or number: `Area.0`. A panel gives what comes over its wire, with all digits. What is
    /// inside a cluster has the cluster's name or id and a slash before its own: `Tower/Area`.
    ///
    /// # Errors
    /// Nothing has that name, several objects have, or the object has several outputs and none is named.
    pub fn find(document: &Document, name: &str) -> Result<Self, StudyError> {
        Self::find_outside(document, name).or_else(|error| {
            let (cluster, inner, rest) = inside::entered(document, name)?.ok_or(error)?;
            Self::find(&inner, rest)?.inside(cluster, name.to_owned())
        })
    }

    fn find_outside(document: &Document, name: &str) -> Result<Self, StudyError> {
        let lookup = document.lookup();
        let marked = marked_in(document, &lookup);
        if let Some(output) = marked.into_iter().find(|output| output.name == name) {
            return Ok(output);
        }
        let source = match object(document, name)? {
            Some(object) => source(document, &lookup, object, None, name)?,
            None => {
                let missing = || StudyError::Output(format!("no object is called '{name}'"));
                let (title, port) = name.rsplit_once('.').ok_or_else(missing)?;
                let object = object(document, title)?.ok_or_else(missing)?;
                source(document, &lookup, object, Some(port), name)?
            }
        };
        Ok(Self { name: name.to_owned(), within: Vec::new(), source, item: None })
    }

    /// The output of an object or port with that id; `None` where nothing has it. A panel, or an object without outputs, gives
    /// what comes over its wire.
    pub fn of_id(document: &Document, id: Uuid) -> Option<Self> {
        let lookup = document.lookup();
        let (object, source) = match lookup.object(id) {
            Some(object) => (object, behind(document, &lookup, object)),
            None => {
                let from = lookup.output(id)?;
                (from.object, Source::Given { object: from.object, output: from.port })
            }
        };
        let title = document.objects.get(object)?.title();
        let name = if title.is_empty() { "fitness" } else { title };
        Some(Self { name: name.to_owned(), within: Vec::new(), source, item: None })
    }

    /// The output of an object or port with that id inside clusters of these ids, the outermost first.
    ///
    /// # Errors
    /// Nothing has the id there, a cluster cannot be opened, or the object joins several wires inside one.
    pub fn of_ids(document: &Document, within: &[Uuid], id: Uuid) -> Result<Self, StudyError> {
        let missing = || StudyError::Output("there is no such output".to_owned());
        let Some((cluster, deeper)) = within.split_first() else {
            return Self::of_id(document, id).ok_or_else(missing);
        };
        let place = document.objects.iter().position(|object| object.id == *cluster).ok_or_else(missing)?;
        let cluster = document.objects.get(place).ok_or_else(missing)?;
        let found = Self::of_ids(&inside::content(cluster)?, deeper, id)?;
        let name = format!("{}/{}", cluster.title(), found.name);
        found.inside(place, name)
    }

    /// One of a document inside a cluster, as an output of the document that the cluster stands in.
    fn inside(self, cluster: usize, name: String) -> Result<Self, StudyError> {
        if matches!(self.source, Source::Taken { .. }) {
            return Err(StudyError::Output(format!(
                "'{name}' joins several wires inside a cluster, which is not supported: name what gives its data"
            )));
        }
        let within = std::iter::once(cluster).chain(self.within).collect();
        Ok(Self { name, within, ..self })
    }

    /// Only one item of it: by its branch and its place there, from 0. It gives nothing where there is none.
    #[must_use]
    pub fn only(self, branch: Path, place: usize) -> Self {
        Self { item: Some((branch, place)), ..self }
    }

    /// The places that lead to the object that gives it: of clusters on the way in, and its own at the end.
    pub(crate) fn path(&self) -> impl Iterator<Item = usize> {
        let (Source::Given { object, .. } | Source::Taken { object }) = self.source;
        self.within.iter().copied().chain(std::iter::once(object))
    }

    /// Its data in a solved engine.
    pub fn tree(&self, engine: &Engine) -> Tree {
        let tree = self.whole(engine);
        let Some((path, place)) = &self.item else { return tree };
        let branch = tree.paths().iter().position(|other| other == path).and_then(|b| tree.branch(b));
        branch.and_then(|branch| branch.get(*place)).map(Tree::item).unwrap_or_default()
    }

    fn whole(&self, engine: &Engine) -> Tree {
        match self.source {
            Source::Given { .. } => self.given(engine).cloned().unwrap_or_default(),
            Source::Taken { object } => Inputs::new(engine).of(object).into_iter().next().unwrap_or_default(),
        }
    }

    /// What its object gives.
    fn given<'a>(&self, engine: &'a Engine) -> Option<&'a Tree> {
        let Source::Given { output, .. } = self.source else { return None };
        self.report(engine)?.outputs.get(output)
    }

    /// The report of the object that gives it.
    fn report<'a>(&self, engine: &'a Engine) -> Option<&'a ObjectReport> {
        inside::report_at(engine, &self.path().collect::<Vec<_>>())
    }

    /// The same as a cell of a table.
    pub fn cell(&self, engine: &Engine) -> Cell {
        match self.source {
            Source::Given { .. } if self.item.is_none() => {
                self.given(engine).map_or(Cell::Null, Cell::of_tree)
            }
            _ => Cell::of_tree(&self.tree(engine)),
        }
    }

    /// What the object that gives it says first.
    pub(crate) fn message<'a>(&self, engine: &'a Engine) -> Option<&'a Message> {
        self.report(engine)?.messages.first()
    }
}

/// What a definition marks as its results: groups called `RH_OUT:name`, Context Print; where there are none, the panels
/// that a wire leads to.
pub fn marked(document: &Document) -> Vec<Output> {
    let lookup = document.lookup();
    let mut found = marked_in(document, &lookup);
    if found.is_empty() {
        let panels = document.objects.iter().enumerate().filter(|(_, object)| {
            object.component == ids::PANEL && object.inputs.iter().any(|port| !port.sources.is_empty())
        });
        found = panels
            .map(|(object, panel)| Output {
                name: panel.title().to_owned(),
                within: Vec::new(),
                source: behind(document, &lookup, object),
                item: None,
            })
            .collect();
    }
    named_apart(found)
}

fn marked_in(document: &Document, lookup: &Lookup) -> Vec<Output> {
    let mut found = Vec::new();
    for (index, object) in document.objects.iter().enumerate() {
        match object.special() {
            Some(Special::Group(group)) if group.marks_output() => {
                let first = group.members.iter().find_map(|id| lookup.object(*id));
                found.extend(first.map(|member| Output {
                    name: group.marked_name().to_owned(),
                    within: Vec::new(),
                    source: behind(document, lookup, member),
                    item: None,
                }));
            }
            _ if object.component == ids::CONTEXT_PRINT => {
                let name = object.inputs.first().map_or("", |port| &port.nickname).to_owned();
                let source = behind(document, lookup, index);
                found.push(Output { name, within: Vec::new(), source, item: None });
            }
            _ => {}
        }
    }
    found
}

/// Gives names that several have a number: `Area`, `Area'2`.
fn named_apart(mut found: Vec<Output>) -> Vec<Output> {
    for at in 1..found.len() {
        let (before, rest) = found.split_at_mut(at);
        let Some(output) = rest.first_mut() else { break };
        let same =
            before.iter().filter(|other| other.name.split('\'').next() == Some(output.name.as_str())).count();
        if same > 0 {
            output.name = format!("{}'{}", output.name, same + 1);
        }
    }
    found
}

/// The data of an object without outputs of its own, or of a panel: where its only wire comes from.
fn behind(document: &Document, lookup: &Lookup, object: usize) -> Source {
    let Some(at) = document.objects.get(object) else { return Source::Taken { object } };
    if !(at.component == ids::PANEL || at.outputs.is_empty()) {
        return Source::Given { object, output: 0 };
    }
    match at.inputs.first().map(|port| port.sources.as_slice()) {
        Some([one]) => lookup.output(*one).map_or(Source::Taken { object }, |from| Source::Given {
            object: from.object,
            output: from.port,
        }),
        _ if at.outputs.is_empty() => Source::Taken { object },
        _ => Source::Given { object, output: 0 },
    }
}

/// The one object of a nickname, name or id; `None` where nothing has it.
fn object(document: &Document, name: &str) -> Result<Option<usize>, StudyError> {
    if let Ok(id) = Uuid::parse_str(name.trim().trim_matches(['{', '}'])) {
        return Ok(document.objects.iter().position(|object| object.id == id));
    }
    let real = || document.objects.iter().enumerate().filter(|(_, object)| !object.is_annotation());
    let with = |same: &dyn Fn(&Object) -> bool| -> Vec<usize> {
        real().filter(|(_, object)| same(object)).map(|(at, _)| at).collect()
    };
    let mut found = with(&|object| object.title() == name);
    if found.is_empty() {
        found = with(&|object| {
            object.title().eq_ignore_ascii_case(name) || object.name.eq_ignore_ascii_case(name)
        });
    }
    match found.as_slice() {
        [] => Ok(None),
        [one] => Ok(Some(*one)),
        many => {
            let ids = many
                .iter()
                .take(5)
                .filter_map(|at| document.objects.get(*at))
                .map(|object| object.id.to_string());
            let ids: Vec<String> = ids.collect();
            let count = many.len();
            Err(StudyError::Output(format!(
                "{count} objects are called '{name}': use one of their ids, {}",
                ids.join(", ")
            )))
        }
    }
}

fn source(
    document: &Document,
    lookup: &Lookup,
    object: usize,
    port: Option<&str>,
    name: &str,
) -> Result<Source, StudyError> {
    let Some(at) = document.objects.get(object) else {
        return Err(StudyError::Output(format!("'{name}' is not there")));
    };
    let Some(port) = port else {
        return match at.outputs.len() {
            0 | 1 => Ok(behind(document, lookup, object)),
            _ => {
                let names: Vec<&str> = at.outputs.iter().map(|port| port.nickname.as_str()).collect();
                Err(StudyError::Output(format!(
                    "'{name}' has several outputs: say which, {name}.{}",
                    names.join(&format!(" or {name}."))
                )))
            }
        };
    };
    let by_number = || port.parse().ok().filter(|k: &usize| *k < at.outputs.len().max(1));
    let output = at.outputs.iter().position(|p| p.nickname == port || p.name == port).or_else(by_number);
    match output {
        Some(output) => Ok(Source::Given { object, output }),
        None => Err(StudyError::Output(format!("'{}' has no output '{port}'", at.title()))),
    }
}
