#![allow(clippy::unwrap_used, reason = "a failing test may panic")]

use std::f64::consts::PI;

use super::Made;
use crate::{BoundingBox, Box3, Brep, Interval, Plane, Point3, Sphere, Tolerance, construct};

fn cuboid(min: [f64; 3], max: [f64; 3]) -> Brep {
    let bounds = BoundingBox { min: Point3::from(min), max: Point3::from(max) };
    construct::box_brep(&Box3::from(bounds)).unwrap()
}

fn tube(center: [f64; 3], radius: f64, height: f64) -> Brep {
    let plane = Plane::XY.with_origin(Point3::from(center));
    let shape = crate::Cylinder::new(plane, radius, Interval::new(0.0, height)).unwrap();
    construct::cylinder(&shape, [true; 2]).unwrap()
}

fn ball(center: [f64; 3], radius: f64) -> Brep {
    construct::sphere(&Sphere::around(Point3::from(center), radius).unwrap()).unwrap()
}

fn tolerance() -> Tolerance {
    Tolerance { absolute: 1e-6, ..Tolerance::default() }
}

fn volume(made: &[Made]) -> f64 {
    made.iter().map(|m| m.brep.volume_properties(1e-9, || true).unwrap().amount).sum()
}

fn area(made: &[Made]) -> f64 {
    made.iter().map(|m| m.brep.area_properties(1e-9, || true).unwrap().amount).sum()
}

fn all_of(a: &Brep, b: &Brep) -> [f64; 4] {
    let (a, b) = ([a.clone()], [b.clone()]);
    let t = tolerance();
    [
        volume(&Brep::union(&[a[0].clone(), b[0].clone()], &t).unwrap()),
        volume(&Brep::intersection(&a, &b, &t).unwrap()),
        volume(&Brep::difference(&a, &b, &t).unwrap()),
        volume(&Brep::difference(&b, &a, &t).unwrap()),
    ]
}

fn near(found: [f64; 4], want: [f64; 4]) {
    for (f, w) in found.iter().zip(want) {
        assert!((f - w).abs() <= 1e-7 * want[0], "{found:?} {want:?}");
    }
}

#[test]
fn boxes_overlap() {
    let found = all_of(&cuboid([0.0; 3], [2.0; 3]), &cuboid([1.0; 3], [3.0; 3]));
    near(found, [15.0, 1.0, 7.0, 7.0]);
}

#[test]
fn boxes_share_a_face_an_edge_and_a_corner() {
    let a = cuboid([0.0; 3], [1.0; 3]);
    near(all_of(&a, &cuboid([1.0, 0.0, 0.0], [2.0, 1.0, 1.0])), [2.0, 0.0, 1.0, 1.0]);
    near(all_of(&a, &cuboid([1.0, 1.0, 0.0], [2.0, 2.0, 1.0])), [2.0, 0.0, 1.0, 1.0]);
    near(all_of(&a, &cuboid([1.0, 1.0, 1.0], [2.0, 2.0, 2.0])), [2.0, 0.0, 1.0, 1.0]);
    near(all_of(&a, &a), [1.0, 1.0, 0.0, 0.0]);
}

#[test]
fn a_hole_through_a_box() {
    let a = cuboid([-2.0, -2.0, 0.0], [2.0, 2.0, 1.0]);
    let hole = PI;
    near(all_of(&a, &tube([0.0, 0.0, -1.0], 1.0, 3.0)), [16.0 + 2.0 * hole, hole, 16.0 - hole, 2.0 * hole]);
    let cut = Brep::difference(&[a], &[tube([0.0, 0.0, -1.0], 1.0, 3.0)], &tolerance()).unwrap();
    assert_eq!(cut.len(), 1);
    assert_eq!(cut[0].brep.faces().len(), 7);
    assert!((area(&cut) - (48.0 - 2.0 * PI + 2.0 * PI)).abs() < 1e-6);
}

#[test]
fn a_cavity() {
    let cut = Brep::difference(&[cuboid([-2.0; 3], [2.0; 3])], &[ball([0.0; 3], 1.0)], &tolerance()).unwrap();
    assert_eq!(cut.len(), 1);
    assert!((volume(&cut) - (64.0 - 4.0 / 3.0 * PI)).abs() < 1e-6);
    assert_eq!(cut[0].names.iter().filter(|n| n.operand == 1).count(), 1);
}

