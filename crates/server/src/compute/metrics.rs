//! Figures in the text form that Prometheus reads.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::Mutex;
use std::time::Duration;

use super::sent::Sent;
use super::service::Service;
use crate::lock::held;

/// The upper ends of the classes that durations are counted in, in seconds.
const CLASSES: [f64; 13] = [0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.5, 1.0, 5.0, 30.0, 100.0];

#[derive(Debug, Clone, Copy, Default)]
struct Histogram {
    classes: [u64; CLASSES.len()],
    count: u64,
    sum: f64,
}

impl Histogram {
    fn add(&mut self, time: Duration) {
        let seconds = time.as_secs_f64();
        for (count, end) in self.classes.iter_mut().zip(CLASSES) {
            *count += u64::from(seconds <= end);
        }
        self.count += 1;
        self.sum += seconds;
    }
}

/// What has happened since the start.
#[derive(Debug, Default)]
pub(crate) struct Metrics(Mutex<Counts>);

#[derive(Debug, Default)]
struct Counts {
    /// By address and status.
    requests: BTreeMap<(&'static str, u16), u64>,
    /// By address.
    times: BTreeMap<&'static str, Histogram>,
    received: u64,
    sent: u64,
    /// By what came of it.
    solves: BTreeMap<&'static str, u64>,
    solve_time: Histogram,
}

impl Metrics {
    pub(crate) fn answered(&self, path: &'static str, status: u16, took: Duration, received: u64, sent: u64) {
        let mut counts = held(&self.0);
        *counts.requests.entry((path, status)).or_default() += 1;
        counts.times.entry(path).or_default().add(took);
        counts.received = counts.received.saturating_add(received);
        counts.sent = counts.sent.saturating_add(sent);
    }

