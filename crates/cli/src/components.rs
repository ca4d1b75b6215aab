//! `katydid components`.

use katydid_component::{Access, Component, Port, registry};
use katydid_data::{Kind, cast};
use serde_json::json;

use crate::args::ComponentsArgs;
use crate::output::{BOLD, DIM, say};

pub(crate) fn components(args: &ComponentsArgs) -> Result<u8, String> {
    let all = registry::all();
    let chosen: Vec<&Component> = match &args.name {
        None => all,
        Some(name) => choose(&all, name),
    };
    if let (Some(name), true) = (&args.name, chosen.is_empty()) {
        let known = registry::all_unsupported().find(|known| known.name.eq_ignore_ascii_case(name));
        return Err(match known {
            Some(known) => format!("{} is not supported: {}", known.name, known.reason),
            None => format!("no component is called '{name}'"),
        });
    }
    if args.json {
        let list: Vec<serde_json::Value> = chosen.iter().map(|c| entry(c)).collect();
        say(&serde_json::to_string(&list).map_err(|error| error.to_string())?);
    } else if args.name.is_some() && chosen.len() <= 3 {
        for component in chosen {
            help(component);
        }
    } else {
        list(&chosen);
    }
    Ok(0)
}

/// Those of that very name or id, else those with it in their name.
fn choose<'a>(all: &[&'a Component], name: &str) -> Vec<&'a Component> {
    let lower = name.to_lowercase();
    let exact: Vec<&Component> = all
        .iter()
        .copied()
        .filter(|c| c.name.to_lowercase() == lower || ids(c).any(|id| id.to_string().starts_with(&lower)))
        .collect();
    if exact.is_empty() {
        all.iter().copied().filter(|c| c.name.to_lowercase().contains(&lower)).collect()
    } else {
        exact
    }
}

fn ids(component: &Component) -> impl Iterator<Item = uuid::Uuid> {
    std::iter::once(component.guid).chain(component.also.iter().copied())
}

fn access(access: Access) -> &'static str {
    match access {
        Access::Item => "item",
        Access::List => "list",
        Access::Tree => "tree",
    }
}

fn entry(component: &Component) -> serde_json::Value {
    let port = |p: &Port| {
        json!({
            "name": p.name,
            "nickname": p.nick,
            "help": p.help,
            "type": p.kind.name(),
            "access": access(p.access),
            "optional": p.optional,
            "many": p.many,
        })
    };
    json!({
        "guid": component.guid,
        "guids": ids(component).collect::<Vec<_>>(),
        "name": component.name,
        "nickname": component.nick,
        "tab": component.tab,
        "panel": component.panel,
        "kind": if component.floating { "parameter" } else { "component" },
        "help": component.help,
        "inputs": component.inputs.iter().map(port).collect::<Vec<_>>(),
        "outputs": component.outputs.iter().map(port).collect::<Vec<_>>(),
    })
}

fn help(component: &Component) {
    let Component { name, nick, tab, panel, help, guid, .. } = component;
    say(&format!("{BOLD}{name}{BOLD:#} ({nick})  {DIM}{tab} / {panel}, {guid}{DIM:#}"));
    say(help);
    for (title, ports) in [("Inputs", component.inputs), ("Outputs", component.outputs)] {
        if ports.is_empty() || component.floating {
            continue;
        }
        say(&format!("\n{BOLD}{title}{BOLD:#}"));
        for p in ports {
            let optional = if p.optional { ", optional" } else { "" };
            let many = if p.many { ", any number" } else { "" };
            let kind = p.kind;
            let access = access(p.access);
            say(&format!(
                "  {:<4} {} {DIM}[{kind}, {access}{optional}{many}]{DIM:#}  {}",
                p.nick, p.name, p.help
            ));
        }
    }
    if let Some(port) = component.outputs.first().filter(|_| component.floating) {
        taken(port.kind);
    }
    say("");
}

/// What a parameter takes beside its own type, what it makes of it, and how sure we are that Grasshopper does the same.
fn taken(kind: Kind) {
    let mut ways = cast::ways_to(kind).filter(|way| !way.from.contains(&kind)).peekable();
    if ways.peek().is_some() {
        say(&format!("\n{BOLD}Takes{BOLD:#}"));
    }
    for way in ways {
        say(&format!("  {}: {} {DIM}({}){DIM:#}", way.sources(), way.gives, way.sure.word()));
    }
}

fn list(components: &[&Component]) {
    let mut place = ("", "");
    for component in components {
        if place != (component.tab, component.panel) {
            place = (component.tab, component.panel);
            say(&format!("{BOLD}{} / {}{BOLD:#}", place.0, place.1));
        }
        let summary = component.help.split_inclusive(". ").next().unwrap_or_default();
        say(&format!("  {:<28} {DIM}{}{DIM:#}", component.name, summary.trim()));
    }
    say(&format!("{} components", components.len()));
}
