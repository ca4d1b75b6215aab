//! Solids by their numbers.

use std::f64::consts::{FRAC_PI_2, TAU};

use katydid_geometry::{
    Arc, Box3, Brep, Circle, Curve, Cylinder, Interval, Line, Plane, Point3, PolyCurve, PolylineCurve,
    Result, Sphere, Tolerance, Torus, construct,
};

/// Within what construction closes gaps, as a part of the size.
fn within(size: f64) -> Tolerance {
    Tolerance { absolute: 1e-9 * size, ..Tolerance::default() }
}

/// A box from a frame's origin along its axes.
pub(crate) fn cuboid(frame: &Plane, [x, y, z]: [f64; 3]) -> Result<Brep> {
    let range = |x: f64| Interval::new(0.0, x);
    construct::box_brep(&Box3 { plane: *frame, x: range(x), y: range(y), z: range(z) })
}

/// A wedge: a box whose upper face, at the height of y, spans other x and z.
pub(crate) fn wedge(frame: &Plane, [dx, dy, dz]: [f64; 3], [x0, z0, x1, z1]: [f64; 4]) -> Result<Brep> {
    let p = |x: f64, y: f64, z: f64| frame.at(x, y, z);
    let bottom = [p(0.0, 0.0, 0.0), p(dx, 0.0, 0.0), p(dx, 0.0, dz), p(0.0, 0.0, dz)];
    let top = [p(x0, dy, z0), p(x1, dy, z0), p(x1, dy, z1), p(x0, dy, z1)];
    let mut faces: Vec<Vec<Point3>> = vec![bottom.to_vec(), top.to_vec()];
    for k in 0..4 {
        let j = (k + 1) % 4;
        faces.push(vec![bottom[k], bottom[j], top[j], top[k]]);
    }
    let t = within(dx.max(dy).max(dz));
    let mut parts = Vec::new();
    for mut face in faces {
        face.dedup();
        if face.first() == face.last() {
            face.pop();
        }
        face.extend(face.first().copied());
        let edge: Curve = PolylineCurve::new(face)?.into();
        parts.extend(Brep::planar_faces(&[edge], &t)?.breps);
    }
    let joined = Brep::join(&parts, &t)?.breps;
    joined.into_iter().next().ok_or(katydid_geometry::Error::Unsupported("wedge"))
}

/// A whole ball, or a part between latitudes and over some longitudes, in radians.
pub(crate) fn ball(frame: &Plane, r: f64, latitude: Option<Interval>, longitude: f64) -> Result<Brep> {
    if latitude.is_none() && longitude >= TAU - 1e-12 {
        return construct::sphere(&Sphere::new(*frame, r)?);
    }
    let latitude = latitude.unwrap_or(Interval::new(-FRAC_PI_2, FRAC_PI_2));
    let plane = meridian(frame)?;
    let arc: Curve = Arc::new(Circle::new(plane, r)?, latitude)?.into();
    let (a, b) = (arc.start(), arc.end());
    let foot = |p: Point3| frame.at(0.0, 0.0, frame.coordinates(p)[2]);
    turned(
        frame,
        &[Some(Line::new(foot(a), a).into()), Some(arc), Some(Line::new(b, foot(b)).into())],
        longitude,
        r,
    )
}

/// The half plane through the axis and x: x is away from the axis, y along it.
fn meridian(frame: &Plane) -> Result<Plane> {
    Plane::from_axes(frame.origin, frame.x_axis, frame.z_axis)
}

/// The solid of a profile from the axis to the axis turned about it.
fn turned(frame: &Plane, parts: &[Option<Curve>], angle: f64, size: f64) -> Result<Brep> {
    let parts: Vec<Curve> = parts.iter().flatten().filter(|c| c.length() > 1e-12 * size).cloned().collect();
    let axis = Line::new(frame.origin, frame.origin + frame.z_axis);
    let t = within(size);
    let full = angle >= TAU - 1e-12;
    if full {
        // Flat ends are discs, not turned rays.
        let curved: Vec<Curve> = parts.iter().filter(|c| !is_flat(frame, c, size)).cloned().collect();
        let profile = chain(curved)?;
        let open = construct::revolve(&profile, axis, Interval::new(0.0, TAU), &t)?;
        return Ok(open.capped(&t)?.0.turned_outward());
    }
    let mut closed = parts.clone();
    if let (Some(a), Some(b)) = (parts.first().map(Curve::start), parts.last().map(Curve::end))
        && a.distance_to(b) > 1e-12 * size
    {
        closed.push(Line::new(b, a).into());
    }
    let open = construct::revolve(&chain(closed)?, axis, Interval::new(0.0, angle), &t)?;
    Ok(open.capped(&t)?.0.turned_outward())
}

fn is_flat(frame: &Plane, curve: &Curve, size: f64) -> bool {
    let height = |p: Point3| frame.coordinates(p)[2];
    matches!(curve, Curve::Line(_)) && (height(curve.start()) - height(curve.end())).abs() < 1e-12 * size
}

fn chain(mut parts: Vec<Curve>) -> Result<Curve> {
    if parts.len() == 1
        && let Some(only) = parts.pop()
    {
        return Ok(only);
    }
    Ok(PolyCurve::new(parts)?.into())
}

/// A cylinder, or a sector of it, in radians.
pub(crate) fn cylinder(frame: &Plane, r: f64, h: f64, angle: f64) -> Result<Brep> {
    if angle >= TAU - 1e-12 {
        let shape = Cylinder::new(*frame, r, Interval::new(0.0, h))?;
        return construct::cylinder(&shape, [true; 2]);
    }
    cone(frame, [r, r], h, angle)
}

/// A cone, its frustum, or a sector of it, in radians.
pub(crate) fn cone(frame: &Plane, [r1, r2]: [f64; 2], h: f64, angle: f64) -> Result<Brep> {
    let p = |r: f64, z: f64| frame.at(r, 0.0, z);
    let line = |a: Point3, b: Point3| (a.distance_to(b) > 0.0).then(|| Line::new(a, b).into());
    let parts = [line(p(0.0, 0.0), p(r1, 0.0)), line(p(r1, 0.0), p(r2, h)), line(p(r2, h), p(0.0, h))];
    turned(frame, &parts, angle, r1.max(r2).max(h.abs()))
}

/// A torus, or a part over a range of the tube's angle and of the ring's, in radians.
pub(crate) fn torus(
    frame: &Plane,
    [big, small]: [f64; 2],
    tube: Option<Interval>,
    angle: f64,
) -> Result<Brep> {
    let full = angle >= TAU - 1e-12;
    if tube.is_none() && full {
        return construct::torus(&Torus::new(*frame, big, small)?);
    }
    let center = frame.at(big, 0.0, 0.0);
    let plane = meridian(frame)?.with_origin(center);
    let axis = Line::new(frame.origin, frame.origin + frame.z_axis);
    let t = within(big + small);
    let circle = Circle::new(plane, small)?;
    let profile: Curve = match tube {
        None => circle.into(),
        Some(range) => {
            let arc: Curve = Arc::new(circle, range)?.into();
            let (a, b) = (arc.start(), arc.end());
            chain(vec![arc, Line::new(b, center).into(), Line::new(center, a).into()])?
        }
    };
    let made = construct::revolve(&profile, axis, Interval::new(0.0, angle.min(TAU)), &t)?;
    Ok(if full { made } else { made.capped(&t)?.0 }.turned_outward())
}
