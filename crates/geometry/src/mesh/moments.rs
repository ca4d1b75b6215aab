//! Areas and volumes of meshes with their moments, exactly.

use super::Mesh;
use crate::{Error, MassProperties, Point3, Result, Vector3};

/// The products xx, yy, zz, xy, yz and zx.
fn products(p: Vector3) -> [f64; 6] {
    [p.x * p.x, p.y * p.y, p.z * p.z, p.x * p.y, p.y * p.z, p.z * p.x]
}

/// The integrals of 1, x, y, z and of the products over triangles, or over tetrahedra from the origin (the last
/// corner), where each holds `amount`: the mean of a quadratic over a simplex follows from its corners.
fn simplex(amount: f64, corners: [Vector3; 3], count: f64) -> [f64; 10] {
    let sum = corners[0] + corners[1] + corners[2];
    let first = sum * (amount / count);
    let mut second = products(sum);
    for corner in corners {
        second.iter_mut().zip(products(corner)).for_each(|(s, v)| *s += v);
    }
    let [xx, yy, zz, xy, yz, zx] = second.map(|v| v * amount / (count * (count + 1.0)));
    [amount, first.x, first.y, first.z, xx, yy, zz, xy, yz, zx]
}

impl Mesh {
    /// The area of all triangles with its centroid and moments, exact but for rounding.
    ///
    /// # Errors
    /// The mesh has no area, or a number overflows.
    pub fn area_properties(&self) -> Result<MassProperties> {
        self.summed(2, |[a, b, c]| simplex(0.5 * (b - a).cross(c - a).length(), [a, b, c], 3.0))
    }

    /// The volume inside a closed mesh with its centroid and moments, exact but for rounding, whichever way its faces
    /// look. For an open mesh the numbers mean nothing.
    ///
    /// # Errors
    /// The mesh has no volume, or a number overflows.
    pub fn volume_properties(&self) -> Result<MassProperties> {
        self.summed(3, |[a, b, c]| simplex(a.dot(b.cross(c)) / 6.0, [a, b, c], 4.0))
    }

    fn summed(&self, dimension: i32, of: impl Fn([Vector3; 3]) -> [f64; 10]) -> Result<MassProperties> {
        let bounds = self.bounding_box().ok_or(Error::degenerate("mesh", "it has no vertices"))?;
        let centre: Point3 = bounds.center();
        let size = (0.5 * bounds.diagonal().length()).max(f64::MIN_POSITIVE);
        let mut sum = [0.0; 10];
        for triangle in self.triangles() {
            let part = of(triangle.map(|p| (p - centre) / size));
            sum.iter_mut().zip(part).for_each(|(s, v)| *s += v);
        }
        MassProperties::of_integrals(sum, 0.0, centre, size, dimension)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Box3, Interval, Mesh, Plane, Point3, Vector3};

    #[test]
    fn boxes() {
        let plane = Plane::XY.with_origin(Point3::new(1e3, -5.0, 7.0));
        let shape = Box3 {
            plane,
            x: Interval::new(-1.0, 1.0),
            y: Interval::new(-2.0, 2.0),
            z: Interval::new(-3.0, 3.0),
        };
        let mesh = Mesh::cuboid(&shape, 2, 3, 1).unwrap();
        let body = mesh.volume_properties().unwrap();
        assert!((body.amount - 48.0).abs() < 1e-10 && body.centroid.distance_to(plane.origin) < 1e-10);
        for (moment, want) in body.second_moments.into_iter().zip([16.0, 64.0, 144.0, 0.0, 0.0, 0.0]) {
            assert!((moment - want).abs() < 1e-9, "{moment} {want}");
        }
        assert_eq!(mesh.flipped().volume_properties().unwrap().amount, body.amount);
        let skin = mesh.area_properties().unwrap();
        assert!((skin.amount - 88.0).abs() < 1e-10);
        // Two sides of 24 at distance 1, and four whose x runs from −1 to 1.
        assert!((skin.second_moments[0] - (48.0 + 40.0 / 3.0)).abs() < 1e-9);
        let about = body.inertia_about(plane.origin + Vector3::new(0.0, 0.0, 2.0));
        assert!((about.x - (64.0 + 144.0 + 48.0 * 4.0)).abs() < 1e-8 && (about.z - 80.0).abs() < 1e-8);
        assert!((body.gyration_about(plane.origin).z - (80.0_f64 / 48.0).sqrt()).abs() < 1e-12);
        assert!(Mesh::default().area_properties().is_err());
    }
}
