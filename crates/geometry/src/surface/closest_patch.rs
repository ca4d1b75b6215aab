//! Bézier patches prepared for questions about the squared distance to a point.
//!
//! As for curves: with control points relative to a centre, the squared distance times the squared weight is a
//! polynomial whose Bernstein coefficients are linear in 1, r and r·r, where r is the point asked about from the
//! centre. Coefficients bound it; second differences of them bound its second derivatives.

use super::closest_grid::{convex, halve, multiply};
use crate::MAX_DEGREE;
use crate::bernstein::jet;
use crate::box_tree::{Bounds, bounds_of};
use crate::nurbs::span_to_bezier;
use crate::surface::thresholds::{
    DEFINITE, LIFT, MINIMUM_MARGIN, NARROWEST_SIDE, NEWTON_SMALL, NO_GAIN_STEP, PATCH_NOISE,
};
use crate::{Direction, NurbsSurface};

/// Tables of products are kept for patches with at most this many coefficients; others are multiplied out each time.
const MOST_PRODUCTS: usize = 225;

/// A Bézier patch as a range of tables.
#[derive(Debug, Clone, Copy)]
pub(super) struct Patch {
    degrees: [u16; 2],
    /// Its ranges of u and v.
    pub(super) range: [[f64; 2]; 2],
    centre: [f64; 3],
    /// The largest distance of a control point from the centre.
    radius: f64,
    points: u32,
    /// Where its products start, if it has some.
    products: Option<u32>,
    pub(super) rational: bool,
}

/// All patches of a surface.
#[derive(Debug, Clone, Default)]
pub(super) struct Patches {
    pub(super) list: Vec<Patch>,
    /// Homogeneous control points relative to the centre, v running fastest; the largest weight is 1.
    points: Vec<[f64; 4]>,
    /// The coefficients of |A|², A·w (three) and w².
    products: Vec<[f64; 5]>,
    /// Whether products are kept.
    tables: bool,
}

/// The best point found so far.
#[derive(Debug, Clone, Copy)]
pub(super) struct Best {
    pub(super) squared: f64,
    pub(super) uv: Option<[f64; 2]>,
}

/// What a question needs besides: room for coefficients, and how many ranges may still be looked at.
#[derive(Debug, Default)]
pub(super) struct Work<const C: usize> {
    arena: Vec<[f64; C]>,
    pub(super) budget: u32,
}

fn space(p: &[f64; 4]) -> [f64; 3] {
    [p[0] / p[3], p[1] / p[3], p[2] / p[3]]
}

fn gap(a: [f64; 3], b: [f64; 3]) -> f64 {
    ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2) + (a[2] - b[2]).powi(2)).sqrt()
}

impl Patches {
    /// The patches of a surface, halved where they bend much, and their bounds.
    pub(super) fn of(surface: &NurbsSurface) -> (Self, Vec<Bounds>) {
        let (patches, bounds, _) = Self::cut(surface, true);
        (patches, bounds)
    }

    /// One patch for each pair of spans, those of v running fastest, without tables; and how many spans there are.
    pub(super) fn spans_of(surface: &NurbsSurface) -> (Self, [usize; 2]) {
        let (patches, _, counts) = Self::cut(surface, false);
        (patches, counts)
    }

    fn cut(surface: &NurbsSurface, finely: bool) -> (Self, Vec<Bounds>, [usize; 2]) {
        let (mut patches, mut bounds) = (Self { tables: finely, ..Self::default() }, Vec::new());
        let [p, q] = surface.degrees();
        let (ku, kv) = (surface.knots(Direction::U), surface.knots(Direction::V));
        let [nu, nv] = surface.counts();
        let source = surface.homogeneous_points();
        let spans = |k: &[f64], degree: usize, count: usize| -> Vec<usize> {
            (0..count - degree).filter(|&j| k[j + degree - 1] < k[j + degree]).collect()
        };
        let (us, vs) = (spans(ku, p, nu), spans(kv, q, nv));
        // Few spans may be cut finer.
        let depth = match us.len() * vs.len() {
            _ if !finely => 0,
            0..=16 => 6,
            17..=64 => 4,
            65..=1024 => 2,
            _ => 0,
        };
        let mut column = [[0.0; 4]; MAX_DEGREE + 1];
        let mut points = vec![[0.0; 4]; (p + 1) * (q + 1)];
        for &ju in &us {
            for &jv in &vs {
                for i in 0..=p {
                    let from = (ju + i) * nv + jv;
                    let row = &mut points[i * (q + 1)..(i + 1) * (q + 1)];
                    row.copy_from_slice(&source[from..=from + q]);
                    span_to_bezier(&kv[jv..jv + 2 * q], row);
                }
                for j in 0..=q {
                    for i in 0..=p {
                        column[i] = points[i * (q + 1) + j];
                    }
                    span_to_bezier(&ku[ju..ju + 2 * p], &mut column[..=p]);
                    for i in 0..=p {
                        points[i * (q + 1) + j] = column[i];
                    }
                }
                let range = [[ku[ju + p - 1], ku[ju + p]], [kv[jv + q - 1], kv[jv + q]]];
                patches.push([p, q], points.clone(), range, depth, &mut bounds);
            }
        }
        (patches, bounds, [us.len(), vs.len()])
    }

