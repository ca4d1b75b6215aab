//! Curves that meet: oracle cases, laws, degenerate and hostile input.

use crate::common;
use katydid_geometry::intersect::{ContactKind, CurveIntersections, curve_curve, curve_self};
use katydid_geometry::{
    Arc, Circle, Curve, Interval, Line, NurbsCurve, Plane, Point3, PolyCurve, PolylineCurve, Vector3,
    clamped_uniform_knots,
};
use proptest::prelude::*;

fn p(x: f64, y: f64) -> Point3 {
    Point3::new(x, y, 0.0)
}

fn nurbs(degree: usize, points: &[Point3]) -> Curve {
    let knots = clamped_uniform_knots(degree, points.len()).unwrap();
    NurbsCurve::new(degree, points.to_vec(), knots).unwrap().into()
}

fn polyline(points: &[Point3]) -> Curve {
    PolylineCurve::new(points.to_vec()).unwrap().into()
}

/// Every crossing lies on both curves, and swapping the curves swaps the answer.
fn sound(a: &Curve, b: &Curve, tolerance: f64) -> CurveIntersections {
    let found = curve_curve(a, b, tolerance).unwrap();
    for c in &found.crossings {
        let (x, y) = (a.point_at(c.a), b.point_at(c.b));
        let limit = tolerance.max(1e-13 * (1.0 + x.to_vector().length()));
        assert!(x.distance_to(y) <= limit, "{c:?} is {} apart", x.distance_to(y));
        assert!(a.domain().contains(c.a) && b.domain().contains(c.b), "{c:?} outside");
    }
    for o in &found.overlaps {
        assert!(o.a.is_increasing());
        for k in 0..=20 {
            let q = a.point_at(o.a.at(f64::from(k) / 20.0));
            assert!(b.closest_point(q).unwrap().distance <= tolerance.max(1e-12), "{o:?}");
        }
        for (s, t) in [(o.a.start, o.b.start), (o.a.end, o.b.end)] {
            assert!(a.point_at(s).distance_to(b.point_at(t)) <= 2.0 * tolerance.max(1e-12), "{o:?}");
        }
    }
    let turned = curve_curve(b, a, tolerance).unwrap();
    assert_eq!(found.crossings.len(), turned.crossings.len());
    for c in &turned.crossings {
        assert!(found.crossings.iter().any(|d| d.a == c.b && d.b == c.a), "{c:?} not in the other order");
    }
    assert_eq!(found.overlaps.len(), turned.overlaps.len());
    found
}

fn kinds(found: &CurveIntersections) -> (usize, usize, usize) {
    let count = |k: ContactKind| found.crossings.iter().filter(|c| c.kind == k).count();
    (count(ContactKind::Transversal), count(ContactKind::Tangent), found.overlaps.len())
}

#[test]
fn plane_curves_of_the_other_kernel() {
    let Some(data) = common::oracle("occ_dev.json") else { return };
    for (i, case) in data["curve_curve_2d"].as_array().unwrap().iter().enumerate() {
        let (a, b): (Curve, Curve) = (common::curve(&case["a"]).into(), common::curve(&case["b"]).into());
        for tolerance in [1e-9, 1e-6, 0.0] {
            let found = sound(&a, &b, tolerance);
            assert!(found.complete && found.overlaps.is_empty());
            let want: Vec<Vec<f64>> = case["t"].as_array().unwrap().iter().map(common::numbers).collect();
            assert_eq!(found.crossings.len(), want.len(), "case {i}");
            for (c, w) in found.crossings.iter().zip(&want) {
                common::close(c.a, w[0], 1e-9, &format!("case {i}"));
                common::close(c.b, w[1], 1e-9, &format!("case {i}"));
            }
        }
    }
}

