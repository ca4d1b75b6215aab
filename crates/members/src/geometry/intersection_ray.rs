//! Rays and what they meet, and points moved along a direction.

use std::sync::Arc;

use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::{Brep, Curve, Line, Mesh, MeshTree, Point3, Vector3};

use super::answer::Outcome;
use super::argument::{Count, Some1, Waiting, Within};
use super::table::Endpoints;
use crate::Fault;
use crate::wire::{GeometryBase, Ray};

pub(super) fn enter(table: &mut Endpoints) {
    table.add("intersect/intersection/meshray-mesh_ray3d", |m: Mesh, ray: Ray| Ok(mesh_ray(&m, ray)?.0));
    table.add("intersect/intersection/meshray-mesh_ray3d_intarray", |m: Mesh, ray: Ray| mesh_ray(&m, ray));
    table.add(
        "intersect/intersection/rayshoot-ray3d_geometrybasearray_int",
        |ray: Ray, g: Some1<GeometryBase>, n: Reflections, w: Waiting| shoot(ray, &g.0, n, &w),
    );
    table.add(
        "intersect/intersection/rayshoot-geometrybasearray_ray3d_int",
        |g: Some1<GeometryBase>, ray: Ray, n: Reflections, w: Waiting| shoot(ray, &g.0, n, &w),
    );
    table.add(
        "intersect/intersection/projectpointstomeshes-mesharray_point3darray_vector3d_double",
        |m: Vec<Mesh>, p: Vec<Point3>, d: Vector3, t: Within, w: Waiting| {
            Ok(project(&targets_of_meshes(&m), &p, d, t, &w)?.0)
        },
    );
    table.add(
        "intersect/intersection/projectpointstomeshesex-mesharray_point3darray_vector3d_double_intarray",
        |m: Vec<Mesh>, p: Vec<Point3>, d: Vector3, t: Within, w: Waiting| {
            project(&targets_of_meshes(&m), &p, d, t, &w)
        },
    );
    table.add(
        "intersect/intersection/projectpointstobreps-breparray_point3darray_vector3d_double",
        |b: Vec<Brep>, p: Vec<Point3>, d: Vector3, t: Within, w: Waiting| {
            Ok(project(&targets_of_breps(b)?, &p, d, t, &w)?.0)
        },
    );
    table.add(
        "intersect/intersection/projectpointstobrepsex-breparray_point3darray_vector3d_double_intarray",
        |b: Vec<Brep>, p: Vec<Point3>, d: Vector3, t: Within, w: Waiting| {
            project(&targets_of_breps(b)?, &p, d, t, &w)
        },
    );
}

type Reflections = Count<1, 1000>;

/// The parameter along the ray of the first point, −1 when there is none, and the face.
fn mesh_ray(mesh: &Mesh, ray: Ray) -> Outcome<(f64, Vec<usize>)> {
    let hits = MeshTree::new(mesh).line_hits(ray.position, ray.direction, [0.0, FARTHEST])?;
    Ok(hits.first().map_or((-1.0, Vec::new()), |hit| (hit.t, vec![hit.face])))
}

/// Something that lines meet.
enum Target<'a> {
    Mesh(MeshTree, &'a Mesh),
    Brep(ClosestOnBrep),
}

/// Where a line meets a target.
struct Hit {
    /// The place on the line, in lengths of its direction.
    t: f64,
    point: Point3,
    normal: Option<Vector3>,
}

/// Where lines end, in lengths of their direction.
const FARTHEST: f64 = 1e100;
/// How near to a surface a ray must come to meet it.
const NEAR: f64 = 1e-9;

