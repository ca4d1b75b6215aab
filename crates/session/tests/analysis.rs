//! Analyses of curves and surfaces, against closed forms.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test may fail loudly"
)]

mod reader;

use katydid_data::cast::Rules;
use katydid_data::{Column, Path, Tree, Value};
use katydid_definition::document::{Object, ids};
use katydid_geometry::{
    Circle, Curve, Ellipse, KnotSpacing, Line, NurbsCurve, NurbsSurface, Plane, Point3, PolyCurve, Sphere,
    Surface, Vector3,
};
use katydid_session::analysis::{Measured, Subjects, encode, measure, probe};
use katydid_session::display::{Geometry, Shown};
use katydid_session::protocol::{
    AnalysisView, BendView, CombView, IsocurvesView, PartKind, Probe, ProbePlace, Probed,
};
use reader::Read;
use uuid::Uuid;

const OBJECT: Uuid = Uuid::from_u128(7);

fn subjects(values: impl IntoIterator<Item = Value>) -> Subjects {
    let object = Object::new_parameter(ids::GEOMETRY, "Geometry", "Geo", OBJECT);
    let column = Column::of_values(values.into_iter().collect(), None);
    let outputs = [Tree::branch_at(Path::from([0, 3].as_slice()), column)];
    Subjects::of(&Shown { object: &object, outputs: &outputs, inputs: &[] }, &Rules::default())
}

fn curve(curve: impl Into<Curve>) -> Value {
    Value::Curve(std::sync::Arc::new(curve.into()))
}

fn surface(surface: impl Into<Surface>) -> Value {
    Value::Surface(std::sync::Arc::new(surface.into()))
}

fn comb(teeth: u32) -> AnalysisView {
    AnalysisView { comb: Some(CombView { teeth, length: 0.2, surfaces: false }), ..AnalysisView::default() }
}

fn look(subjects: &Subjects, view: &AnalysisView, is_draft: bool) -> (Measured, Option<Geometry>) {
    let measured = measure(&[subjects], view, is_draft, None);
    let mut all = encode(&[(OBJECT, subjects)], view, &measured.measure, || true);
    (measured, all.pop().unwrap().1)
}

fn ask(subjects: &Subjects, index: u32, at: ProbePlace) -> Option<Probed> {
    probe(subjects, &Probe { object: OBJECT, output: 0, path: "{0;3}".to_owned(), index, at })
}

fn near(x: f64, y: f64, z: f64) -> ProbePlace {
    ProbePlace::Near { point: [x, y, z] }
}

#[test]
fn the_comb_of_a_circle_is_a_ring() {
    let circle = subjects([curve(Circle::new(Plane::XY, 2.0).unwrap())]);
    let (measured, geometry) = look(&circle, &comb(8), false);
    let about = measured.comb.unwrap();
    assert!((about.sharpest - 0.5).abs() < 1e-12, "1/radius");
    // Wanted are 0.2 of the diagonal of the square around it over the curvature: 2.26, and 2 is the step below.
    assert!((about.scale - 2.0).abs() < 1e-12);
    let read = Read::new(&geometry.unwrap());
    let parts: Vec<_> = read.header.parts.iter().filter(|part| part.kind == PartKind::Comb).collect();
    assert_eq!(parts.len(), 2, "teeth and the line over them");
    let [teeth, tips] = [&parts[0], &parts[1]].map(|part| read.drawn(part, 2));
    assert_eq!(teeth.len(), 4 * 8 + 1);
    for tooth in &teeth {
        let [foot, tip] = [0, 1].map(|k| tooth[k].distance_to(Point3::ORIGIN));
        assert!((foot - 2.0).abs() < 1e-6 && (tip - 3.0).abs() < 1e-6, "0.5 × 2 long, outwards");
    }
    assert_eq!(tips.len(), 4 * 8 * 4);
    assert!(tips.iter().flatten().all(|tip| (tip.distance_to(Point3::ORIGIN) - 3.0).abs() < 1e-6));
}

#[test]
fn a_comb_shows_where_curvature_jumps_and_its_sharpest_place() {
    let arc = katydid_geometry::Arc::from_start_direction_end(
        Point3::new(4.0, 0.0, 0.0),
        Vector3::X,
        Point3::new(6.0, 2.0, 0.0),
    );
    let line = Line::new(Point3::ORIGIN, Point3::new(4.0, 0.0, 0.0));
    let joined = subjects([curve(PolyCurve::new(vec![line.into(), arc.unwrap().into()]).unwrap())]);
    let (_, geometry) = look(&joined, &comb(4), false);
    let read = Read::new(&geometry.unwrap());
    let teeth = read.drawn(&read.header.parts[0], 2);
    assert_eq!(teeth.len(), 5, "the line has none, the joint has that of the arc");
    assert_eq!(teeth[0][0], Point3::new(4.0, 0.0, 0.0));
    assert!(teeth[0][1].y < -0.1);

    // The sharpest places of an ellipse are the ends of its long axis, where the curvature is a/b².
    let ellipse = Ellipse::new(Plane::XY, 5.0, 2.0).unwrap();
    let (measured, _) = look(&subjects([curve(ellipse.to_nurbs().unwrap())]), &comb(5), false);
    let about = measured.comb.unwrap();
    assert!((about.sharpest - 5.0 / 4.0).abs() < 1e-9, "{}", about.sharpest);
    assert!((about.at[0].abs() - 5.0).abs() < 1e-6);
}

