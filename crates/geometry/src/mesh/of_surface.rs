//! Meshes of surfaces without trims.

use super::{Mesh, MeshFace};
use crate::thresholds;
use crate::{Direction, Error, Point3, Result, Side, Surface, Vector3};

/// More quads than this are refused before memory is asked for.
const MOST: usize = 20_000_000;
/// An interval between two lines of the grid is halved at most this often.
const HALVINGS: u32 = 10;
/// Most lines of one direction.
const LINES: usize = 4096;
/// Most places along the other direction at which an interval is looked at.
const SAMPLES: usize = 17;

/// How fine the mesh of a surface is. A limit of 0 is off.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SurfaceMeshing {
    /// The greatest distance between mesh and surface, in model units.
    pub max_distance: f64,
    /// The greatest turn along a line of the grid from one edge to the next, in radians.
    pub max_angle: f64,
    /// Edges are not halved when their halves would be shorter.
    pub min_edge: f64,
    /// The longest edge.
    pub max_edge: f64,
    /// The longest side of a quad over its shortest, on the whole.
    pub aspect: f64,
    /// The fewest quads.
    pub min_count: usize,
    /// Whether the limits hold beyond the first grid, that of `min_count`.
    pub refine: bool,
    /// Whether a flat surface with four straight sides is one quad.
    pub simple_planes: bool,
}

impl Default for SurfaceMeshing {
    /// A sixteenth part of a turn, at least 16 quads, plane surfaces in one.
    fn default() -> Self {
        Self {
            max_distance: 0.0,
            max_angle: std::f64::consts::PI / 8.0,
            min_edge: 0.0,
            max_edge: 0.0,
            aspect: 0.0,
            min_count: 16,
            refine: true,
            simple_planes: true,
        }
    }
}