#[test]
fn plane_curves_of_the_bench() {
    let Some(bench) = common::bench() else { return };
    let meet = |a: &str, b: &str| {
        let found = sound(&bench.curve(a), &bench.curve(b), 1e-9);
        assert!(found.complete);
        found
    };
    for (name, a, b) in [("cc", "cc_a", "cc_b"), ("weave", "wv_a", "wv_b")] {
        let found = meet(a, b);
        let want = bench.reference[name].as_array().unwrap();
        assert_eq!(kinds(&found), (want.len(), 0, 0));
        for w in want {
            let w = common::numbers(w);
            let miss = |c: &katydid_geometry::intersect::Crossing| (c.a - w[0]).abs().max((c.b - w[1]).abs());
            assert!(found.crossings.iter().map(miss).fold(9.0, f64::min) < 1e-12);
        }
    }
    assert_eq!(kinds(&meet("tan_a", "tan_b")), (0, 1, 0));
    assert_eq!(kinds(&meet("tan_a", "near_miss_b")), (0, 0, 0));
    assert_eq!(kinds(&meet("tan_a", "near_hit_b")), (2, 0, 0));
    let found = meet("ov_a", "ov_b");
    assert_eq!(kinds(&found), (0, 0, 1));
    let o = found.overlaps[0];
    for (x, y) in [(o.a.start, 0.3), (o.a.end, 0.7), (o.b.start, 0.0), (o.b.end, 1.0)] {
        assert!((x - y).abs() < 1e-9, "{o:?}");
    }
    assert!(o.same_direction);
    // With a tolerance the shallow lens and the small gap are a touch.
    for name in ["near_miss_b", "near_hit_b"] {
        let found = sound(&bench.curve("tan_a"), &bench.curve(name), 1e-4);
        assert_eq!(kinds(&found), (0, 1, 0), "{name}");
    }
}

#[test]
fn segments_and_arcs() {
    let line: Curve = Line::new(p(-3.0, 0.0), p(3.0, 0.0)).into();
    let circle: Curve = Circle::new(Plane::XY, 1.0).unwrap().into();
    let found = sound(&line, &circle, 1e-9);
    assert_eq!(kinds(&found), (2, 0, 0));
    assert!((found.crossings[0].point.x + 1.0).abs() < 1e-14);
    // The seam of the circle counts once, at its start.
    assert_eq!(found.crossings[1].b, 0.0);
    let touching: Curve = Line::new(p(-3.0, 1.0), p(3.0, 1.0)).into();
    let found = sound(&touching, &circle, 1e-9);
    assert_eq!(kinds(&found), (0, 1, 0));
    assert!((found.crossings[0].a - 0.5 * touching.domain().end).abs() < 1e-12);
    let outside: Curve = Circle::new(Plane::XY.with_origin(p(2.0, 0.0)), 1.0).unwrap().into();
    assert_eq!(kinds(&sound(&circle, &outside, 1e-9)), (0, 1, 0));
    let inside: Curve = Circle::new(Plane::XY.with_origin(p(0.5, 0.0)), 0.5).unwrap().into();
    assert_eq!(kinds(&sound(&circle, &inside, 1e-9)), (0, 1, 0));
    let across: Curve = Circle::new(Plane::YZ.with_origin(p(0.0, 1.0)), 0.25).unwrap().into();
    assert_eq!(kinds(&sound(&circle, &across, 1e-9)), (0, 0, 0));
    let linked: Curve = Circle::new(Plane::YZ, 1.0).unwrap().into();
    assert_eq!(kinds(&sound(&circle, &linked, 1e-9)), (2, 0, 0));
}

