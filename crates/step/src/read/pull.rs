//! Edges in the parameter planes of their faces.

use super::support::{Form, Pole, Support};
use crate::Result;
use katydid_geometry::{Curve, Line, LineCurve, NurbsCurve, Point3, brep};

/// Places looked at in each smooth piece of an edge.
const PLACES: usize = 12;
/// Pieces of a fitted curve are halved so often at most.
const MOST_HALVINGS: u32 = 10;
/// How far a seam may stray from its parameter, as a part of its size.
const STRAY: f64 = 1e-3;
/// Most places looked at along one edge.
const MOST_PLACES: usize = 2000;

/// An edge in a parameter plane, walked as the edge is.
#[derive(Clone)]
pub(super) struct Flat {
    pub(super) curve: Curve,
    /// The poles at its ends.
    pub(super) poles: [Option<Pole>; 2],
}

impl Flat {
    pub(super) fn reversed(&self) -> Self {
        Self { curve: self.curve.reversed(), poles: [self.poles[1], self.poles[0]] }
    }
}

/// A place along an edge.
#[derive(Clone, Copy)]
struct Place {
    t: f64,
    uv: [f64; 2],
    pole: Option<Pole>,
}

/// Pulls an edge onto the support of a face: exactly where it is a line or an arc in a plane, or runs along a parameter;
/// else within a distance. A seam runs along a parameter, however far it strays from there.
pub(super) fn pull(support: &Support, edge: &Curve, tolerance: f64, is_seam: bool) -> Result<Flat> {
    if let Form::Plane(plane) = &support.form {
        return Ok(Flat { curve: brep::flattened(edge, plane)?, poles: [None, None] });
    }
    let places = places(support, edge, tolerance)?;
    let (Some(first), Some(last)) = (places.first(), places.last()) else {
        return Err(katydid_geometry::Error::Degenerate { what: "edge", why: "it has no places" }.into());
    };
    let poles = [first.pole, last.pole];
    let straight = if is_seam { STRAY * edge.bounding_box().diagonal().length() } else { tolerance };
    for d in 0..2 {
        let still = |place: &Place| {
            let mut moved = place.uv;
            moved[d] = first.uv[d];
            support.point(moved).distance_to(support.point(place.uv)) <= straight
        };
        // A place at a pole may be anywhere along it.
        let reference = places.iter().find(|place| place.pole.is_none()).unwrap_or(first).uv[d];
        let reference = if is_seam { support.on_seam(d, reference) } else { reference };
        let is_still = places.iter().all(|place| {
            let mut moved = *place;
            moved.uv[d] = if place.pole.is_some() { first.uv[d] } else { place.uv[d] };
            still(&moved)
        });
        if is_still {
            let at = |place: &Place| {
                let mut uv = place.uv;
                uv[d] = reference;
                Point3::new(uv[0], uv[1], 0.0)
            };
            let line = Line::new(at(first), at(last));
            return Ok(Flat { curve: LineCurve { line, domain: edge.domain() }.into(), poles });
        }
    }
    Ok(Flat { curve: fitted(support, edge, &places, tolerance)?, poles })
}

/// Parameters of an edge at which its smooth pieces meet.
fn joints(edge: &Curve) -> Vec<f64> {
    let domain = edge.domain();
    let mut out = vec![domain.start];
    match edge {
        Curve::Nurbs(c) => out.extend(c.span_parameters()),
        Curve::Polyline(c) => out.extend(c.parameters()),
        Curve::Poly(c) => out.extend(c.parameters()),
        Curve::Line(_) | Curve::Arc(_) => {}
    }
    out.push(domain.end);
    out.dedup_by(|a, b| *a <= *b);
    out
}

/// Places along an edge, near enough that neighbours are less than half a turn apart.
fn places(support: &Support, edge: &Curve, tolerance: f64) -> Result<Vec<Place>> {
    let joints = joints(edge);
    let each = PLACES.min(MOST_PLACES / joints.len().max(1)).max(2);
    let mut out: Vec<Place> = Vec::new();
    for span in joints.windows(2) {
        let from = usize::from(!out.is_empty());
        for k in from..=each {
            let t = if k == each { span[1] } else { span[0] + (span[1] - span[0]) * k as f64 / each as f64 };
            let uv = support.parameters(edge.point_at(t))?;
            let pole = support.pole(uv, tolerance);
            out.push(Place { t, uv, pole });
        }
    }
    unwrap(support, &mut out);
    Ok(out)
}

