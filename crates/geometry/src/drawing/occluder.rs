//! What stands in the line of sight.

use crate::drawing::thresholds::{FOOT_FOUND, ON_SHEET};
use std::ops::ControlFlow;

use katydid_elementary::Elementary;

use super::feature::Feature;
use super::sheet::Sheet;
use super::{DrawingOptions, Drawn, View};
use crate::box_tree::{Bounds, BoxTree};
use crate::brep::ClosestOnBrep;
use crate::silhouette::{SilhouetteKind, Viewpoint, each};
use crate::{
    Brep, Containment, Mesh, MeshFace, MeshSettings, MeshTree, Plane, Point2, Point3, Quadrant, Result,
    Surface, Vector3,
};

/// The surfaces of all objects: those with closed forms, and triangles from which places on the others are found.
#[derive(Debug)]
pub(super) struct Occluders {
    pub(super) sheets: Vec<Sheet>,
    pub(super) sheet_tree: BoxTree,
    pub(super) tree: MeshTree,
    pub(super) searches: Vec<Option<ClosestOnBrep>>,
    pub(super) sources: Vec<Source>,
    clipping: Vec<Plane>,
    view: View,
    pub(super) tolerance: f64,
    /// How far triangles may be from their surfaces.
    pub(super) coarse: f64,
    /// The diagonal of the box of everything.
    pub(super) size: f64,
    center: Point3,
}

/// Where a triangle comes from.
#[derive(Debug, Clone, Copy)]
pub(super) enum Source {
    /// It is exact.
    Flat { object: usize },
    /// A face of a Brep, with the parameters of the middle.
    Face { object: usize, face: usize, at: Point2 },
}

/// What a line of sight meets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sight {
    /// Nothing.
    Free,
    /// Nothing but what is so near to its start that it does not count.
    Close,
    /// Something that hides its start.
    Hidden,
}

/// The surfaces of a Brep.
#[derive(Debug, Default)]
struct Part {
    sheets: Vec<Sheet>,
    vertices: Vec<Point3>,
    faces: Vec<MeshFace>,
    sources: Vec<Source>,
    coarse: f64,
}

