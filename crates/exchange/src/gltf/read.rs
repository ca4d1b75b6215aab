//! Reading: every primitive of every node of the scene becomes a thing, in metres with z up.

use katydid_geometry::{Line, Mesh, MeshFace, Point3, PolylineCurve, Quaternion, Vector3, Xform};

use super::colour;
use super::file::{File, Node, Primitive, malformed};
use crate::{Error, Layer, LeftOut, PointSet, Result, Scene, Shape, Thing};

/// Nodes deeper than this, and vertices beyond this through meshes that many nodes show, are refused.
const DEEPEST: usize = 256;
const MOST_VERTICES: usize = 1 << 26;

pub(crate) fn read(bytes: &[u8], fetch: &mut dyn FnMut(&str) -> Result<Vec<u8>>) -> Result<Scene> {
    let file = File::open(bytes, fetch)?;
    let mut reader = Reader {
        scene: Scene {
            units: katydid_geometry::Units::Meters,
            metres: 1.0,
            tolerance: 1e-6,
            ..Scene::default()
        },
        seen: vec![false; file.json.nodes.len()],
        vertices: 0,
        file: &file,
    };
    // x stays, y goes up to z, z comes forward to −y.
    let up = Xform {
        rows: [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]],
    };
    for node in roots(&file)? {
        reader.node(node, &up, None, 0)?;
    }
    Ok(reader.scene)
}

/// The nodes of the scene that is to be shown; without scenes, those that are nobody's children.
fn roots(file: &File<'_>) -> Result<Vec<usize>> {
    let json = &file.json;
    if json.scenes.is_empty() {
        let mut is_child = vec![false; json.nodes.len()];
        for child in json.nodes.iter().flat_map(|node| &node.children) {
            if let Some(is_child) = is_child.get_mut(*child) {
                *is_child = true;
            }
        }
        return Ok((0..json.nodes.len()).filter(|node| is_child.get(*node) == Some(&false)).collect());
    }
    let scene = json.scenes.get(json.scene.unwrap_or(0));
    Ok(scene.ok_or_else(|| malformed("the scene", "it is not there"))?.nodes.clone())
}

struct Reader<'a> {
    file: &'a File<'a>,
    scene: Scene,
    /// The nodes that were visited: each has its place once.
    seen: Vec<bool>,
    vertices: usize,
}

impl Reader<'_> {
    fn node(&mut self, index: usize, above: &Xform, layer: Option<usize>, depth: usize) -> Result<()> {
        let file = self.file;
        let place = || format!("node {index}");
        let node = file.json.nodes.get(index).ok_or_else(|| malformed(place(), "it is not there"))?;
        if depth > DEEPEST || self.seen.get(index) != Some(&false) {
            return Err(malformed(place(), "the nodes are no tree, or too deep a one"));
        }
        self.seen[index] = true;
        let xform = *above * own(node);
        if !xform.is_finite() {
            return Err(malformed(place(), "its place is not finite"));
        }
        if let Some(mesh) = node.mesh {
            let mesh =
                file.json.meshes.get(mesh).ok_or_else(|| malformed(place(), "its mesh is not there"))?;
            let name = if node.name.is_empty() { &mesh.name } else { &node.name };
            for primitive in &mesh.primitives {
                self.primitive(primitive, name, &xform, layer)?;
            }
        }
        let layer = match (node.children.is_empty(), node.mesh) {
            (false, None) if !node.name.is_empty() => {
                self.scene.layers.push(Layer { name: node.name.clone(), parent: layer });
                Some(self.scene.layers.len() - 1)
            }
            _ => layer,
        };
        node.children.iter().try_for_each(|child| self.node(*child, &xform, layer, depth + 1))
    }

    fn primitive(
        &mut self,
        primitive: &Primitive,
        name: &str,
        xform: &Xform,
        layer: Option<usize>,
    ) -> Result<()> {
        let file = self.file;
        let Some(position) = primitive.attributes.position else {
            LeftOut::add(&mut self.scene.left_out, LeftOut::new("primitive", 1, "it has no positions"));
            return Ok(());
        };
        let points: Vec<Point3> =
            file.rows::<3>(position)?.into_iter().map(|p| xform.point(Point3::from(p))).collect();
        self.vertices += points.len();
        if self.vertices > MOST_VERTICES {
            let what = format!("more than {MOST_VERTICES} vertices in all its nodes");
            return Err(Error::TooLarge { format: super::FORMAT, what });
        }
        if !points.iter().all(|p| p.is_finite()) {
            return Err(malformed(format!("accessor {position}"), "a coordinate is not finite"));
        }
        let corners = match primitive.indices {
            Some(indices) => file.indices(indices)?,
            None => (0..u32::try_from(points.len()).unwrap_or(u32::MAX)).collect(),
        };
        if corners.iter().any(|i| *i as usize >= points.len()) {
            return Err(malformed(format!("accessor {position}"), "an index beyond its points"));
        }
        let normals = match primitive.attributes.normal {
            Some(normal) => {
                let turn = normal_map(xform);
                let rows = file.rows::<3>(normal)?.into_iter();
                rows.map(|n| turn.vector(Vector3::from(n)).unitized().unwrap_or(Vector3::ZERO)).collect()
            }
            None => Vec::new(),
        };
        let colours = match primitive.attributes.colour {
            Some(colour) => self.colours(colour)?,
            None => Vec::new(),
        };
        let set = PointSet {
            normals: if normals.len() == points.len() { normals } else { Vec::new() },
            colours: if colours.len() == points.len() { colours } else { Vec::new() },
            points,
        };
        let flips = xform.determinant() < 0.0;
        let colour = primitive.material.and_then(|material| self.material(material));
        for shape in shapes(primitive.mode.unwrap_or(4), set, &corners, flips)? {
            self.scene.things.push(Thing { name: name.to_owned(), layer, colour, shape });
        }
        Ok(())
    }

    /// Colours of vertices as the screen shows them. Colours without alpha are opaque.
    fn colours(&self, accessor: usize) -> Result<Vec<[u8; 4]>> {
        let has_alpha = self.file.json.accessors.get(accessor).is_some_and(|a| a.r#type == "VEC4");
        let rows = self.file.rows::<4>(accessor)?.into_iter();
        Ok(rows
            .map(|[r, g, b, a]| {
                let alpha = if has_alpha { (a * 255.0).round() as u8 } else { 255 };
                [colour::to_screen(r), colour::to_screen(g), colour::to_screen(b), alpha]
            })
            .collect())
    }

    fn material(&self, material: usize) -> Option<[u8; 4]> {
        let [r, g, b, a] = self.file.json.materials.get(material)?.pbr_metallic_roughness.base_color_factor?;
        let alpha = (a.clamp(0.0, 1.0) * 255.0).round() as u8;
        Some([colour::to_screen(r), colour::to_screen(g), colour::to_screen(b), alpha])
    }
}

