//! The parts of the new brep: where strips end, what the edges beside them become, and the faces put together.

use std::collections::BTreeMap;

use super::FilletBlend;
use super::corner;
use super::cut::Cut;
use super::joint::{Fans, Joint, Link, Stub};
use super::names::Names;
use super::newton::solve;
use super::rebuild::Rails;
use super::strip::Strip;
use crate::brep::{Along, Builder, LoopKind, NewEdge, NewVertex, Path};
use crate::{Brep, ClosestOnCurve, Curve, Direction, Interval, Plane, PlaneSurface, Point3, Result};
use crate::{Surface, Tolerance, Vector3};

/// An end of a strip.
pub(super) struct End {
    pub cut: Cut,
    pub edge: NewEdge,
    /// Whether the edge runs from the second rail to the first.
    pub reversed: bool,
    /// Where the rails end.
    pub feet: [NewVertex; 2],
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
}

impl<'a> Weave<'a> {
    fn fans(&self) -> Fans<'a> {
        Fans { brep: self.brep, names: self.names }
    }

    fn strip(&self, stub: Stub) -> Result<&Strip<'a>> {
        self.strips.get(&stub.0).ok_or_else(|| self.names.refused(stub.0, "it is not rounded"))
    }

    /// Where a strip's edge ends, along it.
    fn place(&self, stub: Stub) -> Result<f64> {
        let ends = self.strip(stub)?.ends;
        Ok(if stub.1 { ends.end } else { ends.start })
    }

    fn point(&self, stub: Stub) -> Result<Point3> {
        let curve = &self.strip(stub)?.wedge.curve;
        Ok(if stub.1 { curve.end() } else { curve.start() })
    }

    fn end(&mut self, stub: Stub, cut: Cut, edge: NewEdge, reversed: bool, feet: [NewVertex; 2]) {
        self.ends.insert(stub, End { cut, edge, reversed, feet });
    }

    /// Lets a stub of an edge that is not rounded end where a rail meets it.
    fn shorten(&mut self, stub: Stub, point: Point3, rounded: usize) -> Result<NewVertex> {
        let (edge, _) = stub;
        let own = self.brep.edges().get(edge);
        let curve = self.brep.edge_as_curve(edge)?;
        let (Some(own), Some(curve)) = (own, curve) else {
            return Err(self.names.refused(rounded, "an edge beside it has no curve"));
        };
        let near = ClosestOnCurve::new(&curve).nearest(point);
        let reach = self.limit + own.tolerance.max(0.0);
        let near = near.ok().filter(|near| near.distance <= reach).ok_or_else(|| {
            let why = format!(
                "the radius is too large, or {} beside it runs another way than its end",
                self.names.of(edge)
            );
            self.names.refused(rounded, &why)
        })?;
        let ends = [curve.start(), curve.end()];
        if ends.iter().any(|p| p.distance_to(point) <= reach) {
            return Err(self.names.refused(
                rounded,
                &format!("the radius is too large: it takes all of {} beside it", self.names.of(edge)),
            ));
        }
        let vertex = self.builder.vertex(point);
        self.shortened.insert(stub, (vertex, near.parameter));
        Ok(vertex)
    }

    /// Does what a joint asks for.
    pub(super) fn add(&mut self, joint: &Joint) -> Result<()> {
        match joint {
            Joint::Third { stub, beside, face, after, first } => {
                self.third(*stub, *beside, *face, *after, *first)
            }
            Joint::Border { stub, beside } => {
                let cut = Cut::across(self.strip(*stub)?, self.place(*stub)?)?;
                let feet = self.feet(*stub, &cut, *beside)?;
                let edge = self.builder.edge(cut.space.clone(), feet);
                self.end(*stub, cut, edge, false, feet);
                Ok(())
            }
            Joint::Through { stubs, links } => {
                let mut cuts = Vec::with_capacity(2);
                for stub in stubs {
                    cuts.push(Cut::across(self.strip(*stub)?, self.place(*stub)?)?);
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
            Joint::Ball { stubs } => self.ball(*stubs),
        }
    }

    fn unsupported(&self, stubs: &[Stub]) -> crate::Error {
        let vertex = stubs.first().and_then(|stub| self.fans().vertex(*stub));
        self.names.unsupported(stubs, vertex)
    }

    fn feet(&mut self, stub: Stub, cut: &Cut, beside: [Stub; 2]) -> Result<[NewVertex; 2]> {
        let first = self.shorten(beside[0], cut.points[0], stub.0)?;
        Ok([first, self.shorten(beside[1], cut.points[1], stub.0)?])
    }

    fn third(
        &mut self,
        stub: Stub,
        beside: [Stub; 2],
        face: usize,
        after: usize,
        first: usize,
    ) -> Result<()> {
        let strip = self.strip(stub)?;
        let none = || self.names.refused(stub.0, "the face at its end has no surface");
        let surface = self.brep.face_surface(face).ok_or_else(none)?;
        let trim = self.brep.trims().get(after).ok_or_else(none)?;
        let corner = self.brep.trim_point(after, trim.part.domain.end).ok_or_else(none)?;
        let limit = 0.1 * self.tolerance.absolute;
        let cut = Cut::by(strip, surface, self.place(stub)?, [corner.x, corner.y], limit)?;
        let feet = self.feet(stub, &cut, beside)?;
        let edge = self.builder.edge(cut.space.clone(), feet);
        let reversed = first == 1;
        let ends = if reversed { [feet[1], feet[0]] } else { feet };
        self.inserts.insert(after, Insert { edge, reversed, space: cut.space.clone(), ends });
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
                Link::Over(over, _) => self.shorten(*over, point, stubs[0].0)?,
            });
        }
        let feet = [feet[0], feet[1]];
        let edge = self.builder.edge(own.space.clone(), feet);
        self.end(stubs[0], own, edge, false, feet);
        let feet = if turned { [feet[1], feet[0]] } else { feet };
        self.end(stubs[1], other, edge, turned, feet);
        Ok(())
    }

    /// Three strips that end on one ball.
    fn ball(&mut self, stubs: [Stub; 3]) -> Result<()> {
        if self.blend == FilletBlend::Smooth {
            return Err(self.unsupported(&stubs));
        }
        let strips = [self.strip(stubs[0])?, self.strip(stubs[1])?, self.strip(stubs[2])?];
        let sides = |face: usize| -> Vec<f64> {
            let of = |s: &&Strip<'_>| (0..2).find(|k| s.wedge.faces[*k] == face).map(|k| s.wedge.sides[k]);
            strips.iter().filter_map(of).collect()
        };
        let faces = strips[0].wedge.faces;
        let third = strips[1].wedge.faces.into_iter().find(|face| !faces.contains(face));
        let third = third.ok_or_else(|| self.unsupported(&stubs))?;
        let all = [faces[0], faces[1], third];
        for face in all {
            if !matches!(sides(face).as_slice(), [a, b] if a == b) {
                return Err(self.unsupported(&stubs));
            }
        }
        let side = sides(third).first().copied().unwrap_or(1.0);
        let fans = self.fans();
        let found = || -> Option<(Point3, f64, Point3)> {
            let surface = self.brep.face_surface(third)?;
            let corner = fans.brep.vertices().get(fans.vertex(stubs[0])?)?.point;
            let near = crate::ClosestOnSurface::new(surface).ok()?.nearest(corner).ok()?;
            let start = if stubs[0].1 { strips[0].ends.end } else { strips[0].ends.start };
            // From a place on the edge as far from the corner as the ball is large.
            let reach = strips[0].ball(start)?.1 * strips[0].ends.length() / strips[0].wedge.size;
            let t = if stubs[0].1 { start - reach } else { start + reach };
            let steps = Direction::BOTH.map(|d| 1e-5 * surface.domain(d).length());
            let steps = [1e-5 * strips[0].ends.length(), steps[0], steps[1]];
            let normal = |u: f64, v: f64| {
                let d = surface.derivatives(u, v, 1, surface.inner_quadrant(u, v));
                d.get(1, 0).cross(d.get(0, 1)).unitized()
            };
            let x = solve([t, near.u, near.v], &steps, strips[0].wedge.size, |x| {
                let (centre, radius) = strips[0].ball(x[0])?;
                let apart = surface.point_at(x[1], x[2]) + normal(x[1], x[2])? * (side * radius) - centre;
                Some([apart.x, apart.y, apart.z])
            })?;
            let (centre, radius) = strips[0].ball(x[0])?;
            Some((centre, radius, surface.point_at(x[1], x[2])))
        };
        let (centre, radius, _) = found().ok_or_else(|| strips[0].wedge.too_large())?;
        let mut cuts = Vec::with_capacity(3);
        for (strip, stub) in strips.iter().zip(stubs) {
            let near = if stub.1 { strip.ends.end } else { strip.ends.start };
            let at = strip.place_of(centre, near).ok_or_else(|| self.unsupported(&stubs))?;
            let own = strip.ball(at).ok_or_else(|| self.unsupported(&stubs))?;
            if !(own.0.distance_to(centre) <= self.limit && (own.1 - radius).abs() <= self.limit) {
                return Err(self.unsupported(&stubs));
            }
            if !strip.ends.contains(at) {
                return Err(strip.wedge.too_large());
            }
            cuts.push((stub, Cut::across(strip, at)?, strip.wedge.faces));
        }
        // One vertex for each face.
        let mut feet: BTreeMap<usize, (NewVertex, Point3)> = BTreeMap::new();
        for face in all {
            let found = cuts
                .iter()
                .find_map(|(_, cut, faces)| faces.iter().position(|f| *f == face).map(|k| cut.points[k]));
            let point = found.ok_or_else(|| self.unsupported(&stubs))?;
            feet.insert(face, (self.builder.vertex(point), point));
        }
        let outward = {
            let strip = self.strip(stubs[0])?;
            let side = strip.wedge.sides[0] < 0.0;
            side != self.brep.is_reversed(strip.wedge.faces[0])
        };
        let mut rim = Vec::with_capacity(3);
        for (stub, cut, faces) in cuts {
            let ends = faces.map(|face| feet.get(&face).copied());
            let [Some(a), Some(b)] = ends else { return Err(self.unsupported(&stubs)) };
            let edge = self.builder.edge(cut.space.clone(), [a.0, b.0]);
            rim.push(corner::Arc { edge, space: cut.space.clone(), ends: [a, b] });
            self.end(stub, cut, edge, false, [a.0, b.0]);
        }
        corner::add(&mut self.builder, &rim, centre, radius, outward, self.blend, &self.tolerance)
    }

    /// The strips as faces; gives the rails of each edge with their ends.
    pub(super) fn add_strips(&mut self) -> Result<Rails> {
        let mut rails = BTreeMap::new();
        for (edge, strip) in &self.strips {
            let ends = (self.ends.get(&(*edge, false)), self.ends.get(&(*edge, true)));
            let (Some(start), Some(end)) = ends else {
                return Err(self.names.refused(*edge, "it has no ends"));
            };
            let slack = 1e-9 * strip.ends.length();
            if !(start.cut.range.end + slack < end.cut.range.start) {
                return Err(self.names.refused(
                    *edge,
                    "the radius is too large: what is left of it between its ends is nothing",
                ));
            }
            let surface = strip.over(start.cut.range.union(end.cut.range))?;
            let along = if strip.is_turned() { Direction::U } else { Direction::V };
            let mut sides = Vec::with_capacity(2);
            for (k, w) in [0.0, 1.0].into_iter().enumerate() {
                let range = Interval::new(start.cut.ends[k], end.cut.ends[k]);
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
            let path = |curve: &Curve, edge: NewEdge, backwards: bool, reversed: bool| Path {
                curve: if backwards { curve.reversed() } else { curve.clone() },
                along: Along::Edge(edge, backwards != reversed),
            };
            let mut paths = vec![
                path(&start.cut.flat, start.edge, false, start.reversed),
                path(&sides[1].3, sides[1].0, false, false),
                path(&end.cut.flat, end.edge, true, end.reversed),
                path(&sides[0].3, sides[0].0, true, false),
            ];
            if strip.is_turned() {
                paths = paths.into_iter().rev().map(turned).collect();
            }
            let reversed = self.is_reversed(strip, start.cut.ends[0], end.cut.ends[0])?;
            let face = self.builder.face(surface, reversed);
            self.builder.bound(face, LoopKind::Outer, paths)?;
            let [a, b] = [&sides[0], &sides[1]].map(|s| (s.0, s.1.clone(), s.2));
            rails.insert(*edge, [a, b]);
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
