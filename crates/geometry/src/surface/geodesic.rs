//! Shortest ways on surfaces.

mod network;
mod relax;
mod shoot;

pub(crate) use shoot::{Shot, shot};

use super::Surface;
use crate::curve::traced::{Sample, joined};
use crate::thresholds;
use crate::{Curve, Direction, Error, Interval, Point3, Result, SurfaceDerivatives, Tolerance, Vector3};

/// A way on a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Geodesic {
    /// The way, within the tolerance of the surface.
    pub curve: Curve,
    /// Its length.
    pub length: f64,
}

/// The most points of a way.
const MOST: usize = 2049;

/// A surface whose closed directions go on without end.
#[derive(Debug)]
pub(crate) struct Unrolled<'a> {
    surface: &'a Surface,
    pub(crate) domains: [Interval; 2],
    pub(crate) closed: [bool; 2],
}

impl<'a> Unrolled<'a> {
    pub(crate) fn new(surface: &'a Surface) -> Self {
        let domains = Direction::BOTH.map(|d| surface.domain(d));
        Self { surface, domains, closed: Direction::BOTH.map(|d| surface.is_closed(d)) }
    }

    /// A place within the domain: closed directions by whole turns, others moved to the side.
    pub(crate) fn wrapped(&self, uv: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|d| {
            let domain = self.domains[d];
            if self.closed[d] && !(domain.start <= uv[d] && uv[d] <= domain.end) {
                domain.start + (uv[d] - domain.start).rem_euclid(domain.length())
            } else {
                domain.clamp(uv[d])
            }
        })
    }

    /// Whether a place lies beyond a side that is no seam.
    pub(crate) fn is_outside(&self, uv: [f64; 2]) -> bool {
        (0..2).any(|d| !(self.closed[d] || (self.domains[d].start..=self.domains[d].end).contains(&uv[d])))
    }

    pub(crate) fn point(&self, uv: [f64; 2]) -> Point3 {
        let [u, v] = self.wrapped(uv);
        self.surface.point_at(u, v)
    }

    pub(crate) fn jet(&self, uv: [f64; 2], order: usize) -> SurfaceDerivatives {
        let [u, v] = self.wrapped(uv);
        self.surface.derivatives(u, v, order, self.surface.inner_quadrant(u, v))
    }

    pub(crate) fn normal(&self, uv: [f64; 2]) -> Option<Vector3> {
        let [u, v] = self.wrapped(uv);
        self.surface.normal_at(u, v)
    }
}

