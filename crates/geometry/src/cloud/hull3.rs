use std::collections::VecDeque;

use super::check_points3;
use crate::{Error, Point3, Result, Vector3};

/// A triangle of the hull as it grows.
#[derive(Debug, Default)]
struct Facet {
    corners: [u32; 3],
    /// The facets across the sides; side k goes from corner k to the next.
    across: [u32; 3],
    /// The plane: an area vector, and its product with a corner.
    normal: Vector3,
    offset: f64,
    /// Points above this facet that no other facet keeps.
    above: Vec<u32>,
    /// The farthest of them, with its height in units of the normal.
    top: Option<(f64, u32)>,
    gone: bool,
}

/// The convex hull of points in space as triangles, counter-clockwise seen from outside, by the indices of their
/// corners. Facets with more than three corners are cut into triangles; points on them or on edges need not be corners.
///
/// Quickhull (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, *The quickhull algorithm for convex hulls*, 1996); which side of
/// a facet a point lies on is decided exactly, so that the hull is convex and closed whatever the input.
///
/// # Errors
/// A coordinate is not finite or beyond 3.2e60, or all points lie in one plane: `Degenerate`.
pub fn convex_hull_3d(points: &[Point3]) -> Result<Vec<[u32; 3]>> {
    check_points3(points)?;
    let size = points.iter().flat_map(|p| [p.x.abs(), p.y.abs(), p.z.abs()]).fold(0.0, f64::max);
    // Areas are at most 24 and heights over them 100 times a power of the size; each step rounds by half an epsilon.
    let doubt = 1000.0 * f64::EPSILON * size * size * size;
    let mut hull = Hull { points, facets: Vec::new(), doubt };
    hull.start()?;
    let mut todo: VecDeque<u32> = (0..4).collect();
    let mut start_at = vec![u32::MAX; points.len()];
    let mut end_at = vec![u32::MAX; points.len()];
    while let Some(f) = todo.pop_front() {
        let Some(top) = hull.farthest(f) else { continue };
        let (seen, horizon) = hull.seen_from(f, top);
        let first = hull.facets.len() as u32;
        for (k, &(a, b, beyond)) in (first..).zip(&horizon) {
            let facet = hull.facet([a, b, top], [beyond, u32::MAX, u32::MAX]);
            hull.facets.push(facet);
            start_at[a as usize] = k;
            end_at[b as usize] = k;
            let other = &mut hull.facets[beyond as usize];
            for side in 0..3 {
                if other.corners[side] == b && other.corners[(side + 1) % 3] == a {
                    other.across[side] = k;
                }
            }
        }
        for (k, &(a, b, _)) in (first..).zip(&horizon) {
            let facet = &mut hull.facets[k as usize];
            (facet.across[1], facet.across[2]) = (start_at[b as usize], end_at[a as usize]);
        }
        let orphans: Vec<u32> = seen
            .iter()
            .flat_map(|&g| {
                let facet = &mut hull.facets[g as usize];
                facet.gone = true;
                std::mem::take(&mut facet.above)
            })
            .collect();
        hull.hand_out(orphans.into_iter().filter(|&p| p != top), first);
        todo.extend(first..hull.facets.len() as u32);
    }
    Ok(hull.facets.into_iter().filter(|f| !f.gone).map(|f| f.corners).collect())
}

struct Hull<'a> {
    points: &'a [Point3],
    facets: Vec<Facet>,
    /// Heights nearer to 0 than this are found exactly.
    doubt: f64,
}

