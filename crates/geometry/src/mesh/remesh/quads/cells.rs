use std::f64::consts::{FRAC_PI_2, PI};

use super::super::net::Net;
use crate::cancellation::check;
use crate::{Point3, Result};

/// Vertices whose lattice points are nearer than this part of a side share one.
const SAME: f64 = 0.5;

/// Makes one vertex of those that share a lattice point, the nearest first, where the surface stays what it is. `at`
/// has the lattice point of each vertex, and then the mean of those that became one; `sides` are those of the cells.
pub(super) fn gather(net: &mut Net, at: &mut [Point3], sides: &[f64]) -> Result<()> {
    let mut members = vec![1.0; at.len()];
    // Distances in parts of the side there.
    let apart = |at: &[Point3], a: u32, b: u32| {
        let (a, b) = (a as usize, b as usize);
        at[a].distance_to(at[b]) / (0.5 * (sides[a] + sides[b]))
    };
    loop {
        let mut near: Vec<(f64, [u32; 2])> = net
            .edges()
            .into_iter()
            .map(|[a, b]| (apart(at, a, b), [a, b]))
            .filter(|(distance, _)| *distance < SAME)
            .collect();
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut changed = false;
        for (_, [a, b]) in near {
            check()?;
            // What has become one since then may have moved away.
            if apart(at, a, b) >= SAME {
                continue;
            }
            let Some([stays, goes]) = net.merge(a, b) else { continue };
            let (s, g) = (stays as usize, goes as usize);
            let all = members[s] + members[g];
            // A vertex on an edge that stays does not leave it.
            if net.kept_neighbours(stays).is_empty() {
                at[s] = at[s].lerp(at[g], members[g] / all);
            }
            members[s] = all;
            changed = true;
        }
        if !changed {
            return Ok(());
        }
    }
}

/// The faces of the net, two triangles along a diagonal as one quad: those that are the most square first.
pub(super) fn quads(net: &Net, at: &[Point3]) -> Vec<Vec<u32>> {
    let mut pairs: Vec<(f64, [u32; 2], [u32; 4])> = Vec::new();
    for [a, b] in net.edges() {
        if net.is_kept(a, b) {
            continue;
        }
        let &[f, g] = net.sides(a, b).as_slice() else { continue };
        let Some(corners) = net.joined(f, g, [a, b]) else { continue };
        let value = squareness(corners.map(|i| at[i as usize]));
        if value > 0.0 {
            pairs.push((value, [f, g], corners));
        }
    }
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut taken = std::collections::HashSet::new();
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for (_, [f, g], corners) in pairs {
        if taken.contains(&f) || taken.contains(&g) {
            continue;
        }
        taken.extend([f, g]);
        faces.push(corners.to_vec());
    }
    faces.extend(net.triangles().filter(|(f, _)| !taken.contains(f)).map(|(_, t)| t.to_vec()));
    faces
}

/// 1 for a square or rectangle, 0 where a corner is straight or folded (J.-F. Remacle and others, *Blossom-Quad*, 2012).
fn squareness(corners: [Point3; 4]) -> f64 {
    let worst = (0..4).map(|k| {
        let [p, next, last] = [corners[k], corners[(k + 1) % 4], corners[(k + 3) % 4]];
        (next - p).angle_to(last - p).map_or(PI, |angle| (FRAC_PI_2 - angle).abs())
    });
    1.0 - worst.fold(0.0, f64::max) / FRAC_PI_2
}
