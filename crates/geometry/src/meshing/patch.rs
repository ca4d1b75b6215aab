//! Bézier patches and bounds of their derivatives by control points.

use super::bend::Size;
use crate::Vector3;

/// A Bézier patch over the unit square: homogeneous control points, v running fastest.
#[derive(Debug, Clone)]
pub(super) struct Patch {
    degrees: [usize; 2],
    points: Vec<[f64; 4]>,
}

impl Patch {
    pub(super) fn new(degrees: [usize; 2], points: Vec<[f64; 4]>) -> Self {
        Self { degrees, points }
    }

    fn at(&self, i: usize, j: usize) -> [f64; 4] {
        self.points.get(i * (self.degrees[1] + 1) + j).copied().unwrap_or([0.0; 4])
    }

    /// The part over a rectangle of the unit square, as a patch of its own.
    pub(super) fn part(&self, [u, v]: [[f64; 2]; 2]) -> Self {
        let [p, q] = self.degrees;
        let mut points = self.points.clone();
        let mut line = Vec::with_capacity(p.max(q) + 1);
        if v != [0.0, 1.0] {
            for row in points.chunks_mut(q + 1) {
                restrict(row, v);
            }
        }
        if u != [0.0, 1.0] {
            for j in 0..=q {
                line.clear();
                line.extend(points.iter().skip(j).step_by(q + 1));
                restrict(&mut line, u);
                for (slot, x) in points.iter_mut().skip(j).step_by(q + 1).zip(&line) {
                    *slot = *x;
                }
            }
        }
        Self { degrees: self.degrees, points }
    }

    /// Bounds of the lengths of the first derivatives and of the second derivatives by uu, uv and vv, for parameters
    /// over `lengths` instead of the unit square: of all that a convex hull property holds for.
    pub(super) fn bounds(&self, n: Vector3, lengths: [f64; 2]) -> ([f64; 2], [Size; 3]) {
        let [p, q] = self.degrees;
        let weights = || self.points.iter().map(|c| c[3]);
        let (light, heavy) = (weights().fold(f64::MAX, f64::min), weights().fold(0.0, f64::max));
        let even = heavy <= light * (1.0 + 1e-14);
        // About the middle point, so that what the weights multiply is small.
        let centre = self.at(p / 2, q / 2);
        let centre = [0, 1, 2].map(|k| centre[k] / centre[3]);
        let local = |i: usize, j: usize| {
            let c = self.at(i, j);
            let w = c[3];
            [c[0] - w * centre[0], c[1] - w * centre[1], c[2] - w * centre[2], w]
        };
        let minus = |a: [f64; 4], b: [f64; 4]| std::array::from_fn::<f64, 4, _>(|k| a[k] - b[k]);
        let (pf, qf) = (p as f64 / lengths[0], q as f64 / lengths[1]);
        let mut nets = [Net::default(); 5];
        let mut reach = Size::default();
        for i in 0..=p {
            for j in 0..=q {
                let c = local(i, j);
                reach.include(Vector3::new(c[0], c[1], c[2]) / c[3], n);
                if i < p {
                    nets[0].include(minus(local(i + 1, j), c), pf, n);
                }
                if j < q {
                    nets[1].include(minus(local(i, j + 1), c), qf, n);
                }
                if i + 2 <= p {
                    let step = minus(minus(local(i + 2, j), local(i + 1, j)), minus(local(i + 1, j), c));
                    nets[2].include(step, pf * (p as f64 - 1.0) / lengths[0], n);
                }
                if i < p && j < q {
                    let step = minus(minus(local(i + 1, j + 1), local(i, j + 1)), minus(local(i + 1, j), c));
                    nets[3].include(step, pf * qf, n);
                }
                if j + 2 <= q {
                    let step = minus(minus(local(i, j + 2), local(i, j + 1)), minus(local(i, j + 1), c));
                    nets[4].include(step, qf * (q as f64 - 1.0) / lengths[1], n);
                }
            }
        }
        let [du, dv, duu, duv, dvv] = nets;
        if even {
            return (
                [du.size.length / light, dv.size.length / light],
                [duu, duv, dvv].map(|net| net.size.over(light)),
            );
        }
        // S = A/w: Su = (Au − wu S)/w and Suu = (Auu − 2 wu Su − wuu S)/w, and so on.
        let su = du.size.plus(reach, du.weight).over(light);
        let sv = dv.size.plus(reach, dv.weight).over(light);
        let suu = duu.size.plus(su, 2.0 * du.weight).plus(reach, duu.weight).over(light);
        let suv = duv.size.plus(sv, du.weight).plus(su, dv.weight).plus(reach, duv.weight).over(light);
        let svv = dvv.size.plus(sv, 2.0 * dv.weight).plus(reach, dvv.weight).over(light);
        ([su.length, sv.length], [suu, suv, svv])
    }
}

