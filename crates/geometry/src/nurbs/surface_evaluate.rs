//! Points and partial derivatives of NURBS surfaces.

use super::NurbsSurface;
use super::curve::{Controls, project};
use super::evaluate::{de_boor, derivatives};
use super::knots::{MAX_DEGREE, span_index};
use super::surface::Quadrant;
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
        let below = side.from_below();
        [
            span_index(&self.knots[0], self.degrees[0], u, below[0]),
            span_index(&self.knots[1], self.degrees[1], v, below[1]),
        ]
    }

    /// The point at (u, v). Outside the domain the polynomial of the nearest span goes on.
    pub fn point_at(&self, u: f64, v: f64) -> Point3 {
        let [ju, jv] = self.spans_at(u, v, Quadrant::NorthEast);
        match &self.controls {
            Controls::Plain(points) => self.value(points, [ju, jv], u, v).into(),
            Controls::Rational(points) => project(self.value(points, [ju, jv], u, v)),
        }
    }

    fn value<const N: usize>(&self, points: &[[f64; N]], [ju, jv]: [usize; 2], u: f64, v: f64) -> [f64; N] {
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

    /// The point and all partial derivatives up to a total order, at a knot those of the piece on the given side.
    /// Orders above 32 are not given.
    ///
    /// Rational surfaces by the quotient rule (P&T, *The NURBS Book*, algorithm A4.4).
    pub fn derivatives(&self, u: f64, v: f64, order: usize, side: Quadrant) -> SurfaceDerivatives {
        let order = order.min(MAX_ORDER);
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
