//! Where vertices and edges of a control net end up on the surface.

use super::limit::Cage;
use super::{SubD, SubDNet};
use crate::thresholds;
use crate::{Point3, Result, Vector3, cancellation};

/// Steps towards a net whose surface goes through given points.
const STEPS: usize = 400;

impl SubD {
    /// The place of each vertex of the finest net on the surface.
    pub fn vertex_limits(&self) -> Vec<Point3> {
        let mut places = Cage::of(self.net()).subdivided().limit_places();
        places.truncate(self.net().vertices().len());
        places
    }

    /// Points of the surface along an edge of the finest net: 2 to the power of `levels`, from 1 to 6, and one more.
    /// Nothing for an edge that is not there.
    pub fn edge_limits(&self, levels: u32) -> Vec<Vec<Point3>> {
        let levels = levels.clamp(1, 6);
        let mut cage = Cage::of(self.net());
        let count = self.net().edges().len();
        // Half k of an edge is edge 2 i + k of the next cage, and starts at end k of it.
        let mut chains: Vec<Vec<(usize, bool)>> = (0..count).map(|edge| vec![(edge, false)]).collect();
        for _ in 0..levels {
            cage = cage.subdivided();
            for chain in &mut chains {
                let halves = chain.iter().flat_map(|&(edge, backwards)| {
                    let [first, second] = [(2 * edge, false), (2 * edge + 1, true)];
                    if backwards { [(second.0, false), (first.0, true)] } else { [first, second] }
                });
                *chain = halves.collect();
            }
        }
        let places = cage.limit_places();
        let along = |chain: &Vec<(usize, bool)>| {
            let ends = |&(edge, backwards): &(usize, bool)| {
                let [a, b] = cage.ends(edge)?;
                Some(if backwards { [b, a] } else { [a, b] })
            };
            let mut vertices: Vec<usize> = chain.iter().filter_map(|half| Some(ends(half)?[0])).collect();
            vertices.extend(chain.last().and_then(|half| Some(ends(half)?[1])));
            vertices.into_iter().filter_map(|v| places.get(v).copied()).collect()
        };
        chains.iter().map(along).collect()
    }
}

impl SubDNet {
    /// The net moved so that its surface goes through where its vertices were, by repeated correction, and how far
    /// it misses them at most. Few nets, such as the eight corners of a cube moved in and out in turn, cannot.
    ///
    /// # Errors
    /// A coordinate overflows.
    pub fn interpolating(self) -> Result<(Self, f64)> {
        let wanted: Vec<Point3> = self.vertices.iter().map(|v| v.point).collect();
        let mut subd = SubD::new(self);
        let size = wanted
            .first()
            .map_or(0.0, |first| wanted.iter().map(|p| p.distance_to(*first)).fold(0.0, f64::max));
        let mut best = (f64::INFINITY, subd.net().clone());
        for _ in 0..STEPS {
            // A net of four times as many faces.
            cancellation::room::<[u64; 160]>(wanted.len())?;
            let found = subd.vertex_limits();
            let steps: Vec<Vector3> = wanted.iter().zip(&found).map(|(w, f)| *w - *f).collect();
            let miss = steps.iter().map(|s| s.length()).fold(0.0, f64::max);
            if miss < best.0 {
                best = (miss, subd.net().clone());
            }
            if miss <= thresholds::ROUNDING * size || !miss.is_finite() {
                break;
            }
            let mut net = subd.net().clone();
            for (vertex, step) in net.vertices.iter_mut().zip(steps) {
                vertex.point += step;
            }
            subd = SubD::new(net);
        }
        let net = Self::from_parts(best.1.vertices, best.1.edges, best.1.faces)?;
        Ok((net, best.0))
    }
}

#[cfg(test)]
mod tests {
    use crate::subd::{FromMesh, SubD, SubDNet};
    use crate::{Mesh, Plane, Point3};

    #[test]
    fn edges_run_from_vertex_to_vertex() {
        let net =
            SubDNet::from_mesh(&Mesh::sphere(&Plane::XY, 2.0, 6, 4).unwrap(), &FromMesh::default()).unwrap();
        let subd = SubD::new(net);
        let (places, chains) = (subd.vertex_limits(), subd.edge_limits(3));
        for (edge, chain) in subd.net().edges().iter().zip(&chains) {
            assert_eq!(chain.len(), 9);
            for (vertex, point) in edge.vertices.iter().zip([chain[0], chain[8]]) {
                assert!(places[*vertex].distance_to(point) < 1e-9);
            }
            let longest = chain.windows(2).map(|w| w[0].distance_to(w[1])).fold(0.0, f64::max);
            assert!(longest < 0.6 && longest > 0.0);
        }
    }

    #[test]
    fn surfaces_go_through_points() {
        let net =
            SubDNet::from_mesh(&Mesh::sphere(&Plane::XY, 2.0, 8, 6).unwrap(), &FromMesh::default()).unwrap();
        let (net, miss) = net.interpolating().unwrap();
        assert!(miss < 1e-6, "{miss}");
        for place in SubD::new(net).vertex_limits() {
            assert!((place.distance_to(Point3::ORIGIN) - 2.0).abs() < 1e-5);
        }
    }
}
