//! HTTP as nobody should speak it.

use std::time::Duration;

use katydid_server::compute::Config;
use serde_json::json;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::time::{Instant, sleep, timeout};

use crate::client::{Compute, WAIT, next, parsed};
use crate::definitions::{SUM, gh};

#[tokio::test(flavor = "multi_thread")]
async fn bodies_that_are_too_large() {
    let most = 1 << 20;
    let compute = Compute::start_with(|config| Config { most_body: most, ..config }).await;
    // One that a client sends whole before it listens.
    let answer = compute.ask("POST", "/grasshopper", "", &vec![b' '; most + 1]).await;
    assert_eq!(answer.status, 413);
    assert!(answer.is_refused() && answer.text().contains("1048576 bytes"));
    // One that is only announced.
    let start = Instant::now();
    let head = "POST /io HTTP/1.1\r\nHost: localhost\r\nContent-Length: 10737418240\r\n\r\n";
    assert_eq!(compute.raw(head.as_bytes()).await.status, 413);
    let head =
        "POST /jobs HTTP/1.1\r\nHost: localhost\r\nContent-Length: 2000000\r\nExpect: 100-continue\r\n\r\n";
    assert_eq!(compute.raw(head.as_bytes()).await.status, 413);
    assert!(start.elapsed() < Duration::from_secs(5));
    // One that does not say how long it is.
    let mut request =
        b"POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nTransfer-Encoding: chunked\r\n\r\n"
            .to_vec();
    for _ in 0..40 {
        request.extend_from_slice(b"10000\r\n");
        request.extend_from_slice(&[b' '; 0x10000]);
        request.extend_from_slice(b"\r\n");
    }
    request.extend_from_slice(b"0\r\n\r\n");
    assert_eq!(compute.raw(&request).await.status, 413);
    // A gigabyte in a megabyte.
    let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
    for _ in 0..900 {
        std::io::Write::write_all(&mut packer, &vec![b' '; 1 << 20]).unwrap();
    }
    let bomb = packer.finish().unwrap();
    assert!(bomb.len() < most);
    let answer = compute.ask("POST", "/grasshopper", "Content-Encoding: gzip\r\n", &bomb).await;
    assert_eq!(answer.status, 413, "{}", answer.text());
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn bodies_that_come_in_pieces_or_not_at_all() {
    let compute = Compute::start_with(|config| Config { timeout: Duration::from_secs(2), ..config }).await;
    let body = json!({"algo": gh(SUM)}).to_string();
    let mut stream = compute.connect().await;
    let head = "POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n";
    stream.write_all(head.as_bytes()).await.unwrap();
    let pieces: String = body.chars().map(|one| format!("1\r\n{one}\r\n")).collect();
    stream.write_all(pieces.as_bytes()).await.unwrap();
    stream.write_all(b"0\r\n\r\n").await.unwrap();
    let mut heard = Vec::new();
    assert_eq!(next(&mut stream, &mut heard).await.output("RH_OUT:sum"), 5.0);
    // It waits to be told to go on.
    let mut stream = compute.connect().await;
    let head = format!(
        "POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nExpect: 100-continue\r\nContent-Length: {}\r\n\r\n",
        body.len()
    );
    stream.write_all(head.as_bytes()).await.unwrap();
    let mut go_on = [0; 25];
    timeout(WAIT, stream.read_exact(&mut go_on)).await.unwrap().unwrap();
    assert_eq!(&go_on, b"HTTP/1.1 100 Continue\r\n\r\n");
    stream.write_all(body.as_bytes()).await.unwrap();
    let mut heard = Vec::new();
    assert_eq!(next(&mut stream, &mut heard).await.status, 200);
    // More is announced than comes.
    let start = Instant::now();
    let mut stream = compute.connect().await;
    let head =
        format!("POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nContent-Length: {}\r\n\r\n{body}", 9999);
    stream.write_all(head.as_bytes()).await.unwrap();
    let mut heard = Vec::new();
    assert_eq!(next(&mut stream, &mut heard).await.status, 408);
    assert!(start.elapsed() < Duration::from_secs(10));
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn heads_that_make_no_sense() {
    let compute = Compute::start().await;
    let long = "x".repeat(100_000);
    let many: String = (0..500).map(|n| format!("h{n}: 1\r\n")).collect();
    for head in [
        format!("GET /version HTTP/1.1\r\nHost: localhost\r\nLong: {long}\r\n\r\n"),
        format!("GET /{long} HTTP/1.1\r\nHost: localhost\r\n\r\n"),
        format!("GET /version HTTP/1.1\r\n{many}\r\n"),
        "POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nContent-Length: -1\r\n\r\n".to_owned(),
        "POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1\r\nContent-Length: 2\r\n\r\nab"
            .to_owned(),
        "GRASSHOPPER\r\n\r\n".to_owned(),
        "\x16\x03\x01\x02\x00\x01\x00\x01\u{fc}\x03\x03".to_owned() + "\r\n\r\n",
    ] {
        let mut stream = compute.connect().await;
        let _ = stream.write_all(head.as_bytes()).await;
        let mut bytes = Vec::new();
        let _ = timeout(WAIT, stream.read_to_end(&mut bytes)).await.expect("an end");
        if let Some((answer, _)) = parsed(&bytes) {
            // A long head may be taken; one that makes no sense is not.
            let is_long = head.len() > 1000;
            assert!(is_long || (400..500).contains(&answer.status), "{head:.60}: {}", answer.status);
        }
    }
    // A hundred that never finish their heads hold up nobody.
    let mut slow = Vec::new();
    for _ in 0..100 {
        let mut stream = compute.connect().await;
        stream.write_all(b"POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nX-").await.unwrap();
        slow.push(stream);
    }
    let start = Instant::now();
    compute.is_well().await;
    assert!(start.elapsed() < Duration::from_secs(5));
    sleep(Duration::from_millis(50)).await;
    let mut stream = compute.connect().await;
    stream
        .write_all(b"HEAD /version HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
        .await
        .unwrap();
    let mut bytes = Vec::new();
    timeout(WAIT, stream.read_to_end(&mut bytes)).await.unwrap().unwrap();
    assert!(bytes.starts_with(b"HTTP/1.1 200") && bytes.ends_with(b"\r\n\r\n"), "a head and no body");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_request_that_says_its_length_twice_is_refused() {
    let compute = Compute::start().await;
    let body = json!({"algo": gh(SUM)}).to_string();
    let (length, pieces) = (format!("Content-Length: {}\r\n", body.len()), "Transfer-Encoding: chunked\r\n");
    let chunked = format!("{:x}\r\n{body}\r\n0\r\n\r\n", body.len());
    let smuggled = "GET /version HTTP/1.1\r\nHost: localhost\r\n\r\n";
    for (fields, sent) in [
        (format!("{length}{pieces}"), chunked.as_str()),
        (format!("{pieces}{length}"), chunked.as_str()),
        (format!("{pieces}{length}"), body.as_str()),
        (format!("{pieces}content-length: 0\r\n"), "0\r\n\r\n"),
        (format!("Content-Length: {}\r\n{pieces}", 5 + smuggled.len()), &format!("0\r\n\r\n{smuggled}")),
    ] {
        // First on its connection, and behind a good request.
        for before in
            [String::new(), format!("POST /grasshopper HTTP/1.1\r\nHost: localhost\r\n{length}\r\n{body}")]
        {
            let mut stream = compute.connect().await;
            let mut heard = Vec::new();
            if !before.is_empty() {
                stream.write_all(before.as_bytes()).await.unwrap();
                assert_eq!(next(&mut stream, &mut heard).await.status, 200);
            }
            let request = format!("POST /grasshopper HTTP/1.1\r\nHost: localhost\r\n{fields}\r\n{sent}");
            stream.write_all(request.as_bytes()).await.unwrap();
            let answer = next(&mut stream, &mut heard).await;
            assert_eq!(answer.status, 400, "{fields}: {}", answer.text());
            assert!(answer.is_refused() && answer.text().contains("Content-Length and Transfer-Encoding"));
            // What comes behind it is not answered.
            let mut rest = Vec::new();
            let _ = timeout(WAIT, stream.read_to_end(&mut rest)).await.expect("it is closed");
            assert!(rest.is_empty(), "{}", String::from_utf8_lossy(&rest));
        }
    }
    compute.is_well().await;
}
