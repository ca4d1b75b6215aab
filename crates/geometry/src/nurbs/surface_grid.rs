//! Points and partial derivatives on a whole grid of parameters: basis functions once for each row and column, and
//! the control net collapsed to a row of points once for each u.

use super::NurbsSurface;
use super::curve::{Controls, project};
use super::evaluate::{divided_partials, local, weighted};
use super::weights::{Weights, bases_at, weights_at};
use crate::{Direction, Point3, Vector3};

/// Grids of fewer points are not worth the start of other threads.
#[cfg(feature = "parallel")]
const PARALLEL: usize = 32_768;

/// Fills rows of `width` places, in parallel when there are many.
fn each_row<T: Send>(out: &mut [T], width: usize, work: impl Fn(usize, &mut [T], &mut Scratch) + Sync) {
    if width == 0 {
        return;
    }
    #[cfg(feature = "parallel")]
    if out.len() >= PARALLEL {
        use rayon::prelude::*;
        let rows = out.par_chunks_mut(width).enumerate();
        crate::parallel::waiting(|| {
            rows.for_each_init(Scratch::default, |scratch, (i, row)| work(i, row, scratch));
        });
        return;
    }
    let mut scratch = Scratch::default();
    out.chunks_mut(width).enumerate().for_each(|(i, row)| work(i, row, &mut scratch));
}

/// Room for the control net collapsed along u: its points, and the derivative along u.
#[derive(Default)]
struct Scratch {
    points: Vec<[f64; 4]>,
    along_u: Vec<[f64; 4]>,
}

/// N coordinates as four, so that two of them go into each instruction.
#[inline(always)]
fn padded<const N: usize>(p: &[f64; N]) -> [f64; 4] {
    std::array::from_fn(|c| if c < N { p[c] } else { 0.0 })
}

/// `out` = the sum of rows of the control net from `first` on, by weights.
fn collapse<const N: usize>(
    points: &[[f64; N]],
    columns: usize,
    first: usize,
    weights: &[f64],
    out: &mut Vec<[f64; 4]>,
) {
    out.clear();
    out.resize(columns, [0.0; 4]);
    for (i, &w) in weights.iter().enumerate() {
        let row = points.get((first + i) * columns..(first + i + 1) * columns).unwrap_or(&[]);
        for (slot, p) in out.iter_mut().zip(row) {
            let p = padded(p);
            *slot = std::array::from_fn(|c| slot[c] + w * p[c]);
        }
    }
}

/// The same for differences of neighbouring rows.
fn collapse_differences<const N: usize>(
    points: &[[f64; N]],
    columns: usize,
    first: usize,
    weights: &[f64],
    out: &mut Vec<[f64; 4]>,
) {
    out.clear();
    out.resize(columns, [0.0; 4]);
    for (i, &w) in weights.iter().enumerate() {
        let start = (first + i) * columns;
        let row = points.get(start..start + columns).unwrap_or(&[]);
        let next = points.get(start + columns..start + 2 * columns).unwrap_or(&[]);
        for (slot, (p, q)) in out.iter_mut().zip(row.iter().zip(next)) {
            let (p, q) = (padded(p), padded(q));
            *slot = std::array::from_fn(|c| slot[c] + w * (q[c] - p[c]));
        }
    }
}

impl NurbsSurface {
    /// The points at all pairs of parameters: `out[i * vs.len() + j]` is the point at (`us[i]`, `vs[j]`), which is
    /// [`NurbsSurface::point_at`] but for a few units in the last place. Long lists run in parallel with the
    /// `parallel` feature; the result is the same to the last bit.
    pub fn points_grid(&self, us: &[f64], vs: &[f64]) -> Vec<Point3> {
        let mut out = vec![Point3::ORIGIN; us.len().saturating_mul(vs.len())];
        self.points_grid_into(us, vs, &mut out);
        out
    }

    /// [`NurbsSurface::points_grid`] without allocating the result: rows are filled as far as there are places.
    pub fn points_grid_into(&self, us: &[f64], vs: &[f64], out: &mut [Point3]) {
        match self.degrees[1] {
            1 => self.points_grid_sized::<1, 2, 2>(us, vs, out),
            2 => self.points_grid_sized::<2, 3, 4>(us, vs, out),
            3 => self.points_grid_sized::<3, 4, 6>(us, vs, out),
            4 => self.points_grid_sized::<4, 5, 8>(us, vs, out),
            5 => self.points_grid_sized::<5, 6, 10>(us, vs, out),
            q => {
                let [along_u, along_v] = self.grid_weights(us, vs);
                self.on_rows(&along_u, vs.len(), out, |scratch, row| {
                    for (slot, w) in row.iter_mut().zip(&along_v) {
                        *slot = self.finished(long_sum(&scratch.points, w.span, &w.points[..=q]));
                    }
                });
            }
        }
    }

