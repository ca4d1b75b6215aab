//! How far a curve reaches.

use katydid_elementary::Elementary;

use super::Curve;
use super::piece::Shape;
use crate::bernstein::{BUDGET, halves};
use crate::curve::thresholds::UNITS_IN_LAST_PLACE;
use crate::{BoundingBox, Box3, Interval, Plane, Point3, Vector3};

impl Curve {
    /// The least and the greatest p·direction over the points of the curve, exact to rounding.
    ///
    /// NURBS spans by halving: control points bound the span, and the bound closes in quadratically.
    pub fn extent_along(&self, direction: Vector3) -> Interval {
        let mut range = Interval::new(f64::INFINITY, f64::NEG_INFINITY);
        let mut take = |x: f64| range = Interval::new(range.start.min(x), range.end.max(x));
        let along = |p: Point3| p.to_vector().dot(direction);
        let pieces = self.pieces();
        for piece in &pieces {
            take(along(piece.start()));
            take(along(piece.end()));
            if let Shape::Arc(arc) = piece.shape {
                let plane = &arc.circle.plane;
                let top = plane.y_axis.dot(direction).arctangent_of(plane.x_axis.dot(direction));
                for angle in [top, top + std::f64::consts::PI] {
                    let turn = std::f64::consts::TAU;
                    let first = angle + ((arc.angle.min() - angle) / turn).ceil() * turn;
                    if first <= arc.angle.max() {
                        take(along(arc.circle.at(first)));
                    }
                }
            }
        }
        for piece in &pieces {
            let Shape::Span(curve, j) = piece.shape else { continue };
            if curve.span_hull(j).map(along).all(|x| range.start <= x && x <= range.end) {
                continue;
            }
            let Some(points) = piece.beziers().pop() else { continue };
            let d = direction;
            let c: Vec<[f64; 2]> =
                points.iter().map(|p| [p[0] * d.x + p[1] * d.y + p[2] * d.z, p[3]]).collect();
            range.end = greatest(c.clone(), range.end);
            range.start = -greatest(c.iter().map(|&[x, w]| [-x, w]).collect(), -range.start);
        }
        range
    }

    /// The tight box along the world axes.
    pub fn bounding_box(&self) -> BoundingBox {
        let [x, y, z] = [Vector3::X, Vector3::Y, Vector3::Z].map(|d| self.extent_along(d));
        BoundingBox { min: Point3::new(x.start, y.start, z.start), max: Point3::new(x.end, y.end, z.end) }
    }

    /// The tight box along a plane's axes.
    pub fn bounding_box_in(&self, plane: &Plane) -> Box3 {
        let o = plane.origin.to_vector();
        let [x, y, z] = [plane.x_axis, plane.y_axis, plane.z_axis].map(|d| {
            let e = self.extent_along(d);
            Interval::new(e.start - o.dot(d), e.end - o.dot(d))
        });
        Box3 { plane: *plane, x, y, z }
    }

    /// Points whose convex hull holds the curve: vertices and control points; for an arc those of its NURBS form.
    pub fn hull_points(&self) -> Vec<Point3> {
        let mut out = Vec::new();
        for piece in self.pieces() {
            for bezier in piece.beziers() {
                out.extend(bezier.iter().map(|&p| crate::nurbs::project(p)));
            }
        }
        out.dedup();
        out
    }
}

/// The greatest quotient of two Bernstein polynomials, the second positive, when it is above `best`; else `best`.
fn greatest(coefficients: Vec<[f64; 2]>, mut best: f64) -> f64 {
    let bound = |c: &[[f64; 2]]| c.iter().map(|c| c[0] / c[1]).fold(f64::NEG_INFINITY, f64::max);
    let slack = UNITS_IN_LAST_PLACE * coefficients.iter().map(|c| (c[0] / c[1]).abs()).fold(0.0, f64::max);
    if !slack.is_finite() {
        return best;
    }
    let mut stack = vec![(coefficients, 0_u32)];
    let mut budget = BUDGET;
    while let Some((c, depth)) = stack.pop() {
        budget = budget.saturating_sub(1);
        if !(bound(&c) > best + slack) || depth > 60 {
            continue;
        }
        if budget == 0 {
            // Lost in rounding: the bound itself is safe.
            best = best.max(bound(&c));
            continue;
        }
        let (left, right) = halves(&c);
        if let Some(&[x, w]) = right.first() {
            best = best.max(x / w);
        }
        if bound(&left) > bound(&right) {
            stack.push((right, depth + 1));
            stack.push((left, depth + 1));
        } else {
            stack.push((left, depth + 1));
            stack.push((right, depth + 1));
        }
    }
    best
}
