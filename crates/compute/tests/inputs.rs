//! Inputs and outputs of every kind, in definitions that are made here.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

mod common;

use common::{Maker, algo, compute, io, item, output, post, value};
use katydid_compute::Cause;
use katydid_definition::document::{Persistent, Stored, ids};
use serde_json::{Value as Json, json};

/// A value in, the type of the item that comes out, and its data.
type Case = (&'static str, Json, &'static str, Json);

/// A contextual input or a parameter in a group, handed through.
fn cases() -> Vec<Case> {
    let point = json!({"X": 1.0, "Y": 2.5, "Z": -3.0});
    let line = json!({"From": {"X": 0.0, "Y": 0.0, "Z": 0.0}, "To": {"X": 1.0, "Y": 2.0, "Z": 3.0}});
    vec![
        ("Number", json!("4.5"), "System.Double", json!(4.5)),
        ("Integer", json!("-7"), "System.Int32", json!(-7)),
        ("Boolean", json!("true"), "System.Boolean", json!(true)),
        ("Point", json!(point.to_string()), "Rhino.Geometry.Point3d", point.clone()),
        ("Vector", point.clone(), "Rhino.Geometry.Vector3d", point.clone()),
        ("Line", json!(line.to_string()), "Rhino.Geometry.Line", line.clone()),
    ]
}

#[test]
fn every_plain_kind_goes_in_and_out() {
    katydid_components::link();
    for (name, data, type_name, expected) in cases() {
        for marked in [false, true] {
            let get = format!("Get {name}");
            let known = katydid_component::registry::all().into_iter().any(|component| component.name == get);
            if !marked && !known {
                continue;
            }
            let mut maker = Maker::default();
            let label = if marked { "RH_IN:x" } else { "x" };
            let at = if marked { maker.named(name, "x") } else { maker.get(&get, "x") };
            if marked {
                maker.group(label, &[maker.object_id(at)]);
            }
            maker.out("RH_OUT:y", at);
            let body = json!({ "algo": algo(&maker.document), "values": [value(label, "{0;2}", std::slice::from_ref(&data))] });
            let (failed, reply) = post(&compute(), &body).unwrap();
            assert!(!failed, "{reply}");
            let branches = &reply["values"][0]["InnerTree"];
            assert_eq!(branches["{0;2}"][0]["type"], type_name, "{reply}");
            let got: Json = serde_json::from_str(branches["{0;2}"][0]["data"].as_str().unwrap()).unwrap();
            assert_eq!(got, expected, "{name}");
        }
    }
}

#[test]
fn the_mark_of_a_name_may_be_there_or_not_unless_two_inputs_differ_by_it_alone() {
    let mut maker = Maker::default();
    for (name, marked) in [("a", false), ("b", true), ("c", false), ("c", true)] {
        let at = if marked { maker.named("Number", name) } else { maker.get("Get Number", name) };
        if marked {
            maker.group(&format!("RH_IN:{name}"), &[maker.object_id(at)]);
        }
        maker.out(&format!("RH_OUT:{name}{}", if marked { " marked" } else { "" }), at);
    }
    let algo = algo(&maker.document);
    let got = |values: &[(&str, f64)]| {
        let values: Vec<Json> = values.iter().map(|(name, x)| value(name, "0", &[json!(x)])).collect();
        let (_, reply) = post(&compute(), &json!({ "algo": algo, "values": values })).unwrap();
        let outputs = reply["values"].as_array().unwrap().clone();
        outputs
            .iter()
            .map(|one| one["InnerTree"]["{0}"][0]["data"].as_str().map(str::to_owned))
            .collect::<Vec<_>>()
    };
    let text = |x: &str| Some(x.to_owned());
    assert_eq!(got(&[("RH_IN:a", 1.0), ("b", 2.0)]), [text("1.0"), text("2.0"), None, None]);
    // Whose very name it is goes first, wherever it stands.
    assert_eq!(
        got(&[("a", 1.0), ("RH_IN:a", 3.0), ("RH_IN:b", 2.0), ("b", 4.0)])[..2],
        [text("1.0"), text("2.0")]
    );
    assert_eq!(got(&[("c", 5.0)])[2..], [text("5.0"), None]);
    assert_eq!(got(&[("RH_IN:c", 6.0)])[2..], [None, text("6.0")]);
    assert_eq!(got(&[("RH_IN:d", 7.0)]), [None, None, None, None]);
}

