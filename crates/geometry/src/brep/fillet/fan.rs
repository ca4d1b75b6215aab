//! The end of a rounded edge on several faces, as at the tip of a pyramid: a piece on each, between the points where the
//! edges between those faces go through the strip.

use super::cut::Cut;
use super::joint::{Outlet, Stub};
use super::weave::{End, Insert, Piece, Weave};
use crate::brep::Along;
use crate::brep::fillet::thresholds::FLAT_CARRIER;
use crate::thresholds;
use crate::{Interval, Point3, Result};

/// Halvings until a place across the strip is found.
const HALVINGS: u32 = 60;
/// Up to this part of the strip's length places along it are one.
const SAME: f64 = 1e-9;

impl Weave<'_> {
    pub(super) fn fan(
        &mut self,
        stub: Stub,
        beside: [Stub; 2],
        outlets: &[Outlet],
        between: &[Stub],
    ) -> Result<()> {
        let strip = self.strip(stub)?;
        // Only straight strips know their section with a plane at every place across.
        let flat = |o: &Outlet| {
            self.brep.face_surface(o.face).is_some_and(|s| s.plane(FLAT_CARRIER * strip.wedge.size).is_some())
        };
        if strip.straight_way().is_none() || !outlets.iter().all(flat) {
            return Err(self.unsupported(&[stub]));
        }
        let slack = SAME * strip.ends.length();
        let cuts = outlets.iter().map(|outlet| self.cut_by(stub, *outlet)).collect::<Result<Vec<Cut>>>()?;
        let place = |cut: &Cut, w: f64| cut.flat.point_at(w).y;
        let mut breaks = vec![0.0];
        for pair in cuts.windows(2) {
            let apart = |w: f64| place(&pair[0], w) - place(&pair[1], w);
            let mut range = Interval::new(breaks.last().copied().unwrap_or(0.0), 1.0);
            let side = apart(range.start).signum();
            if !(side * apart(range.end) < 0.0) {
                return Err(self.unsupported(&[stub]));
            }
            for _ in 0..HALVINGS {
                let middle = range.middle();
                if side * apart(middle) > 0.0 {
                    range.start = middle;
                } else {
                    range.end = middle;
                }
            }
            breaks.push(range.middle());
        }
        breaks.push(1.0);
        let parts: Vec<Interval> = breaks.windows(2).map(|b| Interval::new(b[0], b[1])).collect();
        // The strip ends on whichever face comes first; where that is not its own the faces turn in.
        let toward = if stub.1 { 1.0 } else { -1.0 };
        let nearest = parts.iter().zip(&cuts).all(|(part, own)| {
            part.length() > thresholds::SAME_PARAMETER
                && cuts
                    .iter()
                    .all(|cut| toward * (place(cut, part.middle()) - place(own, part.middle())) >= -slack)
        });
        if !nearest {
            return Err(self.unsupported(&[stub]));
        }
        let (Some(first), Some(last)) = (cuts.first(), cuts.last()) else {
            return Err(self.unsupported(&[stub]));
        };
        let places = [first.ends[0], last.ends[1]];
        let ends: [Point3; 2] = [first.points[0], last.points[1]];
        let mut vertices = vec![self.shorten(beside[0], ends[0], stub.0, false)?];
        for (over, (cut, w)) in between.iter().zip(cuts.iter().zip(&breaks[1..])) {
            vertices.push(self.shorten(*over, cut.space.point_at(*w), stub.0, false)?);
        }
        vertices.push(self.shorten(beside[1], ends[1], stub.0, false)?);
        let feet = [vertices[0], vertices[vertices.len() - 1]];
        let mut pieces = Vec::with_capacity(cuts.len());
        let mut range: Option<Interval> = None;
        for (n, ((cut, part), outlet)) in cuts.iter().zip(parts).zip(outlets).enumerate() {
            let (flat, space) = (cut.flat.trimmed(part)?, cut.space.trimmed(part)?);
            let bounds = flat.bounding_box();
            let own = Interval::new(bounds.min.y, bounds.max.y);
            range = Some(range.map_or(own, |all| all.union(own)));
            let ends = [vertices[n], vertices[n + 1]];
            let edge = self.builder.edge(space.clone(), ends);
            let ends = if outlet.reversed { [ends[1], ends[0]] } else { ends };
            self.inserts.insert(outlet.after, Insert { edge, reversed: outlet.reversed, space, ends });
            pieces.push(Piece { flat, along: Along::Edge(edge, false) });
        }
        let range = range.ok_or_else(|| self.unsupported(&[stub]))?;
        self.ends.insert(stub, End { range, places, pieces, feet });
        Ok(())
    }
}