impl SurfaceMeshing {
    /// The parameters in u and v between which the quads of a surface lie: those where its pieces meet, and more in
    /// between until the limits hold along every second line, and for the twist of the quads. The limits are looked at
    /// in up to 17 places along each line, not proved.
    ///
    /// # Errors
    /// A limit is negative or not finite, or there are too many quads.
    pub fn grid(&self, surface: &Surface) -> Result<[Vec<f64>; 2]> {
        for (what, value) in [
            ("greatest distance", self.max_distance),
            ("greatest angle", self.max_angle),
            ("shortest edge", self.min_edge),
            ("longest edge", self.max_edge),
            ("aspect ratio", self.aspect),
        ] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(Error::OutOfRange { what, value, must: "finite and not negative" });
            }
        }
        let directions = [Direction::U, Direction::V];
        let mut grid = directions.map(|d| surface.span_parameters(d));
        if self.simple_planes && is_flat_quad(surface) {
            return Ok(directions.map(|d| vec![surface.domain(d).start, surface.domain(d).end]));
        }
        if self.refine {
            grid = directions.map(|d| self.refined(surface, d, &grid));
            self.untwist(surface, &mut grid);
        }
        self.balance(surface, &mut grid);
        let quads =
            |g: &[Vec<f64>; 2]| g[0].len().saturating_sub(1).saturating_mul(g[1].len().saturating_sub(1));
        if quads(&grid) < self.min_count {
            let parts = (self.min_count as f64 / quads(&grid).max(1) as f64).sqrt().ceil().max(1.0);
            let most = (MOST as f64 / quads(&grid).max(1) as f64).sqrt();
            let parts = parts.min(most.max(1.0)) as usize;
            grid = grid.map(|line| divided(&line, parts));
        }
        if quads(&grid) > MOST {
            return Err(Error::OutOfRange {
                what: "number of quads",
                value: quads(&grid) as f64,
                must: "at most 20 million",
            });
        }
        Ok(grid)
    }

    /// The lines of one direction with more in between until the limits hold.
    fn refined(&self, surface: &Surface, direction: Direction, grid: &[Vec<f64>; 2]) -> Vec<f64> {
        let spans = &grid[direction.index()];
        let other = divided(&grid[1 - direction.index()], 2);
        let step = other.len().div_ceil(SAMPLES).max(1);
        let mut samples: Vec<f64> = other.iter().copied().step_by(step).collect();
        samples.extend(other.last().filter(|l| samples.last() != Some(l)));
        let at = |t: f64, s: f64| match direction {
            Direction::U => surface.point_at(t, s),
            Direction::V => surface.point_at(s, t),
        };
        let mut out: Vec<f64> = spans.first().copied().into_iter().collect();
        for (&a, &b) in spans.iter().zip(spans.iter().skip(1)) {
            // Depth first, so that the ends come in order.
            let mut stack = vec![(a, b, 0)];
            while let Some((a, b, depth)) = stack.pop() {
                let middle = 0.5 * (a + b);
                let room = depth < HALVINGS && out.len() + stack.len() < LINES && middle > a && middle < b;
                if room
                    && samples
                        .iter()
                        .any(|&s| self.is_coarse([0.0, 0.25, 0.5, 0.75, 1.0].map(|x| at(a + (b - a) * x, s))))
                {
                    stack.extend([(middle, b, depth + 1), (a, middle, depth + 1)]);
                } else {
                    out.push(b);
                }
            }
        }
        out
    }

    /// Whether a stretch of a line, given by its quarters, passes a limit as one edge.
    fn is_coarse(&self, p: [Point3; 5]) -> bool {
        let chord = p[4] - p[0];
        let whole = chord.length();
        let length: f64 = p.windows(2).map(|w| w[0].distance_to(w[1])).sum();
        if length == 0.0 || (self.min_edge > 0.0 && length < 2.0 * self.min_edge) {
            return false;
        }
        if self.max_edge > 0.0 && length > self.max_edge * (1.0 + thresholds::OVER_LIMIT) {
            return true;
        }
        let away = |q: &Point3| {
            let v = *q - p[0];
            let t = if whole > 0.0 { (v.dot(chord) / (whole * whole)).clamp(0.0, 1.0) } else { 0.0 };
            (v - chord * t).length()
        };
        if self.max_distance > 0.0 && p[1..4].iter().any(|q| away(q) > self.max_distance) {
            return true;
        }
        if self.max_angle > 0.0 {
            let steps: Vec<Vector3> = p.windows(2).map(|w| w[1] - w[0]).collect();
            let turns = steps.windows(2).filter_map(|w| w[0].angle_to(w[1]));
            // Three turns between four steps: the whole stretch turns by a third more.
            return turns.sum::<f64>() * 4.0 / 3.0 > self.max_angle * (1.0 + thresholds::OVER_LIMIT);
        }
        false
    }

    /// Halves all intervals while a quad is twisted too far: its diagonals pass each other at a distance.
    fn untwist(&self, surface: &Surface, grid: &mut [Vec<f64>; 2]) {
        if self.max_distance <= 0.0 {
            return;
        }
        for _ in 0..6 {
            let [us, vs] = &*grid;
            if us.len().saturating_mul(vs.len()) > MOST / 16 || us.len().max(vs.len()) > LINES {
                return;
            }
            let pairs = |l: &[f64]| -> Vec<[f64; 2]> {
                let step = (l.len() / SAMPLES).max(1);
                l.windows(2).step_by(step).map(|w| [w[0], w[1]]).collect()
            };
            let twisted = pairs(us).iter().any(|[a, b]| {
                pairs(vs).iter().any(|[c, d]| {
                    let at = |u: f64, v: f64| surface.point_at(u, v).to_vector();
                    let twist = at(*a, *c) - at(*b, *c) - at(*a, *d) + at(*b, *d);
                    // Either diagonal passes the middle of a bilinear patch at a quarter of this.
                    0.25 * twist.length() > self.max_distance
                })
            });
            if !twisted {
                return;
            }
            let finer = [divided(us, 2), divided(vs, 2)];
            *grid = finer;
        }
    }

    /// Divides the intervals of the direction in which quads are too long.
    fn balance(&self, surface: &Surface, grid: &mut [Vec<f64>; 2]) {
        if self.aspect < 1.0 {
            return;
        }
        let middles = [Direction::U, Direction::V].map(|d| surface.domain(d).middle());
        let edge = |d: usize| {
            let line = &grid[d];
            let at = |t: f64| {
                if d == 0 { surface.point_at(t, middles[1]) } else { surface.point_at(middles[0], t) }
            };
            let length: f64 = line.windows(2).map(|w| at(w[0]).distance_to(at(w[1]))).sum();
            length / line.len().saturating_sub(1).max(1) as f64
        };
        let (u, v) = (edge(0), edge(1));
        let (long, ratio) = if u > v { (0, u / v) } else { (1, v / u) };
        if ratio > self.aspect && ratio.is_finite() {
            let parts = (ratio / self.aspect).ceil().min(LINES as f64) as usize;
            let line = divided(&grid[long], parts);
            grid[long] = line;
        }
    }
}

