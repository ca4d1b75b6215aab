//! No request sees what another one brought.

use serde_json::json;

use crate::client::{Compute, input};
use crate::definitions::{SUM, gh};

#[tokio::test(flavor = "multi_thread")]
async fn what_is_left_out_is_as_the_definition_has_it() {
    let compute = Compute::start().await;
    let first = compute.solve(&gh(SUM), json!([input("RH_IN:A", "0", &[json!(7)])])).await;
    assert_eq!(first.output("RH_OUT:sum"), 10.0);
    let pointer = first.json()["pointer"].clone();
    for _ in 0..3 {
        let second = compute.post("/grasshopper", &json!({"pointer": pointer, "values": []})).await;
        assert_eq!(second.output("RH_OUT:sum"), 5.0);
    }
    let named_otherwise = json!([input("nobody", "0", &[json!(7)])]);
    let answer = compute.solve(&gh(SUM), named_otherwise).await;
    assert_eq!(answer.output("RH_OUT:sum"), 5.0);
}

#[tokio::test(flavor = "multi_thread")]
async fn fifty_at_a_time_on_one_definition() {
    let compute = Compute::start().await;
    let algo = gh(SUM);
    let pointer = compute.solve(&algo, json!([])).await.json()["pointer"].clone();
    let ask = async |n: usize| {
        let a = n % 11;
        let values = json!([input("RH_IN:A", "0", &[json!(a)])]);
        let body = if n.is_multiple_of(3) {
            json!({"algo": algo, "values": values})
        } else {
            json!({"pointer": pointer, "values": values, "cachesolve": n.is_multiple_of(2)})
        };
        let answer = compute.post("/grasshopper", &body).await;
        assert_eq!(answer.status, 200, "{}", answer.text());
        assert_eq!(answer.output("RH_OUT:sum"), a as f64 + 3.0);
    };
    let all: Vec<_> = (0..200).map(ask).collect();
    futures_util::future::join_all(all).await;
}
