//! Points and partial derivatives of NURBS surfaces.

use super::NurbsSurface;
use super::curve::{Controls, project};
use super::evaluate::{
    basis_sized, de_boor, derivatives, divided_partials, find_span, jet_weights, local, weighted,
};
use super::knots::{MAX_DEGREE, span_index};
use super::surface::Quadrant;
use super::weights::Weights;
use crate::bernstein::binomial;
use crate::{Point3, Vector3};

/// The highest total order of derivatives that is computed.
pub(crate) const MAX_ORDER: usize = 32;

/// A point of a surface and its partial derivatives up to a total order, ∂^(i+j)S/∂uⁱ∂vʲ.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceDerivatives {
    order: usize,
    /// By total order, within it from all-u to all-v: S, Su, Sv, Suu, Suv, Svv, …
    values: Vec<Vector3>,
}

/// Where derivative (i, j) stands in the list S, Su, Sv, Suu, Suv, Svv, …
#[inline]
pub(crate) fn place(i: usize, j: usize) -> usize {
    let n = i + j;
    n * (n + 1) / 2 + j
}

impl SurfaceDerivatives {
    /// From all partial derivatives up to `order` in the order S, Su, Sv, Suu, Suv, Svv, …
    pub(crate) fn from_values(order: usize, values: Vec<Vector3>) -> Self {
        Self { order, values }
    }

    /// From a function of the two indices.
    pub(crate) fn from_fn(order: usize, mut f: impl FnMut(usize, usize) -> Vector3) -> Self {
        let mut values = Vec::with_capacity((order + 1) * (order + 2) / 2);
        for n in 0..=order {
            values.extend((0..=n).map(|j| f(n - j, j)));
        }
        Self { order, values }
    }

    /// The highest total order that was asked for.
    pub fn order(&self) -> usize {
        self.order
    }

    /// The point.
    pub fn point(&self) -> Point3 {
        self.get(0, 0).to_point()
    }

    /// The derivative taken `i` times by u and `j` times by v; zero above the order.
    pub fn get(&self, i: usize, j: usize) -> Vector3 {
        if i + j > self.order {
            return Vector3::ZERO;
        }
        self.values.get(place(i, j)).copied().unwrap_or(Vector3::ZERO)
    }

    /// All of them: S, Su, Sv, Suu, Suv, Svv, …, as openNURBS lists them.
    pub fn values(&self) -> &[Vector3] {
        &self.values
    }
}

/// All partial derivatives up to a total order, of a tensor-product spline in any dimension: first along v in each
/// row of control points that acts, then along u.
fn tensor<const N: usize>(
    surface: &NurbsSurface,
    points: &[[f64; N]],
    [ju, jv]: [usize; 2],
    [u, v]: [f64; 2],
    order: usize,
) -> Vec<[f64; N]> {
    let ([p, q], [ku, kv]) = (surface.degrees, &surface.knots);
    let mut out = vec![[0.0; N]; (order + 1) * (order + 2) / 2];
    // rows[l] are the l-th derivatives along v of the p + 1 rows.
    let mut rows = vec![[[0.0; N]; MAX_DEGREE + 1]; order + 1];
    let mut column = vec![[0.0; N]; order + 1];
    for i in 0..=p {
        let start = (ju + i) * surface.counts[1];
        let row = points.get(start..start + surface.counts[1]).unwrap_or(&[]);
        derivatives(q, kv, row, jv, v, &mut column);
        for (l, d) in column.iter().enumerate() {
            rows[l][i] = *d;
        }
    }
    let local = ku.get(ju..ju + 2 * p).unwrap_or(&[]);
    for (l, row) in rows.iter().enumerate() {
        let part = &mut column[..=order - l];
        derivatives(p, local, &row[..=p], 0, u, part);
        for (k, d) in part.iter().enumerate() {
            out[place(k, l)] = *d;
        }
    }
    out
}

impl NurbsSurface {
    /// The first control points that act at a pair of parameters.
    pub(crate) fn spans_at(&self, u: f64, v: f64, side: Quadrant) -> [usize; 2] {
        let at = |knots: &[f64], degree: usize, t: f64, below: bool| match below {
            true => span_index(knots, degree, t, true),
            false => find_span(knots, degree, t),
        };
        let below = side.from_below();
        [at(&self.knots[0], self.degrees[0], u, below[0]), at(&self.knots[1], self.degrees[1], v, below[1])]
    }

