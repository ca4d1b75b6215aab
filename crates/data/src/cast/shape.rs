//! To surfaces, breps, meshes and SubDs.

use katydid_geometry::{Brep, Curve, Mesh, MeshSettings, PlaneSurface, Surface};

use super::Sure::{Likely, Shown, Used};
use super::way::{Way, way};
use super::{Rules, curve, number};
use crate::{Kind, Value};

pub(super) const WAYS: &[Way] = &[
    way(Kind::Surface, &[Kind::Brep], "the same, of one face", Shown, one_face),
    way(Kind::Surface, &number::CURVES, "the flat surface inside a closed flat curve", Used, inside),
    way(Kind::Surface, &[Kind::Box], "the face of a box of no thickness", Used, flat_box),
    way(Kind::Brep, &[Kind::Surface], "the same: a surface is a Brep of one face", Shown, |v, _| {
        Some(v.clone())
    }),
    way(Kind::Brep, &number::CURVES, "the flat surface inside a closed flat curve", Used, inside),
    way(Kind::Brep, &[Kind::Box], "its faces: six, or one where it has no thickness", Used, brep_of_box),
    way(Kind::Brep, &[Kind::TwistedBox], "its six faces", Likely, |v, rules| match v {
        Value::TwistedBox(b) => brep_of_mesh(&b.to_mesh().ok()?, rules),
        _ => None,
    }),
    way(Kind::Brep, &[Kind::Mesh], "a face for each face", Likely, |v, rules| match v {
        Value::Mesh(mesh) => brep_of_mesh(mesh, rules),
        _ => None,
    }),
    way(
        Kind::Brep,
        &[Kind::SubD],
        "bicubic patches over its faces, within the tolerance of its surface",
        Likely,
        |v, rules| v.subd()?.ok()?.to_brep(rules.tolerance.absolute).ok().map(Value::from),
    ),
    way(Kind::Mesh, &[Kind::Box, Kind::TwistedBox], "a quad for each side", Likely, |v, _| match v {
        Value::Box(b) => Mesh::cuboid(b, 1, 1, 1).ok().map(Value::from),
        Value::TwistedBox(b) => b.to_mesh().ok().map(Value::from),
        _ => None,
    }),
    way(Kind::Mesh, &[Kind::Surface, Kind::Brep], "the mesh of the default settings", Used, |v, _| {
        mesh_of(&*v.brep()?.ok()?).map(Value::from)
    }),
    way(Kind::Mesh, &number::CURVES, "the mesh inside a closed flat polyline", Likely, |v, rules| {
        let outline = curve::curve(v)?;
        outline.as_polyline()?;
        let face = flat_inside(outline, rules)?;
        mesh_of(&*face.brep()?.ok()?).map(Value::from)
    }),
    way(
        Kind::Mesh,
        &[Kind::SubD],
        "the mesh of points on it that divides each face into 16",
        Likely,
        |v, _| v.subd()?.ok()?.limit_mesh(2).ok().map(Value::from),
    ),
];

fn one_face(value: &Value, _: &Rules) -> Option<Value> {
    match value {
        Value::Brep(brep) => (brep.faces().len() == 1).then(|| value.clone()),
        // What is kept as a program wrote it is read where it is computed with.
        Value::Kept(_) => Some(value.clone()),
        _ => None,
    }
}

fn inside(value: &Value, rules: &Rules) -> Option<Value> {
    if let Some(r) = curve::rectangle(value, rules) {
        let flat = PlaneSurface::new(r.plane, r.x.ordered(), r.y.ordered());
        return flat.ok().map(|flat| Value::from(Surface::from(flat)));
    }
    flat_inside(curve::curve(value)?, rules)
}

/// The trimmed plane inside a closed flat curve.
fn flat_inside(outline: Curve, rules: &Rules) -> Option<Value> {
    if !outline.is_closed() {
        return None;
    }
    let found = Brep::planar_faces(&[outline], &rules.tolerance).ok()?;
    match <[Brep; 1]>::try_from(found.breps) {
        Ok([face]) if found.left.is_empty() => Some(Value::from(face)),
        _ => None,
    }
}

fn flat_box(value: &Value, _: &Rules) -> Option<Value> {
    match value {
        Value::Box(shape) if shape.flat_side().is_some() => value.brep()?.ok().map(Value::from_shared_brep),
        _ => None,
    }
}

fn brep_of_box(value: &Value, _: &Rules) -> Option<Value> {
    value.brep()?.ok().map(Value::from_shared_brep)
}

fn brep_of_mesh(mesh: &Mesh, rules: &Rules) -> Option<Value> {
    Brep::from_mesh(mesh, &rules.tolerance).ok().map(Value::from)
}

fn mesh_of(brep: &Brep) -> Option<Mesh> {
    brep.mesh(&MeshSettings::default()).ok()?.to_mesh().ok()
}
