//! Meshes: nearest points, values at places, and meshes made from meshes.

use std::collections::BTreeMap;

use katydid_data::Colour;
use katydid_geometry::{
    Containment, Curve, Decimation, Mesh, MeshFace, MeshPoint, MeshTree, Plane, Point3, PolylineCurve,
    Smoothing, Vector3,
};
use serde_json::Value as Json;

use super::answer::Outcome;
use super::argument::{Count, OnMesh, Positive, Turn, Waiting, Within};
use super::curve::contour_planes;
use super::smoothing::Pull;
use super::table::Endpoints;
use crate::{Fault, Record, Value};

pub(super) fn enter(table: &mut Endpoints) {
    table.add("mesh/closestpoint-mesh_point3d", |m: Mesh, p: Point3| Ok(m.closest_point(p)?.point));
    table.add("mesh/closestmeshpoint-mesh_point3d_double", |m: Mesh, p: Point3, most: f64| {
        Ok(nearest(&m, p, most)?.map(|found| mesh_point(&found)))
    });
    table.add("mesh/closestpoint-mesh_point3d_point3d_double", |m: Mesh, p: Point3, most: f64| {
        let found = nearest(&m, p, most)?;
        Ok((face_number(found.as_ref()), found.map(|found| found.point)))
    });
    table.add("mesh/closestpoint-mesh_point3d_point3d_vector3d_double", |m: Mesh, p: Point3, most: f64| {
        let found = nearest(&m, p, most)?;
        let at = found.as_ref().map(|f| OnMesh { face: f.face, shares: f.weights });
        let normal = at.map(|at| normal_at(&m, &at)).transpose()?;
        Ok((face_number(found.as_ref()), found.map(|found| found.point), normal))
    });
    table.add("mesh/pullpointstomesh-mesh_point3darray", |m: Mesh, points: Vec<Point3>, w: Waiting| {
        let tree = MeshTree::new(&m);
        points
            .iter()
            .map(|p| w.check().and_then(|()| Ok(tree.nearest(*p)?)))
            .collect::<Outcome<Vec<Point3>>>()
    });
    table.add("mesh/pointat-mesh_meshpoint", |m: Mesh, at: OnMesh| point_at(&m, &at));
    table.add(
        "mesh/pointat-mesh_int_double_double_double_double",
        |m: Mesh, f: Index, a: f64, b: f64, c: f64, d: f64| {
            point_at(&m, &OnMesh { face: f.0, shares: [a, b, c, d] })
        },
    );
    table.add("mesh/normalat-mesh_meshpoint", |m: Mesh, at: OnMesh| normal_at(&m, &at));
    table.add(
        "mesh/normalat-mesh_int_double_double_double_double",
        |m: Mesh, f: Index, a: f64, b: f64, c: f64, d: f64| {
            normal_at(&m, &OnMesh { face: f.0, shares: [a, b, c, d] })
        },
    );
    table.add("mesh/colorat-mesh_meshpoint", |m: Mesh, at: OnMesh| colour_at(&m, &at));
    table.add(
        "mesh/colorat-mesh_int_double_double_double_double",
        |m: Mesh, f: Index, a: f64, b: f64, c: f64, d: f64| {
            colour_at(&m, &OnMesh { face: f.0, shares: [a, b, c, d] })
        },
    );
    table.add(
        "mesh/ispointinside-mesh_point3d_double_bool",
        |m: Mesh, p: Point3, t: Within, strictly: bool| {
            if !m.is_closed() {
                return Err(Fault::bad_request("this is a mesh that is not closed"));
            }
            Ok(match MeshTree::new(&m).containment(p, t.0) {
                Containment::Inside => true,
                Containment::On => !strictly,
                Containment::Outside => false,
            })
        },
    );
    table.add("mesh/pullcurve-mesh_curve_double", |m: Mesh, c: Curve, t: Within| Ok(m.pull_curve(&c, t.0)?));
    table.add("mesh/weld-mesh_double", |m: Mesh, angle: Turn| Ok(m.welded(angle.0)));
    table.add("mesh/unweld-mesh_double_bool", |m: Mesh, angle: Turn, _: bool| Ok(m.unwelded(angle.0)));
    table.add("mesh/rebuildnormals-mesh", |m: Mesh| Ok(m.with_normals()));
    table.add("mesh/splitdisjointpieces-mesh", |m: Mesh| Ok(m.pieces()?));
    table.add("mesh/split-mesh_plane", |m: Mesh, plane: Plane| {
        let parts = m.split_by_plane(&plane, 0.0)?;
        Ok(parts.into_iter().filter(|part| !part.faces().is_empty()).collect::<Vec<Mesh>>())
    });
    table.add("mesh/getoutlines-mesh_plane", |m: Mesh, plane: Plane| {
        let mut outlines = m.shadow(plane.z_axis, &plane)?;
        outlines.iter_mut().for_each(close);
        Ok(outlines)
    });
    table.add("mesh/getnakededges-mesh", |m: Mesh| naked_edges(&m));
    table.add("mesh/offset-mesh_double", |m: Mesh, d: f64| Ok(m.offset(d)?));
    table.add("mesh/offset-mesh_double_bool", |m: Mesh, d: f64, solid: bool| {
        Ok(if solid { m.thickened(d)? } else { m.offset(d)? })
    });
    for path in [
        "mesh/smooth-mesh_double_bool_bool_bool_bool_smoothingcoordinatesystem",
        "mesh/smooth-mesh_double_bool_bool_bool_bool_smoothingcoordinatesystem_plane",
    ] {
        table.add(path, |m: Mesh, pull: Pull, w: Waiting| smoothed(&m, None, &pull, &w));
    }
    table.add(
        "mesh/smooth-mesh_intarray_double_bool_bool_bool_bool_smoothingcoordinatesystem_plane",
        |m: Mesh, vertices: Vec<i32>, pull: Pull, w: Waiting| smoothed(&m, Some(&vertices), &pull, &w),
    );
    for path in ["mesh/reduce-mesh_reducemeshparameters", "mesh/reduce-mesh_reducemeshparameters_bool"] {
        table.add(path, |m: Mesh, wanted: Reduction, w: Waiting| reduced(&m, wanted.0, &w));
    }
    for path in [
        "mesh/reduce-mesh_int_bool_int_bool",
        "mesh/reduce-mesh_int_bool_int_bool_bool",
        "mesh/reduce-mesh_int_bool_int_bool_cancellationtoken_doublearray_string",
        "mesh/reduce-mesh_int_bool_int_bool_cancellationtoken_doublearray_string_bool",
    ] {
        table.add(path, |m: Mesh, n: Faces, _: bool, _: i32, _: bool, w: Waiting| reduced(&m, n.0, &w));
    }
    table.add("mesh/createcontourcurves-mesh_plane", |m: Mesh, plane: Plane, w: Waiting| {
        contours(&m, &[plane], &w)
    });
    table.add(
        "mesh/createcontourcurves-mesh_point3d_point3d_double",
        |m: Mesh, start: Point3, end: Point3, interval: Positive, w: Waiting| {
            contours(&m, &contour_planes(start, end, interval)?, &w)
        },
    );
    table.add("mesh/createfromfilteredfacelist-mesh_boolarray", filtered);
}

