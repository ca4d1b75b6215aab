//! How far trims are from their edges, and edges from their vertices.

use super::{Edge, Parts, Trim};
use crate::{Brep, ClosestOnCurve, Curve, Point3};

/// Below this part of the coordinates a distance is rounding.
const ROUNDING: f64 = 1e-12;
/// Places looked at in each smooth piece of a trim or edge.
const PLACES: usize = 6;
/// At most so many places of an edge are looked at.
const MOST_PLACES: usize = 400;

impl Parts {
    /// Sets the tolerances of edges to the greatest distance of an image of their trims, of vertices to that of the
    /// ends of edges, and those of trims to 0.
    pub fn measure_tolerances(&mut self) {
        let measured: Vec<f64> = self.edges.iter().map(|edge| self.measured(edge)).collect();
        for (edge, tolerance) in self.edges.iter_mut().zip(measured) {
            edge.tolerance = tolerance;
        }
        self.trims.iter_mut().for_each(|trim| trim.tolerance = [0.0; 2]);
        let spread: Vec<f64> = (0..self.vertices.len()).map(|vertex| self.spread(vertex)).collect();
        for (vertex, spread) in self.vertices.iter_mut().zip(spread) {
            vertex.tolerance = spread;
        }
    }

    /// The greatest distance between an edge and the images of its trims, as far as samples tell.
    fn measured(&self, edge: &Edge) -> f64 {
        let Some(curve) = self.edge_curve(edge) else { return 0.0 };
        let trims = edge.trims.iter().filter_map(|t| self.trims.get(*t));
        trims.map(|trim| self.distance(trim, edge, curve)).fold(0.0, f64::max)
    }

    /// The greatest distance of the image of a trim from its edge, which is a part of the curve given, as far as samples
    /// tell; 0 when it is no more than rounding.
    pub(super) fn distance(&self, trim: &Trim, edge: &Edge, space: &Curve) -> f64 {
        let (Some(flat), Some(surface)) = (self.trim_curve(trim), self.trim_surface(trim)) else {
            return 0.0;
        };
        let straight = matches!((flat, space), (Curve::Line(_), Curve::Line(_))) && surface.is_affine();
        let count = if straight {
            // What is apart changes evenly from end to end.
            1
        } else {
            let pieces = flat.pieces().len() + space.pieces().len();
            (PLACES * pieces).clamp(2 * PLACES, MOST_PLACES)
        };
        let mut index: Option<ClosestOnCurve<'_>> = None;
        let mut worst = 0.0_f64;
        for k in 0..=count {
            let x = k as f64 / count as f64;
            let uv = trim.part.point_at(flat, trim.part.domain.at(x));
            let image = surface.point_at(uv.x, uv.y);
            let t = edge.part.domain.at(if trim.reversed { 1.0 - x } else { x });
            let apart = edge.part.point_at(space, t).distance_to(image);
            let rounding = ROUNDING * image.to_vector().length();
            if apart <= rounding.max(worst) {
                continue;
            }
            // Equal parameters need not be equal places.
            let index = index.get_or_insert_with(|| ClosestOnCurve::new(space));
            let nearest = index.nearest(image).map_or(apart, |near| near.distance);
            let end = k == 0 || k == count;
            let apart = if end && edge.vertices[0] != edge.vertices[1] { apart } else { apart.min(nearest) };
            if apart > rounding {
                worst = worst.max(apart);
            }
        }
        worst
    }

    /// The greatest distance between a vertex and the ends of edges and singular trims there.
    fn spread(&self, place: usize) -> f64 {
        let Some(vertex) = self.vertices.get(place) else { return 0.0 };
        let rounding = ROUNDING * vertex.point.to_vector().length();
        let mut worst = 0.0_f64;
        let mut add = |p: Point3| {
            let apart = vertex.point.distance_to(p);
            if apart > rounding {
                worst = worst.max(apart);
            }
        };
        for edge in vertex.edges.iter().filter_map(|e| self.edges.get(*e)) {
            let Some(curve) = self.edge_curve(edge) else { continue };
            let ends = [edge.part.domain.start, edge.part.domain.end];
            for (end, t) in edge.vertices.iter().zip(ends) {
                if *end == Some(place) {
                    add(edge.part.point_at(curve, t));
                }
            }
        }
        worst
    }
}

impl Brep {
    /// The greatest distance between an edge and the images of its trims on their surfaces, as far as samples along
    /// them tell; 0 when it is no more than rounding.
    pub fn edge_deviation(&self, edge: usize) -> Option<f64> {
        let parts = self.parts();
        Some(parts.measured(parts.edges.get(edge)?))
    }
}
