//! The same curve in other forms: reversed, cut, moved, as NURBS, and recognised for what it is.

use crate::common::{close, close_points, close_vectors};
use crate::made::{chain, circle, line, p, polyline, wave};
use katydid_geometry::{Arc, Circle, Curve, Ellipse, Interval, NurbsCurve, Plane, Point3, Vector3, Xform};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

#[test]
fn domains_of_the_basic_curves() {
    assert_eq!(line(p(0.0, 0.0, 0.0), p(3.0, 4.0, 0.0)).domain(), Interval::new(0.0, 5.0));
    assert_eq!(line(p(1.0, 0.0, 0.0), p(1.0, 0.0, 0.0)).domain(), Interval::new(0.0, 1.0));
    assert_eq!(circle(2.0).domain(), Interval::new(0.0, 4.0 * PI));
    assert_eq!(polyline(&[(0.0, 0.0), (5.0, 0.0), (5.0, 9.0)]).domain(), Interval::new(0.0, 2.0));
    assert_eq!(circle(2.0).with_domain(Interval::UNIT).unwrap().point_at(0.25), circle(2.0).point_at(PI));
}

#[test]
fn reversal_trimming_and_splitting_keep_the_points() {
    for c in [wave(), chain(), circle(2.0), polyline(&[(0.0, 0.0), (3.0, 1.0), (1.0, 4.0), (0.0, 7.0)])] {
        let d = c.domain();
        let r = c.reversed();
        assert_eq!(r.domain(), Interval::new(-d.end, -d.start));
        close(r.length(), c.length(), 1e-12, "length survives reversal");
        let (a, b) = (d.at(0.21), d.at(0.83));
        let part = c.trimmed(Interval::new(a, b)).unwrap();
        close(part.length(), c.length_between(Interval::new(a, b)), 1e-11, "length adds up");
        for i in 0..=20 {
            let t = d.at(f64::from(i) / 20.0);
            close_points(r.point_at(-t), c.point_at(t), 1e-12, "reversed");
            if (a..=b).contains(&t) {
                close_points(part.point_at(t), c.point_at(t), 1e-11, "trimmed");
            }
        }
        let pieces = c.split_at(&[b, a, a, d.end + 1.0, f64::NAN]).unwrap();
        assert_eq!(pieces.len(), if c.is_closed() { 2 } else { 3 });
        close(pieces.iter().map(Curve::length).sum::<f64>(), c.length(), 1e-11, "sum of the pieces");
        assert!(c.trimmed(Interval::new(b, a)).is_err());
        assert!(c.trimmed(Interval::new(d.start - 1.0, b)).is_err());
        let moved = c.with_domain(Interval::new(-1.0, 1.0)).unwrap();
        close_points(moved.point_at(0.0), c.point_at(d.middle()), 1e-11, "another domain");
    }
}

#[test]
fn closed_curves_split_as_in_rhino() {
    let c = circle(1.0);
    let parts = c.split_at(&[1.0, 2.0, 4.0]).unwrap();
    assert_eq!(parts.len(), 3);
    close_points(parts[2].start(), c.point_at(4.0), 1e-15, "the piece over the seam is last");
    close_points(parts[2].end(), c.point_at(1.0), 1e-14, "and ends at the first cut");
    assert!(matches!(parts[2], Curve::Arc(_)));
    assert_eq!(c.split_at(&[0.0, 2.0, 4.0]).unwrap().len(), 3);
    assert_eq!(c.split_at(&[]).unwrap(), vec![c.clone()]);
    assert_eq!(c.split_at(&[0.0]).unwrap().len(), 1);
    let square = polyline(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]);
    let parts = square.split_at(&[1.5, 2.5]).unwrap();
    assert_eq!(parts[1].as_polyline().unwrap().len(), 5);
    let moved = square.with_seam(1.5).unwrap();
    assert_eq!(moved.domain(), Interval::new(1.5, 5.5));
    close(moved.length(), 4.0, 1e-15, "length");
    assert_eq!(moved.start(), p(1.0, 0.5, 0.0));
    let blob: Curve = NurbsCurve::periodic_uniform(
        3,
        &[p(0.0, 0.0, 0.0), p(6.0, 0.0, 0.0), p(2.0, 2.0, 0.0), p(0.0, 6.0, 0.0)],
    )
    .unwrap()
    .into();
    let moved = blob.with_seam(1.3).unwrap();
    assert!(matches!(moved, Curve::Nurbs(_)) && moved.is_closed());
    assert_eq!(moved.domain(), Interval::new(1.3, 5.3));
    close_points(moved.point_at(4.7), blob.point_at(0.7), 1e-12, "past the old seam");
    let sub = c.sub_curve(Interval::new(5.0, 1.0)).unwrap();
    close(sub.length(), TAU - 4.0, 1e-13, "through the seam");
}

