//! Curves in a plane: what they enclose, offsets, sections, and what is refused.

use crate::common::{close, close_points};
use crate::made::{circle, line, p, polyline, wave};
use katydid_geometry::{
    Arc, Containment, Curve, Interval, NurbsCurve, Plane, PolyCurve, PolylineCurve, Rectangle, Vector3,
    Xform, regular_polygon,
};
use std::f64::consts::PI;

#[test]
fn regions() {
    let square = Rectangle { plane: Plane::XY, x: Interval::new(1.0, 3.0), y: Interval::new(1.0, 4.0) };
    let c: Curve = square.to_polyline().unwrap().into();
    let (area, center) = c.area_and_centroid(1e-6).unwrap();
    close(area, 6.0, 1e-15, "area");
    close_points(center, p(2.0, 2.5, 0.0), 1e-15, "centroid");
    assert_eq!((square.area(), square.perimeter(), square.center()), (6.0, 10.0, center));
    let at = |x: f64, y: f64| c.contains_in_plane(p(x, y, 7.0), &Plane::XY, 1e-6).unwrap();
    assert_eq!(at(2.0, 2.0), Containment::Inside);
    assert_eq!(at(0.0, 2.0), Containment::Outside);
    assert_eq!(at(3.0, 2.0), Containment::On);
    assert_eq!(at(1.0, 1.0), Containment::On);
    assert_eq!(at(0.0, 1.0), Containment::Outside);
    let disc = circle(2.0);
    let (area, _) = disc.area_and_centroid(1e-6).unwrap();
    close(area, 4.0 * PI, 1e-13, "disc");
    for i in 0..100 {
        let x = f64::from(i) / 25.0;
        let want = if x < 2.0 - 1e-9 {
            Containment::Inside
        } else if x > 2.0 + 1e-9 {
            Containment::Outside
        } else {
            Containment::On
        };
        assert_eq!(disc.contains_in_plane(p(0.0, x, 0.0), &Plane::XY, 1e-9).unwrap(), want, "{x}");
    }
    let blob: Curve = NurbsCurve::periodic_uniform(
        3,
        &[p(0.0, 0.0, 0.0), p(6.0, 0.0, 0.0), p(2.0, 2.0, 0.0), p(0.0, 6.0, 0.0)],
    )
    .unwrap()
    .into();
    let (area, center) = blob.area_and_centroid(1e-6).unwrap();
    let mut sum = 0.0;
    let n = 4000;
    for i in 0..n {
        let q = |k: i32| blob.point_at(blob.domain().at(f64::from(k) / f64::from(n))).to_vector();
        sum += 0.5 * q(i).cross(q(i + 1)).z;
    }
    assert!((sum - area).abs() < 1e-5 * area);
    assert_eq!(blob.contains_in_plane(center, &Plane::XY, 1e-9).unwrap(), Containment::Inside);
    assert_eq!(blob.contains_in_plane(p(6.0, 6.0, 0.0), &Plane::XY, 1e-9).unwrap(), Containment::Outside);
    assert!(wave().area_and_centroid(1e-6).is_err());
    assert!(wave().contains_in_plane(center, &Plane::XY, 1e-6).is_err());
    let hexagon: Curve = regular_polygon(&Plane::XY, 2.0, 6).unwrap().into();
    close(hexagon.length(), 12.0, 1e-14, "hexagon");
    close(hexagon.area_and_centroid(1e-6).unwrap().0, 6.0 * 3f64.sqrt(), 1e-14, "hexagon");
    assert!(regular_polygon(&Plane::XY, 2.0, 2).is_err() && regular_polygon(&Plane::XY, 0.0, 5).is_err());
}

#[test]
fn areas_grow_with_the_determinant() {
    let blob: Curve = NurbsCurve::periodic_uniform(
        3,
        &[p(0.0, 0.0, 0.0), p(6.0, 0.0, 0.0), p(2.0, 2.0, 0.0), p(0.0, 6.0, 0.0)],
    )
    .unwrap()
    .into();
    let far = Xform::translation(Vector3::new(1e5, -1e5, 0.0));
    let shear = Xform::shear(&Plane::XY, [[0.4, 0.0], [-0.3, 0.0], [0.0, 0.0]]);
    for c in [blob, circle(2.0), polyline(&[(0.0, 0.0), (3.0, 1.0), (1.0, 4.0), (0.0, 0.0)])] {
        let (area, center) = c.area_and_centroid(1e-6).unwrap();
        for xform in [far, shear, far * shear] {
            let (image, image_center) = c.transformed(&xform).unwrap().area_and_centroid(1e-6).unwrap();
            close(image, area * xform.determinant(), 1e-8, "area");
            close_points(image_center, xform.point(center), 1e-9, "centroid");
        }
        let (signed, _) = c.signed_area_in(&Plane::XY);
        close(c.reversed().signed_area_in(&Plane::XY).0, -signed, 1e-12, "reversal changes the sign");
    }
}

