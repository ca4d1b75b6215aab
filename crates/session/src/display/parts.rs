//! Things of one look, gathered.

use std::collections::HashMap;

use katydid_data::Colour;
use katydid_geometry::Point3;
use katydid_scene::Origin;

use super::faces::Faces;
use crate::protocol::PartKind;

/// Stands for the document's own preview colour, which a viewport knows. No material is as clear as this.
pub(crate) const DOCUMENT: Colour = Colour { a: 1, r: 1, g: 2, b: 3 };

/// So many stretches of an object are told apart at most; the others can be seen and not picked one by one.
const MOST_PIECES: usize = 100_000;

/// The look of a part, and which arrays it has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Key {
    kind: u8,
    /// In pixels, as bits.
    width: u32,
    /// In model units, as bits.
    text_height: u64,
    colour: Option<[u8; 4]>,
    has_colours: bool,
    has_values: bool,
}

/// A part being filled.
#[derive(Debug)]
pub(crate) struct Group {
    pub(crate) kind: PartKind,
    pub(crate) colour: Option<[u8; 4]>,
    pub(crate) width: f32,
    pub(crate) text_height: f64,
    pub(crate) points: Vec<Point3>,
    pub(crate) normals: Vec<[f32; 3]>,
    pub(crate) colours: Vec<[u8; 4]>,
    pub(crate) gaussian: Vec<f32>,
    pub(crate) mean: Vec<f32>,
    pub(crate) indices: Vec<u32>,
    pub(crate) stretches: Vec<Stretch>,
    /// Segments along the edges of a mesh, between the same points.
    pub(crate) edges: Vec<u32>,
    pub(crate) edge_stretches: Vec<Stretch>,
    pub(crate) texts: Vec<String>,
}

/// What of a part is one item.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    pub(crate) origin: Origin,
    pub(crate) start: usize,
    pub(crate) count: usize,
}

/// The look of one thing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Paint {
    pub(crate) kind: PartKind,
    pub(crate) colour: Colour,
    pub(crate) width: f64,
    pub(crate) text_height: f64,
}

/// All parts of an object.
#[derive(Debug, Default)]
pub(crate) struct Parts {
    pub(crate) groups: Vec<Group>,
    by_key: HashMap<Key, usize>,
    /// The group that was filled last, and its place: neighbours mostly look alike.
    last: Option<(Key, usize)>,
    /// Whether colours are told point by point: there are too many for a part each.
    by_point: bool,
    pieces: usize,
}

fn own(colour: Colour) -> Option<[u8; 4]> {
    let is_document = (colour.r, colour.g, colour.b) == (DOCUMENT.r, DOCUMENT.g, DOCUMENT.b)
        && (colour.a == DOCUMENT.a || colour.a == 255);
    (!is_document).then_some([colour.r, colour.g, colour.b, colour.a])
}

impl Parts {
    /// `by_point` tells colours point by point.
    pub(crate) fn new(by_point: bool) -> Self {
        Self { by_point, ..Self::default() }
    }

    fn group(&mut self, paint: Paint, has_colours: bool, has_values: bool) -> &mut Group {
        let colour = own(paint.colour).filter(|_| !has_colours);
        let key = Key {
            kind: paint.kind as u8,
            width: (paint.width as f32).to_bits(),
            text_height: paint.text_height.to_bits(),
            colour,
            has_colours,
            has_values,
        };
        let fresh = self.groups.len();
        let place = match self.last {
            Some((last, place)) if last == key => place,
            _ => *self.by_key.entry(key).or_insert(fresh),
        };
        self.last = Some((key, place));
        if place == fresh {
            self.groups.push(Group {
                kind: paint.kind,
                colour,
                width: paint.width as f32,
                text_height: paint.text_height,
                points: Vec::new(),
                normals: Vec::new(),
                colours: Vec::new(),
                gaussian: Vec::new(),
                mean: Vec::new(),
                indices: Vec::new(),
                stretches: Vec::new(),
                edges: Vec::new(),
                edge_stretches: Vec::new(),
                texts: Vec::new(),
            });
        }
        &mut self.groups[place]
    }

