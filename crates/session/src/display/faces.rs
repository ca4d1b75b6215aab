//! Triangles with normals and what else a viewport shades by.

use std::sync::LazyLock;

use katydid_data::Colour;
use katydid_geometry::{Mesh, Plane, Point3, Vector3};
use katydid_scene::Facets;

use super::edges;

/// Neighbouring faces of a mesh without normals of its own that turn by more than this, in radians, meet in a crease.
const CREASE: f64 = std::f64::consts::PI / 6.0;
/// A larger mesh without normals is smooth everywhere: creases would take too long.
const MOST_CREASED: usize = 200_000;
/// Surfaces of more points are shaded by the normals of their facets, and have no curvatures.
const MOST_EXACT: usize = 100_000;

/// The triangles of a dot.
pub(super) const DOT_TRIANGLES: usize = 48;
/// Faces around a dot and from pole to pole: triangles at the poles, quads between.
const DOT: [usize; 2] = [8, 4];

/// Triangles between points.
#[derive(Debug, Clone, Default)]
pub(super) struct Faces {
    pub(super) points: Vec<Point3>,
    /// A unit normal a point.
    pub(super) normals: Vec<[f32; 3]>,
    /// Red, green, blue, alpha of each point, or none.
    pub(super) colours: Vec<[u8; 4]>,
    /// The Gaussian curvature at each point, or none.
    pub(super) gaussian: Vec<f32>,
    /// The mean curvature at each point, or none.
    pub(super) mean: Vec<f32>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// The edges that are drawn.
    pub(super) edges: Vec<[u32; 2]>,
}

impl Faces {
    /// A mesh with its own normals, or with creases where faces meet at an angle.
    pub(super) fn of_mesh(mesh: &Mesh) -> Self {
        if mesh.normals().len() == mesh.vertices().len() {
            return Self::with_normals(mesh, mesh.normals());
        }
        if mesh.faces().len() <= MOST_CREASED {
            let creased = mesh.unwelded(CREASE);
            return Self::with_normals(&creased, &creased.vertex_normals());
        }
        Self::with_normals(mesh, &mesh.vertex_normals())
    }

    fn with_normals(mesh: &Mesh, normals: &[Vector3]) -> Self {
        let mut triangles = Vec::with_capacity(2 * mesh.faces().len());
        triangles.extend(mesh.faces().iter().flat_map(|face| face.triangles()).filter(|[a, b, c]| {
            let at = |i: &u32| mesh.vertices().get(*i as usize);
            // Quads of a pole end in a point.
            at(a) != at(b) && at(b) != at(c) && at(c) != at(a)
        }));
        Self {
            points: mesh.vertices().to_vec(),
            normals: repaired(mesh, normals, &triangles),
            colours: if mesh.colours().len() == mesh.vertices().len() {
                mesh.colours().to_vec()
            } else {
                Vec::new()
            },
            triangles,
            edges: edges::of(mesh),
            ..Self::default()
        }
    }

    /// A surface; with `exact`, shaded by its own normals, and with its curvatures.
    pub(super) fn of_surface(facets: &Facets, exact: bool) -> Self {
        let mesh = &facets.mesh;
        let mut faces = Self { edges: Vec::new(), ..Self::with_normals(mesh, mesh.normals()) };
        if !exact || mesh.vertices().len() > MOST_EXACT || !facets.is_curved() {
            return faces;
        }
        let bends = facets.bends();
        if bends.len() != faces.points.len() {
            return faces;
        }
        for (normal, bend) in faces.normals.iter_mut().zip(&bends) {
            if let Some(own) = bend.normal {
                *normal = single(&own);
            }
        }
        faces.gaussian = filled(bends.iter().map(|bend| bend.curvature.map(|c| c.gaussian)));
        faces.mean = filled(bends.iter().map(|bend| bend.curvature.map(|c| c.mean)));
        faces
    }

    /// A ball of a diameter about a point.
    pub(super) fn of_dot(at: Point3, diameter: f64) -> Self {
        /// A ball of radius 1 about the origin.
        static BALL: LazyLock<Faces> = LazyLock::new(|| {
            let [around, up] = DOT;
            let ball =
                Mesh::sphere(&Plane::XY, 1.0, around, up).map(|mesh| Faces::of_mesh(&mesh.with_normals()));
            Faces { edges: Vec::new(), ..ball.unwrap_or_default() }
        });
        let radius = 0.5 * diameter;
        let mut faces = BALL.clone();
        faces.points.iter_mut().for_each(|p| *p = at + (*p - Point3::ORIGIN) * radius);
        faces
    }

    /// A flat quad with a colour at each corner.
    pub(super) fn of_tile(corners: &[Point3; 4], colours: &[Colour; 4]) -> Self {
        let normal =
            (corners[2] - corners[0]).cross(corners[3] - corners[1]).unitized().unwrap_or(Vector3::Z);
        Self {
            points: corners.to_vec(),
            normals: vec![single(&normal); 4],
            colours: colours.iter().map(|c| [c.r, c.g, c.b, c.a]).collect(),
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            ..Self::default()
        }
    }
}

/// Normals, where a point has none those of a triangle at it: at the pole of a surface each facet has a corner of its
/// own, and some of them lie in no face with area.
fn repaired(mesh: &Mesh, normals: &[Vector3], triangles: &[[u32; 3]]) -> Vec<[f32; 3]> {
    let mut list: Vec<[f32; 3]> = normals.iter().map(single).collect();
    if !normals.contains(&Vector3::ZERO) {
        return list;
    }
    let at = |i: u32| mesh.vertices().get(i as usize).copied();
    for triangle in triangles {
        for i in triangle {
            let is_zero = normals.get(*i as usize) == Some(&Vector3::ZERO);
            let [a, b, c] = triangle.map(at);
            if let (true, Some(a), Some(b), Some(c), Some(slot)) =
                (is_zero, a, b, c, list.get_mut(*i as usize))
                && let Some(normal) = (b - a).cross(c - a).unitized()
            {
                *slot = single(&normal);
            }
        }
    }
    list
}

fn single(v: &Vector3) -> [f32; 3] {
    let parts = [v.x as f32, v.y as f32, v.z as f32];
    if parts.iter().all(|x| x.is_finite()) { parts } else { [0.0, 0.0, 1.0] }
}

/// Where a surface has no curvature, as at a pole, the last before it, which is next to it on most surfaces.
fn filled(values: impl Iterator<Item = Option<f64>> + Clone) -> Vec<f32> {
    let finite = |x: f64| (x as f32).is_finite().then_some(x as f32);
    let mut last = values.clone().flatten().find_map(finite).unwrap_or(0.0);
    values
        .map(|value| {
            last = value.and_then(finite).unwrap_or(last);
            last
        })
        .collect()
}
