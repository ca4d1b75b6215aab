//! Derivatives, tangents, curvature, torsion and frames.

use crate::curve::thresholds::{STRAIGHT_FRAME, VANISHES};
use crate::thresholds;
use std::f64::consts::FRAC_PI_2;

use katydid_elementary::Elementary;

use super::Curve;
use crate::{Circle, Line, Plane, Point3, Vector3};

impl Curve {
    /// The point at `t` and the derivatives of order 1…`count` by the parameter (64 at most). At a joint those of
    /// the piece that begins there, with `from_below` of the piece that ends there.
    pub fn derivatives(&self, t: f64, count: usize, from_below: bool) -> (Point3, Vec<Vector3>) {
        let mut out = vec![Vector3::ZERO; count.min(64) + 1];
        self.derivatives_into(t, from_below, &mut out);
        let point = out.remove(0).to_point();
        (point, out)
    }

    /// The position at `t`, as a vector from the origin, and then the derivatives of order 1, 2, … as far as there
    /// are places (65 at most; the rest stay as they are), without allocation. Sides as in [`Curve::derivatives`].
    pub fn derivatives_into(&self, t: f64, from_below: bool, out: &mut [Vector3]) {
        let out = match out.len() {
            0..=65 => out,
            _ => &mut out[..65],
        };
        let straight = |out: &mut [Vector3], point: Point3, d: Vector3| {
            for (k, slot) in out.iter_mut().enumerate() {
                *slot = match k {
                    0 => point.to_vector(),
                    1 => d,
                    _ => Vector3::ZERO,
                };
            }
        };
        match self {
            Self::Line(c) => straight(out, c.point_at(t), c.line.direction() / c.domain.length()),
            Self::Polyline(c) => {
                let i = match c.parameters().partition_point(|&p| p < t) {
                    below if from_below => below.saturating_sub(1).min(c.segment_count() - 1),
                    _ => c.segment_at(t),
                };
                let (p, u) = (c.points(), c.parameters());
                straight(out, c.point_at(t), (p[i + 1] - p[i]) / (u[i + 1] - u[i]));
            }
            Self::Arc(c) => {
                let (angle, plane) = (c.angle_at(t), &c.arc.circle.plane);
                let speed = c.arc.angle.length() / c.domain.length();
                let mut size = c.arc.circle.radius;
                for (k, slot) in out.iter_mut().enumerate() {
                    *slot = if k == 0 {
                        c.point_at(t).to_vector()
                    } else {
                        size *= speed;
                        let (sin, cos) = (angle + FRAC_PI_2 * (k % 4) as f64).sine_cosine();
                        plane.x_axis * (size * cos) + plane.y_axis * (size * sin)
                    };
                }
            }
            Self::Nurbs(c) => c.derivatives_into(t, from_below, out),
            Self::Poly(c) => {
                let i = match c.parameters().partition_point(|&p| p < t) {
                    below if from_below => below.saturating_sub(1).min(c.segments().len() - 1),
                    _ => c.segment_at(t),
                };
                let segment = &c.segments()[i];
                segment.derivatives_into(c.to_segment_parameter(i, t), from_below, out);
                let speed = segment.domain().length() / c.segment_domain(i).length();
                let mut factor = 1.0;
                for v in out.iter_mut().skip(1) {
                    factor *= speed;
                    *v = *v * factor;
                }
            }
        }
    }

    /// The unit tangent at `t`. Where the first derivative vanishes it is the limit, by the first derivative that
    /// does not; `None` for a curve without extent there. At a kink the tangent of the outgoing side, at the end of
    /// the domain that of the incoming one.
    pub fn tangent_at(&self, t: f64) -> Option<Vector3> {
        self.tangent_on_side(t, t >= self.domain().end)
    }

