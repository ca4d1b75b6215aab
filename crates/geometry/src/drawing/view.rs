//! Views: a picture plane, and from where it is seen.

use crate::silhouette::Viewpoint;
use crate::thresholds;
use crate::{Error, NurbsCurve, Plane, Point3, Result, Vector3};

/// A picture plane and from where it is seen. The plane's origin and axes become those of the world's XY plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    plane: Plane,
    /// The camera in the plane's coordinates; none for a parallel view, which looks against the plane's normal.
    eye: Option<[f64; 3]>,
}

/// What is nearer to the plane through the camera than this part of the camera's height is not drawn.
const NEAR: f64 = 1e-3;

impl View {
    /// The parallel view against the normal of a plane.
    ///
    /// # Errors
    /// The plane is not finite.
    pub fn parallel(plane: Plane) -> Result<Self> {
        if plane.is_finite() { Ok(Self { plane, eye: None }) } else { Err(Error::NotFinite("view plane")) }
    }

    /// The perspective from a camera onto a plane. A camera behind the plane sees the picture from its back.
    ///
    /// # Errors
    /// The plane or the camera is not finite, or the camera lies in the plane.
    pub fn perspective(camera: Point3, plane: Plane) -> Result<Self> {
        let view = Self::parallel(plane)?;
        if !camera.is_finite() {
            return Err(Error::NotFinite("camera"));
        }
        let eye = plane.coordinates(camera);
        let across = (eye[0] * eye[0] + eye[1] * eye[1]).sqrt();
        if eye[2].abs() <= thresholds::ROUNDING * across || eye[2] == 0.0 {
            return Err(Error::degenerate("camera", "it lies in the picture plane"));
        }
        Ok(Self { eye: Some(eye), ..view })
    }

    /// The picture plane.
    pub fn plane(&self) -> Plane {
        self.plane
    }

    /// From where it is seen.
    pub fn viewpoint(&self) -> Viewpoint {
        match self.eye {
            None => Viewpoint::Parallel(-self.plane.z_axis),
            Some([x, y, z]) => Viewpoint::Perspective(self.plane.at(x, y, z)),
        }
    }

    /// The picture of a point: its place, and its depth, which grows towards the viewer. A point level with the camera or
    /// behind it has no picture that means anything.
    pub fn picture(&self, p: Point3) -> (Point3, f64) {
        let [x, y, z] = self.plane.coordinates(p);
        match self.eye {
            None => (Point3::new(x, y, 0.0), z),
            Some([a, b, c]) => {
                let share = c / (c - z);
                (Point3::new(a + (x - a) * share, b + (y - b) * share, 0.0), z * c.signum())
            }
        }
    }

    /// The plane that cuts away what lies behind the camera.
    pub(super) fn clipping(&self) -> Option<Plane> {
        let [_, _, z] = self.eye?;
        let [x, y] = [self.plane.x_axis, self.plane.y_axis];
        let origin = self.plane.at(0.0, 0.0, z * (1.0 - NEAR));
        Plane::from_axes(origin, x, if z > 0.0 { -y } else { y }).ok()
    }

    /// The picture of a curve in front of the camera, with the same parameters. Exact: projections of rational curves are
    /// rational.
    pub(super) fn picture_of(&self, curve: &NurbsCurve) -> Result<NurbsCurve> {
        let points: Vec<[f64; 3]> =
            curve.control_points().into_iter().map(|p| self.plane.coordinates(p)).collect();
        let knots = curve.knots().to_vec();
        let Some([a, b, c]) = self.eye else {
            let points: Vec<Point3> = points.iter().map(|[x, y, _]| Point3::new(*x, *y, 0.0)).collect();
            return if curve.is_rational() {
                NurbsCurve::with_weights(curve.degree(), &points, &curve.weights(), knots)
            } else {
                NurbsCurve::new(curve.degree(), points, knots)
            };
        };
        let weights: Vec<f64> =
            points.iter().zip(curve.weights()).map(|([_, _, z], w)| w * (1.0 - z / c)).collect();
        let points: Vec<Point3> = points
            .iter()
            .map(|[x, y, z]| {
                let share = c / (c - z);
                Point3::new(a + (x - a) * share, b + (y - b) * share, 0.0)
            })
            .collect();
        NurbsCurve::with_weights(curve.degree(), &points, &weights, knots)
    }

    /// A vector across the line of sight that moves pictures along (x, y).
    pub(super) fn sideways(&self, x: f64, y: f64) -> Vector3 {
        self.plane.x_axis * x + self.plane.y_axis * y
    }
}
