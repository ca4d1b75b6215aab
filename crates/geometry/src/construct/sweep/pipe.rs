//! Pipes: circles along a rail.

use super::super::check;
use super::run::{Corner, EXACT, Kind, Run, Upright, connect, runs};
use super::section::Frame;
use super::skinning::Motion;
use crate::construct::thresholds::SAME_AXIS;
use crate::nurbs::{Skinning, skinned};
use crate::{
    Arc, ArcCurve, ArcLength, Brep, Circle, Curve, Direction, Error, Interval, Line, NurbsCurve, Plane,
    Point3, Result, RevolutionSurface, Surface, Tolerance, Vector3,
};

/// How the ends of a pipe are closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum PipeCap {
    /// Not at all.
    #[default]
    None,
    /// By discs.
    Flat,
    /// By hemispheres.
    Round,
}

/// The pipe of one radius around a rail: exact cylinders along straight lines and tori along arcs, elsewhere a cubic
/// through circles that is within the tolerance half-way between them. At kinks parts meet in the plane between both
/// directions. A closed rail has no ends to cap.
///
/// # Errors
/// A radius that is not finite and above 0, a rail without length or that turns straight back, or faces that do not
/// meet.
pub fn pipe(rail: &Curve, radius: f64, cap: PipeCap, tolerance: &Tolerance) -> Result<Brep> {
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Error::OutOfRange { what: "radius", value: radius, must: "finite and greater than 0" });
    }
    pipe_variable(rail, &[(rail.domain().start, radius)], cap, tolerance)
}

/// The pipe around a rail whose radius is given at parameters of it: between them it goes over smoothly without
/// going beyond (F. Fritsch and R. Carlson, *Monotone piecewise cubic interpolation*, 1980), before the first and
/// after the last it stays. A radius of 0 gives a tip; between the ends it parts the pipe in two that touch there.
///
/// # Errors
/// As [`pipe`], but a radius may be 0 where the ones beside it are not; also when no radius is given, or two for one
/// parameter.
pub fn pipe_variable(
    rail: &Curve,
    radii: &[(f64, f64)],
    cap: PipeCap,
    tolerance: &Tolerance,
) -> Result<Brep> {
    let limit = check(&[rail], tolerance)?;
    let mut given = radii.to_vec();
    given.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (t, r) in &given {
        if !t.is_finite() {
            return Err(Error::NotFinite("parameter of a radius"));
        }
        if !(*r >= 0.0 && r.is_finite()) {
            return Err(Error::OutOfRange { what: "radius", value: *r, must: "finite and not negative" });
        }
    }
    if given.is_empty() || given.windows(2).any(|w| w[0].0 == w[1].0) {
        return Err(Error::Invalid {
            what: "radii of a pipe",
            why: "each parameter needs one, and one only".into(),
        });
    }
    let closed = rail.is_closed();
    let mut runs = runs(rail)?;
    connect(&mut runs, closed, Upright::Free, Corner::Cut, false)?;
    let radius = Radius::new(rail, &given)?;
    if radius.values.iter().all(|r| is_zero(*r)) {
        return Err(Error::degenerate("pipe", "its radius is 0 everywhere"));
    }
    let mut faces = Vec::new();
    for run in &runs {
        for part in radius.parts(run) {
            if radius.is_zero_over(run, part) {
                continue;
            }
            let surface = tube(run, part, &radius, closed && runs.len() == 1, limit)?;
            faces.push(Brep::from_kinked_surface(&surface, tolerance)?);
        }
    }
    let is_tip = |at_end: bool| {
        let run = if at_end { runs.last() } else { runs.first() };
        run.is_some_and(|run| is_zero(radius.at(if at_end { run.reach.end } else { run.reach.start })))
    };
    let tips = [false, true].map(is_tip);
    if cap == PipeCap::Round && !closed {
        for (at_end, tip) in [false, true].into_iter().zip(tips) {
            let run = if at_end { runs.last() } else { runs.first() };
            if let Some(run) = run.filter(|_| !tip) {
                faces.push(hemisphere(run, &radius, at_end)?);
            }
        }
    }
    let joined = whole(&faces, radius.pinches(&runs), tolerance)?;
    if cap != PipeCap::Flat || closed {
        return Ok(joined);
    }
    let (pipe, count) = joined.capped(tolerance)?;
    if count + tips.iter().filter(|tip| **tip).count() == 2 && pipe.is_solid() {
        return Ok(pipe);
    }
    Err(Error::degenerate("pipe", "its ends could not be capped"))
}