#[test]
fn overlaps_of_segments_and_arcs() {
    let a: Curve = Line::new(p(0.0, 0.0), p(4.0, 0.0)).into();
    let b: Curve = Line::new(p(6.0, 0.0), p(1.0, 0.0)).into();
    let found = sound(&a, &b, 1e-9);
    assert_eq!(kinds(&found), (0, 0, 1));
    let o = found.overlaps[0];
    assert!(!o.same_direction && (o.a.start - 1.0).abs() < 1e-12 && (o.a.end - 4.0).abs() < 1e-12);
    assert!((o.b.start - 5.0).abs() < 1e-12 && (o.b.end - 2.0).abs() < 1e-12);
    // Ends that only meet are a point.
    let c: Curve = Line::new(p(4.0, 0.0), p(9.0, 0.0)).into();
    let found = sound(&a, &c, 1e-9);
    assert_eq!((found.crossings.len(), found.overlaps.len()), (1, 0));
    assert_eq!((found.crossings[0].a, found.crossings[0].b), (4.0, 0.0));
    // Arcs of one circle.
    let circle = Circle::new(Plane::XY, 2.0).unwrap();
    let x: Curve = Arc::new(circle, Interval::new(0.0, 2.0)).unwrap().into();
    let y: Curve = Arc::new(circle, Interval::new(1.0, 3.0)).unwrap().into();
    let found = sound(&x, &y, 1e-9);
    assert_eq!(kinds(&found), (0, 0, 1));
    assert!((found.overlaps[0].a.start - 2.0).abs() < 1e-9 && (found.overlaps[0].a.end - 4.0).abs() < 1e-9);
    // A circle with itself, also from another seam: nothing but overlaps.
    let whole: Curve = circle.into();
    assert_eq!(kinds(&sound(&whole, &whole, 1e-9)), (0, 0, 1));
    let turned: Curve = Circle::new(Plane::XY.rotated(1.0), 2.0).unwrap().into();
    let found = sound(&whole, &turned, 1e-9);
    assert_eq!((found.crossings.len(), found.overlaps.len()), (0, 2));
    let nurbs: Curve = whole.to_nurbs().unwrap().into();
    assert_eq!(kinds(&sound(&whole, &nurbs, 1e-9)), (0, 0, 1));
}

#[test]
fn a_polyline_along_a_line() {
    let line: Curve = Line::new(p(0.0, 0.0), p(10.0, 0.0)).into();
    let path = polyline(&[
        p(1.0, 2.0),
        p(2.0, 0.0),
        p(4.0, 0.0),
        p(5.0, -1.0),
        p(6.0, 1.0),
        p(7.0, 0.0),
        p(8.0, 3.0),
    ]);
    for tolerance in [1e-9, 1e-3] {
        let found = sound(&line, &path, tolerance);
        assert_eq!(found.overlaps.len(), 1, "{found:?}");
        let o = found.overlaps[0];
        assert!((o.a.start - 2.0).abs() < 1e-9 && (o.a.end - 4.0).abs() < 1e-9, "{o:?}");
        assert_eq!(found.crossings.len(), 2, "{found:?}");
        assert!((found.crossings[0].a - 5.5).abs() < 1e-12 && (found.crossings[1].a - 7.0).abs() < 1e-12);
    }
}

#[test]
fn a_fillet_touches_its_lines_at_its_ends() {
    let line: Curve = Line::new(p(-5.0, 0.0), p(5.0, 0.0)).into();
    let circle = Circle::new(Plane::XY.with_origin(p(0.0, 1.0)), 1.0).unwrap();
    let half = std::f64::consts::FRAC_PI_2;
    let arc: Curve = Arc::new(circle, Interval::new(-half, half)).unwrap().into();
    for tolerance in [1e-9, 1e-3] {
        let found = sound(&line, &arc, tolerance);
        assert_eq!(kinds(&found), (0, 1, 0), "{found:?}");
        assert!(found.crossings[0].point.distance_to(p(0.0, 0.0)) < 1e-9);
    }
}

