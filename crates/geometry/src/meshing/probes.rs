//! Bounds of a surface's bending on a grid of rectangles, and the greatest of them over any range.

use super::bend::{Bend, Bender};

/// Bounds on a grid of rectangles of their own.
pub(super) struct Probes {
    pub(super) lines: [Vec<f64>; 2],
    /// The bounds of every rectangle, v running fastest, and then those of squares of two by two, four by four and so on.
    levels: Vec<Level>,
}

/// Bounds of squares of so many rectangles.
struct Level {
    counts: [usize; 2],
    bends: Vec<Bend>,
}

impl Level {
    fn at(&self, i: usize, j: usize) -> Bend {
        self.bends.get(i * self.counts[1] + j).copied().unwrap_or_default()
    }

    /// The squares of two by two of these; what is left over at the ends is in none.
    fn halved(&self) -> Self {
        let counts = self.counts.map(|n| n / 2);
        let mut bends = Vec::with_capacity(counts[0] * counts[1]);
        for i in 0..counts[0] {
            for j in 0..counts[1] {
                let pair = |i: usize| self.at(i, 2 * j).max(&self.at(i, 2 * j + 1));
                bends.push(pair(2 * i).max(&pair(2 * i + 1)));
            }
        }
        Self { counts, bends }
    }
}

impl Probes {
    pub(super) fn new(bender: &Bender<'_>, lines: [Vec<f64>; 2]) -> Self {
        let mut bends = Vec::with_capacity(lines[0].len() * lines[1].len());
        for u in lines[0].windows(2) {
            for v in lines[1].windows(2) {
                bends.push(bender.over([[u[0], u[1]], [v[0], v[1]]]));
            }
        }
        Self::of(lines, bends)
    }

    fn of(lines: [Vec<f64>; 2], bends: Vec<Bend>) -> Self {
        let counts = lines.each_ref().map(|list| list.len().saturating_sub(1));
        let mut levels = vec![Level { counts, bends }];
        while let Some(last) = levels.last()
            && last.counts.iter().all(|&n| n > 3)
        {
            let next = last.halved();
            levels.push(next);
        }
        Self { lines, levels }
    }

    /// The bounds of all rectangles, v running fastest.
    pub(super) fn bends(&self) -> &[Bend] {
        self.levels.first().map_or(&[], |level| &level.bends)
    }

    /// The rectangles that a range of parameters reaches into.
    pub(super) fn reached(&self, d: usize, [from, to]: [f64; 2]) -> [usize; 2] {
        let lines = &self.lines[d];
        let last = lines.len().saturating_sub(2);
        let start = lines.partition_point(|&t| t <= from).saturating_sub(1).min(last);
        let end = lines.partition_point(|&t| t < to).saturating_sub(1).min(last);
        [start, end.max(start)]
    }

    /// The greatest bounds of the rectangles that one reaches into.
    pub(super) fn over(&self, rectangle: [[f64; 2]; 2]) -> Bend {
        // From the first up to the one behind the last.
        let mut ranges = [0, 1].map(|d| {
            let [first, last] = self.reached(d, rectangle[d]);
            [first, last + 1]
        });
        let mut out = Bend::default();
        let top = self.levels.len() - 1;
        for (k, level) in self.levels.iter().enumerate() {
            let mut include = |[u, v]: [[usize; 2]; 2]| {
                for i in u[0]..u[1] {
                    for j in v[0]..v[1] {
                        out = out.max(&level.at(i, j));
                    }
                }
            };
            if k == top {
                include(ranges);
                break;
            }
            // Rows and columns that fill no square of the next level by themselves.
            for d in 0..2 {
                if ranges[d][0] < ranges[d][1] && ranges[d][0] % 2 == 1 {
                    let mut strip = ranges;
                    strip[d][1] = strip[d][0] + 1;
                    include(strip);
                    ranges[d][0] += 1;
                }
                if ranges[d][0] < ranges[d][1] && ranges[d][1] % 2 == 1 {
                    let mut strip = ranges;
                    strip[d][0] = strip[d][1] - 1;
                    include(strip);
                    ranges[d][1] -= 1;
                }
            }
            if ranges.iter().any(|[from, to]| from >= to) {
                break;
            }
            ranges = ranges.map(|range| range.map(|n| n / 2));
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::Probes;
    use crate::meshing::bend::Bend;

    #[test]
    fn the_greatest_of_every_range() {
        for [n, m] in [[1, 1], [3, 5], [9, 4], [37, 22]] {
            let lines = [n, m].map(|count| (0..=count).map(f64::from).collect::<Vec<_>>());
            let noise = |k: i32| f64::from((k * 7919 + 104_729) % 1009);
            let bends: Vec<Bend> =
                (0..n * m).map(|k| Bend { off: [noise(k), noise(k + 1), 0.0], ..Bend::default() }).collect();
            let probes = Probes::of(lines, bends.clone());
            for k in 0..400 {
                let pair = |a: i32, b: i32, most: i32| [a.min(b) % most, a.max(b) % most];
                let [a, b] = pair(k * 13, k * 29 + 5, n);
                let [c, d] = pair(k * 17 + 3, k * 31, m);
                let (a, b, c, d) = (a.min(b), a.max(b), c.min(d), c.max(d));
                let mut want = Bend::default();
                for i in a..=b {
                    for j in c..=d {
                        want = want.max(&bends[(i * m + j) as usize]);
                    }
                }
                let inside = |x: i32, y: i32| [f64::from(x) + 0.25, f64::from(y) + 0.75];
                assert_eq!(probes.over([inside(a, b), inside(c, d)]), want, "{n} {m} {a} {b} {c} {d}");
            }
        }
    }
}
