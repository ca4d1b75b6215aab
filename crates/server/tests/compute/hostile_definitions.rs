//! Definitions that were made to do harm.

use std::time::Duration;

use katydid_server::compute::Config;
use serde_json::json;
use tokio::time::Instant;

use crate::client::{Compute, base64};
use crate::definitions::{SUM, bytes, gh, ghx};

fn deflated(bytes: &[u8]) -> Vec<u8> {
    let mut packer = flate2::write::DeflateEncoder::new(Vec::new(), flate2::Compression::best());
    std::io::Write::write_all(&mut packer, bytes).unwrap();
    packer.finish().unwrap()
}

fn inflated(bytes: &[u8]) -> Vec<u8> {
    let mut out = Vec::new();
    std::io::Read::read_to_end(&mut flate2::read::DeflateDecoder::new(bytes), &mut out).unwrap();
    out
}

#[tokio::test(flavor = "multi_thread")]
async fn files_that_are_none() {
    let compute = Compute::start().await;
    let file = bytes(SUM);
    let text = ghx(SUM);
    let mut plain = inflated(&file);
    let mut bomb = plain.clone();
    bomb.resize(1 << 30, 0);
    let bomb = deflated(&bomb);
    let zeros = deflated(&vec![0; 1 << 30]);
    let at = plain.len() / 2;
    plain[at..at + 4].copy_from_slice(&0x7fff_ffff_u32.to_le_bytes());
    let long = deflated(&plain);
    let nested = format!("<Archive name=\"Root\">{}", "<chunk name=\"a\"><chunks>".repeat(100_000));
    let laughs = "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\">\
        <!ENTITY c \"&b;&b;&b;&b;&b;&b;&b;&b;\">]><Archive name=\"Root\"><items>&c;</items></Archive>";
    let external = "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY x SYSTEM \"file:///etc/passwd\">]>\
        <Archive name=\"Root\"><items><item>&x;</item></items></Archive>";
    let wide = format!("<Archive name=\"{}\"></Archive>", "x".repeat(16 << 20));
    let cases: Vec<(&str, Vec<u8>)> = vec![
        ("a gigabyte of zeros", zeros),
        ("a definition and a gigabyte of zeros", bomb),
        ("a length without end", long),
        ("cut short", file[..file.len() / 2].to_vec()),
        ("nothing", Vec::new()),
        ("a text", b"hello".to_vec()),
        ("nested without end", nested.into_bytes()),
        ("laughs", laughs.into()),
        ("an external entity", external.into()),
        ("a wide attribute", wide.into_bytes()),
        ("cut short text", text.as_bytes()[..text.len() / 2].to_vec()),
        ("a zip", b"PK\x03\x04\x14\x00\x00\x00\x08\x00".to_vec()),
    ];
    for (what, bytes) in cases {
        let start = Instant::now();
        let body = json!({"algo": base64(&bytes)});
        for path in ["/io", "/grasshopper"] {
            let answer = compute.post(path, &body).await;
            // Trailing zeros may be left unread, and a damaged number may still be one.
            let is_read = answer.status == 200
                && matches!(what, "a definition and a gigabyte of zeros" | "a length without end");
            assert!(answer.is_refused() || is_read, "{what}: {} {}", answer.status, answer.text());
            assert!(!answer.text().contains("haha"), "{what}");
        }
        assert!(start.elapsed() < Duration::from_secs(20), "{what}: {:?}", start.elapsed());
    }
    for algo in [format!("{}\n", gh(SUM)), base64(format!("\u{feff}{text}"))] {
        let answer = compute.solve(&algo, json!([])).await;
        assert!(answer.status == 200 || answer.is_refused(), "{}", answer.text());
    }
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn definitions_that_want_too_much() {
    let compute = Compute::start_with(|config| Config { timeout: Duration::from_secs(5), ..config }).await;
    let header = "katydid 1\n";
    let doubled: String = (1..=40).map(|n| format!("t{n} = Concatenate(t{}, t{})\n", n - 1, n - 1)).collect();
    let cases = [
        "x = Series(0, 1, 2147483647)\n".to_owned(),
        "x = Range(0 to 1, 1000000000)\n".to_owned(),
        "x = Repeat Data([1, 2], 1000000000)\n".to_owned(),
        "x = Duplicate Data(1, 1000000000)\n".to_owned(),
        "x = Divide Curve(Circle(XY Plane(), 1), 1000000000)\n".to_owned(),
        "x = Mesh Sphere(XY Plane(), 1, 1000000, 1000000)\n".to_owned(),
        "x = Evaluate(\"2^2^2^2^2\")\n".to_owned(),
        "x = Populate 3D(Sphere(XY Plane(), 1), 1000000000, 1)\n".to_owned(),
        "x = Format(\"{0:D2000000000}\", 1)\n".to_owned(),
        format!("t0 = Panel(\"0123456789abcdef0123456789abcdef\")\n{doubled}x = Panel(t40)\n"),
    ];
    let mut tried = 0;
    for case in cases {
        let text = format!("{header}{case}\"RH_OUT:x\": x\n");
        // A few have other ports than these words suppose; those are not what is tried here.
        katydid_components::link();
        let Ok(definition) = katydid_definition::kd::read(&text, &katydid_session::Registry) else {
            continue;
        };
        tried += 1;
        let start = Instant::now();
        let answer = compute.solve(&base64(definition.document.to_gh().unwrap()), json!([])).await;
        let says = answer.status == 500 && !answer.json()["errors"].as_array().unwrap().is_empty();
        assert!(says || answer.is_refused() || answer.status == 200, "{case:.60}: {}", answer.status);
        assert!(start.elapsed() < Duration::from_secs(20), "{case:.60}: {:?}", start.elapsed());
        assert!(answer.body.len() < 64 << 20, "{case:.60}");
    }
    assert!(tried >= 6, "{tried}");
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn files_of_the_machine_are_not_read() {
    let compute = Compute::start().await;
    for path in ["/etc/passwd", "/proc/self/environ", "../../etc/hostname"] {
        let text = format!("katydid 1\np = Panel(\"{path}\")\nx = Read File(p)\n\"RH_OUT:x\": x\n");
        katydid_components::link();
        let Ok(definition) = katydid_definition::kd::read(&text, &katydid_session::Registry) else { return };
        let answer = compute.solve(&base64(definition.document.to_gh().unwrap()), json!([])).await;
        assert!(!answer.text().contains("root:") && !answer.text().contains("PATH="), "{}", answer.text());
    }
}
