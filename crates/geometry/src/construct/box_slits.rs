//! Slits in boxes that cross, so that they can be put together.

use crate::construct::thresholds::CROSSING_SINE;
use crate::thresholds;
use crate::{Box3, Brep, Error, Interval, Point3, Result, Tolerance, Vector3, cancellation, construct};

/// A box with its slits.
#[derive(Debug, Clone)]
pub struct SlitBox {
    /// What is left of it.
    pub breps: Vec<Brep>,
    /// The places in the list of the boxes that it crosses, in order.
    pub others: Vec<usize>,
}

/// Cuts slits into boxes where they cross: half-lap joints. Where two boxes cross, each is cut over half of the stretch
/// that they share along the direction in which they are put together, the one that comes first in the list at the end
/// towards growing z (of a level direction towards growing y, then x), the other one at the other end, by a slit as wide as
/// the other box and the gap, half of it on each side.
///
/// That direction is at right angles to the thinnest sides of both boxes; of the axes of each box the one nearest to it is
/// taken. Derived from how sheets are put together crosswise; boxes whose thinnest sides are parallel are not cut.
///
/// # Errors
/// The gap is negative or not finite, a box is flat, or as for [`Brep::difference`].
pub fn box_slits(boxes: &[Box3], gap: f64, tolerance: &Tolerance) -> Result<Vec<SlitBox>> {
    if !(gap >= 0.0 && gap.is_finite()) {
        return Err(Error::OutOfRange { what: "gap", value: gap, must: "at least 0 and finite" });
    }
    let limit = tolerance.positive_distance()?;
    let mut tools: Vec<Vec<Brep>> = vec![Vec::new(); boxes.len()];
    let mut others: Vec<Vec<usize>> = vec![Vec::new(); boxes.len()];
    for i in 0..boxes.len() {
        for j in i + 1..boxes.len() {
            cancellation::check()?;
            let (Some(a), Some(b)) = (boxes.get(i), boxes.get(j)) else { continue };
            let Some(way) = joining(a, b) else { continue };
            let Some(shared) = shared(a, b, way) else { continue };
            if shared.length() <= limit || !cross(a, b, tolerance)? {
                continue;
            }
            for (own, other, place, partner, upper) in [(a, b, i, j, true), (b, a, j, i, false)] {
                let tool = slit(other, way, own, shared.middle(), upper, gap);
                tools.get_mut(place).into_iter().for_each(|t| t.extend(construct::box_brep(&tool).ok()));
                others.get_mut(place).into_iter().for_each(|t| t.push(partner));
            }
        }
    }
    let mut out = Vec::with_capacity(boxes.len());
    for ((own, tools), others) in boxes.iter().zip(tools).zip(others) {
        let whole = construct::box_brep(own)?;
        let breps = if tools.is_empty() {
            vec![whole]
        } else {
            Brep::difference(&[whole], &tools, tolerance)?.into_iter().map(|m| m.brep).collect()
        };
        out.push(SlitBox { breps, others });
    }
    Ok(out)
}

fn axes(b: &Box3) -> [(Vector3, Interval); 3] {
    [(b.plane.x_axis, b.x.ordered()), (b.plane.y_axis, b.y.ordered()), (b.plane.z_axis, b.z.ordered())]
}

/// The direction along which two boxes are put together, upwards; none where their thinnest sides are parallel.
fn joining(a: &Box3, b: &Box3) -> Option<Vector3> {
    let thin = |own: &Box3| {
        let all = axes(own);
        all.into_iter().min_by(|p, q| p.1.length().total_cmp(&q.1.length())).map(|p| p.0)
    };
    let way = thin(a)?.cross(thin(b)?);
    if !(way.length() > CROSSING_SINE) {
        return None;
    }
    let way = way.unitized()?;
    let near = |x: f64| x.abs() <= thresholds::PARALLEL;
    let down = way.z < 0.0 && !near(way.z)
        || near(way.z) && (way.y < 0.0 && !near(way.y) || near(way.y) && way.x < 0.0);
    Some(if down { -way } else { way })
}