    /// The point at (u, v). Outside the domain the polynomial of the nearest span goes on.
    pub fn point_at(&self, u: f64, v: f64) -> Point3 {
        let [ju, jv] = self.spans_at(u, v, Quadrant::NorthEast);
        match &self.controls {
            Controls::Plain(points) => self.value(points, [ju, jv], u, v).into(),
            Controls::Rational(points) => project(self.value(points, [ju, jv], u, v)),
        }
    }

    #[inline]
    fn value<const N: usize>(&self, points: &[[f64; N]], spans: [usize; 2], u: f64, v: f64) -> [f64; N] {
        match self.degrees {
            [3, 3] => self.value_sized::<N, 3, 4, 6, 3, 4, 6>(points, spans, u, v),
            [2, 2] => self.value_sized::<N, 2, 3, 4, 2, 3, 4>(points, spans, u, v),
            [1, 1] => self.value_sized::<N, 1, 2, 2, 1, 2, 2>(points, spans, u, v),
            [2, 1] => self.value_sized::<N, 2, 3, 4, 1, 2, 2>(points, spans, u, v),
            [1, 2] => self.value_sized::<N, 1, 2, 2, 2, 3, 4>(points, spans, u, v),
            [3, 1] => self.value_sized::<N, 3, 4, 6, 1, 2, 2>(points, spans, u, v),
            [1, 3] => self.value_sized::<N, 1, 2, 2, 3, 4, 6>(points, spans, u, v),
            [2, 3] => self.value_sized::<N, 2, 3, 4, 3, 4, 6>(points, spans, u, v),
            [3, 2] => self.value_sized::<N, 3, 4, 6, 2, 3, 4>(points, spans, u, v),
            _ => self.value_long(points, spans, u, v),
        }
    }

    /// For fixed degrees: one set of basis functions for each direction.
    #[inline(always)]
    fn value_sized<
        const N: usize,
        const P: usize,
        const PO: usize,
        const PU: usize,
        const Q: usize,
        const QO: usize,
        const QU: usize,
    >(
        &self,
        points: &[[f64; N]],
        [ju, jv]: [usize; 2],
        u: f64,
        v: f64,
    ) -> [f64; N] {
        let (Some(ku), Some(kv)) = (local(&self.knots[0], ju), local(&self.knots[1], jv)) else {
            return [f64::NAN; N];
        };
        let (nu, nv) = (basis_sized::<P, PO, PU>(ku, u), basis_sized::<Q, QO, QU>(kv, v));
        let mut column = [[0.0; N]; PO];
        for i in 0..PO {
            let Some(row) = local(points, (ju + i) * self.counts[1] + jv) else { return [f64::NAN; N] };
            column[i] = weighted(&nv, row);
        }
        weighted(&nu, &column)
    }

    fn value_long<const N: usize>(
        &self,
        points: &[[f64; N]],
        [ju, jv]: [usize; 2],
        u: f64,
        v: f64,
    ) -> [f64; N] {
        let mut column = [[0.0; N]; MAX_DEGREE + 1];
        let [p, q] = self.degrees;
        for (i, slot) in column.iter_mut().enumerate().take(p + 1) {
            let start = (ju + i) * self.counts[1];
            let row = points.get(start..start + self.counts[1]).unwrap_or(&[]);
            *slot = de_boor(q, &self.knots[1], row, jv, v);
        }
        let local = self.knots[0].get(ju..ju + 2 * p).unwrap_or(&[]);
        de_boor(p, local, &column[..=p], 0, u)
    }

    /// The position at (u, v), as a vector from the origin, and the first partial derivatives by u and by v, without
    /// allocation; at a knot those of the piece on the given side.
    #[inline]
    pub fn partials_at(&self, u: f64, v: f64, side: Quadrant) -> [Vector3; 3] {
        let spans = self.spans_at(u, v, side);
        match &self.controls {
            Controls::Plain(points) => self.first_partials(points, spans, u, v).map(Vector3::from),
            Controls::Rational(points) => {
                divided_partials(&self.first_partials(points, spans, u, v)).map(Vector3::from)
            }
        }
    }

