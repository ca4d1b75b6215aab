//! Triangles from some of their angles and sides.

use std::f64::consts::{FRAC_PI_2, PI};

use katydid_component::{Message, component};
use katydid_elementary::Elementary;

/// Lengths and angles that were given may differ from the result by this part of themselves.
const SAME: f64 = 1e-6;

fn impossible() -> Message {
    Message::error("There is no triangle with these angles and lengths")
}

fn too_few() -> Message {
    Message::error("Too few angles and lengths are given: there must be three in all, one a length")
}

/// Whether every given part comes out as given.
fn agrees<const N: usize>(given: [Option<f64>; N], result: [f64; N]) -> bool {
    given.iter().zip(result).all(|(g, r)| g.is_none_or(|g| (g - r).abs() <= SAME * g.abs().max(r.abs())))
}

/// Finds the missing angles and lengths of a triangle with a right angle from two of them, one a length.
///
/// P is opposite α, Q opposite β, and R opposite the right angle. Parts that contradict each other are an error.
#[component(
    "e75d4624-8ee2-4067-ac8d-c56bdc901d83",
    name = "Right Trigonometry",
    nick = "RTrig",
    at = "Maths/Trig"
)]
#[output("Alpha", "α", "The angle opposite P, in radians.")]
#[output("Beta", "β", "The angle opposite Q, in radians.")]
#[output("P length", "P", "The length of P.")]
#[output("Q length", "Q", "The length of Q.")]
#[output("R length", "R", "The length of R, the longest side.")]
fn right_trigonometry(
    /// The angle opposite P, in radians.
    #[port("Alpha", "α")]
    alpha: Option<f64>,
    /// The angle opposite Q, in radians.
    #[port("Beta", "β")]
    beta: Option<f64>,
    /// The length of P.
    #[port("P length", "P")]
    p: Option<f64>,
    /// The length of Q.
    #[port("Q length", "Q")]
    q: Option<f64>,
    /// The length of R.
    #[port("R length", "R")]
    r: Option<f64>,
) -> Result<(f64, f64, f64, f64, f64), Message> {
    let other_leg = |leg: f64, r: f64| ((r - leg) * (r + leg)).sqrt();
    let angle = alpha.or(beta.map(|beta| FRAC_PI_2 - beta));
    let (p1, q1) = match (p, q, r, angle) {
        (Some(p), Some(q), _, _) => (p, q),
        (Some(p), None, Some(r), _) => (p, other_leg(p, r)),
        (None, Some(q), Some(r), _) => (other_leg(q, r), q),
        (Some(p), None, None, Some(a)) => (p, p / a.tangent()),
        (None, Some(q), None, Some(a)) => (q * a.tangent(), q),
        (None, None, Some(r), Some(a)) => (r * a.sine(), r * a.cosine()),
        _ => return Err(Message::error("Two parts must be given, one a length")),
    };
    if !(p1 > 0.0 && q1 > 0.0 && p1.is_finite() && q1.is_finite()) {
        return Err(impossible());
    }
    let a = p1.arctangent_of(q1);
    let result = [a, FRAC_PI_2 - a, p1, q1, p1.hypotenuse(q1)];
    if !agrees([alpha, beta, p, q, r], result) {
        return Err(impossible());
    }
    let [alpha, beta, p, q, r] = result;
    Ok((alpha, beta, p, q, r))
}

/// The angle opposite `a` by the law of cosines.
fn angle(a: f64, b: f64, c: f64) -> f64 {
    ((b * b + c * c - a * a) / (2.0 * b * c)).clamp(-1.0, 1.0).arccosine()
}

/// The three sides from what is known; side k is opposite angle k.
fn sides(mut angles: [Option<f64>; 3], sides: [Option<f64>; 3]) -> Result<[f64; 3], Message> {
    match angles {
        [Some(a), Some(b), None] => angles[2] = Some(PI - a - b),
        [Some(a), None, Some(c)] => angles[1] = Some(PI - a - c),
        [None, Some(b), Some(c)] => angles[0] = Some(PI - b - c),
        _ => {}
    }
    // Seen from each corner in turn, so that every case has to be written once.
    for k in 0..3 {
        let turn = |x: &[Option<f64>; 3]| {
            let at = |i: usize| x.get((k + i) % 3).copied().flatten();
            [at(0), at(1), at(2)]
        };
        let back = |x: [f64; 3]| {
            let at = |i: usize| x.get((i + 3 - k) % 3).copied().unwrap_or(f64::NAN);
            [at(0), at(1), at(2)]
        };
        let found = match (turn(&sides), turn(&angles)) {
            ([Some(a), Some(b), Some(c)], _) => [a, b, c],
            ([Some(a), _, _], [Some(x), Some(y), Some(z)]) => {
                [a, a * y.sine() / x.sine(), a * z.sine() / x.sine()]
            }
            // Two sides and the angle between them.
            ([None, Some(b), Some(c)], [Some(x), _, _]) => {
                [(b * b + c * c - 2.0 * b * c * x.cosine()).max(0.0).sqrt(), b, c]
            }
            // Two sides and an angle opposite one of them: of two triangles the one with the acute angle.
            ([Some(a), Some(b), None], [Some(x), None, None]) => {
                let y = (b * x.sine() / a).arcsine();
                [a, b, a * (PI - x - y).sine() / x.sine()]
            }
            ([Some(a), None, Some(c)], [Some(x), None, None]) => {
                let z = (c * x.sine() / a).arcsine();
                [a, a * (PI - x - z).sine() / x.sine(), c]
            }
            _ => continue,
        };
        return Ok(back(found));
    }
    Err(too_few())
}

