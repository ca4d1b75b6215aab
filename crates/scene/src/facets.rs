//! Surfaces as facets, with the lines that are drawn on them.

use katydid_geometry::{
    BoundingBox, Direction, Mesh, MeshFace, NurbsSurface, Point3, Surface, SurfaceCurvature, Vector3,
};

/// A surface ready to be drawn.
#[derive(Debug, Clone)]
pub struct Facets {
    /// Quads between rows of equal parameters, with normals.
    pub mesh: Mesh,
    /// The sides; one that is only a point is left out, and one that is the same as the opposite is there once.
    pub borders: Vec<Vec<Point3>>,
    /// Isocurves at the knots; in the middle where there is no knot inside.
    pub isocurves: Vec<Vec<Point3>>,
    /// What the facets are of; nothing where a program made them.
    nurbs: Option<NurbsSurface>,
    /// The parameters of the rows: vertices of the mesh go through `v` first.
    rows: [Vec<f64>; 2],
    /// Rows between knots, along u and v.
    inner: [usize; 2],
    /// How far the surface strays from the facets along u and v, about.
    bend: [f64; 2],
    /// How far the middle of a facet is from both its diagonals at most: 0 where all are flat.
    twist: f64,
}

/// How a surface lies and bends at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// The unit normal; none at a place that has none.
    pub normal: Option<Vector3>,
    /// The curvature; none at poles and where the surface has a kink.
    pub curvature: Option<SurfaceCurvature>,
}

/// Isocurves of one direction; of more knots than this, some are left out evenly.
const MOST_ISOCURVES: usize = 24;
/// Rows of facets of one direction; spans beyond are left out evenly.
const MOST_ROWS: usize = 400;
/// Rows of one direction where the surface is curved, before it is known how large it is seen.
const FIRST_ROWS: usize = 24;
/// Rows between two knots at most.
const MOST_INNER: usize = 96;

impl Facets {
    /// Some facets of a surface: enough to know how large it is. `None` when it has no NURBS form.
    pub fn new(surface: &Surface) -> Option<Self> {
        let nurbs = surface.to_nurbs().ok()?;
        let inner = Direction::BOTH.map(|d| {
            let spans = nurbs.span_parameters(d).len().saturating_sub(1).max(1);
            if is_curved(&nurbs, d) { even((FIRST_ROWS / spans).clamp(3, FIRST_ROWS)) } else { 1 }
        });
        Self::with_rows(nurbs, inner)
    }

    /// The same surface in facets that stray from it by `distance` at most, and are no more than that needs.
    pub fn within(&self, distance: f64) -> Option<Self> {
        let Some(nurbs) = &self.nurbs else { return Some(self.clone()) };
        if !(distance > 0.0) {
            return None;
        }
        // The distance between a curve and its chords falls with the square of their number.
        let needed = |k: usize| (self.bend[k] / distance).sqrt() * self.inner[k] as f64;
        let wanted = [0, 1].map(|k| if self.inner[k] > 1 { needed(k).max(2.0) } else { 1.0 });
        // A twisted facet is as far from flat as it is long and wide: of long facets there are more side by side
        // first, as near squares are seen best, then more of both.
        let flat = self.twist * (self.inner[0] * self.inner[1]) as f64 / distance;
        let more = |least: f64, most: f64| {
            let least = least.max((flat / most).min(most));
            let share = (flat / (least * most)).sqrt().max(1.0);
            [least * share, most * share]
        };
        let [u, v] = match wanted {
            [u, v] if u <= v => more(u, v),
            [u, v] => {
                let [v, u] = more(v, u);
                [u, v]
            }
        };
        let inner = [u, v].map(|rows| (rows.ceil() as usize).clamp(1, MOST_INNER));
        let inner = [0, 1].map(|k| if self.inner[k] > 1 { even(inner[k]) } else { inner[k] });
        if inner == self.inner { Some(self.clone()) } else { Self::with_rows(nurbs.clone(), inner) }
    }

