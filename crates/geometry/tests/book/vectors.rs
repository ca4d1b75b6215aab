//! Rows V1 to V14 of the book: vectors, lines and planes, by their worked numbers and laws.

use katydid_geometry::{
    Line, NurbsSurface, Plane, PlaneEquation, Point2, Point3, Sphere, Surface, Vector2, Vector3,
};
use proptest::prelude::*;

fn v(x: f64, y: f64, z: f64) -> Vector3 {
    Vector3::new(x, y, z)
}

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn vectors() -> impl Strategy<Value = Vector3> {
    (-9.0..9.0_f64, -9.0..9.0_f64, -9.0..9.0_f64).prop_map(|(x, y, z)| v(x, y, z))
}

#[test]
fn v1_a_vector_has_no_place() {
    let arrow = Vector3::X * 5.18;
    assert_eq!(arrow, v(5.18, 0.0, 0.0));
    // At four anchors the segments from A to A + v are one vector.
    for a in [p(0.0, 0.0, 0.0), p(1.0, 2.0, 3.0), p(-4.0, 0.5, 2.0), p(8.0, -8.0, 1.0)] {
        let segment = Line::new(a, a + arrow);
        assert!((segment.direction() - arrow).length() < 1e-15 && (segment.length() - 5.18).abs() < 1e-14);
    }
    let flat = Vector2::new(3.0, 4.0);
    assert_eq!((flat.length(), flat.to_vector3()), (5.0, v(3.0, 4.0, 0.0)));
    assert_eq!(Point2::new(1.0, 1.0) + flat, Point2::new(4.0, 5.0));
}

#[test]
fn v2_anchor_and_vector_give_the_tip() {
    assert_eq!(p(1.0, 2.0, 3.0) + v(2.0, 2.0, 2.0), p(3.0, 4.0, 5.0));
}

#[test]
fn v3_position_vectors_start_at_the_origin() {
    let tip = p(3.0, -1.0, 4.0);
    assert_eq!(Point3::ORIGIN + tip.to_vector(), tip);
    assert_eq!(<[f64; 3]>::from(tip.to_vector()), <[f64; 3]>::from(tip));
}

#[test]
fn v4_addition_by_components() {
    let (a, b) = (v(1.0, 2.0, 0.0), v(4.0, 1.0, 4.0));
    assert_eq!(a + b, v(5.0, 3.0, 4.0));
    assert_eq!(a + b, v(a.x + b.x, a.y + b.y, a.z + b.z));
}

#[test]
fn v5_long_vectors_bias_the_average_direction() {
    let vectors = [v(10.0, 0.0, 0.0), v(0.0, 1.0, 0.0)];
    let biased = Vector3::average_direction(&vectors, false).unwrap();
    let fair = Vector3::average_direction(&vectors, true).unwrap();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    assert!((fair - v(half, half, 0.0)).length() < 1e-15);
    assert!(biased.angle_to(Vector3::X).unwrap() < 0.1);
    assert_eq!(Vector3::average(&[], true), None);
    assert_eq!(Vector3::average_direction(&[Vector3::X, -Vector3::X], true), None);
}

