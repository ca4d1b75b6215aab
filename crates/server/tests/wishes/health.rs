//! A hung child still answers "Healthy" (compute.rhino3d#468); nobody can tell busy from dead.

use std::sync::Arc;
use std::time::Duration;

use katydid_server::compute::Config;
use serde_json::{Value, json};
use tokio::time::{Instant, sleep};

use crate::client::{Answer, Compute, WAIT};
use crate::definitions::{SUM, endless, gh};
use crate::stuck::{Gate, STUCK};

async fn started(gate: &Gate) -> Compute {
    let scripts = Arc::new(gate.clone());
    Compute::start_with(|config| Config {
        scripts: Some(scripts),
        timeout: Duration::from_millis(300),
        ..config
    })
    .await
}

/// The first answer of the health check with that status, and when it came.
pub(crate) async fn until(compute: &Compute, status: u16) -> (Answer, Duration) {
    let start = Instant::now();
    loop {
        let answer = compute.get("/healthcheck").await;
        if answer.status == status {
            return (answer, start.elapsed());
        }
        assert!(start.elapsed() < WAIT, "{}", answer.text());
        sleep(Duration::from_millis(20)).await;
    }
}

/// What is told when a worker is stuck, how others are served meanwhile, and what is told when it is back.
pub(crate) async fn is_told(compute: &Compute, gate: &Gate) {
    let (answer, took) = until(compute, 503).await;
    println!("a stuck worker was told after {took:?}");
    assert_eq!(answer.text(), "Unhealthy: workers: 1 were told to stop and do not");
    let told: Value = compute.get("/healthcheck?format=json").await.json();
    assert_eq!((&told["status"], &told["stuck"]), (&json!("unhealthy"), &json!(1)), "{told}");
    // Another thread has its place.
    assert_eq!(compute.solve(&gh(SUM), json!([])).await.output("RH_OUT:sum"), 5.0);
    assert!(compute.get("/metrics").await.text().contains("\nkatydid_threads_stuck 1\n"));
    gate.open();
    let (answer, took) = until(compute, 200).await;
    println!("that it is back was told after {took:?}");
    assert_eq!(answer.text(), "Healthy");
    let told = compute.get("/healthcheck?format=json").await.json();
    assert_eq!((&told["status"], &told["stuck"]), (&json!("healthy"), &json!(0)), "{told}");
}

#[tokio::test(flavor = "multi_thread")]
async fn health_turns_bad_soon_after_a_worker_is_stuck_and_good_when_it_is_back() {
    let gate = Gate::default();
    let compute = started(&gate).await;
    let late = compute.solve(&gh(STUCK), json!([])).await;
    assert_eq!(late.status, 408, "{}", late.text());
    is_told(&compute, &gate).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn busy_is_told_from_dead() {
    let compute = Compute::start_with(|config| Config { workers: Some(1), ..config }).await;
    let body = json!({"algo": gh(&endless(0))});
    let mut jobs = Vec::new();
    // More than can run at a time, all of them within their time.
    for _ in 0..12 {
        jobs.push(compute.post("/jobs", &body).await.json()["id"].as_str().unwrap().to_owned());
    }
    sleep(Duration::from_secs(1)).await;
    for _ in 0..3 {
        let answer = compute.get("/healthcheck").await;
        let text = answer.text();
        assert_eq!(answer.status, 200, "{text}");
        assert!(text == "Healthy" || text.starts_with("Busy: "), "{text}");
        let told = compute.get("/healthcheck?format=json").await.json();
        assert!(told["running"].as_u64().unwrap() > 0 && told["waiting"].as_u64().unwrap() > 0, "{told}");
        assert_eq!(told["stuck"], 0, "{told}");
    }
    for id in jobs {
        compute.ask("DELETE", &format!("/jobs/{id}"), "", b"").await;
    }
    compute.is_well().await;
}
