//! Things of a scene become what a viewport draws.

use std::collections::HashSet;

use katydid_data::Colour;
use katydid_geometry::{Plane, Point3};
use katydid_scene::{Block, Facets, Form, Origin, Scene, Thing};

use super::curves::Smoothness;
use super::faces::Faces;
use super::parts::{Paint, Parts};
use super::{Fineness, count, fewer};
use crate::protocol::PartKind;

/// Half the side of the square that stands for a plane, in model units: Grasshopper's own default.
const PLANE: f64 = 5.0;
const RED: Colour = Colour::rgb(190, 50, 50);
const GREEN: Colour = Colour::rgb(40, 140, 50);
/// Of more colours than this, each point says its own.
const MOST_COLOURS: usize = 64;
/// An object's geometry takes no more bytes.
const MOST_BYTES: usize = 256 << 20;

/// Fills the parts of an object.
pub(super) struct Collector {
    pub(super) parts: Parts,
    /// Whether something could be finer.
    pub(super) is_draft: bool,
    fineness: Fineness,
    curves: Smoothness,
    /// Whether curves are coarser than they will be.
    has_coarse_curves: bool,
    /// Of all triangles, the share that may be drawn.
    keep: f64,
    /// The size of the largest surface, in model units.
    largest: f64,
    reduced: usize,
    dropped: usize,
}

impl Collector {
    /// For the things of a scene, with `share` triangles at most; `all_curves` are shown, of this and other objects.
    pub(super) fn new(scene: &Scene, fineness: Fineness, share: usize, all_curves: usize) -> Self {
        let things = scene.things.iter();
        let curves = count::curves(scene);
        let finest = Smoothness::for_curves(curves);
        let curves = match fineness {
            Fineness::Draft { .. } => Smoothness::dragged(curves, all_curves),
            Fineness::Coarse | Fineness::Smooth => finest,
        };
        let mut colours = HashSet::new();
        let mut last = None;
        for thing in things.clone() {
            if colours.len() > MOST_COLOURS {
                break;
            }
            let pair = (thing.look.line, thing.look.fill);
            if last.replace(pair) != Some(pair) {
                colours.insert(pair);
            }
        }
        let size = |thing: &Thing| match &thing.form {
            Form::Surface(facets) => facets.size(),
            _ => 0.0,
        };
        let all = count::triangles(scene).max(1);
        Self {
            parts: Parts::new(colours.len() > MOST_COLOURS),
            is_draft: false,
            fineness,
            has_coarse_curves: curves != finest,
            curves,
            keep: (share as f64 / all as f64).min(1.0),
            largest: things.map(size).fold(0.0, f64::max),
            reduced: 0,
            dropped: 0,
        }
    }

    /// What is less than it should be, in words.
    pub(super) fn complaint(&self) -> Option<String> {
        let is_draft = matches!(self.fineness, Fineness::Draft { .. });
        if self.dropped > 0 {
            let most = MOST_BYTES >> 20;
            return Some(format!(
                "{} more things are not shown: they take more than {most} MB",
                self.dropped
            ));
        }
        (self.reduced > 0 && !is_draft).then(|| "shown with fewer triangles than it has".to_owned())
    }

