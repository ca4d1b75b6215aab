//! What kind of curve a curve is.

use katydid_elementary::Elementary;

use super::Curve;
use crate::curve::thresholds::{ABOUT_WHOLE_TURN, NO_X_AXIS, SAME_BEND, STRAIGHT_END_FLOOR, TIE_BREAK};
use crate::thresholds;
use crate::{Arc, Circle, Interval, Line, Plane, Point3, Tolerance, Vector3};

impl Curve {
    /// Whether the curve ends where it starts and encloses something: a line never does, a polyline from three
    /// segments on, and a NURBS curve from four control points on: with three it runs there and back.
    pub fn is_closed(&self) -> bool {
        match self {
            Self::Line(_) => false,
            Self::Arc(c) => c.is_circle(),
            Self::Polyline(c) => c.points().len() >= 4 && self.start().coincides(self.end()),
            Self::Nurbs(c) => {
                self.start().coincides(self.end())
                    && c.point_count() > 3
                    && c.control_points().iter().any(|&p| !p.coincides(self.start()))
            }
            Self::Poly(c) => match c.segments() {
                [only] => only.is_closed(),
                _ => self.start().coincides(self.end()),
            },
        }
    }

    /// Whether the curve closes as smoothly as it runs elsewhere: circles and periodic NURBS curves.
    pub fn is_periodic(&self) -> bool {
        match self {
            Self::Arc(c) => c.is_circle(),
            Self::Nurbs(c) => c.is_periodic(),
            Self::Poly(c) => matches!(c.segments(), [only] if only.is_periodic()),
            _ => false,
        }
    }

    /// A plane that holds the curve within `tolerance`, or `None`.
    ///
    /// The origin is the curve's start and the normal is on the side from which a closed curve runs
    /// counter-clockwise; an arc gives its own plane, a straight curve a plane with the curve along x.
    pub fn plane(&self, tolerance: f64) -> Option<Plane> {
        if let Self::Arc(c) = self {
            return Some(c.arc.circle.plane);
        }
        let points = self.hull_points();
        let start = self.start();
        let Ok((fit, _)) = Plane::fit(&points) else {
            let line = Line::fit(&points).ok()?;
            let x = line.unit_direction()?;
            // A straight curve lies in many planes: take the one whose normal is nearest to world z.
            let y = Vector3::Z.cross(x).unitized().unwrap_or(Vector3::Y);
            return Plane::from_axes(start, x, y).ok();
        };
        let plane = fit.with_origin(start);
        let area: Vector3 = points
            .iter()
            .zip(points.iter().cycle().skip(1))
            .map(|(a, b)| (*a - start).cross(*b - start))
            .sum();
        let flip = match area.dot(plane.z_axis) {
            a if a.abs() > thresholds::ROUNDING * area.length().max(f64::MIN_POSITIVE) => a < 0.0,
            _ => plane.z_axis.dot(Vector3::new(TIE_BREAK[0], TIE_BREAK[1], 1.0)) < 0.0,
        };
        let z = if flip { -plane.z_axis } else { plane.z_axis };
        let x = self
            .tangent_at(self.domain().start)
            .and_then(|t| t.rejected_from(z))
            .filter(|x| x.length() > NO_X_AXIS)
            .unwrap_or(plane.x_axis);
        let plane = Plane::from_axes(start, x, z.cross(x)).ok()?;
        points.iter().all(|&p| plane.signed_distance(p).abs() <= tolerance).then_some(plane)
    }

    /// Whether some plane holds the curve within `tolerance`.
    pub fn is_planar(&self, tolerance: f64) -> bool {
        self.plane(tolerance).is_some()
    }

    /// The segment from start to end when the whole curve lies within `tolerance` of it; `None` for a curve that
    /// closes.
    pub fn as_line(&self, tolerance: f64) -> Option<Line> {
        let line = Line::new(self.start(), self.end());
        let straight = match self {
            Self::Line(_) => line.length() > 0.0,
            Self::Arc(c) => {
                let half = 0.5 * c.arc.angle.length().abs();
                let rise = c.arc.circle.radius * (1.0 - half.cosine());
                half < std::f64::consts::FRAC_PI_2 && rise <= tolerance && line.length() > tolerance
            }
            _ => {
                line.length() > tolerance
                    && self.hull_points().iter().all(|&p| line.distance_to(p) <= tolerance)
            }
        };
        straight.then_some(line)
    }