    fn push(
        &mut self,
        [p, q]: [usize; 2],
        mut points: Vec<[f64; 4]>,
        range: [[f64; 2]; 2],
        depth: u32,
        bounds: &mut Vec<Bounds>,
    ) {
        let at = |i: usize, j: usize| space(&points[i * (q + 1) + j]);
        // How much longer than its chord the longest line of the grid is, in each direction.
        let excess = |lines: usize, steps: usize, point: &dyn Fn(usize, usize) -> [f64; 3]| -> f64 {
            (0..=lines)
                .map(|l| {
                    let way: f64 = (0..steps).map(|k| gap(point(l, k), point(l, k + 1))).sum();
                    way - gap(point(l, 0), point(l, steps)) - 0.04 * way
                })
                .fold(0.0, f64::max)
        };
        if depth > 0 {
            let u = excess(q, p, &|j, i| at(i, j));
            let v = excess(p, q, &|i, j| at(i, j));
            if u > 0.0 || v > 0.0 {
                let mut left = points.clone();
                let d = usize::from(v > u);
                if d == 0 {
                    (0..=q).for_each(|j| halve(&mut points, q + 1, p + 1, j, &mut left));
                } else {
                    (0..=p).for_each(|i| halve(&mut points, 1, q + 1, i * (q + 1), &mut left));
                }
                let middle = 0.5 * (range[d][0] + range[d][1]);
                let (mut low, mut high) = (range, range);
                low[d][1] = middle;
                high[d][0] = middle;
                self.push([p, q], left, low, depth - 1, bounds);
                self.push([p, q], points, high, depth - 1, bounds);
                return;
            }
        }
        let hull = bounds_of(points.iter().map(space));
        let centre: [f64; 3] = std::array::from_fn(|c| 0.5 * (hull[0][c] + hull[1][c]));
        let radius = points.iter().map(|s| gap(space(s), centre)).fold(0.0, f64::max);
        let heaviest = points.iter().fold(0.0_f64, |m, c| m.max(c[3]));
        let rational = points.iter().any(|c| c[3] != heaviest);
        for point in &mut points {
            let (s, w) = (space(point), point[3] / heaviest);
            *point = [(s[0] - centre[0]) * w, (s[1] - centre[1]) * w, (s[2] - centre[2]) * w, w];
        }
        let few = self.tables && (2 * p + 1) * (2 * q + 1) <= MOST_PRODUCTS;
        let products = few.then_some(self.products.len() as u32);
        if products.is_some() {
            multiply(
                [p, q],
                &points,
                |a, b| {
                    [
                        a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
                        a[0] * b[3],
                        a[1] * b[3],
                        a[2] * b[3],
                        a[3] * b[3],
                    ]
                },
                &mut self.products,
            );
        }
        bounds.push(hull);
        self.list.push(Patch {
            degrees: [p as u16, q as u16],
            range,
            centre,
            radius,
            points: self.points.len() as u32,
            products,
            rational,
        });
        self.points.append(&mut points);
    }

    /// Improves `best` by the nearest point of patch `i` to `q`, if it is nearer.
    pub(super) fn search(
        &self,
        i: usize,
        q: [f64; 3],
        best: &mut Best,
        plain: &mut Work<1>,
        rational: &mut Work<2>,
    ) {
        let Some(search) = self.question(i, q) else { return };
        if !best.squared.is_finite() {
            let squared = search.squared([0.5, 0.5]);
            search.offer(squared, [0.5, 0.5], best);
        }
        if search.patch.rational {
            search.start(self, rational, best);
        } else {
            search.start(self, plain, best);
        }
    }

