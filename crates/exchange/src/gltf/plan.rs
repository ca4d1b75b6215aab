//! What stands where in a glTF file: everything but the numbers themselves.

use std::collections::HashMap;

use katydid_geometry::{BoundingBox, Mesh, Point3};

use super::document::*;
use super::{FORMAT, colour};
use crate::piece::{Form, Piece};
use crate::{Error, Result, Scene};

/// The lists that the numbers stand in, one behind the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum List {
    Positions,
    Normals,
    Colours,
    Indices,
}

impl List {
    pub(super) const ALL: [Self; 4] = [Self::Positions, Self::Normals, Self::Colours, Self::Indices];

    /// The bytes of an item.
    const fn size(self) -> usize {
        match self {
            Self::Positions | Self::Normals => 12,
            Self::Colours => 8,
            Self::Indices => 4,
        }
    }
}

/// From the scene's units and axes to metres with y up, about a place near the thing.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    metres: f64,
    center: Point3,
}

impl Frame {
    /// The frame for some points. Where they are far from the origin for their size, single precision would blur them:
    /// their own middle is the origin then.
    fn around(points: &BoundingBox, metres: f64) -> Self {
        const FAR: f64 = 1000.0;
        let farthest = points.min.to_vector().length().max(points.max.to_vector().length());
        let is_far = farthest > FAR * points.diagonal().length();
        Self { metres, center: if is_far { points.center() } else { Point3::ORIGIN } }
    }

    pub(super) fn place(&self, p: Point3) -> [f32; 3] {
        let v = (p - self.center) * self.metres;
        [v.x as f32, v.z as f32, -v.y as f32]
    }

    fn translation(&self) -> Option<[f64; 3]> {
        let v = self.center.to_vector() * self.metres;
        (self.center != Point3::ORIGIN).then_some([v.x, v.z, -v.y])
    }
}

/// The document, and for each piece the frame that its positions are in.
pub(super) struct Plan {
    pub(super) document: Document,
    pub(super) frames: Vec<Frame>,
    /// The bytes of all lists together.
    pub(super) length: usize,
}

impl Plan {
    pub(super) fn of(scene: &Scene, pieces: &[Piece<'_>]) -> Result<Self> {
        let mut planner = Planner::new();
        planner.views(pieces);
        let mut on_layer: HashMap<Option<usize>, Vec<usize>> = HashMap::new();
        let mut frames = Vec::with_capacity(pieces.len());
        // The pieces of a thing follow each other.
        for same in pieces.chunk_by(|a, b| a.place == b.place) {
            let Some(first) = same.first() else { continue };
            let bounds = BoundingBox::from_points(same.iter().flat_map(|piece| piece.points()).copied());
            let bounds = bounds.unwrap_or(BoundingBox { min: Point3::ORIGIN, max: Point3::ORIGIN });
            let frame = Frame::around(&bounds, scene.metres);
            let primitives =
                same.iter().map(|piece| planner.primitive(piece, &frame)).collect::<Result<_>>()?;
            frames.extend(same.iter().map(|_| frame));
            let document = &mut planner.document;
            let name = first.thing.name.clone();
            document.meshes.push(MeshOf { name: name.clone(), primitives });
            on_layer.entry(first.thing.layer).or_default().push(document.nodes.len());
            let mesh = Some(document.meshes.len() - 1);
            document.nodes.push(Node { name, mesh, translation: frame.translation(), ..Node::default() });
        }
        planner.layer_nodes(scene, on_layer);
        let length = planner.document.buffer_views.iter().map(|view| view.byte_length).sum();
        Ok(Self { document: planner.document, frames, length })
    }
}

struct Planner {
    document: Document,
    /// For each list its view, and the bytes of it that are given out.
    views: [(usize, usize); 4],
    materials: HashMap<Option<[u8; 4]>, usize>,
}

impl Planner {
    fn new() -> Self {
        let generator = concat!("Katydid ", env!("CARGO_PKG_VERSION"));
        let document = Document {
            asset: Asset { version: "2.0", generator },
            scene: None,
            scenes: Vec::new(),
            nodes: Vec::new(),
            meshes: Vec::new(),
            materials: Vec::new(),
            accessors: Vec::new(),
            buffer_views: Vec::new(),
        };
        Self { document, views: [(0, 0); 4], materials: HashMap::new() }
    }

