//! How servers end when they are told to.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]
#![cfg(unix)]

mod common;

use std::io::Write;
use std::net::TcpStream;
use std::process::{Child, Command, ExitStatus};
use std::time::{Duration, Instant};

/// A compute server with half a request, which it waits for.
fn serving() -> (Child, TcpStream) {
    let (child, host) = common::serving(&["--grace", "60"]);
    let mut stream = TcpStream::connect(&host).unwrap();
    write!(stream, "POST /grasshopper HTTP/1.1\r\nHost: {host}\r\nContent-Length: 1000\r\n\r\n{{").unwrap();
    stream.flush().unwrap();
    // The server has to have taken the request in.
    std::thread::sleep(Duration::from_millis(500));
    (child, stream)
}

fn tell(child: &Child, signal: &str) {
    let done = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(done.success());
}

/// The status with which it ends within that time.
fn ends(child: &mut Child, time: Duration) -> Option<ExitStatus> {
    let start = Instant::now();
    while start.elapsed() < time {
        if let Some(status) = child.try_wait().unwrap() {
            return Some(status);
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    None
}

#[test]
fn a_second_signal_ends_at_once() {
    for (first, second, code) in [("-TERM", "-TERM", 143), ("-INT", "-INT", 130), ("-TERM", "-INT", 130)] {
        let (mut child, _stream) = serving();
        tell(&child, first);
        let early = ends(&mut child, Duration::from_millis(700));
        tell(&child, second);
        let status = ends(&mut child, Duration::from_secs(5));
        let _ = child.kill();
        child.wait().unwrap();
        assert!(early.is_none(), "{first}: a request that is under way is finished first: {early:?}");
        let status = status.unwrap_or_else(|| panic!("{first} and {second}: it goes on"));
        assert_eq!(status.code(), Some(code), "{first} and {second}");
    }
}
