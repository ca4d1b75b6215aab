//! Where three or more rounded edges meet and no others: on one ball that touches all of their faces, or, cut off
//! straight, in the flat facet between the points where the cuts of each face cross.

use crate::brep::fillet::thresholds::FLAT_CARRIER;
use crate::thresholds;
use std::collections::{BTreeMap, BTreeSet};

use super::FilletBlend;
use super::corner;
use super::cut::Cut;
use super::joint::Stub;
use super::newton::{linear, solve};
use super::strip::Strip;
use super::weave::Weave;
use crate::brep::NewVertex;
use crate::{Direction, Interval, Line, LineCurve, Point3, Result, Vector3};

const UNIT: Interval = Interval { start: 0.0, end: 1.0 };

impl Weave<'_> {
    pub(super) fn meeting(&mut self, stubs: &[Stub]) -> Result<()> {
        match self.blend {
            FilletBlend::Smooth => Err(self.unsupported(stubs)),
            FilletBlend::Chamfer if self.are_flat(stubs)? => self.facet(stubs),
            _ => self.ball(stubs),
        }
    }

    /// Whether all strips are straight, between planes.
    fn are_flat(&self, stubs: &[Stub]) -> Result<bool> {
        for stub in stubs {
            let strip = self.strip(*stub)?;
            let flat = |k: usize| strip.wedge.surfaces[k].plane(FLAT_CARRIER * strip.wedge.size).is_some();
            if strip.straight_way().is_none() || !flat(0) || !flat(1) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The flat facet between the points where the rails on each face cross.
    fn facet(&mut self, stubs: &[Stub]) -> Result<()> {
        let too_large = |strip: &Strip<'_>| strip.wedge.too_large();
        // The rails on each face: the strip, and which of its sides.
        let mut rails: BTreeMap<usize, Vec<(usize, usize)>> = BTreeMap::new();
        let strips = stubs.iter().map(|stub| self.strip(*stub)).collect::<Result<Vec<_>>>()?;
        for (n, strip) in strips.iter().enumerate() {
            for (side, face) in strip.wedge.faces.into_iter().enumerate() {
                rails.entry(face).or_default().push((n, side));
            }
        }
        let mut places = vec![[0.0; 2]; strips.len()];
        let mut points = vec![[Point3::ORIGIN; 2]; strips.len()];
        let mut crossings: BTreeMap<usize, Point3> = BTreeMap::new();
        for (face, met) in &rails {
            let &[(m, j), (n, k)] = met.as_slice() else { return Err(self.unsupported(stubs)) };
            let rail = |n: usize, side: usize| {
                let w = if side == 0 { 0.0 } else { 1.0 };
                (strips[n].point(w, 0.0), strips[n].straight_way().unwrap_or(Vector3::ZERO))
            };
            let ((p, a), (q, b)) = (rail(m, j), rail(n, k));
            let slopes = [[a.dot(a), -a.dot(b)], [a.dot(b), -b.dot(b)]];
            let found = linear(slopes, [a.dot(q - p), b.dot(q - p)]).ok_or_else(|| too_large(strips[m]))?;
            let (here, there) = (p + a * found[0], q + b * found[1]);
            if !(here.distance_to(there) <= self.limit) {
                return Err(self.unsupported(stubs));
            }
            (places[m][j], places[n][k]) = (found[0], found[1]);
            (points[m][j], points[n][k]) = (here, here);
            crossings.insert(*face, here);
        }
        let normals: Vec<Option<Vector3>> = strips.iter().map(|strip| self.outward(strip)).collect();
        let feet: BTreeMap<usize, NewVertex> =
            crossings.iter().map(|(face, point)| (*face, self.builder.vertex(*point))).collect();
        let mut sides = Vec::with_capacity(stubs.len());
        for (n, &stub) in stubs.iter().enumerate() {
            let strip = self.strip(stub)?;
            let ([s, t], [a, b]) = (places[n], points[n]);
            let inward = strip.straight_way().map(|way| if stub.1 { -way } else { way });
            let (Some(inward), Some(normal)) = (inward, normals[n]) else {
                return Err(self.unsupported(stubs));
            };
            // The strip walks this side with its inner on the left, and the facet the other way round.
            let backwards = normal.cross(b - a).dot(inward) > 0.0;
            let cut = Cut {
                flat: LineCurve { line: Line::new(strip.place(0.0, s), strip.place(1.0, t)), domain: UNIT }
                    .into(),
                space: LineCurve { line: Line::new(a, b), domain: UNIT }.into(),
                range: Interval::new(s.min(t), s.max(t)),
                ends: [s, t],
                points: [a, b],
            };
            let [Some(&from), Some(&to)] = strip.wedge.faces.map(|face| feet.get(&face)) else {
                return Err(self.unsupported(stubs));
            };
            let edge = self.builder.edge(cut.space.clone(), [from, to]);
            let side = corner::Arc { edge, space: cut.space.clone(), ends: [(from, a), (to, b)] };
            sides.push((side, backwards));
            self.end(stub, cut, edge, false, [from, to]);
        }
        let flat = corner::add_facet(&mut self.builder, &sides, self.limit)?;
        if flat { Ok(()) } else { Err(self.unsupported(stubs)) }
    }

    /// The normal of a flat strip that points where those of the faces beside it do.
    fn outward(&self, strip: &Strip<'_>) -> Option<Vector3> {
        let t = strip.ends.middle();
        let [across, along] = strip.partials(0.0, t);
        let normal = across.cross(along).unitized()?;
        let towards = (strip.ball(t)?.0 - strip.point(0.0, t)) * strip.wedge.sides[0];
        let turned = self.brep.is_reversed(strip.wedge.faces[0]) != (normal.dot(towards) < 0.0);
        Some(if turned { -normal } else { normal })
    }

    /// Strips that end on one ball.
    fn ball(&mut self, stubs: &[Stub]) -> Result<()> {
        let strips = stubs.iter().map(|stub| self.strip(*stub)).collect::<Result<Vec<_>>>()?;
        let sides = |face: usize| -> Vec<f64> {
            let of = |s: &&Strip<'_>| (0..2).find(|k| s.wedge.faces[*k] == face).map(|k| s.wedge.sides[k]);
            strips.iter().filter_map(of).collect()
        };
        let faces = strips[0].wedge.faces;
        let all: BTreeSet<usize> = strips.iter().flat_map(|strip| strip.wedge.faces).collect();
        let third = all.iter().copied().find(|face| !faces.contains(face));
        let third = third.ok_or_else(|| self.unsupported(stubs))?;
        for &face in &all {
            if !matches!(sides(face).as_slice(), [a, b] if a == b) {
                return Err(self.unsupported(stubs));
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
            let steps = Direction::BOTH.map(|d| thresholds::DIFFERENCE_STEP * surface.domain(d).length());
            let steps = [thresholds::DIFFERENCE_STEP * strips[0].ends.length(), steps[0], steps[1]];
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
        let mut cuts = Vec::with_capacity(stubs.len());
        for (strip, &stub) in strips.iter().zip(stubs) {
            let near = if stub.1 { strip.ends.end } else { strip.ends.start };
            let at = strip.place_of(centre, near).ok_or_else(|| self.unsupported(stubs))?;
            let own = strip.ball(at).ok_or_else(|| self.unsupported(stubs))?;
            if !(own.0.distance_to(centre) <= self.limit && (own.1 - radius).abs() <= self.limit) {
                return Err(self.unsupported(stubs));
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
            let point = found.ok_or_else(|| self.unsupported(stubs))?;
            feet.insert(face, (self.builder.vertex(point), point));
        }
        let outward = {
            let strip = self.strip(stubs[0])?;
            let side = strip.wedge.sides[0] < 0.0;
            side != self.brep.is_reversed(strip.wedge.faces[0])
        };
        let mut rim = Vec::with_capacity(stubs.len());
        for (stub, cut, faces) in cuts {
            let ends = faces.map(|face| feet.get(&face).copied());
            let [Some(a), Some(b)] = ends else { return Err(self.unsupported(stubs)) };
            let edge = self.builder.edge(cut.space.clone(), [a.0, b.0]);
            rim.push(corner::Arc { edge, space: cut.space.clone(), ends: [a, b] });
            self.end(stub, cut, edge, false, [a.0, b.0]);
        }
        corner::add(&mut self.builder, &rim, centre, radius, outward, self.blend, &self.tolerance)
    }
}
