//! Requests that no honest face sends.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::time::Instant;

use common::Studio;
use katydid_component::registry;
use katydid_definition::archive::Chunk;
use katydid_definition::document::{Document, Object, Special, ids};
use katydid_session::Editor;
use katydid_session::protocol::{
    Alignment, Connection, Control, Edit, GraphView, Initial, ObjectChange, RoundingView, Setting,
};
use uuid::Uuid;

#[test]
fn nothing_that_is_not_finite_or_not_there_gets_in() {
    let mut studio = Studio::empty();
    let slider = studio.slider(1.0, 0.0, 10.0);
    let panel = studio.place("Panel", [0.0, 0.0]);
    let graph = studio.place("Graph Mapper", [0.0, 0.0]);
    let nobody = Uuid::from_u128(0xdead);
    let component = registry::by_name("Panel").unwrap().guid;
    let bad = [f32::NAN, f32::INFINITY, 1e30];
    let mut edits = vec![
        Edit::Set { object: slider, to: Setting::Number { value: f64::NAN } },
        Edit::Set { object: slider, to: Setting::Number { value: f64::INFINITY } },
        Edit::Set { object: slider, to: Setting::Switch { on: true } },
        Edit::Set { object: nobody, to: Setting::Switch { on: true } },
        Edit::Move { objects: vec![(nobody, [0.0, 0.0])] },
        Edit::Connect { from: nobody, to: panel, how: Connection::Add },
        Edit::Connect { from: slider, to: nobody, how: Connection::Add },
        Edit::Rewire { from: nobody, to: slider, input: None },
        Edit::Change { objects: vec![nobody], change: ObjectChange::Hidden { on: true } },
        Edit::Group { id: nobody, objects: vec![nobody] },
        Edit::Group { id: nobody, objects: Vec::new() },
        Edit::MakeCluster { id: nobody, objects: vec![] },
        Edit::Place { id: Uuid::nil(), component, at: [0.0, 0.0], with: None },
        Edit::Place { id: nobody, component: nobody, at: [0.0, 0.0], with: None },
        Edit::Place { id: nobody, component, at: [0.0, 0.0], with: Some(Initial::Wire { port: nobody }) },
        Edit::Place {
            id: nobody,
            component,
            at: [0.0, 0.0],
            with: Some(Initial::Values { values: vec![(u32::MAX, "1".to_owned())] }),
        },
        Edit::Place { id: nobody, component: ids::CLUSTER_INPUT, at: [0.0, 0.0], with: None },
        Edit::Duplicate { objects: vec![slider], by: [0.0, 0.0], seed: Uuid::nil() },
        Edit::Keep { port: panel, values: Some("1".to_owned()) },
        Edit::Align { objects: vec![slider, nobody], how: Alignment::Left },
        Edit::Reshape { object: slider, control: Control::Toggle { on: true } },
        Edit::Reshape {
            object: slider,
            control: Control::Slider {
                value: 0.0,
                min: 1.0,
                max: -1.0,
                rounding: RoundingView::Float,
                digits: u32::MAX,
                expression: None,
            },
        },
        Edit::Reshape {
            object: graph,
            control: Control::Graph {
                x: [0.0, f64::NAN],
                y: [0.0, 1.0],
                graph: GraphView { name: String::new(), handles: Vec::new() },
                drawn: Vec::new(),
            },
        },
        Edit::Reshape {
            object: graph,
            control: Control::Graph {
                x: [0.0, 1.0],
                y: [0.0, 1.0],
                graph: GraphView { name: "Nonsense".to_owned(), handles: vec![[0.0, 0.0]; 3] },
                drawn: Vec::new(),
            },
        },
    ];
    for x in bad {
        edits.push(Edit::Move { objects: vec![(slider, [x, 0.0])] });
        edits.push(Edit::Resize { object: panel, bounds: [0.0, x, 100.0, 100.0] });
        edits.push(Edit::Place { id: nobody, component, at: [0.0, x], with: None });
        edits.push(Edit::Duplicate { objects: vec![slider], by: [x, 0.0], seed: nobody });
    }
    edits.push(Edit::Resize { object: panel, bounds: [0.0, 0.0, -5.0, 10.0] });
    let before = studio.editor.document().to_gh().unwrap();
    for edit in edits {
        assert!(studio.editor.apply(&edit, None, &[]).is_err(), "{edit:?}");
        assert_eq!(studio.editor.document().to_gh().unwrap(), before, "{edit:?}");
    }
    assert!(studio.editor.state(&[nobody]).is_err());
    assert!(studio.editor.state(&vec![slider; 100_000]).is_err());
    assert!(studio.editor.copy(&[nobody], &[]).is_err());
    // What is gone already is no fault.
    assert!(studio.make(Edit::Remove { objects: vec![nobody] }).is_empty());
}

