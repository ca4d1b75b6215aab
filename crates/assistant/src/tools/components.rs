//! Components by words, with their help.

use std::fmt::Write as _;

use katydid_component::{Access, Component, Port, registry};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};

use super::page::Part;
use super::{Does, Entry, Reply, entry};
use crate::document::cut;
use crate::fault::Fault;
use crate::store::Store;

pub(super) fn entries() -> Vec<Entry> {
    vec![
        entry(
            "find_components",
            "Find components",
            "Finds components by words: what they do, their names, tabs, panels, ports. Gives the best first, each with its \
             inputs and outputs in a line. Of a component that Katydid does not have the reason is told.",
            Does::Reads,
            find,
        ),
        entry(
            "component_help",
            "Component help",
            "The help of one component: what it does, and of each input and output the type, how much data it takes at a time, \
             and what it means.",
            Does::Reads,
            explain,
        ),
    ]
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Find {
    /// Words, as `divide curve` or `closest point mesh`.
    words: String,
    /// The first of the list that is given, from 0.
    from: Option<usize>,
    /// How many are given at most; 15 when not given.
    limit: Option<usize>,
}

fn find(_: &Store, given: Find) -> Result<Reply, Fault> {
    let lower = cut(&given.words).to_lowercase();
    let words: Vec<&str> = lower
        .split(|c: char| !c.is_alphanumeric() && !"+-*/^²°".contains(c))
        .filter(|word| !word.is_empty())
        .collect();
    if words.is_empty() {
        return Err(Fault::new("nothing was looked for", "words", "there are no words in it"));
    }
    let mut found: Vec<(u32, &Component)> = registry::all()
        .into_iter()
        .filter(|component| !component.old)
        .filter_map(|component| Some((score(component, &lower, &words)?, component)))
        .collect();
    // Those of equal worth stay in the order of the tabs.
    found.sort_by_key(|(score, _)| std::cmp::Reverse(*score));
    let part = Part::new(given.from, Some(given.limit.unwrap_or(15)));
    let mut told = part.of("components", &found, |(_, component)| short(component));
    let missing: Vec<Value> = registry::all_unsupported()
        .filter(|known| known.name.to_lowercase() == lower)
        .map(|known| json!({ "name": known.name, "reason": known.reason }))
        .collect();
    if !missing.is_empty() {
        told["not_supported"] = json!(missing);
    }
    if found.is_empty() {
        told["note"] = json!("no component has one of these words: try others, in English");
    }
    Ok(told.into())
}

/// How well a component fits words; none where it does not at all. A word in the name counts more than one in the help, and
/// all words together more than some.
fn score(component: &Component, whole: &str, words: &[&str]) -> Option<u32> {
    let name = component.name.to_lowercase();
    let nick = component.nick.to_lowercase();
    let place = format!("{} {}", component.tab, component.panel).to_lowercase();
    let help = component.help.to_lowercase();
    let ports = || component.inputs.iter().chain(component.outputs);
    let mut sum = if name == whole { 200 } else { 0 };
    let mut fitting = 0;
    for word in words {
        // Words of many: `curves` means what `curve` does.
        let stem = word.strip_suffix('s').filter(|stem| stem.len() > 3).unwrap_or(word);
        let worth = if name.split_whitespace().any(|own| own == *word || own == stem) {
            40
        } else if name.contains(stem) {
            25
        } else if nick == *word {
            20
        } else if place.contains(stem) {
            10
        } else if help.split(|c: char| !c.is_alphanumeric()).any(|own| own.starts_with(stem)) {
            8
        } else if ports().any(|port| port.name.to_lowercase().contains(stem)) {
            5
        } else {
            0
        };
        fitting += u32::from(worth > 0);
        sum += worth;
    }
    let all = u32::try_from(words.len()).unwrap_or(u32::MAX);
    (fitting > 0)
        .then(|| sum + if fitting == all { 60 } else { 0 } - u32::from(component.floating && sum > 0) * 2)
}

fn short(component: &Component) -> Value {
    let summary = component.help.split_inclusive(". ").next().unwrap_or_default().trim();
    let names = |ports: &[Port]| {
        let name =
            |port: &Port| format!("{}: {}{}", port.name, port.kind.name(), if port.many { " …" } else { "" });
        ports.iter().map(name).collect::<Vec<_>>().join(", ")
    };
    json!({
        "name": text_name(component),
        "tab": format!("{}/{}", component.tab, component.panel),
        "id": component.guid,
        "does": cut(summary),
        "inputs": if component.floating { String::new() } else { names(component.inputs) },
        "outputs": names(component.outputs),
    })
}

/// The name that means this component in a text: with its panel where another one has the name alone.
fn text_name(component: &Component) -> String {
    use katydid_definition::kd::Catalogue;
    let meant = katydid_session::Registry.by_name(component.name, component.floating).map(|facts| facts.guid);
    match meant == Some(component.guid) {
        true => component.name.to_owned(),
        false => format!("{}/{}", component.panel, component.name),
    }
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Explain {
    /// Its name, as `Divide Curve` or `Grid/Square`, or its id.
    name: String,
}

fn explain(_: &Store, given: Explain) -> Result<Reply, Fault> {
    let text = help(&given.name)
        .map_err(|why| Fault::new("no help was found", format!("component \"{}\"", cut(&given.name)), why))?;
    Ok(json!({ "help": text }).into())
}

/// The component that a name or id means.
pub(super) fn component(name: &str) -> Result<&'static Component, String> {
    use katydid_definition::kd::Catalogue;
    let by_id = || uuid::Uuid::try_parse(name.trim()).ok().and_then(registry::by_guid);
    let by_name = || {
        katydid_session::Registry.by_name(name.trim(), false).and_then(|facts| registry::by_guid(facts.guid))
    };
    if let Some(found) = by_id().or_else(by_name) {
        return Ok(found);
    }
    if let Some(known) =
        registry::all_unsupported().find(|known| known.name.eq_ignore_ascii_case(name.trim()))
    {
        return Err(format!("it is not supported: {}", known.reason));
    }
    let lower = name.to_lowercase();
    let near: Vec<&str> = registry::all()
        .into_iter()
        .filter(|one| !one.old && lower.len() > 2 && one.name.to_lowercase().contains(&lower))
        .take(5)
        .map(|one| one.name)
        .collect();
    Err(match near.is_empty() {
        true => "there is no such component: find_components finds some by words".to_owned(),
        false => format!("there is no such component; there are {}", near.join(", ")),
    })
}

/// The help of a component, as Markdown.
///
/// # Errors
/// There is none of that name or id.
pub(crate) fn help(name: &str) -> Result<String, String> {
    let found = component(name)?;
    let Component { name, nick, tab, panel, help, guid, .. } = found;
    let mut text = format!("# {name} ({nick})\n\n{tab} / {panel}, id {guid}\n\n{help}\n");
    for (title, ports) in [("Inputs", found.inputs), ("Outputs", found.outputs)] {
        if ports.is_empty() || (found.floating && title == "Inputs") {
            continue;
        }
        let _ = writeln!(text, "\n## {title}\n");
        for port in ports {
            let access = match port.access {
                Access::Item => "item",
                Access::List => "list",
                Access::Tree => "tree",
            };
            let optional = if port.optional { ", optional" } else { "" };
            let many = if port.many { ", any number" } else { "" };
            let kind = port.kind;
            let _ = writeln!(
                text,
                "- **{}** ({}): {kind}, {access}{optional}{many}. {}",
                port.name, port.nick, port.help
            );
        }
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic, reason = "a test may fail")]

    use super::*;

    fn first(words: &str) -> Vec<String> {
        katydid_components::link();
        let store = Store::new(Default::default()).unwrap_or_else(|why| panic!("{why}"));
        let given = Find { words: words.to_owned(), from: None, limit: Some(5) };
        let Ok(Reply::Done(answer)) = find(&store, given) else { panic!("{words}") };
        let all = answer.value["components"].as_array().cloned().unwrap_or_default();
        all.iter().map(|one| one["name"].as_str().unwrap_or_default().to_owned()).collect()
    }

    #[test]
    fn what_is_meant_is_found_by_words() {
        for (words, wanted) in [
            ("divide curve", "Divide Curve"),
            ("circle", "Circle"),
            ("area of a surface", "Area"),
            ("loft", "Loft"),
            ("number slider", "Number Slider"),
            ("closest point on a curve", "Curve Closest Point"),
        ] {
            assert!(first(words).iter().any(|name| name == wanted), "{words}: {:?}", first(words));
        }
    }
}