    pub(crate) fn solved(&self, took: Duration, cause: Option<&'static str>) {
        let mut counts = held(&self.0);
        *counts.solves.entry(cause.unwrap_or("ok")).or_default() += 1;
        counts.solve_time.add(took);
    }
}

/// The page that is scraped. What both processes count is added up.
pub(crate) async fn page(service: &Service) -> Sent {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = write(service, &mut text);
    if let Some(behind) = &service.behind
        && let Some(other) = behind.text("/metrics").await
    {
        text = added(&text, &other);
    }
    Sent::new("text/plain; version=0.0.4; charset=utf-8", text)
}

/// The families of figures that both processes have a part of. Requests are counted in front.
const OF_BOTH: [&str; 10] = [
    "solves_waiting",
    "solves_running",
    "threads_lost",
    "threads_stuck",
    "failures_total",
    "common_memory_bytes",
    "resident_memory_bytes",
    "jobs",
    "solves_total",
    "solve_seconds",
];

/// A line `name{labels} value` of a page, if it is of a family that both have.
fn figure(line: &str) -> Option<(&str, f64)> {
    let (name, value) = line.rsplit_once(' ')?;
    let bare = name.split('{').next()?.strip_prefix("katydid_")?;
    let is_of = |family: &str| {
        let part = bare.strip_prefix(family);
        part.is_some_and(|part| ["", "_bucket", "_sum", "_count"].contains(&part))
    };
    OF_BOTH.iter().any(|family| is_of(family)).then_some((name, value.parse().ok()?))
}

/// A page with the figures of another added to those that both have.
fn added(own: &str, other: &str) -> String {
    let mut more: BTreeMap<&str, f64> = other.lines().filter_map(figure).collect();
    let mut lines: Vec<String> = Vec::new();
    for line in own.lines() {
        lines.push(match figure(line) {
            Some((name, value)) => format!("{name} {}", value + more.remove(name).unwrap_or(0.0)),
            None => line.to_owned(),
        });
    }
    // Outcomes that only the other has come after the last line of their family.
    for (name, value) in more {
        let family = name.split('{').next().unwrap_or(name);
        let is_of = |line: &String| {
            let rest =
                line.strip_prefix(family).or_else(|| line.strip_prefix("# TYPE ")?.strip_prefix(family));
            rest.is_some_and(|rest| rest.starts_with(['{', ' ']))
        };
        let after = lines.iter().rposition(is_of).map_or(lines.len(), |at| at + 1);
        lines.insert(after, format!("{name} {value}"));
    }
    lines.push(String::new());
    lines.join("\n")
}

fn head(out: &mut String, name: &str, kind: &str, help: &str) -> std::fmt::Result {
    writeln!(out, "# HELP katydid_{name} {help}\n# TYPE katydid_{name} {kind}")
}

fn histogram(out: &mut String, name: &str, label: &str, times: &Histogram) -> std::fmt::Result {
    let comma = if label.is_empty() { "" } else { "," };
    for (end, count) in CLASSES.iter().zip(times.classes) {
        writeln!(out, "katydid_{name}_bucket{{{label}{comma}le=\"{end}\"}} {count}")?;
    }
    writeln!(out, "katydid_{name}_bucket{{{label}{comma}le=\"+Inf\"}} {}", times.count)?;
    let label = if label.is_empty() { String::new() } else { format!("{{{label}}}") };
    writeln!(out, "katydid_{name}_sum{label} {}", times.sum)?;
    writeln!(out, "katydid_{name}_count{label} {}", times.count)
}

fn write(service: &Service, out: &mut String) -> std::fmt::Result {
    let mut gauge = |name: &str, kind: &str, help: &str, value: f64| {
        head(out, name, kind, help)?;
        writeln!(out, "katydid_{name} {value}")
    };
    let load = service.pool.load();
    let count = |n: usize| n as f64;
    gauge("uptime_seconds", "gauge", "Time since the server started.", service.idle.uptime().as_secs_f64())?;
    gauge("solves_waiting", "gauge", "Requests that wait for their turn.", count(load.waiting))?;
    gauge("solves_running", "gauge", "Requests that are being solved.", count(load.running))?;
    gauge("solve_places", "gauge", "How many can be solved at a time.", count(service.config.workers()))?;
    gauge("threads_lost", "gauge", "Threads that have been given up.", count(load.lost))?;
    gauge("threads_stuck", "gauge", "Threads that do not stop though they were told to.", count(load.stuck))?;
    gauge("failures_total", "counter", "Solves that failed as they must not.", load.failed as f64)?;
    let taken = service.memory.taken() as f64;
    gauge("common_memory_bytes", "gauge", "Memory that requests take beyond their shares.", taken)?;
    if let Some(bytes) = resident() {
        gauge("resident_memory_bytes", "gauge", "Memory that the process takes.", bytes as f64)?;
    }
    head(out, "build_info", "gauge", "The version that runs.")?;
    writeln!(out, "katydid_build_info{{version=\"{}\"}} 1", env!("CARGO_PKG_VERSION"))?;
    head(out, "jobs", "gauge", "Jobs that are kept, by how far they are.")?;
    for (state, n) in service.jobs.counts() {
        writeln!(out, "katydid_jobs{{state=\"{state}\"}} {n}")?;
    }
    let counts = held(&service.metrics.0);
    head(
        out,
        "requests_total",
        "counter",
        "Requests answered, by address and status; 499 for who left before.",
    )?;
    for ((path, status), n) in &counts.requests {
        writeln!(out, "katydid_requests_total{{path=\"{path}\",status=\"{status}\"}} {n}")?;
    }
    head(out, "request_seconds", "histogram", "How long answers took, by address.")?;
    for (path, times) in &counts.times {
        histogram(out, "request_seconds", &format!("path=\"{path}\""), times)?;
    }
    head(out, "received_bytes_total", "counter", "Bytes of requests.")?;
    writeln!(out, "katydid_received_bytes_total {}", counts.received)?;
    head(out, "sent_bytes_total", "counter", "Bytes of answers.")?;
    writeln!(out, "katydid_sent_bytes_total {}", counts.sent)?;
    head(out, "solves_total", "counter", "Solves, by what came of them.")?;
    for (outcome, n) in &counts.solves {
        writeln!(out, "katydid_solves_total{{outcome=\"{outcome}\"}} {n}")?;
    }
    head(out, "solve_seconds", "histogram", "How long solves took.")?;
    histogram(out, "solve_seconds", "", &counts.solve_time)
}

/// The memory that this process takes, where the system tells.
fn resident() -> Option<u64> {
    const PAGE: u64 = 4096;
    let text = std::fs::read_to_string("/proc/self/statm").ok()?;
    text.split_ascii_whitespace().nth(1)?.parse::<u64>().ok()?.checked_mul(PAGE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_of_two_processes() {
        let page = |outcomes: &str| {
            format!(
                "# HELP katydid_uptime_seconds Time.\n# TYPE katydid_uptime_seconds gauge\nkatydid_uptime_seconds 7\n\
                 # TYPE katydid_solves_total counter\n{outcomes}# TYPE katydid_solve_seconds histogram\n\
                 katydid_solve_seconds_bucket{{le=\"0.1\"}} 2\nkatydid_solve_seconds_sum 0.5\n"
            )
        };
        let own = page("katydid_solves_total{outcome=\"ok\"} 3\n");
        let other =
            page("katydid_solves_total{outcome=\"ok\"} 4\nkatydid_solves_total{outcome=\"late\"} 1\n");
        let sum = added(&own, &other);
        let wanted =
            page("katydid_solves_total{outcome=\"ok\"} 7\nkatydid_solves_total{outcome=\"late\"} 1\n")
                .replace("} 2\n", "} 4\n")
                .replace("sum 0.5", "sum 1");
        assert_eq!(sum, wanted);
        assert_eq!(added(&page(""), &other).matches("katydid_solves_total{").count(), 2);
    }
}
