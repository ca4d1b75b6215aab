//! The Bézier patches of a surface, each made when it is first asked for: a search looks at few of many.

use std::sync::OnceLock;

use super::NurbsSurface;
use super::bezier::span_to_bezier;
use super::curve::Controls;
use super::surface::Direction;

/// The Bézier nets of a surface of which it is made; whoever asks brings the surface along.
#[derive(Debug)]
pub(crate) struct Nets {
    /// The parameters at which patches meet, both ends of the domain among them.
    pub(crate) lines: [Vec<f64>; 2],
    /// The first control point that acts in each span of both directions.
    spans: [Vec<usize>; 2],
    made: Vec<OnceLock<Vec<[f64; 4]>>>,
}

impl Nets {
    /// Those of a surface; none is made yet.
    pub(crate) fn new(surface: &NurbsSurface) -> Self {
        let lines = Direction::BOTH.map(|d| surface.span_parameters(d));
        let spans = Direction::BOTH.map(|d| {
            let (knots, p) = (surface.knots(d), surface.degree(d));
            (0..knots.len() + 1 - 2 * p).filter(|&j| knots[j + p - 1] < knots[j + p]).collect::<Vec<_>>()
        });
        let made = (0..spans[0].len() * spans[1].len()).map(|_| OnceLock::new()).collect();
        Self { lines, spans, made }
    }

    /// How many patches there are.
    pub(crate) fn len(&self) -> usize {
        self.made.len()
    }

    /// The ranges of u and v of a patch; those along v stand together.
    pub(crate) fn ranges(&self, patch: usize) -> [[f64; 2]; 2] {
        let columns = self.spans[1].len().max(1);
        let at = |k: usize, i: usize| {
            let end = |i: usize| self.lines[k].get(i).copied().unwrap_or(f64::NAN);
            [end(i), end(i + 1)]
        };
        [at(0, patch / columns), at(1, patch % columns)]
    }

    /// The patches over parameters, also those beside which they lie by no more than a share of their width.
    pub(crate) fn over(&self, uv: [f64; 2], share: f64) -> impl Iterator<Item = usize> {
        let columns = self.spans[1].len();
        let [us, vs] = [0, 1].map(|k| {
            let lines = &self.lines[k];
            let holds = |i: usize| {
                let room = share * (lines[i + 1] - lines[i]);
                lines[i] - room <= uv[k] && uv[k] <= lines[i + 1] + room
            };
            let at = lines.partition_point(|t| *t <= uv[k]);
            let near = at.saturating_sub(2)..(at + 1).min(lines.len().saturating_sub(1));
            near.filter(|i| holds(*i)).collect::<Vec<_>>()
        });
        us.into_iter().flat_map(move |i| vs.clone().into_iter().map(move |j| i * columns + j))
    }

    /// The control points of the surface that act on a patch, in space: their box holds it.
    pub(crate) fn acting(&self, surface: &NurbsSurface, patch: usize, mut each: impl FnMut([f64; 3])) {
        let columns = self.spans[1].len().max(1);
        let (Some(&i), Some(&j)) = (self.spans[0].get(patch / columns), self.spans[1].get(patch % columns))
        else {
            return;
        };
        let [p, q] = surface.degrees;
        crate::cancellation::worked(p * q / 8 + 1);
        for r in i..=i + p {
            let row = r * surface.counts[1] + j;
            match &surface.controls {
                Controls::Plain(points) => {
                    points.get(row..=row + q).unwrap_or(&[]).iter().for_each(|x| each(*x));
                }
                Controls::Rational(points) => points
                    .get(row..=row + q)
                    .unwrap_or(&[])
                    .iter()
                    .for_each(|x| each([x[0] / x[3], x[1] / x[3], x[2] / x[3]])),
            }
        }
    }

    /// The homogeneous control points of a patch, v running fastest; without weights these are exactly 1.
    pub(crate) fn net(&self, surface: &NurbsSurface, patch: usize) -> &[[f64; 4]] {
        let columns = self.spans[1].len().max(1);
        match (self.made.get(patch), self.spans[0].get(patch / columns), self.spans[1].get(patch % columns)) {
            (Some(slot), Some(&i), Some(&j)) => slot.get_or_init(|| surface.bezier_net([i, j])),
            _ => &[],
        }
    }
}