/// Every interval in equal parts.
fn divided(line: &[f64], parts: usize) -> Vec<f64> {
    let inner =
        line.windows(2).flat_map(|w| (0..parts).map(move |k| w[0] + (w[1] - w[0]) * k as f64 / parts as f64));
    inner.chain(line.last().copied()).collect()
}

/// Whether a surface is a flat quadrilateral: two triangles are all of it.
fn is_flat_quad(surface: &Surface) -> bool {
    let straight = |side: Side| {
        let Ok(curve) = surface.side_curve(side) else { return surface.is_singular(side) };
        let size = curve.start().distance_to(curve.end());
        curve.is_linear(thresholds::SAME_POINT * size)
    };
    let corners = [Direction::U, Direction::V].map(|d| surface.domain(d));
    let size = surface
        .point_at(corners[0].start, corners[1].start)
        .distance_to(surface.point_at(corners[0].end, corners[1].end));
    surface.is_planar(thresholds::SAME_POINT * size) && Side::ALL.into_iter().all(straight)
}

impl Mesh {
    /// The quads of a surface between lines of constant u and constant v: vertices with v fastest, looking along the
    /// surface's normal. Where a side is a point the quads become triangles, and where the surface closes the vertices
    /// at both ends are in exactly the same place. Parameters should ascend.
    ///
    /// # Errors
    /// Fewer than two lines in a direction, too many quads, or points that are not finite.
    pub fn surface_grid(surface: &Surface, us: &[f64], vs: &[f64]) -> Result<Self> {
        let (nu, nv) = (us.len(), vs.len());
        if nu < 2 || nv < 2 || nu.saturating_mul(nv) > 2 * MOST {
            let value = nu.min(nv) as f64;
            return Err(Error::OutOfRange {
                what: "lines of the grid",
                value,
                must: "2 or more, and not too many",
            });
        }
        let [u, v] = [Direction::U, Direction::V].map(|d| surface.domain(d));
        let closed = [Direction::U, Direction::V].map(|d| surface.is_closed(d));
        let point =
            [(Side::West, 0, 0), (Side::East, 0, nu - 1), (Side::South, 1, 0), (Side::North, 1, nv - 1)]
                .map(|(side, d, k)| (surface.is_singular(side), d, k));
        // Whether the lines reach the ends of the domain, where poles and seams are.
        let whole = [
            us.first() == Some(&u.start) && us.last() == Some(&u.end),
            vs.first() == Some(&v.start) && vs.last() == Some(&v.end),
        ];
        let place = |i: usize, j: usize| {
            let (mut i, mut j) = (i, j);
            if whole[0] && closed[0] && i == nu - 1 {
                i = 0;
            }
            if whole[1] && closed[1] && j == nv - 1 {
                j = 0;
            }
            for (singular, d, k) in point {
                if singular && whole[d] && [i, j][d] == k {
                    (i, j) = if d == 0 { (k, 0) } else { (0, k) };
                }
            }
            (i, j)
        };
        let mut vertices = Vec::with_capacity(nu * nv);
        let mut normals = Vec::with_capacity(nu * nv);
        let mut known = true;
        for (i, &s) in us.iter().enumerate() {
            for (j, &t) in vs.iter().enumerate() {
                let (k, l) = place(i, j);
                let at = |list: &[f64], n: usize, fallback: f64| list.get(n).copied().unwrap_or(fallback);
                vertices.push(surface.point_at(at(us, k, s), at(vs, l, t)));
                let normal = surface.normal_at(s, t);
                known &= normal.is_some();
                normals.push(normal.unwrap_or(Vector3::ZERO));
            }
        }
        let mut faces = Vec::with_capacity((nu - 1) * (nv - 1));
        for i in 0..nu - 1 {
            for j in 0..nv - 1 {
                let at = |i: usize, j: usize| (i * nv + j) as u32;
                let quad = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                let same = |a: u32, b: u32| vertices.get(a as usize) == vertices.get(b as usize);
                let [a, b, c, d] = quad;
                faces.push(match (same(a, b), same(b, c), same(c, d), same(d, a)) {
                    (true, ..) => MeshFace::Triangle([b, c, d]),
                    (_, true, ..) => MeshFace::Triangle([a, c, d]),
                    (_, _, true, _) => MeshFace::Triangle([a, b, d]),
                    (.., true) => MeshFace::Triangle([a, b, c]),
                    _ => MeshFace::Quad(quad),
                });
            }
        }
        let mesh = Self::from_parts(vertices, faces, normals, Vec::new())?;
        Ok(if known { mesh } else { mesh.with_normals() })
    }

