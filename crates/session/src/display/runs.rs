//! Curves as few segments, fast: while something is dragged.
//!
//! A span of a NURBS curve lies within the hull of the control points that act on it, and its tangents within the cone of
//! the legs between them. Spans that follow each other are one segment as long as all their control points are near it
//! and no leg turns away from it; nothing but the ends of segments is computed of the curve itself.

use katydid_elementary::Elementary;
use katydid_geometry::{Curve, NurbsCurve, Point3, PolylineLimits, Vector3};

/// A segment stands for so many spans at most.
const MOST_SPANS: usize = 64;
/// A span is divided into so many segments at most.
const MOST_PARTS: f64 = 64.0;

/// How far segments may be from their curve, in model units, and turn from one to the next, in radians.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    pub(super) distance: f64,
    pub(super) angle: f64,
}

/// Adds the points of a curve behind those that are there. Where it begins at the last of them, that is not said twice.
pub(super) fn add(curve: &Curve, limits: Limits, points: &mut Vec<Point3>) {
    match curve {
        Curve::Nurbs(curve) => add_nurbs(curve, limits, points),
        Curve::Poly(curve) => curve.segments().iter().for_each(|segment| add(segment, limits, points)),
        Curve::Line(_) | Curve::Arc(_) | Curve::Polyline(_) => {
            let Limits { distance, angle } = limits;
            let shortest = 0.1 * distance;
            let within = PolylineLimits { distance, angle: Some(angle), shortest, longest: None };
            if let Ok(polyline) = curve.to_polyline(&within) {
                polyline.points().iter().for_each(|point| put(*point, points));
            }
        }
    }
}

fn put(point: Point3, points: &mut Vec<Point3>) {
    if points.last() != Some(&point) {
        points.push(point);
    }
}

fn add_nurbs(curve: &NurbsCurve, limits: Limits, points: &mut Vec<Point3>) {
    let (degree, knots) = (curve.degree(), curve.knots());
    let controls = curve.control_points();
    let mut from = curve.point_at(curve.domain().start);
    put(from, points);
    // The control points that act on a span begin with that of its number.
    let ends = knots.get(degree.saturating_sub(1)..).unwrap_or(&[]).windows(2).map(|w| (w[0], w[1]));
    let mut spans = ends.take(controls.len().saturating_sub(degree)).enumerate().filter(|(_, (a, b))| a < b);
    // The spans that make up the segment which is being made longer: the first, how many, and where they end.
    let mut run: Option<(usize, usize, Point3)> = None;
    let mut next = spans.next();
    while let Some((span, (start, end))) = next {
        let to = curve.point_at(end);
        let (first, count) = run.map_or((span, 0), |(first, count, _)| (first, count));
        let hull = controls.get(first..=span + degree).unwrap_or(&[]);
        if count < MOST_SPANS && is_straight(hull, from, to, limits) {
            run = Some((first, count + 1, to));
            next = spans.next();
        } else if let Some((_, _, at)) = run.take() {
            // The span begins a segment of its own.
            put(at, points);
            from = at;
        } else {
            let parts = parts(curve, span, end - start, hull, limits);
            (1..parts).for_each(|k| {
                let t = start + (end - start) * f64::from(k) / f64::from(parts);
                put(curve.point_at(t), points);
            });
            put(to, points);
            from = to;
            next = spans.next();
        }
    }
    if let Some((_, _, at)) = run {
        put(at, points);
    }
}

/// Whether a segment can stand for what is within a hull.
fn is_straight(hull: &[Point3], from: Point3, to: Point3, limits: Limits) -> bool {
    let chord = to - from;
    let length = chord.length();
    if length == 0.0 || !length.is_finite() {
        return false;
    }
    let along = chord / length;
    let near = |point: &Point3| (*point - from).cross(along).length() <= limits.distance;
    let least = (0.5 * limits.angle).cosine();
    let ahead = |leg: &[Point3]| {
        let leg = leg[1] - leg[0];
        leg.dot(along) >= least * leg.length()
    };
    hull.iter().all(near) && hull.windows(2).all(ahead)
}

