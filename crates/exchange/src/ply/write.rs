//! Writing PLY: all vertices in double precision, then the faces, then the edges of polylines.

use std::io::Write;

use katydid_geometry::Vector3;

use super::FORMAT;
use crate::piece::{Form, Piece, pieces};
use crate::text::Text;
use crate::{Error, LeftOut, Options, Result, Scene};

pub(crate) fn write(scene: &Scene, options: &Options, out: &mut dyn Write) -> Result<Vec<LeftOut>> {
    let (pieces, left_out) = pieces(scene, options);
    let layout = Layout::of(&pieces)?;
    let mut writer = Writer { text: Text::new(out), ascii: options.ascii, layout };
    writer.header(scene)?;
    for piece in &pieces {
        writer.vertices(piece)?;
    }
    let mut first = 0;
    for piece in &pieces {
        writer.faces(piece, first)?;
        first += piece.points().len();
    }
    first = 0;
    for piece in &pieces {
        writer.edges(piece, first)?;
        first += piece.points().len();
    }
    writer.text.flush()?;
    Ok(left_out)
}

/// How many of each element there are, and what a vertex has.
struct Layout {
    vertices: usize,
    faces: usize,
    edges: usize,
    normals: bool,
    colours: bool,
}

impl Layout {
    fn of(pieces: &[Piece<'_>]) -> Result<Self> {
        let mut layout = Self { vertices: 0, faces: 0, edges: 0, normals: false, colours: false };
        for piece in pieces {
            layout.vertices += piece.points().len();
            match &piece.form {
                Form::Mesh(mesh) => layout.faces += mesh.faces().len(),
                Form::Polyline(points) => layout.edges += points.len().saturating_sub(1),
                Form::Points(_) => {}
            }
            layout.normals |= !piece.normals().is_empty();
            layout.colours |= !piece.colours().is_empty() || piece.thing.colour.is_some();
        }
        // Indices are written as int, which every reader takes.
        if i32::try_from(layout.vertices).is_err() {
            return Err(Error::TooLarge { format: FORMAT, what: format!("{} vertices", layout.vertices) });
        }
        Ok(layout)
    }
}

struct Writer<'a> {
    text: Text<'a>,
    ascii: bool,
    layout: Layout,
}

impl Writer<'_> {
    fn header(&mut self, scene: &Scene) -> Result<()> {
        let form = if self.ascii { "ascii" } else { "binary_little_endian" };
        let Layout { vertices, faces, edges, normals, colours } = self.layout;
        let mut header = format!(
            "ply\nformat {form} 1.0\ncomment Katydid, in {}\nelement vertex {vertices}\n",
            scene.units.name()
        );
        header.push_str("property double x\nproperty double y\nproperty double z\n");
        if normals {
            header.push_str("property float nx\nproperty float ny\nproperty float nz\n");
        }
        if colours {
            for part in ["red", "green", "blue", "alpha"] {
                header.push_str(&format!("property uchar {part}\n"));
            }
        }
        if faces > 0 {
            header.push_str(&format!("element face {faces}\nproperty list uchar int vertex_indices\n"));
        }
        if edges > 0 {
            header.push_str(&format!("element edge {edges}\nproperty int vertex1\nproperty int vertex2\n"));
        }
        header.push_str("end_header\n");
        self.text.bytes(header.as_bytes())
    }

    fn vertices(&mut self, piece: &Piece<'_>) -> Result<()> {
        let (normals, colours) = (piece.normals(), piece.colours());
        let plain = piece.thing.colour.unwrap_or([255; 4]);
        for (i, p) in piece.points().iter().enumerate() {
            let normal = self.layout.normals.then(|| normals.get(i).copied().unwrap_or(Vector3::ZERO));
            let colour = self.layout.colours.then(|| colours.get(i).copied().unwrap_or(plain));
            if self.ascii {
                self.text.real(p.x);
                self.text.push(" ");
                self.text.real(p.y);
                self.text.push(" ");
                self.text.real(p.z);
                for x in normal.iter().flat_map(|n| [n.x, n.y, n.z]) {
                    self.text.push(" ");
                    self.text.short_real(x as f32);
                }
                for part in colour.into_iter().flatten() {
                    self.text.push(" ");
                    self.text.whole(part.into());
                }
                self.text.end_line()?;
                continue;
            }
            let mut record = [0; 24];
            for (place, x) in record.chunks_exact_mut(8).zip([p.x, p.y, p.z]) {
                place.copy_from_slice(&x.to_le_bytes());
            }
            self.text.bytes(&record)?;
            for x in normal.iter().flat_map(|n| [n.x, n.y, n.z]) {
                self.text.bytes(&(x as f32).to_le_bytes())?;
            }
            if let Some(colour) = colour {
                self.text.bytes(&colour)?;
            }
        }
        Ok(())
    }

    fn faces(&mut self, piece: &Piece<'_>, first: usize) -> Result<()> {
        let Form::Mesh(mesh) = &piece.form else { return Ok(()) };
        for face in mesh.faces() {
            let corners = face.indices();
            if self.ascii {
                self.text.whole(corners.len());
                for &i in corners {
                    self.text.push(" ");
                    self.text.whole(first + i as usize);
                }
                self.text.end_line()?;
                continue;
            }
            // Four indices behind the count of them, of which a triangle needs three.
            let mut record = [0; 17];
            record[0] = corners.len() as u8;
            for (place, &i) in record[1..].chunks_exact_mut(4).zip(corners) {
                place.copy_from_slice(&((first + i as usize) as i32).to_le_bytes());
            }
            self.text.bytes(record.get(..1 + 4 * corners.len()).unwrap_or_default())?;
        }
        Ok(())
    }

    fn edges(&mut self, piece: &Piece<'_>, first: usize) -> Result<()> {
        let Form::Polyline(points) = &piece.form else { return Ok(()) };
        for end in 1..points.len() {
            let ends = [first + end - 1, first + end];
            if self.ascii {
                self.text.whole(ends[0]);
                self.text.push(" ");
                self.text.whole(ends[1]);
                self.text.end_line()?;
                continue;
            }
            for end in ends {
                self.text.bytes(&(end as i32).to_le_bytes())?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use katydid_geometry::{Curve, Mesh, MeshFace, Point3, PolylineCurve};

    use super::*;
    use crate::{Shape, Thing};

    #[test]
    fn the_text_form_reads_as_it_says() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
        let mesh = Mesh::new(corners.to_vec(), vec![MeshFace::Triangle([0, 1, 2])]).unwrap();
        let line: Curve = PolylineCurve::new(corners.to_vec()).unwrap().into();
        let red = Thing { colour: Some([255, 0, 0, 255]), ..Thing::named("", Shape::Mesh(mesh)) };
        let scene = Scene { things: vec![red, Thing::named("", Shape::Curve(line))], ..Scene::default() };
        let mut bytes = Vec::new();
        write(&scene, &Options { ascii: true, ..Options::default() }, &mut bytes).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        let (_, body) = text.split_once("end_header\n").unwrap();
        let expected = "0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0.5 1 0 255 0 0 255\n\
                        0 0 0 255 255 255 255\n1 0 0 255 255 255 255\n0.5 1 0 255 255 255 255\n\
                        3 0 1 2\n3 4\n4 5\n";
        assert_eq!(body, expected);
        assert!(text.contains("element vertex 6\n") && text.contains("element edge 2\n"), "{text}");
    }
}