    /// The mesh of a surface, as fine as asked: the grid of [`SurfaceMeshing::grid`].
    ///
    /// # Errors
    /// As [`SurfaceMeshing::grid`] and [`Mesh::surface_grid`].
    pub fn from_surface(surface: &Surface, meshing: &SurfaceMeshing) -> Result<Self> {
        let [us, vs] = meshing.grid(surface)?;
        Self::surface_grid(surface, &us, &vs)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::SurfaceMeshing;
    use crate::{
        Interval, Mesh, MeshFace, NurbsSurface, Plane, PlaneSurface, Point3, Sphere, Surface, Torus,
    };

    #[test]
    fn round_surfaces_close() {
        let limits =
            SurfaceMeshing { max_distance: 0.01, max_angle: 0.0, min_count: 0, ..SurfaceMeshing::default() };
        let sphere: Surface = Sphere { plane: Plane::XY, radius: 2.0 }.into();
        let mesh = Mesh::from_surface(&sphere, &limits).unwrap();
        assert!(mesh.is_closed() && mesh.is_oriented(), "{}", mesh.faces().len());
        let round = 4.0 / 3.0 * PI * 8.0;
        assert!(mesh.volume() > 0.97 * round && mesh.volume() < round);
        let torus: Surface = Torus::new(Plane::XY, 3.0, 1.0).unwrap().into();
        let mesh = Mesh::from_surface(&torus, &limits).unwrap();
        assert!(mesh.is_closed() && mesh.is_oriented());
        for t in mesh.face_centers() {
            assert!(Torus::new(Plane::XY, 3.0, 1.0).unwrap().closest_point(t).distance_to(t) < 0.0201);
        }
    }

    #[test]
    fn planes_counts_and_limits() {
        let flat: Surface =
            PlaneSurface::new(Plane::XY, Interval::new(0.0, 8.0), Interval::new(0.0, 2.0)).unwrap().into();
        let faces = |m: &SurfaceMeshing| Mesh::from_surface(&flat, m).unwrap().faces().len();
        let base = SurfaceMeshing::default();
        assert_eq!(faces(&base), 1);
        assert_eq!(faces(&SurfaceMeshing { simple_planes: false, ..base }), 16);
        assert_eq!(faces(&SurfaceMeshing { simple_planes: false, min_count: 0, aspect: 1.0, ..base }), 4);
        let fine = SurfaceMeshing { simple_planes: false, min_count: 0, max_edge: 0.5, ..base };
        assert_eq!(faces(&fine), 16 * 4);
        let mesh = Mesh::from_surface(&flat, &fine).unwrap();
        assert!((mesh.area() - 16.0).abs() < 1e-12);
        assert!(mesh.normals().iter().all(|n| n.z == 1.0));
        assert!(Mesh::from_surface(&flat, &SurfaceMeshing { max_edge: f64::NAN, ..base }).is_err());
        assert!(Mesh::surface_grid(&flat, &[0.0], &[0.0, 1.0]).is_err());
        let grid = Mesh::surface_grid(&flat, &[0.0, 8.0], &[0.0, 1.0, 2.0]).unwrap();
        assert_eq!(grid.vertices()[1], Point3::new(0.0, 1.0, 0.0));
        assert_eq!(grid.faces()[0], MeshFace::Quad([0, 3, 4, 1]));
    }

    #[test]
    fn a_twisted_patch_is_divided() {
        let corner = |x: f64, y: f64| Point3::new(x, y, x * y);
        let saddle = NurbsSurface::from_corners(
            corner(0.0, 0.0),
            corner(2.0, 0.0),
            corner(2.0, 2.0),
            corner(0.0, 2.0),
        );
        let saddle: Surface = saddle.unwrap().into();
        let limits =
            SurfaceMeshing { max_distance: 0.02, max_angle: 0.0, min_count: 0, ..SurfaceMeshing::default() };
        let mesh = Mesh::from_surface(&saddle, &limits).unwrap();
        assert!(mesh.faces().len() >= 50);
        for [a, b, c] in mesh.triangles() {
            let m = (a.to_vector() + b.to_vector() + c.to_vector()) / 3.0;
            assert!((m.z - m.x * m.y).abs() < 0.02);
        }
    }
}
