//! Where points lie: on a face, in a solid, and what part of a brep is nearest to them.

use crate::brep::thresholds::{AWAY_FROM_EDGES, NEAR_RAY, NEARLY_TOUCHES, ROUGH_LENGTH};
use crate::thresholds;
use std::sync::{Arc as Shared, OnceLock};

use super::Brep;
use crate::region::Outline;
use crate::surface::Round;
use crate::{
    BoundingBox, ClosestOnCurve, ClosestOnSurface, Containment, Curve, Error, Line, Plane, Point3, Result,
    Surface, Vector3,
    intersect::{self, ContactKind},
};

/// A face prepared for questions: its surface and its loops.
#[derive(Debug)]
pub(super) struct Sheet {
    pub(super) face: usize,
    /// Made when it is first asked: not all questions need it.
    closest: OnceLock<ClosestOnSurface>,
    /// The sphere, cylinder or cone that its surface is a part of, where it is one.
    round: OnceLock<Option<Box<Round>>>,
    outlines: Vec<Outline>,
    loops: Vec<Curve>,
    pub(super) bounds: BoundingBox,
    pub(super) reversed: bool,
}

impl Sheet {
    /// Its whole surface, prepared for questions about nearest points.
    pub(super) fn closest(&self, brep: &Brep) -> Result<&ClosestOnSurface> {
        if let Some(made) = self.closest.get() {
            return Ok(made);
        }
        let surface =
            brep.face_surface(self.face).ok_or(Error::degenerate("brep", "there is no such face"))?;
        let made = ClosestOnSurface::new(surface)?;
        Ok(self.closest.get_or_init(|| made))
    }

    /// How often the loops run round a pair of parameters: once on the face.
    pub(super) fn covers(&self, u: f64, v: f64) -> bool {
        self.outlines.iter().map(|outline| outline.winding([u, v])).sum::<i32>() != 0
    }
}

/// Where a segment meets a surface.
struct PiercedAt {
    point: Point3,
    /// The parameters; none beyond the ends of the surface.
    uv: Option<[f64; 2]>,
    /// Whether the segment goes through the surface, and does not only touch it.
    through: bool,
}

/// What a segment and a surface have in common.
enum Pierced {
    Points(Vec<PiercedAt>),
    /// They run along each other, or nearly touch: another segment tells more.
    Unclear,
}

impl Pierced {
    /// For a surface of any kind.
    fn general(surface: &Surface, p: Point3, way: Vector3) -> Result<Self> {
        let line: Curve = Line::new(p, p + way).into();
        let found = intersect::curve_with_surface(&line, surface, NEAR_RAY * way.length())?;
        if !found.overlaps.is_empty() || !found.complete {
            return Ok(Self::Unclear);
        }
        let points = found.crossings.iter().map(|c| PiercedAt {
            point: c.point,
            uv: Some([c.u, c.v]),
            through: c.kind == ContactKind::Transversal,
        });
        Ok(Self::Points(points.collect()))
    }
}

impl Sheet {
    /// The sphere, cylinder or cone that its surface is a part of.
    fn round(&self, surface: &Surface) -> Option<&Round> {
        self.round.get_or_init(|| Round::of(surface).map(Box::new)).as_deref()
    }

    /// Whether a point is farther than a distance from the whole plane, sphere, cylinder or cone that the surface is a part
    /// of; of others that is not told.
    fn is_aside(&self, surface: &Surface, p: Point3, reach: f64) -> bool {
        match surface {
            Surface::Plane(flat) => flat.plane().signed_distance(p).abs() > reach,
            _ => self.round(surface).is_some_and(|round| round.distance_to_whole(p) > reach),
        }
    }

