//! The old faces, with rails in place of the rounded edges and the edges beside them shortened.

use crate::brep::fillet::thresholds::BOX_REACH;
use crate::thresholds;
use std::collections::BTreeMap;

use super::weave::Weave;
use super::widen::part_of;
use crate::brep::{Along, LoopKind, NewEdge, NewVertex, Path};
use crate::intersect::{Crossing, curve_curve, curve_self};
use crate::region::{FillRule, Region};
use crate::{
    BoundingBox, Containment, Curve, Direction, Interval, Plane, Point3, Result, Surface, Tolerance, Vector3,
    Xform,
};

/// A border of a rounding: its edge, its curve and where it ends.
pub(super) type Rail = (NewEdge, Curve, [NewVertex; 2]);
/// The rails of each rounded edge, by side; none on a face that the ball only touches at a point.
pub(super) type Rails = BTreeMap<usize, [Option<Rail>; 2]>;

/// A path of a loop, and the rounded edge that made it what it is.
struct Step {
    path: Path,
    ends: [NewVertex; 2],
    made_by: Option<usize>,
}

impl Weave<'_> {
    /// All faces that were there before, each in its new bounds.
    /// Gives the new places of the edges that stay.
    pub(super) fn add_faces(&mut self, rails: &Rails) -> Result<BTreeMap<usize, usize>> {
        let mut vertices: BTreeMap<usize, NewVertex> = std::mem::take(&mut self.kept);
        let mut edges: BTreeMap<usize, (NewEdge, Option<Interval>, [NewVertex; 2])> = BTreeMap::new();
        for place in 0..self.brep.edges().len() {
            if !rails.contains_key(&place) {
                self.keep_edge(place, &mut vertices, &mut edges)?;
            }
        }
        for place in 0..self.brep.faces().len() {
            crate::cancellation::check()?;
            let Some(face) = self.brep.faces().get(place).filter(|face| !face.deleted) else { continue };
            let Some(surface) = self.brep.face_surface(place) else { continue };
            let wide = self.widened.get(&place).cloned();
            let surface = wide.as_ref().unwrap_or(surface);
            let new = self.builder.face(surface.clone(), face.reversed);
            let made = self.builder.parts.faces.len() - 1;
            if let Some(own) = self.builder.parts.faces.get_mut(made) {
                (own.material_channel, own.id, own.colour) = (face.material_channel, face.id, face.colour);
            }
            let mut loops: Vec<(LoopKind, Vec<Step>)> = Vec::new();
            for chain in face.loops.iter().filter_map(|l| self.brep.loops().get(*l)) {
                let mut steps = Vec::with_capacity(chain.trims.len());
                for &trim in &chain.trims {
                    self.step(trim, surface, rails, &edges, &mut vertices, &mut steps)?;
                }
                loops.push((chain.kind, steps));
            }
            self.check_bounds(surface, &loops)?;
            for (kind, steps) in loops {
                self.builder.bound(new, kind, steps.into_iter().map(|step| step.path).collect())?;
            }
        }
        Ok(edges.into_iter().map(|(place, (new, ..))| (place, new.0)).collect())
    }

    fn old_vertex(&mut self, place: usize, known: &mut BTreeMap<usize, NewVertex>) -> Result<NewVertex> {
        if let Some(vertex) = known.get(&place) {
            return Ok(*vertex);
        }
        let old = self.brep.vertices().get(place);
        let point = old.map(|v| v.point).ok_or(crate::Error::degenerate("brep", "an edge has no vertex"))?;
        let new = self.builder.vertex(point);
        known.insert(place, new);
        Ok(new)
    }

    fn keep_edge(
        &mut self,
        place: usize,
        vertices: &mut BTreeMap<usize, NewVertex>,
        edges: &mut BTreeMap<usize, (NewEdge, Option<Interval>, [NewVertex; 2])>,
    ) -> Result<()> {
        let Some(own) = self.brep.edges().get(place).filter(|own| !own.deleted) else { return Ok(()) };
        let Some(curve) = self.brep.edge_as_curve(place)? else { return Ok(()) };
        let cut = [false, true].map(|end| self.shortened.get(&(place, end)).copied());
        let mut ends = Vec::with_capacity(2);
        for (old, cut) in own.vertices.iter().zip(cut) {
            ends.push(match (cut, old) {
                (Some((vertex, _)), _) => vertex,
                (None, Some(old)) => self.old_vertex(*old, vertices)?,
                _ => return Err(crate::Error::degenerate("brep", "an edge has no vertex")),
            });
        }
        let ends = [ends[0], ends[1]];
        let domain = curve.domain();
        let range =
            Interval::new(cut[0].map_or(domain.start, |(_, t)| t), cut[1].map_or(domain.end, |(_, t)| t));
        if range == domain {
            edges.insert(place, (self.builder.edge(curve, ends), None, ends));
            return Ok(());
        }
        let least = thresholds::SAME_PARAMETER * domain.length();
        if !(range.end - range.start > least) {
            return Err(crate::Error::Invalid {
                what: "fillet",
                why: format!(
                    "the radii are too large: nothing of {} between them would be left",
                    self.names.of(place)
                ),
            });
        }
        let curve = part_of(&curve, range)?;
        edges.insert(place, (self.builder.edge(curve, ends), Some(range), ends));
        Ok(())
    }

    fn step(
        &mut self,
        place: usize,
        surface: &Surface,
        rails: &Rails,
        edges: &BTreeMap<usize, (NewEdge, Option<Interval>, [NewVertex; 2])>,
        vertices: &mut BTreeMap<usize, NewVertex>,
        steps: &mut Vec<Step>,
    ) -> Result<()> {
        let none = || crate::Error::degenerate("brep", "a trim has no curve or no edge");
        let trim = self.brep.trims().get(place).ok_or_else(none)?;
        let flip = |ends: [NewVertex; 2]| if trim.reversed { [ends[1], ends[0]] } else { ends };
        match trim.edge {
            // Where the surface is singular at a vertex that is rounded off, nothing is left of it.
            None if trim.vertices[0].is_some_and(|vertex| self.gone.contains(&vertex)) => {}
            None => {
                let vertex = self.old_vertex(trim.vertices[0].ok_or_else(none)?, vertices)?;
                let curve = self.brep.trim_as_curve(place)?.ok_or_else(none)?;
                let path = Path { curve, along: Along::Point(vertex) };
                steps.push(Step { path, ends: [vertex; 2], made_by: None });
            }
            Some(edge) => {
                let made = match rails.get(&edge) {
                    Some(sides) => {
                        let own = self.brep.edges().get(edge).ok_or_else(none)?;
                        let side = own.trims.iter().position(|t| *t == place).ok_or_else(none)?;
                        let Some((new, curve, ends)) = sides.get(side).ok_or_else(none)? else {
                            return Ok(());
                        };
                        let flat = self.rail_in(surface, edge, side, curve)?;
                        let flat = if trim.reversed { flat.reversed() } else { flat };
                        let path = Path { curve: flat, along: Along::Edge(*new, trim.reversed) };
                        Step { path, ends: flip(*ends), made_by: Some(edge) }
                    }
                    None => {
                        let (new, range, ends) = edges.get(&edge).ok_or_else(none)?;
                        let flat = self.brep.trim_as_curve(place)?.ok_or_else(none)?;
                        let flat = match range {
                            Some(range) => {
                                self.shortened_trim(surface, &flat, edge, *range, trim.reversed)?
                            }
                            None => flat,
                        };
                        let path = Path { curve: flat, along: Along::Edge(*new, trim.reversed) };
                        Step { path, ends: flip(*ends), made_by: None }
                    }
                };
                steps.push(made);
            }
        }
        if let Some(insert) = self.inserts.get(&place) {
            let at = steps.last().map_or(Point3::ORIGIN, |step| step.path.curve.end());
            let space = if insert.reversed { insert.space.reversed() } else { insert.space.clone() };
            let flat = self.pulled(surface, &space)?;
            let flat = on_turn(surface, flat, at, 0.0)?;
            let path = Path { curve: flat, along: Along::Edge(insert.edge, insert.reversed) };
            steps.push(Step { path, ends: insert.ends, made_by: Some(usize::MAX) });
        }
        Ok(())
    }

    fn pulled(&self, surface: &Surface, curve: &Curve) -> Result<Curve> {
        let fine = Tolerance { absolute: 0.1 * self.tolerance.absolute, ..self.tolerance };
        surface.parameter_curve(curve, &fine)
    }

    /// A rail in the parameter plane of its face, on the turn on which the ball touched it.
    fn rail_in(&self, surface: &Surface, edge: usize, side: usize, rail: &Curve) -> Result<Curve> {
        let lost = || self.names.refused(edge, "its rounding cannot be followed on a face beside it");
        let flat = self.pulled(surface, rail).map_err(|_| lost())?;
        let Some(strip) = self.strips.get(&edge) else { return Ok(flat) };
        let (t, place) = strip.contact_place(side);
        let x = rail.domain().normalized(rail.domain().clamp(t));
        on_turn(surface, flat, place, x)
    }

    /// The part of a trim along what is left of its edge.
    fn shortened_trim(
        &self,
        surface: &Surface,
        flat: &Curve,
        edge: usize,
        range: Interval,
        reversed: bool,
    ) -> Result<Curve> {
        let curve =
            self.brep.edge_as_curve(edge)?.ok_or_else(|| self.names.refused(edge, "it has no curve"))?;
        let (whole, domain) = (flat.domain(), curve.domain());
        let place = |t: f64| {
            let x = domain.normalized(t);
            let guess = whole.at(if reversed { 1.0 - x } else { x });
            if t <= domain.start || t >= domain.end {
                guess
            } else {
                near(surface, flat, curve.point_at(t), guess)
            }
        };
        let (a, b) = (place(range.start), place(range.end));
        let part = Interval::new(a.min(b), a.max(b));
        if !part.is_increasing() || (a < b) == reversed {
            return Err(self.names.refused(edge, "what is left of it cannot be found on a face beside it"));
        }
        part_of(flat, part)
    }

    /// Refuses loops that the new rails and ends would make cross each other.
    fn check_bounds(&self, surface: &Surface, loops: &[(LoopKind, Vec<Step>)]) -> Result<()> {
        let all: Vec<&Step> = loops.iter().flat_map(|(_, steps)| steps).collect();
        let Some(named) = all
            .iter()
            .find_map(|step| step.made_by.filter(|e| *e != usize::MAX))
            .or_else(|| all.iter().any(|step| step.made_by.is_some()).then_some(usize::MAX))
        else {
            return Ok(());
        };
        let too_large = |edge: usize| -> crate::Error {
            let edge =
                if edge == usize::MAX { self.strips.keys().next().copied().unwrap_or(0) } else { edge };
            self.names
                .refused(edge, "the radius is too large: its rounding runs into other edges of its faces")
        };
        let size = Direction::BOTH.map(|d| surface.domain(d).length());
        let least = thresholds::SAME_PARAMETER * size[0].min(size[1]);
        let boxes: Vec<BoundingBox> = all.iter().map(|step| step.path.curve.bounding_box()).collect();
        let apart = |i: usize, j: usize| are_apart(&boxes[i].inflated(least), &boxes[j]);
        for (i, a) in all.iter().enumerate() {
            crate::cancellation::check()?;
            let p = &a.path.curve;
            // An inset rail may run into itself, as that of a narrow bay does.
            if let Some(edge) = a.made_by {
                let met = curve_self(p, least)?;
                let reach = BOX_REACH * boxes[i].diagonal().length();
                let at_seam =
                    |c: &Crossing| c.point.distance_to(p.start()).max(c.point.distance_to(p.end())) <= reach;
                if !met.overlaps.is_empty() || met.crossings.iter().any(|c| !at_seam(c)) {
                    return Err(too_large(edge));
                }
            }
            for (j, b) in all.iter().enumerate().skip(i + 1) {
                let Some(by) = a.made_by.or(b.made_by).filter(|_| !apart(i, j)) else { continue };
                let q = &b.path.curve;
                let reach = BOX_REACH * (boxes[i].diagonal().length() + boxes[j].diagonal().length());
                let met = curve_curve(p, q, least)?;
                let at_joint = |point: Point3| {
                    let ends = |c: &Curve| [c.start(), c.end()];
                    let near = |c: &Curve| ends(c).iter().any(|e| e.distance_to(point) <= reach);
                    near(p) && near(q) && a.ends.iter().any(|v| b.ends.contains(v))
                };
                if !met.overlaps.is_empty() || met.crossings.iter().any(|c| !at_joint(c.point)) {
                    return Err(too_large(if by == usize::MAX { named } else { by }));
                }
            }
        }
        let closed = |steps: &[Step]| {
            crate::curve::chained(steps.iter().map(|step| step.path.curve.clone()).collect(), 0.0)
        };
        let mut outline: Option<Region> = None;
        for (kind, steps) in loops {
            let chain = closed(steps);
            let area = chain.signed_area_in(&Plane::XY).0;
            match kind {
                LoopKind::Outer => {
                    if !(area > 0.0) {
                        return Err(too_large(named));
                    }
                    if loops.len() > 1 {
                        outline = Region::new(&[chain], FillRule::Any, &Plane::XY, 10.0 * least).ok();
                    }
                }
                LoopKind::Inner => {
                    if !(area < 0.0) {
                        return Err(too_large(named));
                    }
                    let start = chain.start();
                    if let Some(outline) = &outline
                        && outline.contains(start, least)? == Containment::Outside
                    {
                        return Err(too_large(named));
                    }
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// A curve of the parameter plane moved by periods so that its point at a share of its domain is near a place.
fn on_turn(surface: &Surface, flat: Curve, place: Point3, x: f64) -> Result<Curve> {
    let here = flat.point_at(flat.domain().at(x));
    let mut by = [0.0; 2];
    for d in Direction::BOTH {
        if surface.is_closed(d) {
            let period = surface.domain(d).length();
            let gap = if d == Direction::U { place.x - here.x } else { place.y - here.y };
            by[d.index()] = (gap / period).round() * period;
        }
    }
    if by == [0.0; 2] {
        return Ok(flat);
    }
    flat.transformed(&Xform::translation(Vector3::new(by[0], by[1], 0.0)))
}

/// Where the image of a trim is nearest to a point that lies on it.
fn near(surface: &Surface, flat: &Curve, p: Point3, guess: f64) -> f64 {
    const LOOKS: u32 = 64;
    let domain = flat.domain();
    let image = |s: f64| {
        let uv = flat.point_at(s);
        surface.point_at(uv.x, uv.y)
    };
    let mut best = (image(guess).distance_to(p), guess);
    for k in 0..=LOOKS {
        let s = domain.at(f64::from(k) / f64::from(LOOKS));
        let distance = image(s).distance_to(p);
        if distance < best.0 {
            best = (distance, s);
        }
    }
    let mut s = best.1;
    for _ in 0..20 {
        let [uv, way] = flat.jet_at::<2>(s, s > domain.middle());
        let d = surface.derivatives(uv.x, uv.y, 1, surface.inner_quadrant(uv.x, uv.y));
        let velocity = d.get(1, 0) * way.x + d.get(0, 1) * way.y;
        let by = (p - d.point()).dot(velocity) / velocity.length_squared();
        if !by.is_finite() {
            break;
        }
        let next = domain.clamp(s + by);
        let done = (next - s).abs() <= thresholds::NEWTON_DONE * domain.length();
        s = next;
        if done {
            break;
        }
    }
    if image(s).distance_to(p) <= best.0 { s } else { best.1 }
}

/// Whether two boxes have no point in common, in the parameter plane.
fn are_apart(a: &BoundingBox, b: &BoundingBox) -> bool {
    a.max.x < b.min.x || b.max.x < a.min.x || a.max.y < b.min.y || b.max.y < a.min.y
}
