//! Surfaces as facets, with the lines that are drawn on them.

use katydid_geometry::{Direction, Mesh, MeshFace, Point3, Surface};

/// A surface ready to be drawn.
#[derive(Debug, Clone)]
pub(crate) struct Facets {
    /// Quads between rows of equal parameters, with normals.
    pub(crate) mesh: Mesh,
    /// The sides; one that is only a point is left out, and one that is the same as the opposite is there once.
    pub(crate) borders: Vec<Vec<Point3>>,
    /// Isocurves at the knots; in the middle where there is no knot inside.
    pub(crate) isocurves: Vec<Vec<Point3>>,
}

/// Isocurves of one direction; of more knots than this, some are left out evenly.
const MOST_ISOCURVES: usize = 24;
/// Rows of facets of one direction; spans beyond are left out evenly.
const MOST_ROWS: usize = 400;

impl Facets {
    /// The facets of a surface, about `fineness` rows where it is curved. `None` when it has no NURBS form.
    pub(crate) fn new(surface: &Surface, fineness: usize) -> Option<Self> {
        let nurbs = surface.to_nurbs().ok()?;
        let [us, vs] = Direction::BOTH
            .map(|d| rows(&nurbs.span_parameters(d), nurbs.degree(d) > 1 || nurbs.is_rational(), fineness));
        // A twisted patch is straight along its isocurves and curved between them.
        let twisted = [&us, &vs].iter().all(|rows| rows.0.len() == 2);
        let refine = |rows: Rows| if twisted { Rows(subdivided(&rows.0, 12), rows.1) } else { rows };
        let (us, vs) = (refine(us), refine(vs));
        let points = nurbs.points_grid(&us.0, &vs.0);
        let (n, m) = (us.0.len(), vs.0.len());
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
        for pair in [[row(0), row(n - 1)], [column(0), column(m - 1)]] {
            let size =
                katydid_geometry::BoundingBox::from_points(points.iter().copied())?.diagonal().length();
            let [first, last] = pair;
            let same = first.iter().zip(&last).all(|(p, q)| p.distance_to(*q) <= 1e-9 * size);
            let point = |line: &[Point3]| line.windows(2).all(|w| w[0].distance_to(w[1]) <= 1e-9 * size);
            let both = if same { vec![first] } else { vec![first, last] };
            borders.extend(both.into_iter().filter(|line| !point(line)));
        }
        let isocurves = us.1.iter().map(|&i| row(i)).chain(vs.1.iter().map(|&j| column(j))).collect();
        let mesh = Mesh::new(points, faces).ok()?.with_normals();
        Some(Self { mesh, borders, isocurves })
    }
}

/// Parameters of rows, and which of them are drawn as isocurves.
struct Rows(Vec<f64>, Vec<usize>);

fn rows(spans: &[f64], curved: bool, fineness: usize) -> Rows {
    let count = spans.len().saturating_sub(1).max(1);
    let inner = if curved { (fineness / count).clamp(3, fineness.max(3)) } else { 1 };
    let step = (count * inner).div_ceil(MOST_ROWS).min(count);
    let ends: Vec<f64> = {
        let last = spans.last().copied();
        let mut ends: Vec<f64> = spans.iter().copied().step_by(step).collect();
        if ends.last().copied() != last {
            ends.extend(last);
        }
        ends
    };
    // An even number, so that a single span has a row in its middle.
    let inner = if curved { inner + inner % 2 } else { 1 };
    let all = subdivided(&ends, inner);
    let knots = ends.len().saturating_sub(2);
    let drawn = if knots == 0 {
        if curved { vec![all.len() / 2] } else { Vec::new() }
    } else {
        let skip = knots.div_ceil(MOST_ISOCURVES);
        (1..=knots).step_by(skip).map(|k| k * inner).collect()
    };
    Rows(all, drawn)
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

    #[test]
    fn a_sphere_has_a_seam_and_no_other_border() {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 2.0).unwrap().into();
        let facets = Facets::new(&ball, 24).unwrap();
        assert_eq!(facets.borders.len(), 1);
        assert!(facets.isocurves.len() >= 4);
        assert!(facets.mesh.vertices().iter().all(|p| (p.distance_to(Point3::ORIGIN) - 2.0).abs() < 1e-9));
        assert_eq!(facets.mesh.normals().len(), facets.mesh.vertices().len());
    }

    #[test]
    fn isocurves_are_rows_of_the_facets() {
        let Rows(all, drawn) = rows(&[0.0, 1.0, 2.0], true, 8);
        assert_eq!((all.len(), drawn), (9, vec![4]));
        let Rows(all, drawn) = rows(&[0.0, 1.0], false, 8);
        assert_eq!((all.len(), drawn.len()), (2, 0));
    }
}
