//! What pictures of the real Grasshopper show, case by case: see the shared folder's `data/golden`.
//!
//! Each case is a small definition in JSON. It is built as a document, solved, and compared text by text with
//! what the panels in the picture say. A case whose component is not in yet is listed as skipped.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use std::collections::HashMap;
use std::path::PathBuf;

use katydid_component::{Component, registry};
use katydid_data::{Kind, text};
use katydid_definition::archive::Chunk;
use katydid_definition::document::{
    Branch, Document, Mapping, NewPort, Object, Persistent, Side, Stored, parse_path,
};
use katydid_geometry::{Circle, Interval, Line, Plane, Point3};
use katydid_solver::{Engine, Options};
use serde_json::Value as Json;
use uuid::Uuid;

fn shared(path: &str) -> Option<PathBuf> {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared")).join(path);
    if path.exists() {
        return Some(path);
    }
    assert!(std::env::var_os("KATYDID_REQUIRE_SHARED").is_none(), "{} is absent", path.display());
    println!("skipped: {} is absent", path.display());
    None
}

/// Why a case cannot be run.
type Skip = String;

#[test]
fn pictures_of_grasshopper_and_katydid_agree() {
    assert!(katydid_components::link() > 0);
    let Some(path) = shared("data/golden/golden.json") else { return };
    let cases: Vec<Json> = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    let (mut passed, mut skipped, mut failed) = (0, Vec::new(), Vec::new());
    for case in &cases {
        let id = case["id"].as_str().unwrap();
        match run(case) {
            Ok(()) => passed += 1,
            Err(Outcome::Skip(reason)) => skipped.push(format!("{id}: {reason}")),
            Err(Outcome::Fail(reason)) => failed.push(format!("{id}: {reason}")),
        }
    }
    println!("{passed} of {} cases agree; {} skipped:", cases.len(), skipped.len());
    skipped.iter().for_each(|line| println!("  {line}"));
    assert!(failed.is_empty(), "{} cases differ:\n{}", failed.len(), failed.join("\n"));
    assert!(passed >= 60, "only {passed} cases could be run");
}

enum Outcome {
    Skip(Skip),
    Fail(String),
}

fn skip<T>(reason: impl Into<String>) -> Result<T, Outcome> {
    Err(Outcome::Skip(reason.into()))
}

/// The component of that name; a floating parameter where the case gives it values or a nameless input.
fn component(object: &Json) -> Result<&'static Component, Outcome> {
    let name = object["component"].as_str().unwrap_or_default();
    let floating = object.get("persistent").is_some() || object["inputs"].get("in").is_some();
    let mut found = registry::all().into_iter().filter(|c| c.name == name);
    let first = found.clone().find(|c| c.floating == floating).or_else(|| found.next());
    first.ok_or_else(|| Outcome::Skip(format!("no component {name}")))
}

struct Built {
    document: Document,
    /// The output ids by `object.port` and by `object` for parameters.
    outputs: HashMap<String, (usize, usize)>,
}

fn run(case: &Json) -> Result<(), Outcome> {
    let expected = case["expected"].as_object().unwrap();
    let objects = case["objects"].as_array().unwrap();
    if objects.is_empty() {
        return skip("the case names no objects");
    }
    let built = build(objects)?;
    let mut engine = Engine::new(built.document, Options::default());
    engine.solve();
    let mut compared = 0;
    for (key, want) in expected {
        if let Some(object) = key.strip_suffix(".warning") {
            let &(index, _) =
                built.outputs.get(object).ok_or_else(|| Outcome::Skip(format!("no {object}")))?;
            let said: Vec<&str> =
                engine.report(index).unwrap().messages.iter().map(|m| m.text.as_str()).collect();
            for text in want.as_array().unwrap() {
                if !said.contains(&text.as_str().unwrap()) {
                    return Err(Outcome::Fail(format!("{key}: {said:?} instead of {want}")));
                }
            }
            compared += 1;
            continue;
        }
        let Some(&(index, output)) = built.outputs.get(key) else { continue };
        let Some(branches) = want.as_object() else { continue };
        let report = engine.report(index).unwrap();
        let old = case["number_format"].as_str().unwrap_or_default().starts_with("gh0.9");
        let truncated = case.get("truncated").is_some_and(|t| !t.is_null());
        // Where the case gives only the number of items that went in, only numbers can be compared.
        let counted = objects.iter().any(|object| object.to_string().contains("{\"count\":"));
        let counts: serde_json::Map<String, Json> = branches
            .iter()
            .map(|(path, want)| {
                let n = want.as_array().map_or_else(|| want["count"].clone(), |texts| texts.len().into());
                (path.clone(), serde_json::json!({ "count": n }))
            })
            .collect();
        let branches = if counted { &counts } else { branches };
        compare(&report.outputs[output], branches, old, truncated)
            .map_err(|why| Outcome::Fail(format!("{key}: {why}; messages {:?}", report.messages)))?;
        compared += 1;
    }
    if compared == 0 { skip("nothing in it that a solve shows") } else { Ok(()) }
}

