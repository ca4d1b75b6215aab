//! Maths / Polynomials.

use katydid_component::{Message, component};
use katydid_data::Value;
use katydid_elementary::Elementary;

use super::complex;
use super::unary::{self, functions};

functions! {
    "Maths/Polynomials";

    /// x times x.
    square, "2280dde4-9fa2-4b4a-ae2f-37d554861367", "Square", "Sqr", ["0b0f1203-2ea8-4250-a45a-cca7ad2e5b76"], |x| x * x, |z| complex::multiply(z, z);

    /// x times x times x.
    cube, "7e3185eb-a38c-4949-bcf2-0e80dee3a344", "Cube", "Cube", [], |x| x * x * x, |z| complex::power(z, complex::real(3.0));

    /// The number that gives x when squared. A negative number has none, unless it comes as a complex one.
    square_root, "ad476cb7-b6d1-41c8-986b-0df243a64146", "Square Root", "Sqrt", ["5a22dc1a-907c-4e2f-b8da-0e496c4e25bb"], f64::sqrt, complex::sqrt;

    /// The number that gives x when cubed, negative for a negative x.
    cube_root, "5b0be57a-31f5-4446-a11a-ae0d348bca90", "Cube Root", "Cbrt", [], f64::cube_root,
        |z| complex::power(z, complex::real(1.0 / 3.0));

    /// One divided by x, which must not be zero.
    one_over_x, "797d922f-3a1d-46fe-9155-358b009b5997", "One Over X", "1/x", [], f64::recip, |z| complex::divide(complex::real(1.0), z);

    /// The number e to the power x.
    power_of_e, "c717f26f-e4a0-475c-8e1c-b8f77af1bc99", "Power of E", "Eº", ["5f212b16-82a0-4699-be4c-11529a9810ae", "582f96c6-ed0c-4710-9b5e-a05addba9f42"], f64::exponential, complex::exp;

    /// 10 to the power x.
    power_of_10, "2ebb82ef-1f90-4ac9-9a71-1fe0f4ef7044", "Power of 10", "10º", ["ed766861-662d-4462-90f6-29f87f8529cf"], |x| 10f64.raised_to(x),
        |z| complex::power(complex::real(10.0), z);

    /// 2 to the power x.
    power_of_2, "7a1e5fd7-b7da-4244-a261-f1da66614992", "Power of 2", "2º", ["a8bc9c24-1bce-4b92-b7ba-abced2457c22"], f64::power_of_two,
        |z| complex::power(complex::real(2.0), z);

    /// The power that makes x out of 10. Numbers of 0 and below have none.
    logarithm, "27d6f724-a701-4585-992f-3897488abf08", "Logarithm", "Log", ["bc4a27fc-cbb9-4802-bd4a-17ab33ad1826", "d0787f37-d976-48c9-a4b0-29d6c4059cf3"], f64::logarithm_10,
        |z| complex::scale(complex::ln(z), std::f64::consts::LOG10_E);

    /// The power that makes x out of the number e. Numbers of 0 and below have none.
    natural_logarithm, "23afc7aa-2d2f-4ae7-b876-bf366246b826", "Natural logarithm", "Ln", ["8b62751f-6fb4-4d03-a238-11ad6db7483e"], f64::logarithm, complex::ln;
}

/// The power that makes a number out of a base.
///
/// The number must be positive, the base positive and not 1.
#[component("7ab8d289-26a2-4dd4-b4ad-df5b477999d8", name = "Log N", nick = "LogN", at = "Maths/Polynomials")]
#[output("Result", "R", "The logarithm.")]
fn log_n(
    /// The number.
    #[port("Number", "V")]
    number: f64,
    /// The base.
    #[port("Base", "B")]
    base: f64,
) -> Result<f64, Message> {
    let result = number.logarithm() / base.logarithm();
    if result.is_finite() {
        return Ok(result);
    }
    Err(Message::error(format!("{number} has no logarithm to the base {base}")))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Complex;

    #[test]
    fn values_of_each_function() {
        for (name, x, y) in [
            ("Square", 3.0, "9"),
            ("Cube", -2.0, "-8"),
            ("Square Root", 16.0, "4"),
            ("Cube Root", -27.0, "-3"),
            ("One Over X", 4.0, "0.25"),
            ("Power of E", 1.0, "2.718282"),
            ("Power of 10", 3.0, "1000"),
            ("Power of 2", -1.0, "0.5"),
            ("Logarithm", 1000.0, "3"),
        ] {
            assert_eq!(Trial::of(name).item(x).texts(0), [format!("{{0}}: {y}")], "{name}");
        }
        assert_eq!(Trial::of_guid("23afc7aa-2d2f-4ae7-b876-bf366246b826").item(1).texts(0), ["{0}: 0"]);
        assert_eq!(Trial::of("Log N").item(8).item(2).texts(0), ["{0}: 3"]);
    }

    #[test]
    fn no_value_is_an_error_and_a_null() {
        assert_eq!(Trial::of("Square Root").item(-4.0).message(), "Square Root has no value at -4");
        assert_eq!(Trial::of("One Over X").list([0.0, 2.0]).texts(0), ["{0}: null, 0.5"]);
        assert_eq!(Trial::of("Logarithm").item(0).message(), "Logarithm has no value at 0");
        assert!(Trial::of("Log N").item(8).item(1).message().contains("base 1"));
        assert_eq!(Trial::of("Square").item("x!").message(), "The text x! is not a number");
        let root = Trial::of("Square Root").item(Complex { re: -4.0, im: 0.0 });
        assert_eq!(root.texts(0), ["{0}: 0 + 2i"]);
    }
}
