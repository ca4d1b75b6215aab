//! Requests do not see each other, and give what solving the definition by hand gives.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

mod common;

use std::sync::Arc;
use std::time::Duration;

use common::{Maker, algo, compute, post, shared, value};
use katydid_component::{Cancel, Limits};
use katydid_compute::definition::{Data, Form};
use katydid_compute::{Bounds, Cause, Compute, Definition, Settings, SolveRequest};
use katydid_data::Kind;
use katydid_definition::document::{Document, ids};
use katydid_session::Session;
use proptest::prelude::*;
use serde_json::{Value as Json, json};

/// `sum = A + B`, `many = series of N`, and what no input leads to.
fn definition() -> String {
    let mut maker = Maker::default();
    let [a, b] = ["A", "B"].map(|name| maker.get("Get Number", name));
    let n = maker.add(ids::NUMBER_SLIDER, "N");
    maker.group("RH_IN:N", &[maker.object_id(n)]);
    let (sum, series, constant) =
        (maker.named("Addition", "A+B"), maker.named("Series", "S"), maker.named("Pi", "Pi"));
    maker.wire(a, 0, sum, 0);
    maker.wire(b, 0, sum, 1);
    maker.wire(n, 0, series, 2);
    for (label, at) in [("RH_OUT:sum", sum), ("RH_OUT:many", series), ("RH_OUT:pi", constant)] {
        maker.out(label, at);
    }
    algo(&maker.document)
}

/// The values that a request brings: any of the inputs, or none.
fn values() -> impl Strategy<Value = Vec<Json>> {
    let number = || prop::collection::vec(-1e3..1e3f64, 0..4);
    (
        prop::option::of(number()),
        prop::option::of(number()),
        prop::option::of(0..20i32),
        prop::option::of(0..3),
    )
        .prop_map(|(a, b, n, tolerance)| {
            let list = |numbers: Vec<f64>| numbers.into_iter().map(Json::from).collect::<Vec<_>>();
            let given = [("A", a.map(list)), ("B", b.map(list)), ("RH_IN:N", n.map(|n| vec![json!(n)]))];
            let mut values: Vec<Json> =
                given.into_iter().filter_map(|(name, data)| Some(value(name, "{0}", &data?))).collect();
            // It stands for the tolerance: see `request`.
            values.extend(
                tolerance
                    .map(|t: i32| json!({ "ParamName": "tolerance", "InnerTree": { t.to_string(): [] } })),
            );
            values
        })
}

fn request(algo: &str, values: &[Json]) -> Json {
    let tolerance = values.iter().find(|value| value["ParamName"] == "tolerance");
    let tolerance = tolerance.map_or(0.0, |value| {
        0.01 * value["InnerTree"].as_object().unwrap().keys().next().unwrap().parse::<f64>().unwrap()
    });
    json!({ "algo": algo, "values": values, "absolutetolerance": tolerance, "angletolerance": 1.0 })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn requests_in_any_order_do_not_see_each_other(requests in prop::collection::vec(values(), 1..6), cached in any::<bool>()) {
        let algo = definition();
        let one_for_all = compute();
        for values in &requests {
            let mut body = request(&algo, values);
            body["cachesolve"] = json!(cached);
            let alone = post(&compute(), &body).unwrap();
            prop_assert_eq!(post(&one_for_all, &body).unwrap(), alone);
        }
    }
}

#[test]
fn many_at_a_time_do_not_see_each_other() {
    let algo = definition();
    let compute = compute();
    std::thread::scope(|scope| {
        for thread in 0..8 {
            let (algo, compute) = (&algo, &compute);
            scope.spawn(move || {
                for round in 0..50 {
                    let x = f64::from(thread * 100 + round);
                    let given = round % 3 > 0;
                    let values = if given {
                        vec![value("A", "0", &[json!(x)]), value("B", "0", &[json!(1)])]
                    } else {
                        Vec::new()
                    };
                    let (_, reply) = post(compute, &request(algo, &values)).unwrap();
                    let sum = &reply["values"][0]["InnerTree"];
                    if given {
                        assert_eq!(sum["{0}"][0]["data"], format!("{:?}", x + 1.0));
                    } else {
                        let items: usize =
                            sum.as_object().unwrap().values().map(|b| b.as_array().unwrap().len()).sum();
                        assert_eq!(items, 0, "{sum}");
                    }
                }
            });
        }
    });
    assert_eq!(compute.kept().0, 1);
}

