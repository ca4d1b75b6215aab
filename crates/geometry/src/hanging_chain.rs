//! Chains of stiff links.

use katydid_elementary::Elementary;

use crate::{Error, Point3, Result, Vector3};

/// A chain that is longer than its chord by no more than this part of it is taut.
const TAUT: f64 = 1e-9;
/// The width of a chain that hangs straight down, as a part of its length.
const LEAST_WIDTH: f64 = 1e-9;
/// Forces are no less than this: directions of what is 0 stay numbers.
const LEAST_FORCE: f64 = 1e-100;
/// A chain reaches its end when it misses it by no more than this part of its length.
const CLOSES: f64 = 1e-6;

/// The joints of a chain of stiff links that hangs between two points, both ends among them.
///
/// Every link has its own length and weight (the weight of the whole link, in any unit; only ratios count), which
/// acts at its middle. The joints move without friction.
///
/// Link i stands along (H, V + what hangs before its middle): the force in it at its middle. The two unknown forces at
/// the start minimise the convex function Σ lengthᵢ·forceᵢ − H·width − V·rise, whose gradient is the gap that is left
/// at the end (derived). Slopes of convex functions grow, so that each force is found by bisection.
///
/// # Errors
/// No link or more than 10,000, numbers of lengths and weights that differ, a length that is not above 0, a negative weight or none above
/// 0, links that together do not reach the end, a link longer than the room at the bottom between two steep sides, gravity without direction, or a number that is not finite.
pub fn hanging_chain(
    a: Point3,
    b: Point3,
    lengths: &[f64],
    weights: &[f64],
    gravity: Vector3,
) -> Result<Vec<Point3>> {
    if !(a.is_finite() && b.is_finite()) {
        return Err(Error::NotFinite("end of a chain"));
    }
    if lengths.len() > 10_000 {
        return Err(Error::OutOfRange {
            what: "number of links",
            value: lengths.len() as f64,
            must: "at most 10,000",
        });
    }
    if lengths.is_empty() || lengths.len() != weights.len() {
        return Err(Error::Invalid {
            what: "chain",
            why: format!("{} lengths and {} weights: each link needs both", lengths.len(), weights.len()),
        });
    }
    for &value in lengths {
        if !(value > 0.0 && value.is_finite()) {
            return Err(Error::OutOfRange { what: "length of a link", value, must: "finite and above 0" });
        }
    }
    for &value in weights {
        if !(value >= 0.0 && value.is_finite()) {
            return Err(Error::OutOfRange { what: "weight of a link", value, must: "finite and at least 0" });
        }
    }
    let up = -gravity.unitized().ok_or(Error::degenerate("gravity", "it has no direction"))?;
    let (total, heavy): (f64, f64) = (lengths.iter().sum(), weights.iter().sum());
    if !(heavy > 0.0 && heavy.is_finite() && total.is_finite()) {
        return Err(Error::degenerate("chain", "it has no weight, or too much of it to be counted"));
    }
    let chord = b - a;
    if !(total > chord.length() * (1.0 + TAUT)) {
        let must = "greater than the distance of the ends";
        return Err(Error::OutOfRange { what: "length of a chain", value: total, must });
    }
    let rise = chord.dot(up);
    let across = chord - up * rise;
    let axis = across.unitized().or_else(|| up.perpendicular()).unwrap_or(Vector3::X);
    // Links above each other would fold in any way; a hair of width tells them which.
    let width = (across.length() / total).max(LEAST_WIDTH);
    let rise = rise / total;
    let mut hung = 0.0;
    let links: Vec<[f64; 2]> = lengths
        .iter()
        .zip(weights)
        .map(|(l, w)| {
            let w = w / heavy;
            hung += w;
            [l / total, hung - 0.5 * w]
        })
        .collect();
    // The rise of the chain grows with the upward force at its start, and its width, at the right rise, with the pull:
    // both are slopes of one convex function.
    let upward = |pull: f64| {
        let rise_at = |v: f64| links.iter().map(|[l, c]| l * (v + c) / pull.hypotenuse(v + c)).sum::<f64>();
        let reach = 1.0 + pull * 1e6;
        bisect(-reach, reach, |v| rise_at(v) < rise)
    };
    let width_at = |pull: f64| {
        let v = upward(pull);
        links.iter().map(|[l, c]| l * pull / pull.hypotenuse(v + c)).sum::<f64>()
    };
    let pull = bisect(-35.0, 20.0, |x| width_at(x.exponential()) < width).exponential();
    let x = [pull, upward(pull)];
    let mut joints = Vec::with_capacity(links.len() + 1);
    let mut here = a;
    joints.push(here);
    for ([_, c], length) in links.iter().zip(lengths) {
        let s = x[1] + c;
        let force = x[0].hypotenuse(s).max(LEAST_FORCE);
        here += (axis * (x[0] / force) + up * (s / force)) * *length;
        joints.push(here);
    }
    let gap = b - here;
    if !(gap.length() <= CLOSES * total) {
        // A link at the bottom would have to push the two sides apart, which no pull can.
        return Err(Error::degenerate(
            "chain",
            "its ends are too nearly above each other for so long a link",
        ));
    }
    // What rounding left open is shared out.
    let n = links.len() as f64;
    for (i, joint) in joints.iter_mut().enumerate() {
        *joint += gap * (i as f64 / n);
    }
    if let Some(last) = joints.last_mut() {
        *last = b;
    }
    Ok(joints)
}

