//! Single members of a request, in the forms that clients send them in.

use katydid_data::units;
use katydid_geometry::Units;
use serde_json::Value as Json;

use super::path::shown;

/// A text; none for null.
pub(super) fn text(json: &Json) -> Result<Option<String>, String> {
    match json {
        Json::Null => Ok(None),
        Json::String(text) => Ok(Some(text.clone())),
        other => Err(format!("is no text: {}", shown(&other.to_string()))),
    }
}

/// True or false; false for null.
pub(super) fn flag(json: &Json) -> Result<bool, String> {
    match json {
        Json::Null => Ok(false),
        Json::Bool(flag) => Ok(*flag),
        Json::String(text) if text.eq_ignore_ascii_case("true") => Ok(true),
        Json::String(text) if text.eq_ignore_ascii_case("false") => Ok(false),
        other => Err(format!("is neither true nor false: {}", shown(&other.to_string()))),
    }
}

/// A number; none for null. A text may hold it.
fn number(json: &Json) -> Result<Option<f64>, String> {
    let number = match json {
        Json::Null => return Ok(None),
        Json::Number(number) => number.as_f64(),
        Json::String(text) => text.trim().parse().ok(),
        _ => None,
    };
    number.map(Some).ok_or_else(|| format!("is no number: {}", shown(&json.to_string())))
}

/// A whole number of 32 bits; none for null.
pub(super) fn whole(json: &Json) -> Result<Option<i32>, String> {
    let Some(x) = number(json)? else { return Ok(None) };
    if x.fract() == 0.0 && x.abs() <= f64::from(i32::MAX) {
        return Ok(Some(x as i32));
    }
    Err(format!("is no whole number of 32 bits: {x}"))
}

/// A tolerance: a finite number, 0 for none.
pub(super) fn tolerance(json: &Json) -> Result<Option<f64>, String> {
    /// A tolerance beyond this is a mistake: nothing would be told apart.
    const MOST: f64 = 1e6;
    match number(json)? {
        Some(x) if !(0.0..=MOST).contains(&x) => Err(format!("is no tolerance: {x}")),
        x => Ok(x.filter(|x| *x > 0.0)),
    }
}

/// The name of a unit; none for null and for an empty text.
pub(super) fn unit(json: &Json) -> Result<Option<Units>, String> {
    let name = match text(json)? {
        Some(name) if !name.trim().is_empty() => name,
        _ => return Ok(None),
    };
    units::named(&name).map(Some).ok_or_else(|| {
        let known: Vec<&str> = units::ALL.iter().map(|unit| unit.name()).collect();
        format!("is no unit that is known here: {} (there are {})", shown(&name), known.join(", "))
    })
}
