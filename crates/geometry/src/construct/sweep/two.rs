//! Sections along two rails.

use super::super::check;
use super::section::{Frame, Sections};
use super::skinning::Motion;
use crate::construct::thresholds::{KINK_ANGLE, ROOM_ON_RAILS, SAME_PLACE_ON_RAILS};
use crate::thresholds;
use crate::{
    ArcLength, Brep, Continuity, Curve, Error, Interval, NurbsCurve, Result, Tolerance, Vector3, cancellation,
};

/// The surfaces that sections draw when they are moved along two rails, their width being the rails' distance. With
/// `keep_height` their height stays, else it is scaled as the width. Places of the rails belong together that have
/// equal shares of the lengths between sections. u runs along the section from the first rail to the second, v along
/// the rails over 0…1; faces are joined.
///
/// The surface is a cubic through so many places of the section that half-way between them it is within the
/// tolerance.
///
/// # Errors
/// No section, a rail without length, sections that stand where the rails meet or two at one place, or a surface
/// without area.
pub fn sweep_two(
    rails: [&Curve; 2],
    sections: &[Curve],
    keep_height: bool,
    tolerance: &Tolerance,
) -> Result<Vec<Brep>> {
    let limit = check(&sections.iter().chain(rails).collect::<Vec<_>>(), tolerance)?;
    let first = sections.first().ok_or(Error::degenerate("sweep", "there are no sections"))?;
    let rails = matched(rails, first)?;
    let closed = rails.iter().all(Curve::is_closed);
    let along = rails.each_ref().map(ArcLength::new);
    let mut placed = Vec::with_capacity(sections.len());
    for section in sections {
        placed.push(stand(&rails, &along, section)?);
    }
    placed.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    if closed
        && let Some((curve, _)) = placed
            .first_mut()
            .filter(|(_, at)| at.iter().all(|s| *s < SAME_PLACE_ON_RAILS || *s > 1.0 - SAME_PLACE_ON_RAILS))
    {
        let again = curve.clone();
        placed[0].1 = [0.0; 2];
        if placed.len() > 1 {
            placed.push((again, [1.0; 2]));
        }
    }
    let pair = Pair::new(&rails, along, &placed, keep_height)?;
    let (mut local, mut places) = (Vec::new(), Vec::new());
    for (section, at) in &placed {
        let frame = pair.frame(at[0], at[0] >= 1.0)?;
        local.push(frame.local(&section.to_nurbs()?)?);
        places.push(at[0]);
    }
    if places.windows(2).any(|w| !(w[1] - w[0] > SAME_PLACE_ON_RAILS)) {
        return Err(Error::degenerate("sections", "two of them stand at one place of the rails"));
    }
    let sections = Sections::new(&local, &places)?;
    let (mut faces, breaks) = (Vec::new(), pair.breaks());
    for part in pair.parts(&places) {
        let at = |shares: &[f64]| -> Result<Vec<NurbsCurve>> {
            let frames = shares.iter().map(|s| pair.slanted(*s, part));
            frames.zip(shares).map(|(frame, s)| frame?.placed(&sections.at(*s)?)).collect()
        };
        let motion = Motion { domain: part, breaks: breaks.clone(), closed: false, at: &at };
        faces.push(Brep::from_kinked_surface(&motion.surface(0.5 * limit)?.into(), tolerance)?);
    }
    Ok(Brep::join(&faces, tolerance)?.breps)
}

/// Both rails running the same way; closed ones start where the first section stands.
fn matched(rails: [&Curve; 2], section: &Curve) -> Result<[Curve; 2]> {
    let [first, second] = rails;
    if !(first.length() > 0.0 && second.length() > 0.0) {
        return Err(Error::degenerate("rail", "it has no length"));
    }
    let ends = [section.start(), section.end()];
    let mut out = [first.clone(), second.clone()];
    if first.is_closed() && second.is_closed() {
        let away = |rail: &Curve, p| rail.closest_point(p).map(|near| near.distance);
        let swapped = away(first, ends[1])? < away(first, ends[0])?;
        for (rail, p) in out.iter_mut().zip(if swapped { [ends[1], ends[0]] } else { ends }) {
            let (t, domain) = (rail.closest_point(p)?.parameter, rail.domain());
            if [domain.start, domain.end]
                .iter()
                .all(|e| (t - e).abs() > thresholds::SAME_PARAMETER * domain.length())
            {
                *rail = rail.with_seam(t)?;
            }
        }
        let [a, b] = &out;
        let sum = |b: &Curve| -> f64 {
            (1..8)
                .map(|k| f64::from(k) / 8.0)
                .map(|x| a.point_at(a.domain().at(x)).distance_to(b.point_at(b.domain().at(x))))
                .sum()
        };
        let back = b.reversed();
        if sum(&back) < sum(b) {
            out[1] = back;
        }
        return Ok(out);
    }
    let straight = first.start().distance_to(second.start()) + first.end().distance_to(second.end());
    let crossed = first.start().distance_to(second.end()) + first.end().distance_to(second.start());
    if crossed < straight {
        out[1] = second.reversed();
    }
    Ok(out)
}

