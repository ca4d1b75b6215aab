//! Equality, nearness and order.

use std::cmp::Ordering;

use crate::Variant;
use crate::arithmetic::Scalar;
use crate::complex;
use crate::operator::Binary;

/// Two numbers are near (`≈`) when they differ by at most this share of the larger one, or of 1. The original's
/// measure is not published.
const NEAR: f64 = 1e-6;

/// Exact equality. Numbers of any type compare by value, texts letter for letter; a text that reads as a number
/// equals that number. Anything else of different types is different.
pub(crate) fn equal(a: &Variant, b: &Variant) -> bool {
    match (a, b) {
        (Variant::Text(p), Variant::Text(q)) => p == q,
        (Variant::Text(t), Variant::Boolean(_)) | (Variant::Boolean(_), Variant::Text(t))
            if crate::parse_number(t).is_none() =>
        {
            crate::arithmetic::truth(a) == crate::arithmetic::truth(b)
        }
        (Variant::Point(p), Variant::Point(q)) => p == q,
        (Variant::Plane(p), Variant::Plane(q)) => p == q,
        _ => match (Scalar::of(a), Scalar::of(b)) {
            (Some(x), Some(y)) => match (x.real(), y.real()) {
                (Some(x), Some(y)) => x == y,
                _ => parts(x) == parts(y),
            },
            _ => false,
        },
    }
}

fn parts(x: Scalar) -> (f64, f64) {
    match x {
        Scalar::Integer(i) => (f64::from(i), 0.0),
        Scalar::Number(x) => (x, 0.0),
        Scalar::Complex(re, im) => (re, im),
    }
}

/// Whether two real numbers are near.
pub(crate) fn near_numbers(x: f64, y: f64) -> bool {
    x == y || (x - y).abs() <= NEAR * x.abs().max(y.abs()).max(1.0)
}

/// Nearness of numbers and points; texts are near when equal but for case.
pub(crate) fn near(a: &Variant, b: &Variant) -> Option<bool> {
    match (a, b) {
        (Variant::Text(p), Variant::Text(q)) => Some(p.to_lowercase() == q.to_lowercase()),
        (Variant::Point(p), Variant::Point(q)) => {
            Some(near_numbers(p.x, q.x) && near_numbers(p.y, q.y) && near_numbers(p.z, q.z))
        }
        _ => {
            let (x, y) = (Scalar::of(a)?, Scalar::of(b)?);
            match (x.real(), y.real()) {
                (Some(x), Some(y)) => Some(near_numbers(x, y)),
                _ => {
                    let (p, q) = (parts(x), parts(y));
                    let gap = complex::modulus((p.0 - q.0, p.1 - q.1));
                    Some(gap <= NEAR * complex::modulus(p).max(complex::modulus(q)).max(1.0))
                }
            }
        }
    }
}

/// `< ≤ > ≥`: numbers by value, texts as a dictionary sorts them. Points, planes and complex numbers have no
/// order: `None`.
pub(crate) fn ordered(operator: Binary, a: &Variant, b: &Variant) -> Option<bool> {
    let order = match (a, b) {
        (Variant::Text(p), Variant::Text(q)) => Some(dictionary(p, q)),
        _ => Scalar::of(a)?.real()?.partial_cmp(&Scalar::of(b)?.real()?),
    };
    Some(match operator {
        Binary::Less => order == Some(Ordering::Less),
        Binary::LessOrEqual => matches!(order, Some(Ordering::Less | Ordering::Equal)),
        Binary::Greater => order == Some(Ordering::Greater),
        _ => matches!(order, Some(Ordering::Greater | Ordering::Equal)),
    })
}

/// Letters first without regard to case, then small before capital, as .NET's invariant culture does for plain
/// letters.
fn dictionary(a: &str, b: &str) -> Ordering {
    let fold = |s: &str| s.chars().flat_map(char::to_lowercase).collect::<String>();
    fold(a).cmp(&fold(b)).then_with(|| b.cmp(a))
}
