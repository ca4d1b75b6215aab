//! Writing STL in either form.

use std::io::Write;

use katydid_geometry::{Mesh, Point3, Vector3};

use super::{FORMAT, HEADER, TRIANGLE};
use crate::text::Text;
use crate::{Error, LeftOut, Options, Result, Scene, Shape, Thing};

pub(crate) fn write(scene: &Scene, options: &Options, out: &mut dyn Write) -> Result<Vec<LeftOut>> {
    let mut left_out = Vec::new();
    let mut meshes = Vec::new();
    for (place, thing) in scene.things.iter().enumerate() {
        match &thing.shape {
            Shape::Mesh(mesh) | Shape::Faces { facets: Some(mesh), .. } => {
                check_range(mesh, thing, place)?;
                meshes.push((thing, place, mesh));
            }
            other => {
                let left = LeftOut::new(other.kind(), 1, "STL holds triangles only");
                LeftOut::add(&mut left_out, left);
            }
        }
    }
    if options.ascii {
        write_ascii(&meshes, out)?
    } else {
        write_binary(&meshes, out)?
    }
    Ok(left_out)
}

type Named<'a> = (&'a Thing, usize, &'a Mesh);

/// Refuses coordinates that single precision would turn into infinity.
fn check_range(mesh: &Mesh, thing: &Thing, place: usize) -> Result<()> {
    let numbers = mesh.vertices().iter().flat_map(|p| [p.x, p.y, p.z]);
    match numbers.into_iter().find(|x| !(*x as f32).is_finite()) {
        Some(value) => Err(Error::Coordinate { what: thing.title(place), format: FORMAT, value }),
        None => Ok(()),
    }
}

/// The normal of a triangle by its corners in the order they have; zero where it has no area.
fn normal([a, b, c]: [Point3; 3]) -> Vector3 {
    (b - a).cross(c - a).unitized().unwrap_or(Vector3::ZERO)
}

fn write_binary(meshes: &[Named<'_>], out: &mut dyn Write) -> Result<()> {
    let count: usize =
        meshes.iter().flat_map(|(.., mesh)| mesh.faces()).map(|face| face.triangles().count()).sum();
    let count = u32::try_from(count)
        .map_err(|_| Error::TooLarge { format: FORMAT, what: format!("{count} triangles") })?;
    let mut bytes = Text::new(out);
    let mut header = [b' '; HEADER];
    // A header must not begin with the word solid, by which readers tell the form that is text.
    let title = b"Katydid, binary STL";
    header[..title.len()].copy_from_slice(title);
    bytes.bytes(&header)?;
    bytes.bytes(&count.to_le_bytes())?;
    for (.., mesh) in meshes {
        for corners in mesh.triangles() {
            let [a, b, c] = corners;
            let mut record = [0; TRIANGLE];
            let numbers = [normal(corners), a.to_vector(), b.to_vector(), c.to_vector()];
            let numbers = numbers.into_iter().flat_map(|v| [v.x, v.y, v.z]);
            for (place, x) in record.chunks_exact_mut(4).zip(numbers) {
                place.copy_from_slice(&(x as f32).to_le_bytes());
            }
            bytes.bytes(&record)?;
        }
    }
    bytes.flush()
}

fn write_ascii(meshes: &[Named<'_>], out: &mut dyn Write) -> Result<()> {
    let mut text = Text::new(out);
    let numbers = |text: &mut Text<'_>, before: &str, v: Vector3| -> Result<()> {
        text.push(before);
        for x in [v.x, v.y, v.z] {
            text.push(" ");
            text.short_real(x as f32);
        }
        text.end_line()
    };
    for (thing, place, mesh) in meshes {
        let title: String =
            thing.title(*place).chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        text.push("solid ");
        text.push(&title);
        text.end_line()?;
        for corners in mesh.triangles() {
            numbers(&mut text, "facet normal", normal(corners))?;
            text.push("outer loop\n");
            for corner in corners {
                numbers(&mut text, "vertex", corner.to_vector())?;
            }
            text.push("endloop\nendfacet\n");
        }
        text.push("endsolid ");
        text.push(&title);
        text.end_line()?;
    }
    if meshes.is_empty() {
        text.push("solid empty\nendsolid empty\n");
    }
    text.flush()
}

#[cfg(test)]
mod tests {
    use katydid_geometry::MeshFace;

    use super::*;

    fn scene(size: f64) -> Scene {
        let corners =
            [[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]].map(|[x, y]| Point3::new(x, y, 0.0));
        let mesh = Mesh::new(corners.to_vec(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap();
        let point = Shape::Points(vec![Point3::ORIGIN].into());
        let things = vec![Thing::named("a\nsquare", Shape::Mesh(mesh)), Thing::named("", point)];
        Scene { things, ..Scene::default() }
    }

    #[test]
    fn a_quad_is_two_triangles_of_fifty_bytes() {
        let mut bytes = Vec::new();
        let left_out = write(&scene(1.0), &Options::default(), &mut bytes).unwrap();
        assert_eq!(bytes.len(), 84 + 2 * 50);
        assert_eq!(bytes[80..84], 2u32.to_le_bytes());
        assert_eq!(bytes[84 + 8..84 + 12], 1f32.to_le_bytes(), "the normal looks up");
        assert_eq!(left_out, [LeftOut::new("point", 1, "STL holds triangles only")]);
    }

    #[test]
    fn the_text_form_names_its_solids() {
        let mut bytes = Vec::new();
        write(&scene(1.0), &Options { ascii: true, ..Options::default() }, &mut bytes).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        assert!(
            text.starts_with("solid a square\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"),
            "{text}"
        );
        assert!(text.ends_with("endloop\nendfacet\nendsolid a square\n"), "{text}");
    }

    #[test]
    fn what_single_precision_cannot_hold_is_refused() {
        let error = write(&scene(1e39), &Options::default(), &mut Vec::new()).unwrap_err();
        assert!(error.to_string().contains("cannot hold: 1000000000000000000000"), "{error}");
    }
}
