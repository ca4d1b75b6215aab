#![allow(clippy::unwrap_used, reason = "a failing test may panic")]

use std::f64::consts::{FRAC_PI_2, PI};

use super::{DecisionKind, Fuse};
use crate::{
    Arc, BoundingBox, Box3, Brep, Circle, Curve, Cylinder, Interval, Line, Plane, Point3, Sphere, Tolerance,
    Vector3, Xform, construct, join_curves,
};

fn cuboid(min: [f64; 3], max: [f64; 3]) -> Brep {
    let bounds = BoundingBox { min: Point3::from(min), max: Point3::from(max) };
    construct::box_brep(&Box3::from(bounds)).unwrap()
}

fn tube(center: [f64; 3], radius: f64, height: f64) -> Brep {
    let plane = Plane::XY.with_origin(Point3::from(center));
    construct::cylinder(&Cylinder::new(plane, radius, Interval::new(0.0, height)).unwrap(), [true; 2])
        .unwrap()
}

fn disc(center: [f64; 3], radius: f64) -> Brep {
    let rim: Curve = Circle::new(Plane::XY.with_origin(Point3::from(center)), radius).unwrap().into();
    Brep::planar_faces(&[rim], &Tolerance::default()).unwrap().breps.remove(0)
}

fn within(absolute: f64) -> Tolerance {
    Tolerance { absolute, ..Tolerance::default() }
}

fn area(breps: &[Brep]) -> f64 {
    breps.iter().map(|b| b.area_properties(1e-10, || true).unwrap().amount).sum()
}

#[test]
fn a_thin_cylinder_that_touches_a_thick_one_from_inside() {
    // Axes square to each other, 0.5 apart: the common curve crosses itself where the walls touch.
    let thick = tube([0.0; 3], 1.0, 4.0);
    let lying = Xform::rotation(FRAC_PI_2, Vector3::X, Point3::ORIGIN).unwrap();
    let placed = Xform::translation(Vector3::new(0.5, 2.0, 2.0));
    let thin = tube([0.0; 3], 0.5, 4.0).transformed(&lying).unwrap().transformed(&placed).unwrap();
    let t = within(1e-6);
    let [a, b] = [[thick], [thin]];
    let volume = |made: Vec<super::Made>| -> f64 {
        made.iter().map(|m| m.brep.volume_properties(1e-9, || true).unwrap().amount).sum()
    };
    let common = volume(Brep::intersection(&a, &b, &t).unwrap());
    let left = volume(Brep::difference(&a, &b, &t).unwrap());
    // At each y the part of the disc of radius ½ about x = ½ up to x = √(1 − y²).
    let slice = |y: f64| {
        let d = ((1.0 - y * y).sqrt() - 0.5) / 0.5;
        0.25 * (PI - d.acos() + d * (1.0 - d * d).max(0.0).sqrt())
    };
    let count = 400_000;
    let step = 2.0 / f64::from(count);
    let want: f64 = (0..count).map(|k| slice(-1.0 + (f64::from(k) + 0.5) * step) * step).sum();
    assert!((common - want).abs() < 1e-6, "{common} {want}");
    assert!((left - (4.0 * PI - want)).abs() < 1e-6, "{left} {want}");
}

#[test]
fn curves_on_two_operands() {
    // The thin cylinder touches the thick one's wall along 10 units, and its wall cuts the thick one's lid.
    let fuse =
        Fuse::new(&[tube([0.0; 3], 10.0, 20.0), tube([5.0, 0.0, 10.0], 5.0, 20.0)], &within(1e-6)).unwrap();
    let length: f64 = fuse.curves().iter().map(|c| c.curve.length()).sum();
    assert!((length - 10.0 - 10.0 * PI).abs() < 1e-6, "{length}");
    assert!(fuse.curves().iter().all(|c| c.operands == [0, 1]));
}

#[test]
fn what_the_tolerance_decided_is_told() {
    let boxes = |gap: f64| [cuboid([0.0; 3], [1.0; 3]), cuboid([1.0 + gap, 0.0, 0.0], [2.0, 1.0, 1.0])];
    assert_eq!(Fuse::new(&boxes(0.0), &within(1e-6)).unwrap().report(), []);
    let apart = Fuse::new(&boxes(5e-7), &within(1e-6)).unwrap();
    assert_eq!(apart.solids(|i| i.contains(&true)).unwrap().len(), 1);
    let report = apart.report();
    for kind in [DecisionKind::Points, DecisionKind::Surfaces] {
        let own = report.iter().find(|d| d.kind == kind).unwrap();
        assert!((own.distance - 5e-7).abs() < 1e-12, "{own}");
    }
    // What is farther apart than the tolerance stays so.
    let two = Fuse::new(&boxes(2e-6), &within(1e-6)).unwrap();
    assert_eq!((two.solids(|i| i.contains(&true)).unwrap().len(), two.report().len()), (2, 0));
}

