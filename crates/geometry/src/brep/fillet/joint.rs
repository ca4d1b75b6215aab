//! What meets where a rounded edge ends.

use std::collections::{BTreeMap, BTreeSet};

use super::names::Names;
use super::wedge::Radius;
use crate::{Brep, Result, Tolerance, Vector3};

/// One end of an edge: its place, and whether it is its end (or its start).
pub(super) type Stub = (usize, bool);

/// The most faces on which an edge may end.
const MOST_OUTLETS: usize = 100;

/// How a rail goes on beyond a vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Link {
    /// Into that side of the other strip, on the same face.
    Face(usize),
    /// Over an edge, into that side of the other strip.
    Over(Stub, usize),
}

impl Link {
    /// The side of the other strip.
    pub(super) fn side(self) -> usize {
        match self {
            Self::Face(side) | Self::Over(_, side) => side,
        }
    }
}

/// What is to be done at a vertex.
#[derive(Debug, Clone)]
pub(super) enum Joint {
    /// One rounded edge ends on the other faces at its vertex, from one of the stubs beside its sides to the other; the
    /// stubs between those faces come in the same order.
    Third { stub: Stub, beside: [Stub; 2], outlets: Vec<Outlet>, between: Vec<Stub> },
    /// One rounded edge ends at the border of the shape.
    Border { stub: Stub, beside: [Stub; 2] },
    /// A rounded edge goes on in another one, or in itself, without a kink.
    Through { stubs: [Stub; 2], links: [Link; 2] },
    /// Two rounded edges meet at an angle.
    Mitre { stubs: [Stub; 2], links: [Link; 2] },
    /// Three or more rounded edges meet, and no others.
    Ball { stubs: Vec<Stub> },
    /// A mitre between two roundings ends where both run into a face: the rounding of the mitre ends in that point.
    Point { stub: Stub },
    /// Two rounded edges run into an arc in which the rounding of a third one ended, of their own radius: the ball stands
    /// still there. The links lead from the stubs to the arc, which has that side on their common face.
    Cap { stubs: [Stub; 2], links: [[Link; 2]; 2], arc: usize },
}

/// A face on which a rounded edge ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outlet {
    pub face: usize,
    /// The trim of its loop after which the new edge comes.
    pub after: usize,
    /// Whether the new edge runs from the second side to the first there.
    pub reversed: bool,
}

/// What leads round a vertex from trim to trim.
#[derive(Clone, Copy)]
pub(super) struct Fans<'a> {
    pub brep: &'a Brep,
    pub names: &'a Names,
}

