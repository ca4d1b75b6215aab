//! From a box into a twisted box, and onto a surface.

use super::patch::Sheet;
use super::{Morph, finite};
use crate::{Box3, Error, Interval, Point3, Result, Surface, TwistedBox};

/// The place of a point in a box as fractions of its sides; 0 along a side without length.
fn fractions(reference: &Box3, p: Point3) -> [f64; 3] {
    let c = reference.plane.coordinates(p);
    let sides = [reference.x, reference.y, reference.z].map(Interval::ordered);
    std::array::from_fn(|i| if sides[i].is_singleton() { 0.0 } else { sides[i].normalized(c[i]) })
}

fn checked(reference: Box3) -> Result<Box3> {
    let sides = [reference.x, reference.y, reference.z];
    if reference.plane.is_finite() && sides.iter().all(|s| s.is_finite()) {
        Ok(reference)
    } else {
        Err(Error::NotFinite("reference box"))
    }
}

/// From a box into a twisted one: equal fractions of the sides, by [`TwistedBox::at`].
#[derive(Debug, Clone, Copy)]
pub struct BoxMorph {
    reference: Box3,
    target: TwistedBox,
}

impl BoxMorph {
    /// The map that takes the corners of a box to those of a twisted one.
    ///
    /// # Errors
    /// A number that is not finite.
    pub fn new(reference: Box3, target: TwistedBox) -> Result<Self> {
        Ok(Self { reference: checked(reference)?, target: TwistedBox::new(target.corners)? })
    }
}

impl Morph for BoxMorph {
    fn image(&self, p: Point3) -> Result<Point3> {
        let [u, v, w] = fractions(&self.reference, p);
        finite(self.target.at(u, v, w))
    }
}

/// From a box onto a surface: fractions of the box's sides become parameters in two ranges and a height along the
/// normal in a third.
///
/// Beyond an open edge of the surface it goes on along the tangents there, and round a closed one.
#[derive(Debug, Clone)]
pub struct SurfaceMorph {
    reference: Box3,
    sheet: Sheet,
    ranges: [Interval; 3],
}

impl SurfaceMorph {
    /// The map of a box to ranges of u, of v, and of the height above the surface.
    ///
    /// # Errors
    /// A number that is not finite.
    pub fn new(
        reference: Box3,
        surface: &Surface,
        u: Interval,
        v: Interval,
        height: Interval,
    ) -> Result<Self> {
        let ranges = [u, v, height];
        if !ranges.iter().all(|r| r.is_finite()) {
            return Err(Error::NotFinite("domain"));
        }
        Ok(Self { reference: checked(reference)?, sheet: Sheet::new(surface), ranges })
    }
}

impl Morph for SurfaceMorph {
    fn image(&self, p: Point3) -> Result<Point3> {
        let f = fractions(&self.reference, p);
        let [u, v, w] = std::array::from_fn(|i| self.ranges[i].at(f[i]));
        self.sheet.at(u, v, w)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Mesh, Plane, PlaneSurface, Vector3};

    fn unit(height: f64) -> Box3 {
        Box3 {
            plane: Plane::XY,
            x: Interval::new(0.0, 2.0),
            y: Interval::new(0.0, 2.0),
            z: Interval::new(0.0, height),
        }
    }

    #[test]
    fn a_box_into_itself_changes_nothing() {
        let morph = BoxMorph::new(unit(2.0), unit(2.0).into()).unwrap();
        for p in [[0.0; 3], [1.0, 0.5, 0.2], [5.0, -3.0, 4.0]].map(Point3::from) {
            assert!(morph.image(p).unwrap().distance_to(p) < 1e-13);
        }
        let mesh = Mesh::cuboid(&unit(1.0), 2, 2, 2).unwrap();
        let same = mesh.morphed(&morph).unwrap();
        assert!((same.volume() - mesh.volume()).abs() < 1e-12);
        let mut corners = TwistedBox::from(unit(2.0)).corners;
        corners[6] += Vector3::Z;
        let twisted = BoxMorph::new(unit(2.0), TwistedBox { corners }).unwrap();
        let middle = twisted.image(Point3::new(1.0, 1.0, 1.0)).unwrap();
        assert!(middle.distance_to(Point3::new(1.0, 1.0, 1.125)) < 1e-13);
    }

    #[test]
    fn onto_a_plane_it_is_affine() {
        let plane = PlaneSurface::new(Plane::YZ, Interval::new(0.0, 4.0), Interval::new(0.0, 6.0)).unwrap();
        let [u, v] = [Interval::new(0.0, 4.0), Interval::new(0.0, 6.0)];
        let morph = SurfaceMorph::new(unit(2.0), &plane.into(), u, v, Interval::new(0.0, 1.0)).unwrap();
        for [x, y, z] in [[0.0; 3], [1.0, 1.0, 2.0], [3.0, -1.0, 4.0]] {
            let image = morph.image(Point3::new(x, y, z)).unwrap();
            assert!(image.distance_to(Point3::new(0.5 * z, 2.0 * x, 3.0 * y)) < 1e-12);
        }
        // A flat reference lies at the start of the heights.
        let flat = SurfaceMorph::new(unit(0.0), &plane_xy(), Interval::UNIT, Interval::UNIT, Interval::UNIT);
        assert_eq!(flat.unwrap().image(Point3::new(2.0, 2.0, 0.0)).unwrap(), Point3::new(1.0, 1.0, 0.0));
    }

    fn plane_xy() -> Surface {
        PlaneSurface::new(Plane::XY, Interval::UNIT, Interval::UNIT).unwrap().into()
    }
}
