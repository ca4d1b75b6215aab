//! Intersections with a closed form, and the measures of boxes and intervals: laws and edge cases.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use katydid_geometry::intersect::{
    self, ArcArc, CircleCircle, LineCylinder, PlaneCircle, SphereSection, UpToTwo,
};
use katydid_geometry::{
    Arc, BoundingBox, Box3, Circle, Ellipse, Interval, Line, Plane, Point3, Vector3, Xform,
};
use proptest::prelude::*;

const TOLERANCE: f64 = 1e-9;

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn line(a: Point3, b: Point3) -> Line {
    Line::new(a, b)
}

fn circle(x: f64, y: f64, r: f64) -> Circle {
    Circle::new(Plane::XY.with_origin(p(x, y, 0.0)), r).unwrap()
}

fn arc(x: f64, y: f64, r: f64, from: f64, to: f64) -> Arc {
    Arc::new(circle(x, y, r), Interval::new(from, to)).unwrap()
}

fn points() -> impl Strategy<Value = Point3> {
    (-5.0..5.0_f64, -5.0..5.0_f64, -5.0..5.0_f64).prop_map(|(x, y, z)| p(x, y, z))
}

fn planes() -> impl Strategy<Value = Plane> {
    (points(), points()).prop_filter_map("no normal", |(o, n)| {
        (n.to_vector().length() > 0.1).then(|| Plane::from_normal(o, n.to_vector()).ok()).flatten()
    })
}

#[test]
fn a_line_and_a_circle() {
    let c = circle(0.0, 0.0, 2.0);
    let hits = intersect::line_circle(&line(p(-1.0, 1.0, 0.0), p(1.0, 1.0, 0.0)), &c, TOLERANCE);
    let x = 3.0_f64.sqrt();
    let [a, b]: [_; 2] = hits.iter().collect::<Vec<_>>().try_into().unwrap();
    assert!((a.on_line - (0.5 - 0.5 * x)).abs() < 1e-15 && (b.on_line - (0.5 + 0.5 * x)).abs() < 1e-15);
    assert!((a.angle - (PI - PI / 6.0)).abs() < 1e-15 && (b.angle - PI / 6.0).abs() < 1e-15);
    // Touching counts once, also from within the tolerance.
    for y in [2.0, 2.0 + 1e-10, 2.0 - 1e-10] {
        let hits = intersect::line_circle(&line(p(-1.0, y, 0.0), p(1.0, y, 0.0)), &c, TOLERANCE);
        assert_eq!(hits.count(), 1);
    }
    assert_eq!(intersect::line_circle(&line(p(-1.0, 2.1, 0.0), p(1.0, 2.1, 0.0)), &c, TOLERANCE).count(), 0);
    // Upright lines: one on the circle, one inside, one slanting through two heights.
    let up = |x: f64| line(p(x, 0.0, -1.0), p(x, 0.0, 4.0));
    assert_eq!(intersect::line_circle(&up(2.0), &c, TOLERANCE).count(), 1);
    assert_eq!(intersect::line_circle(&up(1.0), &c, TOLERANCE), UpToTwo::None);
    let slanting = line(p(-2.0, 0.0, 0.0), p(2.0, 0.0, 1.0));
    let hit = intersect::line_circle(&slanting, &c, TOLERANCE).iter().next().unwrap();
    assert!(hit.on_line.abs() < 1e-15 && (hit.angle - PI).abs() < 1e-15);
    let none = line(Point3::ORIGIN, Point3::ORIGIN);
    assert_eq!(intersect::line_circle(&none, &c, TOLERANCE), UpToTwo::None);
    // An arc keeps what lies on it, its own ends among it.
    let chord = line(p(-1.0, 0.0, 0.0), p(1.0, 0.0, 0.0));
    let angles = |from, to| -> Vec<f64> {
        intersect::line_arc(&chord, &arc(0.0, 0.0, 2.0, from, to), TOLERANCE)
            .iter()
            .map(|h| h.angle)
            .collect()
    };
    assert_eq!(angles(0.0, PI), [PI, 0.0]);
    assert_eq!(angles(1.0, 2.0).len(), 0);
    assert_eq!(angles(-1.0, 1.0), [0.0]);
    assert_eq!(angles(1e-12, 1.0), [1e-12]);
}