#[test]
fn while_something_is_dragged_combs_are_coarse_and_keep_their_scale() {
    let at = |radius: f64| subjects([curve(Circle::new(Plane::XY, radius).unwrap())]);
    let (fine, geometry) = look(&at(2.0), &comb(10), false);
    let dragged = measure(&[&at(0.3)], &comb(10), true, fine.comb.map(|comb| comb.scale));
    assert_eq!(dragged.comb.unwrap().scale, fine.comb.unwrap().scale);
    let coarse =
        encode(&[(OBJECT, &at(2.0))], &comb(10), &dragged.measure, || true).pop().unwrap().1.unwrap();
    assert!(coarse.is_draft && coarse.bytes.len() < geometry.unwrap().bytes.len());
    assert!(encode(&[(OBJECT, &at(2.0))], &comb(10), &dragged.measure, || false).is_empty(), "cancelled");
}

#[test]
fn what_does_not_bend_has_no_comb() {
    let none = subjects([
        curve(Line::new(Point3::ORIGIN, Point3::new(1.0, 2.0, 3.0))),
        Value::Point(Point3::ORIGIN),
        Value::Number(3.0),
    ]);
    let (measured, geometry) = look(&none, &comb(10), false);
    assert!(measured.comb.is_none() && geometry.is_none());
    let (_, geometry) = look(&Subjects::default(), &AnalysisView { controls: true, ..comb(3) }, false);
    assert!(geometry.is_none());
}

#[test]
fn more_than_can_be_seen_is_thinned_out_and_said() {
    let points: Vec<Point3> =
        (0..30_000).map(|k| Point3::new(f64::from(k), (f64::from(k) * 0.7).sin(), 0.0)).collect();
    let long = NurbsCurve::clamped_uniform(3, &points).unwrap();
    let all = subjects([curve(long)]);
    let view = AnalysisView { controls: true, circles: 5_000, ..comb(50) };
    let (measured, geometry) = look(&all, &view, false);
    assert!(measured.left_out.iter().any(|text| text.contains("combs")), "{:?}", measured.left_out);
    assert!(measured.left_out.iter().any(|text| text.contains("circles")));
    assert!(geometry.unwrap().bytes.len() < 8 << 20);
}

#[test]
fn circles_touch_their_curve() {
    let points = [[0.0, 0.0, 0.0], [3.0, 4.0, 1.0], [6.0, -2.0, 0.0], [9.0, 1.0, 2.0]].map(Point3::from);
    let spline: Curve = NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).unwrap().into();
    let view = AnalysisView { circles: 7, ..AnalysisView::default() };
    let (_, geometry) = look(&subjects([curve(spline.clone())]), &view, false);
    let read = Read::new(&geometry.unwrap());
    let segments = read.drawn(read.part(PartKind::Circles), 2);
    let circles: Vec<_> = segments.chunks(72).collect();
    assert!(circles.len() <= 7 && circles.len() >= 5);
    for circle in circles {
        let touch = circle[0][0];
        let place = spline.closest_point(touch).unwrap();
        assert!(place.distance < 1e-5);
        let middle = circle.iter().fold(Vector3::ZERO, |sum, line| sum + line[0].to_vector()) / 72.0;
        let radius = touch.distance_to(middle.to_point());
        let expected = 1.0 / spline.curvature_at(place.parameter).length();
        assert!((radius / expected - 1.0).abs() < 1e-3, "{radius} {expected}");
    }
}

#[test]
fn control_polygons_have_their_points_degrees_and_weights() {
    let points = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, 1.0, 0.0], [4.0, 0.0, 0.0]].map(Point3::from);
    let weighted =
        NurbsCurve::with_weights(3, &points, &[1.0, 0.5, 1.0, 1.0], vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0])
            .unwrap();
    let view = AnalysisView { controls: true, ..AnalysisView::default() };
    let (_, geometry) = look(&subjects([curve(weighted)]), &view, false);
    let read = Read::new(&geometry.unwrap());
    assert_eq!(read.points(read.part(PartKind::ControlPoints)), points);
    let hull: Vec<_> = points.windows(2).map(<[Point3]>::to_vec).collect();
    assert_eq!(read.drawn(read.part(PartKind::Hull), 2), hull);
    assert_eq!(read.part(PartKind::Texts).texts, ["p = 3", "w = 0.5"]);
    let grid: Vec<Point3> =
        (0..12).map(|k| Point3::new(f64::from(k / 3), f64::from(k % 3), f64::from(k % 2))).collect();
    let net = NurbsSurface::clamped_uniform([3, 2], [4, 3], &grid).unwrap();
    let (_, geometry) = look(&subjects([surface(net)]), &view, false);
    let read = Read::new(&geometry.unwrap());
    assert_eq!(read.points(read.part(PartKind::ControlPoints)).len(), 12);
    assert_eq!(read.drawn(read.part(PartKind::Hull), 2).len(), 4 * 2 + 3 * 3);
    assert_eq!(read.part(PartKind::Texts).texts, ["p = 3 × 2"]);
}

