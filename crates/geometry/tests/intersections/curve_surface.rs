//! Curves that meet surfaces: oracle cases, closed forms, laws, degenerate input.

use crate::common;
use katydid_geometry::intersect::{
    ContactKind, SurfaceIntersections, curve_plane, curve_surface, curve_with_surface,
};
use katydid_geometry::{
    Circle, Curve, Cylinder, Interval, Line, NurbsCurve, NurbsSurface, Plane, Point3, Surface, Vector3,
    Xform, clamped_uniform_knots,
};
use proptest::prelude::*;

fn sheet(degree: usize, n: usize, height: impl Fn(f64, f64) -> f64) -> NurbsSurface {
    let knots = clamped_uniform_knots(degree, n).unwrap();
    let mut points = Vec::new();
    for i in 0..n {
        for j in 0..n {
            let (x, y) = (i as f64, j as f64);
            points.push(Point3::new(x, y, height(x, y)));
        }
    }
    NurbsSurface::new([degree; 2], [n; 2], points, [knots.clone(), knots]).unwrap()
}

fn sound(curve: &Curve, surface: &NurbsSurface, tolerance: f64) -> SurfaceIntersections {
    let found = curve_surface(curve, surface, tolerance).unwrap();
    assert!(found.complete, "{} visits", found.visits);
    for c in &found.crossings {
        let gap = curve.point_at(c.t).distance_to(surface.point_at(c.u, c.v));
        assert!(gap <= tolerance.max(1e-12), "{c:?}: {gap}");
    }
    for o in &found.overlaps {
        for (t, [u, v]) in [(o.t.start, o.from), (o.t.end, o.to)] {
            assert!(
                curve.point_at(t).distance_to(surface.point_at(u, v)) <= 2.0 * tolerance.max(1e-12),
                "{o:?}"
            );
        }
    }
    found
}

#[test]
fn cases_of_the_other_kernel() {
    let Some(data) = common::oracle("occ_dev.json") else { return };
    let mut visits = 0;
    for (i, case) in data["curve_surface"].as_array().unwrap().iter().enumerate() {
        let curve: Curve = common::curve(&case["curve"]).into();
        let surface = common::surface(&case["srf"]);
        for tolerance in [1e-9, 1e-6] {
            let found = sound(&curve, &surface, tolerance);
            let want: Vec<Vec<f64>> = case["tuv"].as_array().unwrap().iter().map(common::numbers).collect();
            assert_eq!(found.crossings.len(), want.len(), "case {i}: {found:?}");
            for (c, w) in found.crossings.iter().zip(&want) {
                common::close(c.t, w[0], 1e-9, "t");
                common::close(c.u, w[1], 1e-9, "u");
                common::close(c.v, w[2], 1e-9, "v");
                assert_eq!(c.kind, ContactKind::Transversal);
            }
            visits = visits.max(found.visits);
        }
    }
    println!("at most {visits} visits");
}

#[test]
fn a_line_through_touching_and_past_a_cylinder() {
    let circle: Curve = Circle::new(Plane::XY, 1.0).unwrap().into();
    let ring = circle.to_nurbs().unwrap();
    let mut points = Vec::new();
    for p in ring.homogeneous_points() {
        for z in [-1.0, 1.0] {
            points.push([p[0], p[1], z * p[3], p[3]]);
        }
    }
    let knots = [ring.knots().to_vec(), clamped_uniform_knots(1, 2).unwrap()];
    let cylinder =
        NurbsSurface::rational([ring.degree(), 1], [ring.point_count(), 2], points, knots).unwrap();
    let line = |y: f64| -> Curve { Line::new(Point3::new(-3.0, y, 0.1), Point3::new(3.0, y, 0.2)).into() };
    let found = sound(&line(0.3), &cylinder, 1e-9);
    assert_eq!(found.crossings.len(), 2, "{found:?}");
    // Through the seam: once.
    assert_eq!(sound(&line(0.0), &cylinder, 1e-9).crossings.len(), 2);
    let found = sound(&line(1.0), &cylinder, 1e-9);
    assert_eq!(found.crossings.len(), 1, "{found:?}");
    assert_eq!(found.crossings[0].kind, ContactKind::Tangent);
    assert!(found.crossings[0].point.x.abs() < 1e-4);
    assert!(sound(&line(1.000001), &cylinder, 1e-9).crossings.is_empty());
    assert_eq!(sound(&line(1.000001), &cylinder, 1e-4).crossings.len(), 1);
    assert_eq!(sound(&line(0.999999), &cylinder, 1e-9).crossings.len(), 2);
    // A generator lies in it, and sticks out at both ends.
    let tall: Curve = Line::new(Point3::new(0.6, 0.8, -2.0), Point3::new(0.6, 0.8, 2.0)).into();
    let found = sound(&tall, &cylinder, 1e-9);
    assert_eq!((found.crossings.len(), found.overlaps.len()), (0, 1), "{found:?}");
    let o = found.overlaps[0];
    let z = |t: f64| tall.point_at(t).z;
    assert!((z(o.t.start) + 1.0).abs() < 1e-8 && (z(o.t.end) - 1.0).abs() < 1e-8, "{o:?}");
    // So does the circle itself.
    let found = sound(&circle, &cylinder, 1e-9);
    assert_eq!((found.crossings.len(), found.overlaps.len()), (0, 1), "{found:?}");
    assert_eq!(found.overlaps[0].t, circle.domain());
}

