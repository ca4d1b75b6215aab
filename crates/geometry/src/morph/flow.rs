use katydid_elementary::Elementary;

use super::{Morph, finite};
use crate::curve::ClosestOnCurve;
use crate::morph::thresholds::NO_SIDE;
use crate::thresholds;
use crate::{ArcLength, Curve, Error, Plane, Point3, Result, Vector3};

/// Frames along a curve that turn about it as little as possible.
#[derive(Debug, Clone)]
struct Spine<'a> {
    curve: &'a Curve,
    length: ArcLength<'a>,
    /// Frames at stations, with increasing parameters.
    frames: Vec<(f64, Plane)>,
    /// What all frames are turned by about the curve.
    roll: f64,
}

impl<'a> Spine<'a> {
    fn new(curve: &'a Curve) -> Result<Self> {
        let pieces = curve.pieces();
        let steps = (4096 / pieces.len().max(1)).clamp(1, 64);
        let mut stations: Vec<f64> = pieces
            .iter()
            .flat_map(|p| (0..steps).map(|k| p.whole.at(k as f64 / steps as f64)).collect::<Vec<_>>())
            .collect();
        stations.push(curve.domain().end);
        let frames: Vec<(f64, Plane)> = stations
            .iter()
            .zip(curve.perpendicular_frames(&stations))
            .filter_map(|(&t, frame)| Some((t, frame?)))
            .collect();
        let length = ArcLength::new(curve);
        if frames.is_empty() || !(length.total() > 0.0 && length.total().is_finite()) {
            return Err(Error::degenerate("curve to flow along", "it has no length"));
        }
        Ok(Self { curve, length, frames, roll: 0.0 })
    }

    /// Turns the frames so that the first is the first of `other` after the smallest turn from its tangent.
    fn rolled_to(mut self, other: &Self) -> Self {
        let (Some((_, own)), Some((_, first))) = (self.frames.first(), other.frames.first()) else {
            return self;
        };
        let wanted = carried(first.x_axis, first.z_axis, own.z_axis);
        self.roll = own.x_axis.signed_angle_to(wanted, own.z_axis).unwrap_or(0.0);
        self
    }

    /// The frame at a parameter: z along the curve.
    fn frame(&self, t: f64) -> Option<Plane> {
        let i = self.frames.partition_point(|f| f.0 <= t).saturating_sub(1);
        let (_, from) = self.frames.get(i)?;
        let z = self.curve.tangent_at(t).unwrap_or(from.z_axis);
        let x = carried(from.x_axis, from.z_axis, z).rejected_from(z)?.unitized()?;
        let frame = Plane { origin: self.curve.point_at(t), x_axis: x, y_axis: z.cross(x), z_axis: z };
        Some(frame.rotated(self.roll))
    }
}

/// `x` after the smallest turn from direction `a` to `b`; to the opposite direction, the half turn about the vertical
/// as far as it is across.
fn carried(x: Vector3, a: Vector3, b: Vector3) -> Vector3 {
    let axis = a.cross(b);
    let turned = if axis.length() > thresholds::NO_DIRECTION {
        x.rotated(axis.length().arctangent_of(a.dot(b)), axis)
    } else if a.dot(b) < 0.0 {
        let axis = Vector3::Z.rejected_from(a).filter(|v| v.length() > NO_SIDE).or_else(|| a.perpendicular());
        axis.and_then(|axis| x.rotated(std::f64::consts::PI, axis))
    } else {
        None
    };
    turned.unwrap_or(x)
}

/// Carries space along with a curve that is laid over another: what lies beside a point of the base lies the same way
/// beside the point of the target at the same length, or the same fraction of the length.
///
/// "The same way" is by frames that turn about the curves as little as possible; at the starts they differ by the
/// smallest turn from one tangent to the other. Beyond the ends of an open base it goes on straight.
#[derive(Debug, Clone)]
pub struct Flow<'a> {
    nearest: ClosestOnCurve<'a>,
    base: Spine<'a>,
    target: Spine<'a>,
    stretch: bool,
}

