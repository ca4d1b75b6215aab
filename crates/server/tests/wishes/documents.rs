//! Document, units and tolerances per request (compute.rhino3d#703).

use katydid_3dm::{Attributes, Model, ModelObject, Object};
use katydid_geometry::{Line, Point3, Tolerance, Units};
use serde_json::{Value, json};
use uuid::Uuid;

use crate::client::{Compute, base64};
use crate::definitions::gh;

/// Two lines with a gap of a twentieth between them.
const GAP: &str = "katydid 1\na = Line((0, 0, 0), (1, 0, 0))\nb = Line((1.05, 0, 0), (2, 0, 0))\n\
    j = Join Curves([a, b])\nn = List Length(j)\np = Construct Point(1, 2, 3)\nbake = Context Bake(p)\n\
    \"RH_OUT:n\": n\n";
/// The length of a curve of the model.
const WALL: &str = "katydid 1\nwall = Curve(geometry(ref = @00000000-0000-0000-0000-0000000000a1))\n\
    l = Length(wall)\n\"RH_OUT:l\": l\n";

/// A line of that length, in metres, with a coarse tolerance.
fn model(length: f64) -> String {
    let tolerance = Tolerance { absolute: 0.1, ..Tolerance::default() };
    let mut model = Model { units: Units::Meters, tolerance, ..Model::default() };
    let line = Line::new(Point3::ORIGIN, Point3::new(length, 0.0, 0.0));
    let attributes = Attributes { id: Uuid::from_u128(0xa1), ..Attributes::default() };
    model.objects.push(ModelObject { attributes, ..ModelObject::from(Object::Curve(line.into())) });
    base64(model.write(70).unwrap())
}

async fn number(compute: &Compute, body: &Value, output: &str) -> f64 {
    let answer = compute.post("/grasshopper", body).await;
    assert_eq!(answer.status, 200, "{}", answer.text());
    answer.output(output).as_f64().unwrap()
}

async fn units(compute: &Compute, body: &Value) -> Units {
    let file = compute.post("/grasshopper?format=3dm", body).await;
    assert_eq!(file.status, 200, "{}", file.text());
    Model::read(&file.body, &Default::default()).unwrap().units
}

#[tokio::test(flavor = "multi_thread")]
async fn units_and_tolerances_are_those_of_the_request() {
    let compute = Compute::start().await;
    let with = |units: &str, tolerance: f64| json!({"algo": gh(GAP), "modelunits": units, "absolutetolerance": tolerance, "angletolerance": 1.0});
    // In turns: what one asked for is nothing for the next.
    for _ in 0..2 {
        assert_eq!(number(&compute, &with("Meters", 0.1), "RH_OUT:n").await, 1.0);
        assert_eq!(number(&compute, &with("Meters", 0.01), "RH_OUT:n").await, 2.0);
        assert_eq!(units(&compute, &with("Meters", 0.01)).await, Units::Meters);
        assert_eq!(units(&compute, &with("Feet", 0.01)).await, Units::Feet);
        assert_eq!(units(&compute, &json!({"algo": gh(GAP)})).await, Units::Millimeters);
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn each_request_has_its_own_model() {
    let compute = Compute::start().await;
    let with = |length: f64| json!({"algo": gh(WALL), "model": model(length), "cachesolve": true});
    for length in [5.0, 6.0, 5.0] {
        assert_eq!(number(&compute, &with(length), "RH_OUT:l").await, length);
    }
    let without = compute.post("/grasshopper", &json!({"algo": gh(WALL)})).await;
    let said = without.text();
    assert!(said.contains("Needs the Rhino model"), "{said}");
    // Units and tolerances are those of the model, unless the request has its own.
    let mut body = json!({"algo": gh(GAP), "model": model(1.0)});
    assert_eq!(number(&compute, &body, "RH_OUT:n").await, 1.0);
    assert_eq!(units(&compute, &body).await, Units::Meters);
    for (name, value) in
        [("absolutetolerance", json!(0.01)), ("angletolerance", json!(1.0)), ("modelunits", json!("Inches"))]
    {
        body[name] = value;
    }
    assert_eq!(number(&compute, &body, "RH_OUT:n").await, 2.0);
    assert_eq!(units(&compute, &body).await, Units::Inches);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_model_that_is_none_is_refused_by_name() {
    let compute = Compute::start().await;
    for (model, word) in [(json!("%%%"), "base64"), (json!(base64("no model")), "model"), (json!(7), "model")]
    {
        let answer = compute.post("/grasshopper", &json!({"algo": gh(WALL), "model": model})).await;
        assert!(answer.status == 400 && answer.is_refused(), "{model}: {}", answer.text());
        assert!(answer.text().contains(word), "{}", answer.text());
    }
    for none in [json!(null), json!("")] {
        assert_ne!(compute.post("/grasshopper", &json!({"algo": gh(WALL), "model": none})).await.status, 400);
    }
    compute.is_well().await;
}
