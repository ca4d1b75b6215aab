//! Meshes of breps, surfaces and solids, and unions, differences and intersections of meshes.

use katydid_geometry::{
    BoundingBox, Box3, Brep, Curve, Interval, Mesh, MeshFace, MeshSettings, Plane, Point3, PolylineCurve,
    Rectangle, Solid, Sphere, Surface,
};

use super::answer::{Outcome, or_null};
use super::argument::{Count, Some1, Waiting, Within};
use super::table::Endpoints;
use crate::wire::{MeshingParameters, Subdivision};
use crate::{Cause, Fault};

pub(super) fn enter(table: &mut Endpoints) {
    table.add("mesh/createfrombrep-brep", |b: Brep, w: Waiting| of_brep(&b, &MeshSettings::default(), &w));
    table.add(
        "mesh/createfrombrep-brep_meshingparameters",
        |b: Brep, p: Option<MeshingParameters>, w: Waiting| of_brep(&b, &settings(p), &w),
    );
    table.add("mesh/createfromsurface-surface", |s: Surface| {
        Ok(s.mesh(&MeshSettings::default())?.to_mesh()?)
    });
    table.add(
        "mesh/createfromsurface-surface_meshingparameters",
        |s: Surface, p: Option<MeshingParameters>| Ok(s.mesh(&settings(p))?.to_mesh()?),
    );
    table.add("mesh/createfromsubd-subd_int", |s: Subdivision, density: Count<0, 6>| {
        Ok(s.0.limit_mesh(u32::try_from(density.0).unwrap_or(0))?)
    });
    table.add(
        "mesh/createfromplane-plane_interval_interval_int_int",
        |plane: Plane, x: Interval, y: Interval, nx: Quads, ny: Quads| {
            few([nx, ny])?;
            Ok(Mesh::plane(&Rectangle { plane, x, y }, nx.0, ny.0)?)
        },
    );
    table
        .add("mesh/createfrombox-boundingbox_int_int_int", |b: BoundingBox, x: Quads, y: Quads, z: Quads| {
            of_box(&b.into(), x, y, z)
        });
    table.add("mesh/createfrombox-box_int_int_int", |b: Box3, x: Quads, y: Quads, z: Quads| {
        of_box(&b, x, y, z)
    });
    table.add("mesh/createfrombox-point3darray_int_int_int", of_corners);
    table.add("mesh/createfromsphere-sphere_int_int", |s: Sphere, around: Around, up: Up| {
        few([Count(around.0), Count(up.0)])?;
        Ok(Mesh::sphere(&s.plane, s.radius, around.0, up.0)?)
    });
    table.add(
        "mesh/createfromplanarboundary-curve_meshingparameters",
        |c: Curve, p: Option<MeshingParameters>| planar(&c, p, Within(0.001)),
    );
    table.add(
        "mesh/createfromplanarboundary-curve_meshingparameters_double",
        |c: Curve, p: Option<MeshingParameters>, t: Within| planar(&c, p, t),
    );
    table.add("mesh/createfromclosedpolyline-polyline", |p: PolylineCurve| {
        planar(&p.into(), Some(MeshingParameters(MeshSettings::default())), Within(0.001))
    });
    table.add("mesh/createbooleanunion-mesharray", |m: Some1<Mesh>| {
        or_null(union(&m.0, "meshes").and_then(combined))
    });
    table.add("mesh/createbooleandifference-mesharray_mesharray", |a: Some1<Mesh>, b: Some1<Mesh>| {
        let both = || union(&a.0, "firstSet")?.difference(&union(&b.0, "secondSet")?).map_err(Fault::from);
        or_null(both().and_then(combined))
    });
    table.add("mesh/createbooleanintersection-mesharray_mesharray", |a: Some1<Mesh>, b: Some1<Mesh>| {
        let both = || union(&a.0, "firstSet")?.intersection(&union(&b.0, "secondSet")?).map_err(Fault::from);
        or_null(both().and_then(combined))
    });
}

type Quads = Count<1, 1_000_000>;
type Around = Count<3, 1_000_000>;
type Up = Count<2, 1_000_000>;

