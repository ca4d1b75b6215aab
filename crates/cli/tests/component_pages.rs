//! The pages of help in `docs/components`: a page a panel, written from the components themselves, with the picture of
//! each example that lies in `docs/components/examples/<panel>/<component>.kd`.
//!
//! `KATYDID_REFRESH_PAGES=1 cargo test -p katydid --test component_pages` writes pages and pictures anew.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use common::{katydid, said, text};
use katydid_component::{Access, Component, Port, registry};
use katydid_data::{Kind, cast, text as texts};
use uuid::Uuid;

const PAGES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/components");
const BOOK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book");

fn is_refresh() -> bool {
    std::env::var_os("KATYDID_REFRESH_PAGES").is_some()
}

/// A name as a heading's anchor, as GitHub makes it: small letters, digits, dashes for blanks; all else is left out.
fn anchor(name: &str) -> String {
    let kept = name.chars().filter(|c| c.is_alphanumeric() || "-_ ".contains(*c));
    kept.flat_map(char::to_lowercase).collect::<String>().trim().replace(' ', "-")
}

/// A name as part of a file's name: letters and digits, all else one dash.
fn slug(name: &str) -> String {
    let words: Vec<String> = name
        .split(|c: char| !c.is_alphanumeric())
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
        .collect();
    words.join("-")
}

/// A panel: its tab and its name, with its components.
type Panels = BTreeMap<(&'static str, &'static str), Vec<&'static Component>>;

fn panels() -> Panels {
    katydid_components::link();
    let mut panels = Panels::new();
    for component in registry::all() {
        panels.entry((component.tab, component.panel)).or_default().push(component);
    }
    for components in panels.values_mut() {
        components.sort_by_key(|c| (c.old, c.name, c.guid));
    }
    panels
}

/// The rows of the book by the components that they use.
fn rows_of_the_book() -> BTreeMap<Uuid, BTreeSet<String>> {
    let mut rows: BTreeMap<Uuid, BTreeSet<String>> = BTreeMap::new();
    for entry in fs::read_dir(BOOK).unwrap() {
        let folder = entry.unwrap().path();
        let definition = folder.join("definition.kd");
        if !definition.exists() {
            continue;
        }
        let row = folder.file_name().unwrap().to_str().unwrap().to_owned();
        let report: serde_json::Value =
            serde_json::from_slice(&katydid(&["run", text(&definition), "--json"]).stdout).unwrap();
        for object in report["objects"].as_array().unwrap() {
            let id: Uuid = object["component"].as_str().unwrap().parse().unwrap();
            if let Some(component) = registry::by_guid(id) {
                rows.entry(component.guid).or_default().insert(row.clone());
            }
        }
    }
    rows
}

/// Text in a cell of a table.
fn cell(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace('|', "\\|")
}

fn ports(page: &mut String, word: &str, ports: &[Port]) {
    if ports.is_empty() {
        return;
    }
    writeln!(page, "| {word} | | type | |\n| --- | --- | --- | --- |").unwrap();
    for port in ports {
        let mut kind = match port.access {
            Access::Item => port.kind.name().to_owned(),
            Access::List => format!("{}, a list", port.kind.name()),
            Access::Tree => format!("{}, a tree", port.kind.name()),
        };
        if port.many {
            kind.push_str(", any number of ports");
        }
        let mut help = cell(port.help);
        let default = port.default.map(|default| default()).and_then(|tree| tree.column().get(0));
        match default {
            Some(value) => {
                let style = texts::Style::default();
                write!(help, " Default: {}.", cell(&texts::value(&value, &style))).unwrap();
            }
            None if port.optional && word == "Input" => help.push_str(" May be left empty."),
            None => {}
        }
        writeln!(page, "| {} | `{}` | {kind} | {help} |", cell(port.name), cell(port.nick)).unwrap();
    }
    page.push('\n');
}

/// What a parameter takes beside its own type.
fn taken(page: &mut String, kind: Kind) {
    let ways: Vec<_> = cast::ways_to(kind).filter(|way| !way.from.contains(&kind)).collect();
    if ways.is_empty() {
        return;
    }
    writeln!(page, "| takes | and makes of it | how sure |\n| --- | --- | --- |").unwrap();
    for way in ways {
        writeln!(page, "| {} | {} | {} |", way.sources(), cell(way.gives), way.sure.word()).unwrap();
    }
    page.push('\n');
}

fn page(
    (tab, panel): (&str, &str),
    components: &[&Component],
    rows: &BTreeMap<Uuid, BTreeSet<String>>,
) -> String {
    let mut page = format!("# {tab} / {panel}\n\n[All panels](README.md)\n\n");
    let folder = slug(&format!("{tab} {panel}"));
    let mut seen = BTreeMap::new();
    for component in components {
        let count: &mut usize = seen.entry(anchor(component.name)).or_default();
        let anchor = match *count {
            0 => anchor(component.name),
            n => format!("{}-{n}", anchor(component.name)),
        };
        *count += 1;
        let first = component.help.split_inclusive(". ").next().unwrap_or_default();
        let age = if component.old { " (earlier version)" } else { "" };
        writeln!(page, "- [{}](#{anchor}){age}: {}", component.name, cell(first)).unwrap();
    }
    for component in components {
        write!(page, "\n## {}\n\n", component.name).unwrap();
        let kind = match (component.floating, component.old) {
            (true, _) => "parameter",
            (false, true) => "earlier version, for old files",
            (false, false) => "component",
        };
        write!(page, "`{}` · {kind}\n\n{}\n\n", component.nick, component.help.trim()).unwrap();
        let name = slug(component.name);
        let example = Path::new(PAGES).join(format!("examples/{folder}/{name}.kd"));
        if example.exists() && !component.old {
            let alternative = format!("{}: what the example makes", component.name);
            write!(page, "![{alternative}](pictures/{folder}/{name}.png)\n\n").unwrap();
            write!(page, "[The example](examples/{folder}/{name}.kd)\n\n").unwrap();
        }
        if !component.floating {
            ports(&mut page, "Input", component.inputs);
            ports(&mut page, "Output", component.outputs);
        } else if let Some(port) = component.outputs.first() {
            taken(&mut page, port.kind);
        }
        if let Some(rows) = rows.get(&component.guid) {
            let links: Vec<String> =
                rows.iter().map(|row| format!("[{row}](../../book/{row}/definition.kd)")).collect();
            write!(page, "In the book: {}\n\n", links.join(", ")).unwrap();
        }
        writeln!(page, "`{}`", component.guid).unwrap();
    }
    page
}

