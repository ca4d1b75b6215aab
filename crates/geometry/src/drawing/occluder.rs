//! What stands in the line of sight.

use std::ops::ControlFlow;

use super::feature::Feature;
use super::{DrawingOptions, Drawn, View};
use crate::box_tree::Bounds;
use crate::brep::ClosestOnBrep;
use crate::silhouette::{SilhouetteKind, Viewpoint};
use crate::{
    Containment, Mesh, MeshFace, MeshSettings, MeshTree, Plane, Point2, Point3, Quadrant, Result, Surface,
    Vector3,
};

/// The surfaces of all objects, as triangles from which places on them are found.
#[derive(Debug)]
pub(super) struct Occluders {
    tree: MeshTree,
    searches: Vec<Option<ClosestOnBrep>>,
    sources: Vec<Source>,
    clipping: Vec<Plane>,
    view: View,
    tolerance: f64,
    /// How far triangles may be from their surfaces.
    coarse: f64,
    size: f64,
}

/// Where a triangle comes from.
#[derive(Debug, Clone, Copy)]
enum Source {
    /// It is exact.
    Flat,
    /// A face of a Brep, with the parameters of the middle.
    Face { object: usize, face: usize, at: Point2 },
}

/// Triangles are within this part of their object's size of its surface.
const COARSE: f64 = 5e-4;
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
        let mut vertices: Vec<Point3> = Vec::new();
        let mut faces: Vec<MeshFace> = Vec::new();
        let mut sources = Vec::new();
        let mut coarse = tolerance;
        for (object, drawn) in objects.iter().enumerate() {
            match drawn {
                Drawn::Curve(_) => {}
                Drawn::Mesh(mesh) => {
                    let base = vertices.len() as u32;
                    vertices.extend(mesh.vertices());
                    for face in mesh.faces() {
                        faces.push(face.map(|v| v.saturating_add(base)));
                        sources.push(Source::Flat);
                    }
                }
                Drawn::Brep(brep) => {
                    let size = brep.bounds_of_faces().map_or(0.0, |b| b.diagonal().length());
                    let within = tolerance.max(COARSE * size);
                    coarse = coarse.max(within);
                    let mesh = brep.mesh_unless(&MeshSettings::within(within), &|| !go_on())?;
                    for own in mesh.faces() {
                        let base = vertices.len() as u32;
                        let at = |p: &u32| mesh.points().get(*p as usize).copied().unwrap_or(Point3::ORIGIN);
                        vertices.extend(own.places.iter().map(at));
                        let flat = matches!(brep.face_surface(own.face), Some(Surface::Plane(_)) | None);
                        for face in &own.faces {
                            faces.push(face.map(|v| v.saturating_add(base)));
                            sources.push(if flat {
                                Source::Flat
                            } else {
                                Source::Face { object, face: own.face, at: middle(face, &own.parameters) }
                            });
                        }
                    }
                }
            }
        }
        let bounds = crate::BoundingBox::from_points(vertices.iter().copied());
        let size = bounds.map_or(0.0, |b| b.diagonal().length());
        let mesh = Mesh::new(vertices, faces)?;
        let tree = MeshTree::new(&mesh);
        let clipping = options.clipping.iter().copied().chain(view.clipping()).collect();
        Ok(Self { tree, searches, sources, clipping, view: *view, tolerance, coarse, size })
    }

    /// Whether a place of a curve is seen: whether the line of sight from it is free, or, where it touches the surface that
    /// the curve is the outline of, one beside it.
    pub(super) fn sees(&self, feature: &Feature, t: f64) -> Result<bool> {
        let p = feature.point(t);
        if self.is_free(p)? {
            return Ok(true);
        }
        if !matches!(feature.kind, SilhouetteKind::Tangent | SilhouetteKind::Projecting) {
            return Ok(false);
        }
        let (_, d) = feature.jet(t);
        let length = d[0].hypot(d[1]);
        if !(length > 0.0) {
            return Ok(false);
        }
        let across = self.view.sideways(-d[1] / length, d[0] / length) * (SIDE * self.tolerance);
        Ok(self.is_free(p + across)? || self.is_free(p - across)?)
    }

    /// Whether nothing lies between a point and the viewer.
    fn is_free(&self, p: Point3) -> Result<bool> {
        let viewpoint = self.view.viewpoint();
        let towards = viewpoint.towards(p);
        let length = towards.length();
        let Some(d) = towards.unitized() else { return Ok(true) };
        let far = match viewpoint {
            Viewpoint::Perspective(_) => length,
            // Past everything there is, from wherever the point is.
            Viewpoint::Parallel(_) => {
                let origin = self.view.plane().origin;
                2.0 * (self.size + p.distance_to(origin)) + 4.0 * self.tree.size()
            }
        };
        let least = BEFORE * self.tolerance;
        let from = least - 2.0 * self.coarse;
        for hit in self.tree.line_hits(p, d, [from, far])? {
            let Some((s, _)) = self.exact(hit.face, p, d, hit.t) else { continue };
            if least < s && s <= far && self.is_there(p + d * s) {
                return Ok(false);
            }
        }
        // Where a surface turns away its triangles may lie within it, and a line of sight pass beside them.
        let mut free = true;
        let mut trouble = None;
        self.tree.boxes().visit_where(
            |bounds| passes(bounds, self.coarse, p, d, [from, far]),
            |i| {
                match self.passes_beside(i, p, d, [least, far]) {
                    Ok(false) => return ControlFlow::Continue(()),
                    Ok(true) => free = false,
                    Err(why) => trouble = Some(why),
                }
                ControlFlow::Break(())
            },
        );
        trouble.map_or(Ok(free), Err)
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
        Ok(search.covers(face, u, v, 1e-3 * self.tolerance)? == Containment::Inside)
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
            if miss.length() <= 1e-4 * self.tolerance {
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
