//! The components against the facts read from real files: names, nicknames, order and access of ports.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use std::collections::HashSet;
use std::path::PathBuf;

use katydid_component::{Access, Component, registry};
use serde_json::Value;
use uuid::Uuid;

/// Whether the ports of a component are any number: the catalogue holds the first few of one file.
fn is_open(component: &Component) -> bool {
    component.inputs.iter().chain(component.outputs).any(|p| p.many)
}

fn access(word: Option<&str>) -> Access {
    match word {
        Some("list") => Access::List,
        Some("tree") => Access::Tree,
        _ => Access::Item,
    }
}

/// The rows of the catalogue, where it is at hand.
fn catalogue() -> Option<Vec<Value>> {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/components.json"));
    if !path.exists() {
        assert!(std::env::var_os("KATYDID_REQUIRE_SHARED").is_none(), "{} is absent", path.display());
        println!("skipped: {} is absent", path.display());
        return None;
    }
    Some(serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap())
}

#[test]
fn components_are_what_files_say() {
    assert!(katydid_components::link() > 100);
    let Some(catalogue) = catalogue() else { return };
    let (mut known, mut differing) = (0, Vec::new());
    for row in &catalogue {
        let guid = Uuid::parse_str(row["guid"].as_str().unwrap()).unwrap();
        let Some(component) = registry::by_guid(guid) else { continue };
        known += 1;
        // Earlier versions answer with the newest one's ports.
        if component.guid != guid || is_open(component) || component.floating {
            continue;
        }
        let name = row["name"].as_str().unwrap();
        if component.name != name {
            differing.push(format!("{guid}: {} instead of {name}", component.name));
        }
        for (side, ports) in [("inputs", component.inputs), ("outputs", component.outputs)] {
            let facts = row[side].as_array().unwrap();
            // A component may have more ports than the files at hand know.
            for (fact, port) in facts.iter().zip(ports) {
                if fact["nickname"].as_str() != Some(port.nick) {
                    differing.push(format!("{name} {side}: {} instead of {}", port.nick, fact["nickname"]));
                }
                if access(fact["access"].as_str()) != port.access {
                    differing.push(format!("{name} {side} {}: {:?} access", port.nick, port.access));
                }
            }
            if facts.len() > ports.len() {
                differing.push(format!("{name}: {} {side} instead of {}", ports.len(), facts.len()));
            }
        }
    }
    println!("{known} of {} rows of the catalogue are in; {} differ:", catalogue.len(), differing.len());
    differing.iter().for_each(|line| println!("  {line}"));
    assert!(differing.len() <= MOST, "{} differences", differing.len());
}

/// How many facts differ on purpose: the cells of Square and Rectangular grids are a branch a column, as pictures show,
/// an old Null Check takes and gives whole trees, and an old Duplicate, Split and Graft Tree give lists and
/// trees, and an old Curve | Line two lists, which the catalogue does not tell for outputs of their age.
const MOST: usize = 9;

/// The panels that are in whole: each row of the catalogue is a component or has its reason for being none.
const WHOLE: [(&str, &[&str]); 11] = [
    ("Params", &[]),
    ("Maths", &[]),
    ("Complex", &[]),
    ("Scalar", &[]),
    ("Sets", &[]),
    ("Vector", &[]),
    ("Curve", &[]),
    ("Intersect", &[]),
    ("Mesh", &[]),
    ("Display", &[]),
    ("Transform", &[]),
];

/// What a definition draws or opens rather than runs.
const NOT_RUN: [&str; 4] = ["Group", "Scribble", "Sketch", "Cluster"];

#[test]
fn whole_panels_lack_nothing_without_a_reason() {
    katydid_components::link();
    let Some(catalogue) = catalogue() else { return };
    let mut lacking = Vec::new();
    for row in &catalogue {
        let text = |key: &str| row[key].as_str().unwrap_or_default();
        let guid = Uuid::parse_str(text("guid")).unwrap();
        let mut panels = WHOLE.iter().filter(|(tab, _)| *tab == text("tab")).map(|(_, panels)| panels);
        if !panels.any(|panels| panels.is_empty() || panels.contains(&text("panel"))) {
            continue;
        }
        let is_known = registry::by_guid(guid).is_some() || NOT_RUN.contains(&text("name"));
        if is_known == registry::unsupported(guid).is_some() {
            lacking.push(format!("{guid} {} at {}/{}", text("name"), text("tab"), text("panel")));
        }
    }
    assert!(lacking.is_empty(), "neither or both a component and a reason:\n{}", lacking.join("\n"));
}

/// The least share of the stock that is in, in percent; what is left has its reasons in `unsupported.rs`.
const SHARE: f64 = 96.8;

#[test]
fn nearly_all_of_the_stock_is_in() {
    katydid_components::link();
    let Some(catalogue) = catalogue() else { return };
    let stock = |row: &&Value| row["group"] == "stock" && row["obsolete"] == false;
    let is_in = |row: &&Value| {
        let guid = Uuid::parse_str(row["guid"].as_str().unwrap_or_default()).unwrap();
        registry::by_guid(guid).is_some() || NOT_RUN.contains(&row["name"].as_str().unwrap_or_default())
    };
    let rows: Vec<&Value> = catalogue.iter().filter(stock).collect();
    let (known, left): (Vec<&Value>, Vec<&Value>) = rows.iter().partition(|row| is_in(row));
    let share = 100.0 * known.len() as f64 / rows.len() as f64;
    println!("{} of {} rows of the stock are in, {share:.1} %; left:", known.len(), rows.len());
    left.iter().for_each(|row| println!("  {} {}", row["guid"], row["name"]));
    assert!(share >= SHARE, "{share:.1} %");
}

#[test]
fn no_two_components_have_one_id() {
    katydid_components::link();
    let mut seen = HashSet::new();
    for component in registry::all() {
        for guid in std::iter::once(component.guid).chain(component.also.iter().copied()) {
            assert!(seen.insert(guid), "{} shares {guid}", component.name);
        }
    }
}

#[test]
fn every_component_has_help() {
    katydid_components::link();
    for component in registry::all() {
        assert!(!component.help.is_empty(), "{}", component.name);
        for port in component.inputs.iter().chain(component.outputs) {
            assert!(!port.help.is_empty(), "{}.{}", component.name, port.nick);
        }
    }
}
