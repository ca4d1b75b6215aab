//! The studio is killed while somebody edits; when the file is opened again, the edits are there.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test may fail loudly"
)]

mod common;

use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket};

/// What may be missing.
const RECENT: Duration = Duration::from_millis(250);
/// And on a machine that is busy with all other tests.
const BUSY: Duration = Duration::from_secs(2);

/// A studio that runs, and the socket of a face.
struct Studio {
    child: Child,
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    seq: u64,
}

impl Studio {
    fn start(file: &Path, state: &Path) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_katydid"));
        command.args(["studio", "--no-open", "--port", "0"]).arg(file).env("XDG_STATE_HOME", state);
        let (child, url) = common::listening(&mut command);
        let socket = url.replace("http://", "ws://").replace("/?", "/socket?");
        let (socket, _) = tungstenite::connect(socket).unwrap();
        Self { child, socket, seq: 0 }
    }

    fn hear(&mut self) -> Option<Value> {
        loop {
            match self.socket.read().ok()? {
                Message::Text(text) => return Some(serde_json::from_str(text.as_str()).unwrap()),
                _ => continue,
            }
        }
    }

    fn document(&mut self) -> Value {
        loop {
            let event = self.hear().expect("a document");
            if event["event"] == "document" {
                return event;
            }
        }
    }

    fn ask(&mut self, ask: Value) {
        self.seq += 1;
        let text = json!({"seq": self.seq, "ask": ask}).to_string();
        self.socket.send(Message::Text(text.into())).unwrap();
        loop {
            let event = self.hear().expect("an answer");
            if event["seq"] == self.seq {
                assert_eq!(event["event"], "done", "{event}");
                return;
            }
        }
    }
}

/// Numbers that look like chance and are the same each time.
struct Chance(u64);

impl Chance {
    fn below(&mut self, n: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % n
    }
}

/// Kills the studio so many times, each time within `longest` milliseconds; what is older than `recent` must be there.
fn killed(times: u64, longest: u64, recent: Duration) {
    let folder = tempfile::tempdir().unwrap();
    let (file, state) = (folder.path().join("a.kd"), folder.path().join("state"));
    std::fs::write(&file, "katydid 1\nr = Number Slider(0, 0..100000000)\nshown = Panel(r)\n").unwrap();
    let mut chance = Chance(0x2545_f491_4f6c_dd1d);
    let (mut sent, mut sure, mut latest) = (0_u64, 0_u64, 0_u64);
    let mut lost = 0;
    for round in 0..times {
        let mut studio = Studio::start(&file, &state);
        let document = studio.document();
        let slider = document["objects"]
            .as_array()
            .unwrap()
            .iter()
            .find(|object| object["nickname"] == "r")
            .expect("the slider")
            .clone();
        let found = slider["control"]["value"].as_f64().unwrap() as u64;
        assert!(found >= sure && found <= latest, "round {round}: {found} is not from {sure} to {latest}");
        lost += latest - found;
        if round > 0 && latest > 0 && found > 0 && document["document"]["changed"] == true {
            assert!(
                document["restored"]["steps"].as_u64().is_some(),
                "round {round}: {}",
                document["restored"]
            );
        }
        sent = sent.max(found);
        let mut answered: Vec<(Instant, u64)> = vec![(Instant::now(), found)];
        let end = Instant::now() + Duration::from_millis(100 + chance.below(longest));
        let mut gesture = 1;
        while Instant::now() < end {
            sent += 1;
            gesture += u64::from(chance.below(30) == 0);
            let edit = json!({"do": "set", "object": slider["id"], "to": {"is": "number", "value": sent}});
            let gesture = (chance.below(10) > 0).then_some(gesture);
            studio.ask(json!({"ask": "edit", "edit": edit, "gesture": gesture, "within": []}));
            answered.push((Instant::now(), sent));
            if chance.below(400) == 0 {
                studio.ask(json!({"ask": "save", "path": null}));
            }
            std::thread::sleep(Duration::from_millis(chance.below(8)));
        }
        studio.child.kill().unwrap();
        let death = Instant::now();
        studio.child.wait().unwrap();
        let safe = answered.iter().filter(|(at, _)| death.duration_since(*at) >= recent);
        sure = safe.map(|(_, value)| *value).next_back().unwrap_or(sure.max(found));
        latest = sent;
    }
    println!("killed {times} times after {sent} edits: {lost} of the last edits missing in all");
}

#[test]
fn edits_are_there_after_the_studio_was_killed() {
    killed(4, 3000, BUSY);
}

#[test]
#[ignore = "takes a minute, and a machine that does nothing else"]
fn edits_are_there_after_the_studio_was_killed_a_hundred_times() {
    killed(100, 900, RECENT);
}