#[test]
fn an_inflection_crosses_once() {
    // y = x³ against y = 0: the curves osculate and cross.
    let cubic = nurbs(3, &[p(-1.0, -1.0), p(-1.0 / 3.0, 1.0), p(1.0 / 3.0, -1.0), p(1.0, 1.0)]);
    let line: Curve = Line::new(p(-2.0, 0.0), p(2.0, 0.0)).into();
    for tolerance in [1e-9, 1e-6, 1e-3] {
        let found = sound(&cubic, &line, tolerance);
        assert_eq!(found.crossings.len(), 1, "{found:?}");
        assert!(found.crossings[0].point.x.abs() < 1e-3, "{found:?}");
    }
}

#[test]
fn a_curve_with_itself() {
    let loops = nurbs(3, &[p(0.0, 0.0), p(4.0, 3.0), p(-1.0, 3.0), p(3.0, 0.0)]);
    let found = curve_self(&loops, 1e-9).unwrap();
    assert_eq!(kinds(&found), (1, 0, 0));
    let c = found.crossings[0];
    assert!(c.a < c.b && loops.point_at(c.a).distance_to(loops.point_at(c.b)) < 1e-12);
    // No joints, no seam, no corners.
    let circle: Curve = Circle::new(Plane::XY, 1.0).unwrap().into();
    for simple in [
        circle.clone(),
        circle.to_nurbs().unwrap().into(),
        polyline(&[p(0.0, 0.0), p(2.0, 0.0), p(0.1, 0.1), p(0.0, 2.0), p(0.0, 0.0)]),
        nurbs(3, &[p(0.0, 0.0), p(1.0, 2.0), p(3.0, 2.0), p(4.0, 0.0), p(6.0, 1.0)]),
    ] {
        let found = curve_self(&simple, 1e-9).unwrap();
        assert!(found.is_empty() && found.complete, "{found:?}");
        assert!(curve_self(&simple, 1e-3).unwrap().is_empty());
    }
    // A figure of eight through its own seam, and a path that goes back on itself.
    let eight = polyline(&[p(0.0, 0.0), p(2.0, 2.0), p(2.0, 0.0), p(0.0, 2.0), p(0.0, 0.0)]);
    assert_eq!(kinds(&curve_self(&eight, 1e-9).unwrap()), (1, 0, 0));
    let back = polyline(&[p(0.0, 0.0), p(3.0, 0.0), p(1.0, 0.0), p(1.0, 5.0)]);
    let found = curve_self(&back, 1e-9).unwrap();
    assert_eq!(found.overlaps.len(), 1, "{found:?}");
    // A cusp is no crossing.
    let cusp = nurbs(3, &[p(0.0, 0.0), p(1.0, 1.0), p(0.0, 1.0), p(1.0, 0.0)]);
    let found = curve_self(&cusp, 1e-9).unwrap();
    assert!(found.crossings.len() <= 1 && found.complete, "{found:?}");
}

/// Control points on a line in space.
fn on_line(xs: &[f64]) -> Vec<Point3> {
    xs.iter().map(|&x| Point3::new(x, 0.37 * x, -0.11 * x)).collect()
}

/// Overlaps of a curve with itself: the ranges meet in space all along.
fn own_overlaps(c: &Curve, tolerance: f64) -> Vec<katydid_geometry::intersect::Overlap> {
    let found = curve_self(c, tolerance).unwrap();
    assert!(found.complete && found.crossings.is_empty(), "{found:?}");
    for o in &found.overlaps {
        assert_eq!(o.same_direction, o.b.start < o.b.end);
        for (s, t) in [(o.a.start, o.b.start), (o.a.end, o.b.end)] {
            assert!(c.point_at(s).distance_to(c.point_at(t)) <= 2.0 * tolerance, "{o:?}");
        }
    }
    found.overlaps
}

