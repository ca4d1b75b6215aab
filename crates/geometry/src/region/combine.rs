//! Regions from closed curves by a rule.

use crate::region::thresholds::FINEST;
use std::collections::HashSet;

use super::loops::{Step, loops};
use super::meetings::Meetings;
use super::sides::{Sides, all_sides};
use super::sources::Sources;
use super::strands::{Strand, strands};
use super::winding::{Outline, OutlineIndex, flat};
use super::{Face, FillRule, Region, assemble, nodes};
use crate::{Curve, Error, Plane, Result};

/// Closed curves and what they enclose together.
#[derive(Debug, Clone, Copy)]
pub(super) struct Operand<'a> {
    pub(super) curves: &'a [Curve],
    pub(super) rule: FillRule,
}

impl Operand<'_> {
    /// Whether the winding numbers of these curves mean inside.
    fn holds(self, turns: impl Iterator<Item = i32>) -> bool {
        match self.rule {
            FillRule::Any => turns.into_iter().any(|w| w != 0),
            FillRule::NonZero => turns.sum::<i32>() != 0,
            FillRule::EvenOdd => turns.sum::<i32>() % 2 != 0,
        }
    }
}

/// Refuses tolerances that mean nothing.
pub(super) fn checked(plane: &Plane, tolerance: f64) -> Result<()> {
    if !plane.is_finite() {
        return Err(Error::NotFinite("plane of the region"));
    }
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::OutOfRange {
            what: "tolerance",
            value: tolerance,
            must: "finite and greater than 0",
        });
    }
    Ok(())
}

/// The tolerances to try, from the one asked for to what rounding allows: finer ones when an arrangement shows that
/// the features of the curves are below it.
pub(super) fn ladder(tolerance: f64, scale: f64) -> Vec<f64> {
    let floor = (FINEST * scale).max(f64::MIN_POSITIVE);
    let mut out = vec![tolerance.max(floor)];
    let mut next = 0.05 * tolerance;
    while next > 2.0 * floor && out.len() < 8 {
        out.push(next);
        next *= 0.05;
    }
    if tolerance > floor {
        out.push(floor);
    }
    out
}

/// The strands of an arrangement with the winding numbers on their sides.
pub(super) type Sided = (nodes::Nodes, Vec<Strand>, Vec<Vec<Sides>>);

/// Cuts the curves at a tolerance; `None` when it is too coarse.
pub(super) fn arranged(
    sources: &Sources,
    meetings: &mut Meetings,
    tolerance: f64,
    last: bool,
) -> Result<Option<Sided>> {
    let Some(nodes) = nodes::find(sources, meetings, tolerance, last)? else { return Ok(None) };
    let strands = strands(sources, &nodes, tolerance)?;
    let sides = all_sides(sources, &strands, nodes.places.len(), tolerance)?;
    Ok(Some((nodes, strands, sides)))
}

/// The region of all points for which `keep` holds of (inside the first operand, inside the second).
pub(super) fn combined(
    operands: [Operand<'_>; 2],
    keep: impl Fn(bool, bool) -> bool,
    plane: &Plane,
    tolerance: f64,
) -> Result<Region> {
    checked(plane, tolerance)?;
    let curves = operands.iter().flat_map(|o| o.curves);
    let sources = Sources::new(curves, plane, tolerance)?;
    let first = operands[0].curves.len();
    let inside = |all: &[Sides], left: bool| {
        let turns = |own: bool| {
            let mine = all.iter().filter(move |s| (s.source < first) == own);
            mine.map(move |s| if left { s.left } else { s.right })
        };
        keep(operands[0].holds(turns(true)), operands[1].holds(turns(false)))
    };
    let steps = ladder(tolerance, sources.scale);
    let mut meetings = Meetings::default();
    for (k, &reach) in steps.iter().enumerate() {
        let Some((nodes, strands, sides)) = arranged(&sources, &mut meetings, reach, k + 1 == steps.len())?
        else {
            continue;
        };
        let mut border = Vec::new();
        for (strand, all) in sides.iter().enumerate() {
            let (left, right) = (inside(all, true), inside(all, false));
            if left != right {
                border.push(Step { strand, forward: left });
            }
        }
        let Some(loops) = loops(&sources, &nodes, &strands, &border)? else { continue };
        let mut walked = Vec::with_capacity(loops.len());
        for steps in loops {
            let curve = assemble::curve(&sources, &nodes, &strands, &steps, reach)?;
            walked.extend(curve.map(|curve| Walked { curve, steps }));
        }
        return Ok(Region { plane: *plane, faces: faces(walked, &sources.plane) });
    }
    Err(too_close())
}

/// No tolerance is fine enough.
pub(super) fn too_close() -> Error {
    let why = "its curves run so close beside each other that inside and outside cannot be told apart".into();
    Error::Invalid { what: "region", why }
}

/// A loop as a curve, and the steps that it was walked by.
pub(super) struct Walked {
    pub(super) curve: Curve,
    pub(super) steps: Vec<Step>,
}

/// Loops by outlines and the holes in them: a loop that runs clockwise is a hole of the smallest outline around it.
pub(super) fn faces(loops: Vec<Walked>, plane: &Plane) -> Vec<Face> {
    let mut outer: Vec<(f64, Outline, HashSet<usize>, Face)> = Vec::new();
    let mut holes = Vec::new();
    for Walked { curve, steps } in loops {
        let (area, _) = curve.signed_area_in(plane);
        if area > 0.0 {
            let outline = Outline::new(&curve, plane);
            let strands = steps.iter().map(|step| step.strand).collect();
            outer.push((area, outline, strands, Face { outline: curve, holes: Vec::new() }));
        } else {
            holes.push((curve, steps));
        }
    }
    let index = OutlineIndex::new(outer.iter().map(|o| Some(&o.1)));
    for (hole, steps) in holes {
        // It may touch its outline, in points: most places on it tell.
        let domain = hole.domain();
        let places =
            [0.03, 0.17, 0.31, 0.47, 0.59, 0.73, 0.89].map(|x| flat(plane, hole.point_at(domain.at(x))));
        let around = |o: &Outline| 2 * places.iter().filter(|&&p| o.winding(p) != 0).count() > places.len();
        // What shares a strand with a hole lies in it.
        let is_within = |strands: &HashSet<usize>| steps.iter().any(|step| strands.contains(&step.strand));
        let near = index.reaching(&places).into_iter();
        let home = near
            .filter_map(|i| Some((i, outer.get(i)?)))
            .filter(|(_, o)| !is_within(&o.2) && around(&o.1))
            .min_by(|(_, x), (_, y)| x.0.total_cmp(&y.0))
            .map(|(i, _)| i);
        if let Some((_, _, _, face)) = home.and_then(|i| outer.get_mut(i)) {
            face.holes.push(hole);
        }
    }
    outer.into_iter().map(|o| o.3).collect()
}