impl Fans<'_> {
    /// How many edges end at a vertex.
    pub(super) fn count(&self, vertex: usize) -> usize {
        let edges = self.brep.vertices().get(vertex).map_or(&[] as &[usize], |own| &own.edges);
        edges.iter().filter(|edge| self.brep.edges().get(**edge).is_some_and(|own| !own.deleted)).count()
    }

    /// The refusal of the vertex at which stubs meet.
    pub(super) fn unsupported(&self, stubs: &[Stub]) -> crate::Error {
        self.names.unsupported(stubs, stubs.first().and_then(|stub| self.vertex(*stub)))
    }

    /// The stub that an end of a trim is; none where the surface is singular.
    fn stub_of(&self, (trim, at_end): (usize, bool)) -> Option<Stub> {
        let own = self.brep.trims().get(trim)?;
        Some((own.edge?, at_end != own.reversed))
    }

    /// The end of a trim that a stub is.
    fn trim_end(&self, trim: usize, (_, at_end): Stub) -> Option<(usize, bool)> {
        Some((trim, at_end != self.brep.trims().get(trim)?.reversed))
    }

    /// The end of the next trim along an edge in the loop that meets an end of a trim.
    fn turned(&self, (trim, at_end): (usize, bool)) -> Option<(usize, bool)> {
        let chain = &self.brep.loops().get(self.brep.trims().get(trim)?.in_loop?)?.trims;
        let at = chain.iter().position(|t| *t == trim)?;
        let count = chain.len();
        let mut around = (1..=count).map(|n| if at_end { at + n } else { at + count - n } % count);
        // A place where the surface is singular is the same vertex.
        let next = around.find_map(|n| {
            let place = *chain.get(n)?;
            self.brep.trims().get(place)?.edge.map(|_| place)
        })?;
        Some((next, !at_end))
    }

    /// The same end of an edge on the other trim along it.
    fn across(&self, end: (usize, bool)) -> Option<(usize, bool)> {
        let stub = self.stub_of(end)?;
        let [a, b] = *self.brep.edges().get(stub.0)?.trims.as_slice() else { return None };
        self.trim_end(if a == end.0 { b } else { a }, stub)
    }

    fn side_of(&self, trim: usize) -> Option<usize> {
        let edge = self.brep.trims().get(trim)?.edge?;
        self.brep.edges().get(edge)?.trims.iter().position(|t| *t == trim)
    }

    /// The end of the trim beside a side of a stub.
    fn beside(&self, stub: Stub, side: usize) -> Option<(usize, bool)> {
        let trim = *self.brep.edges().get(stub.0)?.trims.get(side)?;
        self.turned(self.trim_end(trim, stub)?)
    }

    /// How a side of one stub leads into another stub.
    pub(super) fn link(&self, from: Stub, side: usize, to: Stub) -> Option<Link> {
        let next = self.beside(from, side)?;
        if self.stub_of(next)? == to {
            return Some(Link::Face(self.side_of(next.0)?));
        }
        let over = self.stub_of(next)?;
        let last = self.turned(self.across(next)?)?;
        (self.stub_of(last)? == to).then_some(())?;
        Some(Link::Over(over, self.side_of(last.0)?))
    }

    /// Both links from one stub to another, on different sides of it.
    pub(super) fn links(&self, stubs: [Stub; 2]) -> Option<[Link; 2]> {
        let links = [self.link(stubs[0], 0, stubs[1])?, self.link(stubs[0], 1, stubs[1])?];
        (links[0].side() != links[1].side()).then_some(links)
    }

    pub(super) fn vertex(&self, (edge, at_end): Stub) -> Option<usize> {
        self.brep.edges().get(edge)?.vertices[usize::from(at_end)]
    }

    /// The unit direction in which a stub leaves its vertex.
    pub(super) fn way(&self, (edge, at_end): Stub) -> Option<Vector3> {
        let own = self.brep.edges().get(edge)?;
        let tangent = own.part.end_tangent(self.brep.edge_curve(edge)?, at_end)?;
        Some(if at_end { -tangent } else { tangent })
    }

    /// Whether one stub goes on in another without a kink.
    pub(super) fn runs_through(&self, stubs: [Stub; 2], angle: f64) -> bool {
        match stubs.map(|stub| self.way(stub)) {
            [Some(a), Some(b)] => (-a).angle_to(b).is_some_and(|turn| turn <= angle),
            _ => false,
        }
    }

    /// What is to be done where rounded edges end.
    pub(super) fn joints(&self, edges: &[usize], tolerance: &Tolerance) -> Result<Vec<Joint>> {
        let mut at: BTreeMap<usize, Vec<Stub>> = BTreeMap::new();
        for &edge in edges {
            for stub in [(edge, false), (edge, true)] {
                let vertex =
                    self.vertex(stub).ok_or_else(|| self.names.refused(edge, "it has no vertices"))?;
                at.entry(vertex).or_default().push(stub);
            }
        }
        at.into_iter().map(|(vertex, stubs)| self.joint(vertex, &stubs, tolerance)).collect()
    }

    /// Joints of which those at both ends of an arc on which the ball stands still become one, and some end in a point.
    pub(super) fn capped(
        &self,
        joints: Vec<Joint>,
        arcs: &BTreeSet<usize>,
        points: &BTreeSet<Stub>,
    ) -> Result<Vec<Joint>> {
        let mut out = Vec::with_capacity(joints.len());
        let mut ends: BTreeMap<usize, Vec<(Stub, Stub)>> = BTreeMap::new();
        for joint in joints {
            match joint {
                Joint::Third { stub, .. } if points.contains(&stub) => out.push(Joint::Point { stub }),
                Joint::Through { stubs: [a, b], .. } if arcs.contains(&a.0) => {
                    ends.entry(a.0).or_default().push((b, a))
                }
                Joint::Through { stubs: [a, b], .. } if arcs.contains(&b.0) => {
                    ends.entry(b.0).or_default().push((a, b))
                }
                other => out.push(other),
            }
        }
        for (arc, ends) in ends {
            let found = || -> Option<Joint> {
                let &[(a, to_a), (b, to_b)] = ends.as_slice() else { return None };
                let links = [self.links([a, to_a])?, self.links([b, to_b])?];
                Some(Joint::Cap { stubs: [a, b], links, arc })
            };
            out.push(found().ok_or_else(|| self.unsupported(&[(arc, false)]))?);
        }
        Ok(out)
    }

    fn joint(&self, vertex: usize, stubs: &[Stub], tolerance: &Tolerance) -> Result<Joint> {
        let found = match *stubs {
            [stub] => self.single(stub),
            [a, b] => {
                let stubs = [a, b];
                let joint = |links| {
                    if self.runs_through(stubs, tolerance.angle) {
                        Joint::Through { stubs, links }
                    } else {
                        Joint::Mitre { stubs, links }
                    }
                };
                self.links(stubs).map(joint)
            }
            ref several if several.len() > 2 => {
                let leads = |from: Stub, side: usize| {
                    several
                        .iter()
                        .any(|to| *to != from && matches!(self.link(from, side, *to), Some(Link::Face(_))))
                };
                let all = several.iter().all(|stub| leads(*stub, 0) && leads(*stub, 1));
                all.then(|| Joint::Ball { stubs: several.to_vec() })
            }
            _ => None,
        };
        found.ok_or_else(|| self.names.unsupported(stubs, Some(vertex)))
    }

    fn single(&self, stub: Stub) -> Option<Joint> {
        let next = [self.beside(stub, 0)?, self.beside(stub, 1)?];
        let beside = [self.stub_of(next[0])?, self.stub_of(next[1])?];
        let naked = |stub: Stub| self.brep.edges().get(stub.0).is_some_and(|edge| edge.trims.len() == 1);
        if beside[0] == beside[1] {
            return None;
        }
        if naked(beside[0]) && naked(beside[1]) {
            return Some(Joint::Border { stub, beside });
        }
        let last = self.across(next[1])?;
        let mut at = self.across(next[0])?;
        let (mut outlets, mut between) = (Vec::new(), Vec::new());
        while outlets.len() < MOST_OUTLETS {
            let to = self.turned(at)?;
            let after = if at.1 { at.0 } else { to.0 };
            outlets.push(Outlet { face: self.brep.face_of(after)?, after, reversed: !at.1 });
            if to == last {
                return Some(Joint::Third { stub, beside, outlets, between });
            }
            between.push(self.stub_of(to)?);
            at = self.across(to)?;
        }
        None
    }

    /// The edges that rounded ones run into without a kink, and that have to be rounded with them, with their radii.
    pub(super) fn prolonged(
        &self,
        wanted: &mut Vec<(usize, Radius)>,
        tolerance: &Tolerance,
        sharp: impl Fn(usize) -> Option<bool>,
        arcs: bool,
    ) -> Result<()> {
        let mut next = 0;
        while let Some(&(edge, radius)) = wanted.get(next) {
            crate::cancellation::check()?;
            next += 1;
            for stub in [(edge, false), (edge, true)] {
                let Some(vertex) = self.vertex(stub) else { continue };
                let around = self.brep.vertices().get(vertex).map_or(&[] as &[usize], |v| &v.edges);
                let met = |other: usize| wanted.iter().any(|(e, _)| *e == other);
                let found = match around.iter().filter(|e| met(**e)).count() {
                    1 => around.iter().find_map(|&other| {
                        let on = [(other, false), (other, true)].into_iter().find(|to| {
                            self.vertex(*to) == Some(vertex)
                                && self.runs_through([stub, *to], tolerance.angle)
                                && self.links([stub, *to]).is_some()
                        })?;
                        (!met(other) && sharp(on.0).is_some()).then_some(on.0)
                    }),
                    2 if arcs && around.len() == 3 => around.iter().copied().find(|other| {
                        // Round the arc in which the rounding of the odd one out will end.
                        let kinds: Vec<Option<bool>> = around.iter().map(|e| sharp(*e)).collect();
                        let like = |kind: Option<bool>| kinds.iter().filter(|k| **k == kind).count();
                        let own = sharp(edge);
                        own.is_some()
                            && !met(*other)
                            && sharp(*other) == own
                            && like(own) == 2
                            && !kinds.contains(&None)
                    }),
                    _ => None,
                };
                wanted.extend(found.map(|other| (other, radius)));
            }
        }
        Ok(())
    }
}