#[test]
fn spans_that_turn_back_overlap_themselves() {
    // x = 4t − at², which turns at 2/a.
    for (end, a) in [(0.0, 4.0), (0.7, 3.3), (-1.0, 5.0)] {
        let c = nurbs(2, &on_line(&[0.0, 2.0, end]));
        for tolerance in [1e-9, 1e-6, 1e-3] {
            let found = own_overlaps(&c, tolerance);
            assert_eq!(found.len(), 1, "{end} {tolerance}: {found:?}");
            let o = found[0];
            assert!(!o.same_direction, "{o:?}");
            assert!((o.a.end - 2.0 / a).abs() < 1e-9 && (o.b.end - 2.0 / a).abs() < 1e-9, "{o:?}");
            let start = if end >= 0.0 { 4.0 / a - 1.0 } else { 0.0 };
            assert!((o.a.start - start).abs() < 2.0 * tolerance.max(1e-9), "{end} {tolerance}: {o:?}");
        }
    }
    // Twice: three stretches, each pair of which overlaps. Joined where they go on in each other.
    let c = nurbs(3, &on_line(&[0.0, 5.0, -2.0, 3.0]));
    let found = own_overlaps(&c, 1e-9);
    assert!(found.len() >= 3, "{found:?}");
    assert!(found.iter().any(|o| o.same_direction));
    let path = polyline(&on_line(&[0.0, 3.0, 1.0, 4.0]));
    let found = own_overlaps(&path, 1e-9);
    let mut covered: Vec<(f64, f64, f64, f64)> =
        found.iter().map(|o| (o.a.start, o.a.end, o.b.start, o.b.end)).collect();
    covered.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.2.total_cmp(&y.2)));
    let want = [(1.0 / 3.0, 1.0, 2.0, 1.0), (1.0 / 3.0, 1.0, 2.0, 8.0 / 3.0), (1.0, 2.0, 8.0 / 3.0, 2.0)];
    for w in want {
        let near = |x: &(f64, f64, f64, f64)| {
            [(x.0, w.0), (x.1, w.1), (x.2, w.2), (x.3, w.3)].iter().all(|(a, b)| (a - b).abs() < 1e-9)
        };
        assert!(covered.iter().any(near), "{w:?} is not in {covered:?}");
    }
    assert_eq!(covered.len(), 3, "{covered:?}");
}

#[test]
fn arcs_run_there_and_back_overlap_themselves() {
    // A cubic g(x) run through with x = 1 − (1 − at)²: of degree 6, and it turns at 1/a. Bernstein coefficients of
    // the composition by the blossom: the mean of g's over all ways to take three pairs of the six arguments.
    let g = [p(0.0, 0.0), p(1.0, 2.0), Point3::new(3.0, 2.0, 1.0), p(4.0, 0.0)];
    let blossom = |x: [f64; 3]| {
        let mut row = g.map(|q| q.to_vector());
        for (level, x) in x.into_iter().enumerate() {
            for i in 0..3 - level {
                row[i] = row[i] * (1.0 - x) + row[i + 1] * x;
            }
        }
        row[0]
    };
    for a in [1.25, 1.6, 2.0] {
        // 1 − (1 − at)² has the blossom 2a·mean − a²·product.
        let x = |s: f64, t: f64| a * (s + t) - a * a * s * t;
        let pairings: Vec<[[usize; 2]; 3]> = {
            let mut out = Vec::new();
            for i in 1..6 {
                let rest: Vec<usize> = (1..6).filter(|&k| k != i).collect();
                for j in 1..4 {
                    let last: Vec<usize> = (1..4).filter(|&k| k != j).map(|k| rest[k]).collect();
                    out.push([[0, i], [rest[0], rest[j]], [last[0], last[1]]]);
                }
            }
            out
        };
        let points: Vec<Point3> = (0..=6)
            .map(|k| {
                let t: Vec<f64> = (0..6).map(|i| if i < k { 1.0 } else { 0.0 }).collect();
                let sum =
                    pairings.iter().fold(Vector3::ZERO, |s, w| s + blossom(w.map(|[i, j]| x(t[i], t[j]))));
                (sum / pairings.len() as f64).to_point()
            })
            .collect();
        let c = nurbs(6, &points);
        for tolerance in [1e-9, 1e-6] {
            let found = own_overlaps(&c, tolerance);
            assert_eq!(found.len(), 1, "{a} {tolerance}: {found:?}");
            let o = found[0];
            assert!(
                !o.same_direction && (o.a.end - 1.0 / a).abs() < 1e-7 && (o.b.end - 1.0 / a).abs() < 1e-7
            );
            assert!((o.a.start - (2.0 / a - 1.0)).abs() < 1e-5, "{a}: {o:?}");
        }
        // Its copy: all of it, and there against back.
        let found = curve_curve(&c, &c.clone(), 1e-9).unwrap();
        assert!(found.overlaps.iter().any(|o| o.same_direction && o.a.length() > 0.999), "{found:?}");
        assert!(found.overlaps.iter().any(|o| !o.same_direction), "{found:?}");
    }
}

