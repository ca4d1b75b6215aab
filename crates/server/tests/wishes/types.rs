//! Any type through (compute.rhino3d#335): a Data parameter hands on what it gets.

use serde_json::{Value, json};

use crate::client::{Compute, input};
use crate::definitions::gh;

const DATA: &str = "katydid 1\nd = Data()\ne = Data(d)\n\"RH_IN:d\": d\n\"RH_OUT:e\": e\n";
/// One of each type that the protocol does not know.
const OTHERS: &str = "katydid 1\nc = Colour Swatch(rgb(10, 20, 30))\nd = Construct Domain(1, 2)\n\
    t = Move((1, 0, 0), (0, 0, 2))\nz = Complex(complex(1, -1))\nall = Merge(c, d, t.Transform, z)\n\
    \"RH_OUT:all\": all\n";

fn first(reply: &Value) -> Vec<Value> {
    let branch = reply["values"][0]["InnerTree"].as_object().and_then(|tree| tree.values().next());
    branch.unwrap_or_else(|| panic!("{reply}")).as_array().unwrap().clone()
}

/// A circle of three units as an object of Rhino's, as this server writes it.
async fn object(compute: &Compute) -> String {
    let text = "katydid 1\nc = Circle(XY Plane(), 3)\nk = Curve(c)\n\"RH_OUT:k\": k\n";
    let answer = compute.solve(&gh(text), json!([])).await;
    first(&answer.json())[0]["data"].as_str().unwrap().to_owned()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_data_parameter_takes_any_type_and_gives_it_back() {
    let compute = Compute::start().await;
    let algo = gh(DATA);
    let curve = object(&compute).await;
    let point = json!({"X": 1.0, "Y": 2.5, "Z": -3.0}).to_string();
    let cases = [
        ("System.Int32", json!("7"), "7".to_owned()),
        ("System.Double", json!(7.5), "7.5".to_owned()),
        ("System.Boolean", json!("true"), "true".to_owned()),
        ("System.String", json!("\"a word\""), "\"a word\"".to_owned()),
        ("Rhino.Geometry.Point3d", json!(point), point.clone()),
        ("Rhino.Geometry.NurbsCurve", json!(curve), String::new()),
    ];
    let data: Vec<Value> = cases.iter().map(|(_, data, _)| data.clone()).collect();
    let answer = compute.solve(&algo, json!([input("RH_IN:d", "{1;2}", &data)])).await;
    assert_eq!(answer.status, 200, "{}", answer.text());
    let items = first(&answer.json());
    assert_eq!(items.len(), cases.len());
    for (item, (kind, _, text)) in items.iter().zip(&cases) {
        if text.is_empty() {
            assert!(item["type"].as_str().unwrap().starts_with("Rhino.Geometry."), "{item}");
            assert!(item["data"].as_str().unwrap().contains("\"opennurbs\""), "{item}");
        } else {
            assert_eq!((&item["type"], &item["data"]), (&json!(kind), &json!(text)));
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn types_that_the_protocol_does_not_know_are_told_or_sent_where_asked_for() {
    let compute = Compute::start().await;
    let body = json!({"algo": gh(OTHERS)});
    let plain = compute.post("/grasshopper", &body).await.json();
    assert!(first(&plain).is_empty(), "as Rhino.Compute has it: {plain}");
    assert!(plain["warnings"][0].as_str().unwrap().contains("items are left out"), "{plain}");
    let mut all = body.clone();
    all["alltypes"] = json!(true);
    let reply = compute.post("/grasshopper", &all).await.json();
    let items = first(&reply);
    let kinds: Vec<&str> = items.iter().map(|item| item["type"].as_str().unwrap()).collect();
    let wanted = [
        "System.Drawing.Color",
        "Rhino.Geometry.Interval",
        "Rhino.Geometry.Transform",
        "System.Numerics.Complex",
    ];
    assert_eq!(kinds, wanted, "{reply}");
    assert_eq!(reply["warnings"], Value::Null, "{reply}");
    // Domains and transforms can be sent back as they came.
    let data: Vec<Value> = items[1..3].iter().map(|item| item["data"].clone()).collect();
    let back = json!({"algo": gh(DATA), "alltypes": true, "values": [input("RH_IN:d", "0", &data)]});
    assert_eq!(first(&compute.post("/grasshopper", &back).await.json()), items[1..3]);
}
