//! Transforms from what they do.

use katydid_elementary::Elementary;

use crate::thresholds;
use crate::xform::thresholds::NO_TURN;
use crate::{Error, Plane, Point3, Result, Vector3, Xform};

impl Xform {
    /// The affine map that takes the world axes to `x`, `y`, `z` and the world's origin to `origin`.
    pub const fn from_columns(x: Vector3, y: Vector3, z: Vector3, origin: Point3) -> Self {
        Self {
            rows: [
                [x.x, y.x, z.x, origin.x],
                [x.y, y.y, z.y, origin.y],
                [x.z, y.z, z.z, origin.z],
                [0.0, 0.0, 0.0, 1.0],
            ],
        }
    }

    /// This map's linear part applied about `center` instead of the origin: `center` stays where it is.
    fn about(self, center: Point3) -> Self {
        let mut m = self;
        let t = center.to_vector() - self.vector(center.to_vector());
        m.rows[0][3] = t.x;
        m.rows[1][3] = t.y;
        m.rows[2][3] = t.z;
        m
    }

    /// The scale by three factors along a plane's axes, about its origin.
    pub fn scale_non_uniform(plane: &Plane, x: f64, y: f64, z: f64) -> Self {
        Self::in_frame(plane, plane.x_axis * x, plane.y_axis * y, plane.z_axis * z)
    }

    /// The map that keeps a plane's origin and takes its axes to `x`, `y` and `z`: the general shear and scale.
    pub fn in_frame(plane: &Plane, x: Vector3, y: Vector3, z: Vector3) -> Self {
        let images = [<[f64; 3]>::from(x), y.into(), z.into()];
        let axes = [<[f64; 3]>::from(plane.x_axis), plane.y_axis.into(), plane.z_axis.into()];
        let mut m = Self::IDENTITY;
        for i in 0..3 {
            for j in 0..3 {
                m.rows[i][j] = (0..3).map(|k| images[k][i] * axes[k][j]).sum();
            }
        }
        m.about(plane.origin)
    }

    /// The rotation by `angle` radians about the axis through `center`, by the right-hand rule.
    ///
    /// # Errors
    /// When the axis has no direction.
    pub fn rotation(angle: f64, axis: Vector3, center: Point3) -> Result<Self> {
        let (sin, cos) = angle.sine_cosine();
        Self::rotation_sin_cos(sin, cos, axis, center)
    }

    /// The rotation by the angle with the given sine and cosine.
    ///
    /// # Errors
    /// When the axis has no direction or a number is not finite.
    pub fn rotation_sin_cos(sin: f64, cos: f64, axis: Vector3, center: Point3) -> Result<Self> {
        if !(sin.is_finite() && cos.is_finite() && center.is_finite()) {
            return Err(Error::NotFinite("rotation angle or centre"));
        }
        let k = axis.unitized().ok_or(Error::degenerate("rotation axis", "it has no direction"))?;
        let column = |e: Vector3| e * cos + k.cross(e) * sin + k * (k.dot(e) * (1.0 - cos));
        Ok(Self::from_columns(column(Vector3::X), column(Vector3::Y), column(Vector3::Z), Point3::ORIGIN)
            .about(center))
    }

    /// The smallest rotation about `center` that turns direction `from` into direction `to`. For opposite
    /// directions the axis is [`Vector3::perpendicular`] of `from`.
    ///
    /// # Errors
    /// When one of the two has no direction.
    pub fn rotation_between(from: Vector3, to: Vector3, center: Point3) -> Result<Self> {
        let a = from.unitized().ok_or(Error::degenerate("start direction", "it has no length"))?;
        let b = to.unitized().ok_or(Error::degenerate("end direction", "it has no length"))?;
        let cross = a.cross(b);
        let (sin, cos) = (cross.length(), a.dot(b));
        if sin <= NO_TURN {
            if cos > 0.0 {
                return Ok(Self::IDENTITY);
            }
            let axis = a.perpendicular().ok_or(Error::degenerate("start direction", "it has no length"))?;
            return Self::rotation_sin_cos(0.0, -1.0, axis, center);
        }
        Self::rotation_sin_cos(sin, cos, cross, center)
    }

    /// The reflection in a plane.
    pub fn mirror(plane: &Plane) -> Self {
        let n = plane.z_axis;
        let column = |e: Vector3| e - n * (2.0 * n.dot(e));
        Self::from_columns(column(Vector3::X), column(Vector3::Y), column(Vector3::Z), Point3::ORIGIN)
            .about(plane.origin)
    }

    /// The projection onto a plane at right angles to it.
    pub fn planar_projection(plane: &Plane) -> Self {
        let n = plane.z_axis;
        let column = |e: Vector3| e - n * n.dot(e);
        Self::from_columns(column(Vector3::X), column(Vector3::Y), column(Vector3::Z), Point3::ORIGIN)
            .about(plane.origin)
    }

    /// The projection onto a plane along a direction.
    ///
    /// # Errors
    /// When the direction has no length or lies in the plane.
    pub fn projection_along(plane: &Plane, direction: Vector3) -> Result<Self> {
        let d = direction.unitized().ok_or(Error::degenerate("direction", "it has no length"))?;
        let n = plane.z_axis;
        let along = n.dot(d);
        if along.abs() < thresholds::NO_DIRECTION {
            return Err(Error::degenerate("direction", "it lies in the plane"));
        }
        let column = |e: Vector3| e - d * (n.dot(e) / along);
        Ok(Self::from_columns(column(Vector3::X), column(Vector3::Y), column(Vector3::Z), Point3::ORIGIN)
            .about(plane.origin))
    }

    /// The shear about a plane's origin with all six coefficients, in the plane's coordinates:
    /// x′ = x + xy·y + xz·z, y′ = yx·x + y + yz·z, z′ = zx·x + zy·y + z, with `coefficients` the rows
    /// [[xy, xz], [yx, yz], [zx, zy]].
    pub fn shear(plane: &Plane, coefficients: [[f64; 2]; 3]) -> Self {
        let [[xy, xz], [yx, yz], [zx, zy]] = coefficients;
        let (x, y, z) = (plane.x_axis, plane.y_axis, plane.z_axis);
        Self::in_frame(plane, x + y * yx + z * zx, x * xy + y + z * zy, x * xz + y * yz + z)
    }

    /// The map from coordinates in a plane to world coordinates.
    pub const fn plane_to_world(plane: &Plane) -> Self {
        Self::from_columns(plane.x_axis, plane.y_axis, plane.z_axis, plane.origin)
    }

    /// The map from world coordinates to coordinates in a plane.
    pub fn world_to_plane(plane: &Plane) -> Self {
        Self::plane_to_plane(plane, &Plane::XY)
    }

    /// The change of coordinates: what `initial` calls (a, b, c) `last` calls the result.
    pub fn change_basis(initial: &Plane, last: &Plane) -> Self {
        Self::world_to_plane(last) * Self::plane_to_world(initial)
    }
}