#[test]
fn cusps_are_no_crossings() {
    let cusp = nurbs(3, &[p(0.0, 0.0), p(1.0, 1.0), p(0.0, 1.0), p(1.0, 0.0)]);
    for tolerance in [1e-9, 1e-6, 1e-3] {
        let found = curve_self(&cusp, tolerance).unwrap();
        assert!(found.is_empty() && found.complete, "{tolerance}: {found:?}");
    }
    // What crosses at the tip crosses once.
    let line: Curve = Line::new(p(0.5, 0.0), p(0.5, 2.0)).into();
    assert_eq!(sound(&cusp, &line, 1e-9).crossings.len(), 1);
}

/// Hundreds of thousands of honest crossings are not too many: chords of a circle, which cross where their ends
/// alternate.
#[test]
fn a_star_is_not_hostile() {
    let n = 1_200;
    let angles: Vec<f64> = (0..n).map(|i| (2.5 * f64::from(i)).rem_euclid(std::f64::consts::TAU)).collect();
    let star: Vec<Point3> = angles.iter().map(|a| p(a.cos(), a.sin())).collect();
    let chords: Vec<[f64; 2]> = angles.windows(2).map(|w| [w[0].min(w[1]), w[0].max(w[1])]).collect();
    let mut want = 0;
    for (i, [a, b]) in chords.iter().enumerate() {
        for [c, d] in chords.iter().skip(i + 2) {
            want += usize::from((a < c && c < b) != (a < d && d < b));
        }
    }
    let found = curve_self(&polyline(&star), 1e-12).unwrap();
    assert!(found.complete && found.overlaps.is_empty());
    assert!(want > 100_000);
    assert_eq!(found.crossings.len(), want);
}

#[test]
fn hostile_input_ends_and_says_so() {
    let fold: Vec<Point3> = (0..4_000).map(|i| p(f64::from(i % 2), 0.0)).collect();
    let found = curve_self(&polyline(&fold), 1e-9).unwrap();
    assert!(!found.complete && !found.overlaps.is_empty());
    for o in found.overlaps.iter().take(100) {
        assert!(o.a.length() <= 1.0 + 1e-9, "{o:?}");
    }
    let round: Vec<Point3> =
        (0..4_000).map(|i| f64::from(i % 7)).map(|a| p((0.9 * a).cos(), (0.9 * a).sin())).collect();
    let path = nurbs(3, &round);
    let found = curve_self(&path, 1e-9).unwrap();
    assert!(!found.complete);
    for c in &found.crossings {
        assert!(path.point_at(c.a).distance_to(path.point_at(c.b)) <= 2e-9);
    }
    let heap = |f: f64| -> Vec<Point3> {
        (0..3_000).map(|i| p((f64::from(i) * f).sin() * 3e-3, (f64::from(i) * 2.3).cos() * 3e-3)).collect()
    };
    let found = curve_curve(&nurbs(3, &heap(1.7)), &nurbs(3, &heap(1.9)), 1e-3).unwrap();
    assert!(!found.complete && !found.is_empty());
}

