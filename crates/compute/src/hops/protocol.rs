//! What is said to servers: descriptions of components, requests, replies.

use std::collections::BTreeMap;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use katydid_component::{Access, Message};
use katydid_data::{Tree, Value};
use katydid_solver::Question;
use serde::Deserialize;
use serde_json::{Value as Json, json};

use super::client::{Client, Response, authority};
use super::{HopsSettings, single};
use crate::definition::{Form, Input};
use crate::reply::OutputTree;
use crate::request::{self, InputTree, shown};
use crate::wire::Members;

/// An input as the server describes it.
#[derive(Debug, Clone)]
pub(super) struct Port {
    pub(super) name: String,
    pub(super) access: Access,
    /// Whether it may be left out.
    pub(super) optional: bool,
    pub(super) default: Tree,
}

/// What is at a location, and how it is solved.
#[derive(Debug)]
pub(super) struct Described {
    inputs: Vec<Port>,
    outputs: Vec<String>,
    /// Where it is solved, and what it is called there.
    url: String,
    pointer: String,
}

/// What came back from a call.
#[derive(Debug, Default)]
pub(super) struct Results {
    pub(super) values: Vec<(String, Tree)>,
    pub(super) messages: Vec<Message>,
}

/// Finds out what is at the location of a question.
pub(super) fn describe(
    client: &Client,
    settings: &HopsSettings,
    question: &Question<'_>,
) -> Result<Described, Message> {
    let location = question.location.trim();
    if location.is_empty() {
        return Err(Message::warning("No definition is named".to_owned()));
    }
    let server = authority(location)?;
    let found = client.get(location, question.budget)?;
    if found.status != 200 {
        return Err(Message::error(format!("{location} is not there: status {}", found.status)));
    }
    if found.is_json {
        let after = location.split_once("://").map_or("", |(_, rest)| rest);
        let pointer = after.split_once('/').map_or("", |(_, path)| path).to_owned();
        return read(&parsed(&found, location)?, format!("http://{server}/solve"), Some(pointer));
    }
    // The bytes of a definition, for a server that solves such.
    let Some(base) = settings.compute.as_deref().map(|base| base.trim_end_matches('/')) else {
        return Err(Message::error(format!(
            "{location} is a definition, and no server is named that solves it"
        )));
    };
    let body = json!({ "algo": STANDARD.encode(&found.body), "dataversion": 7 });
    let url = format!("{base}/io");
    let described = client.post(&url, body.to_string().into_bytes(), question.budget)?;
    if described.status != 200 {
        return Err(Message::error(format!("{url} does not know {location}: status {}", described.status)));
    }
    read(&parsed(&described, &url)?, format!("{base}/grasshopper"), None)
}

fn parsed(response: &Response, url: &str) -> Result<Json, Message> {
    serde_json::from_slice(&response.body)
        .map_err(|error| Message::error(format!("{url} does not answer with JSON: {error}")))
}

/// Reads a description. A pointer that is not given is in it.
fn read(json: &Json, url: String, pointer: Option<String>) -> Result<Described, Message> {
    let wrong =
        |why: &str| Message::error(format!("The description of the definition cannot be read: {why}"));
    let members = Members::of(json).map_err(|fault| wrong(&fault.message))?;
    let list = |name: &str| members.get(name).and_then(Json::as_array).map_or(&[][..], Vec::as_slice);
    let name = |port: &Json| {
        let members = Members::of(port).ok()?;
        members.get("Name").and_then(Json::as_str).map(str::to_owned)
    };
    let inputs = list("Inputs").iter().map(|port| Some(input(name(port)?, &Members::of(port).ok()?)));
    let inputs: Option<Vec<Port>> = inputs.collect();
    let outputs: Option<Vec<String>> = list("Outputs").iter().map(name).collect();
    let known = members.get("CacheKey").and_then(Json::as_str).map(str::to_owned);
    Ok(Described {
        inputs: inputs.ok_or_else(|| wrong("an input has no name"))?,
        outputs: outputs.ok_or_else(|| wrong("an output has no name"))?,
        pointer: pointer.or(known).ok_or_else(|| wrong("it has no key"))?,
        url,
    })
}

fn input(name: String, port: &Members<'_>) -> Port {
    let count = |name: &str| port.get(name).and_then(Json::as_i64);
    let (least, most) = (count("AtLeast").unwrap_or(1), count("AtMost").unwrap_or(1));
    let is_tree = port.get("TreeAccess").and_then(Json::as_bool).unwrap_or(false) || least < 0 && most < 0;
    Port {
        access: match most {
            _ if is_tree => Access::Tree,
            1 => Access::Item,
            _ => Access::List,
        },
        optional: least == 0,
        default: port.get("Default").map(default).unwrap_or_default(),
        name,
    }
}