    /// Whether the curve is a straight segment within `tolerance`.
    pub fn is_linear(&self, tolerance: f64) -> bool {
        self.as_line(tolerance).is_some()
    }

    /// The vertices, when the curve consists of straight segments only: lines, polylines, NURBS curves of degree 1
    /// and poly-curves of these.
    pub fn as_polyline(&self) -> Option<Vec<Point3>> {
        match self {
            Self::Line(c) => Some(vec![c.line.from, c.line.to]),
            Self::Polyline(c) => Some(c.points().to_vec()),
            Self::Nurbs(c) => (c.degree() == 1).then(|| c.control_points()),
            Self::Arc(_) => None,
            Self::Poly(c) => {
                let mut points: Vec<Point3> = Vec::new();
                for segment in c.segments() {
                    let own = segment.as_polyline()?;
                    let skip = usize::from(!points.is_empty());
                    points.extend(own.into_iter().skip(skip));
                }
                Some(points)
            }
        }
    }

    /// The arc that the curve is within `tolerance`, walked as the curve is; a full circle has the angle 2π. `None`
    /// when it is no arc. Straight curves are none.
    pub fn as_arc(&self, tolerance: f64) -> Option<Arc> {
        if let Self::Arc(c) = self {
            return Some(c.arc);
        }
        let domain = self.domain();
        let at = |x: f64| self.point_at(domain.at(x));
        let closed = self.is_closed();
        let circle = if closed {
            Circle::through(at(0.0), at(1.0 / 3.0), at(2.0 / 3.0)).ok()?
        } else {
            Circle::through(at(0.0), at(0.5), at(1.0)).ok()?
        };
        // A circle so large that the curve is straight within the tolerance is not what is asked for.
        if self.is_linear(tolerance) {
            return None;
        }
        let turn = std::f64::consts::TAU;
        let mut last = 0.0;
        for piece in self.pieces() {
            // 2p + 1 points decide whether a piece of degree p lies on a circle; half as many again for safety.
            let steps = match piece.shape {
                super::piece::Shape::Span(c, _) => 3 * c.degree() + 2,
                _ => 2,
            };
            for k in 1..=steps {
                let p = piece.point(piece.own.at(k as f64 / steps as f64));
                let [x, y, z] = circle.plane.coordinates(p);
                if (Vector3::new(x, y, 0.0).length() - circle.radius).abs() > tolerance || z.abs() > tolerance
                {
                    return None;
                }
                let mut angle = y.arctangent_of(x);
                angle += ((last - angle) / turn).round() * turn;
                if angle < last - tolerance / circle.radius || angle > last + turn / 2.0 {
                    return None;
                }
                last = last.max(angle);
            }
        }
        if closed {
            return ((last - turn).abs() < ABOUT_WHOLE_TURN)
                .then_some(Arc { circle, angle: Interval::new(0.0, turn) });
        }
        (last <= turn).then_some(Arc { circle, angle: Interval::new(0.0, last) })
    }

    /// The circle that the curve is within `tolerance`; `None` when it is not a full one.
    pub fn as_circle(&self, tolerance: f64) -> Option<Circle> {
        self.as_arc(tolerance).filter(Arc::is_circle).map(|a| a.circle)
    }

    /// How smoothly `next` goes on where this curve ends: `None` when they do not meet, else 0 for position, 1 for
    /// tangent direction as well, 2 for curvature as well. This is geometric continuity (G0, G1, G2): it does not
    /// depend on parameters. Curvatures may differ by a thousandth of the larger one.
    pub fn continuity_with(&self, next: &Self, tolerance: &Tolerance) -> Option<u8> {
        let (end, start) = (self.domain().end, next.domain().start);
        let apart = self.end().distance_to(next.start());
        if !(apart <= tolerance.absolute) {
            return None;
        }
        let smooth = match (self.tangent_on_side(end, true), next.tangent_on_side(start, false)) {
            (Some(a), Some(b)) => a.angle_to(b).is_some_and(|x| x <= tolerance.angle),
            _ => false,
        };
        if !smooth {
            return Some(0);
        }
        let (a, b) = (self.curvature_at(end), next.curvature_at(start));
        let bound = SAME_BEND * a.length().max(b.length()) + STRAIGHT_END_FLOOR;
        Some(if (a - b).length() <= bound { 2 } else { 1 })
    }
}
