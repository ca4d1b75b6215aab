//! Union, difference and intersection of closed meshes, by the crate `manifold-rust`: the only place besides
//! `shadow.rs` that knows it.

mod star;
mod united;

use std::panic::{AssertUnwindSafe, catch_unwind};

use manifold_rust::manifold::Manifold;
use manifold_rust::types::{BooleanEngine, Error as Status, MeshGL64, OpType};

use super::{Mesh, MeshFace};
use crate::hash::{Table, table};
use crate::{Error, Point3, Result, cancellation};

/// Coordinates beyond this are refused: their products leave the range of numbers.
const FARTHEST: f64 = 1e60;

/// What a closed mesh encloses, for unions, differences and intersections.
///
/// # Method
/// For meshes without self-intersections the algorithm of Manifold (J. Smith, *Towards robust inexact geometric
/// computation*, PhD thesis, Cambridge 2009: topology by symbolic perturbation, so that the result is closed whatever
/// coincides); for others an arrangement in exact numbers (Q. Zhou, E. Grinspun, D. Zorin, A. Jacobson, *Mesh
/// arrangements for solid geometry*, SIGGRAPH 2016). Places nearer to each other than about 10⁻¹² of the size may
/// become one.
#[derive(Clone)]
pub struct Solid {
    body: Manifold,
    /// It does not go through itself, or comes from solids that do not by the first algorithm, whose results are as its
    /// operands must be: it is not searched, which would take longer than the algorithm.
    proven: bool,
}

impl std::fmt::Debug for Solid {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Solid({} vertices, {} triangles)", self.body.num_vert(), self.body.num_tri())
    }
}