    #[inline]
    fn first_partials<const N: usize>(
        &self,
        points: &[[f64; N]],
        spans: [usize; 2],
        u: f64,
        v: f64,
    ) -> [[f64; N]; 3] {
        let [s, su, sv, ..] = match self.degrees {
            [3, 3] => self.sized::<false, N, 3, 4, 6, 3, 4, 6>(points, spans, u, v),
            [2, 2] => self.sized::<false, N, 2, 3, 4, 2, 3, 4>(points, spans, u, v),
            [1, 1] => self.sized::<false, N, 1, 2, 2, 1, 2, 2>(points, spans, u, v),
            [2, 1] => self.sized::<false, N, 2, 3, 4, 1, 2, 2>(points, spans, u, v),
            [1, 2] => self.sized::<false, N, 1, 2, 2, 2, 3, 4>(points, spans, u, v),
            [3, 1] => self.sized::<false, N, 3, 4, 6, 1, 2, 2>(points, spans, u, v),
            [1, 3] => self.sized::<false, N, 1, 2, 2, 3, 4, 6>(points, spans, u, v),
            [2, 3] => self.sized::<false, N, 2, 3, 4, 3, 4, 6>(points, spans, u, v),
            [3, 2] => self.sized::<false, N, 3, 4, 6, 2, 3, 4>(points, spans, u, v),
            _ => {
                let mut out = [[0.0; N]; 6];
                self.partials_long(points, spans, [u, v], &mut out[..3]);
                out
            }
        };
        [s, su, sv]
    }

    /// The position at (u, v), as a vector from the origin, and the partial derivatives of order 1 and 2 in the order
    /// S, Su, Sv, Suu, Suv, Svv, without allocation; at a knot those of the piece on the given side.
    pub fn second_partials_at(&self, u: f64, v: f64, side: Quadrant) -> [Vector3; 6] {
        let spans = self.spans_at(u, v, side);
        match &self.controls {
            Controls::Plain(points) => self.second_partials(points, spans, u, v).map(Vector3::from),
            Controls::Rational(points) => divided_second_partials(&self.second_partials(points, spans, u, v)),
        }
    }

    #[inline]
    fn second_partials<const N: usize>(
        &self,
        points: &[[f64; N]],
        spans: [usize; 2],
        u: f64,
        v: f64,
    ) -> [[f64; N]; 6] {
        match self.degrees {
            [3, 3] => self.sized::<true, N, 3, 4, 6, 3, 4, 6>(points, spans, u, v),
            [2, 2] => self.sized::<true, N, 2, 3, 4, 2, 3, 4>(points, spans, u, v),
            _ => {
                let mut out = [[0.0; N]; 6];
                self.partials_long(points, spans, [u, v], &mut out);
                out
            }
        }
    }

    /// S, Su, Sv and, if wanted, Suu, Suv, Svv (else 0) for degrees that the compiler knows.
    #[inline(always)]
    fn sized<
        const SECOND: bool,
        const N: usize,
        const P: usize,
        const PO: usize,
        const PU: usize,
        const Q: usize,
        const QO: usize,
        const QU: usize,
    >(
        &self,
        points: &[[f64; N]],
        [ju, jv]: [usize; 2],
        u: f64,
        v: f64,
    ) -> [[f64; N]; 6] {
        let (Some(ku), Some(kv)) = (local(&self.knots[0], ju), local(&self.knots[1], jv)) else {
            return [[f64::NAN; N]; 6];
        };
        let (nu, [du, duu]) = jet_weights::<P, PO, PU>(ku, u);
        let (nv, [dv, dvv]) = jet_weights::<Q, QO, QU>(kv, v);
        // By row: the point and its first and second derivative along v.
        let mut columns = [[[0.0; N]; PO]; 3];
        for i in 0..PO {
            let Some(row) = local::<_, QO>(points, (ju + i) * self.counts[1] + jv) else {
                return [[f64::NAN; N]; 6];
            };
            let steps = steps::<N, Q, QO>(row);
            columns[0][i] = weighted(&nv, row);
            columns[1][i] = weighted(&dv, &steps);
            if SECOND {
                columns[2][i] = weighted(&dvv, &steps);
            }
        }
        let along_u = steps::<N, P, PO>(&columns[0]);
        let mut out = [[0.0; N]; 6];
        out[0] = weighted(&nu, &columns[0]);
        out[1] = weighted(&du, &along_u);
        out[2] = weighted(&nu, &columns[1]);
        if SECOND {
            out[3] = weighted(&duu, &along_u);
            out[4] = weighted(&du, &steps::<N, P, PO>(&columns[1]));
            out[5] = weighted(&nu, &columns[2]);
        }
        out
    }

