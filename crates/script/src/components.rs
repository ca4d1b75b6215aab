//! The components that scripts run: `ghpythonlib.components`, made from the registry.

use std::collections::HashMap;

use katydid_component::{
    Access, Account, Budget, Call, Cancel, Component, Deadline, Level, Limits, Port, plugin_of_tab, registry,
};
use katydid_data::cast::{self, Rules};
use katydid_data::{Column, Path, Tree, TreeBuilder};
use katydid_definition::archive::Chunk;
use katydid_definition::document::TypeHint;
use katydid_members::{Fault, Registry, Value};
use uuid::Uuid;

use crate::from_script::Outward;
use crate::keeper::Keepers;
use crate::to_script::Inward;

/// The registry, with the units and tolerances of a document.
#[derive(Debug, Clone)]
pub(crate) struct Components {
    pub(crate) rules: Rules,
}

impl Registry for Components {
    fn components(&self) -> Value {
        // Names of plug-ins' components are not theirs alone: Angle is Grasshopper's own.
        let own = |component: &&Component| plugin_of_tab(component.tab).is_none();
        let offered = registry::all().into_iter().filter(|component| !component.old && !component.floating);
        let offered = offered.filter(own);
        Value::List(offered.map(entry).collect())
    }

    fn run(&self, name: &str, inputs: &[Value], limits: &Limits, cancel: &Cancel) -> Result<Value, Fault> {
        let component = found(name).ok_or_else(|| Fault::not_supported(format!("the component {name}")))?;
        let (keepers, texts) = (Keepers::new(0), HashMap::new());
        let mut outward = Outward { keepers: &keepers, texts: &texts, lost: Vec::new() };
        let (mut trees, mut names) = (Vec::new(), Vec::new());
        for k in 0..inputs.len().max(fixed(component.inputs)) {
            let Some(port) = component.input(k) else {
                let most = component.inputs.len();
                return Err(Fault::bad_request(format!("{name} takes {most} inputs, not {}", inputs.len())));
            };
            trees.push(self.tree(port, inputs.get(k).unwrap_or(&Value::Null), &mut outward)?);
            names.push(port.nick.to_owned());
        }
        let account = std::sync::Arc::new(Account::new(limits.solve_bytes));
        let budget = Budget::new(*limits, cancel.clone(), Deadline::after(limits.time), account);
        let call = Call {
            inputs: &trees,
            input_names: &names,
            output_count: component.outputs.len(),
            wanted: &[],
            settings: &Chunk::default(),
            rules: self.rules,
            budget: &budget,
            files: &katydid_component::Files::default(),
            model: None,
            // A component that a script calls writes no files.
            outbox: None,
            kept: None,
        };
        let outcome = (component.run)(&call);
        let error = outcome.messages.iter().find(|message| message.level == Level::Error);
        if let (Some(error), true) = (error, outcome.outputs.iter().all(Tree::is_empty)) {
            return Err(Fault::failed(format!("{}: {}", component.name, error.text)));
        }
        let mut inward = Inward { rules: &self.rules, process: 0, lost: Vec::new() };
        let hint = TypeHint::of(None);
        let outputs = outcome.outputs.iter().map(|tree| {
            let branches = tree.branches().map(|branch| {
                let items = branch.iter().map(|item| inward.value(item, hint)).collect();
                (branch.path().elements().to_vec(), items)
            });
            Value::Tree(branches.collect())
        });
        Ok(Value::List(outputs.collect()))
    }
}

impl Components {
    /// The data of an input: what the script gave, or what the component begins with, cast to the input's type.
    fn tree(&self, port: &Port, value: &Value, outward: &mut Outward<'_>) -> Result<Tree, Fault> {
        let tree = match value {
            Value::Null => port.default.map_or_else(Tree::empty, |default| default()),
            Value::Tree(branches) => {
                let mut builder = TreeBuilder::new();
                for (path, items) in branches {
                    builder.branch(Path::from(path.as_slice()));
                    items.iter().for_each(|item| builder.push(outward.item(item)));
                }
                builder.finish()
            }
            value => match value.items() {
                Some(items) if !matches!(value, Value::Polyline(_)) => {
                    let items = items.iter().map(|item| outward.item(item)).collect();
                    Tree::branch_at(Path::zero(), Column::of_options(items))
                }
                _ => Tree::branch_at(Path::zero(), Column::of_options(vec![outward.item(value)])),
            },
        };
        if tree.is_empty() && !port.optional && !port.many {
            return Err(Fault::bad_request(format!("the input {} has no data", port.name)));
        }
        let cast = cast::column(tree.column(), port.kind, &self.rules);
        if let Some((from, _)) = cast.failed {
            return Err(Fault::bad_request(format!(
                "the input {} takes {}, not {from}",
                port.name, port.kind
            )));
        }
        Ok(tree.with_column(cast.column))
    }
}

/// How many inputs there are besides one that stands for many.
fn fixed(ports: &[Port]) -> usize {
    ports.iter().filter(|port| !port.many).count()
}

fn found(name: &str) -> Option<&'static Component> {
    if let Ok(id) = Uuid::parse_str(name) {
        return registry::by_guid(id);
    }
    registry::by_name(name)
}

fn entry(component: &Component) -> Value {
    let text = |text: &str| Value::from(text);
    let ports = |ports: &[Port]| {
        let port = |port: &Port| {
            let access = match port.access {
                Access::Item => "item",
                Access::List => "list",
                Access::Tree => "tree",
            };
            Value::map([
                ("name", text(port.name)),
                ("nickname", text(port.nick)),
                ("access", text(access)),
                ("default", Value::Bool(port.default.is_some() || port.optional)),
                ("description", text(port.help)),
            ])
        };
        Value::List(ports.iter().map(port).collect())
    };
    Value::map([
        ("id", Value::Text(component.guid.to_string())),
        ("name", text(component.name)),
        ("nickname", text(component.nick)),
        ("tab", text(component.tab)),
        ("panel", text(component.panel)),
        ("description", text(component.help)),
        ("inputs", ports(component.inputs)),
        ("outputs", ports(component.outputs)),
    ])
}
