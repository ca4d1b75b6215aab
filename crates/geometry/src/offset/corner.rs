//! What fills the outside of a corner.

use katydid_elementary::Elementary;

use super::validity::Cap;
use super::{OffsetCorner, RawPart, right_of};
use crate::offset::thresholds::SHARPEST;
use crate::thresholds;
use crate::{Arc, Curve, Error, Line, LineCurve, Plane, Point3, Result, Vector3};

/// A corner of the source with a gap to fill.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    pub(super) vertex: Point3,
    pub(super) arriving: Vector3,
    pub(super) leaving: Vector3,
}

/// What lies between the offsets of two smooth parts that follow each other.
#[derive(Default)]
pub(super) struct Bridge {
    pub(super) parts: Vec<RawPart>,
    pub(super) cap: Option<Cap>,
}

/// The parts between the offsets of two smooth parts that follow each other, and what they enclose: nothing where
/// the sides meet smoothly or overlap. What becomes a chamfer or a blend is an arc so far.
pub(super) fn bridge(
    before: &Curve,
    after: &Curve,
    plane: &Plane,
    distance: f64,
    corner: OffsetCorner,
) -> Result<Bridge> {
    let none = || Error::degenerate("curve to offset", "a part has no direction at its end");
    let arriving = before.tangent_on_side(before.domain().end, true).ok_or_else(none)?;
    let leaving = after.tangent_on_side(after.domain().start, false).ok_or_else(none)?;
    let (vertex, other) = (before.end(), after.start());
    let (n0, n1) = (right_of(arriving, plane)?, right_of(leaving, plane)?);
    let (a, b) = (vertex + n0 * distance, other + n1 * distance);
    // A reversal counts as a turn to the side where the gap is.
    let turn = arriving.cross(leaving).dot(plane.z_axis);
    let reversal = arriving.dot(leaving) < 0.0 && turn.abs() < thresholds::PARALLEL;
    if a.distance_to(b) <= thresholds::SAME_POINT * distance.abs() || (turn * distance <= 0.0 && !reversal) {
        return Ok(Bridge::default());
    }
    let arc = round(vertex, a, b, distance, plane)?;
    let (frame, angle) = (arc.circle.plane, arc.angle.end);
    let (reach, side) = (distance.abs(), distance.signum());
    let path = |points: &[Point3], outer: Vec<(Vector3, f64)>| Bridge {
        parts: points.windows(2).map(|w| RawPart::exact(Line::new(w[0], w[1]).into())).collect(),
        cap: Some(Cap { frame, turn: angle, outer, outline: points.to_vec() }),
    };
    Ok(match corner {
        OffsetCorner::None => Bridge::default(),
        OffsetCorner::Round | OffsetCorner::Chamfer | OffsetCorner::Smooth => {
            let corner = Some(Corner { vertex, arriving, leaving });
            Bridge { parts: vec![RawPart { curve: arc.into(), source: None, corner }], cap: None }
        }
        OffsetCorner::Sharp => {
            let sides = vec![(n0 * side, reach), (n1 * side, reach)];
            let opening = 1.0 + n0.dot(n1);
            if opening > SHARPEST {
                path(&[a, vertex + (n0 + n1) * (distance / opening), b], sides)
            } else {
                // Too sharp for a tip: cut square.
                let (x, y) = (a + arriving * reach, b - leaving * reach);
                let outward = (y - x).cross(frame.z_axis).unitized().ok_or_else(none)?;
                path(&[a, x, y, b], [sides, vec![(outward, outward.dot(x - vertex))]].concat())
            }
        }
    })
}

fn round(vertex: Point3, a: Point3, b: Point3, distance: f64, plane: &Plane) -> Result<Arc> {
    let from = a - vertex;
    let z = if distance > 0.0 { plane.z_axis } else { -plane.z_axis };
    let frame = Plane::from_axes(vertex, from, z.cross(from))?;
    let circle = crate::Circle::new(frame, distance.abs())?;
    let [x, y, _] = frame.coordinates(b);
    let angle = y.arctangent_of(x);
    // A reversal is half a turn, on whichever side rounding puts it.
    let angle = if angle <= 0.0 { angle + std::f64::consts::TAU } else { angle };
    Arc::new(circle, crate::Interval::new(0.0, angle))
}

/// Where both neighbours of a sharp corner are lines, they grow to the tip themselves.
pub(super) fn merge_lines(before: &mut [RawPart], bridge: &mut Vec<RawPart>, after: &mut [RawPart]) {
    let [first, second] = bridge.as_slice() else { return };
    let (Curve::Line(_), Curve::Line(tip)) = (&first.curve, &second.curve) else { return };
    let tip = tip.line.from;
    if let (Some(RawPart { curve: Curve::Line(a), .. }), Some(RawPart { curve: Curve::Line(b), .. })) =
        (before.last_mut(), after.first_mut())
    {
        *a = LineCurve::new(Line::new(a.line.from, tip));
        *b = LineCurve::new(Line::new(tip, b.line.to));
        bridge.clear();
    }
}
