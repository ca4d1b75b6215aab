//! Bézier patches and bounds of their derivatives by control points.

use super::bend::{Greatest, Size, greater};
use crate::Vector3;
use crate::meshing::thresholds::EVEN_WEIGHTS;

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
        let q = self.degrees[1];
        let mut points = self.points.clone();
        if v != [0.0, 1.0] {
            for row in points.chunks_mut(q + 1) {
                restrict(row, 1, v);
            }
        }
        if u != [0.0, 1.0] {
            restrict(&mut points, q + 1, u);
        }
        Self { degrees: self.degrees, points }
    }

    /// The partial derivatives by u and v, over the unit square, in the middle, at the corners and in the middles of the
    /// sides, in this order. The bases are those of the patch's degrees.
    pub(super) fn partials(&self, bases: &[Bases; 2]) -> [[Vector3; 2]; 9] {
        const PLACES: [[usize; 2]; 9] =
            [[1, 1], [0, 0], [2, 0], [2, 2], [0, 2], [1, 0], [2, 1], [1, 2], [0, 1]];
        // The point, and its derivatives by u and by v, at three places of u times three of v.
        let mut sums = [[[[0.0_f64; 4]; 3]; 3]; 3];
        for (row, by_u) in self.points.chunks(self.degrees[1] + 1).zip(&bases[0].0) {
            // The row's own point and derivative at the three places: all rows are mixed from these.
            let mut own = [[[0.0_f64; 4]; 2]; 3];
            for (c, by_v) in row.iter().zip(&bases[1].0) {
                for (own, &(b, db)) in own.iter_mut().zip(by_v) {
                    // At an end all but two are zero.
                    if b != 0.0 || db != 0.0 {
                        add(&mut own[0], c, b);
                        add(&mut own[1], c, db);
                    }
                }
            }
            for (sums, &(a, da)) in sums.iter_mut().zip(by_u) {
                if a != 0.0 || da != 0.0 {
                    for (sum, own) in sums.iter_mut().zip(&own) {
                        add(&mut sum[0], &own[0], a);
                        add(&mut sum[1], &own[0], da);
                        add(&mut sum[2], &own[1], a);
                    }
                }
            }
        }
        let mut out = [[Vector3::ZERO; 2]; 9];
        for (out, [i, j]) in out.iter_mut().zip(PLACES) {
            // S = A/w: Su = (Au − wu S)/w.
            let [point, by_u, by_v] = &sums[i][j];
            let weight = 1.0 / point[3];
            let place = Vector3::new(point[0], point[1], point[2]) * weight;
            let partial = |d: &[f64; 4]| (Vector3::new(d[0], d[1], d[2]) - place * d[3]) * weight;
            *out = [partial(by_u), partial(by_v)];
        }
        out
    }

    /// Bounds of the lengths of the first derivatives and of the second derivatives by uu, uv and vv, for parameters
    /// over `lengths` instead of the unit square: of all that a convex hull property holds for.
    pub(super) fn bounds(&self, n: Vector3, lengths: [f64; 2]) -> ([f64; 2], [Size; 3]) {
        let [p, q] = self.degrees;
        let weights = || self.points.iter().map(|c| c[3]);
        let (light, heavy) = (weights().fold(f64::MAX, f64::min), weights().fold(0.0, f64::max));
        let even = heavy <= light * (1.0 + EVEN_WEIGHTS);
        if !even {
            if let Some(own) = self.plain_along(1, n, lengths) {
                return ([own.first_across, own.first], [own.second_across, own.twist, own.second]);
            }
            if let Some(own) = self.plain_along(0, n, lengths) {
                return ([own.first, own.first_across], [own.second, own.twist, own.second_across]);
            }
        }
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
        let mut reach = Greatest::default();
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
        let [du, dv, duu, duv, dvv] = nets.map(Net::done);
        let reach = reach.size();
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

    /// The bounds of derivatives by a direction along which the weights do not change: then steps between neighbours
    /// are points of a patch with the weights of the other direction, and where they are all the same, as on a tube
    /// that is straight, nothing twists.
    fn plain_along(&self, d: usize, n: Vector3, lengths: [f64; 2]) -> Option<Plain> {
        let (along, across) = (self.degrees[d], self.degrees[1 - d]);
        let at = |k: usize, l: usize| if d == 0 { self.at(k, l) } else { self.at(l, k) };
        let even = |l: usize| {
            let w = at(0, l)[3];
            (1..=along).all(|k| (at(k, l)[3] - w).abs() <= EVEN_WEIGHTS * w)
        };
        if !(0..=across).all(even) {
            return None;
        }
        let weight = |l: usize| at(0, l)[3];
        let mut points = Vec::with_capacity((along + 1) * (across + 1));
        for l in 0..=across {
            let own = 1.0 / weight(l);
            points.extend((0..=along).map(|k| {
                let c = at(k, l);
                Vector3::new(c[0], c[1], c[2]) * own
            }));
        }
        let point = |k: usize, l: usize| points.get(l * (along + 1) + k).copied().unwrap_or(Vector3::ZERO);
        let step = |k: usize, l: usize| point(k + 1, l) - point(k, l);
        let centre =
            if along > 0 { step(along / 2 - usize::from(along > 1), across / 2) } else { Vector3::ZERO };
        let (by, by_across) = (along as f64 / lengths[d], across as f64 / lengths[1 - d]);
        let light = (0..=across).map(weight).fold(f64::MAX, f64::min);
        let mut first = 0.0_f64;
        let (mut second, mut reach, mut net) = (Greatest::default(), Greatest::default(), Net::default());
        for l in 0..=across {
            for k in 0..along {
                let own = step(k, l);
                first = greater(first, own.length_squared());
                reach.include(own - centre, n);
                if k + 1 < along {
                    let bend = step(k + 1, l) - own;
                    second.include(bend * (by * (along as f64 - 1.0) / lengths[d]), n);
                }
                if l < across {
                    let off = (step(k, l + 1) - centre) * weight(l + 1) - (own - centre) * weight(l);
                    net.include([off.x, off.y, off.z, weight(l + 1) - weight(l)], by_across, n);
                }
            }
        }
        let (first, second, net) = (first.sqrt() * by, second.size(), net.done());
        let twist = net.size.plus(reach.size(), net.weight).over(light);
        // Every row across is a curve of its own, whose points the other direction only mixes.
        let (mut first_across, mut second_across) = (0.0_f64, Size::default());
        for k in 0..=along {
            let (speed, bend) = row_bounds(across, |l| at(k, l), n, by_across, light);
            first_across = first_across.max(speed);
            second_across = second_across.max(&bend);
        }
        let twist = Size::default().plus(twist, by);
        Some(Plain { first, second, twist, first_across, second_across })
    }
}

