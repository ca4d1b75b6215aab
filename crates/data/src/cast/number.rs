//! To booleans, numbers, domains and colours.

use katydid_geometry::{Curve, Direction, Interval};

use super::Sure::{Likely, Ours, Shown, Used};
use super::way::{Way, way};
use super::{curve, parse};
use crate::{Colour, Complex, DateTime, Domain2, Kind, Value};

/// The types that count as curves.
pub(super) const CURVES: [Kind; 5] = [Kind::Curve, Kind::Line, Kind::Circle, Kind::Arc, Kind::Rectangle];

pub(super) const WAYS: &[Way] = &[
    way(Kind::Boolean, &[Kind::Integer, Kind::Number], "False for 0, else True", Likely, to_boolean),
    way(
        Kind::Boolean,
        &[Kind::Text],
        "that of `true`, `yes`, `false` and `no` in any case, or of the number",
        Shown,
        to_boolean,
    ),
    way(Kind::Integer, &[Kind::Boolean], "1 for True, 0 for False", Likely, to_integer),
    way(Kind::Integer, &[Kind::Number], "the nearest one, halves to the even one", Likely, to_integer),
    way(
        Kind::Integer,
        &[Kind::Text],
        "the number that it spells, rounded; 1 for `true`, 0 for `false`",
        Used,
        to_integer,
    ),
    way(
        Kind::Integer,
        &[Kind::Complex],
        "the rounded real part of one without imaginary part",
        Likely,
        to_integer,
    ),
    way(Kind::Integer, &[Kind::Point, Kind::Vector], "the length, rounded", Shown, to_integer),
    way(Kind::Integer, &CURVES, "the length, rounded", Used, to_integer),
    way(Kind::Integer, &[Kind::Domain], "end less start, rounded", Likely, to_integer),
    way(Kind::Integer, &[Kind::Path], "the index of a path of one", Ours, to_integer),
    way(Kind::Number, &[Kind::Boolean], "1 for True, 0 for False", Likely, to_number),
    way(Kind::Number, &[Kind::Integer], "the same number", Shown, to_number),
    way(
        Kind::Number,
        &[Kind::Text],
        "the number, or the value of the formula, that it spells: `1,000` is 1000; 1 for `true`, 0 for `false`",
        Shown,
        to_number,
    ),
    way(Kind::Number, &[Kind::Complex], "the real part of one without imaginary part", Likely, to_number),
    way(
        Kind::Number,
        &[Kind::Time],
        "its day, counted from 1899-12-30, with the time as fraction",
        Likely,
        to_number,
    ),
    way(Kind::Number, &[Kind::Vector], "its length", Shown, to_number),
    way(Kind::Number, &[Kind::Point], "its distance from the origin", Shown, to_number),
    way(Kind::Number, &CURVES, "its length", Used, to_number),
    way(Kind::Number, &[Kind::Domain], "end less start", Likely, to_number),
    way(
        Kind::Number,
        &[Kind::Colour],
        "its brightness from 0 to 1, half way between its least and greatest channel",
        Ours,
        to_number,
    ),
    way(Kind::Number, &[Kind::Path], "the index of a path of one", Ours, to_number),
    way(
        Kind::Complex,
        &[Kind::Boolean, Kind::Integer, Kind::Number, Kind::Time],
        "the number as the real part",
        Likely,
        to_complex,
    ),
    way(Kind::Complex, &[Kind::Text], "the number that it spells, such as `3 + 4i`", Likely, to_complex),
    way(
        Kind::Complex,
        &[Kind::Point, Kind::Vector],
        "x as the real and y as the imaginary part",
        Likely,
        to_complex,
    ),
    way(
        Kind::Colour,
        &[Kind::Text],
        "the name, `r,g,b`, `r,g,b (a)` or `#rrggbb` that it spells",
        Likely,
        to_colour,
    ),
    way(
        Kind::Colour,
        &[Kind::Integer, Kind::Number],
        "the grey of 0, black, to 255, white",
        Likely,
        to_colour,
    ),
    way(
        Kind::Colour,
        &[Kind::Point, Kind::Vector],
        "x, y and z as red, green and blue from 0 to 255",
        Likely,
        to_colour,
    ),
    way(Kind::Colour, &[Kind::Material], "its diffuse colour", Likely, to_colour),
    way(
        Kind::Domain,
        &[Kind::Boolean, Kind::Integer, Kind::Number],
        "the domain from 0 to the number",
        Shown,
        to_domain,
    ),
    way(
        Kind::Domain,
        &[Kind::Text],
        "the domain that it spells, such as `2 to 5`, or from 0 to the number",
        Shown,
        to_domain,
    ),
    way(Kind::Domain, &CURVES, "its domain as a curve", Shown, to_domain),
    way(Kind::Domain, &[Kind::Complex], "from the real to the imaginary part", Likely, to_domain),
    way(Kind::Domain, &[Kind::Point, Kind::Vector], "from x to y", Ours, to_domain),
    way(
        Kind::Domain2,
        &[Kind::Surface, Kind::Brep],
        "the domains of the surface, of a Brep of one face",
        Shown,
        to_domain2,
    ),
    way(Kind::Domain2, &[Kind::Text], "what it spells, such as `u:{0 To 1} v:{0 To 2}`", Likely, to_domain2),
    way(Kind::Domain2, &[Kind::Rectangle], "its sizes", Likely, to_domain2),
    way(Kind::Domain2, &[Kind::Domain], "the domain in both directions", Likely, to_domain2),
    way(
        Kind::Domain2,
        &[Kind::Integer, Kind::Number],
        "from 0 to the number in both directions",
        Ours,
        to_domain2,
    ),
];

