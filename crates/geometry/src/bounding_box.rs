mod measure;

use crate::{Point3, Vector3, Xform};

/// A box along the world axes that holds something. It is never empty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingBox {
    /// The smallest coordinates.
    pub min: Point3,
    /// The largest coordinates.
    pub max: Point3,
}

impl BoundingBox {
    /// The smallest box around points; `None` for no points, or when a coordinate is NaN.
    pub fn from_points(points: impl IntoIterator<Item = Point3>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = points.next()?;
        let mut this = Self { min: first, max: first };
        let mut sound = first.is_finite();
        for p in points {
            sound &= p.is_finite();
            this = this.union(&Self { min: p, max: p });
        }
        sound.then_some(this)
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let (a, b, c, d) = (self.min, other.min, self.max, other.max);
        Self {
            min: Point3::new(a.x.min(b.x), a.y.min(b.y), a.z.min(b.z)),
            max: Point3::new(c.x.max(d.x), c.y.max(d.y), c.z.max(d.z)),
        }
    }

    /// The eight corners: the bottom counter-clockwise from the smallest, then the top likewise.
    pub fn corners(&self) -> [Point3; 8] {
        let (a, b) = (self.min, self.max);
        [
            a,
            Point3::new(b.x, a.y, a.z),
            Point3::new(b.x, b.y, a.z),
            Point3::new(a.x, b.y, a.z),
            Point3::new(a.x, a.y, b.z),
            Point3::new(b.x, a.y, b.z),
            b,
            Point3::new(a.x, b.y, b.z),
        ]
    }

    /// The middle.
    pub fn center(&self) -> Point3 {
        self.min.lerp(self.max, 0.5)
    }

    /// From the smallest corner to the largest.
    pub fn diagonal(&self) -> Vector3 {
        self.max - self.min
    }

    /// Whether the point lies inside or on the box.
    pub fn contains(&self, p: Point3) -> bool {
        (self.min.x..=self.max.x).contains(&p.x)
            && (self.min.y..=self.max.y).contains(&p.y)
            && (self.min.z..=self.max.z).contains(&p.z)
    }

    /// The distance from a point to the box, 0 inside.
    pub fn distance_to(&self, p: Point3) -> f64 {
        let gap = |x: f64, low: f64, high: f64| (low - x).max(x - high).max(0.0);
        Vector3::new(
            gap(p.x, self.min.x, self.max.x),
            gap(p.y, self.min.y, self.max.y),
            gap(p.z, self.min.z, self.max.z),
        )
        .length()
    }

    /// The box grown by `distance` on every side; a negative distance shrinks it, at most to its middle.
    #[must_use]
    pub fn inflated(&self, distance: f64) -> Self {
        let half = self.diagonal() * 0.5;
        let least = half.x.min(half.y).min(half.z);
        let d = distance.max(-least);
        let v = Vector3::new(d, d, d);
        Self { min: self.min - v, max: self.max + v }
    }

    /// The box around the images of the corners; `None` when one of them is not finite.
    pub fn transformed(&self, xform: &Xform) -> Option<Self> {
        Self::from_points(self.corners().map(|p| xform.point(p)))
    }
}
