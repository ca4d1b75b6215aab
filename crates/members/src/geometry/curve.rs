//! Curves: nearest points, frames, extremes, and how points and curves lie to each other.

use katydid_geometry::intersect::nearest_on_curves;
use katydid_geometry::{Containment, Curve, Plane, Point3, Vector3};

use super::answer::Outcome;
use super::argument::{Positive, Within};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("curve/closestpoint-curve_point3d_double", |c: Curve, p: Point3| nearest(&c, p, 0.0));
    table.add("curve/closestpoint-curve_point3d_double_double", |c: Curve, p: Point3, most: Option<f64>| {
        nearest(&c, p, most.unwrap_or(0.0))
    });
    table.add("curve/localclosestpoint-curve_point3d_double_double", nearest_from);
    table.add("curve/lcoalclosestpoint-curve_point3d_double_double", nearest_from);
    table.add("curve/closestpoints-curve_curve_point3d_point3d", |a: Curve, b: Curve| {
        let pair = nearest_on_curves(&a, &b, 1e-9)?;
        Ok((true, pair.point_a, pair.point_b))
    });
    table.add("curve/contains-curve_point3d", |c: Curve, p: Point3| contains(&c, p, Plane::XY, 1e-8));
    table.add("curve/contains-curve_point3d_plane", |c: Curve, p: Point3, plane: Plane| {
        contains(&c, p, plane, 1e-8)
    });
    table.add("curve/contains-curve_point3d_plane_double", |c: Curve, p: Point3, plane: Plane, t: Within| {
        contains(&c, p, plane, t.0)
    });
    table.add("curve/extremeparameters-curve_vector3d", |c: Curve, d: Vector3| Ok(c.turning_points(d)?));
    table.add("curve/perpendicularframeat-curve_double_plane", |c: Curve, t: f64| {
        let frame = c.domain().contains(t).then(|| c.perpendicular_frame_at(t)).flatten();
        Ok((frame.is_some(), frame))
    });
    table.add("curve/getperpendicularframes-curve_doublearray", perpendicular_frames);
    table.add("curve/inflectionpoints-curve", |c: Curve| {
        Ok(c.inflections(1e-9).into_iter().map(|t| c.point_at(t)).collect::<Vec<_>>())
    });
    table.add("curve/maxcurvaturepoints-curve", |c: Curve| {
        let maxima = c.curvature_extrema().into_iter().filter(|extremum| extremum.is_maximum);
        Ok(maxima.map(|extremum| c.point_at(extremum.parameter)).collect::<Vec<_>>())
    });
    table.add("curve/dodirectionsmatch-curve_curve", |a: Curve, b: Curve| directions_match(&a, &b));
    table.add("curve/divideascontour-curve_point3d_point3d_double", as_contour);
}

/// The nearest point's parameter; a greatest distance of 0 is none.
fn nearest(curve: &Curve, point: Point3, most: f64) -> Outcome<(bool, f64)> {
    if most < 0.0 {
        return Err(Fault::bad_request(format!("maximumDistance is {most}, below 0")));
    }
    let found =
        if most > 0.0 { curve.closest_point_within(point, most)? } else { Some(curve.closest_point(point)?) };
    Ok((found.is_some(), found.map_or(0.0, |found| found.parameter)))
}

/// Of the points that are nearest among their neighbours the one whose parameter is nearest to a seed.
fn nearest_from(curve: Curve, point: Point3, seed: f64) -> Outcome<(bool, f64)> {
    let found = curve.local_closest_points(point)?;
    let best = found.iter().min_by(|a, b| (a.parameter - seed).abs().total_cmp(&(b.parameter - seed).abs()));
    Ok((best.is_some(), best.map_or(0.0, |best| best.parameter)))
}

/// `PointContainment`: 1 inside, 2 outside, 3 on the curve; 0 for a curve that does not close.
fn contains(curve: &Curve, point: Point3, plane: Plane, tolerance: f64) -> Outcome<i32> {
    if !curve.is_closed() {
        return Ok(0);
    }
    Ok(match curve.contains_in_plane(point, &plane, tolerance)? {
        Containment::Inside => 1,
        Containment::Outside => 2,
        Containment::On => 3,
    })
}

fn perpendicular_frames(curve: Curve, parameters: Vec<f64>) -> Outcome<Option<Vec<Plane>>> {
    if parameters.windows(2).any(|pair| pair.first() >= pair.last()) {
        return Err(Fault::bad_request("parameters do not increase"));
    }
    Ok(curve.perpendicular_frames(&parameters).into_iter().collect())
}

/// Places at which the directions of two curves are compared.
const PLACES: u8 = 16;

/// Whether two curves run side by side: at most places of the first the second, where it is nearest, runs along.
fn directions_match(a: &Curve, b: &Curve) -> Outcome<bool> {
    let mut balance = 0;
    for place in 0..PLACES {
        let t = a.domain().at((f64::from(place) + 0.5) / f64::from(PLACES));
        let near = b.closest_point(a.point_at(t))?;
        if let (Some(own), Some(other)) = (a.tangent_at(t), b.tangent_at(near.parameter)) {
            balance += if own.dot(other) > 0.0 { 1 } else { -1 };
        }
    }
    Ok(balance > 0)
}

/// The most planes of a contour.
const MOST_PLANES: f64 = 1e5;

/// The planes between two points at an interval, both ends counted.
pub(super) fn contour_planes(
    start: Point3,
    end: Point3,
    Positive(interval): Positive,
) -> Outcome<Vec<Plane>> {
    let direction = (end - start).unitized();
    let direction = direction.ok_or_else(|| Fault::bad_request("contourStart and contourEnd coincide"))?;
    // The last plane may miss the end by rounding.
    let count = (start.distance_to(end) / interval + 1e-9).floor();
    if count > MOST_PLANES {
        return Err(Fault::too_large(format!("interval {interval} gives more than {MOST_PLANES} sections")));
    }
    let first = Plane::from_normal(start, direction)?;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 100,000")]
    let count = count as u32;
    Ok((0..=count).map(|k| first.with_origin(start + direction * (interval * f64::from(k)))).collect())
}

fn as_contour(curve: Curve, start: Point3, end: Point3, interval: Positive) -> Outcome<Vec<Point3>> {
    let mut points = Vec::new();
    for plane in contour_planes(start, end, interval)? {
        points.extend(curve.intersect_plane(&plane, 0.0)?.into_iter().map(|t| curve.point_at(t)));
    }
    Ok(points)
}
