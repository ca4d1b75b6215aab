//! Definitions at https addresses: fetched from hosts that can show who they are, and from no others.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

mod common;

use std::io::{Read, Write};
use std::net::TcpListener;
use std::sync::Arc;
use std::time::Duration;

use common::Maker;
use katydid_component::Cancel;
use katydid_compute::{CacheControl, Cause, Compute, Fault, Settings, WebSettings};
use rustls::pki_types::{PrivateKeyDer, PrivatePkcs8KeyDer};
use rustls::{ServerConfig, ServerConnection, StreamOwned};

/// A definition that needs nothing.
fn definition() -> Vec<u8> {
    let mut maker = Maker::default();
    let pi = maker.named("Pi", "Pi");
    maker.out("RH_OUT:pi", pi);
    maker.document.to_gh().unwrap()
}

/// A host called localhost with a definition and a way elsewhere: its port, and the certificate to know it by.
fn host() -> (u16, String) {
    let made = rcgen::generate_simple_self_signed(vec!["localhost".to_owned()]).unwrap();
    let pem = made.cert.pem();
    let key = PrivateKeyDer::from(PrivatePkcs8KeyDer::from(made.signing_key.serialize_der()));
    let provider = Arc::new(rustls::crypto::ring::default_provider());
    let config = ServerConfig::builder_with_provider(provider).with_safe_default_protocol_versions().unwrap();
    let config = config.with_no_client_auth().with_single_cert(vec![made.cert.der().clone()], key).unwrap();
    let config = Arc::new(config);
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    std::thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            let config = config.clone();
            std::thread::spawn(move || {
                let mut stream = StreamOwned::new(ServerConnection::new(config).unwrap(), stream);
                let mut head = [0; 4096];
                let read = stream.read(&mut head).ok()?;
                let (status, body) = match String::from_utf8_lossy(&head[..read]).split(' ').nth(1)? {
                    "/pi.gh" => ("200 OK", definition()),
                    "/away" => ("302 Found\r\nLocation: /pi.gh", Vec::new()),
                    "/huge" => ("200 OK", vec![0; 3 << 20]),
                    _ => ("404 Not Found", Vec::new()),
                };
                let head = format!("HTTP/1.1 {status}\r\nContent-Length: {}\r\n\r\n", body.len());
                stream.write_all(&[head.as_bytes(), &body].concat()).ok()?;
                stream.conn.send_close_notify();
                stream.flush().ok()
            });
        }
    });
    (port, pem)
}

fn fetch(hosts: &[String], authorities: &str, url: &str) -> Result<usize, Fault> {
    let authorities = authorities.as_bytes().to_vec();
    let web = WebSettings { hosts: hosts.to_vec(), authorities, bytes: 1 << 20 };
    let compute = Compute::new(Settings { web, ..Settings::default() });
    let time = Some(Duration::from_secs(10));
    compute
        .fetch(url, time, &Cancel::default(), CacheControl::Allowed)
        .map(|definition| definition.interface().outputs.len())
}

#[test]
fn hosts_show_who_they_are() {
    let (port, pem) = host();
    let listed = [format!("localhost:{port}"), format!("127.0.0.1:{port}")];
    let at = |path: &str| format!("https://localhost:{port}/{path}");
    assert_eq!(fetch(&listed, &pem, &at("pi.gh")).unwrap(), 1);
    for (path, cause) in [("away", Cause::Refused), ("none", Cause::NotFound), ("huge", Cause::TooLarge)] {
        assert_eq!(fetch(&listed, &pem, &at(path)).unwrap_err().cause, cause, "{path}");
    }
    // A certificate of nobody who is known, one for another name, and a host that is not listed.
    let unknown = fetch(&listed, "", &at("pi.gh")).unwrap_err();
    assert!(unknown.cause == Cause::NotFound && unknown.message.contains("trusted"), "{unknown}");
    let other = fetch(&listed, &pem, &format!("https://127.0.0.1:{port}/pi.gh")).unwrap_err();
    assert!(other.cause == Cause::NotFound && other.message.contains("trusted"), "{other}");
    assert_eq!(fetch(&listed[1..], &pem, &at("pi.gh")).unwrap_err().cause, Cause::Refused);
    // What is not encrypted is not taken for it, nor the other way about.
    assert!(fetch(&listed, &pem, &format!("http://localhost:{port}/pi.gh")).is_err());
}
