use katydid_data::Path;
use serde_json::json;

use super::*;
use crate::Cause;

fn read(body: &str) -> Result<SolveRequest, Fault> {
    SolveRequest::read(body.as_bytes(), &RequestLimits::default())
}

#[test]
fn a_body_is_read_leniently() {
    let body = r#"[{"ALGO": null, "Pointer": "md5_A", "AbsoluteTolerance": 0.01, "angletolerance": "2",
        "modelunits": "meters", "dataversion": 8, "cachesolve": true, "recursionlevel": 3, "filename": "x", "Extra": [1],
        "Values": [{"paramname": "A", "INNERTREE": {"0": [{"data": 4, "type": "System.Double"}], "{ 0; 1; }": [
            {"type": "x", "Data": "{\"X\":1}"}, {}, 7, null, [1, 2]]}}, null]}]"#;
    let request = read(body).unwrap();
    assert_eq!(request.pointer(), Some("md5_A"));
    assert_eq!(request.rules(None).units, Units::Meters);
    assert_eq!(request.rules(None).tolerance.absolute, 0.01);
    assert!((request.rules(None).tolerance.angle - 2f64.to_radians()).abs() < 1e-15);
    assert_eq!((request.archive(), request.cache_solve, request.recursion_level), (80, true, 3));
    let [tree] = request.values.as_slice() else { panic!("{:?}", request.values) };
    assert_eq!(tree.name, "A");
    let second = vec![json!("{\"X\":1}"), json!(null), json!(7), json!(null), json!([1, 2])];
    assert_eq!(tree.branches, [(Path::zero(), vec![json!(4)]), (Path::from([0, 1]), second)]);
}