fn add(sum: &mut [f64; 4], point: &[f64; 4], factor: f64) {
    for (sum, x) in sum.iter_mut().zip(point) {
        *sum += factor * x;
    }
}

/// The Bernstein polynomials of one degree with their derivatives, each at the start, in the middle and at the end.
pub(super) struct Bases(Vec<[(f64, f64); 3]>);

impl Bases {
    pub(super) fn new(degree: usize) -> Self {
        let places = [0.0, 0.5, 1.0].map(|t| bernstein(degree, t));
        Self((0..=degree).map(|i| [0, 1, 2].map(|k| places[k].get(i).copied().unwrap_or_default())).collect())
    }
}

/// The Bernstein polynomials of one degree at a parameter, and their derivatives.
fn bernstein(degree: usize, t: f64) -> Vec<(f64, f64)> {
    // Those of the degree below first: they give the derivatives, and one step more gives the values.
    let mut lower = vec![0.0; degree.max(1)];
    lower[0] = 1.0;
    for level in 1..degree {
        for i in (0..=level).rev() {
            let before = if i > 0 { lower[i - 1] } else { 0.0 };
            lower[i] = (1.0 - t) * lower[i] + t * before;
        }
    }
    let at = |i: usize| lower.get(i).copied().unwrap_or(0.0);
    let values = (0..=degree).map(|i| {
        let before = if i > 0 { at(i - 1) } else { 0.0 };
        if degree == 0 {
            return (1.0, 0.0);
        }
        ((1.0 - t) * at(i) + t * before, degree as f64 * (before - at(i)))
    });
    values.collect()
}