fn compare(
    tree: &katydid_data::Tree,
    want: &serde_json::Map<String, Json>,
    old: bool,
    truncated: bool,
) -> Result<(), String> {
    let style = text::Style::default();
    let normal = |text: &str| if old { modern(text) } else { text.to_owned() };
    let mut paths: Vec<String> = Vec::new();
    for branch in tree.branches() {
        paths.push(branch.path().to_string());
    }
    for (path, want) in want {
        let items: Vec<String> = match path.as_str() {
            "*" => tree.column().iter().map(|v| normal(&text::item(v.as_ref(), &style))).collect(),
            path => {
                let branch = tree.branches().find(|b| b.path().to_string() == path);
                let branch = branch.ok_or_else(|| format!("no branch {path} among {paths:?}"))?;
                branch.iter().map(|v| normal(&text::item(v.as_ref(), &style))).collect()
            }
        };
        if let Some(count) = want.get("count") {
            if items.len() as u64 != count.as_u64().unwrap() {
                return Err(format!("{} items instead of {count} at {path}", items.len()));
            }
            continue;
        }
        let want: Vec<String> =
            want.as_array().unwrap().iter().map(|t| normal(t.as_str().unwrap())).collect();
        let same = if truncated { items.starts_with(&want) } else { items == want };
        if !same {
            return Err(format!("at {path} {items:?} instead of {want:?}"));
        }
    }
    if !want.contains_key("*") && !truncated && paths.len() != want.len() {
        return Err(format!("branches {paths:?} instead of {:?}", want.keys().collect::<Vec<_>>()));
    }
    Ok(())
}

/// A text of Grasshopper 0.9 as 1.0 writes it: whole numbers without `.0`.
fn modern(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(".0") {
        let (before, after) = rest.split_at(at);
        out.push_str(before);
        rest = &after[2..];
        if rest.starts_with(|c: char| c.is_ascii_digit()) {
            out.push_str(".0");
        }
    }
    out.push_str(rest);
    out
}