impl Solid {
    /// The solid inside a mesh. Vertices in the same place are one; faces that collapse to a line by that are left out.
    /// A mesh that looks inwards as a whole is turned round; quads are cut from first to third corner. Normals and
    /// colours are not kept. A mesh without faces encloses nothing.
    ///
    /// # Errors
    /// The mesh has naked edges, its faces do not all look to the same side, or its coordinates are beyond 10⁶⁰.
    pub fn new(mesh: &Mesh) -> Result<Self> {
        if mesh.vertices.iter().any(|p| p.x.abs().max(p.y.abs()).max(p.z.abs()) > FARTHEST) {
            return Err(Error::degenerate("mesh", "it lies too far from the origin for a boolean"));
        }
        // The library cannot be asked on its way: what it takes is asked for before.
        cancellation::room::<[u64; 48]>(2 * mesh.faces.len())?;
        let merged = mesh.merged_indices();
        let mut triangles: Vec<[u32; 3]> = Vec::with_capacity(2 * mesh.faces.len());
        for t in mesh.faces.iter().flat_map(|f| f.triangles()) {
            let [a, b, c] = t.map(|i| merged.get(i as usize).copied().unwrap_or(i));
            if a != b && b != c && c != a {
                triangles.push([a, b, c]);
            }
        }
        check_closed(&triangles)?;
        if mesh.volume() < 0.0 {
            triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        let mut number: Vec<Option<u64>> = vec![None; mesh.vertices.len()];
        let mut input = MeshGL64 { num_prop: 3, ..MeshGL64::default() };
        let mut count = 0;
        for i in triangles.into_iter().flatten() {
            let Some(slot) = number.get_mut(i as usize) else { continue };
            let k = *slot.get_or_insert_with(|| {
                count += 1;
                let p = mesh.vertices.get(i as usize).copied().unwrap_or_default();
                input.vert_properties.extend([p.x + 0.0, p.y + 0.0, p.z + 0.0]);
                count - 1
            });
            input.tri_verts.push(k);
        }
        if input.tri_verts.is_empty() {
            return Ok(Self::nothing());
        }
        let made = guarded(|| Manifold::from_mesh_gl64_robust(&input))?;
        Ok(Self { proven: star::is_star_shaped(&made.body), ..made })
    }

    /// What is in either.
    ///
    /// # Errors
    /// The result has more triangles than can be counted.
    pub fn union(&self, other: &Self) -> Result<Self> {
        self.with(other, OpType::Add)
    }

    /// What is in this one and not in the other.
    ///
    /// # Errors
    /// As [`Solid::union`].
    pub fn difference(&self, other: &Self) -> Result<Self> {
        self.with(other, OpType::Subtract)
    }

    /// What is in both.
    ///
    /// # Errors
    /// As [`Solid::union`].
    pub fn intersection(&self, other: &Self) -> Result<Self> {
        self.with(other, OpType::Intersect)
    }

    fn with(&self, other: &Self, operation: OpType) -> Result<Self> {
        // What the library takes at the most, as measured: about 800 bytes a triangle.
        cancellation::room::<[u64; 100]>(self.body.num_tri().saturating_add(other.body.num_tri()))?;
        // The smaller first: when it goes through itself, the larger need not be searched.
        let [small, large] =
            if other.body.num_tri() < self.body.num_tri() { [other, self] } else { [self, other] };
        let proven = small.is_simple() && large.is_simple();
        let engine = if proven { BooleanEngine::Exact } else { BooleanEngine::Robust };
        let made = guarded(|| self.body.boolean_with_engine(&other.body, operation, engine))?;
        Ok(Self { proven, ..made })
    }

    /// Whether the boundary is known, or found, not to go through itself.
    fn is_simple(&self) -> bool {
        let searched = || !self.body.as_impl().is_soup && !self.body.has_self_intersections();
        // What fails in the search is for the method that takes anything.
        self.proven || catch_unwind(AssertUnwindSafe(searched)).unwrap_or(false)
    }

    fn nothing() -> Self {
        Self { body: Manifold::empty(), proven: true }
    }

    /// Whether nothing is enclosed.
    pub fn is_empty(&self) -> bool {
        self.body.is_empty()
    }

    /// The boundary as a mesh of triangles that looks outwards, with normals; without faces when nothing is enclosed.
    ///
    /// # Errors
    /// More vertices than an index can count.
    pub fn to_mesh(&self) -> Result<Mesh> {
        if self.is_empty() {
            return Ok(Mesh::default());
        }
        let out = self.body.get_mesh_gl64(-1);
        let stride = usize::try_from(out.num_prop).unwrap_or(3).max(3);
        let corner = |c: &[f64]| match c {
            [x, y, z, ..] => Some(Point3::new(*x, *y, *z)),
            _ => None,
        };
        let vertices = out.vert_properties.chunks_exact(stride).filter_map(corner).collect();
        let index = |i: &u64| u32::try_from(*i).unwrap_or(u32::MAX);
        let face = |t: &[u64]| match t {
            [a, b, c] => Some(MeshFace::Triangle([index(a), index(b), index(c)])),
            _ => None,
        };
        let faces = out.tri_verts.chunks_exact(3).filter_map(face).collect();
        Ok(Mesh::new(vertices, faces)?.with_normals())
    }
}

/// Every directed edge must be walked as often one way as the other.
fn check_closed(triangles: &[[u32; 3]]) -> Result<()> {
    let mut edges: Table<[u32; 2], [u32; 2]> = table(2 * triangles.len());
    for &[a, b, c] in triangles {
        for (i, j) in [(a, b), (b, c), (c, a)] {
            let walks = edges.entry([i.min(j), i.max(j)]).or_default();
            walks[usize::from(i > j)] += 1;
        }
    }
    let invalid = |why: String| Err(Error::Invalid { what: "mesh for a boolean", why });
    let naked = edges.values().filter(|w| (w[0] + w[1]) % 2 == 1).count();
    if naked > 0 {
        return invalid(format!("it is not closed, {naked} of its edges are naked"));
    }
    let turned = edges.values().filter(|w| w[0] != w[1]).count();
    if turned > 0 {
        return invalid(format!("its faces do not look to one side, neighbours differ along {turned} edges"));
    }
    Ok(())
}

/// Runs the crate's code. It holds its promises by assertions; one that fails is a message here, not the end.
fn guarded(make: impl FnOnce() -> Manifold) -> Result<Solid> {
    let invalid = |why: String| Err(Error::Invalid { what: "mesh for a boolean", why });
    match catch_unwind(AssertUnwindSafe(make)) {
        Ok(made) => match made.status() {
            Status::NoError => Ok(Solid { body: made, proven: false }),
            Status::ResultTooLarge => invalid("the result has too many faces".into()),
            status => invalid(format!("it does not enclose a solid ({status:?})")),
        },
        Err(_) => invalid("the boolean failed on this shape".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::Solid;
    use crate::{Box3, Interval, Mesh, MeshFace, Plane, Point3};

    fn cube(at: [f64; 3]) -> Mesh {
        let [x, y, z] = at.map(|c| Interval::new(c, c + 2.0));
        Mesh::cuboid(&Box3 { plane: Plane::XY, x, y, z }, 2, 2, 2).unwrap()
    }

    fn volumes(a: &Mesh, b: &Mesh) -> [f64; 3] {
        let (a, b) = (Solid::new(a).unwrap(), Solid::new(b).unwrap());
        [a.union(&b), a.difference(&b), a.intersection(&b)].map(|s| {
            let mesh = s.unwrap().to_mesh().unwrap();
            // Closed, and all to one side, also where four faces meet along an edge.
            assert!(Solid::new(&mesh).is_ok());
            mesh.volume()
        })
    }

    #[test]
    fn boxes() {
        let near = |got: [f64; 3], want: [f64; 3]| {
            assert!(got.iter().zip(want).all(|(g, w)| (g - w).abs() < 1e-9), "{got:?} for {want:?}");
        };
        near(volumes(&cube([0.0; 3]), &cube([1.0; 3])), [15.0, 7.0, 1.0]);
        near(volumes(&cube([0.0; 3]).flipped(), &cube([1.0; 3])), [15.0, 7.0, 1.0]);
        near(volumes(&cube([0.0; 3]), &cube([5.0; 3])), [16.0, 8.0, 0.0]);
        // Side by side, the same, and edge to edge.
        near(volumes(&cube([0.0; 3]), &cube([2.0, 0.0, 0.0])), [16.0, 8.0, 0.0]);
        near(volumes(&cube([0.0; 3]), &cube([0.0; 3])), [8.0, 0.0, 8.0]);
        near(volumes(&cube([0.0; 3]), &cube([2.0, 2.0, 0.0])), [16.0, 8.0, 0.0]);
        near(volumes(&cube([0.0; 3]), &cube([0.0, 1.0, 0.0])), [12.0, 4.0, 4.0]);
        near(volumes(&cube([0.0; 3]), &Mesh::default()), [8.0, 8.0, 0.0]);
    }

    #[test]
    fn what_encloses_nothing_is_refused() {
        let open =
            Mesh::new(cube([0.0; 3]).vertices().to_vec(), cube([0.0; 3]).faces()[1..].to_vec()).unwrap();
        let said = Solid::new(&open).unwrap_err().to_string();
        assert!(said.contains("not closed"), "{said}");
        let mut faces = cube([0.0; 3]).faces().to_vec();
        faces[0] = faces[0].flipped();
        let mixed = Mesh::new(cube([0.0; 3]).vertices().to_vec(), faces).unwrap();
        let said = Solid::new(&mixed).unwrap_err().to_string();
        assert!(said.contains("one side"), "{said}");
        let far =
            [[0.0; 3], [1e200, 0.0, 0.0], [0.0, 1e200, 0.0], [0.0, 0.0, 1e200]].map(Point3::from).to_vec();
        let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(MeshFace::Triangle).to_vec();
        assert!(Solid::new(&Mesh::new(far, faces).unwrap()).is_err());
    }

    #[test]
    fn meshes_through_themselves() {
        // Two boxes in one mesh, overlapping: what they enclose counts once.
        let twice = Mesh::join(&[cube([0.0; 3]), cube([1.0; 3])]).unwrap();
        let [union, ..] = volumes(&twice, &cube([0.5; 3]));
        let [both, ..] = volumes(&cube([0.0; 3]), &cube([1.0; 3]));
        let whole =
            Solid::new(&cube([0.0; 3])).unwrap().union(&Solid::new(&cube([1.0; 3])).unwrap()).unwrap();
        let all = whole.union(&Solid::new(&cube([0.5; 3])).unwrap()).unwrap().to_mesh().unwrap();
        assert!((both - 15.0).abs() < 1e-9);
        assert!((union - all.volume()).abs() < 1e-9, "{union} {}", all.volume());
    }
}
