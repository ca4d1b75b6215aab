//! Faces cut along curves: areas by formula, and as many pieces as Euler's formula has.

use std::f64::consts::PI;

use katydid_geometry::{
    Arc, Brep, Circle, Curve, Cylinder, Interval, Line, Plane, PlaneSurface, Point3, Sphere, Tolerance,
    Vector3, construct,
};
use proptest::prelude::*;

fn tolerance() -> Tolerance {
    Tolerance::default()
}

fn p(x: f64, y: f64) -> Point3 {
    Point3::new(x, y, 0.0)
}

fn line(a: Point3, b: Point3) -> Curve {
    Line::new(a, b).into()
}

fn circle(x: f64, y: f64, radius: f64) -> Curve {
    Circle::new(Plane::XY.with_origin(p(x, y)), radius).unwrap().into()
}

/// A square of 4 by 4 around the origin.
fn square() -> Brep {
    let side = Interval::new(-2.0, 2.0);
    Brep::from_surface(PlaneSurface::new(Plane::XY, side, side).unwrap().into()).unwrap()
}

/// A ring with radii 2 and 1.
fn ring() -> Brep {
    let rings = [circle(0.0, 0.0, 2.0), circle(0.0, 0.0, 1.0)];
    Brep::planar_faces(&rings, &tolerance()).unwrap().breps.remove(0)
}

/// The areas of the pieces, increasing; every piece is valid and of one face.
fn areas(brep: &Brep, face: usize, curves: &[Curve]) -> Vec<f64> {
    let pieces = brep.face_split(face, curves, &tolerance()).unwrap();
    let mut out: Vec<f64> = (pieces.iter())
        .map(|piece| {
            assert_eq!(piece.faults(), []);
            assert_eq!(piece.faces().len(), 1);
            piece.area_properties(1e-10, || true).unwrap().amount
        })
        .collect();
    out.sort_by(f64::total_cmp);
    out
}

fn check(found: &[f64], wanted: &[f64], within: f64) {
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (a, b) in found.iter().zip(wanted) {
        assert!((a - b).abs() <= within * b, "{found:?} for {wanted:?}");
    }
}

#[test]
fn closed_and_open_curves_cut_together() {
    let cuts = [circle(0.0, 0.0, 1.0), line(p(-3.0, -3.0), p(3.0, 3.0))];
    check(&areas(&square(), 0, &cuts), &[PI / 2.0, PI / 2.0, 8.0 - PI / 2.0, 8.0 - PI / 2.0], 1e-9);
    // One closed curve in another, and one that touches the border in a point.
    let nested = [circle(0.0, 0.0, 1.5), circle(0.2, 0.0, 0.5), circle(0.0, 1.75, 0.25)];
    let wanted = [PI / 16.0, PI / 4.0, 2.0 * PI, 16.0 - PI * (2.25 + 1.0 / 16.0)];
    check(&areas(&square(), 0, &nested), &wanted, 1e-9);
}

#[test]
fn what_separates_nothing_leaves_no_trace() {
    let whole = square();
    for cuts in [
        vec![],
        vec![line(p(-1.0, 0.0), p(1.0, 0.0))],
        vec![line(p(-3.0, 0.0), p(1.0, 0.0))],
        vec![line(p(-1.0, 0.0), p(1.0, 0.0)), line(p(0.0, -1.0), p(0.0, 1.0))],
        vec![line(p(-2.0, -2.0), p(2.0, -2.0))],
        vec![line(p(5.0, 5.0), p(9.0, 5.0)), circle(9.0, 0.0, 1.0)],
    ] {
        let pieces = whole.face_split(0, &cuts, &tolerance()).unwrap();
        let [only] = pieces.as_slice() else { panic!("{} pieces by {cuts:?}", pieces.len()) };
        assert_eq!((only.trims().len(), only.loops().len()), (4, 1), "{cuts:?}");
    }
    // A circle on a stalk: the stalk alone is forgotten.
    let lollipop = [circle(0.0, 0.0, 1.0), line(p(1.0, 0.0), p(2.0, 0.0))];
    check(&areas(&whole, 0, &lollipop), &[PI, 16.0 - PI], 1e-9);
}

#[test]
fn a_ring_is_cut_by_two_cuts_and_not_by_one() {
    let one = ring().face_split(0, &[line(p(0.5, 0.0), p(3.0, 0.0))], &tolerance()).unwrap();
    assert_eq!((one.len(), one[0].loops().len()), (1, 2));
    check(&areas(&ring(), 0, &[line(p(-3.0, 0.0), p(3.0, 0.0))]), &[1.5 * PI, 1.5 * PI], 1e-9);
    let quarter = [line(p(0.5, 0.0), p(3.0, 0.0)), line(p(0.0, 0.5), p(0.0, 3.0))];
    check(&areas(&ring(), 0, &quarter), &[0.75 * PI, 2.25 * PI], 1e-9);
}

#[test]
fn a_curve_may_end_on_another() {
    let tee = [line(p(-2.0, 0.0), p(2.0, 0.0)), line(p(0.0, 0.0), p(0.0, 3.0))];
    check(&areas(&square(), 0, &tee), &[4.0, 4.0, 8.0], 1e-12);
    // Not quite there, but within the tolerance.
    let almost = [line(p(-1.9998, 0.0), p(1.9998, 0.0)), line(p(0.0, 0.0002), p(0.0, 1.9998))];
    check(&areas(&square(), 0, &almost), &[4.0, 4.0, 8.0], 1e-3);
}