#[test]
fn offsets() {
    let square = polyline(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (0.0, 0.0)]);
    let grown = square.offset_in_plane(&Plane::XY, 1.0).unwrap();
    close(grown.area_and_centroid(1e-6).unwrap().0, 30.0, 1e-14, "counter-clockwise grows");
    assert_eq!(grown.start(), p(-1.0, -1.0, 0.0));
    assert_eq!(grown.domain(), square.domain());
    let shrunk = square.reversed().offset_in_plane(&Plane::XY, 1.0).unwrap();
    close(shrunk.area_and_centroid(1e-6).unwrap().0, 2.0, 1e-14, "clockwise shrinks");
    let open = polyline(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0)])
        .offset_in_plane(&Plane::XY, -0.5)
        .unwrap();
    assert_eq!(
        open.as_polyline().unwrap(),
        [p(0.0, 0.5, 0.0), p(1.0, 0.5, 0.0), p(1.5, 0.5, 0.0), p(1.5, 2.0, 0.0)]
    );
    close(circle(2.0).offset_in_plane(&Plane::XY, 0.5).unwrap().length(), 5.0 * PI, 1e-14, "circle grows");
    assert!(circle(2.0).offset_in_plane(&Plane::XY, -2.0).is_err());
    assert!(circle(2.0).offset_in_plane(&Plane::YZ, 1.0).is_err());
    let l = line(p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)).offset_in_plane(&Plane::XY, 2.0).unwrap();
    assert_eq!(l.start(), p(0.0, -2.0, 0.0));
    let smooth: Curve = PolyCurve::new(vec![
        line(p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0)),
        Arc::from_start_direction_end(p(4.0, 0.0, 0.0), Vector3::X, p(6.0, 2.0, 0.0)).unwrap().into(),
    ])
    .unwrap()
    .into();
    close(smooth.offset_in_plane(&Plane::XY, 1.0).unwrap().length(), 4.0 + 1.5 * PI, 1e-14, "line and arc");
    assert!(wave().offset_in_plane(&Plane::XY, 1.0).is_err(), "not planar");
}

#[test]
fn sections_with_a_plane() {
    let c = wave();
    let cut = Plane::from_normal(p(3.3, 0.0, 0.0), Vector3::Y).unwrap();
    let ts = c.intersect_plane(&cut, 1e-9).unwrap();
    let n = 20_000;
    let side = |i: i32| c.point_at(c.domain().at(f64::from(i) / f64::from(n))).y > 0.0;
    // The curve starts on the plane: that end is one more.
    let crossings = (1..n).filter(|&i| side(i) != side(i + 1)).count();
    assert_eq!(ts.len(), crossings + 1, "{ts:?}");
    assert!(ts.windows(2).all(|w| w[0] < w[1]));
    for t in &ts {
        assert!(c.point_at(*t).y.abs() < 1e-9);
    }
    let disc = circle(2.0);
    assert_eq!(disc.intersect_plane(&Plane::YZ, 1e-9).unwrap().len(), 2);
    let touching = disc.intersect_plane(&Plane::YZ.with_origin(p(0.0, 2.0, 0.0)).rotated(0.0), 1e-9).unwrap();
    assert_eq!(touching.len(), 2);
    let tangent = Plane::from_normal(p(0.0, 2.0, 0.0), Vector3::Y).unwrap();
    let touch = disc.intersect_plane(&tangent, 1e-9).unwrap();
    assert_eq!(touch.len(), 1, "{touch:?}");
    close_points(disc.point_at(touch[0]), p(0.0, 2.0, 0.0), 1e-6, "touch");
    assert!(
        disc.intersect_plane(&Plane::from_normal(p(0.0, 2.1, 0.0), Vector3::Y).unwrap(), 1e-9)
            .unwrap()
            .is_empty()
    );
    let bent = polyline(&[(0.0, 1.0), (1.0, 0.0), (3.0, 0.0), (4.0, -1.0)]);
    assert_eq!(bent.intersect_plane(&Plane::XZ, 1e-9).unwrap(), vec![1.0, 2.0]);
    let through = polyline(&[(0.0, 1.0), (1.0, 0.0), (2.0, -1.0)]);
    assert_eq!(through.intersect_plane(&Plane::XZ, 1e-9).unwrap(), vec![1.0]);
    assert!(disc.intersect_plane(&Plane::XY, f64::NAN).is_err());
}

#[test]
fn degenerate_curves_are_refused() {
    assert!(PolylineCurve::new(vec![p(0.0, 0.0, 0.0)]).is_err());
    assert!(PolylineCurve::new(vec![p(0.0, 0.0, 0.0), p(f64::NAN, 0.0, 0.0)]).is_err());
    assert!(
        PolylineCurve::with_parameters(vec![p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)], vec![1.0, 1.0]).is_err()
    );
    assert!(PolyCurve::new(vec![]).is_err());
    let mut deep = circle(1.0);
    for _ in 0..32 {
        deep = PolyCurve::new(vec![deep]).unwrap().into();
    }
    assert!(PolyCurve::new(vec![deep]).is_err());
    let zero = line(p(1.0, 1.0, 1.0), p(1.0, 1.0, 1.0));
    assert_eq!((zero.length(), zero.tangent_at(0.5)), (0.0, None));
    close(zero.closest_point(p(1.0, 1.0, 3.0)).unwrap().distance, 2.0, 1e-15, "zero-length line");
    assert!(zero.to_nurbs().is_ok() && !zero.reversed().is_linear(1e-9));
}
