//! The book's laws and numbers for vectors (rows V1 to V14).

use crate::common::{self, close, close_points, close_vectors};
use katydid_geometry::{Line, Plane, Point3, Vector3, intersect};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

fn vectors() -> impl Strategy<Value = Vector3> {
    (-100.0..100.0, -100.0..100.0, -100.0..100.0).prop_map(|(x, y, z)| Vector3::new(x, y, z))
}

/// Whether two vectors agree to rounding of numbers of size `scale`.
fn same(a: Vector3, b: Vector3, scale: f64) -> bool {
    (a - b).length() <= 1e-13 * scale.max(1.0)
}

proptest! {
    #[test]
    fn v7_eight_vector_space_laws(a in vectors(), b in vectors(), c in vectors(), s in -9.0..9.0_f64, t in -9.0..9.0_f64) {
        prop_assert_eq!(a + b, b + a);
        prop_assert!(same(a + (b + c), (a + b) + c, 1e3));
        prop_assert_eq!(a + Vector3::ZERO, a);
        prop_assert_eq!(a + (-a), Vector3::ZERO);
        prop_assert!(same(s * (a + b), s * a + s * b, 1e4));
        prop_assert!(same((s + t) * a, s * a + t * a, 1e4));
        prop_assert!(same((s * t) * a, s * (t * a), 1e4));
        prop_assert_eq!(1.0 * a, a);
    }

    #[test]
    fn v9_five_dot_product_laws(a in vectors(), b in vectors(), c in vectors(), s in -9.0..9.0_f64) {
        let near = |x: f64, y: f64| (x - y).abs() <= 1e-13 * 1e6;
        prop_assert!(near(a.dot(a), a.length() * a.length()));
        prop_assert_eq!(a.dot(b), b.dot(a));
        prop_assert!(near(a.dot(b + c), a.dot(b) + a.dot(c)));
        prop_assert!(near((s * a).dot(b), s * a.dot(b)) && near(a.dot(s * b), s * a.dot(b)));
        prop_assert_eq!(Vector3::ZERO.dot(a), 0.0);
    }

    #[test]
    fn v11_six_cross_product_laws(a in vectors(), b in vectors(), c in vectors(), s in -9.0..9.0_f64) {
        prop_assert_eq!(a.cross(b), -(b.cross(a)));
        prop_assert!(same((s * a).cross(b), s * a.cross(b), 1e6) && same(a.cross(s * b), s * a.cross(b), 1e6));
        prop_assert!(same(a.cross(b + c), a.cross(b) + a.cross(c), 1e6));
        prop_assert!(same((a + b).cross(c), a.cross(c) + b.cross(c), 1e6));
        prop_assert!((a.dot(b.cross(c)) - a.cross(b).dot(c)).abs() <= 1e-13 * 1e7);
        prop_assert!(same(a.cross(b.cross(c)), b * a.dot(c) - c * a.dot(b), 1e7));
    }

    #[test]
    fn v8_angle_agrees_with_the_cosine(a in vectors(), b in vectors()) {
        prop_assume!(a.length() > 1e-3 && b.length() > 1e-3);
        let angle = a.angle_to(b).unwrap();
        prop_assert!((0.0..=PI).contains(&angle));
        prop_assert!((angle.cos() - a.dot(b) / (a.length() * b.length())).abs() < 1e-13);
        let p = a.projected_onto(b).unwrap();
        prop_assert!((p + a.rejected_from(b).unwrap() - a).length() < 1e-12);
        prop_assert!((p.length() - (a.length() * angle.cos()).abs()).abs() < 1e-11);
    }

    #[test]
    fn v10_cross_is_perpendicular_and_sine_long(a in vectors(), b in vectors()) {
        prop_assume!(a.length() > 1e-3 && b.length() > 1e-3);
        let c = a.cross(b);
        prop_assert!(c.dot(a).abs() < 1e-8 && c.dot(b).abs() < 1e-8);
        prop_assert!((c.length() - a.length() * b.length() * a.angle_to(b).unwrap().sin()).abs() < 1e-9);
    }

    #[test]
    fn perpendicular_is_perpendicular(a in vectors()) {
        prop_assume!(a.length() > 1e-6);
        let p = a.perpendicular().unwrap();
        prop_assert!((p.length() - 1.0).abs() < 1e-15 && p.dot(a).abs() < 1e-13 * a.length());
    }

    #[test]
    fn rotation_keeps_length_and_axis(a in vectors(), axis in vectors(), angle in -7.0..7.0) {
        prop_assume!(axis.length() > 1e-3);
        let r = a.rotated(angle, axis).unwrap();
        prop_assert!((r.length() - a.length()).abs() < 1e-12 * a.length().max(1.0));
        prop_assert!((r.dot(axis) - a.dot(axis)).abs() < 1e-9);
        prop_assert!(same(r.rotated(-angle, axis).unwrap(), a, 1e3));
    }

    #[test]
    fn angle_in_plane_adds_up_to_a_turn(a in vectors(), b in vectors()) {
        prop_assume!(a.x.abs() > 1e-3 && b.x.abs() > 1e-3);
        let (ab, ba) = (a.angle_in_plane(b, &Plane::XY).unwrap(), b.angle_in_plane(a, &Plane::XY).unwrap());
        prop_assert!((0.0..TAU).contains(&ab));
        prop_assert!((ab + ba - TAU).abs() < 1e-12 || (ab == 0.0 && ba == 0.0));
    }

    #[test]
    fn v14_plane_through_points_holds_them(a in vectors(), b in vectors(), c in vectors()) {
        prop_assume!((b - a).cross(c - a).length() > 1e-2);
        let plane = Plane::from_points(a.to_point(), b.to_point(), c.to_point()).unwrap();
        let [k, l, m, d] = plane.equation();
        for p in [a, b, c] {
            prop_assert!((k * p.x + l * p.y + m * p.z + d).abs() < 1e-10);
            prop_assert!(plane.signed_distance(p.to_point()).abs() < 1e-10);
        }
        prop_assert!(plane.coordinates(c.to_point())[1] > 0.0);
        let again = Plane::from_equation(plane.equation()).unwrap();
        prop_assert!(again.signed_distance(a.to_point()).abs() < 1e-10);
    }
}