/// Into how many parts a span is divided. A part of a curve is no farther from its chord than an eighth of the square of
/// its range times the greatest second derivative; that lies in the hull of the control points of its own spline.
/// Weights can make it more: there are twice as many parts then.
fn parts(curve: &NurbsCurve, span: usize, range: f64, hull: &[Point3], limits: Limits) -> u32 {
    let (degree, knots) = (curve.degree(), curve.knots());
    let width = |from: usize, to: usize| Some(knots.get(to)? - knots.get(from)?).filter(|width| *width > 0.0);
    let first: Vec<Vector3> = (span..)
        .zip(hull.windows(2))
        .map_while(|(i, leg)| Some((leg[1] - leg[0]) * (degree as f64 / width(i, i + degree)?)))
        .collect();
    let second = (span..)
        .zip(first.windows(2))
        .map_while(|(i, pair)| Some((pair[1] - pair[0]) * ((degree - 1) as f64 / width(i + 1, i + degree)?)));
    let bend = second.map(Vector3::length).fold(0.0, f64::max);
    let turn: f64 = hull.windows(3).filter_map(|w| (w[1] - w[0]).angle_to(w[2] - w[1])).sum();
    let by_distance = (range * range * bend / (8.0 * limits.distance)).sqrt();
    let weighty = if curve.is_rational() { 2.0 } else { 1.0 };
    (weighty * by_distance.max(turn / limits.angle)).ceil().clamp(2.0, MOST_PARTS) as u32
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use katydid_geometry::{Circle, KnotSpacing, Plane};

    use super::*;

    const LIMITS: Limits = Limits { distance: 0.02, angle: 0.26 };

    fn drawn(curve: &Curve) -> Vec<Point3> {
        let mut points = Vec::new();
        add(curve, LIMITS, &mut points);
        points
    }

    /// The farthest that the curve is from the segments.
    fn off(curve: &Curve, points: &[Point3]) -> f64 {
        let domain = curve.domain();
        let from_segment = |p: Point3, w: &[Point3]| {
            let along = w[1] - w[0];
            let t = ((p - w[0]).dot(along) / along.dot(along)).clamp(0.0, 1.0);
            p.distance_to(w[0].lerp(w[1], t))
        };
        (0..=4000)
            .map(|k| curve.point_at(domain.at(f64::from(k) / 4000.0)))
            .map(|p| points.windows(2).map(|w| from_segment(p, w)).fold(f64::INFINITY, f64::min))
            .fold(0.0, f64::max)
    }

    #[test]
    fn many_spans_of_a_circle_are_few_segments_within_the_distance() {
        let circle: Curve = Circle::new(Plane::XY, 10.0).unwrap().into();
        let through: Vec<Point3> =
            (0..=200).map(|k| circle.point_at(circle.domain().at(f64::from(k) / 200.0))).collect();
        let curve: Curve =
            NurbsCurve::interpolate(3, &through, KnotSpacing::Chord, None, None).unwrap().into();
        let points = drawn(&curve);
        assert!(points.len() >= 25 && points.len() < 75, "{}", points.len());
        assert!(off(&curve, &points) <= LIMITS.distance);
        assert!(points.first().unwrap().distance_to(curve.start()) < 1e-12);
        assert!(points.last().unwrap().distance_to(curve.end()) < 1e-12);
    }

    #[test]
    fn few_spans_are_divided_until_they_are_near() {
        let points =
            [[0.0, 0.0, 0.0], [0.0, 20.0, 0.0], [10.0, -20.0, 5.0], [10.0, 0.0, 0.0]].map(Point3::from);
        let curve: Curve = NurbsCurve::bezier(&points).unwrap().into();
        assert!(off(&curve, &drawn(&curve)) <= LIMITS.distance);
        // One that ends where it begins, and a rational one.
        let drop =
            [[0.0, 0.0, 0.0], [10.0, 10.0, 0.0], [-10.0, 10.0, 0.0], [0.0, 0.0, 0.0]].map(Point3::from);
        let drop: Curve = NurbsCurve::bezier(&drop).unwrap().into();
        assert!(off(&drop, &drawn(&drop)) <= LIMITS.distance);
        let circle = Curve::from(Circle::new(Plane::XY, 3.0).unwrap()).to_nurbs().unwrap();
        let circle: Curve = circle.into();
        assert!(off(&circle, &drawn(&circle)) <= LIMITS.distance);
    }

    #[test]
    fn straight_runs_are_one_segment_and_kinks_stay() {
        let corners: Vec<Point3> = (0..=40)
            .map(|k| {
                if k <= 20 {
                    Point3::new(f64::from(k), 0.0, 0.0)
                } else {
                    Point3::new(20.0, f64::from(k - 20), 0.0)
                }
            })
            .collect();
        let curve: Curve =
            NurbsCurve::interpolate(1, &corners, KnotSpacing::Chord, None, None).unwrap().into();
        assert_eq!(drawn(&curve).len(), 3);
    }
}