#[test]
fn an_isocurve_lies_in_its_surface() {
    let surface = sheet(3, 7, |x, y| (0.9 * x).sin() * (0.7 * y).cos());
    // Exact: the curve of a row of control points blended by hand at v of a knot is not needed; the border is one.
    let border: Vec<Point3> = (0..7).filter_map(|i| surface.control_point(i, 0)).collect();
    let border: Curve = NurbsCurve::new(3, border, clamped_uniform_knots(3, 7).unwrap()).unwrap().into();
    let found = sound(&border, &surface, 1e-9);
    assert_eq!((found.crossings.len(), found.overlaps.len()), (0, 1), "{found:?}");
    assert_eq!(found.overlaps[0].t, border.domain());
    assert!(found.visits < 100_000, "{}", found.visits);
}

#[test]
fn degenerate_input_stays_bounded() {
    let flat = sheet(1, 4, |_, _| 0.0);
    let in_plane: Curve = Line::new(Point3::new(-1.0, 1.3, 0.0), Point3::new(5.0, 1.7, 0.0)).into();
    let found = sound(&in_plane, &flat, 1e-9);
    assert_eq!((found.crossings.len(), found.overlaps.len()), (0, 1), "{found:?}");
    assert!((in_plane.point_at(found.overlaps[0].t.start).x).abs() < 1e-8);
    assert!(found.visits < 200_000, "{}", found.visits);
    let above: Curve = Line::new(Point3::new(-1.0, 1.3, 2e-9), Point3::new(5.0, 1.7, 2e-9)).into();
    assert!(sound(&above, &flat, 1e-9).crossings.is_empty());
    // A point as a surface, a point as a curve.
    let point = sheet(2, 3, |_, _| 0.0);
    let knots = clamped_uniform_knots(2, 3).unwrap();
    let dot = NurbsSurface::new([2; 2], [3; 2], vec![Point3::new(1.0, 1.0, 0.0); 9], [knots.clone(), knots])
        .unwrap();
    let through: Curve = Line::new(Point3::new(0.0, 0.0, 0.0), Point3::new(2.0, 2.0, 0.0)).into();
    assert_eq!(sound(&through, &dot, 1e-9).crossings.len(), 1);
    let still: Curve =
        NurbsCurve::new(3, vec![Point3::new(1.0, 1.0, 0.0); 4], clamped_uniform_knots(3, 4).unwrap())
            .unwrap()
            .into();
    assert_eq!(sound(&still, &point, 1e-9).crossings.len(), 1);
    assert!(curve_surface(&still, &point, f64::NAN).is_err());
    assert!(curve_surface(&still, &point, -1.0).is_err());
    // A line that ends in the surface.
    let ends: Curve = Line::new(Point3::new(1.2, 1.1, 3.0), Point3::new(1.2, 1.1, 0.0)).into();
    assert_eq!(sound(&ends, &flat, 1e-9).crossings.len(), 1);
    let short: Curve = Line::new(Point3::new(1.2, 1.1, 3.0), Point3::new(1.2, 1.1, 5e-10)).into();
    assert_eq!(sound(&short, &flat, 1e-9).crossings.len(), 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Over a graph z = h(x, y) the sign of z − h tells where a curve crosses: that needs no other solver.
    #[test]
    fn a_graph_is_crossed_where_the_sign_changes(
        heights in prop::collection::vec(-1.5..1.5_f64, 36),
        points in prop::collection::vec((0.2..4.8_f64, 0.2..4.8_f64, -1.5..1.5_f64), 4..8),
    ) {
        // Degree 1 in both: the graph can be evaluated at x, y directly.
        let surface = sheet(1, 6, |x, y| heights[(x * 6.0 + y) as usize]);
        let points: Vec<Point3> = points.into_iter().map(|(x, y, z)| Point3::new(x, y, z)).collect();
        let knots = clamped_uniform_knots(3, points.len()).unwrap();
        let curve: Curve = NurbsCurve::new(3, points, knots).unwrap().with_domain(Interval::UNIT).unwrap().into();
        let found = sound(&curve, &surface, 1e-9);
        let over = |t: f64| {
            let p = curve.point_at(t);
            p.z - surface.point_at(p.x, p.y).z
        };
        let n = 4000;
        for k in 0..n {
            let (s, t) = (f64::from(k) / f64::from(n), f64::from(k + 1) / f64::from(n));
            if over(s) * over(t) < 0.0 {
                let hit = found.crossings.iter().any(|c| s - 1e-9 <= c.t && c.t <= t + 1e-9);
                prop_assert!(hit, "missed between {s} and {t}: {found:?}");
            }
        }
        let up: Curve = Line::new(Point3::new(2.5, 2.4, -5.0), Point3::new(2.5, 2.4, 5.0)).into();
        prop_assert_eq!(sound(&up, &surface, 1e-9).crossings.len(), 1);
        let away = Vector3::new(0.0, 0.0, 9.0);
        let far: Curve = Line::new(Point3::new(0.0, 0.0, 0.0) + away, Point3::new(5.0, 5.0, 0.0) + away).into();
        prop_assert!(sound(&far, &surface, 1e-9).crossings.is_empty());
    }
}

#[test]
fn a_line_through_a_sphere_has_the_sphere_s_own_parameters() {
    use katydid_geometry::{Sphere, Surface};
    let sphere = Sphere::new(Plane::XY, 2.0).unwrap();
    let line: Curve = Line::new(Point3::new(-3.0, -3.0, 0.7), Point3::new(3.0, 3.0, 0.7)).into();
    let surface = Surface::from(sphere);
    let found = curve_with_surface(&line, &surface, 1e-9).unwrap();
    assert_eq!((found.crossings.len(), found.overlaps.len()), (2, 0));
    for c in &found.crossings {
        assert!(surface.point_at(c.u, c.v).distance_to(c.point) < 1e-12);
        assert!((c.v - (0.35_f64).asin()).abs() < 1e-12, "latitude {}", c.v);
    }
    let past: Curve = Line::new(Point3::new(-3.0, 0.0, 2.1), Point3::new(3.0, 0.0, 2.1)).into();
    assert!(curve_with_surface(&past, &surface, 1e-9).unwrap().crossings.is_empty());
}

#[test]
fn stretches_in_a_plane_are_told_from_crossings() {
    use katydid_geometry::PolylineCurve;
    let corners = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [4.0, 0.0, 2.0], [6.0, 0.0, -2.0]];
    let points = corners.map(Point3::from).to_vec();
    let curve: Curve = PolylineCurve::with_parameters(points, vec![0.0, 1.0, 2.0, 3.0, 4.0]).unwrap().into();
    let found = curve_plane(&curve, &Plane::XY, 1e-9).unwrap();
    assert_eq!(found.overlaps.len(), 1);
    let Interval { start, end } = found.overlaps[0];
    assert!((start - 1.0).abs() < 1e-8 && (end - 2.0).abs() < 1e-8, "{start} to {end}");
    assert_eq!(found.crossings.len(), 1);
    assert!((found.crossings[0] - 3.5).abs() < 1e-12);
}

