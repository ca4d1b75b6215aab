use crate::thresholds;
use std::f64::consts::{PI, TAU};

use katydid_elementary::Elementary;

use crate::{Error, Interval, Line, Plane, Point3, Result, Vector3, Xform};

/// A full circle in a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// The plane; its origin is the centre and angle 0 lies on its x axis.
    pub plane: Plane,
    /// The radius, greater than 0.
    pub radius: f64,
}

impl Circle {
    /// The circle in a plane.
    ///
    /// # Errors
    /// When the radius is not finite and greater than 0, or the plane not finite.
    pub fn new(plane: Plane, radius: f64) -> Result<Self> {
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(Error::OutOfRange {
                what: "radius",
                value: radius,
                must: "finite and greater than 0",
            });
        }
        if !plane.is_finite() {
            return Err(Error::NotFinite("plane of the circle"));
        }
        Ok(Self { plane, radius })
    }

    /// The circle by centre, normal and radius; its plane is [`Plane::from_normal`].
    ///
    /// # Errors
    /// When the normal has no direction or the radius is not greater than 0.
    pub fn from_normal(center: Point3, normal: Vector3, radius: f64) -> Result<Self> {
        Self::new(Plane::from_normal(center, normal)?, radius)
    }

    /// The circle through three points, in their order; angle 0 at the first.
    ///
    /// # Errors
    /// When the points lie on a line or coincide.
    pub fn through(a: Point3, b: Point3, c: Point3) -> Result<Self> {
        let why = Error::degenerate("three points", "no circle goes through them: they lie on one line");
        let plane = Plane::from_points(a, b, c).map_err(|_| why.clone())?;
        let ([bx, _, _], [cx, cy, _]) = (plane.coordinates(b), plane.coordinates(c));
        // Centre (bx/2, y) with equal distances to the origin and (cx, cy).
        let y = (cx * (cx - bx) + cy * cy) / (2.0 * cy);
        let center = plane.at(0.5 * bx, y, 0.0);
        let x_axis = (a - center).unitized().ok_or(why.clone())?;
        let plane =
            Plane { origin: center, x_axis, y_axis: plane.z_axis.cross(x_axis), z_axis: plane.z_axis };
        Self::new(plane, center.distance_to(a)).map_err(|_| why)
    }

    /// The circle that fits points best in their best plane (algebraic fit after I. Kåsa, 1976), and the largest
    /// distance of a point from it.
    ///
    /// # Errors
    /// Fewer than three points, or all of them on a line.
    pub fn fit(points: &[Point3]) -> Result<(Self, f64)> {
        let (plane, _) = Plane::fit(points)?;
        // Least squares of x² + y² = 2ax + 2by + c about the mean, where the sums of x and y vanish.
        let local: Vec<[f64; 3]> = points.iter().map(|&p| plane.coordinates(p)).collect();
        let sum = |f: &dyn Fn(&[f64; 3]) -> f64| local.iter().map(f).sum::<f64>();
        let (xx, xy, yy) = (sum(&|p| p[0] * p[0]), sum(&|p| p[0] * p[1]), sum(&|p| p[1] * p[1]));
        let square = |p: &[f64; 3]| p[0] * p[0] + p[1] * p[1];
        let (rx, ry) = (sum(&|p| square(p) * p[0]), sum(&|p| square(p) * p[1]));
        let determinant = xx * yy - xy * xy;
        if !(determinant > thresholds::NO_LENGTH_SQUARED * xx * yy) {
            return Err(Error::degenerate("points", "they lie on one line"));
        }
        let a = 0.5 * (rx * yy - ry * xy) / determinant;
        let b = 0.5 * (ry * xx - rx * xy) / determinant;
        let radius = (a * a + b * b + sum(&|p| square(p)) / points.len() as f64).sqrt();
        let circle = Self::new(plane.with_origin(plane.at(a, b, 0.0)), radius)?;
        let arc = Arc { circle, angle: Interval::new(0.0, TAU) };
        let miss = |&p: &Point3| circle.at(arc.closest_angle(p)).distance_to(p);
        let deviation = points.iter().map(miss).fold(0.0, f64::max);
        Ok((circle, deviation))
    }

    /// The point at an angle in radians, counter-clockwise from the plane's x axis.
    #[inline]
    pub fn at(&self, angle: f64) -> Point3 {
        let (sin, cos) = angle.sine_cosine();
        self.plane.at(self.radius * cos, self.radius * sin, 0.0)
    }

    /// The centre.
    #[inline]
    pub fn center(&self) -> Point3 {
        self.plane.origin
    }

    /// 2πr.
    pub fn circumference(&self) -> f64 {
        TAU * self.radius
    }

    /// The image under a similarity, walked as the original is; `None` when the map does not keep angles. Then the
    /// image of the circle as a [`crate::Curve`] is an exact NURBS curve.
    pub fn transformed(&self, xform: &Xform) -> Option<Self> {
        let factor = xform.similarity_factor(thresholds::ROUNDING)?;
        Self::new(self.plane.transformed(xform).ok()?, self.radius * factor.abs()).ok()
    }
}

