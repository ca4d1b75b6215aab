//! Simple solids, extrusions and things turned.

use katydid_geometry::construct;
use katydid_geometry::{
    Box3, Cone, Curve, Cylinder, Interval, Line, Plane, Point3, PolylineCurve, Sphere, Torus, Vector3,
};

use super::inputs::{base, on_axis};
use super::random::{closed, curve, open};
use super::{Case, TOLERANCE, one};

pub fn cases() -> Vec<Case> {
    vec![
        ("box", |r| {
            let shape = Box3 { plane: r.plane(9.0), x: r.range(5.0), y: r.range(5.0), z: r.range(5.0) };
            one(construct::box_brep(&shape))
        }),
        ("sphere", |r| one(construct::sphere(&Sphere::new(r.plane(9.0), r.size())?))),
        ("quad sphere", |r| one(construct::quad_sphere(&Sphere::new(r.plane(9.0), r.size())?))),
        ("cylinder", |r| {
            let shape = Cylinder::new(r.plane(9.0), r.size(), r.range(5.0))?;
            one(construct::cylinder(&shape, [r.one_in(2), r.one_in(2)]))
        }),
        ("cone", |r| {
            let shape = Cone::new(r.plane(9.0), r.between(-5.0, 5.0) * r.scale, r.size())?;
            one(construct::cone(&shape, r.one_in(2)))
        }),
        ("torus", |r| one(construct::torus(&Torus::new(r.plane(9.0), r.size(), r.size())?))),
        ("plane surface", |r| one(construct::plane_surface(&r.plane(9.0), r.range(5.0), r.range(5.0)))),
        ("extrude", |r| {
            let profile = curve(r)?;
            let direction = if r.one_in(12) { Vector3::ZERO } else { r.vector(5.0) };
            one(construct::extrude(&profile, direction, r.one_in(2), &TOLERANCE))
        }),
        ("extrude along", |r| {
            let (profile, path) = (curve(r)?, curve(r)?);
            one(construct::extrude_along(&profile, &path, r.one_in(2), &TOLERANCE))
        }),
        ("extrude to point", |r| {
            let profile = curve(r)?;
            let apex = if r.one_in(8) { profile.start() } else { r.point(9.0) };
            one(construct::extrude_to_point(&profile, apex, r.one_in(2), &TOLERANCE))
        }),
        ("extrude brep", |r| {
            let base = base(r)?;
            one(match r.below(3) {
                0 => construct::extrude_brep(&base, r.vector(5.0), &TOLERANCE),
                1 => construct::extrude_brep_along(&base, &open(r)?, &TOLERANCE),
                _ => construct::extrude_brep_to_point(&base, r.point(9.0), &TOLERANCE),
            })
        }),
        ("revolve", |r| {
            let axis = Line::new(r.point(5.0), r.point(5.0));
            let profile = if r.one_in(4) { on_axis(r, &axis)? } else { curve(r)? };
            let turn = if r.one_in(2) { 6.3 } else { r.between(0.1, 6.0) };
            one(construct::revolve(&profile, axis, Interval::new(0.0, turn), &TOLERANCE))
        }),
        ("rail revolve", |r| {
            let axis = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0));
            let rail = if r.one_in(3) { curve(r)? } else { closed(r, &Plane::XY)? };
            let profile = if r.one_in(2) { on_axis(r, &axis)? } else { curve(r)? };
            one(construct::rail_revolve(&profile, &rail, axis, r.one_in(2), &TOLERANCE))
        }),
        ("extrude polyline along a side", |r| {
            let corners: Vec<Point3> = (0..3 + r.below(4)).map(|_| r.point(4.0)).collect();
            let side = r.below(corners.len() - 1);
            let along = (corners[side + 1] - corners[side]) * r.between(0.2, 2.0);
            let profile: Curve = PolylineCurve::new(corners)?.into();
            one(match r.below(3) {
                0 => construct::extrude_along(
                    &profile,
                    &Line::new(Point3::ORIGIN, along.to_point()).into(),
                    false,
                    &TOLERANCE,
                ),
                _ => construct::extrude(&profile, along, r.one_in(3), &TOLERANCE),
            })
        }),
        ("revolve polyline with a side on the axis", |r| {
            let axis = Line::new(r.point(5.0), r.point(5.0));
            let (a, b) = (axis.at(r.between(-1.0, 0.5)), axis.at(r.between(0.5, 2.0)));
            let (p, q) = (r.point(5.0), r.point(5.0));
            let corners = match r.below(4) {
                0 => vec![a, p, q, b, a],
                1 => vec![p, a, b, q],
                2 => vec![a, b, p, a],
                _ => vec![a, b, p],
            };
            let turn = if r.one_in(2) { 6.3 } else { r.between(0.1, 6.0) };
            one(construct::revolve(
                &PolylineCurve::new(corners)?.into(),
                axis,
                Interval::new(0.0, turn),
                &TOLERANCE,
            ))
        }),
        ("angled extrusion", |r| {
            let plane = r.plane(5.0);
            let scale = r.scale;
            let count = 3 + r.below(6);
            let mut corners: Vec<Point3> = (0..count)
                .map(|k| {
                    let angle = std::f64::consts::TAU * k as f64 / count as f64;
                    let reach = r.between(0.4, 1.0) * 3.0 * scale;
                    plane.at(reach * angle.cos(), reach * angle.sin(), 0.0)
                })
                .collect();
            match r.below(8) {
                0 => corners.insert(1, corners[0]),
                1 => corners.insert(1, corners[0].lerp(corners[1], 0.5)),
                2 => corners.push(corners[0]),
                3 => corners.swap(0, 1),
                4 => corners[0] = r.point(4.0),
                _ => {}
            }
            let heights =
                [if r.one_in(3) { r.between(-1.0, 1.0) * scale } else { 0.0 }, r.between(-1.0, 2.0) * scale];
            let angles: Vec<f64> = (0..1 + r.below(4)).map(|_| r.between(-0.8, 0.8)).collect();
            one(construct::extrude_angled(&corners, heights, &angles, &TOLERANCE))
        }),
    ]
}
