//! What becomes of trims when a surface takes a form with other parameters: a surface of revolution, or a sum with an
//! arc in it, as a NURBS surface. Each parameter moves for itself, and only along arcs.

use katydid_elementary::Elementary;

use super::trimmed::followed;
use crate::{Arc, Curve, Direction, Interval, Line, LineCurve, Plane, Point3, Result, Surface, Vector3};

/// How near to the exact place a moved trim is, as a part of the domain.
const NEAR: f64 = 1e-9;

/// A stretch of parameters over which an arc's angle grows evenly, and over which the conic that takes its place has
/// its own pace.
#[derive(Debug, Clone, Copy)]
struct ArcStretch {
    domain: Interval,
    spans: f64,
    /// The tangent of a quarter of the angle of one span.
    quarter: f64,
    /// A quarter of that angle's double: half of the span's angle.
    half: f64,
}

impl ArcStretch {
    fn new(angle: f64, domain: Interval) -> Self {
        let spans = Arc::spans_of(angle);
        let half = angle.abs() / (2.0 * spans as f64);
        Self { domain, spans: spans as f64, quarter: (0.5 * half).tangent(), half }
    }

    /// The conic's parameter for the arc's, and how fast the one grows with the other.
    ///
    /// In a span, a rational quadratic arc in standard form runs evenly with the tangent of half the angle from the
    /// span's middle.
    fn moved(&self, t: f64) -> (f64, f64) {
        let along = self.domain.normalized(t) * self.spans;
        let span = along.floor().clamp(0.0, self.spans - 1.0);
        let local = along - span;
        if local == 0.0 || local == 1.0 || local == 0.5 {
            return (t, self.pace(2.0 * local - 1.0));
        }
        let from_middle = 2.0 * local - 1.0;
        let tangent = (0.5 * self.half * from_middle).tangent() / self.quarter;
        (self.domain.at((span + 0.5 * (1.0 + tangent)) / self.spans), self.pace(from_middle))
    }

    fn pace(&self, from_middle: f64) -> f64 {
        let cos = (0.5 * self.half * from_middle).cosine();
        0.5 * self.half / (self.quarter * cos * cos)
    }
}

/// How a parameter moves when arcs become NURBS curves; elsewhere it stays.
#[derive(Debug, Clone)]
pub(crate) struct ParameterMap {
    domain: Interval,
    arcs: Vec<ArcStretch>,
}

impl ParameterMap {
    /// No parameter moves.
    fn identity(domain: Interval) -> Self {
        Self { domain, arcs: Vec::new() }
    }

    /// From a curve to its NURBS form.
    fn of_curve(curve: &Curve) -> Self {
        let mut map = Self::identity(curve.domain());
        map.add(curve, curve.domain());
        map
    }

    /// From a curve to an image of it that has the same kind, but for arcs that became NURBS curves.
    pub(super) fn of_image(curve: &Curve, image: &Curve) -> Self {
        let mut map = Self::identity(curve.domain());
        match (curve, image) {
            (Curve::Arc(_), Curve::Nurbs(_)) => map.add(curve, curve.domain()),
            (Curve::Poly(a), Curve::Poly(b)) => {
                for (i, (from, to)) in a.segments().iter().zip(b.segments()).enumerate() {
                    if matches!((from, to), (Curve::Arc(_), Curve::Nurbs(_))) {
                        map.add(from, a.segment_domain(i));
                    }
                }
            }
            _ => {}
        }
        map
    }

    fn add(&mut self, curve: &Curve, domain: Interval) {
        match curve {
            Curve::Arc(arc) => self.arcs.push(ArcStretch::new(arc.arc.angle.length(), domain)),
            Curve::Poly(chain) => {
                let whole = chain.domain();
                for (i, segment) in chain.segments().iter().enumerate() {
                    let own = chain.segment_domain(i);
                    let at = |t: f64| if whole == domain { t } else { domain.at(whole.normalized(t)) };
                    self.add(segment, Interval::new(at(own.start), at(own.end)));
                }
            }
            Curve::Line(_) | Curve::Polyline(_) | Curve::Nurbs(_) => {}
        }
    }

    pub(super) fn is_identity(&self) -> bool {
        self.arcs.is_empty()
    }

    /// The parameters where one span of an arc ends and the next begins: the second derivative jumps there.
    fn knots(&self) -> impl Iterator<Item = f64> {
        self.arcs.iter().flat_map(|arc| {
            let spans = arc.spans as usize;
            (0..=spans).map(move |k| arc.domain.at(k as f64 / arc.spans))
        })
    }

