//! Laws of NURBS surfaces: what edits keep, what constructors refuse.

use crate::common::{close, close_points, close_surfaces};
use katydid_geometry::{
    Cone, Cylinder, Direction, Interval, KnotSpacing, Line, NurbsCurve, NurbsSurface, Plane, PlaneSurface,
    Point3, Quadrant, RevolutionSurface, Side, Sphere, SumSurface, Surface, Torus, Vector3, Xform,
    compatible_curves,
};
use proptest::prelude::*;

fn net(counts: [usize; 2], seed: f64) -> Vec<Point3> {
    (0..counts[0] * counts[1])
        .map(|k| {
            let (i, j) = ((k / counts[1]) as f64, (k % counts[1]) as f64);
            Point3::new(i, j, (seed + 3.1 * i + 1.7 * j).sin())
        })
        .collect()
}

fn samples(s: &NurbsSurface) -> Vec<(f64, f64)> {
    let [u, v] = Direction::BOTH.map(|d| s.domain(d));
    [0.0, 0.17, 0.5, 0.71, 1.0]
        .iter()
        .flat_map(|&x| [0.0, 0.3, 0.66, 1.0].map(|y| (u.at(x), v.at(y))))
        .collect()
}

#[track_caller]
fn same_points(a: &NurbsSurface, b: &NurbsSurface, tolerance: f64) {
    for (u, v) in samples(b) {
        close_points(a.point_at(u, v), b.point_at(u, v), tolerance, "same point");
    }
}

