//! Developable lofts: closed forms, a tangent developable, and the law that a normal is the same along a ruling.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use katydid_geometry::construct::{DevelopableLoft, DevelopableOptions, developable_loft};
use katydid_geometry::{
    Arc, Brep, Circle, Curve, Direction, Interval, Line, NurbsCurve, Plane, Point3, PolylineCurve, Tolerance,
    Vector3,
};

const TOLERANCE: Tolerance = Tolerance { absolute: 1e-4, angle: PI / 180.0 };

fn between(first: &Curve, second: &Curve) -> DevelopableLoft {
    let made = developable_loft(first, second, &DevelopableOptions::default(), &TOLERANCE).unwrap();
    assert!(made.brep.is_valid(), "{:?}", made.brep.faults());
    made
}

fn area(brep: &Brep) -> f64 {
    brep.area_properties(1e-10, || true).unwrap().amount
}

fn circle(plane: Plane, radius: f64) -> Curve {
    Circle { plane, radius }.into()
}

fn level(z: f64) -> Plane {
    Plane::XY.with_origin(Point3::new(0.0, 0.0, z))
}

/// The largest angle between normals along lines of constant u, in radians.
fn turn(brep: &Brep) -> f64 {
    let mut most = 0.0_f64;
    for face in 0..brep.faces().len() {
        let surface = brep.face_surface(face).unwrap();
        let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
        for i in 1..40 {
            let at = |share: f64| surface.normal_at(u.at(f64::from(i) / 40.0), v.at(share));
            let (Some(a), Some(b)) = (at(0.1), at(0.9)) else { continue };
            most = most.max(a.angle_to(b).unwrap());
        }
    }
    most
}

#[test]
fn circles_round_an_axis_give_an_exact_cone() {
    let made = between(&circle(level(0.0), 3.0), &circle(level(2.0), 1.0));
    assert!(made.twist < 1e-9, "{}", made.twist);
    let slant = 8.0_f64.sqrt();
    assert!((area(&made.brep) / (PI * 4.0 * slant) - 1.0).abs() < 1e-9);
    // The seam of the second is turned by a third: the rulings find their way back.
    let turned = level(2.0).rotated(TAU / 3.0);
    let made = between(&circle(level(0.0), 3.0), &circle(turned, 1.0));
    assert!((area(&made.brep) / (PI * 4.0 * slant) - 1.0).abs() < 1e-6, "{}", area(&made.brep));
}

/// Half the base times height of the four triangles, and four quarters of oblique cones.
#[test]
fn a_square_becomes_a_circle_by_triangles_and_cones() {
    let (half, radius, height) = (2.0, 1.0, 3.0);
    let corners = [(1.0, 0.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0), (1.0, 0.0)];
    let square = PolylineCurve::new(
        corners.iter().map(|(x, y)| Point3::new(half * x, half * y, 0.0)).collect::<Vec<_>>(),
    )
    .unwrap();
    let made = between(&square.into(), &circle(level(height), radius));
    assert!(made.twist < 1e-6, "{}", made.twist);
    let triangles = 4.0 * 0.5 * 2.0 * half * (height * height + (half - radius).powi(2)).sqrt();
    // Of a cone with its apex in a corner: half the cross product of the way there and the tangent.
    let steps = 20_000;
    let cone = |k: i32| {
        let angle = FRAC_PI_2 * (f64::from(k) + 0.5) / f64::from(steps);
        let way = Vector3::new(radius * angle.cos() - half, radius * angle.sin() - half, height);
        0.5 * way.cross(Vector3::new(-angle.sin(), angle.cos(), 0.0) * radius).length() * FRAC_PI_2
            / f64::from(steps)
    };
    let cones: f64 = 4.0 * (0..steps).map(cone).sum::<f64>();
    let expected = triangles + cones;
    assert!((area(&made.brep) / expected - 1.0).abs() < 1e-6, "{} {expected}", area(&made.brep));
    assert!(turn(&made.brep) < 1e-6);
    // Each side of the square gives a triangle, that with the seam two, and each corner a cone.
    assert_eq!(made.brep.faces().len(), 9);
}

#[test]
fn kinks_that_face_each_other_fold_flat_faces() {
    let square = |half: f64, z: f64| -> Curve {
        let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0), (1.0, 1.0)];
        let points = corners.iter().map(|(x, y)| Point3::new(half * x, half * y, z));
        PolylineCurve::new(points.collect::<Vec<_>>()).unwrap().into()
    };
    let made = between(&square(2.0, 0.0), &square(1.0, 1.0));
    assert_eq!(made.brep.faces().len(), 4);
    assert!((area(&made.brep) - 4.0 * 3.0 * 2.0_f64.sqrt()).abs() < 1e-9);
}

