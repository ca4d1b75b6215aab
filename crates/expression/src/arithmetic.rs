//! The operators on values.

use std::sync::Arc;

use katydid_elementary::Elementary;
use katydid_geometry::{Point3, Vector3};

use crate::compare;
use crate::complex;
use crate::functions::numeric;
use crate::operator::{Binary, Postfix, Prefix};
use crate::{Dialect, EvalErrorKind, MAX_TEXT, Variant, parse_number};

type Evaluated = Result<Variant, EvalErrorKind>;

/// The number that a value counts as in arithmetic.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Scalar {
    Integer(i32),
    Number(f64),
    Complex(f64, f64),
}

impl Scalar {
    /// Booleans count as 0 and 1, and texts that read as a number as that number.
    pub(crate) fn of(value: &Variant) -> Option<Self> {
        match value {
            Variant::Boolean(b) => Some(Self::Integer(i32::from(*b))),
            Variant::Integer(i) => Some(Self::Integer(*i)),
            Variant::Number(x) => Some(Self::Number(*x)),
            Variant::Complex { re, im } => Some(Self::Complex(*re, *im)),
            Variant::Text(text) => parse_number(text).map(Self::Number),
            Variant::Null | Variant::Point(_) | Variant::Plane(_) => None,
        }
    }

    fn complex(self) -> complex::Complex {
        match self {
            Self::Integer(i) => (f64::from(i), 0.0),
            Self::Number(x) => (x, 0.0),
            Self::Complex(re, im) => (re, im),
        }
    }

    /// The real number; `None` for a complex one.
    pub(crate) fn real(self) -> Option<f64> {
        match self {
            Self::Integer(i) => Some(f64::from(i)),
            Self::Number(x) => Some(x),
            Self::Complex(..) => None,
        }
    }
}

/// Whether a value counts as true: numbers other than zero, texts "true" and "false".
pub(crate) fn truth(value: &Variant) -> Option<bool> {
    match value {
        Variant::Boolean(b) => Some(*b),
        Variant::Integer(i) => Some(*i != 0),
        Variant::Number(x) => Some(*x != 0.0),
        Variant::Text(text) => {
            let text = text.trim();
            if text.eq_ignore_ascii_case("true") {
                Some(true)
            } else if text.eq_ignore_ascii_case("false") {
                Some(false)
            } else {
                parse_number(text).map(|x| x != 0.0)
            }
        }
        Variant::Null | Variant::Point(_) | Variant::Plane(_) | Variant::Complex { .. } => None,
    }
}

/// One value between two. Null on either side gives null.
pub(crate) fn binary(operator: Binary, a: &Variant, b: &Variant) -> Evaluated {
    if a.is_null() || b.is_null() {
        return Ok(Variant::Null);
    }
    let wrong = || EvalErrorKind::OperandTypes {
        operator: operator.symbol(),
        left: a.type_name(),
        right: b.type_name(),
    };
    match operator {
        Binary::Join => join(&[a, b]),
        Binary::Add if matches!(a, Variant::Text(_)) || matches!(b, Variant::Text(_)) => join(&[a, b]),
        Binary::And | Binary::Or | Binary::Xor => {
            let (p, q) = (truth(a).ok_or_else(wrong)?, truth(b).ok_or_else(wrong)?);
            Ok(Variant::Boolean(match operator {
                Binary::And => p && q,
                Binary::Or => p || q,
                _ => p != q,
            }))
        }
        Binary::Equal => Ok(Variant::Boolean(compare::equal(a, b))),
        Binary::NotEqual => Ok(Variant::Boolean(!compare::equal(a, b))),
        Binary::Near => compare::near(a, b).map(Variant::Boolean).ok_or_else(wrong),
        Binary::Less | Binary::LessOrEqual | Binary::Greater | Binary::GreaterOrEqual => {
            compare::ordered(operator, a, b).map(Variant::Boolean).ok_or_else(wrong)
        }
        Binary::Angle => match (a, b) {
            (Variant::Point(p), Variant::Point(q)) => angle(*p, *q),
            _ => Err(wrong()),
        },
        _ => match (a, b) {
            (Variant::Point(p), Variant::Point(q)) => between_points(operator, *p, *q).ok_or_else(wrong),
            (Variant::Point(p), _) => match (operator, Scalar::of(b).and_then(Scalar::real)) {
                (Binary::Multiply, Some(s)) => Ok(scaled(*p, s)),
                (Binary::Divide, Some(0.0)) => Err(EvalErrorKind::DivisionByZero),
                (Binary::Divide, Some(s)) => Ok(Variant::Point((p.to_vector() / s).to_point())),
                _ => Err(wrong()),
            },
            (_, Variant::Point(p)) => match (operator, Scalar::of(a).and_then(Scalar::real)) {
                (Binary::Multiply, Some(s)) => Ok(scaled(*p, s)),
                _ => Err(wrong()),
            },
            _ => {
                let (x, y) = (Scalar::of(a).ok_or_else(wrong)?, Scalar::of(b).ok_or_else(wrong)?);
                between_scalars(operator, x, y).unwrap_or_else(|| Err(wrong()))
            }
        },
    }
}