fn any_surface() -> impl Strategy<Value = NurbsSurface> {
    (1usize..5, 1usize..5, 0usize..4, 0usize..4, any::<[bool; 2]>(), any::<bool>(), 0.0..10.0f64).prop_map(
        |(p, q, m, n, periodic, rational, seed)| {
            let counts = [p.max(2) + m, q.max(2) + n].map(|c| c + 1);
            let s = NurbsSurface::uniform([p, q], counts, &net(counts, seed), periodic).unwrap();
            if !rational {
                return s;
            }
            // Weights that repeat with the grid, so that a periodic surface stays so.
            let [r, c] = s.counts();
            let weights: Vec<f64> = (0..r * c)
                .map(|k| 1.0 + 0.5 * ((k / c % counts[0]) as f64 * 1.3 + (k % c % counts[1]) as f64).sin())
                .collect();
            let knots = Direction::BOTH.map(|d| s.knots(d).to_vec());
            NurbsSurface::with_weights([p, q], [r, c], &s.control_points(), &weights, knots).unwrap()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn edits_keep_the_surface(s in any_surface(), x in 0.05..0.95f64, m in 1usize..4) {
        for d in Direction::BOTH {
            let t = s.domain(d).at(x);
            let m = m.min(s.degree(d));
            let inserted = s.insert_knot(d, t, m).unwrap();
            same_points(&inserted, &s, 1e-11);
            prop_assert_eq!(inserted.is_periodic(d), s.is_periodic(d));
            same_points(&s.clamped(d).unwrap(), &s, 1e-11);
            same_points(&s.raised_to(d, s.degree(d) + 2).unwrap(), &s, 1e-10);
            let (a, b) = s.split(d, t).unwrap();
            for (u, v) in samples(&s) {
                let own = if d == Direction::U { u } else { v };
                close_points(if own <= t { &a } else { &b }.point_at(u, v), s.point_at(u, v), 1e-11, "split");
            }
            let r = s.domain(d);
            let larger = Interval::new(r.start - 0.1, r.end + 0.1);
            if let Ok(more) = s.extended(d, larger) {
                same_points(&more, &s, 1e-10);
                prop_assert_eq!(more.domain(d), larger);
            }
            prop_assert_eq!(&s.reversed(d).reversed(d), &s);
            let there = s.with_domain(d, Interval::new(-7.0, 3.0)).unwrap();
            close_surfaces(&there.with_domain(d, r).unwrap(), &s, 1e-12, "domain");
        }
        prop_assert_eq!(&s.transposed().transposed(), &s);
        same_points(&s.piecewise_bezier().unwrap(), &s, 1e-11);
        for patch in s.bezier_patches().unwrap() {
            same_points(&s, &patch, 1e-11);
        }
        same_points(&s.to_rational(), &s, 1e-13);
        let hull = s.hull_box();
        let tight = s.bounding_box().inflated(1e-9);
        for (u, v) in samples(&s) {
            prop_assert!(tight.contains(s.point_at(u, v)));
        }
        prop_assert!(hull.inflated(1e-9).contains(tight.min) || hull.inflated(1e-8).contains(tight.center()));
    }

    #[test]
    fn seams_move(s in any_surface(), x in 0.05..0.95f64) {
        for d in Direction::BOTH {
            if !s.is_closed(d) {
                continue;
            }
            let r = s.domain(d);
            let t = r.at(x);
            let moved = s.with_seam(d, t).unwrap();
            close(moved.domain(d).start, t, 1e-13, "start");
            close(moved.domain(d).length(), r.length(), 1e-12, "period");
            prop_assert_eq!(moved.is_periodic(d), s.is_periodic(d));
            for (u, v) in samples(&s) {
                let wrap = |t0: f64, w: f64| if w < t0 { w + r.length() } else { w };
                let (u2, v2) = if d == Direction::U { (wrap(t, u), v) } else { (u, wrap(t, v)) };
                close_points(moved.point_at(u2, v2), s.point_at(u, v), 1e-10, "seam");
            }
        }
    }

    #[test]
    fn interpolation_goes_through(
        p in 1usize..6, q in 1usize..6, m in 1usize..5, n in 1usize..5,
        spacing in prop_oneof![
            Just(KnotSpacing::Uniform), Just(KnotSpacing::Chord), Just(KnotSpacing::SquareRootChord)
        ],
        periodic in any::<[bool; 2]>(), seed in 0.0..10.0f64,
    ) {
        let counts = [p.max(2) + m, q.max(2) + n];
        // A bent tube, so that no two lines coincide when closed.
        let points: Vec<Point3> = (0..counts[0] * counts[1]).map(|k| {
            let a = (k / counts[1]) as f64 / counts[0] as f64 * 6.0;
            let b = (k % counts[1]) as f64 / counts[1] as f64 * 6.0;
            let r = 3.0 + b.cos() + 0.2 * (seed + a).sin();
            Point3::new(r * a.cos(), r * a.sin(), b.sin())
        }).collect();
        let even = (periodic[0] && p % 2 == 0) || (periodic[1] && q % 2 == 0);
        let s = NurbsSurface::interpolate([p, q], counts, &points, spacing, periodic);
        prop_assert_eq!(s.is_err(), even);
        if let Ok(s) = s {
            let [us, vs] = NurbsSurface::interpolation_parameters(counts, &points, spacing, periodic).unwrap();
            for i in 0..counts[0] {
                for j in 0..counts[1] {
                    close_points(s.point_at(us[i], vs[j]), points[i * counts[1] + j], 1e-9, "point");
                }
            }
            for (d, closed) in Direction::BOTH.into_iter().zip(periodic) {
                if closed && s.degree(d) > 1 {
                    prop_assert!(s.is_periodic(d));
                }
            }
        }
    }

    #[test]
    fn compatible_curves_keep_their_points(p in 1usize..5, q in 1usize..5, m in 0usize..5, n in 0usize..5) {
        let curve = |p: usize, m: usize| NurbsCurve::clamped_uniform(p, &net([p + 1 + m, 1], 2.0)).unwrap();
        let (a, b) = (curve(p, m), curve(q, n));
        let made = compatible_curves(&[a.clone(), b.clone()]).unwrap();
        prop_assert_eq!(made[0].knots(), made[1].knots());
        for (old, new) in [a, b].iter().zip(&made) {
            for k in 0..=10 {
                let x = f64::from(k) / 10.0;
                close_points(old.point_at(old.domain().at(x)), new.point_at(new.domain().at(x)), 1e-10, "curve");
            }
        }
    }

    /// Whatever the numbers: an error, or a surface whose points are finite.
    #[test]
    fn constructors_take_anything(
        degrees in [degree(), degree()], counts in [0usize..9, 0usize..9],
        numbers in prop::collection::vec(any_number(), 0..160), periodic in any::<[bool; 2]>(),
    ) {
        let at = |i: usize| numbers.get(i % numbers.len().max(1)).copied().unwrap_or(0.0);
        let given = counts[0] * counts[1];
        let points: Vec<Point3> =
            (0..given).map(|i| Point3::new(at(3 * i), at(3 * i + 1), at(3 * i + 2))).collect();
        let knots = [0, 1].map(|d| {
            let mut k: Vec<f64> = (0..(counts[d] + degrees[d]).saturating_sub(1)).map(|i| at(i + 7 * d)).collect();
            if numbers.len() % 2 == 0 {
                k.sort_by(f64::total_cmp);
            }
            // Now and then knots that fit.
            if numbers.len() % 4 == 0 {
                k = (0..k.len()).map(|i| i as f64 * at(0).abs().max(0.1)).collect();
            }
            k
        });
        let weights: Vec<f64> =
            (0..given).map(|i| if numbers.len() % 3 == 0 { at(i).abs() + 1e-9 } else { at(i) }).collect();
        let spacing = if periodic[0] { KnotSpacing::Chord } else { KnotSpacing::Uniform };
        let made = [
            NurbsSurface::new(degrees, counts, points.clone(), knots.clone()),
            NurbsSurface::with_weights(degrees, counts, &points, &weights, knots),
            NurbsSurface::uniform(degrees, counts, &points, periodic),
            NurbsSurface::interpolate(degrees, counts, &points, spacing, periodic),
            NurbsSurface::bezier(counts, &points),
        ];
        for s in made.into_iter().flatten() {
            check(&s.into(), 1e100);
        }
        let plane = Plane::from_normal(Point3::new(at(0), at(1), at(2)), Vector3::new(at(3), at(4), at(5)));
        if let Ok(plane) = plane {
            let range = Interval::new(at(6), at(7));
            let kinds: Vec<Surface> = [
                Sphere::new(plane, at(8)).ok().map(Surface::from),
                Cylinder::new(plane, at(8), range).ok().map(Surface::from),
                Cone::new(plane, at(8), at(9)).ok().map(Surface::from),
                Torus::new(plane, at(8), at(9)).ok().map(Surface::from),
                PlaneSurface::new(plane, range, Interval::new(at(8), at(9))).ok().map(Surface::from),
                SumSurface::extrusion(Line::new(plane.origin, plane.at(at(6), at(7), 0.0)).into(), plane.x_axis)
                    .ok()
                    .map(Surface::from),
                RevolutionSurface::new(
                    Line::new(plane.origin, plane.at(at(6), at(7), 0.0)).into(),
                    Line::new(Point3::ORIGIN, plane.origin),
                    range,
                )
                .ok()
                .map(Surface::from),
            ].into_iter().flatten().collect();
            for s in &kinds {
                check(s, 1e100);
            }
        }
    }
}

fn degree() -> impl Strategy<Value = usize> {
    prop_oneof![6 => 1usize..4, 1 => 0usize..40]
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -10.0..10.0f64,
        2 => (0..6i32).prop_map(f64::from),
        1 => any::<f64>(),
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(0.0), Just(1e-320), Just(1e300)],
    ]
}

