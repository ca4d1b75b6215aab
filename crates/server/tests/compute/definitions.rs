//! Definitions that are asked for.

use katydid_definition::kd;
use katydid_session::Registry;

use crate::client::base64;

pub(crate) const SUM: &str = "katydid 1\na = Number Slider(2.0, 0..10)\nb = Number Slider(3.0, 0..10)\n\
    sum = Addition(a, b)\n\"RH_IN:A\": a\n\"RH_IN:B\": b\n\"RH_OUT:sum\": sum\n";

/// A sphere, to be had as a file.
pub(crate) const SPHERE: &str = "katydid 1\nr = Number Slider(2.0, 0..10)\nball = Sphere(XY Plane(), r)\n\
    \"RH_IN:r\": r\n\"RH_OUT:ball\": ball\n";

/// The base64 that clients send.
pub(crate) fn gh(text: &str) -> String {
    base64(bytes(text))
}

pub(crate) fn bytes(text: &str) -> Vec<u8> {
    katydid_components::link();
    let definition = kd::read(text, &Registry).unwrap_or_else(|problems| panic!("{problems}\n{text}"));
    definition.document.to_gh().unwrap()
}

pub(crate) fn ghx(text: &str) -> String {
    katydid_components::link();
    kd::read(text, &Registry).unwrap().document.to_ghx().unwrap()
}

/// A formula that may give a text, so that it is worked out item by item.
const SLOW: &str = r#""if(x > -1e9, sin(x) * cos(x) + sqrt(abs(x)), \"\")""#;
/// Minutes of work, in steps of a second each. No two of them are alike.
pub(crate) fn endless(number: usize) -> String {
    let mut text =
        format!("katydid 1\nn = Number Slider(4000000.0, 0..9000000)\ns = Series({number}, 1, n)\n");
    let mut last = "s".to_owned();
    for k in 0..200 {
        let next = format!("e{k}");
        text.push_str(&format!("{next} = Expression({SLOW}, x = {last})\n"));
        last = next;
    }
    text.push_str(&format!("\"RH_IN:n\": n\n\"RH_OUT:end\": {last}\n"));
    text
}