fn build(objects: &[Json]) -> Result<Built, Outcome> {
    let mut document = Document::new();
    let mut outputs = HashMap::new();
    let mut port_ids: HashMap<String, Uuid> = HashMap::new();
    let mut next = 1u128;
    let mut id = || {
        next += 1;
        Uuid::from_u128(next)
    };
    for json in objects {
        let declared = component(json)?;
        let name = json["id"].as_str().unwrap();
        let object_id = id();
        let mut object = if declared.floating {
            Object::new_parameter(declared.guid, declared.name, "", object_id)
        } else {
            Object::new_component(declared.guid, declared.name, declared.nick, object_id)
        };
        let given = json["inputs"].as_object().cloned().unwrap_or_default();
        if declared.floating {
            outputs.insert(name.to_owned(), (document.objects.len(), 0));
            port_ids.insert(name.to_owned(), object_id);
            if let Some(tree) = json.get("persistent") {
                let kind = declared.inputs.first().map_or(Kind::Generic, |p| p.kind);
                let values = persistent(tree, kind)?;
                object.set_persistent(0, Some(&values)).unwrap();
            }
            if let Some(input) = given.get("in") {
                connect(&mut object, 0, input, &port_ids, declared)?;
            }
        } else {
            let fixed: Vec<&str> = declared.inputs.iter().filter(|p| !p.many).map(|p| p.nick).collect();
            let more = given.keys().map(String::as_str).filter(|k| !fixed.contains(k));
            for nick in fixed.iter().copied().chain(more) {
                let port = NewPort {
                    id: id(),
                    name: nick.to_owned(),
                    nickname: nick.to_owned(),
                    ..NewPort::default()
                };
                let k = object.add_port(Side::Input, &port);
                match given.get(nick) {
                    Some(input) => connect(&mut object, k, input, &port_ids, declared)?,
                    None => continue,
                }
            }
            // The variable inputs may stand in any order in the case: they have the order of their names.
            let ports: Vec<&str> = if declared.outputs.last().is_some_and(|p| p.many) {
                let fixed = declared.outputs.iter().filter(|p| !p.many).map(|p| p.nick);
                fixed.chain(["A", "B", "C", "i"]).collect()
            } else {
                declared.outputs.iter().map(|p| p.nick).collect()
            };
            for nick in ports {
                let port = NewPort {
                    id: id(),
                    name: nick.to_owned(),
                    nickname: nick.to_owned(),
                    ..NewPort::default()
                };
                let k = object.add_port(Side::Output, &port);
                let key = format!("{name}.{nick}");
                port_ids.insert(key.clone(), port.id);
                outputs.entry(key).or_insert((document.objects.len(), k));
                outputs.insert(name.to_owned(), (document.objects.len(), 0));
                if json["output_modifiers"][nick].as_array().is_some_and(|m| m.contains(&"flatten".into())) {
                    object.set_mapping(Side::Output, k, Mapping::Flatten).unwrap();
                }
            }
            if declared.outputs.last().is_some_and(|p| p.many) && declared.name == "List Item" {
                outputs.insert(format!("{name}.i"), (document.objects.len(), 0));
                port_ids.insert(format!("{name}.i"), object.outputs[0].id);
            }
        }
        settings(&mut object, json)?;
        document.objects.push(object);
    }
    Ok(Built { document, outputs })
}

fn connect(
    object: &mut Object,
    k: usize,
    input: &Json,
    ids: &HashMap<String, Uuid>,
    declared: &Component,
) -> Result<(), Outcome> {
    if let Some(source) = input["source"].as_str() {
        let Some(id) = ids.get(source) else { return skip(format!("no source {source}")) };
        object.set_sources(k, &[*id]).unwrap();
    }
    if let Some(tree) = input.get("tree") {
        let values = persistent(tree, declared.input(k).map_or(Kind::Generic, |p| p.kind))?;
        object.set_persistent(k, Some(&values)).unwrap();
    }
    let modifiers = input["modifiers"].as_array().cloned().unwrap_or_default();
    if modifiers.contains(&"degrees".into()) {
        let container = object.container_mut();
        if let Some(port) = container.child_at_mut("param_input", i32::try_from(k).unwrap()) {
            port.set("UseDegrees", true);
        }
        object.refresh();
    }
    Ok(())
}

/// The object's own settings: panel text, slider value, toggle, formula, modes.
fn settings(object: &mut Object, json: &Json) -> Result<(), Outcome> {
    let c = object.container_mut();
    if let Some(lines) = json["text"].as_array() {
        let lines: Vec<&str> = lines.iter().filter_map(Json::as_str).collect();
        c.set("UserText", lines.join("\r\n"));
        let mut properties = Chunk::new("PanelProperties");
        properties.set("Multiline", json["multiline_data"].as_bool().unwrap_or(false));
        c.set_child(properties);
    }
    match &json["value"] {
        Json::Bool(b) => c.set("ToggleValue", *b),
        Json::Number(x) => {
            let x = x.as_f64().unwrap();
            let mut slider = Chunk::new("Slider");
            slider.set("Value", x);
            slider.set("Min", x.min(0.0));
            slider.set("Max", x.max(100.0));
            slider.set("Digits", 3);
            slider.set("Interval", 0);
            c.set_child(slider);
        }
        _ => {}
    }
    if let Some(text) = json["expression"].as_str() {
        c.set("Expression", text);
    }
    if let Some(flatten) = json["flatten_inputs"].as_bool() {
        c.set("FlattenInputs", flatten);
    }
    if let (Some(source), Some(target)) = (json["source"].as_str(), json["target"].as_str()) {
        let mut lexers = Chunk::new("lexers");
        lexers.set("lexer_count", 1);
        lexers.set_at("source", 0, source);
        lexers.set_at("target", 0, target);
        c.set_child(lexers);
    }
    if let Some(mode) = json["mode"].as_str() {
        let (name, value) = match mode {
            "Trim Start" => ("TrimMode", 1),
            "Trim End" => ("TrimMode", 2),
            "Interpolate" => ("TrimMode", 3),
            "Holistic" => ("CrossMode", 1),
            "Diagonal" => ("CrossMode", 2),
            "Coincident" => ("CrossMode", 3),
            "Lower" => ("CrossMode", 4),
            "LowerStrict" => ("CrossMode", 5),
            "Upper" => ("CrossMode", 6),
            "UpperStrict" => ("CrossMode", 7),
            other => return skip(format!("mode {other}")),
        };
        c.set(name, value);
    }
    object.refresh();
    Ok(())
}

