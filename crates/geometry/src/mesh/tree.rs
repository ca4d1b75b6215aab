//! A mesh prepared for many questions: rays, inclusion, other meshes.

use crate::mesh::thresholds::HIT_MARGIN;
use std::ops::ControlFlow;

use katydid_elementary::Elementary;

use super::Mesh;
use super::closest::closest_on_triangle;
use crate::box_tree::{Bounds, BoxTree, bounds_of};
use crate::{Containment, Point3, Vector3};

/// Rays that come nearer to an edge than this part of the triangle do not vote on which side a point is.
const NEAR_EDGE: f64 = 1e-9;
/// The most directions in which rays are sent to find the side of one point.
const DIRECTIONS: u32 = 24;

/// The triangles of a mesh in a tree of boxes. Quads are two triangles each, cut from first to third corner.
#[derive(Debug, Clone)]
pub struct MeshTree {
    pub(super) triangles: Vec<[Point3; 3]>,
    /// The face of the mesh that each triangle is of.
    pub(super) faces: Vec<u32>,
    pub(super) tree: BoxTree,
    bounds: Bounds,
}

impl MeshTree {
    /// The tree over all faces of a mesh. O(n log n) for n faces.
    pub fn new(mesh: &Mesh) -> Self {
        let triangles: Vec<[Point3; 3]> = mesh.triangles().collect();
        let per_face = mesh.faces().iter().zip(0_u32..);
        let faces = per_face.flat_map(|(f, i)| f.triangles().map(move |_| i)).collect();
        let boxes: Vec<Bounds> = triangles.iter().map(|t| bounds_of(t.map(<[f64; 3]>::from))).collect();
        let bounds = bounds_of(boxes.iter().flatten().copied());
        Self { tree: BoxTree::by_place(&boxes), triangles, faces, bounds }
    }

    /// The triangle of that number and the face it is of.
    pub(crate) fn triangle(&self, i: usize) -> Option<(&[Point3; 3], usize)> {
        Some((self.triangles.get(i)?, *self.faces.get(i)? as usize))
    }

    /// The largest coordinate, or extent if that is larger: what rounding is measured by.
    pub(crate) fn size(&self) -> f64 {
        let [low, high] = self.bounds;
        let sides = (0..3).map(|c| low[c].abs().max(high[c].abs()).max(high[c] - low[c]));
        sides.filter(|x| x.is_finite()).fold(0.0, f64::max)
    }

    /// The tree of boxes around the triangles.
    pub(crate) fn boxes(&self) -> &BoxTree {
        &self.tree
    }