/// Every output's data by name.
fn outputs(definition: &Definition, engine: &katydid_solver::Engine) -> Vec<(String, String)> {
    let inputs = katydid_solver::Inputs::new(engine);
    let tree = |data: Data| match data {
        Data::Given { object, output } => engine.report(object).and_then(|r| r.outputs.get(output)).cloned(),
        Data::Taken { object, input } => inputs.of(object).into_iter().nth(input),
    };
    let outputs = definition.interface().outputs.iter();
    outputs.map(|output| (output.name.clone(), format!("{:?}", tree(output.data)))).collect()
}

/// The files that need nothing beyond stock components.
fn runnable() -> Vec<(String, Vec<u8>)> {
    let Some(folder) = shared("data/gh") else { return Vec::new() };
    let index = std::fs::read_to_string(folder.join("index.csv")).unwrap();
    let lines = index.lines().skip(1).filter(|line| line.ends_with(",yes,no") || line.ends_with(",yes,yes"));
    let names = lines.filter_map(|line| line.split(',').next());
    names.filter_map(|name| Some((name.to_owned(), std::fs::read(folder.join(name)).ok()?))).collect()
}

#[test]
fn real_definitions_give_what_solving_them_by_hand_gives() {
    katydid_components::link();
    let files = runnable();
    let (mut with_inputs, mut set) = (0, 0);
    for (name, bytes) in &files {
        let document = Document::read(bytes, &Default::default()).unwrap();
        let compute = compute();
        let definition = compute.load_bytes(name.clone(), bytes).unwrap();
        if definition.interface().outputs.is_empty() {
            continue;
        }
        with_inputs += usize::from(!definition.interface().inputs.is_empty());
        // Numbers that every such input of the file takes.
        let numbers: Vec<(&str, String)> = definition
            .interface()
            .inputs
            .iter()
            .filter(|input| {
                matches!(input.form, Form::Of(Kind::Number) | Form::Of(Kind::Integer)) && input.at_most >= 1
            })
            .map(|input| {
                let [least, most] = [input.minimum.unwrap_or(1.0), input.maximum.unwrap_or(5.0)];
                (input.name.as_str(), format!("{}", (0.5 * (least + most)).round()))
            })
            .collect();
        for given in [&numbers[..0], &numbers[..]] {
            let mut session = Session::new(document.clone(), Default::default());
            for (input, value) in given {
                session.set(input, value).unwrap_or_else(|error| panic!("{name}: {error}"));
            }
            session.solve();
            let values: Vec<Json> =
                given.iter().map(|(name, data)| value(name, "0", &[json!(data)])).collect();
            let body = json!({ "values": values }).to_string();
            let request = SolveRequest::read(body.as_bytes(), &compute.settings().request).unwrap();
            let solution = compute.solve(&definition, &request, &Bounds::default()).unwrap();
            assert_eq!(
                outputs(&definition, solution.engine()),
                outputs(&definition, session.engine()),
                "{name}"
            );
            set += given.len();
        }
    }
    println!("{} files, {with_inputs} with inputs, {set} values set", files.len());
    assert!(files.is_empty() || with_inputs >= 8 && set >= 15, "{with_inputs} {set}");
}

#[test]
fn memory_stays_within_its_bound() {
    let settings = Settings { cache_bytes: 1 << 20, ..Settings::default() };
    let compute = Compute::new(settings);
    let mut keys = Vec::new();
    for k in 0..30 {
        let mut maker = Maker::default();
        let series = maker.named("Series", "S");
        let count = maker.get("Get Integer", "n");
        maker.wire(count, 0, series, 2);
        let kept = katydid_definition::document::Persistent::item(
            katydid_definition::document::Stored::Integer(20_000 + k),
        );
        maker.document.objects[count].set_persistent(0, Some(&kept)).unwrap();
        maker.out("RH_OUT:s", series);
        let (_, reply) = post(&compute, &json!({ "algo": algo(&maker.document) })).unwrap();
        keys.push(reply["pointer"].as_str().unwrap().to_owned());
        assert!(compute.kept().1 <= 1 << 20, "{:?}", compute.kept());
    }
    // Results go before definitions, and the oldest first.
    assert!(compute.cached(&keys[29]).is_some());
    assert!(compute.kept().0 > 6, "{:?}", compute.kept());
}

