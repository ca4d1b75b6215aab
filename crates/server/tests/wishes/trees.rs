//! The same tree as the definition itself would give (compute.rhino3d#275, #268, #342, #491).

use serde_json::{Value, json};

use crate::client::{Compute, input};
use crate::definitions::gh;

const PASSED: &str = "katydid 1\nn = Number()\nall = Number(n)\ndoubled = Multiplication(n, 2)\n\
    grafted = Number(n |graft)\nflat = Number(n |flatten)\n\"RH_IN:n\": n\n\"RH_OUT:all\": all\n\
    \"RH_OUT:doubled\": doubled\n\"RH_OUT:grafted\": grafted\n\"RH_OUT:flat\": flat\n";

fn tree(reply: &Value, name: &str) -> Value {
    let values = reply["values"].as_array().unwrap();
    values.iter().find(|one| one["ParamName"] == name).unwrap_or_else(|| panic!("{reply}"))["InnerTree"]
        .clone()
}

/// Branches of numbers as a reply has them.
fn branches(all: &[(&str, &[f64])]) -> Value {
    let items = |numbers: &[f64]| -> Vec<Value> {
        numbers.iter().map(|x| json!({"type": "System.Double", "data": format!("{x:?}")})).collect()
    };
    all.iter().map(|(path, numbers)| ((*path).to_owned(), json!(items(numbers)))).collect()
}

#[tokio::test(flavor = "multi_thread")]
async fn trees_go_in_and_come_out_as_they_are() {
    let compute = Compute::start().await;
    let mut value = input("RH_IN:n", "{0;1}", &[json!(1), json!(2)]);
    value["InnerTree"]["{2}"] = json!([{"data": 3}]);
    value["InnerTree"]["{0;3}"] = json!([]);
    let answer = compute.solve(&gh(PASSED), json!([value])).await;
    assert_eq!(answer.status, 200, "{}", answer.text());
    let reply = answer.json();
    let [one, two, three] = [1.0, 2.0, 3.0];
    assert_eq!(
        tree(&reply, "RH_OUT:all"),
        branches(&[("{0;1}", &[one, two]), ("{0;3}", &[]), ("{2}", &[three])])
    );
    let doubled = branches(&[("{0;1}", &[2.0, 4.0]), ("{0;3}", &[]), ("{2}", &[6.0])]);
    assert_eq!(tree(&reply, "RH_OUT:doubled"), doubled);
    let grafted = tree(&reply, "RH_OUT:grafted");
    for (path, x) in [("{0;1;0}", "1.0"), ("{0;1;1}", "2.0"), ("{2;0}", "3.0")] {
        assert_eq!(grafted[path][0]["data"], x, "{grafted}");
    }
    assert_eq!(tree(&reply, "RH_OUT:flat"), branches(&[("{0}", &[one, two, three])]));
}
