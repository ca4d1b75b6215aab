//! An assistant works on the document that people have open: they see each call as it is done, and take it back as one
//! step. Who may not come in is told so.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use common::{Client, Studio, is_done};
use katydid_assistant::{Assistant, Config, StudioAddress};
use katydid_definition::document::{Difference, Document};
use katydid_session::journal::write_difference;
use katydid_session::protocol::{Ask, Control, Edit};
use rmcp::ServiceExt;
use serde_json::{Value, json};
use tokio::io::{AsyncBufReadExt, AsyncWriteExt, BufReader, DuplexStream, Lines, ReadHalf, WriteHalf};

const SMALL: &str = "katydid 1\nr = Number Slider(2.0, 0..10)\nball = Sphere(_, r)\nshown = Panel(r)\n";
/// The most that waits in a pipe, in bytes: more than any answer here has.
const PIPE: usize = 1 << 20;

/// An assistant's program that is attached to a studio.
struct Attached {
    lines: Lines<BufReader<ReadHalf<DuplexStream>>>,
    out: WriteHalf<DuplexStream>,
    last: u64,
}

impl Attached {
    async fn to(url: &str) -> Self {
        let studio = Some(StudioAddress::Url(url.to_owned()));
        let assistant = Assistant::new(Config { studio, ..Config::default() }).unwrap();
        let (ours, theirs) = tokio::io::duplex(PIPE);
        tokio::spawn(async move {
            let _ = assistant.serve(theirs).await.unwrap().waiting().await;
        });
        let (read, out) = tokio::io::split(ours);
        let mut one = Self { lines: BufReader::new(read).lines(), out, last: 0 };
        let client = json!({ "name": "test", "version": "1" });
        let about = json!({ "protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": client });
        let told = one.ask("initialize", about).await;
        assert!(told["result"]["instructions"].as_str().unwrap().contains("in the studio"), "{told}");
        one.send(&json!({ "jsonrpc": "2.0", "method": "notifications/initialized" })).await;
        one
    }

    async fn send(&mut self, message: &Value) {
        self.out.write_all(format!("{message}\n").as_bytes()).await.unwrap();
    }

    async fn ask(&mut self, method: &str, params: Value) -> Value {
        self.last += 1;
        let id = self.last;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params })).await;
        loop {
            let line = self.lines.next_line().await.unwrap().unwrap();
            let told: Value = serde_json::from_str(&line).unwrap();
            if told["id"] == id {
                return told;
            }
        }
    }

    async fn told(&mut self, tool: &str, arguments: Value) -> Value {
        self.ask("tools/call", json!({ "name": tool, "arguments": arguments })).await["result"].clone()
    }

    async fn call(&mut self, tool: &str, arguments: Value) -> Value {
        let told = self.told(tool, arguments).await;
        assert_ne!(told["isError"], true, "{tool}: {told}");
        told["structuredContent"].clone()
    }

    async fn refused(&mut self, tool: &str, arguments: Value, words: &str) {
        let told = self.told(tool, arguments).await;
        assert_eq!(told["isError"], true, "{tool}: {told}");
        let text = told["content"][0]["text"].as_str().unwrap();
        assert!(text.contains(words), "{tool}: {text}");
    }
}

async fn studio() -> Studio {
    Studio::start_with(|config| katydid_server::Config { assistant: true, ..config }).await
}

/// Waits until an object of that name is there, or is not.
async fn until_there(client: &mut Client, name: &str, is_there: bool) {
    while client.objects.values().any(|object| object.nickname == name) != is_there {
        client.hear().await;
    }
}