impl Target<'_> {
    /// All places of the line through a point along a unit direction, in order.
    fn hits(&self, start: Point3, direction: Vector3) -> Outcome<Vec<Hit>> {
        match self {
            Self::Mesh(tree, mesh) => {
                let normals = mesh.face_normals();
                let found = tree.line_hits(start, direction, [-FARTHEST, FARTHEST])?;
                let hit = |h: katydid_geometry::MeshHit| Hit {
                    t: h.t,
                    point: h.point,
                    normal: normals.get(h.face).copied(),
                };
                Ok(found.into_iter().map(hit).collect())
            }
            Self::Brep(search) => {
                let Some(around) = search.brep().bounds_of_faces() else { return Ok(Vec::new()) };
                let reach = around.corners().map(|p| p.distance_to(start)).into_iter().fold(1.0, f64::max);
                let line = Line::new(start - direction * reach, start + direction * reach);
                let found = search.curve_crossings(&Curve::from(line), NEAR * reach.max(1.0))?;
                let hit = |c: katydid_geometry::brep::BrepCrossing| Hit {
                    t: (c.point - start).dot(direction),
                    point: c.point,
                    normal: c.normal,
                };
                Ok(found.crossings.into_iter().map(hit).collect())
            }
        }
    }
}

fn targets_of_meshes(meshes: &[Mesh]) -> Vec<Target<'_>> {
    meshes.iter().map(|mesh| Target::Mesh(MeshTree::new(mesh), mesh)).collect()
}

fn targets_of_breps(breps: Vec<Brep>) -> Outcome<Vec<Target<'static>>> {
    breps.into_iter().map(|brep| Ok(Target::Brep(ClosestOnBrep::new(Arc::new(brep))?))).collect()
}

/// The points at which a ray is thrown back, by the law of reflection, up to so many.
fn shoot(
    ray: Ray,
    geometry: &[GeometryBase],
    Count(most): Reflections,
    waiting: &Waiting,
) -> Outcome<Vec<Point3>> {
    let mut targets = Vec::with_capacity(geometry.len());
    for (i, part) in geometry.iter().enumerate() {
        waiting.check()?;
        targets.push(match part {
            GeometryBase::Mesh(mesh) => Target::Mesh(MeshTree::new(mesh), mesh),
            GeometryBase::Brep(brep) => Target::Brep(ClosestOnBrep::new(Arc::new(brep.clone()))?),
            GeometryBase::Surface(surface) => {
                Target::Brep(ClosestOnBrep::new(Arc::new(Brep::from_surface(surface.clone())?))?)
            }
            _ => return Err(Fault::bad_request(format!("geometry {i} is no surface, brep or mesh"))),
        });
    }
    let mut from = ray.position;
    let mut along = ray.direction.unitized().ok_or_else(|| Fault::bad_request("ray has no direction"))?;
    let mut points = Vec::new();
    while points.len() < most {
        waiting.check()?;
        // What the ray has just left does not count.
        let least = 1e-7 * from.to_vector().length().max(1.0);
        let mut first: Option<Hit> = None;
        for target in &targets {
            for hit in target.hits(from, along)? {
                if hit.t > least && first.as_ref().is_none_or(|known| hit.t < known.t) {
                    first = Some(hit);
                }
            }
        }
        let Some(hit) = first else { break };
        points.push(hit.point);
        let Some(normal) = hit.normal.and_then(|normal| normal.unitized()) else { break };
        along = along - normal * (2.0 * along.dot(normal));
        from = hit.point;
    }
    Ok(points)
}

/// All points of targets that lie on lines through points along a direction, and for each the place of its point.
fn project(
    targets: &[Target<'_>],
    points: &[Point3],
    direction: Vector3,
    tolerance: Within,
    waiting: &Waiting,
) -> Outcome<(Vec<Point3>, Vec<usize>)> {
    let along = direction.unitized().ok_or_else(|| Fault::bad_request("direction has no length"))?;
    let (mut out, mut places) = (Vec::new(), Vec::new());
    for (place, point) in points.iter().enumerate() {
        waiting.check()?;
        let mut hits = Vec::new();
        for target in targets {
            hits.extend(target.hits(*point, along)?);
        }
        hits.sort_by(|a, b| a.t.total_cmp(&b.t));
        hits.dedup_by(|b, a| b.point.distance_to(a.point) <= tolerance.0);
        for hit in hits {
            out.push(hit.point);
            places.push(place);
        }
    }
    Ok((out, places))
}
