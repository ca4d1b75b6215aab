//! Transforms: the book's numbers (rows M2 to M8) and openNURBS's answers.

use crate::common::{self, close, close_points, close_vectors, number, plane, point, vector};
use katydid_geometry::{Plane, Point3, Vector3, Xform};
use proptest::prelude::*;
use serde_json::Value;
use std::f64::consts::PI;

fn matrix(v: &Value) -> Xform {
    let n = common::numbers(v);
    Xform { rows: std::array::from_fn(|i| std::array::from_fn(|j| n[4 * i + j])) }
}

#[track_caller]
fn close_xforms(a: &Xform, b: &Xform, tolerance: f64, what: &str) {
    for (x, y) in a.rows.iter().flatten().zip(b.rows.iter().flatten()) {
        close(*x, *y, tolerance, what);
    }
}

#[test]
fn oracle_xforms() {
    let Some(data) = common::oracle("on_dev.json") else { return };
    let mut built = 0;
    for case in data["xforms"].as_array().unwrap() {
        let (input, out) = (&case["in"], &case["out"]);
        let m = matrix(&out["m"]);
        let what = case["id"].as_str().unwrap();
        let made = match input["ctor"].as_str().unwrap() {
            "Rotation" => Some(
                Xform::rotation(number(&input["angle"]), vector(&input["axis"]), point(&input["center"]))
                    .unwrap(),
            ),
            "RotationVectorToVector" => Some(
                Xform::rotation_between(
                    vector(&input["start"]),
                    vector(&input["end"]),
                    point(&input["center"]),
                )
                .unwrap(),
            ),
            "Translation" => Some(Xform::translation(vector(&input["v"]))),
            "ScaleUniform" => Some(Xform::scale(point(&input["anchor"]), number(&input["s"]))),
            "ScalePlane" => {
                let s = common::numbers(&input["s"]);
                Some(Xform::scale_non_uniform(&plane(&input["plane"]), s[0], s[1], s[2]))
            }
            "Mirror" => {
                let plane = Plane::from_normal(point(&input["point"]), vector(&input["normal"])).unwrap();
                Some(Xform::mirror(&plane))
            }
            "PlaneToPlane" => Some(Xform::plane_to_plane(&plane(&input["a"]), &plane(&input["b"]))),
            "Shear" => Some(Xform::in_frame(
                &plane(&input["plane"]),
                vector(&input["x"]),
                vector(&input["y"]),
                vector(&input["z"]),
            )),
            _ => None,
        };
        if let Some(made) = made {
            built += 1;
            close_xforms(&made, &m, 1e-13, what);
        }
        close(m.determinant(), number(&out["Determinant"]), 1e-12, what);
        assert_eq!(m.is_affine(), out["IsAffine"].as_bool().unwrap(), "{what}");
        assert_eq!(m.is_identity(1e-12), out["IsIdentity"].as_bool().unwrap(), "{what}");
        let factor = m.similarity_factor(1e-9);
        let similar = match factor {
            None => "NotSimilarity",
            Some(f) if f < 0.0 => "OrientationReversing",
            Some(_) => "OrientationPreserving",
        };
        assert_eq!(similar, out["SimilarityType"].as_str().unwrap(), "{what}");
        let rigid = match factor {
            Some(f) if (f - 1.0).abs() < 1e-9 => "Rigid",
            Some(f) if (f + 1.0).abs() < 1e-9 => "RigidReversing",
            _ => "NotRigid",
        };
        assert_eq!(rigid, out["RigidType"].as_str().unwrap(), "{what}");
        if let Some(inverse) = m.inverse() {
            close_xforms(&inverse, &matrix(&out["Inverse"]), 1e-10, what);
            assert!((inverse * m).is_identity(1e-10), "{what}");
        }
        close_xforms(&m.transposed(), &matrix(&out["Transpose"]), 0.0, what);
        let p = point(&out["pointIn"]);
        close_points(m.point(p), point(&out["point"]), 1e-12, what);
        close_vectors(m.vector(p.to_vector()), vector(&out["vector"]), 1e-12, what);
    }
    assert!(built >= 48);
}

#[test]
fn m3_translation_both_ways() {
    let (p, v) = (Point3::new(2.0, 3.0, 1.0), Vector3::new(2.0, 2.0, 2.0));
    assert_eq!(p + v, Point3::new(4.0, 5.0, 3.0));
    assert_eq!(Xform::translation(v).point(p), Point3::new(4.0, 5.0, 3.0));
    assert_eq!(Xform::translation(v).vector(v), v);
}

#[test]
fn m4_rotations_about_the_axes_are_for_column_vectors() {
    let b = 0.7_f64;
    let z = Xform::rotation(b, Vector3::Z, Point3::ORIGIN).unwrap();
    let (x, y) = (3.0, -2.0);
    let want = Point3::new(x * b.cos() - y * b.sin(), x * b.sin() + y * b.cos(), 5.0);
    close_points(z.point(Point3::new(x, y, 5.0)), want, 1e-15, "angle-sum identities");
    let quarter = |axis| Xform::rotation(PI / 2.0, axis, Point3::ORIGIN).unwrap();
    close_vectors(quarter(Vector3::X).vector(Vector3::Y), Vector3::Z, 1e-15, "x");
    close_vectors(quarter(Vector3::Y).vector(Vector3::Z), Vector3::X, 1e-15, "y");
    close_vectors(quarter(Vector3::Z).vector(Vector3::X), Vector3::Y, 1e-15, "z");
}

