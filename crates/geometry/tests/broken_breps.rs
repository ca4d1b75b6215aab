//! Breps with one rule of validity broken at a time: the checks name the reason, and nothing that takes breps panics,
//! hangs or gives numbers that are none.
//!
//! `KATYDID_CASES=10000 cargo test --release -p katydid-geometry --test broken_breps` breaks each shape so often at random.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

mod broken;

use std::sync::Arc;
use std::time::{Duration, Instant};

use broken::{cuboid, each_at_random, each_way, impossible, ways};
use katydid_geometry::MeshSettings;
use katydid_geometry::brep::{Brep, BrepSections, ClosestOnBrep, Solidity, Symptom};
use katydid_geometry::{Curve, Direction, Line, Plane, Point3, Tolerance, Vector3, Xform, construct};

#[test]
fn every_broken_rule_is_named() {
    assert_eq!(cuboid().faults(), []);
    for way in ways() {
        let mut parts = cuboid().into_parts();
        (way.change)(&mut parts);
        // Lists that are emptied leave names of what is gone: that is refused at once.
        match Brep::from_parts(parts) {
            Ok(brep) => {
                let faults = brep.faults();
                let named = faults.iter().any(|f| f.part == way.part && f.why.contains(way.why));
                assert!(named, "{}: '{}' is not among {faults:?}", way.part, way.why);
                assert!(!brep.is_valid());
            }
            Err(_) => assert_eq!(way.part, "brep", "{}", way.why),
        }
    }
}

#[test]
fn faults_that_show_say_how() {
    let shown = [
        ("away from that of its edge", Symptom::EdgeOffFace),
        ("beyond its curve", Symptom::EdgeBeyondCurve),
        ("does not increase", Symptom::EdgeWithoutLength),
        ("open, but has one vertex", Symptom::EdgeToItself),
        ("do not share a vertex", Symptom::Gap),
        ("begins at", Symptom::Gap),
        ("is a seam, and its edge has", Symptom::Seam),
        ("bounds another", Symptom::SharedBoundary),
        ("tolerance is not set", Symptom::Parts),
    ];
    for (why, symptom) in shown {
        for way in ways().iter().filter(|way| way.why == why) {
            let mut parts = cuboid().into_parts();
            (way.change)(&mut parts);
            let faults = Brep::from_parts(parts).unwrap().faults();
            assert!(faults.iter().any(|f| f.why.contains(why) && f.symptom == symptom), "{why}: {faults:?}");
        }
    }
}

#[test]
fn what_cannot_be_is_refused() {
    for (name, change) in impossible() {
        let mut parts = cuboid().into_parts();
        change(&mut parts);
        let refusal = Brep::from_parts(parts);
        // The reason names the part, by its kind and place.
        let named = refusal.as_ref().is_err_and(|why| why.to_string().chars().any(|c| c.is_ascii_digit()));
        assert!(named, "{name}: {refusal:?}");
    }
}

/// An edge may have three faces, and a face may look the wrong way: that is sound, but no solid.
#[test]
fn sound_breps_that_are_no_solids() {
    let solid = cuboid();
    assert!(solid.is_solid());
    let mut parts = solid.clone().into_parts();
    parts.faces[0].reversed ^= true;
    let turned = Brep::from_parts(parts).unwrap();
    assert!(turned.is_valid() && turned.solid_orientation() == Solidity::Unknown);
    let tolerance = Tolerance::default();
    let fin = Curve::from(Line::new(Point3::ORIGIN, Point3::new(3.0, 0.0, 0.0)));
    let fin = construct::extrude(&fin, Vector3::new(0.0, -2.0, -2.0), false, &tolerance).unwrap();
    for joined in Brep::join(&[solid, fin], &tolerance).unwrap().breps {
        assert!(joined.is_valid());
    }
}

/// Everything that takes a brep; a result or an error, but no panic.
fn try_everything(brep: &Brep) {
    let tolerance = Tolerance::default();
    let _ = brep.faults();
    let _ = (brep.is_solid(), brep.is_manifold(), brep.as_surface(), brep.solid_orientation());
    let begun = Instant::now();
    let go_on = || begun.elapsed() < Duration::from_secs(2);
    for properties in [brep.area_properties(1e-2, go_on), brep.volume_properties(1e-2, go_on)] {
        assert!(properties.is_err() || properties.is_ok_and(|p| p.amount.is_finite()));
    }
    let plane = Plane::XY.offset(0.5);
    if let Ok(sections) = BrepSections::new(Arc::new(brep.clone()), &tolerance) {
        for plane in [plane, Plane::YZ, Plane::XY] {
            let _ = sections.cut(&plane);
        }
    }
    let beam: Curve = Line::new(Point3::new(0.5, 0.4, -9.0), Point3::new(0.6, 0.5, 9.0)).into();
    if let Ok(search) = ClosestOnBrep::new(Arc::new(brep.clone())) {
        let _ = search.curve_crossings(&beam, 1e-3);
        let _ =
            (search.nearest(Point3::new(1.0, 1.0, 9.0)), search.contains(Point3::new(0.5, 0.5, 0.5), 1e-3));
    }
    let _ = (brep.naked_loops(), brep.bounds_of_faces(), brep.bounding_box_in(&Plane::XY));
    let results = [
        brep.transformed(&Xform::scale(Point3::ORIGIN, 2.0)),
        brep.with_coplanar_faces_merged(&tolerance),
        brep.capped(&tolerance).map(|c| c.0),
        construct::extrude_brep(brep, Vector3::Z, &tolerance),
        Ok(brep.clone().flipped()),
        Ok(brep.clone().turned_outward()),
        Ok(Brep::merged(&[brep.clone(), brep.clone()])),
    ];
    drop(results);
    let _ = Brep::join(&[brep.clone(), cuboid()], &tolerance);
    let _ = construct::offset_brep(brep, 0.1, true, &tolerance);
    let _ = (brep.exploded(), brep.connected_components());
    for face in 0..brep.faces().len().min(3) {
        let _ = (brep.face_region(face, &tolerance), brep.face_wires(face, 1));
        let _ = (brep.untrimmed_face(face), brep.shrunk_face(face, &tolerance));
        let _ = brep.face_split_at(face, [&[0.5], &[0.5]], &tolerance);
        let _ = brep.face_isocurves(face, Direction::U, 0.5);
    }
    for edge in 0..brep.edges().len() {
        let _ = (brep.edge_as_curve(edge), brep.edge_deviation(edge), brep.edge_point(edge, 0.5));
    }
}

fn mesh(brep: &Brep) {
    let coarse = MeshSettings { max_distance: 0.1, max_count: 2_000, ..MeshSettings::default() };
    if let Ok(mesh) = brep.mesh(&coarse) {
        assert!(mesh.points().iter().all(|p| p.is_finite()));
        let _ = (mesh.to_mesh(), mesh.welded());
    }
}

#[test]
fn nothing_panics_on_broken_breps() {
    each_way(|brep| {
        mesh(brep);
        try_everything(brep);
    });
}

#[test]
fn breps_broken_at_random_are_meshed_or_refused() {
    each_at_random(100, mesh);
}

#[test]
fn nothing_panics_on_breps_broken_at_random() {
    each_at_random(20, try_everything);
}