impl Part {
    fn new(
        brep: &Brep,
        search: &ClosestOnBrep,
        object: usize,
        tolerance: f64,
        go_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self> {
        let mut out = Self::default();
        let mut others = Vec::new();
        for (face, _) in brep.faces().iter().enumerate().filter(|(_, own)| !own.deleted) {
            match Sheet::new(search, object, face) {
                Some(sheet) => out.sheets.push(sheet),
                None => others.push(face),
            }
        }
        if others.is_empty() {
            return Ok(out);
        }
        let size = brep.bounds_of_faces().map_or(0.0, |b| b.diagonal().length());
        out.coarse = tolerance.max(COARSE * size);
        let mesh = brep.mesh_unless(&MeshSettings::within(out.coarse), &|| !go_on())?;
        for own in mesh.faces().iter().filter(|own| others.contains(&own.face)) {
            let base = out.vertices.len() as u32;
            let at = |p: &u32| mesh.points().get(*p as usize).copied().unwrap_or(Point3::ORIGIN);
            out.vertices.extend(own.places.iter().map(at));
            let flat = matches!(brep.face_surface(own.face), Some(Surface::Plane(_)) | None);
            for face in &own.faces {
                out.faces.push(face.map(|v| v.saturating_add(base)));
                out.sources.push(if flat {
                    Source::Flat { object }
                } else {
                    Source::Face { object, face: own.face, at: middle(face, &own.parameters) }
                });
            }
        }
        Ok(out)
    }
}

/// Triangles are within this part of their object's size of its surface.
const COARSE: f64 = 2e-3;
/// Steps of Newton's method.
const STEPS: usize = 12;
/// Lines of sight start this many tolerances to the side.
const SIDE: f64 = 0.1;
/// What is nearer before a place than this many tolerances does not hide it.
const BEFORE: f64 = 5.0;

impl Occluders {
    pub(super) fn new(
        objects: &[Drawn],
        searches: Vec<Option<ClosestOnBrep>>,
        view: &View,
        options: &DrawingOptions,
        go_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self> {
        let tolerance = options.tolerance.absolute;
        let index: Vec<usize> = (0..objects.len()).collect();
        let parts = each(&index, |&object| match (objects.get(object), searches.get(object)) {
            (Some(Drawn::Brep(brep)), Some(Some(search))) => {
                Part::new(brep, search, object, tolerance, go_on).map(Some)
            }
            _ => Ok(None),
        })?;
        let mut vertices: Vec<Point3> = Vec::new();
        let mut faces: Vec<MeshFace> = Vec::new();
        let mut sources = Vec::new();
        let mut sheets: Vec<Sheet> = Vec::new();
        let mut coarse = tolerance;
        for (object, (drawn, part)) in objects.iter().zip(parts).enumerate() {
            let base = vertices.len() as u32;
            if let Drawn::Mesh(mesh) = drawn {
                vertices.extend(mesh.vertices());
                faces.extend(mesh.faces().iter().map(|face| face.map(|v| v.saturating_add(base))));
                sources.resize(faces.len(), Source::Flat { object });
            }
            if let Some(part) = part {
                vertices.extend(part.vertices);
                faces.extend(part.faces.iter().map(|face| face.map(|v| v.saturating_add(base))));
                sources.extend(part.sources);
                sheets.extend(part.sheets);
                coarse = coarse.max(part.coarse);
            }
        }
        let boxes: Vec<Bounds> = sheets.iter().map(|s| s.bounds).collect();
        let corners = boxes.iter().flatten().map(|p| Point3::new(p[0], p[1], p[2]));
        let bounds = crate::BoundingBox::from_points(vertices.iter().copied().chain(corners));
        let size = bounds.map_or(0.0, |b| b.diagonal().length());
        let center = bounds.map_or(Point3::ORIGIN, |b| b.center());
        let mesh = Mesh::new(vertices, faces)?;
        let tree = MeshTree::new(&mesh);
        let sheet_tree = BoxTree::by_place(&boxes);
        let clipping = options.clipping.iter().copied().chain(view.clipping()).collect();
        let view = *view;
        Ok(Self {
            sheets,
            sheet_tree,
            tree,
            searches,
            sources,
            clipping,
            view,
            tolerance,
            coarse,
            size,
            center,
        })
    }

    /// Whether a place of a curve is seen: whether the line of sight from it is free, or, where it touches the surface that
    /// the curve is the outline of, one beside it.
    pub(super) fn sees(&self, feature: &Feature, t: f64) -> Result<Sight> {
        let p = feature.point(t);
        let sight = self.sight(p, feature)?;
        if sight != Sight::Hidden || !touches(feature) {
            return Ok(sight);
        }
        let (_, d) = feature.jet(t);
        let length = d[0].hypotenuse(d[1]);
        if !(length > 0.0) {
            return Ok(sight);
        }
        let across = self.view.sideways(-d[1] / length, d[0] / length) * (SIDE * self.tolerance);
        for beside in [p + across, p - across] {
            let sight = self.sight(beside, feature)?;
            if sight != Sight::Hidden {
                return Ok(sight);
            }
        }
        Ok(Sight::Hidden)
    }

    /// What lies between a point of a curve, or one beside it, and the viewer.
    fn sight(&self, p: Point3, feature: &Feature) -> Result<Sight> {
        let viewpoint = self.view.viewpoint();
        let towards = viewpoint.towards(p);
        let length = towards.length();
        let Some(d) = towards.unitized() else { return Ok(Sight::Free) };
        let far = match viewpoint {
            Viewpoint::Perspective(_) => length,
            // Past everything there is, from wherever the point is.
            Viewpoint::Parallel(_) => 2.0 * (self.size + p.distance_to(self.center)),
        };
        let least = BEFORE * self.tolerance;
        let mut sight = Sight::Free;
        self.sheet_tree.visit_where(
            |bounds| passes(bounds, self.tolerance, p, d, [-least, far]),
            |i| {
                let Some(sheet) = self.sheets.get(i) else { return ControlFlow::Continue(()) };
                let Some(Some(search)) = self.searches.get(sheet.object) else {
                    return ControlFlow::Continue(());
                };
                for s in sheet
                    .line(p, d, sheet.carries(feature), feature.kind == SilhouetteKind::Tangent)
                    .into_iter()
                    .flatten()
                {
                    let at = p + d * s;
                    if !(-least <= s && s <= far && sheet.covers(search, at) && self.is_there(at)) {
                        continue;
                    }
                    if s > least {
                        sight = Sight::Hidden;
                        return ControlFlow::Break(());
                    }
                    sight = Sight::Close;
                }
                ControlFlow::Continue(())
            },
        );
        if sight == Sight::Hidden || self.sources.is_empty() {
            return Ok(sight);
        }
        let from = -least - 2.0 * self.coarse;
        for hit in self.tree.line_hits(p, d, [from, far])? {
            let Some((s, _)) = self.exact(hit.face, p, d, hit.t) else { continue };
            if !(-least <= s && s <= far && self.is_there(p + d * s)) {
                continue;
            }
            if s > least {
                return Ok(Sight::Hidden);
            }
            if !self.carries(hit.face, feature) {
                sight = Sight::Close;
            }
        }
        // Where a surface turns away its triangles may lie within it, and a line of sight pass beside them.
        let mut trouble = None;
        let from = least - 2.0 * self.coarse;
        self.tree.boxes().visit_where(
            |bounds| passes(bounds, self.coarse, p, d, [from, far]),
            |i| {
                match self.passes_beside(i, p, d, [least, far]) {
                    Ok(false) => return ControlFlow::Continue(()),
                    Ok(true) => sight = Sight::Hidden,
                    Err(why) => trouble = Some(why),
                }
                ControlFlow::Break(())
            },
        );
        trouble.map_or(Ok(sight), Err)
    }

    /// Whether a curve lies on the face that a triangle is of; of a mesh, whether it is of that mesh.
    fn carries(&self, triangle: usize, feature: &Feature) -> bool {
        match self.sources.get(triangle) {
            Some(Source::Flat { object }) => *object == feature.object,
            Some(Source::Face { object, face, .. }) => {
                *object == feature.object && feature.faces.contains(face)
            }
            None => false,
        }
    }

    /// Whether no clipping plane has cut a point away.
    fn is_there(&self, p: Point3) -> bool {
        self.clipping.iter().all(|plane| plane.signed_distance(p) > 0.0)
    }

    /// Whether a line of sight meets the surface of a triangle next to it, within the trims.
    fn passes_beside(&self, i: usize, p: Point3, d: Vector3, [least, far]: [f64; 2]) -> Result<bool> {
        let Some((corners, triangle)) = self.tree.triangle(i) else { return Ok(false) };
        let Some(&Source::Face { object, face, .. }) = self.sources.get(triangle) else { return Ok(false) };
        let middle = corners.iter().map(|c| (*c - p).dot(d)).sum::<f64>() / 3.0;
        let Some((s, [u, v])) = self.exact(triangle, p, d, middle) else { return Ok(false) };
        let at = p + d * s;
        let near = crate::box_tree::bounds_of(corners.map(<[f64; 3]>::from));
        let beside =
            crate::box_tree::squared_distance_to(&near, &at.into()) <= 4.0 * self.coarse * self.coarse;
        if !(least < s && s <= far && beside && self.is_there(at)) {
            return Ok(false);
        }
        let Some(Some(search)) = self.searches.get(object) else { return Ok(false) };
        Ok(search.covers(face, u, v, ON_SHEET * self.tolerance)? == Containment::Inside)
    }

    /// How far along a line of sight the surface itself is and its parameters there, from where its mesh is; `None` where
    /// the line passes the surface by.
    fn exact(&self, triangle: usize, p: Point3, d: Vector3, t: f64) -> Option<(f64, [f64; 2])> {
        let Source::Face { object, face, at } = *self.sources.get(triangle)? else {
            return Some((t, [0.0; 2]));
        };
        let surface = self.searches.get(object)?.as_ref()?.brep().face_surface(face)?;
        let domains = crate::Direction::BOTH.map(|d| surface.domain(d));
        let (mut u, mut v, mut s) = (at.x, at.y, t);
        for _ in 0..STEPS {
            let jet = surface.derivatives(u, v, 1, Quadrant::NorthEast);
            let (su, sv) = (jet.get(1, 0), jet.get(0, 1));
            let miss = (p + d * s) - jet.point();
            if miss.length() <= FOOT_FOUND * self.tolerance {
                return Some((s, [u, v]));
            }
            // miss = a su + b sv − c d, by Cramer's rule.
            let normal = su.cross(sv);
            let det = normal.dot(d);
            if det == 0.0 {
                return None;
            }
            let c = -normal.dot(miss) / det;
            let rest = miss + d * c;
            let square = normal.length_squared();
            let a = rest.cross(sv).dot(normal) / square;
            let b = su.cross(rest).dot(normal) / square;
            if !(a.is_finite() && b.is_finite() && c.is_finite()) {
                return None;
            }
            u = (u + a).clamp(domains[0].start, domains[0].end);
            v = (v + b).clamp(domains[1].start, domains[1].end);
            s += c;
            if (s - t).abs() > self.size {
                return None;
            }
        }
        None
    }
}

/// Whether the line of sight touches a surface that a curve lies on.
fn touches(feature: &Feature) -> bool {
    matches!(feature.kind, SilhouetteKind::Tangent | SilhouetteKind::Projecting)
}

/// Whether a line comes into a box that is wider by a margin.
fn passes(bounds: &Bounds, margin: f64, p: Point3, d: Vector3, [mut low, mut high]: [f64; 2]) -> bool {
    let (p, d): ([f64; 3], [f64; 3]) = (p.into(), [d.x, d.y, d.z]);
    for c in 0..3 {
        let (a, b) = (bounds[0][c] - margin - p[c], bounds[1][c] + margin - p[c]);
        if d[c] == 0.0 {
            if a > 0.0 || b < 0.0 {
                return false;
            }
        } else {
            let (s, t) = (a / d[c], b / d[c]);
            low = low.max(s.min(t));
            high = high.min(s.max(t));
        }
    }
    low <= high
}

/// The mean of the parameters of a face's corners.
fn middle(face: &MeshFace, parameters: &[Point2]) -> Point2 {
    let corners = face.indices();
    let n = corners.len().max(1) as f64;
    let mut out = [0.0; 2];
    for i in corners {
        if let Some(p) = parameters.get(*i as usize) {
            out = [out[0] + p.x / n, out[1] + p.y / n];
        }
    }
    Point2::new(out[0], out[1])
}
