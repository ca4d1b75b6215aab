//! Defaults and optional inputs, geometry too (compute.rhino3d#167, #406, #672).

use serde_json::json;

use crate::client::{Compute, input};
use crate::definitions::gh;

/// A curve that is kept in the parameter, a point and a number.
const KEPT: &str = "katydid 1\nc = Curve(circle(plane((0, 0, 0)), 2))\np = Point(point(3, 4, 0))\n\
    n = Number(7)\nempty = Number()\nl = Length(c)\nd = Distance(p, (0, 0, 0))\nm = Merge(n, empty)\n\
    \"RH_IN:curve\": c\n\"RH_IN:point\": p\n\"RH_IN:number\": n\n\"RH_IN:empty\": empty\n\
    \"RH_OUT:length\": l\n\"RH_OUT:distance\": d\n\"RH_OUT:numbers\": m\n";

#[tokio::test(flavor = "multi_thread")]
async fn what_is_left_out_has_its_default_geometry_too() {
    let compute = Compute::start().await;
    let algo = gh(KEPT);
    let circle = 4.0 * std::f64::consts::PI;
    let near = |got: serde_json::Value, wanted: f64| (got.as_f64().unwrap() - wanted).abs() < 1e-9;
    let line = json!([{"X": 0, "Y": 0, "Z": 0}, {"X": 0, "Y": 5, "Z": 0}]);
    let changed = compute.solve(&algo, json!([input("RH_IN:curve", "0", &[line])])).await;
    assert!(near(changed.output("RH_OUT:length"), 5.0), "{}", changed.text());
    // The one that was sent before has left nothing behind.
    let answer = compute.solve(&algo, json!([])).await;
    assert_eq!(answer.status, 200, "{}", answer.text());
    assert!(near(answer.output("RH_OUT:length"), circle), "{}", answer.text());
    assert_eq!(answer.output("RH_OUT:distance"), 5.0);
    assert_eq!(answer.output("RH_OUT:numbers"), 7.0);
    let io = compute.post("/io", &json!({"algo": algo})).await.json();
    let inputs = io["Inputs"].as_array().unwrap();
    let find = |name: &str| inputs.iter().find(|one| one["Name"] == name).unwrap_or_else(|| panic!("{io}"));
    let default = |name: &str| find(name)["Default"]["InnerTree"]["{0}"][0]["data"].clone();
    assert_eq!(default("RH_IN:number"), "7.0");
    assert!(default("RH_IN:point").as_str().unwrap().contains("\"X\":3.0"), "{io}");
    assert!(default("RH_IN:curve").as_str().unwrap().contains("\"archive3dm\""), "{io}");
    assert_eq!(default("RH_IN:empty"), json!(null));
}
