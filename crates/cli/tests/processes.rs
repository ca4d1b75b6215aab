//! The two processes of `katydid serve`: what is done in which, and what happens when one of them ends.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]
#![cfg(target_os = "linux")]

mod common;

use std::process::Command;

use common::server::{SUM, Server, packed, runs, signal, soon};
use serde_json::json;

/// So many points that it takes longer than a slice in front, on any machine.
const LONG: &str = "katydid 1\na = Number Slider(0.0, 0..1000000)\ns = Series(0, 1, a)\np = Construct Point(s, s, s)\n\
    d = Distance(p, (0, 0, 0))\nm = Mass Addition(d)\n\"RH_IN:a\": a\n\"RH_OUT:x\": m\n";

#[test]
fn what_is_new_or_long_is_done_behind() {
    let folder = tempfile::tempdir().unwrap();
    let (sum, long) = (packed(SUM, folder.path()), packed(LONG, folder.path()));
    let server = Server::start(&[]);
    let first = server.solve(&sum, 4.0);
    assert!(first.is_from_behind(), "nobody knows yet what it takes");
    assert_eq!(first.number(), 7.0);
    soon("what was quick is done in front", || {
        let answer = server.solve(&sum, 5.0);
        assert_eq!(answer.number(), 8.0);
        !answer.is_from_behind()
    });
    // It is quick for few points, and known to be; for many it is given up in front.
    soon("it is quick", || {
        let answer = server.solve(&long, 2.0);
        assert_eq!(answer.status, 200);
        !answer.is_from_behind()
    });
    let n = 400_000.0;
    let answer = server.solve(&long, n);
    let wanted = 3_f64.sqrt() * n * (n - 1.0) / 2.0;
    assert!(answer.is_from_behind());
    assert!((answer.number() - wanted).abs() < 1e-9 * wanted, "{} is not {wanted}", answer.number());

    // Jobs are behind too, and the figures of both are told as one.
    let job = server.ask("POST", "/jobs", json!({"algo": sum, "values": []}).to_string().as_bytes());
    assert_eq!(job.status, 202);
    let place = format!("/jobs/{}", job.json()["id"].as_str().unwrap());
    soon("the job is done", || server.ask("GET", &place, b"").json()["state"] == "done");
    assert_eq!(server.ask("GET", &format!("{place}/result"), b"").number(), 5.0);
    let figures = String::from_utf8(server.ask("GET", "/metrics", b"").body).unwrap();
    assert!(figures.contains("katydid_jobs{state=\"done\"} 1\n"), "{figures}");
    server.end();
}

#[test]
fn the_second_process_may_end() {
    let folder = tempfile::tempdir().unwrap();
    let sum = packed(SUM, folder.path());
    let server = Server::start(&[]);
    assert_eq!(server.solve(&sum, 4.0).number(), 7.0);
    for _ in 0..2 {
        let other = server.other().expect("a second process");
        signal(other, "-KILL");
        soon("another is started", || server.other().is_some_and(|now| now != other));
        // What comes meanwhile waits, or is asked to come again.
        soon("it answers again", || {
            let answer = server.solve(&packed(&SUM.replace("3)", "4)"), folder.path()), 4.0);
            assert!([200, 503].contains(&answer.status), "{}", answer.head);
            answer.status == 200 && answer.number() == 8.0
        });
    }
    soon("all is well", || server.ask("GET", "/healthcheck", b"").body == b"Healthy");
    server.end();
}

#[test]
fn both_processes_end() {
    for how in ["-KILL", "-TERM", "-INT"] {
        let mut server = Server::start(&[]);
        let other = server.other().expect("a second process");
        signal(server.child.id(), how);
        server.child.wait().unwrap();
        soon("the second process ends with the first", || !runs(other));
    }
}

#[test]
fn only_the_first_process_may_ask_the_second() {
    let server = Server::start(&["--key", "secret"]);
    let other = server.other().expect("a second process");
    let ports = Command::new("cat").arg(format!("/proc/{other}/net/tcp")).output().unwrap();
    let inodes: Vec<String> = std::fs::read_dir(format!("/proc/{other}/fd"))
        .unwrap()
        .flatten()
        .filter_map(|file| std::fs::read_link(file.path()).ok())
        .filter_map(|to| Some(to.to_str()?.strip_prefix("socket:[")?.trim_end_matches(']').to_owned()))
        .collect();
    // In this table, 0A is a socket that listens; 0100007F is 127.0.0.1.
    let table = String::from_utf8_lossy(&ports.stdout).into_owned();
    let listens = table.lines().map(|line| line.split_whitespace().collect::<Vec<_>>()).find(|words| {
        words.get(3) == Some(&"0A") && words.get(9).is_some_and(|inode| inodes.iter().any(|own| own == inode))
    });
    let listens = listens.expect("it listens");
    let (address, port) = listens[1].split_once(':').unwrap();
    assert_eq!(address, "0100007F");
    let port = u16::from_str_radix(port, 16).unwrap();
    let behind = Server { host: format!("127.0.0.1:{port}"), ..Server::start(&["--one-process"]) };
    for path in ["/jobs/1", "/idlespan", "/metrics", "/io?pointer=a"] {
        assert_eq!(behind.ask("GET", path, b"").status, 401, "{path}");
    }
    behind.end();
    server.end();
}

#[test]
fn one_process_is_enough() {
    let folder = tempfile::tempdir().unwrap();
    let sum = packed(SUM, folder.path());
    let server = Server::start(&["--one-process"]);
    let answer = server.solve(&sum, 4.0);
    assert_eq!((answer.number(), answer.is_from_behind()), (7.0, false));
    assert_eq!(server.other(), None);
    server.end();
}
