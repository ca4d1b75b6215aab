//! The same faces with fewer triangles: points in one cell of a grid become one (Rossignac and Borrel, "Multi-resolution
//! 3D approximations for rendering complex scenes", 1993). Coarse and quick: a million triangles in some hundredths of
//! a second.

use katydid_geometry::{BoundingBox, Point3, Vector3};

use super::faces::Faces;

/// The cells along the longest side at most.
const MOST_CELLS: f64 = 160.0;
/// The cells along the longest side at least: a box keeps its corners.
const LEAST_CELLS: f64 = 2.0;
/// How often the grid is made coarser.
const ROUNDS: u32 = 8;
const NONE: u32 = u32::MAX;

/// No more than `most` triangles; nothing when no grid does it.
pub(super) fn reduced(faces: &Faces, most: usize) -> Option<Faces> {
    if faces.triangles.len() <= most {
        return Some(faces.clone());
    }
    let bounds = BoundingBox::from_points(faces.points.iter().copied())?;
    // A closed surface meets about six cells a square of cells along its side, with two triangles each.
    let mut cells = (most as f64 / 6.0).sqrt().clamp(LEAST_CELLS, MOST_CELLS);
    for _ in 0..ROUNDS {
        let fewer = clustered(faces, &bounds, cells);
        if fewer.triangles.len() <= most {
            return (!fewer.triangles.is_empty()).then_some(fewer);
        }
        if cells <= LEAST_CELLS {
            return None;
        }
        cells = (0.75 * cells).max(LEAST_CELLS);
    }
    None
}

fn clustered(faces: &Faces, bounds: &BoundingBox, cells: f64) -> Faces {
    let size = bounds.diagonal();
    let side = size.x.max(size.y).max(size.z).max(f64::MIN_POSITIVE) / cells;
    let count = [size.x, size.y, size.z].map(|length| (length / side).floor().clamp(0.0, cells) as usize + 1);
    let mut cell_of = vec![NONE; count.iter().product()];
    let mut kept: Vec<u32> = Vec::with_capacity(faces.points.len());
    let mut sums: Vec<(Vector3, Vector3, f64, usize)> = Vec::new();
    let origin = bounds.min;
    for (k, point) in faces.points.iter().enumerate() {
        let away = *point - origin;
        let step = |x: f64, n: usize| ((x / side) as usize).min(n - 1);
        let [i, j, l] = [step(away.x, count[0]), step(away.y, count[1]), step(away.z, count[2])];
        let Some(cell) = cell_of.get_mut((l * count[1] + j) * count[0] + i) else { continue };
        if *cell == NONE {
            *cell = sums.len() as u32;
            sums.push((Vector3::ZERO, Vector3::ZERO, 0.0, k));
        }
        kept.push(*cell);
        if let Some((place, normal, number, _)) = sums.get_mut(*cell as usize) {
            *place += away;
            *number += 1.0;
            if let Some(n) = faces.normals.get(k) {
                *normal += Vector3::new(f64::from(n[0]), f64::from(n[1]), f64::from(n[2]));
            }
        }
    }
    let at = |i: u32| kept.get(i as usize).copied();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for [a, b, c] in &faces.triangles {
        if let (Some(a), Some(b), Some(c)) = (at(*a), at(*b), at(*c))
            && a != b
            && b != c
            && c != a
        {
            // The least first, so that the same triangle is found again.
            triangles.push(match a.min(b).min(c) {
                least if least == a => [a, b, c],
                least if least == b => [b, c, a],
                _ => [c, a, b],
            });
        }
    }
    triangles.sort_unstable();
    triangles.dedup();
    let has_normals = !faces.normals.is_empty();
    Faces {
        points: sums
            .iter()
            .map(|(place, _, number, _)| origin + *place * (1.0 / number))
            .collect::<Vec<Point3>>(),
        normals: sums
            .iter()
            .filter(|_| has_normals)
            .map(|(_, normal, ..)| {
                normal.unitized().map_or([0.0, 0.0, 1.0], |n| [n.x as f32, n.y as f32, n.z as f32])
            })
            .collect(),
        colours: sums.iter().filter_map(|(.., first)| faces.colours.get(*first).copied()).collect(),
        gaussian: sums.iter().filter_map(|(.., first)| faces.gaussian.get(*first).copied()).collect(),
        mean: sums.iter().filter_map(|(.., first)| faces.mean.get(*first).copied()).collect(),
        triangles,
        edges: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use katydid_geometry::{Mesh, Plane};

    use super::*;

    #[test]
    fn a_ball_of_fewer_triangles_is_still_a_ball() {
        let ball = Mesh::sphere(&Plane::XY, 10.0, 300, 150).unwrap();
        let faces = Faces::of_mesh(&ball);
        for most in [20_000, 2000, 200] {
            let fewer = reduced(&faces, most).unwrap();
            assert!(fewer.triangles.len() <= most && fewer.triangles.len() * 12 > most, "{most}");
            assert_eq!(fewer.normals.len(), fewer.points.len());
            // A mean of points of the ball lies inside, by no more than a cell's diagonal.
            for (p, n) in fewer.points.iter().zip(&fewer.normals) {
                let r = p.distance_to(Point3::ORIGIN);
                assert!(r <= 10.0 + 1e-9 && r > 10.0 - 40.0 / (most as f64 / 6.0).sqrt(), "{most}: {r}");
                let out = (*p - Point3::ORIGIN).unitized().unwrap();
                assert!(out.x * f64::from(n[0]) + out.y * f64::from(n[1]) + out.z * f64::from(n[2]) > 0.8);
            }
        }
        assert!(reduced(&faces, 0).is_none());
    }
}
