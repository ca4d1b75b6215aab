//! Proofs that a part of both domains holds at most one piece of the common curve.
//!
//! Over a box of the four parameters let F be the difference of both surfaces together with the height of their middle
//! along a direction d. The difference of F at two places of the box is M times the difference of the places, where
//! every entry of M lies within bounds of a derivative over the box. When all matrices within these bounds are regular,
//! F takes no value twice: every plane across d holds at most one common point of the box, so that the common curve in
//! the box is a graph over d, without loops (the mean value form of interval Newton methods; A. Neumaier, *Interval
//! Methods for Systems of Equations*, 5.1; for normals T. Sederberg and R. Meyers, *Loop detection in surface patch
//! intersections*, 1988).
//!
//! Where one surface lies on a plane, sphere, cylinder, cone or torus, there are two parameters only.

use super::Pair;
use super::thresholds::ROOM;
use crate::Vector3;
use crate::chart::{Carrier, Chart};

/// A box of the four parameters.
pub(crate) type Box4 = [[f64; 2]; 4];

impl Pair<'_> {
    /// The box grown by a share of its widths on every side, within the domains.
    pub(crate) fn grown(&self, b: Box4, share: f64) -> Box4 {
        std::array::from_fn(|k| {
            let room = share * (b[k][1] - b[k][0]) + ROOM * self.domain(k).length();
            let domain = self.domain(k);
            [(b[k][0] - room).max(domain.start), (b[k][1] + room).min(domain.end)]
        })
    }

    /// Whether each plane across `d` is proved to hold at most one common point of the box.
    pub(crate) fn is_graph(&self, b: Box4, d: Vector3) -> bool {
        match &self.carrier {
            Some((s, carrier)) => {
                let own = 2 * (1 - s);
                self.charts[1 - s].cuts_once([b[own], b[own + 1]], carrier, d)
            }
            None => self.meets_once(b, d),
        }
    }

    fn meets_once(&self, b: Box4, d: Vector3) -> bool {
        let charts = self.charts;
        let jets = self.jets(b.map(|[low, high]| 0.5 * (low + high)));
        let columns = [jets[0][1], jets[0][2], -jets[1][1], -jets[1][2]];
        let mut middle = [[0.0; 4]; 4];
        for (k, column) in columns.into_iter().enumerate() {
            let sign = if k < 2 { 0.5 } else { -0.5 };
            for (i, x) in [column.x, column.y, column.z, sign * d.dot(column)].into_iter().enumerate() {
                middle[i][k] = x;
            }
        }
        let Some(inverse) = inverted(middle) else { return false };
        // With any regular C, all matrices M are regular when |1 − C M| shrinks some positive vector. The rows of C M are the
        // derivatives along vectors: C is applied to the coefficients that bound them, so that it only matters how far these
        // are from each other as C sees them.
        let slopes = [charts[0].slopes_over([b[0], b[1]]), charts[1].slopes_over([b[2], b[3]])];
        let shrink: [[f64; 4]; 4] = std::array::from_fn(|i| {
            let row = Vector3::new(inverse[i][0], inverse[i][1], inverse[i][2]);
            let half = d * (0.5 * inverse[i][3]);
            let sizes = [sum_of_sizes(row) + sum_of_sizes(half); 2];
            let first = slopes[0].along([row + half; 2], sizes);
            let second = slopes[1].along([half - row; 2], sizes);
            let ranges = [first[0], first[1], second[0], second[1]];
            std::array::from_fn(|k| ranges[k].off(if i == k { 1.0 } else { 0.0 }))
        });
        shrinks_some(shrink, b.map(|[low, high]| high - low))
    }
}

impl Chart {
    /// Whether each plane across `d` is proved to hold at most one point of the part of the surface over ranges of the
    /// parameters that lies on a carrier: the same proof for the function of which the carrier is a contour, with the height
    /// along `d`. Its derivatives are those of the surface along the carrier's gradient, which changes no more than so much
    /// over the part.
    fn cuts_once(&self, ranges: [[f64; 2]; 2], carrier: &Carrier, d: Vector3) -> bool {
        let [point, u, v] = self.jet(ranges.map(|[low, high]| 0.5 * (low + high)));
        let out = carrier.gradient(point.to_point());
        let Some(inverse) = inverted([[out.dot(u), out.dot(v)], [d.dot(u), d.dot(v)]]) else { return false };
        let slopes = self.slopes_over(ranges);
        let lengths = slopes.lengths();
        let reach: f64 = (0..2).map(|k| 0.5 * (ranges[k][1] - ranges[k][0]) * lengths[k]).sum();
        let Some(change) = carrier.gradient_change(point.to_point(), reach) else { return false };
        let shrink = inverse.map(|[by_out, by_height]| {
            let parts = [out * by_out, d * by_height];
            let size = sum_of_sizes(parts[0]) + sum_of_sizes(parts[1]);
            let found = slopes.along([parts[0] + parts[1]; 2], [size; 2]);
            [0, 1].map(|k| (found[k], by_out.abs() * change * lengths[k]))
        });
        let shrink = std::array::from_fn(|i| {
            std::array::from_fn(|k| shrink[i][k].0.off(if i == k { 1.0 } else { 0.0 }) + shrink[i][k].1)
        });
        shrinks_some(shrink, ranges.map(|[low, high]| high - low))
    }
}

/// Whether a matrix without negative numbers shrinks some positive vector, sought from one.
fn shrinks_some<const N: usize>(shrink: [[f64; N]; N], from: [f64; N]) -> bool {
    // Towards the vector that is shrunk most evenly; any positive one is a proof.
    let mut z = from.map(|x| x.max(f64::MIN_POSITIVE));
    for _ in 0..6 {
        let next: [f64; N] = std::array::from_fn(|i| (0..N).map(|j| shrink[i][j] * z[j]).sum());
        if (0..N).all(|i| next[i] < 0.9 * z[i]) {
            return true;
        }
        let size = next.iter().fold(0.0, |m: f64, x| m.max(*x));
        if !(size > 0.0) || !size.is_finite() {
            return false;
        }
        let largest = z.iter().fold(0.0, |m: f64, x| m.max(*x));
        z = std::array::from_fn(|i| next[i] / size + 0.1 * z[i] / largest);
    }
    false
}

/// The sum of the sizes of the components.
fn sum_of_sizes(v: Vector3) -> f64 {
    v.x.abs() + v.y.abs() + v.z.abs()
}

/// The inverse of a matrix, by elimination with row pivoting; columns may have units of their own.
fn inverted<const N: usize>(mut a: [[f64; N]; N]) -> Option<[[f64; N]; N]> {
    let mut out: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
    for k in 0..N {
        let best = (k..N).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        a.swap(k, best);
        out.swap(k, best);
        let pivot = a[k][k];
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        for j in 0..N {
            a[k][j] /= pivot;
            out[k][j] /= pivot;
        }
        for i in (0..N).filter(|i| *i != k) {
            let factor = a[i][k];
            for j in 0..N {
                a[i][j] -= factor * a[k][j];
                out[i][j] -= factor * out[k][j];
            }
        }
    }
    out.iter().flatten().all(|x| x.is_finite()).then_some(out)
}
