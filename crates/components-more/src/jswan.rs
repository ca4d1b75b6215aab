//! jSwan: JSON read into outputs, and inputs written as JSON.
//!
//! Names, ports and ids are those of its published sources; the code is our own.

mod text;

use std::sync::Arc;

use katydid_component::{Context, Each, List, ManyItems, Message, component};
use katydid_data::{Tree, TreeBuilder, Value};

pub(crate) use text::Json;

/// What stands in a text, or in the file that the text names.
fn parsed(context: &Context<'_>, text: &str) -> Result<Json, Message> {
    let trimmed = text.trim_start();
    let read;
    let text =
        if trimmed.starts_with(['{', '[', '"']) || !trimmed.to_lowercase().trim_end().ends_with(".json") {
            text
        } else {
            let bytes = context.read_file(text.trim())?;
            read = String::from_utf8(bytes).map_err(|_| Message::error("The file is no text in UTF-8"))?;
            &read
        };
    // A value takes many times the bytes of its text.
    context.bytes(text.len().saturating_mul(8))?;
    Json::parse(text.trim_start_matches('\u{feff}'))
        .map_err(|error| Message::error(format!("No JSON: {error}")))
}

/// The properties of an object; a list is one called "array", as the plug-in has it.
fn properties(json: Json) -> Vec<(String, Json)> {
    match json {
        Json::Object(properties) => properties,
        list @ Json::List(_) => vec![("array".to_owned(), list)],
        _ => Vec::new(),
    }
}

/// Gives each property of an object in JSON to an output of its own, in the order in which they are met first. A list becomes a
/// list, an object inside stays JSON, for another of these. The text may be the path of a file that ends in `.json`. Stands for
/// jSwan's Deserialize Json; outputs go by their order, not by their names.
#[component(
    "22786e9f-f9df-46cc-8815-c2eb104e3455",
    name = "Deserialize Json",
    nick = "DeJson",
    at = "jSwan/JSON"
)]
#[output("Property", "-", "The value of one property.")]
fn deserialize(
    context: &Context<'_>,
    /// The JSON.
    #[port("JSON", "J", kind = Text)]
    texts: &Tree,
) -> Result<Each<Tree>, Message> {
    let mut rows = Vec::new();
    let mut names: Vec<(String, bool)> = Vec::new();
    for branch in texts.branches() {
        for (place, item) in branch.iter().enumerate() {
            context.check()?;
            let Some(Value::Text(text)) = item else { continue };
            let row = properties(parsed(context, &text)?);
            for (name, value) in &row {
                if !names.iter().any(|(known, _)| known == name) {
                    names.push((name.clone(), matches!(value, Json::List(_))));
                }
            }
            rows.push((branch.path().clone(), place, row));
        }
    }
    if names.is_empty() && !texts.is_empty() {
        context.warn("No properties were found");
    }
    let outputs = context.output_count();
    if names.len() > outputs {
        context.warn(format!("{} properties have no output", names.len() - outputs));
    }
    let mut builders: Vec<TreeBuilder<Value>> = (0..outputs).map(|_| TreeBuilder::new()).collect();
    for (path, place, row) in rows {
        for ((name, is_list), builder) in names.iter().zip(&mut builders) {
            // Two properties of one name: the last one counts.
            let value = row.iter().rev().find(|(known, _)| known == name).map(|(_, value)| value);
            let as_list = *is_list || matches!(value, Some(Json::List(_)));
            builder.branch(if as_list { path.child(place) } else { path.clone() });
            match value {
                Some(Json::List(items)) => {
                    context.items(items.len())?;
                    items.iter().for_each(|item| builder.push(item.value()));
                }
                other => builder.push(other.and_then(Json::value)),
            }
        }
    }
    Ok(Each(builders.into_iter().map(TreeBuilder::finish).collect()))
}

