//! Calls as a client makes them, over pipes in memory.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

use katydid_assistant::{Assistant, Config};
use rmcp::ServiceExt;
use serde_json::{Value, json};
use tokio::io::{AsyncBufReadExt, AsyncWriteExt, BufReader, DuplexStream, ReadHalf, WriteHalf};

/// The most that waits in a pipe, in bytes: more than any answer here has.
const PIPE: usize = 1 << 20;

/// A client that speaks in lines of JSON, without a library that would keep it from making mistakes.
struct Client {
    lines: tokio::io::Lines<BufReader<ReadHalf<DuplexStream>>>,
    out: WriteHalf<DuplexStream>,
    last: u64,
}

impl Client {
    async fn new(config: Config) -> Self {
        katydid_components::link();
        let (ours, theirs) = tokio::io::duplex(PIPE);
        let assistant = Assistant::new(config).unwrap();
        tokio::spawn(async move {
            let running = assistant.serve(theirs).await.unwrap();
            let _ = running.waiting().await;
        });
        let (read, out) = tokio::io::split(ours);
        let mut client = Self { lines: BufReader::new(read).lines(), out, last: 0 };
        let about = json!({ "protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": { "name": "test", "version": "1" } });
        let told = client.ask("initialize", about).await;
        assert_eq!(told["result"]["serverInfo"]["name"], "katydid", "{told}");
        client.send(&json!({ "jsonrpc": "2.0", "method": "notifications/initialized" }).to_string()).await;
        client
    }

    async fn send(&mut self, line: &str) {
        self.out.write_all(format!("{line}\n").as_bytes()).await.unwrap();
    }

    async fn ask(&mut self, method: &str, params: Value) -> Value {
        self.last += 1;
        let id = self.last;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }).to_string())
            .await;
        loop {
            let line = self.lines.next_line().await.unwrap().unwrap();
            let told: Value = serde_json::from_str(&line).unwrap();
            if told["id"] == id {
                return told;
            }
        }
    }

    /// A call that is carried out.
    async fn call(&mut self, tool: &str, arguments: Value) -> Value {
        let told = self.ask("tools/call", json!({ "name": tool, "arguments": arguments })).await;
        assert_ne!(told["result"]["isError"], true, "{tool}: {told}");
        assert!(told.get("error").is_none(), "{tool}: {told}");
        told["result"]["structuredContent"].clone()
    }

    /// A call that is refused, with these words in its reason.
    async fn refused(&mut self, tool: &str, arguments: Value, words: &str) {
        let told = self.ask("tools/call", json!({ "name": tool, "arguments": arguments })).await;
        let text = match told.get("error") {
            Some(error) => error["message"].to_string(),
            None => {
                assert_eq!(told["result"]["isError"], true, "{tool} {arguments}: {told}");
                told["result"]["content"][0]["text"].to_string()
            }
        };
        assert!(text.contains(words), "{tool} {arguments}: {text}");
    }
}

const CONE: &str = "r = Number Slider(3, 0..10)\nh = Number Slider(4.0, 0..10)\nc = Circle(_, r)\narea = Area(c)\nsum = Addition(r, h)\n";

#[tokio::test(flavor = "multi_thread")]
async fn a_definition_is_built_solved_measured_and_taken_back() {
    let mut client = Client::new(Config::default()).await;
    let made = client.call("new_definition", json!({ "kd": CONE, "name": "cone" })).await;
    assert_eq!((&made["document"], &made["objects"]), (&json!("d1"), &json!(5)));
    let solved = client.call("solve", json!({})).await;
    assert_eq!(
        (&solved["state"], &solved["outcome"]["objects"]["error"]),
        (&json!("done"), &json!(0)),
        "{solved}"
    );
    let sum = client.call("read_values", json!({ "port": "sum" })).await;
    assert_eq!(sum["branches"][0]["values"], json!(["7"]), "{sum}");
    let circle = client.call("measure", json!({ "port": "c" })).await;
    let near = |value: &Value, wanted: f64| (value.as_f64().unwrap() - wanted).abs() < 1e-6 * wanted;
    assert!(near(&circle["length"], std::f64::consts::TAU * 3.0), "{circle}");
    assert!(near(&circle["area"], std::f64::consts::PI * 9.0), "{circle}");
    assert_eq!(circle["box"]["size"], json!([6.0, 6.0, 0.0]), "{circle}");

    client.call("set_inputs", json!({ "values": { "r": 5, "h": 1.5 } })).await;
    let stale = client.call("read_values", json!({ "port": "sum" })).await;
    assert_eq!(
        (&stale["results"]["current"], &stale["branches"][0]["values"]),
        (&json!(false), &json!(["7"]))
    );
    client.call("solve", json!({})).await;
    let sum = client.call("read_values", json!({ "port": "sum.Result" })).await;
    assert_eq!(sum["branches"][0]["values"], json!(["6.5"]));

    client
        .call("edit_text", json!({ "replace": [{ "old": "Addition(r, h)", "new": "Multiplication(r, h)" }] }))
        .await;
    client
        .call(
            "edit_definition",
            json!({ "operations": [
            { "op": "add", "component": "Panel", "name": "shown" },
            { "op": "connect", "from": "sum", "to": "shown" },
            { "op": "group", "objects": ["r", "h"], "label": "inputs" },
        ] }),
        )
        .await;
    client.call("solve", json!({})).await;
    let shown = client.call("read_values", json!({ "port": "shown" })).await;
    assert_eq!(shown["branches"][0]["values"], json!(["7.5"]), "{shown}");
    let listed = client.call("list_objects", json!({ "objects": ["shown"] })).await;
    assert_eq!(listed["objects"][0]["inputs"][0]["from"], json!(["sum"]), "{listed}");
    let undone = client.call("undo", json!({ "steps": 3 })).await;
    assert_eq!(undone["steps"].as_array().map(Vec::len), Some(3), "{undone}");
    let text = client.call("read_text", json!({})).await;
    assert!(text["text"].as_str().unwrap().contains("r = Number Slider(3, 0..10)"), "{text}");
    assert!(text["text"].as_str().unwrap().contains("Addition(r, h)"), "{text}");
}

