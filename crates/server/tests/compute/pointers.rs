//! Definitions that lie elsewhere.

use std::io::Write;
use std::net::SocketAddr;
use std::time::Duration;

use katydid_server::compute::Config;
use serde_json::json;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpListener;
use tokio::time::Instant;

use crate::client::{Answer, Compute};
use crate::definitions::{SUM, bytes};

/// A host with definitions, and with traps.
async fn host() -> SocketAddr {
    let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let address = listener.local_addr().unwrap();
    tokio::spawn(async move {
        loop {
            let (mut stream, _) = listener.accept().await.unwrap();
            tokio::spawn(async move {
                let mut head = vec![0; 4096];
                let read = stream.read(&mut head).await.unwrap();
                let head = String::from_utf8_lossy(&head[..read]).into_owned();
                let path = head.split(' ').nth(1).unwrap_or_default().to_owned();
                let definition = bytes(SUM);
                let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
                packer.write_all(&definition).unwrap();
                let packed = packer.finish().unwrap();
                let (status, headers, body) = match path.as_str() {
                    "/sum.gh" => ("200 OK", "", definition),
                    "/packed.gh" => ("200 OK", "Content-Encoding: gzip\r\n", packed),
                    "/packed-file.gh" => ("200 OK", "", packed),
                    "/away" => ("302 Found", "Location: /sum.gh\r\n", Vec::new()),
                    "/page" => ("200 OK", "", b"<html>".to_vec()),
                    "/huge" => ("200 OK", "X: y\r\n", vec![0; 3 << 20]),
                    "/slow" => {
                        let _ = stream.write_all(b"HTTP/1.1 200 OK\r\nContent-Length: 9999\r\n\r\n").await;
                        loop {
                            tokio::time::sleep(Duration::from_millis(50)).await;
                            if stream.write_all(b"x").await.is_err() {
                                return;
                            }
                        }
                    }
                    _ => ("404 Not Found", "", Vec::new()),
                };
                let length = body.len();
                let head = format!("HTTP/1.1 {status}\r\n{headers}Content-Length: {length}\r\n\r\n");
                let _ = stream.write_all(&[head.as_bytes(), &body].concat()).await;
                // What is dropped with bytes unread resets the connection, before the answer is read.
                let _ = stream.shutdown().await;
                let _ = tokio::io::copy(&mut stream, &mut tokio::io::sink()).await;
            });
        }
    });
    address
}

/// A host of files at an address that is free.
pub(crate) async fn host_of(files: impl Fn(&str) -> Option<Vec<u8>> + Clone + Send + 'static) -> SocketAddr {
    let address = TcpListener::bind("127.0.0.1:0").await.unwrap().local_addr().unwrap();
    host_at(address, files).await;
    address
}

/// The same at a given address.
pub(crate) async fn host_at(
    address: SocketAddr,
    files: impl Fn(&str) -> Option<Vec<u8>> + Clone + Send + 'static,
) {
    let listener = TcpListener::bind(address).await.unwrap();
    tokio::spawn(async move {
        loop {
            let (mut stream, _) = listener.accept().await.unwrap();
            let files = files.clone();
            tokio::spawn(async move {
                let mut head = vec![0; 4096];
                let read = stream.read(&mut head).await.unwrap_or(0);
                let head = String::from_utf8_lossy(&head[..read]).into_owned();
                let (status, body) = match files(head.split(' ').nth(1).unwrap_or_default()) {
                    Some(body) => ("200 OK", body),
                    None => ("404 Not Found", Vec::new()),
                };
                let head = format!(
                    "HTTP/1.1 {status}\r\nConnection: close\r\nContent-Length: {}\r\n\r\n",
                    body.len()
                );
                let _ = stream.write_all(&[head.as_bytes(), &body].concat()).await;
            });
        }
    });
}

async fn ask(compute: &Compute, pointer: &str) -> Answer {
    compute.post("/grasshopper", &json!({"algo": null, "pointer": pointer, "values": []})).await
}

#[tokio::test(flavor = "multi_thread")]
async fn hosts_that_are_listed_are_asked() {
    let host = host().await;
    let hosts = vec![host.to_string()];
    let compute = Compute::start_with(|config| Config {
        hosts,
        most_body: 1 << 20,
        timeout: Duration::from_secs(2),
        ..config
    })
    .await;
    for path in ["sum.gh", "packed.gh", "packed-file.gh"] {
        let answer = ask(&compute, &format!("http://{host}/{path}")).await;
        assert_eq!(answer.status, 200, "{path}: {}", answer.text());
        assert_eq!(answer.output("RH_OUT:sum"), 5.0);
        let io = compute.get(&format!("/io?pointer=http%3A%2F%2F{host}%2F{path}")).await;
        assert_eq!(io.json()["InputNames"], json!(["RH_IN:A", "RH_IN:B"]), "{path}");
    }
    for (path, status) in [("away", 403), ("none", 404), ("page", 400), ("huge", 413), ("slow", 408)] {
        let start = Instant::now();
        let answer = ask(&compute, &format!("http://{host}/{path}")).await;
        assert_eq!(answer.status, status, "{path}: {}", answer.text());
        assert!(answer.is_refused() && start.elapsed() < Duration::from_secs(10), "{path}");
    }
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn nobody_else_is_asked_and_no_file_is_read() {
    let host = host().await;
    let compute = Compute::start().await;
    assert_eq!(ask(&compute, &format!("http://{host}/sum.gh")).await.status, 403);
    let names = vec!["files.example".to_owned(), "private.localhost.example".to_owned()];
    let listed = Compute::start_with(|config| Config { hosts: names, ..config }).await;
    let own = listed.host();
    for pointer in [
        "/etc/passwd".to_owned(),
        "C:\\Users\\me\\x.gh".to_owned(),
        "..%2f..%2fetc%2fpasswd".to_owned(),
        "../../etc/passwd".to_owned(),
        "file:///etc/passwd".to_owned(),
        "\\\\host\\share\\x.gh".to_owned(),
        "md5_../../x".to_owned(),
        format!("md5_{}", "A".repeat(100)),
        "md5_".to_owned(),
        "http://169.254.169.254/latest/meta-data".to_owned(),
        "http://[::ffff:169.254.169.254]/".to_owned(),
        "http://2852039166/".to_owned(),
        "http://0x7f000001/".to_owned(),
        "http://localhost:9/none.gh".to_owned(),
        "ftp://files.example/x.gh".to_owned(),
        "http://user:word@files.example/x.gh".to_owned(),
        format!("http://{own}/grasshopper"),
        format!("http://{host}/sum.gh"),
        format!("http://{}/", "a".repeat(100_000)),
        "00000000-0000-0000-0000-000000000000".to_owned(),
    ] {
        for server in [&compute, &listed] {
            let answer = ask(server, &pointer).await;
            assert!(answer.is_refused(), "{pointer:.80}: {} {}", answer.status, answer.text());
        }
    }
    compute.is_well().await;
}
