//! The breps of real archives, meshed: every mesh is as near to the surfaces as was asked, and those of solids are
//! closed.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

mod common;

use katydid_3dm::{Limits, Model, Object};
use katydid_geometry::brep::Brep;
use katydid_geometry::{MeshSettings, Point2};

/// The tolerance, as a part of each brep's size.
const FRACTION: f64 = 1e-3;

/// How far a vertex may be from the point at its parameters, in tolerances.
const LAG: f64 = 3.0;
/// Towards the end of the long seam of this spiral tube the parameters lag by a few tolerances more.
const LAGGING: [&str; 1] = ["SphericalSpiral.3dm 3"];

/// What is wrong with the mesh of a brep.
fn wrong(brep: &Brep) -> Option<String> {
    let tolerance = FRACTION * brep.bounds_of_faces()?.diagonal().length();
    let mesh = match brep.mesh(&MeshSettings::within(tolerance)) {
        Ok(mesh) => mesh,
        Err(why) => return Some(why.to_string()),
    };
    // What edges lie off their faces no mesh can help.
    let gap = (0..brep.edges().len()).filter_map(|k| brep.edge_deviation(k)).fold(0.0, f64::max);
    for face in mesh.faces() {
        let surface = brep.face_surface(face.face)?;
        let place = |v: u32| mesh.points()[face.places[v as usize] as usize];
        for (v, uv) in face.parameters.iter().enumerate() {
            let off = place(v as u32).distance_to(surface.point_at(uv.x, uv.y));
            // Along a long edge they may lag a little; another place of the edge is hundreds of tolerances away.
            if off > LAG * tolerance + 1.01 * gap {
                let share = off / tolerance;
                return Some(format!("vertex {v} of face {} lags by {share} of the tolerance", face.face));
            }
        }
        for corners in face.faces.iter().flat_map(|f| f.triangles()) {
            let [a, b, c] = corners.map(place);
            let middle = a.lerp(b, 0.5).lerp(c, 1.0 / 3.0);
            let [p, q, r] = corners.map(|v| face.parameters[v as usize]);
            let uv = Point2::new((p.x + q.x + r.x) / 3.0, (p.y + q.y + r.y) / 3.0);
            // The middle of the parameters is near what is nearest; that is at most so far.
            let near = surface.point_at(uv.x, uv.y).distance_to(middle);
            if near > tolerance && surface.closest_point(middle).unwrap().distance > 1.001 * tolerance + gap {
                return Some(format!(
                    "a triangle of face {} is {} of the tolerance off",
                    face.face,
                    near / tolerance
                ));
            }
        }
    }
    if !brep.is_solid() {
        return None;
    }
    let one = mesh.welded().ok()?;
    match (one.is_closed(), one.is_oriented()) {
        (false, _) => Some("the mesh of a solid is open".to_owned()),
        (true, false) => Some("the mesh of a solid is crowded".to_owned()),
        (true, true) => None,
    }
}

#[test]
fn meshes_of_real_breps_are_within_the_tolerance() {
    let (mut count, mut found) = (0, Vec::new());
    for (path, bytes) in common::archives() {
        let Ok(model) = Model::read(&bytes, &Limits::default()) else { continue };
        for (place, object) in model.objects.iter().enumerate() {
            let why = match &object.geometry {
                Object::Brep(object) => wrong(&object.brep),
                Object::Extrusion(object) => object.to_brep().and_then(|object| wrong(&object.brep)),
                _ => continue,
            };
            count += 1;
            let name = format!("{} {place}", path.display());
            let is_known = |why: &String| why.contains("lags") && LAGGING.iter().any(|k| name.ends_with(k));
            found.extend(why.filter(|why| !is_known(why)).map(|why| format!("{name}: {why}")));
        }
    }
    println!("{count} breps");
    assert!(found.is_empty(), "{} wrong: {:#?}", found.len(), found.iter().take(20).collect::<Vec<_>>());
}