#[test]
fn texts_follow_the_kind_of_the_input() {
    let mut maker = Maker::default();
    let get = maker.get("Get String", "get");
    let text = maker.named("Text", "text");
    let panel = maker.add(ids::PANEL, "panel");
    maker.group("RH_IN:text", &[maker.object_id(text)]);
    maker.group("RH_IN:panel", &[maker.object_id(panel)]);
    for (label, at) in [("RH_OUT:get", get), ("RH_OUT:text", text), ("RH_OUT:panel", panel)] {
        maker.out(label, at);
    }
    let quoted = json!("\"a \\\"b\\\" \u{6f22}\"");
    let values: Vec<Json> = ["get", "RH_IN:text", "RH_IN:panel"]
        .iter()
        .map(|name| value(name, "0", std::slice::from_ref(&quoted)))
        .collect();
    let (_, reply) = post(&compute(), &json!({ "algo": algo(&maker.document), "values": values })).unwrap();
    let read = |name: &str| serde_json::from_str::<String>(&item(&reply, name)).unwrap();
    assert_eq!(read("RH_OUT:get"), "a \"b\" \u{6f22}");
    assert_eq!(read("RH_OUT:panel"), "a \"b\" \u{6f22}");
    assert_eq!(read("RH_OUT:text"), quoted.as_str().unwrap());
}

#[test]
fn sliders_toggles_and_curves_take_values() {
    let mut maker = Maker::default();
    let slider = maker.add(ids::NUMBER_SLIDER, "s");
    let toggle = maker.add(ids::BOOLEAN_TOGGLE, "t");
    let curve = maker.named("Curve", "c");
    let length = maker.named("Length", "L");
    maker.wire(curve, 0, length, 0);
    for (label, at) in [("RH_IN:s", slider), ("RH_IN:t", toggle), ("RH_IN:c", curve)] {
        maker.group(label, &[maker.object_id(at)]);
    }
    for (label, at) in [("RH_OUT:s", slider), ("RH_OUT:t", toggle), ("RH_OUT:length", length)] {
        maker.out(label, at);
    }
    let compute = compute();
    let body = json!({ "algo": algo(&maker.document), "values": [
        // More than one value, and one outside the slider's limits: a program may do what a hand cannot.
        value("RH_IN:s", "{0}", &[json!(1), json!(1e6)]),
        value("RH_IN:t", "{0}", &[json!(true)]),
        value("RH_IN:c", "{0}", &[json!([{"X": 0, "Y": 0, "Z": 0}, {"X": 3, "Y": 0, "Z": 0}, {"X": 3, "Y": 4, "Z": 0}])]),
        value("RH_IN:nobody", "{0}", &[json!(1)]),
    ]});
    let (failed, reply) = post(&compute, &body).unwrap();
    assert!(!failed, "{reply}");
    assert_eq!(output(&reply, "RH_OUT:s")[0].1, ["1.0", "1000000.0"]);
    assert_eq!(item(&reply, "RH_OUT:t"), "true");
    assert_eq!(item(&reply, "RH_OUT:length"), "7.0");
    // The next request has the definition's own values again.
    let (_, reply) = post(&compute, &json!({ "pointer": reply["pointer"] })).unwrap();
    assert_eq!((item(&reply, "RH_OUT:t").as_str(), output(&reply, "RH_OUT:s")[0].1.len()), ("false", 1));
    let described = io(&compute, &json!({ "pointer": reply["pointer"] }));
    assert_eq!(
        (&described["Inputs"][0]["AtMost"], &described["Inputs"][1]["AtMost"]),
        (&json!(1), &json!(i32::MAX))
    );
    assert!(described["Inputs"][0]["Minimum"].is_f64() && described["Inputs"][1]["Minimum"].is_null());
    let types: Vec<&Json> = (0..3).map(|k| &described["Inputs"][k]["ParamType"]).collect();
    assert_eq!(types, ["Number", "Boolean", "Curve"]);
}

