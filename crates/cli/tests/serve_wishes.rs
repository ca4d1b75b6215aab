//! What users of compute servers ask for, as far as it needs the program itself; the rest is in
//! `crates/server/tests/wishes`.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]
#![allow(clippy::print_stdout, reason = "what was measured is told, and not asserted")]
#![cfg(target_os = "linux")]

mod common;

use std::process::{Command, Stdio};
use std::time::Instant;

use common::server::{SUM, Server, packed, signal, soon};
use serde_json::json;

/// The figure of that name.
fn figure(server: &Server, name: &str) -> f64 {
    let page = String::from_utf8(server.ask("GET", "/metrics", b"").body).unwrap();
    let line = page.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
    line.unwrap_or_else(|| panic!("no {name} in {page}")).parse().unwrap()
}

/// Memory grows until the machine must be rebooted (compute.rhino3d#396, #468). `make soak` has a hundred thousand.
#[test]
fn memory_is_flat_over_many_solves() {
    let folder = tempfile::tempdir().unwrap();
    let algos: Vec<String> =
        (3..6).map(|n| packed(&SUM.replace("3)", &format!("{n})")), folder.path())).collect();
    // Behind, too: it is a new input each time, and a third of them is a job.
    let server = Server::start(&["--jobs", "8"]);
    let solve = |n: usize| {
        let (which, a) = (n % 3, n as f64);
        assert_eq!(server.solve(&algos[which], a % 1000.0).number(), a % 1000.0 + 3.0 + which as f64);
        if n.is_multiple_of(3) {
            let body = json!({"algo": algos[which], "values": []}).to_string();
            assert_eq!(server.ask("POST", "/jobs", body.as_bytes()).status, 202);
        }
    };
    let resident = || figure(&server, "katydid_resident_memory_bytes") / f64::from(1 << 20);
    (0..600).for_each(&solve);
    let before = resident();
    (0..1800).for_each(&solve);
    let after = resident();
    println!("{before:.1} MB after 600 solves, {after:.1} MB after 2,400");
    // A leak of 10 kB a solve would be 18 MB.
    assert!(after - before < 9.0, "{before} MB, then {after} MB");
    server.end();
}

/// A hung child still answers "Healthy" (compute.rhino3d#468).
#[test]
fn health_turns_bad_when_the_second_process_hangs_and_good_when_it_goes_on() {
    let server = Server::start(&[]);
    soon("all is well", || server.ask("GET", "/healthcheck", b"").body == b"Healthy");
    let other = server.other().expect("a second process");
    signal(other, "-STOP");
    let start = Instant::now();
    let mut said = Vec::new();
    soon("it is told", || {
        let answer = server.ask("GET", "/healthcheck", b"");
        said = answer.body;
        answer.status == 503
    });
    println!("a hung process was told after {:?}", start.elapsed());
    assert_eq!(said, b"Unhealthy: processes: the second one does not answer");
    signal(other, "-CONT");
    soon("all is well again", || server.ask("GET", "/healthcheck", b"").body == b"Healthy");
    server.end();
}

/// Too many children (compute.rhino3d#732): there are two processes, whatever is asked at a time.
#[test]
fn there_are_two_processes_however_many_ask() {
    let folder = tempfile::tempdir().unwrap();
    let algo = packed(SUM, folder.path());
    let server = Server::start(&[]);
    let processes = || {
        let children = std::fs::read_dir(format!("/proc/{}/task", server.child.id())).unwrap().flatten();
        let lists = children.filter_map(|task| std::fs::read_to_string(task.path().join("children")).ok());
        1 + lists.map(|list| list.split_whitespace().count()).sum::<usize>()
    };
    std::thread::scope(|scope| {
        for n in 0..32 {
            let (server, algo) = (&server, &algo);
            scope.spawn(move || assert_eq!(server.solve(algo, f64::from(n)).number(), f64::from(n) + 3.0));
        }
    });
    assert_eq!(processes(), 2);
    server.end();
}

/// Linux, containers (compute.rhino3d#668, #763, #636), and no licence for each core (#636): it needs nothing but itself,
/// not a home, not a variable, not a folder that it may write.
#[test]
fn it_needs_nothing_around_it() {
    let folder = tempfile::tempdir().unwrap();
    let algo = packed(SUM, folder.path());
    let empty = tempfile::tempdir().unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_katydid"));
    command.args(["serve", "--port", "0"]).env_clear().current_dir(empty.path()).stdin(Stdio::null());
    let (child, url) = common::listening(&mut command);
    let host = common::host_of(&url);
    let server = Server { child, host };
    assert_eq!(server.solve(&algo, 4.0).number(), 7.0);
    assert_eq!(std::fs::read_dir(empty.path()).unwrap().count(), 0, "it leaves nothing behind");
    server.end();
}

/// A definition by its path, in the second process too (compute.rhino3d#591).
#[test]
fn definitions_are_named_by_their_paths() {
    let folder = tempfile::tempdir().unwrap();
    packed(SUM, folder.path());
    let folder = folder.path().to_str().unwrap();
    let server = Server::start(&["--definitions", folder]);
    let ask =
        |path: &str| server.ask("POST", "/grasshopper", json!({"pointer": path}).to_string().as_bytes());
    for _ in 0..3 {
        assert_eq!(ask("a.gh").number(), 5.0);
    }
    assert_eq!(ask("a.kd").status, 403);
    assert_eq!(ask("b.gh").status, 404);
    server.end();
    let missing = common::katydid(&["serve", "--port", "0", "--definitions", "/nowhere/at/all"]);
    assert_eq!(missing.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&missing.stderr).contains("/nowhere/at/all: there is no such folder"));
}