    /// Where a segment meets the surface, by a formula: of planes, spheres, cylinders and cones.
    fn pierced(&self, surface: &Surface, p: Point3, way: Vector3) -> Option<Pierced> {
        let length = way.length();
        let inside = |s: f64| (0.0..=length).contains(&s);
        let at = |s: f64| p + way * (s / length);
        if let Surface::Plane(flat) = surface {
            let plane = flat.plane();
            let (height, slope) = (plane.signed_distance(p), way.dot(plane.z_axis) / length);
            if slope.abs() <= NEAR_RAY {
                let beside = height.abs() > NEAR_RAY * length;
                return Some(if beside { Pierced::Points(Vec::new()) } else { Pierced::Unclear });
            }
            let place = |s: f64| {
                let point = at(s);
                PiercedAt { point, uv: Some(flat.parameters_of(point)), through: true }
            };
            return Some(Pierced::Points(
                Some(-height / slope).filter(|s| inside(*s)).map(place).into_iter().collect(),
            ));
        }
        let round = self.round(surface)?;
        let Some([first, second]) = round.line(p, way / length) else {
            return Some(Pierced::Points(Vec::new()));
        };
        if second - first <= NEARLY_TOUCHES * length {
            return Some(Pierced::Unclear);
        }
        let place = |s: f64| {
            let point = at(s);
            PiercedAt { point, uv: round.parameters(point), through: true }
        };
        Some(Pierced::Points([first, second].into_iter().filter(|s| inside(*s)).map(place).collect()))
    }
}

/// Which part of a brep a point lies on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BrepPlace {
    /// Inside a face, at a pair of its surface's parameters.
    Face {
        /// The face.
        face: usize,
        /// The parameters.
        uv: [f64; 2],
    },
    /// On an edge, at a parameter of the edge.
    Edge {
        /// The edge.
        edge: usize,
        /// The parameter.
        parameter: f64,
    },
}

/// The point of a brep nearest to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BrepPoint {
    /// Where on the brep it lies.
    pub place: BrepPlace,
    /// The point.
    pub point: Point3,
    /// Its distance.
    pub distance: f64,
    /// The normal of the face there, as the face is turned; at an edge that of a face beside it. `None` where the
    /// surface has none.
    pub normal: Option<Vector3>,
}

/// A brep prepared for many questions about nearest points and about what lies inside.
#[derive(Debug)]
pub struct ClosestOnBrep {
    brep: Shared<Brep>,
    sheets: Vec<Sheet>,
    edges: Vec<(usize, Curve, BoundingBox)>,
    solid: bool,
    bounds: BoundingBox,
}

impl ClosestOnBrep {
    /// Prepares a brep.
    ///
    /// # Errors
    /// The brep has no faces, or one whose surface has no NURBS form.
    pub fn new(brep: Shared<Brep>) -> Result<Self> {
        let mut sheets = Vec::new();
        for (face, own) in brep.faces().iter().enumerate().filter(|(_, f)| !f.deleted) {
            let Some(surface) = brep.face_surface(face) else { continue };
            let loops = brep.face_loops(face)?;
            sheets.push(Sheet {
                face,
                closest: OnceLock::new(),
                round: OnceLock::new(),
                outlines: loops.iter().map(|curve| Outline::new(curve, &Plane::XY)).collect(),
                loops,
                bounds: surface.bounding_box()?,
                reversed: own.reversed,
            });
        }
        let mut edges = Vec::new();
        for edge in 0..brep.edges().len() {
            if let Some(curve) = brep.edge_as_curve(edge)? {
                let bounds = curve.bounding_box();
                edges.push((edge, curve, bounds));
            }
        }
        let all = sheets.iter().map(|s| s.bounds).reduce(|a, b| a.union(&b));
        let bounds = all.ok_or(Error::degenerate("brep", "it has no faces"))?;
        let solid = brep.is_solid();
        Ok(Self { brep, sheets, edges, solid, bounds })
    }

    /// The brep.
    pub fn brep(&self) -> &Brep {
        &self.brep
    }

    /// The faces.
    pub(super) fn sheets(&self) -> &[Sheet] {
        &self.sheets
    }

    /// The place of a face among the faces that are prepared, and the box of its surface.
    pub(crate) fn sheet(&self, face: usize) -> Option<(usize, BoundingBox)> {
        let place = self.sheets.binary_search_by(|s| s.face.cmp(&face)).ok()?;
        Some((place, self.sheets.get(place)?.bounds))
    }