#[test]
fn discs_that_overlap() {
    let fuse = Fuse::new(&[disc([0.0; 3], 10.0), disc([10.0, 0.0, 0.0], 10.0)], &within(1e-6)).unwrap();
    let lens = 200.0 * PI / 3.0 - 50.0 * 3.0_f64.sqrt();
    let of = |wanted: [bool; 2]| {
        let made = fuse.faces(|part| part.on == wanted).unwrap();
        area(&made.into_iter().map(|m| m.brep).collect::<Vec<_>>())
    };
    assert!((of([true, true]) - lens).abs() < 1e-6);
    assert!((of([true, false]) - (100.0 * PI - lens)).abs() < 1e-6);
}

#[test]
fn a_slot_whose_round_ends_touch_the_edges_of_a_face() {
    let arc = |z: f64, start: f64| -> Curve {
        let plane = Plane::from_axes(Point3::new(7.0, 3.0, z), Vector3::X, Vector3::Z).unwrap();
        Arc::new(Circle::new(plane, 1.0).unwrap(), Interval::new(start, start + PI)).unwrap().into()
    };
    let (top, low) = (arc(3.0, 0.0), arc(1.0, PI));
    let sides = [Line::new(top.end(), low.start()), Line::new(low.end(), top.start())].map(Curve::from);
    let [left, right] = sides;
    let outline = join_curves(&[top, left, low, right], 1e-9, false);
    let face = Brep::planar_faces(&outline, &within(1e-9)).unwrap().breps.remove(0);
    let slot = construct::extrude_brep(&face, Vector3::new(0.0, -1.0, 0.0), &within(1e-9)).unwrap();
    let block = cuboid([3.0, 3.0, 0.0], [8.0, 9.0, 5.0]);
    let made = Brep::union(&[block, slot], &within(1e-6)).unwrap();
    let breps: Vec<Brep> = made.into_iter().map(|m| m.brep).collect();
    // The box and the side of the slot; its front stands for the part of the box that it covers.
    let want = 170.0 + 2.0 * PI + 4.0;
    assert!((area(&breps) - want).abs() < 1e-6, "{} {want}", area(&breps));
}

/// A square bar with rounded edges, turned about its axis: its wall of flat and round parts is one face.
fn rounded_bar(turn: f64) -> Brep {
    let plane = Plane::XY.rotated(turn);
    let (half, radius) = (2.0, 1.0);
    let quarter = |k: usize| {
        let x = plane.rotated(FRAC_PI_2 * k as f64);
        let corner = x.with_origin(x.at(half - radius, half - radius, 0.0));
        let round = Arc::new(Circle::new(corner, radius).unwrap(), Interval::new(0.0, FRAC_PI_2)).unwrap();
        [Line::new(x.at(half, radius - half, 0.0), x.at(half, half - radius, 0.0)).into(), Curve::from(round)]
    };
    let parts: Vec<Curve> = (0..4).flat_map(quarter).collect();
    let profile: Curve = join_curves(&parts, 1e-9, false).remove(0).to_nurbs().unwrap().into();
    construct::extrude(&profile, Vector3::Z * 4.0, true, &within(1e-6)).unwrap()
}

#[test]
fn a_rounded_bar_is_cut_along_and_across() {
    // The plane y = 0 halves the bar however it is turned.
    let half_space = cuboid([-10.0, 0.0, 1.0], [10.0, 10.0, 9.0]);
    let want = 0.5 * (12.0 + PI) * 3.0;
    for k in 0..6 {
        let bar = rounded_bar(0.1 + 0.25 * f64::from(k));
        let made = Brep::intersection(&[bar], std::slice::from_ref(&half_space), &within(1e-4)).unwrap();
        let volume: f64 = made.iter().map(|m| m.brep.volume_properties(1e-9, || true).unwrap().amount).sum();
        assert!((volume - want).abs() < 1e-6 * want, "{k}: {volume} {want}");
    }
}

