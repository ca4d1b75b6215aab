//! Reading STL in either form. Corners in the same place become one vertex, and the normals of the file are left: they
//! follow from the corners.

use std::collections::HashMap;

use katydid_geometry::{Mesh, MeshFace, Point3};

use super::{FORMAT, HEADER, TRIANGLE};
use crate::{Error, LeftOut, Result, Scene, Shape, Thing};

pub(crate) fn read(bytes: &[u8]) -> Result<Scene> {
    // Many binary files begin with "solid" all the same: the size tells.
    let stated = bytes.get(HEADER..HEADER + 4).and_then(|n| n.try_into().ok()).map(u32::from_le_bytes);
    let body = bytes.get(HEADER + 4..).unwrap_or_default();
    let is_whole = stated.is_some_and(|n| (n as usize).checked_mul(TRIANGLE) == Some(body.len()));
    let says_solid =
        bytes.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    if says_solid && !is_whole {
        return read_ascii(bytes);
    }
    let Some(stated) = stated else {
        return Err(Error::malformed(FORMAT, "byte 0", "it is shorter than a header"));
    };
    read_binary(stated, body)
}

/// Triangles, each corner a place among the vertices.
#[derive(Default)]
struct Triangles {
    places: HashMap<[u32; 3], u32>,
    vertices: Vec<Point3>,
    faces: Vec<MeshFace>,
}

impl Triangles {
    fn add(&mut self, corners: [[f32; 3]; 3]) {
        let indices = corners.map(|corner| {
            // 0 and −0 are the same place.
            let key = corner.map(|x| (x + 0.0).to_bits());
            let vertices = &mut self.vertices;
            // Three corners to 50 bytes: files do not come near 2³² vertices.
            *self.places.entry(key).or_insert_with(|| {
                vertices.push(Point3::from(corner.map(f64::from)));
                u32::try_from(vertices.len() - 1).unwrap_or(u32::MAX)
            })
        });
        self.faces.push(MeshFace::Triangle(indices));
    }

    fn into_thing(self, name: &str) -> Result<Option<Thing>> {
        if self.faces.is_empty() {
            return Ok(None);
        }
        let mesh = Mesh::new(self.vertices, self.faces)
            .map_err(|error| Error::malformed(FORMAT, "the triangles", error.to_string()))?;
        Ok(Some(Thing::named(name, Shape::Mesh(mesh))))
    }
}

fn read_binary(stated: u32, body: &[u8]) -> Result<Scene> {
    let records = body.chunks_exact(TRIANGLE);
    let present = records.len();
    let mut triangles = Triangles::default();
    for record in records.take(stated as usize) {
        let mut numbers =
            record.chunks_exact(4).skip(3).map(|x| f32::from_le_bytes(x.try_into().unwrap_or_default()));
        let mut corner = || [(); 3].map(|()| numbers.next().unwrap_or_default());
        triangles.add([corner(), corner(), corner()]);
    }
    let mut scene = Scene::default();
    scene.things.extend(triangles.into_thing("")?);
    let missing = (stated as usize).saturating_sub(present);
    if missing > 0 {
        scene.left_out.push(LeftOut::new("triangle", missing, "the file ends before them"));
    }
    Ok(scene)
}

fn read_ascii(bytes: &[u8]) -> Result<Scene> {
    let text = String::from_utf8_lossy(bytes);
    let mut scene = Scene::default();
    let (mut name, mut triangles, mut corners) = (String::new(), Triangles::default(), Vec::with_capacity(3));
    for (number, line) in text.lines().enumerate() {
        let wrong = |why: String| Error::malformed(FORMAT, format!("line {}", number + 1), why);
        let line = line.trim();
        let word = line.split_ascii_whitespace().next().unwrap_or_default();
        match word.to_ascii_lowercase().as_str() {
            "solid" => name = line.get(word.len()..).unwrap_or_default().trim().to_owned(),
            "vertex" => {
                let numbers = line
                    .split_ascii_whitespace()
                    .skip(1)
                    .map(|x| x.parse::<f32>().ok().filter(|x| x.is_finite()));
                let numbers =
                    numbers.collect::<Option<Vec<f32>>>().and_then(|n| <[f32; 3]>::try_from(n).ok());
                corners.push(numbers.ok_or_else(|| wrong("a vertex has three numbers".into()))?);
            }
            "endloop" => {
                let found = corners.len();
                let corners = <[_; 3]>::try_from(std::mem::take(&mut corners))
                    .map_err(|_| wrong(format!("a facet has 3 corners, not {found}")))?;
                triangles.add(corners);
            }
            "endsolid" => scene.things.extend(std::mem::take(&mut triangles).into_thing(&name)?),
            _ => {}
        }
    }
    scene.things.extend(triangles.into_thing(&name)?);
    Ok(scene)
}