/// One value before or behind a sign. Null gives null.
pub(crate) fn prefix(operator: Prefix, a: &Variant) -> Evaluated {
    if a.is_null() {
        return Ok(Variant::Null);
    }
    let wrong = || EvalErrorKind::OperandType { operator: operator.symbol(), operand: a.type_name() };
    match operator {
        Prefix::Not => truth(a).map(|b| Variant::Boolean(!b)).ok_or_else(wrong),
        Prefix::Plus => match a {
            Variant::Plane(_) => Err(wrong()),
            Variant::Text(_) => Scalar::of(a).map(|_| a.clone()).ok_or_else(wrong),
            _ => Ok(a.clone()),
        },
        Prefix::Minus => match a {
            Variant::Point(p) => Ok(Variant::Point(Point3::new(-p.x, -p.y, -p.z))),
            _ => Ok(match Scalar::of(a).ok_or_else(wrong)? {
                Scalar::Integer(i) => {
                    i.checked_neg().map_or(Variant::Number(-f64::from(i)), Variant::Integer)
                }
                Scalar::Number(x) => Variant::Number(-x),
                Scalar::Complex(re, im) => Variant::Complex { re: -re, im: -im },
            }),
        },
    }
}

/// A postfix operator or member. Null gives null.
pub(crate) fn postfix(operator: Postfix, a: &Variant) -> Evaluated {
    if a.is_null() {
        return Ok(Variant::Null);
    }
    let wrong = || EvalErrorKind::OperandType { operator: operator.symbol(), operand: a.type_name() };
    match operator {
        Postfix::Square => binary(Binary::Multiply, a, a).map_err(|_| wrong()),
        Postfix::Cube => {
            let square = binary(Binary::Multiply, a, a).map_err(|_| wrong())?;
            match a {
                Variant::Point(_) => Err(wrong()),
                _ => binary(Binary::Multiply, &square, a),
            }
        }
        Postfix::Degree => {
            let x = Scalar::of(a).and_then(Scalar::real).ok_or_else(wrong)?;
            Ok(Variant::Number(x.to_radians()))
        }
        Postfix::Imaginary => {
            let x = Scalar::of(a).and_then(Scalar::real).ok_or_else(wrong)?;
            Ok(Variant::Complex { re: 0.0, im: x })
        }
        Postfix::Factorial => match Scalar::of(a).ok_or_else(wrong)? {
            Scalar::Integer(i) => {
                let value = numeric::factorial(f64::from(i)).ok_or_else(|| factorial_error(f64::from(i)))?;
                Ok(numeric::integer(value).map_or(Variant::Number(value), Variant::Integer))
            }
            Scalar::Number(x) => numeric::factorial(x).map(Variant::Number).ok_or_else(|| factorial_error(x)),
            Scalar::Complex(..) => Err(wrong()),
        },
        Postfix::Unitize => match a {
            Variant::Point(p) => unitize(*p),
            _ => Err(wrong()),
        },
        Postfix::X | Postfix::Y | Postfix::Z | Postfix::Origin => member(operator, a).ok_or_else(wrong),
    }
}

fn factorial_error(x: f64) -> EvalErrorKind {
    let n = crate::number_text(x, Dialect::Modern);
    EvalErrorKind::OutOfRange {
        function: "!",
        reason: format!("a factorial needs a whole number of 0 to 170, not {n}"),
    }
}

/// Coordinates of a point; origin and axes of a plane.
fn member(operator: Postfix, a: &Variant) -> Option<Variant> {
    Some(match (a, operator) {
        (Variant::Point(p), Postfix::X) => Variant::Number(p.x),
        (Variant::Point(p), Postfix::Y) => Variant::Number(p.y),
        (Variant::Point(p), Postfix::Z) => Variant::Number(p.z),
        (Variant::Plane(p), Postfix::Origin) => Variant::Point(p.origin),
        (Variant::Plane(p), Postfix::X) => Variant::Point(p.x_axis.to_point()),
        (Variant::Plane(p), Postfix::Y) => Variant::Point(p.y_axis.to_point()),
        (Variant::Plane(p), Postfix::Z) => Variant::Point(p.z_axis.to_point()),
        _ => return None,
    })
}

