use katydid_component::registry;
use katydid_compute::definition::Interface;
use katydid_data::cast::{self, Rules};
use katydid_data::{Column, Items, Kind, Tree, Value};
use katydid_definition::document::{Document, Object, Special, ids};
use pyo3::prelude::*;
use uuid::Uuid;

use crate::errors::InputError;

/// What a definition can be given: a slider, a panel, a toggle, a list, a parameter without a wire, a contextual input, or
/// a group that is marked as input.
#[pyclass(frozen, get_all, module = "katydid")]
#[derive(Debug, Clone)]
pub(crate) struct Input {
    /// The name that `solve` takes.
    name: String,
    /// The name of the type of its values.
    kind: &'static str,
    /// The smallest number it takes, where there is one.
    minimum: Option<f64>,
    /// The largest number it takes, where there is one.
    maximum: Option<f64>,
    /// What its author says of it.
    description: Option<String>,
    /// Whether the author marked it as an input: a contextual input, or one in a group called `RH_IN:name`.
    marked: bool,
    /// What can be chosen, of a value list.
    choices: Option<Vec<String>>,
    /// The number, text, truth value or choice that it has now, where it is one.
    value: Option<String>,
    /// The id of its object in the definition.
    id: String,
}

impl Input {
    /// All inputs, by the names that the command line has for them; those that are marked come first.
    pub(super) fn all(document: &Document, interface: &Interface) -> Vec<Self> {
        let lookup = document.lookup();
        let mut all: Vec<Self> = katydid_session::inputs(document)
            .into_iter()
            .filter_map(|(name, id)| Some(Self::of(name, lookup.object(id)?, document, interface)))
            .collect();
        let marked: Vec<String> =
            all.iter().filter(|input| input.marked).map(|input| input.id.clone()).collect();
        // A slider in a group that is marked is there by the name of the group.
        let mut seen: std::collections::HashSet<(String, String)> = std::collections::HashSet::new();
        all.retain(|input| {
            (input.marked || !marked.contains(&input.id))
                && seen.insert((input.id.clone(), input.name.clone()))
        });
        all.sort_by_key(|input| !input.marked);
        all
    }

    fn of(name: String, at: usize, document: &Document, interface: &Interface) -> Self {
        let object = document.objects.get(at);
        let said = interface.inputs.iter().find(|input| {
            input.object == at
                && (input.name.trim_start_matches("RH_IN:").trim() == name
                    || object.is_some_and(is_contextual))
        });
        let special = object.and_then(Object::special);
        let (mut minimum, mut maximum) = said.map_or((None, None), |said| (said.minimum, said.maximum));
        let mut choices = None;
        let mut value = None;
        match special {
            Some(Special::Slider(slider)) => {
                minimum = Some(slider.min.min(slider.max));
                maximum = Some(slider.min.max(slider.max));
                value = Some(katydid_data::text::number(slider.value));
            }
            Some(Special::ValueList(list)) => {
                value = list.items.iter().find(|item| item.selected).map(|item| item.name.clone());
                choices = Some(list.items.into_iter().map(|item| item.name).collect());
            }
            Some(Special::Toggle(on)) => value = Some(if on { "True" } else { "False" }.to_owned()),
            _ => {}
        }
        Self {
            name,
            kind: object.map_or(Kind::Generic, kind).name(),
            minimum,
            maximum,
            description: said.and_then(|said| said.prompt.clone()).filter(|text| !text.trim().is_empty()),
            marked: said.is_some(),
            choices,
            value,
            id: object.map(|object| object.id).unwrap_or(Uuid::nil()).to_string(),
        }
    }
}

fn is_contextual(object: &Object) -> bool {
    matches!(object.special(), Some(Special::Contextual(_)))
}

/// The type of the values that an object takes.
pub(super) fn kind(object: &Object) -> Kind {
    if object.component == ids::PANEL {
        return Kind::Text;
    }
    match object.special() {
        Some(Special::Slider(_)) => Kind::Number,
        Some(Special::Toggle(_)) => Kind::Boolean,
        _ => {
            let port = registry::by_guid(object.component).and_then(|component| component.inputs.first());
            port.map_or(Kind::Generic, |port| port.kind)
        }
    }
}