#[test]
fn balls_overlap() {
    // A lens of two caps of height 1/2 of unit balls: 2·π h² (3 − h)/3.
    let lens = 2.0 * PI * 0.25 * 2.5 / 3.0;
    let ball_volume = 4.0 / 3.0 * PI;
    let want = [2.0 * ball_volume - lens, lens, ball_volume - lens, ball_volume - lens];
    for center in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.6, 0.8, 0.0], [0.48, 0.6, 0.64]] {
        near(all_of(&ball([0.0; 3], 1.0), &ball(center, 1.0)), want);
    }
}

#[test]
fn rings_that_cross_at_right_angles() {
    // Where the tubes cross both surfaces are tangent: four places, into each of which four curves run.
    let ring = |normal: [f64; 3]| {
        let plane = Plane::from_normal(Point3::ORIGIN, normal.into()).unwrap();
        construct::torus(&crate::Torus::new(plane, 100.0, 20.0).unwrap()).unwrap()
    };
    let (a, b) = (ring([0.0, 0.0, 1.0]), ring([0.0, 1.0, 0.0]));
    let t = Tolerance { absolute: 1e-3, ..Tolerance::default() };
    // What is not decided is refused; an answer must keep the identity, and the tubes have something in common.
    match Brep::union(&[a.clone(), b.clone()], &t) {
        Err(crate::Error::Refused(_)) => {}
        Err(other) => panic!("{other}"),
        Ok(made) => {
            let common = volume(&Brep::intersection(&[a], &[b], &t).unwrap());
            let one = 2.0 * PI * PI * 100.0 * 400.0;
            assert!((volume(&made) + common - 2.0 * one).abs() <= 1e-5 * one);
            assert!(common > 0.1 * one);
        }
    }
}

/// The volumes between open and closed breps, the least first.
fn enclosed(breps: &[Brep]) -> Vec<f64> {
    let fuse = super::Fuse::new(breps, &tolerance()).unwrap();
    let mut found: Vec<f64> =
        fuse.volumes().unwrap().iter().map(|(_, made)| volume(std::slice::from_ref(made))).collect();
    found.sort_by(f64::total_cmp);
    found
}

fn is_near(found: &[f64], wanted: &[f64]) -> bool {
    found.len() == wanted.len() && found.iter().zip(wanted).all(|(f, w)| (f - w).abs() <= 1e-6 * w)
}

/// A flat sheet, 8 wide, around a point.
fn sheet(center: [f64; 3], x: [f64; 3], y: [f64; 3]) -> Brep {
    let plane = Plane::from_axes(center.into(), x.into(), y.into()).unwrap();
    let side = Interval::new(-4.0, 4.0);
    Brep::from_surface(crate::PlaneSurface::new(plane, side, side).unwrap().into()).unwrap()
}

#[test]
fn sheets_enclose_a_solid() {
    // A square room of 4 by 4 whose roof is 3 high in the middle and slopes along x.
    let walls = [
        sheet([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        sheet([0.0, 0.0, 3.0], [1.0, 0.0, 0.3], [0.0, 1.0, 0.0]),
        sheet([-2.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
        sheet([2.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
        sheet([0.0, -2.0, 1.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        sheet([0.0, 2.0, 1.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
    ];
    let found = enclosed(&walls);
    assert!(is_near(&found, &[48.0]), "{found:?}");
    assert_eq!(enclosed(&walls[1..]), Vec::<f64>::new());
}

#[test]
fn a_closed_brep_encloses_itself_and_one_within_another_leaves_the_rest() {
    let (large, small) = (cuboid([0.0; 3], [4.0; 3]), cuboid([1.0; 3], [2.0; 3]));
    let found = enclosed(std::slice::from_ref(&large));
    assert!(is_near(&found, &[64.0]), "{found:?}");
    let found = enclosed(&[large.clone(), small]);
    assert!(is_near(&found, &[1.0, 63.0]), "{found:?}");
    let found = enclosed(&[large, sheet([2.0, 2.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])]);
    assert!(is_near(&found, &[16.0, 48.0]), "{found:?}");
}

#[test]
fn a_tube_between_two_sheets() {
    // A cylinder's area times the height of the roof above the middle.
    let plane = Plane::XY.with_origin(Point3::new(0.0, 0.0, -3.0));
    let shape = crate::Cylinder::new(plane, 2.0, Interval::new(0.0, 6.0)).unwrap();
    let tube = construct::cylinder(&shape, [false; 2]).unwrap();
    let low = sheet([0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let high = sheet([0.0, 0.0, 2.0], [1.0, 0.0, 0.3], [0.0, 1.0, 0.0]);
    let found = enclosed(&[tube, low, high]);
    assert!(is_near(&found, &[12.0 * PI]), "{found:?}");
}