impl NurbsSurface {
    /// The homogeneous control points of the Bézier form of the span in which control point `first` is the first to act,
    /// v running fastest.
    fn bezier_net(&self, first: [usize; 2]) -> Vec<[f64; 4]> {
        let [p, q] = self.degrees;
        let [i, j] = first;
        let (n, m) = (p + 1, q + 1);
        crate::cancellation::worked(n * m / 2 + 1);
        let mut net = Vec::with_capacity(n * m);
        for r in i..=i + p {
            let row = r * self.counts[1] + j;
            match &self.controls {
                Controls::Plain(points) => {
                    net.extend(points[row..=row + q].iter().map(|&[x, y, z]| [x, y, z, 1.0]));
                }
                Controls::Rational(points) => net.extend_from_slice(&points[row..=row + q]),
            }
        }
        for row in net.chunks_exact_mut(m) {
            span_to_bezier(&self.knots[1][j..j + 2 * q], row);
        }
        let mut column = vec![[0.0; 4]; n];
        for c in 0..m {
            for (k, to) in column.iter_mut().enumerate() {
                *to = net[k * m + c];
            }
            span_to_bezier(&self.knots[0][i..i + 2 * p], &mut column);
            for (k, from) in column.iter().enumerate() {
                net[k * m + c] = *from;
            }
        }
        if let Controls::Plain(_) = self.controls {
            net.iter_mut().for_each(|x| x[3] = 1.0);
        }
        net
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a failing test may panic")]

    use super::Nets;
    use crate::{Direction, NurbsSurface, Point3};

    /// Each net is that of the Bézier surface which is made by putting in knots, and lies in the box of what acts on it.
    #[test]
    fn the_same_as_by_knots() {
        for [p, q] in [[1, 1], [2, 3], [3, 1], [5, 4]] {
            let counts = [p + 5, q + 4];
            let knots = [(p, counts[0], 1.3), (q, counts[1], 0.8)].map(|(degree, count, power)| {
                let mut knots: Vec<f64> = (0..count + degree - 1).map(|i| (i as f64).powf(power)).collect();
                if degree > 1 {
                    knots[degree + 1] = knots[degree];
                }
                knots
            });
            let points: Vec<Point3> = (0..counts[0] * counts[1])
                .map(|k| {
                    let (i, j) = ((k / counts[1]) as f64, (k % counts[1]) as f64);
                    Point3::new(i + 0.2 * j.sin(), j, (1.3 * i).sin() * (0.7 * j).cos())
                })
                .collect();
            let weights: Vec<f64> = (0..points.len()).map(|k| 1.0 + 0.3 * (k as f64).cos()).collect();
            let plain = NurbsSurface::new([p, q], counts, points.clone(), knots.clone()).unwrap();
            let rational = NurbsSurface::with_weights([p, q], counts, &points, &weights, knots).unwrap();
            for surface in [plain, rational] {
                let nets = Nets::new(&surface);
                let want = surface.bezier_patches().unwrap();
                assert_eq!(nets.len(), want.len());
                for (k, patch) in want.iter().enumerate() {
                    let ranges = Direction::BOTH.map(|d| [patch.domain(d).start, patch.domain(d).end]);
                    assert_eq!(nets.ranges(k), ranges);
                    let middle = ranges.map(|[a, b]| 0.5 * (a + b));
                    assert_eq!(nets.over(middle, 1e-3).collect::<Vec<_>>(), [k]);
                    assert!(nets.over(ranges.map(|r| r[0]), 1e-3).any(|i| i == k));
                    assert!(nets.over(ranges.map(|r| r[1]), 1e-3).any(|i| i == k));
                    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
                    nets.acting(&surface, k, |x| {
                        low = std::array::from_fn(|c| low[c].min(x[c]));
                        high = std::array::from_fn(|c| high[c].max(x[c]));
                    });
                    for (a, b) in nets.net(&surface, k).iter().zip(&patch.homogeneous_points()) {
                        for c in 0..4 {
                            assert!((a[c] - b[c]).abs() < 1e-13 * 30.0, "{p} {q} {k} {a:?} {b:?}");
                        }
                        for c in 0..3 {
                            let x = a[c] / a[3];
                            assert!(low[c] - 1e-13 * 30.0 <= x && x <= high[c] + 1e-13 * 30.0);
                        }
                    }
                }
            }
        }
    }
}
