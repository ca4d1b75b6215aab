//! Knot vectors in the openNURBS form: control points + degree − 1 knots, no superfluous end knots.

use crate::{Error, Result};

/// The highest degree that the kernel takes. Rhino stops at 11.
pub const MAX_DEGREE: usize = 31;

/// Checks a knot vector for a curve of `degree` with `count` control points.
///
/// # Errors
/// The degree is not 1…31, there are fewer than degree + 1 control points, the count of knots is not
/// count + degree − 1, a knot is not finite, the knots decrease, the first or last span is empty, or a knot is
/// repeated more than `degree` times.
pub fn check_knots(degree: usize, count: usize, knots: &[f64]) -> Result<()> {
    let invalid = |why: String| Err(Error::Invalid { what: "knot vector", why });
    if degree == 0 || degree > MAX_DEGREE {
        return Err(Error::OutOfRange { what: "degree", value: degree as f64, must: "from 1 to 31" });
    }
    if count <= degree {
        return Err(Error::Invalid {
            what: "NURBS control points",
            why: format!("degree {degree} needs at least {} of them, got {count}", degree + 1),
        });
    }
    let wanted = count + degree - 1;
    if knots.len() != wanted {
        return invalid(format!(
            "{count} control points of degree {degree} need {wanted} knots, got {}",
            knots.len()
        ));
    }
    if !knots.iter().all(|k| k.is_finite()) {
        return Err(Error::NotFinite("knot"));
    }
    if let Some(i) = knots.windows(2).position(|w| w[0] > w[1]) {
        return invalid(format!("knot {} is smaller than knot {i}", i + 1));
    }
    if let Some(i) = knots.windows(degree + 1).position(|w| w[0] >= w[degree]) {
        return invalid(format!("knot {i} is repeated more than {degree} times"));
    }
    if knots[degree - 1] >= knots[degree] || knots[count - 2] >= knots[count - 1] {
        return invalid("its first or last span is empty".into());
    }
    Ok(())
}

/// The span that holds `t`: index j such that `knots[j + degree − 1] ≤ t < knots[j + degree]` and control points
/// j…j + degree act there. Outside the domain it is the first or the last span; with `from_below` a knot belongs to
/// the span that ends at it.
///
/// `knots` must have passed [`check_knots`].
#[inline]
pub fn span_index(knots: &[f64], degree: usize, t: f64, from_below: bool) -> usize {
    let Some(last) = knots.len().checked_sub(2 * degree) else { return 0 };
    let inner = knots.get(degree..degree + last).unwrap_or(&[]);
    if from_below { inner.partition_point(|&k| k < t) } else { inner.partition_point(|&k| k <= t) }
}