    /// The unit tangent at `t` of the piece that ends there (`from_below`) or begins there.
    pub fn tangent_on_side(&self, t: f64, from_below: bool) -> Option<Vector3> {
        let (_, d) = self.derivatives(t, 4, from_below);
        let span = self.domain().length();
        // Sizes that can be compared: what each derivative contributes over the whole domain.
        let mut scale = 1.0;
        let sizes: Vec<f64> = d
            .iter()
            .map(|v| {
                scale *= span;
                v.length() * scale
            })
            .collect();
        let largest = sizes.iter().copied().filter(|x| x.is_finite()).fold(0.0, f64::max);
        for (k, (v, size)) in d.iter().zip(&sizes).enumerate() {
            if *size > VANISHES * largest {
                // (t − t0)^k changes sign from below when k is odd.
                let sign = if from_below && k % 2 == 1 { -1.0 } else { 1.0 };
                return v.unitized().map(|v| v * sign);
            }
        }
        None
    }

    /// The curvature vector at `t`: it points to the centre of the osculating circle and is 1/radius long. Zero
    /// where the curve is straight or stands still.
    pub fn curvature_at(&self, t: f64) -> Vector3 {
        let [_, d1, d2] = self.jet_at(t, t >= self.domain().end);
        curvature(d1, d2)
    }

    /// The curvature with a sign, for a curve seen in a plane: positive where it turns left about the normal.
    pub fn signed_curvature_at(&self, t: f64, normal: Vector3) -> f64 {
        let k = self.curvature_at(t);
        match self.tangent_at(t) {
            Some(tangent) => k.length().copysign(tangent.cross(k).dot(normal)),
            None => 0.0,
        }
    }

    /// The circle that fits the curve best at `t`: tangent there and of the same curvature, with angle 0 at the point.
    /// `None` where the curve is straight.
    pub fn osculating_circle_at(&self, t: f64) -> Option<Circle> {
        let k = self.curvature_at(t);
        let radius = 1.0 / k.length();
        let toward = k.unitized()?;
        let tangent = self.tangent_at(t)?;
        let center = self.point_at(t) + toward * radius;
        Circle::new(Plane::from_axes(center, -toward, tangent).ok()?, radius).ok()
    }

    /// The curvature graph: hairs from points of the curve away from the centre of curvature, `scale` times the
    /// curvature long. Every smooth piece has `samples` + 1 of them with both its ends, so that a jump of curvature
    /// shows as two hairs in one place.
    pub fn curvature_graph(&self, samples: usize, scale: f64) -> Vec<Line> {
        let samples = samples.clamp(1, 10_000);
        let mut hairs = Vec::new();
        for piece in self.pieces() {
            for i in 0..=samples {
                let [p, d1, d2] = piece.jet(piece.own.at(i as f64 / samples as f64));
                let p = p.to_point();
                hairs.push(Line::new(p, p - curvature(d1, d2) * scale));
            }
        }
        hairs
    }

    /// The torsion at `t`: the rate at which the osculating plane turns about the tangent, positive for a right-hand
    /// screw. Zero where the curve is straight.
    pub fn torsion_at(&self, t: f64) -> f64 {
        let (_, d) = self.derivatives(t, 3, t >= self.domain().end);
        let binormal = d[0].cross(d[1]);
        let squared = binormal.length_squared();
        if squared > (thresholds::NO_DIRECTION * d[0].length() * d[1].length()).powi(2) && squared > 0.0 {
            binormal.dot(d[2]) / squared
        } else {
            0.0
        }
    }

    /// The frame of tangent (x) and direction of curvature (y); where the curve is straight y is
    /// [`Vector3::perpendicular`] of the tangent, as in openNURBS. `None` when there is no tangent.
    pub fn frame_at(&self, t: f64) -> Option<Plane> {
        let tangent = self.tangent_at(t)?;
        let k = self.curvature_at(t);
        let size = self.domain().length() * self.derivatives(t, 1, false).1[0].length();
        let y = if k.length() * size > STRAIGHT_FRAME { k } else { tangent.perpendicular()? };
        Plane::from_axes(self.point_at(t), tangent, y).ok()
    }
}

/// The curvature vector of first and second derivative: the part of the second that is at right angles to the first,
/// over the square of the speed.
pub(crate) fn curvature(d1: Vector3, d2: Vector3) -> Vector3 {
    let squared = d1.length_squared();
    if !(squared > f64::MIN_POSITIVE) {
        return Vector3::ZERO;
    }
    let k = (d2 - d1 * (d2.dot(d1) / squared)) / squared;
    if k.is_finite() { k } else { Vector3::ZERO }
}