fn to_boolean(value: &Value, _: &super::Rules) -> Option<Value> {
    boolean(value).map(Value::Boolean)
}

fn to_integer(value: &Value, _: &super::Rules) -> Option<Value> {
    integer(value).map(Value::Integer)
}

fn to_number(value: &Value, _: &super::Rules) -> Option<Value> {
    number(value).map(Value::Number)
}

fn to_complex(value: &Value, _: &super::Rules) -> Option<Value> {
    complex(value).map(Value::Complex)
}

fn to_colour(value: &Value, _: &super::Rules) -> Option<Value> {
    colour(value).map(Value::Colour)
}

fn to_domain(value: &Value, _: &super::Rules) -> Option<Value> {
    domain(value).map(Value::Domain)
}

fn to_domain2(value: &Value, _: &super::Rules) -> Option<Value> {
    domain2(value).map(Value::from)
}

/// 0 is false, every other number true; texts by their words.
fn boolean(value: &Value) -> Option<bool> {
    match value {
        Value::Integer(i) => Some(*i != 0),
        Value::Number(x) => Some(*x != 0.0),
        Value::Text(text) => parse::boolean(text),
        _ => None,
    }
}

/// The nearest integer, halves to the even one, as .NET's `Convert.ToInt32`; none outside 32 bits.
pub(super) fn integer(value: &Value) -> Option<i32> {
    let rounded = number(value)?.round_ties_even();
    (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&rounded).then_some(rounded as i32)
}

pub(super) fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(x) => Some(*x),
        Value::Boolean(b) => Some(f64::from(u8::from(*b))),
        Value::Integer(i) => Some(f64::from(*i)),
        Value::Text(text) => {
            let spelled = parse::number(text).or_else(|| parse::grouped_number(text));
            spelled.or_else(|| parse::truth(text).map(|b| f64::from(u8::from(b))))
        }
        Value::Complex(z) if z.im == 0.0 => Some(z.re),
        Value::Time(time) => Some((time.ticks - FIRST_DAY) as f64 / TICKS_A_DAY),
        Value::Vector(v) => Some(v.length()),
        Value::Point(p) => Some(p.to_vector().length()),
        Value::Line(line) => Some(line.length()),
        Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) | Value::Curve(_) => {
            curve::curve(value).map(|curve| curve.length())
        }
        Value::Domain(d) => Some(d.length()),
        Value::Colour(c) => {
            let channels = [c.r, c.g, c.b].map(|channel| f64::from(channel) / 255.0);
            let least = channels.into_iter().fold(f64::INFINITY, f64::min);
            Some((least + channels.into_iter().fold(0.0, f64::max)) / 2.0)
        }
        Value::Path(path) => match path.elements() {
            [index] => Some(f64::from(*index)),
            _ => None,
        },
        _ => None,
    }
}

/// The ticks of 1899-12-30, from which OLE automation counts its days.
const FIRST_DAY: i64 = 599_264_352_000_000_000;
const TICKS_A_DAY: f64 = 864e9;

/// The moment of a day number; `None` outside the years 1 to 9999.
pub(super) fn day(number: f64) -> Option<DateTime> {
    const LAST: f64 = 3_155_378_975_999_999_999.0;
    let ticks = (number * TICKS_A_DAY).round() + FIRST_DAY as f64;
    (0.0..=LAST).contains(&ticks).then_some(DateTime { ticks: ticks as i64 })
}

fn complex(value: &Value) -> Option<Complex> {
    match value {
        Value::Text(text) => parse::complex(text),
        Value::Point(p) => Some(Complex { re: p.x, im: p.y }),
        Value::Vector(v) => Some(Complex { re: v.x, im: v.y }),
        _ => number(value).map(|re| Complex { re, im: 0.0 }),
    }
}

/// A number n is the domain from 0 to n; a text is `a to b`; a curve, and what casts to one, has its own.
fn domain(value: &Value) -> Option<Interval> {
    match value {
        Value::Text(text) => parse::domain(text),
        Value::Curve(curve) => Some(Curve::domain(curve)),
        Value::Line(_) | Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) => {
            curve::curve(value).map(|curve| Curve::domain(&curve))
        }
        Value::Complex(z) => Some(Interval::new(z.re, z.im)),
        Value::Point(p) => Some(Interval::new(p.x, p.y)),
        Value::Vector(v) => Some(Interval::new(v.x, v.y)),
        _ => number(value).map(|n| Interval::new(0.0, n)),
    }
}

/// A surface's domains, a rectangle's sizes, a text `u:{a To b} v:{c To d}`, or one domain in both directions.
fn domain2(value: &Value) -> Option<Domain2> {
    let both = |d: Interval| Domain2 { u: d, v: d };
    let of_surface =
        |s: &katydid_geometry::Surface| Domain2 { u: s.domain(Direction::U), v: s.domain(Direction::V) };
    match value {
        Value::Text(text) => parse::domain2(text).or_else(|| parse::domain(text).map(both)),
        Value::Surface(s) => Some(of_surface(s)),
        Value::Brep(_) | Value::Kept(_) => {
            let brep = value.brep()?.ok()?;
            let [_] = brep.faces() else { return None };
            brep.face_surface(0).map(of_surface)
        }
        Value::Rectangle(r) => Some(Domain2 { u: r.x, v: r.y }),
        Value::Domain(d) => Some(both(*d)),
        _ => number(value).map(|n| both(Interval::new(0.0, n))),
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
