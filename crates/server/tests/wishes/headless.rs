//! Optimisers and timers do nothing headless (compute.rhino3d#134, open since 2020): here they say so.

use serde_json::{Value, json};

use crate::client::Compute;
use crate::definitions::gh;

fn warned(reply: &Value, member: &str, word: &str) -> bool {
    reply[member].as_array().is_some_and(|all| all.iter().any(|one| one.as_str().unwrap().contains(word)))
}

#[tokio::test(flavor = "multi_thread")]
async fn optimisers_and_timers_say_that_nobody_starts_them() {
    let compute = Compute::start().await;
    let text = "katydid 1\na = Number Slider(2.0, 0..10)\nsum = Addition(a, 3)\nsearch = Galapagos()\n\
        clock = Trigger(sum, interval = 500)\n\"RH_IN:A\": a\n\"RH_OUT:sum\": sum\n";
    let answer = compute.solve(&gh(text), json!([])).await;
    assert_eq!(answer.output("RH_OUT:sum"), 5.0);
    for (word, way) in
        [("Galapagos does not search", "katydid optimise"), ("trigger does not fire", "--ticks")]
    {
        let reply = answer.json();
        assert!(warned(&reply, "warnings", word) && warned(&reply, "warnings", way), "{reply}");
        let io = compute.post("/io", &json!({"algo": gh(text)})).await.json();
        assert!(warned(&io, "Warnings", word), "{io}");
    }
    let plain = compute.solve(&gh(crate::definitions::SUM), json!([])).await.json();
    assert_eq!(plain["warnings"], Value::Null, "only who has one is told");
}

#[tokio::test(flavor = "multi_thread")]
async fn an_optimiser_of_a_plug_in_is_named() {
    let compute = Compute::start().await;
    let text = "katydid 1\na = Number Slider(2.0, 0..10)\n\
        w = `Wallacei X` @11111111-2222-3333-4444-555555555555(Genes = a) variable -> Best\n\
        \"RH_IN:A\": a\n\"RH_OUT:best\": w\n";
    let answer = compute.solve(&gh(text), json!([])).await;
    assert_eq!(answer.status, 500);
    assert!(warned(&answer.json(), "errors", "Wallacei X"), "{}", answer.text());
}
