//! Hops components: asked servers, and what they must not do.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

#[path = "../common/mod.rs"]
mod common;
mod keys;
mod server;
mod steering;

use std::time::{Duration, Instant};

use common::{Maker, algo, item, output, value};
use katydid_component::Files;
use katydid_component::{Cancel, Limits};
use katydid_compute::{Bounds, Cause, Compute, HopsSettings, Settings, SolveRequest, WebSettings};
use katydid_definition::document::{NewPort, Object, Side};
use serde_json::{Value as Json, json};
use uuid::{Uuid, uuid};

use server::{Asked, Reply, serve};

const NUMBER: Uuid = uuid!("3e8ca6be-fda8-4aaf-b5c0-3c54c8bb7312");

/// As ghhops-server 1.5.5 describes and solves: numbers added, and trees summed branch by branch.
fn components(asked: &Asked) -> Reply {
    let body = &asked.body;
    let port = |name: &str, count: i32| json!({"Name": name, "Nickname": name, "ParamType": "Number", "AtLeast": count, "AtMost": count});
    let reply = match (asked.method.as_str(), asked.path.as_str()) {
        ("GET", "/add") => {
            json!({"Uri": "/add", "Name": "Add", "Inputs": [port("A", 1), {"Name": "B", "AtLeast": 1, "AtMost": 1, "Default": 2.0}], "Outputs": [port("Sum", 1)]})
        }
        ("GET", "/tree") => json!({"Uri": "/tree", "Inputs": [port("N", -1)], "Outputs": [port("S", -1)]}),
        ("POST", "/solve") if body["pointer"] == "add" => {
            let number = |k: usize| -> f64 {
                let items = body["values"][k]["InnerTree"]["{0}"].as_array().unwrap();
                items[0]["data"].as_str().unwrap().parse().unwrap()
            };
            let sum = (number(0) + number(1)).to_string();
            json!({"values": [{"ParamName": "Sum", "InnerTree": {"0": [{"type": "System.Double", "data": sum}]}}]})
        }
        ("POST", "/solve") => {
            let branches = body["values"][0]["InnerTree"].as_object().unwrap().iter();
            let sums = branches.map(|(path, items)| {
                let numbers = items
                    .as_array()
                    .unwrap()
                    .iter()
                    .map(|item| item["data"].as_str().unwrap().parse::<f64>().unwrap());
                (path.clone(), json!([{"type": "System.Double", "data": numbers.sum::<f64>().to_string()}]))
            });
            let tree: serde_json::Map<String, Json> = sums.collect();
            json!({"values": [{"ParamName": "S", "InnerTree": tree}], "warnings": [format!("level {}", body["recursionlevel"])]})
        }
        _ => json!({}),
    };
    Some(("application/json", reply.to_string().into_bytes()))
}

/// A definition with a Hops component of so many numbers.
fn hops(location: &str, inputs: &[&str], output: &str) -> Maker {
    let mut maker = Maker::default();
    let id = maker.id();
    let mut object = Object::new_component(katydid_solver::HOPS, "Hops", "Hops", id);
    object.container_mut().set("RemoteDefinitionLocation", location);
    object.container_mut().set_child(katydid_definition::archive::Chunk::new("ParameterData"));
    object.refresh();
    for (side, names) in [(Side::Input, inputs), (Side::Output, &[output][..])] {
        for name in names {
            let port = NewPort {
                id: maker.id(),
                name: (*name).to_owned(),
                nickname: (*name).to_owned(),
                type_id: Some(NUMBER),
                ..NewPort::default()
            };
            object.add_port(side, &port);
        }
    }
    maker.document.objects.push(object);
    for (k, name) in inputs.iter().enumerate() {
        let get = maker.get("Get Number", name);
        maker.wire(get, 0, 0, k);
    }
    maker.out("RH_OUT:x", 0);
    maker
}

fn settings(hosts: &[String]) -> Settings {
    Settings {
        web: WebSettings { hosts: hosts.to_vec(), ..WebSettings::default() },
        hops: HopsSettings { time: Duration::from_secs(5), ..HopsSettings::default() },
        ..Settings::default()
    }
}

