//! Curves beside surfaces, pulled to them, against closed forms.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

use std::f64::consts::PI;

use katydid_geometry::{
    Brep, Circle, Curve, Cylinder, Interval, Line, NurbsCurve, NurbsSurface, Plane, Point3, Sphere,
    SumSurface, Surface, Tolerance, Vector3,
};

const TOLERANCE: Tolerance = Tolerance { absolute: 0.001, angle: PI / 180.0 };

/// A square of side 4 in the xy plane that does not know that it is flat.
fn patch() -> Surface {
    let p = |x: f64, y: f64| Point3::new(x, y, 0.0);
    NurbsSurface::clamped_uniform([1, 1], [2, 2], &[p(0.0, 0.0), p(0.0, 4.0), p(4.0, 0.0), p(4.0, 4.0)])
        .unwrap()
        .into()
}

fn circle(x: f64, y: f64, z: f64, radius: f64) -> Curve {
    Circle::new(Plane::XY.with_origin(Point3::new(x, y, z)), radius).unwrap().into()
}

fn area(brep: &Brep) -> f64 {
    brep.area_properties(1e-9, || true).unwrap().amount
}

#[test]
fn what_lies_beyond_a_side_runs_straight_along_it() {
    // The whole circle, half of it, a quarter at a corner, and nothing.
    for (x, y, wanted) in [(2.0, 2.0, PI), (0.0, 2.0, 0.5 * PI), (4.0, 4.0, 0.25 * PI), (-1.5, 2.0, 0.0)] {
        let found = Brep::trimmed_surface(&patch(), &[circle(x, y, 0.7, 1.0)], &TOLERANCE).unwrap();
        let sum: f64 = found.iter().map(area).sum();
        assert!((sum - wanted).abs() < 0.005, "{sum} {wanted}");
        for brep in &found {
            assert!(brep.is_valid());
            assert!(brep.edges().len() <= 8, "{}", brep.edges().len());
        }
    }
}

#[test]
fn a_hole_beyond_a_side_takes_nothing_away() {
    let whole = Brep::from_surface(patch()).unwrap();
    let left = whole.face_with_holes(0, &[circle(-1.5, 2.0, 0.0, 1.0)], &TOLERANCE).unwrap();
    assert!((left.iter().map(area).sum::<f64>() - 16.0).abs() < 1e-9);
}

#[test]
fn a_winding_curve_beyond_a_side_is_no_work() {
    // It goes up and down beside the patch a thousand times.
    let points: Vec<Point3> = (0..2000)
        .map(|k| {
            let turn = PI * k as f64 / 7.3;
            Point3::new(-1.0 - 0.3 * turn.cos(), 2.0 + turn.sin(), 0.1 * (3.0 * turn).cos())
        })
        .collect();
    let wound: Curve = NurbsCurve::clamped_uniform(3, &points).unwrap().into();
    let back: Curve = Line::new(wound.end(), wound.start()).into();
    let begun = std::time::Instant::now();
    let found = Brep::trimmed_surface(&patch(), &[wound, back], &TOLERANCE).unwrap();
    assert_eq!(found.len(), 0);
    assert!(begun.elapsed().as_secs() < 20, "{:?}", begun.elapsed());
}

/// Far from the surface the derivative of the foot is not that of the point: with the right one few spans do.
#[test]
fn curves_far_from_a_surface_are_pulled_in_few_spans() {
    let ball: Surface = Sphere::new(Plane::XY, 1.0).unwrap().into();
    let tube: Surface = Cylinder::new(Plane::XY, 1.0, Interval::new(-5.0, 5.0)).unwrap().into();
    let place = Plane::from_normal(Point3::new(6.0, 1.0, 1.0), Vector3::new(1.0, 0.3, 0.2)).unwrap();
    let ring: Curve = Circle::new(place, 2.0).unwrap().into();
    for surface in [ball, tube] {
        let flat = surface.parameter_curve(&ring, &TOLERANCE).unwrap();
        for k in 0..=64 {
            let x = f64::from(k) / 64.0;
            let p = ring.point_at(ring.domain().at(x));
            let uv = flat.point_at(flat.domain().at(x));
            let exact = surface.closest_point(p).unwrap().point;
            assert!(surface.point_at(uv.x, uv.y).distance_to(exact) < 0.0011);
        }
        let count = flat.to_nurbs().unwrap().control_points().len();
        assert!(count < 60, "{count}");
    }
}