/// A straight line of a cylinder lies in it however both are turned: parts of one size, of which none ever lies within
/// the other, once were halved down to the tolerance.
#[test]
fn rulings_of_cylinders_in_any_place() {
    for scale in [1.0, 1e3] {
        for turn in [0.0, 0.1, 0.3, 0.7, 1.1] {
            let turned = Xform::rotation(turn, Vector3::new(1.0, 2.0, 3.0), Point3::ORIGIN).unwrap();
            let height = Interval::new(0.0, 4.0 * scale);
            let tube = Surface::from(Cylinder { plane: Plane::XY, radius: 3.0 * scale, height });
            let tube = tube.to_nurbs().unwrap().transformed(&turned).unwrap();
            let at = |z: f64| Point3::new(3.0 * 1f64.cos(), 3.0 * 1f64.sin(), z);
            let line = |from: f64, to: f64| {
                let ends = [from, to].map(|z| Point3::ORIGIN + at(z).to_vector() * scale);
                Curve::from(Line::new(ends[0], ends[1])).transformed(&turned).unwrap()
            };
            for line in [line(-1.0, 9.0), line(0.0, 4.0), line(0.5, 3.2), line(0.5, 7.0)] {
                let found = sound(&line, &tube, 1e-3);
                assert!(found.visits < 20_000, "{scale} {turn}: {} visits", found.visits);
                assert_eq!((found.crossings.len(), found.overlaps.len()), (0, 1), "{scale} {turn}");
            }
        }
    }
}
