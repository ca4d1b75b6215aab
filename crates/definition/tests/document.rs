//! The document over real files, and its edits.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod shared;

use std::collections::{BTreeMap, HashMap};

use katydid_definition::Error;
use katydid_definition::archive::{self, Chunk, Decimal, ItemValue, Limits};
use katydid_definition::document::special::Graph;
use katydid_definition::document::{
    Access, ClusterContent, Document, Object, OnData, Persistent, PortPlace, Special, Stored, UserObject,
    ids, parse_path,
};
use uuid::Uuid;

fn open(bytes: &[u8]) -> Result<Document, Error> {
    Document::read(bytes, &Limits::default())
}

/// Every document: the files, and the clusters in them, each with where it is.
fn everything() -> Vec<(String, Document)> {
    let mut all = Vec::new();
    for path in shared::definitions() {
        let document = open(&std::fs::read(&path).unwrap());
        let document = document.unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let name = path.strip_prefix(shared::folder()).unwrap().display().to_string();
        inside(&name, &document, &mut all);
        all.push((name, document));
    }
    all
}

fn inside(name: &str, document: &Document, all: &mut Vec<(String, Document)>) {
    for object in &document.objects {
        if let Some(Ok(ClusterContent::Open { document, .. })) = object.cluster(&Limits::default()) {
            let name = format!("{name}/{}", object.title());
            inside(&name, &document, all);
            all.push((name, *document));
        }
    }
}

/// The `objects` column of the index: what stands in the file itself, annotations included, clusters closed.
fn counts() -> HashMap<String, usize> {
    let text = std::fs::read_to_string(shared::folder().join("index.csv")).unwrap_or_default();
    let mut lines = text.lines().map(cells);
    let Some(head) = lines.next() else { return HashMap::new() };
    let at = head.iter().position(|cell| cell == "objects").unwrap();
    lines.map(|cells| (cells[0].clone(), cells[at].parse().unwrap())).collect()
}

/// The cells of a line of comma-separated text with quotes.
fn cells(line: &str) -> Vec<String> {
    let (mut cells, mut quoted) = (vec![String::new()], false);
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            _ => cells.last_mut().unwrap().push(c),
        }
    }
    cells
}

#[test]
fn every_document_builds_and_is_saved_unchanged() {
    let counts = counts();
    let (mut files, mut wires, mut dangling, mut clusters) = (0, 0, 0, 0);
    for path in shared::definitions() {
        let bytes = std::fs::read(&path).unwrap();
        let archive = archive::read(&bytes, &Limits::default()).unwrap();
        let root = archive.root.clone();
        let document = Document::from_archive(archive).unwrap();
        assert!(document.to_archive().root == root, "{}", path.display());
        let name = path.strip_prefix(shared::folder()).unwrap().display().to_string();
        assert_eq!(counts.get(&name), Some(&document.objects.len()), "{name}");
        assert!(document.header.plugin_version.is_some(), "{name}");
        files += 1;
    }
    for (name, document) in everything() {
        clusters += usize::from(document.nesting() > 0);
        let lookup = document.lookup();
        for wire in document.wires() {
            wires += 1;
            match lookup.output(wire.from) {
                Some(port) => assert_eq!(document.objects[port.object].outputs[port.port].id, wire.from),
                None => dangling += 1,
            }
        }
        for object in &document.objects {
            assert!(!object.component.is_nil() && !object.id.is_nil(), "{name}");
            for port in object.inputs.iter().chain(&object.outputs) {
                assert!(!port.id.is_nil(), "{name}: {}", object.name);
                assert!(port.place.find(object.container()).is_some());
                assert_eq!(port.place == PortPlace::Own, object.is_floating());
            }
            if object.is_floating() {
                assert_eq!((object.inputs.len(), object.outputs.len()), (1, 1));
                assert_eq!(object.outputs[0].id, object.id);
            }
            if object.is_annotation() {
                assert!(object.inputs.is_empty() && object.outputs.is_empty());
            }
        }
        let wires_from_nowhere = document.wires().filter(|wire| lookup.output(wire.from).is_none()).count();
        let told = document.problems().iter().filter(|p| p.contains("a wire into")).count();
        assert_eq!(told, wires_from_nowhere, "{name}");
    }
    println!("{files} files, {clusters} clusters, {wires} wires, {dangling} of them from nowhere");
    if files > 0 {
        assert_eq!((files, clusters), (273, 70));
        assert!(dangling * 100 < wires, "{dangling} of {wires}");
    }
}