/// Makes the parameters of places go on from one to the next; those at poles take their neighbour's.
fn unwrap(support: &Support, places: &mut [Place]) {
    for d in 0..2 {
        let is_free = |place: &Place| place.pole.is_some_and(|pole| pole.free == d);
        let mut last: Option<f64> = None;
        for place in places.iter_mut().filter(|place| !is_free(place)) {
            if let (Some(last), Some(period)) = (last, support.periods[d]) {
                place.uv[d] += period * ((last - place.uv[d]) / period).round();
            }
            last = Some(place.uv[d]);
        }
        let known: Vec<Option<f64>> = places.iter().map(|p| (!is_free(p)).then_some(p.uv[d])).collect();
        for (k, place) in places.iter_mut().enumerate().filter(|(k, _)| known[*k].is_none()) {
            let after = known[k..].iter().flatten().next();
            let before = known[..k].iter().rev().flatten().next();
            if let Some(value) = after.or(before) {
                place.uv[d] = *value;
            }
        }
    }
}

/// Cubic pieces through places, with the directions of the edge, halved until they are within the distance.
fn fitted(support: &Support, edge: &Curve, places: &[Place], tolerance: f64) -> Result<Curve> {
    let mut points: Vec<Point3> = Vec::new();
    let mut knots: Vec<f64> = Vec::new();
    let domain = edge.domain();
    for pair in places.windows(2) {
        let mut stack = vec![(pair[0], pair[1], 0)];
        while let Some((a, b, depth)) = stack.pop() {
            let piece = hermite(support, edge, &a, &b);
            let middle = 0.5 * (a.t + b.t);
            let away = |place: &Place| support.point(place.uv).distance_to(edge.point_at(place.t));
            // The edge may lie off the surface: no halving brings the surface to it.
            let lift = 2.0 * away(&a).max(away(&b));
            let is_near = [0.25, 0.5, 0.75].iter().all(|x| {
                let (uv, point) = (bezier(&piece, *x), edge.point_at(a.t + (b.t - a.t) * x));
                beside(support, uv, point, lift) <= tolerance
            });
            if !is_near && depth < MOST_HALVINGS && middle > a.t && middle < b.t && points.len() < 20_000 {
                let mut uv = support.parameters(edge.point_at(middle))?;
                for (d, value) in uv.iter_mut().enumerate() {
                    if let Some(period) = support.periods[d] {
                        let guess = 0.5 * (a.uv[d] + b.uv[d]);
                        *value += period * ((guess - *value) / period).round();
                    }
                }
                let place = Place { t: middle, uv, pole: None };
                stack.push((place, b, depth + 1));
                stack.push((a, place, depth + 1));
                continue;
            }
            if points.is_empty() {
                points.push(flat(piece[0]));
                knots.extend([a.t; 3]);
            }
            points.extend(piece[1..].iter().map(|uv| flat(*uv)));
            knots.extend([b.t; 3]);
        }
    }
    if let Some(last) = knots.last_mut() {
        *last = domain.end;
    }
    let count = knots.len();
    knots.iter_mut().skip(count.saturating_sub(3)).for_each(|t| *t = domain.end);
    Ok(NurbsCurve::new(3, points, knots)?.into())
}

/// How far a place is from a point, along the surface if the point is above the place by no more than a lift.
fn beside(support: &Support, uv: [f64; 2], point: Point3, lift: f64) -> f64 {
    let way = point - support.point(uv);
    let [x, y] = support.partials(uv, uv);
    let Some(up) = x.cross(y).unitized() else { return way.length() };
    let above = way.dot(up);
    if above.abs() <= lift { (way - up * above).length() } else { way.length() }
}

fn flat(uv: [f64; 2]) -> Point3 {
    Point3::new(uv[0], uv[1], 0.0)
}

/// The four points of a cubic from one place to the next.
fn hermite(support: &Support, edge: &Curve, a: &Place, b: &Place) -> [[f64; 2]; 4] {
    let third = (b.t - a.t) / 3.0;
    let chord = [0, 1].map(|d| (b.uv[d] - a.uv[d]) / (b.t - a.t));
    let slope = |place: &Place, other: &Place, from_below: bool| {
        if place.pole.is_some() {
            return chord;
        }
        let mut jet = [katydid_geometry::Vector3::ZERO; 2];
        edge.derivatives_into(place.t, from_below, &mut jet);
        let [x, y] = support.partials(place.uv, other.uv);
        // Least squares of x·du + y·dv = the edge's derivative.
        let (xx, xy, yy) = (x.dot(x), x.dot(y), y.dot(y));
        let determinant = xx * yy - xy * xy;
        if determinant.is_nan() || determinant <= 1e-14 * xx * yy {
            return chord;
        }
        let (p, q) = (x.dot(jet[1]), y.dot(jet[1]));
        [(p * yy - q * xy) / determinant, (q * xx - p * xy) / determinant]
    };
    let (s, e) = (slope(a, b, false), slope(b, a, true));
    let at = |uv: [f64; 2], slope: [f64; 2], h: f64| [uv[0] + slope[0] * h, uv[1] + slope[1] * h];
    [a.uv, at(a.uv, s, third), at(b.uv, e, -third), b.uv]
}