fn slider(client: &Client, name: &str) -> f64 {
    match client.objects[&client.named(name)].control {
        Some(Control::Slider { value, .. }) => value,
        ref other => panic!("{other:?}"),
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn people_see_each_call_and_take_it_back_as_one_step() {
    let studio = studio().await;
    let id = studio.upload(SMALL).await;
    let (mut one, mut two) = (studio.join(&id).await, studio.join(&id).await);
    one.solved(1).await;
    two.solved(1).await;
    let mut assistant = Attached::to(studio.server.url()).await;
    let listed = assistant.call("list_definitions", json!({})).await;
    assert_eq!(listed["open"][0]["name"], "test", "{listed}");

    // Several objects, in one call.
    let text = "side = Number Slider(3.0, 0..10)\nround = Circle(_, side)\ndouble = Operators/Multiplication(side, 2)\nsecond = Panel(double)\n";
    assistant.call("edit_text", json!({ "append": text })).await;
    for client in [&mut one, &mut two] {
        until_there(client, "second", true).await;
        client.shows("second", &["6"]).await;
    }
    // Ctrl+Z in the page.
    assert_eq!(two.state.as_ref().unwrap().document.undo.as_deref(), Some("Assistant: Edit text"));
    assert!(is_done(&one.ask(Ask::Undo).await));
    for client in [&mut one, &mut two] {
        until_there(client, "second", false).await;
        assert_eq!(client.objects.len(), 3);
    }
    let read = assistant.call("read_text", json!({})).await;
    assert!(!read["text"].as_str().unwrap().contains("second"), "{read}");
    assert!(is_done(&one.ask(Ask::Redo).await));
    until_there(&mut two, "second", true).await;

    // Both edit, and each has the other's state.
    one.set("r", 7.0).await;
    let described = assistant.call("describe_definition", json!({})).await;
    assert_eq!(described["objects"], 7, "{described}");
    let r = described["inputs"].as_array().unwrap().iter().find(|input| input["name"] == "r").unwrap();
    assert_eq!(r["value"]["value"], 7.0, "{r}");
    assistant.refused("undo", json!({}), "by the person").await;
    assistant.call("set_inputs", json!({ "values": { "r": 4, "side": 1 } })).await;
    one.shows("shown", &["4"]).await;
    two.shows("shown", &["4"]).await;
    two.shows("second", &["2"]).await;
    let solved = assistant.call("solve", json!({})).await;
    assert_eq!(
        (&solved["state"], &solved["outcome"]["objects"]["error"]),
        (&json!("done"), &json!(0)),
        "{solved}"
    );
    let measured = assistant.call("measure", json!({ "port": "ball" })).await;
    assert!((measured["box"]["size"][2].as_f64().unwrap() - 8.0).abs() < 1e-9, "{measured}");
    let undone = assistant.call("undo", json!({})).await;
    assert_eq!(undone["steps"], json!(["Set r, side"]), "{undone}");
    two.shows("shown", &["7"]).await;
    two.shows("second", &["6"]).await;
    one.shows("shown", &["7"]).await;
    assert_eq!((slider(&one, "r"), slider(&two, "side")), (7.0, 3.0));
    assistant.refused("undo", json!({}), "by the person").await;
    let again = assistant.call("redo", json!({})).await;
    assert_eq!(again["steps"], json!(["Set r, side"]), "{again}");
    two.shows("shown", &["4"]).await;
    assert!(one.notices.iter().any(|notice| notice.contains("assistant")), "{:?}", one.notices);
    studio.server.stop().await;
    assistant.refused("describe_definition", json!({}), "does not answer").await;
}

#[tokio::test(flavor = "multi_thread")]
async fn what_a_person_does_in_a_studio_is_refused_by_name() {
    let studio = studio().await;
    let mut assistant = Attached::to(studio.server.url()).await;
    assistant.refused("describe_definition", json!({}), "none is open in the studio").await;
    let id = studio.upload(SMALL).await;
    let mut client = studio.join(&id).await;
    client.solved(1).await;
    for (tool, arguments) in [
        ("new_definition", json!({})),
        ("open_definition", json!({ "path": "a.gh" })),
        ("close_definition", json!({ "document": "d1" })),
    ] {
        assistant.refused(tool, arguments, "the person makes, opens and closes").await;
    }
    assistant.refused("save_definition", json!({}), "the person saves it").await;
    let calls = [
        (
            "edit_definition",
            json!({ "operations": [{ "op": "remove", "objects": ["r"] }, { "op": "remove", "objects": ["nobody"] }] }),
        ),
        ("edit_text", json!({ "append": "x = (" })),
        ("set_inputs", json!({ "values": { "r": 99 } })),
        ("undo", json!({})),
    ];
    for (tool, arguments) in calls {
        assistant.refused(tool, arguments, "").await;
    }
    let edit = Edit::Move { objects: vec![(client.named("r"), [500.0, 500.0])] };
    assert!(is_done(&client.edit(edit).await));
    assert_eq!(client.state.as_ref().unwrap().revision, 1, "what was refused has changed nothing");
    // A document that is closed is none any more.
    drop(client);
    let question = json!({ "document": id }).to_string();
    while studio.post_json("/api/close", &question).await.status == 409 {
        tokio::time::sleep(std::time::Duration::from_millis(20)).await;
    }
    assistant.refused("read_text", json!({}), "none is open in the studio").await;
}

#[tokio::test(flavor = "multi_thread")]
async fn only_who_is_let_in_comes_in() {
    let shut = Studio::start().await;
    let id = shut.upload(SMALL).await;
    let state = format!("/api/assistant/state?document={id}");
    for path in ["/api/assistant", &state] {
        let answer = shut.get(path).await;
        assert_eq!(answer.status, 403);
        assert!(answer.json()["error"].as_str().unwrap().contains("--allow-assistant"));
    }
    let mut refused = Attached::to(shut.server.url()).await;
    refused.refused("list_definitions", json!({}), "--allow-assistant").await;

    let studio = studio().await;
    let id = studio.upload(SMALL).await;
    let state = format!("/api/assistant/state?document={id}");
    assert_eq!(studio.get(&state).await.status, 200);
    let host = studio.host();
    let without = format!("GET {state} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
    assert_eq!(studio.raw(without.as_bytes()).await.status, 401);
    for line in [
        "Origin: https://evil.example\r\n",
        "Origin: null\r\n",
        "Sec-Fetch-Site: cross-site\r\n",
        "X-Forwarded-For: 192.168.1.7\r\n",
    ] {
        assert_eq!(studio.ask("GET", &state, line, b"").await.status, 403, "{line}");
        let walk = format!("/api/assistant/walk?document={id}&revision=0");
        assert_eq!(studio.ask("POST", &walk, line, b"").await.status, 403, "{line}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn steps_that_do_not_fit_change_nothing() {
    let studio = studio().await;
    let id = studio.upload(SMALL).await;
    let mut client = studio.join(&id).await;
    client.solved(1).await;
    let step = |revision: u64| format!("/api/assistant/step?document={id}&revision={revision}&name=x");
    let gone = write_difference(&Difference { removed: vec![0], ..Difference::default() }).unwrap();
    let far = write_difference(&Difference { removed: vec![70], ..Difference::default() }).unwrap();
    let whole = katydid_definition::archive::write_gh(&Document::new().to_archive().root).unwrap();
    for (path, body, status) in [
        (step(1), gone.as_slice(), 409),
        (step(0), far.as_slice(), 409),
        (step(0), b"nonsense".as_slice(), 400),
        (step(0), b"".as_slice(), 400),
        (step(0), whole.as_slice(), 400),
        (format!("/api/assistant/step?document={id}&name=x"), gone.as_slice(), 400),
        ("/api/assistant/step?document=none&revision=0&name=x".to_owned(), gone.as_slice(), 404),
    ] {
        assert_eq!(studio.ask("POST", &path, "", body).await.status, status, "{path}");
    }
    assert_eq!(studio.get(&format!("/api/assistant/state?document={id}")).await.json()["revision"], 0);
    let taken = studio.ask("POST", &step(0), "", &gone).await;
    assert_eq!((taken.status, taken.json()["revision"].as_u64()), (200, Some(1)));
    while client.objects.len() != 2 {
        client.hear().await;
    }
    let known = studio.get(&format!("/api/assistant/state?document={id}&known=1")).await.json();
    assert_eq!((known["revision"].as_u64(), &known["document"]), (Some(1), &Value::Null));
}
