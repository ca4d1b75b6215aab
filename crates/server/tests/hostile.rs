//! Pages of other sites, requests that make no sense, definitions without end: refused, and the server goes on.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::net::{IpAddr, Ipv4Addr};
use std::time::Duration;

use common::{Studio, WAIT, is_done, refusal};
use katydid_session::protocol::{Ask, Edit, Event, Setting};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;
use tokio::time::{Instant, timeout};
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::tungstenite::{Error, Message};

const EMPTY: &str = "katydid 1\nr = Number Slider(2.0, 0..10)\nshown = Panel(r)\n";
/// A formula that may give a text, so that it is worked out item by item.
const SLOW: &str = r#""if(x > -1e9, sin(x) * cos(x) + sqrt(abs(x)), \"\")""#;
/// Minutes of work, in steps of a second each.
const ENDLESS: &str = "katydid 1\nn = Number Slider(4000000.0, 0..9000000)\ns = Series(0, 1, n)\n";

fn endless() -> String {
    let mut text = ENDLESS.to_owned();
    let mut last = "s".to_owned();
    for k in 0..200 {
        let next = format!("e{k}");
        text.push_str(&format!("{next} = Expression({SLOW}, x = {last})\n"));
        last = next;
    }
    text
}

#[tokio::test(flavor = "multi_thread")]
async fn pages_of_other_sites_get_no_socket() {
    let studio = Studio::start().await;
    let id = studio.upload(EMPTY).await;
    let url = studio.socket(&id);
    for (header, value) in [
        ("origin", "https://evil.example"),
        ("origin", "null"),
        ("origin", "http://127.0.0.1:1"),
        ("host", "evil.example"),
        ("sec-fetch-site", "cross-site"),
    ] {
        let mut request = url.as_str().into_client_request().unwrap();
        request.headers_mut().insert(header, value.parse().unwrap());
        match tokio_tungstenite::connect_async(request).await {
            Err(Error::Http(response)) => assert_eq!(response.status(), 403, "{header}: {value}"),
            other => panic!("{header}: {value}: {other:?}"),
        }
    }
    let mut request = url.as_str().into_client_request().unwrap();
    request.headers_mut().insert("origin", format!("http://{}", studio.host()).parse().unwrap());
    assert!(tokio_tungstenite::connect_async(request).await.is_ok());
    let nobody = studio.socket("none");
    assert!(
        matches!(tokio_tungstenite::connect_async(nobody).await, Err(Error::Http(r)) if r.status() == 404)
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn names_that_were_made_to_point_here_are_refused() {
    let studio = Studio::start().await;
    for host in ["evil.example", "evil.example:6510", "10.0.0.1"] {
        let request = format!("GET /api/start HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
        assert_eq!(studio.raw(request.as_bytes()).await.status, 403, "{host}");
    }
    let request = "GET /api/start HTTP/1.1\r\nConnection: close\r\n\r\n";
    assert!((400..500).contains(&studio.raw(request.as_bytes()).await.status));
    let answer = studio.ask("POST", "/api/open", "Origin: https://evil.example\r\n", b"{\"new\":true}").await;
    assert_eq!(answer.status, 403);
    assert!(answer.head.to_lowercase().contains("content-security-policy: default-src 'self'"));
    assert!(!answer.head.to_lowercase().contains("access-control-allow"));
}

#[tokio::test(flavor = "multi_thread")]
async fn a_gigabyte_is_refused_before_it_is_sent() {
    let studio = Studio::start().await;
    let (host, cookie) = (studio.host(), studio.cookie());
    let start = Instant::now();
    let request = format!(
        "POST /api/upload?name=a.gh HTTP/1.1\r\nHost: {host}\r\n{cookie}Connection: close\r\nContent-Length: 1073741824\r\n\r\n"
    );
    let answer = studio.raw(request.as_bytes()).await;
    assert_eq!(answer.status, 413);
    assert!(
        answer.json()["error"].as_str().unwrap().contains("MB") && start.elapsed() < Duration::from_secs(5)
    );
    // Who does not say how much comes is stopped on the way.
    let studio = Studio::start_with(|config| katydid_server::Config { most_upload: 1 << 20, ..config }).await;
    let mut stream = TcpStream::connect(studio.server.address()).await.unwrap();
    let (host, cookie) = (studio.host(), studio.cookie());
    let head = format!(
        "POST /api/upload?name=a.gh HTTP/1.1\r\nHost: {host}\r\n{cookie}Connection: close\r\nTransfer-Encoding: chunked\r\n\r\n"
    );
    stream.write_all(head.as_bytes()).await.unwrap();
    let chunk = [b"10000\r\n".as_slice(), &[0; 0x10000], b"\r\n"].concat();
    let mut sent = 0;
    while sent < 1 << 30 && stream.write_all(&chunk).await.is_ok() {
        sent += 0x10000;
    }
    assert!(sent < 64 << 20, "{sent} bytes were taken");
    let question = vec![b' '; 1 << 20];
    assert_eq!(
        studio.ask("POST", "/api/open", "Content-Type: application/json\r\n", &question).await.status,
        413
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn requests_that_make_no_sense() {
    let studio = Studio::start().await;
    for body in [
        "",
        "{}",
        "[]",
        "{\"path\":1}",
        "{\"path\":\"/etc/passwd\"}",
        "{\"gallery\":\"../V1\"}",
        "{\"new\":false}",
    ] {
        let answer = studio.post_json("/api/open", body).await;
        assert!((400..500).contains(&answer.status), "{body}: {}", answer.status);
        assert!(answer.json()["error"].is_string(), "{body}");
    }
    let deep = "[".repeat(100_000);
    assert!((400..500).contains(&studio.post_json("/api/open", &deep[..60_000]).await.status));
    for name in ["a.exe", "", "a", "..", "%2e%2e%2fa.kd"] {
        let answer = studio.ask("POST", &format!("/api/upload?name={name}"), "", b"katydid 9").await;
        assert!((400..500).contains(&answer.status), "{name}");
    }
    for path in [
        "/../../etc/passwd",
        "/..%2f..%2fetc/passwd",
        "/assets/../../Cargo.toml",
        "/%2e%2e/%2e%2e/etc/passwd",
        "//etc/passwd",
        "/.git/config",
        "/assets/..\\..\\Cargo.toml",
        "/geometry/..%2f..%2fetc%2fpasswd",
        "/api/../api/none",
    ] {
        let answer = studio.get(path).await;
        assert!((400..500).contains(&answer.status), "{path}: {}", answer.status);
        assert!(!String::from_utf8_lossy(&answer.body).contains("root:"), "{path}");
    }
    for method in ["PUT", "DELETE", "PATCH", "OPTIONS"] {
        assert!((400..500).contains(&studio.ask(method, "/api/open", "", b"").await.status), "{method}");
        assert!((400..500).contains(&studio.ask(method, "/", "", b"").await.status), "{method}");
    }
    let long = format!("X-Long: {}\r\n", "a".repeat(200_000));
    assert!((400..500).contains(&studio.ask("GET", "/api/start", &long, b"").await.status));
    assert_eq!(studio.get("/api/start").await.status, 200);
}

#[tokio::test(flavor = "multi_thread")]
async fn frames_that_make_no_sense() {
    let studio = Studio::start().await;
    let mut client = studio.with(EMPTY).await;
    for text in
        ["", "null", "{", "{\"seq\":7,\"ask\":{\"ask\":\"fly\"}}", "{\"seq\":-1}", &"[".repeat(1_000_000)]
    {
        client.send(Message::Text(text.into())).await;
        let reason = loop {
            if let Some(Event::Refused { reason, .. }) = client.hear().await {
                break reason;
            }
        };
        assert!(!reason.is_empty());
    }
    client.send(Message::Text("{\"seq\":7,\"ask\":{\"ask\":\"fly\"}}".into())).await;
    while !matches!(client.hear().await, Some(Event::Refused { seq: 7, .. })) {}
    client.send(Message::Binary(vec![0; 100].into())).await;
    while !client.notices.iter().any(|text| text.contains("only text")) {
        client.hear().await;
    }
    assert!(is_done(&client.set("r", 4.0).await));
    // A frame beyond all measure ends this connection, and no other.
    let mut giant = studio.join(&studio.upload(EMPTY).await).await;
    giant.send(Message::Text(" ".repeat(10 << 20).into())).await;
    let big = "a".repeat(17 << 20);
    let _ = timeout(Duration::from_secs(20), giant.send_or_fail(Message::Text(big.into()))).await;
    assert!(is_done(&client.set("r", 5.0).await));
    // Bytes that are no frames at all.
    let mut stream = TcpStream::connect(studio.server.address()).await.unwrap();
    let id = studio.upload(EMPTY).await;
    let head = format!(
        "GET /socket?document={id} HTTP/1.1\r\nHost: {}\r\n{}Connection: Upgrade\r\nUpgrade: websocket\r\n\
         Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
        studio.host(),
        studio.cookie()
    );
    stream.write_all(head.as_bytes()).await.unwrap();
    stream.write_all(&[0xff; 10_000]).await.unwrap();
    let mut rest = Vec::new();
    timeout(WAIT, stream.read_to_end(&mut rest)).await.expect("closed").ok();
    assert!(is_done(&client.set("r", 6.0).await));
}

#[tokio::test(flavor = "multi_thread")]
async fn who_reads_slowly_hears_the_newest_and_holds_nobody_up() {
    let studio = Studio::start().await;
    let id = studio.upload(EMPTY).await;
    let mut slow = studio.join(&id).await;
    let mut quick = studio.join(&id).await;
    quick.solved(1).await;
    let slider = quick.named("r");
    for k in 0..3000 {
        let to = Setting::Number { value: f64::from(k % 100) / 10.0 };
        let event = quick.ask(Ask::Edit {
            edit: Edit::Set { object: slider, to },
            gesture: Some(k as u64 / 500),
            within: vec![],
        });
        assert!(is_done(&event.await));
    }
    quick.set("r", 1.5).await;
    let start = Instant::now();
    let mut heard = 0;
    while slow.texts_or_nothing("shown") != ["1.5"] {
        assert!(start.elapsed() < WAIT);
        slow.hear().await;
        heard += 1;
    }
    assert!(heard < 9000, "{heard} messages for 3000 changes");
}

#[tokio::test(flavor = "multi_thread")]
async fn who_never_reads_answers_is_not_heard_for_ever() {
    let studio = Studio::start().await;
    let mut deaf = studio.with(EMPTY).await;
    // As many as fit: what is not read holds up the one who does not read.
    let flood = async {
        loop {
            deaf.tell(Ask::Undo).await;
        }
    };
    let _ = timeout(Duration::from_secs(3), flood).await;
    let mut other = studio.with(EMPTY).await;
    assert!(is_done(&other.set("r", 4.0).await));
}

#[tokio::test(flavor = "multi_thread")]
async fn a_definition_without_end_can_be_cancelled() {
    let studio = Studio::start().await;
    let id = studio.upload(&endless()).await;
    let mut client = studio.join(&id).await;
    while client.results.len() < 3 {
        client.hear().await;
    }
    let start = Instant::now();
    let event = client.ask(Ask::Cancel).await;
    assert!(is_done(&event));
    eprintln!("answered after {:?}", start.elapsed());
    while client.finished == 0 {
        client.hear().await;
    }
    assert!(client.cancelled);
    eprintln!("cancelled after {:?}", start.elapsed());
    // A change that makes it short: solved at once.
    client.set("n", 10.0).await;
    let start = Instant::now();
    while client.cancelled || client.finished < 2 {
        assert!(start.elapsed() < WAIT);
        client.hear().await;
    }
    assert!(client.results.values().all(|result| result.status == "ok"));
}

#[tokio::test(flavor = "multi_thread")]
async fn a_newer_edit_gives_up_a_long_solve() {
    let studio = Studio::start().await;
    let id = studio.upload(&endless()).await;
    let mut client = studio.join(&id).await;
    while client.results.len() < 3 {
        client.hear().await;
    }
    let start = Instant::now();
    assert!(is_done(&client.set("n", 5.0).await));
    assert_eq!(client.finished, 0, "edits do not wait for the solve");
    let last = client.named("e199");
    while !(client.finished >= 1 && !client.cancelled && client.results.contains_key(&last)) {
        assert!(start.elapsed() < Duration::from_secs(8));
        client.hear().await;
    }
    eprintln!("a short solve after a long one: {:?}", start.elapsed());
}

#[tokio::test(flavor = "multi_thread")]
async fn ten_thousand_objects() {
    let studio = Studio::start().await;
    let mut text = "katydid 1\nr = Number Slider(2.0, 0..10)\n".to_owned();
    for k in 0..10_000 {
        text.push_str(&format!("p{k} = Construct Point(r, {k}, 0)\n"));
    }
    let start = Instant::now();
    let mut client = studio.with(&text).await;
    assert_eq!(client.objects.len(), 10_001);
    eprintln!("10,000 objects: open and solved in {:?}", start.elapsed());
    let start = Instant::now();
    client.set("r", 3.0).await;
    let answered = start.elapsed();
    let point = client.named("p9999");
    client.drawn(point).await;
    eprintln!("10,000 objects: answered in {answered:?}, drawn in {:?}", start.elapsed());
}

#[tokio::test(flavor = "multi_thread")]
async fn other_users_of_this_machine_get_nothing() {
    let studio = Studio::start().await;
    let id = studio.upload(EMPTY).await;
    let host = studio.host();
    for (method, path) in [
        ("GET", "/"),
        ("GET", "/api/start"),
        ("POST", "/api/open"),
        ("POST", "/api/upload?name=a.kd"),
        ("GET", &format!("/api/save?document={id}&format=kd")),
        ("GET", "/api/components"),
        ("GET", "/geometry/1"),
        ("GET", "/image/1"),
        ("GET", "/assets/index.js"),
        ("GET", &format!("/socket?document={id}")),
        ("GET", &format!("/socket?document={id}&token=wrong")),
    ] {
        let request = format!(
            "{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\nContent-Length: 0\r\n\r\n"
        );
        let answer = studio.raw(request.as_bytes()).await;
        assert_eq!(answer.status, 401, "{method} {path}");
        assert!(!answer.head.to_lowercase().contains("set-cookie"), "{method} {path}");
    }
    let url = format!("ws://{host}/socket?document={id}");
    assert!(matches!(tokio_tungstenite::connect_async(&url).await, Err(Error::Http(r)) if r.status() == 401));
    // The address that is printed lets in, and so does the one for the browser: once.
    for (address, times) in [(studio.server.url(), 3), (studio.server.opening(), 1)] {
        let path = address.strip_prefix(&format!("http://{host}")).unwrap();
        let request = format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
        for k in 0..4 {
            let is_in = studio.raw(request.as_bytes()).await.status != 401;
            assert_eq!(is_in, k < times || times > 1, "{k}");
        }
    }
    assert!(!studio.server.opening().contains("token"));
}

#[tokio::test(flavor = "multi_thread")]
async fn who_can_be_reached_by_others_wants_a_token_and_gives_no_files() {
    let studio = Studio::start_with(|config| katydid_server::Config {
        address: IpAddr::V4(Ipv4Addr::UNSPECIFIED),
        token: Some("open-sesame".to_owned()),
        ..config
    })
    .await;
    assert!(studio.server.url().ends_with("?token=open-sesame"));
    assert_eq!(studio.get("/api/start").await.status, 401);
    assert_eq!(studio.get("/api/start?token=open-sesam").await.status, 401);
    let start = studio.get("/api/start?token=open-sesame").await;
    assert_eq!((start.status, start.json()["local"].as_bool()), (200, Some(false)));
    let page = studio.get("/?token=open-sesame").await;
    assert!(page.head.contains("HttpOnly") && page.head.contains("SameSite=Strict"));
    let port = studio.server.address().port();
    let cookie = format!("Cookie: katydid_token_{port}=open-sesame\r\nContent-Type: application/json\r\n");
    let answer = studio.ask("POST", "/api/open", &cookie, b"{\"path\":\"/tmp/a.gh\"}").await;
    assert_eq!(answer.status, 403);
    let new = studio.ask("POST", "/api/open", &cookie, b"{\"new\":true}").await.json();
    let id = new["document"].as_str().unwrap();
    let url = format!("ws://{}/socket?document={id}", studio.host());
    assert!(matches!(tokio_tungstenite::connect_async(&url).await, Err(Error::Http(r)) if r.status() == 401));
    let mut client = studio.join(&format!("{id}&token=open-sesame")).await;
    let event = client.ask(Ask::Save { path: Some("/tmp/katydid-test.gh".to_owned()) }).await;
    assert!(refusal(&event).contains("download"));
}

#[tokio::test(flavor = "multi_thread")]
async fn half_a_request_does_not_stay() {
    let studio = Studio::start().await;
    let mut streams = Vec::new();
    for _ in 0..200 {
        let mut stream = TcpStream::connect(studio.server.address()).await.unwrap();
        stream.write_all(b"GET / HTTP/1.1\r\nHost:").await.unwrap();
        streams.push(stream);
    }
    assert_eq!(studio.get("/api/start").await.status, 200);
    let mut rest = Vec::new();
    let closed = timeout(Duration::from_secs(25), streams[0].read_to_end(&mut rest)).await;
    assert!(closed.is_ok(), "a head that never ends is not waited for");
}
