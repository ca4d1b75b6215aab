//! Maths / Util: constants, rounding, extremes, complex numbers.

use std::cmp::Ordering;

use katydid_component::{Message, component};
use katydid_data::{Complex, Tree, Value};

use super::{comparison, complex};

/// A multiple of π, the ratio of a circle's circumference to its diameter.
#[component("0d2ccfb3-9d41-4759-9452-da6a522c3eaa", name = "Pi", nick = "Pi", at = "Maths/Util")]
#[output("Output", "y", "N times π.")]
fn pi(
    /// How many times.
    #[port("Factor", "N", default = 1.0)]
    factor: f64,
) -> f64 {
    factor * std::f64::consts::PI
}

/// A multiple of the golden ratio, 1.618….
#[component("cb22d3ed-93d8-4629-bdf2-c0c7c25afd2c", name = "Golden Ratio", nick = "Phi", at = "Maths/Util")]
#[output("Output", "y", "N times the golden ratio.")]
fn golden_ratio(
    /// How many times.
    #[port("Factor", "N", default = 1.0)]
    factor: f64,
) -> f64 {
    factor * 0.5 * (1.0 + 5f64.sqrt())
}

/// A multiple of e, the base of the natural logarithm, 2.718….
#[component(
    "b6cac37c-21b9-46c6-bd0d-17ff67796578",
    name = "Natural logarithm",
    nick = "E",
    at = "Maths/Util"
)]
#[output("Output", "y", "N times e.")]
fn e(
    /// How many times.
    #[port("Factor", "N", default = 1.0)]
    factor: f64,
) -> f64 {
    factor * std::f64::consts::E
}

/// A multiple of the smallest positive number there is among numbers of 64 bits.
#[component("deadf87d-99a6-4980-90c3-f98350aa6f0f", name = "Epsilon", nick = "Eps", at = "Maths/Util")]
#[output("Output", "y", "N times the smallest number.")]
fn epsilon(
    /// How many times.
    #[port("Factor", "N", default = 1.0)]
    factor: f64,
) -> f64 {
    factor * f64::from_bits(1)
}

/// Rounds a number to whole ones: to the nearest, halves to the even one, downwards and upwards.
///
/// Numbers that do not fit 32 bits are an error.
#[component("a50c4a3b-0177-4c91-8556-db95de6c56c8", name = "Round", nick = "Round", at = "Maths/Util")]
#[output("Nearest", "N", "The nearest whole number.")]
#[output("Floor", "F", "The whole number at or below.")]
#[output("Ceiling", "C", "The whole number at or above.")]
fn round(
    /// The number.
    #[port("Number", "x")]
    x: f64,
) -> Result<(i32, i32, i32), Message> {
    let whole = |r: f64| {
        let fits = (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&r);
        fits.then_some(r as i32)
            .ok_or_else(|| Message::error(format!("{x} does not fit a whole number of 32 bits")))
    };
    Ok((whole(x.round_ties_even())?, whole(x.floor())?, whole(x.ceil())?))
}

/// The smaller of two values: numbers by size, texts by the alphabet, points by x, then y, then z.
#[component(
    "57308b30-772d-4919-ac67-e86c18f3a996",
    name = "Minimum",
    nick = "Min",
    at = "Maths/Util",
    also("532b722d-9368-42ee-b99d-64a4732ee99a")
)]
#[output("Result", "R", "The smaller one; A when they are equal.")]
fn minimum(
    /// A value.
    #[port("A", "A")]
    a: Value,
    /// Another value.
    #[port("B", "B")]
    b: Value,
) -> Result<Value, Message> {
    if let (Value::Number(x), Value::Number(y)) = (&a, &b) {
        return Ok(Value::Number(x.min(*y)));
    }
    Ok(if comparison::values(&a, &b)? == Ordering::Greater { b } else { a })
}

/// The larger of two values: numbers by size, texts by the alphabet, points by x, then y, then z.
#[component(
    "0d1e2027-f153-460d-84c0-f9af431b08cb",
    name = "Maximum",
    nick = "Max",
    at = "Maths/Util",
    also("e9b807a3-dd48-4c2c-bada-e4f8e0edbbdb")
)]
#[output("Result", "R", "The larger one; A when they are equal.")]
fn maximum(
    /// A value.
    #[port("A", "A")]
    a: Value,
    /// Another value.
    #[port("B", "B")]
    b: Value,
) -> Result<Value, Message> {
    if let (Value::Number(x), Value::Number(y)) = (&a, &b) {
        return Ok(Value::Number(x.max(*y)));
    }
    Ok(if comparison::values(&a, &b)? == Ordering::Less { b } else { a })
}

/// Two values in order: numbers by size, texts by the alphabet, points by x, then y, then z.
#[component("37084b3f-2b66-4f3a-9737-80d0b0b7f0cb", name = "Extremes", nick = "Extrz", at = "Maths/Util")]
#[output("Mininum", "V-", "The smaller one.")]
#[output("Maximum", "V+", "The larger one.")]
fn extremes(
    /// A value.
    #[port("A", "A")]
    a: Value,
    /// Another value.
    #[port("B", "B")]
    b: Value,
) -> Result<(Value, Value), Message> {
    Ok(if comparison::values(&a, &b)? == Ordering::Greater { (b, a) } else { (a, b) })
}

/// Makes a complex number of its real and imaginary parts.
#[component(
    "63d12974-2915-4ccf-ac26-5d566c3bac92",
    name = "Create Complex",
    nick = "Complex",
    at = "Maths/Util"
)]
#[output("Complex", "C", "The complex number.")]
fn create_complex(
    /// The real part.
    #[port("Real", "R", default = 0.0)]
    re: f64,
    /// The imaginary part.
    #[port("Imaginary", "i", default = 0.0)]
    im: f64,
) -> Complex {
    Complex { re, im }
}

