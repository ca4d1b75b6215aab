//! Where two meshes meet.

use std::collections::{HashMap, HashSet};
use std::ops::ControlFlow;

use crate::box_tree::{Bounds, BoxTree, bounds_of, boxes_meet};
use crate::mesh::{MeshTree, align_points};
use crate::{Error, Line, Point3, Result, Vector3, cancellation};

/// A corner this near to the other triangle's plane, as a part of the meshes' size, lies in it: it cannot be told from
/// one that does.
const IN_PLANE: f64 = 1e-12;

/// The segments along which the faces of two meshes meet, one for each pair of triangles that do, in no order: two
/// pairs may give the same one. Faces that lie in one plane give none; where they overlap, the faces around them tell
/// the outline. Finds every pair of triangles whose meeting is longer than rounding (about 10⁻¹² of the size).
///
/// # Method
/// Pairs by two trees of boxes; a pair by the intervals that both triangles cut from the common line of their planes
/// (T. Möller, *A fast triangle-triangle intersection test*, J. Graphics Tools 2, 1997). The ends are computed from an
/// edge of one and the plane of the other alone, so that neighbours along an edge get the same point.
pub fn mesh_mesh_segments(a: &MeshTree, b: &MeshTree) -> Vec<Line> {
    let size = |t: &MeshTree| t.size();
    let snap = IN_PLANE * size(a).max(size(b));
    let mut out = Vec::new();
    a.boxes().visit_pairs(b.boxes(), snap, |i, j| {
        if let (Some((p, _)), Some((q, _))) = (a.triangle(i), b.triangle(j)) {
            out.extend(triangle_triangle(p, q, snap));
        }
        ControlFlow::Continue(())
    });
    out
}

/// The curves along which two meshes meet, as polylines: a closed one ends with its first point. Curves that meet in
/// a point end there.
///
/// The segments of [`mesh_mesh_segments`] are joined where their ends come within `tolerance` of each other, and cut
/// where others end on them; what is there twice counts once, and what is shorter than the tolerance is lost.
///
/// # Errors
/// The tolerance is negative or not finite.
pub fn mesh_mesh(a: &MeshTree, b: &MeshTree, tolerance: f64) -> Result<Vec<Vec<Point3>>> {
    if !(tolerance >= 0.0 && tolerance.is_finite()) {
        return Err(Error::OutOfRange {
            what: "tolerance",
            value: tolerance,
            must: "finite and not negative",
        });
    }
    let segments = mesh_mesh_segments(a, b);
    cancellation::check_now()?;
    chained(&segments, tolerance)
}

/// The common segment of two triangles; `None` when they do not meet, meet in a point, or lie in one plane.
fn triangle_triangle(p: &[Point3; 3], q: &[Point3; 3], snap: f64) -> Option<Line> {
    let normal = |[a, b, c]: &[Point3; 3]| (*b - *a).cross(*c - *a).unitized();
    let (n, m) = (normal(p)?, normal(q)?);
    let heights = |t: &[Point3; 3], o: Point3, n: Vector3| {
        t.map(|x| {
            let h = n.dot(x - o);
            if h.abs() <= snap { 0.0 } else { h }
        })
    };
    let across = cut(p, heights(p, q[0], m))?;
    let over = cut(q, heights(q, p[0], n))?;
    let along = n.cross(m).unitized()?;
    let place = |x: Point3| along.dot(x - p[0]);
    let sorted = |[x, y]: [Point3; 2]| if place(x) <= place(y) { [x, y] } else { [y, x] };
    let ([a, b], [c, d]) = (sorted(across), sorted(over));
    let from = if place(a) >= place(c) { a } else { c };
    let to = if place(b) <= place(d) { b } else { d };
    (place(to) - place(from) > snap).then(|| Line::new(from, to))
}

/// Where a triangle meets a plane, from the heights of its corners over it.
fn cut(t: &[Point3; 3], h: [f64; 3]) -> Option<[Point3; 2]> {
    let mut found = [None, None];
    let mut add = |x: Point3| {
        if let Some(slot) = found.iter_mut().find(|s| s.is_none()) {
            *slot = Some(x);
        }
    };
    if h == [0.0; 3] {
        return None;
    }
    for k in 0..3 {
        if h[k] == 0.0 {
            add(t[k]);
        }
    }
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        if h[i] * h[j] < 0.0 {
            // From the corner above, whichever way the triangle walks the edge.
            let (i, j) = if h[i] > 0.0 { (i, j) } else { (j, i) };
            add(t[i].lerp(t[j], h[i] / (h[i] - h[j])));
        }
    }
    Some([found[0]?, found[1]?])
}