/// The faces joined to one brep: in so many more parts as there are places where they touch in a point only.
fn whole(faces: &[Brep], pinches: usize, tolerance: &Tolerance) -> Result<Brep> {
    if pinches == 0 {
        return Brep::joined_into_one(faces, tolerance);
    }
    let parts = Brep::join(faces, tolerance)?.breps;
    if parts.len() > pinches + 1 {
        return Err(Error::degenerate("pipe", "its faces do not meet"));
    }
    Ok(Brep::merged(&parts))
}

/// The radius along the rail, by its length.
struct Radius {
    places: Vec<f64>,
    values: Vec<f64>,
    slopes: Vec<f64>,
}

impl Radius {
    fn new(rail: &Curve, given: &[(f64, f64)]) -> Result<Self> {
        let domain = rail.domain();
        let lengths = ArcLength::new(rail);
        let place = |t: f64| lengths.length_at(domain.clamp(t));
        let mut kept: Vec<(f64, f64)> = given.iter().map(|(t, r)| (place(*t), *r)).collect();
        kept.dedup_by(|b, a| b.0 <= a.0);
        let (places, values): (Vec<f64>, Vec<f64>) = kept.into_iter().unzip();
        let steps: Vec<f64> =
            places.windows(2).zip(values.windows(2)).map(|(t, r)| (r[1] - r[0]) / (t[1] - t[0])).collect();
        // Level at both ends, and wherever the radius turns from growing to shrinking.
        let mut slopes = vec![0.0; values.len()];
        for i in 1..values.len().saturating_sub(1) {
            let (a, b) = (steps[i - 1], steps[i]);
            if a * b > 0.0 {
                slopes[i] = 2.0 * a * b / (a + b);
            }
        }
        Ok(Self { places, values, slopes })
    }

    /// Where inside a run the radius is 0, by the length of the rail.
    fn zeros(&self, run: &Run) -> Vec<f64> {
        let least = EXACT * run.reach.length();
        let inside = |p: &f64| run.reach.start + least < *p && *p < run.reach.end - least;
        let all = self.places.iter().zip(&self.values).filter(|(_, r)| is_zero(**r));
        all.map(|(p, _)| *p).filter(inside).collect()
    }

    /// The parts of a run's domain between places inside it where the radius is 0.
    fn parts(&self, run: &Run) -> Vec<Interval> {
        let domain = run.curve.domain();
        let mut cuts = vec![domain.start];
        let zeros = self.zeros(run);
        cuts.extend(zeros.iter().filter_map(|p| run.curve.parameter_at_length(p - run.reach.start)));
        cuts.push(domain.end);
        cuts.windows(2).map(|w| Interval::new(w[0], w[1])).filter(|part| part.is_increasing()).collect()
    }

    /// In how many places between the ends the pipe is only a point.
    fn pinches(&self, runs: &[Run]) -> usize {
        let inside: usize = runs.iter().map(|run| self.zeros(run).len()).sum();
        let joints = runs.iter().skip(1).filter(|run| is_zero(self.at(run.reach.start))).count();
        inside + joints
    }

    /// Whether the pipe is only a line along a part of a run's domain.
    fn is_zero_over(&self, run: &Run, part: Interval) -> bool {
        let domain = run.curve.domain();
        let places = [0.1, 0.5, 0.9].map(|x| part.at(x));
        let place = |t: f64| run.reach.start + run.curve.length_between(Interval::new(domain.start, t));
        self.values.iter().any(|r| is_zero(*r)) && places.iter().all(|t| is_zero(self.at(place(*t))))
    }

