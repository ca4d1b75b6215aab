use std::collections::HashMap;

use spade::handles::{FixedVertexHandle, VertexHandle};
use spade::{DelaunayTriangulation, HasPosition, Triangulation};

use super::check_points2;
use crate::{Error, Point2, Result, cancellation};

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

/// How sites hang together.
#[derive(Debug, Clone)]
pub(super) enum Links {
    /// By the edges of triangles.
    Mesh(SiteMesh),
    /// One by one: all lie on a line, in this order. The first of those that share a place stands for them.
    ///
    /// `spade` sorts such points anew for each that comes.
    Row(Vec<u32>),
}
/// A corner of the triangulation.
pub(super) type Corner<'a> = VertexHandle<'a, Site>;

/// The Delaunay triangulation of points in a plane: no circle about a triangle has a point inside.
///
/// Points in the same place count as the first of them. Points on one line have edges but no triangles. Of several
/// triangulations that points on one circle have, it is one. Found by the `spade` crate: a sweep with exact predicates
/// (B. Žalik, I. Kolingerová, *A sweep-line algorithm for spatial triangulation*, 2005).
#[derive(Debug, Clone)]
pub struct Delaunay {
    links: Links,
    /// For every point the first in its place, when some points share one.
    shared: Option<Vec<u32>>,
    /// For every point its vertex, or its place in the row.
    vertices: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}

impl Delaunay {
    /// Triangulates points.
    ///
    /// # Errors
    /// A coordinate is not finite or beyond 3.2e60, or there are 2²⁹ points or more.
    pub fn new(points: &[Point2]) -> Result<Self> {
        let (links, shared) = linked(points)?;
        let mut vertices = vec![0; points.len()];
        let mut keep = |index: u32, vertex: usize| {
            if let Some(place) = vertices.get_mut(index as usize) {
                *place = vertex as u32;
            }
        };
        let mut triangles = Vec::new();
        match &links {
            Links::Mesh(mesh) => {
                mesh.vertices().for_each(|vertex| keep(vertex.data().index, vertex.index()));
                triangles.extend(mesh.inner_faces().map(|f| f.vertices().map(|v| v.data().index)));
            }
            Links::Row(row) => row.iter().enumerate().for_each(|(k, &index)| keep(index, k)),
        }
        Ok(Self { links, shared, vertices, triangles })
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

    /// The points that an edge joins to point `i`, counter-clockwise around it.
    pub fn neighbours(&self, i: usize) -> impl Iterator<Item = usize> + '_ {
        let vertex = self.vertices.get(self.first_at(i)).map(|&vertex| vertex as usize);
        let (corner, beside) = match (&self.links, vertex) {
            (_, None) => (None, None),
            (Links::Mesh(mesh), Some(vertex)) => {
                (mesh.get_vertex(FixedVertexHandle::from_index(vertex)), None)
            }
            (Links::Row(row), Some(place)) => (None, Some(beside(row, place))),
        };
        let around = corner.into_iter().flat_map(|v: Corner<'_>| v.out_edges().map(|e| e.to().data().index));
        around.chain(beside.into_iter().flatten()).map(|index| index as usize)
    }

    /// Every edge once, by the indices of its ends, the smaller first; in order.
    pub fn edges(&self) -> Vec<[u32; 2]> {
        let ordered = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
        let mut out: Vec<[u32; 2]> = match &self.links {
            Links::Mesh(mesh) => {
                mesh.undirected_edges().map(|e| ordered(e.vertices().map(|v| v.data().index))).collect()
            }
            Links::Row(row) => row.iter().zip(row.iter().skip(1)).map(|(&a, &b)| ordered([a, b])).collect(),
        };
        out.sort_unstable();
        out
    }

    /// The points along the border, counter-clockwise, those on straight stretches included. For points on one line it
    /// goes there and back.
    pub fn border(&self) -> Vec<u32> {
        match &self.links {
            Links::Mesh(mesh) => {
                let mut out: Vec<u32> = mesh.convex_hull().map(|e| e.from().data().index).collect();
                out.reverse();
                out
            }
            Links::Row(row) => {
                let back = row.iter().rev().skip(1).take(row.len().saturating_sub(2));
                if row.len() < 2 { Vec::new() } else { row.iter().chain(back).copied().collect() }
            }
        }
    }
}

/// Those before and behind a place in a row.
pub(super) fn beside(row: &[u32], place: usize) -> impl Iterator<Item = u32> + use<> {
    let at = |k: usize| row.get(k).copied();
    let before = place.checked_sub(1).and_then(at);
    before.into_iter().chain(at(place + 1))
}

/// How points hang together, and, when some share a place, for every point the first in its place.
pub(super) fn linked(points: &[Point2]) -> Result<(Links, Option<Vec<u32>>)> {
    check_points2(points)?;
    // 0 has one sign: places are compared by their bits.
    let settled = |x: f64| if x.abs() < SMALLEST { 0.0 } else { x };
    let places: Vec<Point2> = points.iter().map(|p| Point2::new(settled(p.x), settled(p.y))).collect();
    if on_a_line(&places) {
        let mut row: Vec<u32> = (0..places.len() as u32).collect();
        let at = |i: u32| places.get(i as usize).copied().unwrap_or_default();
        let compared = |p: Point2, q: Point2| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y));
        row.sort_unstable_by(|&i, &j| compared(at(i), at(j)).then(i.cmp(&j)));
        row.dedup_by(|next, kept| at(*next) == at(*kept));
        let shared = (row.len() < places.len()).then(|| firsts(&places));
        return Ok((Links::Row(row), shared));
    }
    // The triangulation and what it is made with: it cannot be asked on its way.
    cancellation::room::<[u64; 48]>(places.len())?;
    let sites = places
        .iter()
        .zip(0..)
        .map(|(p, index)| Site { position: spade::Point2::new(p.x, p.y), index })
        .collect();
    let mut mesh = DelaunayTriangulation::<Site>::bulk_load(sites)
        .map_err(|e| Error::Invalid { what: "points to triangulate", why: e.to_string() })?;
    // Where points share a place the triangulation names any one of them: it shall be the first.
    let shared = (mesh.num_vertices() < points.len()).then(|| {
        let firsts = firsts(&places);
        for handle in mesh.fixed_vertices() {
            let data = mesh.vertex_data_mut(handle);
            data.index = firsts.get(data.index as usize).copied().unwrap_or(data.index);
        }
        firsts
    });
    Ok((Links::Mesh(mesh), shared))
}