    /// What patch `i` has to do with `q`.
    pub(super) fn question(&self, i: usize, q: [f64; 3]) -> Option<Search<'_>> {
        let patch = self.list.get(i)?;
        let n = patch.degrees.map(usize::from);
        let from = patch.points as usize;
        let points = self.points.get(from..from + (n[0] + 1) * (n[1] + 1))?;
        let r: [f64; 3] = std::array::from_fn(|c| q[c] - patch.centre[c]);
        let distance = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
        let noise = PATCH_NOISE * (patch.radius + distance).powi(2);
        Some(Search { patch, points, n, r, noise })
    }
}

/// Where a descent ended.
#[derive(Debug, Clone, Copy)]
pub(super) struct Descent {
    /// In the patch's own parameters.
    pub(super) x: [f64; 2],
    /// The squared distance there.
    pub(super) squared: f64,
    /// Whether it is a minimum of the range, to all digits.
    pub(super) settled: bool,
}

/// The search in one patch. Its own parameters x run over 0…1.
pub(super) struct Search<'s> {
    pub(super) patch: &'s Patch,
    /// Homogeneous control points relative to the patch's centre.
    pub(super) points: &'s [[f64; 4]],
    /// The degrees.
    pub(super) n: [usize; 2],
    /// The point asked about, from the patch's centre.
    pub(super) r: [f64; 3],
    /// What rounding may do to a squared distance.
    pub(super) noise: f64,
}

/// A range of a patch's own parameters: low and high ends.
pub(super) type Range = [[f64; 2]; 2];

