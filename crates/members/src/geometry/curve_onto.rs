//! Curves on meshes, breps and surfaces.

use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::{Brep, Curve, Direction, Mesh, Point2, Surface, Tolerance, Vector3};

use super::answer::Outcome;
use super::argument::{Waiting, Within};
use super::brep_face::Face;
use super::table::Endpoints;
use crate::Fault;

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
    table.add(
        "curve/offsetonsurface-curve_surface_point2d_double",
        |c: Curve, s: Surface, through: Point2, t: Within, w: Waiting| offset_through(&c, &s, through, t, &w),
    );
    table.add(
        "curve/offsetonsurface-curve_brepface_point2d_double",
        |c: Curve, f: Face, through: Point2, t: Within, w: Waiting| {
            offset_through(&c, &f.surface()?, through, t, &w)
        },
    );
    table.add("curve/offsetnormaltosurface-curve_surface_double", |c: Curve, s: Surface, height: f64| {
        Ok(s.curve_above(&c, height, &Tolerance::default())?)
    });
}

/// How often the distance of an offset is corrected until the offset goes through a point.
const CORRECTIONS: usize = 12;

/// The offset of a curve on a surface that goes through a point of it: the distance from the curve to the point along
/// the surface is not known beforehand, so it is corrected by what the offset misses it by.
fn offset_through(
    curve: &Curve,
    surface: &Surface,
    through: Point2,
    tolerance: Within,
    waiting: &Waiting,
) -> Outcome<Option<Vec<Curve>>> {
    for (name, along, t) in [("u", Direction::U, through.x), ("v", Direction::V, through.y)] {
        if !surface.domain(along).contains(t) {
            return Err(Fault::bad_request(format!("throughPoint: its {name} is {t}, outside the domain")));
        }
    }
    let point = surface.point_at(through.x, through.y);
    let normal = surface.normal_at(through.x, through.y);
    let normal = normal.ok_or_else(|| Fault::bad_request("throughPoint lies where there is no normal"))?;
    // How far the point lies to the left of a curve.
    let left_of = |curve: &Curve| -> Outcome<f64> {
        let near = curve.closest_point(point)?;
        let along = curve.tangent_at(near.parameter).unwrap_or(Vector3::ZERO);
        let side = normal.cross(along).dot(point - near.point);
        Ok(if side < 0.0 { -near.distance } else { near.distance })
    };
    let mut distance = left_of(curve)?;
    if distance.abs() <= tolerance.0 {
        return Ok(None);
    }
    for _ in 0..CORRECTIONS {
        waiting.check()?;
        let made = surface.offset_curve(curve, distance, &tolerance.tolerance())?;
        let mut misses = made.iter().map(left_of).collect::<Outcome<Vec<f64>>>()?;
        misses.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        match misses.first() {
            Some(miss) if miss.abs() <= tolerance.0 => return Ok(Some(made)),
            Some(miss) => distance += miss,
            None => return Ok(None),
        }
    }
    Ok(None)
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
