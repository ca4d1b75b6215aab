//! Solves without end, and clients that leave.

use std::time::Duration;

use futures_util::future::join_all;
use katydid_server::compute::Config;
use serde_json::json;
use tokio::io::AsyncWriteExt;
use tokio::time::{Instant, sleep};

use crate::client::{Compute, input};
use crate::definitions::{SUM, endless, gh};

fn figure(metrics: &str, name: &str) -> f64 {
    let line = metrics.lines().find(|line| line.split(' ').next() == Some(name));
    line.and_then(|line| line.split(' ').nth(1)?.parse().ok()).unwrap_or(0.0)
}

async fn figures(compute: &Compute, name: &str) -> f64 {
    figure(&compute.get("/metrics").await.text(), name)
}

#[tokio::test(flavor = "multi_thread")]
async fn a_hundred_solves_without_end_are_stopped_and_others_are_served() {
    let time = Duration::from_secs(3);
    let compute = Compute::start_with(|config| Config { timeout: time, ..config }).await;
    let sum = gh(SUM);
    assert_eq!(compute.solve(&sum, json!([])).await.status, 200);
    let definitions: Vec<String> = (0..10).map(|n| gh(&endless(n))).collect();
    let start = Instant::now();
    let late = join_all((0..100).map(|n| compute.solve(&definitions[n % 10], json!([]))));
    let others = async {
        let mut worst = Duration::ZERO;
        sleep(Duration::from_millis(200)).await;
        let mut asked = 0;
        while start.elapsed() < time {
            let from = Instant::now();
            let answer = compute.solve(&sum, json!([input("RH_IN:A", "0", &[json!(1)])])).await;
            assert_eq!(answer.status, 200, "{}", answer.text());
            assert_eq!(answer.output("RH_OUT:sum"), 4.0);
            worst = worst.max(from.elapsed());
            asked += 1;
            sleep(Duration::from_millis(20)).await;
        }
        (worst, asked)
    };
    let (late, (worst, asked)) = tokio::join!(late, others);
    for answer in &late {
        assert_eq!(answer.status, 408, "{}", answer.text());
        assert_eq!(answer.json()["cause"], "timed-out");
        assert!(answer.is_refused());
    }
    let took = start.elapsed();
    assert!(took < time + Duration::from_secs(5), "{took:?}");
    println!("{asked} others were served meanwhile, the slowest in {worst:?}; all was over after {took:?}");
    assert!(asked >= 2, "{asked}");
    compute.is_well().await;
    // None goes on behind the scenes.
    sleep(Duration::from_secs(1)).await;
    assert_eq!(figures(&compute, "katydid_solves_running").await, 0.0);
}

#[tokio::test(flavor = "multi_thread")]
async fn who_leaves_is_not_worked_for() {
    let compute = Compute::start().await;
    let body = json!({"algo": gh(&endless(0))}).to_string();
    let mut leaving = Vec::new();
    for _ in 0..12 {
        let mut stream = compute.connect().await;
        let head = format!(
            "POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nContent-Length: {}\r\n\r\n",
            body.len()
        );
        stream.write_all(format!("{head}{body}").as_bytes()).await.unwrap();
        leaving.push(stream);
    }
    sleep(Duration::from_millis(800)).await;
    assert!(figures(&compute, "katydid_solves_running").await >= 1.0);
    drop(leaving);
    let start = Instant::now();
    while figures(&compute, "katydid_solves_running").await
        + figures(&compute, "katydid_solves_waiting").await
        > 0.0
    {
        assert!(start.elapsed() < Duration::from_secs(10), "they go on");
        sleep(Duration::from_millis(50)).await;
    }
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_request_may_ask_for_less() {
    let compute = Compute::start().await;
    let body = json!({"algo": gh(&endless(0))});
    let start = Instant::now();
    let answer = compute.post("/grasshopper?seconds=0.4", &body).await;
    assert_eq!(answer.status, 408, "{}", answer.text());
    assert!(answer.text().contains("0.4 seconds") && start.elapsed() < Duration::from_secs(5));
    for query in ["seconds=-1", "seconds=NaN", "seconds=x", "items=-1", "items=1e3", "bytes=x"] {
        assert_eq!(compute.post(&format!("/grasshopper?{query}"), &body).await.status, 400, "{query}");
    }
    let answer = compute.post("/grasshopper?items=1000", &body).await;
    assert_eq!(answer.status, 500, "a component says that there are too many");
    assert!(answer.json()["errors"][0].as_str().unwrap().contains("1000 items"));
    let more = Compute::start_with(|config| Config { timeout: Duration::from_secs(1), ..config }).await;
    assert_eq!(more.post("/grasshopper?seconds=1000", &body).await.status, 408, "never more");
}

#[tokio::test(flavor = "multi_thread")]
async fn only_so_many_wait() {
    let compute = Compute::start_with(|config| Config {
        most_waiting: 4,
        workers: Some(1),
        timeout: Duration::from_secs(3),
        ..config
    })
    .await;
    let body = json!({"algo": gh(&endless(0))});
    let all = join_all((0..20).map(|_| compute.post("/grasshopper", &body))).await;
    let full: Vec<_> = all.iter().filter(|answer| answer.status == 503).collect();
    assert!(full.len() >= 10, "{} were sent away", full.len());
    assert!(full.iter().all(|answer| answer.header("retry-after").parse::<u32>().is_ok()));
    assert!(all.iter().all(|answer| matches!(answer.status, 408 | 503)));
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn what_is_under_way_is_finished_when_it_stops() {
    let compute = Compute::start_with(|config| Config { timeout: Duration::from_secs(2), ..config }).await;
    let address = compute.host();
    let body = json!({"algo": gh(&endless(0))}).to_string();
    let mut stream = compute.connect().await;
    let head =
        format!("POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nContent-Length: {}\r\n\r\n", body.len());
    stream.write_all(format!("{head}{body}").as_bytes()).await.unwrap();
    sleep(Duration::from_millis(300)).await;
    let answered = async {
        let mut heard = Vec::new();
        crate::client::next(&mut stream, &mut heard).await
    };
    let ((), answer) = tokio::join!(compute.server.stop(), answered);
    assert_eq!(answer.status, 408, "it was let end");
    assert!(tokio::net::TcpStream::connect(address).await.is_err(), "nobody listens");
}