impl Surface {
    /// The shortest way on the surface between two places, given by their parameters. Over the seams of closed directions
    /// it may go; sides of others hold it.
    ///
    /// A first way is the shortest on a grid of 48 by 48 places with 16 neighbours each (E. Dijkstra, 1959). Then the
    /// sum of squares of the steps, whose minima are geodesics walked evenly, is brought to its minimum next to it by Newton's
    /// method (block-tridiagonal, with damping), and the number of points doubled until the way no longer moves by the
    /// tolerance. The result is a locally shortest way. Where two ways around an obstacle or a bump are equally long to a
    /// few per cent, the grid may choose the longer.
    ///
    /// # Errors
    /// A parameter is not finite or outside the domain, or both places are the same point.
    pub fn geodesic(&self, from: [f64; 2], to: [f64; 2], tolerance: &Tolerance) -> Result<Geodesic> {
        let sheet = Unrolled::new(self);
        for uv in [from, to] {
            if !uv.iter().all(|x| x.is_finite()) {
                return Err(Error::NotFinite("parameter on the surface"));
            }
            for d in 0..2 {
                let domain = sheet.domains[d];
                let slack = thresholds::SAME_PARAMETER * domain.length();
                if !(domain.start - slack <= uv[d] && uv[d] <= domain.end + slack) {
                    return Err(Error::OutOfRange {
                        what: "parameter on the surface",
                        value: uv[d],
                        must: "within the domain",
                    });
                }
            }
        }
        let ends = [from, to].map(|uv| sheet.point(uv));
        let first = network::way(&sheet, from, to);
        let rough: f64 = first.windows(2).map(|w| sheet.point(w[0]).distance_to(sheet.point(w[1]))).sum();
        if !(rough > thresholds::ROUNDING * (1.0 + ends[0].to_vector().length())) {
            return Err(Error::degenerate("places on the surface", "they are the same point"));
        }
        let limit = tolerance.absolute.max(thresholds::SAME_POINT * rough);
        let mut way = relax::spread(&sheet, &first, 17);
        relax::relax(&sheet, &mut way);
        loop {
            let finer = relax::doubled(&way);
            let mut better = finer.clone();
            relax::relax(&sheet, &mut better);
            let moved = finer
                .iter()
                .zip(&better)
                .map(|(a, b)| sheet.point(*a).distance_to(sheet.point(*b)))
                .fold(0.0, f64::max);
            way = better;
            if moved <= 0.2 * limit || way.len() * 2 > MOST {
                break;
            }
        }
        let samples = samples(&sheet, &way);
        let curve =
            joined(&[samples], thresholds::SAME_POINT * rough, std::f64::consts::PI)?.into_iter().next();
        let curve = curve.ok_or(Error::degenerate("places on the surface", "they are the same point"))?;
        let length = curve.length();
        Ok(Geodesic { curve, length })
    }
}

