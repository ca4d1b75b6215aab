//! Regions of known curves: what touches, coincides, contains, or is next to nothing.

use std::f64::consts::{PI, TAU};
use std::slice::from_ref;

use katydid_geometry::region::{CurveRelation, FillRule, Region, relation};
use katydid_geometry::{
    Arc, Circle, Containment, Curve, Interval, Line, NurbsCurve, Plane, Point3, PolyCurve, PolylineCurve,
    Vector3, Xform,
};

const TOLERANCE: f64 = 1e-3;

fn p(x: f64, y: f64) -> Point3 {
    Point3::new(x, y, 0.0)
}

fn circle(x: f64, y: f64, radius: f64) -> Curve {
    Circle::new(Plane::XY.with_origin(p(x, y)), radius).unwrap().into()
}

fn polyline(points: &[(f64, f64)]) -> Curve {
    let mut points: Vec<Point3> = points.iter().map(|&(x, y)| p(x, y)).collect();
    points.push(points[0]);
    PolylineCurve::new(points).unwrap().into()
}

fn square(x: f64, y: f64, side: f64) -> Curve {
    polyline(&[(x, y), (x + side, y), (x + side, y + side), (x, y + side)])
}

fn union(curves: &[Curve]) -> Region {
    Region::union_of(curves, &Plane::XY, TOLERANCE).unwrap()
}

fn common(a: &Curve, b: &Curve) -> Region {
    Region::intersection_of(from_ref(a), from_ref(b), &Plane::XY, TOLERANCE).unwrap()
}

fn less(a: &Curve, b: &Curve) -> Region {
    Region::difference_of(from_ref(a), from_ref(b), &Plane::XY, TOLERANCE).unwrap()
}

/// Outlines, holes and area.
fn facts(r: &Region) -> (usize, usize, f64) {
    (r.faces().len(), r.faces().iter().map(|f| f.holes().len()).sum(), r.area())
}

fn check(r: &Region, outlines: usize, holes: usize, area: f64) {
    let (o, h, a) = facts(r);
    assert!(
        (o, h) == (outlines, holes) && (a - area).abs() <= 1e-9 * area.abs().max(1.0),
        "{o} {h} {a}, not {area}"
    );
    assert!(r.curves().iter().all(Curve::is_closed));
}

#[test]
fn two_circles() {
    let (a, b) = (circle(0.0, 0.0, 2.0), circle(2.0, 0.0, 2.0));
    let lens = 8.0 * PI / 3.0 - 2.0 * 3.0_f64.sqrt();
    check(&union(&[a.clone(), b.clone()]), 1, 0, 8.0 * PI - lens);
    check(&common(&a, &b), 1, 0, lens);
    check(&less(&a, &b), 1, 0, 4.0 * PI - lens);
    // Arcs stay arcs, and what goes over a seam is one.
    for r in [union(&[a.clone(), b.clone()]), common(&a, &b), less(&a, &b)] {
        let Curve::Poly(c) = r.faces()[0].outline() else { panic!("not joined") };
        assert_eq!(c.segments().len(), 2);
        assert!(c.segments().iter().all(|s| matches!(s, Curve::Arc(_))));
    }
    // Apart, inside, the same.
    let far = circle(9.0, 0.0, 1.0);
    let both = union(&[a.clone(), far.clone()]);
    check(&both, 2, 0, 5.0 * PI);
    assert_eq!(both.curves(), [a.clone(), far.clone()]);
    assert!(common(&a, &far).is_empty());
    assert_eq!(less(&a, &far).curves(), from_ref(&a));
    let small = circle(0.5, 0.0, 1.0);
    assert_eq!(union(&[small.clone(), a.clone()]).curves(), from_ref(&a));
    assert_eq!(common(&small, &a).curves(), from_ref(&small));
    check(&less(&a, &small), 1, 1, 3.0 * PI);
    assert!(less(&small, &a).is_empty());
    assert_eq!(less(&a, &small).faces()[0].holes(), [small.reversed()]);
    for twin in [a.clone(), a.reversed(), a.with_seam(3.0).unwrap(), Curve::from(a.to_nurbs().unwrap())] {
        check(&union(&[a.clone(), twin.clone()]), 1, 0, 4.0 * PI);
        check(&common(&a, &twin), 1, 0, 4.0 * PI);
        assert!(less(&a, &twin).is_empty(), "{twin:?}");
    }
}

