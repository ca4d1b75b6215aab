//! Conversions to and from glam and nalgebra keep what the values mean.

#![cfg(all(feature = "glam", feature = "nalgebra"))]
#![allow(clippy::unwrap_used, reason = "a test may stop")]

use katydid_geometry::{Matrix, Point2, Point3, Quaternion, Vector2, Vector3, Xform};

fn map() -> Xform {
    Xform::rotation(0.7, Vector3::new(1.0, -2.0, 0.5), Point3::new(3.0, 1.0, 2.0)).unwrap()
}

#[test]
fn glam_agrees() {
    let (m, q, v) = (map(), Point3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0));
    let theirs = glam::DMat4::from(m);
    let moved = Point3::from(theirs.transform_point3(q.into()));
    assert!(moved.distance_to(m.point(q)) < 1e-14);
    assert!((Vector3::from(theirs.transform_vector3(v.into())) - m.vector(v)).length() < 1e-14);
    assert_eq!(Xform::from(theirs), m);
    let turn = Quaternion::rotation(0.4, v).unwrap();
    let theirs = glam::DQuat::from(turn);
    assert!((Vector3::from(theirs * glam::DVec3::from(v)) - turn.rotate(v).unwrap()).length() < 1e-14);
    assert_eq!(Quaternion::from(theirs), turn);
    let flat = (Point2::new(1.0, 2.0), Vector2::new(3.0, 4.0));
    assert_eq!(Point2::from(glam::DVec2::from(flat.0)), flat.0);
    assert_eq!(Vector2::from(glam::DVec2::from(flat.1)), flat.1);
}

#[test]
fn nalgebra_agrees() {
    let (m, q, v) = (map(), Point3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0));
    let theirs = nalgebra::Matrix4::from(m);
    assert!(Point3::from(theirs.transform_point(&q.into())).distance_to(m.point(q)) < 1e-14);
    assert!((Vector3::from(theirs.transform_vector(&v.into())) - m.vector(v)).length() < 1e-14);
    assert_eq!(Xform::from(theirs), m);
    let turn = Quaternion::rotation(0.4, v).unwrap();
    let theirs = nalgebra::Quaternion::from(turn);
    let unit = nalgebra::UnitQuaternion::from_quaternion(theirs);
    assert!((Vector3::from(unit * nalgebra::Vector3::from(v)) - turn.rotate(v).unwrap()).length() < 1e-14);
    assert_eq!(Quaternion::from(theirs), turn);
    let ours = Matrix::new(2, 3, vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]).unwrap();
    let theirs = nalgebra::DMatrix::from(&ours);
    assert_eq!((theirs[(0, 2)], theirs[(1, 0)]), (3.0, 4.0));
    assert_eq!(Matrix::try_from(&theirs).unwrap(), ours);
    assert!(Matrix::try_from(&nalgebra::DMatrix::<f64>::zeros(0, 3)).is_err());
    assert_eq!(Point2::from(nalgebra::Point2::from(Point2::new(1.0, 2.0))), Point2::new(1.0, 2.0));
    assert_eq!(Vector2::from(nalgebra::Vector2::from(Vector2::new(1.0, 2.0))), Vector2::new(1.0, 2.0));
}
