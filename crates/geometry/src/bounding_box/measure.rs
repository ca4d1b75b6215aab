//! Distances of boxes, their edges and what they have in common.

use crate::{BoundingBox, Interval, Line, Plane, PlaneEquation, Point3};

impl BoundingBox {
    /// The box between two opposite corners in any order; `None` when a coordinate is not finite.
    pub fn from_corners(a: Point3, b: Point3) -> Option<Self> {
        Self::from_points([a, b])
    }

    /// What both boxes have in common, which may be a rectangle, a segment or a point; `None` when they are apart.
    pub fn intersection(&self, other: &Self) -> Option<Self> {
        let (a, b, c, d) = (self.min, other.min, self.max, other.max);
        let min = Point3::new(a.x.max(b.x), a.y.max(b.y), a.z.max(b.z));
        let max = Point3::new(c.x.min(d.x), c.y.min(d.y), c.z.min(d.z));
        (min.x <= max.x && min.y <= max.y && min.z <= max.z).then_some(Self { min, max })
    }

    /// Whether the other box lies inside or on this one.
    pub fn contains_box(&self, other: &Self) -> bool {
        self.contains(other.min) && self.contains(other.max)
    }

    /// The twelve edges: four around the bottom, four around the top, then the four upright ones.
    pub fn edges(&self) -> [Line; 12] {
        let c = self.corners();
        let pairs =
            [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)];
        pairs.map(|(i, j): (usize, usize)| Line::new(c[i], c[j]))
    }

    /// In how many directions the box is no wider than `tolerance`: 0 for a solid box, 1 for a rectangle, 2 for a
    /// segment, 3 for a point.
    pub fn degenerate_directions(&self, tolerance: f64) -> usize {
        let d = self.diagonal();
        [d.x, d.y, d.z].iter().filter(|x| **x <= tolerance).count()
    }

    /// The surface area.
    pub fn area(&self) -> f64 {
        let d = self.diagonal();
        2.0 * (d.x * d.y + d.y * d.z + d.z * d.x)
    }

    /// The volume.
    pub fn volume(&self) -> f64 {
        let d = self.diagonal();
        d.x * d.y * d.z
    }

    /// The point of the solid box nearest to `p`: `p` itself inside.
    pub fn closest_point(&self, p: Point3) -> Point3 {
        let (a, b) = (self.min, self.max);
        Point3::new(p.x.max(a.x).min(b.x), p.y.max(a.y).min(b.y), p.z.max(a.z).min(b.z))
    }

    /// The distance from `p` to the farthest corner.
    pub fn max_distance_to(&self, p: Point3) -> f64 {
        self.corners().iter().map(|c| c.distance_to(p)).fold(0.0, f64::max)
    }

    /// The least distance between points of two boxes, 0 when they overlap.
    pub fn distance_to_box(&self, other: &Self) -> f64 {
        let gap = |a: f64, b: f64, c: f64, d: f64| (c - b).max(a - d).max(0.0);
        let (a, b, c, d) = (self.min, self.max, other.min, other.max);
        crate::Vector3::new(gap(a.x, b.x, c.x, d.x), gap(a.y, b.y, c.y, d.y), gap(a.z, b.z, c.z, d.z))
            .length()
    }

    /// The greatest distance between points of two boxes.
    pub fn max_distance_to_box(&self, other: &Self) -> f64 {
        other.corners().iter().map(|&c| self.max_distance_to(c)).fold(0.0, f64::max)
    }

    /// The least distance from the solid box to a segment, 0 when they meet.
    ///
    /// Exact: between the parameters where the segment crosses the box's six planes the square of the distance is one
    /// quadratic, and the whole is convex.
    pub fn distance_to_segment(&self, line: &Line) -> f64 {
        let d = line.direction();
        let mut cuts = vec![0.0, 1.0];
        for (from, d, low, high) in [
            (line.from.x, d.x, self.min.x, self.max.x),
            (line.from.y, d.y, self.min.y, self.max.y),
            (line.from.z, d.z, self.min.z, self.max.z),
        ] {
            cuts.extend([(low - from) / d, (high - from) / d].into_iter().filter(|t| 0.0 < *t && *t < 1.0));
        }
        cuts.sort_by(f64::total_cmp);
        let mut best = f64::INFINITY;
        for w in cuts.windows(2) {
            let [start, end] = [w[0], w[1]];
            // In between each coordinate is below, inside or above throughout: the outside ones count.
            let p = line.at(0.5 * (start + end));
            let out = p - self.closest_point(p);
            let kept = |o: f64, d: f64| if o == 0.0 { 0.0 } else { d };
            let slope = crate::Vector3::new(kept(out.x, d.x), kept(out.y, d.y), kept(out.z, d.z));
            let squared = slope.length_squared();
            let shift = if squared > 0.0 { -out.dot(slope) / squared } else { 0.0 };
            let t = (0.5 * (start + end) + shift).clamp(start, end);
            for t in [start, t, end] {
                best = best.min(self.distance_to(line.at(t)));
            }
        }
        best
    }

    /// The greatest distance from points of the box to points of a segment.
    pub fn max_distance_to_segment(&self, line: &Line) -> f64 {
        self.max_distance_to(line.from).max(self.max_distance_to(line.to))
    }

    /// The signed distances from a plane that points of the box have, the least and the greatest.
    pub fn range_of_distances(&self, plane: &Plane) -> Interval {
        PlaneEquation::from(plane).range_over(self)
    }

    /// The distance from the box to a plane, 0 when they meet.
    pub fn distance_to_plane(&self, plane: &Plane) -> f64 {
        let r = self.range_of_distances(plane);
        r.start.max(-r.end).max(0.0)
    }
}
