//! Ways pulled tight.

use super::Unrolled;
use crate::Vector3;
use crate::surface::thresholds::{FIRST_DAMPING, LEAST_DAMPING};
use crate::thresholds;

type Place = [f64; 2];
type Block = [[f64; 2]; 2];

/// So many points at equal distances along a way of straight steps in the parameters.
pub(super) fn spread(sheet: &Unrolled<'_>, way: &[Place], count: usize) -> Vec<Place> {
    let mut lengths = vec![0.0];
    for w in way.windows(2) {
        let last = lengths.last().copied().unwrap_or(0.0);
        lengths.push(last + sheet.point(w[0]).distance_to(sheet.point(w[1])));
    }
    let total = lengths.last().copied().unwrap_or(0.0);
    let n = count.max(3) - 1;
    (0..=n)
        .map(|k| {
            let s = total * k as f64 / n as f64;
            let i = lengths.partition_point(|&l| l <= s).clamp(1, way.len() - 1);
            let x = ((s - lengths[i - 1]) / (lengths[i] - lengths[i - 1])).clamp(0.0, 1.0);
            let x = if x.is_finite() { x } else { 0.0 };
            let (a, b) = (way[i - 1], way[i]);
            match k {
                0 => way[0],
                k if k == n => way[way.len() - 1],
                _ => [a[0] + (b[0] - a[0]) * x, a[1] + (b[1] - a[1]) * x],
            }
        })
        .collect()
}

/// The way with a point between each two: on a cubic through four neighbours.
pub(super) fn doubled(way: &[Place]) -> Vec<Place> {
    let mut out = Vec::with_capacity(2 * way.len());
    for (i, w) in way.windows(2).enumerate() {
        out.push(w[0]);
        let before = i.checked_sub(1).and_then(|k| way.get(k));
        out.push(match (before, way.get(i + 2)) {
            (Some(a), Some(b)) => std::array::from_fn(|d| (9.0 * (w[0][d] + w[1][d]) - a[d] - b[d]) / 16.0),
            _ => std::array::from_fn(|d| 0.5 * (w[0][d] + w[1][d])),
        });
    }
    out.extend(way.last());
    out
}

fn energy(sheet: &Unrolled<'_>, way: &[Place]) -> f64 {
    let points: Vec<_> = way.iter().map(|uv| sheet.point(*uv)).collect();
    points.windows(2).map(|w| (w[1] - w[0]).length_squared()).sum()
}

/// Moves all points but the ends until the sum of squared steps is least.
pub(super) fn relax(sheet: &Unrolled<'_>, way: &mut Vec<Place>) {
    let n = way.len();
    if n < 3 {
        return;
    }
    // Points that left the domain come back to its side.
    let kept = |x: Place| -> Place {
        std::array::from_fn(|d| if sheet.closed[d] { x[d] } else { sheet.domains[d].clamp(x[d]) })
    };
    for x in way.iter_mut() {
        *x = kept(*x);
    }
    let mut damping = FIRST_DAMPING;
    let mut here = energy(sheet, way);
    for _ in 0..60 {
        let system = System::new(sheet, way);
        let mut moved = None;
        while damping < 1e8 {
            if let Some(steps) = system.solved(damping) {
                let mut next = way.clone();
                for (x, step) in next.iter_mut().skip(1).zip(&steps) {
                    *x = kept([x[0] + step[0], x[1] + step[1]]);
                }
                let there = energy(sheet, &next);
                if there < here {
                    moved = Some((next, there));
                    damping = (damping * 0.2).max(LEAST_DAMPING);
                    break;
                }
            }
            damping *= 8.0;
        }
        let Some((next, there)) = moved else { return };
        let gain = here - there;
        (*way, here) = (next, there);
        if gain <= thresholds::FEW_ROUNDINGS * here {
            return;
        }
    }
}

/// Gradient and second derivatives of half the energy at the inner points.
struct System {
    slopes: Vec<Place>,
    blocks: Vec<Block>,
    /// How much each point's own directions weigh, for the damping.
    weights: Vec<Place>,
    /// The blocks between a point and the next.
    links: Vec<Block>,
}

