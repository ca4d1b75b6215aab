//! Many clients at a time on a compute server: `compute_load HOST:PORT CASES.json CLIENTS SOLVES`.
//!
//! The cases are a list of `{"body": "…", "expected": [[1.0, …], …]}`: a request of `/grasshopper`, and the branches of its
//! first output. Each client keeps one connection and asks again as soon as it is answered. `benches/compute_load.py`
//! makes the cases, with what `katydid run` says, and reads what this prints.

use std::error::Error;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

type Outcome<T> = Result<T, Box<dyn Error + Send + Sync>>;

struct Case {
    request: Vec<u8>,
    expected: Vec<Vec<f64>>,
}

struct Client {
    stream: TcpStream,
    heard: Vec<u8>,
}

impl Client {
    fn new(host: &str) -> Outcome<Self> {
        let stream = TcpStream::connect(host)?;
        stream.set_nodelay(true)?;
        Ok(Self { stream, heard: Vec::new() })
    }

    /// The body of the answer, and the milliseconds that the server says the solve took.
    fn ask(&mut self, request: &[u8]) -> Outcome<(Vec<u8>, f64)> {
        self.stream.write_all(request)?;
        self.heard.clear();
        let mut piece = [0; 16_384];
        let (head, start) = loop {
            let read = self.stream.read(&mut piece)?;
            if read == 0 {
                return Err("the server has closed the connection".into());
            }
            self.heard.extend_from_slice(piece.get(..read).unwrap_or_default());
            if let Some(end) = self.heard.windows(4).position(|window| window == b"\r\n\r\n") {
                let head = String::from_utf8_lossy(self.heard.get(..end).unwrap_or_default()).to_lowercase();
                break (head, end + 4);
            }
        };
        let field = |name: &str| head.lines().find_map(|line| line.strip_prefix(name)).map(str::trim);
        let length: usize = field("content-length:").ok_or("no length")?.parse()?;
        let solve = field("server-timing:").and_then(|timing| timing.split("solve;dur=").nth(1));
        let solve = solve.and_then(|rest| rest.split(',').next()?.parse().ok()).unwrap_or(0.0);
        while self.heard.len() < start + length {
            let read = self.stream.read(&mut piece)?;
            if read == 0 {
                return Err("the server has closed the connection".into());
            }
            self.heard.extend_from_slice(piece.get(..read).unwrap_or_default());
        }
        Ok((self.heard.get(start..start + length).unwrap_or_default().to_vec(), solve))
    }
}

fn is_right(body: &[u8], expected: &[Vec<f64>]) -> bool {
    let Ok(reply) = serde_json::from_slice::<Value>(body) else { return false };
    let Some(tree) = reply["values"][0]["InnerTree"].as_object() else { return false };
    tree.len() == expected.len()
        && tree.values().zip(expected).all(|(branch, expected)| {
            let Some(branch) = branch.as_array() else { return false };
            let number = |item: &Value| item["data"].as_str().and_then(|text| text.parse::<f64>().ok());
            branch.len() == expected.len()
                && branch.iter().zip(expected).all(|(item, expected)| {
                    number(item).is_some_and(|x| (x - expected).abs() <= 1e-12 * expected.abs().max(1.0))
                })
        })
}

/// A number for each turn, the same in each run (the constants are Knuth's, for a congruential generator).
fn case_of(turn: usize, count: usize) -> usize {
    let mixed =
        (turn as u64 + 1).wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (mixed >> 33) as usize % count
}

/// What one client saw.
#[derive(Default)]
struct Seen {
    /// How long each answer took.
    times: Vec<Duration>,
    /// What of it was not the solve, in milliseconds.
    beyond: Vec<f64>,
    /// How many answers were not those of `katydid run`.
    wrong: usize,
}

fn main() -> Outcome<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [host, cases, clients, solves] = words.as_slice() else {
        return Err("compute_load HOST:PORT CASES.json CLIENTS SOLVES".into());
    };
    let (clients, solves): (usize, usize) = (clients.parse()?, solves.parse()?);
    let cases: Vec<Value> = serde_json::from_slice(&std::fs::read(cases)?)?;
    let cases: Vec<Case> = cases
        .iter()
        .map(|case| {
            let body = case["body"].as_str().unwrap_or_default();
            let head = format!(
                "POST /grasshopper HTTP/1.1\r\nHost: {host}\r\nContent-Length: {}\r\n\r\n",
                body.len()
            );
            let expected = serde_json::from_value(case["expected"].clone()).unwrap_or_default();
            Case { request: [head.as_bytes(), body.as_bytes()].concat(), expected }
        })
        .collect();
    let start = Instant::now();
    let done: Vec<Outcome<Seen>> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..clients)
            .map(|own| {
                let cases = &cases;
                scope.spawn(move || -> Outcome<Seen> {
                    let mut client = Client::new(host)?;
                    let mut seen = Seen::default();
                    for turn in (own..solves).step_by(clients) {
                        let Some(case) = cases.get(case_of(turn, cases.len())) else { continue };
                        let from = Instant::now();
                        let (body, solve) = client.ask(&case.request)?;
                        let took = from.elapsed();
                        seen.times.push(took);
                        seen.beyond.push(took.as_secs_f64() * 1e3 - solve);
                        seen.wrong += usize::from(!is_right(&body, &case.expected));
                    }
                    Ok(seen)
                })
            })
            .collect();
        threads
            .into_iter()
            .map(|thread| thread.join().unwrap_or_else(|_| Err("a client failed".into())))
            .collect()
    });
    let seconds = start.elapsed().as_secs_f64();
    let Seen { mut times, mut beyond, mut wrong } = Seen::default();
    for one in done {
        let own = one?;
        times.extend(own.times);
        beyond.extend(own.beyond);
        wrong += own.wrong;
    }
    times.sort();
    beyond.sort_by(f64::total_cmp);
    let at = |part: f64| ((times.len() as f64 * part) as usize).min(times.len().saturating_sub(1));
    let ms = |part: f64| times.get(at(part)).map_or(0.0, |time| time.as_secs_f64() * 1e3);
    let extra = |part: f64| beyond.get(at(part)).copied().unwrap_or(0.0);
    let told = json!({
        "solves": times.len(), "wrong": wrong, "seconds": seconds, "rate": times.len() as f64 / seconds,
        "median_ms": ms(0.5), "p99_ms": ms(0.99), "beyond_median_ms": extra(0.5), "beyond_p95_ms": extra(0.95),
    });
    println!("{told}");
    Ok(())
}
