//! Areas, volumes and moments of breps against closed forms.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use katydid_geometry::construct::{self, LoftOptions, PipeCap};
use katydid_geometry::{
    Box3, Brep, Circle, Cone, Curve, Cylinder, Ellipse, Interval, Line, MassProperties, NurbsSurface, Plane,
    Point3, PolylineCurve, Sphere, Surface, Tolerance, Torus, Vector3,
};

const TOLERANCE: Tolerance = Tolerance { absolute: 0.001, angle: PI / 180.0 };

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

/// A plane that is parallel to none of the world's.
fn tilted() -> Plane {
    Plane::from_normal(p(30.0, -20.0, 10.0), Vector3::new(1.0, 2.0, 3.0)).unwrap()
}

fn close(found: f64, want: f64) {
    let miss = (found - want).abs() / want.abs();
    assert!(miss <= 1e-10, "{found} instead of {want}: {miss:e}");
}

fn near(found: Point3, want: Point3) {
    assert!(found.distance_to(want) <= 1e-9, "{found:?} instead of {want:?}");
}

fn area(brep: &Brep) -> MassProperties {
    brep.area_properties(1e-12, || true).unwrap()
}

fn volume(brep: &Brep) -> MassProperties {
    brep.volume_properties(1e-13, || true).unwrap()
}

/// The integral of the square of the distance from a plane through the centroid with a normal.
fn spread(found: &MassProperties, n: Vector3) -> f64 {
    let [xx, yy, zz, xy, yz, zx] = found.second_moments;
    xx * n.x * n.x
        + yy * n.y * n.y
        + zz * n.z * n.z
        + 2.0 * (xy * n.x * n.y + yz * n.y * n.z + zx * n.z * n.x)
}

#[test]
fn spheres() {
    let plane = tilted();
    for r in [1e-3, 2.5, 1e4] {
        let shape = Sphere::new(plane, r).unwrap();
        let nurbs: Surface = shape.to_nurbs().unwrap().into();
        for ball in [construct::sphere(&shape).unwrap(), Brep::from_surface(nurbs).unwrap()] {
            let (skin, body) = (area(&ball), volume(&ball));
            close(skin.amount, 4.0 * PI * r * r);
            close(body.amount, 4.0 / 3.0 * PI * r * r * r);
            assert!(body.centroid.distance_to(plane.origin) <= 1e-10 * (40.0 + r));
            close(spread(&skin, Vector3::X), skin.amount * r * r / 3.0);
            close(spread(&body, plane.x_axis), body.amount * r * r / 5.0);
            close(body.gyration_about(body.centroid).z, (0.4_f64).sqrt() * r);
        }
    }
    let ball = construct::quad_sphere(&Sphere::new(plane, 3.0).unwrap()).unwrap();
    close(area(&ball).amount, 36.0 * PI);
    close(volume(&ball).amount, 36.0 * PI);
}

#[test]
fn tori_and_pipes_round_circles() {
    let (major, minor) = (5.0, 1.25);
    let plane = tilted();
    let ring = construct::torus(&Torus::new(plane, major, minor).unwrap()).unwrap();
    let rail: Curve = Circle::new(plane, major).unwrap().into();
    let pipe = construct::pipe(&rail, minor, PipeCap::None, &TOLERANCE).unwrap();
    for shape in [ring, pipe] {
        close(area(&shape).amount, 4.0 * PI * PI * major * minor);
        let body = volume(&shape);
        close(body.amount, 2.0 * PI * PI * major * minor * minor);
        near(body.centroid, plane.origin);
        let round = body.amount * (major * major + 0.75 * minor * minor);
        close(spread(&body, plane.x_axis) + spread(&body, plane.y_axis), round);
    }
}

