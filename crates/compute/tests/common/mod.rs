#![allow(dead_code, reason = "each test file uses what it needs")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

use std::path::PathBuf;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use katydid_compute::{Bounds, Compute, Fault, Located, Settings, SolveRequest};
use katydid_definition::document::{Document, Object, ids};
use serde_json::{Value as Json, json};
use uuid::Uuid;

/// The shared test data, or nothing with a line that says so.
pub(crate) fn shared(path: &str) -> Option<PathBuf> {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared")).join(path);
    if path.exists() {
        return Some(path);
    }
    assert!(std::env::var_os("CI").is_none(), "{} is missing", path.display());
    println!("skipped: {} is missing", path.display());
    None
}

pub(crate) fn compute() -> Compute {
    Compute::new(Settings::default())
}

/// A request as a client sends it, and the reply.
pub(crate) fn post(compute: &Compute, body: &Json) -> Result<(bool, Json), Fault> {
    let request = SolveRequest::read(body.to_string().as_bytes(), &compute.settings().request)?;
    let Located::Here(definition) = compute.locate(&request)? else { panic!("{body} names a URL") };
    let answer = compute.answer(&definition, &request, &Bounds::default())?;
    Ok((answer.has_errors, serde_json::from_slice(&answer.body).unwrap()))
}

/// The reply of `/io`.
pub(crate) fn io(compute: &Compute, body: &Json) -> Json {
    let request = SolveRequest::read(body.to_string().as_bytes(), &compute.settings().request).unwrap();
    let Located::Here(definition) = compute.locate(&request).unwrap() else { panic!("{body} names a URL") };
    serde_json::to_value(&*compute.describe(&definition)).unwrap()
}

/// A definition as a client sends it.
pub(crate) fn algo(document: &Document) -> String {
    STANDARD.encode(document.to_gh().unwrap())
}

/// A value with one branch.
pub(crate) fn value(name: &str, path: &str, data: &[Json]) -> Json {
    let items: Vec<Json> = data.iter().map(|data| json!({ "data": data })).collect();
    json!({ "ParamName": name, "InnerTree": { path: items } })
}

/// The data of an output: branches with the texts of their items.
pub(crate) fn output(reply: &Json, name: &str) -> Vec<(String, Vec<String>)> {
    let values = reply["values"].as_array().unwrap();
    let value = values.iter().find(|value| value["ParamName"] == name).unwrap_or_else(|| panic!("{reply}"));
    let branches = value["InnerTree"].as_object().unwrap().iter();
    let texts = |items: &Json| {
        items.as_array().unwrap().iter().map(|item| item["data"].as_str().unwrap().to_owned()).collect()
    };
    branches.map(|(path, items)| (path.clone(), texts(items))).collect()
}

/// The one item of an output.
pub(crate) fn item(reply: &Json, name: &str) -> String {
    let branches = output(reply, name);
    let [(_, items)] = branches.as_slice() else { panic!("{branches:?}") };
    let [item] = items.as_slice() else { panic!("{items:?}") };
    item.clone()
}

/// A definition being made.
#[derive(Default)]
pub(crate) struct Maker {
    pub(crate) document: Document,
    next: u128,
}

impl Maker {
    pub(crate) fn id(&mut self) -> Uuid {
        self.next += 1;
        Uuid::from_u128(self.next)
    }

    /// Adds an object of a type.
    pub(crate) fn add(&mut self, component: Uuid, nickname: &str) -> usize {
        katydid_components::link();
        let id = self.id();
        let mut object = katydid_session::new_object(component, id).unwrap();
        object.set_nickname(nickname);
        self.document.objects.push(object);
        self.document.objects.len() - 1
    }

    /// Adds an object of a type by its name.
    pub(crate) fn named(&mut self, name: &str, nickname: &str) -> usize {
        katydid_components::link();
        let all = katydid_component::registry::all();
        let mut named = all.into_iter().filter(|component| component.name == name && !component.old);
        // A parameter goes before a component of the same name.
        let first = named.next();
        let found = first.filter(|first| first.floating).or_else(|| named.find(|c| c.floating)).or(first);
        self.add(found.unwrap_or_else(|| panic!("{name}")).guid, nickname)
    }

    /// Adds a contextual input with limits on the number of its items.
    pub(crate) fn get(&mut self, name: &str, nickname: &str) -> usize {
        let at = self.named(name, nickname);
        let container = self.document.objects[at].container_mut();
        container.set("AtLeast", 1);
        container.set("AtMost", i32::MAX);
        container.set("Prompt", format!("give {nickname}"));
        container.set("TreeAccess", true);
        self.document.objects[at].refresh();
        at
    }

    /// Wires an input of `to` to an output of `from`.
    pub(crate) fn wire(&mut self, from: usize, output: usize, to: usize, input: usize) {
        let source = self.document.objects[from].outputs[output].id;
        let mut sources = self.document.objects[to].inputs[input].sources.clone();
        sources.push(source);
        self.document.objects[to].set_sources(input, &sources).unwrap();
    }

    /// Puts an object into a group.
    pub(crate) fn group(&mut self, label: &str, members: &[Uuid]) {
        let id = self.id();
        let mut group = Object::new_component(ids::GROUP, "Group", label, id);
        let container = group.container_mut();
        for (k, member) in (0..).zip(members) {
            container.set_at("ID", k, *member);
        }
        container.set("ID_Count", i32::try_from(members.len()).unwrap());
        group.refresh();
        self.document.objects.push(group);
    }

    pub(crate) fn object_id(&self, at: usize) -> Uuid {
        self.document.objects[at].id
    }

    /// Marks an object as an output.
    pub(crate) fn out(&mut self, label: &str, at: usize) {
        self.group(label, &[self.object_id(at)]);
    }

    pub(crate) fn place(&mut self, at: usize, y: f32) {
        self.document.objects[at].set_place([0.0, y, 50.0, 20.0], [25.0, y]);
    }
}
