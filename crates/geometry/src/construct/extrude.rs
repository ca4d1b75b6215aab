//! Curves and faces drawn along a direction, along a curve or to a point.

use super::walls::{Way, drawn_out};
use super::{cap_plane, check};
use crate::{
    Brep, Curve, Error, NurbsSurface, Point3, Result, SumSurface, Surface, Tolerance, Vector3, Xform,
};

/// The surface that a curve draws along a straight way: u runs along the curve over its domain, v over 0…the
/// length of `direction`; one face for each stretch of the curve without a kink. Arcs and lines stay what they are.
///
/// With `capped` a closed planar curve gives a solid.
///
/// # Errors
/// The direction has no length, or is that of a straight curve; with caps, a curve that is open, not planar, or in
/// whose plane the direction lies.
pub fn extrude(profile: &Curve, direction: Vector3, capped: bool, tolerance: &Tolerance) -> Result<Brep> {
    let limit = check(&[profile], tolerance)?;
    let surface: Surface = SumSurface::extrusion(profile.clone(), direction)?.into();
    if capped {
        let plane = cap_plane(profile, limit)?;
        if !(direction.dot(plane.z_axis).abs() > limit) {
            return Err(Error::degenerate("extrusion", "its direction lies in the plane of the profile"));
        }
    }
    closed_if(capped, Brep::from_kinked_surface(&surface, tolerance)?, tolerance)
}

/// The surface that a curve draws when its start moves along another curve without turning: S(u, v) = A(u) + B(v) −
/// B(start).
///
/// # Errors
/// The surface has no area; with caps, a profile that is open or not planar, or a path that is closed.
pub fn extrude_along(profile: &Curve, path: &Curve, capped: bool, tolerance: &Tolerance) -> Result<Brep> {
    let limit = check(&[profile, path], tolerance)?;
    let shift = -path.start().to_vector();
    let surface: Surface = SumSurface::new(profile.clone(), path.clone(), shift)?.into();
    if capped {
        cap_plane(profile, limit)?;
        if path.is_closed() {
            return Err(Error::degenerate("extrusion", "along a closed path it has no caps"));
        }
    }
    closed_if(capped, Brep::from_kinked_surface(&surface, tolerance)?, tolerance)
}

/// The cone over a curve: straight from each of its points to an apex; u runs along the curve, v from it, at 0, to
/// the apex, at 1.
///
/// # Errors
/// The surface has no area; with caps, a curve that is open or not planar, or in whose plane the apex lies.
pub fn extrude_to_point(profile: &Curve, apex: Point3, capped: bool, tolerance: &Tolerance) -> Result<Brep> {
    let limit = check(&[profile], tolerance)?;
    if capped {
        let plane = cap_plane(profile, limit)?;
        if !(plane.signed_distance(apex).abs() > limit) {
            return Err(Error::degenerate("extrusion", "its apex lies in the plane of the profile"));
        }
    }
    let surface: Surface = NurbsSurface::to_apex(&profile.to_nurbs()?, apex)?.into();
    closed_if(capped, Brep::from_kinked_surface(&surface, tolerance)?, tolerance)
}

/// Fills the planar holes when asked to.
fn closed_if(capped: bool, brep: Brep, tolerance: &Tolerance) -> Result<Brep> {
    if !capped {
        return Ok(brep);
    }
    let (closed, _) = brep.capped(tolerance)?;
    if closed.is_solid() {
        return Ok(closed);
    }
    Err(Error::degenerate("extrusion", "its ends could not be capped"))
}

/// The solid that an open brep draws along a straight way: the brep, its moved copy, and walls along naked edges.
///
/// # Errors
/// The direction has no length; the brep has no naked edges, or walls and faces do not meet.
pub fn extrude_brep(base: &Brep, direction: Vector3, tolerance: &Tolerance) -> Result<Brep> {
    tolerance.positive_distance()?;
    drawn_out(base, &Way::Straight(direction))
}

/// The solid that an open brep draws when it moves along a curve without turning. At kinks of the curve walls are cut.
///
/// # Errors
/// As [`extrude_brep`]; also a closed path.
pub fn extrude_brep_along(base: &Brep, path: &Curve, tolerance: &Tolerance) -> Result<Brep> {
    check(&[path], tolerance)?;
    if path.is_closed() {
        return Err(Error::degenerate("extrusion", "along a closed path it has no ends"));
    }
    if path.smooth_runs(tolerance)?.len() == 1 {
        return drawn_out(base, &Way::Along(path));
    }
    let shift = -path.start().to_vector();
    let top = base.transformed(&Xform::translation(path.end() - path.start()))?;
    let mut all = vec![base.clone(), top];
    for edge in base.naked_edges() {
        if let Some(curve) = base.edge_as_curve(edge)? {
            let wall = SumSurface::new(curve, path.clone(), shift)?.into();
            all.push(Brep::from_kinked_surface(&wall, tolerance)?);
        }
    }
    let whole = Brep::joined_into_one(&all, tolerance)?;
    if whole.is_solid() {
        return Ok(whole);
    }
    Err(Error::degenerate("extrusion", "its faces do not close"))
}

/// The solid between an open brep and a point.
///
/// # Errors
/// The brep has no naked edges, or the apex lies on it.
pub fn extrude_brep_to_point(base: &Brep, apex: Point3, tolerance: &Tolerance) -> Result<Brep> {
    tolerance.positive_distance()?;
    drawn_out(base, &Way::To(apex))
}