#[test]
fn degenerate_input_stays_bounded() {
    let point = nurbs(3, &[p(1.0, 0.0); 4]);
    let line: Curve = Line::new(p(0.0, 0.0), p(2.0, 0.0)).into();
    let found = curve_curve(&point, &line, 1e-9).unwrap();
    assert_eq!((found.crossings.len(), found.overlaps.len()), (1, 0), "{found:?}");
    assert!(found.visits < 1_000);
    assert!(curve_curve(&point, &point, 1e-9).unwrap().visits < 1_000);
    assert!(curve_curve(&nurbs(3, &[p(1.0, 1.0); 4]), &line, 1e-9).unwrap().is_empty());
    // A thousand spans, coincident, and the same reversed and with another parametrisation.
    let wave: Vec<Point3> = (0..1003).map(|i| p(0.1 * f64::from(i), (0.7 * f64::from(i)).sin())).collect();
    let long = nurbs(3, &wave);
    for other in [long.clone(), long.reversed()] {
        let found = curve_curve(&long, &other, 1e-9).unwrap();
        assert_eq!(kinds(&found), (0, 0, 1), "{:?}", found.overlaps);
        assert!(found.complete && found.visits < 200_000, "{}", found.visits);
    }
    // A little beside itself: nothing, without end is not allowed either.
    let beside =
        long.transformed(&katydid_geometry::Xform::translation(Vector3::new(0.0, 0.0, 2e-9))).unwrap();
    let found = curve_curve(&long, &beside, 1e-9).unwrap();
    assert!(found.crossings.is_empty() && found.overlaps.is_empty(), "{found:?}");
    // A heap of the tolerance's size.
    let heap: Vec<Point3> =
        (0..300).map(|i| p((f64::from(i) * 1.7).sin() * 3e-3, (f64::from(i) * 2.3).cos() * 3e-3)).collect();
    let found = curve_self(&polyline(&heap), 1e-3).unwrap();
    assert!(found.visits < 4_000_000);
}

#[test]
fn long_polylines_take_little() {
    let saw = |n: i32, phase: f64| -> Curve {
        let points: Vec<Point3> =
            (0..n).map(|i| p(f64::from(i), if i % 2 == 0 { phase } else { 1.0 + phase })).collect();
        polyline(&points)
    };
    let mut last = 0;
    for n in [1_000, 10_000] {
        let found = curve_curve(
            &saw(n, 0.0),
            &saw(n, 0.5)
                .reversed()
                .transformed(&katydid_geometry::Xform::translation(Vector3::new(0.3, 0.0, 0.0)))
                .unwrap(),
            1e-9,
        )
        .unwrap();
        assert!(found.complete);
        if last > 0 {
            assert!(found.visits < 16 * last, "{} after {last}", found.visits);
        }
        last = found.visits;
    }
}

#[test]
fn bad_tolerances_and_poly_curves() {
    let line: Curve = Line::new(p(0.0, 0.0), p(2.0, 0.0)).into();
    assert!(curve_curve(&line, &line, f64::NAN).is_err());
    assert!(curve_curve(&line, &line, -1.0).is_err());
    assert!(curve_self(&line, f64::INFINITY).is_err());
    let arc = Arc::through(p(2.0, 0.0), p(3.0, 1.0), p(4.0, 0.0)).unwrap();
    let poly: Curve = PolyCurve::new(vec![line.clone(), arc.into()]).unwrap().into();
    let cut: Curve = Line::new(p(3.0, -1.0), p(3.0, 5.0)).into();
    let found = sound(&poly, &cut, 1e-9);
    assert_eq!(kinds(&found), (1, 0, 0));
    assert!(found.crossings[0].point.distance_to(p(3.0, 1.0)) < 1e-12);
    // Through the joint: once.
    let joint: Curve = Line::new(p(2.0, -1.0), p(2.0, 5.0)).into();
    assert_eq!(sound(&poly, &joint, 1e-9).crossings.len(), 1);
}

