//! Surfaces as meshes, and their borders as curves.

use katydid_geometry::{Brep, Curve, Mesh, MeshSettings, Side, Surface, SurfaceMeshing};

use super::{Scene, Shape};

impl Scene {
    /// The scene with facets and edges in the place of breps; nothing when it has no breps.
    pub(crate) fn faceted(&self, tolerance: Option<f64>) -> Option<Self> {
        if !self.things.iter().any(|thing| matches!(thing.shape, Shape::Brep(_))) {
            return None;
        }
        let mut scene = self.clone();
        for thing in &mut scene.things {
            if let Shape::Brep(brep) = &thing.shape {
                let bounds = brep.bounds_of_faces();
                let within = bounds.map_or(self.tolerance, |bounds| self.tolerance_for(tolerance, &bounds));
                thing.shape = Shape::of_brep(brep, within);
            }
        }
        Some(scene)
    }
}

impl Shape {
    /// A brep as facets within a distance, and its edges.
    pub fn of_brep(brep: &Brep, tolerance: f64) -> Self {
        let mesh = brep.mesh(&MeshSettings::within(tolerance)).and_then(|mesh| mesh.to_mesh());
        let edges = 0..brep.edges().len();
        let edges = edges.filter_map(|edge| brep.edge_as_curve(edge).ok().flatten()).collect();
        Self::Faces { facets: mesh.ok().filter(|mesh| !mesh.faces().is_empty()), edges }
    }
}

/// A surface as a mesh within a distance, or as near to that as a mesh of sensible size gets; nothing when there is
/// none at all.
pub(super) fn facets(surface: &Surface, tolerance: f64) -> Option<Mesh> {
    let fine = SurfaceMeshing { max_distance: tolerance, ..SurfaceMeshing::default() };
    let coarse = SurfaceMeshing { refine: false, ..SurfaceMeshing::default() };
    // A surface too large for its tolerance is better shown coarsely than not at all.
    [fine, SurfaceMeshing::default(), coarse]
        .iter()
        .find_map(|meshing| Mesh::from_surface(surface, meshing).ok())
        .filter(|mesh| !mesh.faces().is_empty())
}

/// The sides of a surface that are lines to look at: not the poles, and a seam only once.
pub(super) fn borders(surface: &Surface) -> Vec<Curve> {
    let sides: Vec<Curve> = Side::ALL.iter().filter_map(|side| surface.side_curve(*side).ok()).collect();
    let sizes: Vec<f64> = sides.iter().map(|c| c.bounding_box().diagonal().length()).collect();
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    let mut curves: Vec<Curve> = Vec::new();
    for (curve, size) in sides.into_iter().zip(sizes) {
        let is_pole = size <= 1e-9 * largest;
        if !is_pole && !curves.iter().any(|known| same_place(known, &curve)) {
            curves.push(curve);
        }
    }
    curves
}

/// Whether two curves go through the same points at the same shares of their domains, as the two sides of a seam do.
fn same_place(a: &Curve, b: &Curve) -> bool {
    const SAMPLES: u32 = 8;
    let size = a.bounding_box().diagonal().length();
    (0..=SAMPLES).all(|i| {
        let share = f64::from(i) / f64::from(SAMPLES);
        let [p, q] = [a, b].map(|c| c.point_at(c.domain().at(share)));
        p.distance_to(q) <= 1e-9 * size
    })
}

#[cfg(test)]
mod tests {
    use katydid_geometry::{Interval, Plane, PlaneSurface, Point3, Sphere};

    use super::*;

    #[test]
    fn facets_are_within_the_tolerance() {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 10.0).unwrap().into();
        for tolerance in [0.5, 0.05, 0.005] {
            let mesh = facets(&ball, tolerance).unwrap();
            for center in mesh.face_centers() {
                let depth = 10.0 - center.distance_to(Point3::ORIGIN);
                assert!(depth <= 2.0 * tolerance, "{tolerance}: {depth}");
            }
        }
    }

    #[test]
    fn a_ball_has_one_seam_and_no_poles_a_square_four_sides() {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 10.0).unwrap().into();
        assert_eq!(borders(&ball).len(), 1);
        let unit = Interval::new(0.0, 1.0);
        let square: Surface = PlaneSurface::new(Plane::XY, unit, unit).unwrap().into();
        assert_eq!(borders(&square).len(), 4);
    }
}