    /// Where a parameter goes, and the derivative.
    ///
    /// An arc at the end of the domain goes on beyond it: a trim may lie outside the domain by a rounding, and must not
    /// change its pace there.
    fn at(&self, t: f64) -> (f64, f64) {
        let inside = self.domain.clamp(t);
        let arc = self.arcs.iter().find(|arc| arc.domain.contains(inside));
        arc.map_or((t, 1.0), |arc| arc.moved(t))
    }
}

/// How both parameters of a surface move.
#[derive(Debug, Clone)]
pub(crate) struct ParameterMaps {
    maps: [ParameterMap; 2],
    /// The shorter domain.
    size: f64,
}

impl ParameterMaps {
    /// From a surface to its NURBS form.
    pub(crate) fn to_nurbs(surface: &Surface) -> Self {
        let maps = match surface {
            Surface::Plane(_) | Surface::Nurbs(_) => identity(surface),
            Surface::Sum(sum) => sum.curves().each_ref().map(ParameterMap::of_curve),
            Surface::Revolution(turned) => {
                let round = turned.angle_direction();
                let stretch = ArcStretch::new(turned.angle().length(), turned.domain(round));
                Direction::BOTH.map(|direction| match direction == round {
                    true => ParameterMap { domain: stretch.domain, arcs: vec![stretch] },
                    false => ParameterMap::of_curve(turned.profile()),
                })
            }
        };
        Self { maps, size: size(surface) }
    }

    /// From a surface to its image under [`Surface::transformed`].
    pub(crate) fn to_image(surface: &Surface, image: &Surface) -> Self {
        let maps = match (surface, image) {
            (Surface::Revolution(_) | Surface::Sum(_), Surface::Nurbs(_)) => return Self::to_nurbs(surface),
            (Surface::Sum(a), Surface::Sum(b)) => {
                let ([a, b], [c, d]) = (a.curves(), b.curves());
                [ParameterMap::of_image(a, c), ParameterMap::of_image(b, d)]
            }
            (Surface::Revolution(a), Surface::Revolution(b)) => {
                let along = ParameterMap::of_image(a.profile(), b.profile());
                let round = ParameterMap::identity(a.domain(a.angle_direction()));
                match a.angle_direction() {
                    Direction::U => [round, along],
                    Direction::V => [along, round],
                }
            }
            _ => identity(surface),
        };
        Self { maps, size: size(surface) }
    }

    /// Whether no parameter moves.
    pub(crate) fn is_identity(&self) -> bool {
        self.maps.iter().all(ParameterMap::is_identity)
    }

    /// The stretches of a curve of the parameter plane over which its image is as smooth as itself.
    fn stretches(&self, flat: &Curve) -> Result<Vec<Interval>> {
        let mut cuts = Vec::new();
        for (map, normal) in self.maps.iter().zip([Vector3::X, Vector3::Y]) {
            for knot in map.knots() {
                let plane = Plane::from_normal(Point3::ORIGIN + normal * knot, normal)?;
                cuts.extend(flat.intersect_plane(&plane, NEAR * self.size)?);
            }
        }
        cuts.sort_by(f64::total_cmp);
        let mut out = Vec::new();
        for whole in flat.smooth_stretches() {
            // Cuts nearer to each other or to an end than this part of the stretch make no stretch of their own.
            let least = NEAR * whole.length();
            let mut start = whole.start;
            for &cut in &cuts {
                if cut - start > least && whole.end - cut > least {
                    out.push(Interval::new(start, cut));
                    start = cut;
                }
            }
            out.push(Interval::new(start, whole.end));
        }
        Ok(out)
    }

    /// The curve of the parameter plane that another becomes: exact where it runs along a parameter line, else within a
    /// billionth of the domain.
    ///
    /// # Errors
    /// It cannot be followed.
    pub(crate) fn moved(&self, flat: &Curve) -> Result<Curve> {
        if self.is_identity() {
            return Ok(flat.clone());
        }
        let [u, v] = &self.maps;
        let point = |p: Point3| Point3::new(u.at(p.x).0, v.at(p.y).0, 0.0);
        if let Curve::Line(straight) = flat {
            let (a, b) = (straight.line.from, straight.line.to);
            if a.x == b.x || a.y == b.y {
                return Ok(LineCurve { line: Line::new(point(a), point(b)), domain: straight.domain }.into());
            }
        }
        let formula = |t: f64, below: bool| -> Result<(Point3, Vector3)> {
            let [place, slope] = flat.jet_at::<2>(t, below);
            let (x, y) = (u.at(place.x), v.at(place.y));
            Ok((Point3::new(x.0, y.0, 0.0), Vector3::new(slope.x * x.1, slope.y * y.1, 0.0)))
        };
        Ok(followed(&self.stretches(flat)?, NEAR * self.size, formula)?.into())
    }
}

