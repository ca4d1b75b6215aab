//! 502 after about five minutes; long jobs need submit, poll, fetch (compute.rhino3d#589, #913).

use std::time::Duration;

use katydid_server::compute::Config;
use serde_json::{Value, json};
use tokio::time::{Instant, sleep};

use crate::client::{Compute, WAIT, input};
use crate::definitions::{SUM, gh};

async fn submit(compute: &Compute, a: f64) -> String {
    let body = json!({"algo": gh(SUM), "values": [input("RH_IN:A", "0", &[json!(a)])]});
    let answer = compute.post("/jobs", &body).await;
    assert_eq!(answer.status, 202, "{}", answer.text());
    answer.header("location").to_owned()
}

async fn polled(compute: &Compute, place: &str) -> Value {
    let start = Instant::now();
    loop {
        let about = compute.get(place).await.json();
        if !["waiting", "running"].contains(&about["state"].as_str().unwrap()) {
            return about;
        }
        assert!(start.elapsed() < WAIT, "{about}");
        sleep(Duration::from_millis(10)).await;
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn long_work_is_submitted_polled_and_fetched() {
    let compute = Compute::start().await;
    let places = [submit(&compute, 4.0).await, submit(&compute, 7.0).await];
    for (place, sum) in places.iter().zip([7.0, 10.0]) {
        let about = polled(&compute, place).await;
        assert_eq!((&about["state"], &about["hasErrors"]), (&json!("done"), &json!(false)), "{about}");
        let result = compute.get(about["result"].as_str().unwrap()).await;
        assert_eq!(result.output("RH_OUT:sum"), sum);
    }
    // Who has fetched a result need not leave it there.
    assert_eq!(compute.ask("DELETE", &places[0], "", b"").await.json()["state"], "done");
    assert_eq!(compute.get(&places[0]).await.status, 404);
    assert_eq!(compute.ask("DELETE", &places[0], "", b"").await.status, 404);
    assert_eq!(compute.get(&places[1]).await.status, 200);
}

#[tokio::test(flavor = "multi_thread")]
async fn results_are_kept_in_number_and_age_within_limits() {
    let keep = Duration::from_millis(1500);
    let compute = Compute::start_with(|config| Config { most_jobs: 2, keep_jobs: keep, ..config }).await;
    let mut places = Vec::new();
    for a in 0..3 {
        let place = submit(&compute, f64::from(a)).await;
        polled(&compute, &place).await;
        places.push(place);
    }
    assert_eq!(compute.get(&places[0]).await.status, 404, "the oldest has made room");
    sleep(keep).await;
    for place in &places {
        assert_eq!(compute.get(place).await.status, 404, "too old");
    }
    compute.is_well().await;
}