#[test]
fn defaults_come_through_relays_and_limits_from_the_slider() {
    let mut maker = Maker::default();
    let (slider, relay) = (maker.add(ids::NUMBER_SLIDER, "s"), maker.add(ids::RELAY, ""));
    maker.document.objects[slider].set_slider(0.75).unwrap();
    let through = maker.get("Get Number", "through");
    let direct = maker.get("Get Number", "direct");
    maker.wire(slider, 0, relay, 0);
    maker.wire(relay, 0, through, 0);
    maker.wire(slider, 0, direct, 0);
    let kept = maker.get("Get Integer", "kept");
    let three = Persistent::list(vec![Stored::Integer(3), Stored::Integer(4)]);
    maker.document.objects[kept].set_persistent(0, Some(&three)).unwrap();
    let series = maker.named("Series", "S");
    let computed = maker.get("Get Number", "computed");
    maker.wire(series, 0, computed, 0);
    // Clients see what stands higher first.
    for (at, y) in [(through, 40.0), (direct, 30.0), (kept, 20.0), (computed, 10.0)] {
        maker.place(at, y);
    }
    maker.out("RH_OUT:x", through);
    let described = io(&compute(), &json!({ "algo": algo(&maker.document) }));
    assert_eq!(described["InputNames"], json!(["computed", "kept", "direct", "through"]));
    let default = |k: usize| described["Inputs"][k]["Default"]["InnerTree"].clone();
    assert_eq!(default(0), json!({}));
    assert_eq!(default(1)["{0}"][1], json!({"type": "System.Int32", "data": "4"}));
    assert_eq!(
        (default(2)["{0}"][0]["data"].as_str(), default(3)["{0}"][0]["data"].as_str()),
        (Some("0.75"), Some("0.75"))
    );
    assert_eq!(described["Inputs"][1]["Default"]["ParamName"], "Get Integer");
    assert!(described["Inputs"][2]["Maximum"].is_f64() && described["Inputs"][3]["Maximum"].is_null());
    assert_eq!(described["Inputs"][2]["Description"], "give direct");
}