type Index = Count<0, { i32::MAX as usize }>;
type Faces = Count<4, 100_000_000>;

/// The nearest point, unless it is farther than a greatest distance above 0.
fn nearest(mesh: &Mesh, point: Point3, most: f64) -> Outcome<Option<MeshPoint>> {
    if most < 0.0 {
        return Err(Fault::bad_request(format!("maximumDistance is {most}, below 0")));
    }
    let found = mesh.closest_point(point)?;
    Ok((most == 0.0 || found.distance <= most).then_some(found))
}

/// The number of the face, −1 for none.
fn face_number(found: Option<&MeshPoint>) -> i32 {
    found.and_then(|found| i32::try_from(found.face).ok()).unwrap_or(-1)
}

fn mesh_point(found: &MeshPoint) -> Record {
    let fields = vec![
        ("FaceIndex", i64::try_from(found.face).map_or(Value::Null, Value::Int)),
        ("T", Value::Numbers(found.weights.to_vec())),
        ("Point", Value::Point(found.point)),
    ];
    Record { class: "MeshPoint", fields }
}

/// The vertices of a face, with how much each takes part.
fn corners(mesh: &Mesh, at: &OnMesh) -> Outcome<Vec<(usize, f64)>> {
    let faces = mesh.faces();
    let face = faces.get(at.face);
    let face =
        face.ok_or_else(|| Fault::bad_request(format!("faceIndex is {}, of {}", at.face, faces.len())))?;
    Ok(face.indices().iter().map(|&i| i as usize).zip(at.shares).collect())
}

