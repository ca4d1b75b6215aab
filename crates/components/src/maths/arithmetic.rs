//! Arithmetic on values of any type: what `+ − × ÷` mean for numbers, points, vectors, texts, domains, colours.

use katydid_component::Message;
use katydid_data::{Colour, Complex, Value, cast};
use katydid_elementary::Elementary;
use katydid_geometry::{Interval, Matrix, Point3, Vector3};

type Result = std::result::Result<Value, Message>;

fn unsupported(verb: &str, a: &Value, b: &Value) -> Message {
    Message::error(format!("{} and {} cannot be {verb}", a.kind(), b.kind()))
}

/// A text that reads as a number counts as that number, and a boolean as 0 or 1.
fn as_number(value: &Value) -> Value {
    match value {
        Value::Text(text) => cast::parse_number(text).map_or_else(|| value.clone(), Value::Number),
        Value::Boolean(b) => Value::Integer(i32::from(*b)),
        other => other.clone(),
    }
}

/// Two integers as an integer where it fits 32 bits, else as a number.
fn integers(a: i32, b: i32, exact: fn(i32, i32) -> Option<i32>, real: fn(f64, f64) -> f64) -> Value {
    exact(a, b).map_or_else(|| Value::Number(real(f64::from(a), f64::from(b))), Value::Integer)
}

fn float(value: &Value) -> Option<f64> {
    match value {
        Value::Number(x) => Some(*x),
        Value::Integer(i) => Some(f64::from(*i)),
        _ => None,
    }
}

fn complex(value: &Value) -> Option<Complex> {
    match value {
        Value::Complex(z) => Some(*z),
        other => float(other).map(|re| Complex { re, im: 0.0 }),
    }
}

fn channels(a: Colour, b: Colour, f: impl Fn(i32, i32) -> i32) -> Value {
    let mix = |x: u8, y: u8| f(i32::from(x), i32::from(y)).clamp(0, 255) as u8;
    Value::Colour(Colour { a: a.a.max(b.a), r: mix(a.r, b.r), g: mix(a.g, b.g), b: mix(a.b, b.b) })
}

/// Two matrices of one size, entry by entry.
fn entries(a: &Matrix, b: &Matrix, f: impl Fn(f64, f64) -> f64) -> Result {
    if (a.rows(), a.columns()) != (b.rows(), b.columns()) {
        return Err(Message::error(format!(
            "A matrix of {} × {} and one of {} × {} have no entries in common",
            a.rows(),
            a.columns(),
            b.rows(),
            b.columns()
        )));
    }
    let values = a.values().iter().zip(b.values()).map(|(x, y)| f(*x, *y)).collect();
    Ok(Value::from(Matrix::new(a.rows(), a.columns(), values)?))
}

/// a + b: numbers, points and vectors by components, two texts joined, a domain shifted.
pub(super) fn add(a: &Value, b: &Value) -> Result {
    if let (Value::Number(x), Value::Number(y)) = (a, b) {
        return Ok(Value::Number(x + y));
    }
    if let (Value::Text(x), Value::Text(y)) = (a, b) {
        if let (Some(x), Some(y)) = (cast::parse_number(x), cast::parse_number(y)) {
            return Ok(Value::Number(x + y));
        }
        return Ok(Value::from(format!("{x}{y}")));
    }
    let (x, y) = (as_number(a), as_number(b));
    if let (Some(x), Some(y)) = (float(&x), float(&y)) {
        if let (Value::Integer(x), Value::Integer(y)) = (as_number(a), as_number(b)) {
            return Ok(integers(x, y, i32::checked_add, |x, y| x + y));
        }
        return Ok(Value::Number(x + y));
    }
    Ok(match (&x, &y) {
        (Value::Point(p), Value::Vector(v)) | (Value::Vector(v), Value::Point(p)) => Value::Point(*p + *v),
        (Value::Point(p), Value::Point(q)) => Value::Point(*p + q.to_vector()),
        (Value::Vector(v), Value::Vector(w)) => Value::Vector(*v + *w),
        (Value::Domain(d), n) | (n, Value::Domain(d)) if float(n).is_some() => {
            let n = float(n).unwrap_or_default();
            Value::Domain(Interval::new(d.start + n, d.end + n))
        }
        (Value::Domain(d), Value::Domain(e)) => {
            Value::Domain(Interval::new(d.start + e.start, d.end + e.end))
        }
        (Value::Colour(c), Value::Colour(d)) => channels(*c, *d, |x, y| x + y),
        (Value::Plane(p), Value::Vector(v)) => {
            Value::from(katydid_geometry::Plane { origin: p.origin + *v, ..**p })
        }
        (Value::Matrix(m), Value::Matrix(n)) => entries(m, n, |x, y| x + y)?,
        (Value::Text(t), other) | (other, Value::Text(t)) if matches!(a, Value::Text(_)) => {
            Value::from(format!("{t}{}", katydid_data::text::value(other, &Default::default())))
        }
        (other, Value::Text(t)) => {
            Value::from(format!("{}{t}", katydid_data::text::value(other, &Default::default())))
        }
        _ => match (complex(&x), complex(&y)) {
            (Some(x), Some(y)) => Value::Complex(Complex { re: x.re + y.re, im: x.im + y.im }),
            _ => return Err(unsupported("added", a, b)),
        },
    })
}