    fn with_rows(nurbs: NurbsSurface, inner: [usize; 2]) -> Option<Self> {
        let rows_of = |d: Direction, inner| rows(&nurbs.span_parameters(d), is_curved(&nurbs, d), inner);
        let [first, second] = Direction::BOTH;
        let (us, vs) = (rows_of(first, inner[0]), rows_of(second, inner[1]));
        let points = nurbs.points_grid(&us.all, &vs.all);
        let (n, m) = (us.all.len(), vs.all.len());
        let mut faces = Vec::new();
        for i in 1..n {
            for j in 1..m {
                let at = |i: usize, j: usize| u32::try_from(i * m + j).ok();
                faces.push(MeshFace::Quad([at(i - 1, j - 1)?, at(i, j - 1)?, at(i, j)?, at(i - 1, j)?]));
            }
        }
        let row = |i: usize| -> Vec<Point3> { points.get(i * m..(i + 1) * m).unwrap_or(&[]).to_vec() };
        let column = |j: usize| -> Vec<Point3> { points.iter().skip(j).step_by(m).copied().collect() };
        let mut borders = Vec::new();
        let size = BoundingBox::from_points(points.iter().copied())?.diagonal().length();
        for pair in [[row(0), row(n - 1)], [column(0), column(m - 1)]] {
            let [first, last] = pair;
            let same = first.iter().zip(&last).all(|(p, q)| p.distance_to(*q) <= 1e-9 * size);
            let point = |line: &[Point3]| line.windows(2).all(|w| w[0].distance_to(w[1]) <= 1e-9 * size);
            let both = if same { vec![first] } else { vec![first, last] };
            borders.extend(both.into_iter().filter(|line| !point(line)));
        }
        let isocurves = us.drawn.iter().map(|&i| row(i)).chain(vs.drawn.iter().map(|&j| column(j))).collect();
        let bend = [
            (0..m).map(|j| strays(&column(j), inner[0])).fold(0.0, f64::max),
            (0..n).map(|i| strays(&row(i), inner[1])).fold(0.0, f64::max),
        ];
        let twist = twist(&points, n, m);
        let mesh = Mesh::new(points, faces).ok()?.with_normals();
        Some(Self {
            mesh,
            borders,
            isocurves,
            nurbs: Some(nurbs),
            rows: [us.all, vs.all],
            inner,
            bend,
            twist,
        })
    }

    /// Facets that a program made, with the edges between faces.
    pub(crate) fn made(mesh: Mesh, borders: Vec<Vec<Point3>>) -> Self {
        let mesh = if mesh.normals().is_empty() { mesh.with_normals() } else { mesh };
        Self {
            mesh,
            borders,
            isocurves: Vec::new(),
            nurbs: None,
            rows: [Vec::new(), Vec::new()],
            inner: [1, 1],
            bend: [0.0; 2],
            twist: 0.0,
        }
    }

    /// The surface that the facets are of; none where a program made them.
    pub fn nurbs(&self) -> Option<&NurbsSurface> {
        self.nurbs.as_ref()
    }

    /// Whether the facets have the surface with them, so that finer ones can be made.
    pub fn is_exact(&self) -> bool {
        self.nurbs.is_some()
    }

    /// Whether the surface bends in any direction.
    pub fn is_curved(&self) -> bool {
        self.nurbs.as_ref().is_some_and(|nurbs| {
            Direction::BOTH.iter().any(|d| is_curved(nurbs, *d)) || self.twist > 1e-12 * self.size()
        })
    }

    /// The diagonal of the box around the facets.
    pub fn size(&self) -> f64 {
        self.mesh.bounding_box().map_or(0.0, |bounds| bounds.diagonal().length())
    }

    /// How the surface lies and bends at each vertex of the mesh, in their order. Nothing where a program made the
    /// facets.
    pub fn bends(&self) -> Vec<Bend> {
        let Some(nurbs) = &self.nurbs else { return Vec::new() };
        let [us, vs] = &self.rows;
        let at = |u: f64, v: f64| {
            let curvature = nurbs.curvature_at(u, v).ok();
            let normal = curvature.map(|curvature| curvature.normal).or_else(|| nurbs.normal_at(u, v));
            Bend { normal, curvature }
        };
        us.iter().flat_map(|u| vs.iter().map(move |v| at(*u, *v))).collect()
    }
}

fn is_curved(nurbs: &NurbsSurface, d: Direction) -> bool {
    nurbs.degree(d) > 1 || nurbs.is_rational()
}

/// An even number of rows, so that a single span has one in its middle.
fn even(rows: usize) -> usize {
    rows + rows % 2
}

/// How far a curve strays from the chords between points of it at equal steps, about: an eighth of the second
/// difference. Steps change at every `inner`th point.
fn strays(points: &[Point3], inner: usize) -> f64 {
    let difference = |(k, w): (usize, &[Point3])| match w {
        [a, b, c] if inner > 1 && (k + 1) % inner != 0 => (((*a - *b) + (*c - *b)).length()) / 8.0,
        _ => 0.0,
    };
    points.windows(3).enumerate().map(difference).fold(0.0, f64::max)
}

