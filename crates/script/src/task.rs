//! A script component's turn as a message: its code, its ports, and the values of every iteration.

use std::ops::Range;
use std::path::Path as FilePath;

use katydid_component::{Access, Matching, Ranges};
use katydid_data::cast::Rules;
use katydid_data::{Column, Items, Kind, Path, Tree};
use katydid_definition::document::{Access as Asked, Port, ScriptLanguage, TypeHint};
use katydid_members::Value;
use katydid_solver::ScriptTask;

use crate::to_script::Inward;

/// The name of the output that prints go to.
pub(crate) const OUT: &str = "out";

/// What a run is made of, ready for any process.
#[derive(Debug)]
pub(crate) struct Prepared {
    /// The message without its iterations.
    pub(crate) head: Vec<(&'static str, Value)>,
    pub(crate) inputs: Vec<(Access, TypeHint, Tree)>,
    pub(crate) rules: Rules,
    /// The branch sets: their paths, and how many iterations each has.
    pub(crate) sets: Vec<(Path, usize)>,
    /// Whether lists get the number of the iteration at the end of their path.
    pub(crate) grows: bool,
    /// For each output of the component its place among those of the script; none for the prints.
    pub(crate) places: Vec<Option<usize>>,
}

fn access(port: &Port) -> Access {
    match port.access {
        Asked::Item => Access::Item,
        Asked::List => Access::List,
        Asked::Tree => Access::Tree,
    }
}

/// The variable that a port is in a script: its short name.
pub(crate) fn variable(port: &Port) -> &str {
    if port.nickname.is_empty() { &port.name } else { &port.nickname }
}

fn text(text: &str) -> Value {
    Value::from(text)
}

impl Prepared {
    pub(crate) fn new(task: &ScriptTask<'_>) -> Self {
        Self::of(task, None)
    }

    /// The same, of a definition that lies somewhere.
    pub(crate) fn of(task: &ScriptTask<'_>, definition: Option<&FilePath>) -> Self {
        let inputs: Vec<(Access, TypeHint, Tree)> = task
            .inputs
            .iter()
            .map(|(port, tree)| (access(port), TypeHint::of(port.type_hint), tree.clone()))
            .collect();
        let trees: Vec<Tree> = inputs.iter().map(|(_, _, tree)| tree.clone()).collect();
        let accesses: Vec<Access> = inputs.iter().map(|(access, ..)| *access).collect();
        let matching = Matching::new(&trees, &accesses, None);
        let sets = matching.paths().iter().enumerate();
        let sets = sets.map(|(set, path)| (path.clone(), matching.set_range(set).len())).collect();
        let mut count = 0;
        let places = task.object.outputs.iter().map(|port| {
            if variable(port) == OUT {
                return None;
            }
            count += 1;
            Some(count - 1)
        });
        let places = places.collect();
        let grows = accesses.contains(&Access::Item);
        Self { head: head(task, definition), inputs, rules: task.rules, sets, grows, places }
    }

    /// How many iterations there are.
    pub(crate) fn iterations(&self) -> usize {
        self.sets.iter().map(|(_, count)| count).sum()
    }

    /// The values of the inputs in every iteration, a list each.
    pub(crate) fn rows(&self, inward: &mut Inward<'_>) -> Vec<Value> {
        let trees: Vec<Tree> = self.inputs.iter().map(|(_, _, tree)| tree.clone()).collect();
        let accesses: Vec<Access> = self.inputs.iter().map(|(access, ..)| *access).collect();
        let matching = Matching::new(&trees, &accesses, None);
        let (mut iterations, mut ranges) = (Vec::with_capacity(self.iterations()), Ranges::new());
        for (set, (_, count)) in self.sets.iter().enumerate() {
            matching.ranges(set, &mut ranges);
            for k in 0..*count {
                let row = self.inputs.iter().zip(&ranges).map(|((access, hint, tree), range)| match access {
                    Access::Item => {
                        let last = range.len().saturating_sub(1);
                        let item = (!range.is_empty()).then(|| tree.column().get(range.start + k.min(last)));
                        inward.value(item.flatten(), *hint)
                    }
                    Access::List if tree.is_empty() => Value::List(Vec::new()),
                    Access::List => plain(tree.column(), range, *hint).unwrap_or_else(|| {
                        let items = range.clone().map(|i| inward.value(tree.column().get(i), *hint));
                        Value::list(items.collect())
                    }),
                    _ => whole(tree, *hint, inward),
                });
                iterations.push(Value::List(row.collect()));
            }
        }
        iterations
    }