#[test]
fn touches() {
    let a = circle(0.0, 0.0, 2.0);
    let (outer, inner) = (circle(3.0, 0.0, 1.0), circle(1.0, 0.0, 1.0));
    check(&union(&[a.clone(), outer.clone()]), 2, 0, 5.0 * PI);
    assert!(common(&a, &outer).is_empty());
    check(&less(&a, &outer), 1, 0, 4.0 * PI);
    // A hole that touches its outline.
    check(&less(&a, &inner), 1, 1, 3.0 * PI);
    check(&union(&[a.clone(), inner.clone()]), 1, 0, 4.0 * PI);
    check(&common(&a, &inner), 1, 0, PI);
    // Corners.
    let (s, t) = (square(0.0, 0.0, 1.0), square(1.0, 1.0, 1.0));
    check(&union(&[s.clone(), t.clone()]), 2, 0, 2.0);
    assert!(common(&s, &t).is_empty());
    // Four squares around a hole, corner to corner.
    let ring = [square(1.0, 0.0, 1.0), square(0.0, 1.0, 1.0), square(2.0, 1.0, 1.0), square(1.0, 2.0, 1.0)];
    check(&union(&ring), 4, 0, 4.0);
    // A square around them: its middle is left over.
    let around = square(0.0, 0.0, 3.0);
    let left = Region::difference_of(&[around], &ring, &Plane::XY, TOLERANCE).unwrap();
    check(&left, 5, 0, 5.0);
    // A diamond in a square touches it in four points.
    let diamond = polyline(&[(1.5, 0.0), (3.0, 1.5), (1.5, 3.0), (0.0, 1.5)]);
    check(&less(&square(0.0, 0.0, 3.0), &diamond), 4, 0, 4.5);
}

