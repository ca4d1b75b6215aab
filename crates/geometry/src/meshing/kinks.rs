//! Lines of a surface that a mesh has to follow.

use crate::{Curve, Direction, Surface};

/// The parameters of one direction at which a surface may have a kink, as its knots tell: where its derivative may
/// jump. Where pieces meet more smoothly bounds of second derivatives hold across, and no line is needed.
pub(super) fn kink_lines(surface: &Surface, direction: Direction) -> Vec<f64> {
    match surface {
        Surface::Plane(_) => Vec::new(),
        Surface::Sum(s) => s.curves().get(direction.index()).map_or_else(Vec::new, of_curve),
        Surface::Revolution(s) if direction == s.angle_direction() => surface.span_parameters(direction),
        Surface::Revolution(s) => of_curve(s.profile()),
        Surface::Nurbs(s) => full(s.knots(direction), s.degree(direction)),
    }
}

/// Those of a curve.
fn of_curve(curve: &Curve) -> Vec<f64> {
    match curve {
        Curve::Line(_) | Curve::Arc(_) => Vec::new(),
        Curve::Polyline(c) => c.parameters().to_vec(),
        Curve::Nurbs(c) => full(c.knots(), c.degree()),
        Curve::Poly(_) => {
            let pieces = curve.pieces();
            pieces.iter().map(|piece| piece.whole.start).collect()
        }
    }
}

/// The knots as often repeated as the degree.
fn full(knots: &[f64], degree: usize) -> Vec<f64> {
    let mut out: Vec<f64> = knots
        .chunk_by(|a, b| a == b)
        .filter(|same| same.len() >= degree)
        .filter_map(|same| same.first().copied())
        .collect();
    out.dedup();
    out
}

#[cfg(test)]
mod tests {
    use crate::construct::{PipeCap, pipe, pipe_variable};
    use crate::{Brep, Curve, Line, Mesh, MeshSettings, NurbsCurve, Point3, Tolerance};

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 0.01, angle: 1_f64.to_radians() }
    }

    /// Settings as Grasshopper's custom ones come: angles of 20 degrees, quads of 1 to 20 at most.
    fn custom() -> MeshSettings {
        MeshSettings {
            relative_tolerance: 0.0,
            max_angle: 20_f64.to_radians(),
            max_aspect: 20.0,
            min_edge: 0.0,
            max_count: 400,
            simple_planes: false,
            ..MeshSettings::default()
        }
    }

    fn closed(brep: &Brep, settings: &MeshSettings) -> Mesh {
        let mesh = brep.mesh(settings).unwrap().welded().unwrap();
        assert!(mesh.is_closed() && mesh.is_oriented());
        mesh
    }

    fn longest(mesh: &Mesh) -> f64 {
        let at = |v: u32| mesh.vertices()[v as usize];
        mesh.edges().iter().map(|e| at(e.vertices[0]).distance_to(at(e.vertices[1]))).fold(0.0, f64::max)
    }

    /// A tube of radius 5 and length 50 within 0.0005 of its size has cells as wide as a chord with that sagitta: 31
    /// around, whole numbers for each quarter; nothing divides them along.
    #[test]
    fn straight_pipes_are_divided_around_only() {
        let line: Curve = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 50.0)).into();
        let brep = pipe(&line, 5.0, PipeCap::Flat, &tolerance()).unwrap();
        let mesh = closed(&brep, &MeshSettings::default());
        assert!((31 * 3 - 4..=160).contains(&mesh.faces().len()), "{}", mesh.faces().len());
        let size = 50_f64.hypot(10.0).hypot(10.0);
        let allowed = 0.5 * 10_f64.powf(-2.95) * size;
        assert!(
            mesh.face_centers()
                .iter()
                .all(|p| 5.0 - p.x.hypot(p.y) <= allowed || p.z.abs() < 1e-9 || p.z > 50.0 - 1e-9)
        );
        let coarse = closed(&brep, &MeshSettings { max_edge: 28.0, min_edge: 10.0, ..custom() });
        assert!(coarse.faces().len() <= 60, "{}", coarse.faces().len());
    }

    /// Tubes thinner than the shortest edge stay tubes.
    #[test]
    fn thin_pipes_stay_closed() {
        let from = Point3::new(0.0, 0.0, 0.0);
        let bent: Curve =
            crate::Arc::through(from, Point3::new(10.0, 3.0, 15.0), Point3::new(0.0, 12.0, 30.0))
                .unwrap()
                .into();
        let straight: Curve = Line::new(from, Point3::new(0.0, 0.0, 30.0)).into();
        for rail in [bent, straight] {
            for radius in [0.01, 0.3, 1.0, 2.0] {
                let brep = pipe(&rail, radius, PipeCap::Flat, &tolerance()).unwrap();
                let settings = MeshSettings { max_edge: 28.0, min_edge: 10.0, ..custom() };
                let mesh = closed(&brep, &settings);
                // A square in the circle has this part of its area.
                let least = 2.0 / std::f64::consts::PI * 0.8;
                let whole = brep.volume_properties(1e-6, || true).unwrap().amount;
                let share = mesh.volume() / whole;
                assert!((least..=1.0).contains(&share), "{radius}: {share}");
                assert!(mesh.faces().len() <= 120, "{radius}: {}", mesh.faces().len());
            }
        }
    }

    /// A pipe's surface has a knot at each place that it was fitted through: they are no lines of its mesh.
    #[test]
    fn smooth_knots_are_no_lines() {
        let points =
            [[0.0, 0.0, 0.0], [20.0, 10.0, 5.0], [40.0, -10.0, 10.0], [60.0, 10.0, 0.0], [80.0, 0.0, 0.0]];
        let rail: Curve = NurbsCurve::clamped_uniform(3, &points.map(Point3::from)).unwrap().into();
        let domain = rail.domain();
        let radii = [(domain.start, 2.0), (domain.at(0.5), 4.0), (domain.end, 3.0)];
        let brep = pipe_variable(&rail, &radii, PipeCap::Flat, &tolerance()).unwrap();
        let coarse = closed(&brep, &MeshSettings { max_edge: 28.0, min_edge: 10.0, ..custom() });
        assert!(coarse.faces().len() <= 80, "{}", coarse.faces().len());
        let fine = closed(&brep, &MeshSettings { max_edge: 2.0, ..custom() });
        // The diagonals of triangles are longer than the sides of quads.
        assert!(longest(&fine) <= 2.0 * 1.5, "{}", longest(&fine));
        assert!(closed(&brep, &custom()).faces().len() <= 500);
        for distance in [0.5, 0.05] {
            let mesh = closed(&brep, &MeshSettings::within(distance));
            let near = crate::brep::ClosestOnBrep::new(std::sync::Arc::new(brep.clone())).unwrap();
            for p in mesh.face_centers() {
                assert!(near.nearest(p).unwrap().point.distance_to(p) <= distance);
            }
        }
    }
}