    /// One view for each list that has anything in it.
    fn views(&mut self, pieces: &[Piece<'_>]) {
        let mut byte_offset = 0;
        for (place, list) in List::ALL.into_iter().enumerate() {
            let byte_length = list.size() * pieces.iter().map(|piece| count(piece, list)).sum::<usize>();
            if byte_length == 0 {
                continue;
            }
            self.views[place] = (self.document.buffer_views.len(), 0);
            let is_indices = list == List::Indices;
            self.document.buffer_views.push(BufferView {
                buffer: 0,
                byte_offset,
                byte_length,
                byte_stride: (!is_indices).then_some(list.size()),
                target: if is_indices { ELEMENT_ARRAY_BUFFER } else { ARRAY_BUFFER },
            });
            byte_offset += byte_length;
        }
    }

    /// The next items of a list; nothing when the piece has none in it.
    fn accessor(&mut self, piece: &Piece<'_>, list: List) -> Option<usize> {
        let count = count(piece, list);
        if count == 0 {
            return None;
        }
        let (buffer_view, used) = &mut self.views[list as usize];
        let byte_offset = *used;
        *used += count * list.size();
        let (component_type, r#type) = match list {
            List::Positions | List::Normals => (FLOAT, "VEC3"),
            List::Colours => (UNSIGNED_SHORT, "VEC4"),
            List::Indices => (UNSIGNED_INT, "SCALAR"),
        };
        self.document.accessors.push(Accessor {
            buffer_view: *buffer_view,
            byte_offset,
            component_type,
            normalized: list == List::Colours,
            count,
            r#type,
            min: None,
            max: None,
        });
        Some(self.document.accessors.len() - 1)
    }

    fn primitive(&mut self, piece: &Piece<'_>, frame: &Frame) -> Result<Primitive> {
        let (min, max) = range(piece, frame)?;
        let empty = || Error::TooLarge { format: FORMAT, what: "a thing without points".into() };
        let position = self.accessor(piece, List::Positions).ok_or_else(empty)?;
        if let Some(accessor) = self.document.accessors.get_mut(position) {
            (accessor.min, accessor.max) = (Some(min), Some(max));
        }
        let normal = self.accessor(piece, List::Normals);
        let colour = self.accessor(piece, List::Colours);
        // Colours of vertices are multiplied by the material's: that is white then.
        let of_thing = if colour.is_some() { Some([255; 4]) } else { piece.thing.colour };
        let mode = match piece.form {
            Form::Points(_) => POINTS,
            Form::Polyline(_) => LINE_STRIP,
            Form::Mesh(_) => TRIANGLES,
        };
        Ok(Primitive {
            attributes: Attributes { position, normal, colour },
            indices: self.accessor(piece, List::Indices),
            material: self.material(of_thing),
            mode,
        })
    }

    fn material(&mut self, colour: Option<[u8; 4]>) -> usize {
        let materials = &mut self.document.materials;
        *self.materials.entry(colour).or_insert_with(|| {
            let [r, g, b, a] = colour.unwrap_or([255; 4]);
            let [red, green, blue] = [r, g, b].map(colour::to_light);
            materials.push(Material {
                pbr_metallic_roughness: Surface {
                    base_color_factor: [red, green, blue, f64::from(a) / 255.0],
                    metallic_factor: 0.0,
                    roughness_factor: 0.8,
                },
                alpha_mode: (a < 255).then_some("BLEND"),
                double_sided: true,
            });
            materials.len() - 1
        })
    }

    /// A node for each layer that holds something, under that of its parent.
    fn layer_nodes(&mut self, scene: &Scene, mut on_layer: HashMap<Option<usize>, Vec<usize>>) {
        let parents = scene.parents();
        let mut used = vec![false; scene.layers.len()];
        for layer in on_layer.keys().flatten() {
            let mut next = Some(*layer);
            while let Some((layer, is_used)) =
                next.and_then(|i| Some((i, used.get_mut(i)?))).filter(|(_, u)| !**u)
            {
                *is_used = true;
                next = parents.get(layer).copied().flatten();
            }
        }
        let nodes = &mut self.document.nodes;
        let mut node_of = vec![None; scene.layers.len()];
        for (place, layer) in scene.layers.iter().enumerate() {
            if used.get(place) == Some(&true) {
                node_of[place] = Some(nodes.len());
                let children = on_layer.remove(&Some(place)).unwrap_or_default();
                nodes.push(Node { name: layer.name.clone(), children, ..Node::default() });
            }
        }
        let mut roots = Vec::new();
        for (parent, node) in parents.iter().zip(&node_of) {
            let Some(node) = *node else { continue };
            let parent = parent.and_then(|parent| node_of.get(parent).copied().flatten());
            match parent.and_then(|parent| nodes.get_mut(parent)) {
                Some(parent) => parent.children.push(node),
                None => roots.push(node),
            }
        }
        // On no layer, or on one that is not there.
        let mut rest: Vec<usize> = on_layer.into_values().flatten().collect();
        rest.sort_unstable();
        roots.extend(rest);
        // A scene has one node at least, or is not there at all.
        if !roots.is_empty() {
            self.document.scene = Some(0);
            self.document.scenes.push(Root { nodes: roots });
        }
    }
}

/// How many items of a list a piece has.
pub(super) fn count(piece: &Piece<'_>, list: List) -> usize {
    match (list, &piece.form) {
        (List::Positions, _) => piece.points().len(),
        (List::Normals, _) => piece.normals().len(),
        (List::Colours, _) => piece.colours().len(),
        (List::Indices, Form::Mesh(mesh)) => 3 * triangles(mesh),
        _ => 0,
    }
}

fn triangles(mesh: &Mesh) -> usize {
    mesh.faces().iter().map(|face| face.triangles().count()).sum()
}

/// The least and greatest coordinates of a piece, as they will stand in the file.
fn range(piece: &Piece<'_>, frame: &Frame) -> Result<([f32; 3], [f32; 3])> {
    let (mut min, mut max) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for p in piece.points() {
        let place = frame.place(*p);
        if place.iter().any(|x| !x.is_finite()) {
            let value = [p.x, p.y, p.z]
                .into_iter()
                .fold(0.0, |most: f64, x| if x.abs() > most.abs() { x } else { most });
            return Err(Error::Coordinate { what: piece.thing.title(piece.place), format: FORMAT, value });
        }
        for (i, x) in place.into_iter().enumerate() {
            min[i] = min[i].min(x);
            max[i] = max[i].max(x);
        }
    }
    Ok((min, max))
}