fn answer(
    settings: Settings,
    maker: &Maker,
    values: Vec<Json>,
    bounds: &Bounds,
) -> Result<(bool, Json), katydid_compute::Fault> {
    let compute = Compute::new(settings);
    let body = json!({ "values": values }).to_string();
    let request = SolveRequest::read(body.as_bytes(), &compute.settings().request)?;
    let definition = compute.load(&algo(&maker.document))?;
    let answer = compute.answer(&definition, &request, bounds)?;
    Ok((answer.has_errors, serde_json::from_slice(&answer.body).unwrap()))
}

#[test]
fn a_server_of_components_is_asked() {
    let port = serve(components);
    let host = format!("127.0.0.1:{port}");
    let maker = hops(&format!("http://{host}/add"), &["A", "B"], "Sum");
    let values = vec![value("A", "{0;4}", &[json!(4), json!(5)]), value("B", "0", &[json!(0.5)])];
    let (failed, reply) =
        answer(settings(std::slice::from_ref(&host)), &maker, values, &Bounds::default()).unwrap();
    assert!(!failed, "{reply}");
    assert_eq!(output(&reply, "RH_OUT:x"), [("{0;4}".to_owned(), vec!["4.5".to_owned(), "5.5".to_owned()])]);
    // What is left out has the server's default.
    let (_, reply) = answer(
        settings(std::slice::from_ref(&host)),
        &maker,
        vec![value("A", "0", &[json!(4)])],
        &Bounds::default(),
    )
    .unwrap();
    assert_eq!(item(&reply, "RH_OUT:x"), "6.0");
    let maker = hops(&format!("http://{host}/tree"), &["N"], "S");
    let values = vec![
        json!({"ParamName": "N", "InnerTree": {"{0;0}": [{"data": 1}], "{0;1}": [{"data": 2}, {"data": 3}]}}),
    ];
    let (_, reply) = answer(settings(&[host]), &maker, values, &Bounds::default()).unwrap();
    let branch = |path: &str, data: &str| (path.to_owned(), vec![data.to_owned()]);
    assert_eq!(output(&reply, "RH_OUT:x"), [branch("{0;0}", "1.0"), branch("{0;1}", "5.0")]);
    assert!(reply["warnings"][0].as_str().unwrap().starts_with("level 1: component \"Hops\""), "{reply}");
}

/// A definition at a URL, and a server that solves such.
fn definitions(asked: &Asked) -> Reply {
    let body = &asked.body;
    let reply = match (asked.method.as_str(), asked.path.as_str()) {
        ("GET", "/double.gh") => {
            return Some(("application/octet-stream", b"the bytes of a definition".to_vec()));
        }
        ("POST", "/io") => {
            assert_eq!(body["algo"], "dGhlIGJ5dGVzIG9mIGEgZGVmaW5pdGlvbg==");
            json!({"CacheKey": "md5_D", "Inputs": [{"Name": "RH_IN:N", "AtLeast": 1, "AtMost": 2147483647}], "Outputs": [{"Name": "RH_OUT:D"}]})
        }
        _ => {
            assert_eq!(
                (asked.path.as_str(), &body["pointer"], &body["recursionlevel"]),
                ("/grasshopper", &json!("md5_D"), &json!(1))
            );
            let value = &body["values"][0];
            assert_eq!(value["ParamName"], "RH_IN:N");
            let doubled: Vec<Json> = value["InnerTree"]["{0}"]
                .as_array()
                .unwrap()
                .iter()
                .flat_map(|item| [item.clone(), item.clone()])
                .collect();
            json!({"values": [{"ParamName": "RH_OUT:D", "InnerTree": {"{0}": doubled}}], "errors": null})
        }
    };
    Some(("application/json; charset=utf-8", reply.to_string().into_bytes()))
}

