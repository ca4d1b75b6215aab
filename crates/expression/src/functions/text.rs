//! Functions of texts. Places and counts are in UTF-16 units, as .NET counts.

use super::Function;
use super::call::Arguments;
use crate::{EvalErrorKind, MAX_TEXT, Variant};

/// Calls a text function; `None` when it is not one.
pub(super) fn call(function: Function, a: &Arguments<'_>) -> Option<Result<Variant, EvalErrorKind>> {
    let result = match function {
        Function::Contains => both(a).map(|(t, part)| Variant::Boolean(t.contains(&*part))),
        Function::StartsWith => both(a).map(|(t, part)| Variant::Boolean(t.starts_with(&*part))),
        Function::EndsWith => both(a).map(|(t, part)| Variant::Boolean(t.ends_with(&*part))),
        Function::IndexOf => both(a).map(|(t, part)| {
            let before = t.find(&*part).and_then(|at| t.get(..at));
            let place = before.map_or(-1, |b| i32::try_from(units(b)).unwrap_or(i32::MAX));
            Variant::Integer(place)
        }),
        Function::Left => a.text(0).and_then(|t| Ok(slice(&t, 0, a.count(1)?))),
        Function::Right => a.text(0).and_then(|t| {
            let count = a.count(1)?;
            Ok(slice(&t, units(&t).saturating_sub(count), count))
        }),
        Function::Mid => a.text(0).and_then(|t| {
            let count = if a.len() > 2 { a.count(2)? } else { usize::MAX };
            Ok(slice(&t, a.count(1)?, count))
        }),
        Function::Trim => a.text(0).map(|t| Variant::text(t.trim())),
        Function::LCase => a.text(0).map(|t| Variant::text(t.to_lowercase())),
        Function::UCase => a.text(0).map(|t| Variant::text(t.to_uppercase())),
        Function::Replace => replace(a),
        _ => return None,
    };
    Some(result)
}

type Text = std::sync::Arc<str>;

fn both(a: &Arguments<'_>) -> Result<(Text, Text), EvalErrorKind> {
    Ok((a.text(0)?, a.text(1)?))
}

/// The number of UTF-16 units.
pub(super) fn units(text: &str) -> usize {
    text.encode_utf16().count()
}

/// At most `count` units from `start` on; what is not there is left out.
fn slice(text: &str, start: usize, count: usize) -> Variant {
    if text.is_ascii() {
        let start = start.min(text.len());
        let end = start.saturating_add(count).min(text.len());
        return Variant::text(text.get(start..end).unwrap_or(""));
    }
    let part: Vec<u16> = text.encode_utf16().skip(start).take(count).collect();
    Variant::text(String::from_utf16_lossy(&part))
}

fn replace(a: &Arguments<'_>) -> Result<Variant, EvalErrorKind> {
    let (text, old, new) = (a.text(0)?, a.text(1)?, a.text(2)?);
    if old.is_empty() {
        return Err(EvalErrorKind::OutOfRange {
            function: "Replace",
            reason: "the part to replace is empty".into(),
        });
    }
    let added = text.matches(&*old).count().saturating_mul(new.len());
    if text.len().saturating_add(added) > MAX_TEXT {
        return Err(EvalErrorKind::TextTooLong(MAX_TEXT));
    }
    Ok(Variant::text(text.replace(&*old, &new)))
}