#[test]
fn tilted_circles_have_rulings_that_do_not_turn() {
    let tilted = Plane::from_normal(Point3::new(0.5, 0.2, 4.0), Vector3::new(0.4, 0.1, 1.0)).unwrap();
    let made = between(&circle(level(0.0), 2.0), &circle(tilted, 1.5));
    assert!(made.twist < 1e-5, "{}", made.twist);
    assert!(turn(&made.brep) < 1e-3, "{}", turn(&made.brep));
    let far = |p: Point3| made.brep.closest_point(p).unwrap().point.distance_to(p);
    for k in 0..50 {
        let angle = TAU * f64::from(k) / 50.0;
        assert!(far(Circle { plane: tilted, radius: 1.5 }.at(angle)) < TOLERANCE.absolute);
    }
}

/// Points on the tangents of a helix: the surface is known, and its area is κ (b² − a²) / 2 for each unit of length.
#[test]
fn the_tangents_of_a_helix_are_found_again() {
    let (radius, pitch) = (2.0, 0.5);
    let speed = f64::hypot(radius, pitch);
    let point = |angle: f64, far: f64| {
        let p = Point3::new(radius * angle.cos(), radius * angle.sin(), pitch * angle);
        p + Vector3::new(-radius * angle.sin(), radius * angle.cos(), pitch) * (far / speed)
    };
    // The second rail at another pace, so that the same parameter is another ruling.
    let rail = |far: f64, pace: &dyn Fn(f64) -> f64| -> Curve {
        let points: Vec<Point3> = (0..=200).map(|k| point(4.0 * pace(f64::from(k) / 200.0), far)).collect();
        NurbsCurve::interpolate(3, &points, katydid_geometry::KnotSpacing::Chord, None, None).unwrap().into()
    };
    let uneven = rail(2.0, &|x| 0.7 * x + 0.3 * x * x);
    let cut = uneven.trimmed(Interval::new(uneven.domain().start, uneven.domain().end)).unwrap();
    let made = between(&rail(1.0, &|x| x), &cut);
    assert!(made.twist < 1e-3, "{}", made.twist);
    let curvature = radius / (radius * radius + pitch * pitch);
    let expected = 0.5 * curvature * (4.0 - 1.0) * 4.0 * speed;
    assert!((area(&made.brep) / expected - 1.0).abs() < 1e-4, "{} {expected}", area(&made.brep));
}

#[test]
fn lines_in_a_plane_give_one_flat_face() {
    let line =
        |y: f64, x: f64| -> Curve { Line::new(Point3::new(0.0, y, 0.0), Point3::new(x, y, 0.0)).into() };
    let made = between(&line(0.0, 4.0), &line(1.0, 2.0));
    assert_eq!((made.brep.faces().len(), made.twist), (1, 0.0));
    assert!((area(&made.brep) - 3.0).abs() < 1e-12);
}

#[test]
fn skewed_lines_are_told_to_twist() {
    let a: Curve = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)).into();
    let b: Curve = Line::new(Point3::new(0.0, 0.0, 1.0), Point3::new(1.0, 1.0, 1.0)).into();
    let made = between(&a, &b);
    assert!(made.twist > 0.1 || made.brep.faces().len() == 2, "{made:?}");
}

#[test]
fn fixed_rulings_are_kept() {
    let a: Curve =
        Arc::through(Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 1.0, 0.0), Point3::new(-1.0, 0.0, 0.0))
            .unwrap()
            .into();
    let b = a.transformed(&katydid_geometry::Xform::translation(Vector3::new(0.0, 0.0, 2.0))).unwrap();
    let fixed = |share: [f64; 2]| [a.domain().at(share[0]), b.domain().at(share[1])];
    let with = |fixed: Vec<[f64; 2]>| {
        developable_loft(&a, &b, &DevelopableOptions { fixed, ..DevelopableOptions::default() }, &TOLERANCE)
    };
    let made = with(vec![fixed([0.3, 0.6])]).unwrap();
    assert!(made.brep.is_valid());
    let (from, to) = (a.point_at(fixed([0.3, 0.6])[0]), b.point_at(fixed([0.3, 0.6])[1]));
    let middle = from + (to - from) * 0.5;
    assert!(made.brep.closest_point(middle).unwrap().point.distance_to(middle) < 1e-9);
    // The straight way, without: a half cylinder.
    let made = with(vec![]).unwrap();
    assert!((area(&made.brep) / (TAU) - 1.0).abs() < 1e-9);
    assert!(with(vec![fixed([0.3, 0.6]), fixed([0.5, 0.4])]).is_err(), "they cross");
    assert!(with(vec![[9e9, 0.0]]).is_err());
    assert!(with(vec![[f64::NAN, 0.0]]).is_err());
}

#[test]
fn a_rail_beside_itself_is_refused() {
    let a = circle(Plane::XY, 1.0);
    assert!(developable_loft(&a, &a, &DevelopableOptions::default(), &TOLERANCE).is_err());
}
