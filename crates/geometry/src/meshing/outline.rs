//! The loops of a face as polygons in its parameter plane.

use robust::{Coord, orient2d};

use crate::Point2;

/// A corner of a polygon: its parameters, and its place among the points of the brep's mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Corner {
    pub(super) uv: Point2,
    pub(super) id: u32,
    /// The trim of the segment that begins here.
    pub(super) trim: u32,
}

/// Closed polygons.
pub(super) struct Outline {
    pub(super) corners: Vec<Corner>,
    /// For every corner the next one of its polygon.
    next: Vec<u32>,
    /// Strips of equal width in v, each with the segments that reach into it.
    strips: Vec<Vec<u32>>,
    range: [f64; 2],
}

/// On which side of the line from a to b a point lies: positive on the left. Exact.
pub(super) fn side(a: Point2, b: Point2, p: Point2) -> f64 {
    let coord = |p: Point2| Coord { x: p.x, y: p.y };
    orient2d(coord(a), coord(b), coord(p))
}

impl Outline {
    /// The polygons with these corners each.
    pub(super) fn new(polygons: &[Vec<Corner>]) -> Self {
        let mut corners = Vec::with_capacity(polygons.iter().map(Vec::len).sum());
        let mut next = Vec::with_capacity(corners.capacity());
        for polygon in polygons {
            let start = corners.len() as u32;
            corners.extend_from_slice(polygon);
            next.extend(start + 1..corners.len() as u32);
            if !polygon.is_empty() {
                next.push(start);
            }
        }
        let range = corners.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], c: &Corner| {
            [low.min(c.uv.y), high.max(c.uv.y)]
        });
        let mut outline = Self { corners, next, strips: Vec::new(), range };
        let mut strips = vec![Vec::new(); outline.strip_count()];
        for k in 0..outline.corners.len() {
            let Some([a, b]) = outline.segment(k) else { continue };
            let (from, to) = (a.uv.y.min(b.uv.y), a.uv.y.max(b.uv.y));
            let [i, j] = [from, to].map(|v| strip(range, strips.len(), v));
            for strip in strips.get_mut(i..=j).unwrap_or_default() {
                strip.push(k as u32);
            }
        }
        outline.strips = strips;
        outline
    }

    /// Into how many strips the polygons are sorted: fewer where segments are long, so that the lists stay short.
    fn strip_count(&self) -> usize {
        const ROOM: usize = 16;
        let n = self.corners.len();
        let mut count = (n / 2).clamp(1, 4096);
        while count > 1 {
            let spread = |k: usize| {
                self.segment(k).map_or(0, |[a, b]| {
                    let [i, j] = [a, b].map(|c| strip(self.range, count, c.uv.y));
                    i.abs_diff(j) + 1
                })
            };
            if (0..n).map(spread).sum::<usize>() <= ROOM * n {
                break;
            }
            count /= 2;
        }
        count
    }

    /// How many segments are looked at to tell on which side of the polygons a point lies, more or less.
    pub(super) fn effort(&self) -> usize {
        self.strips.iter().map(Vec::len).sum::<usize>() / self.strips.len().max(1)
    }

    /// The corner after a corner.
    pub(super) fn next(&self, k: usize) -> usize {
        self.next.get(k).map_or(k, |&n| n as usize)
    }

    /// The ends of the segment that begins at a corner.
    pub(super) fn segment(&self, k: usize) -> Option<[Corner; 2]> {
        Some([*self.corners.get(k)?, *self.corners.get(self.next(k))?])
    }

    /// The segments that may reach into a range of v; some more than once.
    pub(super) fn near(&self, [from, to]: [f64; 2]) -> impl Iterator<Item = usize> + '_ {
        let [i, j] = [from, to].map(|v| strip(self.range, self.strips.len(), v));
        self.strips.get(i..=j).unwrap_or(&[]).iter().flatten().map(|&k| k as usize)
    }

    /// Whether a point lies inside, by the parity of crossings with a ray along u; exact for points off the polygons.
    pub(super) fn contains(&self, p: Point2) -> bool {
        if !(p.y >= self.range[0] && p.y <= self.range[1]) {
            return false;
        }
        let place = strip(self.range, self.strips.len(), p.y);
        let mut inside = false;
        for &k in self.strips.get(place).map_or(&[] as &[u32], Vec::as_slice) {
            let Some([a, b]) = self.segment(k as usize) else { continue };
            let (a, b) = (a.uv, b.uv);
            if (a.y <= p.y) == (b.y <= p.y) || (p.x > a.x && p.x > b.x) {
                continue;
            }
            let ahead = if p.x < a.x && p.x < b.x { true } else { (side(a, b, p) > 0.0) == (b.y > a.y) };
            inside ^= ahead;
        }
        inside
    }
}

fn strip([low, high]: [f64; 2], count: usize, v: f64) -> usize {
    let x = (v - low) / (high - low) * count as f64;
    // Not a number when all is in one line.
    if x > 0.0 { (x as usize).min(count - 1) } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::{Corner, Outline};
    use crate::Point2;

    #[test]
    fn inside_of_a_ring() {
        let polygon = |points: &[[f64; 2]]| -> Vec<Corner> {
            points.iter().map(|&[x, y]| Corner { uv: Point2::new(x, y), id: 0, trim: 0 }).collect()
        };
        let outline = Outline::new(&[
            polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]),
            polygon(&[[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0]]),
        ]);
        for i in 0..40 {
            for j in 0..40 {
                let p = Point2::new(0.1103 * f64::from(i) - 0.1, 0.1071 * f64::from(j) - 0.1);
                let within = |low: f64, high: f64| p.x > low && p.x < high && p.y > low && p.y < high;
                assert_eq!(outline.contains(p), within(0.0, 4.0) && !within(1.0, 3.0), "{p:?}");
            }
        }
    }
}
