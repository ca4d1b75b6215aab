//! Integrals over faces as integrals along their trims.

use crate::brep::thresholds::LEAST_RANGE;
use crate::thresholds;
use std::f64::consts::FRAC_PI_3;

use super::bound::{Bound, Nearness, bound};
use super::rule::{Work, integral, polynomial};
use super::strip::Strip;
use super::{Frame, Measure, inner_direction};
use crate::brep::{Brep, LoopKind};
use crate::quadrature::GAUSS_10;
use crate::{
    Curve, Direction, Interval, Line, Plane, Point3, Quadrant, Result, RevolutionSurface, Surface, Vector3,
};

/// A face ready to be integrated over.
pub(super) struct Sheet<'a> {
    surface: &'a Surface,
    pub(super) reversed: bool,
    frame: Frame,
    /// The parameter that the inner integrals run along.
    inner: Direction,
    /// Where they start: nothing of the face lies before.
    floor: f64,
    /// Where the surface is not smooth along the inner direction.
    breaks: Vec<f64>,
    arcs: Vec<Path>,
    /// From the trims to the edges: where a strip's curve is not smooth, and how it counts.
    strips: Vec<(Strip, Vec<f64>, f64)>,
}

/// A trim in the parameter plane, divided where the integrand is not smooth, and how it counts.
struct Path {
    curve: Curve,
    stops: Vec<f64>,
    sign: f64,
}

/// More knots than this are not looked for along a curved trim: halving finds them.
const LOOKED_FOR: usize = 400;

impl<'a> Sheet<'a> {
    /// A face of a brep; none for one that is deleted or has no surface.
    pub(super) fn new(
        brep: &'a Brep,
        face: usize,
        frame: Frame,
        near: Nearness,
        work: &Work<'_>,
    ) -> Result<Option<Self>> {
        let Some(own) = brep.faces().get(face).filter(|f| !f.deleted) else { return Ok(None) };
        let Some(surface) = brep.face_surface(face) else { return Ok(None) };
        let spans = Direction::BOTH.map(|d| surface.span_parameters(d));
        let mut chains = Vec::new();
        for chain in own.loops.iter().filter_map(|l| brep.loops().get(*l)) {
            chains.push((chain.kind, bound(brep, surface, &chain.trims, near, work)?));
        }
        if chains.is_empty() {
            chains.push((LoopKind::Outer, Bound { curves: sides(surface), strips: Vec::new() }));
        }
        let bounds =
            chains.iter().flat_map(|(_, c)| &c.curves).map(Curve::bounding_box).reduce(|a, b| a.union(&b));
        let Some(bounds) = bounds else { return Ok(None) };
        let used = [(bounds.min.x, bounds.max.x), (bounds.min.y, bounds.max.y)];
        let within = |d: usize| spans[d].iter().filter(|t| used[d].0 < **t && **t < used[d].1).count();
        let inner = match surface {
            // What is integrated around the axis is known beforehand.
            Surface::Revolution(s) => s.angle_direction(),
            _ => inner_direction([within(0), within(1)]),
        };
        let (mut arcs, mut strips) = (Vec::new(), Vec::new());
        for (kind, chain) in chains {
            let turns = if parameter_area(&chain.curves) < 0.0 { -1.0 } else { 1.0 };
            let sign = match kind {
                LoopKind::Outer => turns,
                LoopKind::Inner => -turns,
                LoopKind::Unknown | LoopKind::Slit => 1.0,
            };
            for strip in chain.strips {
                let stops = strip.flat().map(|flat| stops(flat, &spans)).unwrap_or_default();
                strips.push((strip, stops, sign));
            }
            for curve in chain.curves {
                let stops = stops(&curve, &spans);
                arcs.push(Path { curve, stops, sign });
            }
        }
        let [floor, breaks] = match inner {
            Direction::U => [used[0].0, 0.0],
            Direction::V => [used[1].0, 1.0],
        };
        let breaks = spans.into_iter().nth(breaks as usize).unwrap_or_default();
        Ok(Some(Self { surface, reversed: own.reversed, frame, inner, floor, breaks, arcs, strips }))
    }

    /// The integrals over the face, off by no more than `tolerance`.
    pub(super) fn integral(
        &self,
        measure: Measure,
        tolerance: f64,
        work: &mut Work<'_>,
    ) -> Result<[f64; 10]> {
        let mut sum = [0.0; 10];
        let share = tolerance / self.arcs.len().max(1) as f64;
        for path in &self.arcs {
            let (part, error) = self.along(path, measure, share, work)?;
            sum.iter_mut().zip(part).for_each(|(sum, v)| *sum += path.sign * v);
            work.error += error;
        }
        Ok(sum)
    }

