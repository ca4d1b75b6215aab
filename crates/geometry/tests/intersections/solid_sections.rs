//! Sections of breps by planes.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use katydid_geometry::brep::{BrepSection, BrepSections, ClosestOnBrep};
use katydid_geometry::construct::{self, PipeCap};
use katydid_geometry::{
    Box3, Brep, Circle, Cone, Curve, Cylinder, Interval, Line, Plane, Point3, PolylineCurve, Sphere,
    SumSurface, Tolerance, Torus, Vector3, Xform,
};

const TOLERANCE: Tolerance = Tolerance { absolute: 0.001, angle: PI / 180.0 };

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn length(section: &BrepSection) -> f64 {
    section.curves.iter().map(Curve::length).sum()
}

/// All loops are closed without a gap, in the plane and on the brep.
fn sound(brep: &Brep, plane: &Plane) -> BrepSection {
    let section = brep.section(plane, &TOLERANCE).unwrap();
    assert!(section.complete);
    for curve in &section.curves {
        assert!(curve.is_closed(), "{plane:?}: an open curve from {:?} to {:?}", curve.start(), curve.end());
        for k in 0..40 {
            let q = curve.point_at(curve.domain().at(f64::from(k) / 40.0));
            assert!(plane.signed_distance(q).abs() <= 2.0 * TOLERANCE.absolute);
            assert!(brep.closest_point(q).unwrap().distance <= 2.0 * TOLERANCE.absolute, "{q:?}");
        }
    }
    section
}

#[test]
fn boxes() {
    let side = Interval::new(0.0, 2.0);
    let block = construct::box_brep(&Box3 { plane: Plane::XY, x: side, y: side, z: side }).unwrap();
    // Inside, at the bottom, at the top, beside.
    for (z, want) in [(1.0, 8.0), (0.0, 8.0), (2.0, 8.0), (2.5, 0.0)] {
        let section = sound(&block, &Plane::XY.offset(z));
        assert!((length(&section) - want).abs() < 1e-9, "{z}: {}", length(&section));
        assert_eq!(section.curves.len(), usize::from(want > 0.0));
        assert!(section.points.is_empty());
    }
    // Through two edges and two corners; by a corner; along an edge; a hexagon.
    let diagonal = Plane::from_normal(p(0.0, 0.0, 0.0), Vector3::new(1.0, -1.0, 0.0)).unwrap();
    assert!((length(&sound(&block, &diagonal)) - (4.0 + 2.0 * 8f64.sqrt())).abs() < 1e-9);
    let corner = Plane::from_normal(p(0.0, 0.0, 0.0), Vector3::new(1.0, 1.0, 1.0)).unwrap();
    let touch = sound(&block, &corner);
    assert!(touch.curves.is_empty() && touch.points == [p(0.0, 0.0, 0.0)]);
    let ridge = Plane::from_normal(p(0.0, 0.0, 0.0), Vector3::new(1.0, 1.0, 0.0)).unwrap();
    let touch = sound(&block, &ridge);
    assert!(touch.curves.is_empty() && touch.points.is_empty(), "{touch:?}");
    let hexagon = Plane::from_normal(p(1.0, 1.0, 1.0), Vector3::new(1.0, 1.0, 1.0)).unwrap();
    let hexagon = sound(&block, &hexagon);
    assert!((length(&hexagon) - 6.0 * 2f64.sqrt()).abs() < 1e-9);
    assert_eq!(hexagon.curves[0].as_polyline().map(|l| l.len()), Some(7));
}

