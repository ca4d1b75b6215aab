#![allow(clippy::unwrap_used, reason = "a failing test may panic")]

use std::f64::consts::TAU;

use super::{SurfaceContactKind, SurfaceMeeting, surface_surface};
use crate::{
    Curve, Cylinder, Interval, NurbsSurface, Plane, Point3, Sphere, Surface, Tolerance, Torus, Vector3, Xform,
};

/// z = a x² + b y² + c over −2…2 in both directions, exactly: x² has the Bernstein coefficients 4, −4, 4 there.
fn graph(a: f64, b: f64, c: f64) -> NurbsSurface {
    let square = [4.0, -4.0, 4.0];
    let points: Vec<Point3> = (0..9)
        .map(|k| {
            let (i, j) = (k / 3, k % 3);
            Point3::new(2.0 * i as f64 - 2.0, 2.0 * j as f64 - 2.0, a * square[i] + b * square[j] + c)
        })
        .collect();
    NurbsSurface::bezier([3, 3], &points).unwrap()
}

/// Not over the same square, so that nothing falls on a border.
fn floor() -> NurbsSurface {
    NurbsSurface::from_corners(
        Point3::new(-2.7, -2.3, 0.0),
        Point3::new(2.9, -2.5, 0.0),
        Point3::new(2.6, 2.4, 0.0),
        Point3::new(-2.5, 2.8, 0.0),
    )
    .unwrap()
}

fn meet(a: &NurbsSurface, b: &NurbsSurface) -> SurfaceMeeting {
    let tolerance = Tolerance { absolute: 1e-5, ..Tolerance::default() };
    let met = surface_surface(a, b, &tolerance).unwrap();
    for branch in &met.branches {
        assert!(branch.deviation <= 1e-5, "{}", branch.deviation);
        let domain = branch.curve.domain();
        for k in 0..=97 {
            let share = f64::from(k) / 97.0;
            let p = branch.curve.point_at(domain.at(share));
            for (surface, image) in [a, b].into_iter().zip(&branch.parameters) {
                let uv = image.point_at(image.domain().at(share));
                let wrapped = Surface::from(surface.clone());
                let [u, v] = [crate::Direction::U, crate::Direction::V].map(|d| {
                    let (domain, t) = (wrapped.domain(d), if d == crate::Direction::U { uv.x } else { uv.y });
                    if domain.contains(t) { t } else { domain.wrapped(t) }
                });
                assert!(surface.point_at(u, v).distance_to(p) < 2e-5);
            }
        }
    }
    met
}

fn counts(met: &SurfaceMeeting) -> [usize; 2] {
    let closed = met.branches.iter().filter(|b| b.closed).count();
    [closed, met.branches.len() - closed]
}

fn length(met: &SurfaceMeeting) -> f64 {
    met.branches.iter().map(|b| b.curve.length()).sum()
}

#[test]
fn bowls_have_circles() {
    for radius in [1.5, 1.0, 1e-1, 1e-2, 1e-3] {
        let met = meet(&graph(1.0, 1.0, -radius * radius), &floor());
        assert!(met.complete && met.contacts.is_empty(), "{radius}");
        assert_eq!(counts(&met), [1, 0], "{radius}");
        assert!((length(&met) - TAU * radius).abs() < 1e-5, "{radius} {}", length(&met));
        // Smaller loops are round only as far as the small angle between the surfaces tells where they are.
        if radius > 0.05 {
            let circle = met.branches[0].curve.as_circle(1e-9);
            assert!(circle.is_some_and(|c| (c.radius - radius).abs() < 1e-9), "{radius}");
        }
    }
    assert!(meet(&graph(1.0, 1.0, 1e-6), &floor()).branches.is_empty());
}

#[test]
fn saddles_have_hyperbolas() {
    for c in [0.3, 1e-2, -1e-4, 1e-6] {
        let met = meet(&graph(1.0, -1.0, c), &floor());
        assert!(met.complete, "{c}");
        assert_eq!(counts(&met), [0, 2], "{c}");
        // From the side of the square to its side: x² − y² = −c.
        let n = 40_000;
        let r = c.abs();
        let end = (4.0_f64 - r).sqrt();
        let at = |k: usize| {
            let y = -end + 2.0 * end * k as f64 / n as f64;
            Point3::new((y * y + r).sqrt(), y, 0.0)
        };
        let want: f64 = (0..n).map(|k| at(k).distance_to(at(k + 1))).sum();
        assert!((length(&met) - 2.0 * want).abs() < 1e-3, "{c} {} {want}", length(&met));
    }
}

