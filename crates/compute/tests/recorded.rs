//! Requests as real clients sent them, and the keys that they are answered with.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

mod common;

use common::{compute, io, item, output, post, shared};
use katydid_compute::{Cause, Located, SolveRequest, cache};
use serde_json::{Value as Json, json};

const CLIENTS: [&str; 3] = [
    "compute_rhino3d_0.12.2_requests.json",
    "compute-rhino3d_npm_0.12.1_requests.json",
    "appserver_0.1.12_requests.json",
];

/// The bodies that the clients sent to a path.
fn sent(path: &str) -> Option<Vec<String>> {
    let folder = shared("tools/compute-clients/fixtures")?;
    let mut bodies = Vec::new();
    for client in CLIENTS {
        let text = std::fs::read_to_string(folder.join(client)).unwrap();
        let requests: Vec<Json> = serde_json::from_str(&text).unwrap();
        let matching = requests.iter().filter(|request| request["path"] == path);
        bodies.extend(matching.map(|request| request["body"].as_str().unwrap().to_owned()));
    }
    Some(bodies)
}

/// A definition that came with the recorded requests.
fn definition(name: &str) -> Option<String> {
    use base64::Engine as _;
    let path = shared("tools/compute-clients/fixtures/defs")?.join(name);
    Some(base64::engine::general_purpose::STANDARD.encode(std::fs::read(path).unwrap()))
}

#[test]
fn every_recorded_request_is_answered() {
    let Some(bodies) = sent("/grasshopper") else { return };
    assert!(bodies.len() >= 18, "{}", bodies.len());
    let compute = compute();
    for body in bodies {
        let request = SolveRequest::read(body.as_bytes(), &compute.settings().request).unwrap();
        let located = compute.locate(&request).unwrap();
        let sent: Json = serde_json::from_str(&body).unwrap();
        if sent["algo"].is_null() {
            assert!(matches!(located, Located::Url(url) if url.starts_with("http://127.0.0.1")));
            continue;
        }
        let (failed, reply) = post(&compute, &sent).unwrap();
        assert!(!failed && reply.get("errors").is_none(), "{reply}");
        // Values are given where the names are those of the definition's inputs.
        let number = |name: &str| {
            let values = sent["values"].as_array().unwrap().iter();
            let mut named = values.filter(|value| value["ParamName"].as_str().unwrap().ends_with(name));
            named.next().map(|value| {
                let branches = value["InnerTree"].as_object().unwrap().values();
                let items = branches.flat_map(|items| items.as_array().unwrap());
                let number =
                    |data: &Json| data.as_f64().or_else(|| data.as_str()?.parse().ok()).unwrap_or(f64::NAN);
                items.map(|item| number(&item["data"])).collect::<Vec<f64>>()
            })
        };
        let (a, b) = (number("A").unwrap_or(vec![2.0]), number("B").unwrap_or(vec![3.0]));
        let sums: Vec<f64> = output(&reply, "RH_OUT:sum")
            .into_iter()
            .flat_map(|(_, items)| items)
            .map(|x| x.parse().unwrap())
            .collect();
        let expected: Vec<f64> = a.iter().map(|a| a + b[0]).collect();
        assert_eq!(sums, expected, "{}", sent["values"]);
    }
}

#[test]
fn replies_are_to_the_letter() {
    let (Some(sum), Some(groups)) = (definition("mini_sum.gh"), definition("mini_groups.gh")) else { return };
    let compute = compute();
    let body = |algo: &str, values: Json| {
        let request = json!({ "algo": algo, "values": values });
        let request =
            SolveRequest::read(request.to_string().as_bytes(), &compute.settings().request).unwrap();
        let Located::Here(definition) = compute.locate(&request).unwrap() else { panic!() };
        String::from_utf8(compute.answer(&definition, &request, &Default::default()).unwrap().body.to_vec())
            .unwrap()
    };
    let reply = |key: &str, path: &str, data: &str| {
        format!(
            concat!(
                r#"{{"modelunits":"Millimeters","dataversion":7,"algo":"","pointer":"{}","cachesolve":false,"#,
                r#""values":[{{"ParamName":"RH_OUT:sum","InnerTree":{{"{}":[{{"type":"System.Double","data":"{}"}}]}}}}]}}"#
            ),
            key, path, data
        )
    };
    let key = "md5_922DBA670C19CC935C3C9EB28D81A405";
    assert_eq!(body(&sum, json!([])), reply(key, "{0}", "5.0"));
    let values = json!([{"ParamName": "A", "InnerTree": {"{ 0; 1; }": [{"type": "x", "data": "4.25"}]}}]);
    assert_eq!(body(&sum, values), reply(key, "{0;1}", "7.25"));
    let values = json!([{"ParamName": "RH_IN:B", "InnerTree": {"0": [{"data": 1}]}}]);
    assert_eq!(body(&groups, values), reply("md5_17A9D08BA33AC5C23D0EB03F86873E0D", "{0}", "3.0"));
}

