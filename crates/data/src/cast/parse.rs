//! What a text can be read as.

use katydid_expression::Expression;
use katydid_expression::Variant;
use katydid_geometry::{Interval, MeshFace, Plane, Point3};

use crate::{Colour, Complex, DateTime, Domain2, Location, Value};

/// Longer texts are not numbers, points or colours; reading stops before any work is done.
const LONGEST: usize = 4096;

fn trimmed(text: &str) -> Option<&str> {
    let text = text.trim();
    (!text.is_empty() && text.len() <= LONGEST).then_some(text)
}

/// `true`, `false`, `yes`, `no` in any case, or a number (0 is false).
pub(super) fn boolean(text: &str) -> Option<bool> {
    let text = trimmed(text)?;
    if ["true", "yes"].iter().any(|word| text.eq_ignore_ascii_case(word)) {
        return Some(true);
    }
    if ["false", "no"].iter().any(|word| text.eq_ignore_ascii_case(word)) {
        return Some(false);
    }
    number(text).map(|x| x != 0.0)
}

/// A number as .NET writes it, or a formula without variables: `1/3`, `pi*2`, `1e3`.
pub fn number(text: &str) -> Option<f64> {
    let text = trimmed(text)?;
    if let Some(x) = katydid_expression::format::parse_number(text) {
        return Some(x);
    }
    // A word is no formula: without a digit or a constant's letter there is nothing to compute.
    let program = Expression::parse(text).ok()?.bind(&[]).ok()?;
    match program.evaluate(&[]).ok()? {
        Variant::Number(x) => Some(x),
        Variant::Integer(i) => Some(i as f64),
        _ => None,
    }
}

/// A number with commas between its whole digits, which .NET passes over wherever they stand: `1,000` is 1000, and so
/// is `1,0,00`. A real definition gives the panel `0,0,550` to a point and, as a height, to a number.
pub(super) fn grouped_number(text: &str) -> Option<f64> {
    let text = trimmed(text)?;
    let whole = text.find(['.', 'e', 'E']).unwrap_or(text.len());
    let (digits, rest) = text.split_at(whole);
    let unsigned = digits.trim_start_matches(['+', '-']);
    if !digits.contains(',') || !unsigned.starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    katydid_expression::format::parse_number(&(digits.replace(',', "") + rest))
}

/// `{1,2,3}`, `1, 2, 3`, `{1,2}` (z is 0), the separators commas or semicolons.
pub fn point(text: &str) -> Option<Point3> {
    let text = trimmed(text)?;
    let inner = match (text.chars().next(), text.chars().last()) {
        (Some('{'), Some('}')) | (Some('('), Some(')')) | (Some('['), Some(']')) => {
            text.get(1..text.len() - 1)?
        }
        _ => text,
    };
    let parts: Option<Vec<f64>> = inner.split([',', ';']).map(number).collect();
    match parts?.as_slice() {
        [x, y] => Some(Point3::new(*x, *y, 0.0)),
        [x, y, z] => Some(Point3::new(*x, *y, *z)),
        _ => None,
    }
    .filter(|p| p.is_finite())
}

/// `a to b` in any case, or `n` for 0 to n.
pub fn domain(text: &str) -> Option<Interval> {
    let text = trimmed(text)?;
    let lower = text.to_ascii_lowercase();
    if let Some(at) = lower.find("to") {
        return Some(Interval::new(number(lower.get(..at)?)?, number(lower.get(at + 2..)?)?));
    }
    number(text).map(|n| Interval::new(0.0, n))
}

/// Degrees of longitude and latitude as x and y of a point; a text of them too.
pub(super) fn location(value: &Value) -> Option<Location> {
    let p = match value {
        Value::Point(p) => *p,
        Value::Text(text) => point(text)?,
        _ => return None,
    };
    let known = (-180.0..=360.0).contains(&p.x) && (-90.0..=90.0).contains(&p.y);
    known.then_some(Location { longitude: p.x, latitude: p.y })
}

/// `u:{a To b} v:{c To d}`.
pub(super) fn domain2(text: &str) -> Option<Domain2> {
    let text = trimmed(text)?.to_ascii_lowercase();
    let (u, v) = text.split_once('v')?;
    let part = |s: &str| -> Option<Interval> {
        let inner = s.split_once('{')?.1.split_once('}')?.0;
        domain(inner)
    };
    u.trim_start().starts_with('u').then(|| Some(Domain2 { u: part(u)?, v: part(v)? }))?
}

/// `Q{0,1,2,3}`, `T{1;2;4}`, or the bare lists in braces.
pub(super) fn mesh_face(text: &str) -> Option<MeshFace> {
    let text = trimmed(text)?;
    let inner = text.trim_start_matches(['Q', 'T', 'q', 't']).trim().strip_prefix('{')?.strip_suffix('}')?;
    let indices: Option<Vec<u32>> = inner.split([',', ';']).map(|i| i.trim().parse().ok()).collect();
    match indices?.as_slice() {
        [a, b, c] => Some(MeshFace::Triangle([*a, *b, *c])),
        [a, b, c, d] => Some(MeshFace::Quad([*a, *b, *c, *d])),
        _ => None,
    }
}

