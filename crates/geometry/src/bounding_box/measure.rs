//! Distances of boxes, and what they have in common.

use crate::{BoundingBox, Interval, Plane, PlaneEquation, Point3};

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

impl PlaneEquation {
    /// The least and the greatest value over a box.
    pub fn range_over(&self, bounds: &BoundingBox) -> Interval {
        let (n, a, b) = (self.normal(), bounds.min, bounds.max);
        let pick = |n: f64, a: f64, b: f64| if n >= 0.0 { (a, b) } else { (b, a) };
        let ((x0, x1), (y0, y1), (z0, z1)) = (pick(n.x, a.x, b.x), pick(n.y, a.y, b.y), pick(n.z, a.z, b.z));
        Interval::new(self.value_at(Point3::new(x0, y0, z0)), self.value_at(Point3::new(x1, y1, z1)))
    }
}