fn scaled(p: Point3, s: f64) -> Variant {
    Variant::Point((p.to_vector() * s).to_point())
}

fn vector(v: Vector3) -> Variant {
    Variant::Point(v.to_point())
}

/// `*` between points is the dot product, like `•`; `×` is the cross product.
fn between_points(operator: Binary, p: Point3, q: Point3) -> Option<Variant> {
    let (a, b) = (p.to_vector(), q.to_vector());
    Some(match operator {
        Binary::Add => vector(a + b),
        Binary::Subtract => vector(a - b),
        Binary::Multiply | Binary::Dot => Variant::Number(a.dot(b)),
        Binary::Cross => vector(a.cross(b)),
        _ => return None,
    })
}

/// Two integers stay an integer under `+ - * \ %` as long as it fits; `/` and `^` always give a number.
/// `×` and `•` multiply. `None` when the operator does not know the types.
fn between_scalars(operator: Binary, x: Scalar, y: Scalar) -> Option<Evaluated> {
    use Scalar::{Complex, Integer};
    if let (Complex(..), _) | (_, Complex(..)) = (x, y) {
        let (a, b) = (x.complex(), y.complex());
        let (re, im) = match operator {
            Binary::Add => (a.0 + b.0, a.1 + b.1),
            Binary::Subtract => (a.0 - b.0, a.1 - b.1),
            Binary::Multiply | Binary::Cross | Binary::Dot => complex::multiply(a, b),
            Binary::Divide => match complex::divide(a, b) {
                Some(quotient) => quotient,
                None => return Some(Err(EvalErrorKind::DivisionByZero)),
            },
            Binary::Power => complex::power(a, b),
            _ => return None,
        };
        return Some(Ok(Variant::Complex { re, im }));
    }
    let (a, b) = (x.real()?, y.real()?);
    if let (Integer(i), Integer(j)) = (x, y) {
        let whole = match operator {
            Binary::Add => i.checked_add(j),
            Binary::Subtract => i.checked_sub(j),
            Binary::Multiply | Binary::Cross | Binary::Dot => i.checked_mul(j),
            Binary::IntegerDivide => i.checked_div(j),
            Binary::Modulus if j != 0 => Some(i.wrapping_rem(j)),
            _ => None,
        };
        if let Some(whole) = whole {
            return Some(Ok(Variant::Integer(whole)));
        }
    }
    let zero = b == 0.0;
    Some(
        match operator {
            Binary::Add => Ok(a + b),
            Binary::Subtract => Ok(a - b),
            Binary::Multiply | Binary::Cross | Binary::Dot => Ok(a * b),
            Binary::Power => Ok(numeric::power(a, b)),
            Binary::Divide | Binary::IntegerDivide | Binary::Modulus if zero => {
                Err(EvalErrorKind::DivisionByZero)
            }
            Binary::Divide => Ok(a / b),
            Binary::IntegerDivide => Ok((a / b).trunc()),
            Binary::Modulus => Ok(a % b),
            _ => return None,
        }
        .map(Variant::Number),
    )
}

/// The angle between two vectors, 0..π, by the arc tangent of cross and dot product (accurate near 0 and π).
pub(crate) fn angle(p: Point3, q: Point3) -> Evaluated {
    let unit = |v: Point3| {
        v.to_vector().unitized().ok_or_else(|| EvalErrorKind::OutOfRange {
            function: "Angle",
            reason: "a vector has no direction".into(),
        })
    };
    let (a, b) = (unit(p)?, unit(q)?);
    Ok(Variant::Number(a.cross(b).length().arctangent_of(a.dot(b))))
}

pub(crate) fn unitize(p: Point3) -> Evaluated {
    p.to_vector().unitized().map(vector).ok_or_else(|| EvalErrorKind::OutOfRange {
        function: "Unitize",
        reason: "the vector has no direction".into(),
    })
}

/// The values' texts one behind the other.
pub(crate) fn join(values: &[&Variant]) -> Evaluated {
    let mut text = String::new();
    for value in values {
        match value {
            Variant::Text(part) => {
                if text.len().saturating_add(part.len()) > MAX_TEXT {
                    return Err(EvalErrorKind::TextTooLong(MAX_TEXT));
                }
                text.push_str(part);
            }
            other => text.push_str(&other.to_text(Dialect::Modern)),
        }
    }
    if text.len() > MAX_TEXT {
        return Err(EvalErrorKind::TextTooLong(MAX_TEXT));
    }
    Ok(Variant::Text(Arc::from(text)))
}