#[test]
fn every_stored_value_is_read_and_written() {
    let limits = Limits::default();
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    let mut unknown: BTreeMap<String, usize> = BTreeMap::new();
    let mut classes: BTreeMap<String, usize> = BTreeMap::new();
    let (mut missing, mut exact, mut other) = (0, 0, BTreeMap::<&str, usize>::new());
    let documents = everything();
    for (name, document) in &documents {
        for object in &document.objects {
            for port in &object.inputs {
                let Some(values) = object.persistent(port) else { continue };
                for item in values.branches.iter().flat_map(|branch| &branch.items) {
                    *kinds.entry(item.type_name()).or_default() += 1;
                    match item {
                        Stored::Unknown(chunk) => {
                            let shape: Vec<_> = chunk.items.iter().map(|item| item.name.as_str()).collect();
                            let inner = chunk.chunks.iter().map(|c| c.name.as_str());
                            let shape: Vec<_> = shape.into_iter().chain(inner).collect();
                            *unknown.entry(shape.join(" ")).or_default() += 1;
                        }
                        Stored::Geometry(geometry) => {
                            missing += usize::from(geometry.is_missing());
                            if let Some(data) = geometry.decode(&limits) {
                                let data = data.unwrap_or_else(|e| panic!("{name}: {e}"));
                                assert!(
                                    data.class_name.starts_with("Rhino.Geometry."),
                                    "{}",
                                    data.class_name
                                );
                                assert!([4, 50, 60, 70, 80].contains(&data.archive3dm));
                                assert!(data.data.len() > 20);
                                *classes.entry(data.class_name).or_default() += 1;
                            }
                        }
                        _ => {}
                    }
                }
                // Writing what was read gives the same chunk, apart from the order and widths of old versions.
                let chunk = port.place.find(object.container()).unwrap();
                let Some(before) = chunk.child("PersistentData") else { continue };
                let type_names =
                    before.chunks.iter().flat_map(|b| &b.chunks).any(|i| i.str("TypeName").is_some());
                if sorted(&values.to_chunk(type_names)) == sorted(before) {
                    exact += 1;
                } else {
                    let kind =
                        values.branches.iter().flat_map(|b| &b.items).next().map_or("", Stored::type_name);
                    *other.entry(kind).or_default() += 1;
                }
            }
        }
    }
    println!("{kinds:?}\nunknown: {unknown:?}\nclasses: {classes:?}\n{missing} only in a model");
    println!("{exact} written as they came, others: {other:?}");
    if !documents.is_empty() {
        assert_eq!(classes.values().sum::<usize>(), 145);
        assert!(unknown.values().sum::<usize>() < 140);
    }
}

/// The tree with items and chunks in the order of their names.
fn sorted(chunk: &Chunk) -> Chunk {
    let mut chunk = chunk.clone();
    chunk.items.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    chunk.chunks = chunk.chunks.iter().map(sorted).collect();
    chunk.chunks.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    chunk
}

#[test]
fn every_on_data_blob_decodes() {
    fn blobs(chunk: &Chunk, count: &mut usize) {
        for (name, value) in chunk.items.iter().map(|item| (&item.name, &item.value)) {
            if let (true, ItemValue::ByteArray(bytes)) = (name.as_str() == "ON_Data", value) {
                OnData::read(bytes, &Limits::default()).unwrap();
                *count += 1;
            }
        }
        chunk.chunks.iter().for_each(|child| blobs(child, count));
    }
    let mut count = 0;
    let documents = everything();
    documents.iter().for_each(|(_, document)| blobs(&document.to_archive().root, &mut count));
    println!("{count} blobs");
    assert!(documents.is_empty() || count == 145);
}