fn twist(points: &[Point3], n: usize, m: usize) -> f64 {
    let mut most = 0.0_f64;
    for i in 1..n {
        for j in 1..m {
            let at = |i: usize, j: usize| points.get(i * m + j).copied();
            if let (Some(a), Some(b), Some(c), Some(d)) =
                (at(i - 1, j - 1), at(i, j - 1), at(i, j), at(i - 1, j))
            {
                most = most.max(((a - b) + (c - d)).length() / 4.0);
            }
        }
    }
    most
}

/// Parameters of rows, and which of them are drawn as isocurves.
struct Rows {
    all: Vec<f64>,
    drawn: Vec<usize>,
}

fn rows(spans: &[f64], curved: bool, inner: usize) -> Rows {
    let count = spans.len().saturating_sub(1).max(1);
    let step = (count * inner).div_ceil(MOST_ROWS).min(count);
    let ends: Vec<f64> = {
        let last = spans.last().copied();
        let mut ends: Vec<f64> = spans.iter().copied().step_by(step).collect();
        if ends.last().copied() != last {
            ends.extend(last);
        }
        ends
    };
    let all = subdivided(&ends, inner);
    let knots = ends.len().saturating_sub(2);
    let drawn = if knots == 0 {
        if curved { vec![all.len() / 2] } else { Vec::new() }
    } else {
        let skip = knots.div_ceil(MOST_ISOCURVES);
        (1..=knots).step_by(skip).map(|k| k * inner).collect()
    };
    Rows { all, drawn }
}

fn subdivided(ends: &[f64], inner: usize) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::with_capacity(ends.len() * inner);
    for w in ends.windows(2) {
        let [a, b] = *w else { continue };
        all.extend((0..inner).map(|k| a + (b - a) * (k as f64 / inner as f64)));
    }
    all.extend(ends.last().copied());
    all
}

#[cfg(test)]
mod tests {
    use katydid_geometry::Sphere;

    use super::*;

    fn ball() -> Facets {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 2.0).unwrap().into();
        Facets::new(&ball).unwrap()
    }

    #[test]
    fn a_sphere_has_a_seam_and_no_other_border() {
        let facets = ball();
        assert_eq!(facets.borders.len(), 1);
        assert!(facets.isocurves.len() >= 4);
        assert!(facets.mesh.vertices().iter().all(|p| (p.distance_to(Point3::ORIGIN) - 2.0).abs() < 1e-9));
        assert_eq!(facets.mesh.normals().len(), facets.mesh.vertices().len());
    }

    #[test]
    fn facets_are_as_fine_as_asked_and_no_finer() {
        let mut last = 0;
        for distance in [0.05, 0.01, 0.002] {
            let mesh = ball().within(distance).unwrap().mesh;
            let middle = |k: usize| {
                let points = mesh.face_points(k).unwrap();
                let sum = points.iter().fold(Point3::ORIGIN, |sum, p| sum + (*p - Point3::ORIGIN));
                (sum - Point3::ORIGIN).length() / points.len() as f64
            };
            let deepest = (0..mesh.faces().len()).map(middle).fold(2.0, f64::min);
            // The middle of a facet lies as deep as the chords along both its directions together.
            assert!(2.0 - deepest <= 2.2 * distance, "{distance}: {deepest}");
            assert!(mesh.faces().len() > last && (mesh.faces().len() as f64) < 40.0 / distance);
            last = mesh.faces().len();
        }
    }

    #[test]
    fn twisted_patches_are_parted_until_their_facets_are_flat() {
        let [a, b, c, d] =
            [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [9.0, 1.0, 4.0], [0.0, 1.0, 0.0]].map(Point3::from);
        let patch: Surface = NurbsSurface::from_corners(a, b, c, d).unwrap().into();
        let coarse = Facets::new(&patch).unwrap();
        assert_eq!((coarse.mesh.faces().len(), coarse.twist), (1, 1.0));
        let fine = coarse.within(0.02).unwrap();
        assert!(fine.twist <= 0.021 && fine.mesh.faces().len() < 100, "{}", fine.mesh.faces().len());
    }

    #[test]
    fn isocurves_are_rows_of_the_facets() {
        let rows_of = |spans: &[f64], curved, inner| {
            let rows = rows(spans, curved, inner);
            (rows.all.len(), rows.drawn)
        };
        assert_eq!(rows_of(&[0.0, 1.0, 2.0], true, 4), (9, vec![4]));
        assert_eq!(rows_of(&[0.0, 1.0], false, 1), (2, vec![]));
    }
}
