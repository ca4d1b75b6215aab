//! `katydid serve` as a process of its own, and a client of it.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Value, json};

/// Nothing takes longer on a busy machine.
pub(crate) const WAIT: Duration = Duration::from_secs(60);
/// It takes a number and adds three.
pub(crate) const SUM: &str =
    "katydid 1\na = Number Slider(2.0, 0..1000)\nsum = Addition(a, 3)\n\"RH_IN:a\": a\n\"RH_OUT:x\": sum\n";

pub(crate) struct Server {
    pub(crate) child: Child,
    pub(crate) host: String,
}

pub(crate) struct Answer {
    pub(crate) status: u16,
    pub(crate) head: String,
    pub(crate) body: Vec<u8>,
}

impl Answer {
    pub(crate) fn is_from_behind(&self) -> bool {
        self.head.contains("behind;dur=")
    }

    pub(crate) fn json(&self) -> Value {
        serde_json::from_slice(&self.body)
            .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&self.body)))
    }

    /// The number that came out.
    pub(crate) fn number(&self) -> f64 {
        let reply = self.json();
        let tree = &reply["values"][0]["InnerTree"];
        let branch = tree.as_object().and_then(|tree| tree.values().next());
        let data = branch.unwrap_or_else(|| panic!("{reply}"))[0]["data"].as_str().unwrap().to_owned();
        data.trim_matches('"').parse().unwrap()
    }
}

impl Server {
    pub(crate) fn start(words: &[&str]) -> Self {
        let (child, host) = super::serving(words);
        Self { child, host }
    }

    pub(crate) fn ask(&self, method: &str, path: &str, body: &[u8]) -> Answer {
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

    pub(crate) fn solve(&self, algo: &str, a: f64) -> Answer {
        let value = json!({"ParamName": "RH_IN:a", "InnerTree": {"0": [{"data": a}]}});
        self.ask("POST", "/grasshopper", json!({"algo": algo, "values": [value]}).to_string().as_bytes())
    }

    /// Its other process, once there is one.
    pub(crate) fn other(&self) -> Option<u32> {
        let tasks = std::fs::read_dir(format!("/proc/{}/task", self.child.id())).ok()?;
        let children =
            tasks.flatten().filter_map(|task| std::fs::read_to_string(task.path().join("children")).ok());
        children
            .flat_map(|line| line.split_whitespace().filter_map(|id| id.parse().ok()).collect::<Vec<_>>())
            .next()
    }

    pub(crate) fn end(mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }
}

pub(crate) fn signal(process: u32, signal: &str) {
    assert!(Command::new("kill").args([signal, &process.to_string()]).status().unwrap().success());
}

/// Whether a process is there and not only waits to be buried.
pub(crate) fn runs(process: u32) -> bool {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat"));
    stat.is_ok_and(|stat| !stat.rsplit(')').next().unwrap_or_default().trim_start().starts_with('Z'))
}

pub(crate) fn soon(what: &str, mut is_so: impl FnMut() -> bool) {
    let end = Instant::now() + WAIT;
    while !is_so() {
        assert!(Instant::now() < end, "{what}");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// A definition in the form that clients send.
pub(crate) fn packed(text: &str, folder: &Path) -> String {
    let (source, target) = (folder.join("a.kd"), folder.join("a.gh"));
    std::fs::write(&source, text).unwrap();
    let words = [Path::new("convert"), &source, &target];
    let done = Command::new(env!("CARGO_BIN_EXE_katydid")).args(words).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    BASE64_STANDARD.encode(std::fs::read(target).unwrap())
}
