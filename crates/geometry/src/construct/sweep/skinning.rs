//! A surface through so many places of a moving section that it keeps to the section between them.

use crate::nurbs::{Skinning, skinned};
use crate::{Direction, Error, Interval, NurbsCurve, NurbsSurface, Result};

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
    /// u along the section, v the parameter.
    pub(super) fn surface(&self, tolerance: f64) -> Result<NurbsSurface> {
        let mut stations = self.first_stations();
        // A rail of many spans begins with more of them.
        let most = MOST.max(2 * stations.len());
        loop {
            let surface = self.through(&stations)?;
            let middles: Vec<f64> = stations.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
            let sections = (self.at)(&middles)?;
            let wrong: Vec<f64> = middles
                .iter()
                .zip(&sections)
                .filter(|(t, section)| deviation(&surface, **t, section) > tolerance)
                .map(|(t, _)| *t)
                .collect();
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

    fn first_stations(&self) -> Vec<f64> {
        let mut cuts = vec![self.domain.start];
        cuts.extend(self.breaks.iter().copied().filter(|t| self.domain.start < *t && *t < self.domain.end));
        cuts.push(self.domain.end);
        let least = 1e-6 * self.domain.length();
        cuts.dedup_by(|b, a| *b - *a < least);
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
