//! Cells as mesh faces: quads, and triangles where neighbours are finer or sides are points.

use super::fill::Vertex;
use crate::meshing::thresholds::SLIVER;
use crate::{MeshFace, Point2};

/// Adds the polygon around a cell, which bulges nowhere inwards, to a mesh: as it is with up to four corners, else cut
/// into triangles of the best shape one by one.
pub(super) fn cut_corners(vertices: &[Vertex], scale: [f64; 2], round: &[u32], faces: &mut Vec<MeshFace>) {
    let place = |v: u32| vertices.get(v as usize).map_or(Point2::new(0.0, 0.0), |v| v.uv);
    let id = |v: u32| vertices.get(v as usize).and_then(|v| v.id);
    let same = |a: u32, b: u32| a == b || (id(a).is_some() && id(a) == id(b));
    if let [a, b, c, d] = *round
        && ![(a, b), (b, c), (c, d), (d, a), (a, c), (b, d)].iter().any(|&(x, y)| same(x, y))
    {
        faces.push(MeshFace::Quad([a, b, c, d]));
        return;
    }
    // Neighbours that are one point in space are one corner, which is anywhere between them.
    let mut left: Vec<[u32; 2]> = Vec::with_capacity(round.len());
    for &v in round {
        match left.last_mut() {
            Some(last) if same(last[1], v) => last[1] = v,
            _ => left.push([v, v]),
        }
    }
    if let (Some(&first), Some(&last)) = (left.first(), left.last())
        && left.len() > 1
        && same(first[0], last[1])
    {
        left.remove(0);
        if let Some(slot) = left.last_mut() {
            slot[1] = first[1];
        }
    }
    let shape = |a: u32, b: u32, c: u32| {
        let [a, b, c] = [a, b, c].map(|v| {
            let p = place(v);
            [p.x * scale[0], p.y * scale[1]]
        });
        let (x, y) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let z = [c[0] - b[0], c[1] - b[1]];
        let longest = [x, y, z].iter().map(|s| s[0] * s[0] + s[1] * s[1]).fold(0.0, f64::max);
        (x[0] * y[1] - x[1] * y[0], longest)
    };
    // The least area, wherever the corners are.
    let doubled = |a: [u32; 2], b: [u32; 2], c: [u32; 2]| {
        let mut least = (f64::INFINITY, 0.0);
        for k in 0..8 {
            let found = shape(a[k & 1], b[k >> 1 & 1], c[k >> 2]);
            if found.0 < least.0 {
                least = found;
            }
        }
        least
    };
    if let [[a, _], [b, _], [c, _]] = *left {
        faces.push(MeshFace::Triangle([a, b, c]));
        return;
    }
    while left.len() >= 3 {
        let n = left.len();
        let whole: f64 = (1..n - 1).map(|k| doubled(left[0], left[k], left[k + 1]).0).sum();
        let mut best = (f64::NEG_INFINITY, 0);
        for k in 0..n {
            let (a, b, c) = (left[(k + n - 1) % n], left[k], left[(k + 1) % n]);
            let (area, longest) = doubled(a, b, c);
            // What is left must have an area too.
            let sound = area > SLIVER * whole && (n == 3 || whole - area > SLIVER * whole);
            let worth = if sound && longest > 0.0 { area / longest } else { -1.0 };
            if worth > best.0 {
                best = (worth, k);
            }
        }
        let k = best.1;
        let (a, b, c) = (left[(k + n - 1) % n], left[k], left[(k + 1) % n]);
        if !(same(a[0], b[0]) || same(b[0], c[0]) || same(c[0], a[0])) {
            faces.push(MeshFace::Triangle([a[0], b[0], c[0]]));
        }
        left.remove(k);
    }
}
