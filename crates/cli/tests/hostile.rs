//! Bad files: a clear error with a reason, soon, and with little memory.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::path::Path;
use std::time::{Duration, Instant};

use common::{said, text, within};

/// Opens the bytes under a name, and expects exit code 2 with `reason` in the message, within two seconds.
fn refused(folder: &Path, name: &str, bytes: &[u8], reason: &str) {
    let path = folder.join(name);
    std::fs::write(&path, bytes).unwrap();
    for command in ["run", "check"] {
        let start = Instant::now();
        let output = within(Duration::from_secs(20), &[command, text(&path)]).expect("it hangs");
        let out = String::from_utf8_lossy(&output.stdout).into_owned() + &said(&output);
        assert_eq!(output.status.code(), Some(2), "{name}: {out}");
        assert!(out.contains(reason), "{name}: expected '{reason}' in: {out}");
        assert!(!out.contains("panicked"), "{name}: {out}");
        println!("{command} {name}: {:?}", start.elapsed());
    }
}

/// Raw deflate of zeros, and more of them than any archive has.
fn bomb() -> Vec<u8> {
    use std::io::Write;
    let mut encoder = flate2::write::DeflateEncoder::new(Vec::new(), flate2::Compression::best());
    let zeros = vec![0u8; 1 << 20];
    for _ in 0..1024 {
        encoder.write_all(&zeros).unwrap();
    }
    encoder.finish().unwrap()
}

fn deflated(bytes: &[u8]) -> Vec<u8> {
    use std::io::Write;
    let mut encoder = flate2::write::DeflateEncoder::new(Vec::new(), flate2::Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// The head of a chunk: name, no index, item and chunk counts.
fn chunk(name: &str, items: i32, chunks: i32) -> Vec<u8> {
    let mut bytes = vec![u8::try_from(name.len()).unwrap()];
    bytes.extend_from_slice(name.as_bytes());
    bytes.extend_from_slice(&(-1i32).to_le_bytes());
    bytes.extend_from_slice(&items.to_le_bytes());
    bytes.extend_from_slice(&chunks.to_le_bytes());
    bytes
}

#[test]
fn bad_archives_are_refused_with_a_reason() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    refused(at, "empty.gh", b"", "empty");
    refused(at, "picture.gh", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "PNG");
    refused(at, "bomb.gh", &bomb(), "268435456");
    refused(at, "negative.gh", &deflated(&chunk("Root", -1, 0)), "-1");
    refused(at, "many.gh", &deflated(&chunk("Root", i32::MAX, i32::MAX)), "2147483647");
    let mut long = chunk("Root", 1, 0);
    long.extend_from_slice(b"\x04Name\xff\xff\xff\xff");
    long.extend_from_slice(&10i32.to_le_bytes());
    long.extend_from_slice(&[0xff, 0xff, 0xff, 0x7f]);
    refused(at, "long.gh", &deflated(&long), "a text needs");
    let mut deep = Vec::new();
    for _ in 0..100_000 {
        deep.extend_from_slice(&chunk("a", 0, 1));
    }
    refused(at, "deep.gh", &deflated(&deep), "depth");
    let nested = "<chunk name=\"a\"><chunks>".repeat(100_000);
    refused(at, "deep.ghx", format!("<Archive name=\"Root\"><chunks>{nested}").as_bytes(), "depth");
    let entity = "<!DOCTYPE a [<!ENTITY x \"y\"><!ENTITY z \"&x;&x;&x;\">]><Archive name=\"Root\"></Archive>";
    refused(at, "entity.ghx", entity.as_bytes(), "DOCTYPE");
}

#[test]
fn an_archive_cut_anywhere_is_refused() {
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/attractor.ghx");
    let folder = tempfile::tempdir().unwrap();
    let binary = folder.path().join("whole.gh");
    let output = common::katydid(&["convert", example, text(&binary)]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    for whole in [std::fs::read(&binary).unwrap(), std::fs::read(example).unwrap()] {
        let cut = folder.path().join("cut.gh");
        for k in 1..24 {
            std::fs::write(&cut, &whole[..whole.len() * k / 24]).unwrap();
            let output = within(Duration::from_secs(5), &["run", text(&cut)]).expect("it hangs");
            assert_eq!(output.status.code(), Some(2), "{k}/24: {}", said(&output));
            assert!(!said(&output).contains("panicked"));
        }
    }
}

#[test]
fn a_wrong_count_is_only_a_note() {
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/attractor.ghx");
    let xml = std::fs::read_to_string(example).unwrap();
    let wrong = xml.replacen("<chunks count=\"", "<chunks count=\"9", 1);
    assert_ne!(xml, wrong);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wrong.ghx");
    std::fs::write(&path, wrong).unwrap();
    assert_eq!(common::katydid(&["run", text(&path)]).status.code(), Some(0));
}
