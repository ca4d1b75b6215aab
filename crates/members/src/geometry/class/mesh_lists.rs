//! The lists of a mesh: vertices, faces, normals, colours, and the edges between its vertices. The mesh stands for its lists:
//! `MeshVertexList.Add` takes it and changes it.

use katydid_data::Colour;
use katydid_geometry::{Line, Mesh, MeshFace, Point3, Vector3};

use super::mesh::{Corners, SharedMesh, face_value, kernel_faces, rebuilt, rgba};
use crate::geometry::answer::Outcome;
use crate::geometry::argument::Count;
use crate::geometry::table::Endpoints;
use crate::{Fault, Value};

type Index = Count<0, 100_000_000>;

pub(super) fn enter(table: &mut Endpoints) {
    vertices(table);
    faces(table);
    attributes(table);
    edges(table);
}

fn vertices(table: &mut Endpoints) {
    table.member("MeshVertexList.ToArray this", |m: Mesh| Ok(m.vertices().to_vec()));
    table.member("MeshVertexList.ToPoint3dArray this", |m: Mesh| Ok(m.vertices().to_vec()));
    for signature in ["MeshVertexList.get_Item this index", "MeshVertexList.Point3dAt this index"] {
        table.member(signature, |SharedMesh(m): SharedMesh, i: Index| {
            m.vertices().get(i.0).copied().ok_or_else(|| beyond(i, m.vertices().len()))
        });
    }
    table.member("MeshVertexList.set_Item &this index vertex", |m: Mesh, i: Index, to: Point3| {
        let mut points = m.vertices().to_vec();
        *points.get_mut(i.0).ok_or_else(|| beyond(i, m.vertices().len()))? = to;
        Ok(((), with_points(&m, points)?))
    });
    table.member("MeshVertexList.get_Count this", |SharedMesh(m): SharedMesh| Ok(m.vertices().len()));
    table.member("MeshVertexList.Add &this x y z", |m: Mesh, x: f64, y: f64, z: f64| {
        with_vertices(&m, &[Point3::new(x, y, z)])
    });
    table.member("MeshVertexList.Add &this vertex", |m: Mesh, p: Point3| with_vertices(&m, &[p]));
    table.member("MeshVertexList.AddVertices &this vertices", |m: Mesh, points: Vec<Point3>| {
        with_vertices(&m, &points).map(|(_, mesh)| ((), mesh))
    });
    table.member("MeshVertexList.SetVertex &this index vertex", |m: Mesh, i: Index, to: Point3| {
        let mut points = m.vertices().to_vec();
        match points.get_mut(i.0) {
            Some(point) => *point = to,
            None => return Ok((false, m)),
        }
        Ok((true, with_points(&m, points)?))
    });
    table.member(
        "MeshVertexList.SetVertex &this index x y z",
        |m: Mesh, i: Index, x: f64, y: f64, z: f64| {
            let mut points = m.vertices().to_vec();
            match points.get_mut(i.0) {
                Some(point) => *point = Point3::new(x, y, z),
                None => return Ok((false, m)),
            }
            Ok((true, with_points(&m, points)?))
        },
    );
    // Many at once: what a loop of a script sets one by one.
    table.member(
        "MeshVertexList.SetVertex &this indices vertices",
        |m: Mesh, places: Vec<Index>, to: Vec<Point3>| {
            let mut points = m.vertices().to_vec();
            put(&mut points, &places, &to)?;
            Ok((true, with_points(&m, points)?))
        },
    );
    table.member("MeshVertexList.Clear &this", |_: Mesh| Ok(((), Mesh::new(Vec::new(), Vec::new())?)));
}

/// The mesh with more vertices, and the place of the first of them.
fn with_vertices(mesh: &Mesh, more: &[Point3]) -> Outcome<(usize, Mesh)> {
    let first = mesh.vertices().len();
    let points: Vec<Point3> = mesh.vertices().iter().chain(more).copied().collect();
    Ok((first, with_points(mesh, points)?))
}

fn with_points(mesh: &Mesh, points: Vec<Point3>) -> Outcome<Mesh> {
    with(mesh, points, mesh.faces().to_vec())
}

/// The mesh with other vertices and faces; its normals and colours where there are still as many.
fn with(mesh: &Mesh, points: Vec<Point3>, faces: Vec<MeshFace>) -> Outcome<Mesh> {
    rebuilt(points, faces, mesh.normals().to_vec(), mesh.colours().to_vec())
}