/// Drives everything a surface answers; points must be finite when the input was of moderate size.
fn check(s: &Surface, moderate: f64) {
    let [du, dv] = Direction::BOTH.map(|d| s.domain(d));
    let sizes = |s: &Surface| {
        s.to_nurbs().map_or(f64::INFINITY, |n| {
            n.homogeneous_points().iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()))
                / n.weights().iter().fold(1.0_f64, |m, w| m.min(*w))
        })
    };
    let width = |d: Direction| match s {
        Surface::Nurbs(n) => {
            n.span_parameters(d).windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min)
        }
        _ => s.domain(d).length(),
    };
    let tame = sizes(s) < moderate
        && [du, dv].iter().all(|d| d.start.abs() < moderate && d.end.abs() < moderate)
        && Direction::BOTH.into_iter().all(|d| width(d) > 1e-100);
    for (u, v) in [(du.start, dv.start), (du.middle(), dv.middle()), (du.end, dv.end)] {
        let p = s.point_at(u, v);
        assert!(!tame || p.is_finite(), "{p:?}");
        let _ = s.derivatives(u, v, 3, Quadrant::SouthWest);
        if let Some(n) = s.normal_at(u, v) {
            assert!(n.is_finite());
        }
        let _ = (s.frame_at(u, v), s.curvature_at(u, v), s.normal_section(u, v, Vector3::X));
    }
    for d in Direction::BOTH {
        let t = s.domain(d).middle();
        let _ = (s.isocurve(d, t), s.split(d, t), s.is_closed(d), s.reversed(d));
        let _ = s.with_domain(d, Interval::UNIT);
    }
    let _ = Side::ALL.map(|side| s.is_singular(side));
    let _ = (s.bounding_box(), s.plane(1e-3), s.transformed(&Xform::scale(Point3::ORIGIN, 3.0)));
    let _ = (s.as_sphere(1e-3), s.as_cylinder(1e-3), s.as_cone(1e-3), s.as_torus(1e-3));
}