#[tokio::test(flavor = "multi_thread")]
async fn bad_calls_are_refused_by_name_and_nothing_is_lost() {
    let folder = tempfile::tempdir().unwrap();
    let open = folder.path().join("open");
    std::fs::create_dir(&open).unwrap();
    std::fs::write(folder.path().join("secret.kd"), "a = Panel(\"x\")").unwrap();
    std::fs::write(open.join("broken.gh"), b"not an archive").unwrap();
    let mut client = Client::new(Config { folders: vec![open], ..Config::default() }).await;
    client.refused("solve", json!({}), "none is open").await;
    client.call("new_definition", json!({ "kd": CONE })).await;
    let before = client.call("read_text", json!({ "blocks": true })).await;
    let outside = folder.path().join("secret.kd").display().to_string();
    for (tool, arguments, words) in [
        ("nothing", json!({}), "no tool"),
        ("describe_definition", json!({ "document": "d9" }), "no such definition"),
        ("describe_definition", json!({ "document": 1 }), "invalid type"),
        ("describe_definition", json!({ "what": "d1" }), "unknown field"),
        ("new_definition", json!({ "kd": "a = Nothing Such(1)" }), "line 1"),
        ("new_definition", json!({ "kd": "(((((" }), "line 1"),
        ("new_definition", json!({ "example": "../V1" }), "none of that id"),
        ("new_definition", json!({ "kd": "x".repeat(9 << 20) }), "bytes"),
        ("open_definition", json!({ "path": "../secret.kd" }), ".."),
        ("open_definition", json!({ "path": outside }), "outside"),
        ("open_definition", json!({ "path": "/etc/passwd" }), "a definition is"),
        ("open_definition", json!({ "path": "broken.gh" }), "broken.gh"),
        ("open_definition", json!({ "path": "none.gh" }), "no such file"),
        ("save_definition", json!({}), "in no file"),
        ("save_definition", json!({ "path": "a.txt" }), ".gh"),
        ("save_definition", json!({ "path": "../a.gh" }), ".."),
        ("close_definition", json!({ "document": "d1" }), "discard"),
        ("edit_text", json!({}), "give replace"),
        ("edit_text", json!({ "replace": [{ "old": "never there", "new": "" }] }), "does not occur"),
        ("edit_text", json!({ "replace": [{ "old": "Number Slider", "new": "" }] }), "more than once"),
        ("edit_text", json!({ "replace": [{ "old": "", "new": "" }] }), "empty"),
        ("edit_text", json!({ "append": "x = Circle(nowhere)" }), "nowhere"),
        ("edit_text", json!({ "append": "x = Panel(1)", "revision": 99 }), "revision"),
        ("edit_definition", json!({ "operations": [] }), "between 1"),
        ("edit_definition", json!({ "operations": [{ "op": "explode the sun" }] }), "unknown variant"),
        (
            "edit_definition",
            json!({ "operations": [{ "op": "remove", "objects": ["r"] }, { "op": "remove", "objects": ["zz"] }] }),
            "operation 1",
        ),
        (
            "edit_definition",
            json!({ "operations": [{ "op": "connect", "from": "r", "to": "c.Nothing" }] }),
            "no such input",
        ),
        ("edit_definition", json!({ "operations": [{ "op": "connect", "from": "sum", "to": "h" }] }), "wire"),
        (
            "edit_definition",
            json!({ "operations": [{ "op": "move", "object": "r", "at": [1e30, 0] }] }),
            "canvas",
        ),
        (
            "edit_definition",
            json!({ "operations": [{ "op": "set", "object": "r", "value": 11 }] }),
            "0 to 10",
        ),
        ("edit_definition", json!({ "operations": [{ "op": "set", "object": "r", "value": "NaN" }] }), "r"),
        (
            "edit_definition",
            json!({ "operations": [{ "op": "add", "component": "No Such" }] }),
            "no such component",
        ),
        ("set_inputs", json!({ "values": {} }), "between 1"),
        ("set_inputs", json!({ "values": { "r": 5, "zz": 1 } }), "zz"),
        ("set_inputs", json!({ "values": { "r": null } }), "null"),
        ("set_inputs", json!({ "values": { "r": "inf" } }), "r"),
        ("read_values", json!({ "port": "sum" }), "call solve"),
        ("picture", json!({}), "call solve"),
        ("picture", json!({ "of": "canvas", "width": 100_000 }), "64 to 2048"),
        ("export_geometry", json!({ "path": "a.glb" }), "call solve"),
        ("export_geometry", json!({ "path": "a.doc" }), "no format"),
        ("export_geometry", json!({}), "must be given"),
        ("solve", json!({ "wait_seconds": -1 }), "0 to 50"),
        ("solve", json!({ "wait_seconds": 1e300 }), "0 to 50"),
        ("cancel_job", json!({}), "never solved"),
        ("job_status", json!({ "job": 7 }), "no such job"),
        ("why", json!({}), "call solve"),
        ("diff_definition", json!({ "path": "../secret.kd" }), ".."),
        ("component_help", json!({ "name": "No Such" }), "no such component"),
        ("find_components", json!({ "words": " ,. " }), "no words"),
        ("undo", json!({}), "nothing to undo"),
        ("redo", json!({}), "nothing to do again"),
    ] {
        client.refused(tool, arguments, words).await;
    }
    // What is no message is passed over.
    for line in ["", "{", "[1, 2", "null", "{\"jsonrpc\":\"2.0\"}", "\u{0}\u{1}"] {
        client.send(line).await;
    }
    let after = client.call("read_text", json!({ "blocks": true })).await;
    assert_eq!(before, after);
    let rounded = client.call("set_inputs", json!({ "values": { "r": 4.4 } })).await;
    assert_eq!(rounded["rounded"], json!({ "r": 4.0 }), "{rounded}");
}

