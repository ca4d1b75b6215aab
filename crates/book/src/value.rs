//! Values of a figure, as pages name and write them.

use serde_json::Value as Json;

use crate::fault::Fault;

/// A fraction that is shown has a denominator no larger than this: others say less than decimals.
const LARGEST_DENOMINATOR: f64 = 1000.0;
/// Within this part of a number it is the fraction: results of short computations are off by a few roundings.
const SAME_FRACTION: f64 = 1e-10;
/// Digits after the point where none are asked for.
const USUAL_DIGITS: usize = 2;
/// Digits of a double.
const MOST_DIGITS: usize = 15;

/// How a number is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Style {
    Digits(usize),
    Fraction,
}

/// A value of a figure: `figure: object.port[item].x | style`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Reference {
    /// The id of the figure, where it is named.
    pub(crate) figure: Option<String>,
    /// The object, or the object and its output with a point between them.
    pub(crate) name: String,
    pub(crate) item: Option<usize>,
    /// 0 to 2 for x, y, z.
    pub(crate) axis: Option<usize>,
    pub(crate) style: Style,
}

impl Reference {
    /// Reads one; `ids` are the figures of the page.
    pub(crate) fn read(text: &str, ids: &[String]) -> Result<Self, String> {
        let (text, style) = match text.rsplit_once('|') {
            Some((text, style)) => (text, Self::style(style.trim())?),
            None => (text, Style::Digits(USUAL_DIGITS)),
        };
        let (figure, text) = match text.split_once(':') {
            Some((id, rest)) if ids.iter().any(|known| known == id.trim()) => {
                (Some(id.trim().to_owned()), rest)
            }
            _ => (None, text),
        };
        let mut name = text.trim();
        let mut axis = None;
        for (place, end) in ["].x", "].y", "].z"].into_iter().enumerate() {
            if name.ends_with(end) {
                axis = Some(place);
                name = &name[..name.len() - 2];
            }
        }
        let mut item = None;
        if let Some((before, index)) = name.strip_suffix(']').and_then(|rest| rest.rsplit_once('[')) {
            item = Some(index.trim().parse().map_err(|_| format!("[{index}] is no index"))?);
            name = before.trim();
        }
        if name.is_empty() {
            return Err("it names no object".to_owned());
        }
        Ok(Self { figure, name: name.to_owned(), item, axis, style })
    }

    fn style(text: &str) -> Result<Style, String> {
        match text {
            "fraction" => Ok(Style::Fraction),
            digits => match digits.parse() {
                Ok(digits) if digits <= MOST_DIGITS => Ok(Style::Digits(digits)),
                _ => Err(format!("'{digits}' is neither a number of digits nor `fraction`")),
            },
        }
    }

    /// What of the items of an output is meant.
    pub(crate) fn pick(&self, items: &[Json]) -> Result<Json, String> {
        let picked = match (self.item, items) {
            (Some(index), items) => {
                let why = || format!("'{}' has {} items: there is no [{index}]", self.name, items.len());
                items.get(index).cloned().ok_or_else(why)?
            }
            (None, []) => return Err(format!("'{}' has no data", self.name)),
            (None, [one]) => one.clone(),
            (None, many) => Json::Array(vec![Json::Null, Json::Array(many.to_vec())]),
        };
        match self.axis {
            None => Ok(picked),
            Some(axis) => {
                picked.get(axis).cloned().ok_or_else(|| format!("'{}' is no point or vector", self.name))
            }
        }
    }

    /// A value in words.
    pub(crate) fn written(&self, value: &Json, is_vector: bool) -> String {
        written(value, self.style, is_vector)
    }
}

/// A value in words: several items (a list behind a null, as [`Reference::pick`] gives them) with commas between them.
pub(crate) fn written(value: &Json, style: Style, is_vector: bool) -> String {
    match value {
        Json::Number(x) => number(x.as_f64().unwrap_or(f64::NAN), style),
        Json::String(text) => text.clone(),
        Json::Bool(on) => on.to_string(),
        Json::Null => "null".to_owned(),
        Json::Array(list) => match list.as_slice() {
            [Json::Null, Json::Array(items)] => {
                items.iter().map(|item| written(item, style, is_vector)).collect::<Vec<_>>().join(", ")
            }
            coordinates => {
                let inner: Vec<String> = coordinates.iter().map(|c| written(c, style, false)).collect();
                let [open, close] = if is_vector { ["⟨", "⟩"] } else { ["(", ")"] };
                format!("{open}{}{close}", inner.join(", "))
            }
        },
        Json::Object(_) => value.to_string(),
    }
}