fn range_along(own: &Box3, way: Vector3) -> Interval {
    let heights = own.corners().map(|p| (p - Point3::ORIGIN).dot(way));
    let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
    Interval::new(low, heights.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}

/// The stretch along a direction that both have.
fn shared(a: &Box3, b: &Box3, way: Vector3) -> Option<Interval> {
    range_along(a, way).intersection(range_along(b, way))
}

/// Whether two boxes have a part in common.
fn cross(a: &Box3, b: &Box3, tolerance: &Tolerance) -> Result<bool> {
    let [a, b] = [construct::box_brep(a)?, construct::box_brep(b)?];
    Ok(!Brep::intersection(&[a], &[b], tolerance)?.is_empty())
}

/// The other box, wider by half of the gap on every side, from a height on: beyond the end of the one that is cut.
fn slit(other: &Box3, way: Vector3, own: &Box3, middle: f64, upper: bool, gap: f64) -> Box3 {
    let wide = |r: Interval| Interval::new(r.min() - 0.5 * gap, r.max() + 0.5 * gap);
    let mut tool = Box3 { plane: other.plane, x: wide(other.x), y: wide(other.y), z: wide(other.z) };
    let along = axes(other).map(|(axis, _)| axis.dot(way));
    let k = (0..3).max_by(|a, b| along[*a].abs().total_cmp(&along[*b].abs())).unwrap_or(2);
    let sign = if along[k] < 0.0 { -1.0 } else { 1.0 };
    // Heights along the box's own axis, from its origin.
    let base = (other.plane.origin - Point3::ORIGIN).dot(way);
    let from = (middle - base) * sign;
    let reach = range_along(own, way).length() + range_along(other, way).length() + gap;
    let towards = if upper { sign } else { -sign };
    let half = 0.5 * gap * towards;
    let ends = Interval::new(from - half, from + towards * reach).ordered();
    match k {
        0 => tool.x = ends,
        1 => tool.y = ends,
        _ => tool.z = ends,
    }
    tool
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a failing test may panic")]

    use super::*;
    use crate::Plane;

    #[test]
    fn crossing_sheets() {
        let range = |a: f64, b: f64| Interval::new(a, b);
        let a = Box3 { plane: Plane::XY, x: range(-5.0, 5.0), y: range(-0.5, 0.5), z: range(0.0, 4.0) };
        let b = Box3 { plane: Plane::XY, x: range(-0.5, 0.5), y: range(-5.0, 5.0), z: range(0.0, 4.0) };
        let t = Tolerance { absolute: 1e-6, ..Tolerance::default() };
        let made = box_slits(&[a, b], 0.0, &t).unwrap();
        let whole = |k: usize| -> f64 {
            made[k].breps.iter().map(|b| b.volume_properties(1e-9, || true).unwrap().amount).sum()
        };
        // Each loses half of the common 1 by 1 by 4.
        assert!((whole(0) - 38.0).abs() < 1e-6 && (whole(1) - 38.0).abs() < 1e-6);
        assert_eq!((&made[0].others, &made[1].others), (&vec![1], &vec![0]));
        // The first is cut from above.
        let top = Point3::new(0.0, 0.0, 3.0);
        assert_eq!(made[0].breps[0].contains(top, 1e-6).unwrap(), crate::Containment::Outside);
        assert_eq!(made[1].breps[0].contains(top, 1e-6).unwrap(), crate::Containment::Inside);
        let apart = Box3 { x: range(7.0, 8.0), ..b };
        assert!(box_slits(&[a, apart], 0.1, &t).unwrap().iter().all(|s| s.others.is_empty()));
        assert!(box_slits(&[a, b], f64::NAN, &t).is_err());
    }
}
