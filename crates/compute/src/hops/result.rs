//! What comes back from calls, and how the results of all calls become the component's.

use std::collections::BTreeMap;

use katydid_component::Message;
use katydid_data::{Column, Kind, Path, Tree, TreeBuilder, Value};
use katydid_solver::{Question, Solved};
use serde::Deserialize;
use serde_json::Value as Json;

use super::protocol::Described;
use crate::definition::{Form, Input};
use crate::reply::OutputTree;
use crate::request::{self, InputTree};

/// What came back from a call.
#[derive(Debug, Default)]
pub(super) struct Results {
    pub(super) values: Vec<(String, Tree)>,
    pub(super) messages: Vec<Message>,
}

/// The results of all calls.
pub(super) struct Gathered {
    outputs: Vec<TreeBuilder<Value>>,
    messages: Vec<Message>,
    /// Whether an input has several branches.
    has_branches: bool,
    /// How many calls there were.
    calls: i32,
}

impl Gathered {
    pub(super) fn new(outputs: usize, has_branches: bool) -> Self {
        let outputs = (0..outputs).map(|_| TreeBuilder::new()).collect();
        Self { outputs, messages: Vec::new(), has_branches, calls: 0 }
    }

    /// Adds the results of a call, as Hops does: a single item goes where the items of the inputs came from; a list,
    /// where no input has branches, gets the number of the call at the end of its path; trees keep their paths.
    pub(super) fn add(
        &mut self,
        path: &Path,
        results: Results,
        described: &Described,
        question: &Question<'_>,
    ) {
        for message in results.messages {
            if !self.messages.contains(&message) {
                self.messages.push(message);
            }
        }
        for (k, builder) in self.outputs.iter_mut().enumerate() {
            let name = question.outputs.get(k).copied().unwrap_or_default();
            let Some(tree) = described.output_named(k, name, &results.values) else { continue };
            let is_list = tree.branch_count() == 1 && !self.has_branches;
            for branch in tree.branches() {
                builder.branch(match branch.path() {
                    _ if tree.item_count() == 1 => path.clone(),
                    own if is_list => numbered(own, self.calls),
                    own => own.clone(),
                });
                branch.iter().for_each(|item| builder.push(item));
            }
        }
        self.calls = self.calls.saturating_add(1);
    }

    pub(super) fn finish(self) -> Solved {
        let outputs = self.outputs.into_iter().map(TreeBuilder::finish).collect();
        Solved { outputs, messages: self.messages }
    }
}

/// The path with another last element.
fn numbered(path: &Path, last: i32) -> Path {
    let mut elements = path.elements().to_vec();
    if let Some(element) = elements.last_mut() {
        *element = last;
    }
    Path::from(elements.as_slice())
}

/// What a server replies.
#[derive(Debug, Deserialize)]
pub(super) struct RemoteReply {
    #[serde(default, alias = "Values")]
    values: Vec<RemoteTree>,
    #[serde(default, alias = "Errors")]
    errors: Option<Vec<String>>,
    #[serde(default, alias = "Warnings")]
    warnings: Option<Vec<String>>,
}

#[derive(Debug, Deserialize)]
pub(super) struct RemoteTree {
    #[serde(rename = "ParamName", alias = "paramName")]
    name: String,
    #[serde(rename = "InnerTree", alias = "innerTree")]
    branches: BTreeMap<String, Vec<RemoteItem>>,
}

#[derive(Debug, Deserialize)]
struct RemoteItem {
    #[serde(default, rename = "type")]
    kind: String,
    data: Json,
}

/// So many messages of one call are passed on.
const MOST_MESSAGES: usize = 20;

impl RemoteReply {
    /// # Errors
    /// What is wrong with a value.
    pub(super) fn read(&self) -> Result<Results, String> {
        let values: Result<Vec<_>, String> =
            self.values.iter().map(|tree| Ok((tree.name.clone(), tree.read()?))).collect();
        let errors = self.errors.iter().flatten().map(|text| Message::error(text.as_str()));
        let warnings = self.warnings.iter().flatten().map(|text| Message::warning(text.as_str()));
        Ok(Results { values: values?, messages: errors.chain(warnings).take(MOST_MESSAGES).collect() })
    }
}

impl From<OutputTree> for RemoteTree {
    fn from(tree: OutputTree) -> Self {
        let item = |item: crate::reply::OutputItem| RemoteItem {
            kind: item.type_name.to_owned(),
            data: Json::String(item.data),
        };
        let branches = tree.inner_tree.into_iter();
        let branches = branches.map(|(path, items)| (path, items.into_iter().map(item).collect()));
        Self { name: tree.param_name, branches: branches.collect() }
    }
}

impl From<crate::Reply> for RemoteReply {
    fn from(reply: crate::Reply) -> Self {
        Self {
            values: reply.values.into_iter().map(RemoteTree::from).collect(),
            errors: Some(reply.errors),
            warnings: Some(reply.warnings),
        }
    }
}

impl RemoteTree {
    pub(super) fn read(&self) -> Result<Tree, String> {
        let mut branches = Vec::with_capacity(self.branches.len());
        for (key, items) in &self.branches {
            branches.push((request::parse_path(key)?, items));
        }
        // Keys are in the order of their texts: {10} before {2}.
        branches.sort_by(|a, b| a.0.cmp(&b.0));
        let mut parts = Vec::new();
        for (path, items) in branches {
            if items.is_empty() {
                parts.push(Tree::branch_at(path.clone(), Column::empty()));
            }
            // Each run of items is read as they say: all are of one type as a rule.
            for run in items.chunk_by(|a, b| a.kind == b.kind) {
                let form = run.first().map_or(Form::Of(Kind::Generic), |item| form(&item.kind));
                let data = run.iter().map(|item| item.data.clone()).collect();
                let tree = InputTree { name: self.name.clone(), branches: vec![(path.clone(), data)] };
                let input = Input::new(self.name.clone(), 0, 0, form);
                parts.push(request::tree(&input, &tree).map_err(|fault| fault.message)?);
            }
        }
        Ok(Tree::merge(parts.iter()))
    }
}

/// How data of a .NET type is read.
fn form(kind: &str) -> Form {
    match kind.rsplit('.').next().unwrap_or(kind) {
        "Double" => Form::Of(Kind::Number),
        "Int32" => Form::Of(Kind::Integer),
        "Boolean" => Form::Of(Kind::Boolean),
        "String" => Form::Of(Kind::Text),
        "Point3d" => Form::Of(Kind::Point),
        "Vector3d" => Form::Of(Kind::Vector),
        "Plane" => Form::Of(Kind::Plane),
        "Line" => Form::Of(Kind::Line),
        "Circle" => Form::Of(Kind::Circle),
        "Arc" => Form::Of(Kind::Arc),
        "Rectangle3d" => Form::Of(Kind::Rectangle),
        "Box" => Form::Of(Kind::Box),
        "" => Form::Of(Kind::Generic),
        _ => Form::Of(Kind::Geometry),
    }
}