#[test]
fn a_definition_at_a_url_is_solved_by_another_server() {
    let host = format!("127.0.0.1:{}", serve(definitions));
    let maker = hops(&format!("http://{host}/double.gh"), &["N"], "D");
    let values = || vec![value("N", "0", &[json!(1), json!(2)])];
    let mut settings = settings(std::slice::from_ref(&host));
    settings.hops.server = Some(format!("http://{host}/"));
    let (failed, reply) = answer(settings, &maker, values(), &Bounds::default()).unwrap();
    assert!(!failed, "{reply}");
    assert_eq!(output(&reply, "RH_OUT:x")[0].1, ["1.0", "1.0", "2.0", "2.0"]);
    let (failed, reply) = answer(self::settings(&[host]), &maker, values(), &Bounds::default()).unwrap();
    assert!(failed && reply["errors"][0].as_str().unwrap().contains("is no definition"), "{reply}");
}

/// Doubles a number, by itself.
fn double() -> Maker {
    let mut maker = Maker::default();
    let get = maker.get("Get Number", "N");
    let sum = maker.named("Addition", "Sum");
    maker.wire(get, 0, sum, 0);
    maker.wire(get, 0, sum, 1);
    maker.out("RH_OUT:D", sum);
    maker
}

/// The bytes of it, at a URL.
fn files(asked: &Asked) -> Reply {
    let bytes =
        if asked.path == "/double.gh" { double().document.to_gh().unwrap() } else { b"nothing".to_vec() };
    Some(("application/octet-stream", bytes))
}

#[test]
fn a_definition_that_lies_elsewhere_is_solved_here() {
    let host = format!("127.0.0.1:{}", serve(files));
    let values = || vec![value("N", "0", &[json!(1), json!(2)])];
    let maker = hops(&format!("http://{host}/double.gh"), &["N"], "D");
    let (failed, reply) =
        answer(settings(std::slice::from_ref(&host)), &maker, values(), &Bounds::default()).unwrap();
    assert!(!failed, "{reply}");
    assert_eq!(output(&reply, "RH_OUT:x"), [("{0}".to_owned(), vec!["2.0".to_owned(), "4.0".to_owned()])]);
    let maker = hops(&format!("http://{host}/other.gh"), &["N"], "D");
    let (failed, reply) = answer(settings(&[host]), &maker, values(), &Bounds::default()).unwrap();
    assert!(failed && reply["errors"][0].as_str().unwrap().contains("is no definition"), "{reply}");
    // One that the component keeps itself needs nobody.
    let mut maker = hops("C:\\gone\\double.gh", &["N"], "D");
    let kept = double().document.to_gh().unwrap();
    maker.document.objects[0]
        .container_mut()
        .set("InternalizeDefinition", katydid_definition::archive::ItemValue::ByteArray(kept.clone()));
    let (failed, reply) = answer(settings(&[]), &maker, values(), &Bounds::default()).unwrap();
    assert!(!failed, "{reply}");
    assert_eq!(output(&reply, "RH_OUT:x")[0].1, ["2.0", "4.0"]);
    // One in a file is read where files may be read: beside the definition, when its path is of another machine.
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("double.gh"), kept).unwrap();
    let maker = hops("C:\\gone\\double.gh", &["N"], "D");
    let open = Settings { files: Files::Inside(folder.path().to_path_buf()), ..settings(&[]) };
    let (failed, reply) = answer(open, &maker, values(), &Bounds::default()).unwrap();
    assert!(!failed, "{reply}");
    assert_eq!(output(&reply, "RH_OUT:x")[0].1, ["2.0", "4.0"]);
}

#[test]
fn definitions_that_call_themselves_come_to_an_end() {
    let folder = tempfile::tempdir().unwrap();
    let maker = hops("self.gh", &["N"], "x");
    std::fs::write(folder.path().join("self.gh"), maker.document.to_gh().unwrap()).unwrap();
    let open = Settings { files: Files::Inside(folder.path().to_path_buf()), ..settings(&[]) };
    let (failed, reply) =
        answer(open, &maker, vec![value("N", "0", &[json!(1)])], &Bounds::default()).unwrap();
    let text = reply["errors"].to_string();
    assert!(failed && text.contains("call one another more than 10 times"), "{text}");
}

