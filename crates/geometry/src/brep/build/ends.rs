//! Curves of a loop brought to meet end to end.

use super::Path;
use crate::curve::with_ends;
use crate::{Curve, Error, Point3, Result};

/// Moves the ends of neighbours to one place, over gaps up to a part of the loop's size. A straight curve keeps its end,
/// so that it stays on its line.
pub(super) fn close_gaps(paths: &mut [Path], largest: f64) -> Result<()> {
    if paths.is_empty() {
        return Err(Error::degenerate("loop", "it has no pieces"));
    }
    let ends: Vec<[Point3; 2]> = paths.iter().map(|p| [p.curve.start(), p.curve.end()]).collect();
    let all = ends.iter().flatten().copied();
    if !all.clone().all(Point3::is_finite) {
        return Err(Error::NotFinite("end of a loop's curve"));
    }
    let count = paths.len();
    if (0..count).all(|i| ends[i][1] == ends[(i + 1) % count][0]) {
        return Ok(());
    }
    let size = crate::BoundingBox::from_points(paths.iter().flat_map(|p| p.curve.hull_points()))
        .map_or(0.0, |b| b.diagonal().length());
    let mut wanted = ends.clone();
    for i in 0..count {
        let j = (i + 1) % count;
        let (a, b) = (ends[i][1], ends[j][0]);
        if a == b {
            continue;
        }
        if !(a.distance_to(b) <= largest * size) {
            return Err(Error::Invalid {
                what: "boundary of a face",
                why: format!("its curves do not meet: two are {} of its size apart", a.distance_to(b) / size),
            });
        }
        let straight = |k: usize| matches!(paths[k].curve, Curve::Line(_));
        let meeting = match (straight(i), straight(j)) {
            (true, false) => a,
            (false, true) => b,
            _ if is_axial(&paths[i].curve) && is_axial(&paths[j].curve) => {
                corner(&paths[i].curve, &paths[j].curve)
            }
            _ => a.lerp(b, 0.5),
        };
        wanted[i][1] = meeting;
        wanted[j][0] = meeting;
    }
    for ((path, old), new) in paths.iter_mut().zip(ends).zip(wanted) {
        if old != new {
            path.curve = with_ends(&path.curve, new)?;
        }
    }
    Ok(())
}

fn is_axial(curve: &Curve) -> bool {
    let (a, b) = (curve.start(), curve.end());
    matches!(curve, Curve::Line(_)) && (a.x == b.x || a.y == b.y)
}

/// Where two axial lines meet; the first one's end when they run along each other.
fn corner(first: &Curve, second: &Curve) -> Point3 {
    let (a, b) = (first.end(), second.start());
    let upright = |c: &Curve| c.start().x == c.end().x;
    match (upright(first), upright(second)) {
        (true, false) => Point3::new(a.x, b.y, 0.0),
        (false, true) => Point3::new(b.x, a.y, 0.0),
        _ => a,
    }
}