    /// The share in the volume of what joins the face to its edges, off by no more than `tolerance`.
    pub(super) fn closing(&self, tolerance: f64, work: &mut Work<'_>) -> Result<[f64; 10]> {
        let mut sum = [0.0; 10];
        let share = tolerance / self.strips.len().max(1) as f64;
        for (strip, stops, sign) in &self.strips {
            let part = strip.integral(self.surface, self.frame, stops, share, work)?;
            sum.iter_mut().zip(part).for_each(|(sum, v)| *sum += sign * v);
        }
        Ok(sum)
    }

    fn along(
        &self,
        path: &Path,
        measure: Measure,
        tolerance: f64,
        work: &mut Work<'_>,
    ) -> Result<([f64; 10], f64)> {
        // Green: the integral of g du dv is that of G dv for ∂G/∂u = g, and that of −H du for ∂H/∂v = g.
        let sign = if self.inner == Direction::U { 1.0 } else { -1.0 };
        let domain = path.curve.domain();
        let [mut least, mut most] = [f64::INFINITY, f64::NEG_INFINITY];
        let bounds = path.curve.bounding_box();
        let outer = if self.inner == Direction::U {
            (bounds.min.y, bounds.max.y)
        } else {
            (bounds.min.x, bounds.max.x)
        };
        least = least.min(outer.0);
        most = most.max(outer.1);
        if !(most > least) || domain.length() == 0.0 {
            return Ok(([0.0; 10], 0.0));
        }
        let inner_tolerance = 0.1 * tolerance / (most - least);
        let mut stops = Vec::with_capacity(self.breaks.len() + 2);
        // On a plane what is integrated is cubic in the parameters, and quartic along a straight trim afterwards.
        let flat = self.surface.is_affine();
        let straight = flat && matches!(path.curve, Curve::Line(_));
        let mut at = |t: f64| {
            work.check()?;
            let [place, slope] = path.curve.jet_at::<2>(t, false);
            let (to, across, slope) = match self.inner {
                Direction::U => (place.x, place.y, slope.y),
                Direction::V => (place.y, place.x, slope.x),
            };
            if slope == 0.0 || to == self.floor {
                return Ok([0.0; 10]);
            }
            let mut density = |s: f64| {
                work.take(1)?;
                Ok(match self.inner {
                    Direction::U => self.density(measure, s, across),
                    Direction::V => self.density(measure, across, s),
                })
            };
            let value = if let Surface::Revolution(turned) = self.surface {
                work.take(1)?;
                self.around(turned, measure, across, to)
            } else if flat {
                polynomial([self.floor, to], &mut density)?
            } else {
                self.stops_to(to, &mut stops);
                integral(&stops, inner_tolerance, &mut density)?.0
            };
            Ok(value.map(|v| sign * slope * v))
        };
        if straight {
            return Ok((polynomial([domain.start, domain.end], &mut at)?, 0.0));
        }
        integral(&path.stops, tolerance, &mut at)
    }

    /// From the floor to a parameter around the axis of a surface of revolution, of which `across` is the profile's. What is
    /// integrated is a polynomial in sine and cosine of degree 5 or less: the rule of 10 points has it to rounding over a
    /// sixth of a turn.
    fn around(&self, turned: &RevolutionSurface, measure: Measure, across: f64, to: f64) -> [f64; 10] {
        let ring = turned.ring(across);
        let transposed = turned.angle_direction() == Direction::V;
        let range = [self.floor, to].map(|s| turned.angle_at(s));
        let count = ((range[1] - range[0]).abs() / FRAC_PI_3).ceil().clamp(1.0, 64.0);
        let half = 0.5 * (range[1] - range[0]) / count;
        let size = self.frame.size;
        let mut sum = [0.0; 10];
        for k in 0..count as usize {
            let middle = range[0] + (2 * k + 1) as f64 * half;
            for [x, weight] in GAUSS_10 {
                for side in [-1.0, 1.0] {
                    let [place, around, along] = ring.at(middle + side * half * x);
                    let local = (place - self.frame.centre.to_vector()) / size;
                    let [by_u, by_v] = if transposed { [along, around] } else { [around, along] };
                    let value = measure.density(local, by_u / size, by_v / size);
                    sum.iter_mut().zip(value).for_each(|(sum, v)| *sum += weight * v);
                }
            }
        }
        // By the angle's parameter, not the angle.
        let angles = range[1] - range[0];
        let by = if angles == 0.0 { 0.0 } else { half * (to - self.floor) / angles };
        sum.map(|v| v * by)
    }

