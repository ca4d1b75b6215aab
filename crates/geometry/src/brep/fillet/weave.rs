//! The parts of the new brep: where strips end, what the edges beside them become, and the faces put together.

use crate::thresholds;
use std::collections::{BTreeMap, BTreeSet};

use super::FilletBlend;
use super::cut::Cut;
use super::joint::{Fans, Joint, Link, Outlet, Stub};
use super::names::Names;
use super::newton::linear;
use super::rebuild::Rails;
use super::strip::Strip;
use super::widen::{parameter_beyond, widened};
use crate::brep::{Along, Builder, LoopKind, NewEdge, NewVertex, Path};
use crate::{
    Brep, ClosestOnCurve, Curve, Direction, Interval, Line, LineCurve, Plane, PlaneSurface, Point3, Result,
};
use crate::{Surface, Tolerance, Vector3};

/// The most steps in search of the place where a ball leaves a face.
const STEPS: u32 = 20;

/// An end of a strip.
pub(super) struct End {
    /// The least and the greatest place along the edge.
    pub range: Interval,
    /// Where the rails end along the edge.
    pub places: [f64; 2],
    /// What ends the strip, from its first rail to its second.
    pub pieces: Vec<Piece>,
    /// Where the rails end.
    pub feet: [NewVertex; 2],
}

/// A new edge, or a point, that ends a strip.
pub(super) struct Piece {
    /// In the parameter plane of the strip.
    pub flat: Curve,
    /// Walked from the first rail to the second.
    pub along: Along,
}

/// A piece that a loop gets between two of its old ones.
pub(super) struct Insert {
    pub edge: NewEdge,
    pub reversed: bool,
    pub space: Curve,
    pub ends: [NewVertex; 2],
}

/// All that is known of the new brep.
pub(super) struct Weave<'a> {
    pub brep: &'a Brep,
    pub names: &'a Names,
    pub strips: BTreeMap<usize, Strip<'a>>,
    pub builder: Builder,
    pub tolerance: Tolerance,
    pub limit: f64,
    pub blend: FilletBlend,
    pub ends: BTreeMap<Stub, End>,
    /// Where stubs of other edges now end.
    pub shortened: BTreeMap<Stub, (NewVertex, f64)>,
    /// Pieces to put after a trim.
    pub inserts: BTreeMap<usize, Insert>,
    /// Flat faces that have to reach farther than they did.
    pub widened: BTreeMap<usize, Surface>,
    /// The borders of corners in place of arcs on which the ball stands still.
    pub caps: Rails,
    /// Old vertices that the new brep has already.
    pub kept: BTreeMap<usize, NewVertex>,
    /// Vertices at which rounded edges ended.
    pub gone: BTreeSet<usize>,
}