#[test]
fn special_objects_are_all_read() {
    let mut found: BTreeMap<String, usize> = BTreeMap::new();
    let mut scripts: BTreeMap<String, usize> = BTreeMap::new();
    let mut unfit = 0;
    let documents = everything();
    let named = [
        ids::NUMBER_SLIDER,
        ids::PANEL,
        ids::BOOLEAN_TOGGLE,
        ids::BOOLEAN_TOGGLE_2,
        ids::BUTTON,
        ids::COLOUR_SWATCH,
        ids::VALUE_LIST,
        ids::MD_SLIDER,
        ids::CONTROL_KNOB,
        ids::CALENDAR,
        ids::CLOCK,
        ids::GENE_POOL,
        ids::GRAPH_MAPPER,
        ids::GRADIENT,
        ids::PATH_MAPPER,
        ids::CHERRY_PICKER,
        ids::IMAGE_SAMPLER,
        ids::EXPRESSION,
        ids::TRIGGER,
        ids::GALAPAGOS,
        ids::GROUP,
        ids::SCRIBBLE,
        ids::SKETCH,
    ];
    for (name, document) in &documents {
        for object in &document.objects {
            let special = object.special();
            assert!(special.is_some() || !named.contains(&object.component), "{name}: {}", object.name);
            match &special {
                Some(Special::GraphMapper(mapper)) => {
                    assert!(!matches!(mapper.graph, Some(Graph::Other(..)) | None), "{name}");
                }
                Some(Special::Slider(slider)) => {
                    assert!(slider.min <= slider.value && slider.value <= slider.max, "{name}: {slider:?}");
                    let fitted = slider.fit(slider.value);
                    // At its limits a slider may stand at a number that its rule does not know.
                    unfit += usize::from((fitted - slider.value).abs() > 1e-9 * slider.value.abs().max(1.0));
                }
                _ => {}
            }
            if let Some(special) = special {
                let kind = format!("{special:?}");
                let kind = kind.split(['(', ' ']).next().unwrap().to_owned();
                *found.entry(kind).or_default() += 1;
            }
            if let Some(script) = object.script() {
                assert!(script.from_wire || !script.text.is_empty() || script.language.to_string() == "C#");
                *scripts.entry(script.language.to_string()).or_default() += 1;
            }
        }
    }
    println!("{found:?}\n{scripts:?}\n{unfit} sliders off their rule");
    assert!(unfit < 10);
    if !documents.is_empty() {
        assert_eq!(found.get("Slider"), Some(&966));
        assert_eq!(found.get("Panel"), Some(&2725));
    }
}

#[test]
fn clusters_open_and_hook_up() {
    let (mut open, mut locked, mut hooks) = (0, 0, 0);
    for (name, document) in everything() {
        for object in &document.objects {
            match object.cluster(&Limits::default()) {
                Some(Ok(ClusterContent::Open { document, hooks: pairs })) => {
                    open += 1;
                    let inside = document.lookup();
                    for hook in pairs {
                        hooks += 1;
                        let mut ports = object.inputs.iter().chain(&object.outputs);
                        assert!(ports.any(|port| port.id == hook.port), "{name}");
                        let at = inside.object(hook.object).unwrap();
                        let component = document.objects[at].component;
                        assert!([ids::CLUSTER_INPUT, ids::CLUSTER_OUTPUT].contains(&component), "{name}");
                    }
                }
                Some(Ok(ClusterContent::Locked)) => locked += 1,
                Some(Ok(ClusterContent::File(_)) | Err(_)) => panic!("{name}"),
                None => assert_ne!(object.component, ids::CLUSTER),
            }
        }
    }
    println!("{open} open, {locked} locked, {hooks} hooks");
    assert!(open == 0 || (open, locked) == (70, 2));
}

#[test]
fn the_book_is_read() {
    let path = shared::folder().join("the-book/TheEssentialMathematics_3rdEdition.gh");
    let Ok(bytes) = std::fs::read(path) else { return };
    let document = open(&bytes).unwrap();
    assert_eq!(document.objects.len(), 1490);
    println!("{:?}\n{:?}\n{:?}", document.header, document.libraries, document.problems());
    let mut kinds: BTreeMap<String, usize> = BTreeMap::new();
    for object in &document.objects {
        *kinds.entry(format!("{:?}", object.kind)).or_default() += 1;
    }
    println!("{kinds:?}");
    assert!(document.objects.iter().any(|o| o.inputs.iter().any(|p| p.access == Access::List)));
}

fn container(component: Uuid, items: &[(&str, ItemValue)]) -> Object {
    let mut object = Object::new(component, "thing");
    object.set_id(Uuid::from_u128(7));
    for (name, value) in items {
        object.container_mut().set(name, value.clone());
    }
    object.refresh();
    object
}