/// Where a condition that holds at `low` and not at `high` ends.
fn bisect(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..90 {
        let middle = 0.5 * (low + high);
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::hanging_chain;
    use crate::{Point3, Vector3};

    const DOWN: Vector3 = Vector3::new(0.0, 0.0, -1.0);

    fn p(x: f64, z: f64) -> Point3 {
        Point3::new(x, 0.0, z)
    }

    #[test]
    fn two_and_three_links() {
        let two = hanging_chain(p(0.0, 0.0), p(6.0, 0.0), &[5.0, 5.0], &[1.0, 1.0], DOWN).unwrap();
        assert!(two[1].distance_to(p(3.0, -4.0)) < 1e-9, "{two:?}");
        // Any weights hold two links in the same triangle.
        let uneven = hanging_chain(p(0.0, 0.0), p(6.0, 0.0), &[5.0, 5.0], &[9.0, 1.0], DOWN).unwrap();
        assert!(uneven[1].distance_to(p(3.0, -4.0)) < 1e-9);
        // The middle link of three is level.
        let three =
            hanging_chain(p(0.0, 0.0), p(8.0, 0.0), &[5.0, 2.0, 5.0], &[1.0, 7.0, 1.0], DOWN).unwrap();
        assert!(three[1].distance_to(p(3.0, -4.0)) < 1e-9 && three[2].distance_to(p(5.0, -4.0)) < 1e-9);
    }

    #[test]
    fn many_links_hang_like_a_rope() {
        let n = 400;
        let length = 4.0 * 1f64.sinh();
        let chain =
            hanging_chain(p(-2.0, 0.0), p(2.0, 0.0), &vec![length / n as f64; n], &vec![0.3; n], DOWN);
        for q in chain.unwrap() {
            let z = 2.0 * ((q.x / 2.0).cosh() - 1f64.cosh());
            assert!((q.z - z).abs() < 1e-4, "{q:?} {z}");
        }
    }

    #[test]
    fn links_keep_their_lengths() {
        let lengths = [1.0, 4.0, 0.5, 3.0, 2.0];
        for b in [[3.0, 4.0, 5.0], [9.0, 0.0, -3.0], [5.0, 0.0, 0.0], [-2.0, 3.0, 1.0]] {
            let b = Point3::from(b);
            let chain = hanging_chain(Point3::ORIGIN, b, &lengths, &[5.0, 0.0, 1.0, 2.0, 1.0], DOWN).unwrap();
            assert_eq!(chain.last(), Some(&b));
            for (w, l) in chain.windows(2).zip(lengths) {
                assert!((w[0].distance_to(w[1]) - l).abs() < 1e-5, "{b:?} {chain:?}");
            }
        }
        assert!(hanging_chain(Point3::ORIGIN, p(1e-4, 2.0), &lengths, &[1.0; 5], DOWN).is_err());
        assert!(hanging_chain(Point3::ORIGIN, p(3.0, 0.0), &[1.0, 1.0], &[1.0, 1.0], DOWN).is_err());
        assert!(hanging_chain(Point3::ORIGIN, p(3.0, 0.0), &[9.0], &[1.0, 1.0], DOWN).is_err());
        assert!(hanging_chain(Point3::ORIGIN, p(3.0, 0.0), &[2.0, 2.0], &[0.0, 0.0], DOWN).is_err());
    }
}
