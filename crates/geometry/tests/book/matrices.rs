//! Rows M1 to M9 of the book: matrices and transforms, and the rest of what transforms can do.

use std::f64::consts::{FRAC_PI_2, PI};

use katydid_geometry::{
    Box3, Circle, Curve, Frustum, Interval, Matrix, Mesh, Plane, PlaneEquation, Point3, Quaternion, Vector3,
    Xform,
};
use proptest::prelude::*;

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn v(x: f64, y: f64, z: f64) -> Vector3 {
    Vector3::new(x, y, z)
}

fn near(a: &Xform, b: &Xform, tolerance: f64) -> bool {
    let size = b.rows.as_flattened().iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    a.rows.as_flattened().iter().zip(b.rows.as_flattened()).all(|(x, y)| (x - y).abs() <= tolerance * size)
}

fn affine() -> impl Strategy<Value = Xform> {
    prop::array::uniform3(prop::array::uniform4(-3.0..3.0_f64))
        .prop_map(|[a, b, c]| Xform { rows: [a, b, c, [0.0, 0.0, 0.0, 1.0]] })
}

fn turns() -> impl Strategy<Value = Quaternion> {
    prop::array::uniform4(-1.0..1.0_f64).prop_filter_map("no length", |[w, x, y, z]| {
        let q = Quaternion::new(w, x, y, z);
        (q.length() > 0.1).then(|| q.unitized()).flatten()
    })
}

#[test]
fn m1_sizes_of_products() {
    let m = |rows, columns| Matrix::new(rows, columns, vec![1.0; rows * columns]).unwrap();
    let size = |m: Matrix| (m.rows(), m.columns());
    assert_eq!(size(m(2, 4).product(&m(4, 3)).unwrap()), (2, 3));
    assert_eq!(size(m(2, 4).product(&m(4, 5)).unwrap()), (2, 5));
    assert!(m(2, 4).product(&m(3, 4)).unwrap_err().to_string().contains("columns of the first"));
    let column = Matrix::new(4, 1, vec![2.0, 3.0, 1.0, 1.0]).unwrap();
    assert_eq!(Matrix::identity(4, 4).unwrap().product(&column).unwrap(), column);
}

#[test]
fn m3_translation_both_ways() {
    let by = v(2.0, 2.0, 2.0);
    assert_eq!(p(2.0, 3.0, 1.0) + by, p(4.0, 5.0, 3.0));
    assert_eq!(Xform::translation(by).point(p(2.0, 3.0, 1.0)), p(4.0, 5.0, 3.0));
    assert_eq!(Xform::translation(by).vector(by), by);
}

#[test]
fn m4_rotations_from_the_sums_of_angles() {
    let b = 0.7_f64;
    let turn = |axis, q: Point3| Xform::rotation(b, axis, Point3::ORIGIN).unwrap().point(q);
    let (x, y) = (2.0, -1.5);
    let want = (x * b.cos() - y * b.sin(), x * b.sin() + y * b.cos());
    for (axis, q, image) in [
        (Vector3::Z, p(x, y, 5.0), p(want.0, want.1, 5.0)),
        (Vector3::X, p(5.0, x, y), p(5.0, want.0, want.1)),
        (Vector3::Y, p(y, 5.0, x), p(want.1, 5.0, want.0)),
    ] {
        assert!(turn(axis, q).distance_to(image) < 1e-15 * 4.0);
    }
    let (axis, center) = (v(1.0, 2.0, -1.0), p(3.0, 0.0, 1.0));
    let m = Xform::rotation(1.1, axis, center).unwrap();
    assert!(m.point(center + axis * 2.5).distance_to(center + axis * 2.5) < 1e-14);
    let angles =
        Xform::rotation(0.4, Vector3::Z, center).unwrap() * Xform::rotation(0.3, Vector3::Z, center).unwrap();
    assert!(near(&angles, &Xform::rotation(0.7, Vector3::Z, center).unwrap(), 1e-14));
}

#[test]
fn m5_a_solid_turned_and_its_matrix() {
    let size = |x: f64| Interval::new(0.0, x);
    let solid = Box3 { plane: Plane::XY, x: size(1.0), y: size(2.0), z: size(3.0) };
    let solid = Mesh::cuboid(&solid, 1, 1, 1).unwrap();
    let m = Xform::rotation(PI / 6.0, Vector3::Z, p(1.0, 0.0, 0.0)).unwrap();
    let printed: Vec<String> =
        m.rows.iter().map(|r| r.iter().map(|x| format!("{x:.2}")).collect::<Vec<_>>().join(" ")).collect();
    assert_eq!(
        printed,
        ["0.87 -0.50 0.00 0.13", "0.50 0.87 0.00 -0.50", "0.00 0.00 1.00 0.00", "0.00 0.00 0.00 1.00"]
    );
    let turned = solid.transformed(&m).unwrap();
    for (a, b) in solid.vertices().iter().zip(turned.vertices()) {
        assert!(m.point(*a).distance_to(*b) < 1e-15 * 8.0);
    }
}