proptest! {
    #[test]
    fn v6_magnitude_is_the_root_of_the_sum_of_squares(a in vectors()) {
        prop_assert_eq!(a.length(), (a.x * a.x + a.y * a.y + a.z * a.z).sqrt());
    }

    #[test]
    fn v7_eight_laws_of_a_vector_space(
        a in vectors(), b in vectors(), c in vectors(), s in -9.0..9.0_f64, t in -9.0..9.0_f64,
    ) {
        let near = |x: Vector3, y: Vector3| (x - y).length() <= 1e-12;
        prop_assert_eq!(a + b, b + a);
        prop_assert!(near(a + (b + c), (a + b) + c));
        prop_assert_eq!(a + Vector3::ZERO, a);
        prop_assert_eq!(a + -a, Vector3::ZERO);
        prop_assert!(near((a + b) * s, a * s + b * s));
        prop_assert!(near(a * (s + t), a * s + a * t));
        prop_assert!(near(a * (s * t), (a * t) * s));
        prop_assert_eq!(a * 1.0, a);
    }

    #[test]
    fn v8_dot_product_and_angle(a in vectors(), b in vectors()) {
        prop_assume!(a.length() > 0.1 && b.length() > 0.1);
        prop_assert_eq!(a.dot(b), a.x * b.x + a.y * b.y + a.z * b.z);
        let (u, w) = (a.unitized().unwrap(), b.unitized().unwrap());
        prop_assert!(u.dot(w).abs() <= 1.0 + 1e-15);
        prop_assert!((a.dot(a) - a.length().powi(2)).abs() <= 1e-12);
        let cos = a.dot(b) / (a.length() * b.length());
        prop_assert!((a.angle_to(b).unwrap().cos() - cos).abs() < 1e-14);
        let along = a.projected_onto(b).unwrap();
        prop_assert!((along.length() - a.length() * cos.abs()).abs() < 1e-12);
        prop_assert!((along + a.rejected_from(b).unwrap() - a).length() < 1e-13);
    }

    #[test]
    fn v9_five_laws_of_the_dot_product(a in vectors(), b in vectors(), c in vectors(), s in -9.0..9.0_f64) {
        prop_assert!(a.dot(a) >= 0.0);
        prop_assert_eq!(a.dot(b), b.dot(a));
        prop_assert!((a.dot(b + c) - (a.dot(b) + a.dot(c))).abs() < 1e-11);
        prop_assert!(((a * s).dot(b) - s * a.dot(b)).abs() < 1e-10);
        prop_assert_eq!(Vector3::ZERO.dot(a), 0.0);
    }

    #[test]
    fn v10_cross_product(a in vectors(), b in vectors(), s in -9.0..9.0_f64) {
        let n = a.cross(b);
        prop_assert_eq!(n, v(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x));
        prop_assert!(n.dot(a).abs() < 1e-11 && n.dot(b).abs() < 1e-11);
        if let Some(angle) = a.angle_to(b) {
            prop_assert!((n.length() - a.length() * b.length() * angle.sin()).abs() < 1e-11);
        }
        // Parallel vectors: exactly zero where the multiple is exact, else rounding.
        prop_assert_eq!(a.cross(a * 2.0), Vector3::ZERO);
        prop_assert!(a.cross(a * s).length() < 1e-12 * (1.0 + a.length_squared() * s.abs()));
    }

    #[test]
    fn v11_six_laws_of_the_cross_product(
        a in vectors(), b in vectors(), c in vectors(), s in -9.0..9.0_f64,
    ) {
        let near = |x: Vector3, y: Vector3| (x - y).length() <= 1e-9;
        prop_assert_eq!(a.cross(b), -b.cross(a));
        prop_assert!(near((a * s).cross(b), a.cross(b) * s) && near(a.cross(b * s), a.cross(b) * s));
        prop_assert!(near(a.cross(b + c), a.cross(b) + a.cross(c)));
        prop_assert!(near((a + b).cross(c), a.cross(c) + b.cross(c)));
        prop_assert!((a.triple_product(b, c) - a.cross(b).dot(c)).abs() < 1e-10);
        prop_assert!(near(a.cross(b.cross(c)), b * a.dot(c) - c * a.dot(b)));
    }

    #[test]
    fn v8_signed_angles_turn_about_the_normal(a in vectors(), angle in -3.1..3.1_f64) {
        let Some(x) = a.perpendicular() else { return Ok(()) };
        let turned = x.rotated(angle, a).unwrap();
        prop_assert!((x.signed_angle_to(turned, a).unwrap() - angle).abs() < 1e-12);
        prop_assert!((x.signed_angle_to(turned, -a).unwrap() + angle).abs() < 1e-12);
        let flat = Vector2::new(3.0, -1.0);
        prop_assert!((flat.signed_angle_to(flat.rotated(angle)).unwrap() - angle).abs() < 1e-12);
    }

    #[test]
    fn components_along_skew_directions(a in vectors(), x in vectors(), y in vectors(), z in vectors()) {
        prop_assume!(x.triple_product(y, z).abs() > 1.0);
        let [s, t, u] = a.components_along(x, y, z).unwrap();
        prop_assert!((x * s + y * t + z * u - a).length() < 1e-9);
    }

    #[test]
    fn v14_plane_through_three_points_by_the_cross_product(a in vectors(), b in vectors(), c in vectors()) {
        let normal = (b - a).cross(c - a);
        prop_assume!(normal.length() > 1.0);
        let [a, b, c] = [a, b, c].map(Vector3::to_point);
        let plane = PlaneEquation::from_points(a, b, c).unwrap();
        for q in [a, b, c] {
            prop_assert!(plane.value_at(q).abs() < 1e-12);
        }
        prop_assert!(plane.normal().angle_to(normal).unwrap() < 1e-12);
        let again = PlaneEquation::from(&plane.to_plane().unwrap());
        prop_assert!(again.coefficients().iter().zip(plane.coefficients()).all(|(s, t)| (s - t).abs() < 1e-13));
    }
}

