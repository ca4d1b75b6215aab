//! Solids whose trims or surfaces lie beside their edges: volumes against closed forms, seen from anywhere.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

use std::f64::consts::PI;
use std::sync::Arc;

use katydid_geometry::brep::{ClosestOnBrep, CurvePart};
use katydid_geometry::{
    Box3, Brep, Containment, Curve, Cylinder, Interval, KnotSpacing, MassProperties, NurbsCurve, Plane,
    Point3, Surface, Tolerance, Vector3, Xform, construct,
};

/// How far what leaks is off.
const OFF: f64 = 1e-4;

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn close(found: f64, want: f64) {
    let miss = (found - want).abs() / want.abs();
    assert!(miss <= 1e-10, "{found} instead of {want}: {miss:e}");
}

fn volume(brep: &Brep) -> MassProperties {
    brep.volume_properties(1e-13, || true).unwrap()
}

fn block() -> Brep {
    let side = |end: f64| Interval::new(0.0, end);
    construct::box_brep(&Box3 { plane: Plane::XY, x: side(2.0), y: side(3.0), z: side(4.0) }).unwrap()
}

fn tube() -> Brep {
    construct::cylinder(&Cylinder::new(Plane::XY, 1.5, Interval::new(0.0, 4.0)).unwrap(), [true; 2]).unwrap()
}

/// Every trim moved in its parameter plane; its edge stays.
fn with_trims_moved(brep: &Brep, by: Vector3, pace: f64) -> Brep {
    let mut parts = brep.clone().into_parts();
    for curve in parts.curves_2d.iter_mut().flatten() {
        let mut nurbs = curve.to_nurbs().unwrap();
        if pace != 1.0 {
            nurbs = nurbs.reparametrized(pace).unwrap();
        }
        *curve = Curve::from(nurbs).transformed(&Xform::translation(by)).unwrap();
    }
    Brep::from_parts(parts).unwrap()
}

/// The block with the plane of its upper side higher than the edges there.
fn with_lid_raised(by: f64) -> Brep {
    let mut parts = block().into_parts();
    let mut raised = 0;
    for surface in parts.surfaces.iter_mut().flatten() {
        let bounds = surface.bounding_box();
        if bounds.unwrap().min.z > 3.9 {
            *surface = surface.transformed(&Xform::translation(Vector3::Z * by)).unwrap();
            raised += 1;
        }
    }
    assert_eq!(raised, 1);
    Brep::from_parts(parts).unwrap()
}

/// Amount, centroid and moments about it, here and where a motion brings the solid.
fn is_block_of_height(brep: &Brep, height: f64) {
    let turn = Xform::rotation(0.7, Vector3::new(1.0, 2.0, -1.0), p(3.0, 1.0, 0.0)).unwrap();
    let moves = [
        Xform::IDENTITY,
        Xform::translation(Vector3::new(20.0, -30.0, 10.0)),
        turn,
        Xform::translation(Vector3::new(-9.0, 7.0, 15.0)) * turn,
    ];
    for by in moves {
        let found = volume(&brep.transformed(&by).unwrap());
        close(found.amount, 6.0 * height);
        let centre = by.point(p(1.0, 1.5, 0.5 * height));
        assert!(found.centroid.distance_to(centre) <= 1e-9, "{:?} instead of {centre:?}", found.centroid);
        let inertia = found.inertia_about(found.centroid);
        let whole = 6.0 * height * (4.0 + 9.0 + height * height) / 6.0;
        close(inertia.x + inertia.y + inertia.z, whole);
    }
}

