//! Spheres, cylinders, cones and tori behind other surfaces.

use katydid_elementary::Elementary;

use super::{Cone, Cylinder, Sphere, Surface, Torus};
use crate::linear::symmetric_eigen;
use crate::surface::thresholds::{FLAT_SCATTER, RECOGNISED};
use crate::thresholds;
use crate::{Circle, Direction, Interval, Plane, Point3, Vector3};

/// At most so many points a direction are looked at.
const MOST: usize = 64;

/// A point of the surface with its unit normal and principal curvatures.
struct Sample {
    point: Point3,
    normal: Vector3,
    principal: [f64; 2],
}

impl Surface {
    /// Points on a grid: in every span 2·degree + 1 for a NURBS surface, so that a quadric condition that holds at
    /// them holds everywhere; singular points are left out.
    fn samples(&self) -> Vec<Sample> {
        let parameters = |d: Direction| -> Vec<f64> {
            let (spans, inner) = match self {
                Self::Nurbs(s) => (s.span_parameters(d), 2 * s.degree(d) + 1),
                _ => (vec![self.domain(d).start, self.domain(d).end], 16),
            };
            let inner = inner.min(MOST / spans.len().max(2)).max(1);
            let mut out: Vec<f64> = spans
                .windows(2)
                .flat_map(|w| {
                    let span = Interval::new(w[0], w[1]);
                    (0..inner).map(move |i| span.at((i as f64 + 0.5) / inner as f64))
                })
                .collect();
            out.extend([spans.first(), spans.last()].into_iter().flatten());
            out
        };
        let vs = parameters(Direction::V);
        let mut out = Vec::new();
        for u in parameters(Direction::U) {
            for &v in &vs {
                if let Ok(c) = self.curvature_at(u, v) {
                    out.push(Sample { point: c.point, normal: c.normal, principal: c.principal });
                }
            }
        }
        out
    }

    /// The sphere on which the surface lies within `tolerance`. An exact sphere is always told; what else passes was
    /// looked at on a grid of points in every patch.
    pub fn as_sphere(&self, tolerance: f64) -> Option<Sphere> {
        let samples = self.samples();
        let first = samples.first()?;
        // Along the normal by the radius of curvature.
        let k = 0.5 * (first.principal[0] + first.principal[1]);
        let center = first.point + first.normal / k;
        if !center.is_finite() || samples.len() < 4 {
            return None;
        }
        let distances: Vec<f64> = samples.iter().map(|s| s.point.distance_to(center)).collect();
        let radius = distances.iter().sum::<f64>() / distances.len() as f64;
        within(distances.iter().map(|d| d - radius), tolerance, radius, &samples)?;
        Sphere::around(center, radius).ok()
    }

    /// The cylinder on which the surface lies within `tolerance`, as long as the surface reaches along its axis.
    pub fn as_cylinder(&self, tolerance: f64) -> Option<Cylinder> {
        let samples = self.samples();
        // The axis is at right angles to all normals.
        let axis = least_spread(samples.iter().map(|s| s.normal))?;
        let plane = Plane::from_normal(samples.first()?.point, axis).ok()?;
        let flat: Vec<Point3> = samples.iter().map(|s| plane.closest_point(s.point)).collect();
        let (circle, deviation) = Circle::fit(&flat).ok()?;
        within([deviation], tolerance, circle.radius, &samples)?;
        let frame = plane.with_origin(plane.closest_point(circle.center()));
        let (low, high) = self.reach(&frame)?;
        Cylinder::new(frame.offset(low), circle.radius, Interval::new(0.0, high - low)).ok()
    }

