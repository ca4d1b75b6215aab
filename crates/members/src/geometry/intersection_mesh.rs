//! Where meshes meet planes, lines and each other.

use katydid_geometry::intersect::{mesh_mesh, mesh_mesh_segments};
use katydid_geometry::{Line, Mesh, MeshTree, Plane, Point3, PolylineCurve};
use serde_json::Value as Json;

use super::answer::Outcome;
use super::argument::{Count, Some1, Waiting, Within};
use super::table::Endpoints;
use crate::wire::Script;
use crate::{Record, Value};

pub(super) fn enter(table: &mut Endpoints) {
    table.add("intersect/intersection/meshplane-mesh_plane", |m: Mesh, plane: Plane, w: Waiting| {
        sections(&m, &[plane], &w)
    });
    table.add(
        "intersect/intersection/meshplane-mesh_planearray",
        |m: Mesh, planes: Some1<Plane>, w: Waiting| sections(&m, &planes.0, &w),
    );
    table.add("intersect/intersection/meshmeshfast-mesh_mesh", |a: Mesh, b: Mesh| {
        Ok(mesh_mesh_segments(&MeshTree::new(&a), &MeshTree::new(&b)))
    });
    table.add("intersect/intersection/meshmeshaccurate-mesh_mesh_double", |a: Mesh, b: Mesh, t: Within| {
        Ok(mesh_mesh(&MeshTree::new(&a), &MeshTree::new(&b), t.0)?)
    });
    table.add("intersect/intersection/meshline-mesh_line_intarray", |m: Mesh, line: Line, w: Waiting| {
        on_lines(&m, &[line], &w)
    });
    table.add(
        "intersect/intersection/meshlinesorted-mesh_line_intarray",
        |m: Mesh, line: Line, w: Waiting| on_lines(&m, &[line], &w),
    );
    table.add("intersect/intersection/meshpolyline-mesh_polylinecurve_intarray", on_polyline);
    table.add("intersect/intersection/meshpolylinesorted-mesh_polylinecurve_intarray", on_polyline);
    table.add("intersect/meshclash/search", clashes);
    table.add("intersect/meshclash/search-mesh_mesharray_double_int", clashes);
}

/// The polylines in which planes cut a mesh; `None` for none.
fn sections(mesh: &Mesh, planes: &[Plane], waiting: &Waiting) -> Outcome<Option<Vec<Vec<Point3>>>> {
    let mut out = Vec::new();
    for plane in planes {
        waiting.check()?;
        out.extend(mesh.section(plane)?);
    }
    Ok((!out.is_empty()).then_some(out))
}

/// The points on a chain of segments, in its order, and the faces they lie in.
fn on_lines(mesh: &Mesh, lines: &[Line], waiting: &Waiting) -> Outcome<(Vec<Point3>, Vec<usize>)> {
    let tree = MeshTree::new(mesh);
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for line in lines {
        waiting.check()?;
        for hit in tree.line_hits(line.from, line.direction(), [0.0, 1.0])? {
            // A corner of the chain belongs to two segments.
            if points.last().is_none_or(|last: &Point3| last.distance_to(hit.point) > 0.0) {
                points.push(hit.point);
                faces.push(hit.face);
            }
        }
    }
    Ok((points, faces))
}

fn on_polyline(mesh: Mesh, polyline: PolylineCurve, waiting: Waiting) -> Outcome<(Vec<Point3>, Vec<usize>)> {
    let ends = polyline.points().iter().zip(polyline.points().iter().skip(1));
    on_lines(&mesh, &ends.map(|(a, b)| Line::new(*a, *b)).collect::<Vec<_>>(), &waiting)
}

/// Where a mesh comes within a distance of others: one entry for each of the others, with the point of the pair of faces
/// that are nearest, up to so many.
fn clashes(
    mesh: Mesh,
    others: Vec<Mesh>,
    distance: Reach,
    most: Count<1, 100_000>,
    waiting: Waiting,
) -> Outcome<Vec<Record>> {
    let tree = MeshTree::new(&mesh);
    let mut out = Vec::new();
    for other in &others {
        waiting.check()?;
        let pairs = tree.clashes(&MeshTree::new(other), distance.0, most.0);
        let Some(nearest) = pairs.iter().min_by(|a, b| a.distance.total_cmp(&b.distance)) else { continue };
        let fields = vec![
            ("ClashPoint", Value::Point(nearest.point)),
            ("ClashRadius", Value::Number(nearest.distance)),
            ("MeshA", mesh.clone().into_script()?),
            ("MeshB", other.clone().into_script()?),
        ];
        out.push(Record { class: "MeshClash", fields });
        if out.len() >= most.0 {
            break;
        }
    }
    Ok(out)
}

/// A distance, 0 or more.
struct Reach(f64);

impl crate::wire::Read for Reach {
    fn read(json: &Json) -> Result<Self, crate::Fault> {
        let x = f64::read(json)?;
        if x >= 0.0 { Ok(Self(x)) } else { Err(crate::Fault::bad_request(format!("is {x}, below 0"))) }
    }

    fn type_name() -> String {
        "Double".into()
    }
}