/// A part of a circle between two angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// The circle the arc lies on.
    pub circle: Circle,
    /// Start and end angle in radians; increasing, at most 2π long.
    pub angle: Interval,
}

impl Arc {
    /// The part of a circle between two angles. A reversed range gives the same points walked the other way (the
    /// plane turns over), a range of more than a turn the full circle.
    ///
    /// # Errors
    /// When the angles are equal or not finite.
    pub fn new(circle: Circle, angle: Interval) -> Result<Self> {
        if !(angle.start.is_finite() && angle.end.is_finite()) {
            return Err(Error::NotFinite("arc angle"));
        }
        if angle.start == angle.end {
            return Err(Error::degenerate("arc", "its angle is 0"));
        }
        if angle.end < angle.start {
            let turned = Self { circle, angle: angle.reversed() }.reversed();
            return Self::new(turned.circle, turned.angle);
        }
        let end = angle.end.min(angle.start + TAU);
        Ok(Self { circle, angle: Interval::new(angle.start, end) })
    }

    /// The arc from `a` through `b` to `c`; its plane has its x axis towards `a`, so that the angle starts at 0.
    ///
    /// # Errors
    /// When the points lie on a line or coincide.
    pub fn through(a: Point3, b: Point3, c: Point3) -> Result<Self> {
        let circle = Circle::through(a, b, c)?;
        let [x, y, _] = circle.plane.coordinates(c);
        let angle = y.arctangent_of(x);
        Self::new(circle, Interval::new(0.0, if angle <= 0.0 { angle + TAU } else { angle }))
    }

    /// The arc from a start point, along a direction there, to an end point.
    ///
    /// # Errors
    /// When start and end coincide, or the direction leads straight to or away from the end.
    pub fn from_start_direction_end(start: Point3, direction: Vector3, end: Point3) -> Result<Self> {
        let why = Error::degenerate("arc", "the direction leads straight to or away from the end");
        let plane = Plane::from_points(start, start + direction.unitized().ok_or(why.clone())?, end)
            .map_err(|_| why.clone())?;
        // In the plane the arc starts along x and bends towards y: the centre is (0, r).
        let [x, y, _] = plane.coordinates(end);
        let radius = (x * x + y * y) / (2.0 * y);
        let center = plane.at(0.0, radius, 0.0);
        let x_axis = -plane.y_axis;
        let frame = Plane { origin: center, x_axis, y_axis: plane.x_axis, z_axis: plane.z_axis };
        let circle = Circle::new(frame, radius).map_err(|_| why)?;
        let angle = x.arctangent_of(radius - y);
        Self::new(circle, Interval::new(0.0, if angle <= 0.0 { angle + TAU } else { angle }))
    }

    /// The radius times the angle.
    pub fn length(&self) -> f64 {
        self.circle.radius * self.angle.length().abs()
    }

    /// The start.
    pub fn start(&self) -> Point3 {
        self.circle.at(self.angle.start)
    }

    /// The point halfway.
    pub fn midpoint(&self) -> Point3 {
        self.circle.at(self.angle.middle())
    }

    /// The end.
    pub fn end(&self) -> Point3 {
        self.circle.at(self.angle.end)
    }

    /// The segment from start to end.
    pub fn chord(&self) -> Line {
        Line::new(self.start(), self.end())
    }

    /// Whether the arc is a full circle.
    pub fn is_circle(&self) -> bool {
        (self.angle.length().abs() - TAU).abs() <= thresholds::WHOLE_TURN
    }

    /// The same points from the end to the start: the plane turns about its x axis by half a turn.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let p = self.circle.plane;
        let plane = Plane { y_axis: -p.y_axis, z_axis: -p.z_axis, ..p };
        Self {
            circle: Circle { plane, ..self.circle },
            angle: Interval::new(-self.angle.end, -self.angle.start),
        }
    }

    /// The image under a similarity, walked as the original is; `None` when the map does not keep angles.
    pub fn transformed(&self, xform: &Xform) -> Option<Self> {
        Some(Self { circle: self.circle.transformed(xform)?, angle: self.angle })
    }

    /// The area between the arc and its chord.
    pub fn segment_area(&self) -> f64 {
        let a = self.angle.length().abs().min(2.0 * PI);
        0.5 * self.circle.radius.powi(2) * (a - a.sine())
    }
}