/// Bounds of the first and second derivatives of a rational curve: its degree and control points, the degree over the
/// length of its range, and its least weight.
fn row_bounds(degree: usize, at: impl Fn(usize) -> [f64; 4], n: Vector3, by: f64, light: f64) -> (f64, Size) {
    let middle = at(degree.div_ceil(2));
    let centre = [0, 1, 2].map(|k| middle[k] / middle[3]);
    let minus = |a: &[f64; 4], b: &[f64; 4]| std::array::from_fn::<f64, 4, _>(|k| a[k] - b[k]);
    let again = by * by * (degree as f64 - 1.0) / (degree as f64).max(1.0);
    let (mut once, mut twice, mut reach) = (Net::default(), Net::default(), Greatest::default());
    let (mut before, mut last): (Option<[f64; 4]>, Option<[f64; 4]>) = (None, None);
    for k in 0..=degree {
        let c = at(k);
        // About the middle point, so that what the weights multiply is small.
        let c = [c[0] - c[3] * centre[0], c[1] - c[3] * centre[1], c[2] - c[3] * centre[2], c[3]];
        reach.include(Vector3::new(c[0], c[1], c[2]) * (1.0 / c[3]), n);
        if let Some(before) = before {
            let step = minus(&c, &before);
            once.include(step, by, n);
            if let Some(last) = last {
                twice.include(minus(&step, &last), again, n);
            }
            last = Some(step);
        }
        before = Some(c);
    }
    let (once, twice, reach) = (once.done(), twice.done(), reach.size());
    let speed = once.size.plus(reach, once.weight).over(light);
    (speed.length, twice.size.plus(speed, 2.0 * once.weight).plus(reach, twice.weight).over(light))
}

/// Bounds of derivatives by a direction along which weights do not change, and by the other one.
struct Plain {
    first: f64,
    second: Size,
    twist: Size,
    first_across: f64,
    second_across: Size,
}

/// A net of homogeneous differences.
#[derive(Debug, Clone, Copy, Default)]
struct Net {
    size: Greatest,
    weight: f64,
}

/// Bounds of a net of homogeneous differences.
struct NetBounds {
    size: Size,
    weight: f64,
}

impl Net {
    fn include(&mut self, d: [f64; 4], scale: f64, n: Vector3) {
        self.size.include(Vector3::new(d[0], d[1], d[2]) * scale, n);
        self.weight = greater(self.weight, (d[3] * scale).abs());
    }