#[test]
fn v8_the_x_axis_turned_by_30_degrees() {
    let turned = Vector3::X.rotated(30.0_f64.to_radians(), Vector3::Z).unwrap();
    assert!((Vector3::X.dot(turned) - 3.0_f64.sqrt() / 2.0).abs() < 1e-15);
    assert!((turned.projected_onto(Vector3::X).unwrap().length() - 3.0_f64.sqrt() / 2.0).abs() < 1e-15);
    assert_eq!((Vector3::X.dot(Vector3::X), Vector3::X.dot(-Vector3::X)), (1.0, -1.0));
}

#[test]
fn v10_right_hand_rule() {
    assert_eq!(Vector3::X.cross(Vector3::Y), Vector3::Z);
    assert_eq!(Vector3::Y.cross(Vector3::X), v(0.0, 0.0, -1.0));
}

#[test]
fn v12_in_front_of_or_behind() {
    let plane = Plane::from_normal(p(0.0, 0.0, 1.0), v(0.0, 1.0, 1.0)).unwrap();
    for (q, front) in [(p(0.0, 0.0, 3.0), true), (p(5.0, 0.0, 0.0), false)] {
        let to_point = q - plane.closest_point(q);
        assert_eq!(to_point.dot(plane.z_axis) > 0.0, front);
        assert_eq!(plane.signed_distance(q) > 0.0, front);
    }
    // A surface by a grid of points, and a sphere, whose normals look outwards.
    let points: Vec<Point3> =
        (0..16).map(|i| p(f64::from(i / 4), f64::from(i % 4), f64::from(i * i % 7) / 7.0)).collect();
    let waves: Surface = NurbsSurface::clamped_uniform([3, 3], [4, 4], &points).unwrap().into();
    let ball: Surface = Sphere::around(p(0.0, 0.0, 0.0), 2.0).unwrap().into();
    for (surface, q, front) in [
        (&waves, p(1.5, 1.5, 4.0), true),
        (&waves, p(1.4, 1.6, -4.0), false),
        (&ball, p(3.0, 1.0, 1.0), true),
        (&ball, p(0.5, -1.0, 0.3), false),
    ] {
        let found = surface.closest_point(q).unwrap();
        let normal = surface.normal_at(found.u, found.v).unwrap();
        assert_eq!((q - found.point).dot(normal) > 0.0, front);
        // Nothing of the vector to the point lies in the surface.
        assert!((q - found.point).cross(normal).length() < 1e-6);
    }
}

#[test]
fn v13_points_of_a_line() {
    let (a, b) = (p(1.0, 2.0, 3.0), p(5.0, -2.0, 7.0));
    let line = Line::new(a, b);
    for t in [-1.0, 0.0, 0.25, 1.0, 2.5] {
        assert!(line.at(t).distance_to(a + (b - a) * t) < 1e-14);
    }
    assert_eq!(line.midpoint(), a + 0.5 * (b - a));
    assert_eq!(line.midpoint(), p(3.0, 0.0, 5.0));
}

#[test]
fn v14_plane_from_origin_and_normal() {
    let (origin, normal) = (p(1.0, 2.0, 3.0), v(2.0, -1.0, 2.0));
    let plane = PlaneEquation::from_point_and_normal(origin, normal).unwrap();
    let [a, b, c, d] = plane.coefficients();
    for q in [p(0.0, 0.0, 0.0), p(4.0, 1.0, -2.0), origin] {
        let by_hand = (2.0 * (q.x - 1.0) - (q.y - 2.0) + 2.0 * (q.z - 3.0)) / 3.0;
        assert!((plane.value_at(q) - by_hand).abs() < 1e-15 * 10.0);
        assert!((a * q.x + b * q.y + c * q.z + d - by_hand).abs() < 1e-15 * 10.0);
        assert!(plane.value_at(plane.closest_point(q)).abs() < 1e-15 * 10.0);
    }
    assert!(PlaneEquation::new(0.0, 0.0, 0.0, 1.0).is_err());
    assert!(PlaneEquation::new(1.0, f64::NAN, 0.0, 1.0).is_err());
    assert_eq!(PlaneEquation::new(2.0, 0.0, 0.0, -4.0).unwrap().offset(1.0).coefficients()[3], -3.0);
}