    fn points_grid_sized<const P: usize, const Q: usize, const U: usize>(
        &self,
        us: &[f64],
        vs: &[f64],
        out: &mut [Point3],
    ) {
        let along_u = weights_at(self.degrees[0], &self.knots[0], us);
        let along_v = bases_at::<P, Q, U>(&self.knots[1], vs);
        let rational = self.is_rational();
        self.on_rows(&along_u, vs.len(), out, |scratch, row| {
            let points = &scratch.points;
            let at = |(j, n): &(usize, [f64; Q])| match local::<_, Q>(points, *j) {
                Some(points) => weighted(n, points),
                None => [f64::NAN; 4],
            };
            // Two loops, so that neither asks again.
            if rational {
                row.iter_mut().zip(&along_v).for_each(|(slot, w)| *slot = project(at(w)));
            } else {
                row.iter_mut().zip(&along_v).for_each(|(slot, w)| {
                    let [x, y, z, _] = at(w);
                    *slot = Point3::new(x, y, z);
                });
            }
        });
    }

    fn finished(&self, p: [f64; 4]) -> Point3 {
        if self.is_rational() { project(p) } else { Point3::new(p[0], p[1], p[2]) }
    }

    fn grid_weights(&self, us: &[f64], vs: &[f64]) -> [Vec<Weights>; 2] {
        let at = |d: Direction, t| weights_at(self.degree(d), self.knots(d), t);
        [at(Direction::U, us), at(Direction::V, vs)]
    }

    fn on_rows<T: Send>(
        &self,
        along_u: &[Weights],
        width: usize,
        out: &mut [T],
        work: impl Fn(&Scratch, &mut [T]) + Sync,
    ) {
        let (p, columns) = (self.degrees[0], self.counts[1]);
        each_row(out, width, |i, row, scratch| {
            let Some(w) = along_u.get(i) else { return };
            match &self.controls {
                Controls::Plain(c) => collapse(c, columns, w.span, &w.points[..=p], &mut scratch.points),
                Controls::Rational(c) => collapse(c, columns, w.span, &w.points[..=p], &mut scratch.points),
            }
            work(scratch, row);
        });
    }

    /// The position, as a vector from the origin, and the first partial derivatives by u and by v at all pairs of
    /// parameters, in the order of [`NurbsSurface::points_grid`]; at knots those of the piece that begins there. The
    /// cross product of the two derivatives is along the normal.
    pub fn partials_grid(&self, us: &[f64], vs: &[f64]) -> Vec<[Vector3; 3]> {
        let mut out = vec![[Vector3::ZERO; 3]; us.len().saturating_mul(vs.len())];
        let [along_u, along_v] = self.grid_weights(us, vs);
        let ([p, q], columns, rational) = (self.degrees, self.counts[1], self.is_rational());
        each_row(&mut out, vs.len(), |i, row, scratch| {
            let Some(w) = along_u.get(i) else { return };
            let (n, d) = (&w.points[..=p], &w.differences[0][..p]);
            match &self.controls {
                Controls::Plain(c) => {
                    collapse(c, columns, w.span, n, &mut scratch.points);
                    collapse_differences(c, columns, w.span, d, &mut scratch.along_u);
                }
                Controls::Rational(c) => {
                    collapse(c, columns, w.span, n, &mut scratch.points);
                    collapse_differences(c, columns, w.span, d, &mut scratch.along_u);
                }
            }
            for (slot, w) in row.iter_mut().zip(&along_v) {
                let point = long_sum(&scratch.points, w.span, &w.points[..=q]);
                let by_u = long_sum(&scratch.along_u, w.span, &w.points[..=q]);
                let by_v = long_difference_sum(&scratch.points, w.span, &w.differences[0][..q]);
                let d = [point, by_u, by_v];
                let d = if rational { divided_partials(&d) } else { d.map(|[x, y, z, _]| [x, y, z]) };
                *slot = d.map(Vector3::from);
            }
        });
        out
    }
}

/// The sum of points from `first` on by weights.
#[inline]
fn long_sum(points: &[[f64; 4]], first: usize, weights: &[f64]) -> [f64; 4] {
    let mut sum = [0.0; 4];
    for (p, &w) in points.get(first..).unwrap_or(&[]).iter().zip(weights) {
        sum = std::array::from_fn(|c| sum[c] + w * p[c]);
    }
    sum
}

/// The sum of differences of neighbouring points from `first` on by weights.
#[inline]
fn long_difference_sum(points: &[[f64; 4]], first: usize, weights: &[f64]) -> [f64; 4] {
    let mut sum = [0.0; 4];
    for (p, &w) in points.get(first..).unwrap_or(&[]).windows(2).zip(weights) {
        sum = std::array::from_fn(|c| sum[c] + w * (p[1][c] - p[0][c]));
    }
    sum
}