impl<'a> Weave<'a> {
    pub(super) fn fans(&self) -> Fans<'a> {
        Fans { brep: self.brep, names: self.names }
    }

    pub(super) fn strip(&self, stub: Stub) -> Result<&Strip<'a>> {
        self.strips.get(&stub.0).ok_or_else(|| self.names.refused(stub.0, "it is not rounded"))
    }

    /// Where a strip's edge ends, along it.
    pub(super) fn place(&self, stub: Stub) -> Result<f64> {
        let ends = self.strip(stub)?.ends;
        Ok(if stub.1 { ends.end } else { ends.start })
    }

    fn point(&self, stub: Stub) -> Result<Point3> {
        let curve = &self.strip(stub)?.wedge.curve;
        Ok(if stub.1 { curve.end() } else { curve.start() })
    }

    pub(super) fn end(&mut self, stub: Stub, cut: Cut, edge: NewEdge, reversed: bool, feet: [NewVertex; 2]) {
        let pieces = vec![Piece { flat: cut.flat, along: Along::Edge(edge, reversed) }];
        self.ends.insert(stub, End { range: cut.range, places: cut.ends, pieces, feet });
    }

    /// Lets a stub of an edge that is not rounded end where a rail meets it: before the vertex, or beyond it if a
    /// straight edge may be prolonged.
    pub(super) fn shorten(
        &mut self,
        stub: Stub,
        point: Point3,
        rounded: usize,
        further: bool,
    ) -> Result<NewVertex> {
        let (edge, at_end) = stub;
        let own = self.brep.edges().get(edge);
        let curve = self.brep.edge_as_curve(edge)?;
        let (Some(own), Some(curve)) = (own, curve) else {
            return Err(self.names.refused(rounded, "an edge beside it has no curve"));
        };
        let reach = self.limit + own.tolerance.max(0.0);
        let near = ClosestOnCurve::new(&curve).nearest(point).ok().filter(|near| near.distance <= reach);
        let parameter = match near {
            Some(_) if [curve.start(), curve.end()].iter().any(|p| p.distance_to(point) <= reach) => {
                let why =
                    format!("the radius is too large: it takes all of {} beside it", self.names.of(edge));
                return Err(self.names.refused(rounded, &why));
            }
            Some(near) => near.parameter,
            None => {
                let beyond = parameter_beyond(&curve, at_end, point, reach).filter(|_| further);
                beyond.ok_or_else(|| {
                    let name = self.names.of(edge);
                    let why =
                        format!("the radius is too large, or {name} beside it runs another way than its end");
                    self.names.refused(rounded, &why)
                })?
            }
        };
        let vertex = self.builder.vertex(point);
        self.shortened.insert(stub, (vertex, parameter));
        Ok(vertex)
    }

    /// Does what a joint asks for.
    pub(super) fn add(&mut self, joint: &Joint) -> Result<()> {
        match joint {
            Joint::Third { stub, beside, outlets, between } => match outlets.as_slice() {
                [outlet] => self.third(*stub, *beside, *outlet),
                _ => self.fan(*stub, *beside, outlets, between),
            },
            Joint::Border { stub, beside } => {
                let cut = Cut::across(self.strip(*stub)?, self.place(*stub)?)?;
                let feet = self.feet(*stub, &cut, *beside, false)?;
                let edge = self.builder.edge(cut.space.clone(), feet);
                self.end(*stub, cut, edge, false, feet);
                Ok(())
            }
            Joint::Through { stubs, links } => {
                let places = self.handover(*stubs, *links)?;
                let mut cuts = Vec::with_capacity(2);
                for (stub, t) in stubs.iter().zip(places) {
                    cuts.push(Cut::across(self.strip(*stub)?, t)?);
                }
                self.pair(*stubs, *links, cuts)
            }
            Joint::Mitre { stubs, links } => {
                let fans = self.fans();
                let ways = stubs.map(|stub| fans.way(stub));
                let normal = match ways {
                    [Some(a), Some(b)] => (a - b).unitized(),
                    _ => None,
                };
                let normal = normal.ok_or_else(|| self.unsupported(stubs))?;
                let plane = Plane::from_normal(self.point(stubs[0])?, normal)?;
                let size = 10.0 * self.strip(stubs[0])?.wedge.size;
                let range = Interval::new(-size, size);
                let surface: Surface = PlaneSurface::new(plane, range, range)?.into();
                let mut cuts = Vec::with_capacity(2);
                for stub in stubs {
                    let limit = 0.1 * self.tolerance.absolute;
                    let at = self.place(*stub)?;
                    cuts.push(Cut::by(self.strip(*stub)?, &surface, at, [0.0, 0.0], limit)?);
                }
                self.pair(*stubs, *links, cuts)
            }
            Joint::Ball { stubs } => self.meeting(stubs),
            Joint::Point { stub } => self.in_point(*stub),
            Joint::Cap { stubs, links, arc } => self.cap(*stubs, *links, *arc),
        }
    }

    pub(super) fn unsupported(&self, stubs: &[Stub]) -> crate::Error {
        self.fans().unsupported(stubs)
    }

    fn feet(&mut self, stub: Stub, cut: &Cut, beside: [Stub; 2], further: bool) -> Result<[NewVertex; 2]> {
        let first = self.shorten(beside[0], cut.points[0], stub.0, further)?;
        Ok([first, self.shorten(beside[1], cut.points[1], stub.0, further)?])
    }

    /// The section of a strip with the surface of a face at its end.
    pub(super) fn cut_by(&self, stub: Stub, outlet: Outlet) -> Result<Cut> {
        let strip = self.strip(stub)?;
        let none = || self.names.refused(stub.0, "the face at its end has no surface");
        let surface = self.brep.face_surface(outlet.face).ok_or_else(none)?;
        let trim = self.brep.trims().get(outlet.after).ok_or_else(none)?;
        let corner = self.brep.trim_point(outlet.after, trim.part.domain.end).ok_or_else(none)?;
        let limit = 0.1 * self.tolerance.absolute;
        Cut::by(strip, surface, self.place(stub)?, [corner.x, corner.y], limit)
    }

    /// Where two strips go on in each other: at the vertex, or, where the edge between the faces beside them slants, where
    /// the ball leaves one of these faces for the other.
    fn handover(&self, stubs: [Stub; 2], links: [Link; 2]) -> Result<[f64; 2]> {
        let own = [self.place(stubs[0])?, self.place(stubs[1])?];
        let (side, over) = match links {
            [Link::Over(over, _), Link::Face(_)] => (0, over),
            [Link::Face(_), Link::Over(over, _)] => (1, over),
            _ => return Ok(own),
        };
        // A closed edge meets itself: its strip starts and ends with it.
        if stubs[0].0 == stubs[1].0 {
            return Ok(own);
        }
        let (strip, other) = (self.strip(stubs[0])?, self.strip(stubs[1])?);
        let Some(curve) = self.brep.edge_as_curve(over.0)? else { return Ok(own) };
        let index = ClosestOnCurve::new(&curve);
        let w = if side == 0 { 0.0 } else { 1.0 };
        let mut t = own[0];
        for step in 0..STEPS {
            let p = strip.point(w, t);
            let near = index.nearest(p)?;
            let apart = curve.point_at(near.parameter) - p;
            if apart.length()
                <= if step == 0 { 0.1 * self.limit } else { thresholds::ROUNDING * strip.wedge.size }
            {
                break;
            }
            let [along, run] =
                [strip.partials(w, t)[1], curve.tangent_at(near.parameter).unwrap_or(Vector3::ZERO)];
            let slopes = [[along.dot(along), -along.dot(run)], [along.dot(run), -run.dot(run)]];
            let Some([by, _]) = linear(slopes, [along.dot(apart), run.dot(apart)]) else { return Ok(own) };
            t += by;
        }
        if t == own[0] {
            return Ok(own);
        }
        let place = strip.ball(t).and_then(|(centre, _)| other.place_of(centre, own[1]));
        Ok([t, place.ok_or_else(|| self.unsupported(&stubs))?])
    }

    /// A strip whose rails meet in a vertex, which stays.
    fn in_point(&mut self, stub: Stub) -> Result<()> {
        let t = self.place(stub)?;
        let strip = self.strip(stub)?;
        let line = Line::new(strip.place(0.0, t), strip.place(1.0, t));
        let flat = LineCurve { line, domain: Interval::new(0.0, 1.0) }.into();
        let place = self.fans().vertex(stub).ok_or_else(|| self.unsupported(&[stub]))?;
        let point = self.brep.vertices().get(place).map(|own| own.point);
        let vertex = self.builder.vertex(point.ok_or_else(|| self.unsupported(&[stub]))?);
        self.kept.insert(place, vertex);
        let pieces = vec![Piece { flat, along: Along::Point(vertex) }];
        self.ends.insert(stub, End { range: Interval::new(t, t), places: [t; 2], pieces, feet: [vertex; 2] });
        Ok(())
    }

    /// A strip that ends on one face.
    fn third(&mut self, stub: Stub, beside: [Stub; 2], outlet: Outlet) -> Result<()> {
        let cut = self.cut_by(stub, outlet)?;
        let feet = self.feet(stub, &cut, beside, true)?;
        let is_longer = |stub: &Stub| {
            let domain = self.brep.edges().get(stub.0).map(|own| own.part.domain);
            self.shortened.get(stub).zip(domain).is_some_and(|((_, t), domain)| !domain.contains(*t))
        };
        if beside.iter().any(is_longer) {
            // The corner turns in: the face goes on beyond it, down to the end of the strip.
            let old = self.widened.get(&outlet.face).or_else(|| self.brep.face_surface(outlet.face));
            let wide = old.and_then(|surface| widened(surface, &cut.points));
            self.widened.insert(outlet.face, wide.ok_or_else(|| self.unsupported(&[stub]))?);
        }
        let edge = self.builder.edge(cut.space.clone(), feet);
        let ends = if outlet.reversed { [feet[1], feet[0]] } else { feet };
        let insert = Insert { edge, reversed: outlet.reversed, space: cut.space.clone(), ends };
        self.inserts.insert(outlet.after, insert);
        self.end(stub, cut, edge, false, feet);
        Ok(())
    }

    /// Two strips that share their ends.
    fn pair(&mut self, stubs: [Stub; 2], links: [Link; 2], cuts: Vec<Cut>) -> Result<()> {
        let Ok([own, other]) = <[Cut; 2]>::try_from(cuts) else { return Err(self.unsupported(&stubs)) };
        let turned = links[0].side() == 1;
        // Equal parameters need not be equal places.
        let index = ClosestOnCurve::new(&other.space);
        let same = [0.25, 0.5, 0.75]
            .iter()
            .all(|&w| index.nearest(own.space.point_at(w)).is_ok_and(|near| near.distance <= self.limit))
            && (0..2).all(|k| {
                own.points[k].distance_to(other.points[if turned { 1 - k } else { k }]) <= self.limit
            });
        if !same {
            return Err(self.unsupported(&stubs));
        }
        let mut feet = Vec::with_capacity(2);
        for (link, point) in links.iter().zip(own.points) {
            feet.push(match link {
                Link::Face(_) => self.builder.vertex(point),
                Link::Over(over, _) => self.shorten(*over, point, stubs[0].0, false)?,
            });
        }
        let feet = [feet[0], feet[1]];
        let edge = self.builder.edge(own.space.clone(), feet);
        self.end(stubs[0], own, edge, false, feet);
        let feet = if turned { [feet[1], feet[0]] } else { feet };
        self.end(stubs[1], other, edge, turned, feet);
        Ok(())
    }

    /// The strips as faces; gives the rails of each edge with their ends.
    pub(super) fn add_strips(&mut self) -> Result<Rails> {
        let mut rails = std::mem::take(&mut self.caps);
        for (edge, strip) in &self.strips {
            let ends = (self.ends.get(&(*edge, false)), self.ends.get(&(*edge, true)));
            let (Some(start), Some(end)) = ends else {
                return Err(self.names.refused(*edge, "it has no ends"));
            };
            let slack = thresholds::SAME_PARAMETER * strip.ends.length();
            if !(start.range.end + slack < end.range.start) {
                return Err(self.names.refused(
                    *edge,
                    "the radius is too large: what is left of it between its ends is nothing",
                ));
            }
            let surface = strip.over(start.range.union(end.range))?;
            let along = if strip.is_turned() { Direction::U } else { Direction::V };
            let mut sides = Vec::with_capacity(2);
            for (k, w) in [0.0, 1.0].into_iter().enumerate() {
                let range = Interval::new(start.places[k], end.places[k]);
                let whole = surface.isocurve(along, w)?;
                let curve = if whole.domain() == range { whole } else { whole.trimmed(range)? };
                let feet = [start.feet[k], end.feet[k]];
                let flat = crate::LineCurve {
                    line: crate::Line::new(strip.place(w, range.start), strip.place(w, range.end)),
                    domain: range,
                };
                let made = self.builder.edge(curve.clone(), feet);
                sides.push((made, curve, feet, Curve::from(flat)));
            }
            let path = |curve: &Curve, along: Along| Path { curve: curve.clone(), along };
            let rail = |k: usize| path(&sides[k].3, Along::Edge(sides[k].0, false));
            let mut paths = Vec::with_capacity(2 + start.pieces.len() + end.pieces.len());
            paths.extend(start.pieces.iter().map(|piece| path(&piece.flat, piece.along)));
            paths.push(rail(1));
            paths.extend(end.pieces.iter().rev().map(|piece| turned(path(&piece.flat, piece.along))));
            paths.push(turned(rail(0)));
            if strip.is_turned() {
                paths = paths.into_iter().rev().map(turned).collect();
            }
            let reversed = self.is_reversed(strip, start.places[0], end.places[0])?;
            let face = self.builder.face(surface, reversed);
            self.builder.bound(face, LoopKind::Outer, paths)?;
            let [a, b] = [&sides[0], &sides[1]].map(|s| (s.0, s.1.clone(), s.2));
            rails.insert(*edge, [Some(a), Some(b)]);
        }
        Ok(rails)
    }

    /// Whether the face of a strip has to be turned over to agree with the first face of its edge.
    fn is_reversed(&self, strip: &Strip<'_>, from: f64, to: f64) -> Result<bool> {
        let t = 0.5 * (from + to);
        let [across, along] = strip.partials(0.0, t);
        let normal = if strip.is_turned() { along.cross(across) } else { across.cross(along) };
        let (centre, _) = strip.ball(t).ok_or_else(|| strip.wedge.too_large())?;
        // The ball lies on the side of the surface's normal where its side is 1.
        let towards = (centre - strip.point(0.0, t)) * strip.wedge.sides[0];
        let own: Vector3 = if self.brep.is_reversed(strip.wedge.faces[0]) { -towards } else { towards };
        Ok(normal.dot(own) < 0.0)
    }
}

/// A path walked backwards.
fn turned(path: Path) -> Path {
    let along = match path.along {
        Along::Edge(edge, reversed) => Along::Edge(edge, !reversed),
        point => point,
    };
    Path { curve: path.curve.reversed(), along }
}