/// Makes an object in JSON of the inputs, each under its short name. Inputs without data are left out. Numbers, booleans and JSON
/// stay what they are, all else becomes text. Stands for jSwan's Serialize Json; inputs that are set to take lists are not
/// supported: they make an object an item.
#[component(
    "a02f83ba-161b-42cf-9f5e-cd27d7f39a6f",
    name = "Serialize Json",
    nick = "ReJson",
    at = "jSwan/JSON"
)]
#[output("JSON", "J", "The JSON.")]
fn serialize(
    context: &Context<'_>,
    /// One value.
    #[port("Data", "d", optional)]
    data: ManyItems<Value>,
) -> Result<Option<Arc<str>>, Message> {
    let mut object = Vec::new();
    for (place, value) in data.into_iter().enumerate() {
        if let Some(value) = value {
            object.push((context.input_name(place).to_owned(), Json::of(&value, context)));
        }
    }
    written(context, (!object.is_empty()).then_some(Json::Object(object)))
}

fn written(context: &Context<'_>, json: Option<Json>) -> Result<Option<Arc<str>>, Message> {
    let Some(json) = json else { return Ok(None) };
    let text = json.text();
    context.bytes(text.len())?;
    Ok(Some(text.into()))
}

/// The names and the values of an object in JSON: all, or those of some names, null where there is none. Stands for jSwan's
/// Deserialize Keys and Values.
#[component(
    "01e741f7-35bb-4e64-bd80-e304135374c7",
    name = "Deserialize Keys and Values",
    nick = "DeJsonKV",
    at = "jSwan/JSON"
)]
#[output("Key", "K", "The names, in their order.")]
#[output("Value", "V", "The value of each; objects and lists stay JSON.", kind = Generic)]
fn deserialize_pairs(
    context: &Context<'_>,
    /// The JSON, or the path of a file that ends in `.json`.
    #[port("JSON", "J")]
    text: List<Arc<str>>,
    /// The names that are wanted; all when there are none.
    #[port("Keys", "K", optional)]
    keys: List<Arc<str>>,
) -> Result<(Vec<Arc<str>>, Vec<Option<Value>>), Message> {
    let (mut names, mut values) = (Vec::new(), Vec::new());
    for text in text.iter().flatten() {
        let pairs = properties(parsed(context, &text)?);
        context.items(pairs.len().max(keys.len()))?;
        if keys.is_empty() {
            for (name, value) in pairs {
                names.push(Arc::from(name));
                values.push(value.value());
            }
            continue;
        }
        for key in keys.iter().flatten() {
            let found = pairs.iter().rev().find(|(name, _)| **name == *key);
            values.push(found.and_then(|(_, value)| value.value()));
            names.push(key);
        }
    }
    Ok((names, values))
}

/// Makes an object in JSON of names and values: a value for each name, or all of them as a list under one name. Stands for jSwan's
/// Serialize Keys and Values.
#[component(
    "b6a01fce-08dc-4881-87d7-3d53b089b8ab",
    name = "Serialize Keys and Values",
    nick = "ReJsonKV",
    at = "jSwan/JSON"
)]
#[output("JSON", "J", "The JSON.")]
fn serialize_pairs(
    context: &Context<'_>,
    /// The names.
    #[port("Key", "K")]
    keys: List<Arc<str>>,
    /// The value of each.
    #[port("Value", "V")]
    values: List<Value>,
) -> Result<Option<Arc<str>>, Message> {
    let of = |value: Option<Value>| value.map_or(Json::Null, |value| Json::of(&value, context));
    if keys.len() == 1 {
        let list = Json::List(values.iter().map(of).collect());
        let object = keys.get(0).map(|key| Json::Object(vec![(key.to_string(), list)]));
        return written(context, object);
    }
    if keys.len() != values.len() {
        return Err(Message::error(format!("There are {} keys and {} values", keys.len(), values.len())));
    }
    let mut object = Vec::new();
    for (key, value) in keys.iter().zip(values.iter()) {
        if let Some(key) = key {
            object.push((key.to_string(), of(value)));
        }
    }
    written(context, (!object.is_empty()).then_some(Json::Object(object)))
}