/// A section running from the first rail to the second, and its places on them by share of their lengths.
fn stand(rails: &[Curve; 2], along: &[ArcLength<'_>; 2], section: &Curve) -> Result<(Curve, [f64; 2])> {
    let away = |rail: &Curve, p| rail.closest_point(p);
    let straight = away(&rails[0], section.start())?.distance + away(&rails[1], section.end())?.distance;
    let turned = away(&rails[0], section.end())?.distance + away(&rails[1], section.start())?.distance;
    let section = if turned < straight { section.reversed() } else { section.clone() };
    let share = |k: usize, p| -> Result<f64> {
        let t = away(&rails[k], p)?.parameter;
        Ok((along[k].length_at(t) / along[k].total()).clamp(0.0, 1.0))
    };
    let at = [share(0, section.start())?, share(1, section.end())?];
    Ok((section, at))
}

/// Two rails and which of their places belong together.
struct Pair<'a> {
    rails: &'a [Curve; 2],
    lengths: [ArcLength<'a>; 2],
    /// Shares of the first and of the second rail that belong together, increasing.
    stops: Vec<[f64; 2]>,
    keep_height: bool,
    /// The parameters of the rails' kinks: places found by length are rounded, and must not miss them.
    corners: [Vec<f64>; 2],
}

impl<'a> Pair<'a> {
    fn new(
        rails: &'a [Curve; 2],
        lengths: [ArcLength<'a>; 2],
        placed: &[(Curve, [f64; 2])],
        keep_height: bool,
    ) -> Result<Self> {
        let mut stops: Vec<[f64; 2]> = vec![[0.0; 2]];
        for (_, at) in placed {
            let before = stops.last().copied().unwrap_or_default();
            let room = |k: usize| at[k] - before[k] > ROOM_ON_RAILS && at[k] < 1.0 - ROOM_ON_RAILS;
            if room(0) && room(1) {
                stops.push(*at);
            }
        }
        stops.push([1.0; 2]);
        let tight = Tolerance { absolute: f64::INFINITY, angle: KINK_ANGLE };
        let corners = [0, 1].map(|k: usize| rails[k].discontinuities(Continuity::G1, &tight));
        Ok(Self { rails, lengths, stops, keep_height, corners })
    }

    /// The parameters of both rails at a share of the first.
    fn parameters(&self, share: f64) -> [f64; 2] {
        let k = self.stops.windows(2).position(|w| share <= w[1][0]).unwrap_or(self.stops.len() - 2);
        let (a, b) = (self.stops[k], self.stops[k + 1]);
        let x = (share - a[0]) / (b[0] - a[0]);
        let shares = [share, a[1] + (b[1] - a[1]) * x];
        [0, 1].map(|k| {
            let rail = &self.rails[k];
            if shares[k] <= 0.0 {
                return rail.domain().start;
            }
            if shares[k] >= 1.0 {
                return rail.domain().end;
            }
            let found = self.lengths[k].parameter_at(shares[k] * self.lengths[k].total());
            let (corners, least) = (&self.corners[k], thresholds::SAME_PARAMETER * rail.domain().length());
            let first = corners.partition_point(|t| *t < found - least);
            corners.get(first).copied().filter(|t| *t <= found + least).unwrap_or(found)
        })
    }

    /// Shares of the first rail at which one of both has a kink, or more than G1 to be expected of.
    fn kinks(&self) -> Vec<f64> {
        let own = self.corners[0].iter().map(|t| self.share(0, *t));
        own.chain(self.corners[1].iter().map(|t| self.share(1, *t))).collect()
    }

    /// The share of the first rail that belongs to a parameter of either.
    fn share(&self, k: usize, t: f64) -> f64 {
        let share = self.lengths[k].length_at(t) / self.lengths[k].total();
        if k == 0 { share } else { self.first_share(share) }
    }

    /// The share of the first rail that belongs to one of the second.
    fn first_share(&self, share: f64) -> f64 {
        let k = self.stops.windows(2).position(|w| share <= w[1][1]).unwrap_or(self.stops.len() - 2);
        let (a, b) = (self.stops[k], self.stops[k + 1]);
        a[0] + (b[0] - a[0]) * ((share - a[1]) / (b[1] - a[1]))
    }

    fn breaks(&self) -> Vec<f64> {
        let starts =
            |k: usize| self.rails[k].smooth_stretches().into_iter().map(move |s| self.share(k, s.start));
        let mut out: Vec<f64> = starts(0).chain(starts(1)).collect();
        out.sort_by(f64::total_cmp);
        out
    }

    /// The stretches between kinks, and where sections make the surface less than smooth.
    fn parts(&self, places: &[f64]) -> Vec<Interval> {
        let mut cuts = vec![0.0, 1.0];
        cuts.extend(self.kinks());
        cuts.extend(self.stops.iter().map(|s| s[0]));
        if let ([first, _, ..], Some(last)) = (places, places.last()) {
            cuts.extend([*first, *last]);
        }
        cuts.retain(|c| (0.0..=1.0).contains(c));
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|b, a| *b - *a < SAME_PLACE_ON_RAILS);
        if let Some(last) = cuts.last_mut() {
            *last = 1.0;
        }
        cuts.windows(2).map(|w| Interval::new(w[0], w[1])).collect()
    }

    /// The frame at a share: x from rail to rail, y upwards.
    fn frame(&self, share: f64, below: bool) -> Result<Frame> {
        let [s, t] = self.parameters(share);
        let origin = self.rails[0].point_at(s);
        let across = self.rails[1].point_at(t) - origin;
        let along = self.along([s, t], below)?;
        Ok(self.frame_of(origin, across, along))
    }

    fn along(&self, parameters: [f64; 2], below: bool) -> Result<Vector3> {
        let tangent = |k: usize| {
            self.rails[k]
                .tangent_on_side(parameters[k], below)
                .ok_or(Error::degenerate("rail", "it has no direction"))
        };
        Ok(tangent(0)? + tangent(1)?)
    }

    fn frame_of(&self, origin: crate::Point3, across: Vector3, along: Vector3) -> Frame {
        let width = across.length();
        let x = across.unitized().or_else(|| along.perpendicular()).unwrap_or(Vector3::X);
        let z = along
            .rejected_from(x)
            .and_then(Vector3::unitized)
            .or_else(|| x.perpendicular())
            .unwrap_or(Vector3::Z);
        let height = if self.keep_height { 1.0 } else { width };
        Frame { origin, axes: [across, z.cross(x) * height, z * height] }
    }

    /// The frame inside a part, with directions at its ends half-way to those of the parts beside it.
    fn slanted(&self, share: f64, part: Interval) -> Result<Frame> {
        cancellation::check()?;
        let [s, t] = self.parameters(share);
        let origin = self.rails[0].point_at(s);
        let across = self.rails[1].point_at(t) - origin;
        let along = self.along([s, t], share >= part.end)?;
        let closed = self.rails.iter().all(Curve::is_closed);
        let beyond = |end: f64, at_end: bool| -> Result<Vector3> {
            let own = self.parameters(end);
            // Over the seam of closed rails the part beside is the one at the other end.
            let beside = match (closed, at_end) {
                (true, true) if end >= 1.0 => self.parameters(0.0),
                (true, false) if end <= 0.0 => self.parameters(1.0),
                _ => own,
            };
            let open = !closed && ((at_end && end >= 1.0) || (!at_end && end <= 0.0));
            if open {
                return Ok(Vector3::ZERO);
            }
            Ok((self.along(beside, !at_end)? - self.along(own, at_end)?) * 0.5)
        };
        let x = part.normalized(share);
        let along = along + beyond(part.start, false)? * (1.0 - x) + beyond(part.end, true)? * x;
        Ok(self.frame_of(origin, across, along))
    }
}
