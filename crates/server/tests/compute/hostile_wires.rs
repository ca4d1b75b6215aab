//! Definitions whose wires, ids and names make no sense.

use std::time::Duration;

use katydid_definition::document::{Document, Object};
use katydid_definition::kd;
use serde_json::json;
use tokio::time::Instant;
use uuid::Uuid;

use crate::client::{Answer, Compute, base64};
use crate::definitions::gh;

/// Two sums, one of the other: `first = a + b`, `second = first + b`.
const SUMS: &str = "katydid 1\na = Number Slider(2.0, 0..10)\nb = Number Slider(3.0, 0..10)\nfirst = Addition(a, b)\n\
    second = Addition(first, b)\n\"RH_OUT:x\": second\n";

/// The definition with a change that no text of ours can say.
fn changed(change: impl FnOnce(&mut Document)) -> String {
    katydid_components::link();
    let mut document = kd::read(SUMS, &katydid_session::Registry).unwrap().document;
    change(&mut document);
    base64(document.to_gh().unwrap())
}

fn at(document: &Document, nickname: &str) -> usize {
    document.objects.iter().position(|object| object.nickname == nickname).unwrap()
}

fn wire(document: &mut Document, to: &str, sources: &[Uuid]) {
    let at = at(document, to);
    document.objects[at].set_sources(0, sources).unwrap();
}

fn output(document: &Document, of: &str) -> Uuid {
    document.objects[at(document, of)].outputs[0].id
}

/// The whole reply, with what is wrong in it.
fn says(answer: &Answer) -> bool {
    answer.status == 500 && answer.json()["errors"].as_array().is_some_and(|errors| !errors.is_empty())
}

#[tokio::test(flavor = "multi_thread")]
async fn wires_that_run_in_circles() {
    let compute = Compute::start_with(|config| katydid_server::compute::Config {
        timeout: Duration::from_secs(20),
        ..config
    })
    .await;
    for (what, algo) in [
        (
            "each other",
            changed(|document| {
                let second = output(document, "second");
                wire(document, "first", &[second]);
            }),
        ),
        (
            "itself",
            changed(|document| {
                let second = output(document, "second");
                wire(document, "second", &[second]);
            }),
        ),
    ] {
        let answer = compute.solve(&algo, json!([])).await;
        assert!(says(&answer) || answer.is_refused(), "{what}: {} {}", answer.status, answer.text());
        assert_eq!(compute.post("/io", &json!({ "algo": algo })).await.status, 200, "{what}");
    }
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn wires_that_are_many_or_lead_nowhere() {
    let compute = Compute::start().await;
    let nowhere = changed(|document| wire(document, "first", &[Uuid::from_u128(1), Uuid::nil()]));
    let answer = compute.solve(&nowhere, json!([])).await;
    assert!(answer.status == 200 || says(&answer), "{} {}", answer.status, answer.text());
    let many = changed(|document| {
        let slider = document.objects[at(document, "a")].id;
        wire(document, "first", &vec![slider; 20_000]);
    });
    let start = Instant::now();
    let answer = compute.solve(&many, json!([])).await;
    assert!(answer.status == 200 || says(&answer) || answer.is_refused(), "{:.300}", answer.text());
    assert!(start.elapsed() < Duration::from_secs(60), "{:?}", start.elapsed());
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn ids_and_names_that_are_odd() {
    let compute = Compute::start().await;
    let twins = changed(|document| {
        let (a, b) = (document.objects[at(document, "a")].id, at(document, "b"));
        document.objects[b].container_mut().set("InstanceGuid", a);
        document.objects[b].refresh();
    });
    let strangers = changed(|document| {
        for n in 0..10_000 {
            let id = Uuid::from_u128(0x1000_0000 + n);
            document.objects.push(Object::new_component(Uuid::from_u128(n + 1), "Stranger", "S", id));
        }
    });
    let long = gh(&SUMS.replace("RH_OUT:x", &format!("RH_OUT:{}", "x".repeat(1 << 20))));
    let labels: String = (0..10_000).map(|n| format!("\"RH_OUT:{n}\": second\n")).collect();
    let outputs = gh(&format!("{SUMS}{labels}"));
    for (what, algo) in
        [("twins", twins), ("strangers", strangers), ("a long name", long), ("outputs", outputs)]
    {
        let start = Instant::now();
        let answer = compute.solve(&algo, json!([])).await;
        let is_whole = answer.status == 200 || says(&answer);
        assert!(is_whole || answer.is_refused(), "{what}: {} {:.300}", answer.status, answer.text());
        assert!(start.elapsed() < Duration::from_secs(60), "{what}: {:?}", start.elapsed());
        let io = compute.post("/io", &json!({ "algo": algo })).await;
        assert!(io.status == 200 || io.is_refused(), "{what}: {} {:.300}", io.status, io.text());
    }
    compute.is_well().await;
}