#[test]
fn keys_are_those_of_rhino_compute() {
    for (file, key) in [
        ("mini_sum.gh", "md5_922DBA670C19CC935C3C9EB28D81A405"),
        ("mini_groups.gh", "md5_17A9D08BA33AC5C23D0EB03F86873E0D"),
        ("mini_sum.ghx", "md5_1BF6C46F7DD05D25AF1ABA88CA28DD72"),
    ] {
        let Some(algo) = definition(file) else { return };
        assert_eq!(cache::key(&algo), key, "{file}");
        let compute = compute();
        assert!(compute.cached(key).is_none());
        let loaded = compute.load(&algo).unwrap();
        assert_eq!(loaded.key(), key);
        assert!(std::sync::Arc::ptr_eq(&loaded, &compute.cached(key).unwrap()));
        let (_, reply) = post(&compute, &json!({ "pointer": key })).unwrap();
        assert_eq!((item(&reply, "RH_OUT:sum").as_str(), &reply["pointer"]), ("5.0", &json!(key)));
    }
}

#[test]
fn a_definition_is_described() {
    let Some(algo) = definition("mini_sum.gh") else { return };
    let described = io(&compute(), &json!({ "algo": algo }));
    let input = |name: &str, default: &str| {
        json!({
            "Description": format!("number {name}"), "AtLeast": 1, "AtMost": 1, "TreeAccess": false,
            "Default": {"ParamName": "Get Number",
                "InnerTree": {"{0}": [{"type": "System.Double", "data": default}]}},
            "Minimum": null, "Maximum": null, "Name": name, "Nickname": null, "ParamType": "Number",
        })
    };
    let expected = json!({
        "Description": "smoke definition mini_sum", "CacheKey": "md5_922DBA670C19CC935C3C9EB28D81A405",
        "InputNames": ["A", "B"], "OutputNames": ["RH_OUT:sum"], "Icon": null,
        "Inputs": [input("A", "2.0"), input("B", "3.0")],
        "Outputs": [{"Name": "RH_OUT:sum", "Nickname": null, "ParamType": "Number"}],
        "Warnings": [], "Errors": [],
    });
    assert_eq!(described, expected);
}

#[test]
fn pointers_that_lead_nowhere_say_so() {
    let compute = compute();
    let cause = |body: Json| {
        let request = SolveRequest::read(body.to_string().as_bytes(), &compute.settings().request).unwrap();
        compute.locate(&request).map(drop).map_err(|fault| fault.cause)
    };
    assert_eq!(cause(json!({})), Err(Cause::BadRequest));
    assert_eq!(cause(json!({ "algo": "", "pointer": " " })), Err(Cause::BadRequest));
    assert_eq!(cause(json!({ "algo": "no base64!" })), Err(Cause::BadRequest));
    assert_eq!(cause(json!({ "algo": "AAAA" })), Err(Cause::BadRequest));
    assert_eq!(cause(json!({ "pointer": "md5_0" })), Err(Cause::NotFound));
    assert_eq!(cause(json!({ "pointer": "md5_../../etc/passwd" })), Err(Cause::NotFound));
    assert_eq!(cause(json!({ "pointer": "00000000-0000-0000-0000-000000000007" })), Err(Cause::NotFound));
    for path in
        ["/etc/passwd", "C:\\x.gh", "..%2f..", "file:///etc/passwd", "\\\\host\\share\\x.gh", "ftp://a/b"]
    {
        assert_eq!(cause(json!({ "pointer": path })), Err(Cause::Refused), "{path}");
    }
    assert_eq!(cause(json!({ "pointer": "HTTP://host/x.gh" })), Ok(()));
}
