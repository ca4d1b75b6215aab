//! Curves turned about an axis.

use katydid_elementary::Elementary;

use super::check;
use crate::construct::thresholds::NO_ANGLE;
use crate::nurbs::check_net;
use crate::thresholds;
use crate::{
    Brep, Curve, Error, Interval, Line, NurbsSurface, Plane, Point3, Result, RevolutionSurface, Surface,
    Tolerance, Vector3, cancellation,
};

/// The surface of a curve turned about an axis between two angles in radians, by the right-hand rule from the axis'
/// start to its end; angle 0 is where the curve lies. u is the angle, v runs along the curve; one face for each
/// stretch of the curve without a kink. Ends of the curve on the axis become singular points; a whole turn closes.
/// Angles more than a turn apart count as a whole turn; decreasing ones are exchanged.
///
/// # Errors
/// The axis has no direction, the angles are equal, or the surface has no area: the curve lies on the axis.
pub fn revolve(profile: &Curve, axis: Line, angle: Interval, tolerance: &Tolerance) -> Result<Brep> {
    check(&[profile], tolerance)?;
    if !angle.is_finite() {
        return Err(Error::NotFinite("angle of revolution"));
    }
    let turn = std::f64::consts::TAU;
    let mut angle = angle.ordered();
    if angle.length() > turn - NO_ANGLE {
        angle = Interval::new(angle.start, angle.start + turn);
    }
    let surface: Surface = RevolutionSurface::new(profile.clone(), axis, angle)?.into();
    Brep::from_kinked_surface(&surface, tolerance)
}

/// A curve turned about an axis so that it follows a rail: at every place of the rail the curve is turned towards it
/// and scaled away from the axis as the rail's distance goes. With `scale_height` heights along the axis are scaled
/// too, about the end of the curve that is nearer to the axis, as the rail's height goes; else they stay.
///
/// u runs along the rail, v along the curve. The surface is exact: of the degree of the rail in u and of the curve
/// in v, rational when one of them is.
///
/// # Errors
/// The axis has no direction, the rail starts on it, or with `scale_height` the curve has no height there; the
/// surface has no area.
pub fn rail_revolve(
    profile: &Curve,
    rail: &Curve,
    axis: Line,
    scale_height: bool,
    tolerance: &Tolerance,
) -> Result<Brep> {
    check(&[profile, rail], tolerance)?;
    let unit = axis.unit_direction().ok_or(Error::degenerate("axis of revolution", "it has no direction"))?;
    let start = rail.start() - axis.from;
    let arm = (start - unit * start.dot(unit))
        .unitized()
        .ok_or(Error::degenerate("rail", "it starts on the axis"))?;
    let frame = Plane { origin: axis.from, x_axis: arm, y_axis: unit.cross(arm), z_axis: unit };
    let [reach, _, base] = frame.coordinates(rail.start());
    if !(reach > 0.0) {
        return Err(Error::degenerate("rail", "it starts on the axis"));
    }
    let (rail, profile) = (rail.to_nurbs()?, profile.to_nurbs()?);
    let local = |list: Vec<[f64; 4]>| -> Vec<[f64; 4]> {
        let coordinates = |[x, y, z, w]: [f64; 4]| {
            let p = Vector3::new(x, y, z) - axis.from.to_vector() * w;
            [p.dot(frame.x_axis), p.dot(frame.y_axis), p.dot(frame.z_axis), w]
        };
        list.into_iter().map(coordinates).collect()
    };
    let (foot, far) = foot_of(&profile, &frame);
    if scale_height && !((base - foot).abs() > thresholds::ROUNDING * (base.abs() + foot.abs() + far)) {
        return Err(Error::degenerate("rail", "it starts at the height of the curve's foot"));
    }
    let mut net = Vec::new();
    check_net([rail.point_count(), profile.point_count()])?;
    let (along, across) = (local(rail.homogeneous_points()), local(profile.homogeneous_points()));
    for r in &along {
        cancellation::check()?;
        for p in &across {
            let w = r[3] * p[3];
            // The plane across the axis as complex numbers: turned and scaled by the rail's over its first.
            let x = (p[0] * r[0] - p[1] * r[1]) / reach;
            let y = (p[0] * r[1] + p[1] * r[0]) / reach;
            let z = if scale_height {
                foot * w + (p[2] - foot * p[3]) * ((r[2] - foot * r[3]) / (base - foot))
            } else {
                p[2] * r[3]
            };
            let place = frame.origin.to_vector() * w + frame.x_axis * x + frame.y_axis * y + frame.z_axis * z;
            net.push([place.x, place.y, place.z, w]);
        }
    }
    let degrees = [rail.degree(), profile.degree()];
    let counts = [rail.point_count(), profile.point_count()];
    let knots = [rail.knots().to_vec(), profile.knots().to_vec()];
    let surface = if rail.is_rational() || profile.is_rational() {
        NurbsSurface::rational(degrees, counts, net, knots)?
    } else {
        let plain = net.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
        NurbsSurface::new(degrees, counts, plain, knots)?
    };
    Brep::from_kinked_surface(&surface.into(), tolerance)
}

/// The height of the end of a curve that is nearer to the axis, and the curve's size.
fn foot_of(profile: &crate::NurbsCurve, frame: &Plane) -> (f64, f64) {
    let domain = profile.domain();
    let [a, b] = [domain.start, domain.end].map(|t| frame.coordinates(profile.point_at(t)));
    let nearer = if a[0].hypotenuse(a[1]) <= b[0].hypotenuse(b[1]) { a } else { b };
    (nearer[2], (a[2] - b[2]).abs())
}