    fn is_constant(&self, reach: Interval) -> bool {
        let at = |x: f64| self.at(reach.at(x));
        self.values.len() == 1 || (0..=16).all(|k| at(f64::from(k) / 16.0) == at(0.0))
    }

    fn at(&self, place: f64) -> f64 {
        let (first, last) = (self.values[0], self.values[self.values.len() - 1]);
        let next = self.places.partition_point(|p| *p <= place);
        if next == 0 {
            return first;
        }
        if next == self.places.len() {
            return last;
        }
        let i = next - 1;
        let h = self.places[next] - self.places[i];
        let x = (place - self.places[i]) / h;
        let (y, x2, x3) = (1.0 - x, x * x, x * x * x);
        (2.0 * x3 - 3.0 * x2 + 1.0) * self.values[i]
            + (3.0 * x2 - 2.0 * x3) * self.values[next]
            + x * y * y * h * self.slopes[i]
            - x2 * y * h * self.slopes[next]
    }
}

/// Whether a circle of a radius is a point to openNURBS's eyes.
fn is_zero(radius: f64) -> bool {
    Point3::ORIGIN.coincides(Point3::new(radius, 0.0, 0.0))
}

/// The circle of a radius about the origin of the plane, as a section.
fn circle(radius: f64) -> Result<NurbsCurve> {
    Circle::new(Plane::XY, radius)?.to_nurbs()
}

fn tube(run: &Run, domain: Interval, radius: &Radius, closed: bool, limit: f64) -> Result<Surface> {
    let unit = circle(1.0)?;
    let lengths = ArcLength::new(&run.curve);
    let place = |t: f64| run.reach.start + lengths.length_at(t);
    let at = |ts: &[f64]| -> Result<Vec<NurbsCurve>> {
        let frames = run.frames(ts, Upright::Free)?;
        let scaled = |frame: &Frame, r: f64| Frame { axes: frame.axes.map(|a| a * r), ..*frame };
        frames.iter().zip(ts).map(|(frame, t)| scaled(frame, radius.at(place(*t))).placed(&unit)).collect()
    };
    let even = domain == run.curve.domain() && radius.is_constant(run.reach);
    let square = run.slants == [[Vector3::ZERO; 3]; 2];
    match run.kind {
        Kind::Straight if even => {
            let ends = at(&[domain.start, domain.end])?;
            return Ok(skinned(&ends, Skinning::Straight, &[domain.start, domain.end], false)?.into());
        }
        Kind::Circular(arc) if even && square => {
            let plane = run.end_plane(false, Upright::Free)?;
            let section: Curve = Circle::new(plane, radius.at(run.reach.start))?.into();
            let axis = Line::new(arc.circle.center(), arc.circle.center() + arc.circle.plane.z_axis);
            let angle = Interval::new(0.0, arc.angle.length());
            let turned = RevolutionSurface::new(section, axis, angle)?.transposed();
            return Surface::from(turned).with_domain(Direction::V, domain);
        }
        _ => {}
    }
    let mut breaks: Vec<f64> = run.curve.smooth_stretches().iter().map(|s| s.start).collect();
    let inside =
        radius.places.iter().map(|p| p - run.reach.start).filter(|p| *p > 0.0 && *p < run.reach.length());
    breaks.extend(inside.filter_map(|p| run.curve.parameter_at_length(p)));
    breaks.sort_by(f64::total_cmp);
    // Frames that do not close after a round give an open seam, whose rims meet all the same.
    let meets = closed && domain == run.curve.domain() && {
        let [a, b] = [run.end_plane(false, Upright::Free)?, run.end_plane(true, Upright::Free)?];
        a.x_axis.dot(b.x_axis) > 1.0 - SAME_AXIS
    };
    let motion = Motion { domain, breaks, closed: meets && square, at: &at };
    Ok(motion.surface(0.5 * limit)?.into())
}

