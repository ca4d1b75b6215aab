//! Sides and knot lines of a surface that lie in a plane.

use crate::{Curve, Direction, Interval, NurbsSurface, Plane, Result, Surface};

/// What lies beside one span of a knot line.
#[derive(Debug, Clone, Copy, Default)]
struct Beside {
    above: bool,
    below: bool,
    /// Patches that lie in the plane themselves.
    level: usize,
    patches: usize,
}

impl Beside {
    /// Whether the surface passes through the plane here, ends, or begins to lie in it.
    fn belongs(self) -> bool {
        let ends = self.patches == 1;
        (self.above && self.below) || self.level == 1 || (ends && self.level == 0)
    }
}

/// The curves along sides and knot lines that lie in the plane within `reach` and belong to the section. `patches` are
/// the Bézier patches of `nurbs`, the NURBS form of `surface`, v running fastest.
pub(super) fn in_plane(
    surface: &Surface,
    nurbs: &NurbsSurface,
    patches: &[NurbsSurface],
    plane: &Plane,
    reach: f64,
) -> Result<Vec<Curve>> {
    let spans = Direction::BOTH.map(|d| nurbs.span_parameters(d));
    let counts = [0, 1].map(|d| spans[d].len().saturating_sub(1));
    let mut out = Vec::new();
    for across in Direction::BOTH {
        let along = across.other();
        let (n, m) = (counts[across.index()], counts[along.index()]);
        let closed = nurbs.is_closed(across);
        // A seam is one line, not two.
        for line in 0..=if closed { n.saturating_sub(1) } else { n } {
            let mut runs: Vec<[usize; 2]> = Vec::new();
            for k in 0..m {
                let patch = |i: usize| {
                    let index = if across == Direction::U { i * m + k } else { k * n + i };
                    patches.get(index)
                };
                let before = match line.checked_sub(1) {
                    Some(i) => patch(i),
                    None if closed => patch(n - 1),
                    None => None,
                };
                let after = if line < n { patch(line) } else { None };
                if beside(before, after, across, plane, reach).is_some_and(Beside::belongs) {
                    match runs.last_mut() {
                        Some(run) if run[1] == k => run[1] = k + 1,
                        _ => runs.push([k, k + 1]),
                    }
                }
            }
            for [from, to] in runs {
                let at = |i: usize| spans[along.index()].get(i).copied().unwrap_or(0.0);
                let constant = spans[across.index()].get(line).copied().unwrap_or(0.0);
                let whole = from == 0 && to == m;
                let own = surface.domain(across);
                let curve = match (line, whole) {
                    // The surface's own side is exact where its NURBS form is only the same shape.
                    (0, true) => surface.isocurve(along, own.start),
                    (i, true) if i == n => surface.isocurve(along, own.end),
                    _ => {
                        let iso = nurbs.isocurve(along, constant)?;
                        if whole {
                            Ok(iso.into())
                        } else {
                            Ok(iso.trimmed(Interval::new(at(from), at(to)))?.into())
                        }
                    }
                };
                // A side that is a point on an axis has no curve.
                let Ok(curve) = curve else { continue };
                if curve.bounding_box().diagonal().length() > reach {
                    out.push(curve);
                }
            }
        }
    }
    Ok(out)
}

/// What lies beside the common side of two patches, if that side is in the plane.
fn beside(
    before: Option<&NurbsSurface>,
    after: Option<&NurbsSurface>,
    across: Direction,
    plane: &Plane,
    reach: f64,
) -> Option<Beside> {
    let mut found = Beside::default();
    let mut flat = None;
    for (patch, at_end) in [(before, true), (after, false)] {
        let Some(patch) = patch else { continue };
        let [n, m] = patch.counts();
        let heights: Vec<f64> = patch.control_points().iter().map(|p| plane.signed_distance(*p)).collect();
        let (rows, columns) = if across == Direction::U { (n, m) } else { (m, n) };
        let at = |i: usize, k: usize| {
            let i = if at_end { rows - 1 - i } else { i };
            heights[if across == Direction::U { i * m + k } else { k * m + i }]
        };
        let level = |i: usize| (0..columns).all(|k| at(i, k).abs() <= reach);
        flat = Some(flat.unwrap_or(true) && level(0));
        found.patches += 1;
        // The first row that leaves the plane tells the side.
        match (1..rows).find(|&i| !level(i)) {
            None => found.level += 1,
            Some(i) => {
                let sum: f64 = (0..columns).map(|k| at(i, k)).sum();
                found.above |= sum > 0.0;
                found.below |= sum < 0.0;
            }
        }
    }
    flat.filter(|f| *f).map(|_| found)
}