#[test]
fn shared_edges() {
    let (s, t) = (square(0.0, 0.0, 2.0), square(2.0, 0.0, 2.0));
    check(&union(&[s.clone(), t.clone()]), 1, 0, 8.0);
    assert!(common(&s, &t).is_empty());
    check(&less(&s, &t), 1, 0, 4.0);
    check(&union(&[s.clone(), square(2.0, 1.0, 2.0)]), 1, 0, 8.0);
    check(&less(&s, &square(0.0, 0.0, 1.0)), 1, 0, 3.0);
    check(&common(&s, &square(1.0, 0.0, 1.0)), 1, 0, 1.0);
    // A ring of rectangles has a hole.
    let ring = [
        polyline(&[(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (0.0, 1.0)]),
        polyline(&[(0.0, 2.0), (3.0, 2.0), (3.0, 3.0), (0.0, 3.0)]),
        polyline(&[(0.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]),
        polyline(&[(2.0, 1.0), (3.0, 1.0), (3.0, 2.0), (2.0, 2.0)]),
    ];
    check(&union(&ring), 1, 1, 8.0);
    // An arc and a line shared by a half disc and a disc.
    let half = PolyCurve::new(vec![
        Arc::new(Circle::new(Plane::XY, 2.0).unwrap(), Interval::new(0.0, PI)).unwrap().into(),
        Line::new(p(-2.0, 0.0), p(2.0, 0.0)).into(),
    ]);
    let half: Curve = half.unwrap().into();
    check(&less(&circle(0.0, 0.0, 2.0), &half), 1, 0, 2.0 * PI);
    check(&common(&circle(0.0, 0.0, 2.0), &half), 1, 0, 2.0 * PI);
    // A grid of squares becomes one.
    let many: Vec<Curve> = (0..100).map(|i| square(f64::from(i % 10), f64::from(i / 10), 1.0)).collect();
    check(&union(&many), 1, 0, 100.0);
}

#[test]
fn within_the_tolerance() {
    // Edges that nearly coincide leave no slivers, and ends that nearly meet are joined.
    let s = square(0.0, 0.0, 2.0);
    for gap in [1e-5, -1e-5, 4e-4, -4e-4, 1e-9, -1e-12] {
        let t = square(2.0 + gap, gap, 2.0);
        let r = union(&[s.clone(), t.clone()]);
        assert_eq!((r.faces().len(), r.faces()[0].holes().len()), (1, 0), "gap {gap}");
        assert!((r.area() - 8.0).abs() < 0.01 && r.curves().iter().all(Curve::is_closed));
        assert!(common(&s, &t).is_empty());
        let twin = s.transformed(&Xform::translation(Vector3::new(gap, 0.3 * gap, 0.0))).unwrap();
        assert!(less(&s, &twin).is_empty(), "gap {gap}");
        assert_eq!(facts(&union(&[s.clone(), twin])).0, 1);
        let (a, b) = (circle(0.0, 0.0, 5.0), circle(0.0, 0.0, 5.0 + gap));
        assert!(less(&a, &b).is_empty() && less(&b, &a).is_empty(), "gap {gap}");
    }
    // A crossing so shallow that the lens is no deeper than the tolerance.
    let (a, b) = (circle(0.0, 0.0, 100.0), circle(199.9995, 0.0, 100.0));
    assert!(common(&a, &b).is_empty());
    // What is below the tolerance as a whole vanishes beside what is not.
    let dot = circle(5.0, 5.0, 1e-4);
    assert_eq!(union(&[s.clone(), dot]).faces().len(), 1);
    // A polyline of sides shorter than the tolerance keeps its form.
    let dense: Vec<(f64, f64)> =
        (0..20_000).map(|i| TAU * f64::from(i) / 20_000.0).map(|t| (t.cos(), t.sin())).collect();
    let dense = polyline(&dense);
    let r = union(&[dense.clone(), square(0.0, 0.0, 2.0)]);
    assert!((r.area() - (4.0 + 0.75 * PI)).abs() < 1e-6, "{}", r.area());
    assert_eq!(facts(&union(&[dense.clone(), dense])).0, 1);
    // Ends apart by less than the tolerance.
    let nearly = PolylineCurve::new(vec![p(0.0, 0.0), p(2.0, 0.0), p(2.0, 2.0), p(0.0, 2.0), p(0.0, 5e-4)]);
    let r = union(&[nearly.unwrap().into()]);
    assert!(r.faces()[0].outline().is_closed() && (r.area() - 4.0).abs() < 1e-3);
}

#[test]
fn curves_that_cross_themselves() {
    let eight = polyline(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]);
    for rule in [FillRule::Any, FillRule::NonZero, FillRule::EvenOdd] {
        check(&Region::new(from_ref(&eight), rule, &Plane::XY, TOLERANCE).unwrap(), 2, 0, 2.0);
    }
    let vertex = |k: usize| {
        let angle = TAU * 0.4 * k as f64;
        (angle.cos(), angle.sin())
    };
    let star = polyline(&[0, 1, 2, 3, 4].map(vertex));
    let whole = Region::new(from_ref(&star), FillRule::NonZero, &Plane::XY, TOLERANCE).unwrap();
    let odd = Region::new(&[star], FillRule::EvenOdd, &Plane::XY, TOLERANCE).unwrap();
    assert_eq!((facts(&whole).0, facts(&odd).0), (1, 5));
    assert!(whole.area() > odd.area() + 0.3);
    let nested = [circle(0.0, 0.0, 3.0), circle(0.0, 0.0, 2.0), circle(0.0, 0.0, 1.0)];
    let target = Region::new(&nested, FillRule::EvenOdd, &Plane::XY, TOLERANCE).unwrap();
    check(&target, 2, 1, 6.0 * PI);
    let inside = |x: f64| target.contains(Point3::new(x, 0.0, 7.0), TOLERANCE).unwrap();
    assert_eq!(
        [0.0, 1.0, 1.5, 2.5, 3.0005, 4.0].map(inside),
        [
            Containment::Inside,
            Containment::On,
            Containment::Outside,
            Containment::Inside,
            Containment::On,
            Containment::Outside
        ]
    );
}

#[test]
fn refused() {
    let open: Curve = Line::new(p(0.0, 0.0), p(1.0, 0.0)).into();
    let error =
        |c: Curve, tolerance: f64| Region::union_of(&[c], &Plane::XY, tolerance).unwrap_err().to_string();
    assert!(error(open, TOLERANCE).contains("open"));
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(error(circle(0.0, 0.0, 1.0), tolerance).contains("tolerance"));
    }
    // Nothing of nothing, and a curve seen edge-on.
    assert!(Region::union_of(&[], &Plane::XY, TOLERANCE).unwrap().is_empty());
    let upright = Circle::new(Plane::YZ, 1.0).unwrap().into();
    assert!(Region::union_of(&[upright], &Plane::XY, TOLERANCE).unwrap().is_empty());
    // A tilted circle is seen as an ellipse.
    let tilted = Plane::from_normal(p(0.0, 0.0), Vector3::new(0.0, 1.0, 1.0)).unwrap();
    let ellipse = union(&[Circle::new(tilted, 2.0).unwrap().into()]);
    check(&ellipse, 1, 0, 4.0 * PI * 0.5_f64.sqrt());
}