/// The points of a way with directions along it, in the tangent planes.
fn samples(sheet: &Unrolled<'_>, way: &[[f64; 2]]) -> Vec<Sample> {
    let points: Vec<Point3> = way.iter().map(|uv| sheet.point(*uv)).collect();
    let n = points.len();
    let at = |i: usize| points.get(i).copied().unwrap_or(Point3::ORIGIN);
    let flat = |v: Vector3, i: usize| {
        let normal = way.get(i).and_then(|uv| sheet.normal(*uv)).unwrap_or(Vector3::ZERO);
        (v - normal * v.dot(normal)).unitized()
    };
    (0..n)
        .map(|i| {
            // At the ends the parabola through three points tells.
            let along = if n < 3 {
                at(n - 1) - at(0)
            } else if i == 0 {
                (at(1) - at(0)) * 4.0 - (at(2) - at(0))
            } else if i + 1 == n {
                (at(n - 1) - at(n - 2)) * 4.0 - (at(n - 1) - at(n - 3))
            } else {
                at(i + 1) - at(i - 1)
            };
            Sample { point: at(i), direction: flat(along, i) }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use crate::{
        Cone, Cylinder, Direction, Interval, NurbsSurface, Plane, PlaneSurface, Point3, Sphere, Surface,
        Tolerance, Torus,
    };

    fn between(surface: &Surface, a: Point3, b: Point3) -> super::Geodesic {
        let [a, b] = [a, b].map(|p| surface.closest_point(p).unwrap()).map(|c| [c.u, c.v]);
        let way = surface.geodesic(a, b, &Tolerance::default()).unwrap();
        for k in 0..=100 {
            let p = way.curve.point_at(way.curve.domain().at(f64::from(k) / 100.0));
            assert!(surface.closest_point(p).unwrap().distance < 1e-3);
        }
        way
    }

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    #[test]
    fn great_circles() {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 5.0).unwrap().into();
        for (a, b) in [
            ([1.0, 0.2, 0.3], [-0.2, 1.0, 0.5]),
            // Across the seam, and over a pole.
            ([1.0, -0.5, 0.1], [1.0, 0.6, -0.2]),
            ([0.6, 0.1, 1.0], [-0.5, 0.1, 1.0]),
        ] {
            let [a, b] = [a, b].map(|v| crate::Vector3::from(v).with_length(5.0).unwrap());
            let way = between(&ball, a.to_point(), b.to_point());
            let want = 5.0 * a.angle_to(b).unwrap();
            assert!((way.length - want).abs() < 2e-4 * want, "{} {want}", way.length);
        }
    }

    #[test]
    fn rolled_surfaces() {
        let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 10.0)).unwrap().into();
        for turn in [0.5, 2.5, 3.0, 4.0, 6.0] {
            let way = between(&tube, p(2.0, 0.0, 1.0), p(2.0 * f64::cos(turn), 2.0 * f64::sin(turn), 9.0));
            let short: f64 = if turn > PI { 2.0 * PI - turn } else { turn };
            let want = (2.0 * short).hypot(8.0);
            assert!((way.length - want).abs() < 1e-4 * want, "{turn}: {} {want}", way.length);
        }
        // A cone of half angle 30° unrolls to a half disk.
        let cone = Cone::new(Plane::XY, 3f64.sqrt() * 4.0, 4.0).unwrap();
        let cone: Surface = cone.into();
        let (u, v) = (cone.domain(Direction::U), cone.domain(Direction::V));
        let rim = |x: f64| [[u.at(x), v.end], [u.at(x), v.start]].map(|w| cone.point_at(w[0], w[1]));
        let wide = |x: f64| {
            let [a, b] = rim(x);
            if (a - Point3::ORIGIN).x.hypot(a.y) > (b - Point3::ORIGIN).x.hypot(b.y) { a } else { b }
        };
        let way = between(&cone, wide(0.1), wide(0.35));
        // A quarter turn around is 45° in the plane, at a radius of 8.
        let want = 16.0 * (PI / 8.0).sin();
        assert!((way.length - want).abs() < 1e-3 * want, "{} {want}", way.length);
    }

    #[test]
    fn flat_and_bent() {
        let side = Interval::new(0.0, 4.0);
        let flat: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let way = between(&flat, p(0.5, 1.0, 0.0), p(3.5, 3.0, 0.0));
        assert!((way.length - 13f64.sqrt()).abs() < 1e-9);
        // Around the hole of a ring it keeps to the inner side.
        let ring: Surface = Torus::new(Plane::XY, 5.0, 2.0).unwrap().into();
        let way = between(&ring, p(3.0, 0.0, 0.0), p(-2.0, 3.0 * (5f64 / 9.0).sqrt(), 0.0));
        assert!(way.length < 3.0 * 2.42 && way.length > 5.2, "{}", way.length);
        let n = 7;
        let points: Vec<Point3> = (0..n * n)
            .map(|k| {
                let (i, j) = ((k / n) as f64, (k % n) as f64);
                p(i, j, 1.5 * (1.3 * i).sin() * (1.1 * j + 0.4).cos())
            })
            .collect();
        let knots = || crate::clamped_uniform_knots(3, n).unwrap();
        let hills: Surface = NurbsSurface::new([3, 3], [n, n], points, [knots(), knots()]).unwrap().into();
        let [u, v] = Direction::BOTH.map(|d| hills.domain(d));
        let way =
            hills.geodesic([u.at(0.1), v.at(0.1)], [u.at(0.9), v.at(0.8)], &Tolerance::default()).unwrap();
        // The curve bends only along the normal: its own curvature has no part in the tangent plane.
        for k in 1..20 {
            let t = way.curve.domain().at(f64::from(k) / 20.0);
            let near = hills.closest_point(way.curve.point_at(t)).unwrap();
            let normal = hills.normal_at(near.u, near.v).unwrap();
            let bend = way.curve.curvature_at(t);
            assert!((bend - normal * bend.dot(normal)).length() < 0.05, "{k} {bend:?}");
        }
        assert!(hills.geodesic([u.start, v.start], [u.start, v.start], &Tolerance::default()).is_err());
        assert!(hills.geodesic([u.start, v.start], [u.end + 1.0, v.start], &Tolerance::default()).is_err());
    }
}
