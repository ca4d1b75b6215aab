//! The part of a ball that stands still while its contact with a strip runs round: three edges of one radius at a corner,
//! of which one was rounded before the others.

use super::corner;
use super::cut::Cut;
use super::joint::{Link, Stub};
use super::weave::Weave;
use crate::{Result, Xform};

impl Weave<'_> {
    pub(super) fn cap(&mut self, stubs: [Stub; 2], links: [[Link; 2]; 2], arc: usize) -> Result<()> {
        let mut cuts = Vec::with_capacity(2);
        let mut tops = Vec::with_capacity(2);
        let mut foots = Vec::with_capacity(2);
        for (stub, links) in stubs.iter().zip(links) {
            let cut = Cut::across(self.strip(*stub)?, self.place(*stub)?)?;
            let top = links.iter().position(|link| matches!(link, Link::Face(_)));
            let foot = links.iter().enumerate().find_map(|(side, link)| match link {
                Link::Over(over, side_of_arc) => Some((side, *over, *side_of_arc)),
                Link::Face(_) => None,
            });
            let (Some(top), Some(foot)) = (top, foot) else { return Err(self.unsupported(&stubs)) };
            cuts.push(cut);
            tops.push(top);
            foots.push(foot);
        }
        let still = cuts[0].points[tops[0]];
        let strip = self.strip(stubs[0])?;
        let ball = strip.ball(self.place(stubs[0])?).ok_or_else(|| self.unsupported(&stubs))?;
        let other =
            self.strip(stubs[1])?.ball(self.place(stubs[1])?).ok_or_else(|| self.unsupported(&stubs))?;
        let outward = (strip.wedge.sides[0] < 0.0) != self.brep.is_reversed(strip.wedge.faces[0]);
        // The arc, moved down to where the ball touches the strip in which it ends.
        let curve = self.brep.edge_as_curve(arc)?.ok_or_else(|| self.unsupported(&stubs))?;
        let ends = [0, 1].map(|k: usize| cuts[k].points[foots[k].0]);
        let vertex = |stub: Stub| self.fans().vertex(stub);
        let turned = vertex(stubs[0]) != vertex((arc, false));
        let [from, to] = if turned { [ends[1], ends[0]] } else { ends };
        let lowered = curve.transformed(&Xform::translation(from - curve.start()))?;
        let middle = lowered.point_at(lowered.domain().middle());
        let meets = lowered.end().distance_to(to) <= self.limit
            && cuts[1].points[tops[1]].distance_to(still) <= self.limit
            && other.0.distance_to(ball.0) <= self.limit
            && (middle.distance_to(ball.0) - ball.1).abs() <= self.limit
            && (to.distance_to(ball.0) - ball.1).abs() <= self.limit;
        if !meets || foots[0].2 != foots[1].2 {
            return Err(self.unsupported(&stubs));
        }
        let top = self.builder.vertex(still);
        let mut sides = Vec::with_capacity(3);
        let mut feet = Vec::with_capacity(2);
        for ((stub, cut), (side, over, _)) in stubs.into_iter().zip(cuts).zip(&foots) {
            let foot = self.shorten(*over, cut.points[*side], stub.0, false)?;
            let ends = if *side == 0 { [foot, top] } else { [top, foot] };
            let edge = self.builder.edge(cut.space.clone(), ends);
            sides.push(corner::Arc {
                edge,
                space: cut.space.clone(),
                ends: [(ends[0], cut.points[0]), (ends[1], cut.points[1])],
            });
            feet.push(foot);
            self.end(stub, cut, edge, false, ends);
        }
        let feet = if turned { [feet[1], feet[0]] } else { [feet[0], feet[1]] };
        let edge = self.builder.edge(lowered.clone(), feet);
        sides.push(corner::Arc { edge, space: lowered.clone(), ends: [(feet[0], from), (feet[1], to)] });
        let rail = Some((edge, lowered, feet));
        self.caps.insert(arc, if foots[0].2 == 0 { [rail, None] } else { [None, rail] });
        let (blend, tolerance) = (self.blend, self.tolerance);
        corner::add(&mut self.builder, &sides, ball.0, ball.1, outward, blend, &tolerance)
    }
}