    /// From the floor to a parameter, by the knots between.
    fn stops_to(&self, to: f64, stops: &mut Vec<f64>) {
        stops.clear();
        stops.push(self.floor);
        let between = Interval::new(self.floor, to).ordered();
        let inside = self.breaks.iter().copied().filter(|t| between.start < *t && *t < between.end);
        if self.floor <= to {
            stops.extend(inside);
        } else {
            stops.extend(inside.rev());
        }
        stops.push(to);
    }

    fn density(&self, measure: Measure, u: f64, v: f64) -> [f64; 10] {
        let [p, by_u, by_v] = match self.surface {
            Surface::Nurbs(nurbs) => nurbs.partials_at(u, v, Quadrant::NorthEast),
            other => {
                let d = other.derivatives(u, v, 1, Quadrant::NorthEast);
                [d.point().to_vector(), d.get(1, 0), d.get(0, 1)]
            }
        };
        let size = self.frame.size;
        let local: Vector3 = (p - self.frame.centre.to_vector()) / size;
        measure.density(local, by_u / size, by_v / size)
    }
}

/// The border of the whole domain, counter-clockwise.
fn sides(surface: &Surface) -> Vec<Curve> {
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
    let corners = [(u.start, v.start), (u.end, v.start), (u.end, v.end), (u.start, v.end)];
    let corners = corners.map(|(u, v)| Point3::new(u, v, 0.0));
    (0..4).map(|k| Line::new(corners[k], corners[(k + 1) % 4]).into()).collect()
}

/// The area in the parameter plane: only its sign counts, which tells how a loop turns.
fn parameter_area(chain: &[Curve]) -> f64 {
    let origin = chain.first().map_or(Point3::ORIGIN, Curve::start);
    let mut sum = 0.0;
    for curve in chain {
        let domain = curve.domain();
        let mut stops: Vec<f64> = curve.pieces().iter().map(|p| p.whole.start).collect();
        stops.push(domain.end);
        let found = integral(&stops, f64::INFINITY, &mut |t| {
            let [p, d] = curve.jet_at::<2>(t, false);
            let p = p - origin.to_vector();
            let mut out = [0.0; 10];
            out[0] = 0.5 * (p.x * d.y - p.y * d.x);
            Ok(out)
        });
        sum += found.map_or(0.0, |(value, _)| value[0]);
    }
    sum
}

/// Where a trim is divided: at its own knots and where it crosses the surface's.
fn stops(curve: &Curve, spans: &[Vec<f64>; 2]) -> Vec<f64> {
    let domain = curve.domain();
    let mut out: Vec<f64> = curve.pieces().iter().map(|p| p.whole.start).collect();
    let bounds = curve.bounding_box();
    let ranges = [(bounds.min.x, bounds.max.x), (bounds.min.y, bounds.max.y)];
    for (d, normal) in [(0, Vector3::X), (1, Vector3::Y)] {
        let (low, high) = ranges[d];
        let crossed: Vec<f64> = spans[d].iter().copied().filter(|t| low < *t && *t < high).collect();
        if crossed.len() > LOOKED_FOR {
            continue;
        }
        for at in crossed {
            match curve {
                Curve::Line(c) => {
                    let (a, b) =
                        if d == 0 { (c.line.from.x, c.line.to.x) } else { (c.line.from.y, c.line.to.y) };
                    out.push(domain.at((at - a) / (b - a)));
                }
                _ => {
                    let Ok(plane) = Plane::from_normal((normal * at).to_point(), normal) else { continue };
                    let size = (high - low).max(f64::MIN_POSITIVE);
                    out.extend(
                        curve.intersect_plane(&plane, thresholds::ROUNDING * size).unwrap_or_default(),
                    );
                }
            }
        }
    }
    let least = LEAST_RANGE * domain.length();
    out.retain(|t| t.is_finite() && domain.start + least < *t && *t < domain.end - least);
    out.push(domain.start);
    out.push(domain.end);
    out.sort_by(f64::total_cmp);
    out.dedup_by(|a, b| (*a - *b).abs() <= least);
    out
}