#[test]
fn round_solids() {
    let can =
        construct::cylinder(&Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 5.0)).unwrap(), [true; 2]);
    let can = can.unwrap();
    for z in [0.0, 5.0, 2.5] {
        assert!((length(&sound(&can, &Plane::XY.offset(z))) - 2.0 * TAU).abs() < 1e-9);
    }
    // Beside the axis: two lines of the wall and two of the caps.
    let section = sound(&can, &Plane::YZ.offset(1.0));
    assert_eq!(section.curves.len(), 1);
    assert!((length(&section) - (10.0 + 4.0 * 3f64.sqrt())).abs() < 1e-6);
    // Aslant, out through the lid.
    let slant = Plane::from_normal(p(0.0, 0.0, 4.0), Vector3::new(1.0, 0.3, 1.0)).unwrap();
    assert_eq!(sound(&can, &slant).curves.len(), 1);
    let cone = construct::cone(&Cone::new(Plane::XY, 4.0, 2.0).unwrap(), true).unwrap();
    // Through the apex: a triangle.
    assert!((length(&sound(&cone, &Plane::YZ)) - (4.0 + 2.0 * 20f64.sqrt())).abs() < 1e-6);
    assert_eq!(sound(&cone, &Plane::YZ.offset(0.7)).curves.len(), 1);
    let ring = construct::torus(&Torus::new(Plane::XY, 5.0, 1.0).unwrap()).unwrap();
    assert_eq!(sound(&ring, &Plane::YZ).curves.len(), 2);
    assert!((length(&sound(&ring, &Plane::XY)) - TAU * 10.0).abs() < 1e-3);
    let ball = construct::quad_sphere(&Sphere::around(Point3::ORIGIN, 3.0).unwrap()).unwrap();
    for n in [Vector3::X, Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.2, -0.1, 1.0)] {
        for h in [0.0, 1.1, -2.2] {
            let plane = Plane::from_normal(Point3::ORIGIN, n).unwrap().offset(h);
            let section = sound(&ball, &plane);
            assert_eq!(section.curves.len(), 1, "{n:?} {h}");
            assert!((length(&section) - TAU * (9.0 - h * h).sqrt()).abs() < 2e-3);
        }
    }
}

#[test]
fn open_breps_and_holes() {
    let round = |r: f64| -> Curve { Circle::new(Plane::XY, r).unwrap().into() };
    let plate = Brep::planar_faces(&[round(3.0), round(1.0)], &TOLERANCE).unwrap().breps.swap_remove(0);
    let section = plate.section(&Plane::YZ, &TOLERANCE).unwrap();
    assert_eq!(section.curves.len(), 2);
    assert!((length(&section) - 4.0).abs() < 1e-9);
    let outline = plate.section(&Plane::XY, &TOLERANCE).unwrap();
    assert!((length(&outline) - 4.0 * TAU).abs() < 1e-9, "{outline:?}");
    let drilled = construct::extrude_brep(&plate, Vector3::new(0.0, 0.0, 2.0), &TOLERANCE).unwrap();
    assert_eq!(sound(&drilled, &Plane::XY.offset(1.0)).curves.len(), 2);
    assert_eq!(sound(&drilled, &Plane::YZ.offset(0.5)).curves.len(), 2);
    assert_eq!(sound(&drilled, &Plane::YZ.offset(2.0)).curves.len(), 1);
}

/// A tower of 200 faces: a star with 66 walls on each of three floors, turned and drawn in.
fn tower() -> Brep {
    let ring = |z: f64, turn: f64, size: f64| -> Vec<Point3> {
        (0..=66)
            .map(|k| {
                let angle = TAU * f64::from(k % 66) / 66.0 + turn;
                let r = size * (3.0 + 0.4 * (5.0 * angle).sin());
                p(r * angle.cos(), r * angle.sin(), z)
            })
            .collect()
    };
    let floors = [ring(0.0, 0.0, 1.0), ring(2.0, 0.02, 0.8), ring(3.5, -0.03, 1.1), ring(6.0, 0.01, 0.6)];
    let mut walls = Vec::new();
    for w in floors.windows(2) {
        for k in 0..66 {
            let wall = construct::four_point_surface(w[0][k], w[0][k + 1], w[1][k + 1], Some(w[1][k]));
            walls.push(wall.unwrap());
        }
    }
    for floor in [&floors[0], &floors[3]] {
        let outline: Curve = PolylineCurve::new(floor.clone()).unwrap().into();
        walls.extend(Brep::planar_faces(&[outline], &TOLERANCE).unwrap().breps);
    }
    let joined = Brep::join(&walls, &TOLERANCE).unwrap().breps;
    assert_eq!(joined.len(), 1);
    joined.into_iter().next().unwrap()
}