#[test]
fn tolerances_count_in_pairs_only() {
    let default = Tolerance::default();
    for body in [r#"{"absolutetolerance": 0.5}"#, r#"{"absolutetolerance": 0.5, "angletolerance": 0}"#, "{}"]
    {
        assert_eq!(read(body).unwrap().rules(None).tolerance, default, "{body}");
    }
}

#[test]
fn what_is_no_request_is_refused_by_name() {
    for (body, word) in [
        ("", "EOF"),
        ("null", "an object with the definition"),
        ("[]", "empty"),
        ("{\"values\": {}}", "a list of values"),
        ("{\"values\": [1]}", "ParamName"),
        ("{\"values\": [{\"InnerTree\": {}}]}", "no ParamName"),
        ("{\"values\": [{\"ParamName\": 4}]}", "ParamName is no text"),
        ("{\"values\": [{\"ParamName\": \"A\", \"InnerTree\": []}]}", "a list for each path"),
        ("{\"values\": [{\"ParamName\": \"A\", \"InnerTree\": {\"0\": 4}}]}", "a list of items"),
        ("{\"values\": [{\"ParamName\": \"A\", \"InnerTree\": {\"{-1}\": []}}]}", "begin at 0"),
        ("{\"modelunits\": \"Parsecs\"}", "Parsecs"),
        ("{\"absolutetolerance\": -1}", "absolutetolerance is no tolerance"),
        ("{\"absolutetolerance\": 1e308}", "absolutetolerance"),
        ("{\"absolutetolerance\": \"NaN\"}", "absolutetolerance"),
        ("{\"recursionlevel\": -1}", "recursionlevel"),
        ("{\"recursionlevel\": 1e30}", "recursionlevel"),
        ("{\"algo\": 7}", "algo is no text"),
        ("{\"absolutetolerance\": 1e999}", "number out of range"),
        ("{} {}", "trailing"),
        ("{\"algo\": \"\\ud800\"}", "hex escape"),
    ] {
        let fault = read(body).unwrap_err();
        assert!(
            fault.cause == Cause::BadRequest && fault.message.contains(word),
            "{body}: {}",
            fault.message
        );
    }
    let deep = "[".repeat(100_000);
    assert_eq!(read(&deep).unwrap_err().cause, Cause::BadRequest);
    assert_eq!(read(&format!("{{\"x\": {deep}")).unwrap_err().cause, Cause::BadRequest);
}

#[test]
fn null_stands_for_nothing() {
    assert_eq!(read("{\"values\": null, \"algo\": null}").unwrap(), SolveRequest::default());
    let request = read("{\"values\": [{\"ParamName\": \"A\", \"InnerTree\": null}]}").unwrap();
    assert_eq!(request.values, [InputTree { name: "A".to_owned(), branches: Vec::new() }]);
}

#[test]
fn limits_hold() {
    let limits = RequestLimits { items: 3, branches: 4, bytes: 200 };
    let items = |n| {
        let list = vec!["{\"data\":1}"; n].join(",");
        SolveRequest::read(
            format!("{{\"values\":[{{\"ParamName\":\"A\",\"InnerTree\":{{\"0\":[{list}]}}}}]}}").as_bytes(),
            &limits,
        )
    };
    assert!(items(3).is_ok());
    let fault = items(4).unwrap_err();
    assert_eq!((fault.cause, fault.message.as_str()), (Cause::TooLarge, "The values have more than 3 items"));
    assert_eq!(items(40).unwrap_err().message, "The body has more than 200 bytes");
}

#[test]
fn equal_requests_have_equal_digests() {
    let digest = |body| read(body).unwrap().digest();
    let a = r#"{"values": [{"ParamName": "A", "InnerTree": {"0": [{"data": 1}, {"data": 2}]}}]}"#;
    let same = r#"{"pointer":"x","values":[{"InnerTree":{"{0}":[{"data":1},{"data":2}]},"ParamName":"A"}]}"#;
    assert_eq!(digest(a), digest(same));
    for other in [
        "{}",
        r#"{"values": [{"ParamName": "A", "InnerTree": {"0": [{"data": 12}]}}]}"#,
        r#"{"values": [{"ParamName": "A", "InnerTree": {"0": [{"data": 1}], "1": [{"data": 2}]}}]}"#,
        r#"{"values": [{"ParamName": "B", "InnerTree": {"0": [{"data": 1}, {"data": 2}]}}]}"#,
        r#"{"alltypes": true, "values": [{"ParamName": "A", "InnerTree": {"0": [{"data": 1}, {"data": 2}]}}]}"#,
        r#"{"model": "AAAA", "values": [{"ParamName": "A", "InnerTree": {"0": [{"data": 1}, {"data": 2}]}}]}"#,
        r#"{"modelunits": "Feet", "values": [{"ParamName": "A", "InnerTree": {"0": [{"data": 1}, {"data": 2}]}}]}"#,
    ] {
        assert_ne!(digest(a), digest(other), "{other}");
    }
}

/// What the fuzz target `compute_request` looks at, on bodies that are a request but for a few bytes.
#[test]
fn damaged_bodies_are_read_within_the_limits_or_refused() {
    let whole = br#"[{"algo":"AAAA","model":"","modelunits":"Feet","absolutetolerance":"0.01","angletolerance":1,
        "alltypes":true,"cachesolve":false,"recursionlevel":1,"dataversion":8,"values":[{"ParamName":"A","InnerTree":
        {"{0;1}":[{"data":"4"},{"data":{"X":1}}],"2":[null,7,[1]]}}]}]"#;
    let limits = RequestLimits { items: 4, branches: 3, bytes: 1 << 10 };
    let signs = b"{}[]\",:0-9e.\\ untfalse\x00\xff";
    // The constants are Knuth's, for a congruential generator.
    let mut state = 1_u64;
    let mut below = |count: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % count
    };
    let mut read = 0;
    for _ in 0..20_000 {
        let mut body = whole.to_vec();
        for _ in 0..=below(3) {
            let at = below(body.len());
            match below(3) {
                0 => body[at] = signs[below(signs.len())],
                1 => body.insert(at, signs[below(signs.len())]),
                _ => drop(body.drain(at..body.len().min(at + 1 + below(8)))),
            }
        }
        let Ok(request) = SolveRequest::read(&body, &limits) else { continue };
        read += 1;
        let branches = || request.values.iter().flat_map(|tree| &tree.branches);
        assert!(branches().count() <= limits.branches);
        assert!(branches().map(|(_, items)| items.len()).sum::<usize>() <= limits.items);
        let rules = request.rules(None);
        assert!(rules.tolerance.absolute > 0.0 && rules.tolerance.angle > 0.0);
    }
    assert!(read > 100, "{read} could be read");
}