/// A number, with a true minus and without noughts at the end.
pub(crate) fn number(x: f64, style: Style) -> String {
    if !x.is_finite() {
        return x.to_string();
    }
    let text = match style {
        Style::Fraction => match fraction(x) {
            Some((n, 1.0)) => format!("{n}"),
            Some((n, d)) => format!("{n}/{d}"),
            None => plain(x, 4),
        },
        Style::Digits(digits) => plain(x, digits),
    };
    match text.strip_prefix('-') {
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

/// Digits after the point, halves rounded away from 0: as the page's script writes them (`toFixed`). Rust rounds halves to
/// even digits.
fn plain(x: f64, digits: usize) -> String {
    /// A half has no more digits than this behind those that are shown, in numbers that pages show.
    const MORE: usize = 60;
    let size = x.abs();
    let long = format!("{size:.more$}", more = digits + MORE);
    let behind = long.split_once('.').and_then(|(_, tail)| tail.get(digits..)).unwrap_or_default();
    let is_half = behind.strip_prefix('5').is_some_and(|rest| rest.bytes().all(|byte| byte == b'0'));
    let size = if is_half { size.next_up() } else { size };
    let text = format!("{size:.digits$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if x < 0.0 && text != "0" { format!("-{text}") } else { text.to_owned() }
}

/// The fraction with a small denominator that a number is, as it came out of a computation.
fn fraction(x: f64) -> Option<(f64, f64)> {
    let (mut before, mut last) = ((0.0, 1.0), (1.0, 0.0));
    let mut rest = x;
    for _ in 0..40 {
        let whole = rest.floor();
        let (p, q) = (whole * last.0 + before.0, whole * last.1 + before.1);
        if q > LARGEST_DENOMINATOR {
            return None;
        }
        if (p / q - x).abs() <= SAME_FRACTION * x.abs().max(1.0) {
            return Some((p, q));
        }
        (before, last) = (last, (p, q));
        rest = 1.0 / (rest - whole);
    }
    None
}

/// A mark in a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Mark {
    /// A value.
    Value(Reference),
    /// A slider that can be dragged: its figure, where it is named, and its name.
    Drag(Reference),
}

impl Mark {
    pub(crate) fn read(file: &str, line: usize, text: &str, ids: &[String]) -> Result<Self, Fault> {
        let told = |why: String| Fault::new(file, line, format!("{{{{ {} }}}}: {why}", text.trim()));
        let trimmed = text.trim();
        match trimmed.strip_prefix("drag ") {
            Some(rest) => Reference::read(rest, ids).map(Self::Drag).map_err(told),
            None => Reference::read(trimmed, ids).map(Self::Value).map_err(told),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn values_are_named_and_written() {
        let ids = ["main".to_owned()];
        let read = |text: &str| Reference::read(text, &ids).unwrap();
        let r = read("main: three[1].x | 3");
        assert_eq!(
            (r.figure.as_deref(), r.name.as_str(), r.item, r.axis),
            (Some("main"), "three", Some(1), Some(0))
        );
        assert_eq!(r.written(&r.pick(&[json!([0, 0, 0]), json!([1.5, 2, 3])]).unwrap(), false), "1.5");
        let whole = read("sum.L");
        assert_eq!(whole.written(&json!(7.0710678), false), "7.07");
        assert_eq!(whole.written(&json!([1, -2, 0.5]), true), "⟨1, −2, 0.5⟩");
        assert_eq!(whole.written(&whole.pick(&[json!(1), json!(2)]).unwrap(), false), "1, 2");
        assert!(read("a[3]").pick(&[]).is_err());
        assert!(Reference::read("a | many", &ids).is_err());
        assert!(Reference::read("  ", &ids).is_err());
    }

    #[test]
    fn fractions_where_there_are_some() {
        let told = |x: f64| number(x, Style::Fraction);
        assert_eq!(told(8.0 / 15.0), "8/15");
        assert_eq!(told(-0.75), "−3/4");
        assert_eq!(told(2.0), "2");
        assert_eq!(told(std::f64::consts::PI), "3.1416");
        assert_eq!(number(-0.0001, Style::Digits(2)), "0");
        assert_eq!(number(1.125, Style::Digits(2)), "1.13");
        assert_eq!(number(-2.5, Style::Digits(0)), "−3");
        assert_eq!(number(f64::NAN, Style::Digits(2)), "NaN");
    }
}
