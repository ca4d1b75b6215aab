//! Faces inside a closed polyline that need not be flat.

use crate::{Brep, Error, Point3, Result, Tolerance};

/// The most corners: the work grows with their third power.
const MOST: usize = 400;

/// Flat faces that fill a closed polyline: the triangles between its corners whose areas together are least (G.
/// Barequet and M. Sharir, *Filling gaps in the boundary of a polyhedron*, 1995), those in one plane made one face. A
/// flat polyline gives one face. The last point may repeat the first.
///
/// # Errors
/// Fewer than three corners or more than 400, corners that coincide or lie on one line.
pub fn fragment_patch(corners: &[Point3], tolerance: &Tolerance) -> Result<Brep> {
    let limit = tolerance.positive_distance()?;
    if !corners.iter().all(|p| p.is_finite()) {
        return Err(Error::NotFinite("corner of the patch"));
    }
    let mut points: Vec<Point3> = Vec::with_capacity(corners.len());
    for p in corners {
        if points.last().is_none_or(|q| q.distance_to(*p) > limit) {
            points.push(*p);
        }
    }
    while points.len() > 1
        && points.first().zip(points.last()).is_some_and(|(a, b)| a.distance_to(*b) <= limit)
    {
        points.pop();
    }
    if points.len() < 3 || points.len() > MOST {
        return Err(Error::Invalid {
            what: "boundary of the patch",
            why: format!("it must have from 3 to {MOST} corners, got {}", points.len()),
        });
    }
    let mut faces = Vec::with_capacity(points.len() - 2);
    for [a, b, c] in triangles(&points) {
        let [a, b, c] = [points[a], points[b], points[c]];
        let longest = a.distance_to(b).max(b.distance_to(c)).max(c.distance_to(a));
        if (b - a).cross(c - a).length() <= limit * longest {
            continue;
        }
        let frame = crate::PolylineCurve::new(vec![a, b, c, a])?;
        faces.extend(Brep::planar_faces(&[frame.into()], tolerance)?.breps);
    }
    if faces.is_empty() {
        return Err(Error::degenerate("patch", "its corners lie on one line"));
    }
    let joined = Brep::join(&faces, tolerance)?.breps;
    match joined.as_slice() {
        [one] => one.with_coplanar_faces_merged(tolerance),
        _ => Err(Error::degenerate("patch", "its faces do not hang together")),
    }
}

/// The triangulation of least area, by the best triangle over every stretch of the boundary.
fn triangles(points: &[Point3]) -> Vec<[usize; 3]> {
    let n = points.len();
    let area = |a: usize, b: usize, c: usize| (points[b] - points[a]).cross(points[c] - points[a]).length();
    let mut least = vec![0.0_f64; n * n];
    let mut apex = vec![0_usize; n * n];
    for span in 2..n {
        for a in 0..n - span {
            let c = a + span;
            let mut best = (f64::INFINITY, a + 1);
            for b in a + 1..c {
                let sum = least[a * n + b] + least[b * n + c] + area(a, b, c);
                if sum < best.0 {
                    best = (sum, b);
                }
            }
            (least[a * n + c], apex[a * n + c]) = best;
        }
    }
    let (mut out, mut stack) = (Vec::with_capacity(n - 2), vec![(0, n - 1)]);
    while let Some((a, c)) = stack.pop() {
        if c - a < 2 {
            continue;
        }
        let b = apex[a * n + c];
        out.push([a, b, c]);
        stack.extend([(a, b), (b, c)]);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MeshSettings;

    fn patch(corners: &[[f64; 3]]) -> Result<Brep> {
        let corners: Vec<Point3> = corners.iter().map(|p| Point3::from(*p)).collect();
        fragment_patch(&corners, &Tolerance { absolute: 1e-6, ..Tolerance::default() })
    }

    fn area(brep: &Brep) -> f64 {
        brep.mesh(&MeshSettings::default()).unwrap().to_mesh().unwrap().area()
    }

    #[test]
    fn flat_and_bent_frames() {
        // An L, which turns in once.
        let flat = [
            [0.0, 0.0, 0.0],
            [3.0, 0.0, 0.0],
            [3.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, 4.0, 0.0],
            [0.0, 4.0, 0.0],
        ];
        let flat = patch(&flat).unwrap();
        assert_eq!((flat.faces().len(), flat.faults().len()), (1, 0));
        assert!((area(&flat) - 6.0).abs() < 1e-12);
        let bent =
            patch(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, 0.0]])
                .unwrap();
        assert_eq!((bent.faces().len(), bent.edges().len(), bent.faults().len()), (2, 5, 0));
    }

    #[test]
    fn frames_that_are_none() {
        assert!(patch(&[[0.0; 3], [1.0, 0.0, 0.0]]).is_err());
        assert!(patch(&[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]]).is_err());
        assert!(patch(&[[0.0; 3], [f64::NAN, 0.0, 0.0], [2.0, 1.0, 0.0]]).is_err());
    }
}
