//! The borders of breps as closed curves.

use super::{Brep, LoopKind};
use crate::{Curve, Result, join_curves};

impl Brep {
    /// A loop as curves in space, each in the sense of the loop; sides where the surface is a point are left out.
    /// Nothing for a loop that does not exist.
    ///
    /// # Errors
    /// An edge is too short to be a curve.
    pub fn loop_curves(&self, place: usize) -> Result<Vec<Curve>> {
        let Some(found) = self.loops().get(place) else { return Ok(Vec::new()) };
        let mut curves = Vec::with_capacity(found.trims.len());
        for trim in found.trims.iter().filter_map(|trim| self.trims().get(*trim)) {
            let Some(edge) = trim.edge else { continue };
            if let Some(curve) = self.edge_as_curve(edge)? {
                curves.push(if trim.reversed { curve.reversed() } else { curve });
            }
        }
        Ok(curves)
    }

    /// The naked edges joined where they meet within a tolerance, in the order of the edges: the closed curves that
    /// bound a brep that is not closed. Of one face without seam that is its outer loop first, then its holes.
    ///
    /// # Errors
    /// An edge is too short to be a curve.
    pub fn borders(&self, tolerance: f64) -> Result<Vec<Curve>> {
        if let Some(loops) = self.loops_of_only_face() {
            let rims = loops.into_iter().map(|place| self.loop_curves(place));
            let joined = |rim: Result<Vec<Curve>>| Ok(join_curves(&rim?, tolerance, true));
            return Ok(rims.map(joined).collect::<Result<Vec<_>>>()?.concat());
        }
        let naked = self.naked_edges().into_iter();
        let curves = naked.filter_map(|edge| self.edge_as_curve(edge).transpose());
        Ok(join_curves(&curves.collect::<Result<Vec<_>>>()?, tolerance, false))
    }

    /// The loops of the only face, the outer one first; `None` where there are several faces or a seam, whose loops are
    /// no borders.
    fn loops_of_only_face(&self) -> Option<Vec<usize>> {
        let mut live = self.faces().iter().filter(|face| !face.deleted);
        let (face, None) = (live.next()?, live.next()) else { return None };
        let is_outer = |place: &usize| self.loops().get(*place).is_some_and(|l| l.kind == LoopKind::Outer);
        let naked = self.edges().iter().filter(|edge| !edge.deleted).all(|edge| edge.trims.len() == 1);
        let (outer, inner): (Vec<usize>, Vec<usize>) = face.loops.iter().partition(|place| is_outer(place));
        naked.then(|| [outer, inner].concat())
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::construct::box_brep;
    use crate::{Box3, Circle, Cylinder, Interval, Plane, PlaneSurface, Tolerance};

    fn lengths(brep: &Brep) -> Vec<f64> {
        let borders = brep.borders(0.001).unwrap();
        assert!(borders.iter().all(Curve::is_closed));
        borders.iter().map(Curve::length).collect()
    }

    #[test]
    fn borders_of_faces_and_of_open_and_closed_shells() {
        let side = Interval::new(0.0, 2.0);
        let sheet = Brep::from_surface(PlaneSurface::new(Plane::XY, side, side).unwrap().into()).unwrap();
        assert!((lengths(&sheet)[0] - 8.0).abs() < 1e-12);
        let rings: Vec<Curve> = [1.0, 3.0].map(|radius| Circle { plane: Plane::XY, radius }.into()).to_vec();
        let ring = Brep::planar_faces(&rings, &Tolerance::default()).unwrap().breps.remove(0);
        let found = lengths(&ring);
        assert!((found[0] - 6.0 * PI).abs() < 1e-9 && (found[1] - 2.0 * PI).abs() < 1e-9, "{found:?}");
        let cube = box_brep(&Box3 { plane: Plane::XY, x: side, y: side, z: side }).unwrap();
        assert!(lengths(&cube).is_empty());
        let open = cube.sub_brep(&[0, 1, 2, 3, 4]).unwrap();
        assert!((lengths(&open)[0] - 8.0).abs() < 1e-12);
        let pipe = Cylinder { plane: Plane::XY, radius: 1.0, height: Interval::new(0.0, 3.0) };
        let pipe = Brep::from_surface(pipe.into()).unwrap();
        assert_eq!(lengths(&pipe).len(), 2, "a seam is no border");
    }
}