    /// Whether parameters lie on a face, by its place among those prepared; at its border either.
    pub(crate) fn sheet_covers(&self, place: usize, [u, v]: [f64; 2]) -> bool {
        self.sheets.get(place).is_some_and(|sheet| sheet.covers(u, v))
    }

    /// The edges that have curves, with their places and boxes.
    pub(super) fn edge_curves(&self) -> &[(usize, Curve, BoundingBox)] {
        &self.edges
    }

    /// Whether the brep is closed, so that points can lie inside.
    pub fn is_solid(&self) -> bool {
        self.solid
    }

    /// The nearest point of the brep, trims respected; edges of zero distance count before faces.
    ///
    /// # Errors
    /// The point is not finite, or so far away that the square of the distance overflows.
    pub fn nearest(&self, q: Point3) -> Result<BrepPoint> {
        let mut best: Option<BrepPoint> = None;
        let reach = |best: &Option<BrepPoint>| best.map_or(f64::INFINITY, |b| b.distance);
        let mut order: Vec<usize> = (0..self.edges.len()).collect();
        order.sort_by(|a, b| self.edges[*a].2.distance_to(q).total_cmp(&self.edges[*b].2.distance_to(q)));
        for k in order {
            let (edge, curve, bounds) = &self.edges[k];
            if bounds.distance_to(q) > reach(&best) {
                break;
            }
            let near = ClosestOnCurve::new(curve).nearest(q)?;
            if near.distance < reach(&best) {
                let place = BrepPlace::Edge { edge: *edge, parameter: near.parameter };
                best = Some(BrepPoint { place, point: near.point, distance: near.distance, normal: None });
            }
        }
        let mut order: Vec<&Sheet> = self.sheets.iter().collect();
        order.sort_by(|a, b| a.bounds.distance_to(q).total_cmp(&b.bounds.distance_to(q)));
        for sheet in order {
            if sheet.bounds.distance_to(q) >= reach(&best) {
                break;
            }
            if let Some(found) = self.nearest_on(sheet, q, reach(&best))? {
                best = Some(found);
            }
        }
        let mut best = best.ok_or(Error::degenerate("brep", "it has no faces"))?;
        if let BrepPlace::Edge { edge, .. } = best.place {
            best.normal = self.normal_beside(edge, best.point)?;
        }
        Ok(best)
    }

    /// The nearest point inside a face, when it is nearer than a limit.
    fn nearest_on(&self, sheet: &Sheet, q: Point3, limit: f64) -> Result<Option<BrepPoint>> {
        let found = |u: f64, v: f64, point: Point3, distance: f64| {
            let normal = self.brep.face_surface(sheet.face).and_then(|s| s.normal_at(u, v));
            let normal = normal.map(|n| if sheet.reversed { -n } else { n });
            BrepPoint { place: BrepPlace::Face { face: sheet.face, uv: [u, v] }, point, distance, normal }
        };
        let Some(first) = sheet.closest(&self.brep)?.nearest_within(q, limit)? else { return Ok(None) };
        if !(first.distance < limit) {
            return Ok(None);
        }
        if sheet.covers(first.u, first.v) {
            return Ok(Some(found(first.u, first.v, first.point, first.distance)));
        }
        // What is nearest was cut away: other feet may not be.
        let others = sheet.closest(&self.brep)?.local_closest_points(q)?;
        let kept = others.points.iter().find(|p| p.distance < limit && sheet.covers(p.u, p.v));
        Ok(kept.map(|p| found(p.u, p.v, p.point, p.distance)))
    }

    fn normal_beside(&self, edge: usize, point: Point3) -> Result<Option<Vector3>> {
        let trims = self.brep.edges().get(edge).map_or(&[] as &[usize], |e| &e.trims);
        let Some(face) = trims.first().and_then(|t| self.brep.face_of(*t)) else { return Ok(None) };
        let Some(sheet) = self.sheets.iter().find(|s| s.face == face) else { return Ok(None) };
        let near = sheet.closest(&self.brep)?.nearest(point)?;
        let normal = self.brep.face_surface(face).and_then(|s| s.normal_at(near.u, near.v));
        Ok(normal.map(|n| if sheet.reversed { -n } else { n }))
    }

