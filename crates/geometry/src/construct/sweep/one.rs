//! Sections along one rail.

use super::super::check;
use super::run::{Corner, Kind, Run, Upright, connect, runs};
use super::section::Sections;
use super::skinning::Motion;
use crate::construct::thresholds::AT_RUN_END;
use crate::nurbs::{Skinning, skinned};
use crate::thresholds;
use crate::{
    ArcLength, Brep, Curve, Direction, Error, Interval, Line, NurbsCurve, Result, RevolutionSurface, Surface,
    Tolerance, Vector3,
};

/// How sections stand while they are moved.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum SweepFrame {
    /// They turn about the rail as little as possible.
    #[default]
    Freeform,
    /// They keep upright against a direction, as the cross-section of a road does.
    Roadlike(Vector3),
}

/// What becomes of sections at kinks of the rail.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Miter {
    /// Nothing: the parts beside a kink end across the rail and are not joined.
    None,
    /// They are cut by the plane half-way between both directions.
    #[default]
    Trim,
    /// They are turned into that plane, and keep their shape.
    Rotate,
}

/// What a sweep along one rail heeds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SweepOptions {
    /// How sections stand.
    pub frame: SweepFrame,
    /// What becomes of them at kinks.
    pub miter: Miter,
}

/// The surfaces that sections draw when they are moved along a rail. Each section belongs to the place of the rail
/// nearest to its start; between two of them the shape goes over from one to the other, before the first and after
/// the last it stays. u runs along the section, v along the rail; faces are joined.
///
/// One section along straight lines gives ruled, along circular arcs revolved surfaces, which are exact. Elsewhere
/// the surface is a cubic through so many places of the section that half-way between them it is within the
/// tolerance. Frames are rotation-minimising (W. Wang and others, *Computation of rotation minimizing frames*, 2008);
/// along a closed rail what they lack at the end is made up evenly.
///
/// # Errors
/// No section, a rail without length or that turns straight back, a rail along the upright direction, two sections
/// at one place, or a surface without area.
pub fn sweep_one(
    rail: &Curve,
    sections: &[Curve],
    options: &SweepOptions,
    tolerance: &Tolerance,
) -> Result<Vec<Brep>> {
    let limit = check(&sections.iter().chain([rail]).collect::<Vec<_>>(), tolerance)?;
    let upright = match options.frame {
        SweepFrame::Freeform => Upright::Free,
        SweepFrame::Roadlike(up) if up.unitized().is_some() => Upright::Towards(up),
        SweepFrame::Roadlike(_) => return Err(Error::degenerate("upright direction", "it has no length")),
    };
    let corner = match options.miter {
        Miter::None => Corner::Open,
        Miter::Trim => Corner::Cut,
        Miter::Rotate => Corner::Turned,
    };
    let first = sections.first().ok_or(Error::degenerate("sweep", "there are no sections"))?;
    let closed = rail.is_closed();
    let rail = if closed { seam_at(rail, first)? } else { rail.clone() };
    let mut runs = runs(&rail)?;
    connect(&mut runs, closed, upright, corner, true)?;
    let placed = placed(sections, closed, &runs, limit)?;
    let mut local = Vec::with_capacity(placed.len());
    for section in &placed {
        let run = &runs[section.run];
        let frame = run.frames(&[section.parameter], upright)?.pop();
        let frame = frame.ok_or(Error::degenerate("rail", "it has no direction"))?;
        local.push(frame.local(&section.curve.to_nurbs()?)?);
    }
    let places: Vec<f64> = placed.iter().map(|section| section.place).collect();
    let sections = Sections::new(&local, &places)?;
    let mut faces = Vec::new();
    for run in &runs {
        for part in parts(run, &places, closed && runs.len() == 1) {
            let surface = swept(run, part, &sections, upright, closed && runs.len() == 1, limit)?;
            faces.push(Brep::from_kinked_surface(&surface, tolerance)?);
        }
    }
    Ok(Brep::join(&faces, tolerance)?.breps)
}

/// A closed rail that starts where the first section stands.
fn seam_at(rail: &Curve, section: &Curve) -> Result<Curve> {
    let (t, domain) = (rail.closest_point(section.start())?.parameter, rail.domain());
    let at_end = [domain.start, domain.end]
        .iter()
        .any(|e| (t - e).abs() <= thresholds::SAME_PARAMETER * domain.length());
    if at_end { Ok(rail.clone()) } else { rail.with_seam(t) }
}