#[test]
fn a_hundred_planes_through_two_hundred_faces() {
    let solid = tower();
    assert!(solid.is_solid() && solid.faces().len() == 200);
    let sections = BrepSections::new(Arc::new(solid.clone()), &TOLERANCE).unwrap();
    let begun = std::time::Instant::now();
    for (n, count) in [(Vector3::Z, 40), (Vector3::X, 30), (Vector3::new(0.4, -0.7, 0.9), 30)] {
        let base = Plane::from_normal(p(0.0, 0.0, 3.0), n).unwrap();
        for k in 0..count {
            let plane = base.offset(-2.95 + 5.9 * f64::from(k) / f64::from(count - 1));
            let section = sections.cut(&plane).unwrap();
            for curve in &section.curves {
                assert!(curve.is_closed(), "{n:?} {k}: {:?} {:?}", curve.start(), curve.end());
            }
            assert!(section.complete && (n != Vector3::Z || section.curves.len() == 1), "{n:?} {k}");
        }
    }
    println!("100 planes: {:?}", begun.elapsed());
}

#[test]
fn pipes_and_revolved_shapes() {
    let rail: Curve =
        PolylineCurve::new(vec![p(0.0, 0.0, 0.0), p(6.0, 0.0, 0.0), p(6.0, 5.0, 3.0)]).unwrap().into();
    let pipe = construct::pipe(&rail, 0.7, PipeCap::Round, &TOLERANCE).unwrap();
    for h in [-0.4, 0.0, 0.3, 2.0] {
        sound(&pipe, &Plane::XY.offset(h));
        sound(&pipe, &Plane::XZ.offset(h));
        sound(&pipe, &Plane::YZ.offset(h + 3.0));
    }
    let profile: Curve =
        PolylineCurve::new(vec![p(1.0, 0.0, 0.0), p(3.0, 0.0, 0.5), p(2.0, 0.0, 3.0), p(1.0, 0.0, 0.0)])
            .unwrap()
            .into();
    let axis = Line::new(Point3::ORIGIN, p(0.0, 0.0, 1.0));
    let ring = construct::revolve(&profile, axis, Interval::new(0.0, TAU), &TOLERANCE).unwrap();
    for h in [0.0, 0.3, 1.0, 1.7, 2.4] {
        sound(&ring, &Plane::YZ.offset(h));
        sound(&ring, &Plane::XY.offset(h + 0.1));
    }
}

/// Motions that put things elsewhere, with the scales that go with them.
fn places() -> [(Xform, f64); 6] {
    let turned = |angle: f64| Xform::rotation(angle, Vector3::new(3.0, 1.0, 2.0), Point3::ORIGIN).unwrap();
    let moved = |x: f64, y: f64, z: f64| Xform::translation(Vector3::new(x, y, z));
    let grown = |scale: f64| Xform::scale(Point3::ORIGIN, scale);
    [
        (Xform::IDENTITY, 1.0),
        (turned(0.7), 1.0),
        (moved(12_345.6, -54_321.1, 777.7) * turned(1.9), 1.0),
        (moved(1e6, 1e6, 0.0) * turned(2.3), 1.0),
        (turned(0.4) * grown(1e3), 1e3),
        (turned(1.4) * grown(1e-1), 1e-1),
    ]
}

