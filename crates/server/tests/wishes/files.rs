//! A definition by its path: .ghx fails (compute.rhino3d#591).

use katydid_server::compute::Config;
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::client::{Compute, base64};
use crate::definitions::{SUM, bytes, ghx};

async fn serving() -> (Compute, TempDir) {
    let room = tempfile::tempdir().unwrap();
    let folder = room.path().join("definitions");
    std::fs::create_dir_all(folder.join("roofs")).unwrap();
    std::fs::write(folder.join("sum.gh"), bytes(SUM)).unwrap();
    std::fs::write(folder.join("roofs/sum.ghx"), ghx(&SUM.replace("3.0", "4.0"))).unwrap();
    std::fs::write(folder.join("sum.txt"), bytes(SUM)).unwrap();
    std::fs::write(folder.join("broken.ghx"), "<Archive>").unwrap();
    std::fs::write(room.path().join("secret.gh"), bytes(SUM)).unwrap();
    let definitions = vec![folder];
    (Compute::start_with(|config| Config { definitions, ..config }).await, room)
}

#[tokio::test(flavor = "multi_thread")]
async fn definitions_are_solved_by_path_and_by_hash() {
    let (compute, room) = serving().await;
    let ask = async |pointer: &Value| compute.post("/grasshopper", &json!({"pointer": pointer})).await;
    let whole = room.path().join("definitions/roofs/sum.ghx").display().to_string();
    for (path, sum) in [("sum.gh", 5.0), ("roofs/sum.ghx", 6.0), (whole.as_str(), 6.0)] {
        let answer = ask(&json!(path)).await;
        assert_eq!(answer.output("RH_OUT:sum"), sum, "{path}: {}", answer.text());
        let key = answer.json()["pointer"].clone();
        assert!(key.as_str().unwrap().starts_with("md5_"), "{key}");
        assert_eq!(ask(&key).await.output("RH_OUT:sum"), sum);
    }
    // The key is that of who sends the file, .ghx too.
    let sent = compute.solve(&base64(ghx(SUM)), json!([])).await;
    assert_eq!(ask(&sent.json()["pointer"]).await.output("RH_OUT:sum"), 5.0);
    let io = compute.get("/io?pointer=roofs%2Fsum.ghx").await;
    assert_eq!(io.json()["InputNames"], json!(["RH_IN:A", "RH_IN:B"]), "{}", io.text());
    // A file that was changed is read anew.
    std::fs::write(room.path().join("definitions/sum.gh"), bytes(&SUM.replace("3.0", "7.0"))).unwrap();
    assert_eq!(ask(&json!("sum.gh")).await.output("RH_OUT:sum"), 9.0);
}

#[tokio::test(flavor = "multi_thread")]
async fn nothing_else_is_read_by_path() {
    let (compute, room) = serving().await;
    let outside = room.path().join("secret.gh").display().to_string();
    for path in [
        "../secret.gh",
        outside.as_str(),
        "sum.txt",
        "none.gh",
        "roofs",
        "/etc/passwd",
        "broken.ghx",
        "/dev/zero",
    ] {
        let answer = compute.post("/grasshopper", &json!({"pointer": path})).await;
        assert!(answer.is_refused(), "{path}: {} {}", answer.status, answer.text());
        let told = answer.text().replace(path, "");
        assert!(!told.contains(room.path().to_str().unwrap()), "{told}");
    }
    let closed = Compute::start().await;
    let inside = room.path().join("definitions/sum.gh").display().to_string();
    let answer = closed.post("/grasshopper", &json!({"pointer": inside})).await;
    assert_eq!(answer.status, 403, "{}", answer.text());
    compute.is_well().await;
}