#[test]
fn v1_to_v4_worked_numbers() {
    assert_eq!(Vector3::X * 5.18, Vector3::new(5.18, 0.0, 0.0));
    assert_eq!(Point3::new(1.0, 2.0, 3.0) + Vector3::new(2.0, 2.0, 2.0), Point3::new(3.0, 4.0, 5.0));
    assert_eq!(Point3::new(4.0, 1.0, 4.0).to_vector(), Vector3::new(4.0, 1.0, 4.0));
    assert_eq!(Vector3::new(1.0, 2.0, 0.0) + Vector3::new(4.0, 1.0, 4.0), Vector3::new(5.0, 3.0, 4.0));
}

#[test]
fn v5_unequal_lengths_bias_the_average_and_v6_length_by_formula() {
    let vectors = [Vector3::X * 10.0, Vector3::Y];
    let biased = vectors.iter().copied().sum::<Vector3>().unitized().unwrap();
    let fair = vectors.iter().filter_map(|v| v.unitized()).sum::<Vector3>().unitized().unwrap();
    close(fair.angle_to(Vector3::X).unwrap(), PI / 4.0, 1e-15, "fair");
    assert!(biased.angle_to(Vector3::X).unwrap() < 0.1);
    let v = Vector3::new(2.0, -3.0, 6.0);
    assert_eq!(v.length(), (v.x.powi(2) + v.y.powi(2) + v.z.powi(2)).sqrt());
    assert_eq!((v.length(), Vector3::new(1e200, 0.0, 0.0).length()), (7.0, 1e200));
}

#[test]
fn v8_projection_of_an_axis_turned_by_30_degrees() {
    let turned = Vector3::X.rotated(PI / 6.0, Vector3::Z).unwrap();
    close(turned.projected_onto(Vector3::X).unwrap().length(), 3.0_f64.sqrt() / 2.0, 1e-15, "cos 30°");
    close(Vector3::X.angle_to(turned).unwrap(), PI / 6.0, 1e-15, "angle");
    assert_eq!(turned.parallel_to(-turned, 1e-12), -1);
    assert_eq!(turned.parallel_to(turned * 7.0, 1e-12), 1);
    assert_eq!(turned.parallel_to(Vector3::X, 1e-12), 0);
}