#[test]
fn groups_in_a_ring_are_shown_and_taken_apart() {
    katydid_components::link();
    let mut document = Document::new();
    for k in 0..3_u128 {
        let mut group = Object::new_component(ids::GROUP, "Group", "", Uuid::from_u128(k + 1));
        group.container_mut().set_at("ID", 0, Uuid::from_u128((k + 1) % 3 + 1));
        group.container_mut().set("ID_Count", 1);
        group.refresh();
        document.objects.push(group);
    }
    let mut editor = Editor::new(document, Default::default());
    assert_eq!(editor.state(&[]).unwrap().objects.len(), 3);
    let one = Uuid::from_u128(1);
    let change = editor.apply(&Edit::Ungroup { groups: vec![one] }, None, &[]).unwrap();
    editor.patch(&change, &[]).unwrap();
    editor.apply(&Edit::Remove { objects: vec![Uuid::from_u128(2)] }, None, &[]).unwrap();
    assert!(editor.state(&[]).is_ok());
}

/// Chunks of odd shapes are edited around.
#[test]
fn broken_objects_are_shown_and_can_be_moved_and_removed() {
    katydid_components::link();
    let mut document = Document::new();
    for (k, component) in [
        ids::NUMBER_SLIDER,
        ids::PANEL,
        ids::GROUP,
        ids::CLUSTER,
        ids::GRAPH_MAPPER,
        ids::GENE_POOL,
        ids::SCRIBBLE,
    ]
    .into_iter()
    .enumerate()
    {
        let mut chunk = Chunk::new("Object");
        chunk.set("GUID", component);
        let mut container = Chunk::new("Container");
        container.set("InstanceGuid", Uuid::from_u128(k as u128 + 1));
        if k % 2 == 0 {
            container.set("SourceCount", -7);
        }
        chunk.chunks.push(container);
        document.objects.push(Object::from_chunk(chunk));
    }
    document.objects.push(Object::from_chunk(Chunk::new("Object")));
    let mut editor = Editor::new(document, Default::default());
    let views = editor.state(&[]).unwrap().objects;
    assert_eq!(views.len(), 8);
    for view in &views {
        let _ = editor.apply(&Edit::Move { objects: vec![(view.id, [5.0, 5.0])] }, None, &[]);
        for to in [Setting::Number { value: 1.0 }, Setting::Gene { index: u32::MAX, value: 1.0 }] {
            let _ = editor.apply(&Edit::Set { object: view.id, to }, None, &[]);
        }
        if let Some(control) = view.control.clone() {
            let _ = editor.apply(&Edit::Reshape { object: view.id, control }, None, &[]);
        }
        let _ = editor.apply(&Edit::ExplodeCluster { cluster: view.id }, None, &[]);
    }
    let all = views.iter().map(|view| view.id).collect();
    editor.apply(&Edit::Remove { objects: all }, None, &[]).unwrap();
    assert!(editor.document().objects.is_empty());
}

/// A hundred thousand objects: an edit of one takes no longer than a blink.
#[test]
fn a_hundred_thousand_objects_stay_usable() {
    katydid_components::link();
    let mut document = Document::new();
    let mut editor = Editor::new(Document::new(), Default::default());
    let template = Uuid::from_u128(1);
    let component = registry::by_name("Addition").unwrap().guid;
    editor.apply(&Edit::Place { id: template, component, at: [0.0, 0.0], with: None }, None, &[]).unwrap();
    let template = editor.document().objects[0].chunk().clone();
    for k in 0..100_000_u128 {
        let mut object = Object::from_chunk(template.clone());
        object.set_id(Uuid::from_u128(k + 10));
        document.objects.push(object);
    }
    let slider = registry::by_name("Number Slider").unwrap().guid;
    let mut editor = Editor::new(document, Default::default());
    let start = Instant::now();
    let id = Uuid::from_u128(5);
    editor.apply(&Edit::Place { id, component: slider, at: [0.0, 0.0], with: None }, None, &[]).unwrap();
    println!("placed in {:?}", start.elapsed());
    let start = Instant::now();
    for k in 0..20 {
        let edit = Edit::Set { object: id, to: Setting::Number { value: f64::from(k) / 20.0 } };
        let change = editor.apply(&edit, Some(1), &[]).unwrap();
        editor.patch(&change, &[]).unwrap();
    }
    println!("set in {:?}", start.elapsed() / 20);
    assert!(matches!(editor.document().objects.last().unwrap().special(), Some(Special::Slider(_))));
    let start = Instant::now();
    let all: Vec<Uuid> = editor.document().objects.iter().map(|object| object.id).collect();
    editor
        .apply(&Edit::Duplicate { objects: all.clone(), by: [1.0, 1.0], seed: Uuid::from_u128(3) }, None, &[])
        .unwrap_err();
    editor
        .apply(
            &Edit::Duplicate { objects: all[1..].to_vec(), by: [1.0, 1.0], seed: Uuid::from_u128(3) },
            None,
            &[],
        )
        .unwrap();
    editor.undo().unwrap();
    editor.apply(&Edit::Remove { objects: all }, None, &[]).unwrap();
    println!("copied, undone and removed in {:?}", start.elapsed());
}
