use katydid_definition::document::Document;
use katydid_definition::kd;

use super::hanging::{Hanging, Missing};
use super::outputs::Outputs;
use super::{Check, Unsupported, check};
use crate::Registry;

fn document(text: &str) -> Document {
    katydid_components::link();
    kd::read(&format!("katydid 1\n{text}"), &Registry).unwrap().document
}

/// The titles of the objects that hang on those with these titles, in the order of the file.
fn hanging(document: &Document, missing: &[&str]) -> Vec<String> {
    let mut ids = Missing::new();
    for (place, title) in missing.iter().enumerate() {
        let object = document.objects.iter().find(|object| object.title() == *title).unwrap();
        ids.insert(object.id, vec![place]);
    }
    let found = Hanging::of(document, &ids);
    let hangs = |at: &usize| !found.at(*at).missing.is_empty();
    (0..document.objects.len()).filter(hangs).map(|at| document.objects[at].title().to_owned()).collect()
}

#[test]
fn all_behind_what_is_missing_hangs_on_it() {
    let chain = document("a = Number(1)\nb = Negative(a)\nc = Negative(b)\nd = Negative(a)\n");
    assert_eq!(hanging(&chain, &["b"]), ["b", "c"]);
    assert_eq!(hanging(&chain, &["a"]), ["a", "b", "c", "d"]);
    assert!(hanging(&chain, &[]).is_empty());
}

#[test]
fn what_is_disabled_gives_nothing_on() {
    let mut chain = document("a = Number(1)\nb = Negative(a)\nc = Negative(b)\n");
    let at = chain.objects.iter().position(|object| object.title() == "b").unwrap();
    chain.objects[at].set_locked(true);
    assert_eq!(hanging(&chain, &["a"]), ["a"]);
    assert!(hanging(&chain, &["b"]).is_empty());
}

#[test]
fn each_output_of_a_cluster_hangs_on_what_it_reads() {
    let text = "a = Number(1)\nb = Number(2)\n\
        two = Cluster(a, b) -> first, second inside {\n\
        p = Cluster Input()\nq = Cluster Input()\n\
        n = Negative(p)\nm = Negative(q)\n\
        first = Cluster Output(n)\nsecond = Cluster Output(m)\n}\n\
        x = Negative(two.first)\ny = Negative(two.second)\n";
    let whole = document(text);
    assert_eq!(hanging(&whole, &["a"]), ["a", "two", "x"]);
    assert_eq!(hanging(&whole, &["b"]), ["b", "two", "y"]);
    // Something is missing inside.
    let inside = whole.objects.iter().find(|object| object.title() == "two").unwrap();
    let Some(Ok(katydid_definition::document::ClusterContent::Open { document: inner, .. })) =
        inside.cluster(&Default::default())
    else {
        panic!("the cluster is open");
    };
    let id = inner.objects.iter().find(|object| object.title() == "m").unwrap().id;
    let found = Hanging::of(&whole, &Missing::from([(id, vec![0])]));
    let hangs = |title: &str| {
        let at = whole.objects.iter().position(|object| object.title() == title).unwrap();
        !found.at(at).missing.is_empty()
    };
    assert!(hangs("two") && hangs("y"));
    assert!(!hangs("x") && !hangs("a"));
}

#[test]
fn a_loop_hands_what_its_end_takes_to_its_start() {
    let text = "a = Number(1)\n\
        s = Loop Start(3, _, a)\n\
        b = Number(2)\nc = Addition(s.D0, b)\n\
        e = Loop End(s.Loop, _, c)\nd = Negative(s.D0)\n";
    assert_eq!(hanging(&document(text), &["b"]), ["s", "b", "c", "e", "d"]);
}

#[test]
fn wires_in_a_circle_end() {
    let mut circle = document("a = Negative(_)\nb = Negative(a)\nc = Number(1)\n");
    let id = |circle: &Document, title: &str| {
        circle.objects.iter().find(|object| object.title() == title).unwrap().outputs[0].id
    };
    let b = id(&circle, "b");
    let at = circle.objects.iter().position(|object| object.title() == "a").unwrap();
    circle.objects[at].set_sources(0, &[b]).unwrap();
    assert_eq!(hanging(&circle, &["b"]), ["a", "b"]);
}

/// The check of a document in which the objects of a title are of a plug-in that nobody knows.
fn lacking(document: &Document, titles: &[&str]) -> Check {
    let mut found = check(document);
    assert!(found.unsupported.is_empty(), "{:?}", found.unsupported);
    for title in titles {
        let object = document.objects.iter().find(|object| object.title() == *title).unwrap();
        found.unsupported.push(Unsupported {
            name: format!("the {title}"),
            component: object.component,
            plugin: None,
            known: None,
            reason: None,
            count: 1,
            objects: vec![object.id],
            outputs: 0,
        });
    }
    found.look_at_outputs(document);
    found
}

fn missing(outputs: &Outputs) -> Vec<(&str, Vec<&str>)> {
    outputs
        .missing
        .iter()
        .map(|output| (output.name.as_str(), output.needs.iter().map(String::as_str).collect()))
        .collect()
}

#[test]
fn outputs_are_what_no_wire_leads_on_from() {
    let text = "a = Number Slider(2, 0..5)\nb = Negative(a)\nc = Negative(b)\nd = Negative(a)\n\
        e = Addition(c, d)\nf = Negative(d)\nstored = Number(4)\n";
    let document = document(text);
    let all = check(&document).outputs;
    assert_eq!((all.count, all.whole, all.marked), (2, 2, false));
    assert!(all.missing.is_empty());
    let part = lacking(&document, &["b", "f"]);
    assert_eq!((part.outputs.count, part.outputs.whole), (2, 0));
    assert_eq!(missing(&part.outputs), [("e", vec!["the b"]), ("f", vec!["the f"])]);
    assert_eq!(part.unsupported.iter().map(|kind| kind.outputs).collect::<Vec<_>>(), [1, 1]);
    let one = lacking(&document, &["b"]);
    assert_eq!((one.outputs.whole, one.outputs.missing.len()), (1, 1));
}

#[test]
fn outputs_that_a_definition_marks_are_the_only_ones() {
    let text = "a = Number Slider(2, 0..5)\nb = Negative(a)\nc = Negative(b)\n\
        shown = Context Print(b)\n";
    let document = document(text);
    let outputs = check(&document).outputs;
    assert_eq!((outputs.count, outputs.marked), (1, true));
    // Nothing that is marked hangs on it.
    let part = lacking(&document, &["c"]);
    assert_eq!((part.outputs.whole, part.unsupported[0].outputs), (1, 0));
    assert!(part.outputs.missing.is_empty());
    assert_eq!(lacking(&document, &["b"]).outputs.missing.len(), 1);
}