#[test]
fn m6_scale_uniform_and_by_axis() {
    let center = p(1.0, 1.0, 1.0);
    let m = Xform::scale(center, 3.0);
    assert_eq!((m.point(center), m.point(p(2.0, 1.0, 0.0))), (center, p(4.0, 1.0, -2.0)));
    let m = Xform::scale_non_uniform(&Plane::XY, 2.0, 3.0, 4.0);
    assert_eq!(m, Xform::diagonal(2.0, 3.0, 4.0));
    assert_eq!(m.determinant(), 24.0);
}

#[test]
fn m7_shear_with_six_coefficients() {
    let m = Xform::shear(&Plane::XY, [[0.1, 0.2], [0.3, 0.4], [0.5, 0.6]]);
    assert_eq!(
        m.rows,
        [[1.0, 0.1, 0.2, 0.0], [0.3, 1.0, 0.4, 0.0], [0.5, 0.6, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
    );
}

#[test]
fn m8_world_camera_clip_and_screen() {
    let camera = Plane::from_axes(p(5.0, -4.0, 3.0), v(1.0, 1.0, 0.0), v(0.0, 0.3, 1.0)).unwrap();
    let in_camera = Xform::world_to_camera(&camera);
    let ahead = camera.at(0.0, 0.0, -7.0);
    assert!(in_camera.point(ahead).distance_to(p(0.0, 0.0, -7.0)) < 1e-14);
    assert!((in_camera * Xform::camera_to_world(&camera)).is_identity(1e-14));
    let view =
        Frustum { x: Interval::new(-1.0, 3.0), y: Interval::new(-2.0, 1.0), depth: Interval::new(2.0, 10.0) };
    for perspective in [false, true] {
        let m = Xform::camera_to_clip(&view, perspective).unwrap();
        assert!(m.point(p(-1.0, -2.0, -2.0)).distance_to(p(-1.0, -1.0, 1.0)) < 1e-14);
        assert!(m.point(p(3.0, 1.0, -2.0)).distance_to(p(1.0, 1.0, 1.0)) < 1e-14);
        let grown = if perspective { 5.0 } else { 1.0 };
        assert!(m.point(p(3.0 * grown, grown, -10.0)).distance_to(p(1.0, 1.0, -1.0)) < 1e-14);
        assert!((m * Xform::clip_to_camera(&view, perspective).unwrap()).is_identity(1e-12));
    }
    let (x, y, z) = (Interval::new(0.0, 800.0), Interval::new(600.0, 0.0), Interval::new(0.0, 1.0));
    let screen = Xform::clip_to_screen(x, y, z);
    assert_eq!(screen.point(p(-1.0, 1.0, 1.0)), p(0.0, 0.0, 1.0));
    assert_eq!(screen.point(p(1.0, -1.0, -1.0)), p(800.0, 600.0, 0.0));
    assert!((screen * Xform::screen_to_clip(x, y, z).unwrap()).is_identity(1e-12));
    assert!(Xform::screen_to_clip(Interval::new(1.0, 1.0), y, z).is_err());
    let empty = Frustum { x: Interval::new(1.0, 1.0), ..view };
    assert!(Xform::camera_to_clip(&empty, false).is_err());
    let behind = Frustum { depth: Interval::new(-1.0, 1.0), ..view };
    assert!(Xform::camera_to_clip(&behind, true).is_err());
    let m = Xform::interval_change(1, Interval::new(2.0, 4.0), Interval::new(10.0, 0.0)).unwrap();
    assert_eq!((m.point(p(7.0, 2.0, 7.0)), m.point(p(7.0, 4.0, 7.0))), (p(7.0, 10.0, 7.0), p(7.0, 0.0, 7.0)));
    assert!(Xform::interval_change(3, Interval::UNIT, Interval::UNIT).is_err());
    assert!(Xform::interval_change(0, Interval::new(1.0, 1.0), Interval::UNIT).is_err());
}

#[test]
fn m8_kinds_and_ranks() {
    let turn = Xform::rotation(1.0, v(1.0, 1.0, 1.0), Point3::ORIGIN).unwrap();
    let mirror = Xform::mirror(&Plane::YZ);
    assert_eq!((turn.rigid_type(1e-12), mirror.rigid_type(1e-12)), (1, -1));
    let twice = Xform::scale(p(1.0, 0.0, 0.0), 2.0);
    assert_eq!((twice.rigid_type(1e-12), twice.similarity_type(1e-12)), (0, 1));
    assert_eq!((twice * mirror).similarity_type(1e-12), -1);
    assert_eq!(Xform::diagonal(1.0, 2.0, 3.0).similarity_type(1e-12), 0);
    assert!(turn.is_rotation(1e-12) && turn.is_linear() && !mirror.is_rotation(1e-12) && !twice.is_linear());
    assert!(Xform::translation(Vector3::X).is_translation(0.0) && !turn.is_translation(1e-3));
    assert_eq!(turn.rank(1e-12).0, 4);
    assert_eq!(Xform::planar_projection(&Plane::XY).rank(1e-12).0, 3);
    assert_eq!(Xform { rows: [[0.0; 4]; 4] }.rank(1e-12), (0, [0.0; 4]));
    assert!(Xform { rows: [[0.0; 4]; 4] }.is_zero());
}

#[test]
fn m9_a_circle_under_a_non_uniform_scale_is_exact() {
    let circle: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
    let m = Xform::scale_non_uniform(&Plane::XY.rotated(0.4), 3.0, 0.5, 1.0);
    let image = circle.transformed(&m).unwrap();
    assert!(image.as_circle(1e-6).is_none());
    let back = m.inverse().unwrap();
    let domain = image.domain();
    for i in 0..=100 {
        let q = back.point(image.point_at(domain.at(f64::from(i) / 100.0)));
        assert!((q.to_vector().length() - 2.0).abs() < 1e-14);
    }
}

proptest! {
    #[test]
    fn m2_one_matrix_for_a_sequence(a in affine(), b in affine(), x in -5.0..5.0_f64, y in -5.0..5.0_f64) {
        let q = p(x, y, x - y);
        prop_assert!((b * a).point(q).distance_to(b.point(a.point(q))) < 1e-11);
        // Parallel lines stay parallel.
        let d = v(y, 1.0, x);
        prop_assert!((a.point(q + d) - a.point(q)).cross(a.vector(d)).length() < 1e-9);
    }

    #[test]
    fn affine_maps_come_apart_and_together(m in affine()) {
        let parts = m.decompose_affine().unwrap();
        prop_assert!(near(&parts.compose(), &m, 1e-13));
        prop_assert!(parts.rotation.is_rotation(1e-13) && parts.axes.is_rotation(1e-13));
        let (t, linear) = m.decompose_translation_linear().unwrap();
        prop_assert!(near(&(Xform::translation(t) * linear), &m, 1e-15));
        if let Some((linear, t)) = m.decompose_linear_translation().filter(|_| m.determinant().abs() > 0.1) {
            prop_assert!(near(&(linear * Xform::translation(t)), &m, 1e-11));
        }
        let square = m.linear_part().transposed() * m.linear_part();
        let (q, d) = square.decompose_symmetric(1e-12).unwrap();
        prop_assert!(near(&(q * Xform::diagonal(d.x, d.y, d.z) * q.transposed()), &square, 1e-13));
        // The eigenvalues are the squares of the factors.
        let mut squares = [parts.scale.x.powi(2), parts.scale.y.powi(2), parts.scale.z.powi(2)];
        squares.sort_by(f64::total_cmp);
        for (a, b) in squares.iter().zip([d.x, d.y, d.z]) {
            prop_assert!((a - b).abs() < 1e-11);
        }
    }

    #[test]
    fn flattening_maps_come_apart_too(m in affine(), scale in prop::array::uniform3(0..3_u8)) {
        let flat = m.linear_part() * Xform::diagonal(f64::from(scale[0]), f64::from(scale[1]), f64::from(scale[2]));
        let parts = flat.decompose_affine().unwrap();
        prop_assert!(near(&parts.compose(), &flat, 1e-13));
        prop_assert!(parts.rotation.is_rotation(1e-12) && parts.axes.is_rotation(1e-12));
    }

    #[test]
    fn rigid_maps_and_similarities_come_apart(q in turns(), f in 0.1..9.0_f64, x in -9.0..9.0_f64, mirror: bool) {
        let sign = if mirror { -1.0 } else { 1.0 };
        let (turn, t) = (q.to_xform().unwrap(), v(x, -x, 1.0));
        let m = Xform::translation(t) * Xform::scale(Point3::ORIGIN, sign * f) * turn;
        let (moved, factor, rotation) = m.decompose_similarity(1e-9).unwrap();
        prop_assert!((factor - sign * f).abs() < 1e-13 * f && (moved - t).length() < 1e-15);
        prop_assert!(near(&rotation, &turn, 1e-14));
        let m = Xform::translation(t) * Xform::scale(Point3::ORIGIN, sign) * turn;
        let (s, _, rotation) = m.decompose_rigid(1e-9).unwrap();
        prop_assert_eq!(s, if mirror { -1 } else { 1 });
        prop_assert!(near(&rotation, &turn, 1e-14));
    }

    #[test]
    fn normals_follow_the_surface(m in affine(), q in turns()) {
        let (a, b) = (q.rotate(Vector3::X).unwrap(), q.rotate(Vector3::Y).unwrap());
        let image = m.vector(a).cross(m.vector(b));
        prop_assert!((m.normal_map().vector(a.cross(b)) - image).length() < 1e-12);
    }

    #[test]
    fn planes_as_equations_follow_maps(m in affine(), q in turns()) {
        prop_assume!(m.determinant().abs() > 0.5);
        let plane = Plane::from_normal(p(1.0, 2.0, 3.0), q.rotate(Vector3::Z).unwrap()).unwrap();
        let image = PlaneEquation::from(&plane).transformed(&m).unwrap();
        for (u, w) in [(0.0, 0.0), (2.0, -1.0), (-3.0, 0.5)] {
            prop_assert!(image.value_at(m.point(plane.at(u, w, 0.0))).abs() < 1e-10);
        }
    }

    #[test]
    fn quaternions_turn_as_matrices_do(a in turns(), b in turns(), x in -9.0..9.0_f64) {
        let (ma, mb) = (a.to_xform().unwrap(), b.to_xform().unwrap());
        prop_assert!(ma.is_rotation(1e-14));
        prop_assert!(near(&(a * b).to_xform().unwrap(), &(ma * mb), 1e-14));
        let w = v(x, 1.0, -x);
        prop_assert!((a.rotate(w).unwrap() - ma.vector(w)).length() < 1e-13);
        prop_assert!((a * a.inverse().unwrap() - Quaternion::IDENTITY).length() < 1e-15);
        let back = Quaternion::from_xform(&ma, 1e-9).unwrap();
        prop_assert!((back - a).length().min((back + a).length()) < 1e-14);
        let (angle, axis) = a.angle_and_axis().unwrap();
        let again = Quaternion::rotation(angle, axis).unwrap();
        prop_assert!((again - a).length() < 1e-14);
        let [yaw, pitch, roll] = a.yaw_pitch_roll().unwrap();
        let again = Quaternion::from_yaw_pitch_roll(yaw, pitch, roll);
        prop_assert!((again - a).length().min((again + a).length()) < 1e-7);
        let half = a.pow(0.5).unwrap();
        prop_assert!((half * half - a).length() < 1e-14);
        prop_assert!((a.ln().unwrap().exp() - a).length() < 1e-14);
    }

    #[test]
    fn slerp_is_even(a in turns(), b in turns(), t in 0.0..1.0_f64) {
        let angle = |p: Quaternion, q: Quaternion| {
            (p.conjugate() * q).angle_and_axis().map_or(0.0, |(a, _)| a.min(std::f64::consts::TAU - a))
        };
        let (whole, at) = (angle(a, b), a.slerp(b, t).unwrap());
        prop_assert!((angle(a, at) - t * whole).abs() < 1e-7);
        prop_assert!((angle(at, b) - (1.0 - t) * whole).abs() < 1e-7);
        let toward = a.rotate_towards(b, 0.5 * whole).unwrap();
        prop_assert!((angle(a, toward) - 0.5 * whole).abs() < 1e-7);
        prop_assert!(angle(a.rotate_towards(b, 7.0).unwrap(), b) < 1e-7);
    }
}

#[test]
fn quaternions_by_their_rules() {
    let (i, j, k) = (Quaternion::I, Quaternion::J, Quaternion::K);
    assert_eq!((i * j, j * k, k * i), (k, i, j));
    assert_eq!(i * i, -Quaternion::IDENTITY);
    assert_eq!(i * j * k, -Quaternion::IDENTITY);
    assert_eq!(
        (Quaternion::ZERO.inverse(), Quaternion::ZERO.unitized(), Quaternion::ZERO.ln()),
        (None, None, None)
    );
    let quarter = Quaternion::rotation(FRAC_PI_2, Vector3::Z).unwrap();
    assert!((quarter.rotate(Vector3::X).unwrap() - Vector3::Y).length() < 1e-15);
    let planes = Quaternion::between_planes(&Plane::XY, &Plane::XZ);
    assert!((planes.rotate(Vector3::Y).unwrap() - Vector3::Z).length() < 1e-15);
    assert!(Quaternion::rotation(1.0, Vector3::ZERO).is_err());
    assert_eq!(Quaternion::from_xform(&Xform::diagonal(1.0, 1.0, -1.0), 1e-9), None);
    let e = Quaternion::from_parts(0.0, Vector3::Z * PI).exp();
    assert!((e + Quaternion::IDENTITY).length() < 1e-15);
}