/// Segments joined to polylines.
fn chained(segments: &[Line], tolerance: f64) -> Result<Vec<Vec<Point3>>> {
    let mut ends: Vec<Point3> = segments.iter().flat_map(|l| [l.from, l.to]).collect();
    align_points(&mut ends, tolerance)?;
    let mut numbers: HashMap<[u64; 3], usize> = HashMap::new();
    let mut points: Vec<Point3> = Vec::new();
    let mut number = |p: &Point3| {
        let key = [p.x + 0.0, p.y + 0.0, p.z + 0.0].map(f64::to_bits);
        *numbers.entry(key).or_insert_with(|| {
            points.push(*p);
            points.len() - 1
        })
    };
    let mut pairs: Vec<[usize; 2]> = Vec::new();
    let mut seen = HashSet::new();
    for pair in ends.chunks_exact(2) {
        if let [a, b] = pair {
            let (i, j) = (number(a), number(b));
            if i != j && seen.insert([i.min(j), i.max(j)]) {
                pairs.push([i, j]);
            }
        }
    }
    Ok(walked(&points, &split(&points, pairs, tolerance)?))
}

/// Cuts each segment at the points that lie on it, so that stretches which overlap become equal and are there once.
fn split(points: &[Point3], pairs: Vec<[usize; 2]>, tolerance: f64) -> Result<Vec<[usize; 2]>> {
    let at = |i: usize| points.get(i).copied().unwrap_or_default();
    let boxes: Vec<Bounds> = points.iter().map(|p| bounds_of([<[f64; 3]>::from(*p)])).collect();
    let tree = BoxTree::by_place(&boxes);
    let mut seen = HashSet::new();
    let mut out = Vec::with_capacity(pairs.len());
    for [i, j] in pairs {
        cancellation::check()?;
        let (a, b) = (at(i), at(j));
        let reach = bounds_of([a, b].map(<[f64; 3]>::from));
        let (along, length) = (b - a, (b - a).length());
        let mut stops = vec![(0.0, i), (1.0, j)];
        tree.visit_where(
            |bounds| boxes_meet(bounds, &reach, tolerance),
            |k| {
                let t = (at(k) - a).dot(along) / (length * length);
                let off = (a + along * t).distance_to(at(k));
                if k != i && k != j && t > 0.0 && t < 1.0 && off <= tolerance {
                    stops.push((t, k));
                }
                ControlFlow::Continue(())
            },
        );
        stops.sort_by(|x, y| x.0.total_cmp(&y.0));
        for (from, to) in stops.iter().zip(stops.iter().skip(1)) {
            let (k, l) = (from.1, to.1);
            if seen.insert([k.min(l), k.max(l)]) {
                out.push([k, l]);
            }
        }
    }
    Ok(out)
}