    /// Three or six partial derivatives for any degrees.
    fn partials_long<const N: usize>(
        &self,
        points: &[[f64; N]],
        [ju, jv]: [usize; 2],
        [u, v]: [f64; 2],
        out: &mut [[f64; N]],
    ) {
        let [p, q] = self.degrees;
        let wu = Weights::new(p, &self.knots[0], ju, u);
        let wv = Weights::new(q, &self.knots[1], jv, v);
        let second = out.len() > 3;
        let add = |sum: &mut [f64; N], w: f64, p: &[f64; N]| {
            *sum = std::array::from_fn(|c| sum[c] + w * p[c]);
        };
        let mut all = [[0.0; N]; 6];
        let mut before = [[0.0; N]; 2];
        for i in 0..=p {
            let start = (ju + i) * self.counts[1] + jv;
            let row = points.get(start..=start + q).unwrap_or(&[]);
            // The row's point and its derivatives along v.
            let mut d = [[0.0; N]; 3];
            for (p, &w) in row.iter().zip(&wv.points) {
                add(&mut d[0], w, p);
            }
            for (j, pair) in row.windows(2).enumerate() {
                let step: [f64; N] = std::array::from_fn(|c| pair[1][c] - pair[0][c]);
                add(&mut d[1], wv.differences[0][j], &step);
                if second {
                    add(&mut d[2], wv.differences[1][j], &step);
                }
            }
            add(&mut all[0], wu.points[i], &d[0]);
            add(&mut all[2], wu.points[i], &d[1]);
            add(&mut all[5], wu.points[i], &d[2]);
            if i > 0 {
                let step: [f64; N] = std::array::from_fn(|c| d[0][c] - before[0][c]);
                add(&mut all[1], wu.differences[0][i - 1], &step);
                add(&mut all[3], wu.differences[1][i - 1], &step);
                let step: [f64; N] = std::array::from_fn(|c| d[1][c] - before[1][c]);
                add(&mut all[4], wu.differences[0][i - 1], &step);
            }
            before = [d[0], d[1]];
        }
        for (slot, d) in out.iter_mut().zip(all) {
            *slot = d;
        }
    }

    /// The point and all partial derivatives up to a total order, at a knot those of the piece on the given side.
    /// Orders above 32 are not given.
    ///
    /// Rational surfaces by the quotient rule (P&T, *The NURBS Book*, algorithm A4.4).
    pub fn derivatives(&self, u: f64, v: f64, order: usize, side: Quadrant) -> SurfaceDerivatives {
        let order = order.min(MAX_ORDER);
        match order {
            0 | 1 => {
                let mut values = self.partials_at(u, v, side).to_vec();
                values.truncate(if order == 0 { 1 } else { 3 });
                return SurfaceDerivatives::from_values(order, values);
            }
            2 => return SurfaceDerivatives::from_values(2, self.second_partials_at(u, v, side).to_vec()),
            _ => {}
        }
        let spans = self.spans_at(u, v, side);
        match &self.controls {
            Controls::Plain(points) => {
                let values = tensor(self, points, spans, [u, v], order);
                SurfaceDerivatives::from_values(order, values.into_iter().map(Vector3::from).collect())
            }
            Controls::Rational(points) => {
                let values = tensor(self, points, spans, [u, v], order);
                SurfaceDerivatives::from_values(order, quotient(&values, order))
            }
        }
    }
}

/// The P differences of PO = P + 1 neighbouring points.
#[inline(always)]
fn steps<const N: usize, const P: usize, const PO: usize>(points: &[[f64; N]; PO]) -> [[f64; N]; P] {
    std::array::from_fn(|i| std::array::from_fn(|c| points[i + 1][c] - points[i][c]))
}

/// The quotient rule for S, Su, Sv, Suu, Suv, Svv.
fn divided_second_partials(d: &[[f64; 4]; 6]) -> [Vector3; 6] {
    let [s, su, sv] = divided_partials(&[d[0], d[1], d[2]]).map(Vector3::from);
    let over = 1.0 / d[0][3];
    let (wu, wv) = (d[1][3], d[2][3]);
    let part = |d: &[f64; 4], cross: Vector3| (Vector3::new(d[0], d[1], d[2]) - s * d[3] - cross) * over;
    [s, su, sv, part(&d[3], su * (2.0 * wu)), part(&d[4], su * wv + sv * wu), part(&d[5], sv * (2.0 * wv))]
}

/// The derivatives of (x, y, z)/w from those of (x, y, z, w).
pub(crate) fn quotient(values: &[[f64; 4]], order: usize) -> Vec<Vector3> {
    let mut out = vec![Vector3::ZERO; values.len()];
    let Some(w) = values.first().map(|d| d[3]) else { return out };
    for n in 0..=order {
        for l in 0..=n {
            let k = n - l;
            let d = values[place(k, l)];
            let mut sum = Vector3::new(d[0], d[1], d[2]);
            for i in 0..=k {
                for j in 0..=l {
                    if i + j > 0 {
                        let share = binomial(k, i) * binomial(l, j) * values[place(i, j)][3];
                        sum -= out[place(k - i, l - j)] * share;
                    }
                }
            }
            out[place(k, l)] = sum / w;
        }
    }
    out
}
