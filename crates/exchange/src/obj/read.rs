//! Reading OBJ: vertices with colours and normals, points, lines, faces, and the names over them. Of materials
//! the colours count. Curves and surfaces in parameters are passed over and counted, textures are passed over.

use std::collections::HashMap;

use katydid_geometry::{Curve, Line, Mesh, MeshFace, Point3, PolylineCurve, Vector3};

use super::{FORMAT, materials, rest};
use crate::{Error, Layer, LeftOut, PointSet, Result, Scene, Shape, Thing};

/// Files of materials that one OBJ may name.
const MOST_LIBRARIES: usize = 64;

/// Gives the bytes of a file by the name that stands in another.
type Fetch<'a> = &'a mut dyn FnMut(&str) -> Result<Vec<u8>>;

pub(crate) fn read(bytes: &[u8], fetch: Fetch<'_>) -> Result<Scene> {
    let text = String::from_utf8_lossy(bytes);
    let mut reader = Reader::default();
    let mut joined = String::new();
    for (number, line) in text.lines().enumerate() {
        // A line that ends in \ goes on in the next.
        if let Some(start) = line.strip_suffix('\\') {
            joined.push_str(start);
            joined.push(' ');
            continue;
        }
        let whole = if joined.is_empty() {
            line
        } else {
            joined.push_str(line);
            joined.as_str()
        };
        if let Some(names) = whole.trim_start().strip_prefix("mtllib ") {
            reader.materials(names.trim(), fetch);
        }
        reader.line(whole).map_err(|why| Error::malformed(FORMAT, format!("line {}", number + 1), why))?;
        joined.clear();
    }
    Ok(reader.into_scene())
}

type Told<T> = std::result::Result<T, String>;

#[derive(Default)]
struct Reader {
    points: Vec<Point3>,
    /// Colours of the first vertices; as many as vertices when all have one.
    colours: Vec<[u8; 4]>,
    normals: Vec<Vector3>,
    scene: Scene,
    layers: HashMap<String, usize>,
    layer: Option<usize>,
    name: String,
    /// The colours of materials, and that of the one in use.
    materials: HashMap<String, Option<[u8; 4]>>,
    /// How many files of materials were named.
    libraries: usize,
    colour: Option<[u8; 4]>,
    part: Part,
}

/// What was read since the last name.
#[derive(Default)]
struct Part {
    /// For a vertex of the file and a normal, the vertex of this part.
    corners: HashMap<(usize, Option<usize>), u32>,
    vertices: Vec<(usize, Option<usize>)>,
    faces: Vec<MeshFace>,
    points: Vec<usize>,
}

impl Reader {
    fn line(&mut self, line: &str) -> Told<()> {
        let mut words = line.split_ascii_whitespace();
        let Some(word) = words.next() else { return Ok(()) };
        match word {
            "v" => self.vertex(words),
            "vn" => {
                let [x, y, z] = three(&mut words)?;
                self.normals.push(Vector3::new(x, y, z));
                Ok(())
            }
            "p" => {
                for word in words {
                    let point = index(word, self.points.len())?;
                    self.part.points.push(point);
                }
                Ok(())
            }
            "l" => self.polyline(words),
            "f" | "fo" => self.face(words),
            "o" => {
                self.end_part()?;
                self.name = rest(line, word).to_owned();
                Ok(())
            }
            "g" => {
                self.end_part()?;
                self.group(rest(line, word));
                Ok(())
            }
            "usemtl" => {
                let colour = self.materials.get(rest(line, word)).copied().flatten();
                if colour != self.colour {
                    self.end_part()?;
                    self.colour = colour;
                }
                Ok(())
            }
            "curv" | "curv2" | "surf" => {
                let class = if word == "surf" { "surface" } else { "curve" };
                LeftOut::add(
                    &mut self.scene.left_out,
                    LeftOut::new(class, 1, "curves and surfaces of OBJ are not supported"),
                );
                Ok(())
            }
            // Textures, smoothing groups, comments and what later programs added.
            _ => Ok(()),
        }
    }

    /// Reads files of materials. Their name may have blanks, or be several.
    fn materials(&mut self, names: &str, fetch: Fetch<'_>) {
        self.libraries += 1;
        if self.libraries > MOST_LIBRARIES {
            let why = format!("more than {MOST_LIBRARIES} are not opened");
            return LeftOut::add(&mut self.scene.left_out, LeftOut::new("file of materials", 1, why));
        }
        if let Ok(bytes) = fetch(names) {
            return materials::read(&bytes, &mut self.materials);
        }
        for name in names.split_ascii_whitespace() {
            match fetch(name) {
                Ok(bytes) => materials::read(&bytes, &mut self.materials),
                Err(error) => {
                    LeftOut::add(
                        &mut self.scene.left_out,
                        LeftOut::new("file of materials", 1, error.to_string()),
                    );
                }
            }
        }
    }

