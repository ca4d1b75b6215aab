use crate::{Error, Interval, Plane, Point3, Result, Xform};

/// A map keeps angles when its columns are as long as each other and at right angles to this part.
const SIMILAR: f64 = 1e-9;

/// A rectangle in a plane, by its ranges along the plane's axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// The plane.
    pub plane: Plane,
    /// The range along the x axis.
    pub x: Interval,
    /// The range along the y axis.
    pub y: Interval,
}

impl Rectangle {
    /// The rectangle in a plane with two diagonal corners, which are projected into it; its ranges increase.
    pub fn from_corners(plane: &Plane, a: Point3, b: Point3) -> Self {
        let ([ax, ay, _], [bx, by, _]) = (plane.coordinates(a), plane.coordinates(b));
        Self { plane: *plane, x: Interval::new(ax, bx).ordered(), y: Interval::new(ay, by).ordered() }
    }

    /// The rectangle with the edge from `a` to `b`, as high as `c` is beside it; its plane has its origin in `a`, x
    /// along the edge and `c` on the side of y.
    ///
    /// # Errors
    /// When the three points lie on a line.
    pub fn from_points(a: Point3, b: Point3, c: Point3) -> Result<Self> {
        let plane = Plane::from_points(a, b, c)?;
        let height = plane.coordinates(c)[1];
        Ok(Self { plane, x: Interval::new(0.0, a.distance_to(b)), y: Interval::new(0.0, height) })
    }

    /// The four corners, counter-clockwise from the smallest.
    pub fn corners(&self) -> [Point3; 4] {
        let (x, y) = (self.x.ordered(), self.y.ordered());
        [(x.start, y.start), (x.end, y.start), (x.end, y.end), (x.start, y.end)]
            .map(|(u, v)| self.plane.at(u, v, 0.0))
    }

    /// The middle.
    pub fn center(&self) -> Point3 {
        self.plane.at(self.x.middle(), self.y.middle(), 0.0)
    }

    /// The area.
    pub fn area(&self) -> f64 {
        (self.x.length() * self.y.length()).abs()
    }

    /// The length of the four sides.
    pub fn perimeter(&self) -> f64 {
        2.0 * (self.x.length().abs() + self.y.length().abs())
    }

    /// The image under a similarity.
    ///
    /// # Errors
    /// The map does not keep angles, so that the image need be no rectangle.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        let (plane, f) = similar_frame(&self.plane, xform, "rectangle")?;
        let grown = |r: Interval| Interval::new(r.start * f.abs(), r.end * f.abs());
        Ok(Self { plane, x: grown(self.x), y: grown(self.y) })
    }
}

/// The image of a frame under a similarity and the signed factor of the map.
pub(crate) fn similar_frame(plane: &Plane, xform: &Xform, what: &'static str) -> Result<(Plane, f64)> {
    let factor = xform
        .similarity_factor(SIMILAR)
        .ok_or(Error::degenerate(what, "the transform does not keep its angles"))?;
    Ok((plane.transformed(xform)?, factor))
}