#[test]
fn contacts_have_names() {
    let kind = |a: f64, b: f64| {
        let met = meet(&graph(a, b, 0.0), &floor());
        (met.contacts.iter().map(|c| c.kind).collect::<Vec<_>>(), counts(&met), met.complete)
    };
    assert_eq!(kind(1.0, 2.0), (vec![SurfaceContactKind::Point], [0, 0], true));
    assert_eq!(kind(1.0, -1.0), (vec![SurfaceContactKind::Crossing], [0, 4], true));
    assert_eq!(kind(1.0, 0.0).0, vec![SurfaceContactKind::Curve]);
    assert_eq!(kind(0.0, 0.0).0, vec![SurfaceContactKind::Overlap]);
    let touch = meet(&graph(1.0, 1.0, 0.0), &floor());
    assert!(touch.contacts[0].point.distance_to(Point3::ORIGIN) < 1e-12);
}

/// A floor under a bowl, a saddle and a valley sinks through the place where it touches them, in 200 steps.
#[test]
fn a_floor_sinks_through_each_contact() {
    for (a, b, before, kind, after) in [
        (1.0, 2.0, [1, 0], SurfaceContactKind::Point, [0, 0]),
        (1.0, -1.5, [0, 2], SurfaceContactKind::Crossing, [0, 2]),
        (1.0, 0.0, [0, 2], SurfaceContactKind::Curve, [0, 0]),
    ] {
        for step in 0..=200 {
            let c = 1e-3 * f64::from(step - 100);
            let met = meet(&graph(a, b, c), &floor());
            let kinds: Vec<_> = met.contacts.iter().map(|c| c.kind).collect();
            match step {
                100 => assert_eq!((kinds, met.complete), (vec![kind], true), "{a} {b}"),
                _ => {
                    let want = if step < 100 { before } else { after };
                    assert_eq!((counts(&met), kinds, met.complete), (want, vec![], true), "{a} {b} {c}");
                }
            }
        }
        // Nearer than a loop of a thousandth there is a name for it, if not the right curves.
        for c in [1e-7, 1e-9, 1e-11, 1e-13].into_iter().flat_map(|c| [-c, c]) {
            let met = meet(&graph(a, b, c), &floor());
            let right = counts(&met) == if c < 0.0 { before } else { after } && met.contacts.is_empty();
            assert!(right || !met.contacts.is_empty(), "{a} {b} {c} {:?}", counts(&met));
        }
    }
}

#[test]
fn tangent_points_are_exact() {
    for (radius, way) in [(1.0, Vector3::new(1.0, 2.0, 2.0)), (0.3, Vector3::new(-2.0, 1.0, 0.5))] {
        let frame = Plane::from_normal(Point3::new(0.3, -0.2, radius), way).unwrap();
        let ball = Surface::from(Sphere::new(frame, radius).unwrap()).to_nurbs().unwrap();
        let met = meet(&ball, &floor());
        let [only] = &met.contacts[..] else { panic!("{:?}", met.contacts) };
        assert!(met.complete && met.branches.is_empty());
        assert_eq!(only.kind, SurfaceContactKind::Point);
        assert!(only.point.distance_to(Point3::new(0.3, -0.2, 0.0)) < 1e-12, "{:?}", only.point);
        assert!(only.gap < 1e-14, "{}", only.gap);
    }
}

/// The one curve along which two surfaces touch.
fn tangent_curve(a: &NurbsSurface, b: &NurbsSurface) -> super::SurfaceBranch {
    let met = meet(a, b);
    let [only] = &met.contacts[..] else { panic!("{:?}", met.contacts) };
    assert!(met.complete && met.branches.is_empty());
    assert_eq!(only.kind, SurfaceContactKind::Curve);
    let branch = only.curve.clone().unwrap();
    assert!(branch.deviation < 1e-5, "{}", branch.deviation);
    branch
}