    /// The whole message, for one process.
    pub(crate) fn message(&self, inward: &mut Inward<'_>) -> Value {
        let iterations = self.rows(inward);
        let mut pairs: Vec<(Value, Value)> =
            self.head.iter().map(|(key, value)| (text(key), value.clone())).collect();
        pairs.push((text("iterations"), Value::List(iterations)));
        Value::Map(pairs)
    }
}

/// A part of a column that a script gets as it is: numbers, points and vectors without nulls, which their hint does not
/// change. Lists of thousands are handed over without a look at each item.
fn plain(column: &Column, range: &Range<usize>, hint: TypeHint) -> Option<Value> {
    if range.len() < 2 || column.null_mask().is_some() || hint.is("GeometryBase") {
        return None;
    }
    let fits = |kind: Kind| hint.kind.is_none_or(|asked| asked == kind);
    match column.items() {
        Items::Numbers(items) if fits(Kind::Number) => {
            Some(Value::Numbers(items.get(range.clone())?.to_vec()))
        }
        Items::Points(items) if fits(Kind::Point) => Some(Value::Points(items.get(range.clone())?.to_vec())),
        Items::Vectors(items) if fits(Kind::Vector) => {
            Some(Value::Vectors(items.get(range.clone())?.to_vec()))
        }
        _ => None,
    }
}

/// A whole tree.
fn whole(tree: &Tree, hint: TypeHint, inward: &mut Inward<'_>) -> Value {
    let branches = tree.branches().map(|branch| {
        let items = branch.iter().map(|item| inward.value(item, hint)).collect();
        (branch.path().elements().to_vec(), items)
    });
    Value::Tree(branches.collect())
}

/// What the message says of the component.
fn head(task: &ScriptTask<'_>, definition: Option<&FilePath>) -> Vec<(&'static str, Value)> {
    let object = task.object;
    let language = match task.script.language {
        ScriptLanguage::IronPython => "python2",
        _ => "python3",
    };
    let inputs = task.inputs.iter().map(|(port, _)| {
        let access = match port.access {
            Asked::Item => "item",
            Asked::List => "list",
            Asked::Tree => "tree",
        };
        Value::map([
            ("name", text(variable(port))),
            ("access", text(access)),
            ("hint", text(TypeHint::of(port.type_hint).name)),
            ("optional", Value::Bool(port.optional)),
            ("description", text(&port.description)),
        ])
    });
    let outputs = object.outputs.iter().filter(|port| variable(port) != OUT);
    let outputs = outputs
        .map(|port| Value::map([("name", text(variable(port))), ("description", text(&port.description))]));
    let units = &task.rules.units;
    let document = Value::map([
        ("tolerance", Value::Number(task.rules.tolerance.absolute)),
        ("angle_tolerance", Value::Number(task.rules.tolerance.angle)),
        ("units", Value::Text(format!("{units:?}"))),
        ("path", text(&definition.map(|path| path.display().to_string()).unwrap_or_default())),
        ("name", text(&definition.and_then(FilePath::file_stem).unwrap_or_default().to_string_lossy())),
    ]);
    vec![
        // Runs come one after the other: there is nothing to tell apart.
        ("run", Value::Int(0)),
        ("code", text(&task.script.text)),
        ("language", text(language)),
        ("key", Value::Text(object.id.to_string())),
        ("name", text(&object.name)),
        ("nickname", text(object.title())),
        ("inputs", Value::List(inputs.collect())),
        ("outputs", Value::List(outputs.collect())),
        ("doc", document),
    ]
}