/// The half of a sphere beyond an end of the rail.
fn hemisphere(run: &Run, radius: &Radius, at_end: bool) -> Result<Brep> {
    let plane = run.end_plane(at_end, Upright::Free)?;
    let r = radius.at(if at_end { run.reach.end } else { run.reach.start });
    let outward = if at_end { plane.z_axis } else { -plane.z_axis };
    let side = Plane::from_axes(plane.origin, plane.x_axis, outward)?;
    let quarter =
        Arc { circle: Circle::new(side, r)?, angle: Interval::new(0.0, std::f64::consts::FRAC_PI_2) };
    // As long as the cap is high: the direction of a short line far away has lost digits, and the pole its place.
    let axis = Line::new(plane.origin, plane.origin + outward * r.max(1.0));
    let turn = Interval::new(0.0, std::f64::consts::TAU);
    let profile: Curve = ArcCurve::from(quarter).into();
    Brep::from_surface(RevolutionSurface::new(profile, axis, turn)?.into())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::{PipeCap, pipe, pipe_variable};
    use crate::{Curve, Line, NurbsCurve, Point3, Tolerance};

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 0.01, angle: 1_f64.to_radians() }
    }

    fn line() -> Curve {
        Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 10.0)).into()
    }

    /// Between radii 0 and 1 over 10 with level ends r = 3x² − 2x³: the volume is 10 π (9/5 − 2 + 4/7) = 130 π / 35.
    #[test]
    fn tips() {
        for (radii, cap) in [
            ([(0.0, 0.0), (10.0, 1.0)], PipeCap::Flat),
            ([(0.0, 1.0), (10.0, 0.0)], PipeCap::Flat),
            ([(0.0, 0.0), (10.0, 1.0)], PipeCap::Round),
        ] {
            let brep = pipe_variable(&line(), &radii, cap, &tolerance()).unwrap();
            assert_eq!(brep.faults(), []);
            assert!(brep.is_solid());
            let ball = if cap == PipeCap::Round { 2.0 / 3.0 * PI } else { 0.0 };
            let volume = brep.volume_properties(1e-6, || true).unwrap().amount;
            assert!((volume - 130.0 * PI / 35.0 - ball).abs() < 0.05, "{volume}");
        }
    }

    #[test]
    fn a_radius_of_0_between_the_ends_parts_the_pipe() {
        let radii = [(0.0, 1.0), (5.0, 0.0), (10.0, 1.0)];
        let brep = pipe_variable(&line(), &radii, PipeCap::Flat, &tolerance()).unwrap();
        assert_eq!(brep.faults(), []);
        assert!(brep.is_solid() && brep.faces().len() == 4);
        let volume = brep.volume_properties(1e-6, || true).unwrap().amount;
        assert!((volume - 130.0 * PI / 35.0).abs() < 0.05, "{volume}");
        let none = pipe_variable(&line(), &[(0.0, 0.0)], PipeCap::None, &tolerance());
        assert!(none.unwrap_err().to_string().contains("0 everywhere"));
        assert!(pipe(&line(), 0.0, PipeCap::None, &tolerance()).is_err());
        assert!(pipe_variable(&line(), &[(0.0, -1.0)], PipeCap::None, &tolerance()).is_err());
    }

    /// All radii in the first thousandth of the rail, as where a rail's domain was not made 0 to 1.
    #[test]
    fn radii_that_are_crowded() {
        let points = [[0.0, 0.0, 0.0], [300.0, 100.0, 0.0], [600.0, -100.0, 50.0], [1000.0, 0.0, 0.0]];
        let rail: Curve = NurbsCurve::clamped_uniform(3, &points.map(Point3::from)).unwrap().into();
        let rail = rail.with_domain(crate::Interval::new(0.0, 1100.0)).unwrap();
        for radii in [[5.0, 20.0, 1.0], [0.0, 10.0, 0.0]] {
            let given: Vec<(f64, f64)> = [0.0, 0.5, 1.0].into_iter().zip(radii).collect();
            let brep = pipe_variable(&rail, &given, PipeCap::None, &tolerance()).unwrap();
            assert_eq!(brep.faults(), []);
        }
    }
}
