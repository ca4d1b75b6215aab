//! Where polynomials over patches are zero: parts of a patch, by the Bernstein coefficients of a function over it, such as
//! the distance from a plane.

use super::thresholds::{LAST_STEP, OF_LARGEST, OF_NOISE, SAME_CUT};
use crate::polynomial::Polynomial;

/// A part is not split further than this.
const DEEPEST: u32 = 44;
/// Not quite in the middle, so that splits do not fall on the zeros where that lies in the middle.
const SPLIT: f64 = 0.486_137;

/// More parts of a patch than this and a search is lost.
const MOST: usize = 100_000;

/// A part of a patch.
#[derive(Debug, Clone)]
pub(crate) struct Cell {
    patch: usize,
    /// Its range of the surface's parameters.
    ranges: [[f64; 2]; 2],
    /// The numbers of coefficients along u and v.
    counts: [usize; 2],
    /// The coefficients, v running fastest.
    values: Vec<f64>,
    depth: u32,
}

/// A stretch of the zeros: over one parameter of a cell a graph of the other.
#[derive(Debug, Clone)]
pub(crate) struct Stretch {
    cell: Cell,
    /// The parameter that runs.
    over: usize,
    /// Its range, in 0…1 of the cell.
    range: [f64; 2],
}

impl Cell {
    /// The whole of a patch: its number, its ranges of the surface's parameters, and the coefficients, `counts` of them
    /// along u and v, v running fastest.
    pub(crate) fn new(patch: usize, ranges: [[f64; 2]; 2], counts: [usize; 2], values: Vec<f64>) -> Self {
        Self { patch, ranges, counts, values, depth: 0 }
    }

    /// Whether the function has no zeros here, or does not pass through.
    pub(crate) fn is_clear(&self, noise: f64) -> bool {
        self.values.iter().all(|&v| v >= -noise) || self.values.iter().all(|&v| v <= noise)
    }

    /// The coefficients along `direction` in row `k` of the other one.
    fn row(&self, direction: usize, k: usize) -> Vec<f64> {
        let m = self.counts[1];
        (0..self.counts[direction])
            .map(|i| if direction == 0 { i * m + k } else { k * m + i })
            .map(|i| self.values.get(i).copied().unwrap_or(0.0))
            .collect()
    }

    /// How much the function changes along one parameter in all, and whether it grows or falls all along it.
    fn change(&self, direction: usize, noise: f64) -> (f64, bool) {
        let (mut total, mut up, mut down) = (0.0, true, true);
        for k in 0..self.counts[1 - direction] {
            let row = self.row(direction, k);
            for w in row.windows(2) {
                let d = w[1] - w[0];
                total += d.abs();
                up &= d >= -noise;
                down &= d <= noise;
            }
        }
        (total, up || down)
    }

    /// The stretches of the zeros here, when one of the parameters proves to tell it.
    pub(crate) fn graphs(&self, noise: f64) -> Option<Vec<Stretch>> {
        // Differences carry the noise of two coefficients, and must not pass for none where all are small.
        let largest = self.values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let slack = (0.01 * noise).min(OF_LARGEST * largest);
        let changes = [0, 1].map(|d| self.change(d, slack));
        let across = usize::from(changes[1].0 > changes[0].0);
        // One that hardly changes would tell the other badly, even if it does all along.
        let across = [across, 1 - across].into_iter().find(|&d| {
            changes[d].1 && (changes[d].0 > 0.05 * changes[1 - d].0 || self.depth + 8 > DEEPEST)
        })?;
        let over = 1 - across;
        let sides = [0, self.counts[across] - 1].map(|k| Polynomial::new(self.row(over, k)));
        let mut cuts = vec![0.0, 1.0];
        for side in &sides {
            if side.size() > noise {
                cuts.extend(side.roots(OF_NOISE * noise));
            }
        }
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|a, b| *a - *b <= SAME_CUT);
        let mut out: Vec<Stretch> = Vec::new();
        for w in cuts.windows(2) {
            let middle = 0.5 * (w[0] + w[1]);
            let [low, high] = [sides[0].at(middle), sides[1].at(middle)];
            let through = low * high < 0.0;
            // Sides that are zero themselves are looked at by whoever asks.
            let flat = |s: &Polynomial| s.size() <= noise;
            if !through || flat(&sides[0]) || flat(&sides[1]) {
                continue;
            }
            match out.last_mut() {
                Some(last) if last.range[1] == w[0] => last.range[1] = w[1],
                _ => out.push(Stretch { cell: self.clone(), over, range: [w[0], w[1]] }),
            }
        }
        Some(out)
    }

    /// Two parts, split across the parameter along which the function bends more; `None` at the end of all splitting.
    pub(crate) fn split(&self) -> Option<(Self, Self)> {
        if self.depth >= DEEPEST {
            return None;
        }
        let bend = |direction: usize| -> f64 {
            (0..self.counts[1 - direction])
                .map(|k| {
                    let row = self.row(direction, k);
                    let rise = |i: usize| row[i] - row[i - 1];
                    (2..row.len()).map(|i| (rise(i) - rise(i - 1)).abs()).sum::<f64>()
                })
                .sum()
        };
        let (u, v) = (bend(0), bend(1));
        // A twist without any bend is split both ways in turn.
        let twist = u.max(v) <= OF_LARGEST * self.values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let direction = if twist { (self.depth % 2) as usize } else { usize::from(v > u) };
        let (mut low, mut high) = (self.clone(), self.clone());
        let m = self.counts[1];
        for k in 0..self.counts[1 - direction] {
            let at = |i: usize| if direction == 0 { i * m + k } else { k * m + i };
            let mut row = self.row(direction, k);
            let n = row.len();
            for level in 0..n {
                low.values[at(level)] = row[0];
                high.values[at(n - 1 - level)] = row[n - 1 - level];
                for i in 0..n - 1 - level {
                    row[i] = (1.0 - SPLIT) * row[i] + SPLIT * row[i + 1];
                }
            }
        }
        let [a, b] = self.ranges[direction];
        let middle = a + (b - a) * SPLIT;
        (low.ranges[direction], high.ranges[direction]) = ([a, middle], [middle, b]);
        (low.depth, high.depth) = (self.depth + 1, self.depth + 1);
        Some((low, high))
    }
}

