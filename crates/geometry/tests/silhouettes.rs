//! Silhouettes against closed forms.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use std::f64::consts::{PI, TAU};

use katydid_geometry::construct::{self, LoftOptions};
use katydid_geometry::silhouette::{Silhouette, SilhouetteKind as Kind, Viewpoint};
use katydid_geometry::{
    Box3, Brep, Circle, Cone, Curve, Cylinder, Interval, Mesh, NurbsCurve, Plane, Point3, Sphere, Surface,
    Tolerance, Torus, Vector3,
};

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn v(x: f64, y: f64, z: f64) -> Vector3 {
    Vector3::new(x, y, z)
}

fn seen(brep: &Brep, from: Viewpoint) -> Vec<Silhouette> {
    let found = brep.silhouettes(from, &Tolerance::default(), &|| true).unwrap();
    assert!(found.complete);
    found.curves
}

fn along(brep: &Brep, direction: Vector3) -> Vec<Silhouette> {
    seen(brep, Viewpoint::Parallel(direction))
}

fn whole(surface: impl Into<Surface>) -> Brep {
    Brep::from_surface(surface.into()).unwrap()
}

fn outlines(all: &[Silhouette]) -> Vec<&Curve> {
    all.iter().filter(|s| s.kind.is_silhouette() && s.kind != Kind::Boundary).map(|s| &s.curve).collect()
}

fn length<'a>(curves: impl IntoIterator<Item = &'a Curve>) -> f64 {
    curves.into_iter().map(Curve::length).sum()
}

#[test]
fn a_sphere_has_one_circle() {
    let ball = whole(Sphere::around(p(1.0, 2.0, 3.0), 5.0).unwrap());
    for d in [
        Vector3::Z,
        Vector3::Y,
        Vector3::X,
        -Vector3::X,
        v(1.0, 2.0, 3.0),
        v(0.0, -1.0, 1.0),
        v(1.0, 1.0, 0.0),
    ] {
        let all = along(&ball, d);
        let outline = outlines(&all);
        assert!((length(outline.clone()) - TAU * 5.0).abs() < 1e-6, "{d:?} {outline:?}");
        for curve in outline {
            for k in 0..=50 {
                let q = curve.point_at(curve.domain().at(f64::from(k) / 50.0)) - p(1.0, 2.0, 3.0);
                assert!((q.length() - 5.0).abs() < 1e-8 && q.dot(d).abs() < 1e-7, "{d:?} {q:?}");
            }
        }
    }
    // From a point at distance D the circle has the radius r √(1 − r²/D²).
    for eye in [p(14.0, 2.0, 3.0), p(1.0, 2.0, 16.0), p(1.0 + 3.0, 2.0 + 4.0, 15.0)] {
        let all = seen(&ball, Viewpoint::Perspective(eye));
        assert!((length(outlines(&all)) - TAU * 5.0 * (1.0 - 25.0 / 169.0_f64).sqrt()).abs() < 1e-6);
    }
}

#[test]
fn cylinders_and_cones_have_rulings() {
    let tube = whole(Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 10.0)).unwrap());
    for d in [Vector3::X, Vector3::Y, v(1.0, 3.0, 0.0), v(-2.0, 1.0, 1.5)] {
        let all = along(&tube, d);
        let outline = outlines(&all);
        assert_eq!(outline.len(), 2, "{d:?} {all:?}");
        assert!((length(outline) - 20.0).abs() < 1e-7, "{d:?}");
        let ends = all.iter().filter(|s| s.kind == Kind::Boundary).map(|s| &s.curve);
        assert!((length(ends) - 2.0 * TAU * 2.0).abs() < 1e-6);
    }
    // Along its axis it is edge-on all over: nothing but its ends and its seam.
    let all = along(&tube, Vector3::Z);
    assert!(outlines(&all).is_empty(), "{all:?}");
    assert_eq!(all.len(), 3);
    // A cone seen across its axis shows two rulings of its slant; steeply from above none.
    let cone = whole(Cone::new(Plane::XY, 4.0, 3.0).unwrap());
    for d in [Vector3::X, v(1.0, 2.0, 0.0)] {
        let all = along(&cone, d);
        assert!((length(outlines(&all)) - 10.0).abs() < 1e-7, "{d:?} {all:?}");
    }
    assert!(outlines(&along(&cone, v(0.1, 0.0, -1.0))).is_empty());
}

#[test]
fn a_torus_from_above_and_from_the_side() {
    let ring = whole(Torus::new(Plane::XY, 5.0, 2.0).unwrap());
    let all = along(&ring, Vector3::Z);
    assert!((length(outlines(&all)) - TAU * (7.0 + 3.0)).abs() < 1e-6, "{:?}", outlines(&all));
    // Seen along x: the circles at the top and the bottom, and those in which the plane x = 0 cuts it.
    let all = along(&ring, Vector3::X);
    assert!(
        (length(outlines(&all)) - 2.0 * TAU * 5.0 - 2.0 * TAU * 2.0).abs() < 1e-3,
        "{:?}",
        outlines(&all)
    );
    // Aslant: the outline is where (cos a cos t, cos a sin t, sin a) is across the direction.
    let d = v(1.0, 0.0, -1.0).unitized().unwrap();
    let all = along(&ring, d);
    for curve in outlines(&all) {
        for k in 0..=40 {
            let q = curve.point_at(curve.domain().at(f64::from(k) / 40.0));
            let out = v(q.x, q.y, 0.0).unitized().unwrap() * 5.0;
            let n = (q.to_vector() - out) / 2.0;
            assert!((n.length() - 1.0).abs() < 1e-3 && n.dot(d).abs() < 1e-3, "{n:?} {q:?} {curve:?}");
        }
    }
}

