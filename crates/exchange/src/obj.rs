//! Wavefront OBJ, as the Advanced Visualizer manual describes it: `v`, `p`, `l`, `f` and `o` statements.

use std::fmt::Write;

use katydid_geometry::Point3;

use crate::scene::points;
use crate::{Scene, Shape, Written};

pub(crate) fn write(scene: &Scene) -> Written {
    let mut text = String::from("# Katydid\n");
    let mut used = 0;
    for thing in &scene.things {
        // A name ends at a blank for most readers.
        let name: String =
            thing.name.chars().map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c }).collect();
        if !name.is_empty() {
            let _ = writeln!(text, "o {name}");
        }
        let vertices: Vec<Point3> = match &thing.shape {
            Shape::Point(p) => vec![*p],
            Shape::Curve(curve) => points(curve),
            Shape::Mesh(mesh) => mesh.vertices().to_vec(),
        };
        for v in &vertices {
            let _ = writeln!(text, "v {} {} {}", v.x, v.y, v.z);
        }
        let index = |i: usize| used + i + 1;
        match &thing.shape {
            Shape::Point(_) => {
                let _ = writeln!(text, "p {}", index(0));
            }
            Shape::Curve(_) => {
                text.push('l');
                for i in 0..vertices.len() {
                    let _ = write!(text, " {}", index(i));
                }
                text.push('\n');
            }
            Shape::Mesh(mesh) => {
                for face in mesh.faces() {
                    text.push('f');
                    for &i in face.indices() {
                        let _ = write!(text, " {}", index(i as usize));
                    }
                    text.push('\n');
                }
            }
        }
        used += vertices.len();
    }
    Written { bytes: text.into_bytes(), left_out: scene.left_out() }
}

#[cfg(test)]
mod tests {
    use katydid_geometry::{Mesh, MeshFace};

    use super::*;
    use crate::Thing;

    #[test]
    fn indices_go_on_from_thing_to_thing() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
        let mesh = Mesh::new(corners.to_vec(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap();
        let scene = Scene {
            things: vec![
                Thing { name: "a b".into(), shape: Shape::Point(Point3::new(0.5, 0.25, -2.0)) },
                Thing { name: String::new(), shape: Shape::Mesh(mesh) },
            ],
            unknown: vec!["Brep".into(), "Brep".into()],
        };
        let written = write(&scene);
        let text = String::from_utf8(written.bytes).unwrap();
        assert!(text.contains("o a_b\nv 0.5 0.25 -2\np 1\n") && text.ends_with("f 2 3 4 5\n"), "{text}");
        assert_eq!(written.left_out, ["2 × Brep"]);
    }
}