#[test]
fn one_reads_a_definition_for_all_who_ask_at_a_time() {
    let algo = definition();
    let compute = compute();
    let loaded: Vec<Arc<Definition>> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..8).map(|_| scope.spawn(|| compute.load(&algo).unwrap())).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert!(loaded.iter().all(|definition| Arc::ptr_eq(definition, &loaded[0])));
}

/// A definition that takes longer than anybody waits.
fn endless() -> Document {
    let mut maker = Maker::default();
    let count = maker.get("Get Integer", "n");
    let series = maker.named("Series", "S");
    maker.wire(count, 0, series, 2);
    let cross = maker.named("Negative", "Neg");
    maker.wire(series, 0, cross, 0);
    maker.out("RH_OUT:s", cross);
    let quick = maker.named("Pi", "Pi");
    maker.out("RH_OUT:pi", quick);
    maker.document
}

#[test]
fn time_runs_out_and_nothing_stays_of_it() {
    let compute = compute();
    let definition = compute.load(&algo(&endless())).unwrap();
    let request = |n: i32| {
        let body = json!({ "values": [value("n", "0", &[json!(n)])] }).to_string();
        SolveRequest::read(body.as_bytes(), &compute.settings().request).unwrap()
    };
    let limits = Limits { time: Some(Duration::ZERO), ..Limits::default() };
    let fault = compute
        .answer(&definition, &request(1_000_000), &Bounds { limits, ..Bounds::default() })
        .unwrap_err();
    assert_eq!(
        (fault.cause, fault.message.as_str()),
        (Cause::TimedOut, "The time limit of 0 seconds is over")
    );
    let cancel = Cancel::default();
    cancel.cancel();
    let fault =
        compute.answer(&definition, &request(5), &Bounds { cancel, ..Bounds::default() }).unwrap_err();
    assert_eq!(fault.cause, Cause::Cancelled);
    // Fewer items than the series has: an error of the component, for this request only.
    let limits = Limits { items: 3, ..Limits::default() };
    let few = compute.answer(&definition, &request(5), &Bounds { limits, ..Bounds::default() }).unwrap();
    assert!(few.has_errors);
    assert!(!compute.answer(&definition, &request(5), &Bounds::default()).unwrap().has_errors);
}

#[test]
fn a_reply_is_kept_for_the_same_request_only() {
    let algo = definition();
    let compute = compute();
    let answer = |body: &Json| {
        let request = SolveRequest::read(body.to_string().as_bytes(), &compute.settings().request).unwrap();
        let definition = compute.load(&algo).unwrap();
        compute.answer(&definition, &request, &Bounds::default()).unwrap()
    };
    let body = |x: f64| json!({ "cachesolve": true, "values": [value("A", "0", &[json!(x)]), value("B", "0", &[json!(1)])] });
    assert!(!answer(&body(1.0)).kept);
    let again = answer(&body(1.0));
    assert!(again.kept && !again.has_errors);
    assert!(String::from_utf8_lossy(&again.body).contains("\"cachesolve\":true"));
    assert!(!answer(&body(2.0)).kept);
    let mut other = body(1.0);
    other["modelunits"] = json!("Meters");
    assert!(!answer(&other).kept);
    other["cachesolve"] = json!(false);
    assert!(!answer(&other).kept);
}

#[test]
fn results_are_a_model_too() {
    let mut maker = Maker::default();
    let point = maker.named("Construct Point", "Pt");
    let bake = maker.add(ids::CONTEXT_BAKE, "");
    maker.wire(point, 0, bake, 0);
    let compute = compute();
    let definition = compute.load(&algo(&maker.document)).unwrap();
    let request = SolveRequest::default();
    let solution = compute.solve(&definition, &request, &Bounds::default()).unwrap();
    assert_eq!(solution.model().objects.len(), 1);
}
