//! A document speaks the studio's protocol with one client, and its journal has what was edited.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

use katydid_wasm::{Document, Message, written};
use serde_json::{Value, json};

const SUM: &str = "katydid 1\na = Number Slider(3.0, 0..10)\nb = Number Slider(4.0, 0..10)\nsum = Addition(a, b)\n\
                   c = Circle(_, sum)\n";

fn open(journal: Vec<u8>) -> Document {
    let mut document = Document::open("sum", Some(SUM.as_bytes()), journal, false).unwrap();
    document.join();
    document
}

/// Does all that is due; the events that came of it, and how many frames of geometry.
fn settle(document: &mut Document) -> (Vec<Value>, usize) {
    while document.is_due() {
        document.work(|_| {});
    }
    let (mut events, mut frames) = (Vec::new(), 0);
    for message in document.take() {
        match message {
            Message::Text(text) => events.push(serde_json::from_str(&text).unwrap()),
            Message::Binary(_) => frames += 1,
        }
    }
    (events, frames)
}

fn ask(document: &mut Document, seq: u64, mut what: Value, name: &str) {
    what["ask"] = name.into();
    document.ask(&json!({"seq": seq, "ask": what}).to_string(), |_| {});
}

fn of<'a>(events: &'a [Value], name: &str) -> Vec<&'a Value> {
    events.iter().filter(|event| event["event"] == name).collect()
}

fn slider(events: &[Value]) -> (String, f64) {
    let state = of(events, "document")[0];
    let objects = state["objects"].as_array().unwrap();
    let slider = objects.iter().find(|object| object["control"]["is"] == "slider").unwrap();
    (slider["id"].as_str().unwrap().to_owned(), slider["control"]["value"].as_f64().unwrap())
}

fn set(document: &mut Document, seq: u64, object: &str, value: f64) {
    let edit = json!({"do": "set", "object": object, "to": {"is": "number", "value": value}});
    ask(document, seq, json!({"edit": edit, "gesture": null, "within": []}), "edit");
}

#[test]
fn what_joins_is_shown_the_document_its_geometry_and_its_results() {
    let mut document = open(Vec::new());
    let (events, frames) = settle(&mut document);
    assert_eq!(of(&events, "document").len(), 1);
    assert_eq!(frames, 1);
    assert!(of(&events, "preview").iter().any(|event| event["objects"].as_array().unwrap().len() == 1));
    let results = of(&events, "results");
    let last = results.last().unwrap();
    assert!(last["finished"] == true && last["cancelled"] == false, "{last}");
    assert!(last["results"].as_array().unwrap().iter().all(|result| result["status"] == "ok"), "{last}");
    let drawn = events.iter().rposition(|event| event["event"] == "preview").unwrap();
    let told = events.iter().rposition(|event| event["event"] == "results").unwrap();
    assert!(drawn < told, "geometry comes first");
}

#[test]
fn many_edits_are_one_solve() {
    let mut document = open(Vec::new());
    let (events, _) = settle(&mut document);
    let (id, _) = slider(&events);
    for k in 0_u32..10 {
        set(&mut document, u64::from(k), &id, f64::from(k));
    }
    let (events, frames) = settle(&mut document);
    assert_eq!(of(&events, "done").len(), 10);
    assert_eq!(of(&events, "results").len(), 1);
    assert_eq!(frames, 1);
    ask(&mut document, 11, json!({}), "undo");
    ask(&mut document, 12, json!({"on": true}), "lock");
    set(&mut document, 13, &id, 1.0);
    let (events, _) = settle(&mut document);
    assert!(of(&events, "results").len() <= 1, "what is locked waits");
}

#[test]
fn the_journal_has_what_was_edited() {
    let mut first = open(Vec::new());
    let (events, _) = settle(&mut first);
    let (id, value) = slider(&events);
    assert_eq!(value, 3.0);
    set(&mut first, 1, &id, 9.0);
    settle(&mut first);
    first.flush();
    let journal = written(Vec::new(), &first.take_written());
    assert!(!journal.is_empty() && first.is_changed());

    let mut second = open(journal.clone());
    let (events, _) = settle(&mut second);
    assert_eq!(of(&events, "document")[0]["restored"]["steps"], 1);
    assert_eq!(slider(&events).1, 9.0);
    // A journal that is cut anywhere, or garbage, opens what is left and says so.
    for length in 0..journal.len() {
        let mut cut = open(journal[..length].to_vec());
        let (events, _) = settle(&mut cut);
        assert_eq!(of(&events, "document").len(), 1, "{length}");
    }
    second.saved("sum.kd");
    assert!(!second.is_changed());
    assert!(written(journal, &second.take_written()).is_empty());
}

#[test]
fn what_makes_no_sense_is_refused_and_nothing_falls() {
    let mut document = open(Vec::new());
    settle(&mut document);
    for text in ["", "{}", "no request", "{\"seq\":1,\"ask\":{\"ask\":\"nothing\"}}"] {
        document.ask(text, |_| {});
        let (events, _) = settle(&mut document);
        assert_eq!(of(&events, "notice").len(), 1, "{text}");
    }
    ask(&mut document, 7, json!({"path": null}), "save");
    ask(&mut document, 8, json!({"run": true, "keep": true}), "allowScripts");
    let (events, _) = settle(&mut document);
    assert_eq!(of(&events, "refused").len(), 2);
    assert!(document.attach("x.3dm", b"no model").is_err());
    assert!(Document::open("x", Some(b"no definition"), Vec::new(), false).is_err());
    assert!(document.geometry("nothing").is_none() && document.picture("nothing").is_none());
}