/// All crossings of two plane curves by another way: dense polylines whose segments cross. With each the length of
/// its segments, which tells how far from the curves it may be.
fn sampled(a: &Curve, b: &Curve, n: usize) -> Vec<(f64, f64, f64)> {
    let points = |c: &Curve| -> Vec<(f64, Point3)> {
        (0..=n).map(|i| c.domain().at(i as f64 / n as f64)).map(|t| (t, c.point_at(t))).collect()
    };
    let (a, b) = (points(a), points(b));
    let mut out = Vec::new();
    for u in a.windows(2) {
        for v in b.windows(2) {
            let (d, e, w) = (u[1].1 - u[0].1, v[1].1 - v[0].1, v[0].1 - u[0].1);
            let n = d.x * e.y - d.y * e.x;
            if n.abs() <= 1e-9 * d.length() * e.length() {
                continue;
            }
            let (s, t) = ((w.x * e.y - w.y * e.x) / n, (w.x * d.y - w.y * d.x) / n);
            if (0.0..1.0).contains(&s) && (0.0..1.0).contains(&t) {
                let size = d.length() + e.length();
                out.push((u[0].0 + s * (u[1].0 - u[0].0), v[0].0 + t * (v[1].0 - v[0].0), size));
            }
        }
    }
    out
}

fn any_curve() -> impl Strategy<Value = Curve> {
    let coordinate = -4.0..4.0_f64;
    let points = prop::collection::vec((coordinate.clone(), coordinate).prop_map(|(x, y)| p(x, y)), 5..9);
    (points, 1..5_usize, prop::collection::vec(0.3..3.0_f64, 9), any::<bool>()).prop_map(
        |(points, degree, weights, rational)| {
            let knots = clamped_uniform_knots(degree, points.len()).unwrap();
            let weights = &weights[..points.len()];
            let curve = if rational {
                NurbsCurve::with_weights(degree, &points, weights, knots).unwrap()
            } else {
                NurbsCurve::new(degree, points, knots).unwrap()
            };
            curve.with_domain(Interval::UNIT).unwrap().into()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn nothing_that_sampling_sees_is_missed(a in any_curve(), b in any_curve()) {
        let found = sound(&a, &b, 1e-9);
        prop_assert!(found.complete);
        for (s, t, size) in sampled(&a, &b, 400) {
            let q = a.point_at(s).lerp(b.point_at(t), 0.5);
            let near = found.crossings.iter().any(|c| c.point.distance_to(q) < 2.0 * size);
            prop_assert!(near, "missed {s} {t}");
        }
    }

    #[test]
    fn a_part_overlaps_its_whole(a in any_curve(), x in 0.0..0.4_f64, y in 0.6..1.0_f64, turn in any::<bool>()) {
        let part = a.trimmed(Interval::new(x, y)).unwrap();
        let part = if turn { part.reversed() } else { part };
        let found = sound(&a, &part, 1e-7);
        prop_assert!(found.complete);
        let covered: f64 = found.overlaps.iter().map(|o| o.a.length()).sum();
        prop_assert!((covered - (y - x)).abs() < 1e-4, "{covered} of {} in {found:?}", y - x);
        prop_assert!(found.overlaps.iter().all(|o| o.same_direction != turn));
    }

    #[test]
    fn own_crossings_lie_on_the_curve(a in any_curve()) {
        let found = curve_self(&a, 1e-9).unwrap();
        prop_assert!(found.complete);
        for c in &found.crossings {
            prop_assert!(c.a < c.b);
            prop_assert!(a.point_at(c.a).distance_to(a.point_at(c.b)) < 2e-9);
        }
        let n = 400;
        for (s, t, size) in sampled(&a, &a, n) {
            if t > s + 2.5 / n as f64 {
                let q = a.point_at(s);
                prop_assert!(found.crossings.iter().any(|c| c.point.distance_to(q) < 2.0 * size), "missed {s} {t}");
            }
        }
    }
}