impl System {
    fn new(sheet: &Unrolled<'_>, way: &[Place]) -> Self {
        let jets: Vec<_> = way.iter().map(|uv| sheet.jet(*uv, 2)).collect();
        let tangents: Vec<[Vector3; 2]> = jets.iter().map(|j| [j.get(1, 0), j.get(0, 1)]).collect();
        let n = way.len() - 2;
        let mut this = Self {
            slopes: Vec::with_capacity(n),
            blocks: Vec::with_capacity(n),
            weights: Vec::with_capacity(n),
            links: Vec::with_capacity(n),
        };
        for i in 1..=n {
            let p = |k: usize| jets[k].point();
            let pull = (p(i) - p(i - 1)) + (p(i) - p(i + 1));
            let t = tangents[i];
            let bends = [[jets[i].get(2, 0), jets[i].get(1, 1)], [jets[i].get(1, 1), jets[i].get(0, 2)]];
            let mut slope: Place = t.map(|t| pull.dot(t));
            let mut block: Block = std::array::from_fn(|a| {
                std::array::from_fn(|b| 2.0 * t[a].dot(t[b]) + pull.dot(bends[a][b]))
            });
            let mut weight: Place = t.map(|t| t.length_squared());
            let mut link: Block =
                std::array::from_fn(|a| std::array::from_fn(|b| -t[a].dot(tangents[i + 1][b])));
            let least = thresholds::ROUNDING * (weight[0] + weight[1]) + f64::MIN_POSITIVE;
            for d in 0..2 {
                let domain = sheet.domains[d];
                let held = !sheet.closed[d]
                    && ((way[i][d] <= domain.start && slope[d] > 0.0)
                        || (way[i][d] >= domain.end && slope[d] < 0.0));
                weight[d] = weight[d].max(least);
                // A point held by a side stays there; one at a pole has no way along it.
                if held || t[d].length_squared() <= least {
                    slope[d] = 0.0;
                    (block[0][1], block[1][0]) = (0.0, 0.0);
                    block[d][d] = weight[d];
                    link[d] = [0.0; 2];
                    if let Some(before) = this.links.last_mut() {
                        for row in before.iter_mut() {
                            row[d] = 0.0;
                        }
                    }
                }
            }
            this.slopes.push(slope);
            this.blocks.push(block);
            this.weights.push(weight);
            this.links.push(link);
        }
        this
    }

    /// The damped Newton step, by elimination from block to block; `None` when the matrix is not positive.
    fn solved(&self, damping: f64) -> Option<Vec<Place>> {
        let n = self.slopes.len();
        let mut inverses: Vec<Block> = Vec::with_capacity(n);
        let mut right: Vec<Place> = Vec::with_capacity(n);
        for i in 0..n {
            let mut block = self.blocks[i];
            for d in 0..2 {
                block[d][d] += damping * self.weights[i][d];
            }
            let mut side = self.slopes[i].map(|s| -s);
            if i > 0 {
                // Subtract linkᵀ · inverse · (link, side) of the one before.
                let (link, inverse) = (self.links[i - 1], inverses[i - 1]);
                let factor: Block = std::array::from_fn(|a| {
                    std::array::from_fn(|b| link[0][a] * inverse[0][b] + link[1][a] * inverse[1][b])
                });
                for a in 0..2 {
                    for b in 0..2 {
                        block[a][b] -= factor[a][0] * link[0][b] + factor[a][1] * link[1][b];
                    }
                    side[a] -= factor[a][0] * right[i - 1][0] + factor[a][1] * right[i - 1][1];
                }
            }
            let determinant = block[0][0] * block[1][1] - block[0][1] * block[1][0];
            if !(block[0][0] > 0.0 && determinant > 0.0 && determinant.is_finite()) {
                return None;
            }
            inverses.push([
                [block[1][1] / determinant, -block[0][1] / determinant],
                [-block[1][0] / determinant, block[0][0] / determinant],
            ]);
            right.push(side);
        }
        let mut out = vec![[0.0; 2]; n];
        for i in (0..n).rev() {
            let mut side = right[i];
            if i + 1 < n {
                for a in 0..2 {
                    side[a] -= self.links[i][a][0] * out[i + 1][0] + self.links[i][a][1] * out[i + 1][1];
                }
            }
            let inverse = inverses[i];
            out[i] = std::array::from_fn(|a| inverse[a][0] * side[0] + inverse[a][1] * side[1]);
        }
        out.iter().flatten().all(|x| x.is_finite()).then_some(out)
    }
}
