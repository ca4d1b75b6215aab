//! Many clients at a time on a compute server.
//!
//! - `compute_load HOST:PORT CASES.json CLIENTS SOLVES`: each client keeps one connection and asks again as soon as it is
//!   answered.
//! - `compute_load soak HOST:PORT CASES.json CLIENTS SECONDS ENDLESS.json`: the same for a time, among them clients that
//!   leave, send nonsense, too much or too slowly, and jobs that are fetched or cancelled. ENDLESS is a body of a solve that
//!   takes longer than anybody waits.
//!
//! The cases are a list of `{"body": "…", "expected": [[1.0, …], …]}`: a request of `/grasshopper`, and the branches of its
//! first output. `benches/compute_load.py` and `benches/compute_soak.py` make the cases, with what `katydid run` says, and
//! read what this prints.

mod cases;
mod client;
mod misuse;
mod rounds;
mod share;
mod soak;

use std::error::Error;
use std::time::Duration;

type Outcome<T> = Result<T, Box<dyn Error + Send + Sync>>;

fn main() -> Outcome<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let told = match *words.as_slice() {
        [host, cases, clients, solves] => {
            rounds::measure(host, &cases::read(cases, host)?, clients.parse()?, solves.parse()?)?
        }
        ["soak", host, cases, clients, seconds, endless] => {
            let time = Duration::from_secs_f64(seconds.parse()?);
            let site =
                misuse::Site { host, cases: &cases::read(cases, host)?, endless: &std::fs::read(endless)? };
            soak::soak(&site, clients.parse()?, time)
        }
        _ => {
            return Err("compute_load HOST:PORT CASES.json CLIENTS SOLVES; compute_load soak HOST:PORT \
                         CASES.json CLIENTS SECONDS ENDLESS.json"
                .into());
        }
    };
    println!("{told}");
    Ok(())
}
