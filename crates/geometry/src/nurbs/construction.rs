//! The steps of de Casteljau and de Boor as data, for those who want to see them.

use super::NurbsCurve;
use super::curve::project;
use super::knots::span_index;
use crate::Point3;

/// One point of de Boor's triangle: where two points of the level before are mixed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DeBoorStep {
    /// The share of the second of the two points, a: the result is (1 − a)·first + a·second.
    pub ratio: f64,
    /// The index of the first of the two points in the level before.
    pub first: usize,
    /// The result in homogeneous form, (wx, wy, wz, w).
    pub homogeneous: [f64; 4],
    /// The result in space.
    pub point: Point3,
}

/// De Boor's algorithm on one parameter, with every value on the way.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DeBoor {
    /// The index of the first control point that acts at the parameter; degree + 1 of them do.
    pub first_control_point: usize,
    /// The levels: degree steps, then one fewer, …, and at last the one whose point lies on the curve.
    pub levels: Vec<Vec<DeBoorStep>>,
    /// The point on the curve.
    pub point: Point3,
}

impl NurbsCurve {
    /// De Boor's algorithm at `t`, step by step.
    pub fn de_boor(&self, t: f64) -> DeBoor {
        let p = self.degree;
        let j = span_index(&self.knots, p, t, false);
        let mut row: Vec<[f64; 4]> = self.homogeneous_points().into_iter().skip(j).take(p + 1).collect();
        let mut levels = Vec::with_capacity(p);
        for level in 1..=p {
            let steps: Vec<DeBoorStep> = (0..row.len() - 1)
                .map(|i| {
                    let (a, b) = (self.knots[j + i + level - 1], self.knots[j + i + p]);
                    let ratio = (t - a) / (b - a);
                    let homogeneous = super::evaluate::mix(&row[i], &row[i + 1], ratio);
                    let first = if level == 1 { j + i } else { i };
                    DeBoorStep { ratio, first, homogeneous, point: project(homogeneous) }
                })
                .collect();
            row = steps.iter().map(|s| s.homogeneous).collect();
            levels.push(steps);
        }
        DeBoor { first_control_point: j, levels, point: row.first().map_or(Point3::ORIGIN, |&p| project(p)) }
    }
}

/// De Casteljau's algorithm on a Bézier curve: the points of every level, the last level holding the one on the curve.
///
/// The control points themselves are not repeated: a cubic gives three points, then two, then one.
pub fn de_casteljau(control_points: &[Point3], t: f64) -> Vec<Vec<Point3>> {
    let mut levels: Vec<Vec<Point3>> = Vec::with_capacity(control_points.len().saturating_sub(1));
    let mut row = control_points.to_vec();
    while row.len() > 1 {
        row = row.windows(2).map(|w| w[0].lerp(w[1], t)).collect();
        levels.push(row.clone());
    }
    levels
}

/// The Bézier control points of the cubic with two end points and the derivatives there, over 0…1.
pub fn hermite_to_bezier(
    start: Point3,
    start_tangent: crate::Vector3,
    end: Point3,
    end_tangent: crate::Vector3,
) -> [Point3; 4] {
    [start, start + start_tangent / 3.0, end - end_tangent / 3.0, end]
}

/// The end points and end derivatives of a cubic Bézier curve over 0…1: start, its derivative, end, its derivative.
pub fn bezier_to_hermite(points: [Point3; 4]) -> (Point3, crate::Vector3, Point3, crate::Vector3) {
    let [a, b, c, d] = points;
    (a, (b - a) * 3.0, d, (d - c) * 3.0)
}