/// What a plane cuts does not depend on where it happens.
#[test]
fn sections_far_from_the_origin() {
    let height = Interval::new(0.0, 5.0);
    let tube = Brep::from_surface(Cylinder { plane: Plane::XY, radius: 1.0, height }.into()).unwrap();
    let ball = Brep::from_surface(Sphere { plane: Plane::XY, radius: 1.0 }.into()).unwrap();
    for (place, scale) in places() {
        let (tube, ball) = (tube.transformed(&place).unwrap(), ball.transformed(&place).unwrap());
        let lengths = |brep: &Brep, plane: Plane| {
            let section = brep.section(&plane.transformed(&place).unwrap(), &TOLERANCE).unwrap();
            section.curves.iter().map(|c| c.length() / scale).collect::<Vec<_>>()
        };
        let along =
            Plane { x_axis: Vector3::Y, y_axis: Vector3::Z, z_axis: Vector3::X, origin: Point3::ORIGIN };
        let close = |found: Vec<f64>, wanted: &[f64]| {
            assert_eq!(found.len(), wanted.len(), "{found:?} instead of {wanted:?} at {place:?}");
            for (a, b) in found.iter().zip(wanted) {
                assert!((a - b).abs() < 1e-6, "{found:?} instead of {wanted:?} at {place:?}");
            }
        };
        close(lengths(&tube, along), &[5.0, 5.0]);
        close(lengths(&tube, Plane { origin: p(0.0, 0.0, 5.0), ..Plane::XY }), &[TAU]);
        close(lengths(&ball, along), &[TAU]);
        close(lengths(&ball, Plane::XZ), &[TAU]);
    }
}

/// A line along an edge of a box, or along the seam of a tube, is in it between the corners, in one piece.
#[test]
fn lines_along_edges_and_seams() {
    let side = |to: f64| Interval::new(0.0, to);
    let block = Box3 { plane: Plane::XY, x: side(3.0), y: side(4.0), z: side(5.0) };
    let block = construct::box_brep(&block).unwrap();
    let height = Interval::new(0.0, 3.0);
    let tube = Brep::from_surface(Cylinder { plane: Plane::XY, radius: 1.0, height }.into()).unwrap();
    let cases = [
        (&block, [p(-1.0, 0.0, 0.0), p(9.0, 0.0, 0.0)]),
        (&block, [p(3.0, -1.0, 5.0), p(3.0, 9.0, 5.0)]),
        (&block, [p(-1.0, 2.0, 0.0), p(9.0, 2.0, 0.0)]),
        (&tube, [p(1.0, 0.0, -1.0), p(1.0, 0.0, 9.0)]),
        (&tube, [p(0.6, 0.8, -1.0), p(0.6, 0.8, 9.0)]),
    ];
    for (place, scale) in places() {
        for (i, (brep, ends)) in cases.iter().enumerate() {
            let brep = Arc::new(brep.transformed(&place).unwrap());
            let line = Curve::from(Line::new(ends[0], ends[1])).transformed(&place).unwrap();
            let found = ClosestOnBrep::new(brep).unwrap().curve_crossings(&line, 0.001).unwrap();
            let lengths: Vec<f64> =
                found.overlaps.iter().map(|o| line.trimmed(*o).unwrap().length() / scale).collect();
            let wanted = [3.0, 4.0, 3.0, 3.0, 3.0][i];
            assert!(found.complete && found.crossings.is_empty(), "case {i}, {scale}: {:?}", found.crossings);
            assert!(
                lengths.len() == 1 && (lengths[0] - wanted).abs() < 1e-4,
                "case {i}, {scale}: {lengths:?}"
            );
        }
    }
}

/// Pipes with round caps are closed however large.
#[test]
fn round_pipes_of_all_sizes() {
    for scale in [1e-1, 1.0, 1e3, 1e5, 1e6] {
        let turned = Xform::rotation(0.8, Vector3::new(3.0, 1.0, 2.0), Point3::ORIGIN).unwrap();
        let rail = Curve::from(Line::new(Point3::ORIGIN, p(3.0, 4.0, 0.0)));
        let place = turned * Xform::scale(Point3::ORIGIN, scale);
        let made =
            construct::pipe(&rail.transformed(&place).unwrap(), 0.5 * scale, PipeCap::Round, &TOLERANCE);
        let made = made.unwrap();
        assert!(made.is_solid(), "{scale}");
    }
}

