use crate::{BoundingBox, Interval, Plane, Point3, Rectangle, Result, Xform};

/// What coordinates computed in a few steps may be off by, in proportion to their size.
const ROUNDING: f64 = 1e-12;

/// A box in a frame, by its ranges along the three axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Box3 {
    /// The frame.
    pub plane: Plane,
    /// The range along the x axis.
    pub x: Interval,
    /// The range along the y axis.
    pub y: Interval,
    /// The range along the z axis.
    pub z: Interval,
}

impl Box3 {
    /// The smallest box along a plane's axes around points; `None` for no points or one that is not finite.
    pub fn around(plane: &Plane, points: impl IntoIterator<Item = Point3>) -> Option<Self> {
        let local = points.into_iter().map(|p| Point3::from(plane.coordinates(p)));
        let b = BoundingBox::from_points(local)?;
        let range = |a: f64, b: f64| Interval::new(a, b);
        Some(Self {
            plane: *plane,
            x: range(b.min.x, b.max.x),
            y: range(b.min.y, b.max.y),
            z: range(b.min.z, b.max.z),
        })
    }

    /// The eight corners: the bottom counter-clockwise from the smallest, then the top likewise.
    pub fn corners(&self) -> [Point3; 8] {
        let (x, y, z) = (self.x.ordered(), self.y.ordered(), self.z.ordered());
        [
            (x.start, y.start, z.start),
            (x.end, y.start, z.start),
            (x.end, y.end, z.start),
            (x.start, y.end, z.start),
            (x.start, y.start, z.end),
            (x.end, y.start, z.end),
            (x.end, y.end, z.end),
            (x.start, y.end, z.end),
        ]
        .map(|(u, v, w)| self.plane.at(u, v, w))
    }

    /// The rectangle that a box without thickness is: one range is nothing beside the rounding of its corners, the other
    /// two are more. `None` for other boxes. The normal of its plane is the axis of that range.
    pub fn flat_side(&self) -> Option<Rectangle> {
        let largest =
            self.corners().iter().flat_map(|p| [p.x, p.y, p.z]).fold(0.0_f64, |m, c| m.max(c.abs()));
        let ranges = [self.x, self.y, self.z];
        let flat = ranges.map(|range| range.length().abs() <= ROUNDING * largest);
        let Plane { x_axis, y_axis, z_axis, .. } = self.plane;
        let (at, axes, [x, y]) = match flat {
            [false, false, true] => ([0.0, 0.0, self.z.start], [x_axis, y_axis, z_axis], [self.x, self.y]),
            [true, false, false] => ([self.x.start, 0.0, 0.0], [y_axis, z_axis, x_axis], [self.y, self.z]),
            [false, true, false] => ([0.0, self.y.start, 0.0], [z_axis, x_axis, y_axis], [self.z, self.x]),
            _ => return None,
        };
        let [x_axis, y_axis, z_axis] = axes;
        let plane = Plane { origin: self.plane.at(at[0], at[1], at[2]), x_axis, y_axis, z_axis };
        Some(Rectangle { plane, x, y })
    }

    /// The point at fractions 0…1 of the three ranges.
    pub fn at(&self, u: f64, v: f64, w: f64) -> Point3 {
        self.plane.at(self.x.at(u), self.y.at(v), self.z.at(w))
    }

    /// The middle.
    pub fn center(&self) -> Point3 {
        self.at(0.5, 0.5, 0.5)
    }

    /// The area of the six sides.
    pub fn area(&self) -> f64 {
        let (x, y, z) = (self.x.length().abs(), self.y.length().abs(), self.z.length().abs());
        2.0 * (x * y + y * z + z * x)
    }

    /// The volume.
    pub fn volume(&self) -> f64 {
        (self.x.length() * self.y.length() * self.z.length()).abs()
    }

    /// Whether a point lies inside, or within `tolerance` of the box.
    pub fn contains(&self, p: Point3, tolerance: f64) -> bool {
        let c = self.plane.coordinates(p);
        [self.x, self.y, self.z]
            .iter()
            .zip(c)
            .all(|(r, x)| r.min() - tolerance <= x && x <= r.max() + tolerance)
    }

    /// The point of the box nearest to `p`; inside it is `p` itself.
    pub fn closest_point(&self, p: Point3) -> Point3 {
        let [x, y, z] = self.plane.coordinates(p);
        self.plane.at(self.x.clamp(x), self.y.clamp(y), self.z.clamp(z))
    }

    /// The box along the world axes around this one.
    pub fn bounding_box(&self) -> BoundingBox {
        let corners = self.corners();
        let first = BoundingBox { min: corners[0], max: corners[0] };
        corners.iter().fold(first, |b, &p| b.union(&BoundingBox { min: p, max: p }))
    }

    /// The image under a similarity; the ranges grow with it.
    ///
    /// # Errors
    /// The map does not keep angles, so that the image is no box.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        let (plane, f) = crate::rectangle::similar_frame(&self.plane, xform, "box")?;
        let grown = |r: Interval| Interval::new(r.start * f.abs(), r.end * f.abs());
        // A mirror turns the frame's normal round: heights change sign with it.
        let z = if f < 0.0 { Interval::new(-self.z.end, -self.z.start) } else { self.z };
        Ok(Self { plane, x: grown(self.x), y: grown(self.y), z: grown(z) })
    }
}

impl From<BoundingBox> for Box3 {
    fn from(b: BoundingBox) -> Self {
        Self {
            plane: Plane::XY,
            x: Interval::new(b.min.x, b.max.x),
            y: Interval::new(b.min.y, b.max.y),
            z: Interval::new(b.min.z, b.max.z),
        }
    }
}