#[test]
fn tangent_curves_are_followed() {
    // A valley on a floor, from side to side.
    let valley = tangent_curve(&graph(1.0, 0.0, 0.0), &floor());
    assert!(!valley.closed);
    assert!((valley.curve.length() - 4.0).abs() < 1e-9, "{}", valley.curve.length());
    // A ring under a floor touches it along a circle, across the seams of the ring.
    let ring = Surface::from(Torus::new(Plane::XY.offset(-0.5), 1.5, 0.5).unwrap()).to_nurbs().unwrap();
    let top = tangent_curve(&ring, &floor());
    assert!(top.closed);
    assert!((top.curve.as_circle(1e-7).unwrap().radius - 1.5).abs() < 1e-8);
    assert!((top.curve.length() - 1.5 * TAU).abs() < 1e-7);
    // A ball fills a tube.
    let frame = Plane::from_normal(Point3::new(0.0, 0.0, 0.2), Vector3::new(1.0, 2.0, 2.0)).unwrap();
    let ball = Surface::from(Sphere::new(frame, 1.0).unwrap()).to_nurbs().unwrap();
    let height = crate::Interval::new(-2.0, 2.0);
    let tube = Surface::from(crate::Cylinder::new(Plane::XY, 1.0, height).unwrap()).to_nurbs().unwrap();
    let around = tangent_curve(&ball, &tube);
    assert!(around.closed);
    assert!((around.curve.as_circle(1e-7).unwrap().radius - 1.0).abs() < 1e-8);
}

#[test]
fn laws_hold() {
    let (a, b) = (graph(1.0, -1.0, 0.05), graph(-0.4, 0.3, 0.1));
    let met = meet(&a, &b);
    let want = (counts(&met), length(&met));
    assert!(met.complete && want.0 != [0, 0]);
    let swapped = meet(&b, &a);
    for (x, y) in met.branches.iter().zip(&swapped.branches) {
        let back = y.curve.reversed();
        assert_eq!(x.curve.start(), back.start());
        assert_eq!(x.curve.end(), back.end());
        assert_eq!(x.parameters[0].control_points(), y.parameters[1].reversed().control_points());
    }
    let axis = Vector3::new(1.0, 2.0, 3.0).unitized().unwrap();
    let turned = Xform::rotation(0.7, axis, Point3::ORIGIN);
    for (name, xform, scale) in [
        ("moved", Ok(Xform::translation(Vector3::new(1e6, -1e6, 1e6))), 1.0),
        ("small", Ok(Xform::scale(Point3::ORIGIN, 1e-3)), 1e-3),
        ("large", Ok(Xform::scale(Point3::ORIGIN, 1e4)), 1e4),
        ("turned", turned, 1.0),
    ] {
        let xform = xform.unwrap();
        let tolerance = Tolerance { absolute: 1e-5 * scale, ..Tolerance::default() };
        let [a, b] = [&a, &b].map(|s| s.transformed(&xform).unwrap());
        let other = surface_surface(&a, &b, &tolerance).unwrap();
        assert!(other.complete, "{name}");
        assert_eq!(counts(&other), want.0, "{name}");
        assert!((length(&other) / scale - want.1).abs() < 1e-4, "{name}");
    }
}

#[test]
fn seams_are_crossed() {
    let ring = |p: Plane| Surface::from(Torus::new(p, 5.0, 2.0).unwrap()).to_nurbs().unwrap();
    let ball = |x: f64, y: f64, z: f64, r: f64| {
        Surface::from(Sphere::around(Point3::new(x, y, z), r).unwrap()).to_nurbs().unwrap()
    };
    // A ball round the outermost point of the ring, at its seams.
    let met = meet(&ring(Plane::XY), &ball(7.0, 0.0, 0.0, 1.0));
    assert!(met.complete, "{:?}", met.contacts);
    assert_eq!(counts(&met), [1, 0]);
    // Linked rings do not meet; a ring pushed through another does.
    let upright = Plane::XZ.with_origin(Point3::new(5.0, 0.0, 0.0));
    assert!(meet(&ring(Plane::XY), &ring(upright)).branches.is_empty());
}

#[test]
fn circles_stay_circles() {
    let ball = Surface::from(Sphere::around(Point3::new(0.2, 0.1, 0.3), 1.0).unwrap()).to_nurbs().unwrap();
    let met = meet(&ball, &floor());
    let [only] = &met.branches[..] else { panic!("{}", met.branches.len()) };
    assert!(only.closed && met.complete);
    let circle = only.curve.as_circle(1e-8).unwrap();
    assert!((circle.radius - 0.91_f64.sqrt()).abs() < 1e-8);
    assert!((only.curve.length() - TAU * circle.radius).abs() < 1e-8);
    assert!(!matches!(only.curve, Curve::Nurbs(_)));
}

