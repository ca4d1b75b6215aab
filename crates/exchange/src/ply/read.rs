//! Reading PLY in its three forms: one mesh of all faces, or a point cloud, and the edges as lines.

use katydid_geometry::{Line, Mesh, MeshFace, Point3, Vector3};

use super::FORMAT;
use super::header::{self, Element, Encoding, Property, Scalar};
use crate::{Error, LeftOut, PointSet, Result, Scene, Shape, Thing};

pub(crate) fn read(bytes: &[u8]) -> Result<Scene> {
    let header = header::read(bytes)?;
    let body = bytes.get(header.length..).unwrap_or_default();
    let mut source: Box<dyn Numbers + '_> = match header.encoding {
        Encoding::Ascii => Box::new(Words { bytes: body, at: 0, line: header.lines + 1 }),
        Encoding::Little => Box::new(Binary { bytes: body, at: 0, big: false }),
        Encoding::Big => Box::new(Binary { bytes: body, at: 0, big: true }),
    };
    let mut found = Found::default();
    for element in &header.elements {
        found.element(element, source.as_mut(), body.len())?;
    }
    found.into_scene()
}

/// Where the numbers of the body come from.
trait Numbers {
    /// The next number.
    fn next(&mut self, scalar: Scalar) -> Result<f64>;
    /// How many numbers of that type can be left at most.
    fn most(&self, scalar: Scalar) -> usize;
    /// Where the last number is, for messages.
    fn place(&self) -> String;
}

/// Numbers as text, with blanks or ends of lines between them.
struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
    /// The line of the file in which the last number is.
    line: usize,
}

impl Numbers for Words<'_> {
    fn next(&mut self, _: Scalar) -> Result<f64> {
        let left = self.bytes.get(self.at..).unwrap_or_default();
        let start = left.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(left.len());
        let (blanks, left) = left.split_at(start);
        self.line += blanks.iter().filter(|byte| **byte == b'\n').count();
        let end = left.iter().position(u8::is_ascii_whitespace).unwrap_or(left.len());
        let word = left.get(..end).unwrap_or_default();
        self.at += start + end;
        let wrong = |why: &str| Error::malformed(FORMAT, self.place(), why);
        if word.is_empty() {
            return Err(wrong("the file ends before all is told"));
        }
        let number = std::str::from_utf8(word).ok().and_then(|word| word.parse().ok());
        number.ok_or_else(|| wrong("it is no number"))
    }

    fn most(&self, _: Scalar) -> usize {
        usize::MAX
    }

    fn place(&self) -> String {
        format!("line {}", self.line)
    }
}

struct Binary<'a> {
    bytes: &'a [u8],
    at: usize,
    big: bool,
}

impl Binary<'_> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N]> {
        let bytes = self.bytes.get(self.at..).and_then(|left| left.first_chunk::<N>());
        let mut bytes = *bytes
            .ok_or_else(|| Error::malformed(FORMAT, self.place(), "the file ends before all is told"))?;
        self.at += N;
        if self.big {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

impl Numbers for Binary<'_> {
    fn next(&mut self, scalar: Scalar) -> Result<f64> {
        Ok(match scalar {
            Scalar::I8 => i8::from_le_bytes(self.take()?).into(),
            Scalar::U8 => u8::from_le_bytes(self.take()?).into(),
            Scalar::I16 => i16::from_le_bytes(self.take()?).into(),
            Scalar::U16 => u16::from_le_bytes(self.take()?).into(),
            Scalar::I32 => i32::from_le_bytes(self.take()?).into(),
            Scalar::U32 => u32::from_le_bytes(self.take()?).into(),
            Scalar::F32 => f32::from_le_bytes(self.take()?).into(),
            Scalar::F64 => f64::from_le_bytes(self.take()?),
        })
    }

    fn most(&self, scalar: Scalar) -> usize {
        self.bytes.len().saturating_sub(self.at) / scalar.size()
    }

    fn place(&self) -> String {
        format!("byte {} of the body", self.at)
    }
}

#[derive(Default)]
struct Found {
    points: PointSet,
    faces: Vec<MeshFace>,
    edges: Vec<[u32; 2]>,
    left_out: Vec<LeftOut>,
}

/// What a number of a vertex is.
#[derive(Clone, Copy)]
enum Role {
    Place(usize),
    Normal(usize),
    Colour(usize),
    Other,
}