/// Finds the missing angles and lengths of a triangle from three of them, one a length.
///
/// Side A is opposite α, B opposite β and C opposite γ. Of two possible triangles the one with the acute angle
/// is given. Parts that contradict each other are an error.
#[component(
    "92af1a02-9b87-43a0-8c45-0ce1b81555ec",
    name = "Triangle Trigonometry",
    nick = "Trig",
    at = "Maths/Trig"
)]
#[output("Alpha", "α", "The angle opposite A, in radians.")]
#[output("Beta", "β", "The angle opposite B, in radians.")]
#[output("Gamma", "γ", "The angle opposite C, in radians.")]
#[output("A length", "A", "The length of A.")]
#[output("B length", "B", "The length of B.")]
#[output("C length", "C", "The length of C.")]
fn triangle_trigonometry(
    /// The angle opposite A, in radians.
    #[port("Alpha", "α")]
    alpha: Option<f64>,
    /// The angle opposite B, in radians.
    #[port("Beta", "β")]
    beta: Option<f64>,
    /// The angle opposite C, in radians.
    #[port("Gamma", "γ")]
    gamma: Option<f64>,
    /// The length of A.
    #[port("A length", "A")]
    a: Option<f64>,
    /// The length of B.
    #[port("B length", "B")]
    b: Option<f64>,
    /// The length of C.
    #[port("C length", "C")]
    c: Option<f64>,
) -> Result<(f64, f64, f64, f64, f64, f64), Message> {
    let [x, y, z] = sides([alpha, beta, gamma], [a, b, c])?;
    let sound = |x: f64, y: f64, z: f64| x > 0.0 && x.is_finite() && x < y + z;
    if !(sound(x, y, z) && sound(y, z, x) && sound(z, x, y)) {
        return Err(impossible());
    }
    let result = [angle(x, y, z), angle(y, z, x), angle(z, x, y), x, y, z];
    if !agrees([alpha, beta, gamma, a, b, c], result) {
        return Err(impossible());
    }
    let [alpha, beta, gamma, a, b, c] = result;
    Ok((alpha, beta, gamma, a, b, c))
}

#[cfg(test)]
mod tests {
    use super::*;
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Tree;

    fn solve<const N: usize>(name: &str, parts: [Option<f64>; N]) -> String {
        let mut trial = Trial::of(name);
        for part in parts {
            trial = match part {
                Some(x) => trial.item(x),
                None => trial.tree(Tree::empty()),
            };
        }
        let out = trial.run();
        if let Some(message) = out.messages.first() {
            return message.text.clone();
        }
        out.outputs.iter().map(|tree| texts(tree).concat().replace("{0}: ", "")).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn right_triangles() {
        let all = "0.643501 0.927295 3 4 5";
        let right = |parts| solve("Right Trigonometry", parts);
        assert_eq!(right([None, None, Some(3.0), Some(4.0), None]), all);
        assert_eq!(right([None, None, Some(3.0), None, Some(5.0)]), all);
        assert_eq!(right([None, None, None, Some(4.0), Some(5.0)]), all);
        let alpha = 0.75f64.atan();
        assert_eq!(right([Some(alpha), None, None, None, Some(5.0)]), all);
        assert_eq!(right([None, Some(FRAC_PI_2 - alpha), None, Some(4.0), None]), all);
        assert_eq!(right([Some(alpha), None, None, None, None]), "Two parts must be given, one a length");
        assert_eq!(right([None, None, Some(3.0), Some(4.0), Some(6.0)]), impossible().text);
        assert_eq!(right([None, None, Some(6.0), None, Some(5.0)]), impossible().text);
    }

    #[test]
    fn triangles_from_any_three_parts() {
        let (a, b, c) = (7.0, 8.0, 9.0);
        let parts = [angle(a, b, c), angle(b, c, a), angle(c, a, b), a, b, c];
        let all = solve("Triangle Trigonometry", [None, None, None, Some(a), Some(b), Some(c)]);
        for mask in 0..64u32 {
            let given: [Option<f64>; 6] = std::array::from_fn(|k| (mask >> k & 1 == 1).then(|| parts[k]));
            let result = solve("Triangle Trigonometry", given);
            if mask.count_ones() >= 3 && mask >> 3 != 0 {
                assert_eq!(result, all, "{given:?}");
            } else {
                assert_eq!(result, too_few().text, "{given:?}");
            }
        }
        let flat = solve("Triangle Trigonometry", [None, None, None, Some(1.0), Some(2.0), Some(4.0)]);
        assert_eq!(flat, impossible().text);
    }
}
