//! Solves that nobody waits for.

use std::time::Duration;

use katydid_server::compute::Config;
use serde_json::{Value, json};
use tokio::time::{Instant, sleep};

use crate::client::{Compute, WAIT, input};
use crate::definitions::{SPHERE, SUM, endless, gh};

async fn submitted(compute: &Compute, path: &str, body: &Value) -> String {
    let answer = compute.post(path, body).await;
    assert_eq!(answer.status, 202, "{}", answer.text());
    let id = answer.json()["id"].as_str().unwrap().to_owned();
    assert_eq!(answer.header("location"), format!("/jobs/{id}"));
    id
}

async fn until(compute: &Compute, id: &str, is_so: impl Fn(&str) -> bool) -> Value {
    let start = Instant::now();
    loop {
        let about = compute.get(&format!("/jobs/{id}")).await.json();
        if is_so(about["state"].as_str().unwrap()) {
            return about;
        }
        assert!(start.elapsed() < WAIT, "{about}");
        sleep(Duration::from_millis(10)).await;
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_job_is_done_and_its_result_kept() {
    let compute = Compute::start().await;
    let body = json!({"algo": gh(SUM), "values": [input("RH_IN:A", "0", &[json!(4)])]});
    let id = submitted(&compute, "/jobs", &body).await;
    let about = until(&compute, &id, |state| state == "done").await;
    assert_eq!(about["hasErrors"], false);
    let path = about["result"].as_str().unwrap().to_owned();
    for _ in 0..2 {
        assert_eq!(compute.get(&path).await.output("RH_OUT:sum"), 7.0);
    }
    let events = compute.get(&format!("/jobs/{id}/events")).await;
    assert_eq!(events.header("content-type"), "text/event-stream");
    assert!(events.text().contains("event: done\ndata: {"), "{}", events.text());
    let id = submitted(&compute, "/JOBS/", &json!({"algo": gh(SPHERE)})).await;
    until(&compute, &id, |state| state == "done").await;
    let file = compute.get(&format!("/jobs/{id}/result?format=glb")).await;
    assert!(file.status == 200 && file.body.starts_with(b"glTF"));
    assert!(compute.get(&format!("/jobs/{id}/result?format=exe")).await.is_refused());
}

#[tokio::test(flavor = "multi_thread")]
async fn a_job_that_fails_says_why() {
    let compute = Compute::start().await;
    for body in [json!({}), json!({"algo": "%%%"}), json!({"pointer": "/etc/passwd"})] {
        let id = submitted(&compute, "/jobs", &body).await;
        let about = until(&compute, &id, |state| state == "failed").await;
        assert!(about["error"].is_string() && about["cause"].is_string());
        assert!(compute.get(&format!("/jobs/{id}/result")).await.is_refused());
    }
    let missing = "0".repeat(32);
    for path in ["", "/events", "/result"] {
        assert_eq!(compute.get(&format!("/jobs/{missing}{path}")).await.status, 404);
    }
    assert_eq!(compute.ask("DELETE", &format!("/jobs/{missing}"), "", b"").await.status, 404);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_job_is_followed_stopped_and_stopped_by_time() {
    let compute = Compute::start().await;
    let id = submitted(&compute, "/jobs", &json!({"algo": gh(&endless(0))})).await;
    until(&compute, &id, |state| state == "running").await;
    assert_eq!(compute.get(&format!("/jobs/{id}/result")).await.status, 202);
    let path = format!("/jobs/{id}/events");
    let (events, stopped) = tokio::join!(compute.get(&path), async {
        sleep(Duration::from_secs(2)).await;
        compute.ask("DELETE", &format!("/jobs/{id}"), "", b"").await
    });
    assert_eq!(stopped.json()["state"], "cancelled");
    let text = events.text();
    assert!(text.contains("event: progress\n") && text.contains("event: cancelled\n"), "{text}");
    assert_eq!(compute.get(&format!("/jobs/{id}/result")).await.status, 410);
    let id = submitted(&compute, "/jobs?seconds=0.5", &json!({"algo": gh(&endless(1))})).await;
    let about = until(&compute, &id, |state| state == "failed").await;
    assert_eq!(about["cause"], "timed-out");
    assert_eq!(compute.get(&format!("/jobs/{id}/result")).await.status, 408);
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn only_so_many_are_kept() {
    let compute =
        Compute::start_with(|config| Config { most_jobs: 3, keep_jobs: Duration::from_secs(1), ..config })
            .await;
    let body = json!({"algo": gh(SUM)});
    let first = submitted(&compute, "/jobs", &body).await;
    until(&compute, &first, |state| state == "done").await;
    let endless = json!({"algo": gh(&endless(2))});
    let mut running = Vec::new();
    for _ in 0..3 {
        running.push(submitted(&compute, "/jobs", &endless).await);
    }
    // The one that was done has made room; those that run do not.
    assert_eq!(compute.get(&format!("/jobs/{first}")).await.status, 404);
    let full = compute.post("/jobs", &body).await;
    assert_eq!(full.status, 503);
    assert!(!full.header("retry-after").is_empty());
    for id in &running {
        compute.ask("DELETE", &format!("/jobs/{id}"), "", b"").await;
    }
    sleep(Duration::from_millis(1200)).await;
    assert_eq!(compute.get(&format!("/jobs/{}", running[0])).await.status, 404);
    compute.is_well().await;
}
