//! Nodes and the struts between them.

use crate::subd::thresholds::SETTLED;
use std::collections::{HashMap, HashSet};

use super::MultiPipe;
use crate::{Curve, Error, Point3, PolylineLimits, Result, Vector3};

/// Points that are joined by straight struts.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MultiPipeNetwork {
    pub(super) nodes: Vec<Point3>,
    pub(super) struts: Vec<[usize; 2]>,
}

/// The most rounds in which radii are evened out.
const ROUNDS: usize = 10_000;

impl MultiPipeNetwork {
    /// The network of lines; ends no farther apart than `tolerance` are one node, lines shorter than it are left out, and
    /// of lines between the same nodes one counts. Lines that cross away from their ends are not joined.
    ///
    /// # Errors
    /// A number is not finite, or the tolerance is not above 0.
    pub fn of_lines(lines: &[[Point3; 2]], tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(Error::OutOfRange {
                what: "tolerance",
                value: tolerance,
                must: "finite and greater than 0",
            });
        }
        let mut network = Self::default();
        let mut places = Places { tolerance, cells: HashMap::new() };
        let mut known = HashSet::new();
        for line in lines {
            if !line.iter().all(|p| p.is_finite()) {
                return Err(Error::NotFinite("line of a network"));
            }
            if line[0].distance_to(line[1]) <= tolerance {
                continue;
            }
            let [a, b] = line.map(|p| places.node(p, &mut network.nodes));
            if a != b && known.insert([a.min(b), a.max(b)]) {
                network.struts.push([a, b]);
            }
        }
        Ok(network)
    }

    /// The straight pieces of curves, end to end: lines and polylines as they are, smooth curves in pieces that turn by
    /// no more than `angle` radians from one to the next.
    ///
    /// # Errors
    /// The angle is not above 0, or too many pieces would be needed.
    pub fn lines_of(curve: &Curve, angle: f64) -> Result<Vec<[Point3; 2]>> {
        let limits =
            PolylineLimits { distance: f64::INFINITY, angle: Some(angle), shortest: 0.0, longest: None };
        let mut points = curve.to_polyline(&limits)?.points().to_vec();
        if curve.is_closed() && points.len() == 3 {
            // There and back again: a loop needs three pieces.
            let domain = curve.domain();
            points = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(|x| curve.point_at(domain.at(x))).to_vec();
        }
        Ok(points.windows(2).map(|w| [w[0], w[1]]).collect())
    }

    /// The nodes.
    pub fn nodes(&self) -> &[Point3] {
        &self.nodes
    }

    /// The struts, by the nodes at their ends.
    pub fn struts(&self) -> &[[usize; 2]] {
        &self.struts
    }

    /// For every node its struts, each with the end at which it is.
    pub(super) fn around(&self) -> Vec<Vec<(usize, usize)>> {
        let mut around = vec![Vec::new(); self.nodes.len()];
        for (strut, ends) in self.struts.iter().enumerate() {
            for (end, node) in ends.iter().enumerate() {
                around[*node].push((strut, end));
            }
        }
        around
    }

    /// The unit direction of a strut away from one of its ends.
    pub(super) fn direction(&self, (strut, end): (usize, usize)) -> Vector3 {
        let ends = self.struts[strut];
        (self.nodes[ends[1 - end]] - self.nodes[ends[end]]).unitized().unwrap_or(Vector3::Z)
    }

    pub(super) fn length(&self, strut: usize) -> f64 {
        let [a, b] = self.struts[strut].map(|node| self.nodes[node]);
        a.distance_to(b)
    }

    /// The radius at every node. Where it is not given it is the mean of those around, weighted by the inverse of the
    /// struts' lengths; parts of the network without a given one take the mean of all given.
    pub(super) fn radii(&self, options: &MultiPipe) -> Vec<f64> {
        let mean = options.radii.iter().sum::<f64>() / options.radii.len().max(1) as f64;
        let mut radii = vec![mean; self.nodes.len()];
        if options.radii.len() < 2 {
            return radii;
        }
        let mut given = vec![false; self.nodes.len()];
        for (point, radius) in options.size_points.iter().zip(&options.radii) {
            let far = |node: &usize| self.nodes[*node].distance_to(*point);
            let nearest = (0..self.nodes.len()).min_by(|a, b| far(a).total_cmp(&far(b)));
            if let Some(node) = nearest {
                (radii[node], given[node]) = (*radius, true);
            }
        }
        let around = self.around();
        for _ in 0..ROUNDS {
            let mut moved = 0.0_f64;
            for node in (0..radii.len()).filter(|n| !given[*n]) {
                let (mut sum, mut weights) = (0.0, 0.0);
                for &(strut, end) in &around[node] {
                    let weight = 1.0 / self.length(strut);
                    sum += weight * radii[self.struts[strut][1 - end]];
                    weights += weight;
                }
                let new = if weights > 0.0 { sum / weights } else { mean };
                moved = moved.max((new - radii[node]).abs());
                radii[node] = new;
            }
            if moved <= SETTLED * mean {
                break;
            }
        }
        radii
    }
}

/// Points by the cells of a grid, to find those in one place.
struct Places {
    tolerance: f64,
    cells: HashMap<[i64; 3], Vec<usize>>,
}

impl Places {
    /// The node at a point, a new one if there is none yet.
    fn node(&mut self, p: Point3, nodes: &mut Vec<Point3>) -> usize {
        let cell = [p.x, p.y, p.z].map(|x| (x / (2.0 * self.tolerance)).floor() as i64);
        for x in -1..=1 {
            for y in -1..=1 {
                for z in -1..=1 {
                    let near =
                        [cell[0].saturating_add(x), cell[1].saturating_add(y), cell[2].saturating_add(z)];
                    let known = self.cells.get(&near).into_iter().flatten();
                    if let Some(node) = known.copied().find(|n| nodes[*n].distance_to(p) <= self.tolerance) {
                        return node;
                    }
                }
            }
        }
        nodes.push(p);
        self.cells.entry(cell).or_default().push(nodes.len() - 1);
        nodes.len() - 1
    }
}