impl<'a> Flow<'a> {
    /// The flow from `base` to `target`, both in their own directions. With `stretch` the whole base becomes the whole
    /// target; else lengths are kept, and a target that is too short goes on straight.
    ///
    /// # Errors
    /// A curve without length.
    pub fn new(base: &'a Curve, target: &'a Curve, stretch: bool) -> Result<Self> {
        let spine = Spine::new(base)?;
        let target = Spine::new(target)?.rolled_to(&spine);
        Ok(Self { nearest: ClosestOnCurve::new(base), base: spine, target, stretch })
    }
}

impl Morph for Flow<'_> {
    fn image(&self, p: Point3) -> Result<Point3> {
        let near = self.nearest.nearest(p)?;
        let none = Error::degenerate("curve to flow along", "it has no direction somewhere");
        let [x, y, along] = self.base.frame(near.parameter).ok_or(none.clone())?.coordinates(p);
        let (length, whole) = (self.base.length.length_at(near.parameter), self.target.length.total());
        let length = if self.stretch { length / self.base.length.total() * whole } else { length };
        let inside = length.clamp(0.0, whole);
        let t = self.target.length.parameter_at(inside);
        finite(self.target.frame(t).ok_or(none)?.at(x, y, along + (length - inside)))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::{Circle, Line, NurbsCurve, Tolerance};

    fn line(a: [f64; 3], b: [f64; 3]) -> Curve {
        Line::new(a.into(), b.into()).into()
    }

    #[test]
    fn along_itself_nothing_moves() {
        let points = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, -1.0, 1.0], [4.0, 0.0, 0.0], [5.0, 1.0, 2.0]];
        let wave: Curve = NurbsCurve::clamped_uniform(3, &points.map(Point3::from)).unwrap().into();
        for stretch in [true, false] {
            for curve in [&wave, &line([0.0; 3], [4.0, 1.0, 0.0])] {
                let flow = Flow::new(curve, curve, stretch).unwrap();
                for p in [[1.0, 1.0, 0.0], [3.0, 0.2, 0.7], [9.0, 1.0, 1.0]].map(Point3::from) {
                    assert!(flow.image(p).unwrap().distance_to(p) < 1e-7);
                }
            }
        }
    }

    #[test]
    fn a_line_onto_a_line_is_rigid_or_stretched() {
        let (a, b) = (line([0.0; 3], [2.0, 0.0, 0.0]), line([0.0, 5.0, 0.0], [0.0, 9.0, 0.0]));
        let at = |stretch: bool, x: f64, y: f64, z: f64| {
            Flow::new(&a, &b, stretch).unwrap().image(Point3::new(x, y, z)).unwrap()
        };
        assert!(at(true, 1.0, 0.5, 3.0).distance_to(Point3::new(-0.5, 7.0, 3.0)) < 1e-12);
        assert!(at(false, 1.0, 0.5, 3.0).distance_to(Point3::new(-0.5, 6.0, 3.0)) < 1e-12);
        assert!(at(false, 3.0, 0.5, 3.0).distance_to(Point3::new(-0.5, 8.0, 3.0)) < 1e-12);
        let back = line([9.0, 0.0, 0.0], [5.0, 0.0, 0.0]);
        let flow = Flow::new(&a, &back, false).unwrap();
        let turned = flow.image(Point3::new(1.0, 0.5, 3.0)).unwrap();
        assert!(turned.distance_to(Point3::new(8.0, -0.5, 3.0)) < 1e-12);
    }

    #[test]
    fn a_line_flows_into_a_circle() {
        let base = line([0.0; 3], [4.0 * PI, 0.0, 0.0]);
        let ring: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
        let flow = Flow::new(&base, &ring, true).unwrap();
        let side = line([0.0, 1.0, 0.0], [4.0 * PI, 1.0, 0.0]);
        let image = side.morphed(&flow, &Tolerance::default()).unwrap();
        assert!((image.length() - 2.0 * PI).abs() < 1e-6, "{}", image.length());
    }
}