impl Stretch {
    /// The index of the patch it lies on.
    pub(crate) fn patch(&self) -> usize {
        self.cell.patch
    }

    /// The place on the surface at a share `x` of the range.
    pub(crate) fn place(&self, x: f64) -> [f64; 2] {
        let across = 1 - self.over;
        let along = self.range[0] + (self.range[1] - self.range[0]) * x;
        let rows: Vec<f64> = (0..self.cell.counts[across])
            .map(|k| Polynomial::new(self.cell.row(self.over, k)).at(along))
            .collect();
        let column = Polynomial::new(rows);
        let (first, last) = (column.at(0.0), column.at(1.0));
        let other = if first == 0.0 {
            0.0
        } else if last == 0.0 {
            1.0
        } else if first * last > 0.0 {
            // At an end of the stretch, to rounding.
            if first.abs() < last.abs() { 0.0 } else { 1.0 }
        } else {
            bisected(&column, first)
        };
        let local = if self.over == 0 { [along, other] } else { [other, along] };
        std::array::from_fn(|d| {
            let [a, b] = self.cell.ranges[d];
            a + (b - a) * local[d]
        })
    }
}

/// The stretches of the zeros within cells, and whether all parts were looked at.
pub(crate) fn stretches(cells: impl IntoIterator<Item = Cell>, noise: f64) -> (Vec<Stretch>, bool) {
    let mut found = Vec::new();
    let mut complete = true;
    for whole in cells {
        let mut budget = MOST;
        let mut stack = vec![whole];
        while let Some(cell) = stack.pop() {
            if cell.is_clear(noise) {
                continue;
            }
            if let Some(mut graphs) = cell.graphs(noise) {
                found.append(&mut graphs);
                continue;
            }
            if budget == 0 {
                complete = false;
                break;
            }
            budget -= 1;
            if let Some((a, b)) = cell.split() {
                stack.extend([b, a]);
            }
        }
    }
    (found, complete)
}

/// The root of a polynomial with values of opposite sign at 0 and 1: false position with halving where that stalls
/// (the Illinois rule).
fn bisected(column: &Polynomial, first: f64) -> f64 {
    let (mut a, mut b) = (0.0, 1.0);
    let (mut fa, mut fb) = (first, column.at(1.0));
    let mut side = 0;
    for step in 0..90 {
        let x = if step % 4 == 3 { 0.5 * (a + b) } else { (a * fb - b * fa) / (fb - fa) };
        let x = if a < x && x < b { x } else { 0.5 * (a + b) };
        let f = column.at(x);
        if f == 0.0 || b - a < LAST_STEP {
            return x;
        }
        if (f < 0.0) == (fa < 0.0) {
            (a, fa) = (x, f);
            if side == 1 {
                fb *= 0.5;
            }
            side = 1;
        } else {
            (b, fb) = (x, f);
            if side == 2 {
                fa *= 0.5;
            }
            side = 2;
        }
    }
    0.5 * (a + b)
}