    fn done(self) -> NetBounds {
        NetBounds { size: self.size.size(), weight: self.weight }
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

    fn max(self, other: &Self) -> Self {
        Self {
            normal: self.normal.max(other.normal),
            tangent: self.tangent.max(other.tangent),
            length: self.length.max(other.length),
        }
    }

    fn over(self, divisor: f64) -> Self {
        Self { normal: self.normal / divisor, tangent: self.tangent / divisor, length: self.length / divisor }
    }
}

/// Restricts rows of Bézier control points, of so many points each, to a part of the unit interval across them, by de
/// Casteljau's algorithm at both ends.
fn restrict(points: &mut [[f64; 4]], width: usize, [from, to]: [f64; 2]) {
    let n = points.len() / width;
    // Two neighbouring rows become one between them: in place of the later one, or of the earlier one.
    let mut mix = |i: usize, later: bool, x: f64| {
        let Some(pair) = points.get_mut(i * width..(i + 2) * width) else { return };
        let (first, second) = pair.split_at_mut(width);
        for (a, b) in first.iter_mut().zip(second) {
            for (a, b) in a.iter_mut().zip(b) {
                let mixed = *a + (*b - *a) * x;
                *(if later { b } else { a }) = mixed;
            }
        }
    };
    if to != 1.0 {
        for level in 1..n {
            for i in (level..n).rev() {
                mix(i - 1, true, to);
            }
        }
    }
    if from != 0.0 {
        let x = if to != 0.0 { from / to } else { 0.0 };
        for level in 1..n {
            for i in 0..n - level {
                mix(i, false, x);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Bases, Patch};
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

    #[test]
    fn partials_are_those_of_the_surface() {
        let points: Vec<Point3> = (0..12)
            .map(|k| {
                let (i, j) = ((k / 4) as f64, (k % 4) as f64);
                Point3::new(i + 0.1 * j * j, j - 0.2 * i, (i * 1.3 + j).sin())
            })
            .collect();
        let weights: Vec<f64> = (0..12).map(|k| 1.0 + 0.3 * (k as f64).cos()).collect();
        let knots = [vec![0.0, 0.0, 1.0, 1.0], vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0]];
        let surface = NurbsSurface::with_weights([2, 3], [3, 4], &points, &weights, knots).unwrap();
        let patch = Patch::new([2, 3], surface.homogeneous_points());
        let (u, v) = ([0.25, 0.75], [0.0, 0.5]);
        let places = [
            [0.5, 0.5],
            [0.0, 0.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [0.0, 1.0],
            [0.5, 0.0],
            [1.0, 0.5],
            [0.5, 1.0],
            [0.0, 0.5],
        ];
        let bases = [2, 3].map(Bases::new);
        for ([du, dv], [x, y]) in patch.part([u, v]).partials(&bases).into_iter().zip(places) {
            let d = surface.derivatives(0.25 + 0.5 * x, 0.5 * y, 1, Quadrant::NorthEast);
            assert!((du - d.get(1, 0) * 0.5).length() < 1e-12, "{x} {y}");
            assert!((dv - d.get(0, 1) * 0.5).length() < 1e-12, "{x} {y}");
        }
        let flat = Patch::new([1, 0], vec![[0.0, 0.0, 0.0, 1.0], [3.0, 0.0, 0.0, 1.0]]);
        assert_eq!(flat.partials(&[1, 0].map(Bases::new))[4], [Vector3::new(3.0, 0.0, 0.0), Vector3::ZERO]);
    }

    /// A straight tube does not twist, whatever the weights around it; a cone's twist is what it is.
    #[test]
    fn tubes_with_weights_around() {
        let w = 0.5_f64.sqrt();
        for top in [1.0, 0.25] {
            let ring = |r: f64, z: f64| [[r, 0.0, z, 1.0], [r * w, r * w, z * w, w], [0.0, r, z, 1.0]];
            let (low, high) = (ring(1.0, 0.0), ring(top, 50.0));
            let points: Vec<[f64; 4]> = low.into_iter().zip(high).flat_map(|(a, b)| [a, b]).collect();
            let patch = Patch::new([2, 1], points.clone());
            let around: Vec<[f64; 4]> =
                points.chunks(2).map(|c| c[0]).chain(points.chunks(2).map(|c| c[1])).collect();
            for (patch, along) in [(patch, 1), (Patch::new([1, 2], around), 0)] {
                let (first, second) = patch.bounds(Vector3::Z, [1.0, 1.0]);
                // The corner of the control points is √2 away from the axis.
                let [side, corner] = [1.0, 2_f64.sqrt()].map(|x| 50_f64.hypot(x * (1.0 - top)));
                assert!((side - 1e-12..=corner + 1e-12).contains(&first[along]), "{first:?}");
                // However long the tube.
                assert!(first[1 - along] < 4.0, "{first:?}");
                // A quarter of a circle begins with a speed of √2.
                let least = 2_f64.sqrt() * (1.0 - top);
                assert!(second[1].length >= least - 1e-12 && second[1].length <= 3.0 * least + 1e-12);
                assert!(second[if along == 1 { 2 } else { 0 }].length == 0.0);
            }
        }
    }
}
