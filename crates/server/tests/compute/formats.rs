//! Results as files.

use serde_json::json;

use crate::client::{Compute, input};
use crate::definitions::{SPHERE, SUM, gh};

#[tokio::test(flavor = "multi_thread")]
async fn results_as_files() {
    let compute = Compute::start().await;
    let body = json!({"algo": gh(SPHERE), "values": [input("RH_IN:r", "0", &[json!(3)])]});
    let file = async |name: &str| {
        let answer = compute.post(&format!("/grasshopper?format={name}"), &body).await;
        assert_eq!(answer.status, 200, "{name}: {}", answer.text());
        assert!(answer.header("content-disposition").contains(&format!("result.{name}\"")));
        assert!(answer.header("server-timing").contains("solve;dur="));
        answer
    };
    let model = katydid_3dm::Model::read(&file("3dm").await.body, &Default::default()).unwrap();
    assert_eq!(model.objects.len(), 1);
    assert!(file("glb").await.body.starts_with(b"glTF"));
    // Eighty bytes, the number of triangles, and fifty bytes each.
    let stl = file("stl").await.body;
    let count = u32::from_le_bytes(stl[80..84].try_into().unwrap()) as usize;
    assert!(count > 100 && stl.len() == 84 + 50 * count);
    assert!(file("step").await.text().starts_with("ISO-10303-21"));
    assert!(compute.post("/grasshopper?format=exe", &body).await.is_refused());
    assert_eq!(compute.post("/grasshopper?format=json", &body).await.status, 200);
    // Numbers are no geometry: the file has none.
    let answer = compute.post("/grasshopper?format=3dm", &json!({"algo": gh(SUM)})).await;
    assert_eq!(answer.status, 200);
    assert!(katydid_3dm::Model::read(&answer.body, &Default::default()).unwrap().objects.is_empty());
}
