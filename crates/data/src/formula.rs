//! Between values and what formulas compute with.

use std::sync::Arc;

use katydid_expression::Variant;

use crate::{Complex, Value};

/// A value as a formula sees it; `None` for the types that formulas do not take. Vectors are points there.
pub fn variant(value: &Value) -> Option<Variant> {
    Some(match value {
        Value::Boolean(b) => Variant::Boolean(*b),
        Value::Integer(i) => Variant::Integer(*i),
        Value::Number(x) => Variant::Number(*x),
        Value::Text(text) => Variant::Text(Arc::clone(text)),
        Value::Point(p) => Variant::Point(*p),
        Value::Vector(v) => Variant::Point(v.to_point()),
        Value::Plane(p) => Variant::Plane(**p),
        Value::Complex(z) => Variant::Complex { re: z.re, im: z.im },
        Value::Path(_) | Value::Guid(_) | Value::Domain(_) | Value::Time(_) => {
            Variant::Text(crate::text::value(value, &crate::text::Style::default()).into())
        }
        _ => return None,
    })
}

/// The result of a formula as a value; `None` for null.
pub fn value(variant: Variant) -> Option<Value> {
    Some(match variant {
        Variant::Null => return None,
        Variant::Boolean(b) => Value::Boolean(b),
        Variant::Integer(i) => Value::Integer(i),
        Variant::Number(x) => Value::Number(x),
        Variant::Text(text) => Value::Text(text),
        Variant::Point(p) => Value::Point(p),
        Variant::Plane(p) => Value::from(p),
        Variant::Complex { re, im } => Value::Complex(Complex { re, im }),
    })
}