/// `r,g,b`, `r,g,b (a)`, `a,r,g,b`, `#rrggbb`, `#aarrggbb`, or a common name.
pub fn colour(text: &str) -> Option<Colour> {
    let text = trimmed(text)?;
    if let Some(hex) = text.strip_prefix('#') {
        let value = u32::from_str_radix(hex, 16).ok()?;
        let [a, r, g, b] = value.to_be_bytes();
        return match hex.len() {
            6 => Some(Colour::rgb(r, g, b)),
            8 => Some(Colour { a, r, g, b }),
            _ => None,
        };
    }
    let (channels, alpha) = match text.split_once('(') {
        Some((channels, alpha)) => {
            (channels, Some(alpha.trim().strip_suffix(')')?.trim().parse::<u8>().ok()?))
        }
        None => (text, None),
    };
    let bytes: Option<Vec<u8>> = channels.split([',', ';']).map(|c| c.trim().parse().ok()).collect();
    match (bytes.as_deref(), alpha) {
        (Some([r, g, b]), alpha) => Some(Colour { a: alpha.unwrap_or(255), r: *r, g: *g, b: *b }),
        (Some([a, r, g, b]), None) => Some(Colour { a: *a, r: *r, g: *g, b: *b }),
        _ => named_colour(text),
    }
}

/// The sixteen names of HTML 4 and a few more that people type; values by the web's standard.
fn named_colour(name: &str) -> Option<Colour> {
    let (r, g, b) = match name.to_ascii_lowercase().as_str() {
        "black" => (0, 0, 0),
        "silver" => (192, 192, 192),
        "gray" | "grey" => (128, 128, 128),
        "white" => (255, 255, 255),
        "maroon" => (128, 0, 0),
        "red" => (255, 0, 0),
        "purple" => (128, 0, 128),
        "fuchsia" | "magenta" => (255, 0, 255),
        "green" => (0, 128, 0),
        "lime" => (0, 255, 0),
        "olive" => (128, 128, 0),
        "yellow" => (255, 255, 0),
        "navy" => (0, 0, 128),
        "blue" => (0, 0, 255),
        "teal" => (0, 128, 128),
        "aqua" | "cyan" => (0, 255, 255),
        "orange" => (255, 165, 0),
        "pink" => (255, 192, 203),
        "brown" => (165, 42, 42),
        _ => return None,
    };
    Some(Colour::rgb(r, g, b))
}

/// `true` or `false`, in any case.
pub(super) fn truth(text: &str) -> Option<bool> {
    let text = trimmed(text)?;
    [("true", true), ("false", false)]
        .into_iter()
        .find(|(word, _)| text.eq_ignore_ascii_case(word))
        .map(|(_, b)| b)
}

/// A number, or a real and an imaginary part: `3 + 4i`, `-2i`.
pub(super) fn complex(text: &str) -> Option<Complex> {
    if let Some(re) = number(text) {
        return Some(Complex { re, im: 0.0 });
    }
    let body = trimmed(text)?.strip_suffix(['i', 'I'])?.trim_end();
    // The sign between the parts: the last one that is neither the first character nor that of an exponent.
    let sign = body.char_indices().rev().find(|&(at, c)| {
        matches!(c, '+' | '-') && at > 0 && !body.get(..at).is_some_and(|head| head.ends_with(['e', 'E']))
    });
    let part = |text: &str| match text.replace(char::is_whitespace, "").as_str() {
        "" | "+" => Some(1.0),
        "-" => Some(-1.0),
        digits => number(digits),
    };
    match sign {
        Some((at, _)) => Some(Complex { re: number(body.get(..at)?)?, im: part(body.get(at..)?)? }),
        None => part(body).map(|im| Complex { re: 0.0, im }),
    }
}

/// `O(x,y,z) Z(x,y,z)`, as a panel shows a plane.
pub(super) fn plane(text: &str) -> Option<Plane> {
    let (origin, normal) = trimmed(text)?.strip_prefix(['O', 'o'])?.split_once(['Z', 'z'])?;
    Plane::from_normal(point(origin)?, point(normal)?.to_vector()).ok()
}

/// A date, a time of day, or both: `2024-02-29`, `13:05`, `2024/2/29 13:05:09`, `2024-02-29T13:05:09`. A time alone is
/// that of the first day there is.
pub fn time(text: &str) -> Option<DateTime> {
    let text = trimmed(text)?;
    let (date, clock) = match text.split_once([' ', 'T']) {
        Some((date, clock)) => (Some(date), Some(clock)),
        None if text.contains(':') => (None, Some(text)),
        None => (Some(text), None),
    };
    let parts = |text: &str, marks: &[char]| -> Option<Vec<i64>> {
        text.split(marks).map(|part| part.trim().parse::<u32>().ok().map(i64::from)).collect()
    };
    let day = match date {
        None => 0,
        Some(date) => match parts(date, &['-', '/', '.'])?.as_slice() {
            [year @ 1..=9999, month @ 1..=12, day @ 1..=31] => DateTime::day(*year, *month, *day)?,
            _ => return None,
        },
    };
    let seconds = match clock {
        None => 0,
        Some(clock) => match parts(clock, &[':'])?.as_slice() {
            [hour @ 0..=23, minute @ 0..=59] => hour * 3600 + minute * 60,
            [hour @ 0..=23, minute @ 0..=59, second @ 0..=59] => hour * 3600 + minute * 60 + second,
            _ => return None,
        },
    };
    Some(DateTime { ticks: (day * 86_400 + seconds) * 10_000_000 })
}
