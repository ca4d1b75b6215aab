//! Setting the inputs of a definition from text.

use katydid_data::{Kind, Value, cast};
use katydid_definition::document::{Branch, Document, Object, Persistent, Special, Stored};
use uuid::Uuid;

/// Why an input could not be set.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum InputError {
    /// No input has that name.
    #[error("no input is called '{name}'{}", near.as_ref().map(|n| format!(": did you mean '{n}'?")).unwrap_or_default())]
    NotFound {
        /// The name asked for.
        name: String,
        /// The most similar name there is.
        near: Option<String>,
    },
    /// Several inputs have it.
    #[error("{count} inputs are called '{name}': use one of their ids, {}", ids.join(", "))]
    Ambiguous {
        /// The name asked for.
        name: String,
        /// How many there are.
        count: usize,
        /// The first few ids.
        ids: Vec<String>,
    },
    /// The input does not take that value.
    #[error("'{value}' cannot be set on '{name}': {reason}")]
    Refused {
        /// The input.
        name: String,
        /// The value given.
        value: String,
        /// Why not.
        reason: String,
    },
}

/// The objects that can be set, with the names they go by, in the order of the document.
pub fn inputs(document: &Document) -> Vec<(String, Uuid)> {
    named(document).into_iter().map(|(name, index)| (name, document.objects[index].id)).collect()
}

fn named(document: &Document) -> Vec<(String, usize)> {
    let mut named = Vec::new();
    for (index, object) in document.objects.iter().enumerate() {
        if let Some(Special::Group(group)) = object.special() {
            if !group.marks_input() {
                continue;
            }
            let mut members = group.members.iter();
            let first = members.find_map(|id| document.objects.iter().position(|o| o.id == *id));
            named.extend(first.map(|member| (group.marked_name().to_owned(), member)));
        } else if can_be_set(object) {
            named.push((object.title().to_owned(), index));
        }
    }
    named
}

/// Sliders, panels, toggles, lists and parameters that read no wire, and contextual inputs: what a wire brings to those
/// is their default.
fn can_be_set(object: &Object) -> bool {
    let reads_no_wire = || object.inputs.iter().all(|port| port.sources.is_empty());
    object.is_floating() && (is_contextual(object) || reads_no_wire())
}

fn is_contextual(object: &Object) -> bool {
    matches!(object.special(), Some(Special::Contextual(_)))
}

/// The index of the one input of that nickname or id. Exact spelling goes before another case, and a contextual input
/// before what else has its name: the slider that is its default, say.
///
/// # Errors
/// There is no such input, or there are several.
pub fn find(document: &Document, name: &str) -> Result<usize, InputError> {
    if let Ok(id) = Uuid::parse_str(name.trim().trim_matches(['{', '}']))
        && let Some(index) = document.objects.iter().position(|o| o.id == id)
    {
        return Ok(index);
    }
    let all = named(document);
    // Servers and their clients know an input by the whole label of its group.
    let name = name.strip_prefix("RH_IN:").map_or(name, str::trim);
    let matching = |same: &dyn Fn(&str) -> bool| {
        let mut found: Vec<usize> = all.iter().filter(|(n, _)| same(n)).map(|(_, i)| *i).collect();
        found.sort_unstable();
        found.dedup();
        let asks = |index: &usize| document.objects.get(*index).is_some_and(is_contextual);
        if found.iter().any(asks) {
            found.retain(asks);
        }
        found
    };
    let mut found = matching(&|n| n == name);
    if found.is_empty() {
        found = matching(&|n| n.eq_ignore_ascii_case(name));
    }
    match found.as_slice() {
        [one] => Ok(*one),
        [] => {
            let near = nearest(all.iter().map(|(other, _)| other.as_str()), name).map(str::to_owned);
            Err(InputError::NotFound { name: name.to_owned(), near })
        }
        many => Err(InputError::Ambiguous {
            name: name.to_owned(),
            count: many.len(),
            ids: many.iter().take(5).map(|&i| document.objects[i].id.to_string()).collect(),
        }),
    }
}

/// Of these names that with the fewest letters different, when it is similar at all.
pub fn nearest<'a>(all: impl Iterator<Item = &'a str>, name: &str) -> Option<&'a str> {
    let distance = |other: &str| edit_distance(&name.to_lowercase(), &other.to_lowercase());
    let (best, there) = all.map(|other| (distance(other), other)).min()?;
    (best <= name.chars().count().max(3) / 2).then_some(there)
}

/// Levenshtein's distance by one row of the table.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().take(200).collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().take(200).enumerate() {
        let mut diagonal = i;
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let substitute = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = substitute.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row.last().copied().unwrap_or(0)
}