/// The polylines through points joined by segments: first those between ends and crossings, then the closed ones.
fn walked(points: &[Point3], pairs: &[[usize; 2]]) -> Vec<Vec<Point3>> {
    let mut ways: Vec<Vec<usize>> = vec![Vec::new(); points.len()];
    for (s, pair) in pairs.iter().enumerate() {
        for &end in pair {
            if let Some(list) = ways.get_mut(end) {
                list.push(s);
            }
        }
    }
    let degree = |i: usize| ways.get(i).map_or(0, Vec::len);
    let mut used = vec![false; pairs.len()];
    let mut out = Vec::new();
    let walk = |first: usize, used: &mut Vec<bool>| {
        let mut here = first;
        let mut line = vec![points.get(first).copied().unwrap_or_default()];
        loop {
            let free = |s: &&usize| used.get(**s).is_some_and(|u| !*u);
            let Some(&s) = ways.get(here).and_then(|w| w.iter().find(free)) else { break };
            if let Some(slot) = used.get_mut(s) {
                *slot = true;
            }
            let Some(&[i, j]) = pairs.get(s) else { break };
            here = if i == here { j } else { i };
            line.push(points.get(here).copied().unwrap_or_default());
            if degree(here) != 2 || here == first {
                break;
            }
        }
        line
    };
    for first in (0..points.len()).filter(|&i| degree(i) != 2) {
        for _ in 0..degree(first) {
            let line = walk(first, &mut used);
            if line.len() > 1 {
                out.push(line);
            }
        }
    }
    for first in 0..points.len() {
        let line = walk(first, &mut used);
        if line.len() > 1 {
            out.push(line);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{mesh_mesh, mesh_mesh_segments};
    use crate::mesh::MeshTree;
    use crate::{Box3, Interval, Mesh, Plane, Point3, Vector3};

    fn cube(at: [f64; 3], n: usize) -> MeshTree {
        let [x, y, z] = at.map(|c| Interval::new(c, c + 2.0));
        MeshTree::new(&Mesh::cuboid(&Box3 { plane: Plane::XY, x, y, z }, n, n, n).unwrap())
    }

    fn length(line: &[Point3]) -> f64 {
        line.windows(2).map(|w| w[0].distance_to(w[1])).sum()
    }

    fn closed(line: &[Point3]) -> bool {
        line.len() > 3 && line.first() == line.last()
    }

    #[test]
    fn corners_through_each_other() {
        for n in 1..6 {
            let lines = mesh_mesh(&cube([0.0; 3], n), &cube([1.0; 3], n + 1), 1e-6).unwrap();
            assert_eq!(lines.len(), 1, "{n}");
            assert!(closed(&lines[0]));
            assert!((length(&lines[0]) - 6.0).abs() < 1e-9);
        }
    }

    #[test]
    fn faces_in_one_plane_and_edges_in_faces() {
        // One stands on the other, shifted: the outline of the overlap.
        let lines = mesh_mesh(&cube([0.0; 3], 3), &cube([0.5, 0.5, 2.0], 2), 1e-6).unwrap();
        let total: f64 = lines.iter().map(|l| length(l)).sum();
        assert!((total - 6.0).abs() < 1e-9, "{total}");
        // Exactly on top of each other: the common square, once.
        let lines = mesh_mesh(&cube([0.0; 3], 3), &cube([0.0, 0.0, 2.0], 2), 1e-6).unwrap();
        assert_eq!(lines.len(), 1);
        assert!((length(&lines[0]) - 8.0).abs() < 1e-9 && closed(&lines[0]));
        assert!(mesh_mesh(&cube([0.0; 3], 3), &cube([5.0; 3], 2), 1e-6).unwrap().is_empty());
        assert!(mesh_mesh(&cube([0.0; 3], 3), &MeshTree::new(&Mesh::default()), 1e-6).unwrap().is_empty());
        assert!(mesh_mesh(&cube([0.0; 3], 3), &cube([1.0; 3], 2), f64::NAN).is_err());
    }

    #[test]
    fn two_balls() {
        let ball = |x: f64, r: f64| {
            let axis = Vector3::new(0.3, 0.5, 1.0);
            let plane = Plane::from_normal(Point3::new(x, 0.1, 0.2), axis).unwrap();
            MeshTree::new(&Mesh::sphere(&plane, r, 40, 30).unwrap())
        };
        let lines = mesh_mesh(&ball(0.0, 1.0), &ball(1.2, 0.9), 1e-9).unwrap();
        assert_eq!(lines.len(), 1);
        assert!(closed(&lines[0]));
        // The circle of two round balls, within the error of the facets.
        let x = (1.0 - 0.81 + 1.44) / 2.4;
        let round = 2.0 * std::f64::consts::PI * f64::sqrt(1.0 - x * x);
        assert!((length(&lines[0]) - round).abs() < 0.02 * round);
        // A bar through a ball: two rings.
        let bar = Interval::new(-0.2, 0.2);
        let bar = Box3 { plane: Plane::XY, x: Interval::new(-3.0, 3.0), y: bar, z: bar };
        let bar = MeshTree::new(&Mesh::cuboid(&bar, 5, 2, 2).unwrap());
        let lines = mesh_mesh(&ball(0.0, 1.0), &bar, 1e-9).unwrap();
        assert_eq!(lines.len(), 2);
        assert!(lines.iter().all(|l| closed(l)));
        assert!(mesh_mesh_segments(&ball(0.0, 1.0), &bar).len() >= lines.iter().map(|l| l.len() - 1).sum());
    }
}
