//! Rotations by three angles.

use katydid_elementary::Elementary;

use crate::xform::thresholds::{LOCKED, ROTATION};
use crate::{Point3, Vector3, Xform};

/// The rotation about a world axis through the origin.
fn about(angle: f64, axis: usize) -> Xform {
    let (sin, cos) = angle.sine_cosine();
    let mut m = Xform::IDENTITY;
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    m.rows[i][i] = cos;
    m.rows[j][j] = cos;
    m.rows[i][j] = -sin;
    m.rows[j][i] = sin;
    m
}

impl Xform {
    /// Roll about x, then pitch about y, then yaw about z, all about the world's axes and in radians: Z·Y·X.
    pub fn rotation_zyx(yaw: f64, pitch: f64, roll: f64) -> Self {
        about(yaw, 2) * about(pitch, 1) * about(roll, 0)
    }

    /// Euler's angles in the order Z·Y·Z, in radians: first γ about z, then β about y, then α about z.
    pub fn rotation_zyz(alpha: f64, beta: f64, gamma: f64) -> Self {
        about(alpha, 2) * about(beta, 1) * about(gamma, 2)
    }

    /// The orientation by KML's angles in radians, which turn **clockwise**: first roll about y, then tilt about x,
    /// then heading about z (KML reference, *Orientation*).
    pub fn rotation_kml(heading: f64, tilt: f64, roll: f64) -> Self {
        about(-heading, 2) * about(-tilt, 0) * about(-roll, 1)
    }

    /// Yaw, pitch and roll in radians that [`Xform::rotation_zyx`] makes this rotation of; `None` when it is none
    /// within `tolerance`. The pitch is between −π/2 and π/2; straight up or down the roll is 0.
    pub fn yaw_pitch_roll(&self, tolerance: f64) -> Option<[f64; 3]> {
        let r = self.is_rotation(tolerance).then_some(&self.rows)?;
        let cos = r[0][0].hypotenuse(r[1][0]);
        let pitch = (-r[2][0]).arctangent_of(cos);
        Some(if cos <= LOCKED {
            [(-r[0][1]).arctangent_of(r[1][1]), pitch, 0.0]
        } else {
            [r[1][0].arctangent_of(r[0][0]), pitch, r[2][1].arctangent_of(r[2][2])]
        })
    }

    /// Euler's angles α, β, γ in radians that [`Xform::rotation_zyz`] makes this rotation of; `None` when it is none
    /// within `tolerance`. β is between 0 and π; where it is one of these γ is 0.
    pub fn euler_zyz(&self, tolerance: f64) -> Option<[f64; 3]> {
        let r = self.is_rotation(tolerance).then_some(&self.rows)?;
        let sin = r[0][2].hypotenuse(r[1][2]);
        let beta = sin.arctangent_of(r[2][2]);
        Some(if sin <= LOCKED {
            // Turned over, α counts backwards in the first column.
            [(-r[0][1]).arctangent_of(r[1][1]), beta, 0.0]
        } else {
            [r[1][2].arctangent_of(r[0][2]), beta, r[2][1].arctangent_of(-r[2][0])]
        })
    }

    /// Heading, tilt and roll in radians that [`Xform::rotation_kml`] makes this rotation of; `None` when it is none
    /// within `tolerance`. The tilt is between −π/2 and π/2; at these ends the roll is 0.
    pub fn kml_angles(&self, tolerance: f64) -> Option<[f64; 3]> {
        let r = self.is_rotation(tolerance).then_some(&self.rows)?;
        let cos = r[0][1].hypotenuse(r[1][1]);
        let tilt = -r[2][1].arctangent_of(cos);
        Some(if cos <= LOCKED {
            [-r[1][0].arctangent_of(r[0][0]), tilt, 0.0]
        } else {
            [-(-r[0][1]).arctangent_of(r[1][1]), tilt, -(-r[2][0]).arctangent_of(r[2][2])]
        })
    }