    /// Whether a point lies inside a solid, outside, or within the tolerance of its faces.
    ///
    /// By the parity of crossings with a ray that stays clear of edges and of tangency; of several rays the first such
    /// one decides. Where faces end beside their common edge, a ray keeps away from it by the edge's tolerance, as it may
    /// slip out between them; when no ray can, most of the rays decide.
    ///
    /// # Errors
    /// The brep is not closed, the point not finite, or every ray tried comes too near to an edge.
    pub fn contains(&self, p: Point3, tolerance: f64) -> Result<Containment> {
        if !self.solid {
            return Err(Error::degenerate("brep", "it is not closed, and has no inside"));
        }
        if !p.is_finite() {
            return Err(Error::NotFinite("point to test"));
        }
        if self.bounds.distance_to(p) > tolerance {
            return Ok(Containment::Outside);
        }
        if self.is_near(p, tolerance)? {
            return Ok(Containment::On);
        }
        let size = self.bounds.diagonal().length();
        // For outside and for inside.
        let mut votes = [0_usize; 2];
        for direction in RAYS {
            let way = Vector3::new(direction[0], direction[1], direction[2]);
            let Some(way) = way.unitized().map(|way| way * (2.0 * size)) else { continue };
            if let (count, true) = self.crossings(p, way, AWAY_FROM_EDGES * size)? {
                if !self.passes_gap(p, way, AWAY_FROM_EDGES * size)? {
                    return Ok(side(count));
                }
                votes[count % 2] += 1;
            }
        }
        if votes[0] != votes[1] {
            return Ok(side(usize::from(votes[1] > votes[0])));
        }
        Err(Error::degenerate("point to test", "every ray from it comes too near to an edge"))
    }