/// Numbers up to another, one call each.
fn counts(asked: &Asked) -> Reply {
    let body = &asked.body;
    let reply = match asked.path.as_str() {
        "/solve" => {
            let number = body["values"][0]["InnerTree"]["{0}"][0]["data"].as_str().unwrap();
            let number: f64 = number.parse().unwrap();
            let items: Vec<Json> =
                (0..number as i32).map(|k| json!({"type": "System.Int32", "data": k.to_string()})).collect();
            json!({"values": [{"ParamName": "L", "InnerTree": {"{0}": items}}]})
        }
        _ => json!({"Inputs": [{"Name": "N", "AtLeast": 1, "AtMost": 1}], "Outputs": [{"Name": "L"}]}),
    };
    Some(("application/json", reply.to_string().into_bytes()))
}

#[test]
fn lists_of_several_calls_stand_side_by_side() {
    let host = format!("127.0.0.1:{}", serve(counts));
    let maker = hops(&format!("http://{host}/count"), &["N"], "L");
    let values = vec![value("N", "0", &[json!(2), json!(3)])];
    let (_, reply) = answer(settings(&[host]), &maker, values, &Bounds::default()).unwrap();
    let paths: Vec<(String, usize)> =
        output(&reply, "RH_OUT:x").into_iter().map(|(path, items)| (path, items.len())).collect();
    assert_eq!(paths, [("{0}".to_owned(), 2), ("{1}".to_owned(), 3)]);
}

#[test]
fn what_is_not_allowed_is_not_asked() {
    let port = serve(|_| panic!("asked"));
    let error = |location: &str, hosts: &[String], bounds: &Bounds| {
        let maker = hops(location, &["A"], "S");
        let (failed, reply) =
            answer(settings(hosts), &maker, vec![value("A", "0", &[json!(1)])], bounds).unwrap();
        assert!(failed);
        reply["errors"][0].as_str().unwrap().to_owned()
    };
    let here = format!("http://127.0.0.1:{port}/add");
    assert!(error(&here, &[], &Bounds::default()).contains("nothing is fetched from elsewhere"));
    let other = ["localhost:1".to_owned()];
    assert!(error(&here, &other, &Bounds::default()).contains("is not among the hosts that may be asked"));
    assert!(error("C:\\x.gh", &other, &Bounds::default()).contains("files may not be read here"));
    assert!(error("https://localhost:1/x", &other, &Bounds::default()).contains("does not answer"));
    let allowed = [format!("127.0.0.1:{port}")];
    let deep = Bounds { recursion: 10, ..Bounds::default() };
    assert!(error(&here, &allowed, &deep).contains("call one another more than 10 times"));
}

#[test]
fn a_server_that_never_answers_holds_nobody_up() {
    let host = format!("127.0.0.1:{}", serve(|_| None));
    let maker = hops(&format!("http://{host}/add"), &["A"], "S");
    let begin = Instant::now();
    let limits = Limits { time: Some(Duration::from_millis(300)), ..Limits::default() };
    let values = || vec![value("A", "0", &[json!(1)])];
    let bounds = Bounds { limits, ..Bounds::default() };
    let fault = answer(settings(std::slice::from_ref(&host)), &maker, values(), &bounds).unwrap_err();
    assert_eq!(fault.cause, Cause::TimedOut);
    let cancel = Cancel::default();
    let later = cancel.clone();
    std::thread::spawn(move || {
        std::thread::sleep(Duration::from_millis(300));
        later.cancel();
    });
    let fault =
        answer(settings(&[host]), &maker, values(), &Bounds { cancel, ..Bounds::default() }).unwrap_err();
    assert_eq!(fault.cause, Cause::Cancelled);
    assert!(begin.elapsed() < Duration::from_secs(4), "{:?}", begin.elapsed());
}