/// a − b: the difference of two points is a vector.
pub(super) fn subtract(a: &Value, b: &Value) -> Result {
    if let (Value::Number(x), Value::Number(y)) = (a, b) {
        return Ok(Value::Number(x - y));
    }
    let (x, y) = (as_number(a), as_number(b));
    if let (Value::Integer(x), Value::Integer(y)) = (&x, &y) {
        return Ok(integers(*x, *y, i32::checked_sub, |x, y| x - y));
    }
    if let (Some(x), Some(y)) = (float(&x), float(&y)) {
        return Ok(Value::Number(x - y));
    }
    Ok(match (&x, &y) {
        (Value::Point(p), Value::Point(q)) => Value::Vector(*p - *q),
        (Value::Point(p), Value::Vector(v)) => Value::Point(*p - *v),
        (Value::Vector(v), Value::Vector(w)) => Value::Vector(*v - *w),
        (Value::Vector(v), Value::Point(p)) => Value::Vector(*v - p.to_vector()),
        (Value::Domain(d), n) if float(n).is_some() => {
            let n = float(n).unwrap_or_default();
            Value::Domain(Interval::new(d.start - n, d.end - n))
        }
        (Value::Domain(d), Value::Domain(e)) => {
            Value::Domain(Interval::new(d.start - e.start, d.end - e.end))
        }
        (Value::Colour(c), Value::Colour(d)) => channels(*c, *d, |x, y| x - y),
        (Value::Matrix(m), Value::Matrix(n)) => entries(m, n, |x, y| x - y)?,
        _ => match (complex(&x), complex(&y)) {
            (Some(x), Some(y)) => Value::Complex(Complex { re: x.re - y.re, im: x.im - y.im }),
            _ => return Err(unsupported("subtracted", a, b)),
        },
    })
}

/// a × b: numbers scale vectors, points and domains; two vectors give their dot product.
pub(super) fn multiply(a: &Value, b: &Value) -> Result {
    if let (Value::Number(x), Value::Number(y)) = (a, b) {
        return Ok(Value::Number(x * y));
    }
    let (x, y) = (as_number(a), as_number(b));
    if let (Value::Integer(x), Value::Integer(y)) = (&x, &y) {
        return Ok(integers(*x, *y, i32::checked_mul, |x, y| x * y));
    }
    match (float(&x), float(&y)) {
        (Some(x), Some(y)) => return Ok(Value::Number(x * y)),
        (Some(s), None) => {
            if let Some(scaled) = scale(&y, s) {
                return Ok(scaled);
            }
        }
        (None, Some(s)) => {
            if let Some(scaled) = scale(&x, s) {
                return Ok(scaled);
            }
        }
        (None, None) => {}
    }
    Ok(match (&x, &y) {
        (Value::Vector(v), Value::Vector(w)) => Value::Number(v.dot(*w)),
        (Value::Colour(c), Value::Colour(d)) => channels(*c, *d, |x, y| (x * y + 127) / 255),
        (Value::Matrix(m), Value::Matrix(n)) => Value::from(m.product(n)?),
        _ if x.as_transform().is_some() => match (x.as_transform(), y.as_transform()) {
            (Some(f), Some(g)) => Value::from(f * g),
            _ => return Err(unsupported("multiplied", a, b)),
        },
        _ => match (complex(&x), complex(&y)) {
            (Some(x), Some(y)) => {
                Value::Complex(Complex { re: x.re * y.re - x.im * y.im, im: x.re * y.im + x.im * y.re })
            }
            _ => return Err(unsupported("multiplied", a, b)),
        },
    })
}

