//! Lines and conics in space.

use katydid_elementary::Elementary;

use super::Axis;
use crate::{
    Arc, BoundingBox, Circle, Curve, Ellipse, Interval, Line, LineCurve, NurbsCurve, Plane, Point3, Result,
    intersect,
};

/// A line or a conic, whole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Conic {
    /// A straight line without ends.
    Line(Axis),
    /// A circle.
    Circle(Circle),
    /// An ellipse.
    Ellipse(Ellipse),
    /// The parabola y = x²/(4 f) in a plane.
    Parabola {
        /// Its vertex is the origin, its axis is y.
        plane: Plane,
        /// The distance f between vertex and focus.
        focal: f64,
    },
    /// The branch (a cosh t, b sinh t) of a hyperbola in a plane.
    Hyperbola {
        /// Its centre is the origin; the branch opens along x.
        plane: Plane,
        /// The distance between centre and vertex.
        a: f64,
        /// The half axis along y.
        b: f64,
    },
}

/// A curve that two surfaces have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CarrierCurve {
    /// The curve.
    pub conic: Conic,
    /// Whether the surfaces touch along it; else they pass through each other.
    pub tangent: bool,
}

impl Conic {
    /// The point at a parameter: the distance along a line, the angle of a circle, the eccentric angle of an ellipse, x
    /// on a parabola, t on a hyperbola.
    pub fn at(&self, t: f64) -> Point3 {
        match self {
            Self::Line(axis) => axis.at(t),
            Self::Circle(circle) => circle.at(t),
            Self::Ellipse(ellipse) => ellipse.at(t),
            Self::Parabola { plane, focal } => plane.at(t, t * t / (4.0 * focal), 0.0),
            Self::Hyperbola { plane, a, b } => {
                plane.at(a * t.hyperbolic_cosine(), b * t.hyperbolic_sine(), 0.0)
            }
        }
    }

    /// The curve, exactly, as far as it may lie in a box: a part of a line, parabola or hyperbola holds all that lies in
    /// the box; a circle or an ellipse is whole. `None` when it is seen to lie outside.
    ///
    /// # Errors
    /// A number overflows.
    pub fn over(&self, bounds: &BoundingBox) -> Result<Option<Curve>> {
        match self {
            Self::Line(axis) => {
                let line = Line::new(axis.origin, axis.origin + axis.direction);
                let Some(range) = intersect::line_bounding_box(&line, bounds, 0.0) else { return Ok(None) };
                if !(range.length() > 0.0) {
                    return Ok(None);
                }
                Ok(Some(LineCurve::new(Line::new(axis.at(range.start), axis.at(range.end))).into()))
            }
            Self::Circle(circle) => Ok(Some((*circle).into())),
            Self::Ellipse(ellipse) => Ok(Some(ellipse.to_nurbs()?.into())),
            Self::Parabola { plane, .. } => {
                let [[s, t], _] = reach(plane, bounds);
                if s < t { self.between(s, t).map(Some) } else { Ok(None) }
            }
            Self::Hyperbola { plane, a, b } => {
                let [[_, far], [low, high]] = reach(plane, bounds);
                if far < *a || !(low < high) {
                    return Ok(None);
                }
                let widest = (far / a).area_cosine();
                let (s, t) = ((low / b).area_sine().max(-widest), (high / b).area_sine().min(widest));
                if s < t { self.between(s, t).map(Some) } else { Ok(None) }
            }
        }
    }

    /// The part between two parameters as in [`Self::at`], exactly; the second is the larger one, and on a circle or an
    /// ellipse the larger by a whole turn at most.
    ///
    /// # Errors
    /// The range is empty, or a number overflows.
    pub fn between(&self, s: f64, t: f64) -> Result<Curve> {
        match self {
            Self::Line(axis) => Ok(LineCurve::new(Line::new(axis.at(s), axis.at(t))).into()),
            Self::Circle(circle) => Ok(Arc::new(*circle, Interval::new(s, t))?.into()),
            Self::Ellipse(Ellipse { plane, rx, ry }) => {
                // The image of an arc of a unit circle.
                let unit = Arc::new(Circle::new(Plane::XY, 1.0)?, Interval::new(s, t))?;
                let arc = Curve::from(unit).to_nurbs()?;
                let points = arc
                    .homogeneous_points()
                    .iter()
                    .map(|[x, y, _, w]| {
                        let p =
                            plane.origin.to_vector() * *w + plane.x_axis * (rx * x) + plane.y_axis * (ry * y);
                        [p.x, p.y, p.z, *w]
                    })
                    .collect();
                Ok(NurbsCurve::rational(arc.degree(), points, arc.knots().to_vec())?.into())
            }
            Self::Parabola { plane, focal } => {
                // The tangents at both ends meet halfway in x, at y = s·t/(4 f).
                let middle = plane.at(0.5 * (s + t), s * t / (4.0 * focal), 0.0);
                quadratic([self.at(s), middle, self.at(t)], 1.0)
            }
            Self::Hyperbola { plane, a, b } => {
                // As for an arc of a circle, with hyperbolic functions (P&T, *The NURBS Book*, §7.6).
                let (center, weight) = (0.5 * (s + t), (0.5 * (t - s)).hyperbolic_cosine());
                let middle = plane.at(
                    a * center.hyperbolic_cosine() / weight,
                    b * center.hyperbolic_sine() / weight,
                    0.0,
                );
                quadratic([self.at(s), middle, self.at(t)], weight)
            }
        }
    }

    /// The parameter of a point of the curve, or of its foot along the axes of the curve's frame.
    pub fn parameter(&self, p: Point3) -> f64 {
        match self {
            Self::Line(axis) => axis.split(p).0,
            Self::Circle(circle) => {
                let [x, y, _] = circle.plane.coordinates(p);
                y.arctangent_of(x)
            }
            Self::Ellipse(Ellipse { plane, rx, ry }) => {
                let [x, y, _] = plane.coordinates(p);
                (y / ry).arctangent_of(x / rx)
            }
            Self::Parabola { plane, .. } => plane.coordinates(p)[0],
            Self::Hyperbola { plane, b, .. } => (plane.coordinates(p)[1] / b).area_sine(),
        }
    }

    /// Whether it comes back to where it began.
    pub fn is_closed(&self) -> bool {
        matches!(self, Self::Circle(_) | Self::Ellipse(_))
    }
}

/// The ranges of a plane's x and y in a box.
fn reach(plane: &Plane, bounds: &BoundingBox) -> [[f64; 2]; 2] {
    let mut out = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for corner in bounds.corners() {
        let own = plane.coordinates(corner);
        for (range, x) in out.iter_mut().zip(own) {
            *range = [range[0].min(x), range[1].max(x)];
        }
    }
    out
}

/// The rational parabola with one weight in its middle.
fn quadratic(points: [Point3; 3], weight: f64) -> Result<Curve> {
    let [a, b, c] = points;
    let middle = [b.x * weight, b.y * weight, b.z * weight, weight];
    let points = vec![[a.x, a.y, a.z, 1.0], middle, [c.x, c.y, c.z, 1.0]];
    Ok(NurbsCurve::rational(2, points, vec![0.0, 0.0, 1.0, 1.0])?.into())
}