/// Puts values in places.
fn put<T: Copy>(items: &mut [T], places: &[Index], values: &[T]) -> Outcome<()> {
    if places.len() != values.len() {
        return Err(Fault::bad_request(format!("{} indices for {} values", places.len(), values.len())));
    }
    let count = items.len();
    for (place, value) in places.iter().zip(values) {
        *items.get_mut(place.0).ok_or_else(|| beyond(Count(place.0), count))? = *value;
    }
    Ok(())
}

fn beyond(Count(index): Index, count: usize) -> Fault {
    Fault::bad_request(format!("index is {index}, of {count}"))
}

fn faces(table: &mut Endpoints) {
    table.member("MeshFaceList.ToArray this", |m: Mesh| {
        Ok(Value::List(m.faces().iter().map(face_value).collect()))
    });
    for signature in ["MeshFaceList.get_Item this index", "MeshFaceList.GetFace this index"] {
        table.member(signature, |SharedMesh(m): SharedMesh, i: Index| {
            m.faces().get(i.0).map(face_value).ok_or_else(|| no_face(i, &m))
        });
    }
    for signature in ["MeshFaceList.set_Item &this index face", "MeshFaceList.SetFace &this index face"] {
        table.member(signature, |m: Mesh, i: Index, face: Corners| {
            let mut faces = m.faces().to_vec();
            let face = kernel_faces(&[face])?;
            *faces.get_mut(i.0).ok_or_else(|| no_face(i, &m))? =
                face.first().copied().ok_or_else(|| no_face(i, &m))?;
            Ok((true, with(&m, m.vertices().to_vec(), faces)?))
        });
    }
    table.member(
        "MeshFaceList.SetFace &this indices faces",
        |m: Mesh, places: Vec<Index>, to: Vec<Corners>| {
            let mut faces = m.faces().to_vec();
            put(&mut faces, &places, &kernel_faces(&to)?)?;
            Ok((true, with(&m, m.vertices().to_vec(), faces)?))
        },
    );
    table.member("MeshFaceList.get_Count this", |SharedMesh(m): SharedMesh| Ok(m.faces().len()));
    table.member("MeshFaceList.get_QuadCount this", |m: Mesh| Ok(quads(&m)));
    table.member("MeshFaceList.get_TriangleCount this", |m: Mesh| Ok(m.faces().len() - quads(&m)));
    table.member("MeshFaceList.AddFace &this face", |m: Mesh, face: Corners| with_faces(&m, &[face]));
    table.member("MeshFaceList.AddFace &this a b c", |m: Mesh, a: i32, b: i32, c: i32| {
        with_faces(&m, &[Corners([a, b, c, c])])
    });
    table.member("MeshFaceList.AddFace &this a b c d", |m: Mesh, a: i32, b: i32, c: i32, d: i32| {
        with_faces(&m, &[Corners([a, b, c, d])])
    });
    table.member("MeshFaceList.AddFaces &this faces", |m: Mesh, faces: Vec<Corners>| with_faces(&m, &faces));
    table.member("MeshFaceList.GetFaceCenter this faceIndex", |SharedMesh(m): SharedMesh, i: Index| {
        center(&m, i.0).ok_or_else(|| no_face(i, &m))
    });
    table.member("MeshFaceList.ConvertQuadsToTriangles &this", |m: Mesh| {
        let cut = |face: &MeshFace| face.triangles().map(MeshFace::Triangle).collect::<Vec<_>>();
        let faces: Vec<MeshFace> = m.faces().iter().flat_map(cut).collect();
        let is_new = faces.len() > m.faces().len();
        Ok((is_new, with(&m, m.vertices().to_vec(), faces)?))
    });
    table.member("MeshFaceList.DeleteFaces &this faceIndexes", |m: Mesh, gone: Vec<Index>| {
        let gone: std::collections::HashSet<usize> = gone.iter().map(|i| i.0).collect();
        let kept = m.faces().iter().enumerate().filter(|(i, _)| !gone.contains(i)).map(|(_, face)| *face);
        let kept: Vec<MeshFace> = kept.collect();
        Ok((m.faces().len() - kept.len(), m.part(&kept)?))
    });
}

/// The mean of one face's corners.
fn center(mesh: &Mesh, place: usize) -> Option<Point3> {
    let face = mesh.faces().get(place)?;
    let corners = face.indices().iter().map(|&i| mesh.vertices().get(i as usize).copied());
    let corners: Vec<Point3> = corners.collect::<Option<_>>()?;
    let sum = corners.iter().fold(Vector3::ZERO, |sum, corner| sum + corner.to_vector());
    Some((sum / corners.len() as f64).to_point())
}