#[test]
fn isocurves_are_as_dense_as_asked_and_lie_on_the_surface() {
    let grid: Vec<Point3> =
        (0..16).map(|k| Point3::new(f64::from(k / 4), f64::from(k % 4), f64::from((k * 7) % 5))).collect();
    let patch = NurbsSurface::clamped_uniform([3, 3], [4, 4], &grid).unwrap();
    let all = subjects([surface(patch.clone())]);
    for (between, directions, lines) in [(3, false, 6), (0, false, 0), (2, true, 2 * 4), (0, true, 4)] {
        let isocurves = Some(IsocurvesView { between, directions });
        let (_, geometry) = look(&all, &AnalysisView { isocurves, ..AnalysisView::default() }, false);
        let Some(geometry) = geometry else {
            assert_eq!(lines, 0);
            continue;
        };
        let read = Read::new(&geometry);
        let mut runs = 0;
        for part in &read.header.parts {
            assert_eq!(part.colour.is_some(), directions);
            let segments = read.drawn(part, 2);
            runs += 1 + segments.windows(2).filter(|pair| pair[0][1] != pair[1][0]).count();
            for point in segments.iter().flatten() {
                assert!(patch.closest_point(*point).unwrap().distance < 1e-5);
            }
        }
        assert_eq!(runs, lines, "{between} {directions}");
    }
    // A comb along an isocurve of a surface is the comb of that curve.
    let view = AnalysisView {
        comb: Some(CombView { teeth: 4, length: 0.2, surfaces: true }),
        isocurves: Some(IsocurvesView { between: 1, directions: false }),
        ..AnalysisView::default()
    };
    let (measured, geometry) = look(&all, &view, false);
    assert!(measured.comb.is_some() && geometry.is_some());
}

#[test]
fn places_of_curves_are_answered_exactly() {
    let far = Point3::new(1e6, -2e6, 3.0);
    let circle = Circle::new(Plane::XY.with_origin(far), 2.5).unwrap();
    let all = subjects([curve(Line::new(Point3::ORIGIN, Point3::new(9.0, 0.0, 0.0))), curve(circle)]);
    let found = ask(&all, 1, near(far.x + 7.0, far.y + 7.0, far.z + 1.0)).unwrap();
    let BendView::Curve { tangent: Some(_), curvature, circle: Some(seen) } = &found.bend else {
        panic!("{found:?}")
    };
    assert!((curvature - 0.4).abs() < 1e-12 && (seen.radius - 2.5).abs() < 1e-10);
    assert!(Point3::from(seen.centre).distance_to(far) < 1e-8);
    let again = ask(&all, 1, ProbePlace::Parameter { member: 0, parameter: found.parameter.clone() });
    assert_eq!(again, Some(found));
    let straight = ask(&all, 0, near(4.0, 1.0, 0.0)).unwrap();
    assert!(matches!(straight.bend, BendView::Curve { curvature: 0.0, circle: None, .. }));
    assert_eq!(straight.point, [4.0, 0.0, 0.0]);
    for at in [
        near(f64::NAN, 0.0, 0.0),
        ProbePlace::Parameter { member: 3, parameter: vec![0.5] },
        ProbePlace::Parameter { member: 0, parameter: vec![] },
        ProbePlace::Parameter { member: 0, parameter: vec![f64::INFINITY] },
        ProbePlace::Parameter { member: 0, parameter: vec![0.1, 0.2] },
    ] {
        assert_eq!(ask(&all, 1, at.clone()), None, "{at:?}");
    }
    assert_eq!(ask(&all, 9, near(0.0, 0.0, 0.0)), None);
}

#[test]
fn places_of_surfaces_are_answered_exactly() {
    let all = subjects([surface(Sphere::around(Point3::new(1.0, 2.0, 3.0), 4.0).unwrap())]);
    let found = ask(&all, 0, near(9.0, 5.0, 4.0)).unwrap();
    let BendView::Surface { principal, gaussian, mean, circles, .. } = &found.bend else {
        panic!("{found:?}")
    };
    assert!((gaussian - 1.0 / 16.0).abs() < 1e-9 && (mean.abs() - 0.25).abs() < 1e-9);
    assert!(principal.iter().all(|k| (k.abs() - 0.25).abs() < 1e-6));
    for circle in circles {
        let circle = circle.unwrap();
        assert!(Point3::from(circle.centre).distance_to(Point3::new(1.0, 2.0, 3.0)) < 1e-5);
        let touch =
            Point3::from(circle.centre) + Vector3::new(circle.x[0], circle.x[1], circle.x[2]) * circle.radius;
        assert!(touch.distance_to(Point3::from(found.point)) < 1e-9);
    }
}