fn role(name: &str) -> Role {
    match name {
        "x" => Role::Place(0),
        "y" => Role::Place(1),
        "z" => Role::Place(2),
        "nx" | "normal_x" => Role::Normal(0),
        "ny" | "normal_y" => Role::Normal(1),
        "nz" | "normal_z" => Role::Normal(2),
        "red" | "r" | "diffuse_red" => Role::Colour(0),
        "green" | "g" | "diffuse_green" => Role::Colour(1),
        "blue" | "b" | "diffuse_blue" => Role::Colour(2),
        "alpha" | "a" => Role::Colour(3),
        _ => Role::Other,
    }
}

impl Found {
    fn element(&mut self, element: &Element, source: &mut dyn Numbers, bytes: usize) -> Result<()> {
        // An element without properties takes no bytes: its count is only a number.
        if element.properties.is_empty() {
            return Ok(());
        }
        // Each number takes a byte at least, so a count beyond the bytes ends in an error soon enough; memory grows only
        // with what is really there.
        if element.count > bytes {
            let why = format!("{} {}s do not fit into {bytes} bytes", element.count, element.name);
            return Err(Error::malformed(FORMAT, "the header", why));
        }
        match element.name.as_str() {
            "vertex" => self.vertices(element, source),
            "face" | "faces" => self.faces(element, source),
            "edge" => self.edges(element, source),
            "tristrips" => self.strips(element, source),
            name => {
                LeftOut::add(
                    &mut self.left_out,
                    LeftOut::new(format!("element '{name}'"), element.count, "not supported"),
                );
                (0..element.count)
                    .try_for_each(|_| element.properties.iter().try_for_each(|p| skip(p, source)))
            }
        }
    }

    fn vertices(&mut self, element: &Element, source: &mut dyn Numbers) -> Result<()> {
        let roles: Vec<Role> = element.properties.iter().map(|p| role(&p.name)).collect();
        let has = |wanted: fn(&Role) -> bool| roles.iter().filter(|r| wanted(r)).count() >= 3;
        let has_normals = has(|r| matches!(r, Role::Normal(_)));
        let has_colours = has(|r| matches!(r, Role::Colour(0..3)));
        for number in 0..element.count {
            let (mut place, mut normal, mut colour) = ([0.0; 3], [0.0; 3], [255_u8; 4]);
            for (property, role) in element.properties.iter().zip(&roles) {
                if property.count.is_some() {
                    skip(property, source)?;
                    continue;
                }
                let x = source.next(property.scalar)?;
                match *role {
                    Role::Place(i) => place[i] = x,
                    Role::Normal(i) => normal[i] = x,
                    Role::Colour(i) => colour[i] = part(x, property.scalar),
                    Role::Other => {}
                }
            }
            let point = Point3::from(place);
            if !point.is_finite() {
                let place = format!("{}, vertex {number}", source.place());
                return Err(Error::malformed(FORMAT, place, "a coordinate is not finite"));
            }
            self.points.points.push(point);
            if has_normals {
                let n = Vector3::from(normal);
                self.points.normals.push(if n.is_finite() { n } else { Vector3::ZERO });
            }
            if has_colours {
                self.points.colours.push(colour);
            }
        }
        Ok(())
    }

    fn faces(&mut self, element: &Element, source: &mut dyn Numbers) -> Result<()> {
        for _ in 0..element.count {
            for property in &element.properties {
                let is_corners = matches!(property.name.as_str(), "vertex_indices" | "vertex_index");
                let Some(count) = property.count.filter(|_| is_corners) else {
                    skip(property, source)?;
                    continue;
                };
                let corners = list(source, count, property.scalar)?;
                self.check(&corners, source)?;
                match *corners.as_slice() {
                    [a, b, c] => self.faces.push(MeshFace::Triangle([a, b, c])),
                    [a, b, c, d] => self.faces.push(MeshFace::Quad([a, b, c, d])),
                    [] | [_] | [_, _] => {
                        LeftOut::add(
                            &mut self.left_out,
                            LeftOut::new("face", 1, "it has fewer than 3 corners"),
                        );
                    }
                    [a, ..] => {
                        let fan = corners.windows(2).skip(1).filter_map(|w| <[u32; 2]>::try_from(w).ok());
                        self.faces.extend(fan.map(|[b, c]| MeshFace::Triangle([a, b, c])));
                    }
                }
            }
        }
        Ok(())
    }

