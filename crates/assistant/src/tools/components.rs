//! Components by words, with their help.

use std::fmt::Write as _;

use katydid_component::{Access, Component, Port, registry};
use katydid_elementary::Elementary;
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
    let found = ranked(&lower, &words);
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

/// The components in which one of the words is, the best first; those of equal worth in the order of the tabs.
///
/// Each word counts by where it stands, times the logarithm of how seldom it is among all components (inverse document
/// frequency, K. Spärck Jones 1972): `of` says little, `revolution` much.
fn ranked(whole: &str, words: &[&str]) -> Vec<(f64, &'static Component)> {
    let all: Vec<&Component> = registry::all().into_iter().filter(|component| !component.old).collect();
    let worths: Vec<Vec<f64>> = all.iter().map(|component| worths(component, words)).collect();
    #[allow(clippy::cast_precision_loss, reason = "numbers of components")]
    let weights: Vec<f64> = (0..words.len())
        .map(|k| {
            let having = worths.iter().filter(|of| of[k] > 0.0).count();
            (1.0 + all.len() as f64 / having.max(1) as f64).logarithm()
        })
        .collect();
    let mut found: Vec<(f64, &Component)> = all
        .into_iter()
        .zip(&worths)
        .filter(|(_, worths)| worths.iter().any(|worth| *worth > 0.0))
        .map(|(component, worths)| {
            let sum: f64 = worths.iter().zip(&weights).map(|(worth, weight)| worth * weight).sum();
            let named = if component.name.to_lowercase() == whole { WHOLE_NAME } else { 0.0 };
            let floating = if component.floating { FLOATING } else { 0.0 };
            (sum + named - floating, component)
        })
        .collect();
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    found
}

/// What is before all others: the name as it was asked for.
const WHOLE_NAME: f64 = 1000.0;
/// A parameter comes after a component that is worth as much.
const FLOATING: f64 = 2.0;

/// What each of the words is worth for a component: most in its name, least among its ports.
fn worths(component: &Component, words: &[&str]) -> Vec<f64> {
    let name = component.name.to_lowercase();
    let nick = component.nick.to_lowercase();
    let place = format!("{} {}", component.tab, component.panel).to_lowercase();
    let help = component.help.to_lowercase();
    let ports: Vec<String> =
        component.inputs.iter().chain(component.outputs).map(|port| port.name.to_lowercase()).collect();
    let worth = |word: &&str| {
        // Words of many: `curves` means what `curve` does.
        let stem = word.strip_suffix('s').filter(|stem| stem.len() > 3).unwrap_or(word);
        if name.split_whitespace().any(|own| own == *word || own == stem) {
            40.0
        } else if name.contains(stem) {
            25.0
        } else if nick == *word {
            20.0
        } else if place.contains(stem) {
            10.0
        } else if help.split(|c: char| !c.is_alphanumeric()).any(|own| own.starts_with(stem)) {
            8.0
        } else if ports.iter().any(|port| port.contains(stem)) {
            5.0
        } else {
            0.0
        }
    };
    words.iter().map(worth).collect()
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
            // Words that are in nearly all components do not hide the one that counts.
            ("revolution surface of a profile curve", "Revolution"),
            ("the closest point on a mesh", "Mesh Closest Point"),
            ("make a loft through curves", "Loft"),
            ("voronoi cells of points in the plane", "Voronoi"),
        ] {
            assert!(first(words).iter().any(|name| name == wanted), "{words}: {:?}", first(words));
        }
    }
}