    /// The map from a surface's texture space to a picture's: move by −offset, turn by the angles of `rotation`
    /// about x, then y, then z (radians), scale by `repeat`.
    pub fn texture_mapping(offset: Vector3, repeat: Vector3, rotation: Vector3) -> Self {
        Self::diagonal(repeat.x, repeat.y, repeat.z)
            * Self::rotation_zyx(rotation.z, rotation.y, rotation.x)
            * Self::translation(-offset)
    }

    /// Offset, repeat and rotation that [`Xform::texture_mapping`] makes this map of, with positive repeats; `None`
    /// when it is not a move, a turn and a scale along the axes in this order.
    pub fn decompose_texture_mapping(&self) -> Option<[Vector3; 3]> {
        if !(self.is_affine() && self.is_finite()) {
            return None;
        }
        let rows: [Vector3; 3] =
            std::array::from_fn(|i| Vector3::new(self.rows[i][0], self.rows[i][1], self.rows[i][2]));
        let repeat = Vector3::new(rows[0].length(), rows[1].length(), rows[2].length());
        let [a, b, c] = [rows[0].unitized()?, rows[1].unitized()?, rows[2].unitized()?];
        let turn = Self::from_columns(a, b, c, Point3::ORIGIN).transposed();
        let [z, y, x] = turn.yaw_pitch_roll(ROTATION)?;
        let inverse = self.inverse()?;
        let offset = Vector3::new(inverse.rows[0][3], inverse.rows[1][3], inverse.rows[2][3]);
        Some([offset, repeat, Vector3::new(x, y, z)])
    }
}

#[cfg(test)]
mod tests {
    use crate::{Vector3, Xform};

    fn near(a: &Xform, b: &Xform) -> bool {
        a.rows.as_flattened().iter().zip(b.rows.as_flattened()).all(|(x, y)| (x - y).abs() < 1e-13)
    }

    #[test]
    fn angles_come_back() {
        for [a, b, c] in
            [[0.3, 0.4, -1.2], [-2.9, -1.5, 3.0], [1.0, std::f64::consts::FRAC_PI_2, 0.5], [0.0; 3]]
        {
            let m = Xform::rotation_zyx(a, b, c);
            let [x, y, z] = m.yaw_pitch_roll(1e-9).unwrap();
            assert!(near(&m, &Xform::rotation_zyx(x, y, z)));
            let m = Xform::rotation_zyz(a, b, c);
            let [x, y, z] = m.euler_zyz(1e-9).unwrap();
            assert!(near(&m, &Xform::rotation_zyz(x, y, z)));
            let m = Xform::rotation_kml(a, b, c);
            let [x, y, z] = m.kml_angles(1e-9).unwrap();
            assert!(near(&m, &Xform::rotation_kml(x, y, z)), "{a} {b} {c}");
        }
        let over = Xform::rotation_zyz(0.7, std::f64::consts::PI, 0.2);
        let [x, y, z] = over.euler_zyz(1e-9).unwrap();
        assert!(near(&over, &Xform::rotation_zyz(x, y, z)));
        // A quarter turn of heading looks from north (y) to east (x).
        let east = Xform::rotation_kml(std::f64::consts::FRAC_PI_2, 0.0, 0.0).vector(Vector3::Y);
        assert!((east - Vector3::X).length() < 1e-15);
        assert_eq!(Xform::scale(crate::Point3::ORIGIN, 2.0).yaw_pitch_roll(1e-9), None);
    }

    #[test]
    fn texture_mappings_come_apart() {
        let parts = [Vector3::new(0.5, -2.0, 1.0), Vector3::new(2.0, 3.0, 0.5), Vector3::new(0.3, -0.4, 1.2)];
        let m = Xform::texture_mapping(parts[0], parts[1], parts[2]);
        for (a, b) in m.decompose_texture_mapping().unwrap().iter().zip(parts) {
            assert!((*a - b).length() < 1e-14);
        }
    }
}
