//! Curves on meshes, breps and surfaces.

use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::{Brep, Curve, Mesh, Surface, Tolerance, Vector3};

use super::answer::Outcome;
use super::argument::{Waiting, Within};
use super::brep_face::Face;
use super::table::Endpoints;

pub(super) fn enter(table: &mut Endpoints) {
    table.add(
        "curve/projecttomesh-curve_mesh_vector3d_double",
        |c: Curve, m: Mesh, d: Vector3, t: Within, w: Waiting| onto_meshes(&[c], &[m], d, t, &w),
    );
    table.add(
        "curve/projecttomesh-curve_mesharray_vector3d_double",
        |c: Curve, m: Vec<Mesh>, d: Vector3, t: Within, w: Waiting| onto_meshes(&[c], &m, d, t, &w),
    );
    table.add(
        "curve/projecttomesh-curvearray_mesharray_vector3d_double",
        |c: Vec<Curve>, m: Vec<Mesh>, d: Vector3, t: Within, w: Waiting| onto_meshes(&c, &m, d, t, &w),
    );
    table
        .add("curve/pulltomesh-curve_mesh_double", |c: Curve, m: Mesh, t: Within| Ok(m.pull_curve(&c, t.0)?));
    table.add(
        "curve/projecttobrep-curve_brep_vector3d_double",
        |c: Curve, b: Brep, d: Vector3, t: Within, w: Waiting| {
            onto_breps(&[c], &[b], d, t, &w).map(|found| found.curves)
        },
    );
    table.add(
        "curve/projecttobrep-curve_breparray_vector3d_double",
        |c: Curve, b: Vec<Brep>, d: Vector3, t: Within, w: Waiting| {
            onto_breps(&[c], &b, d, t, &w).map(|found| found.curves)
        },
    );
    table.add(
        "curve/projecttobrep-curve_breparray_vector3d_double_intarray",
        |c: Curve, b: Vec<Brep>, d: Vector3, t: Within, w: Waiting| {
            onto_breps(&[c], &b, d, t, &w).map(|found| (found.curves, found.breps))
        },
    );
    table.add(
        "curve/projecttobrep-curvearray_breparray_vector3d_double",
        |c: Vec<Curve>, b: Vec<Brep>, d: Vector3, t: Within, w: Waiting| {
            onto_breps(&c, &b, d, t, &w).map(|found| found.curves)
        },
    );
    table.add(
        "curve/projecttobrep-curvearray_breparray_vector3d_double_intarray_intarray",
        |c: Vec<Curve>, b: Vec<Brep>, d: Vector3, t: Within, w: Waiting| {
            onto_breps(&c, &b, d, t, &w).map(|found| (found.curves, found.sources, found.breps))
        },
    );
    table.add("curve/pulltobrepface-curve_brepface_double", pulled);
    table.add(
        "curve/offsetonsurface-curve_surface_double_double",
        |c: Curve, s: Surface, d: f64, t: Within| Ok(s.offset_curve(&c, d, &t.tolerance())?),
    );
    table
        .add("curve/offsetonsurface-curve_brepface_double_double", |c: Curve, f: Face, d: f64, t: Within| {
            Ok(f.surface()?.offset_curve(&c, d, &t.tolerance())?)
        });
}

fn onto_meshes(
    curves: &[Curve],
    meshes: &[Mesh],
    direction: Vector3,
    tolerance: Within,
    waiting: &Waiting,
) -> Outcome<Vec<Curve>> {
    let mut out = Vec::new();
    for curve in curves {
        for mesh in meshes {
            waiting.check()?;
            out.extend(mesh.project_curve(curve, direction, tolerance.0)?);
        }
    }
    Ok(out)
}

/// Projected curves, and for each the places of the curve and the brep that it comes from.
#[derive(Default)]
struct Projected {
    curves: Vec<Curve>,
    sources: Vec<usize>,
    breps: Vec<usize>,
}

fn onto_breps(
    curves: &[Curve],
    breps: &[Brep],
    direction: Vector3,
    tolerance: Within,
    waiting: &Waiting,
) -> Outcome<Projected> {
    let tolerance: Tolerance = tolerance.tolerance();
    let mut out = Projected::default();
    for (source, curve) in curves.iter().enumerate() {
        for (place, brep) in breps.iter().enumerate() {
            waiting.check()?;
            for found in brep.project_curve(curve, direction, &tolerance)? {
                out.curves.push(found);
                out.sources.push(source);
                out.breps.push(place);
            }
        }
    }
    Ok(out)
}

/// A curve pulled to the nearest points of a face, as far as they lie within its trims.
fn pulled(curve: Curve, face: Face, tolerance: Within) -> Outcome<Vec<Curve>> {
    let found = face.surface()?.pull_curve(&curve, &tolerance.tolerance())?;
    let search = ClosestOnBrep::new(face.brep().into())?;
    let mut out = Vec::new();
    for curve in found {
        out.extend(search.curve_on_face(0, &curve)?);
    }
    Ok(out)
}