#[test]
fn a_block_with_rough_trims_is_what_its_edges_bound() {
    // Far apart the edges are pulled, nearby strips close the gap; at the edge's pace and at another.
    for off in [OFF, 1e-8] {
        for pace in [1.0, 3.0] {
            let leaky = with_trims_moved(&block(), Vector3::new(off, -0.7 * off, 0.0), pace);
            is_block_of_height(&leaky, 4.0);
        }
    }
    let leaky = with_trims_moved(&block(), Vector3::new(OFF, -0.7 * OFF, 0.0), 1.0);
    // The area is that within the trims: each face's slid along.
    close(leaky.area_properties(1e-12, || true).unwrap().amount, 52.0);
    for from in [Point3::ORIGIN, p(50.0, -20.0, 8.0)] {
        let shares = (0..6).map(|face| leaky.face_volume(face, from, 1e-13).unwrap()).sum::<f64>();
        close(shares, 24.0);
    }
    assert!(leaky.volume_properties(1e-9, || false).is_err());
}

#[test]
fn a_block_whose_edges_lie_beside_a_face_is_closed_by_strips() {
    for by in [1e-9, 1e-6, OFF, 0.01] {
        is_block_of_height(&with_lid_raised(by), 4.0 + by);
        is_block_of_height(&with_lid_raised(-by), 4.0 - by);
    }
}

#[test]
fn a_tube_with_rough_trims() {
    for off in [OFF, 1e-8] {
        // Not round the tube: a trim that leaves the seam has no edge beside it.
        let mut parts = tube().into_parts();
        let walls: Vec<usize> = (0..parts.faces.len())
            .filter(|face| {
                !matches!(parts.surfaces[parts.faces[*face].surface.unwrap()], Some(Surface::Plane(_)))
            })
            .collect();
        let [wall] = walls[..] else { panic!("one wall") };
        let trims: Vec<usize> =
            parts.faces[wall].loops.iter().flat_map(|chain| parts.loops[*chain].trims.clone()).collect();
        for trim in trims {
            let place = parts.trims[trim].part.curve.unwrap();
            let curve = parts.curves_2d[place].as_ref().unwrap();
            let slid = Xform::translation(Vector3::new(0.0, off, 0.0));
            parts.curves_2d[place] = Some(curve.transformed(&slid).unwrap());
        }
        let leaky = Brep::from_parts(parts).unwrap();
        for by in [Vector3::ZERO, Vector3::new(30.0, -10.0, 20.0)] {
            let found = volume(&leaky.transformed(&Xform::translation(by)).unwrap());
            close(found.amount, PI * 1.5 * 1.5 * 4.0);
            assert!(found.centroid.distance_to(p(0.0, 0.0, 2.0) + by) <= 1e-9);
        }
    }
}

#[test]
fn edges_pulled_to_their_faces() {
    let tolerance = Tolerance { absolute: 1e-6, ..Tolerance::default() };
    let (sound, leaky) = (block(), with_trims_moved(&block(), Vector3::new(OFF, OFF, 0.0), 3.0));
    for trim in 0..sound.trims().len() {
        let edge = sound.trims()[trim].edge.unwrap();
        let edge = sound.edge_as_curve(edge).unwrap().unwrap();
        assert_eq!(sound.edge_beside_trim(trim, &edge, &tolerance).unwrap(), None);
        let flat = leaky.edge_beside_trim(trim, &edge, &tolerance).unwrap().unwrap();
        let face = leaky.loops()[leaky.trims()[trim].in_loop.unwrap()].face.unwrap();
        let surface = leaky.face_surface(face).unwrap();
        for k in 0..=20 {
            let t = edge.domain().at(f64::from(k) / 20.0);
            let uv = flat.point_at(t);
            assert!(surface.point_at(uv.x, uv.y).distance_to(edge.point_at(t)) <= 1e-12);
        }
    }
    assert_eq!(leaky.edge_beside_trim(99, &Curve::from(line()), &tolerance).unwrap(), None);
    let none = Tolerance { absolute: 0.0, ..tolerance };
    assert!(leaky.edge_beside_trim(0, &Curve::from(line()), &none).is_err());
}

fn line() -> katydid_geometry::Line {
    katydid_geometry::Line::new(Point3::ORIGIN, p(1.0, 0.0, 0.0))
}