/// A node's own motion: a matrix by columns, or scale, then rotation, then translation.
fn own(node: &Node) -> Xform {
    if let Some(m) = node.matrix {
        let row = |i: usize| [m[i], m[4 + i], m[8 + i], m[12 + i]];
        return Xform { rows: [row(0), row(1), row(2), row(3)] };
    }
    let [tx, ty, tz] = node.translation.unwrap_or_default();
    let [sx, sy, sz] = node.scale.unwrap_or([1.0; 3]);
    let [x, y, z, w] = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
    let turn = Quaternion { w, x, y, z }.unitized().and_then(Quaternion::to_xform).unwrap_or(Xform::IDENTITY);
    Xform::translation(Vector3::new(tx, ty, tz)) * turn * Xform::diagonal(sx, sy, sz)
}

/// The motion of normals: the inverse transposed, of the linear part.
fn normal_map(xform: &Xform) -> Xform {
    xform.inverse().map_or(*xform, |inverse| inverse.transposed().linear_part())
}

/// The shapes of a primitive by its mode.
fn shapes(mode: u32, set: PointSet, corners: &[u32], flips: bool) -> Result<Vec<Shape>> {
    let wrong = |error: katydid_geometry::Error| malformed("a primitive", error.to_string());
    let point = |i: &u32| set.points.get(*i as usize).copied().unwrap_or_default();
    let line = |a: &u32, b: &u32| Some(Line::new(point(a), point(b))).filter(|l| l.from != l.to);
    let faces: Vec<[u32; 3]> = match mode {
        0 => return Ok(vec![Shape::Points(set)]),
        1 => {
            let lines = corners.chunks_exact(2).filter_map(|w| line(w.first()?, w.get(1)?));
            return Ok(lines.map(|line| Shape::Curve(line.into())).collect());
        }
        2 | 3 => {
            let ends = corners.iter().chain(corners.first().filter(|_| mode == 2));
            let mut points: Vec<Point3> = ends.map(point).collect();
            points.dedup();
            return Ok(match *points.as_slice() {
                [] | [_] => Vec::new(),
                [a, b] => vec![Shape::Curve(Line::new(a, b).into())],
                _ => vec![Shape::Curve(PolylineCurve::new(points).map_err(wrong)?.into())],
            });
        }
        4 => corners.chunks_exact(3).filter_map(|w| w.try_into().ok()).collect(),
        5 => {
            let strips = corners.windows(3).enumerate().filter_map(|(i, w)| match (w, i % 2) {
                (&[a, b, c], 0) => Some([a, b, c]),
                (&[a, b, c], _) => Some([b, a, c]),
                _ => None,
            });
            strips.filter(|[a, b, c]| a != b && b != c && a != c).collect()
        }
        6 => {
            let Some((&a, rim)) = corners.split_first() else { return Ok(Vec::new()) };
            rim.windows(2).filter_map(|w| Some([a, *w.first()?, *w.get(1)?])).collect()
        }
        other => return Err(malformed("a primitive", format!("mode {other} is not known"))),
    };
    // A mirror turns faces over.
    let faces =
        faces.into_iter().map(|[a, b, c]| MeshFace::Triangle(if flips { [a, c, b] } else { [a, b, c] }));
    let mesh = Mesh::from_parts(set.points, faces.collect(), set.normals, set.colours).map_err(wrong)?;
    Ok(if mesh.faces().is_empty() { Vec::new() } else { vec![Shape::Mesh(mesh)] })
}