impl Hull<'_> {
    fn facet(&self, corners: [u32; 3], across: [u32; 3]) -> Facet {
        let [a, b, c] = corners.map(|i| self.at(i));
        let normal = (b - a).cross(c - a);
        Facet { corners, across, normal, offset: normal.dot(a.to_vector()), ..Facet::default() }
    }

    /// The height of a point over a facet, in units of its normal, when it lies above it; decided exactly.
    #[inline]
    fn height(&self, facet: &Facet, p: u32) -> Option<f64> {
        let height = facet.normal.dot(self.at(p).to_vector()) - facet.offset;
        let above = if height.abs() > self.doubt { height > 0.0 } else { self.above(facet.corners, p) > 0.0 };
        above.then_some(height)
    }

    fn at(&self, i: u32) -> Point3 {
        self.points[i as usize]
    }

    /// Positive when point `p` lies above the plane of three points, from where they turn left; exact.
    fn above(&self, [a, b, c]: [u32; 3], p: u32) -> f64 {
        let coord = |i: u32| {
            let p = self.at(i);
            robust::Coord3D { x: p.x, y: p.y, z: p.z }
        };
        -robust::orient3d(coord(a), coord(b), coord(c), coord(p))
    }

    /// Makes a first tetrahedron and hands the other points to its sides.
    fn start(&mut self) -> Result<()> {
        let flat = || Error::degenerate("points", "they lie in one plane");
        let n = self.points.len() as u32;
        fn best(n: u32, value: impl Fn(u32) -> f64) -> Option<u32> {
            let larger = |found: (f64, Option<u32>), i: u32| {
                let v = value(i);
                if found.1.is_none() || v > found.0 { (v, Some(i)) } else { found }
            };
            (0..n).fold((0.0, None), larger).1
        }
        let a = best(n, |i| -self.at(i).x).ok_or_else(flat)?;
        let b = best(n, |i| (self.at(i) - self.at(a)).length_squared()).ok_or_else(flat)?;
        let ab = self.at(b) - self.at(a);
        let c = best(n, |i| ab.cross(self.at(i) - self.at(a)).length_squared()).ok_or_else(flat)?;
        let normal = ab.cross(self.at(c) - self.at(a));
        let guess = best(n, |i| normal.dot(self.at(i) - self.at(a)).abs()).ok_or_else(flat)?;
        // What is farthest by rounded numbers may lie in the plane by exact ones; and another point may not.
        let off = |i: &u32| self.above([a, b, c], *i) != 0.0;
        let corners = std::iter::once((a, b, c))
            .flat_map(|t| std::iter::once(guess).chain(0..n).filter(off).map(move |d| (t, d)))
            .next();
        let ((a, b, c), d) = match corners {
            Some(found) => found,
            None => self.search_tetrahedron().ok_or_else(flat)?,
        };
        let (b, c) = if self.above([a, b, c], d) < 0.0 { (b, c) } else { (c, b) };
        // d is below a, b, c.
        let facet = |corners, across| self.facet(corners, across);
        self.facets = vec![
            facet([a, b, c], [3, 1, 2]),
            facet([c, b, d], [0, 3, 2]),
            facet([a, c, d], [0, 1, 3]),
            facet([b, a, d], [0, 2, 1]),
        ];
        self.hand_out((0..n).filter(|i| ![a, b, c, d].contains(i)), 0);
        Ok(())
    }

    /// Four points that span space, when three that do not lie on a line by rounded numbers do so by exact ones.
    fn search_tetrahedron(&self) -> Option<((u32, u32, u32), u32)> {
        let n = self.points.len() as u32;
        let b = (1..n).find(|&i| self.at(i) != self.at(0))?;
        // Three points are on a line when their projections are, in all three directions.
        let pair = |i: u32, k: usize| {
            let p: [f64; 3] = self.at(i).into();
            crate::Point2::new(p[k], p[(k + 1) % 3])
        };
        let bent = |i: &u32| (0..3).any(|k| super::turn(pair(0, k), pair(b, k), pair(*i, k)) != 0.0);
        let c = (1..n).find(bent)?;
        let d = (1..n).find(|&i| self.above([0, b, c], i) != 0.0)?;
        Some(((0, b, c), d))
    }

    /// Gives points to the first facet from `first` on that they lie above; those above none are inside.
    fn hand_out(&mut self, points: impl Iterator<Item = u32>, first: u32) {
        for p in points {
            let above = (first as usize..self.facets.len())
                .find_map(|f| self.facets.get(f).and_then(|facet| Some((f, self.height(facet, p)?))));
            if let Some((facet, height)) = above.and_then(|(f, h)| Some((self.facets.get_mut(f)?, h))) {
                facet.above.push(p);
                if facet.top.is_none_or(|(most, _)| height > most) {
                    facet.top = Some((height, p));
                }
            }
        }
    }

    /// The farthest of the points above a facet.
    fn farthest(&self, f: u32) -> Option<u32> {
        self.facets.get(f as usize).filter(|f| !f.gone)?.top.map(|(_, p)| p)
    }

    /// The facets that a point sees, from one of them on, and the border of what it sees: the ends of each side, and
    /// the facet beyond.
    fn seen_from(&mut self, f: u32, p: u32) -> (Vec<u32>, Vec<(u32, u32, u32)>) {
        let (mut seen, mut horizon) = (vec![f], Vec::new());
        self.facets[f as usize].gone = true;
        let mut next = 0;
        while let Some(&g) = seen.get(next) {
            next += 1;
            let (corners, across) = (self.facets[g as usize].corners, self.facets[g as usize].across);
            for side in 0..3 {
                let h = across[side];
                let other = &self.facets[h as usize];
                if other.gone {
                    // Seen already: the facets that are gone for good have no neighbours left.
                    continue;
                }
                if self.height(other, p).is_some() {
                    self.facets[h as usize].gone = true;
                    seen.push(h);
                } else {
                    horizon.push((corners[side], corners[(side + 1) % 3], h));
                }
            }
        }
        (seen, horizon)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_of_points_is_a_cube() {
        let points: Vec<Point3> = (0..125)
            .map(|i| Point3::new(f64::from(i % 5) / 3.0, f64::from(i / 5 % 5) / 3.0, f64::from(i / 25) / 3.0))
            .collect();
        let hull = convex_hull_3d(&points).unwrap();
        let volume: f64 = hull
            .iter()
            .map(|t| t.map(|i| points[i as usize].to_vector()))
            .map(|[a, b, c]| a.dot(b.cross(c)) / 6.0)
            .sum();
        assert!((volume - (4.0_f64 / 3.0).powi(3)).abs() < 1e-12, "{volume}");
    }

    #[test]
    fn flat_points_have_none() {
        let flat: Vec<Point3> =
            (0..30).map(|i| Point3::new(f64::from(i % 6), f64::from(i / 6), 0.1)).collect();
        for n in [0, 1, 2, 3, 6, 30] {
            assert!(convex_hull_3d(&flat[..n]).is_err(), "{n} points");
        }
        let mut tilted: Vec<Point3> = flat.iter().map(|p| Point3::new(p.x, p.y, p.x + 2.0 * p.y)).collect();
        assert!(convex_hull_3d(&tilted).is_err());
        tilted.push(Point3::new(2.0, 2.0, 6.0 + 1e-15 * 4.0));
        let hull = convex_hull_3d(&tilted).unwrap();
        assert!(hull.len() >= 4);
    }
}