#[test]
fn far_from_the_origin() {
    let away = Xform::translation(Vector3::new(4.0e5, 5.8e6, 120.0));
    let plane = Plane::XY.with_origin(Point3::new(0.0, 0.0, 120.0));
    let at = |c: Curve| c.transformed(&away).unwrap();
    let (a, b) = (at(circle(0.0, 0.0, 2.0)), at(square(0.0, 0.0, 3.0)));
    let r = Region::union_of(&[a.clone(), b.clone()], &plane, TOLERANCE).unwrap();
    assert!((r.area() - (9.0 + 3.0 * PI)).abs() < 1e-6);
    let r = Region::intersection_of(&[a], &[b], &plane, TOLERANCE).unwrap();
    assert!((r.area() - PI).abs() < 1e-6 && r.faces()[0].outline().is_closed());
}

#[test]
fn trimmed_curves() {
    let ring = Region::new(
        &[circle(0.0, 0.0, 3.0), circle(0.0, 0.0, 1.0)],
        FillRule::EvenOdd,
        &Plane::XY,
        TOLERANCE,
    );
    let ring = ring.unwrap();
    let line: Curve = Line::new(p(-5.0, 0.0), p(5.0, 0.0)).into();
    let cut = ring.trim(&line, TOLERANCE).unwrap();
    let ends = |list: &[Curve]| list.iter().map(|c| (c.start().x, c.end().x)).collect::<Vec<_>>();
    let near = |a: Vec<(f64, f64)>, b: &[(f64, f64)]| {
        assert!(
            a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x.0 - y.0).abs() + (x.1 - y.1).abs() < 1e-9),
            "{a:?}"
        );
    };
    near(ends(&cut.inside), &[(-3.0, -1.0), (1.0, 3.0)]);
    near(ends(&cut.outside), &[(-5.0, -3.0), (-1.0, 1.0), (3.0, 5.0)]);
    // A closed curve: the piece over the seam is one; a tilted one stays an arc where it is.
    let disc = union(&[circle(0.0, 0.0, 2.0)]);
    let other = circle(1.0, 0.0, 2.0).with_seam(0.3).unwrap();
    let cut = disc.trim(&other, TOLERANCE).unwrap();
    assert_eq!((cut.inside.len(), cut.outside.len()), (1, 1));
    assert!((cut.inside[0].length() + cut.outside[0].length() - other.length()).abs() < 1e-9);
    let tilted = Plane::from_normal(Point3::new(0.0, 0.0, 5.0), Vector3::new(0.0, 1.0, 2.0)).unwrap();
    let arch: Curve = Circle::new(tilted, 2.2).unwrap().into();
    let cut = disc.trim(&arch, TOLERANCE).unwrap();
    assert_eq!((cut.inside.len(), cut.outside.len()), (2, 2));
    for piece in cut.inside.iter().chain(&cut.outside) {
        assert!(matches!(piece, Curve::Arc(_)));
        for q in [piece.start(), piece.end()] {
            assert!((q.x.hypot(q.y) - 2.0).abs() < 1e-8, "{q:?}");
        }
    }
    // On the border, touching it from outside, not meeting it.
    let edge: Curve = Line::new(p(0.0, 0.0), p(2.0, 0.0)).into();
    let box_ = union(&[square(0.0, 0.0, 2.0)]);
    let trim = |c: &Curve| box_.trim(c, TOLERANCE).unwrap();
    assert_eq!(trim(&edge).inside, from_ref(&edge));
    let touching = circle(3.0, 1.0, 1.0);
    assert_eq!((trim(&touching).inside.len(), trim(&touching).outside), (0, vec![touching]));
    let inside = circle(1.0, 1.0, 0.5);
    assert_eq!(trim(&inside).inside, [inside]);
    let helix = NurbsCurve::interpolate(
        3,
        &[p(-1.0, 1.0), Point3::new(1.0, 1.5, 4.0), Point3::new(3.0, 1.0, 9.0)],
        katydid_geometry::KnotSpacing::Chord,
        None,
        None,
    );
    let cut = trim(&helix.unwrap().into());
    assert_eq!((cut.inside.len(), cut.outside.len()), (1, 2));
    assert!(cut.inside[0].start().x.abs() < 1e-9 && cut.inside[0].start().z > 0.1);
}