/// Curves that fall on the edges of a face are on it all the same, in one piece, and arcs on planes stay exact.
#[test]
fn outlines_projected_onto_outlines() {
    let side = |to: f64| Interval::new(0.0, to);
    let block = Box3 { plane: Plane::XY, x: side(3.0), y: side(4.0), z: side(5.0) };
    let block = construct::box_brep(&block).unwrap();
    let corners = [p(0.0, 0.0, 9.0), p(3.0, 0.0, 9.0), p(3.0, 4.0, 9.0), p(0.0, 4.0, 9.0), p(0.0, 0.0, 9.0)];
    let outline = Curve::from(PolylineCurve::new(corners.to_vec()).unwrap());
    let round = Curve::from(Circle { plane: Plane { origin: p(1.5, 2.0, 9.0), ..Plane::XY }, radius: 1.0 });
    for (place, scale) in places() {
        let block = block.transformed(&place).unwrap();
        let down = place.vector(-Vector3::Z);
        let lengths = |curve: &Curve| -> Vec<f64> {
            let images = block.project_curve(&curve.transformed(&place).unwrap(), down, &TOLERANCE).unwrap();
            images.iter().map(|c| c.length() / scale).collect()
        };
        for (found, wanted) in [(lengths(&outline), 14.0), (lengths(&round), TAU)] {
            let fits = found.iter().all(|l| (l - wanted).abs() < 1e-5);
            assert!(found.len() == 2 && fits, "{scale}: {found:?} instead of twice {wanted}");
        }
    }
}

/// A projection whose lines run within the surface gives nothing, and soon.
#[test]
fn projections_edge_on_end_soon() {
    let begun = std::time::Instant::now();
    let ends = [p(-10_000.0, 40_000.0, 0.0), p(0.0, 0.0, 0.0)];
    let strip =
        SumSurface::extrusion(Line::new(ends[0], ends[1]).into(), Vector3::new(-10_000.0, -19_161.4, 0.0));
    let strip = Brep::from_surface(strip.unwrap().into()).unwrap();
    let around = Curve::from(Circle { plane: Plane::XY, radius: 20_000.0 });
    let found = strip.project_curve(&around, Vector3::new(50_000.0, -47_505.9, 0.0), &TOLERANCE).unwrap();
    assert!(found.is_empty());
    let ring = SumSurface::new(around.clone(), around.clone(), Vector3::ZERO).unwrap();
    let ring = Brep::from_surface(ring.into()).unwrap();
    let _ = ring.project_curve(&around, Vector3::Z, &TOLERANCE);
    assert!(begun.elapsed().as_secs() < 20, "{:?}", begun.elapsed());
}

/// A plane along the axis passes both poles of round caps, in any direction and of any size.
#[test]
fn planes_through_poles() {
    for scale in [0.1, 1.0, 1e3, 1e5] {
        for (axis, from) in [
            (Vector3::new(3.0, 4.0, 0.0), Point3::ORIGIN),
            (Vector3::new(1.0, -2.0, 2.0), p(10.0, 20.0, -5.0)),
            (Vector3::Z, p(1.0, 0.0, 0.0)),
        ] {
            let from = Point3::new(from.x * scale, from.y * scale, from.z * scale);
            let (length_of_axis, r) = (axis.length() * scale, 0.5 * scale);
            let rail: Curve = Line::new(from, from + axis * scale).into();
            let tolerance = TOLERANCE;
            let solid = construct::pipe(&rail, r, PipeCap::Round, &tolerance).unwrap();
            let beside = axis.cross(Vector3::new(0.3, 0.2, 1.0)).unitized().unwrap();
            for k in 0..8 {
                let turn = Xform::rotation(f64::from(k) * 0.3, axis, from).unwrap();
                let plane = Plane::from_normal(from, turn.vector(beside)).unwrap();
                let section = solid.section(&plane, &tolerance).unwrap();
                let closed = section.curves.iter().all(Curve::is_closed);
                assert!(
                    section.complete && closed && section.curves.len() == 1,
                    "{scale} {axis:?} {k}: {section:?}"
                );
                let want = 2.0 * length_of_axis + TAU * r;
                assert!(
                    (length(&section) - want).abs() <= 1e-6 * want,
                    "{scale} {axis:?} {k}: {} {want}",
                    length(&section)
                );
            }
        }
    }
}
