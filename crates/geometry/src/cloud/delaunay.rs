use std::collections::HashMap;

use spade::handles::{FixedVertexHandle, VertexHandle};
use spade::{DelaunayTriangulation, HasPosition, Triangulation};

use super::check_points2;
use crate::{Error, Point2, Result};

/// Numbers nearer to 0 than 2⁻¹⁴² count as 0: the predicates would underflow.
const SMALLEST: f64 = 1.793_662_034_335_766e-43;

/// A point with its place in the list.
#[derive(Debug, Clone, Copy)]
pub(super) struct Site {
    position: spade::Point2<f64>,
    pub(super) index: u32,
}

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> spade::Point2<f64> {
        self.position
    }
}

/// A triangulation of sites.
pub(super) type SiteMesh = DelaunayTriangulation<Site>;
/// A corner of the triangulation.
pub(super) type Corner<'a> = VertexHandle<'a, Site>;

/// The Delaunay triangulation of points in a plane: no circle about a triangle has a point inside.
///
/// Points in the same place count as the first of them. Points on one line have edges but no triangles. Of several
/// triangulations that points on one circle have, it is one. Found by the `spade` crate: a sweep with exact predicates
/// (B. Žalik, I. Kolingerová, *A sweep-line algorithm for spatial triangulation*, 2005).
#[derive(Debug, Clone)]
pub struct Delaunay {
    mesh: SiteMesh,
    /// For every point the first in its place, when some points share one.
    shared: Option<Vec<u32>>,
    /// For every point its vertex.
    vertices: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}

impl Delaunay {
    /// Triangulates points.
    ///
    /// # Errors
    /// A coordinate is not finite or beyond 3.2e60, or there are 2²⁹ points or more.
    pub fn new(points: &[Point2]) -> Result<Self> {
        let (mesh, shared) = triangulated(points)?;
        let mut vertices = vec![0; points.len()];
        for vertex in mesh.vertices() {
            if let Some(place) = vertices.get_mut(vertex.data().index as usize) {
                *place = vertex.index() as u32;
            }
        }
        let triangles = mesh.inner_faces().map(|f| f.vertices().map(|v| v.data().index)).collect();
        Ok(Self { mesh, shared, vertices, triangles })
    }

    /// The triangles by the indices of their corners, counter-clockwise.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        self.vertices.len()
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.vertices.is_empty()
    }

    /// The first point in the same place as point `i`: mostly itself.
    pub fn first_at(&self, i: usize) -> usize {
        self.shared.as_ref().and_then(|s| s.get(i)).map_or(i, |&first| first as usize)
    }

    /// Whether some points share a place.
    pub fn has_duplicates(&self) -> bool {
        self.shared.is_some()
    }

    fn corner(&self, i: usize) -> Option<Corner<'_>> {
        let vertex = *self.vertices.get(self.first_at(i))?;
        self.mesh.get_vertex(FixedVertexHandle::from_index(vertex as usize))
    }

    /// The points that an edge joins to point `i`, counter-clockwise around it.
    pub fn neighbours(&self, i: usize) -> impl Iterator<Item = usize> + '_ {
        self.corner(i).into_iter().flat_map(|v| v.out_edges().map(|e| e.to().data().index as usize))
    }

    /// Every edge once, by the indices of its ends, the smaller first; in order.
    pub fn edges(&self) -> Vec<[u32; 2]> {
        let mut out: Vec<[u32; 2]> = self
            .mesh
            .undirected_edges()
            .map(|e| {
                let [a, b] = e.vertices().map(|v| v.data().index);
                [a.min(b), a.max(b)]
            })
            .collect();
        out.sort_unstable();
        out
    }

    /// The points along the border, counter-clockwise, those on straight stretches included. For points on one line it
    /// goes there and back.
    pub fn border(&self) -> Vec<u32> {
        let mut out: Vec<u32> = self.mesh.convex_hull().map(|e| e.from().data().index).collect();
        out.reverse();
        out
    }
}