#[test]
fn a_line_and_round_solids() {
    let through = line(p(-5.0, 0.0, 1.0), p(5.0, 0.0, 1.0));
    let hits = intersect::line_sphere(&through, Point3::ORIGIN, 2.0, TOLERANCE);
    for t in hits.iter() {
        assert!((through.at(t).to_vector().length() - 2.0).abs() < 1e-15);
    }
    assert_eq!(hits.count(), 2);
    assert_eq!(intersect::line_sphere(&through, Point3::ORIGIN, 1.0, TOLERANCE), UpToTwo::One(0.5));
    assert_eq!(intersect::line_sphere(&through, Point3::ORIGIN, 0.9, TOLERANCE), UpToTwo::None);
    let base = circle(0.0, 0.0, 2.0);
    let LineCylinder::At(hits) = intersect::line_cylinder(&through, &base, TOLERANCE) else {
        unreachable!("it crosses")
    };
    assert_eq!(hits, UpToTwo::Two(0.3, 0.7));
    let along = line(p(0.0, 2.0, 0.0), p(0.0, 2.0, 1.0));
    assert_eq!(intersect::line_cylinder(&along, &base, TOLERANCE), LineCylinder::OnSurface);
    let axis = line(Point3::ORIGIN, p(0.0, 0.0, 1.0));
    assert_eq!(intersect::line_cylinder(&axis, &base, TOLERANCE), LineCylinder::At(UpToTwo::None));
    let beside = line(p(-5.0, 2.0, 1.0), p(5.0, 2.0, -3.0));
    assert_eq!(intersect::line_cylinder(&beside, &base, TOLERANCE), LineCylinder::At(UpToTwo::One(0.5)));
}

#[test]
fn a_line_and_boxes() {
    let b = BoundingBox { min: Point3::ORIGIN, max: p(2.0, 3.0, 4.0) };
    let diagonal = line(p(0.0, 0.0, 0.0), p(2.0, 3.0, 4.0));
    assert_eq!(intersect::line_bounding_box(&diagonal, &b, 0.0), Some(Interval::UNIT));
    let edge = line(p(0.0, 0.0, -1.0), p(0.0, 0.0, 1.0));
    assert_eq!(intersect::line_bounding_box(&edge, &b, 0.0), Some(Interval::new(0.5, 2.5)));
    let beside = line(p(-1e-6, 0.0, -1.0), p(-1e-6, 0.0, 1.0));
    assert_eq!(intersect::line_bounding_box(&beside, &b, 0.0), None);
    assert!(intersect::line_bounding_box(&beside, &b, 1e-5).is_some());
    assert_eq!(intersect::line_bounding_box(&line(p(1.0, 1.0, 1.0), p(1.0, 1.0, 1.0)), &b, 0.0), None);
    let plane = Plane::XY.rotated(0.7).with_origin(p(5.0, 5.0, 5.0));
    let solid = Box3 { plane, x: Interval::new(2.0, 0.0), y: Interval::new(0.0, 3.0), z: Interval::UNIT };
    let axis = line(plane.at(-1.0, 1.0, 0.5), plane.at(1.0, 1.0, 0.5));
    let hit = intersect::line_box(&axis, &solid, 0.0).unwrap();
    assert!((hit.start - 0.5).abs() < 1e-14 && (hit.end - 1.5).abs() < 1e-14);
}

