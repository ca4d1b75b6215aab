//! A surface through so many places of a moving section that it keeps to the section between them.

use crate::nurbs::{Skinning, skinned};
use crate::{Direction, Error, Interval, NurbsCurve, NurbsSurface, Point3, Result, cancellation};

/// The most places of a section along one run, of a rail that does not ask for more by itself.
const MOST: usize = 600;
/// The shortest step from place to place, as a part of the run.
const SHORTEST: f64 = 1e-6;
/// Places along a section at which it is compared with the surface.
const PROBES: usize = 12;

/// How a section moves over a range.
pub(super) struct Motion<'a> {
    /// The range of the parameter.
    pub(super) domain: Interval,
    /// Parameters inside at which it is likely to be less smooth.
    pub(super) breaks: Vec<f64>,
    /// Whether it comes back to where it began.
    pub(super) closed: bool,
    /// The section at each of increasing parameters, compatible.
    pub(super) at: &'a dyn Fn(&[f64]) -> Result<Vec<NurbsCurve>>,
}

impl Motion<'_> {
    /// The surface that the section draws, within the tolerance as far as samples half-way between its places tell:
    /// u along the section, v the parameter. Where one smooth surface cannot follow, each stretch between breaks is
    /// followed by itself.
    pub(super) fn surface(&self, tolerance: f64) -> Result<NurbsSurface> {
        self.followed(tolerance).or_else(|why| {
            cancellation::check_now()?;
            self.by_stretches(tolerance)?.ok_or(why)
        })
    }

    /// The surface made of those of the stretches between breaks; none when there is only one.
    fn by_stretches(&self, tolerance: f64) -> Result<Option<NurbsSurface>> {
        let cuts = self.cuts();
        if cuts.len() < 3 {
            return Ok(None);
        }
        let mut whole: Option<NurbsSurface> = None;
        for w in cuts.windows(2) {
            let domain = Interval::new(w[0], w[1]);
            let stretch = Motion { domain, breaks: Vec::new(), closed: false, at: self.at };
            cancellation::check_now()?;
            let next = stretch.followed(tolerance)?;
            whole = Some(match whole {
                None => next,
                Some(before) => continued(&before, &next)?,
            });
        }
        Ok(whole)
    }

    /// One smooth surface.
    fn followed(&self, tolerance: f64) -> Result<NurbsSurface> {
        let mut stations = self.first_stations();
        // A rail of many spans begins with more of them.
        let most = MOST.max(2 * stations.len());
        loop {
            let surface = self.through(&stations)?;
            let middles: Vec<f64> = stations.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
            let sections = (self.at)(&middles)?;
            let mut wrong = Vec::new();
            for (t, section) in middles.iter().zip(&sections) {
                cancellation::check_now()?;
                if deviation(&surface, *t, section) > tolerance {
                    wrong.push(*t);
                }
            }
            if wrong.is_empty() {
                return Ok(surface);
            }
            let least = SHORTEST * self.domain.length();
            let tight = stations.windows(2).any(|w| w[1] - w[0] < least);
            if tight || stations.len() + wrong.len() > most {
                return Err(Error::degenerate(
                    "sweep",
                    "it bends too wildly to be followed within the tolerance",
                ));
            }
            stations.extend(wrong);
            stations.sort_by(f64::total_cmp);
        }
    }

    /// The ends and the breaks between them, none nearer to the one before than the shortest step.
    fn cuts(&self) -> Vec<f64> {
        let mut cuts = vec![self.domain.start];
        let mut inner: Vec<f64> =
            self.breaks.iter().copied().filter(|t| self.domain.start < *t && *t < self.domain.end).collect();
        inner.sort_by(f64::total_cmp);
        cuts.extend(inner);
        let least = SHORTEST * self.domain.length();
        cuts.dedup_by(|b, a| *b - *a < least);
        if cuts.len() > 1 && cuts.last().is_some_and(|last| self.domain.end - last < least) {
            cuts.pop();
        }
        cuts.push(self.domain.end);
        cuts
    }

    fn first_stations(&self) -> Vec<f64> {
        let cuts = self.cuts();
        let parts = if cuts.len() < 4 { 4 } else { 2 };
        let mut out = Vec::new();
        for w in cuts.windows(2) {
            out.extend((0..parts).map(|k| w[0] + (w[1] - w[0]) * k as f64 / parts as f64));
        }
        out.push(self.domain.end);
        out
    }

    fn through(&self, stations: &[f64]) -> Result<NurbsSurface> {
        if self.closed {
            let open = stations.get(..stations.len() - 1).unwrap_or(stations);
            return skinned(&(self.at)(open)?, Skinning::Through, stations, true);
        }
        skinned(&(self.at)(stations)?, Skinning::Through, stations, false)
    }
}

/// A surface that goes on in v with another one, over a line that both have, with the same sections.
fn continued(before: &NurbsSurface, after: &NurbsSurface) -> Result<NurbsSurface> {
    let no = || Error::degenerate("sweep", "its stretches do not fit");
    let ([p, q], [rows, m]) = (before.degrees(), before.counts());
    let n = after.counts()[1];
    if after.degrees() != [p, q] || after.counts()[0] != rows {
        return Err(no());
    }
    let (first, second) = (before.homogeneous_points(), after.homogeneous_points());
    cancellation::room::<[f64; 4]>(3 * rows * (m + n - 1))?;
    let mut points = Vec::with_capacity(rows * (m + n - 1));
    for (a, b) in first.chunks(m).zip(second.chunks(n)) {
        points.extend_from_slice(a);
        points.extend_from_slice(b.get(1..).ok_or_else(no)?);
    }
    let mut knots = before.knots(Direction::V).to_vec();
    knots.extend_from_slice(after.knots(Direction::V).get(q..).ok_or_else(no)?);
    let (counts, knots) = ([rows, m + n - 1], [before.knots(Direction::U).to_vec(), knots]);
    if before.is_rational() || after.is_rational() {
        return NurbsSurface::rational([p, q], counts, points, knots);
    }
    let points = points.iter().map(|c| Point3::new(c[0], c[1], c[2])).collect();
    NurbsSurface::new([p, q], counts, points, knots)
}

/// The greatest distance between a section and the surface's curve at its parameter, at equal parameters.
fn deviation(surface: &NurbsSurface, v: f64, section: &NurbsCurve) -> f64 {
    let domain = surface.domain(Direction::U);
    (0..=PROBES)
        .map(|k| {
            let u = domain.at(k as f64 / PROBES as f64);
            surface.point_at(u, v).distance_to(section.point_at(u))
        })
        .fold(0.0, f64::max)
}