    /// Strips of triangles, one behind the other, each ended by −1.
    fn strips(&mut self, element: &Element, source: &mut dyn Numbers) -> Result<()> {
        for _ in 0..element.count {
            for property in &element.properties {
                let Some(count) = property.count else {
                    skip(property, source)?;
                    continue;
                };
                let corners = numbers(source, count, property.scalar)?;
                for strip in corners.split(|i| *i < 0.0) {
                    let strip = strip.iter().map(|i| whole(*i, source)).collect::<Result<Vec<u32>>>()?;
                    self.check(&strip, source)?;
                    for (place, w) in strip.windows(3).enumerate() {
                        let [a, b, c] = *w else { continue };
                        let turned = if place % 2 == 0 { [a, b, c] } else { [b, a, c] };
                        if a != b && b != c && a != c {
                            self.faces.push(MeshFace::Triangle(turned));
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn edges(&mut self, element: &Element, source: &mut dyn Numbers) -> Result<()> {
        for _ in 0..element.count {
            let mut ends = [None; 2];
            for property in &element.properties {
                match (property.name.as_str(), property.count) {
                    ("vertex1", None) => ends[0] = Some(index(source, property.scalar)?),
                    ("vertex2", None) => ends[1] = Some(index(source, property.scalar)?),
                    _ => skip(property, source)?,
                }
            }
            if let [Some(a), Some(b)] = ends {
                self.check(&[a, b], source)?;
                self.edges.push([a, b]);
            }
        }
        Ok(())
    }

    /// Refuses indices of vertices that are not there, with the place. Where vertices come behind what refers to them,
    /// this is seen at the end.
    fn check(&self, corners: &[u32], source: &dyn Numbers) -> Result<()> {
        let count = self.points.points.len();
        match corners.iter().find(|corner| **corner as usize >= count) {
            Some(corner) if count > 0 => {
                let why = format!("it refers to vertex {corner}, but there are {count}");
                Err(Error::malformed(FORMAT, source.place(), why))
            }
            _ => Ok(()),
        }
    }

    fn into_scene(self) -> Result<Scene> {
        let mut scene = Scene { left_out: self.left_out, ..Scene::default() };
        let PointSet { points, normals, colours } = self.points;
        for [a, b] in &self.edges {
            let [from, to] = [a, b].map(|i| points.get(*i as usize));
            let (Some(from), Some(to)) = (from, to) else {
                return Err(Error::malformed(FORMAT, "an edge", "it refers to a vertex that is not there"));
            };
            if from != to {
                scene.things.push(Thing::named("", Shape::Curve(Line::new(*from, *to).into())));
            }
        }
        if !self.faces.is_empty() {
            let mesh = Mesh::from_parts(points, self.faces, normals, colours)
                .map_err(|error| Error::malformed(FORMAT, "the faces", error.to_string()))?;
            scene.things.insert(0, Thing::named("", Shape::Mesh(mesh)));
        } else if !points.is_empty() && self.edges.is_empty() {
            scene.things.push(Thing::named("", Shape::Points(PointSet { points, normals, colours })));
        }
        Ok(scene)
    }
}

/// A colour's part as one of 255: whole numbers are it already, of 16 bits the upper 8 are, fractions go to 1.
fn part(x: f64, scalar: Scalar) -> u8 {
    let x = match scalar {
        Scalar::F32 | Scalar::F64 => x * 255.0,
        Scalar::U16 => x / 257.0,
        _ => x,
    };
    x.round().clamp(0.0, 255.0) as u8
}

fn whole(x: f64, source: &dyn Numbers) -> Result<u32> {
    let is_index = x >= 0.0 && x < f64::from(u32::MAX) && x == x.trunc();
    if is_index {
        Ok(x as u32)
    } else {
        Err(Error::malformed(FORMAT, source.place(), format!("{x} is no place in a list")))
    }
}

fn index(source: &mut dyn Numbers, scalar: Scalar) -> Result<u32> {
    let x = source.next(scalar)?;
    whole(x, source)
}

fn numbers(source: &mut dyn Numbers, count: Scalar, scalar: Scalar) -> Result<Vec<f64>> {
    let count = index(source, count)? as usize;
    if count > source.most(scalar) {
        let why = format!("a list says to have {count} numbers, more than are left");
        return Err(Error::malformed(FORMAT, source.place(), why));
    }
    (0..count).map(|_| source.next(scalar)).collect()
}

fn list(source: &mut dyn Numbers, count: Scalar, scalar: Scalar) -> Result<Vec<u32>> {
    let numbers = numbers(source, count, scalar)?;
    numbers.into_iter().map(|x| whole(x, source)).collect()
}

fn skip(property: &Property, source: &mut dyn Numbers) -> Result<()> {
    match property.count {
        Some(count) => numbers(source, count, property.scalar).map(|_| ()),
        None => source.next(property.scalar).map(|_| ()),
    }
}
