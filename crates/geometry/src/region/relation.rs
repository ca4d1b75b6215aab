//! How two closed curves lie to each other.

use super::combine::{arranged, checked, ladder};
use super::meetings::Meetings;
use super::sources::Sources;
use crate::{Curve, Error, Plane, Result};

/// How the regions that two closed curves enclose lie to each other. Borders may touch, within the tolerance, in all
/// cases.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum CurveRelation {
    /// They have no area in common.
    Apart,
    /// They have area in common, and each has some for itself.
    Crossing,
    /// The first lies in the second.
    FirstInside,
    /// The second lies in the first.
    SecondInside,
    /// They are the same.
    Same,
}

/// How two closed curves, projected into a plane, lie to each other. Inside means a winding number other than 0.
///
/// # Errors
/// A curve is open; the tolerance is not finite and above 0; the curves meet so often that the work is refused, or
/// one of them encloses nothing.
pub fn relation(a: &Curve, b: &Curve, plane: &Plane, tolerance: f64) -> Result<CurveRelation> {
    checked(plane, tolerance)?;
    let sources = Sources::new([a, b], plane, tolerance)?;
    let steps = ladder(tolerance, sources.scale);
    let mut meetings = Meetings::default();
    for (k, &reach) in steps.iter().enumerate() {
        let Some((_, _, sides)) = arranged(&sources, &mut meetings, reach, k + 1 == steps.len())? else {
            continue;
        };
        // Every part of the plane that the curves bound lies beside some strand.
        let (mut first, mut second, mut both) = (false, false, false);
        for all in &sides {
            for left in [true, false] {
                let inside = |source: usize| {
                    all.iter().any(|s| s.source == source && (if left { s.left } else { s.right }) != 0)
                };
                match (inside(0), inside(1)) {
                    (true, true) => both = true,
                    (true, false) => first = true,
                    (false, true) => second = true,
                    (false, false) => {}
                }
            }
        }
        return match (both, first, second) {
            (true, true, true) => Ok(CurveRelation::Crossing),
            (true, false, true) => Ok(CurveRelation::FirstInside),
            (true, true, false) => Ok(CurveRelation::SecondInside),
            (true, false, false) => Ok(CurveRelation::Same),
            (false, true, true) => Ok(CurveRelation::Apart),
            _ => Err(Error::degenerate("curve", "it encloses no area")),
        };
    }
    Err(Error::degenerate("curve", "it encloses no area"))
}
