//! Definitions that were made to do harm.

use std::time::Duration;

use katydid_component::Limits;
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
    let utf16: Vec<u8> =
        "\u{feff}<Archive name=\"Root\">".encode_utf16().flat_map(u16::to_le_bytes).collect();
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
        ("text in UTF-16", utf16),
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

/// Each ends in an error that says what is too much, or in a refusal, and takes little time and memory until then.
#[tokio::test(flavor = "multi_thread")]
async fn definitions_that_want_too_much() {
    let limits = Limits { items: 1_000_000, ..Limits::default() }.with_bytes(8 << 20);
    let compute =
        Compute::start_with(|config| Config { timeout: Duration::from_secs(20), limits, ..config }).await;
    let doubled: String = (1..=40).map(|n| format!("t{n} = Concatenate(t{}, t{})\n", n - 1, n - 1)).collect();
    let (open, close) = ("(".repeat(10_000), ")".repeat(10_000));
    let long = vec!["1"; 300_000].join("+");
    let cases = [
        "x = Series(0, 1, 2147483647)".to_owned(),
        "d = Construct Domain(0, 1)\nx = Range(d, 1000000000)".to_owned(),
        "x = Repeat Data([1, 2], 1000000000)".to_owned(),
        "x = Duplicate Data(1, 1000000000)".to_owned(),
        "c = Circle(XY Plane(), 1)\nx = Divide Curve(c, 1000000000)".to_owned(),
        "x = Mesh Sphere(XY Plane(), 1, 1000000, 1000000)".to_owned(),
        "b = Center Box(XY Plane(), 1, 1, 1)\nx = Populate 3D(b, 1000000000, 1)".to_owned(),
        "a = Series(0, 1, 100000)\nx = Cross Reference(a, a)".to_owned(),
        "b = Center Box(XY Plane(), 1, 1, 1)\nx = Box Array(b, b, 10000, 10000, 10000)".to_owned(),
        "r = Series(0, 1, 10000000)\np = Construct Point(r, r, r)\nx = Voronoi(p)".to_owned(),
        "b = Center Box(XY Plane(), 1, 1, 1)\nm = Mesh Box(b, 1, 1, 1)\ns = SubD from Mesh(m)\n\
         x = Mesh from SubD(s, 12)"
            .to_owned(),
        "x = Format(\"{0:D2000000000}\", 127, 1)".to_owned(),
        format!("t0 = Panel(\"0123456789abcdef0123456789abcdef\")\n{doubled}x = Panel(t40)"),
        format!("x = Expression(\"{open}1{close}\")"),
        format!("x = Expression(\"{long}\")"),
    ];
    for case in cases {
        let start = Instant::now();
        let answer = compute.solve(&given(&case), json!([])).await;
        let says = answer.status == 500 && !answer.json()["errors"].as_array().unwrap().is_empty();
        assert!(says || answer.is_refused(), "{case:.60}: {} {:.200}", answer.status, answer.text());
        assert!(start.elapsed() < Duration::from_secs(20), "{case:.60}: {:?}", start.elapsed());
        assert!(answer.body.len() < 1 << 20, "{case:.60}: {} bytes", answer.body.len());
    }
    // What looks bad and is not: the powers are read from the right, or from the left; nothing is tried twice.
    for case in [
        "x = Expression(\"2^2^2^2^2\")",
        "x = Match Text(\"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaab\", \"*b\", \"(a+)+$\")",
    ] {
        let start = Instant::now();
        let answer = compute.solve(&given(case), json!([])).await;
        assert_eq!(answer.status, 200, "{case}: {}", answer.text());
        assert!(start.elapsed() < Duration::from_secs(5), "{case}: {:?}", start.elapsed());
    }
    compute.is_well().await;
}

/// What fits the limits and takes longer than the time that there is.
#[tokio::test(flavor = "multi_thread")]
async fn definitions_that_take_too_long() {
    let compute = Compute::start_with(|config| Config { timeout: Duration::from_secs(1), ..config }).await;
    let start = Instant::now();
    let text = "r = Series(0, 1, 1000000)\np = Construct Point(r, r, r)\nx = Voronoi(p)";
    let answer = compute.solve(&given(text), json!([])).await;
    assert_eq!(answer.status, 408, "{:.200}", answer.text());
    assert!(answer.is_refused() && start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
    compute.is_well().await;
}

/// All at a time take no more than the server may: who comes too late is told so, and who wants little is answered.
#[tokio::test(flavor = "multi_thread")]
async fn many_that_want_much_together() {
    let total_bytes = 64 << 20;
    let compute = Compute::start_with(|config| Config { total_bytes, ..config }).await;
    let large = given("x = Series(0, 1, 60000)");
    let ask = |_| compute.solve(&large, json!([]));
    let many = futures_util::future::join_all((0..12).map(ask));
    let few = async {
        for _ in 0..10 {
            let answer = compute.solve(&gh(SUM), json!([])).await;
            assert_eq!(answer.status, 200, "{:.200}", answer.text());
        }
    };
    let (many, ()) = tokio::join!(many, few);
    for answer in many {
        if answer.status == 503 {
            assert_eq!(answer.json()["cause"], "busy");
            assert!(!answer.header("retry-after").is_empty());
        } else {
            assert_eq!((answer.status, answer.output("RH_OUT:x").as_f64()), (200, Some(0.0)));
        }
    }
    // One at a time there is room for each, and nothing is kept of it.
    assert_eq!(compute.solve(&large, json!([])).await.status, 200);
    let alone = compute.solve(&given("x = Series(0, 1, 5000000)"), json!([])).await;
    assert!(alone.status == 500 || alone.status == 503, "{:.200}", alone.text());
    let taken = async || compute.get("/metrics").await.text().contains("katydid_common_memory_bytes 0\n");
    for _ in 0..100 {
        if taken().await {
            break;
        }
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
    assert!(taken().await);
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn files_of_the_machine_are_not_read() {
    let compute = Compute::start().await;
    for path in ["/etc/passwd", "/proc/self/environ", "../../etc/hostname", "C:\\Windows\\win.ini"] {
        let path = path.replace('\\', "\\\\");
        for reader in [
            format!("p = Panel(\"{path}\")\nx = Read File(p)"),
            format!("p = File Path(\"{path}\")\nx = Read File(p)"),
            format!("x = Read File(\"{path}\")"),
            format!("x = Import Coordinates(\"{path}\")"),
            format!("x = Import 3DM(\"{path}\")"),
            format!("r = Rectangle(XY Plane(), 4, 3)\nx = Import Image(\"{path}\", r)"),
        ] {
            let answer = compute.solve(&given(&reader), json!([])).await;
            assert_eq!(answer.status, 500, "{reader}: {}", answer.text());
            let errors = answer.json()["errors"].to_string();
            assert!(errors.contains("files may not be read here"), "{reader}: {errors}");
            assert!(
                !answer.text().contains("root:") && !answer.text().contains("PATH="),
                "{}",
                answer.text()
            );
        }
    }
    compute.is_well().await;
}

/// A definition of these lines, whose `x` is given.
fn given(lines: &str) -> String {
    gh(&format!("katydid 1\n{lines}\n\"RH_OUT:x\": x\n"))
}