fn persistent(tree: &Json, kind: Kind) -> Result<Persistent, Outcome> {
    let Some(map) = tree.as_object() else { return skip("a tree in another form") };
    let mut branches = Vec::new();
    for (path, items) in map {
        let Some(path) = parse_path(path) else { return skip(format!("a tree given by its {path}")) };
        let items: Vec<Stored> = if let Some(items) = items.as_array() {
            items.iter().map(|item| stored(item, kind)).collect::<Result<_, _>>()?
        } else if let (Some(count), true) = (items["count"].as_u64(), items.get("from_gh").is_none()) {
            (0..count).map(|i| filler(i, kind)).collect()
        } else {
            return skip("its data is in a file that is not at hand");
        };
        branches.push(Branch { path, items });
    }
    Ok(Persistent { branches })
}

/// Something of that type, where only the count matters.
fn filler(i: u64, kind: Kind) -> Stored {
    let x = i as f64;
    match kind {
        Kind::Circle => Stored::Circle(Box::new(Circle { plane: Plane::XY, radius: x + 1.0 })),
        Kind::Curve | Kind::Line => {
            Stored::Line(Box::new(Line::new(Point3::new(x, 0.0, 0.0), Point3::new(x, 9.0, 0.0))))
        }
        Kind::Point => Stored::Point(Point3::new(x, 0.0, 0.0)),
        _ => Stored::Number(x),
    }
}

fn stored(item: &Json, kind: Kind) -> Result<Stored, Outcome> {
    let numbers = |list: &[Json]| list.iter().map(Json::as_f64).collect::<Option<Vec<f64>>>();
    Ok(match item {
        Json::Bool(b) => Stored::Boolean(*b),
        Json::Number(x) => Stored::Number(x.as_f64().unwrap()),
        Json::String(text) if text == "world XY" => Stored::Plane(Box::new(Plane::XY)),
        Json::String(text) => Stored::Text(text.clone()),
        Json::Array(list) => match numbers(list).as_deref() {
            Some([a, b]) => Stored::Domain(Interval::new(*a, *b)),
            Some([x, y, z]) if kind == Kind::Vector => Stored::Vector([*x, *y, *z].into()),
            Some([x, y, z]) => Stored::Point(Point3::new(*x, *y, *z)),
            Some([a, b, c, d, e, f]) => {
                Stored::Line(Box::new(Line::new(Point3::new(*a, *b, *c), Point3::new(*d, *e, *f))))
            }
            _ => return skip("a value in another form"),
        },
        Json::Object(map) if map.contains_key("line") => {
            let ends: Option<Vec<Vec<f64>>> =
                map["line"].as_array().unwrap().iter().map(|p| numbers(p.as_array()?)).collect();
            match ends.as_deref() {
                Some([a, b]) => Stored::Line(Box::new(Line::new(
                    Point3::new(a[0], a[1], a[2]),
                    Point3::new(b[0], b[1], b[2]),
                ))),
                _ => return skip("a line in another form"),
            }
        }
        _ => return skip("its data is in a file that is not at hand"),
    })
}