fn bezier(p: &[[f64; 2]; 4], x: f64) -> [f64; 2] {
    let y = 1.0 - x;
    let w = [y * y * y, 3.0 * x * y * y, 3.0 * x * x * y, x * x * x];
    [0, 1].map(|d| (0..4).map(|k| w[k] * p[k][d]).sum())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a failing test may panic")]

    use super::*;
    use katydid_geometry::{Direction, Interval, SumSurface, Surface, Vector3};

    /// A closed curve with a kink where it closes, raised at its control points.
    fn ring(heights: [f64; 7]) -> Curve {
        let corners = [[0.0, 0.0], [4.0, -1.0], [7.0, 2.0], [5.0, 6.0], [1.0, 7.0], [-2.0, 3.0], [0.0, 0.0]];
        let points: Vec<Point3> =
            corners.iter().zip(heights).map(|([x, y], z)| Point3::new(*x, *y, z)).collect();
        NurbsCurve::clamped_uniform(3, &points).unwrap().into()
    }

    #[test]
    fn edges_that_go_round_a_surface_with_a_kinked_seam_stay_on_it() {
        let line = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 9.0));
        let rise: Curve = LineCurve { line, domain: Interval::new(0.0, 9.0) }.into();
        let side = SumSurface::new(ring([0.0; 7]), rise, Vector3::ZERO).unwrap();
        let support = Support::free(side.clone().into()).unwrap();
        let wavy = ring([2.0, 3.0, 8.0, 1.0, 5.0, 4.0, 2.0]);
        // From the seam round, across the seam, and both the other way.
        let across = wavy.with_seam(wavy.domain().at(0.3)).unwrap();
        for edge in [wavy.reversed(), across.reversed(), wavy, across] {
            let flat = pull(&support, &edge, 1e-6, false).unwrap().curve;
            let period = support.periods[0].unwrap();
            assert!(((flat.end().x - flat.start().x).abs() - period).abs() < 1e-9);
            let surface = Surface::from(side.clone());
            let from = surface.domain(Direction::U).start;
            let mut before = None;
            for k in 0..=500 {
                let x = f64::from(k) / 500.0;
                let uv = flat.point_at(flat.domain().at(x));
                let u = from + (uv.x - from).rem_euclid(period);
                let apart = surface.point_at(u, uv.y).distance_to(edge.point_at(edge.domain().at(x)));
                assert!(apart < 2e-6, "{apart} off at {x}");
                if let Some(before) = before {
                    assert!((uv.x - before) * (flat.end().x - flat.start().x) > 0.0, "it turns back at {x}");
                }
                before = Some(uv.x);
            }
        }
    }

    /// Viviani's curve from the equator to the pole, as an intersection is written: through points, and a little off
    /// the ball.
    #[test]
    fn edges_off_a_ball_reach_its_pole_in_few_pieces() {
        let (radius, lift, tolerance) = (4.0, 1e-4, 1e-7);
        let form = Form::Sphere { plane: katydid_geometry::Plane::XY, radius };
        let support = Support::new(form).unwrap();
        let at = |k: u32| {
            let (sin, cos) = (f64::from(k) / 40.0 * std::f64::consts::FRAC_PI_2).sin_cos();
            (Vector3::new(cos * cos, cos * sin, sin) * (radius + lift)).to_point()
        };
        let points: Vec<Point3> = (0..=40).map(at).collect();
        let spacing = katydid_geometry::KnotSpacing::Chord;
        let edge: Curve = NurbsCurve::interpolate(5, &points, spacing, None, None).unwrap().into();
        let flat = pull(&support, &edge, tolerance, false).unwrap().curve;
        let Curve::Nurbs(spline) = &flat else { panic!("a cubic is wanted") };
        assert!(spline.control_points().len() < 3_000, "{}", spline.control_points().len());
        assert!((flat.end().y - std::f64::consts::FRAC_PI_2).abs() < 1e-9);
        assert!(flat.bounding_box().max.x > std::f64::consts::FRAC_PI_2 - 1e-3, "it stops short of the pole");
        for k in 0..=300 {
            let x = f64::from(k) / 300.0;
            let (uv, point) = (flat.point_at(flat.domain().at(x)), edge.point_at(edge.domain().at(x)));
            let foot = point.to_vector().unitized().unwrap() * radius;
            let apart = support.point([uv.x, uv.y]).distance_to(foot.to_point());
            assert!(apart < 3.0 * tolerance, "{apart} off at {x}");
        }
    }
}