#[test]
fn v10_right_hand_rule() {
    assert_eq!(Vector3::X.cross(Vector3::Y), Vector3::Z);
    assert_eq!(Vector3::Y.cross(Vector3::X), -Vector3::Z);
    assert_eq!((Vector3::X * 3.0).cross(Vector3::X * -2.0), Vector3::ZERO);
}

#[test]
fn v13_points_of_a_line() {
    let line = Line::new(Point3::new(1.0, 2.0, 3.0), Point3::new(3.0, 6.0, 5.0));
    assert_eq!(line.midpoint(), Point3::new(2.0, 4.0, 4.0));
    close(line.closest_parameter(line.at(0.3)), 0.3, 1e-15, "parameter");
    let point = Line::new(Point3::ORIGIN, Point3::ORIGIN);
    assert_eq!(point.closest_parameter(Point3::new(1.0, 1.0, 1.0)), 0.0);
    close(point.distance_to(Point3::new(3.0, 4.0, 0.0)), 5.0, 1e-15, "distance to a segment without length");
}

#[test]
fn perpendicular_follows_opennurbs() {
    assert_eq!(Vector3::Z.perpendicular(), Some(Vector3::X));
    assert_eq!(Vector3::X.perpendicular(), Some(Vector3::Y));
    assert_eq!(
        Vector3::Y.perpendicular(),
        Some(Vector3::new(0.0, 0.0, 1.0)).map(|v| Vector3::new(v.x, v.y, v.z))
    );
    assert_eq!(Vector3::ZERO.perpendicular(), None);
    let n = Vector3::new(-0.04386269005178093, -0.13030792317292983, 0.9905028569266113);
    close_vectors(
        n.perpendicular().unwrap(),
        Vector3::new(0.0, 0.991457065868538, 0.13043345636511194),
        1e-15,
        "",
    );
}

#[test]
fn tiny_angles_keep_their_digits() {
    for angle in [1e-3, 1e-8, 1e-12] {
        let v = Vector3::X.rotated(angle, Vector3::Z).unwrap();
        assert!((Vector3::X.angle_to(v).unwrap() - angle).abs() < 1e-15 * angle.max(1e-3));
    }
    let huge = Vector3::new(1e200, 0.0, 0.0);
    close(huge.angle_to(Vector3::new(1e-200, 1e-200, 0.0)).unwrap(), PI / 4.0, 1e-15, "sizes far apart");
}

#[test]
fn degenerate_input_is_refused() {
    assert!(Vector3::ZERO.angle_to(Vector3::X).is_none());
    assert!(Vector3::new(f64::NAN, 0.0, 0.0).unitized().is_none());
    assert!(Vector3::Z.angle_in_plane(Vector3::X, &Plane::XY).is_none());
    assert!(Vector3::X.rotated(1.0, Vector3::ZERO).is_none());
    let p = |x: f64| Point3::new(x, 2.0 * x, 0.0);
    assert!(Plane::from_points(p(0.0), p(1.0), p(2.0)).is_err());
    assert!(Plane::from_points(p(0.0), p(0.0), p(2.0)).is_err());
    assert!(Plane::from_normal(p(0.0), Vector3::ZERO).is_err());
    assert!(Plane::from_normal(p(f64::INFINITY), Vector3::Z).is_err());
    assert!(Plane::fit(&[p(0.0), p(1.0), p(2.0), p(5.0)]).is_err());
    assert!(Plane::fit(&[p(0.0), p(1.0)]).is_err());
    assert!(Line::fit(&[p(1.0), p(1.0)]).is_err());
    assert!(Line::fit(&[]).is_err());
    assert!(Plane::from_equation([0.0, 0.0, 0.0, 1.0]).is_err());
}