#[test]
fn planes_and_round_things() {
    let c = circle(0.0, 0.0, 2.0);
    let upright = |x: f64| Plane::YZ.with_origin(p(x, 0.0, 0.0));
    let PlaneCircle::At(UpToTwo::Two(a, b)) = intersect::plane_circle(&upright(1.0), &c, TOLERANCE) else {
        unreachable!("it crosses")
    };
    assert!((a - PI / 3.0).abs() < 1e-15 && (b - (TAU - PI / 3.0)).abs() < 1e-14);
    assert_eq!(intersect::plane_circle(&upright(2.0), &c, TOLERANCE), PlaneCircle::At(UpToTwo::One(0.0)));
    let PlaneCircle::At(UpToTwo::One(left)) = intersect::plane_circle(&upright(-2.0), &c, TOLERANCE) else {
        unreachable!("it touches")
    };
    assert!((left - PI).abs() < 1e-15);
    assert_eq!(intersect::plane_circle(&upright(2.1), &c, TOLERANCE), PlaneCircle::At(UpToTwo::None));
    assert_eq!(intersect::plane_circle(&Plane::XY, &c, TOLERANCE), PlaneCircle::InPlane);
    let above = Plane::XY.offset(0.1);
    assert_eq!(intersect::plane_circle(&above, &c, TOLERANCE), PlaneCircle::At(UpToTwo::None));
    let half = arc(0.0, 0.0, 2.0, 0.0, PI);
    let PlaneCircle::At(hits) = intersect::plane_arc(&upright(1.0), &half, TOLERANCE) else {
        unreachable!("it crosses")
    };
    assert_eq!(hits.count(), 1);
    let section = |z: f64| intersect::plane_sphere(&Plane::XY.offset(z), Point3::ORIGIN, 2.0, TOLERANCE);
    assert!(matches!(section(1.0), SphereSection::Circle(c) if (c.radius - 3.0_f64.sqrt()).abs() < 1e-15));
    assert_eq!(section(2.0), SphereSection::Point(p(0.0, 0.0, 2.0)));
    assert_eq!(section(2.1), SphereSection::None);
    let two =
        |x: f64, r: f64| intersect::sphere_sphere((Point3::ORIGIN, 2.0), (p(x, 0.0, 0.0), r), TOLERANCE);
    assert_eq!(two(3.0, 1.0), SphereSection::Point(p(2.0, 0.0, 0.0)));
    assert_eq!(two(1.0, 1.0), SphereSection::Point(p(2.0, 0.0, 0.0)));
    assert_eq!(two(1.0, 3.0), SphereSection::Point(p(-2.0, 0.0, 0.0)));
    assert_eq!(
        (two(3.1, 1.0), two(0.5, 1.0), two(0.0, 1.0)),
        (SphereSection::None, SphereSection::None, SphereSection::None)
    );
    assert_eq!(two(0.0, 2.0), SphereSection::Same);
    assert!(matches!(two(2.0, 2.0), SphereSection::Circle(c) if (c.radius - 3.0_f64.sqrt()).abs() < 1e-15));
}

#[test]
fn circles_and_arcs_in_one_plane() {
    let a = circle(0.0, 0.0, 2.0);
    let count = |x: f64, r: f64| match intersect::circle_circle(&a, &circle(x, 0.0, r), TOLERANCE) {
        CircleCircle::At(hits) => hits.count(),
        CircleCircle::Same => 9,
    };
    assert_eq!(
        [count(3.0, 2.0), count(4.0, 2.0), count(1.0, 1.0), count(5.0, 2.0), count(0.0, 1.0)],
        [2, 1, 1, 0, 0]
    );
    assert_eq!(count(0.0, 2.0), 9);
    assert_eq!(count(-1.0, 3.0), 1);
    let (upper, right) = (arc(0.0, 0.0, 2.0, 0.0, PI), arc(0.0, 0.0, 2.0, -FRAC_PI_2, FRAC_PI_2));
    let shared = intersect::arc_arc(&upper, &right, TOLERANCE);
    assert_eq!((shared.points.len(), shared.overlaps.len()), (0, 1));
    assert!((shared.overlaps[0].start).abs() < 1e-15 && (shared.overlaps[0].end - FRAC_PI_2).abs() < 1e-15);
    // Two halves meet in their ends.
    let lower = arc(0.0, 0.0, 2.0, PI, TAU);
    let ends = intersect::arc_arc(&upper, &lower, TOLERANCE);
    assert_eq!((ends.points.len(), ends.overlaps.len()), (2, 0));
    // The same arc walked backwards.
    let same = intersect::arc_arc(&upper, &upper.reversed(), TOLERANCE);
    assert!(same.points.is_empty() && (same.overlaps[0].length() - PI).abs() < 1e-14);
    // Nearly whole circles whose gaps lie apart share two ranges.
    let (c, d) = (arc(0.0, 0.0, 2.0, 0.1, TAU - 0.1), arc(0.0, 0.0, 2.0, PI + 0.1, 3.0 * PI - 0.1));
    assert_eq!(intersect::arc_arc(&c, &d, TOLERANCE).overlaps.len(), 2);
    let apart = intersect::arc_arc(&upper, &arc(3.0, 0.0, 2.0, PI, TAU), TOLERANCE);
    assert_eq!(apart, ArcArc::default());
    assert_eq!(intersect::arc_arc(&upper, &arc(3.0, 0.0, 2.0, 0.0, PI), TOLERANCE).points.len(), 1);
}

