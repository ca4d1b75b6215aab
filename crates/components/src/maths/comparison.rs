//! Which of two values is smaller.

use std::cmp::{Ordering, Reverse};

use katydid_component::Message;
use katydid_data::{Value, cast};

fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(x) => Some(*x),
        Value::Integer(i) => Some(f64::from(*i)),
        Value::Boolean(b) => Some(f64::from(u8::from(*b))),
        Value::Text(text) => cast::parse_number(text),
        _ => None,
    }
}

fn text(value: &Value) -> Option<&str> {
    if let Value::Text(text) = value { Some(text) } else { None }
}

fn coordinates(value: &Value) -> Option<[f64; 3]> {
    match value {
        Value::Point(p) => Some([p.x, p.y, p.z]),
        Value::Vector(v) => Some([v.x, v.y, v.z]),
        _ => None,
    }
}

fn places(a: &[f64; 3], b: &[f64; 3]) -> Ordering {
    a.iter().zip(b).map(|(x, y)| x.total_cmp(y)).fold(Ordering::Equal, Ordering::then)
}

/// What texts are sorted by: as in a dictionary, capital letters count only between texts that are otherwise
/// the same, small ones first.
pub(crate) fn dictionary(text: &str) -> (String, Reverse<String>) {
    (text.to_lowercase(), Reverse(text.to_owned()))
}

/// The indices of values in rising order, equal ones as they stand: numbers by size, texts by the alphabet,
/// points by x, then y, then z. Texts are numbers when all of them read as such.
///
/// # Errors
/// For types that have no order, or none in common.
pub(super) fn order(values: &[Value]) -> Result<Vec<usize>, Message> {
    fn by<K>(keys: &[K], compare: impl Fn(&K, &K) -> Ordering) -> Vec<usize> {
        let mut order: Vec<usize> = (0..keys.len()).collect();
        order.sort_by(|&a, &b| match (keys.get(a), keys.get(b)) {
            (Some(a), Some(b)) => compare(a, b),
            _ => Ordering::Equal,
        });
        order
    }
    fn all<'a, K>(values: &'a [Value], key: impl Fn(&'a Value) -> Option<K>) -> Option<Vec<K>> {
        values.iter().map(key).collect()
    }
    // One key for all: pair by pair, numbers and texts together could run in a circle.
    if let Some(keys) = all(values, number) {
        return Ok(by(&keys, f64::total_cmp));
    }
    if let Some(keys) = all(values, |v| text(v).map(dictionary)) {
        return Ok(by(&keys, Ord::cmp));
    }
    if let Some(keys) = all(values, coordinates) {
        return Ok(by(&keys, places));
    }
    if let Some(keys) = all(values, |v| if let Value::Time(t) = v { Some(*t) } else { None }) {
        return Ok(by(&keys, Ord::cmp));
    }
    let kind = |k: usize| values.get(k).map(Value::kind);
    let other = (0..values.len()).find(|&k| kind(k) != kind(0));
    Err(match (kind(0), other.and_then(kind)) {
        (Some(a), Some(b)) => Message::error(format!("{a} and {b} cannot be compared")),
        (Some(a), None) => Message::error(format!("{a} has no order")),
        _ => Message::error("Nothing to compare"),
    })
}

/// The order of two values.
///
/// # Errors
/// As [`order`].
pub(super) fn values(a: &Value, b: &Value) -> Result<Ordering, Message> {
    if let (Some(x), Some(y)) = (number(a), number(b)) {
        return Ok(x.total_cmp(&y));
    }
    if let (Some(x), Some(y)) = (text(a), text(b)) {
        return Ok(dictionary(x).cmp(&dictionary(y)));
    }
    if let (Some(x), Some(y)) = (coordinates(a), coordinates(b)) {
        return Ok(places(&x, &y));
    }
    match (a, b) {
        (Value::Time(x), Value::Time(y)) => Ok(x.cmp(y)),
        _ if a.kind() == b.kind() => Err(Message::error(format!("{} has no order", a.kind()))),
        _ => Err(Message::error(format!("{} and {} cannot be compared", a.kind(), b.kind()))),
    }
}
