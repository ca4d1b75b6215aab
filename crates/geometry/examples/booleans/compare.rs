//! One case: its steps built, and its results beside those that are right.

use serde_json::Value;

use crate::read::{Read, number, text};
use crate::shapes::{Failure, Shapes};
use crate::variant::Variant;

/// Volumes and areas may be off by this part of those of the largest operand.
const WITHIN: f64 = 1e-6;

/// How a case came out.
pub(crate) enum Verdict {
    Right,
    Wrong(String),
    Counts(String),
    Refused(String),
    NotBuilt(String),
}

impl Verdict {
    pub(crate) fn class(&self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Wrong(_) => "WRONG",
            Self::Counts(_) => "COUNT",
            Self::Refused(_) => "refused",
            Self::NotBuilt(_) => "not built",
        }
    }

    pub(crate) fn why(&self) -> &str {
        match self {
            Self::Right => "",
            Self::Wrong(why) | Self::Counts(why) | Self::Refused(why) | Self::NotBuilt(why) => why,
        }
    }
}

/// Builds a case and compares its results.
pub(crate) fn case(case: &Value, variant: Variant) -> Verdict {
    match compared(case, variant) {
        Ok(verdict) => verdict,
        Err(Failure::Refused(why)) => Verdict::Refused(why),
        Err(Failure::NotBuilt(why)) => Verdict::NotBuilt(why),
    }
}

fn compared(case: &Value, variant: Variant) -> Result<Verdict, Failure> {
    let steps = case["steps"].as_array().ok_or("it has no steps".to_owned())?;
    let mut shapes = Shapes::new(variant);
    let open = case["tags"].as_array().is_some_and(|t| t.iter().any(|t| t == "open_or_infinite_solid"));
    let mut refused = None;
    for step in steps {
        // What the results do not need may fail; all others of the case are still looked at.
        if let Err(why) = shapes.build(step) {
            refused.get_or_insert(why);
        }
    }
    let results = case["results"].as_object().ok_or("it has no results".to_owned())?;
    let mut counts = None;
    for (id, result) in results {
        let Some(parts) = shapes.result(id) else { continue };
        for field in ["volume", "area"] {
            if (open && field == "volume") || (variant.parts() && field == "area") {
                continue;
            }
            let Some(want) = wanted(result, field)? else { continue };
            let scale = shapes.largest(field).max(want.abs());
            let found = parts.measure(field).map_err(Failure::Refused)?;
            if !near(found, want, WITHIN * scale) {
                return Ok(Verdict::Wrong(format!("{id}: {field} {found} instead of {want}")));
            }
        }
        if variant.parts() {
            continue;
        }
        if let Some(value) = result["expected"]["length"]["value"].as_f64() {
            let want = result["occt"]["length"].as_f64().unwrap_or(value);
            if let Some(found) = parts.length()
                && !near(found, want, WITHIN * want.abs())
            {
                return Ok(Verdict::Wrong(format!("{id}: length {found} instead of {want}")));
            }
        }
        if let Some(wanted) = result["expected"]["counts"]["value"].as_object() {
            for (what, want) in wanted {
                let (Some(found), Some(want)) = (parts.count(what), want.as_u64()) else { continue };
                if found as u64 != want {
                    counts.get_or_insert(format!("{id}: {what} {found} instead of {want}"));
                }
            }
        }
    }
    if let Some(why) = refused {
        return Err(why);
    }
    Ok(counts.map_or(Verdict::Right, Verdict::Counts))
}

/// The number that is right: with all digits where another kernel gives them and agrees.
fn wanted(result: &Value, field: &str) -> Read<Option<f64>> {
    let own = &result["expected"][field];
    if own.is_null() {
        return Ok(None);
    }
    let value = number(&own["value"])?;
    let exact = own["closed_form"] == true || own["occt_agrees"] == false;
    if exact {
        return Ok(Some(value));
    }
    let full = result["occt"][field].as_f64();
    // Nothing is left: the other kernel gives no number.
    Ok(Some(full.unwrap_or(value)))
}

/// The name of a step, for messages.
pub(crate) fn name(step: &Value) -> Read<&str> {
    text(&step["id"])
}

/// Whether two numbers differ by no more than `by`; what is not a number is near nothing.
fn near(found: f64, want: f64, by: f64) -> bool {
    (found - want).abs() <= by
}