#[test]
fn fits() {
    let points: Vec<_> = (0..30).map(|i| Plane::XZ.at(f64::from(i), f64::from(i * i % 7), 0.0)).collect();
    let (plane, deviation) = Plane::fit(&points).unwrap();
    assert!(deviation < 1e-12);
    assert_eq!(plane.z_axis.parallel_to(Vector3::Y, 1e-9).abs(), 1);
    let line = Line::fit(&[p(3.0), p(1.0), p(2.0), p(0.0)]).unwrap();
    fn p(t: f64) -> Point3 {
        Point3::new(t, -t, 2.0 * t)
    }
    close_points(line.from, p(3.0), 1e-14, "start of the fitted line");
    close_points(line.to, p(0.0), 1e-14, "end of the fitted line");
}

#[test]
fn planes_turn_and_flip() {
    let turned = Plane::XY.rotated(PI / 2.0);
    close_vectors(turned.x_axis, Vector3::Y, 1e-15, "x");
    close_vectors(turned.y_axis, -Vector3::X, 1e-15, "y");
    let flipped = Plane::XY.flipped();
    assert_eq!(flipped.x_axis.cross(flipped.y_axis), flipped.z_axis);
    assert_eq!(Plane::XZ.x_axis.cross(Plane::XZ.y_axis), Plane::XZ.z_axis);
    assert_eq!(Plane::YZ.x_axis.cross(Plane::YZ.y_axis), Plane::YZ.z_axis);
    assert_eq!(Plane::XY.closest_point(Point3::new(1.0, 2.0, 3.0)), Point3::new(1.0, 2.0, 0.0));
}

#[test]
fn oracle_intersections() {
    let Some(data) = common::oracle("on_dev.json") else { return };
    let line = |v: &serde_json::Value| Line::new(common::point(&v[0]), common::point(&v[1]));
    let mut counts = [0; 4];
    for case in data["intersections"].as_array().unwrap() {
        let (input, out) = (&case["in"], &case["out"]);
        match input["f"].as_str().unwrap() {
            "LineLine" => {
                counts[0] += 1;
                let got = intersect::line_line(&line(&input["a"]), &line(&input["b"]));
                let Some((s, t)) = got else { panic!("{case}") };
                close(s, common::number(&out[1]), 1e-11, "on a");
                close(t, common::number(&out[2]), 1e-11, "on b");
            }
            "LinePlane" => {
                counts[1] += 1;
                let t = intersect::line_plane(&line(&input["a"]), &common::plane(&input["plane"])).unwrap();
                close(t, common::number(&out[1]), 1e-11, "line plane");
            }
            "PlanePlane" => {
                counts[2] += 1;
                let (a, b) = (common::plane(&input["a"]), common::plane(&input["b"]));
                let got = intersect::plane_plane(&a, &b).unwrap();
                close_points(got.from, common::point(&out[1]), 1e-11, "from");
                close_points(got.to, common::point(&out[2]), 1e-11, "to");
            }
            "PlanePlanePlane" => {
                counts[3] += 1;
                let p: Vec<_> = input["p"].as_array().unwrap().iter().map(common::plane).collect();
                let got = intersect::three_planes(&p[0], &p[1], &p[2]).unwrap();
                close_points(got, common::point(&out[1]), 1e-11, "three planes");
            }
            _ => {}
        }
    }
    assert!(counts.iter().all(|&c| c > 0), "{counts:?}");
}

#[test]
fn parallel_things_do_not_meet() {
    let a = Line::new(Point3::ORIGIN, Point3::new(1.0, 1.0, 0.0));
    let b = Line::new(Point3::new(0.0, 0.0, 1.0), Point3::new(-3.0, -3.0, 1.0));
    assert_eq!(intersect::line_line(&a, &b), None);
    assert_eq!(intersect::line_line(&a, &Line::new(Point3::ORIGIN, Point3::ORIGIN)), None);
    assert_eq!(intersect::line_plane(&a, &Plane::XY), None);
    assert_eq!(intersect::plane_plane(&Plane::XY, &Plane::XY.offset(1.0)), None);
    assert_eq!(intersect::three_planes(&Plane::XY, &Plane::XZ, &Plane::XY), None);
    assert_eq!(intersect::three_planes(&Plane::XY, &Plane::XZ, &Plane::YZ), Some(Point3::ORIGIN));
}