/// The nearest point of a large surface, found by distances alone, is off by more than the tolerance.
#[test]
fn curves_on_large_surfaces_are_pulled_within_the_tolerance() {
    let radius = 3e6;
    let ball: Surface = Sphere::new(Plane::XY, radius).unwrap().into();
    let place = Plane::from_normal(Point3::ORIGIN, Vector3::new(1.0, 0.3, 0.2)).unwrap();
    let around = place.with_origin(Point3::ORIGIN + place.z_axis * (0.8 * radius));
    let ring: Curve = Circle::new(around, 0.6 * radius).unwrap().into();
    let flat = ball.parameter_curve(&ring, &TOLERANCE).unwrap();
    for k in 0..=100 {
        let x = f64::from(k) / 100.0;
        let uv = flat.point_at(flat.domain().at(x));
        let miss = ball.point_at(uv.x, uv.y).distance_to(ring.point_at(ring.domain().at(x)));
        assert!(miss < 0.0012, "{miss}");
    }
    let count = flat.to_nurbs().unwrap().control_points().len();
    assert!(count < 2500, "{count}");
}

/// In the first span of a NURBS curve parameters differ sooner: the flag of a trim that is nearly an isocurve follows
/// that of openNURBS, also on surfaces made of curves.
#[test]
fn isocurves_of_sums_are_told_by_the_spans_of_their_curves() {
    let profile = NurbsCurve::clamped_uniform(
        3,
        &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].map(|x: f64| Point3::new(x, 0.0, (0.8 * x).sin())),
    )
    .unwrap();
    let domain = profile.domain();
    let wall: Surface = SumSurface::new(
        profile.clone().into(),
        Line::new(Point3::ORIGIN, Point3::new(0.0, 5.0, 0.0)).into(),
        Vector3::ZERO,
    )
    .unwrap()
    .into();
    let nurbs: Surface = wall.to_nurbs().unwrap().into();
    // Wider than a span's share, narrower than the whole domain's.
    let wide = domain.length() * 1e-7;
    for surface in [&wall, &nurbs] {
        for (x, iso) in [(0.1, false), (0.5, true), (0.9, false)] {
            let u = domain.at(x);
            let v = surface.domain(katydid_geometry::Direction::V);
            let at = |du: f64, share: f64| Point3::new(u + du, v.at(share), 0.0);
            let slanted: Curve =
                NurbsCurve::clamped_uniform(2, &[at(0.0, 0.2), at(wide, 0.5), at(wide, 0.8)]).unwrap().into();
            let wide_end: Curve = katydid_geometry::PolylineCurve::new(vec![
                at(wide, 0.8),
                Point3::new(u + 0.5, v.at(0.8), 0.0),
                Point3::new(u + 0.5, v.at(0.2), 0.0),
                at(0.0, 0.2),
            ])
            .unwrap()
            .into();
            let loop_curve = katydid_geometry::join_curves(&[slanted, wide_end], 1e-9, false);
            let found = Brep::from_parameter_loops(surface, &loop_curve, &TOLERANCE).unwrap();
            assert!(found[0].is_valid());
            let told = found[0].trims().iter().any(|t| {
                t.iso == katydid_geometry::brep::Iso::InnerU
                    && t.part.curve.is_some_and(|c| {
                        matches!(found[0].parts().curves_2d.get(c), Some(Some(Curve::Nurbs(_))))
                    })
            });
            assert_eq!(told, iso, "{x}");
        }
    }
}
