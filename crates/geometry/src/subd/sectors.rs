//! What Rhino stores of smooth edges that end on creases, corners and darts.

use super::limit::{Cage, Kind};
use super::{SubDEdgeTag, SubDNet};

impl SubDNet {
    /// The net with the tags and coefficients of such edges as openNURBS asks for them: an edge that is smooth though both
    /// its ends are tagged is [`SubDEdgeTag::SmoothX`], and each tagged end has the coefficient 1/2 + cos(θ)/3, where θ is
    /// the angle that each face takes of its sector (Biermann, Levin and Zorin 2000). What the net says already stays.
    #[must_use]
    pub fn with_sector_coefficients(mut self) -> Self {
        let cage = Cage::of(&self);
        for (at, edge) in self.edges_mut().iter_mut().enumerate() {
            let Some((ends, coefficients)) = cage.coefficients(at) else { continue };
            let tagged = ends.map(|kind| kind != Kind::Smooth);
            match (edge.tag, tagged) {
                (SubDEdgeTag::Smooth, [true, true]) => edge.tag = SubDEdgeTag::SmoothX,
                (SubDEdgeTag::SmoothX, [false, _] | [_, false]) => edge.tag = SubDEdgeTag::Smooth,
                _ => {}
            }
            for end in 0..2 {
                if tagged[end] && edge.sector_coefficients[end] == 0.0 {
                    edge.sector_coefficients[end] = coefficients[end];
                }
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::Point3;

    /// So many triangles around the middle of a half circle.
    fn fan(count: usize) -> SubDNet {
        let on = |k: usize| {
            let (sin, cos) = (PI * k as f64 / count as f64).sin_cos();
            Point3::new(cos, sin, 0.0)
        };
        let points = std::iter::once(Point3::ORIGIN).chain((0..=count).map(on)).collect();
        let polygons: Vec<Vec<usize>> = (0..count).map(|k| vec![0, k + 1, k + 2]).collect();
        SubDNet::from_polygons(points, &polygons).unwrap().with_sector_coefficients()
    }

    #[test]
    fn edges_between_borders() {
        for count in [2, 3, 5] {
            let net = fan(count);
            let inner: Vec<_> = net.edges().iter().filter(|edge| edge.faces.len() == 2).collect();
            assert_eq!(inner.len(), count - 1);
            for edge in inner {
                assert_eq!(edge.tag, SubDEdgeTag::SmoothX);
                for (end, vertex) in edge.vertices.into_iter().enumerate() {
                    let faces = net.vertices()[vertex].faces.len() as f64;
                    let wanted = 0.5 + (PI / faces).cos() / 3.0;
                    assert!((edge.sector_coefficients[end] - wanted).abs() < 1e-15);
                }
            }
            assert_eq!(net.clone().with_sector_coefficients(), net, "nothing changes any more");
        }
    }

    #[test]
    fn edges_inside() {
        let points = (0..16).map(|k| Point3::new(f64::from(k % 4), f64::from(k / 4), 0.0)).collect();
        let corners = (0..9).map(|k| k / 3 * 4 + k % 3);
        let polygons: Vec<Vec<usize>> = corners.map(|c| vec![c, c + 1, c + 5, c + 4]).collect();
        let net = SubDNet::from_polygons(points, &polygons).unwrap().with_sector_coefficients();
        for edge in net.edges() {
            let on_border = edge.vertices.map(|v| net.vertices()[v].edges.len() < 4);
            let wanted = on_border.map(|yes| if yes && edge.faces.len() == 2 { 0.5 } else { 0.0 });
            assert!(
                (0..2).all(|end| (edge.sector_coefficients[end] - wanted[end]).abs() < 1e-15),
                "{edge:?}"
            );
            assert_eq!(edge.tag == SubDEdgeTag::Crease, edge.faces.len() == 1);
        }
    }
}