/// An object in JSON with the properties of another put into it. Objects inside are put together too, and so are lists, where
/// what a list has already is not added; of other properties with one name the second object's counts, but for null. Stands for
/// jSwan's Merge Json.
#[component("ecd4d2fd-e522-4dd2-861a-5afc9bb8689c", name = "Merge Json", nick = "JMerge", at = "jSwan/JSON")]
#[output("Merged Json", "J", "The JSON.")]
fn merge(
    context: &Context<'_>,
    /// The object.
    #[port("Source Json", "J")]
    source: Arc<str>,
    /// What is put into it.
    #[port("Override Json", "O")]
    other: Arc<str>,
) -> Result<Option<Arc<str>>, Message> {
    let merged = parsed(context, &source)?.merged(parsed(context, &other)?);
    written(context, Some(merged))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    const TEXT: &str = r#"{"z": 1, "a": 2.5, "list": [1, "two", null], "in": {"k": true}}"#;

    #[test]
    fn properties_come_in_their_order() {
        let trial = |k: usize| Trial::of("Deserialize Json").item(TEXT).outputs(4).texts(k);
        assert_eq!(trial(0), ["{0}: 1"]);
        assert_eq!(trial(1), ["{0}: 2.5"]);
        assert_eq!(trial(2), ["{0;0}: 1, two, null"]);
        assert_eq!(trial(3), [r#"{0}: {"k":true}"#]);
    }

    #[test]
    fn objects_without_a_property_give_a_null() {
        let trial = |k: usize| {
            let texts = [r#"{"a": 1}"#, r#"{"b": 2}"#];
            Trial::of("Deserialize Json").list(texts).outputs(2).texts(k)
        };
        assert_eq!(trial(0), ["{0}: 1, null"]);
        assert_eq!(trial(1), ["{0}: null, 2"]);
    }

    #[test]
    fn inputs_are_written_by_their_names() {
        let trial = Trial::of("Serialize Json").item(1).item("b\"c").item(0.5).names(["x", "y", "z"]);
        assert_eq!(trial.texts(0), [r#"{0}: {"x":1,"y":"b\"c","z":0.5}"#]);
        let inner = Trial::of("Serialize Json").item(r#"{"k":[1,2]}"#).names(["o"]);
        assert_eq!(inner.texts(0), [r#"{0}: {"o":{"k":[1,2]}}"#]);
    }

    #[test]
    fn pairs_there_and_back() {
        let pairs = |k: usize| Trial::of("Deserialize Keys and Values").item(TEXT).texts(k);
        assert_eq!(pairs(0), ["{0}: z, a, list, in"]);
        assert_eq!(pairs(1), [r#"{0}: 1, 2.5, [1,"two",null], {"k":true}"#]);
        let some = Trial::of("Deserialize Keys and Values").item(TEXT).list(["a", "none"]);
        assert_eq!(some.texts(1), ["{0}: 2.5, null"]);
        let back = || Trial::of("Serialize Keys and Values");
        assert_eq!(back().list(["p", "q"]).list([1, 2]).texts(0), [r#"{0}: {"p":1,"q":2}"#]);
        assert_eq!(back().list(["p"]).list([1, 2]).texts(0), [r#"{0}: {"p":[1,2]}"#]);
        assert_eq!(back().list(["p", "q"]).list([1]).message(), "There are 2 keys and 1 values");
    }

    #[test]
    fn later_properties_count() {
        let trial = |other: &str| {
            let source = r#"{"a":1,"o":{"x":1},"l":[1,2]}"#;
            Trial::of("Merge Json").item(source).item(other).texts(0)
        };
        let wanted = r#"{0}: {"a":3,"o":{"x":1,"y":2},"l":[1,2]}"#;
        assert_eq!(trial(r#"{"o":{"y":2},"a":3}"#), [wanted]);
        assert_eq!(trial(r#"{"a":null,"l":[2,5]}"#), [r#"{0}: {"a":1,"o":{"x":1},"l":[1,2,5]}"#]);
    }

    #[test]
    fn what_is_no_json_is_refused() {
        let deep = "[".repeat(100_000);
        for text in ["{", "", "{\"a\":}", deep.as_str()] {
            assert!(Trial::of("Deserialize Json").item(text).outputs(1).message().starts_with("No JSON"));
        }
    }
}
