//! Values that can be averaged and interpolated: those that are a few numbers side by side.

use katydid_component::Message;
use katydid_data::{Colour, Complex, DateTime, Kind, Value, cast};
use katydid_geometry::{Interval, Point3, Vector3};

/// A value as up to four numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Numbers {
    kind: Kind,
    parts: [f64; 4],
}

impl Numbers {
    /// The numbers of a value. Whole numbers, truth values and texts that read as numbers are numbers.
    ///
    /// # Errors
    /// For a type that is not a few numbers.
    pub(super) fn of(value: &Value) -> Result<Self, Message> {
        let (kind, parts) = match value {
            Value::Number(x) => (Kind::Number, [*x, 0.0, 0.0, 0.0]),
            Value::Integer(i) => (Kind::Number, [f64::from(*i), 0.0, 0.0, 0.0]),
            Value::Boolean(b) => (Kind::Number, [f64::from(u8::from(*b)), 0.0, 0.0, 0.0]),
            Value::Text(text) => {
                let x = cast::parse_number(text);
                let x = x.ok_or_else(|| Message::error(format!("The text {text:.40} is not a number")))?;
                (Kind::Number, [x, 0.0, 0.0, 0.0])
            }
            Value::Complex(z) => (Kind::Complex, [z.re, z.im, 0.0, 0.0]),
            Value::Point(p) => (Kind::Point, [p.x, p.y, p.z, 0.0]),
            Value::Vector(v) => (Kind::Vector, [v.x, v.y, v.z, 0.0]),
            Value::Colour(c) => (Kind::Colour, [c.a, c.r, c.g, c.b].map(f64::from)),
            Value::Domain(d) => (Kind::Domain, [d.start, d.end, 0.0, 0.0]),
            Value::Time(t) => (Kind::Time, [t.ticks as f64, 0.0, 0.0, 0.0]),
            other => return Err(Message::error(format!("{} cannot be averaged", other.kind()))),
        };
        Ok(Self { kind, parts })
    }

    /// The value of these numbers. Colours are rounded to what they can hold.
    pub(super) fn value(self) -> Value {
        let [a, b, c, d] = self.parts;
        let byte = |x: f64| x.round().clamp(0.0, 255.0) as u8;
        match self.kind {
            Kind::Complex => Value::Complex(Complex { re: a, im: b }),
            Kind::Point => Value::Point(Point3::new(a, b, c)),
            Kind::Vector => Value::Vector(Vector3::new(a, b, c)),
            Kind::Colour => Value::Colour(Colour { a: byte(a), r: byte(b), g: byte(c), b: byte(d) }),
            Kind::Domain => Value::Domain(Interval::new(a, b)),
            Kind::Time => Value::Time(DateTime { ticks: a.round() as i64 }),
            _ => Value::Number(a),
        }
    }

    /// The sum of values, each taken so many times. Points and vectors, numbers and complex numbers mix.
    ///
    /// # Errors
    /// For types that do not mix.
    pub(super) fn sum(terms: impl IntoIterator<Item = (Self, f64)>) -> Result<Option<Self>, Message> {
        let mut sum: Option<Self> = None;
        for (Self { kind, parts }, times) in terms {
            let s = sum.get_or_insert(Self { kind, parts: [0.0; 4] });
            s.kind = match (s.kind, kind) {
                (a, b) if a == b => a,
                (Kind::Point, Kind::Vector) | (Kind::Vector, Kind::Point) => Kind::Point,
                (Kind::Number, Kind::Complex) | (Kind::Complex, Kind::Number) => Kind::Complex,
                (a, b) => return Err(Message::error(format!("{a} and {b} have no average"))),
            };
            for (s, x) in s.parts.iter_mut().zip(parts) {
                *s += times * x;
            }
        }
        Ok(sum)
    }

    /// The same numbers, each divided by `x`.
    pub(super) fn over(self, x: f64) -> Self {
        Self { parts: self.parts.map(|p| p / x), ..self }
    }
}