/// The triangulation, and, when some points share a place, for every point the first in its place.
pub(super) fn triangulated(points: &[Point2]) -> Result<(SiteMesh, Option<Vec<u32>>)> {
    check_points2(points)?;
    let settled = |x: f64| if x.abs() < SMALLEST { 0.0 } else { x };
    let place = |p: &Point2| spade::Point2::new(settled(p.x), settled(p.y));
    let sites = points.iter().zip(0..).map(|(p, index)| Site { position: place(p), index }).collect();
    let mut mesh = DelaunayTriangulation::<Site>::bulk_load(sites)
        .map_err(|e| Error::Invalid { what: "points to triangulate", why: e.to_string() })?;
    // Where points share a place the triangulation names any one of them: it shall be the first.
    let shared = (mesh.num_vertices() < points.len()).then(|| {
        let mut first: HashMap<[u64; 2], u32> = HashMap::with_capacity(points.len());
        let firsts: Vec<u32> = points
            .iter()
            .zip(0..)
            .map(|(p, i)| {
                let p = place(p);
                *first.entry([(p.x + 0.0).to_bits(), (p.y + 0.0).to_bits()]).or_insert(i)
            })
            .collect();
        for handle in mesh.fixed_vertices() {
            let data = mesh.vertex_data_mut(handle);
            data.index = firsts.get(data.index as usize).copied().unwrap_or(data.index);
        }
        firsts
    });
    Ok((mesh, shared))
}

/// The centre of the circle through three points; not finite when they lie on a line.
///
/// Measured from an end of the shortest side: rounding in the differences then matters least.
pub(super) fn circumcenter([a, b, c]: [Point2; 3]) -> Point2 {
    let (ab, bc, ca) = ((b - a).length_squared(), (c - b).length_squared(), (a - c).length_squared());
    let (o, p, q) = if ab <= bc && ab <= ca {
        (a, b, c)
    } else if bc <= ca {
        (b, c, a)
    } else {
        (c, a, b)
    };
    let (p, q) = (p - o, q - o);
    let doubled = 2.0 * p.cross(q);
    let (pp, qq) = (p.length_squared(), q.length_squared());
    Point2::new(o.x + (q.y * pp - p.y * qq) / doubled, o.y + (p.x * qq - q.x * pp) / doubled)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(n: i32) -> Vec<Point2> {
        (0..n * n).map(|i| Point2::new(f64::from(i % n), f64::from(i / n))).collect()
    }

    #[test]
    fn a_grid_has_two_triangles_a_cell() {
        let d = Delaunay::new(&grid(20)).unwrap();
        assert_eq!(d.triangles().len(), 2 * 19 * 19);
        assert_eq!(d.border().len(), 4 * 19);
        assert_eq!(d.edges().len(), 3 * 19 * 19 + 2 * 19);
        let border = d.border();
        assert_eq!(border.iter().filter(|&&i| i == 0).count(), 1);
    }

    #[test]
    fn few_points_and_points_on_a_line() {
        for n in 0..5 {
            let row: Vec<Point2> = (0..n).map(|i| Point2::new(f64::from(i), 2.0 * f64::from(i))).collect();
            let d = Delaunay::new(&row).unwrap();
            assert!(d.triangles().is_empty());
            assert_eq!(d.edges().len(), usize::try_from((n - 1).max(0)).unwrap());
            if n > 2 {
                assert_eq!(d.neighbours(1).count(), 2);
            }
        }
    }

    #[test]
    fn points_in_one_place_are_the_first() {
        let p = Point2::new(1.0, 1.0);
        let points = [p, Point2::ORIGIN, p, Point2::new(2.0, 0.0), p, Point2::new(-0.0, 0.0)];
        let d = Delaunay::new(&points).unwrap();
        assert_eq!(d.triangles().len(), 1);
        let mut corners = d.triangles()[0];
        corners.sort_unstable();
        assert_eq!(corners, [0, 1, 3]);
        assert_eq!((0..6).map(|i| d.first_at(i)).collect::<Vec<_>>(), [0, 1, 0, 3, 0, 1]);
        let mut around: Vec<usize> = d.neighbours(4).collect();
        around.sort_unstable();
        assert_eq!(around, [1, 3]);
    }

    #[test]
    fn refuses_what_is_no_place() {
        for x in [f64::NAN, f64::INFINITY, 1e300] {
            assert!(Delaunay::new(&[Point2::new(x, 0.0)]).is_err());
        }
        assert!(Delaunay::new(&[Point2::new(1e60, 1e-300), Point2::ORIGIN]).is_ok());
    }
}