/// Bounds of a net of homogeneous differences.
#[derive(Debug, Clone, Copy, Default)]
struct Net {
    size: Size,
    weight: f64,
}

impl Net {
    fn include(&mut self, d: [f64; 4], scale: f64, n: Vector3) {
        self.size.include(Vector3::new(d[0], d[1], d[2]) * scale, n);
        self.weight = self.weight.max((d[3] * scale).abs());
    }
}

impl Size {
    fn plus(self, other: Self, factor: f64) -> Self {
        Self {
            normal: self.normal + factor * other.normal,
            tangent: self.tangent + factor * other.tangent,
            length: self.length + factor * other.length,
        }
    }

    fn over(self, divisor: f64) -> Self {
        Self { normal: self.normal / divisor, tangent: self.tangent / divisor, length: self.length / divisor }
    }
}

/// Restricts Bézier control points to a part of the unit interval, by de Casteljau's algorithm at both ends.
fn restrict(points: &mut [[f64; 4]], [from, to]: [f64; 2]) {
    let n = points.len();
    let mix =
        |a: [f64; 4], b: [f64; 4], x: f64| std::array::from_fn::<f64, 4, _>(|k| a[k] + (b[k] - a[k]) * x);
    if to != 1.0 {
        for level in 1..n {
            for i in (level..n).rev() {
                points[i] = mix(points[i - 1], points[i], to);
            }
        }
    }
    if from != 0.0 {
        let x = if to != 0.0 { from / to } else { 0.0 };
        for level in 1..n {
            for i in 0..n - level {
                points[i] = mix(points[i], points[i + 1], x);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Patch;
    use crate::{NurbsSurface, Point3, Quadrant, Vector3};

    #[test]
    fn bounds_hold_and_are_near() {
        for rational in [false, true] {
            let points: Vec<Point3> = (0..16)
                .map(|k| {
                    let (i, j) = ((k / 4) as f64, (k % 4) as f64);
                    Point3::new(i, j, (i * 1.3).sin() * (j * 0.9).cos())
                })
                .collect();
            let weights: Vec<f64> =
                (0..16).map(|k| if rational { 1.0 + 0.2 * (k as f64).cos() } else { 1.0 }).collect();
            let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
            let surface =
                NurbsSurface::with_weights([3, 3], [4, 4], &points, &weights, [knots.clone(), knots])
                    .unwrap();
            let patch = Patch::new([3, 3], surface.homogeneous_points());
            let (u, v) = ([0.25, 0.375], [0.5, 0.625]);
            let n = Vector3::Z;
            let (first, second) = patch.part([u, v]).bounds(n, [0.125, 0.125]);
            let mut reached = [0.0_f64; 3];
            for i in 0..=10 {
                for j in 0..=10 {
                    let (s, t) = (u[0] + 0.0125 * i as f64, v[0] + 0.0125 * j as f64);
                    let d = surface.derivatives(s, t, 2, Quadrant::NorthEast);
                    assert!(d.get(1, 0).length() <= first[0] * (1.0 + 1e-12));
                    assert!(d.get(0, 1).length() <= first[1] * (1.0 + 1e-12));
                    for (k, x) in [d.get(2, 0), d.get(1, 1), d.get(0, 2)].into_iter().enumerate() {
                        assert!(x.length() <= second[k].length * (1.0 + 1e-12));
                        assert!(x.z.abs() <= second[k].normal * (1.0 + 1e-12) + 1e-12);
                        reached[k] = reached[k].max(x.length());
                    }
                }
            }
            let slack = if rational { 1.8 } else { 1.2 };
            assert!((0..3).all(|k| second[k].length <= slack * reached[k]), "{second:?} {reached:?}");
        }
    }
}