    /// Whether anything of the mesh stands on the ray from `origin` along `direction`, farther away than `nearest`.
    ///
    /// A ray through an edge or a vertex meets the faces there; one that lies in a face does not meet that face.
    /// False for a direction of zero length.
    pub fn blocks(&self, origin: Point3, direction: Vector3, nearest: f64) -> bool {
        let Some(direction) = direction.unitized() else { return false };
        let mut found = false;
        self.along(origin, direction, |_, hit| {
            if hit.margin >= -HIT_MARGIN && hit.distance > nearest {
                found = true;
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
        found
    }

    /// Visits the triangles in whose boxes a ray comes and in whose planes it does not lie.
    fn along(&self, o: Point3, d: Vector3, mut visit: impl FnMut(usize, Crossing) -> ControlFlow<()>) {
        let (origin, inverse) = (<[f64; 3]>::from(o), [1.0 / d.x, 1.0 / d.y, 1.0 / d.z]);
        self.tree.visit_where(
            |bounds| ray_meets(bounds, &origin, &inverse),
            |i| match self.triangles.get(i).and_then(|t| crossing(t, o, d)) {
                Some(hit) => visit(i, hit),
                None => ControlFlow::Continue(()),
            },
        );
    }

    /// Where a point lies: on the mesh within `tolerance`, inside or outside. The mesh should be closed.
    ///
    /// Rays are sent in up to 24 directions; one that passes an edge or grazes a face does not vote. When two more
    /// votes are on one side than on the other it is taken, so that one ray that errs does not decide. When hardly any
    /// ray can vote, the winding number decides (sum of solid angles: A. van Oosterom, J. Strackee, *The solid angle
    /// of a plane triangle*, IEEE Trans. Biomed. Eng. 30, 1983).
    pub fn containment(&self, q: Point3, tolerance: f64) -> Containment {
        if !q.is_finite() || self.triangles.is_empty() {
            return Containment::Outside;
        }
        if self.is_within(q, tolerance.max(0.0)) {
            return Containment::On;
        }
        let place = <[f64; 3]>::from(q);
        if (0..3).any(|c| !(place[c] >= self.bounds[0][c] && place[c] <= self.bounds[1][c])) {
            return Containment::Outside;
        }
        let mut lead = 0_i32;
        for k in 0..DIRECTIONS {
            match self.vote(q, direction(k)) {
                Some(true) => lead += 1,
                Some(false) => lead -= 1,
                None => {}
            }
            if lead.abs() >= 2 {
                break;
            }
        }
        let inside = if lead.abs() >= 2 { lead > 0 } else { self.winding_number(q).abs() > 0.5 };
        if inside { Containment::Inside } else { Containment::Outside }
    }

    /// Whether a point is within a distance of the mesh.
    fn is_within(&self, q: Point3, distance: f64) -> bool {
        let (place, limit) = (<[f64; 3]>::from(q), distance * distance);
        let mut found = false;
        // The next larger number, so that a distance of 0 finds what is exactly on the mesh.
        self.tree.visit_near(&place, limit.next_up(), |i| {
            let Some(t) = self.triangles.get(i) else { return limit };
            if (closest_on_triangle(*t, q).0 - q).length_squared() <= limit {
                found = true;
                return f64::NEG_INFINITY;
            }
            limit.next_up()
        });
        found
    }

    /// Whether a ray crosses the mesh an odd number of times; `None` when it passes too near to an edge to tell.
    fn vote(&self, q: Point3, d: Vector3) -> Option<bool> {
        let (mut odd, mut clear) = (false, true);
        self.along(q, d, |_, hit| {
            if hit.distance <= 0.0 || hit.margin < -NEAR_EDGE {
                return ControlFlow::Continue(());
            }
            if hit.margin <= NEAR_EDGE || hit.slope <= NEAR_EDGE {
                clear = false;
                return ControlFlow::Break(());
            }
            odd = !odd;
            ControlFlow::Continue(())
        });
        clear.then_some(odd)
    }

    /// How often the mesh goes round a point: 1 inside a closed mesh that looks outwards, 0 outside it.
    pub fn winding_number(&self, q: Point3) -> f64 {
        let solid_angle = |t: &[Point3; 3]| {
            let [a, b, c] = t.map(|p| p - q);
            let (la, lb, lc) = (a.length(), b.length(), c.length());
            let scale = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
            2.0 * a.dot(b.cross(c)).arctangent_of(scale)
        };
        self.triangles.iter().map(solid_angle).sum::<f64>() / (4.0 * std::f64::consts::PI)
    }
}

/// Where a ray crosses the plane of a triangle.
struct Crossing {
    /// How far along the ray, in multiples of its direction.
    distance: f64,
    /// The least barycentric coordinate of the point: below 0 outside the triangle.
    margin: f64,
    /// The cosine between ray and normal.
    slope: f64,
}

/// T. Möller, B. Trumbore, *Fast, minimum storage ray-triangle intersection*, J. Graphics Tools 2, 1997. `None` for a
/// triangle without area and a ray in its plane's direction.
fn crossing(&[a, b, c]: &[Point3; 3], o: Point3, d: Vector3) -> Option<Crossing> {
    let (e, f) = (b - a, c - a);
    let p = d.cross(f);
    let det = e.dot(p);
    let area = e.cross(f).length();
    if !(area > 0.0) || det == 0.0 {
        return None;
    }
    let s = o - a;
    let u = s.dot(p) / det;
    let q = s.cross(e);
    let v = d.dot(q) / det;
    let margin = u.min(v).min(1.0 - u - v);
    let distance = f.dot(q) / det;
    let slope = det.abs() / area;
    (distance.is_finite() && margin.is_finite()).then_some(Crossing { distance, margin, slope })
}

/// Whether a ray comes into a box, its faces included (slabs: A. Williams and others, *An efficient and robust ray-box
/// intersection algorithm*, J. Graphics Tools 10, 2005).
#[inline]
fn ray_meets(bounds: &Bounds, origin: &[f64; 3], inverse: &[f64; 3]) -> bool {
    let (mut enter, mut leave) = (0.0_f64, f64::INFINITY);
    for c in 0..3 {
        if inverse[c].is_infinite() {
            // The ray keeps its coordinate: the products below could be 0 · ∞.
            if origin[c] < bounds[0][c] || origin[c] > bounds[1][c] {
                return false;
            }
            continue;
        }
        let a = (bounds[0][c] - origin[c]) * inverse[c];
        let b = (bounds[1][c] - origin[c]) * inverse[c];
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    // Widened, since a box without thickness must not be missed for a rounding.
    enter <= leave * (1.0 + HIT_MARGIN) + f64::MIN_POSITIVE
}

/// Directions spread over the sphere, none along an axis: points of a spiral with the golden angle.
fn direction(k: u32) -> Vector3 {
    let z = 1.0 - (2.0 * f64::from(k) + 0.613) / f64::from(DIRECTIONS);
    let (sin, cos) = (2.399_963_229_728_653 * f64::from(k) + 0.737).sine_cosine();
    let r = (1.0 - z * z).max(0.0).sqrt();
    Vector3::new(r * cos, r * sin, z)
}

#[cfg(test)]
mod tests {
    use super::{MeshTree, ray_meets};
    use crate::{Box3, Containment, Interval, Mesh, MeshFace, Plane, Point3, Vector3};

    fn cube() -> Mesh {
        let side = Interval::new(-1.0, 1.0);
        Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 4, 4, 4).unwrap()
    }

    #[test]
    fn inside_on_and_outside() {
        let tree = MeshTree::new(&cube());
        // Many of these rays would pass edges: the grid of the points is that of the faces.
        for i in -4..=4 {
            for j in -4..=4 {
                for k in -4..=4 {
                    let at = [i, j, k].map(|x| f64::from(x) * 0.5);
                    let most = at.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                    let want = if most < 1.0 {
                        Containment::Inside
                    } else if most == 1.0 {
                        Containment::On
                    } else {
                        Containment::Outside
                    };
                    assert_eq!(tree.containment(Point3::from(at), 0.0), want, "{at:?}");
                }
            }
        }
        assert_eq!(tree.containment(Point3::new(0.0, 0.0, 1.01), 0.02), Containment::On);
        assert_eq!(tree.containment(Point3::new(f64::NAN, 0.0, 0.0), 0.0), Containment::Outside);
        assert!((tree.winding_number(Point3::new(0.1, 0.2, 0.3)) - 1.0).abs() < 1e-12);
        assert!(tree.winding_number(Point3::new(3.0, 0.2, 0.3)).abs() < 1e-12);
    }

    #[test]
    fn a_hollow_is_outside_and_flipped_faces_do_not_matter() {
        let hollow = Mesh::sphere(&Plane::XY, 0.5, 12, 8).unwrap();
        let tree = MeshTree::new(&Mesh::join(&[cube(), hollow]).unwrap());
        assert_eq!(tree.containment(Point3::ORIGIN, 0.0), Containment::Outside);
        assert_eq!(tree.containment(Point3::new(0.7, 0.7, 0.7), 0.0), Containment::Inside);
        let faces: Vec<MeshFace> = cube()
            .faces()
            .iter()
            .enumerate()
            .map(|(i, f)| if i % 3 == 0 { f.flipped() } else { *f })
            .collect();
        let mixed = Mesh::new(cube().vertices().to_vec(), faces).unwrap();
        assert_eq!(MeshTree::new(&mixed).containment(Point3::ORIGIN, 0.0), Containment::Inside);
    }

    #[test]
    fn rays() {
        let tree = MeshTree::new(&cube());
        let up = Vector3::new(0.0, 0.0, 1.0);
        assert!(tree.blocks(Point3::new(0.0, 0.0, -3.0), up, 0.0));
        assert!(tree.blocks(Point3::new(0.5, 0.5, -3.0), up, 3.5));
        assert!(!tree.blocks(Point3::new(0.5, 0.5, -3.0), up, 4.5));
        assert!(!tree.blocks(Point3::new(1.5, 0.5, -3.0), up, 0.0));
        assert!(!tree.blocks(Point3::ORIGIN, Vector3::ZERO, 0.0));
        // Along an edge of the cube's grid, and through its corners.
        assert!(tree.blocks(Point3::new(-3.0, -3.0, -3.0), Vector3::new(1.0, 1.0, 1.0), 0.0));
        let flat = [[0.0; 3], [1.0, 1.0, 0.0]];
        assert!(ray_meets(&flat, &[0.5, 0.5, -1.0], &[f64::INFINITY, f64::INFINITY, 1.0]));
        let empty = MeshTree::new(&Mesh::default());
        assert!(!empty.blocks(Point3::ORIGIN, up, 0.0));
        assert_eq!(empty.containment(Point3::ORIGIN, 0.0), Containment::Outside);
    }
}