/// The most faces of a grid.
const MOST: usize = 4_000_000;

/// Refuses grids that nobody can have meant.
fn few<const N: usize>(counts: [Quads; N]) -> Outcome<()> {
    let faces = counts.iter().fold(1_usize, |product, count| product.saturating_mul(count.0));
    if faces > MOST {
        Err(Fault::too_large(format!("the mesh would have {faces} faces, more than {MOST}")))
    } else {
        Ok(())
    }
}

fn settings(parameters: Option<MeshingParameters>) -> MeshSettings {
    parameters.map_or_else(MeshSettings::default, |parameters| parameters.0)
}

/// One mesh a face, as RhinoCommon gives them.
fn of_brep(brep: &Brep, settings: &MeshSettings, waiting: &Waiting) -> Outcome<Vec<Mesh>> {
    let stop = || !waiting.go_on();
    let found = brep.mesh_unless(settings, &stop).map_err(|error| {
        if stop() { Fault::new(Cause::Cancelled, "it was cancelled") } else { Fault::from(error) }
    })?;
    (0..found.faces().len()).filter_map(|face| found.face_mesh(face)).map(|mesh| Ok(mesh?)).collect()
}

fn of_box(shape: &Box3, x: Quads, y: Quads, z: Quads) -> Outcome<Mesh> {
    few([x, y])?;
    few([y, z])?;
    few([z, x])?;
    Ok(Mesh::cuboid(shape, x.0, y.0, z.0)?)
}

/// The box with eight given corners, bottom and top each once round: the grids of a unit box, moved to where the corners
/// take them.
fn of_corners(corners: Vec<Point3>, x: Quads, y: Quads, z: Quads) -> Outcome<Mesh> {
    let count = corners.len();
    let Ok(corners) = <[Point3; 8]>::try_from(corners) else {
        return Err(Fault::bad_request(format!("corners has {count} points, not 8")));
    };
    let unit = BoundingBox { min: Point3::ORIGIN, max: Point3::new(1.0, 1.0, 1.0) };
    let grid = of_box(&unit.into(), x, y, z)?;
    let twisted = katydid_geometry::TwistedBox::new(corners)?;
    let vertices = grid.vertices().iter().map(|p| twisted.at(p.x, p.y, p.z)).collect();
    Ok(Mesh::new(vertices, grid.faces().to_vec())?.with_normals())
}

/// The mesh of what a closed planar curve bounds; `None` when that is nothing.
fn planar(curve: &Curve, parameters: Option<MeshingParameters>, tolerance: Within) -> Outcome<Option<Mesh>> {
    let faces = Brep::planar_faces(std::slice::from_ref(curve), &tolerance.tolerance())?;
    let meshes = faces.breps.iter().map(|brep| Ok(brep.mesh(&settings(parameters))?.welded()?));
    let meshes = meshes.collect::<Outcome<Vec<Mesh>>>()?;
    Ok(if meshes.is_empty() { None } else { Some(Mesh::join(&meshes)?) })
}

/// What several closed meshes enclose together.
pub(super) fn union(meshes: &[Mesh], name: &str) -> Outcome<Solid> {
    if meshes.is_empty() {
        return Err(Fault::bad_request(format!("{name} is empty")));
    }
    let solid = |(i, mesh)| {
        Solid::new(mesh)
            .map_err(|error| Fault::bad_request(format!("{name}: mesh {i} cannot be combined: {error}")))
    };
    Ok(Solid::united(&meshes.iter().enumerate().map(solid).collect::<Outcome<Vec<Solid>>>()?)?)
}

/// The pieces of a result; nothing for an empty one.
pub(super) fn combined(solid: Solid) -> Outcome<Vec<Mesh>> {
    if solid.is_empty() {
        return Ok(Vec::new());
    }
    let mesh = solid.to_mesh()?;
    let faces: &[MeshFace] = mesh.faces();
    if faces.is_empty() { Ok(Vec::new()) } else { Ok(vec![mesh]) }
}
