//! `Mesh`: what it is, and changes in place.

use std::sync::Arc;

use katydid_data::Colour;
use katydid_geometry::{Mesh, MeshFace, Point3, Vector3};

use super::Named;
use crate::geometry::answer::Outcome;
use crate::geometry::table::Endpoints;
use crate::shape::{Geometry, Shape};
use crate::wire::Read;
use crate::{Fault, Value};

pub(super) fn enter(table: &mut Endpoints) {
    table.member("Mesh.new", || Ok(Mesh::new(Vec::new(), Vec::new())?));
    table.member("Mesh.new vertices faces", |vertices: Vec<Point3>, faces: Vec<Corners>| {
        Ok(Mesh::new(vertices, kernel_faces(&faces)?)?)
    });
    table.member("Mesh.DuplicateMesh this", |m: Mesh| Ok(m));
    table.member("Mesh.get_IsClosed this", |m: Mesh| Ok(m.is_closed()));
    table.member("Mesh.IsManifold this", |m: Mesh| Ok(m.is_manifold()));
    table.member("Mesh.get_IsSolid this", |m: Mesh| Ok(m.is_closed() && m.is_manifold()));
    table.member("Mesh.get_IsOriented this", |m: Mesh| Ok(m.is_oriented()));
    table.member("Mesh.SolidOrientation this", |m: Mesh| {
        let volume = if m.is_closed() && m.is_oriented() { m.volume() } else { 0.0 };
        Ok(if volume > 0.0 {
            1
        } else if volume < 0.0 {
            -1
        } else {
            0
        })
    });
    table.member("Mesh.get_DisjointMeshCount this", |m: Mesh| Ok(m.pieces()?.len()));
    table.member("Mesh.Append &this other", |m: Mesh, other: Mesh| Ok(((), Mesh::join(&[m, other])?)));
    table.member("Mesh.Append &this meshes", |m: Mesh, others: Vec<Mesh>| {
        let all: Vec<Mesh> = std::iter::once(m).chain(others).collect();
        Ok(((), Mesh::join(&all)?))
    });
    table.member(
        "Mesh.Flip &this vertexNormals faceNormals faceOrientation",
        |m: Mesh, _: bool, _: bool, faces: bool| Ok(((), if faces { m.flipped() } else { m })),
    );
    table.member("Mesh.Compact &this", |m: Mesh| Ok((true, m.without_vertices(|_| false, false)?)));
    table.member("Mesh.get_ObjectType this", |_: Mesh| Ok(Named("ObjectType", 32)));
}

/// A mesh that is asked and not changed: a script's own, without a copy.
pub(super) struct SharedMesh(pub(super) Arc<Mesh>);

impl Read for SharedMesh {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        Mesh::read(json).map(|mesh| Self(Arc::new(mesh)))
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Geometry(Geometry { shape: Shape::Mesh(mesh), .. }) => Ok(Self(mesh.clone())),
            other => Mesh::of_value(other).map(|mesh| Self(Arc::new(mesh))),
        }
    }

    fn type_name() -> String {
        Mesh::type_name()
    }
}

/// A face, by its corners: the last twice in a triangle.
#[derive(Clone, Copy)]
pub(super) struct Corners(pub(super) [i32; 4]);

impl Read for Corners {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        let corners: Vec<i32> = Vec::read(json)?;
        match *corners.as_slice() {
            [a, b, c] => Ok(Self([a, b, c, c])),
            [a, b, c, d] => Ok(Self([a, b, c, d])),
            _ => Err(Fault::bad_request(format!("has {} corners, not 3 or 4", corners.len()))),
        }
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Face(corners) => Ok(Self(*corners)),
            other => Self::read(&other.to_json(0)?),
        }
    }

    fn type_name() -> String {
        "MeshFace".into()
    }
}

/// Faces as the kernel has them.
pub(super) fn kernel_faces(faces: &[Corners]) -> Outcome<Vec<MeshFace>> {
    let index =
        |i: i32| u32::try_from(i).map_err(|_| Fault::bad_request(format!("a face has the corner {i}")));
    let one = |face: &Corners| {
        let [a, b, c, d] = face.0;
        let (a, b, c, d) = (index(a)?, index(b)?, index(c)?, index(d)?);
        Ok(if c == d { MeshFace::Triangle([a, b, c]) } else { MeshFace::Quad([a, b, c, d]) })
    };
    faces.iter().map(one).collect()
}

/// A face as scripts have it.
pub(super) fn face_value(face: &MeshFace) -> Value {
    let corner = |i: u32| i32::try_from(i).unwrap_or(-1);
    let [a, b, c, d] = match *face {
        MeshFace::Triangle([a, b, c]) => [a, b, c, c],
        MeshFace::Quad(corners) => corners,
    };
    Value::Face([corner(a), corner(b), corner(c), corner(d)])
}

/// The same mesh with other vertices, faces, normals or colours; normals and colours are kept where they fit.
pub(super) fn rebuilt(
    vertices: Vec<Point3>,
    faces: Vec<MeshFace>,
    normals: Vec<Vector3>,
    colours: Vec<[u8; 4]>,
) -> Outcome<Mesh> {
    let count = vertices.len();
    let normals = if normals.len() == count { normals } else { Vec::new() };
    let colours = if colours.len() == count { colours } else { Vec::new() };
    Ok(Mesh::from_parts(vertices, faces, normals, colours)?)
}

/// A colour as the kernel has it: red, green, blue, alpha.
pub(super) fn rgba(colour: Colour) -> [u8; 4] {
    [colour.r, colour.g, colour.b, colour.a]
}