#[test]
fn cones_and_cylinders() {
    let plane = tilted();
    let (h, r) = (4.0, 1.5);
    let cone = construct::cone(&Cone::new(plane, h, r).unwrap(), true).unwrap();
    close(area(&cone).amount, PI * r * (r + h.hypot(r)));
    let body = volume(&cone);
    close(body.amount, PI * r * r * h / 3.0);
    // The apex is the plane's origin.
    near(body.centroid, plane.at(0.0, 0.0, 0.75 * h));
    close(spread(&body, plane.z_axis), body.amount * h * h * 3.0 / 80.0);
    let tube = construct::cylinder(&Cylinder::new(plane, r, Interval::new(-1.0, 3.0)).unwrap(), [true; 2]);
    let tube = tube.unwrap();
    close(area(&tube).amount, TAU * r * (r + 4.0));
    let body = volume(&tube);
    close(body.amount, PI * r * r * 4.0);
    near(body.centroid, plane.at(0.0, 0.0, 1.0));
    close(spread(&body, plane.x_axis), body.amount * r * r / 4.0);
    let open = construct::cylinder(&Cylinder::new(plane, r, Interval::UNIT).unwrap(), [true, false]).unwrap();
    assert!(open.volume_properties(1e-9, || true).is_err());
    close(area(&open).amount, TAU * r + PI * r * r);
    assert!(tube.area_properties(1e-9, || false).is_err());
    assert!(Brep::default().area_properties(1e-9, || true).is_err());
}

#[test]
fn flat_regions_with_holes() {
    let plane = tilted();
    let corners = [(-4.0, -3.0), (4.0, -3.0), (4.0, 3.0), (-4.0, 3.0), (-4.0, -3.0)];
    let frame: Curve =
        PolylineCurve::new(corners.iter().map(|(x, y)| plane.at(*x, *y, 0.0)).collect()).unwrap().into();
    let round = |x: f64, y: f64, r: f64| -> Curve {
        Circle::new(plane.with_origin(plane.at(x, y, 0.0)), r).unwrap().into()
    };
    let oval: Curve = Ellipse::new(plane.with_origin(plane.at(-2.0, 1.0, 0.0)), 1.0, 0.5)
        .unwrap()
        .to_nurbs()
        .unwrap()
        .into();
    let made =
        Brep::planar_faces(&[frame, round(2.0, 0.0, 1.0), oval, round(2.0, 0.0, 0.25)], &TOLERANCE).unwrap();
    assert_eq!(made.breps.len(), 2);
    let plate = made.breps.iter().map(area).max_by(|a, b| a.amount.total_cmp(&b.amount)).unwrap();
    let (disc, hole) = (PI, PI * 0.5);
    let want = 48.0 - disc - hole;
    close(plate.amount, want);
    near(plate.centroid, plane.at((-2.0 * disc + 2.0 * hole) / want, -hole / want, 0.0));
    let solid = construct::extrude_brep(
        made.breps.iter().max_by(|a, b| area(a).amount.total_cmp(&area(b).amount)).unwrap(),
        plane.z_axis * 2.0,
        &TOLERANCE,
    );
    close(volume(&solid.unwrap()).amount, 2.0 * want);
}

#[test]
fn lofts_of_squares_and_boxes() {
    let square = |z: f64, half: f64| -> Curve {
        let corners = [(-half, -half), (half, -half), (half, half), (-half, half), (-half, -half)];
        PolylineCurve::new(corners.iter().map(|(x, y)| p(*x, *y, z)).collect()).unwrap().into()
    };
    let walls = construct::loft(&[square(0.0, 2.0), square(3.0, 1.0)], &LoftOptions::default(), &TOLERANCE);
    let walls = walls.unwrap();
    close(area(&walls).amount, 4.0 * 3.0 * 10f64.sqrt());
    let body = volume(&walls.capped(&TOLERANCE).unwrap().0);
    close(body.amount, 16.0 + 8.0 + 4.0);
    let unit = Interval::new(1.0, 3.0);
    let block = construct::box_brep(&Box3 { plane: tilted(), x: unit, y: unit, z: Interval::new(0.0, 5.0) });
    let block = block.unwrap();
    close(area(&block).amount, 48.0);
    let body = volume(&block);
    close(body.amount, 20.0);
    near(body.centroid, tilted().at(2.0, 2.0, 2.5));
    close(spread(&body, tilted().z_axis), 20.0 * 25.0 / 12.0);
    close(volume(&block.clone().flipped()).amount, 20.0);
}

#[test]
fn spheroids() {
    // The half of an ellipse with semi-axes 2 along x and 1 along z, turned about the x axis.
    let oval = Ellipse::new(Plane::XZ, 2.0, 1.0).unwrap().to_nurbs().unwrap();
    let half: Curve = oval.trimmed(Interval::new(0.0, PI)).unwrap().into();
    let axis = Line::new(p(-2.0, 0.0, 0.0), p(2.0, 0.0, 0.0));
    let egg = construct::revolve(&half, axis, Interval::new(0.0, TAU), &TOLERANCE).unwrap();
    close(volume(&egg).amount, 4.0 / 3.0 * PI * 2.0);
    let e = (0.75_f64).sqrt();
    close(area(&egg).amount, TAU * (1.0 + 2.0 / e * e.asin()));
}

