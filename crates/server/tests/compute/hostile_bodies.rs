//! JSON that makes no sense, or too much of it.

use std::time::Duration;

use serde_json::json;
use tokio::time::Instant;

use crate::client::{Compute, base64};
use crate::definitions::{SUM, gh};

#[tokio::test(flavor = "multi_thread")]
async fn bodies_that_are_no_request() {
    let compute = Compute::start().await;
    let algo = gh(SUM);
    let deep = "[".repeat(100_000);
    let objects = "{\"a\":".repeat(100_000);
    for body in [
        String::new(),
        "{".to_owned(),
        "null".to_owned(),
        "1".to_owned(),
        "[]".to_owned(),
        "{}".to_owned(),
        "[{},{}]".to_owned(),
        "\u{feff}".to_owned(),
        deep.clone(),
        objects.clone(),
        format!("{{\"algo\":\"{algo}\",\"values\":{deep}"),
        format!("{{\"other\":{deep}{}}}", "]".repeat(100_000)),
        "{\"algo\":\"\"}".to_owned(),
        "{\"algo\":null,\"pointer\":null}".to_owned(),
        "{\"algo\":1e999}".to_owned(),
        "{\"algo\":NaN}".to_owned(),
        "{\"algo\":\"\\ud800\"}".to_owned(),
        format!("{{\"algo\":{}}}", "1".repeat(10_000_000)),
        json!({"algo": "not base64!"}).to_string(),
        json!({"algo": base64("not a definition")}).to_string(),
        json!({"algo": {"a": 1}}).to_string(),
        json!({"algo": algo, "values": {"a": 1}}).to_string(),
        json!({"algo": algo, "values": [1]}).to_string(),
    ] {
        let start = Instant::now();
        for path in ["/grasshopper", "/io"] {
            let answer = compute.ask("POST", path, "", body.as_bytes()).await;
            // What only /grasshopper looks at does not matter to /io.
            let is_fine = path == "/io" && answer.status == 200;
            assert!(answer.is_refused() || is_fine, "{path} {body:.80}: {} {}", answer.status, answer.text());
        }
        assert!(start.elapsed() < Duration::from_secs(10), "{body:.80}");
    }
    compute.is_well().await;
}

/// What is odd and can be understood is understood; what cannot is refused. Nothing is a failure of the server.
#[tokio::test(flavor = "multi_thread")]
async fn values_that_are_odd() {
    let compute = Compute::start().await;
    let algo = gh(SUM);
    let with = |values: &str| format!("{{\"algo\":\"{algo}\",\"values\":{values}}}");
    let tree = |tree: &str| with(&format!("[{{\"ParamName\":\"RH_IN:A\",\"InnerTree\":{tree}}}]"));
    let data = |data: &str| tree(&format!("{{\"0\":[{{\"data\":{data}}}]}}"));
    let key = |key: &str| tree(&format!("{{{}:[{{\"data\":1}}]}}", json!(key)));
    let mut bodies = vec![
        with("null"),
        with("[]"),
        with("[null]"),
        tree("null"),
        tree("[]"),
        tree("{\"0\":null}"),
        tree("{\"0\":[null]}"),
        tree("{\"0\":[{}]}"),
        data("{\"a\":1}"),
        data("[1,2]"),
        data("null"),
        data("1e999"),
        data("\"1e999\""),
        data("\"NaN\""),
        data("\"\""),
        data("\"\\ud800\""),
        data(&"9".repeat(400)),
        format!("{{\"algo\":\"{algo}\",\"algo\":\"{algo}\"}}"),
        format!("{{\"algo\":\"{algo}\",\"absolutetolerance\":0,\"angletolerance\":-1}}"),
        format!("{{\"algo\":\"{algo}\",\"absolutetolerance\":1e308,\"angletolerance\":1e308}}"),
        format!("{{\"algo\":\"{algo}\",\"modelunits\":\"Parsecs\"}}"),
        format!("{{\"algo\":\"{algo}\",\"dataversion\":999}}"),
        format!("{{\"algo\":\"{algo}\",\"recursionlevel\":1000000000}}"),
        format!("{{\"algo\":\"{algo}\",\"recursionlevel\":-1}}"),
    ];
    let long = format!("{{{}}}", vec!["0"; 10_000].join(";"));
    for path in ["{}", "", "{-1}", "{99999999999}", "{0;}", "0;a", "{0}{1}", "{", " ", &long] {
        bodies.push(key(path));
    }
    for body in bodies {
        let answer = compute.ask("POST", "/grasshopper", "", body.as_bytes()).await;
        let is_solved = answer.status == 200 || (answer.status == 500 && answer.json()["errors"].is_array());
        assert!(answer.is_refused() || is_solved, "{body:.120}: {} {}", answer.status, answer.text());
    }
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn values_that_are_many() {
    let compute = Compute::start().await;
    let algo = gh(SUM);
    let branches: Vec<String> = (0..1_000_000).map(|n| format!("\"{{{n}}}\":[{{\"data\":1}}]")).collect();
    let many = branches.join(",");
    let numbers = vec!["{\"data\":1}"; 4_000_000].join(",");
    for tree in [format!("{{{many}}}"), format!("{{\"0\":[{numbers}]}}")] {
        let body = format!(
            "{{\"algo\":\"{algo}\",\"values\":[{{\"ParamName\":\"RH_IN:A\",\"InnerTree\":{tree}}}]}}"
        );
        assert!(body.len() < 52_428_800);
        let start = Instant::now();
        let answer = compute.ask("POST", "/grasshopper?seconds=60", "", body.as_bytes()).await;
        assert!(answer.status == 200 || answer.is_refused(), "{}: {:.300}", answer.status, answer.text());
        assert!(start.elapsed() < Duration::from_secs(90));
    }
    compute.is_well().await;
}