    fn vertex<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Told<()> {
        let numbers = words.take(7).map(number).collect::<Told<Vec<f64>>>()?;
        let (place, colour) = match *numbers.as_slice() {
            [x, y, z] | [x, y, z, _] => ([x, y, z], None),
            [x, y, z, r, g, b] => ([x, y, z], Some([r, g, b])),
            [x, y, z, _, r, g, b] => ([x, y, z], Some([r, g, b])),
            _ => return Err(format!("a vertex has 3 numbers, not {}", numbers.len())),
        };
        if let Some(colour) = colour.filter(|_| self.colours.len() == self.points.len()) {
            let [r, g, b] = colour.map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8);
            self.colours.push([r, g, b, 255]);
        }
        self.points.push(Point3::from(place));
        Ok(())
    }

    fn polyline<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Told<()> {
        let mut points = Vec::new();
        for word in words {
            let place = index(word.split('/').next().unwrap_or_default(), self.points.len())?;
            let point = self.points.get(place).copied().unwrap_or_default();
            if points.last() != Some(&point) {
                points.push(point);
            }
        }
        let curve: Curve = match *points.as_slice() {
            [] | [_] => return Ok(()),
            [from, to] => Line::new(from, to).into(),
            _ => PolylineCurve::new(points).map_err(|error| error.to_string())?.into(),
        };
        self.add(Shape::Curve(curve));
        Ok(())
    }

    fn face<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Told<()> {
        let mut corners: Vec<u32> = Vec::new();
        for word in words {
            let mut numbers = word.split('/');
            let vertex = index(numbers.next().unwrap_or_default(), self.points.len())?;
            let normal = match numbers.nth(1) {
                None | Some("") => None,
                Some(word) => Some(index(word, self.normals.len())?),
            };
            let vertices = &mut self.part.vertices;
            let next = u32::try_from(vertices.len())
                .map_err(|_| "more vertices than an index can count".to_owned())?;
            let corner = *self.part.corners.entry((vertex, normal)).or_insert_with(|| {
                vertices.push((vertex, normal));
                next
            });
            corners.push(corner);
        }
        match *corners.as_slice() {
            [a, b, c] => self.part.faces.push(MeshFace::Triangle([a, b, c])),
            [a, b, c, d] => self.part.faces.push(MeshFace::Quad([a, b, c, d])),
            [] | [_] | [_, _] => return Err("a face has at least 3 corners".to_owned()),
            [a, ..] => {
                let fan = corners.windows(2).skip(1).filter_map(|w| <[u32; 2]>::try_from(w).ok());
                self.part.faces.extend(fan.map(|[b, c]| MeshFace::Triangle([a, b, c])));
            }
        }
        Ok(())
    }

    /// A group is a layer: its name, as katydid writes them, may have parents.
    fn group(&mut self, path: &str) {
        if path.is_empty() || path == "default" {
            self.layer = None;
            return;
        }
        let mut parent = None;
        let mut so_far = String::new();
        for name in path.split("::") {
            so_far.push_str("::");
            so_far.push_str(name);
            let layers = &mut self.scene.layers;
            let layer = *self.layers.entry(so_far.clone()).or_insert_with(|| {
                layers.push(Layer { name: name.to_owned(), parent });
                layers.len() - 1
            });
            parent = Some(layer);
        }
        self.layer = parent;
    }

    fn add(&mut self, shape: Shape) {
        self.scene.things.push(Thing {
            name: self.name.clone(),
            layer: self.layer,
            colour: self.colour,
            shape,
        });
    }

    fn end_part(&mut self) -> Told<()> {
        let part = std::mem::take(&mut self.part);
        let has_colours = !self.colours.is_empty() && self.colours.len() == self.points.len();
        let mut shapes = Vec::new();
        let colour = |i: &usize| self.colours.get(*i).copied().unwrap_or([255; 4]);
        let point = |i: &usize| self.points.get(*i).copied().unwrap_or_default();
        if !part.points.is_empty() {
            let mut set = PointSet::from(part.points.iter().map(point).collect::<Vec<_>>());
            if has_colours {
                set.colours = part.points.iter().map(colour).collect();
            }
            shapes.push(Shape::Points(set));
        }
        if !part.faces.is_empty() {
            let vertices = part.vertices.iter().map(|(v, _)| point(v)).collect();
            let normals: Option<Vec<Vector3>> =
                part.vertices.iter().map(|(_, n)| self.normals.get((*n)?).copied()).collect();
            let colours =
                if has_colours { part.vertices.iter().map(|(v, _)| colour(v)).collect() } else { Vec::new() };
            let mesh = Mesh::from_parts(vertices, part.faces, normals.unwrap_or_default(), colours);
            shapes.push(Shape::Mesh(mesh.map_err(|error| error.to_string())?));
        }
        shapes.into_iter().for_each(|shape| self.add(shape));
        Ok(())
    }

    fn into_scene(mut self) -> Scene {
        // The names are checked as they come; what can still fail is a mesh the kernel refuses.
        if let Err(why) = self.end_part() {
            LeftOut::add(&mut self.scene.left_out, LeftOut::new("mesh", 1, why));
        }
        self.scene
    }
}

fn number(word: &str) -> Told<f64> {
    let x: Option<f64> = word.parse().ok();
    x.filter(|x| x.is_finite()).ok_or_else(|| format!("'{}' is no number", word.escape_debug()))
}

fn three<'a>(words: &mut impl Iterator<Item = &'a str>) -> Told<[f64; 3]> {
    let mut next =
        || words.next().ok_or_else(|| "three numbers should stand here".to_owned()).and_then(number);
    Ok([next()?, next()?, next()?])
}

/// A place from the front, counted from 1, or from the back, counted from −1; given from 0.
fn index(word: &str, count: usize) -> Told<usize> {
    let wrong = || format!("'{}' is none of the {count} there are", word.escape_debug());
    let i: i64 = word.parse().map_err(|_| wrong())?;
    let from_zero =
        if i < 0 { i64::try_from(count).map_err(|_| wrong())?.checked_add(i) } else { i.checked_sub(1) };
    from_zero.and_then(|i| usize::try_from(i).ok()).filter(|i| *i < count).ok_or_else(wrong)
}