#[test]
fn transforms_of_arcs_are_exact() {
    let arc = Arc::new(Circle::new(Plane::XZ, 3.0).unwrap(), Interval::new(0.4, 4.0)).unwrap();
    let c: Curve = arc.into();
    let mirror = Xform::mirror(&Plane::from_normal(p(1.0, 2.0, 3.0), Vector3::new(1.0, 2.0, -1.0)).unwrap());
    let squash = Xform::scale_non_uniform(&Plane::XY, 2.0, 1.0, 0.3);
    let turn = Xform::rotation(1.0, Vector3::new(1.0, 1.0, 0.0), p(3.0, 0.0, 0.0)).unwrap();
    for (xform, stays) in [(mirror, true), (turn, true), (squash, false), (squash * turn, false)] {
        let image = c.transformed(&xform).unwrap();
        assert_eq!(matches!(image, Curve::Arc(_)), stays);
        assert_eq!(image.domain(), c.domain());
        for i in 0..=8 {
            let t = c.domain().at(f64::from(i) / 8.0);
            let want = xform.point(c.point_at(t));
            if stays {
                close_points(image.point_at(t), want, 1e-13, "same parameter");
            }
            assert!(image.closest_point(want).unwrap().distance < 1e-9, "same points");
        }
        close_points(image.start(), xform.point(c.start()), 1e-13, "start");
        close_points(image.end(), xform.point(c.end()), 1e-13, "end");
    }
    let flat = c.transformed(&Xform::planar_projection(&Plane::XY)).unwrap();
    assert!(flat.is_linear(1e-9) || flat.length() > 0.0);
    let huge = Xform::scale(Point3::ORIGIN, f64::MAX);
    assert!(wave().transformed(&huge).is_err());
}

#[test]
fn nurbs_forms_are_exact() {
    for c in [
        chain(),
        circle(2.0),
        polyline(&[(0.0, 0.0), (3.0, 1.0), (1.0, 4.0)]),
        line(p(0.0, 0.0, 0.0), p(1.0, 2.0, 3.0)),
    ] {
        let n: Curve = c.to_nurbs().unwrap().into();
        assert_eq!(n.domain(), c.domain());
        close(n.length(), c.length(), 1e-12, "length");
        for i in 0..=30 {
            let t = c.domain().at(f64::from(i) / 30.0);
            assert!(n.closest_point(c.point_at(t)).unwrap().distance < 1e-9);
        }
    }
    let e = Ellipse::new(Plane::XY, 5.0, 3.0).unwrap();
    let n: Curve = e.to_nurbs().unwrap().into();
    assert_eq!(n.domain(), Interval::new(0.0, TAU));
    assert!(n.is_closed());
    close_points(n.point_at(FRAC_PI_2), p(0.0, 3.0, 0.0), 1e-15, "quadrant");
    let (area, center) = n.area_and_centroid(1e-6).unwrap();
    close(area, PI * 15.0, 1e-12, "area of an ellipse");
    close_points(center, Point3::ORIGIN, 1e-12, "centre of an ellipse");
    assert_eq!(e.foci(), [p(4.0, 0.0, 0.0), p(-4.0, 0.0, 0.0)]);
    assert!(Ellipse::new(Plane::XY, 0.0, 1.0).is_err());
}

#[test]
fn recognised_for_what_they_are() {
    let c: Curve = Circle::from_normal(p(1.0, 2.0, 3.0), Vector3::new(1.0, 1.0, 1.0), 4.0).unwrap().into();
    let n: Curve = c.to_nurbs().unwrap().into();
    let found = n.as_circle(1e-9).unwrap();
    close(found.radius, 4.0, 1e-12, "radius");
    close_points(found.center(), p(1.0, 2.0, 3.0), 1e-12, "centre");
    let arc: Curve = Arc::through(p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(2.0, 0.0, 0.0)).unwrap().into();
    let n: Curve = arc.to_nurbs().unwrap().into();
    let back = n.as_arc(1e-9).unwrap();
    close(back.length(), PI, 1e-12, "arc");
    close_points(back.end(), p(2.0, 0.0, 0.0), 1e-12, "end");
    assert!(n.as_circle(1e-9).is_none());
    assert!(wave().as_arc(1e-3).is_none() && wave().as_line(1e-3).is_none());
    let straight: Curve =
        NurbsCurve::bezier(&[p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(2.0, 2.0, 0.0)]).unwrap().into();
    assert!(straight.is_linear(1e-9) && straight.as_arc(1e-3).is_none());
    assert_eq!(chain().as_polyline(), None);
    assert!(circle(1.0).is_periodic() && circle(1.0).is_closed());
    assert!(!polyline(&[(0.0, 0.0), (1.0, 0.0), (0.0, 0.0)]).is_closed());
    assert!(!chain().is_planar(1e-3));
    let clockwise = polyline(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0), (0.0, 0.0)]);
    close_vectors(
        clockwise.plane(1e-9).unwrap().z_axis,
        -Vector3::Z,
        1e-12,
        "a closed curve runs counter-clockwise",
    );
    close_vectors(clockwise.reversed().plane(1e-9).unwrap().z_axis, Vector3::Z, 1e-12, "and its reverse too");
}

#[test]
fn boxes_are_tight() {
    for c in [wave(), chain(), circle(2.0)] {
        let b = c.bounding_box();
        let d = c.domain();
        let mut inner = katydid_geometry::BoundingBox { min: c.start(), max: c.start() };
        for i in 0..=20_000 {
            let q = c.point_at(d.at(f64::from(i) / 20_000.0));
            assert!(b.inflated(1e-12).contains(q));
            inner = inner.union(&katydid_geometry::BoundingBox { min: q, max: q });
        }
        assert!(b.min.distance_to(inner.min) < 1e-5 && b.max.distance_to(inner.max) < 1e-5);
    }
    let frame = Plane::from_normal(p(1.0, 0.0, 0.0), Vector3::new(1.0, 2.0, 3.0)).unwrap();
    let b = chain().bounding_box_in(&frame);
    assert!(b.contains(chain().point_at(3.3), 1e-12));
}