fn point_at(mesh: &Mesh, at: &OnMesh) -> Outcome<Point3> {
    let corner = |(i, share): (usize, f64)| {
        mesh.vertices().get(i).map_or(Vector3::ZERO, |vertex| vertex.to_vector() * share)
    };
    Ok(corners(mesh, at)?.into_iter().map(corner).sum::<Vector3>().to_point())
}

/// The mean of the vertex normals; the face's own where the mesh has none or they cancel out.
fn normal_at(mesh: &Mesh, at: &OnMesh) -> Outcome<Vector3> {
    let corners = corners(mesh, at)?;
    let computed;
    let normals: &[Vector3] = if mesh.normals().is_empty() {
        computed = mesh.vertex_normals();
        &computed
    } else {
        mesh.normals()
    };
    let sum: Vector3 = corners.iter().filter_map(|&(i, share)| Some(*normals.get(i)? * share)).sum();
    let own = || mesh.face_normals().get(at.face).copied().unwrap_or(Vector3::ZERO);
    Ok(sum.unitized().unwrap_or_else(own))
}

/// The mean of the vertex colours; `None` for a mesh without colours.
fn colour_at(mesh: &Mesh, at: &OnMesh) -> Outcome<Option<Colour>> {
    let mut sum = [0.0; 4];
    for (i, share) in corners(mesh, at)? {
        let Some(colour) = mesh.colours().get(i) else { return Ok(None) };
        sum.iter_mut().zip(colour).for_each(|(sum, channel)| *sum += share * f64::from(*channel));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a byte")]
    let [r, g, b, a] = sum.map(|x| x.round().clamp(0.0, 255.0) as u8);
    Ok(Some(Colour::argb(a, r, g, b)))
}

/// Ends a chain of points with its first.
fn close(points: &mut Vec<Point3>) {
    if let (Some(first), Some(last)) = (points.first().copied(), points.last().copied())
        && first != last
    {
        points.push(first);
    }
}

/// The borders as polylines, closed ones with their first point at the end; `None` for a closed mesh.
fn naked_edges(mesh: &Mesh) -> Outcome<Option<Vec<Vec<Point3>>>> {
    let mut neighbours: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for edge in mesh.edges().into_iter().filter(|edge| edge.faces == 1) {
        let [a, b] = edge.vertices;
        neighbours.entry(a).or_default().push(b);
        neighbours.entry(b).or_default().push(a);
    }
    let mut chains = Vec::new();
    // Chains that end somewhere begin there; what is left over closes.
    let ends: Vec<u32> = neighbours.iter().filter(|(_, next)| next.len() != 2).map(|(&i, _)| i).collect();
    let all: Vec<u32> = ends.into_iter().chain(neighbours.keys().copied().collect::<Vec<_>>()).collect();
    for start in all {
        while neighbours.get(&start).is_some_and(|next| !next.is_empty()) {
            let mut chain = vec![start];
            let mut at = start;
            while let Some(next) = neighbours.get_mut(&at).and_then(Vec::pop) {
                if let Some(back) = neighbours.get_mut(&next)
                    && let Some(place) = back.iter().position(|&i| i == at)
                {
                    back.swap_remove(place);
                }
                chain.push(next);
                at = next;
                // A corner where chains meet ends them all.
                if at == start || neighbours.get(&at).is_none_or(|rest| rest.len() != 1) {
                    break;
                }
            }
            chains.push(chain);
        }
    }
    let points = |chain: Vec<u32>| {
        chain.into_iter().filter_map(|i| mesh.vertices().get(i as usize).copied()).collect::<Vec<Point3>>()
    };
    Ok((!chains.is_empty()).then(|| chains.into_iter().map(points).collect()))
}

/// The mesh with its vertices, or those listed, drawn towards their neighbours along some axes. What lies in one place
/// stays together.
fn smoothed(mesh: &Mesh, listed: Option<&[i32]>, pull: &Pull, waiting: &Waiting) -> Outcome<(bool, Mesh)> {
    let options = Smoothing { strength: pull.strength, skip_naked: pull.fixed, iterations: 1, limit: None };
    let smooth = mesh.smoothed(&options, || waiting.go_on())?;
    let merged = mesh.merged_indices();
    let mut moves = vec![listed.is_none(); mesh.vertices().len()];
    for i in listed.unwrap_or_default() {
        let place = usize::try_from(*i).ok().and_then(|i| merged.get(i));
        let moving = place.and_then(|place| moves.get_mut(*place as usize));
        *moving.ok_or_else(|| Fault::bad_request(format!("vertexIndices: there is no vertex {i}")))? = true;
    }
    let places = mesh.vertices().iter().zip(smooth.vertices()).zip(&merged).map(|((from, to), place)| {
        let moving = moves.get(*place as usize).copied().unwrap_or(false);
        if moving { *from + pull.axes.part(*to - *from) } else { *from }
    });
    let (faces, colours) = (mesh.faces().to_vec(), mesh.colours().to_vec());
    Ok((true, Mesh::from_parts(places.collect(), faces, Vec::new(), colours)?.with_normals()))
}

/// `ReduceMeshParameters`, of which the count of faces is heeded.
struct Reduction(usize);

impl crate::wire::Read for Reduction {
    fn read(json: &Json) -> Result<Self, Fault> {
        let Count(faces): Faces = crate::wire::Members::of(json)?.read("DesiredPolygonCount")?;
        Ok(Self(faces))
    }

    fn type_name() -> String {
        "ReduceMeshParameters".into()
    }
}

fn reduced(mesh: &Mesh, faces: usize, waiting: &Waiting) -> Outcome<(bool, Mesh)> {
    let reduced = mesh.decimated(&Decimation { faces, max_error: f64::INFINITY }, || waiting.go_on())?;
    Ok((reduced.faces().len() < mesh.faces().len(), reduced))
}

fn contours(mesh: &Mesh, planes: &[Plane], waiting: &Waiting) -> Outcome<Vec<PolylineCurve>> {
    let mut out = Vec::new();
    for plane in planes {
        waiting.check()?;
        for points in mesh.section(plane)? {
            out.push(PolylineCurve::new(points)?);
        }
    }
    Ok(out)
}

/// The faces that are marked.
fn filtered(mesh: Mesh, inclusion: Vec<bool>) -> Outcome<Mesh> {
    if inclusion.len() != mesh.faces().len() {
        let (given, faces) = (inclusion.len(), mesh.faces().len());
        return Err(Fault::bad_request(format!("inclusion has {given} items for {faces} faces")));
    }
    let kept = mesh.faces().iter().zip(inclusion).filter(|(_, keep)| *keep).map(|(face, _)| *face);
    Ok(mesh.part(&kept.collect::<Vec<MeshFace>>())?)
}