fn identity(surface: &Surface) -> [ParameterMap; 2] {
    Direction::BOTH.map(|direction| ParameterMap::identity(surface.domain(direction)))
}

fn size(surface: &Surface) -> f64 {
    let lengths = Direction::BOTH.map(|direction| surface.domain(direction).length());
    lengths[0].min(lengths[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Circle, NurbsCurve, PlaneSurface, RevolutionSurface, Sphere};

    #[test]
    fn a_moved_parameter_names_the_same_point() {
        let ball: Surface = Sphere::around(Point3::new(1.0, 2.0, 3.0), 2.0).unwrap().into();
        let profile: Curve = Line::new(Point3::new(1.0, 0.0, 0.0), Point3::new(3.0, 0.0, 4.0)).into();
        let axis = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0));
        for angle in [0.5, 2.0, 3.5, 6.0] {
            let turned = RevolutionSurface::with_domain(
                profile.clone(),
                axis,
                Interval::new(0.2, 0.2 + angle),
                Interval::new(-3.0, 8.0),
            );
            for surface in [ball.clone(), turned.unwrap().into()] {
                let nurbs = surface.to_nurbs().unwrap();
                let maps = ParameterMaps::to_nurbs(&surface);
                let [du, dv] = Direction::BOTH.map(|d| surface.domain(d));
                for i in 0..=20 {
                    let (x, y) = (f64::from(i) / 20.0, f64::from((7 * i) % 21) / 21.0);
                    let (u, v) = (du.at(x), dv.at(y));
                    let (mu, mv) = (maps.maps[0].at(u).0, maps.maps[1].at(v).0);
                    let miss = surface.point_at(u, v).distance_to(nurbs.point_at(mu, mv));
                    assert!(miss < 1e-12, "{miss} at {u} {v}");
                    let h = 1e-6 * du.length();
                    if du.contains(u + h) && du.contains(u - h) {
                        let slope = (maps.maps[0].at(u + h).0 - maps.maps[0].at(u - h).0) / (2.0 * h);
                        // At a knot the second derivative changes its sign: the quotient is off by as much as h has.
                        assert!((slope - maps.maps[0].at(u).1).abs() < h, "{slope}");
                    }
                }
            }
        }
        let sheet: Surface = PlaneSurface::new(Plane::XY, Interval::UNIT, Interval::UNIT).unwrap().into();
        assert!(ParameterMaps::to_nurbs(&sheet).is_identity());
    }

    /// A trim of a real model ended a rounding beyond the end of the angle, where the pace must not jump.
    #[test]
    fn a_trim_may_leave_the_domain_by_a_rounding() {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 1.0).unwrap().into();
        let [du, dv] = Direction::BOTH.map(|d| ball.domain(d));
        for beyond in [1e-15, 1e-9, 1e-3] {
            let (from, to) = (du.at(0.7), du.end + beyond);
            let ends = [from, to].map(|u| Point3::new(u, dv.at(0.5), 0.0));
            let flat = NurbsCurve::new(1, ends.to_vec(), vec![0.0, 1.0]);
            let moved = ParameterMaps::to_nurbs(&ball).moved(&flat.unwrap().into()).unwrap();
            let end = moved.end();
            // A quarter of a turn over the sine of its half, as the derivative of the tangent of half an angle gives it.
            let pace = std::f64::consts::FRAC_PI_4 / std::f64::consts::FRAC_PI_4.sin();
            assert!(
                (end.x - du.end - beyond * pace).abs() < 2.0 * beyond * beyond + 1e-14,
                "{beyond} {}",
                end.x
            );
        }
    }

    #[test]
    fn a_moved_trim_runs_where_it_ran() {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 1.0).unwrap().into();
        let nurbs: Surface = ball.to_nurbs().unwrap().into();
        let [du, dv] = Direction::BOTH.map(|d| ball.domain(d));
        let middle = Point3::new(du.at(0.4), dv.at(0.5), 0.0);
        let ring: Curve =
            Circle::new(Plane { origin: middle, ..Plane::XY }, 0.3 * dv.length()).unwrap().into();
        let moved = ParameterMaps::to_nurbs(&ball).moved(&ring).unwrap();
        for i in 0..200 {
            let t = ring.domain().at(f64::from(i) / 200.0);
            let (p, q) = (ring.point_at(t), moved.point_at(t));
            assert!(ball.point_at(p.x, p.y).distance_to(nurbs.point_at(q.x, q.y)) < 1e-8);
        }
        // The ring itself closes but for the rounding of its last angle.
        assert!(moved.start().distance_to(moved.end()) < 1e-14);
    }
}
