//! What is asked for, and what is to come out.

use serde_json::Value;

use crate::Outcome;
use crate::client::request;

pub(crate) struct Case {
    /// The body of `/grasshopper`.
    pub(crate) body: Vec<u8>,
    /// The whole request.
    pub(crate) request: Vec<u8>,
    expected: Vec<Vec<f64>>,
}

/// The cases of a file: a list of `{"body": "…", "expected": [[1.0, …], …]}`.
pub(crate) fn read(path: &str, host: &str) -> Outcome<Vec<Case>> {
    let cases: Vec<Value> = serde_json::from_slice(&std::fs::read(path)?)?;
    let case = |case: &Value| {
        let body = case["body"].as_str().unwrap_or_default().as_bytes().to_vec();
        let expected = serde_json::from_value(case["expected"].clone()).unwrap_or_default();
        Case { request: request("POST", host, "/grasshopper", &body), body, expected }
    };
    Ok(cases.iter().map(case).collect())
}

impl Case {
    /// Whether an answer holds what `katydid run` gives.
    pub(crate) fn is_right(&self, body: &[u8]) -> bool {
        let Ok(reply) = serde_json::from_slice::<Value>(body) else { return false };
        let Some(tree) = reply["values"][0]["InnerTree"].as_object() else { return false };
        tree.len() == self.expected.len()
            && tree.values().zip(&self.expected).all(|(branch, expected)| {
                let Some(branch) = branch.as_array() else { return false };
                let number = |item: &Value| item["data"].as_str().and_then(|text| text.parse::<f64>().ok());
                branch.len() == expected.len()
                    && branch.iter().zip(expected).all(|(item, expected)| {
                        number(item).is_some_and(|x| (x - expected).abs() <= 1e-12 * expected.abs().max(1.0))
                    })
            })
    }
}

/// Numbers that are the same in each run (the constants are Knuth's, for a congruential generator).
pub(crate) struct Chance(u64);

impl Chance {
    pub(crate) fn new(seed: usize) -> Self {
        Self(seed as u64)
    }

    /// A number below `count`, which is not 0.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % count.max(1)
    }
}