#[tokio::test(flavor = "multi_thread")]
async fn files_are_saved_exported_and_compared() {
    let folder = tempfile::tempdir().unwrap();
    let mut client =
        Client::new(Config { folders: vec![folder.path().to_owned()], ..Config::default() }).await;
    client.call("new_definition", json!({ "kd": CONE })).await;
    for path in ["a.kd", "a.gh", "a.ghx"] {
        client.call("save_definition", json!({ "path": path })).await;
        let opened = client.call("open_definition", json!({ "path": path })).await;
        let other = opened["document"].clone();
        let diff = client.call("diff_definition", json!({ "document": "d1", "other": other })).await;
        assert_eq!(diff["total"], 0, "{path}: {diff}");
        client.call("close_definition", json!({ "document": other })).await;
    }
    client.refused("save_definition", json!({ "path": "a.kd" }), "overwrite").await;
    client.call("solve", json!({})).await;
    for format in ["3dm", "glb", "svg", "step", "obj"] {
        let told = client.call("export_geometry", json!({ "path": format!("out.{format}") })).await;
        let size = std::fs::metadata(folder.path().join(format!("out.{format}"))).unwrap().len();
        assert_eq!(
            (told["bytes"].as_u64(), told["objects"].as_u64().unwrap() > 0),
            (Some(size), true),
            "{told}"
        );
    }
    for of in ["result", "canvas"] {
        let told = client.ask("tools/call", json!({ "name": "picture", "arguments": { "of": of } })).await;
        let image = &told["result"]["content"][1];
        assert_eq!(image["mimeType"], "image/png", "{told}");
        assert!(image["data"].as_str().unwrap().starts_with("iVBORw0KGgo"));
    }
    let why = client.call("why", json!({ "object": "area" })).await;
    assert_eq!((&why["status"], &why["begins_at"]), (&json!("ok"), &json!([])), "{why}");
}

/// A solve that lasts far longer than this test.
const LONG: &str =
    "n = Series(0, 1, 20000000)\nm = Sine(n)\nk = Sine(m)\nl = Sine(k)\no = Sine(l)\np = Sine(o)\n";

#[tokio::test(flavor = "multi_thread")]
async fn a_long_solve_blocks_nothing_and_can_be_cancelled() {
    let mut client = Client::new(Config::default()).await;
    client.call("new_definition", json!({ "kd": LONG })).await;
    let job = client.call("solve", json!({ "wait_seconds": 0 })).await;
    assert_eq!(job["state"], "running", "{job}");
    for tool in ["describe_definition", "list_objects", "read_text", "job_status"] {
        let began = std::time::Instant::now();
        client.call(tool, json!({})).await;
        assert!(began.elapsed().as_secs_f64() < 5.0, "{tool} waited for the solve");
    }
    client
        .call("edit_definition", json!({ "operations": [{ "op": "rename", "object": "p", "name": "q" }] }))
        .await;
    let ended = client.call("cancel_job", json!({})).await;
    assert!(["cancelled", "done"].contains(&ended["state"].as_str().unwrap()), "{ended}");
    client.refused("cancel_job", json!({}), "ended").await;
    let told = client.call("describe_definition", json!({})).await;
    assert_eq!(told["results"]["current"], false, "{told}");
}