#[test]
fn surfaces_that_close_are_cut_over_their_seams() {
    let tube = Cylinder::new(Plane::XY, 1.0, Interval::new(0.0, 4.0)).unwrap();
    let tube = construct::cylinder(&tube, [false; 2]).unwrap();
    let around = |height: f64| -> Curve {
        let plane = Plane::XY.with_origin(Point3::new(0.0, 0.0, height));
        Circle::new(plane, 1.0).unwrap().into()
    };
    check(&areas(&tube, 0, &[around(1.0), around(2.0)]), &[2.0 * PI, 2.0 * PI, 4.0 * PI], 1e-9);
    // A circle that begins elsewhere than the seam of the surface.
    let turned = around(1.0).with_seam(1.0).unwrap();
    check(&areas(&tube, 0, &[turned]), &[2.0 * PI, 6.0 * PI], 1e-6);
    // A window over the seam.
    let lens: Vec<Curve> = [0.5_f64, -0.5]
        .windows(2)
        .flat_map(|w| {
            let at = |angle: f64, z: f64| Point3::new(angle.cos(), angle.sin(), z);
            let arc =
                |z: f64| -> Curve { Arc::through(at(w[1], z), at(0.0, z), at(w[0], z)).unwrap().into() };
            let side = |angle: f64| line(at(angle, 1.0), at(angle, 3.0));
            [arc(1.0), arc(3.0), side(w[0]), side(w[1])]
        })
        .collect();
    check(&areas(&tube, 0, &lens), &[1.0, 1.0, 8.0 * PI - 2.0], 1e-4);
    let ball = construct::sphere(&Sphere::new(Plane::XY, 1.0).unwrap()).unwrap();
    check(&areas(&ball, 0, &[around(0.0)]), &[2.0 * PI, 2.0 * PI], 1e-9);
}

#[test]
fn a_grid_of_lines() {
    let at = |k: i32| -2.0 + 4.0 * f64::from(k) / 16.0;
    let lines: Vec<Curve> = (1..16)
        .flat_map(|k| [line(p(at(k), -9.0), p(at(k), 9.0)), line(p(-9.0, at(k)), p(9.0, at(k)))])
        .collect();
    check(&areas(&square(), 0, &lines), &[1.0 / 16.0; 256], 1e-9);
}

#[test]
fn curves_that_cannot_be_followed_are_refused() {
    assert!(square().face_split(1, &[], &tolerance()).is_err());
    let wild = line(p(f64::NAN, 0.0), p(1.0, 0.0));
    assert!(square().face_split(0, &[wild], &tolerance()).is_err());
    let flat = Tolerance { absolute: 0.0, ..tolerance() };
    assert!(square().face_split(0, &[], &flat).is_err());
    // Onto the middle line of a tube every direction is as near as any other.
    let tube = Cylinder::new(Plane::XY, 1.0, Interval::new(0.0, 4.0)).unwrap();
    let tube = construct::cylinder(&tube, [false; 2]).unwrap();
    let axis = line(Point3::ORIGIN, Point3::ORIGIN + Vector3::Z * 4.0);
    if let Ok(pieces) = tube.face_split(0, &[axis], &tolerance()) {
        assert!(pieces.iter().all(|piece| piece.is_valid()));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    /// Chords in general position: one piece more for each, and one for each crossing inside.
    #[test]
    fn as_many_pieces_as_euler_says(
        chords in prop::collection::vec((0.0..std::f64::consts::TAU, -0.9..0.9), 1..7),
    ) {
        let chords: Vec<[Point3; 2]> = chords
            .into_iter()
            .map(|(angle, away): (f64, f64)| {
                let along = Vector3::new(angle.cos(), angle.sin(), 0.0);
                let middle = Point3::ORIGIN + Vector3::new(-angle.sin(), angle.cos(), 0.0) * away;
                [middle - along * 9.0, middle + along * 9.0]
            })
            .collect();
        let disc = Brep::planar_faces(&[circle(0.0, 0.0, 1.0)], &tolerance()).unwrap().breps.remove(0);
        let mut crossings = Vec::new();
        for (k, a) in chords.iter().enumerate() {
            for b in &chords[..k] {
                let (u, v) = (a[1] - a[0], b[1] - b[0]);
                let across = u.cross(v).z;
                prop_assume!(across.abs() > 0.05 * u.length() * v.length());
                let t = (b[0] - a[0]).cross(v).z / across;
                let point = a[0] + u * t;
                let r = point.distance_to(Point3::ORIGIN);
                prop_assume!((r - 1.0).abs() > 0.02);
                if r < 1.0 {
                    prop_assume!(crossings.iter().all(|q: &Point3| q.distance_to(point) > 0.02));
                    crossings.push(point);
                }
            }
        }
        let lines: Vec<Curve> = chords.iter().map(|[a, b]| line(*a, *b)).collect();
        let found = areas(&disc, 0, &lines);
        prop_assert_eq!(found.len(), 1 + chords.len() + crossings.len());
        prop_assert!((found.iter().sum::<f64>() - PI).abs() < 1e-8);
    }
}
