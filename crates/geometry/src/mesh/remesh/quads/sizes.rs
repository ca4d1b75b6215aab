//! How large cells are where.

use crate::mesh::thresholds::FLAT_EVERYWHERE;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

use katydid_elementary::Elementary;

use super::super::net::Net;
use crate::Point3;
use crate::box_tree::{BoxTree, bounds_of};

/// Cells are at most so many times smaller or larger than the mean.
const MOST: f64 = 4.0;
/// Sizes change by at most this part of the distance.
const SLOPE: f64 = 0.25;
/// Rounds of evening out curvature.
const ROUNDS: usize = 3;

/// The sides of cells, as factors of one length.
pub(super) struct Sizes {
    points: Vec<Point3>,
    factors: Vec<f64>,
    tree: BoxTree,
    /// The number of cells as a multiple of that of cells of the one length.
    pub(super) share: f64,
}

impl Sizes {
    /// Cells of one size.
    pub(super) fn even() -> Self {
        Self { points: Vec::new(), factors: Vec::new(), tree: BoxTree::by_place(&[]), share: 1.0 }
    }

    /// Smaller cells where even triangles curve, larger ones where they are flat: sides go with the radius of curvature
    /// to the power of `adaptive`, from 0 to 1. Their number stays that of cells with sides of a length, unless it may
    /// `grow`: then no cell is larger.
    pub(super) fn by_curvature(net: &Net, side: f64, adaptive: f64, grow: bool) -> Self {
        let vertices = net.vertices();
        let mut number = vec![u32::MAX; net.vertex_count()];
        for (&v, k) in vertices.iter().zip(0..) {
            number[v as usize] = k;
        }
        let near: Vec<Vec<u32>> = vertices
            .iter()
            .map(|&v| net.neighbours(v).iter().map(|&w| number[w as usize]).collect())
            .collect();
        let areas: Vec<f64> = vertices.iter().map(|&v| net.area_at(v)).collect();
        let whole = areas.iter().sum::<f64>().max(f64::MIN_POSITIVE);
        let mean = |values: &[f64]| values.iter().zip(&areas).map(|(x, a)| x * a).sum::<f64>() / whole;
        let curvatures = curvatures(net, &vertices, &near);
        let usual = mean(&curvatures);
        let points: Vec<Point3> = vertices.iter().map(|&v| net.at(v)).collect();
        // What is flat everywhere has nothing to adapt to: a turn of a thousandth over a whole cell.
        if !(usual * side > FLAT_EVERYWHERE) {
            return Self::even();
        }
        let most = MOST.raised_to(adaptive);
        let largest = if grow { 1.0 } else { most };
        let factor =
            |k: f64| (usual / k.max(f64::MIN_POSITIVE)).raised_to(adaptive).clamp(1.0 / most, largest);
        let mut factors: Vec<f64> = curvatures.into_iter().map(factor).collect();
        grade(&mut factors, &points, &near, SLOPE / side);
        let inverse: Vec<f64> = factors.iter().map(|f| 1.0 / (f * f)).collect();
        let mut share = mean(&inverse);
        if !grow {
            factors.iter_mut().for_each(|f| *f *= share.sqrt());
            share = 1.0;
        }
        let boxes: Vec<_> = points.iter().map(|&p| bounds_of([p.into()])).collect();
        Self { tree: BoxTree::by_place(&boxes), points, factors, share }
    }

    /// The factor at a place.
    pub(super) fn at(&self, p: Point3) -> f64 {
        let mut best = (f64::INFINITY, 1.0);
        self.tree.visit_near(&p.into(), f64::INFINITY, |i| {
            if let (Some(q), Some(&factor)) = (self.points.get(i), self.factors.get(i)) {
                let d = (*q - p).length_squared();
                if d < best.0 {
                    best = (d, factor);
                }
            }
            best.0
        });
        best.1
    }
}

/// The greatest curvature along the edges at each vertex, evened out; edges that stay are none of the surface's bends.
fn curvatures(net: &Net, vertices: &[u32], near: &[Vec<u32>]) -> Vec<f64> {
    let stays: Vec<bool> = vertices.iter().map(|&v| !net.kept_neighbours(v).is_empty()).collect();
    let normals: Vec<_> = vertices.iter().map(|&v| net.normal_at(v)).collect();
    let at = |k: u32| net.at(vertices[k as usize]);
    let bend = |k: usize, w: u32| {
        let turn = normals[k].angle_to(normals[w as usize]).unwrap_or(0.0);
        turn / at(k as u32).distance_to(at(w)).max(f64::MIN_POSITIVE)
    };
    let mut out: Vec<Option<f64>> = (0..vertices.len())
        .map(|k| {
            let inner = near[k].iter().filter(|&&w| !stays[w as usize]);
            (!stays[k]).then(|| inner.map(|&w| bend(k, w)).fold(0.0, f64::max))
        })
        .collect();
    for _ in 0..ROUNDS {
        out = (0..out.len())
            .map(|k| {
                let own = out[k].into_iter();
                let all = own.chain(near[k].iter().filter_map(|&w| out[w as usize]));
                let (sum, n) = all.fold((0.0, 0.0), |(sum, n), x| (sum + x, n + 1.0));
                (n > 0.0).then(|| sum / n)
            })
            .collect();
    }
    out.into_iter().map(|k| k.unwrap_or(0.0)).collect()
}

/// Lowers factors until none is above a neighbour's by more than a slope times the distance.
fn grade(factors: &mut [f64], points: &[Point3], near: &[Vec<u32>], slope: f64) {
    // Numbers above 0 are in the order of their bits.
    let mut queue: BinaryHeap<Reverse<(u64, u32)>> =
        factors.iter().zip(0..).map(|(f, k)| Reverse((f.to_bits(), k))).collect();
    while let Some(Reverse((bits, k))) = queue.pop() {
        let own = factors[k as usize];
        if bits != own.to_bits() {
            continue;
        }
        for &w in &near[k as usize] {
            let most = own + slope * points[k as usize].distance_to(points[w as usize]);
            if most < factors[w as usize] {
                factors[w as usize] = most;
                queue.push(Reverse((most.to_bits(), w)));
            }
        }
    }
}