    /// Whether a point is no farther from the boundary than a distance: only edges and faces that may be as near are asked.
    fn is_near(&self, p: Point3, reach: f64) -> Result<bool> {
        if !(reach > 0.0) {
            return Ok(self.nearest(p)?.distance <= reach);
        }
        // What is just as far away counts.
        let beyond = reach * (1.0 + thresholds::FEW_ROUNDINGS);
        for (_, curve, bounds) in &self.edges {
            if bounds.distance_to(p) <= beyond && curve.closest_point_within(p, beyond)?.is_some() {
                return Ok(true);
            }
        }
        for sheet in self.sheets.iter().filter(|s| s.bounds.distance_to(p) <= beyond) {
            let Some(surface) = self.brep.face_surface(sheet.face) else { continue };
            if sheet.is_aside(surface, p, beyond) {
                continue;
            }
            if self.nearest_on(sheet, p, beyond)?.is_some() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// How often a segment from a point crosses the faces, and whether it stays clear of edges and tangency.
    fn crossings(&self, p: Point3, way: Vector3, clear: f64) -> Result<(usize, bool)> {
        let mut count = 0;
        for sheet in &self.sheets {
            if !meets(&sheet.bounds, p, way) {
                continue;
            }
            let Some(surface) = self.brep.face_surface(sheet.face) else { continue };
            let found = match sheet.pierced(surface, p, way) {
                Some(found) => found,
                None => Pierced::general(surface, p, way)?,
            };
            let Pierced::Points(points) = found else { return Ok((count, false)) };
            for place in points {
                if self.near_loop(sheet, place.point, clear)? {
                    return Ok((count, false));
                }
                let covered = place.uv.is_some_and(|[u, v]| sheet.covers(u, v));
                if covered && !place.through {
                    return Ok((count, false));
                }
                count += usize::from(covered);
            }
        }
        Ok((count, true))
    }

    /// Whether a segment comes within the tolerance of an edge that is not tight: between what the faces end with.
    fn passes_gap(&self, p: Point3, way: Vector3, tight: f64) -> Result<bool> {
        let ray: Curve = Line::new(p, p + way).into();
        for (edge, curve, bounds) in &self.edges {
            let gap = self.brep.edges().get(*edge).map_or(0.0, |e| e.tolerance);
            if gap > tight
                && gap.is_finite()
                && meets(&bounds.inflated(gap), p, way)
                && intersect::nearest_on_curves(&ray, curve, ROUGH_LENGTH * gap)?.distance <= gap
            {
                return Ok(true);
            }
        }
        Ok(false)
    }

    pub(super) fn near_loop(&self, sheet: &Sheet, p: Point3, clear: f64) -> Result<bool> {
        for trim in self.brep.trims_of(sheet.face) {
            let Some(edge) = self.brep.trims().get(trim).and_then(|t| t.edge) else { continue };
            let Ok(place) = self.edges.binary_search_by_key(&edge, |e| e.0) else { continue };
            let Some((_, curve, bounds)) = self.edges.get(place) else { continue };
            if bounds.distance_to(p) <= clear && curve.closest_point_within(p, clear)?.is_some() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether parameters lie on a face rather than on what was cut away.
    pub fn covers(&self, face: usize, u: f64, v: f64, tolerance: f64) -> Result<Containment> {
        let sheet = self
            .sheets
            .iter()
            .find(|s| s.face == face)
            .ok_or(Error::degenerate("brep", "there is no such face"))?;
        let uv = Point3::new(u, v, 0.0);
        for curve in &sheet.loops {
            if curve.closest_point_within(uv, tolerance.max(f64::MIN_POSITIVE))?.is_some() {
                return Ok(Containment::On);
            }
        }
        Ok(if sheet.covers(u, v) { Containment::Inside } else { Containment::Outside })
    }
}

/// Directions of rays, none of them along an axis or a likely edge.
const RAYS: [[f64; 3]; 10] = [
    [0.577_1, 0.211_3, 0.788_9],
    [-0.313_7, 0.889_1, 0.333_3],
    [0.119_7, -0.683_9, 0.719_7],
    [-0.871_3, -0.213_1, 0.441_9],
    [0.739_1, 0.607_3, -0.291_1],
    [-0.409_9, 0.387_1, -0.826_1],
    [0.233_9, -0.911_3, -0.338_9],
    [-0.617_7, -0.573_9, -0.537_1],
    [0.917_3, -0.163_1, 0.363_7],
    [-0.071_9, 0.997_1, -0.023_3],
];

fn side(crossings: usize) -> Containment {
    if crossings % 2 == 1 { Containment::Inside } else { Containment::Outside }
}

/// Whether a segment comes into a box.
fn meets(bounds: &BoundingBox, p: Point3, way: Vector3) -> bool {
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    let slabs = [
        (p.x, way.x, bounds.min.x, bounds.max.x),
        (p.y, way.y, bounds.min.y, bounds.max.y),
        (p.z, way.z, bounds.min.z, bounds.max.z),
    ];
    for (at, step, from, to) in slabs {
        if step == 0.0 {
            if at < from || at > to {
                return false;
            }
            continue;
        }
        let (a, b) = ((from - at) / step, (to - at) / step);
        low = low.max(a.min(b) - thresholds::SAME_PARAMETER);
        high = high.min(a.max(b) + thresholds::SAME_PARAMETER);
    }
    low <= high
}

impl Brep {
    /// The point of the brep nearest to another, trims respected; for many questions see [`ClosestOnBrep`].
    ///
    /// # Errors
    /// The brep has no faces, or the point is not finite.
    pub fn closest_point(&self, q: Point3) -> Result<BrepPoint> {
        ClosestOnBrep::new(Shared::new(self.clone()))?.nearest(q)
    }

    /// Whether a point lies inside a solid, outside, or within the tolerance of its faces; for many questions see
    /// [`ClosestOnBrep::contains`].
    ///
    /// # Errors
    /// As [`ClosestOnBrep::contains`].
    pub fn contains(&self, p: Point3, tolerance: f64) -> Result<Containment> {
        ClosestOnBrep::new(Shared::new(self.clone()))?.contains(p, tolerance)
    }
}