/// The default of an input: a tree, or one value.
fn default(json: &Json) -> Tree {
    if let Ok(tree) = RemoteTree::deserialize(json) {
        return tree.read().unwrap_or_default();
    }
    let value = match json {
        Json::Bool(flag) => Some(Value::Boolean(*flag)),
        Json::Number(number) => number.as_f64().map(Value::Number),
        Json::String(text) => Some(Value::from(text.as_str())),
        _ => None,
    };
    single(value)
}

impl Described {
    /// The inputs that the server wants, in the order of the component's: by name, else by place.
    pub(super) fn inputs_for(&self, question: &Question<'_>) -> Result<Vec<Port>, Message> {
        if self.inputs.len() != question.inputs.len() {
            return Err(Message::error(format!(
                "The definition at {} takes {} inputs, not {}: the component is out of date",
                shown(question.location),
                self.inputs.len(),
                question.inputs.len()
            )));
        }
        let port = |(k, (name, _)): (usize, &(&str, Tree))| {
            self.inputs
                .iter()
                .find(|port| is_called(&port.name, name))
                .or_else(|| self.inputs.get(k))
                .cloned()
        };
        Ok(question.inputs.iter().enumerate().filter_map(port).collect())
    }

    /// The data of output `k` of the component among what came back.
    pub(super) fn output_named<'a>(
        &self,
        k: usize,
        name: &str,
        values: &'a [(String, Tree)],
    ) -> Option<&'a Tree> {
        let by_name = |name: &str| values.iter().find(|(known, _)| is_called(known, name));
        let by_place = || self.outputs.get(k).and_then(|name| by_name(name));
        by_name(name).or_else(by_place).map(|(_, tree)| tree)
    }
}

/// Whether a component shows a name as another: without what stands before the last colon.
fn is_called(full: &str, shown: &str) -> bool {
    full == shown || full.rsplit(':').next() == Some(shown)
}

/// Solves once.
pub(super) fn solve<'a>(
    client: &Client,
    described: &Described,
    values: impl Iterator<Item = (&'a str, Tree)>,
    recursion: u32,
    question: &Question<'_>,
) -> Result<Results, Message> {
    let trees = values.filter(|(_, tree)| !tree.is_empty());
    let trees: Vec<OutputTree> = trees.map(|(name, tree)| OutputTree::of(name, &tree, 70).0).collect();
    let rules = question.rules;
    let body = json!({
        "absolutetolerance": rules.tolerance.absolute,
        "angletolerance": rules.tolerance.angle.to_degrees(),
        "modelunits": rules.units.name(),
        "dataversion": 7,
        "algo": null,
        "pointer": described.pointer,
        "cachesolve": false,
        "recursionlevel": recursion,
        "values": trees,
    });
    let response = client.post(&described.url, body.to_string().into_bytes(), question.budget)?;
    let reply: RemoteReply = serde_json::from_slice(&response.body).map_err(|error| {
        let status = response.status;
        Message::error(format!("{} does not answer with results: status {status}, {error}", described.url))
    })?;
    let values: Result<Vec<_>, String> =
        reply.values.iter().map(|tree| Ok((tree.name.clone(), tree.read()?))).collect();
    let values = values.map_err(|why| Message::error(format!("{}: {why}", described.url)))?;
    let errors = reply.errors.iter().flatten().map(|text| Message::error(text.as_str()));
    let warnings = reply.warnings.iter().flatten().map(|text| Message::warning(text.as_str()));
    Ok(Results { values, messages: errors.chain(warnings).take(20).collect() })
}

/// What a server replies.
#[derive(Debug, Deserialize)]
struct RemoteReply {
    #[serde(default, alias = "Values")]
    values: Vec<RemoteTree>,
    #[serde(default, alias = "Errors")]
    errors: Option<Vec<String>>,
    #[serde(default, alias = "Warnings")]
    warnings: Option<Vec<String>>,
}

#[derive(Debug, Deserialize)]
struct RemoteTree {
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

impl RemoteTree {
    fn read(&self) -> Result<Tree, String> {
        let mut parts = Vec::new();
        for (key, items) in &self.branches {
            let path = request::parse_path(key)?;
            if items.is_empty() {
                parts.push(Tree::branch_at(path.clone(), katydid_data::Column::empty()));
            }
            // Each run of items is read as they say: all are of one type as a rule.
            for run in items.chunk_by(|a, b| a.kind == b.kind) {
                let form = run.first().map_or(Form::Any, |item| form(&item.kind));
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
        "Double" => Form::Number,
        "Int32" => Form::Integer,
        "Boolean" => Form::Boolean,
        "String" => Form::Text,
        "Point3d" => Form::Point,
        "Vector3d" => Form::Vector,
        "Plane" => Form::Plane,
        "Line" => Form::Line,
        "Circle" => Form::Circle,
        "Arc" => Form::Arc,
        "Rectangle3d" => Form::Rectangle,
        "Box" => Form::Box,
        "" => Form::Any,
        _ => Form::Object,
    }
}