fn no_face(Count(index): Index, mesh: &Mesh) -> Fault {
    Fault::bad_request(format!("faceIndex is {index}, of {}", mesh.faces().len()))
}

fn quads(mesh: &Mesh) -> usize {
    mesh.faces().iter().filter(|face| matches!(face, MeshFace::Quad(_))).count()
}

/// The mesh with more faces, and the place of the first of them.
fn with_faces(mesh: &Mesh, more: &[Corners]) -> Outcome<(usize, Mesh)> {
    let first = mesh.faces().len();
    let faces = mesh.faces().iter().copied().chain(kernel_faces(more)?).collect();
    Ok((first, with(mesh, mesh.vertices().to_vec(), faces)?))
}

fn attributes(table: &mut Endpoints) {
    table.member("MeshVertexNormalList.ToArray this", |m: Mesh| Ok(m.normals().to_vec()));
    table.member("MeshVertexNormalList.get_Count this", |SharedMesh(m): SharedMesh| Ok(m.normals().len()));
    table.member("MeshVertexNormalList.get_Item this index", |SharedMesh(m): SharedMesh, i: Index| {
        m.normals().get(i.0).copied().ok_or_else(|| beyond(i, m.normals().len()))
    });
    table.member("MeshFaceNormalList.ToArray this", |m: Mesh| Ok(m.face_normals()));
    table.member("MeshFaceNormalList.get_Count this", |SharedMesh(m): SharedMesh| Ok(m.faces().len()));
    table.member("MeshFaceNormalList.get_Item this index", |m: Mesh, i: Index| {
        m.face_normals().get(i.0).copied().ok_or_else(|| beyond(i, m.faces().len()))
    });
    table.member("MeshVertexNormalList.ComputeNormals &this", |m: Mesh| Ok((true, m.with_normals())));
    table.member("MeshFaceNormalList.ComputeFaceNormals &this", |m: Mesh| Ok((true, m)));
    table.member("MeshVertexNormalList.SetNormals &this normals", |m: Mesh, normals: Vec<Vector3>| {
        if normals.len() != m.vertices().len() {
            return Ok((false, m));
        }
        Ok((true, rebuilt(m.vertices().to_vec(), m.faces().to_vec(), normals, m.colours().to_vec())?))
    });
    table.member("MeshVertexColorList.ToArray this", |m: Mesh| {
        Ok(m.colours().iter().map(|own| colour(*own)).collect::<Vec<Colour>>())
    });
    table.member("MeshVertexColorList.get_Count this", |SharedMesh(m): SharedMesh| Ok(m.colours().len()));
    table.member("MeshVertexColorList.get_Item this index", |SharedMesh(m): SharedMesh, i: Index| {
        m.colours().get(i.0).map(|own| colour(*own)).ok_or_else(|| beyond(i, m.colours().len()))
    });
    table.member("MeshVertexColorList.SetColors &this colors", |m: Mesh, colours: Vec<Colour>| {
        if colours.len() != m.vertices().len() {
            return Ok((false, m));
        }
        let colours: Vec<[u8; 4]> = colours.into_iter().map(rgba).collect();
        Ok((true, rebuilt(m.vertices().to_vec(), m.faces().to_vec(), m.normals().to_vec(), colours)?))
    });
    table.member("MeshVertexColorList.CreateMonotoneMesh &this baseColor", |m: Mesh, colour: Colour| {
        let colours = vec![rgba(colour); m.vertices().len()];
        Ok((true, rebuilt(m.vertices().to_vec(), m.faces().to_vec(), m.normals().to_vec(), colours)?))
    });
    table.member("MeshVertexColorList.Clear &this", |m: Mesh| {
        Ok(((), rebuilt(m.vertices().to_vec(), m.faces().to_vec(), m.normals().to_vec(), Vec::new())?))
    });
}

fn edges(table: &mut Endpoints) {
    table.member("MeshTopologyEdgeList.get_Count this", |m: Mesh| Ok(m.edges().len()));
    table.member("MeshTopologyEdgeList.EdgeLine this topologyEdgeIndex", |m: Mesh, i: Index| {
        let edges = m.edges();
        let line = edges.get(i.0).and_then(|edge| m.edge_line(edge));
        line.ok_or_else(|| Fault::bad_request(format!("topologyEdgeIndex is {}, of {}", i.0, edges.len())))
    });
    table.member("MeshTopologyEdgeList.ToArray this", |m: Mesh| {
        Ok(m.edges().iter().filter_map(|edge| m.edge_line(edge)).collect::<Vec<Line>>())
    });
}

fn colour([r, g, b, a]: [u8; 4]) -> Colour {
    Colour::argb(a, r, g, b)
}
