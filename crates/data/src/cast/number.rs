//! To booleans, numbers, domains and colours.

use katydid_geometry::{Curve, Direction, Interval};

use super::{curve, parse};
use crate::{Colour, Complex, Domain2, Value};

/// 0 is false, every other number true; texts by their words.
pub(super) fn boolean(value: &Value) -> Option<bool> {
    match value {
        Value::Integer(i) => Some(*i != 0),
        Value::Number(x) => Some(*x != 0.0),
        Value::Text(text) => parse::boolean(text),
        _ => None,
    }
}

/// The nearest integer, halves to the even one, as .NET's `Convert.ToInt32`; none outside 32 bits.
pub(super) fn integer(value: &Value) -> Option<i32> {
    let x = match value {
        Value::Boolean(b) => return Some(i32::from(*b)),
        Value::Number(x) => *x,
        Value::Text(text) => parse::number(text)?,
        Value::Complex(z) if z.im == 0.0 => z.re,
        _ => return None,
    };
    let rounded = x.round_ties_even();
    (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&rounded).then_some(rounded as i32)
}

pub(super) fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(x) => Some(*x),
        Value::Boolean(b) => Some(f64::from(u8::from(*b))),
        Value::Integer(i) => Some(f64::from(*i)),
        Value::Text(text) => parse::number(text),
        Value::Complex(z) if z.im == 0.0 => Some(z.re),
        // Days since 1899-12-30, the day numbers of OLE automation.
        Value::Time(time) => Some((time.ticks - 599_264_352_000_000_000) as f64 / 864e9),
        _ => None,
    }
}

pub(super) fn complex(value: &Value) -> Option<Complex> {
    number(value).map(|re| Complex { re, im: 0.0 })
}

/// A number n is the domain from 0 to n; a text is `a to b`; a curve, and what casts to one, has its own.
pub(super) fn domain(value: &Value) -> Option<Interval> {
    match value {
        Value::Text(text) => parse::domain(text),
        Value::Curve(curve) => Some(Curve::domain(curve)),
        Value::Line(_) | Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) => {
            curve::curve(value).map(|curve| Curve::domain(&curve))
        }
        Value::Complex(z) => Some(Interval::new(z.re, z.im)),
        _ => number(value).map(|n| Interval::new(0.0, n)),
    }
}

/// A surface's domains, a rectangle's sizes, a text `u:{a To b} v:{c To d}`, or one domain in both directions.
pub(super) fn domain2(value: &Value) -> Option<Domain2> {
    match value {
        Value::Text(text) => parse::domain2(text).or_else(|| {
            let d = parse::domain(text)?;
            Some(Domain2 { u: d, v: d })
        }),
        Value::Surface(s) => Some(Domain2 { u: s.domain(Direction::U), v: s.domain(Direction::V) }),
        Value::Rectangle(r) => Some(Domain2 { u: r.x, v: r.y }),
        Value::Domain(d) => Some(Domain2 { u: *d, v: *d }),
        _ => None,
    }
}

/// A text, a grey from a number of 0 to 255, or red, green and blue from a point's coordinates.
pub(super) fn colour(value: &Value) -> Option<Colour> {
    let byte = |x: f64| x.round_ties_even().clamp(0.0, 255.0) as u8;
    match value {
        Value::Colour(colour) => Some(*colour),
        Value::Text(text) => parse::colour(text),
        Value::Integer(i) => u8::try_from(*i).ok().map(|g| Colour::rgb(g, g, g)),
        Value::Number(x) if x.is_finite() => Some(Colour::rgb(byte(*x), byte(*x), byte(*x))),
        Value::Point(p) if p.is_finite() => Some(Colour::rgb(byte(p.x), byte(p.y), byte(p.z))),
        Value::Vector(v) if v.is_finite() => Some(Colour::rgb(byte(v.x), byte(v.y), byte(v.z))),
        Value::Material(material) => Some(material.diffuse),
        _ => None,
    }
}
