//! What clients rely on.

use serde_json::json;
use tokio::io::AsyncWriteExt;

use crate::client::{Compute, base64, input, next};
use crate::definitions::{SUM, gh, ghx};
use katydid_server::compute::Config;

#[tokio::test(flavor = "multi_thread")]
async fn a_definition_is_solved_and_named_for_later() {
    let compute = Compute::start().await;
    let algo = gh(SUM);
    let values = json!([input("RH_IN:A", "0", &[json!(4)]), input("RH_IN:B", "{0;0}", &[json!("5")])]);
    let answer = compute.solve(&algo, values.clone()).await;
    assert_eq!(answer.status, 200, "{}", answer.text());
    assert_eq!(answer.output("RH_OUT:sum"), 9.0);
    assert_eq!(answer.header("content-type"), "application/json; charset=utf-8");
    assert_eq!(answer.header("content-length"), answer.body.len().to_string());
    let timing = answer.header("server-timing");
    for part in ["decode;dur=", "solve;dur=", "encode;dur="] {
        assert!(timing.contains(part), "{timing}");
    }
    let pointer = answer.json()["pointer"].as_str().unwrap().to_owned();
    assert!(pointer.starts_with("md5_") && pointer.len() == 36, "{pointer}");
    let later = compute.post("/grasshopper", &json!({"pointer": pointer, "values": values})).await;
    assert_eq!(later.output("RH_OUT:sum"), 9.0);
    // A definition as text, and one that is read in place of a pointer that is kept no longer.
    let answer = compute.solve(&base64(ghx(SUM)), json!([])).await;
    assert_eq!(answer.output("RH_OUT:sum"), 5.0);
    let gone = format!("md5_{}", "0".repeat(32));
    let answer = compute.post("/grasshopper", &json!({"algo": algo, "pointer": gone, "values": []})).await;
    assert_eq!(answer.output("RH_OUT:sum"), 5.0);
    let answer = compute.post("/grasshopper", &json!({"pointer": gone, "values": []})).await;
    assert!(answer.is_refused(), "{}", answer.text());
    compute.server.stop().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn requests_in_every_form_that_clients_have() {
    let compute = Compute::start().await;
    let algo = gh(SUM);
    let body = json!({"algo": algo, "values": [input("RH_IN:A", "{ 0; 0; }", &[json!(4)])]});
    let shouted =
        json!({"ALGO": algo, "Values": [{"paramname": "RH_IN:A", "INNERTREE": {"0": [{"DATA": "4"}]}}]});
    for (path, headers, body) in [
        ("/grasshopper", "", body.to_string()),
        ("/grasshopper", "Content-Type: text/plain;charset=UTF-8\r\n", body.to_string()),
        ("/grasshopper", "Content-Type: application/json; charset=utf-8\r\n", body.to_string()),
        ("/GrassHopper", "", body.to_string()),
        ("//grasshopper/", "", body.to_string()),
        ("/grasshopper", "", format!("[{body}]")),
        ("/grasshopper", "", format!("\u{feff}{body}")),
        ("/grasshopper", "", shouted.to_string()),
    ] {
        let answer = compute.ask("POST", path, headers, body.as_bytes()).await;
        assert_eq!(answer.status, 200, "{path} {headers} {}", answer.text());
        assert_eq!(answer.output("RH_OUT:sum"), 7.0, "{path} {headers}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn what_a_definition_asks_for_and_gives() {
    let compute = Compute::start().await;
    let answer = compute.post("/io", &json!({"algo": gh(SUM), "pointer": null})).await;
    assert_eq!(answer.status, 200, "{}", answer.text());
    let io = answer.json();
    assert_eq!(io["InputNames"], json!(["RH_IN:A", "RH_IN:B"]));
    assert_eq!(io["OutputNames"], json!(["RH_OUT:sum"]));
    let key = io["CacheKey"].as_str().unwrap();
    let same = compute.get(&format!("/io?Pointer={key}")).await;
    assert_eq!(same.json(), io);
    for path in ["/io", "/io?pointer=", "/io?other=1"] {
        let answer = compute.get(path).await;
        assert_eq!(answer.status, 400);
        assert_eq!(answer.json()["error"], "GET /io needs a Pointer query parameter.");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn what_the_server_says_of_itself() {
    let compute = Compute::start().await;
    let text = async |path: &str| {
        let answer = compute.get(path).await;
        assert_eq!(answer.status, 200, "{path}: {}", answer.text());
        assert_eq!(answer.header("content-length"), answer.body.len().to_string(), "{path}");
        answer.text()
    };
    assert_eq!(text("/idlespan").await, "-1");
    assert_eq!(text("/healthcheck").await, "Healthy");
    let version: serde_json::Value = serde_json::from_str(&text("/version").await).unwrap();
    assert!(version["rhino"].as_str().unwrap().starts_with("8."));
    assert!(version["compute"].is_string() && version["git_sha"].is_null());
    let time: String = serde_json::from_str(&text("/servertime").await).unwrap();
    assert!(time.starts_with("20") && time.ends_with('Z') && time.len() == 28, "{time}");
    assert!(text("/activechildren").await.parse::<u32>().unwrap() > 0);
    assert_eq!(text("/").await, "compute.rhino3d");
    assert!(text("/robots.txt").await.contains("Disallow: /"));
    assert_eq!(text("/favicon.ico").await, "Handled");
    assert_eq!(text("/validate").await, "Valid (no API key configured)");
    assert!(text("/sdk").await.contains("<html"));
    assert!(text("/docs").await.contains("<html"));
    for path in ["/plugins/rhino/installed", "/plugins/gh/installed"] {
        let plugins: serde_json::Value = serde_json::from_str(&text(path).await).unwrap();
        assert!(plugins.is_object());
    }
    compute.solve(&gh(SUM), json!([])).await;
    assert!(text("/idlespan").await.parse::<u32>().unwrap() < 60);
    let metrics = text("/metrics").await;
    for line in [
        "katydid_requests_total{path=\"/version\",status=\"200\"} 1",
        "katydid_solves_total{outcome=\"ok\"} 1",
        "katydid_request_seconds_bucket{path=\"/version\",le=\"+Inf\"} 1",
    ] {
        assert!(metrics.lines().any(|own| own == line), "{line} is not in\n{metrics}");
    }
    let openapi: serde_json::Value = serde_json::from_str(&text("/openapi.json").await).unwrap();
    assert!(openapi["openapi"].as_str().unwrap().starts_with("3."));
    assert!(openapi["paths"]["/grasshopper"]["post"].is_object());
    assert_eq!(compute.post("/script/evaluate", &json!({})).await.status, 403);
    let missing = compute.post("/rhino/python/evaluate", &json!([])).await;
    assert_eq!(missing.status, 501);
    assert!(missing.json()["error"].as_str().unwrap().contains("rhino/python/evaluate"));
}

#[tokio::test(flavor = "multi_thread")]
async fn the_key_is_asked_for() {
    let key = "a secret of many letters".to_owned();
    let compute = Compute::start_with(|config| Config { key: Some(key.clone()), ..config }).await;
    let with = |key: &str| format!("RhinoComputeKey: {key}\r\n");
    for path in ["/version", "/healthcheck", "/", "/metrics", "/nowhere", "/io?pointer=x"] {
        let answer = compute.get(path).await;
        assert_eq!((answer.status, answer.text().as_str()), (401, "Api Key was not provided."), "{path}");
    }
    for wrong in ["wrong", "", &key[1..], &format!("{key}, {key}"), &format!("{key}x")] {
        let answer = compute.ask("POST", "/grasshopper", &with(wrong), b"{}").await;
        assert_eq!((answer.status, answer.text().as_str()), (401, "Unauthorized client."), "{wrong}");
    }
    let twice = with(&key).repeat(2);
    assert_eq!(compute.ask("GET", "/version", &twice, b"").await.status, 401);
    let valid = compute.ask("GET", "/validate", &with(&key), b"").await;
    assert_eq!((valid.status, valid.text().as_str()), (200, "Valid"));
    let old = "rhinocomputekey: a secret of many letters\r\nAuthorization: Bearer x\r\n";
    assert_eq!(compute.ask("GET", "/version", old, b"").await.status, 200);
    let asked = "Origin: https://a.example\r\nAccess-Control-Request-Method: POST\r\n\
        Access-Control-Request-Headers: rhinocomputekey,content-type\r\n";
    let answer = compute.ask("OPTIONS", "/grasshopper", asked, b"").await;
    assert_eq!(answer.status, 204);
    assert_eq!(answer.header("access-control-allow-headers"), "rhinocomputekey,content-type");
    assert_eq!(answer.header("access-control-allow-origin"), "*");
    assert!(answer.header("access-control-allow-methods").contains("POST"));
    for path in ["/docs", "/openapi.json", "/robots.txt"] {
        assert_eq!(compute.get(path).await.status, 200, "{path}");
    }
    let open = Config { address: [0, 0, 0, 0].into(), port: 0, ..Config::default() };
    for key in [None, Some(String::new()), Some("  ".to_owned())] {
        let refused = katydid_server::compute::start(Config { key, ..open.clone() }).await;
        assert!(refused.unwrap_err().to_string().contains("key"));
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn pages_of_other_sites() {
    let page = "Origin: https://a.example\r\n";
    let everybody = vec!["*".to_owned()];
    let compute = Compute::start_with(|config| Config { origins: everybody, ..config }).await;
    for (method, path) in [("GET", "/version"), ("POST", "/grasshopper"), ("GET", "/nowhere")] {
        let answer = compute.ask(method, path, page, b"").await;
        assert_eq!(answer.header("access-control-allow-origin"), "*", "{path}");
        assert!(answer.header("access-control-expose-headers").contains("Server-Timing"));
    }
    let named = vec!["https://a.example".to_owned()];
    let compute = Compute::start_with(|config| Config { origins: named, ..config }).await;
    let answer = compute.ask("GET", "/version", page, b"").await;
    assert_eq!(answer.header("access-control-allow-origin"), "https://a.example");
    assert_eq!(answer.header("vary"), "Origin");
    let answer = compute.ask("GET", "/version", "Origin: https://b.example\r\n", b"").await;
    assert_eq!((answer.status, answer.header("access-control-allow-origin")), (403, ""));
}

#[tokio::test(flavor = "multi_thread")]
async fn without_a_key_pages_of_this_machine_alone_may_ask() {
    let compute = Compute::start().await;
    let body = json!({"algo": gh(SUM), "values": [input("RH_IN:A", "0", &[json!(1)])]}).to_string();
    let post = |headers: String| {
        let (compute, body) = (&compute, &body);
        async move { compute.ask("POST", "/grasshopper", &headers, body.as_bytes()).await }
    };
    for origin in ["https://evil.example", "null", "http://localhost.evil.example", "http://192.168.0.7"] {
        let answer = post(format!("Origin: {origin}\r\n")).await;
        assert_eq!((answer.status, answer.header("access-control-allow-origin")), (403, ""), "{origin}");
        assert!(answer.is_refused(), "{}", answer.text());
        let asked = format!("Origin: {origin}\r\nAccess-Control-Request-Method: POST\r\n");
        let answer = compute.ask("OPTIONS", "/grasshopper", &asked, b"").await;
        assert_eq!(answer.header("access-control-allow-origin"), "", "{origin}");
    }
    for origin in ["http://localhost:3000", "http://127.0.0.1:8080", "http://[::1]:5173"] {
        let answer = post(format!("Origin: {origin}\r\n")).await;
        assert_eq!((answer.status, answer.header("access-control-allow-origin")), (200, origin), "{origin}");
    }
    assert_eq!(post(String::new()).await.status, 200);
    assert_eq!(post("Sec-Fetch-Site: cross-site\r\n".to_owned()).await.status, 403);
    assert_eq!(compute.ask("GET", "/docs", "Sec-Fetch-Site: cross-site\r\n", b"").await.status, 200);
}

#[tokio::test(flavor = "multi_thread")]
async fn requests_have_ids() {
    let compute = Compute::start().await;
    let given = compute.ask("GET", "/version", "X-Request-Id: abc-1.2\r\n", b"").await;
    assert_eq!(given.header("x-request-id"), "abc-1.2");
    let none = compute.get("/nowhere").await;
    assert_eq!((none.status, none.header("x-request-id").len()), (404, 32));
    for bad in ["a b", "<script>", &"x".repeat(200)] {
        let answer = compute.ask("GET", "/version", &format!("X-Request-Id: {bad}\r\n"), b"").await;
        assert_eq!(answer.header("x-request-id").len(), 32, "{bad}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn packed_both_ways() {
    use std::io::{Read, Write};
    let compute = Compute::start().await;
    let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    let body = json!({"algo": gh(SUM), "values": [input("RH_IN:A", "0", &[json!(1)])]}).to_string();
    packer.write_all(body.as_bytes()).unwrap();
    let packed = packer.finish().unwrap();
    let answer = compute.ask("POST", "/grasshopper", "Content-Encoding: gzip\r\n", &packed).await;
    assert_eq!(answer.output("RH_OUT:sum"), 4.0);
    assert!(compute.ask("POST", "/grasshopper", "Content-Encoding: gzip\r\n", b"{}").await.is_refused());
    assert_eq!(compute.ask("POST", "/grasshopper", "Content-Encoding: br\r\n", b"{}").await.status, 415);
    let plain = compute.get("/openapi.json").await;
    let answer = compute.ask("GET", "/openapi.json", "Accept-Encoding: gzip, deflate\r\n", b"").await;
    assert_eq!(answer.header("content-encoding"), "gzip");
    assert_eq!(answer.header("content-length"), answer.body.len().to_string());
    let mut text = Vec::new();
    flate2::read::GzDecoder::new(answer.body.as_slice()).read_to_end(&mut text).unwrap();
    assert_eq!(text, plain.body);
    let answer = compute.ask("GET", "/openapi.json", "Accept-Encoding: gzip;q=0\r\n", b"").await;
    assert_eq!(answer.header("content-encoding"), "");
}

#[tokio::test(flavor = "multi_thread")]
async fn connections_stay_and_requests_may_follow_one_another_at_once() {
    let compute = Compute::start().await;
    let mut stream = compute.connect().await;
    let mut heard = Vec::new();
    let request = |a: usize| {
        let body = json!({"algo": gh(SUM), "values": [input("RH_IN:A", "0", &[json!(a)])]}).to_string();
        let host = compute.host();
        format!("POST /grasshopper HTTP/1.1\r\nHost: {host}\r\nContent-Length: {}\r\n\r\n{body}", body.len())
    };
    for a in 0..20 {
        stream.write_all(request(a).as_bytes()).await.unwrap();
        let answer = next(&mut stream, &mut heard).await;
        assert_eq!(answer.output("RH_OUT:sum"), a as f64 + 3.0);
    }
    let all: String = (0..20).map(request).collect();
    stream.write_all(all.as_bytes()).await.unwrap();
    for a in 0..20 {
        let answer = next(&mut stream, &mut heard).await;
        assert_eq!(answer.output("RH_OUT:sum"), a as f64 + 3.0, "in the order they came");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn other_methods_are_refused() {
    let compute = Compute::start().await;
    for (method, path, allowed) in [
        ("GET", "/grasshopper", "POST, OPTIONS"),
        ("PUT", "/grasshopper", "POST, OPTIONS"),
        ("DELETE", "/version", "GET, HEAD, OPTIONS"),
        ("PATCH", "/io", "GET, POST, HEAD, OPTIONS"),
    ] {
        let answer = compute.ask(method, path, "", b"").await;
        assert_eq!((answer.status, answer.header("allow")), (405, allowed), "{method} {path}");
        assert!(answer.is_refused());
    }
    compute.is_well().await;
}
