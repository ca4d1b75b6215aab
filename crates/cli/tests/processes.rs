//! The two processes of `katydid serve`: what is done in which, and what happens when one of them ends.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]
#![cfg(target_os = "linux")]

mod common;

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Value, json};

/// Nothing takes longer on a busy machine.
const WAIT: Duration = Duration::from_secs(60);
/// It takes a number and adds three.
const SUM: &str =
    "katydid 1\na = Number Slider(2.0, 0..1000)\nsum = Addition(a, 3)\n\"RH_IN:a\": a\n\"RH_OUT:x\": sum\n";
/// So many points that it takes longer than a slice in front, on any machine.
const LONG: &str = "katydid 1\na = Number Slider(0.0, 0..1000000)\ns = Series(0, 1, a)\np = Construct Point(s, s, s)\n\
    d = Distance(p, (0, 0, 0))\nm = Mass Addition(d)\n\"RH_IN:a\": a\n\"RH_OUT:x\": m\n";

struct Server {
    child: Child,
    host: String,
}

struct Answer {
    status: u16,
    head: String,
    body: Vec<u8>,
}

impl Answer {
    fn is_from_behind(&self) -> bool {
        self.head.contains("behind;dur=")
    }

    fn json(&self) -> Value {
        serde_json::from_slice(&self.body)
            .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&self.body)))
    }

    /// The number that came out.
    fn number(&self) -> f64 {
        let reply = self.json();
        let tree = &reply["values"][0]["InnerTree"];
        let branch = tree.as_object().and_then(|tree| tree.values().next());
        let data = branch.unwrap_or_else(|| panic!("{reply}"))[0]["data"].as_str().unwrap().to_owned();
        data.trim_matches('"').parse().unwrap()
    }
}

impl Server {
    fn start(words: &[&str]) -> Self {
        let (child, host) = common::serving(words);
        Self { child, host }
    }

    fn ask(&self, method: &str, path: &str, body: &[u8]) -> Answer {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(WAIT)).unwrap();
        let length = body.len();
        write!(
            stream,
            "{method} {path} HTTP/1.1\r\nHost: {}\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n",
            self.host
        )
        .unwrap();
        stream.write_all(body).unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let end = answer.windows(4).position(|four| four == b"\r\n\r\n").expect("a head");
        let head = String::from_utf8_lossy(&answer[..end]).into_owned();
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap();
        Answer { status, head, body: answer[end + 4..].to_vec() }
    }

    fn solve(&self, algo: &str, a: f64) -> Answer {
        let value = json!({"ParamName": "RH_IN:a", "InnerTree": {"0": [{"data": a}]}});
        self.ask("POST", "/grasshopper", json!({"algo": algo, "values": [value]}).to_string().as_bytes())
    }

    /// Its other process, once there is one.
    fn other(&self) -> Option<u32> {
        let tasks = std::fs::read_dir(format!("/proc/{}/task", self.child.id())).ok()?;
        let children =
            tasks.flatten().filter_map(|task| std::fs::read_to_string(task.path().join("children")).ok());
        children
            .flat_map(|line| line.split_whitespace().filter_map(|id| id.parse().ok()).collect::<Vec<_>>())
            .next()
    }

    fn end(mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }
}

fn signal(process: u32, signal: &str) {
    assert!(Command::new("kill").args([signal, &process.to_string()]).status().unwrap().success());
}

/// Whether a process is there and not only waits to be buried.
fn runs(process: u32) -> bool {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat"));
    stat.is_ok_and(|stat| !stat.rsplit(')').next().unwrap_or_default().trim_start().starts_with('Z'))
}

fn soon(what: &str, mut is_so: impl FnMut() -> bool) {
    let end = Instant::now() + WAIT;
    while !is_so() {
        assert!(Instant::now() < end, "{what}");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// A definition in the form that clients send.
fn packed(text: &str, folder: &Path) -> String {
    let (source, target) = (folder.join("a.kd"), folder.join("a.gh"));
    std::fs::write(&source, text).unwrap();
    let words = [Path::new("convert"), &source, &target];
    let done = Command::new(env!("CARGO_BIN_EXE_katydid")).args(words).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    BASE64_STANDARD.encode(std::fs::read(target).unwrap())
}

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