fn index(panels: &Panels) -> String {
    let mut page =
        "# Components\n\nWritten from the components themselves; `katydid components NAME` prints the same \
                    help.\n"
            .to_owned();
    let mut last = "";
    for ((tab, panel), components) in panels {
        if *tab != last {
            write!(page, "\n## {tab}\n\n").unwrap();
            last = tab;
        }
        let file = slug(&format!("{tab} {panel}"));
        let count = components.iter().filter(|c| !c.old).count();
        writeln!(page, "- [{panel}]({file}.md): {count}").unwrap();
    }
    page.push_str("\n## How sure\n\n");
    page.push_str(
        "Pages of parameters list what each takes and how sure we are that Grasshopper does the same: ",
    );
    page.push_str(
        "*shown* by a picture or its documentation; *used*: files could not have worked otherwise; ",
    );
    page.push_str(
        "*likely*: known to its users; *ours*: our own reading, which a remark on the object says.\n",
    );
    page.push_str("\n## Not here\n\n| component | why |\n| --- | --- |\n");
    let mut unsupported: Vec<_> = registry::all_unsupported().collect();
    unsupported.sort_by_key(|known| (known.name, known.guid));
    for known in unsupported {
        writeln!(page, "| {} | {} |", cell(known.name), cell(known.reason)).unwrap();
    }
    page
}

#[test]
fn the_pages_say_what_the_components_say() {
    let panels = panels();
    let rows = rows_of_the_book();
    let mut pages: BTreeMap<String, String> = panels
        .iter()
        .map(|(&(tab, panel), components)| {
            (format!("{}.md", slug(&format!("{tab} {panel}"))), page((tab, panel), components, &rows))
        })
        .collect();
    pages.insert("README.md".to_owned(), index(&panels));
    if is_refresh() {
        for (name, page) in &pages {
            fs::write(Path::new(PAGES).join(name), page).unwrap();
        }
    }
    let files = fs::read_dir(PAGES).unwrap().map(|entry| entry.unwrap().path());
    let kept: BTreeSet<String> = files
        .filter(|path| path.extension().is_some_and(|e| e == "md"))
        .map(|path| path.file_name().unwrap().to_str().unwrap().to_owned())
        .collect();
    assert_eq!(kept, pages.keys().cloned().collect(), "pages of panels that are not there, or none of one");
    for (name, page) in &pages {
        let found = fs::read_to_string(Path::new(PAGES).join(name)).unwrap();
        assert!(
            found == *page,
            "{name} is not fresh: KATYDID_REFRESH_PAGES=1 cargo test -p katydid --test component_pages"
        );
    }
}

/// The examples: panel, component, file.
fn examples() -> Vec<(String, String, PathBuf)> {
    let mut found = Vec::new();
    let Ok(folders) = fs::read_dir(Path::new(PAGES).join("examples")) else { return found };
    for folder in folders.map(|entry| entry.unwrap().path()) {
        let panel = folder.file_name().unwrap().to_str().unwrap().to_owned();
        let files = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
        // Beside them lies what they read.
        for file in files.filter(|path| path.extension().is_some_and(|e| e == "kd")) {
            found.push((panel.clone(), file.file_stem().unwrap().to_str().unwrap().to_owned(), file));
        }
    }
    found.sort();
    found
}

#[test]
fn every_example_runs_and_has_its_picture() {
    let panels = panels();
    let slugs = |components: &[&Component]| components.iter().map(|c| slug(c.name)).collect::<BTreeSet<_>>();
    let known: BTreeMap<String, BTreeSet<String>> = panels
        .iter()
        .map(|((tab, panel), components)| (slug(&format!("{tab} {panel}")), slugs(components)))
        .collect();
    for (panel, component, file) in examples() {
        assert!(
            known.get(&panel).is_some_and(|k| k.contains(&component)),
            "{}: no such component",
            file.display()
        );
        let folder = tempfile::tempdir().unwrap();
        let drawn = folder.path().join("picture.png");
        let mut call = vec!["view", text(&file), "-o", text(&drawn), "--size", "480x320"];
        let mut output = katydid(&call);
        if said(&output).contains("nothing to show") {
            call.push("--canvas");
            output = katydid(&call);
        }
        // Where nothing documents what a component does, it says so in a remark.
        let told = said(&output);
        let others: Vec<&str> = told.lines().filter(|line| !line.starts_with("remark: ")).collect();
        assert!(output.status.code() == Some(0) && others.is_empty(), "{}: {told}", file.display());
        let kept = Path::new(PAGES).join(format!("pictures/{panel}/{component}.png"));
        if is_refresh() {
            fs::create_dir_all(kept.parent().unwrap()).unwrap();
            fs::copy(&drawn, &kept).unwrap();
        }
        common::pictures::assert_alike(&component, &drawn, &kept);
    }
}