#[test]
fn holes_in_round_and_free_surfaces() {
    let tube: Surface = Cylinder::new(tilted(), 2.0, Interval::new(0.0, 10.0)).unwrap().into();
    let tube = tube.with_domain(katydid_geometry::Direction::U, Interval::new(0.0, 4.0 * PI)).unwrap();
    let place = Plane::XY.with_origin(p(6.0, 5.0, 0.0));
    let round: Curve = Circle::new(place, 3.0).unwrap().into();
    // Lengths on the unrolled tube are lengths in the parameter plane.
    let [patch] = &Brep::from_parameter_loops(&tube, std::slice::from_ref(&round), &TOLERANCE).unwrap()[..]
    else {
        panic!("one piece")
    };
    close(area(patch).amount, 9.0 * PI);
    let n = 8;
    let points = (0..n * n).map(|k| {
        let (x, y) = ((k / n) as f64, (k % n) as f64);
        p(x, y, (0.9 * x).sin() * (0.7 * y).cos())
    });
    let free = NurbsSurface::clamped_uniform([3, 3], [n, n], &points.collect::<Vec<_>>()).unwrap();
    let whole = free.area_within(1e-12).unwrap();
    let free: Surface = free.into();
    let sheet = area(&Brep::from_surface(free.clone()).unwrap());
    close(sheet.amount, whole.area);
    near(sheet.centroid, whole.centroid);
    close(sheet.second_moments[2], whole.second_moments[2]);
    let round: Curve = Circle::new(Plane::XY.with_origin(p(2.3, 2.6, 0.0)), 1.4).unwrap().into();
    let inside = Brep::from_parameter_loops(&free, std::slice::from_ref(&round), &TOLERANCE).unwrap();
    let frame = construct::plane_surface(&Plane::XY, Interval::UNIT, Interval::UNIT).unwrap();
    assert!(frame.is_valid());
    let domain = free.domain(katydid_geometry::Direction::U);
    let border = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]
        .map(|(x, y)| p(domain.at(x), domain.at(y), 0.0));
    let border: Curve = PolylineCurve::new(border.to_vec()).unwrap().into();
    let outside = Brep::from_parameter_loops(&free, &[border, round], &TOLERANCE).unwrap();
    let parts = inside.iter().chain(&outside).map(|b| area(b).amount).sum::<f64>();
    close(parts, whole.area);
}

#[test]
fn turned_and_moved_shapes() {
    let half = construct::revolve(
        &Line::new(p(1.0, 0.0, 0.0), p(2.0, 0.0, 3.0)).into(),
        Line::new(Point3::ORIGIN, p(0.0, 0.0, 1.0)),
        Interval::new(0.0, FRAC_PI_2),
        &TOLERANCE,
    );
    // A quarter of a cone's frustum without caps: π (r + R) s / 4.
    close(area(&half.unwrap()).amount, PI * 3.0 * 10f64.sqrt() / 4.0);
}

#[test]
fn curves_agree_with_the_faces_that_they_bound() {
    let oval: Curve = Ellipse::new(tilted(), 3.0, 1.0).unwrap().to_nurbs().unwrap().into();
    let (found, face) = (
        oval.area_properties(1e-6).unwrap(),
        area(&Brep::planar_faces(&[oval], &TOLERANCE).unwrap().breps[0]),
    );
    close(found.amount, 3.0 * PI);
    close(spread(&found, tilted().x_axis), 3.0 * PI * 9.0 / 4.0);
    close(spread(&found, tilted().y_axis), 3.0 * PI / 4.0);
    for (own, other) in found.second_moments.into_iter().zip(face.second_moments) {
        assert!((own - other).abs() < 1e-9);
    }
    let (a, b) = (found.inertia_about(p(1.0, 2.0, 3.0)), face.inertia_about(p(1.0, 2.0, 3.0)));
    assert!((a - b).length() <= 1e-9 * a.length());
    let twice = MassProperties::together(&[found, face]).unwrap();
    close(twice.amount, 6.0 * PI);
    near(twice.centroid, found.centroid);
}