#[test]
fn a_box_has_edges_of_its_kinds() {
    let side = Interval::new(0.0, 1.0);
    let cube = construct::box_brep(&Box3 { plane: Plane::XY, x: side, y: side, z: side }).unwrap();
    let count = |all: &[Silhouette], kind| all.iter().filter(|s| s.kind == kind).count();
    let corner = along(&cube, v(-1.0, -2.0, -3.0));
    assert_eq!(corner.len(), 12);
    assert_eq!(count(&corner, Kind::Crease), 6);
    assert_eq!(count(&corner, Kind::NonSilhouetteCrease), 6);
    let plan = along(&cube, -Vector3::Z);
    assert_eq!(count(&plan, Kind::Projecting), 8);
    assert_eq!(count(&plan, Kind::NonSilhouetteCrease), 4);
    // A mesh with corners of its own for each face has the same.
    let mesh = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 1, 1, 1).unwrap();
    for d in [v(-1.0, -2.0, -3.0), -Vector3::Z, Vector3::X] {
        let mut kinds: Vec<Kind> = along(&cube, d).iter().map(|s| s.kind).collect();
        let found = mesh.silhouettes(Viewpoint::Parallel(d), &Tolerance::default()).unwrap();
        let mut others: Vec<Kind> = found.curves.iter().map(|s| s.kind).collect();
        kinds.sort();
        others.sort();
        assert_eq!(kinds, others, "{d:?}");
    }
}

/// Numbers without a pattern, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[test]
fn lofts_are_tangent_to_the_line_of_sight_along_silhouettes() {
    let mut r = Numbers(7);
    let tolerance = Tolerance { absolute: 1e-6, ..Tolerance::default() };
    let mut curves = 0;
    for round in 0..12 {
        let sections: Vec<Curve> = (0..4)
            .map(|k| {
                let points: Vec<Point3> =
                    (0..7).map(|i| p(f64::from(i), 3.0 * f64::from(k), 4.0 * r.next() - 2.0)).collect();
                NurbsCurve::clamped_uniform(3, &points).unwrap().into()
            })
            .collect();
        let sheet = construct::loft(&sections, &LoftOptions::default(), &tolerance).unwrap();
        let d = v(r.next() - 0.5, r.next() - 0.5, 0.3 * r.next()).unitized().unwrap();
        let eye = p(20.0 * r.next() + 10.0, -20.0, 3.0 * r.next());
        let view = if round % 2 == 0 { Viewpoint::Parallel(d) } else { Viewpoint::Perspective(eye) };
        let found = sheet.silhouettes(view, &tolerance, &|| true).unwrap();
        for one in found.curves.iter().filter(|s| s.kind == Kind::Tangent) {
            curves += 1;
            for k in 0..=20 {
                let q = one.curve.point_at(one.curve.domain().at(f64::from(k) / 20.0));
                let near = sheet.closest_point(q).unwrap();
                assert!(near.distance < 1e-6, "{round} {k} {} {one:?}", near.distance);
                assert!(view.facing(near.normal.unwrap(), near.point).abs() < 1e-5, "{round}");
            }
        }
        // Every change of side between neighbouring places of a grid has a silhouette between.
        let surface = sheet.face_surface(0).unwrap();
        let domains = katydid_geometry::Direction::BOTH.map(|d| surface.domain(d));
        let facing = |i: i32, j: i32| {
            let (u, v) = (domains[0].at(f64::from(i) / 30.0), domains[1].at(f64::from(j) / 30.0));
            (surface.point_at(u, v), view.facing(surface.normal_at(u, v).unwrap(), surface.point_at(u, v)))
        };
        for i in 1..29 {
            for j in 1..30 {
                let ((a, s), (b, t)) = (facing(i, j), facing(i + 1, j));
                if s * t < 0.0 {
                    let middle = a.lerp(b, 0.5);
                    let near = found.curves.iter().filter(|s| s.kind == Kind::Tangent);
                    let miss =
                        near.map(|s| s.curve.closest_point(middle).unwrap().distance).fold(9.0, f64::min);
                    assert!(miss < a.distance_to(b), "{round} {i} {j} {miss}");
                }
            }
        }
    }
    assert!(curves >= 12, "{curves}");
}

#[test]
fn rounded_edges_have_no_curve_twice() {
    // A tube with a quarter of a turn, seen so that its straight sides are silhouettes.
    let arc: Curve =
        katydid_geometry::Arc::new(Circle::new(Plane::XY, 1.0).unwrap(), Interval::new(0.0, PI / 2.0))
            .unwrap()
            .into();
    let wall: Surface = katydid_geometry::SumSurface::extrusion(arc, v(0.0, 0.0, 3.0)).unwrap().into();
    let all = along(&whole(wall), Vector3::Y);
    assert_eq!(all.len(), 4, "{all:?}");
    assert!(all.iter().all(|s| s.kind == Kind::Boundary));
}

#[test]
fn bad_input_is_refused() {
    let ball = whole(Sphere::around(Point3::ORIGIN, 5.0).unwrap());
    let go_on = || true;
    for from in [
        Viewpoint::Parallel(Vector3::ZERO),
        Viewpoint::Parallel(v(f64::NAN, 0.0, 0.0)),
        Viewpoint::Perspective(p(0.0, f64::INFINITY, 0.0)),
    ] {
        assert!(ball.silhouettes(from, &Tolerance::default(), &go_on).is_err());
    }
    let view = Viewpoint::Parallel(Vector3::X);
    assert!(ball.silhouettes(view, &Tolerance { absolute: 0.0, angle: 0.1 }, &go_on).is_err());
    assert!(ball.silhouettes(view, &Tolerance::default(), &|| false).is_err());
}
