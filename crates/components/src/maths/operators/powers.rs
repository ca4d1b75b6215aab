//! Powers, remainders, factorials.

use katydid_component::{Message, component};
use katydid_data::{Complex, Value, cast};
use katydid_elementary::Elementary;

use super::super::complex;

/// A value as the number it is or reads as.
fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(x) => Some(*x),
        Value::Integer(i) => Some(f64::from(*i)),
        Value::Boolean(b) => Some(f64::from(u8::from(*b))),
        Value::Text(text) => cast::parse_number(text),
        _ => None,
    }
}

fn complex_number(value: &Value) -> Option<Complex> {
    match value {
        Value::Complex(z) => Some(*z),
        other => number(other).map(|re| Complex { re, im: 0.0 }),
    }
}

/// Raises A to the power B, both numbers or complex numbers.
///
/// A negative number has no real power of a broken exponent: that is an error, unless it comes as a complex one.
#[component(
    "78fed580-851b-46fe-af2f-6519a9d378e0",
    name = "Power",
    nick = "Pow",
    at = "Maths/Operators",
    also("2d6cb24f-da89-4fab-be0f-e5d439e0217a", "96c8c5f2-5f8e-4bb3-b19f-eb61d9cefa46")
)]
#[output("Result", "R", "The power.")]
fn power(
    /// The base.
    #[port("A", "A")]
    a: Value,
    /// The exponent.
    #[port("B", "B")]
    b: Value,
) -> Result<Value, Message> {
    if let (Some(x), Some(y)) = (number(&a), number(&b)) {
        let power = x.raised_to(y);
        if power.is_nan() || (power.is_infinite() && x.is_finite() && y.is_finite()) {
            return Err(Message::error(format!(
                "{x} to the power {y} is not a real number that can be written"
            )));
        }
        return Ok(Value::Number(power));
    }
    match (complex_number(&a), complex_number(&b)) {
        (Some(z), Some(w)) => Ok(Value::Complex(complex::power(z, w))),
        _ => Err(Message::error(format!("{} has no power of {}", a.kind(), b.kind()))),
    }
}

/// The remainder of A divided by B, with the sign of A.
///
/// Dividing by zero is an error.
#[component(
    "431bc610-8ae1-4090-b217-1a9d9c519fe2",
    name = "Modulus",
    nick = "Mod",
    at = "Maths/Operators",
    also("481e1f0d-a945-4662-809d-f49d1a8f40bd", "9ebccbb4-f3e3-4ee1-af31-2f301f2516f0")
)]
#[output("Result", "R", "The remainder.")]
fn modulus(
    /// What is divided.
    #[port("A", "A")]
    a: Value,
    /// What it is divided by; not zero.
    #[port("B", "B")]
    b: Value,
) -> Result<Value, Message> {
    if let (Value::Integer(x), Value::Integer(y)) = (&a, &b) {
        // The one overflow, of the smallest integer by -1, leaves no remainder.
        return match y {
            0 => Err(Message::error("Division by zero")),
            _ => Ok(Value::Integer(x.wrapping_rem(*y))),
        };
    }
    match (number(&a), number(&b)) {
        (Some(_), Some(0.0)) => Err(Message::error("Division by zero")),
        (Some(x), Some(y)) => Ok(Value::Number(x % y)),
        _ => Err(Message::error(format!("{} has no remainder by {}", a.kind(), b.kind()))),
    }
}

/// Divides whole numbers and drops the fraction: 7 by 2 is 3, -7 by 2 is -3.
///
/// Dividing by zero is an error.
#[component(
    "54db2568-3441-4ae2-bcef-92c4cc608e11",
    name = "Integer Division",
    nick = "A\\B",
    at = "Maths/Operators"
)]
#[output("Result", "R", "The whole quotient.")]
fn integer_division(
    /// What is divided.
    #[port("A", "A")]
    a: i32,
    /// What it is divided by; not zero.
    #[port("B", "B")]
    b: i32,
) -> Result<i32, Message> {
    if b == 0 {
        return Err(Message::error("Division by zero"));
    }
    a.checked_div(b)
        .ok_or_else(|| Message::error(format!("{a} by {b} does not fit a whole number of 32 bits")))
}

/// The product of all whole numbers from 1 to N; 1 for 0.
///
/// From 13 on the result is a number with a fraction part, and above 170 too large for one.
#[component(
    "a0a38131-c5fc-4984-b05d-34cf57f0c018",
    name = "Factorial",
    nick = "Fac",
    at = "Maths/Operators",
    also("80da90e3-3ea9-4cfe-b7cc-2b6019f850e3")
)]
#[output("Factorial", "F", "The factorial.")]
fn factorial(
    /// The number, 0 to 170.
    #[port("Number", "N")]
    n: i32,
) -> Result<Value, Message> {
    if !(0..=170).contains(&n) {
        return Err(Message::error(format!("{n} has no factorial that can be written: 0 to 170 have")));
    }
    match (1..=n).try_fold(1i32, i32::checked_mul) {
        Some(product) => Ok(Value::Integer(product)),
        None => Ok(Value::Number((1..=n).map(f64::from).product())),
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Complex;

    #[test]
    fn powers() {
        assert_eq!(Trial::of("Power").item(2).item(10).texts(0), ["{0}: 1024"]);
        assert_eq!(Trial::of("Power").item(2.0).item("0.5").texts(0), ["{0}: 1.414214"]);
        assert!(Trial::of("Power").item(-8.0).item(0.5).message().contains("not a real number"));
        assert!(Trial::of("Power").item(0.0).item(-1.0).message().contains("not a real number"));
        let i = Trial::of("Power").item(Complex { re: 0.0, im: 1.0 }).item(2);
        assert_eq!(i.texts(0), ["{0}: -1 + 0i"]);
    }

    #[test]
    fn remainders_have_the_sign_of_the_first() {
        assert_eq!(Trial::of("Modulus").list([7, -7]).item(3).texts(0), ["{0}: 1, -1"]);
        assert_eq!(Trial::of("Modulus").item(5.5).item(2).texts(0), ["{0}: 1.5"]);
        assert_eq!(Trial::of("Modulus").item(i32::MIN).item(-1).texts(0), ["{0}: 0"]);
        assert_eq!(Trial::of("Modulus").item(5).item(0.0).message(), "Division by zero");
        assert_eq!(Trial::of("Integer Division").list([7, -7]).item(2).texts(0), ["{0}: 3, -3"]);
        assert_eq!(Trial::of("Integer Division").item(7).item(0).message(), "Division by zero");
        assert!(Trial::of("Integer Division").item(i32::MIN).item(-1).message().contains("32 bits"));
    }

    #[test]
    fn factorials() {
        assert_eq!(Trial::of("Factorial").list([0, 1, 5, 12]).texts(0), ["{0}: 1, 1, 120, 479001600"]);
        assert_eq!(Trial::of("Factorial").item(13).texts(0), ["{0}: 6.227021e+9"]);
        assert!(Trial::of("Factorial").item(-1).message().contains("no factorial"));
    }
}