#[test]
fn bad_input_is_refused() {
    let flat = floor();
    let negative = NurbsSurface::with_weights(
        [1, 1],
        [2, 2],
        &flat.control_points(),
        &[1.0, 1.0, -0.5, 1.0],
        [vec![0.0, 1.0], vec![0.0, 1.0]],
    );
    if let Ok(negative) = negative {
        assert!(surface_surface(&negative, &graph(1.0, 1.0, -1.0), &Tolerance::default()).is_err());
    }
    let none = Tolerance { absolute: 0.0, ..Tolerance::default() };
    assert!(surface_surface(&flat, &flat, &none).is_err());
}

/// A wall whose parts go on smoothly into each other at another speed, cut by tubes and a squeezed ball over that line.
#[test]
fn where_speed_leaps_nothing_is_undecided() {
    let profile = [(0.0, 0.0), (1.0, 0.3), (2.0, 0.5), (3.0, 0.5), (3.5, 0.5), (4.2, 0.2), (5.0, 0.0)];
    let net = profile.iter().flat_map(|(x, y)| [0.0, 2.0].map(|z| Point3::new(*x, *y, z))).collect();
    let knots = [vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0], vec![0.0, 1.0]];
    let wall = NurbsSurface::new([3, 1], [7, 2], net, knots).unwrap();
    let tolerance = Tolerance { absolute: 1e-5, ..Tolerance::default() };
    for tilt in [0.0, 0.1, 0.3] {
        let way = Vector3::new(tilt, 1.0, 0.5 * tilt);
        let plane = Plane::from_normal(Point3::new(3.05, -1.0, 1.0), way).unwrap();
        let ball = Sphere::around(Point3::new(3.05, 0.3, 1.0), 0.7).unwrap().to_nurbs().unwrap();
        let squeezed = Xform::scale_non_uniform(&plane, 1.0, 1.2, 0.9);
        let mut others = vec![ball.transformed(&squeezed).unwrap()];
        for radius in [0.3, 0.7] {
            let tube = Cylinder::new(plane, radius, Interval::new(0.0, 3.0)).unwrap();
            others.push(tube.to_nurbs().unwrap());
        }
        for (k, other) in others.iter().enumerate() {
            let met = surface_surface(&wall, other, &tolerance).unwrap();
            assert!(met.complete && met.contacts.is_empty(), "{tilt} {k}: {:?}", met.contacts);
            // One loop, in one piece or in two that go on in each other.
            assert!(met.branches.iter().all(|b| b.deviation <= 1e-5), "{tilt} {k}");
            match met.branches.as_slice() {
                [only] => assert!(only.closed, "{tilt} {k}"),
                [a, b] => {
                    let gap = a.curve.end().distance_to(b.curve.start());
                    assert!(gap.max(b.curve.end().distance_to(a.curve.start())) <= 1e-9, "{tilt} {k}");
                }
                more => panic!("{tilt} {k}: {} branches", more.len()),
            }
        }
    }
}

#[test]
fn a_loop_whose_edge_just_crosses_a_seam_is_one_loop() {
    let (r, c) = (0.75, 1.3);
    let ball = Sphere::new(Plane::XY.with_origin(Point3::new(c, 0.0, 0.1)), r).unwrap();
    let ball = Surface::from(ball.to_revolution()).to_nurbs().unwrap();
    // The rulings that touch the ball stand at these angles.
    let edge = ((1.0 + c * c - r * r) / (2.0 * c)).acos();
    let length = |seam: f64| {
        let axis = Plane::from_axes(
            Point3::new(0.0, 0.0, -2.0),
            Vector3::new(seam.cos(), seam.sin(), 0.0),
            Vector3::new(-seam.sin(), seam.cos(), 0.0),
        );
        let wall = Cylinder::new(axis.unwrap(), 1.0, Interval::new(0.0, 4.0)).unwrap();
        let wall = Surface::from(wall.to_revolution()).to_nurbs().unwrap();
        let met = meet(&ball, &wall);
        assert!(met.complete && met.contacts.is_empty(), "{seam}");
        assert_eq!(counts(&met), [1, 0], "{seam}");
        met.branches[0].curve.length()
    };
    let want = length(3.0);
    for beyond in [0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10, 1e-12] {
        for seam in [edge - beyond, beyond - edge, edge + beyond] {
            let found = length(seam);
            assert!((found - want).abs() < 1e-4, "{seam} {found} {want}");
        }
    }
}
