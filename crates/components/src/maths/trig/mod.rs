//! Maths / Trig.

mod centres;
mod triangles;

use katydid_component::{Message, component};
use katydid_data::{Complex, Value};
use katydid_elementary::Elementary;
use katydid_expression::circular;

use super::complex::{self, divide, real};
use super::unary::{self, functions};

fn one_over(f: fn(Complex) -> Complex, z: Complex) -> Complex {
    divide(real(1.0), f(z))
}

functions! {
    "Maths/Trig";

    /// The sine of an angle in radians.
    sine, "7663efbb-d9b8-4c6a-a0da-c3750a7bbe77", "Sine", "Sin", ["c53932eb-7c8c-4825-ae98-e36bba97232d", "ecee923b-1b93-4cf2-acd6-680835503437"], circular::sin, complex::sin, circular::sines;

    /// The cosine of an angle in radians.
    cosine, "d2d2a900-780c-4d58-9a35-1f9d8d35df6f", "Cosine", "Cos", ["7874f26c-6f76-4da8-b527-2d567184b2bd", "12278a4b-c131-4735-a3ee-bcb783083856"], circular::cos, complex::cos, circular::cosines;

    /// The tangent of an angle in radians: its sine over its cosine.
    tangent, "0f31784f-7177-4104-8500-1f4f4a306df4", "Tangent", "Tan", ["0bc93049-e1a7-44b5-8068-c7ddc85a9f46", "002b2feb-5d1b-41ea-913f-9f203c615792"], f64::tangent, complex::tan;

    /// One over the cosine of an angle in radians.
    secant, "60103def-1bb7-4700-b294-3a89100525c4", "Secant", "Sec", ["d879e74c-6fe3-4cbf-b3fa-60a7c48b73e7"], |x| circular::cos(x).recip(), |z| one_over(complex::cos, z);

    /// One over the sine of an angle in radians, which must not be 0.
    cosecant, "d222500b-dfd5-45e0-933e-eabefd07cbfa", "CoSecant", "Csc", ["99197a17-d5c7-419b-acde-eca2737f3c58"], |x| circular::sin(x).recip(), |z| one_over(complex::sin, z);

    /// One over the tangent of an angle in radians, which must not be 0.
    cotangent, "1f602c33-f38e-4f47-898b-359f0a4de3c2", "CoTangent", "Cot", ["39461433-ac44-4298-94a9-988f983e347c"], |x| circular::cos(x) / circular::sin(x),
        |z| divide(complex::cos(z), complex::sin(z));

    /// The sine of x over x, and 1 for 0.
    sinc, "a2d9503d-a83c-4d71-81e0-02af8d09cd0c", "Sinc", "Sinc", ["da4be42b-ba75-4249-a685-69ce78b6ee44"], |x| if x == 0.0 { 1.0 } else { circular::sin(x) / x },
        |z| if z == real(0.0) { real(1.0) } else { divide(complex::sin(z), z) };

    /// The angle in radians, -π/2 to π/2, whose sine is x. A real x lies between -1 and 1.
    arcsine, "cc15ba56-fae7-4f05-b599-cb7c43b60e11", "ArcSine", "ASin", ["f18091e9-3264-4dd4-9ba6-32c77fca0ac0", "22bba82d-32e8-448c-a59c-f054c8843ee3"], f64::arcsine, complex::asin;

    /// The angle in radians, 0 to π, whose cosine is x. A real x lies between -1 and 1.
    arccosine, "49584390-d541-41f7-b5f6-1f9515ac0f73", "ArcCosine", "ACos", ["8640c519-9bf6-4e9a-a108-75f9d89b2c58", "cfc280bb-332a-4828-bb4e-aca6d88859aa"], f64::arccosine, complex::acos;

    /// The angle in radians, -π/2 to π/2, whose tangent is x.
    arctangent, "b4647919-d041-419e-99f5-fa0dc0ddb8b6", "ArcTangent", "ATan", ["4e8aad42-9111-470c-9acd-7ae365d8bba4", "7b312903-4782-438f-aa37-ba43f5083460"], f64::arctangent, complex::atan;
}

/// Turns an angle in degrees into radians.
#[component("a4cd2751-414d-42ec-8916-476ebf62d7fe", name = "Radians", nick = "Rad", at = "Maths/Trig")]
#[output("Radians", "R", "The angle in radians.")]
fn radians(
    /// The angle in degrees.
    #[port("Degrees", "D")]
    degrees: f64,
) -> f64 {
    degrees * std::f64::consts::PI / 180.0
}

/// Turns an angle in radians into degrees.
#[component("0d77c51e-584f-44e8-aed2-c2ddf4803888", name = "Degrees", nick = "Deg", at = "Maths/Trig")]
#[output("Degrees", "D", "The angle in degrees.")]
fn degrees(
    /// The angle in radians.
    #[port("Radians", "R")]
    radians: f64,
) -> f64 {
    radians * 180.0 / std::f64::consts::PI
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_6, PI};

    use katydid_component::testing::Trial;
    use katydid_data::Complex;

    #[test]
    fn values_of_each_function() {
        for (name, x, y) in [
            ("Sine", FRAC_PI_6, "0.5"),
            ("Cosine", FRAC_PI_3, "0.5"),
            ("Tangent", 0.0, "0"),
            ("Secant", 0.0, "1"),
            ("CoSecant", FRAC_PI_2, "1"),
            ("CoTangent", FRAC_PI_2 / 2.0, "1"),
            ("Sinc", FRAC_PI_2, "0.63662"),
            ("Sinc", 0.0, "1"),
            ("ArcSine", 1.0, "1.570796"),
            ("ArcCosine", -1.0, "3.141593"),
            ("ArcTangent", 1.0, "0.785398"),
            ("Radians", 180.0, "3.141593"),
            ("Degrees", PI, "180"),
        ] {
            assert_eq!(Trial::of(name).item(x).texts(0), [format!("{{0}}: {y}")], "{name}");
        }
    }

    #[test]
    fn beyond_the_real_numbers() {
        assert_eq!(Trial::of("ArcSine").item(2).message(), "ArcSine has no value at 2");
        assert_eq!(Trial::of("CoSecant").list([0.0, 1e9]).message(), "CoSecant has no value at 0");
        let i = Complex { re: 0.0, im: 1.0 };
        assert_eq!(Trial::of("Sine").item(i).texts(0), ["{0}: 0 + 1.175201i"]);
        assert_eq!(Trial::of("Cosine").item("0").texts(0), ["{0}: 1"]);
    }
}
