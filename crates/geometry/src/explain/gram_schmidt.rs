//! Gram and Schmidt's method.

use super::thresholds::SMALLEST_REST;
use super::{Algorithm, Explanation, Number, Quantity, Round, Step};
use crate::{Error, Result, Vector3};

fn dot(a: &[Number], b: &[Number]) -> Number {
    a.iter().zip(b).fold(Number::given(0.0), |sum, (a, b)| sum.plus(a.times(*b)))
}

/// Perpendicular vectors of length 1 from up to three vectors: each loses its shares along those before it, and is divided
/// by what length is left. A round for each vector.
///
/// # Errors
/// A vector is not finite, or depends on those before it.
///
/// Source: Golub and Van Loan, *Matrix Computations*, section 5.2.7.
pub fn gram_schmidt(vectors: &[Vector3]) -> Result<Explanation> {
    if vectors.len() > 3 {
        let why = "in space no more than three are independent".to_owned();
        return Err(Error::Invalid { what: "vectors", why });
    }
    let mut given = Vec::new();
    let mut rounds = Vec::new();
    let mut units: Vec<Quantity> = Vec::new();
    for (i, v) in vectors.iter().enumerate() {
        let i = i + 1;
        if !v.is_finite() {
            return Err(Error::NotFinite("a vector"));
        }
        let own = Quantity::given(format!("v{i}"), &[v.x, v.y, v.z]);
        let mut steps = Vec::new();
        let mut rest = own.clone();
        if !units.is_empty() {
            let one = Number::given(1.0);
            let mut terms = vec![(one, own.name.clone())];
            for unit in &units {
                let share = dot(&own.numbers, &unit.numbers);
                let rule = format!("{}·{}", own.name, unit.name);
                let made = Quantity::new(format!("share of {}", unit.name), vec![share]);
                steps.push(Step { made, rule, terms: Vec::new() });
                let minus = Number::given(0.0).minus(share);
                terms.push((minus, unit.name.clone()));
                let pairs = rest.numbers.iter().zip(&unit.numbers);
                rest.numbers = pairs.map(|(r, e)| r.plus(minus.times(*e))).collect();
            }
            rest.name = format!("w{i}");
            steps.push(Step { made: rest.clone(), rule: String::new(), terms });
        }
        let length = dot(&rest.numbers, &rest.numbers).root();
        if !(length.value > SMALLEST_REST * v.length()) {
            return Err(Error::Degenerate { what: "a vector", why: "it depends on those before it" });
        }
        let made = Quantity::new(format!("|{}|", rest.name), vec![length]);
        steps.push(Step { made, rule: String::new(), terms: Vec::new() });
        let unit = rest.numbers.iter().map(|x| x.over(length)).collect();
        let unit = Quantity::new(format!("e{i}"), unit);
        let rule = format!("{0} / |{0}|", rest.name);
        steps.push(Step { made: unit.clone(), rule, terms: Vec::new() });
        given.push(own);
        rounds.push(Round { steps });
        units.push(unit);
    }
    Ok(Explanation { algorithm: Algorithm::GramSchmidt, given, rounds, result: units })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_stay_exact() {
        let told = gram_schmidt(&[Vector3::new(3.0, 4.0, 0.0), Vector3::new(0.0, 5.0, 0.0)]).unwrap();
        let texts: Vec<String> = told.result.iter().map(ToString::to_string).collect();
        assert_eq!(texts, ["e1 = (3/5, 4/5, 0)", "e2 = (-4/5, 3/5, 0)"]);
        assert!(gram_schmidt(&[Vector3::X, Vector3::X]).is_err());
        assert!(gram_schmidt(&[Vector3::ZERO]).is_err());
        assert!(gram_schmidt(&[Vector3::new(f64::NAN, 0.0, 0.0)]).is_err());
    }

    proptest::proptest! {
        #[test]
        fn what_comes_out_is_perpendicular(c in proptest::array::uniform9(-10.0_f64..10.0)) {
            let v = [0, 3, 6].map(|i| Vector3::new(c[i], c[i + 1], c[i + 2]));
            let volume = v[0].cross(v[1]).dot(v[2]).abs();
            proptest::prop_assume!(volume > 1.0);
            let told = gram_schmidt(&v).unwrap();
            for (i, a) in told.result.iter().enumerate() {
                for (j, b) in told.result.iter().enumerate() {
                    let expected = f64::from(u8::from(i == j));
                    proptest::prop_assert!((dot(&a.numbers, &b.numbers).value - expected).abs() < 1e-9);
                }
            }
        }
    }
}