#[test]
fn outputs_are_found_in_every_form() {
    let mut maker = Maker::default();
    let point = maker.named("Construct Point", "Pt");
    let parts = maker.named("Deconstruct", "pDecon");
    maker.wire(point, 0, parts, 0);
    let bake = maker.add(ids::CONTEXT_BAKE, "component's own");
    maker.wire(point, 0, bake, 0);
    let print = maker.add(ids::CONTEXT_PRINT, "component's own");
    maker.wire(parts, 0, print, 0);
    let slider = maker.add(ids::NUMBER_SLIDER, "s");
    let gone = uuid::Uuid::from_u128(4711);
    let (point_id, parts_id, slider_id) =
        (maker.object_id(point), maker.object_id(parts), maker.object_id(slider));
    maker.group("old RH_OUT:gone", &[gone]);
    maker.group("RH_OUT:parts", &[gone, parts_id, slider_id]);
    maker.group("RH_OUT:115:point", &[point_id]);
    maker.group("RH_OUT:115:point", &[slider_id]);
    maker.group("a frame", &[slider_id]);
    maker.group("RH_IN:no parameter", &[parts_id]);
    let compute = compute();
    let (failed, reply) = post(&compute, &json!({ "algo": algo(&maker.document) })).unwrap();
    let names: Vec<&str> = reply["values"]
        .as_array()
        .unwrap()
        .iter()
        .map(|value| value["ParamName"].as_str().unwrap())
        .collect();
    let nick = |at: usize| maker.document.objects[at].inputs[0].nickname.clone();
    let (bake, print) = (nick(bake), nick(print));
    let expected = [
        bake.as_str(),
        &print,
        "RH_OUT:parts (X)",
        "RH_OUT:parts (Y)",
        "RH_OUT:parts (Z)",
        "RH_OUT:115:point",
    ];
    assert_eq!(names, expected);
    assert_eq!(item(&reply, "RH_OUT:parts (X)"), "0.0");
    assert_eq!(item(&reply, &print), "\"0\"");
    assert_eq!(item(&reply, &bake), r#"{"X":0.0,"Y":0.0,"Z":0.0}"#);
    // Two outputs of one name are told, and the first counts; no component failed.
    assert!(!failed);
    assert_eq!(reply["errors"].as_array().unwrap().len(), 1);
    assert!(
        reply["errors"][0].as_str().unwrap().starts_with("Multiple output parameters with the same name")
    );
    assert!(io(&compute, &json!({ "pointer": reply["pointer"] }))["Errors"][0].is_string());
}

#[test]
fn a_component_by_its_id_is_a_definition() {
    let addition = "a0d62394-a118-422d-abb3-6af115c75b25";
    let compute = compute();
    let described = io(&compute, &json!({ "pointer": addition }));
    assert_eq!((&described["InputNames"], &described["OutputNames"]), (&json!(["A", "B"]), &json!(["R"])));
    let values = json!([value("A", "0", &[json!(2), json!(3)]), value("B", "0", &[json!("40")])]);
    let (failed, reply) = post(&compute, &json!({ "pointer": addition, "values": values })).unwrap();
    assert!(!failed, "{reply}");
    assert_eq!(output(&reply, "R")[0].1, ["42", "43"]);
}

#[test]
fn errors_have_their_component_and_the_rest_goes_on() {
    let mut maker = Maker::default();
    let get = maker.get("Get Number", "n");
    let series = maker.named("Series", "S");
    maker.wire(get, 0, series, 2);
    let fine = maker.named("Number", "fine");
    maker.wire(get, 0, fine, 0);
    maker.out("RH_OUT:series", series);
    maker.out("RH_OUT:fine", fine);
    let unknown = uuid::Uuid::from_u128(0xabc);
    let script = maker.id();
    let mut object = katydid_definition::document::Object::new_component(unknown, "Magic", "M", script);
    object.refresh();
    maker.document.objects.push(object);
    let compute = compute();
    let body = json!({ "algo": algo(&maker.document), "values": [value("n", "0", &[json!(3)])] });
    let (failed, reply) = post(&compute, &body).unwrap();
    assert!(failed);
    assert_eq!(reply["errors"], json!([format!("Magic is not supported: component \"Magic\" ({script})")]));
    assert_eq!(
        (output(&reply, "RH_OUT:series")[0].1.len(), item(&reply, "RH_OUT:fine").as_str()),
        (3, "3.0")
    );
    maker.document.objects.pop();
    let body = json!({ "algo": algo(&maker.document), "values": [value("n", "0", &[json!(2e9)])] });
    let (failed, reply) = post(&compute, &body).unwrap();
    let error = reply["errors"][0].as_str().unwrap();
    assert!(
        failed && error.ends_with(&format!(": component \"Series\" ({})", maker.object_id(series))),
        "{error}"
    );
    assert_eq!(item(&reply, "RH_OUT:fine"), "2000000000.0");
}

#[test]
fn what_makes_no_sense_is_refused() {
    let compute = compute();
    let mut maker = Maker::default();
    let get = maker.get("Get Integer", "n");
    let fault = |body: Json| post(&compute, &body).unwrap_err();
    let nothing = fault(json!({ "algo": algo(&maker.document) }));
    assert!(nothing.cause == Cause::BadRequest && nothing.message.contains("no outputs"), "{nothing}");
    maker.out("RH_OUT:n", get);
    let algo = algo(&maker.document);
    let half = fault(json!({ "algo": algo, "values": [value("n", "{3}", &[json!("4.5")])] }));
    assert_eq!(half.cause, Cause::BadRequest);
    assert!(half.message.starts_with("n, item 0 of {3}: the data is 4.5"), "{half}");
    let deep = fault(json!({ "algo": algo, "recursionlevel": 1_000_000_000 }));
    assert!(deep.cause == Cause::BadRequest && deep.message.contains("more than 10 times"), "{deep}");
}