/// For every point the first in its place.
fn firsts(places: &[Point2]) -> Vec<u32> {
    let mut first: HashMap<[u64; 2], u32> = HashMap::with_capacity(places.len());
    places.iter().zip(0..).map(|(p, i)| *first.entry([p.x.to_bits(), p.y.to_bits()]).or_insert(i)).collect()
}

/// Whether all points lie on one line, exactly.
fn on_a_line(points: &[Point2]) -> bool {
    let Some(&a) = points.first() else { return true };
    let Some(&b) = points.iter().find(|&&p| p != a) else { return true };
    let coordinate = |p: Point2| robust::Coord { x: p.x, y: p.y };
    points.iter().all(|&p| robust::orient2d(coordinate(a), coordinate(b), coordinate(p)) == 0.0)
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

    /// The edges along a line do not hang on how many points there are, nor on their order.
    #[test]
    fn a_long_row_is_sorted_once() {
        let n = 100_000_u32;
        let row: Vec<Point2> = (0..n)
            .map(|i| f64::from(i.wrapping_mul(7919) % n))
            .map(|x| Point2::new(0.25 * x - 3.0, 2.0 - 0.5 * x))
            .chain([Point2::new(-3.0, 2.0)])
            .collect();
        let d = Delaunay::new(&row).unwrap();
        assert_eq!(d.edges().len(), n as usize - 1);
        assert!(d.edges().iter().all(|&[a, b]| {
            let distance = row[a as usize].distance_to(row[b as usize]);
            (distance - 0.25_f64.hypot(0.5)).abs() < 1e-9
        }));
        assert_eq!(d.border().len(), 2 * (n as usize - 1));
        assert_eq!((d.first_at(n as usize), d.neighbours(n as usize).count()), (0, 1));
        let border = crate::cloud::ConvexPolygon::rectangle(
            crate::Interval::new(-10.0, 30_000.0),
            crate::Interval::new(-60_000.0, 10.0),
        );
        let cells = crate::cloud::Voronoi::new(&row, &border.unwrap()).unwrap();
        let area: f64 = (0..cells.len()).map(|i| cells.area(i)).sum();
        assert!((area / (30_010.0 * 60_010.0) - 1.0).abs() < 1e-9, "{area}");
        assert_eq!(cells.area(n as usize), 0.0);
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