#[test]
fn relations() {
    let a = circle(0.0, 0.0, 2.0);
    let to = |b: &Curve| relation(&a, b, &Plane::XY, TOLERANCE).unwrap();
    assert_eq!(to(&circle(9.0, 0.0, 1.0)), CurveRelation::Apart);
    assert_eq!(to(&circle(4.0, 0.0, 2.0)), CurveRelation::Apart);
    assert_eq!(to(&circle(3.0, 0.0, 2.0)), CurveRelation::Crossing);
    assert_eq!(to(&circle(1.0, 0.0, 1.0)), CurveRelation::SecondInside);
    assert_eq!(to(&circle(1.0, 0.0, 5.0).reversed()), CurveRelation::FirstInside);
    assert_eq!(to(&a.reversed()), CurveRelation::Same);
    let line: Curve = Line::new(p(0.0, 0.0), p(1.0, 0.0)).into();
    assert!(relation(&a, &line, &Plane::XY, TOLERANCE).is_err());
}

#[test]
fn many_circles_at_once() {
    let mut curves = Vec::new();
    for i in 0..20 {
        for j in 0..20 {
            curves.push(circle(f64::from(i) * 1.5, f64::from(j) * 1.5, 1.0));
        }
    }
    let r = union(&curves);
    assert_eq!((r.faces().len(), r.faces()[0].holes().len()), (1, 361));
    let holes: f64 = r.faces()[0].holes().iter().map(|h| h.signed_area_in(&Plane::XY).0).sum();
    let outline = r.faces()[0].outline().signed_area_in(&Plane::XY).0;
    assert!((outline + holes - r.area()).abs() < 1e-9 && holes < 0.0);
}
