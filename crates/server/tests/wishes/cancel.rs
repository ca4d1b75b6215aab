//! Cancel a running solve (compute.rhino3d#224, open since 2021).

use std::sync::Arc;
use std::time::Duration;

use katydid_server::compute::Config;
use serde_json::json;
use tokio::io::AsyncWriteExt;
use tokio::time::{Instant, sleep};

use crate::client::{Compute, WAIT};
use crate::definitions::{self, SUM, gh};
use crate::health::is_told;
use crate::stuck::{Gate, STUCK};

/// Many seconds of work, in steps that are short in a build that is not optimised, too.
fn endless(number: usize) -> String {
    definitions::endless(number).replace("4000000.0", "200000.0")
}

/// Waits until something is worked on or nothing is, not even what was given up; tells how long that took.
async fn until_running(compute: &Compute, wanted: bool) -> Duration {
    let start = Instant::now();
    loop {
        let metrics = compute.get("/metrics").await.text();
        let figure = |name: &str| {
            let line = metrics.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
            line.and_then(|figure| figure.parse::<f64>().ok()).expect("a figure")
        };
        let parts = ["katydid_solves_running", "katydid_solves_waiting", "katydid_threads_lost"];
        let works = parts.iter().any(|part| figure(part) > 0.0);
        if works == wanted {
            return start.elapsed();
        }
        assert!(start.elapsed() < WAIT, "{metrics}");
        sleep(Duration::from_millis(5)).await;
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_client_that_leaves_frees_the_core() {
    let compute = Compute::start_with(|config| Config { workers: Some(1), ..config }).await;
    let body = json!({"algo": gh(&endless(0))}).to_string();
    for _ in 0..3 {
        let mut stream = compute.connect().await;
        let head = format!(
            "POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nContent-Length: {}\r\n\r\n",
            body.len()
        );
        stream.write_all(format!("{head}{body}").as_bytes()).await.unwrap();
        until_running(&compute, true).await;
        sleep(Duration::from_millis(400)).await;
        drop(stream);
        println!("nothing ran any more {:?} after the client had left", until_running(&compute, false).await);
        assert_eq!(compute.solve(&gh(SUM), json!([])).await.output("RH_OUT:sum"), 5.0);
    }
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_job_that_is_cancelled_frees_the_core() {
    let compute = Compute::start_with(|config| Config { workers: Some(1), ..config }).await;
    // Some run and some wait: all are gone.
    let mut jobs = Vec::new();
    for n in 0..6 {
        let answer = compute.post("/jobs", &json!({"algo": gh(&endless(n))})).await;
        jobs.push(answer.json()["id"].as_str().unwrap().to_owned());
    }
    until_running(&compute, true).await;
    sleep(Duration::from_millis(400)).await;
    for id in &jobs {
        let answer = compute.ask("DELETE", &format!("/jobs/{id}"), "", b"").await;
        assert_eq!(answer.json()["state"], "cancelled");
    }
    println!("nothing ran any more {:?} after the jobs were cancelled", until_running(&compute, false).await);
    assert_eq!(compute.solve(&gh(SUM), json!([])).await.output("RH_OUT:sum"), 5.0);
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_cancelled_job_that_does_not_stop_is_given_up() {
    let gate = Gate::default();
    let scripts = Arc::new(gate.clone());
    let compute = Compute::start_with(|config| Config { scripts: Some(scripts), ..config }).await;
    let id = compute.post("/jobs", &json!({"algo": gh(STUCK)})).await.json()["id"].clone();
    let path = format!("/jobs/{}", id.as_str().unwrap());
    gate.holds().await;
    assert_eq!(compute.ask("DELETE", &path, "", b"").await.json()["state"], "cancelled");
    is_told(&compute, &gate).await;
}