/// Gives an object its new value.
///
/// # Errors
/// It does not take that value.
pub fn assign(object: &mut Object, value: &str) -> Result<(), InputError> {
    let name = object.title().to_owned();
    let refuse = |reason: String| InputError::Refused { name: name.clone(), value: value.to_owned(), reason };
    let plain = |error: katydid_definition::Error| refuse(error.to_string());
    match object.special() {
        Some(Special::Slider(slider)) => {
            let x = cast::parse_number(value).ok_or_else(|| refuse("it is not a number".to_owned()))?;
            let (min, max) = (slider.min.min(slider.max), slider.min.max(slider.max));
            // No range holds what is no number.
            if !(min..=max).contains(&x) {
                return Err(refuse(format!("the slider goes from {min} to {max}")));
            }
            object.set_slider(x).map(drop).map_err(plain)
        }
        Some(Special::Panel(_)) => object.set_panel_text(value).map_err(plain),
        Some(Special::Toggle(_)) => {
            match cast::value(&Value::from(value), Kind::Boolean, &Default::default()) {
                Some(Value::Boolean(on)) => object.set_toggle(on).map_err(plain),
                _ => Err(refuse("it is neither true nor false".to_owned())),
            }
        }
        Some(Special::ValueList(list)) => {
            if list.items.iter().any(|item| item.name == value) {
                return object.select_named(value).map_err(plain);
            }
            match value.trim().parse::<usize>() {
                Ok(index) if index < list.items.len() => object.select(&[index]).map_err(plain),
                _ => {
                    let names: Vec<&str> = list.items.iter().map(|item| item.name.as_str()).collect();
                    Err(refuse(format!("the list has {}", names.join(", "))))
                }
            }
        }
        Some(Special::Calendar(_)) => {
            let day =
                cast::parse_time(value).ok_or_else(|| refuse("a day is written 2025-05-28".to_owned()))?;
            object.set_calendar(day.date()).map_err(plain)
        }
        Some(Special::Clock(_)) => {
            let time = cast::parse_time(value).ok_or_else(|| refuse("a time is written 14:05".to_owned()))?;
            object.set_clock(time.time_of_day()).map_err(plain)
        }
        Some(Special::Contextual(_)) | None if object.is_floating() => {
            let kind = katydid_component::registry::by_guid(object.component)
                .and_then(|c| c.inputs.first())
                .map_or(Kind::Generic, |port| port.kind);
            let items: Vec<Stored> = values(value)
                .into_iter()
                .map(|item| stored(&item, kind).ok_or_else(|| refuse(format!("'{item}' is not a {kind}"))))
                .collect::<Result<_, _>>()?;
            let persistent = Persistent { branches: vec![Branch { path: vec![0], items }] };
            object.set_persistent(0, Some(&persistent)).map_err(plain)?;
            // What is brought from outside takes the place of what wires bring, as in a server's request.
            object.set_sources(0, &[]).map_err(plain)
        }
        _ => Err(refuse(format!("a {} cannot be set", object.name))),
    }
}

/// A JSON array is a list of values, anything else is one.
fn values(text: &str) -> Vec<String> {
    let array: Option<Vec<serde_json::Value>> =
        text.trim_start().starts_with('[').then(|| serde_json::from_str(text).ok()).flatten();
    match array {
        Some(array) => array
            .into_iter()
            .map(|item| match item {
                serde_json::Value::String(text) => text,
                other => other.to_string(),
            })
            .collect(),
        None => vec![text.to_owned()],
    }
}

/// A text as a value that a parameter of that type keeps.
fn stored(text: &str, kind: Kind) -> Option<Stored> {
    let text = Value::from(text);
    let value = match kind {
        // What reads as a number is one where anything goes.
        Kind::Generic => cast::value(&text, Kind::Number, &Default::default()).unwrap_or(text),
        kind => cast::value(&text, kind, &Default::default())?,
    };
    Some(match value {
        Value::Boolean(b) => Stored::Boolean(b),
        Value::Integer(i) => Stored::Integer(i),
        Value::Number(x) if x.is_finite() => Stored::Number(x),
        Value::Text(text) => Stored::Text(text.to_string()),
        Value::Point(p) => Stored::Point(p),
        Value::Vector(v) => Stored::Vector(v),
        Value::Plane(p) => Stored::Plane(Box::new(*p)),
        Value::Domain(d) => Stored::Domain(d),
        Value::Domain2(d) => Stored::Domain2([d.u, d.v]),
        Value::Colour(c) => Stored::Colour(katydid_definition::archive::Colour::new(c.a, c.r, c.g, c.b)),
        Value::Path(path) => Stored::Path(path.elements().to_vec()),
        Value::Guid(id) => Stored::Guid(id),
        Value::Circle(c) => Stored::Circle(Box::new(*c)),
        _ => return None,
    })
}