/// A section and where it stands: by the length of the rail, and on which run.
struct Placed {
    curve: Curve,
    place: f64,
    run: usize,
    parameter: f64,
}

/// The sections by their places; on a closed rail the first comes again at the end.
fn placed(sections: &[Curve], closed: bool, runs: &[Run], limit: f64) -> Result<Vec<Placed>> {
    let mut out = Vec::with_capacity(sections.len() + 1);
    for (number, section) in sections.iter().enumerate() {
        let mut best: Option<(f64, usize, f64)> = None;
        for (k, run) in runs.iter().enumerate() {
            let near = run.curve.closest_point(section.start())?;
            if best.is_none_or(|(d, ..)| near.distance < d) {
                best = Some((near.distance, k, near.parameter));
            }
        }
        let (_, run, parameter) = best.ok_or(Error::degenerate("rail", "it has no length"))?;
        let (run, parameter) =
            if closed && number == 0 { (0, runs[0].curve.domain().start) } else { (run, parameter) };
        let own = &runs[run];
        let place =
            own.reach.start + own.curve.length_between(Interval::new(own.curve.domain().start, parameter));
        out.push(Placed { curve: section.clone(), place, run, parameter });
    }
    out.sort_by(|a, b| a.place.total_cmp(&b.place));
    if closed && out.len() > 1 {
        let run = runs.len() - 1;
        let (first, last) = (&out[0], &runs[run]);
        out.push(Placed {
            curve: first.curve.clone(),
            place: last.reach.end,
            run,
            parameter: last.curve.domain().end,
        });
    }
    if out.windows(2).any(|w| w[1].place - w[0].place <= limit) {
        return Err(Error::degenerate("sections", "two of them stand at one place of the rail"));
    }
    Ok(out)
}

/// The parts of a run between places where the section begins or ceases to change.
fn parts(run: &Run, places: &[f64], whole: bool) -> Vec<Interval> {
    let domain = run.curve.domain();
    let mut cuts = vec![domain.start];
    if let ([first, _, ..], Some(last), false) = (places, places.last(), whole) {
        for place in [first, last] {
            let inside = *place - run.reach.start;
            if inside > AT_RUN_END * run.reach.length() && inside < (1.0 - AT_RUN_END) * run.reach.length() {
                cuts.extend(run.curve.parameter_at_length(inside));
            }
        }
    }
    cuts.push(domain.end);
    cuts.windows(2).map(|w| Interval::new(w[0], w[1])).filter(|r| r.is_increasing()).collect()
}

fn swept(
    run: &Run,
    part: Interval,
    sections: &Sections,
    upright: Upright,
    closed: bool,
    limit: f64,
) -> Result<Surface> {
    let lengths = ArcLength::new(&run.curve);
    let place = |t: f64| run.reach.start + lengths.length_at(t);
    let at = |ts: &[f64]| -> Result<Vec<NurbsCurve>> {
        let frames = run.frames(ts, upright)?;
        frames.iter().zip(ts).map(|(frame, t)| frame.placed(&sections.at(place(*t))?)).collect()
    };
    let rigid = run.slants == [[Vector3::ZERO; 3]; 2] && run.twist == 0.0;
    match run.kind {
        Kind::Straight if sections.is_one() && (run.twist == 0.0) => {
            let ends = at(&[part.start, part.end])?;
            return Ok(skinned(&ends, Skinning::Straight, &[part.start, part.end], false)?.into());
        }
        Kind::Circular(arc) if sections.is_one() && rigid && upright == Upright::Free => {
            let start = at(&[part.start])?.pop().ok_or(Error::degenerate("rail", "it has no direction"))?;
            let circle = arc.circle;
            let axis = Line::new(circle.center(), circle.center() + circle.plane.z_axis);
            let domain = run.curve.domain();
            let share = part.length() / domain.length();
            let angle = Interval::new(0.0, arc.angle.length() * share);
            let turned = RevolutionSurface::new(start.into(), axis, angle)?.transposed();
            return Surface::from(turned).with_domain(Direction::V, part);
        }
        _ => {}
    }
    let breaks: Vec<f64> = run.curve.smooth_stretches().iter().map(|s| s.start).collect();
    let motion =
        Motion { domain: part, breaks, closed: closed && sections.is_one() && rigid_ends(run), at: &at };
    Ok(motion.surface(0.5 * limit)?.into())
}

/// Whether nothing is slanted at the ends of a run.
fn rigid_ends(run: &Run) -> bool {
    run.slants == [[Vector3::ZERO; 3]; 2]
}
