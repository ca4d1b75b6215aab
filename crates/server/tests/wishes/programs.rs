//! Run an external program (compute.rhino3d.appserver#78): never. Scripts only where they are allowed.

use std::sync::Arc;

use katydid_server::compute::Config;
use serde_json::json;

use crate::client::Compute;
use crate::definitions::gh;
use crate::stuck::{Gate, STUCK};

#[tokio::test(flavor = "multi_thread")]
async fn scripts_run_only_where_they_are_allowed() {
    let closed = Compute::start().await;
    let answer = closed.solve(&gh(STUCK), json!([])).await;
    assert_eq!(answer.status, 500);
    assert!(answer.text().contains("this server was started without --allow-scripts"), "{}", answer.text());
    let gate = Gate::default();
    gate.open();
    let scripts = Arc::new(gate);
    let open = Compute::start_with(|config| Config { scripts: Some(scripts), ..config }).await;
    let answer = open.solve(&gh(STUCK), json!([])).await;
    assert!(answer.text().contains("the gate was opened"), "it was run: {}", answer.text());
}

#[tokio::test(flavor = "multi_thread")]
async fn what_is_sent_to_be_run_is_refused() {
    let gate = Gate::default();
    gate.open();
    let scripts = Arc::new(gate);
    // Whether scripts of definitions run or not.
    for compute in
        [Compute::start().await, Compute::start_with(|c| Config { scripts: Some(scripts), ..c }).await]
    {
        for path in ["/script/evaluate", "/script/python3", "/script/csharp", "/script/run"] {
            let answer = compute.post(path, &json!({"language": "python3", "script": "x = 1"})).await;
            assert_eq!(answer.status, 403, "{path}: {}", answer.text());
        }
        let answer = compute.post("/rhino/python/evaluate", &json!(["x = 1", "{}", []])).await;
        assert_eq!(answer.status, 501, "{}", answer.text());
        for path in ["/run", "/exec", "/shell", "/launch"] {
            assert_eq!(compute.post(path, &json!({"command": "id"})).await.status, 404, "{path}");
        }
    }
}

/// A component of a plug-in that would run a program is not there: it is named, and nothing is run.
#[tokio::test(flavor = "multi_thread")]
async fn components_that_run_programs_are_named_and_not_run() {
    let room = tempfile::tempdir().unwrap();
    let made = room.path().join("made");
    let text = format!(
        "katydid 1\nw = `Run Program` @11111111-2222-3333-4444-666666666666(Program = \"touch {}\") variable -> Out\n\
         \"RH_OUT:out\": w\n",
        made.display()
    );
    let compute = Compute::start().await;
    let answer = compute.solve(&gh(&text), json!([])).await;
    assert_eq!(answer.status, 500);
    assert!(answer.text().contains("Run Program"), "{}", answer.text());
    assert!(!made.exists());
}