    pub(super) fn thing(&mut self, thing: &Thing) {
        if self.parts.bytes_above(MOST_BYTES) {
            self.dropped += 1;
            return;
        }
        let (look, origin) = (thing.look, thing.origin);
        let paint = |kind, colour| Paint { kind, colour, width: 0.0, text_height: 0.0 };
        let wide = |kind| Paint { width: width(look.width), ..paint(kind, look.line) };
        match &thing.form {
            Form::Point(p) => self.parts.point(paint(PartKind::Points, look.line), *p, None, origin),
            Form::Symbol(p, symbol) => {
                let paint =
                    Paint { width: symbol.size[0].clamp(1.0, 200.0), ..paint(PartKind::Points, symbol.fill) };
                self.parts.point(paint, *p, None, origin);
            }
            Form::Dot(p, size) => {
                self.faces(paint(PartKind::Mesh, look.line), Faces::of_dot(*p, *size), origin);
            }
            Form::Lines(points) => self.parts.line(wide(PartKind::Curves), points, origin),
            Form::Curve(curve) => {
                self.is_draft |= self.has_coarse_curves;
                let points = self.curves.points(curve);
                self.parts.line(wide(PartKind::Curves), &points, origin);
            }
            Form::Mesh(mesh) => self.faces(paint(PartKind::Mesh, look.fill), Faces::of_mesh(mesh), origin),
            Form::Surface(facets) => self.surface(facets, look.fill, origin),
            Form::Plane(plane) => self.plane(plane, look.line, origin),
            Form::Arrow(from, along) => {
                self.parts.line(wide(PartKind::Arrows), &[*from, *from + *along], origin);
            }
            Form::Tip(at, way) => {
                self.parts.line(wide(PartKind::Arrows), &[*at - *way * 0.1, *at], origin);
            }
            Form::Tag { at, text, size, .. } => {
                let paint = Paint { width: *size, ..paint(PartKind::Texts, look.line) };
                self.parts.point(paint, *at, Some(text.clone()), origin);
            }
            Form::Writing { plane, text, size, justification } => {
                let [u0, v0, u1, v1] = Block::new(text, *justification).extent();
                let middle = plane.at(0.5 * (u0 + u1) * size, 0.5 * (v0 + v1) * size, 0.0);
                let paint = Paint { text_height: *size, ..paint(PartKind::Texts, look.line) };
                self.parts.point(paint, middle, Some(text.clone()), origin);
            }
            Form::Tile(corners, colours) => {
                self.faces(paint(PartKind::Mesh, look.fill), Faces::of_tile(corners, colours), origin);
            }
        }
    }

    /// Adds faces, as many as the share allows.
    fn faces(&mut self, paint: Paint, mut faces: Faces, origin: Origin) {
        let most = (self.keep * faces.triangles.len() as f64).floor() as usize;
        if most < faces.triangles.len() {
            self.is_draft = true;
            self.reduced += 1;
            let edges = std::mem::take(&mut faces.edges);
            // What is too small for a share keeps its edges.
            faces = fewer::reduced(&faces, most).unwrap_or_else(|| Faces {
                triangles: Vec::new(),
                edges,
                ..faces
            });
        }
        self.parts.faces(paint, &faces, origin);
    }

    fn surface(&mut self, facets: &Facets, fill: Colour, origin: Origin) {
        let is_draft = matches!(self.fineness, Fineness::Draft { .. });
        let exact = !matches!(self.fineness, Fineness::Draft { exact: false, .. });
        let finer = if is_draft { None } else { facets.within(self.distance(facets)) };
        let drawn = finer.as_ref().unwrap_or(facets);
        self.is_draft |= is_draft && facets.is_exact() && facets.is_curved();
        let paint = |kind| Paint { kind, colour: fill, width: 0.0, text_height: 0.0 };
        self.faces(paint(PartKind::Mesh), Faces::of_surface(drawn, exact), origin);
        for line in &drawn.borders {
            self.parts.line(paint(PartKind::Edges), line, origin);
        }
        for line in &drawn.isocurves {
            self.parts.line(paint(PartKind::Isocurves), line, origin);
        }
    }

    /// How far facets may be from their surface: as far as is not seen on it, nor on the largest beside it.
    fn distance(&self, facets: &Facets) -> f64 {
        let [own, all] = match self.fineness {
            Fineness::Smooth => [2e-4, 2e-5],
            _ => [1e-3, 1e-4],
        };
        (own * facets.size()).max(all * self.largest)
    }

    fn plane(&mut self, plane: &Plane, colour: Colour, origin: Origin) {
        let at = |u: f64, v: f64| plane.at(PLANE * u, PLANE * v, 0.0);
        let paint = |colour, width| Paint { kind: PartKind::Planes, colour, width, text_height: 0.0 };
        let corners: [Point3; 5] =
            [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0), at(-1.0, -1.0)];
        self.parts.line(paint(colour, 0.0), &corners, origin);
        for k in [-0.5, 0.0, 0.5] {
            self.parts.line(paint(colour, 0.0), &[at(k, -1.0), at(k, 1.0)], origin);
            self.parts.line(paint(colour, 0.0), &[at(-1.0, k), at(1.0, k)], origin);
        }
        self.parts.line(paint(RED, 2.0), &[at(0.0, 0.0), at(1.0, 0.0)], origin);
        self.parts.line(paint(GREEN, 2.0), &[at(0.0, 0.0), at(0.0, 1.0)], origin);
    }
}

/// The usual width is 0: a viewport knows its own.
fn width(pixels: f64) -> f64 {
    if pixels == katydid_scene::Look::WIDTH { 0.0 } else { pixels }
}