    /// Whether that colour is told point by point.
    fn each(&self, colour: Colour) -> Option<[u8; 4]> {
        own(colour).filter(|_| self.by_point)
    }

    /// A line through points.
    pub(crate) fn line(&mut self, paint: Paint, points: &[Point3], origin: Origin) {
        if points.len() < 2 || !points.iter().all(|p| p.is_finite()) {
            return;
        }
        let each = self.each(paint.colour);
        let room = self.pieces < MOST_PIECES;
        let group = self.group(paint, each.is_some(), false);
        let (Ok(first), start) = (u32::try_from(group.points.len()), group.indices.len()) else { return };
        group.points.extend(points);
        group.colours.extend(each.iter().flat_map(|colour| std::iter::repeat_n(*colour, points.len())));
        for k in 1..points.len() as u32 {
            group.indices.extend([first + k - 1, first + k]);
        }
        let made = room && stretch(&mut group.stretches, origin, start, group.indices.len());
        self.pieces += usize::from(made);
    }

    /// A point with a sign or a text.
    pub(crate) fn point(&mut self, paint: Paint, at: Point3, text: Option<String>, origin: Origin) {
        if !at.is_finite() {
            return;
        }
        let each = self.each(paint.colour);
        let room = self.pieces < MOST_PIECES;
        let group = self.group(paint, each.is_some(), false);
        let start = group.points.len();
        group.points.push(at);
        group.colours.extend(each);
        group.texts.extend(text);
        let made = room && stretch(&mut group.stretches, origin, start, group.points.len());
        self.pieces += usize::from(made);
    }

    /// Triangles, with segments along the edges that are drawn.
    pub(in crate::display) fn faces(&mut self, paint: Paint, faces: &Faces, origin: Origin) {
        if !faces.points.iter().all(|p| p.is_finite()) {
            return;
        }
        let each = if faces.colours.is_empty() { self.each(paint.colour) } else { None };
        let has_colours = !faces.colours.is_empty() || each.is_some();
        let room = self.pieces < MOST_PIECES;
        let group = self.group(paint, has_colours, !faces.gaussian.is_empty());
        let Ok(first) = u32::try_from(group.points.len()) else { return };
        let (start, edge) = (group.indices.len(), group.edges.len());
        group.points.extend(&faces.points);
        group.normals.extend(&faces.normals);
        group.colours.extend(&faces.colours);
        group.colours.extend(each.iter().flat_map(|colour| std::iter::repeat_n(*colour, faces.points.len())));
        group.gaussian.extend(&faces.gaussian);
        group.mean.extend(&faces.mean);
        group.indices.extend(faces.triangles.iter().flatten().map(|i| first + i));
        group.edges.extend(faces.edges.iter().flatten().map(|i| first + i));
        if room {
            let made = stretch(&mut group.stretches, origin, start, group.indices.len());
            let edges = stretch(&mut group.edge_stretches, origin, edge, group.edges.len());
            self.pieces += usize::from(made) + usize::from(edges);
        }
    }

    /// Whether the parts take more bytes than this, about.
    pub(crate) fn bytes_above(&self, most: usize) -> bool {
        let of = |group: &Group| {
            12 * (group.points.len() + group.normals.len())
                + 4 * (group.colours.len() + group.gaussian.len() + group.mean.len())
                + 4 * (group.indices.len() + group.edges.len())
        };
        self.groups.iter().map(of).sum::<usize>() > most
    }
}

/// Says what the stretch from `start` to `end` is of. Neighbours of one item are one stretch. Whether it is a new one.
fn stretch(stretches: &mut Vec<Stretch>, origin: Origin, start: usize, end: usize) -> bool {
    if end <= start {
        return false;
    }
    if let Some(last) = stretches.last_mut()
        && last.origin == origin
        && last.start + last.count == start
    {
        last.count = end - last.start;
        return false;
    }
    stretches.push(Stretch { origin, start, count: end - start });
    true
}
