//! Definitions that call others, over the port.

use std::time::Duration;

use katydid_compute::HostKey;
use katydid_server::compute::Config;
use serde_json::json;
use tokio::net::TcpListener;
use tokio::time::Instant;

use crate::client::{Compute, input};
use crate::definitions::{bytes, gh};
use crate::pointers::host_of;

const DOUBLE: &str = "katydid 1\nn = Number()\nd = Addition(n, n)\n\"RH_IN:N\": n\n\"RH_OUT:D\": d\n";

/// A definition that hands a number on to what lies at an address.
fn calling(location: &str, output: &str) -> String {
    format!(
        "katydid 1\nn = Number()\nh = Hops(N = n) variable -> {output} {{ RemoteDefinitionLocation = \"{location}\" }}\n\
         x = Data(h)\n\"RH_IN:N\": n\n\"RH_OUT:x\": x\n"
    )
}

#[tokio::test(flavor = "multi_thread")]
async fn definitions_elsewhere_are_solved_here_or_by_another_server() {
    let files = host_of(|path| (path == "/double.gh").then(|| bytes(DOUBLE))).await;
    let algo = gh(&calling(&format!("http://{files}/double.gh"), "D"));
    let values = || json!([input("RH_IN:N", "{0}", &[json!(4)])]);
    let here = Compute::start_with(|config| Config { hosts: vec![files.to_string()], ..config }).await;
    let answer = here.solve(&algo, values()).await;
    assert_eq!((answer.status, answer.output("RH_OUT:x")), (200, json!(8.0)), "{}", answer.text());
    let url = format!("http://{}", here.host());
    let asking = Compute::start_with(|config| Config {
        hosts: vec![files.to_string(), here.host()],
        hops_server: Some(url),
        ..config
    })
    .await;
    let answer = asking.solve(&algo, values()).await;
    assert_eq!((answer.status, answer.output("RH_OUT:x")), (200, json!(8.0)), "{}", answer.text());
    // Nobody is listed: nobody is asked.
    let closed = Compute::start().await;
    let answer = closed.solve(&algo, values()).await;
    assert_eq!(answer.status, 500);
    assert!(answer.json()["errors"][0].as_str().unwrap().contains("nothing is fetched from elsewhere"));
}

/// Ten levels and no more, whether they are solved here or each is a request to the very server that asks.
#[tokio::test(flavor = "multi_thread")]
async fn definitions_that_call_themselves_come_to_an_end() {
    let files = TcpListener::bind("127.0.0.1:0").await.unwrap().local_addr().unwrap();
    let text = calling(&format!("http://{files}/self.gh"), "x");
    let held = text.clone();
    crate::pointers::host_at(files, move |path| (path == "/self.gh").then(|| bytes(&held))).await;
    let port = TcpListener::bind("127.0.0.1:0").await.unwrap().local_addr().unwrap().port();
    for server in [None, Some(format!("http://127.0.0.1:{port}"))] {
        let compute = Compute::start_with(|config| Config {
            port,
            hosts: vec![files.to_string(), format!("127.0.0.1:{port}")],
            hops_server: server.clone(),
            timeout: Duration::from_secs(30),
            ..config
        })
        .await;
        let start = Instant::now();
        let answer = compute.solve(&gh(&text), json!([input("RH_IN:N", "{0}", &[json!(1)])])).await;
        assert_eq!(answer.status, 500, "{}", answer.text());
        assert!(answer.text().contains("more than 10 times"), "{server:?}: {}", answer.text());
        assert!(start.elapsed() < Duration::from_secs(20), "{server:?}: {:?}", start.elapsed());
        compute.is_well().await;
        compute.server.stop().await;
    }
}

/// Two servers that solve for each other, each with a key of its own: the key goes along, and they come to an end.
#[tokio::test(flavor = "multi_thread")]
async fn servers_that_name_each_other_come_to_an_end() {
    let files = TcpListener::bind("127.0.0.1:0").await.unwrap().local_addr().unwrap();
    let itself = calling(&format!("http://{files}/self.gh"), "x");
    let held = itself.clone();
    crate::pointers::host_at(files, move |path| match path {
        "/self.gh" => Some(bytes(&held)),
        "/double.gh" => Some(bytes(DOUBLE)),
        _ => None,
    })
    .await;
    let mut ports = Vec::new();
    for _ in 0..2 {
        ports.push(TcpListener::bind("127.0.0.1:0").await.unwrap());
    }
    let ports: Vec<u16> = ports.into_iter().map(|port| port.local_addr().unwrap().port()).collect();
    let start = |own: u16, other: u16, keys: Vec<String>| {
        let other = format!("127.0.0.1:{other}");
        Compute::start_with(move |config| Config {
            port: own,
            key: Some(format!("key of {own}")),
            hosts: vec![files.to_string(), other.clone()],
            hops_server: Some(format!("http://{other}")),
            hops_keys: keys.iter().map(|key| HostKey::read(key).unwrap()).collect(),
            timeout: Duration::from_secs(30),
            ..config
        })
    };
    let key_of = |port: u16| format!("127.0.0.1:{port}=key of {port}");
    let [first, second] = [ports[0], ports[1]];
    let ours = start(first, second, vec![key_of(second)]).await;
    let theirs = start(second, first, vec![key_of(first)]).await;
    let ask = async |compute: &Compute, port: u16, text: &str| {
        let body = json!({"algo": gh(text), "values": [input("RH_IN:N", "{0}", &[json!(4)])]}).to_string();
        let key = format!("RhinoComputeKey: key of {port}\r\n");
        compute.ask("POST", "/grasshopper", &key, body.as_bytes()).await
    };
    let double = calling(&format!("http://{files}/double.gh"), "D");
    let answer = ask(&ours, first, &double).await;
    assert_eq!((answer.status, answer.output("RH_OUT:x")), (200, json!(8.0)), "{}", answer.text());
    let begin = Instant::now();
    for (compute, port) in [(&ours, first), (&theirs, second)] {
        let answer = ask(compute, port, &itself).await;
        assert_eq!(answer.status, 500, "{}", answer.text());
        assert!(answer.text().contains("more than 10 times"), "{}", answer.text());
        let health =
            compute.ask("GET", "/healthcheck", &format!("RhinoComputeKey: key of {port}\r\n"), b"").await;
        assert_eq!((health.status, health.text().as_str()), (200, "Healthy"));
    }
    assert!(begin.elapsed() < Duration::from_secs(25), "{:?}", begin.elapsed());
    // With a key of somebody else's it is sent away, and says so; the key is in no answer.
    ours.server.stop().await;
    let ours = start(first, second, vec![format!("127.0.0.1:{second}=key of nobody")]).await;
    let answer = ask(&ours, first, &double).await;
    assert_eq!(answer.status, 500);
    assert!(answer.text().contains("status 401") && !answer.text().contains("nobody"), "{}", answer.text());
}