#[test]
fn m6_scale_and_m7_shear() {
    let s = Xform::scale_non_uniform(&Plane::XY, 2.0, 3.0, 4.0);
    assert_eq!(s.point(Point3::new(1.0, 1.0, 1.0)), Point3::new(2.0, 3.0, 4.0));
    let c = Point3::new(1.0, 2.0, 3.0);
    assert_eq!(Xform::scale(c, 5.0).point(c), c);
    let shear = Xform::shear(&Plane::XY, [[0.1, 0.2], [0.3, 0.4], [0.5, 0.6]]);
    let want = [[1.0, 0.1, 0.2], [0.3, 1.0, 0.4], [0.5, 0.6, 1.0]];
    for (row, want) in shear.rows.iter().zip(want) {
        for (a, b) in row.iter().zip(want) {
            close(*a, b, 1e-15, "shear");
        }
    }
}

#[test]
fn m8_projections_and_coordinate_change() {
    let plane = Plane::from_normal(Point3::new(1.0, 2.0, 3.0), Vector3::new(1.0, 1.0, 1.0)).unwrap();
    let p = Point3::new(4.0, -1.0, 7.0);
    let flat = Xform::planar_projection(&plane);
    close_points(flat.point(p), plane.closest_point(p), 1e-15, "projection");
    assert!(flat.inverse().is_none());
    let along = Xform::projection_along(&plane, Vector3::X).unwrap();
    let q = along.point(p);
    close(plane.signed_distance(q), 0.0, 1e-14, "on the plane");
    assert!((q.y - p.y).abs() < 1e-14 && (q.z - p.z).abs() < 1e-14);
    assert!(along.inverse().is_none());
    assert!(Xform::projection_along(&Plane::XY, Vector3::X).is_err());
    let other = Plane::from_normal(Point3::new(-5.0, 0.5, 1.0), Vector3::new(0.3, -1.0, 2.0)).unwrap();
    let [a, b, c] = plane.coordinates(p);
    let changed = Xform::change_basis(&plane, &other).point(Point3::new(a, b, c));
    let want = Point3::from(other.coordinates(p));
    close_points(changed, want, 1e-14, "change of basis");
    close_points(Xform::world_to_plane(&plane).point(p), Point3::new(a, b, c), 1e-14, "world to plane");
}

#[test]
fn singular_is_not_the_same_as_small() {
    assert!(Xform::scale(Point3::ORIGIN, 1e-12).inverse().is_some());
    assert!(Xform::scale(Point3::ORIGIN, 0.0).inverse().is_none());
    assert!(Xform::scale_non_uniform(&Plane::XY, 1.0, 1.0, 1e-12).inverse().is_some());
    assert!(Xform { rows: [[f64::NAN; 4]; 4] }.inverse().is_none());
    assert!(Xform { rows: [[1.0; 4]; 4] }.inverse().is_none());
    assert!(Xform::rotation(1.0, Vector3::ZERO, Point3::ORIGIN).is_err());
    assert!(Xform::rotation(f64::NAN, Vector3::X, Point3::ORIGIN).is_err());
}

#[test]
fn opposite_directions_turn_half_round() {
    let m = Xform::rotation_between(Vector3::X, -Vector3::X, Point3::ORIGIN).unwrap();
    close_vectors(m.vector(Vector3::X), -Vector3::X, 1e-15, "turned");
    assert!(m.is_rigid(1e-14));
    assert_eq!(Xform::rotation_between(Vector3::X, Vector3::X, Point3::ORIGIN).unwrap(), Xform::IDENTITY);
}

proptest! {
    #[test]
    fn m2_affine_maps_keep_parallels_and_multiply(
        rows in proptest::array::uniform3(proptest::array::uniform4(-5.0..5.0_f64)),
        other in proptest::array::uniform3(proptest::array::uniform4(-5.0..5.0_f64)),
        p in proptest::array::uniform3(-5.0..5.0_f64),
        v in proptest::array::uniform3(-5.0..5.0_f64),
    ) {
        let affine = |r: [[f64; 4]; 3]| Xform { rows: [r[0], r[1], r[2], [0.0, 0.0, 0.0, 1.0]] };
        let (a, b) = (affine(rows), affine(other));
        let (p, v) = (Point3::from(p), Vector3::from(v));
        let moved = a.point(p + v) - a.point(p);
        prop_assert!((moved - a.vector(v)).length() < 1e-11);
        prop_assert!(((a * b).point(p) - a.point(b.point(p))).length() < 1e-10);
        if let Some(inverse) = a.inverse() {
            let error = (inverse.point(a.point(p)) - p).length();
            prop_assert!(error < 1e-9 * (1.0 + 1.0 / a.determinant().abs()).powi(2), "{error}");
        }
    }
}
