//! What lies at a location, and how it is called.

use std::sync::Arc;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use katydid_component::{Access, Limits, Message};
use katydid_data::{Column, Path, Tree, Value};
use katydid_solver::Question;
use serde::Deserialize;
use serde_json::{Value as Json, json};

use super::Hops;
use super::result::{RemoteReply, RemoteTree, Results};
use crate::reply::OutputTree;
use crate::request::{InputTree, SolveRequest, parse_path, shown};
use crate::web::{Response, authority};
use crate::wire::Members;
use crate::{Bounds, Definition, solve};

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
    place: Place,
}

/// Where something is solved.
#[derive(Debug)]
enum Place {
    /// Here.
    Here(Arc<Definition>),
    /// By a server, at an address and by a name.
    There { url: String, pointer: String },
}

impl Hops {
    /// Finds out what a component stands for.
    pub(super) fn describe(&self, question: &Question<'_>) -> Result<Described, Message> {
        let location = question.location.trim();
        if let Some(kept) = question.kept {
            return self.definition("the definition that the component keeps", kept);
        }
        if location.is_empty() {
            return Err(Message::warning("No definition is named"));
        }
        if !location.contains("://") {
            let most = u64::try_from(self.settings.archive.max_inflated).unwrap_or(u64::MAX);
            return self.definition(location, &self.settings.files.read(location, most)?);
        }
        let found = self.ask(location, None, question)?;
        if found.status != 200 {
            return Err(Message::error(format!("{location} is not there: status {}", found.status)));
        }
        if found.is_json {
            let server = authority(location).map_err(|fault| Message::error(fault.message))?;
            let after = location.split_once("://").map_or("", |(_, rest)| rest);
            let pointer = after.split_once('/').map_or("", |(_, path)| path).to_owned();
            let place = Place::There { url: format!("{server}/solve"), pointer };
            return read(&parsed(&found, location)?, |_| Some(place));
        }
        let Some(server) = self.settings.hops.server.as_deref() else {
            return self.definition(location, &found.body);
        };
        let server = server.trim_end_matches('/');
        let body = json!({ "algo": STANDARD.encode(&found.body), "dataversion": 7 });
        let url = format!("{server}/io");
        let told = self.ask(&url, Some(body.to_string().into_bytes()), question)?;
        if told.status != 200 {
            return Err(Message::error(format!("{url} does not know {location}: status {}", told.status)));
        }
        let url = format!("{server}/grasshopper");
        read(&parsed(&told, location)?, |key| Some(Place::There { url, pointer: key?.to_owned() }))
    }

    /// A definition that is solved here.
    fn definition(&self, name: &str, bytes: &[u8]) -> Result<Described, Message> {
        let definition = Definition::read(String::new(), bytes, &self.settings.archive);
        let definition = definition.map_err(|fault| {
            Message::error(format!("{} is no definition: {}", shown(name), fault.message))
        })?;
        let description = serde_json::to_value(&*definition.described().0);
        let description = description.map_err(|error| Message::error(error.to_string()))?;
        read(&description, |_| Some(Place::Here(Arc::new(definition))))
    }

    /// Solves once.
    pub(super) fn call<'a>(
        &self,
        described: &Described,
        values: impl Iterator<Item = (&'a str, Tree)>,
        question: &Question<'_>,
    ) -> Result<Results, Message> {
        let trees = values.filter(|(_, tree)| !tree.is_empty());
        let trees = trees.map(|(name, tree)| OutputTree::of(name, &tree, 70, false).0).collect();
        let (url, pointer) = match &described.place {
            Place::Here(definition) => return self.solve_here(definition, trees, question),
            Place::There { url, pointer } => (url, pointer),
        };
        let rules = question.rules;
        let body = json!({
            "absolutetolerance": rules.tolerance.absolute,
            "angletolerance": rules.tolerance.angle.to_degrees(),
            "modelunits": rules.units.name(),
            "dataversion": 7,
            "algo": null,
            "pointer": pointer,
            "cachesolve": false,
            "recursionlevel": self.recursion.saturating_add(1),
            "values": trees,
        });
        let response = self.ask(url, Some(body.to_string().into_bytes()), question)?;
        let reply: RemoteReply = serde_json::from_slice(&response.body).map_err(|error| {
            let status = response.status;
            Message::error(format!("{url} does not answer with results: status {status}, {error}"))
        })?;
        reply.read().map_err(|why| Message::error(format!("{url}: {why}")))
    }

    /// Solves a definition here, with what is left of the time.
    fn solve_here(
        &self,
        definition: &Arc<Definition>,
        values: Vec<OutputTree>,
        question: &Question<'_>,
    ) -> Result<Results, Message> {
        let failed = |why: String| Message::error(why);
        let mut request = SolveRequest {
            absolute_tolerance: Some(question.rules.tolerance.absolute),
            angle_tolerance: Some(question.rules.tolerance.angle.to_degrees()),
            units: Some(question.rules.units),
            ..SolveRequest::default()
        };
        for tree in values {
            let branches = tree.inner_tree.into_iter().map(|(path, items)| {
                let items = items.into_iter().map(|item| Json::String(item.data)).collect();
                Ok((parse_path(&path)?, items))
            });
            let branches: Result<Vec<_>, String> = branches.collect();
            request.values.push(InputTree { name: tree.param_name, branches: branches.map_err(failed)? });
        }
        let bounds = Bounds {
            limits: Limits { ..question.limits },
            memory: Some(question.memory.clone()),
            cancel: question.cancel.clone(),
            progress: None,
            recursion: self.recursion.saturating_add(1),
        };
        let solved = solve::run(&self.settings, &self.web, definition, &request, &bounds);
        let (solution, _) = solved.map_err(|fault| failed(fault.message))?;
        RemoteReply::from(solution.reply()).read().map_err(failed)
    }
}

fn parsed(response: &Response, url: &str) -> Result<Json, Message> {
    serde_json::from_slice(&response.body)
        .map_err(|error| Message::error(format!("{url} does not answer with JSON: {error}")))
}

/// Reads a description. Where it is solved follows from the key in it.
fn read(json: &Json, place: impl FnOnce(Option<&str>) -> Option<Place>) -> Result<Described, Message> {
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
    let key = members.get("CacheKey").and_then(Json::as_str);
    Ok(Described {
        inputs: inputs.ok_or_else(|| wrong("an input has no name"))?,
        outputs: outputs.ok_or_else(|| wrong("an output has no name"))?,
        place: place(key).ok_or_else(|| wrong("it has no key"))?,
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
    let column = |value| Column::of_values(vec![value], None);
    value.map_or_else(Tree::empty, |value| Tree::branch_at(Path::zero(), column(value)))
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