impl Search<'_> {
    fn offer(&self, squared: f64, x: [f64; 2], best: &mut Best) {
        if squared < best.squared {
            *best = Best { squared, uv: Some(self.parameters(x)) };
        }
    }

    /// The surface's parameters for the patch's own.
    pub(super) fn parameters(&self, x: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|d| {
            let [a, b] = self.patch.range[d];
            (1.0 - x[d]) * a + x[d] * b
        })
    }

    /// The control points relative to the point asked about.
    pub(super) fn shifted(&self) -> Vec<[f64; 4]> {
        let r = self.r;
        self.points
            .iter()
            .map(|a| [a[0] - r[0] * a[3], a[1] - r[1] * a[3], a[2] - r[2] * a[3], a[3]])
            .collect()
    }

    fn start<const C: usize>(&self, patches: &Patches, work: &mut Work<C>, best: &mut Best) {
        let r = self.r;
        let rr = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
        let count = (2 * self.n[0] + 1) * (2 * self.n[1] + 1);
        work.arena.clear();
        if let Some(first) = self.patch.products {
            let first = first as usize;
            let products = patches.products.get(first..first + count).unwrap_or(&[]);
            work.arena.extend(products.iter().map(|m| {
                let value = m[0] - 2.0 * (r[0] * m[1] + r[1] * m[2] + r[2] * m[3]) + rr * m[4];
                std::array::from_fn(|k| if k == 0 { value } else { m[4] })
            }));
        } else {
            multiply(
                self.n,
                &self.shifted(),
                |a, b| {
                    let value = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                    std::array::from_fn(|k| if k == 0 { value } else { a[3] * b[3] })
                },
                &mut work.arena,
            );
        }
        if work.arena.len() == count {
            self.range(work, 0, [[0.0, 1.0]; 2], 0, best);
        }
    }

    /// Looks at a range of the patch, whose coefficients stand in the arena from `at` on: squared distance times w²,
    /// and w² where C is 2.
    ///
    /// The range is left when the coefficients prove it no nearer than the best (2·10⁻¹³ of the distance counts as
    /// equal), or when they prove the function convex and Newton's method, kept in the range, has found its minimum;
    /// else it is halved. The recursion ends at depth 80.
    fn range<const C: usize>(
        &self,
        work: &mut Work<C>,
        at: usize,
        range: Range,
        depth: u32,
        best: &mut Best,
    ) {
        work.budget = work.budget.saturating_sub(1);
        let [m, n] = [2 * self.n[0] + 1, 2 * self.n[1] + 1];
        let count = m * n;
        let weight = |c: &[f64; C]| if C == 1 { 1.0 } else { c[C - 1] };
        let coefficients = &work.arena[at..at + count];
        let tie = best.squared * (1.0 - MINIMUM_MARGIN);
        let (mut least, mut lowest, mut margin) = (f64::INFINITY, 0, f64::INFINITY);
        for (k, c) in coefficients.iter().enumerate() {
            let x = c[0] - tie * weight(c);
            if x < least {
                (least, lowest) = (x, k);
            }
            // What rounding may have done to a coefficient is a part of the weight that stands with it.
            margin = margin.min(x - self.noise * weight(c));
        }
        if !(margin < 0.0) {
            return;
        }
        // Where the lowest coefficient acts most the function is low; a good value there is worth Newton's method.
        let inside = |d: usize, t: f64| range[d][0] + (range[d][1] - range[d][0]) * t;
        let x = [
            inside(0, (lowest / n) as f64 / (m - 1) as f64),
            inside(1, (lowest % n) as f64 / (n - 1) as f64),
        ];
        let is_convex = convex(coefficients, [m, n], best.squared);
        if is_convex || depth == 0 || self.squared(x) < best.squared {
            let found = self.minimum(range, x);
            self.offer(found.squared, found.x, best);
            if found.settled && is_convex && (C == 1 || convex(coefficients, [m, n], found.squared)) {
                return;
            }
        }
        // Where coefficients differ by no more than rounding may, halving tells nothing new.
        let (low, high) = coefficients.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| {
            let value = c[0] / weight(c);
            (low.min(value), high.max(value))
        });
        if depth >= 80 || work.budget == 0 || high - low <= 4.0 * self.noise {
            return;
        }
        // Across the direction in which the coefficients change more.
        let change = |step: usize, skip: &dyn Fn(usize) -> bool| -> f64 {
            (step..count)
                .filter(|&k| !skip(k))
                .map(|k| (coefficients[k][0] - coefficients[k - step][0]).abs())
                .fold(0.0, f64::max)
        };
        let (du, dv) = (change(n, &|_| false), change(1, &|k| k % n == 0));
        let wide = |d: usize| range[d][1] - range[d][0] > NARROWEST_SIDE;
        let d = usize::from(if wide(0) && wide(1) { dv > du } else { wide(1) });
        if !wide(d) {
            return;
        }
        let (left, right) = (work.arena.len(), work.arena.len() + count);
        work.arena.resize(left + 2 * count, [0.0; C]);
        let (before, after) = work.arena.split_at_mut(left);
        let (low, high) = after.split_at_mut(count);
        high.copy_from_slice(&before[at..at + count]);
        let (lines, stride, steps, jump) = if d == 0 { (n, n, m, 1) } else { (m, 1, n, n) };
        for line in 0..lines {
            let start = line * jump;
            for level in 0..steps {
                low[start + level * stride] = high[start];
                for i in 0..steps - 1 - level {
                    let k = start + i * stride;
                    high[k] = std::array::from_fn(|c| 0.5 * (high[k][c] + high[k + stride][c]));
                }
            }
        }
        let lowest = |c: &[[f64; C]]| c.iter().fold(f64::INFINITY, |m, c| m.min(c[0]));
        let left_first = lowest(low) <= lowest(high);
        let middle = 0.5 * (range[d][0] + range[d][1]);
        let (mut lower, mut upper) = (range, range);
        lower[d][1] = middle;
        upper[d][0] = middle;
        if left_first {
            self.range(work, left, lower, depth + 1, best);
            self.range(work, right, upper, depth + 1, best);
        } else {
            self.range(work, right, upper, depth + 1, best);
            self.range(work, left, lower, depth + 1, best);
        }
        work.arena.truncate(left);
    }

    pub(super) fn squared(&self, x: [f64; 2]) -> f64 {
        let [v, ..] = self.jet(x);
        v[0] * v[0] + v[1] * v[1] + v[2] * v[2]
    }

    /// The vector from the point asked about and the derivatives Su, Sv, Suu, Suv, Svv by the patch's own parameters.
    pub(super) fn jet(&self, x: [f64; 2]) -> [[f64; 3]; 6] {
        if self.n[0] <= 3 && self.n[1] <= 3 {
            self.jet_sized::<4>(x)
        } else {
            self.jet_sized::<{ MAX_DEGREE + 1 }>(x)
        }
    }

    fn jet_sized<const M: usize>(&self, x: [f64; 2]) -> [[f64; 3]; 6] {
        let width = self.n[1] + 1;
        let mut rows = [[[0.0; 4]; M]; 3];
        for (i, row) in self.points.chunks_exact(width).enumerate().take(M) {
            let d = jet::<M>(row, x[1]);
            (0..3).for_each(|k| rows[k][i] = d[k]);
        }
        let count = self.n[0] + 1;
        let [s, su, suu] = jet::<M>(&rows[0][..count], x[0]);
        let [sv, suv, _] = jet::<M>(&rows[1][..count], x[0]);
        let [svv, ..] = jet::<M>(&rows[2][..count], x[0]);
        let all = [s, su, sv, suu, suv, svv];
        let mut out = [[0.0; 3]; 6];
        if self.patch.rational {
            let w = s[3];
            let part = |k: usize, from: &[(usize, f64, usize)], out: &[[f64; 3]; 6]| -> [f64; 3] {
                std::array::from_fn(|c| {
                    let taken: f64 = from.iter().map(|&(a, s, b)| s * all[a][3] * out[b][c]).sum();
                    (all[k][c] - taken) / w
                })
            };
            out[0] = part(0, &[], &out);
            out[1] = part(1, &[(1, 1.0, 0)], &out);
            out[2] = part(2, &[(2, 1.0, 0)], &out);
            out[3] = part(3, &[(1, 2.0, 1), (3, 1.0, 0)], &out);
            out[4] = part(4, &[(1, 1.0, 2), (2, 1.0, 1), (4, 1.0, 0)], &out);
            out[5] = part(5, &[(2, 2.0, 2), (5, 1.0, 0)], &out);
        } else {
            (0..6).for_each(|k| out[k] = [all[k][0], all[k][1], all[k][2]]);
        }
        (0..3).for_each(|c| out[0][c] -= self.r[c]);
        out
    }

    /// A minimum of the squared distance in a range: Newton's method from x, along the sides of the range where it is
    /// held by them. Steps that make it worse are shortened.
    pub(super) fn minimum(&self, range: Range, mut x: [f64; 2]) -> Descent {
        let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let mut jet = self.jet(x);
        let mut value = dot(&jet[0], &jet[0]);
        let mut settled = false;
        for _ in 0..30 {
            let [v, su, sv, suu, suv, svv] = &jet;
            let g = [dot(v, su), dot(v, sv)];
            let first = [dot(su, su), dot(su, sv), dot(sv, sv)];
            let mut h = [first[0] + dot(v, suu), first[1] + dot(v, suv), first[2] + dot(v, svv)];
            let held =
                |d: usize| (x[d] <= range[d][0] && g[d] >= 0.0) || (x[d] >= range[d][1] && g[d] <= 0.0);
            let free = [!held(0), !held(1)];
            let definite = |h: &[f64; 3]| match free {
                [true, true] => h[0] > 0.0 && h[2] > 0.0 && h[0] * h[2] > h[1] * h[1] * (1.0 + DEFINITE),
                [true, false] => h[0] > 0.0,
                [false, true] => h[2] > 0.0,
                [false, false] => true,
            };
            let newton = definite(&h);
            if !newton {
                // Without the curvature of the surface the matrix is never indefinite.
                let lift = LIFT * (first[0] + first[2]);
                h = [first[0] + lift, first[1], first[2] + lift];
                if !definite(&h) {
                    break;
                }
            }
            let step = match free {
                [true, true] => {
                    let det = h[0] * h[2] - h[1] * h[1];
                    [(h[1] * g[1] - h[2] * g[0]) / det, (h[1] * g[0] - h[0] * g[1]) / det]
                }
                [true, false] => [-g[0] / h[0], 0.0],
                [false, true] => [0.0, -g[1] / h[2]],
                [false, false] => [0.0, 0.0],
            };
            let (mut share, mut moved) = (1.0, false);
            let mut size = 0.0;
            for _ in 0..12 {
                let next: [f64; 2] =
                    std::array::from_fn(|d| (x[d] + share * step[d]).clamp(range[d][0], range[d][1]));
                size = (next[0] - x[0]).abs().max((next[1] - x[1]).abs());
                let there = self.jet(next);
                let found = dot(&there[0], &there[0]);
                if found <= value || size <= NO_GAIN_STEP {
                    moved = next != x;
                    (x, jet, value) = (next, there, found.min(value));
                    break;
                }
                share *= 0.25;
            }
            if newton && size <= NEWTON_SMALL {
                settled = true;
                break;
            }
            if !moved {
                break;
            }
        }
        Descent { x, squared: dot(&jet[0], &jet[0]), settled }
    }
}
