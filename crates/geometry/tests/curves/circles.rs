//! Circles and arcs from what is known of them.

use crate::common::{close, close_points, close_vectors};
use crate::made::p;
use katydid_geometry::{Arc, Circle, Interval, Line, Plane, Point3, Vector3, Xform};
use std::f64::consts::{FRAC_PI_2, PI};

#[test]
fn circles_and_arcs_from_what_is_known() {
    let c = Circle::through(p(1.0, 0.0, 0.0), p(0.0, 1.0, 0.0), p(-1.0, 0.0, 0.0)).unwrap();
    close_points(c.center(), Point3::ORIGIN, 1e-15, "centre");
    close_points(c.at(0.0), p(1.0, 0.0, 0.0), 1e-15, "angle 0 at the first point");
    let line = |t: f64| p(t, 2.0 * t, -t);
    assert!(Circle::through(line(0.0), line(1.0), line(2.0)).is_err());
    assert!(Circle::through(line(0.0), line(0.0), line(2.0)).is_err());
    assert!(Arc::through(line(0.0), line(1.0), line(2.0)).is_err());
    assert!(Circle::new(Plane::XY, 0.0).is_err() && Circle::new(Plane::XY, f64::NAN).is_err());
    let arc = Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::Y, p(-2.0, 0.0, 0.0)).unwrap();
    close_points(arc.midpoint(), p(-1.0, 1.0, 0.0), 1e-15, "bends towards the end");
    close(arc.length(), PI, 1e-15, "half a circle");
    let long =
        Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::new(1.0, -1.0, 0.0), p(-2.0, 0.0, 0.0))
            .unwrap();
    close(long.length(), 1.5 * PI * 2f64.sqrt(), 1e-13, "three quarters");
    assert!(Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::X, p(2.0, 0.0, 0.0)).is_err());
    assert!(Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::ZERO, p(2.0, 1.0, 0.0)).is_err());
    let unit = Circle::new(Plane::XY, 1.0).unwrap();
    let back = Arc::new(unit, Interval::new(1.0, 0.0)).unwrap();
    close_points(back.start(), unit.at(1.0), 1e-15, "a reversed range starts at its first angle");
    close_points(back.end(), unit.at(0.0), 1e-15, "and ends at its second");
    assert!(Arc::new(unit, Interval::new(0.0, 99.0)).unwrap().is_circle());
    assert!(Arc::new(unit, Interval::new(1.0, 1.0)).is_err());
    let points: Vec<_> = (0..9)
        .map(|i| {
            Plane::YZ.with_origin(p(1.0, 2.0, 3.0)).at(
                f64::from(i).cos() * 2.0,
                f64::from(i).sin() * 2.0,
                0.0,
            )
        })
        .collect();
    let (fit, deviation) = Circle::fit(&points).unwrap();
    close(fit.radius, 2.0, 1e-12, "fitted radius");
    assert!(deviation < 1e-12);
    close_points(fit.center(), p(1.0, 2.0, 3.0), 1e-12, "fitted centre");
}

#[test]
fn tangents_of_circles() {
    let a = Circle::new(Plane::XY, 1.0).unwrap();
    let b = Circle::new(Plane::XY.with_origin(p(5.0, 1.0, 0.0)), 2.0).unwrap();
    let touches = |l: &Line, c: &Circle, at: Point3| {
        close(at.distance_to(c.center()), c.radius, 1e-14, "on the circle");
        close(l.direction().dot(at - c.center()), 0.0, 1e-13, "at right angles to the radius");
    };
    for l in a.tangents_from(p(3.0, -2.0, 7.0)).unwrap() {
        assert_eq!(l.from.z, 0.0);
        touches(&l, &a, l.to);
    }
    let [left, right] = a.tangents_from(p(-3.0, 0.0, 0.0)).unwrap();
    assert!(left.to.y > 0.0 && right.to.y < 0.0);
    for pair in [a.outer_tangents(&b).unwrap(), a.inner_tangents(&b).unwrap()] {
        for l in pair {
            touches(&l, &a, l.from);
            touches(&l, &b, l.to);
        }
        assert!(pair[0].from.y > pair[1].from.y);
    }
    assert!(a.tangents_from(p(0.5, 0.0, 0.0)).is_none());
    let inside = Circle::new(Plane::XY, 0.25).unwrap();
    assert!(a.outer_tangents(&inside).is_none() && a.inner_tangents(&inside).is_none());
}

#[test]
fn m9_one_circle_gives_three() {
    let c = Circle::new(Plane::XY, 2.0).unwrap();
    let scaled = c.transformed(&Xform::scale(p(1.0, 0.0, 0.0), 1.5)).unwrap();
    assert_eq!((scaled.radius, scaled.center()), (3.0, p(-0.5, 0.0, 0.0)));
    let turned = c.transformed(&Xform::rotation(FRAC_PI_2, Vector3::Y, Point3::ORIGIN).unwrap()).unwrap();
    close_vectors(turned.plane.z_axis, Vector3::X, 1e-15, "normal turned about y");
    let moved = c.transformed(&Xform::translation(Vector3::new(1.0, 2.0, 3.0))).unwrap();
    assert_eq!((moved.radius, moved.center()), (2.0, p(1.0, 2.0, 3.0)));
    assert!(c.transformed(&Xform::scale_non_uniform(&Plane::XY, 1.0, 2.0, 1.0)).is_none());
}
