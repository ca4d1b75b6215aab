//! Surfaces: extrusions, offsets, nearest points, and curves on them.

use katydid_elementary::Elementary;
use katydid_geometry::construct::{extrude_to_point, offset_surface, offset_surface_variably};
use katydid_geometry::{
    Curve, Direction, Interval, NurbsSurface, Point2, Point3, SumSurface, Surface, Tolerance, Vector3,
};

use super::answer::{Outcome, or_null};
use super::argument::Within;
use super::nurbs_surface::sole_surface;
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("surface/createextrusion-curve_vector3d", |profile: Curve, direction: Vector3| {
        Ok(Surface::from(SumSurface::extrusion(profile, direction)?))
    });
    table.add("surface/createextrusiontopoint-curve_point3d", |profile: Curve, apex: Point3| {
        match NurbsSurface::to_apex(&profile.to_nurbs()?, apex) {
            Ok(surface) => Ok(Surface::from(surface)),
            Err(_) => sole_surface(&extrude_to_point(&profile, apex, false, &Tolerance::default())?),
        }
    });
    table.add("surface/closestpoint-surface_point3d_double_double", |s: Surface, p: Point3| {
        let found = s.closest_point(p)?;
        Ok((true, found.u, found.v))
    });
    table.add("surface/localclosestpoint-surface_point3d_double_double_double_double", nearest_from);
    table.add("surface/offset-surface_double_double", |s: Surface, distance: f64, t: Within| {
        Ok(offset_surface(&s, distance, &t.tolerance())?)
    });
    table.add(
        "surface/shortpath-surface_point2d_point2d_double",
        |s: Surface, a: Point2, b: Point2, t: Within| {
            Ok(s.geodesic([a.x, a.y], [b.x, b.y], &t.tolerance())?.curve)
        },
    );
    table.add("surface/pullback-surface_curve_double", |s: Surface, c: Curve, t: Within| {
        Ok(s.parameter_curve(&c, &t.tolerance())?)
    });
    table.add(
        "surface/pullback-surface_curve_double_interval",
        |s: Surface, c: Curve, t: Within, part: Interval| {
            Ok(s.parameter_curve(&c.sub_curve(part.ordered())?, &t.tolerance())?)
        },
    );
    table.add("surface/pushup-surface_curve_double", |s: Surface, c: Curve, t: Within| {
        Ok(s.image_of(&c, &t.tolerance())?)
    });
    table.add(
        "surface/pushup-surface_curve_double_interval",
        |s: Surface, c: Curve, t: Within, part: Interval| {
            Ok(s.image_of(&c.sub_curve(part.ordered())?, &t.tolerance())?)
        },
    );
    table.add(
        "surface/variableoffset-surface_double_double_double_double_double",
        |s: Surface, a: f64, b: f64, c: f64, d: f64, t: Within| {
            or_null(offset_surface_variably(&s, [a, b, c, d], &t.tolerance()).map_err(Fault::from))
        },
    );
    table.add("surface/closestside-surface_double_double", closest_side);
}

/// Of the points that are nearest among their neighbours the one whose parameters are nearest to a seed, as shares of
/// the domains.
fn nearest_from(surface: Surface, point: Point3, u: f64, v: f64) -> Outcome<(bool, f64, f64)> {
    let [us, vs] = Direction::BOTH.map(|direction| surface.domain(direction).length());
    let found = surface.local_closest_points(point)?;
    let far = |a: f64, b: f64| ((a - u) / us).hypotenuse((b - v) / vs);
    let best = found.points.iter().min_by(|a, b| far(a.u, a.v).total_cmp(&far(b.u, b.v)));
    Ok(best.map_or((false, 0.0, 0.0), |best| (true, best.u, best.v)))
}

/// `IsoStatus`: the side that is nearest by parameters: 3 west, 4 south, 5 east, 6 north.
fn closest_side(surface: Surface, u: f64, v: f64) -> Outcome<i32> {
    let [us, vs] = Direction::BOTH.map(|direction| surface.domain(direction));
    for (name, domain, t) in [("u", us, u), ("v", vs, v)] {
        if !domain.contains(t) {
            return Err(Fault::bad_request(format!("{name} is {t}, outside the domain")));
        }
    }
    let (x, y) = (us.normalized(u), vs.normalized(v));
    let sides = [(3, x), (4, y), (5, 1.0 - x), (6, 1.0 - y)];
    let nearest = sides.into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
    Ok(nearest.map_or(0, |(side, _)| side))
}