#[test]
fn an_edge_that_weaves_across_the_side_of_its_surface_is_not_followed() {
    let (off, waves) = (0.01, 5.0);
    let mut parts = block().into_parts();
    for surface in parts.surfaces.iter_mut().flatten() {
        *surface = surface.to_nurbs().unwrap().into();
    }
    let (from, to) = (p(2.0, 0.0, 4.0), p(2.0, 3.0, 4.0));
    let wave = |k: usize| {
        let y = k as f64 / 15.0;
        p(2.0 + off * (waves * PI * y).sin(), 3.0 * y, 4.0)
    };
    let points: Vec<Point3> = (0..=15).map(wave).collect();
    let woven = NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).unwrap();
    let edge = parts.edges.iter().position(|edge| {
        let ends = edge.vertices.map(|vertex| parts.vertices[vertex.unwrap()].point);
        ends == [from, to] || ends == [to, from]
    });
    let edge = edge.unwrap();
    let backwards = parts.vertices[parts.edges[edge].vertices[0].unwrap()].point == to;
    let woven = Curve::from(woven);
    let woven = if backwards { woven.reversed() } else { woven };
    parts.edges[edge].part = CurvePart::whole(parts.curves_3d.len(), woven.domain());
    parts.edges[edge].tolerance = 2.0 * off;
    parts.curves_3d.push(Some(woven.clone()));
    let leaky = Brep::from_parts(parts).unwrap();
    // The lid and the strip from the wall are one plane, whichever way the edge goes in it.
    close(volume(&leaky).amount, 24.0);
    for trim in (0..leaky.trims().len()).filter(|trim| leaky.trims()[*trim].edge == Some(edge)) {
        let tolerance = Tolerance { absolute: 1e-6, angle: 0.1 };
        let Some(flat) = leaky.edge_beside_trim(trim, &woven, &tolerance).unwrap() else { continue };
        // The wall's: it slides along the side. The lid's would leave its side and come back.
        let bounds = flat.bounding_box();
        assert!(bounds.min.x == bounds.max.x || bounds.min.y == bounds.max.y, "{bounds:?}");
    }
}

/// Rays that leave through the gap beside the lid cross no face.
#[test]
fn points_of_a_block_whose_lid_ends_beside_its_edge_are_inside() {
    let gap = 0.05;
    let mut parts = block().into_parts();
    let lid =
        parts.surfaces.iter().position(|s| s.as_ref().is_some_and(|s| s.bounding_box().unwrap().min.z > 3.9));
    let face = parts.faces.iter().position(|f| f.surface == lid).unwrap();
    let of_lid: Vec<usize> =
        parts.loops.iter().filter(|l| l.face == Some(face)).flat_map(|l| l.trims.clone()).collect();
    for trim in of_lid {
        let curve = parts.trims[trim].part.curve.unwrap();
        let flat = parts.curves_2d[curve].as_mut().unwrap();
        *flat = flat.transformed(&Xform::translation(Vector3::X * gap)).unwrap();
    }
    parts.measure_tolerances();
    let tolerances: Vec<f64> = parts.edges.iter().map(|e| e.tolerance).collect();
    assert!(tolerances.iter().any(|t| (t - gap).abs() < 1e-9), "{tolerances:?}");
    let brep = Brep::from_parts(parts).unwrap();
    assert!(brep.is_solid());
    let search = ClosestOnBrep::new(Arc::new(brep)).unwrap();
    let mut count = 0;
    for (i, j, k) in (0..12).flat_map(|i| (0..7).flat_map(move |j| (0..9).map(move |k| (i, j, k)))) {
        let q = p(0.01 + 0.02 * f64::from(i), 0.4 + 0.37 * f64::from(j), 3.55 + 0.05 * f64::from(k));
        assert_eq!(search.contains(q, 1e-6).unwrap(), Containment::Inside, "{q:?}");
        let above = p(q.x, q.y, 4.001 + 0.05 * f64::from(k));
        assert_eq!(search.contains(above, 1e-6).unwrap(), Containment::Outside, "{above:?}");
        count += 1;
    }
    assert_eq!(count, 756);
}