    /// The cone on which the surface lies within `tolerance`, from its apex to as far as the surface reaches.
    pub fn as_cone(&self, tolerance: f64) -> Option<Cone> {
        let samples = self.samples();
        // The tips of the normals lie in a plane across the axis.
        let n = samples.len() as f64;
        let mean = samples.iter().map(|s| s.normal / n).sum::<Vector3>();
        let axis = least_spread(samples.iter().map(|s| s.normal - mean))?;
        // The apex is where all tangent planes meet: least squares of n·x = n·p.
        let mut m = [[0.0; 3]; 3];
        let mut right = [0.0; 3];
        let start = samples.first()?.point;
        for s in &samples {
            let row: [f64; 3] = s.normal.into();
            let value = s.normal.dot(s.point - start);
            for i in 0..3 {
                for j in 0..3 {
                    m[i][j] += row[i] * row[j];
                }
                right[i] += row[i] * value;
            }
        }
        let (values, vectors) = symmetric_eigen(m);
        if !(values[0] > FLAT_SCATTER * values[2]) {
            return None;
        }
        let right = Vector3::from(right);
        let apex = vectors.iter().zip(values).fold(start, |sum, (&v, value)| {
            let v = Vector3::from(v);
            sum + v * (v.dot(right) / value)
        });
        // Towards the surface.
        let center = samples.iter().map(|s| (s.point - apex) / n).sum::<Vector3>();
        let axis = if axis.dot(center) < 0.0 { -axis } else { axis };
        let frame = Plane::from_normal(apex, axis).ok()?;
        let polar = |p: Point3| {
            let [x, y, z] = frame.coordinates(p);
            (x.hypotenuse(y), z)
        };
        let (r, z) = samples.iter().map(|s| polar(s.point)).fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
        let slope = r / z;
        let across = (1.0 + slope * slope).sqrt();
        let size = self.reach(&frame)?.1;
        within(
            samples.iter().map(|s| {
                let (r, z) = polar(s.point);
                (r - slope * z) / across
            }),
            tolerance,
            size,
            &samples,
        )?;
        Cone::new(frame, size, slope * size).ok()
    }

    /// The torus on which the surface lies within `tolerance`.
    pub fn as_torus(&self, tolerance: f64) -> Option<Torus> {
        let samples = self.samples();
        let first = samples.first()?;
        // One principal curvature is that of the tube everywhere: the points that far inside lie on its middle circle.
        first.principal.into_iter().find_map(|k| {
            let middle: Vec<Point3> = samples.iter().map(|s| s.point + s.normal / k).collect();
            let (circle, deviation) = Circle::fit(&middle).ok()?;
            let minor = 1.0 / k.abs();
            within([deviation], tolerance, circle.radius + minor, &samples)?;
            let torus = Torus::new(circle.plane, circle.radius, minor).ok()?;
            let misses = samples.iter().map(|s| torus.closest_point(s.point).distance_to(s.point));
            within(misses, tolerance, circle.radius + minor, &samples)?;
            Some(torus)
        })
    }

    /// The range that the surface covers along a plane's normal.
    fn reach(&self, plane: &Plane) -> Option<(f64, f64)> {
        let range = self.extent_along(plane.z_axis).ok()?;
        let origin = plane.origin.to_vector().dot(plane.z_axis);
        Some((range.start - origin, range.end - origin))
    }
}

/// Nothing, unless all deviations are within the tolerance, or within rounding of the size. What the surface leaves a
/// sphere by that is far larger than the surface is no rounding: of a flat part the radius is that of rounding itself.
fn within(
    deviations: impl IntoIterator<Item = f64>,
    tolerance: f64,
    size: f64,
    samples: &[Sample],
) -> Option<()> {
    let first = samples.first()?.point;
    let extent = samples.iter().map(|s| s.point.distance_to(first)).fold(0.0, f64::max);
    let limit = tolerance.max(RECOGNISED * size.min(extent));
    // From so far away distances have no digits left to tell them apart.
    if !(f64::EPSILON * size <= limit) {
        return None;
    }
    deviations.into_iter().all(|d| d.abs() <= limit).then_some(())
}

/// The unit direction along which vectors spread least, when they spread in the two others.
fn least_spread(vectors: impl Iterator<Item = Vector3>) -> Option<Vector3> {
    let mut m = [[0.0; 3]; 3];
    for v in vectors {
        let v: [f64; 3] = v.into();
        for i in 0..3 {
            for j in 0..3 {
                m[i][j] += v[i] * v[j];
            }
        }
    }
    let (values, axes) = symmetric_eigen(m);
    if !(values[1] > thresholds::ROUNDING * values[2] && values[2] > 0.0) {
        return None;
    }
    Some(axes[0].into())
}