#[test]
fn intervals() {
    let i = Interval::new(5.0, 2.0);
    assert!(i.is_decreasing() && !i.is_singleton() && i.includes(Interval::new(3.0, 5.0), true));
    assert!(i.includes(Interval::new(2.0, 5.0), false) && !i.includes(Interval::new(2.0, 5.0), true));
    assert_eq!(i.including(7.0), Interval::new(2.0, 7.0));
    assert_eq!((i.expanded(1.0), i.expanded(-2.0)), (Some(Interval::new(1.0, 6.0)), None));
    assert_eq!(i.normalized_interval(Interval::new(5.0, 3.5)), Interval::new(0.0, 0.5));
    assert_eq!(i.sub_interval(Interval::new(0.0, 0.5)), Interval::new(5.0, 3.5));
    let day = Interval::new(0.0, 24.0);
    assert_eq!((day.wrapped(25.0), day.wrapped(-1.0), day.wrapped(24.0)), (1.0, 23.0, 0.0));
    assert_eq!((Interval::new(1.0, 1.0).wrapped(7.0), i.shifted(1.0)), (7.0, Interval::new(6.0, 3.0)));
}

proptest! {
    #[test]
    fn hits_lie_on_both(a in points(), b in points(), plane in planes(), r in 0.1..6.0_f64) {
        prop_assume!(a.distance_to(b) > 0.1);
        let (l, c) = (line(a, b), Circle::new(plane, r).unwrap());
        for t in intersect::line_sphere(&l, plane.origin, r, TOLERANCE).iter() {
            prop_assert!((l.at(t).distance_to(plane.origin) - r).abs() < 2.0 * TOLERANCE);
        }
        if let LineCylinder::At(hits) = intersect::line_cylinder(&l, &c, TOLERANCE) {
            for t in hits.iter() {
                let [x, y, _] = plane.coordinates(l.at(t));
                prop_assert!((x.hypot(y) - r).abs() < 1e-8);
            }
        }
        // A line in the circle's plane meets the circle where it meets the sphere.
        let flat = line(plane.closest_point(a), plane.closest_point(b));
        prop_assume!(flat.length() > 0.1);
        let on_circle = intersect::line_circle(&flat, &c, TOLERANCE);
        let on_sphere = intersect::line_sphere(&flat, plane.origin, r, TOLERANCE);
        prop_assert_eq!(on_circle.count(), on_sphere.count());
        for (hit, t) in on_circle.iter().zip(on_sphere.iter()) {
            prop_assert!((hit.on_line - t).abs() < 1e-6);
            prop_assert!(c.at(hit.angle).distance_to(flat.at(hit.on_line)) < 1e-4);
        }
    }

    #[test]
    fn circles_in_space(f in planes(), g in planes(), r in 0.5..6.0_f64, s in 0.5..6.0_f64, t in 0.0..TAU) {
        let a = Circle::new(f, r).unwrap();
        if let PlaneCircle::At(hits) = intersect::plane_circle(&g, &a, TOLERANCE) {
            for t in hits.iter() {
                prop_assert!(g.signed_distance(a.at(t)).abs() < 2.0 * TOLERANCE);
            }
        }
        // A second circle through a point of the first.
        let p = a.at(t);
        let Ok(frame) = Plane::from_axes(g.origin, p - g.origin, g.y_axis) else { return Ok(()) };
        prop_assume!(p.distance_to(g.origin) > 0.5 && frame.z_axis.cross(f.z_axis).length() > 0.1);
        let b = Circle::new(frame, p.distance_to(g.origin)).unwrap();
        let CircleCircle::At(hits) = intersect::circle_circle(&a, &b, 1e-7) else { return Ok(()) };
        prop_assert!(hits.iter().any(|[s, _]| a.at(s).distance_to(p) < 1e-3), "{hits:?}");
        for [x, y] in hits.iter() {
            prop_assert!(a.at(x).distance_to(b.at(y)) < 1e-6);
        }
        // In one plane.
        let b = Circle::new(f.with_origin(f.at(1.3, 0.4, 0.0)).rotated(1.0), s).unwrap();
        if let CircleCircle::At(hits) = intersect::circle_circle(&a, &b, TOLERANCE) {
            for [x, y] in hits.iter() {
                prop_assert!(a.at(x).distance_to(b.at(y)) < 1e-8);
            }
            let apart = 1.3_f64.hypot(0.4);
            prop_assert_eq!(hits.count() == 0, apart > r + s || apart < (r - s).abs());
        }
    }

    #[test]
    fn boxes_measure_as_samples_do(a in points(), b in points(), c in points(), d in points(), plane in planes()) {
        let (one, two) = (BoundingBox::from_corners(a, b).unwrap(), BoundingBox::from_corners(c, d).unwrap());
        prop_assert_eq!(one.intersection(&two).is_some(), one.distance_to_box(&two) == 0.0);
        let nearest = one.closest_point(c);
        prop_assert!((nearest.distance_to(c) - one.distance_to(c)).abs() < 1e-14);
        let l = line(c, d);
        let (least, most) = (one.distance_to_segment(&l), one.max_distance_to_segment(&l));
        let mut sampled = f64::INFINITY;
        for i in 0..=200 {
            let q = l.at(f64::from(i) / 200.0);
            sampled = sampled.min(one.distance_to(q));
            prop_assert!(one.max_distance_to(q) <= most + 1e-13);
        }
        prop_assert!(least <= sampled + 1e-14 && sampled - least < l.length() / 200.0);
        prop_assert!(one.max_distance_to_box(&two) >= one.max_distance_to(c) - 1e-13);
        let range = one.range_of_distances(&plane);
        for q in one.corners() {
            let h = plane.signed_distance(q);
            prop_assert!(range.start - 1e-13 <= h && h <= range.end + 1e-13);
        }
        prop_assert_eq!(one.distance_to_plane(&plane) == 0.0, range.contains(0.0));
        prop_assert!((one.edges().iter().map(Line::length).sum::<f64>()
            - 4.0 * (one.diagonal().x + one.diagonal().y + one.diagonal().z)).abs() < 1e-12);
    }

    #[test]
    fn affine_images_of_circles_are_ellipses(plane in planes(), r in 0.2..3.0_f64, rows in prop::array::uniform3(prop::array::uniform4(-2.0..2.0_f64))) {
        let m = Xform { rows: [rows[0], rows[1], rows[2], [0.0, 0.0, 0.0, 1.0]] };
        prop_assume!(m.determinant().abs() > 0.2);
        let c = Circle::new(plane, r).unwrap();
        let e = Ellipse::image_of_circle(&c, &m).unwrap();
        prop_assert!(e.rx >= e.ry);
        for i in 0..12 {
            let q = m.point(c.at(f64::from(i)));
            let [x, y, z] = e.plane.coordinates(q);
            prop_assert!(((x / e.rx).hypot(y / e.ry) - 1.0).abs() < 1e-12 && z.abs() < 1e-12);
        }
        let both = Ellipse::new(e.plane, e.rx, e.ry).unwrap().image(&m.inverse().unwrap()).unwrap();
        prop_assert!((both.rx - r).abs() < 1e-10 && (both.ry - r).abs() < 1e-10);
    }
}

#[test]
fn conjugate_radii() {
    let e = Ellipse::from_conjugate_radii(Point3::ORIGIN, Vector3::X * 3.0, Vector3::Y * 5.0).unwrap();
    assert!((e.rx - 5.0).abs() < 1e-15 && (e.ry - 3.0).abs() < 1e-15);
    assert!(Ellipse::from_conjugate_radii(Point3::ORIGIN, Vector3::X, Vector3::X * 2.0).is_err());
    let same = BoundingBox { min: p(1.0, 1.0, 1.0), max: p(1.0, 2.0, 1.0) };
    assert_eq!((same.degenerate_directions(0.0), same.volume(), same.area()), (2, 0.0, 0.0));
}
