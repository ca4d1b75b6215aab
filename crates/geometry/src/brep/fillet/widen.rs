//! Straight edges and flat faces made longer than they were, for roundings that run beyond a corner that turns in.

use crate::{
    Curve, Direction, Interval, Line, LineCurve, PlaneSurface, Point3, Result, SumSurface, Surface, Vector3,
};

/// Up to this part of a face's size it is flat and even.
const EVEN: f64 = 1e-10;
/// The part of its size by which a face gets wider than it has to be.
const MARGIN: f64 = 0.01;

/// The segment of a straight curve whose parameter runs evenly along it.
fn segment(curve: &Curve) -> Option<Line> {
    let line = curve.as_line(EVEN * curve.start().distance_to(curve.end()))?;
    let domain = curve.domain();
    let even =
        |x: f64| curve.point_at(domain.at(x)).distance_to(line.from.lerp(line.to, x)) <= EVEN * line.length();
    [0.25, 0.5, 0.75].into_iter().all(even).then_some(line)
}

/// The parameter at which a straight curve, prolonged beyond one end, comes within a distance of a point.
pub(super) fn parameter_beyond(curve: &Curve, at_end: bool, point: Point3, reach: f64) -> Option<f64> {
    let line = segment(curve)?;
    let way = line.to - line.from;
    let x = (point - line.from).dot(way) / way.length_squared();
    let beyond = if at_end { x > 1.0 } else { x < 0.0 };
    (beyond && (line.from + way * x).distance_to(point) <= reach).then(|| curve.domain().at(x))
}

/// A part of a straight curve that may reach beyond its ends, or of any other curve.
pub(super) fn part_of(curve: &Curve, range: Interval) -> Result<Curve> {
    let domain = curve.domain();
    match segment(curve).filter(|_| !domain.includes(range, false)) {
        Some(line) => {
            let at = |t: f64| line.from + (line.to - line.from) * domain.normalized(t);
            Ok(LineCurve { line: Line::new(at(range.start), at(range.end)), domain: range }.into())
        }
        None => curve.trimmed(range),
    }
}

/// A flat surface whose parameters run evenly, made to reach points of its plane: they keep their parameters.
pub(super) fn widened(surface: &Surface, points: &[Point3]) -> Option<Surface> {
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
    let corner = surface.point_at(u.start, v.start);
    let (a, b) = (surface.point_at(u.end, v.start) - corner, surface.point_at(u.start, v.end) - corner);
    let size = a.length() + b.length();
    let even = [(0.25, 0.25), (0.25, 0.75), (0.5, 0.5), (0.75, 0.25), (0.75, 0.75), (1.0, 1.0)].iter().all(
        |(x, y)| surface.point_at(u.at(*x), v.at(*y)).distance_to(corner + a * *x + b * *y) <= EVEN * size,
    );
    if !even {
        return None;
    }
    let mut ranges = [Interval::new(0.0, 1.0); 2];
    for p in points {
        let slopes = [[a.dot(a), a.dot(b)], [a.dot(b), b.dot(b)]];
        let place = super::newton::linear(slopes, [a.dot(*p - corner), b.dot(*p - corner)])?;
        for (range, x) in ranges.iter_mut().zip(place) {
            *range = range.including(x);
        }
    }
    // A little more, so that nothing lies on the border that did not.
    for range in &mut ranges {
        let more = MARGIN * range.length();
        *range = Interval::new(
            if range.start < 0.0 { range.start - more } else { 0.0 },
            if range.end > 1.0 { range.end + more } else { 1.0 },
        );
    }
    let domains = [(u, ranges[0]), (v, ranges[1])].map(|(d, r)| Interval::new(d.at(r.start), d.at(r.end)));
    let along = |v: Vector3, range: Interval, from: Point3, domain: Interval| -> Curve {
        LineCurve { line: Line::new(from + v * range.start, from + v * range.end), domain }.into()
    };
    match surface {
        Surface::Plane(own) => {
            let wide = |extent: Interval, range: Interval| {
                Interval::new(extent.at(range.start), extent.at(range.end))
            };
            let [x, y] = own.extents();
            let extents = [wide(x, ranges[0]), wide(y, ranges[1])];
            Some(PlaneSurface::with_domains(*own.plane(), extents, domains).ok()?.into())
        }
        _ => {
            let first = along(a, ranges[0], corner, domains[0]);
            let second = along(b, ranges[1], Point3::ORIGIN, domains[1]);
            Some(SumSurface::new(first, second, Vector3::ZERO).ok()?.into())
        }
    }
}