fn refused(object: &Object, why: impl std::fmt::Display) -> PyErr {
    InputError::new_err(format!("'{}' does not take that: {why}", object.title()))
}

/// The data that an object gets for what Python brings.
pub(super) fn data(object: &Object, brought: &Bound<'_, PyAny>, rules: &Rules) -> PyResult<Tree> {
    let kind = kind(object);
    let tree =
        crate::values::given(brought, kind).map_err(|error| refused(object, error.value(brought.py())))?;
    if let Some(number) = not_finite(tree.column()) {
        return Err(refused(object, format!("{number} is not a finite number")));
    }
    let only = (tree.item_count() == 1).then(|| tree.column().get(0)).flatten();
    match object.special() {
        Some(Special::Slider(slider)) => {
            let wanted = only.and_then(|value| cast::value(&value, Kind::Number, rules));
            let Some(Value::Number(x)) = wanted else {
                return Err(refused(object, "a slider takes one number"));
            };
            let (low, high) = (slider.min.min(slider.max), slider.min.max(slider.max));
            if x < low || x > high {
                return Err(refused(
                    object,
                    format!("the slider goes from {low} to {high}, and {x} is outside"),
                ));
            }
            Ok(Tree::item(Value::Number(x)))
        }
        Some(Special::ValueList(_)) => match only {
            Some(Value::Text(name)) => chosen(object, &name),
            _ => Ok(tree),
        },
        _ => {
            let made = cast::column(tree.column(), kind, rules);
            match made.failed {
                Some((from, count)) => {
                    Err(refused(object, format!("{count} of its items, a {from}, cannot be a {kind}")))
                }
                None => Ok(tree.with_column(made.column)),
            }
        }
    }
}

/// The first number of a column that is none, or is infinite. Long columns are looked through as they lie.
fn not_finite(column: &Column) -> Option<f64> {
    fn first(mut numbers: impl Iterator<Item = f64>) -> Option<f64> {
        numbers.find(|x| !x.is_finite())
    }
    match column.items() {
        Items::Numbers(all) => first(all.iter().copied()),
        Items::Points(all) => {
            all.iter().find(|p| !p.is_finite()).and_then(|p| first([p.x, p.y, p.z].into_iter()))
        }
        Items::Vectors(all) => {
            all.iter().find(|v| !v.is_finite()).and_then(|v| first([v.x, v.y, v.z].into_iter()))
        }
        Items::Domains(all) => first(all.iter().flat_map(|range| [range.start, range.end])),
        Items::Values(all) => all.iter().find_map(|value| match value {
            Value::Number(x) => Some(*x).filter(|x| !x.is_finite()),
            Value::Point(p) => first([p.x, p.y, p.z].into_iter()),
            Value::Vector(v) => first([v.x, v.y, v.z].into_iter()),
            Value::Domain(range) => first([range.start, range.end].into_iter()),
            _ => None,
        }),
        _ => None,
    }
}

/// What a value list gives when one of its items is chosen, by its name.
fn chosen(object: &Object, name: &str) -> PyResult<Tree> {
    let mut copy = object.clone();
    katydid_session::assign_input(&mut copy, name).map_err(|error| InputError::new_err(error.to_string()))?;
    let mut alone = Document::new();
    alone.objects.push(copy);
    let mut engine = katydid_solver::Engine::new(alone, katydid_solver::Options::default());
    engine.solve();
    Ok(engine.report(0).and_then(|report| report.outputs.first().cloned()).unwrap_or_default())
}

#[pymethods]
impl Input {
    fn __repr__(&self) -> String {
        let range = match (self.minimum, self.maximum) {
            (Some(low), Some(high)) => format!(", {low}..{high}"),
            _ => String::new(),
        };
        format!("<Input '{}': {}{range}>", self.name, self.kind)
    }
}