/// An object by its title.
fn named<'a>(events: &'a [Value], title: &str) -> &'a Value {
    let objects = of(events, "document")[0]["objects"].as_array().unwrap();
    objects.iter().find(|object| object["nickname"] == title).unwrap()
}

/// Its id.
fn object(events: &[Value], title: &str) -> Value {
    named(events, title)["id"].clone()
}

#[test]
fn what_moves_a_result_is_found_beside_other_requests() {
    let mut document = open(Vec::new());
    let (events, _) = settle(&mut document);
    let (sum, port) = (object(&events, "sum"), named(&events, "sum")["outputs"][0]["id"].clone());
    let question =
        |ranges: bool| json!({"target": {"output": sum, "item": null}, "with": null, "ranges": ranges});
    ask(&mut document, 1, question(true), "effects");
    assert!(document.is_due() && document.take().is_empty(), "the answer comes when it is found");
    // Requests are heard between two slices, and a question takes the place of another.
    document.work(|_| {});
    ask(&mut document, 2, json!({"port": port, "from": 0, "count": 1, "exact": true, "within": []}), "rows");
    ask(&mut document, 3, question(true), "effects");
    let (events, _) = settle(&mut document);
    assert_eq!(of(&events, "refused").iter().map(|event| event["seq"].clone()).collect::<Vec<_>>(), [1]);
    let found = of(&events, "effects")[0];
    assert_eq!(found["seq"], 3);
    assert_eq!(of(&events, "rows")[0]["seq"], 2);
    let effects = &found["effects"];
    assert_eq!(effects["value"], 7.0);
    for here in effects["here"].as_array().unwrap() {
        assert_eq!(here["slope"]["is"], "even", "{here}");
        assert!((here["slope"]["by"]["value"].as_f64().unwrap() - 1.0).abs() < 1e-9, "{here}");
    }
    // Two inputs of the same range that are added make a half of the variance each.
    let ranged = effects["ranged"].as_array().unwrap();
    assert_eq!(ranged.len(), 2);
    for one in ranged {
        assert!((one["share"]["alone"][0].as_f64().unwrap() - 0.5).abs() < 0.05, "{one}");
    }
    // One that is ended is told so, and what follows is heard.
    ask(&mut document, 4, question(true), "effects");
    document.work(|_| {});
    ask(&mut document, 5, json!({}), "endStudy");
    let (events, _) = settle(&mut document);
    assert_eq!(of(&events, "refused")[0]["seq"], 4);
    assert_eq!(of(&events, "done")[0]["seq"], 5);
    assert!(of(&events, "effects").is_empty());
}

#[test]
fn inputs_for_a_wanted_result_are_found_and_set_as_one_step() {
    let mut document = open(Vec::new());
    let (events, _) = settle(&mut document);
    let sum = object(&events, "sum");
    let wants = json!([{"target": {"output": sum, "item": null}, "numbers": [11.0]}]);
    ask(&mut document, 1, json!({"wants": wants, "with": null, "quick": false, "gesture": 7}), "solveFor");
    let (events, _) = settle(&mut document);
    let solved = &of(&events, "solved")[0]["solved"];
    assert!(solved["off"].as_f64().unwrap() < 1e-9, "{solved}");
    let inputs: Vec<f64> =
        solved["inputs"].as_array().unwrap().iter().map(|input| input["value"].as_f64().unwrap()).collect();
    assert!((inputs.iter().sum::<f64>() - 11.0).abs() < 1e-9, "{solved}");
    // Both sliders went there in one step of the history, and the results are those of there.
    assert!(of(&events, "results").last().unwrap()["finished"] == true);
    ask(&mut document, 2, json!({}), "undo");
    ask(&mut document, 3, json!({}), "undo");
    let (events, _) = settle(&mut document);
    assert_eq!(of(&events, "refused").len(), 1, "there is one step to undo");
    // A gesture that is taken back leaves no slider moved.
    ask(&mut document, 9, json!({"wants": wants, "with": null, "quick": false, "gesture": 9}), "solveFor");
    document.work(|_| {});
    ask(&mut document, 10, json!({"gesture": 9}), "abandon");
    let (events, _) = settle(&mut document);
    assert_eq!(of(&events, "refused")[0]["reason"], "it was ended");
    assert!(of(&events, "solved").is_empty() && of(&events, "results").is_empty());
    // What cannot be wanted is refused by name.
    ask(&mut document, 4, json!({"wants": [], "with": null, "quick": true, "gesture": 8}), "solveFor");
    let input = json!({"object": sum, "gene": null});
    ask(&mut document, 5, json!({"input": input}), "motion");
    let (events, _) = settle(&mut document);
    let told: Vec<&str> =
        of(&events, "refused").iter().map(|event| event["reason"].as_str().unwrap()).collect();
    assert_eq!(told.len(), 2, "{told:?}");
}

#[test]
fn places_move_with_an_input() {
    let mut document = open(Vec::new());
    let (events, _) = settle(&mut document);
    let input = json!({"object": object(&events, "a"), "gene": null});
    ask(&mut document, 1, json!({"input": input}), "motion");
    let (events, _) = settle(&mut document);
    let motion = &of(&events, "motion")[0]["motion"];
    let arrows = motion["arrows"].as_array().unwrap();
    // The circle grows by 1 where the slider does.
    assert!(!arrows.is_empty());
    for arrow in arrows {
        let by: f64 = arrow["by"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap().powi(2)).sum();
        assert!((by.sqrt() - 1.0).abs() < 1e-6, "{arrow}");
    }
}
