//! Frames along a curve that do not twist about it.

use katydid_elementary::Elementary;

use super::Curve;
use crate::curve::thresholds::{NO_HORIZONTAL, NO_ROTATION};
use crate::{Plane, Vector3, cancellation};

impl Curve {
    /// Frames at parameters, in the order given: z is the tangent, and x turns about it as little as possible from
    /// the start of the curve on, where it is [`Vector3::perpendicular`] of the tangent. A frame is `None` where
    /// there is no tangent.
    ///
    /// Double reflection (W. Wang, B. Jüttler, D. Zheng, Y. Liu, *Computation of rotation minimizing frames*, ACM
    /// Trans. Graph. 27, 2008), exact on circles; elsewhere in steps of 1/64 of a span, an error of order h⁴.
    pub fn perpendicular_frames(&self, parameters: &[f64]) -> Vec<Option<Plane>> {
        let domain = self.domain();
        let mut stations: Vec<f64> = Vec::new();
        for piece in self.pieces() {
            let straight = matches!(piece.shape, super::piece::Shape::Segment(..));
            let steps = if straight { 1 } else { 64 };
            stations.extend((0..steps).map(|k| piece.whole.at(f64::from(k) / f64::from(steps))));
        }
        let wanted = parameters.iter().map(|&t| domain.clamp(t));
        stations.extend(wanted.clone());
        stations.push(domain.end);
        stations.sort_by(f64::total_cmp);
        stations.dedup();
        let mut frames: Vec<(f64, Vector3, Vector3)> = Vec::with_capacity(stations.len());
        for t in stations {
            if cancellation::check().is_err() {
                break;
            }
            let point = self.point_at(t);
            // Over a kink the frame turns by the smallest rotation from the arriving tangent to the leaving one.
            let Some(leaving) = self.tangent_at(t) else { continue };
            let arriving = self.tangent_on_side(t, true).unwrap_or(leaving);
            let x = match frames.last() {
                None => leaving.perpendicular(),
                Some(&(before, old_t, old_x)) => {
                    let from = self.point_at(before);
                    // Between places a rounding apart the way is noise, and a reflection in it would turn the frame.
                    let x = if from.coincides(point) {
                        turned(old_x, old_t, arriving)
                    } else {
                        Some(double_reflection(from - point, old_t, old_x, arriving))
                    };
                    x.and_then(|x| turned(x, arriving, leaving))
                }
            };
            let Some(x) = x.and_then(|x| x.rejected_from(leaving)).and_then(Vector3::unitized) else {
                continue;
            };
            frames.push((t, leaving, x));
        }
        wanted
            .map(|t| {
                let i = frames.binary_search_by(|f| f.0.total_cmp(&t)).ok()?;
                let &(_, z, x) = frames.get(i)?;
                Some(Plane { origin: self.point_at(t), x_axis: x, y_axis: z.cross(x), z_axis: z })
            })
            .collect()
    }

    /// The twist-free frame at one parameter: see [`Curve::perpendicular_frames`].
    pub fn perpendicular_frame_at(&self, t: f64) -> Option<Plane> {
        self.perpendicular_frames(&[t]).pop().flatten()
    }

    /// The frame with the tangent's horizontal part along x and z straight up; `None` where the tangent is vertical
    /// or there is none.
    pub fn horizontal_frame_at(&self, t: f64) -> Option<Plane> {
        let tangent = self.tangent_at(t)?;
        let x = Vector3::new(tangent.x, tangent.y, 0.0);
        if x.length() < NO_HORIZONTAL {
            return None;
        }
        let x = x.unitized()?;
        Some(Plane { origin: self.point_at(t), x_axis: x, y_axis: Vector3::Z.cross(x), z_axis: Vector3::Z })
    }
}

/// The x axis carried from one station to the next by two reflections.
fn double_reflection(back: Vector3, old_t: Vector3, old_x: Vector3, new_t: Vector3) -> Vector3 {
    let v1 = -back;
    let c1 = v1.length_squared();
    if !(c1 > f64::MIN_POSITIVE) {
        return old_x;
    }
    let x = old_x - v1 * (2.0 * v1.dot(old_x) / c1);
    let t = old_t - v1 * (2.0 * v1.dot(old_t) / c1);
    let v2 = new_t - t;
    let c2 = v2.length_squared();
    if !(c2 > f64::MIN_POSITIVE) {
        return x;
    }
    x - v2 * (2.0 * v2.dot(x) / c2)
}

/// `x` turned by the smallest rotation from `a` to `b`.
fn turned(x: Vector3, a: Vector3, b: Vector3) -> Option<Vector3> {
    let axis = a.cross(b);
    if axis.length() < NO_ROTATION { Some(x) } else { x.rotated(axis.length().arctangent_of(a.dot(b)), axis) }
}

#[cfg(test)]
mod tests {
    use crate::{Curve, NurbsCurve, Point3};

    /// Parameters a rounding beside the places that frames are carried by, such as the middle of a span, get the same
    /// frame as those; that of a plane curve keeps its place against the plane.
    #[test]
    fn places_a_rounding_apart() {
        let points = [[7.0, 0.0, 0.0], [7.0, 20.0, 30.0], [7.0, -10.0, 60.0], [7.0, 10.0, 90.0]];
        let curve: Curve = NurbsCurve::clamped_uniform(3, &points.map(Point3::from)).unwrap().into();
        let domain = curve.domain();
        let first = curve.perpendicular_frame_at(domain.start).unwrap();
        for k in 1..64 {
            let t = domain.at(f64::from(k) / 64.0);
            for near in
                [t, t.next_up(), t.next_down(), t * (1.0 + 1e-14), t * (1.0 - 1e-14), t * (1.0 + 1e-12)]
            {
                for asked in [near, domain.end] {
                    let frames = curve.perpendicular_frames(&[near, asked]);
                    for frame in frames.into_iter().flatten() {
                        let apart = frame.x_axis.x - first.x_axis.x;
                        assert!(apart.abs() < 1e-6, "{k} {near} {apart}");
                    }
                }
            }
        }
    }
}
