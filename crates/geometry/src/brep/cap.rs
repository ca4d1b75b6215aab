//! Planar holes of a brep filled.

use super::build::NewEdge;
use super::flatten::flattened;
use super::planar::{Rim, add_planar_face};
use super::{Brep, Builder};
use crate::brep::thresholds::NO_AREA;
use crate::{Curve, Plane, Point3, Result, Tolerance};

/// How far a rim may be off its plane whatever the tolerance, as a part of its size: holes smaller than the tolerance
/// would lie in any plane.
const FLAT: f64 = 0.01;

/// A closed chain of naked edges, each with whether it is walked backwards, in the sense that a face which fills it
/// must run.
#[derive(Debug, Clone)]
struct Hole {
    edges: Rim,
    plane: Plane,
}

impl Hole {
    /// The rim as one closed curve.
    fn rim(&self) -> Option<Curve> {
        let walked = self.edges.iter().map(|(_, back, c)| if *back { c.reversed() } else { c.clone() });
        let mut joined = crate::join_curves(&walked.collect::<Vec<_>>(), f64::INFINITY, true);
        if joined.len() == 1 { joined.pop() } else { None }
    }

    /// The area of the rim, positive when it runs counter-clockwise about a plane's normal.
    fn area(&self, plane: &Plane) -> f64 {
        let origin = plane.origin;
        let area = |p: Point3, q: Point3| 0.5 * (p - origin).cross(q - origin).dot(plane.z_axis);
        let points = self.polygon();
        points.iter().zip(points.iter().cycle().skip(1)).map(|(p, q)| area(*p, *q)).sum()
    }

    /// Points along the rim.
    fn polygon(&self) -> Vec<Point3> {
        const PLACES: usize = 16;
        let mut out = Vec::new();
        for (_, back, curve) in &self.edges {
            let count = PLACES * curve.pieces().len().min(PLACES);
            let at = |k: usize| {
                let x = k as f64 / count as f64;
                curve.point_at(curve.domain().at(if *back { 1.0 - x } else { x }))
            };
            out.extend((0..count).map(at));
        }
        out
    }
}

impl Brep {
    /// The chains of naked edges, closed ones whole, each edge with whether it is walked backwards: in the sense of
    /// the faces beside them, seen from their front.
    pub fn naked_loops(&self) -> Vec<Vec<(usize, bool)>> {
        let parts = self.parts();
        let mut used = vec![false; parts.edges.len()];
        let mut out = Vec::new();
        for first in self.naked_edges() {
            if used.get(first) != Some(&false) {
                continue;
            }
            let Some(&trim) = parts.edges.get(first).and_then(|e| e.trims.first()) else { continue };
            let behind =
                self.face_of(trim).and_then(|f| parts.faces.get(f)).is_some_and(|face| face.reversed);
            let mut chain = Vec::new();
            let mut here = (trim, if behind { 0 } else { 1 });
            while let Some(own) = parts.trims.get(here.0)
                && let Some(edge) = own.edge
            {
                match used.get_mut(edge) {
                    Some(used @ false) => *used = true,
                    _ => break,
                }
                chain.push((edge, own.reversed == (here.1 == 1)));
                let Some((next, end)) = parts.next_naked(here) else { break };
                here = (next, 1 - end);
            }
            out.push(chain);
        }
        out
    }

    /// Whether a chain of edges ends where it begins.
    fn closes(&self, chain: &[(usize, bool)]) -> bool {
        let end = |(edge, back): (usize, bool), at_end: bool| {
            self.edges()
                .get(edge)
                .and_then(|e| e.vertices.get(usize::from(at_end != back)).copied().flatten())
        };
        match (chain.first(), chain.last()) {
            (Some(first), Some(last)) => {
                end(*first, false).is_some() && end(*first, false) == end(*last, true)
            }
            _ => false,
        }
    }

