//! Writing OBJ: `v`, `vn`, `p`, `l`, `f`, with `o` for things and `g` for layers. Colours of vertices stand behind their
//! coordinates, where most readers look for them.

use std::io::Write;

use katydid_geometry::Mesh;

use super::{materials, share};
use crate::piece::{Form, Piece, pieces};
use crate::text::Text;
use crate::{LeftOut, Options, Result, Scene, needs_materials};

pub(crate) fn write(scene: &Scene, options: &Options, out: &mut dyn Write) -> Result<Vec<LeftOut>> {
    let (pieces, left_out) = pieces(scene, options);
    // Without a file for them, materials would only be names that lead nowhere.
    let library = options.materials.as_deref().filter(|_| needs_materials(scene));
    let mut writer = Writer {
        text: Text::new(out),
        vertices: 0,
        normals: 0,
        layer: None,
        thing: None,
        has_materials: library.is_some(),
        material: None,
    };
    writer.text.push("# Katydid, in ");
    writer.text.push(match scene.units.name() {
        "None" => "no unit",
        name => name,
    });
    writer.text.end_line()?;
    if let Some(library) = library {
        // A name ends with its line: blanks are part of it.
        let name: String = library.chars().map(|c| if c.is_control() { '_' } else { c }).collect();
        writer.text.push("mtllib ");
        writer.text.push(&name);
        writer.text.end_line()?;
    }
    for piece in &pieces {
        writer.headings(scene, piece)?;
        writer.piece(piece)?;
    }
    writer.text.flush()?;
    Ok(left_out)
}

struct Writer<'a> {
    text: Text<'a>,
    /// How many there are so far: OBJ counts them through the whole file.
    vertices: usize,
    normals: usize,
    /// The layer and the thing whose names were written last.
    layer: Option<usize>,
    thing: Option<usize>,
    has_materials: bool,
    /// The colour whose material was named last.
    material: Option<Option<[u8; 4]>>,
}

impl Writer<'_> {
    fn headings(&mut self, scene: &Scene, piece: &Piece<'_>) -> Result<()> {
        if self.thing == Some(piece.place) {
            return Ok(());
        }
        self.thing = Some(piece.place);
        if let Some(layer) = piece.thing.layer.filter(|layer| self.layer != Some(*layer)) {
            self.layer = Some(layer);
            self.heading("g ", &scene.layer_path(layer))?;
        }
        if piece.thing.name.is_empty() {
            // Without a heading it would belong to the thing before it.
            let title = piece.thing.title(piece.place);
            self.heading("o ", &title)?;
        } else {
            self.heading("o ", &piece.thing.name)?;
        }
        let colour = piece.thing.colour;
        if self.has_materials && self.material != Some(colour) {
            self.material = Some(colour);
            self.heading("usemtl ", &materials::name(colour))?;
        }
        Ok(())
    }

    fn heading(&mut self, word: &str, name: &str) -> Result<()> {
        self.text.push(word);
        self.text.push(&plain(name));
        self.text.end_line()
    }

    fn piece(&mut self, piece: &Piece<'_>) -> Result<()> {
        let colours = piece.colours();
        for (i, p) in piece.points().iter().enumerate() {
            self.text.push("v");
            self.text.reals([p.x, p.y, p.z]);
            if let Some([r, g, b, _]) = colours.get(i) {
                self.text.reals([*r, *g, *b].map(share));
            }
            self.text.end_line()?;
        }
        let count = piece.points().len();
        match &piece.form {
            Form::Points(_) => {
                for i in 1..=count {
                    self.text.push("p ");
                    self.text.whole(self.vertices + i);
                    self.text.end_line()?;
                }
            }
            Form::Polyline(_) => {
                self.text.push("l");
                for i in 1..=count {
                    self.text.push(" ");
                    self.text.whole(self.vertices + i);
                }
                self.text.end_line()?;
            }
            Form::Mesh(mesh) => self.faces(mesh)?,
        }
        self.vertices += count;
        Ok(())
    }

    fn faces(&mut self, mesh: &Mesh) -> Result<()> {
        for n in mesh.normals() {
            self.text.push("vn");
            self.text.reals([n.x, n.y, n.z]);
            self.text.end_line()?;
        }
        for face in mesh.faces() {
            self.text.push("f");
            for &i in face.indices() {
                self.text.push(" ");
                self.text.whole(self.vertices + i as usize + 1);
                if !mesh.normals().is_empty() {
                    self.text.push("//");
                    self.text.whole(self.normals + i as usize + 1);
                }
            }
            self.text.end_line()?;
        }
        self.normals += mesh.normals().len();
        Ok(())
    }
}

/// A name as one word: for most readers it ends at a blank, `#` begins a comment, and `\` joins lines.
fn plain(name: &str) -> String {
    let odd = |c: char| c.is_whitespace() || c.is_control() || c == '#' || c == '\\';
    name.chars().map(|c| if odd(c) { '_' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use katydid_geometry::{Line, MeshFace, Point3};

    use super::*;
    use crate::{Layer, Shape, Thing};

    fn square() -> Mesh {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
        Mesh::new(corners.to_vec(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap()
    }

    fn text(scene: &Scene) -> String {
        let mut out = Vec::new();
        write(scene, &Options::default(), &mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn indices_go_on_from_thing_to_thing() {
        let things = vec![
            Thing::named("a b#\\\u{7}ö", Shape::Points(vec![Point3::new(0.5, 0.25, -2.0)].into())),
            Thing::named("", Shape::Mesh(square().with_normals())),
            Thing::named("", Shape::Mesh(square().with_normals())),
            Thing::named(
                "line",
                Shape::Curve(Line::new(Point3::ORIGIN, Point3::new(1e-7, 0.0, 1e21)).into()),
            ),
        ];
        let text = text(&Scene { things, ..Scene::default() });
        assert!(
            text.starts_with("# Katydid, in Millimeters\no a_b___ö\nv 0.5 0.25 -2\np 1\no mesh_2\nv 0 0 0\n"),
            "{text}"
        );
        assert!(
            text.contains("f 2//1 3//2 4//3 5//4\n") && text.contains("f 6//5 7//6 8//7 9//8\n"),
            "{text}"
        );
        assert!(text.contains("v 1e-7 0 1e+21\n") && text.ends_with("l 10 11\n"), "{text}");
    }

    #[test]
    fn layers_are_groups_by_their_full_name() {
        let layer = |name: &str, parent| Layer { name: name.into(), parent };
        let on = |layer| Thing { layer: Some(layer), ..Thing::named("x", Shape::Mesh(square())) };
        let scene = Scene {
            layers: vec![layer("top", None), layer("in it", Some(0))],
            things: vec![on(1), on(1), on(0)],
            ..Scene::default()
        };
        let text = text(&scene);
        let groups: Vec<&str> = text.lines().filter(|line| line.starts_with("g ")).collect();
        assert_eq!(groups, ["g top::in_it", "g top"]);
    }

    #[test]
    fn colours_stand_behind_the_coordinates() {
        let coloured = square().with_colours(&[[255, 0, 51, 255]; 4]);
        let scene = Scene { things: vec![Thing::named("c", Shape::Mesh(coloured))], ..Scene::default() };
        assert!(text(&scene).contains("v 1 1 0 1 0 0.2\n"));
        for part in 0..=255_u8 {
            assert_eq!((share(part) * 255.0).round() as u8, part);
        }
    }
}