/// A value stretched by a number.
fn scale(value: &Value, s: f64) -> Option<Value> {
    Some(match value {
        Value::Vector(v) => Value::Vector(*v * s),
        Value::Point(p) => Value::Point((p.to_vector() * s).to_point()),
        Value::Domain(d) => Value::Domain(Interval::new(d.start * s, d.end * s)),
        Value::Complex(z) => Value::Complex(Complex { re: z.re * s, im: z.im * s }),
        Value::Matrix(m) => entries(m, m, |x, _| x * s).ok()?,
        Value::Colour(c) => {
            let channel = |x: u8| (f64::from(x) * s).round().clamp(0.0, 255.0) as u8;
            Value::Colour(Colour { a: c.a, r: channel(c.r), g: channel(c.g), b: channel(c.b) })
        }
        _ => return None,
    })
}

/// a ÷ b as a real quotient, of integers too.
pub(super) fn divide(a: &Value, b: &Value) -> Result {
    let (x, y) = (as_number(a), as_number(b));
    if let Some(divisor) = float(&y) {
        if divisor == 0.0 {
            return Err(Message::error("Division by zero"));
        }
        if let Some(x) = float(&x) {
            return Ok(Value::Number(x / divisor));
        }
        // Not times the inverse: that would round twice.
        match &x {
            Value::Vector(v) => return Ok(Value::Vector(*v / divisor)),
            Value::Point(p) => return Ok(Value::Point((p.to_vector() / divisor).to_point())),
            Value::Domain(d) => return Ok(Value::Domain(Interval::new(d.start / divisor, d.end / divisor))),
            Value::Matrix(_) | Value::Colour(_) => {
                return scale(&x, divisor.recip()).ok_or_else(|| unsupported("divided", a, b));
            }
            _ => {}
        }
    }
    match (complex(&x), complex(&y)) {
        (Some(x), Some(y)) => {
            let d = y.re * y.re + y.im * y.im;
            if d == 0.0 {
                return Err(Message::error("Division by zero"));
            }
            Ok(Value::Complex(Complex {
                re: (x.re * y.re + x.im * y.im) / d,
                im: (x.im * y.re - x.re * y.im) / d,
            }))
        }
        _ => Err(unsupported("divided", a, b)),
    }
}

/// −a.
pub(super) fn negate(a: &Value) -> Result {
    Ok(match as_number(a) {
        Value::Number(x) => Value::Number(-x),
        Value::Integer(i) => i.checked_neg().map_or_else(|| Value::Number(-f64::from(i)), Value::Integer),
        Value::Vector(v) => Value::Vector(-v),
        Value::Point(p) => Value::Point(Point3::ORIGIN + -p.to_vector()),
        Value::Domain(d) => Value::Domain(Interval::new(-d.start, -d.end)),
        Value::Complex(z) => Value::Complex(Complex { re: -z.re, im: -z.im }),
        Value::Colour(c) => Value::Colour(Colour { a: c.a, r: 255 - c.r, g: 255 - c.g, b: 255 - c.b }),
        Value::Matrix(m) => entries(&m, &m, |x, _| -x)?,
        other => return Err(Message::error(format!("{} has no negative", other.kind()))),
    })
}

/// |a|: of a vector, its components without signs.
pub(super) fn absolute(a: &Value) -> Result {
    Ok(match as_number(a) {
        Value::Number(x) => Value::Number(x.abs()),
        Value::Integer(i) => {
            i.checked_abs().map_or_else(|| Value::Number(f64::from(i).abs()), Value::Integer)
        }
        Value::Complex(z) => Value::Number(z.re.hypotenuse(z.im)),
        Value::Vector(v) => Value::Vector(Vector3::new(v.x.abs(), v.y.abs(), v.z.abs())),
        Value::Point(p) => Value::Point(Point3::new(p.x.abs(), p.y.abs(), p.z.abs())),
        other => return Err(Message::error(format!("{} has no absolute value", other.kind()))),
    })
}