    /// The brep with every hole that is planar within the tolerance filled by a face, and how many were; what is off by more than a hundredth of its size is not planar. Rims in one
    /// plane that lie inside each other and run in opposite senses become one face with holes. When nothing is left
    /// open the result is a solid with its normals outward.
    ///
    /// # Errors
    /// The tolerance is not above 0, or the brep has faults.
    pub fn capped(&self, tolerance: &Tolerance) -> Result<(Self, usize)> {
        let limit = tolerance.positive_distance()?;
        let live: Vec<usize> = (0..self.faces().len()).collect();
        let whole = self.sub_brep(&live)?;
        let mut holes = Vec::new();
        for chain in whole.naked_loops() {
            if whole.closes(&chain)
                && let Some(hole) = whole.hole(&chain, limit)?
            {
                holes.push(hole);
            }
        }
        if holes.is_empty() {
            return Ok((whole, 0));
        }
        let mut builder = Builder::from_brep(whole);
        let mut count = 0;
        for (plane, loops) in nested(holes, limit) {
            add_planar_face(&mut builder, &plane, &loops)?;
            count += 1;
        }
        Ok((builder.finish(f64::INFINITY)?, count))
    }

    /// The rim of a planar hole, turned to be walked as its filling is.
    fn hole(&self, chain: &[(usize, bool)], limit: f64) -> Result<Option<Hole>> {
        let mut edges = Vec::with_capacity(chain.len());
        for &(edge, back) in chain.iter().rev() {
            let Some(curve) = self.edge_as_curve(edge)? else { return Ok(None) };
            edges.push((NewEdge(edge), !back, curve));
        }
        let mut hole = Hole { edges, plane: Plane::XY };
        let points: Vec<Point3> = hole.edges.iter().flat_map(|(_, _, c)| c.hull_points()).collect();
        let Ok((plane, _)) = Plane::fit(&points) else { return Ok(None) };
        let size = crate::BoundingBox::from_points(points).map_or(0.0, |b| b.diagonal().length());
        let limit = limit.min(FLAT * size);
        let flat = hole.edges.iter().all(|(_, _, c)| {
            let heights = c.extent_along(plane.z_axis);
            let own = plane.origin.to_vector().dot(plane.z_axis);
            (heights.start - own).abs().max((heights.end - own).abs()) <= limit
        });
        // Of a hole that is no wider than a hair some edges may stand upright on the plane.
        for (_, _, curve) in &hole.edges {
            let image = flattened(curve, &plane)?.bounding_box();
            if image.min.coincides(image.max) {
                return Ok(None);
            }
        }
        let area = hole.area(&plane);
        if !flat || !(area.abs() > NO_AREA * size * size) {
            return Ok(None);
        }
        hole.plane = if area < 0.0 { plane.flipped() } else { plane };
        Ok(Some(hole))
    }
}

/// Sorts holes into faces: a plane, the outer rim, and the rims inside it that run the other way about.
fn nested(holes: Vec<Hole>, limit: f64) -> Vec<(Plane, Vec<Rim>)> {
    let sizes: Vec<f64> = holes.iter().map(|hole| hole.area(&hole.plane).abs()).collect();
    let mut order: Vec<usize> = (0..holes.len()).collect();
    order.sort_by(|a, b| sizes[*b].total_cmp(&sizes[*a]));
    let mut outer: Vec<(usize, Vec<usize>)> = Vec::new();
    for &place in &order {
        let hole = &holes[place];
        // The smallest that encloses it is the last found.
        let owner = outer.iter_mut().rev().find(|(big, _)| encloses(&holes[*big], hole, limit));
        match owner {
            Some((_, inner)) => inner.push(place),
            None => outer.push((place, Vec::new())),
        }
    }
    outer
        .into_iter()
        .map(|(big, inner)| {
            let loops = std::iter::once(big).chain(inner).map(|place| holes[place].edges.clone());
            (holes[big].plane, loops.collect())
        })
        .collect()
}

/// Whether a rim lies inside another in the same plane and runs the other way.
fn encloses(big: &Hole, small: &Hole, limit: f64) -> bool {
    let opposite = big.plane.z_axis.dot(small.plane.z_axis) < 0.0;
    let points = small.polygon();
    let size = crate::BoundingBox::from_points(points.iter().copied()).map_or(0.0, |b| b.diagonal().length());
    let limit = limit.min(FLAT * size);
    let flat = points.iter().all(|p| big.plane.signed_distance(*p).abs() <= limit);
    opposite
        && flat
        && big.rim().is_some_and(|rim| {
            points.iter().all(|p| {
                rim.contains_in_plane(*p, &big.plane, limit).is_ok_and(|c| c != crate::Containment::Outside)
            })
        })
}