#[test]
fn bad_input_is_named() {
    let text = |r: katydid_geometry::Result<NurbsSurface>| r.unwrap_err().to_string();
    let k = || [vec![0.0, 1.0], vec![0.0, 1.0]];
    let p = |n: usize| vec![Point3::ORIGIN; n];
    assert!(text(NurbsSurface::new([1, 1], [2, 2], p(3), k())).contains("grid of 2 by 2"));
    assert!(text(NurbsSurface::new([1, 0], [2, 2], p(4), k())).contains("degree is 0"));
    assert!(text(NurbsSurface::new([1, 200], [2, 2], p(4), k())).contains("degree is 200"));
    assert!(text(NurbsSurface::new([1, 1], [usize::MAX, 2], p(4), k())).contains("grid"));
    let decreasing = [vec![0.0, 1.0], vec![1.0, 0.0]];
    assert!(text(NurbsSurface::new([1, 1], [2, 2], p(4), decreasing)).contains("knot 1 is smaller"));
    let weights = NurbsSurface::with_weights([1, 1], [2, 2], &p(4), &[1.0, 1.0, 0.0, 1.0], k());
    assert!(text(weights).contains("weight (1, 0) is 0"));
    assert!(
        text(NurbsSurface::interpolate([3, 3], [4, 4], &p(16), KnotSpacing::Chord, [false; 2]))
            .contains("length")
    );
    assert!(text(NurbsSurface::bezier([1, 1], &p(1))).contains("degree is 0"));
    let s = NurbsSurface::bezier([2, 2], &p(4)).unwrap();
    assert!(text(s.with_weight(2, 0, 1.0)).contains("(2, 0)"));
    assert!(text(s.with_weight(0, 0, -1.0)).contains("weight is -1"));
    assert!(text(s.with_seam(Direction::U, 0.5)).contains("not closed"));
    assert!(s.insert_knot(Direction::U, 2.0, 1).is_err() && s.insert_knot(Direction::U, 0.5, 2).is_err());
    assert!(s.trimmed(Direction::V, Interval::new(0.5, 0.5)).is_err());
}

#[test]
fn tight_boxes_are_tight() {
    let sphere = Surface::from(Sphere::around(Point3::new(1.0, 2.0, 3.0), 2.0).unwrap());
    let turned = sphere
        .transformed(&Xform::rotation(0.4, Vector3::new(1.0, 1.0, 0.3), Point3::new(1.0, 2.0, 3.0)).unwrap());
    let b = turned.unwrap().bounding_box().unwrap();
    close_points(b.min, Point3::new(-1.0, 0.0, 1.0), 1e-11, "sphere");
    close_points(b.max, Point3::new(3.0, 4.0, 5.0), 1e-11, "sphere");
    let torus = Surface::from(Torus::new(Plane::XY, 3.0, 1.0).unwrap()).bounding_box().unwrap();
    close_points(torus.max, Point3::new(4.0, 4.0, 1.0), 1e-11, "torus");
    // A hill whose top is inside a patch: z = 16 u(1−u) v(1−v) reaches 1.
    let mut hill = Vec::new();
    for i in 0..3 {
        for j in 0..3 {
            hill.push(Point3::new(f64::from(i), f64::from(j), if (i, j) == (1, 1) { 4.0 } else { 0.0 }));
        }
    }
    let b = NurbsSurface::bezier([3, 3], &hill).unwrap().bounding_box();
    close(b.max.z, 1.0, 1e-11, "hill");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    /// Surfaces of revolution are bounded by formula where the profile lies in a plane with the axis; their exact NURBS forms
    /// by subdivision. Profiles that cross the axis and parts of a turn too.
    #[test]
    fn extents_of_revolutions_are_those_of_their_nurbs_forms(
        points in prop::collection::vec((-3.0..5.0f64, -4.0..4.0f64), 3..7),
        start in -7.0..7.0f64,
        turn in prop_oneof![0.05..6.2f64, Just(std::f64::consts::TAU)],
        leaves in prop_oneof![Just(0.0), Just(0.3)],
        towards in (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64),
        place in (-50.0..50.0f64, 0.0..3.0f64),
    ) {
        let profile = points.iter().map(|&(x, z)| Point3::new(x, leaves * x * x, z)).collect::<Vec<_>>();
        let profile = NurbsCurve::clamped_uniform(2, &profile).unwrap();
        let axis = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0));
        let s = RevolutionSurface::new(profile.into(), axis, Interval::new(start, start + turn)).unwrap();
        let moves = Xform::translation(Vector3::new(place.0, -2.0, 7.0))
            * Xform::rotation(place.1, Vector3::new(1.0, 2.0, -1.0), Point3::new(3.0, 1.0, 0.0)).unwrap();
        let s = Surface::from(s).transformed(&moves).unwrap();
        prop_assert!(matches!(s, Surface::Revolution(_)));
        let direction = Vector3::new(towards.0, towards.1, towards.2);
        let (own, exact) = (s.extent_along(direction).unwrap(), s.to_nurbs().unwrap().extent_along(direction));
        prop_assert!((own.start - exact.start).abs() <= 1e-10 && (own.end - exact.end).abs() <= 1e-10);
        let (own, exact) = (s.bounding_box().unwrap(), s.to_nurbs().unwrap().bounding_box());
        close_points(own.min, exact.min, 1e-10, "least");
        close_points(own.max, exact.max, 1e-10, "most");
    }
}