/// The real and imaginary parts of a complex number.
#[component(
    "1f384257-b26b-4160-a6d3-1dcd89b64acd",
    name = "Complex Components",
    nick = "Complex",
    at = "Maths/Util"
)]
#[output("Real", "R", "The real part.")]
#[output("Imaginary", "i", "The imaginary part.")]
fn complex_components(
    /// The complex number.
    #[port("Complex", "C")]
    z: Complex,
) -> (f64, f64) {
    (z.re, z.im)
}

/// The size of a complex number: its distance from 0.
#[component(
    "88fb33f9-f467-452b-a0e3-44bdb78a9b06",
    name = "Complex Modulus",
    nick = "CMod",
    at = "Maths/Util"
)]
#[output("Modulus", "M", "The size.")]
fn complex_modulus(
    /// The complex number.
    #[port("Complex", "C")]
    z: Complex,
) -> f64 {
    complex::modulus(z)
}

/// The angle of a complex number from the positive real axis.
#[component(
    "be715e4c-d6d8-447b-a9c3-6fea700d0b83",
    name = "Complex Argument",
    nick = "Arg",
    at = "Maths/Util"
)]
#[output("Argument", "A", "The angle in radians, -π to π.")]
fn complex_argument(
    /// The complex number.
    #[port("Complex", "C")]
    z: Complex,
) -> f64 {
    complex::argument(z)
}

/// A complex number with the opposite imaginary part.
#[component(
    "7d2a6064-51f0-45b2-adc4-f417b30dcd15",
    name = "Complex Conjugate",
    nick = "z*",
    at = "Maths/Util"
)]
#[output("Conjugate", "C", "The conjugate.")]
fn complex_conjugate(
    /// The complex number.
    #[port("Complex", "C")]
    z: Complex,
) -> Complex {
    Complex { im: -z.im, ..z }
}

/// Evens out how numbers change over time. A single solution has only the numbers of the moment: they are
/// handed on.
#[component(
    "5b424e1c-d061-43cd-8c20-db84564b0502",
    name = "Smooth Numbers",
    nick = "Smooth",
    at = "Maths/Util"
)]
#[output("Numbers", "N", "The numbers.", kind = Number)]
fn smooth_numbers(
    /// The numbers.
    #[port("Numbers", "N", kind = Number)]
    numbers: &Tree,
) -> Tree {
    numbers.clone()
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Complex;
    use katydid_geometry::Point3;

    #[test]
    fn constants() {
        assert_eq!(Trial::of("Pi").list([1.0, 0.5]).texts(0), ["{0}: 3.141593, 1.570796"]);
        assert_eq!(Trial::of("Golden Ratio").item(1).texts(0), ["{0}: 1.618034"]);
        assert_eq!(
            Trial::of_guid("b6cac37c-21b9-46c6-bd0d-17ff67796578").item(2).texts(0),
            ["{0}: 5.436564"]
        );
        assert_eq!(Trial::of("Epsilon").item(0).texts(0), ["{0}: 0"]);
    }

    #[test]
    fn rounding_goes_to_even_numbers() {
        let numbers = || Trial::of("Round").list([2.5, 3.5, -1.2, -0.5]);
        assert_eq!(numbers().texts(0), ["{0}: 2, 4, -1, 0"]);
        assert_eq!(numbers().texts(1), ["{0}: 2, 3, -2, -1"]);
        assert_eq!(numbers().texts(2), ["{0}: 3, 4, -1, 0"]);
        assert_eq!(
            Trial::of("Round").item(1e12).message(),
            "1000000000000 does not fit a whole number of 32 bits"
        );
    }

    #[test]
    fn extremes_of_any_type() {
        assert_eq!(Trial::of("Minimum").item(3).item(2.5).texts(0), ["{0}: 2.5"]);
        assert_eq!(Trial::of("Maximum").item("10").item("9").texts(0), ["{0}: 10"]);
        assert_eq!(Trial::of("Minimum").item("Beta").item("alpha").texts(0), ["{0}: alpha"]);
        let (p, q) = (Point3::new(1.0, 5.0, 0.0), Point3::new(1.0, 4.0, 9.0));
        // Curves have a component of that name too.
        let both = || Trial::of_guid("37084b3f-2b66-4f3a-9737-80d0b0b7f0cb").item(p).item(q);
        assert_eq!(both().texts(0), ["{0}: {1, 4, 9}"]);
        assert_eq!(both().texts(1), ["{0}: {1, 5, 0}"]);
        assert_eq!(Trial::of("Maximum").item(p).item(1).message(), "Point and Integer cannot be compared");
    }

    #[test]
    fn complex_numbers() {
        let z = Complex { re: -3.0, im: 4.0 };
        assert_eq!(Trial::of("Create Complex").item(-3).item(4).texts(0), ["{0}: -3 + 4i"]);
        assert_eq!(Trial::of("Complex Components").item(z).texts(1), ["{0}: 4"]);
        assert_eq!(Trial::of("Complex Modulus").item(z).texts(0), ["{0}: 5"]);
        assert_eq!(Trial::of("Complex Argument").item(-1).texts(0), ["{0}: 3.141593"]);
        assert_eq!(Trial::of("Complex Conjugate").item(z).texts(0), ["{0}: -3 - 4i"]);
        assert_eq!(Trial::of("Smooth Numbers").list([1, 2]).texts(0), ["{0}: 1, 2"]);
    }
}