#[test]
fn a_corner_that_reaches_through_a_face_by_less_than_the_tolerance() {
    // The flat corner of a squeezed cube that stands on it comes through the top of a plate.
    let limit = 1e-2;
    let plate = [cuboid([-5.0, -5.0, -1.0], [5.0, 5.0, 0.0])];
    let turned = Xform::rotation_between(Vector3::new(1.0, 1.0, 1.0), Vector3::Z, Point3::ORIGIN).unwrap();
    for flat in [0.4, 0.2] {
        let squeezed = Xform::scale_non_uniform(&Plane::XY, 1.0, 1.0, flat);
        for depth in [0.9, 0.6].map(|x| x * limit) {
            let lowered = Xform::translation(Vector3::Z * -depth);
            let moves = [&turned, &squeezed, &lowered];
            let cube = moves.iter().fold(cuboid([0.0; 3], [3.0; 3]), |b, m| b.transformed(m).unwrap());
            let left = Brep::difference(&plate, &[cube], &within(limit)).unwrap();
            let volume: f64 =
                left.iter().map(|m| m.brep.volume_properties(1e-12, || true).unwrap().amount).sum();
            // A corner of three right angles of the height h is √3/2 h³; squeezed it has the height `depth`.
            let want = 100.0 - 0.5 * 3.0_f64.sqrt() * depth.powi(3) / flat.powi(2);
            assert!((volume - want).abs() < 1e-9, "{flat} {depth}: {volume} {want}");
        }
    }
}

/// Balls of radius 1.5, their seams along a direction.
fn balls(centers: &[[f64; 3]], axis: Vector3) -> Vec<Brep> {
    let ball = |center: &[f64; 3]| {
        let plane = Plane::from_normal(Point3::from(*center), axis).unwrap();
        construct::sphere(&Sphere::new(plane, 1.5).unwrap()).unwrap()
    };
    centers.iter().map(ball).collect()
}

fn volume(breps: &[Brep], tolerance: f64) -> f64 {
    let made = Brep::union(breps, &within(tolerance)).unwrap();
    made.iter().map(|m| m.brep.volume_properties(1e-9, || true).unwrap().amount).sum()
}

#[test]
fn a_circle_that_passes_a_pole_within_the_tolerance() {
    let centers = [[2.558535, -3.410291, 0.004779], [3.704958, -4.372307, -1.388743]];
    let [a, b] = centers.map(Point3::from);
    let (d, r) = (a.distance_to(b), 1.5);
    // Two balls without what they have in common: a lens of two equal caps.
    let lens = PI * (4.0 * r + d) * (2.0 * r - d).powi(2) / 12.0;
    let want = 2.0 * 4.0 / 3.0 * PI * r.powi(3) - lens;
    for tolerance in [1e-2, 1e-3, 1e-5] {
        let found = volume(&balls(&centers, Vector3::Z), tolerance);
        assert!((found - want).abs() < 1e-6 * want, "{tolerance}: {found} {want}");
    }
}

#[test]
fn places_that_are_within_the_tolerance_by_chance() {
    // Corners and seams a few tolerances apart: pieces between them that pierce a face, or begin and end on its border.
    let cases: [&[[f64; 3]]; 3] = [
        &[[2.744162, 2.266094, 1.561044], [3.44238, 3.455086, 0.217773], [4.993106, 4.079242, 1.938367]],
        &[
            [-2.311191, 0.785719, -3.137798],
            [-4.503776, 0.097855, -1.639603],
            [-3.16314, 1.433705, -1.361595],
        ],
        &[[2.337278, -4.428224, -0.348421], [4.765877, -3.941174, 1.268845], [3.147525, -4.786345, 1.866202]],
    ];
    for centers in cases {
        // Where the seams are does not matter.
        let want = volume(&balls(centers, Vector3::new(0.3, 0.5, 0.8)), 1e-6);
        for tolerance in [1e-2, 1e-3] {
            let found = volume(&balls(centers, Vector3::Z), tolerance);
            assert!((found - want).abs() < 1e-6 * want, "{centers:?} {tolerance}: {found} {want}");
        }
    }
}

#[test]
fn spheres_enclose_the_most_and_what_encloses_more_is_refused() {
    for radius in [0.3, 1.0, 40.0] {
        let turn = Xform::rotation(radius, Vector3::new(1.0, 2.0, -1.0), Point3::new(0.2, 0.1, 5.0)).unwrap();
        let ball = construct::sphere(&Sphere::around(Point3::new(0.2, -7.0, 0.4), radius).unwrap()).unwrap();
        for ball in [ball.transformed(&turn).unwrap(), ball] {
            let made = Fuse::new(&[ball], &within(1e-6 * radius)).unwrap().volumes().unwrap();
            assert_eq!(made.len(), 1, "{radius}");
        }
    }
    // A lid far above the edges that bound it.
    let mut parts = cuboid([0.0; 3], [1.0; 3]).into_parts();
    for surface in parts.surfaces.iter_mut().flatten() {
        if surface.bounding_box().unwrap().min.z > 0.9 {
            *surface = surface.transformed(&Xform::translation(Vector3::Z * 1e4)).unwrap();
        }
    }
    let open = Brep::from_parts(parts).unwrap();
    let whole = cuboid([0.0; 3], [1.0; 3]);
    assert!(super::audit::enclosed([&whole].into_iter()).is_ok());
    assert!(super::audit::enclosed([&whole, &open].into_iter()).is_err());
}