/// A ridge of equal height across a patch is bounded, if not as closely as a top.
#[test]
fn ridges_are_bounded() {
    // z = 4 − (u − v)² over 0…1 by 0…1, and a turn of it.
    let square = |i: usize| [0.0, 0.0, 1.0][i];
    let linear = |i: usize| [0.0, 0.5, 1.0][i];
    let mut net = Vec::new();
    for i in 0..3 {
        for j in 0..3 {
            let z = 4.0 - (square(i) - 2.0 * linear(i) * linear(j) + square(j));
            net.push(Point3::new(linear(i), linear(j), z));
        }
    }
    let b = NurbsSurface::bezier([3, 3], &net).unwrap().bounding_box();
    assert!((4.0..4.0 + 1e-6).contains(&b.max.z), "{}", b.max.z);
    close(b.min.z, 3.0, 1e-12, "lowest corner");
}

#[test]
fn front_and_back() {
    // The surface of a hill, a point above it and one below (BOOK V12).
    let s = Surface::from(Sphere::around(Point3::ORIGIN, 2.0).unwrap());
    let sphere = Sphere::around(Point3::ORIGIN, 2.0).unwrap();
    for (p, height) in [(Point3::new(3.0, 0.0, 4.0), 3.0), (Point3::new(0.0, -1.0, 0.0), -1.0)] {
        let (u, v) = sphere.closest_parameters(p).unwrap();
        close(s.height_over(u, v, p).unwrap(), height, 1e-14, "height");
    }
}

#[test]
fn seams_of_every_kind_move() {
    let torus = Surface::from(Torus::new(Plane::XZ, 3.0, 1.0).unwrap());
    let circle = katydid_geometry::Circle::new(Plane::YZ, 1.5).unwrap();
    let tube = Surface::from(SumSurface::extrusion(circle.into(), Vector3::new(2.0, 1.0, 0.0)).unwrap());
    let nurbs = Surface::from(torus.to_nurbs().unwrap());
    for s in [torus.clone(), tube, nurbs, torus.transposed()] {
        for d in Direction::BOTH {
            if !s.is_closed(d) {
                assert!(s.with_seam(d, s.domain(d).middle()).is_err());
                continue;
            }
            let (r, t) = (s.domain(d), s.domain(d).at(0.3));
            let moved = s.with_seam(d, t).unwrap();
            assert!(moved.is_closed(d));
            close(moved.domain(d).start, t, 1e-14, "start");
            let other = s.domain(d.other()).at(0.6);
            for k in 0..8 {
                let w = r.at(f64::from(k) / 8.0);
                let at = |s: &Surface, w: f64| {
                    if d == Direction::U { s.point_at(w, other) } else { s.point_at(other, w) }
                };
                close_points(at(&moved, if w < t { w + r.length() } else { w }), at(&s, w), 1e-12, "seam");
            }
        }
    }
}

#[test]
fn ruled_and_pointed() {
    let arc = katydid_geometry::Circle::new(Plane::XY, 2.0).unwrap().to_nurbs().unwrap();
    let cone = Surface::from(NurbsSurface::to_apex(&arc, Point3::new(0.0, 0.0, 3.0)).unwrap());
    assert!(cone.is_singular(Side::North) && cone.is_closed(Direction::U));
    let told = cone.as_cone(1e-9).unwrap();
    close(told.half_angle(), (2.0_f64 / 3.0).atan(), 1e-10, "cone");
    let lifted = arc.transformed(&Xform::translation(Vector3::new(0.0, 0.0, 1.0))).unwrap();
    let tube = Surface::from(NurbsSurface::ruled(&arc, &lifted).unwrap());
    close(tube.as_cylinder(1e-9).unwrap().radius, 2.0, 1e-12, "tube");
}