#[test]
fn objects_without_examples_are_read() {
    let mut scroller = Chunk::new("Scroller");
    scroller.set("Value", "12.5".parse::<Decimal>().unwrap());
    let mut object = container(ids::DIGIT_SCROLLER, &[]);
    object.container_mut().set_child(scroller);
    assert!(matches!(object.special(), Some(Special::DigitScroller(s)) if s.value == 12.5));
    let object = container(ids::DATA_RECORDER, &[("RecordData", true.into()), ("DataLimit", (-10).into())]);
    assert!(matches!(object.special(), Some(Special::DataRecorder(r)) if r.recording && r.limit.is_none()));
    let mut object = container(ids::OLD_C_SHARP, &[]);
    let mut code = Chunk::new("UserCode");
    code.set_at("Line", 1, "b");
    code.set_at("Line", 0, "a");
    object.container_mut().set_child(code);
    assert_eq!(object.script().unwrap().text, "a\nb");
    let mut object = container(ids::CLUSTER, &[]);
    assert!(matches!(object.cluster(&Limits::default()), Some(Err(_))));
    let mut file = Chunk::new("FileInfo");
    file.set("Path", "a.ghcluster");
    object.container_mut().set_child(file);
    let content = object.cluster(&Limits::default()).unwrap();
    assert_eq!(content, Ok(ClusterContent::File("a.ghcluster".to_owned())));
}

#[test]
fn left_out_items_are_null() {
    let mut branch = Chunk::indexed("Branch", 0);
    branch.set("Count", 4);
    let mut item = Chunk::indexed("Item", 1);
    item.set("number", 5);
    branch.set_child(item);
    let mut data = Chunk::new("PersistentData");
    data.set_child(branch);
    let mut parameter = Chunk::new("Container");
    parameter.set_child(data);
    let items = |parameter: &Chunk| Persistent::read(parameter).unwrap().branches.remove(0).items;
    assert_eq!(items(&parameter), [Stored::Null, Stored::Integer(5), Stored::Null, Stored::Null]);
    let data = parameter.child_mut("PersistentData").unwrap();
    data.child_at_mut("Branch", 0).unwrap().set("Count", i32::MAX);
    assert_eq!(items(&parameter).len(), 10_001);
}

#[test]
fn paths_are_read() {
    assert_eq!(parse_path(" { 0 ; 1 } "), Some(vec![0, 1]));
    assert_eq!(parse_path("{}"), Some(Vec::new()));
    for text in ["", "{", "{0", "0;1", "{0;}", "{a}", "{99999999999}"] {
        assert_eq!(parse_path(text), None, "{text}");
    }
}

#[test]
fn user_objects_are_read() {
    let mut inside = Chunk::new("UserObject");
    inside.set("NickName", "Grid");
    inside.set("SourceCount", 0);
    let mut root = Chunk::new("Root");
    root.set("BaseID", ids::PANEL);
    root.set("Name", "My panel");
    root.set("Category", "Params");
    root.set("Object", ItemValue::ByteArray(archive::write_gh(&inside).unwrap()));
    let bytes = archive::write_gh(&root).unwrap();
    let user = UserObject::read(&bytes, &Limits::default()).unwrap();
    assert_eq!((user.name.as_str(), user.category.as_str()), ("My panel", "Params"));
    let object = user.to_object();
    assert_eq!((object.component, object.nickname.as_str()), (ids::PANEL, "Grid"));
    assert!(open(&bytes).unwrap_err().to_string().contains("user object"));
    assert!(UserObject::read(&Document::new().to_gh().unwrap(), &Limits::default()).is_err());
}

#[test]
fn clusters_in_clusters_end_somewhere() {
    let mut bytes = Document::new().to_gh().unwrap();
    for _ in 0..20 {
        let mut document = Document::new();
        document.objects.push(container(ids::CLUSTER, &[("ClusterDocument", ItemValue::ByteArray(bytes))]));
        bytes = document.to_gh().unwrap();
    }
    let mut document = open(&bytes).unwrap();
    for depth in 0.. {
        match document.objects[0].cluster(&Limits::default()).unwrap() {
            Ok(ClusterContent::Open { document: inside, .. }) => document = *inside,
            Ok(_) => panic!("not a document"),
            Err(error) => {
                assert_eq!(depth, 16, "{error}");
                break;
            }
        }
    }
}
