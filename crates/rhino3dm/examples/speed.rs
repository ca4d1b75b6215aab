//! Times reading and writing in process: `speed VERSION FILE.3dm…`.
//!
//! Prints a line of JSON a file: its size, the medians of the times of reading it and of writing it as an archive of
//! the version, in seconds, and the peak of memory while it was read once, in bytes beyond what the process had
//! before (the archive's own bytes left out).

use std::time::{Duration, Instant};

use katydid_3dm::{Limits, Model};
use serde_json::json;

/// How long each kind of run is repeated.
const WAIT: Duration = Duration::from_millis(1500);

/// The median time of `run`, of at least five runs.
fn median(mut run: impl FnMut()) -> f64 {
    let mut times = Vec::new();
    let start = Instant::now();
    while times.len() < 5 || start.elapsed() < WAIT {
        let one = Instant::now();
        run();
        times.push(one.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or_default()
}

/// A number of kilobytes out of the kernel's account of this process, in bytes.
fn memory(what: &str) -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(what));
    line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok()).unwrap_or_default() * 1024
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [version, files @ ..] = arguments.as_slice() else {
        return Err("usage: speed VERSION FILE.3dm…".into());
    };
    let version = version.parse()?;
    let limits = Limits::default();
    for file in files {
        let bytes = std::fs::read(file)?;
        let _ = std::fs::write("/proc/self/clear_refs", "5");
        let before = memory("VmRSS:");
        let mut model = Model::read(&bytes, &limits)?;
        let peak = memory("VmHWM:").saturating_sub(before);
        let read = median(|| drop(Model::read(&bytes, &limits)));
        model.objects.retain(|object| object.geometry.check_writable(version).is_ok());
        let write = median(|| drop(model.write(version)));
        println!(
            "{}",
            json!({"file": file, "bytes": bytes.len(), "read": read, "write": write, "peak": peak,
                "objects": model.objects.len()})
        );
    }
    Ok(())
}
