//! From the scene to the drawing list.

mod faces;
mod furniture;
mod labels;
mod signs;

use std::collections::HashSet;

use katydid_data::Colour;
use katydid_geometry::{Point3, Vector3};

use crate::camera::{Camera, View};
use crate::drawing::{Drawing, Item, Path, Shape, Solids, SpaceLine, Stroke, blend, opaque};
use crate::{HiddenLines, Options, hidden};
pub(crate) use furniture::gradient;
use katydid_scene::{Block, Form, Place, Scene, Thing, tessellated};
use labels::Labels;

/// Free pixels around what is seen, as a part of the picture's smaller side; and at least so many.
const MARGIN: (f64, f64) = (0.07, 14.0);
/// How far lines are moved towards the viewer, in pixels of depth: a curve on a surface is seen whole although both
/// are drawn as facets.
const BEFORE: f64 = 2.0;
/// Half the side of a plane, in pixels.
const PLANE: f64 = 20.0;
/// Signs are smaller on pictures whose smaller side is less than this, in pixels, but by no more than that factor.
const FULL_SIGNS: (f64, f64) = (500.0, 0.55);
/// A dash and a gap of hidden lines, in pixels.
const DASHES: [f64; 2] = [4.0, 3.0];
/// Curves are drawn to this part of a pixel.
const SMOOTH: f64 = 0.15;

/// What a scene is drawn on.
pub(crate) struct Canvas {
    pub(crate) camera: Camera,
    pub(crate) size: [f64; 2],
    pub(crate) solids: Solids,
    pub(crate) labels: Labels,
    pub(crate) above: Vec<Item>,
    /// Where clear faces are already.
    clear: HashSet<Vec<[i64; 3]>>,
    /// How large signs are, over their full size.
    pub(crate) sign_size: f64,
    /// The colour of the ground, or what a clear ground is taken for.
    pub(crate) ground: Colour,
    /// A colour that is seen on the ground.
    pub(crate) ink: Colour,
}

/// The picture of a scene. Its title and description are the caller's.
pub(crate) fn draw(scene: &Scene, view: View, options: &Options) -> Drawing {
    let size = options.size.map(f64::from);
    let points = scene.extents();
    let side = size[0].min(size[1]);
    let sign_size = (side / FULL_SIGNS.0).clamp(FULL_SIGNS.1, 1.0);
    let margin = (MARGIN.0 * side).max(MARGIN.1);
    let ground = options.background.unwrap_or(Colour::rgb(255, 255, 255));
    let bright = 0.3 * f64::from(ground.r) + 0.59 * f64::from(ground.g) + 0.11 * f64::from(ground.b) > 110.0;
    let mut canvas = Canvas {
        camera: camera(scene, view, &points, size, margin, sign_size),
        size,
        solids: Solids::default(),
        labels: Labels::default(),
        above: Vec::new(),
        clear: HashSet::new(),
        sign_size,
        ground,
        ink: if bright { Colour::rgb(34, 38, 46) } else { Colour::rgb(236, 238, 242) },
    };
    let grid = if options.grid || options.axes {
        furniture::grid(&canvas, view, &points, options)
    } else {
        Vec::new()
    };
    scene.things.iter().for_each(|thing| canvas.thing(thing));
    if options.axes {
        furniture::triad(&mut canvas);
    }
    if options.legend || scene.legends.iter().any(|legend| matches!(legend, katydid_scene::Legend::List(_))) {
        furniture::legends(&mut canvas, &scene.legends, options.legend);
    }
    let mut drawing = Drawing { size, background: options.background, ..Drawing::default() };
    if !grid.is_empty() {
        drawing.items.push(Item::Group("Grid".to_owned(), grid));
    }
    let over = behind(&mut canvas, options.hidden_lines);
    drawing.items.push(Item::Solids(canvas.solids));
    if !over.is_empty() {
        drawing.items.push(Item::Group("Hidden lines".to_owned(), over));
    }
    drawing.items.extend(canvas.labels.placed(size, ground));
    drawing.items.extend(canvas.above);
    drawing
}

/// Takes the stretches behind faces out of the lines, and gives what is drawn of them over the faces.
fn behind(canvas: &mut Canvas, choice: HiddenLines) -> Vec<Item> {
    if choice == HiddenLines::Natural {
        return Vec::new();
    }
    let [seen, hidden] = hidden::part(&canvas.solids, BEFORE);
    canvas.solids.lines = seen;
    let stroke = |line: &SpaceLine| match choice {
        HiddenLines::Natural | HiddenLines::Hide => None,
        // What is too short for a dash and a gap.
        HiddenLines::Dash if hidden::is_short(line) => Some(Stroke::solid(line.colour, line.width)),
        HiddenLines::Show => Some(Stroke::solid(line.colour, line.width)),
        HiddenLines::Dash => {
            let width = (0.7 * line.width).max(0.5);
            Some(Stroke { colour: line.colour, width, dashes: DASHES.to_vec() })
        }
    };
    let shape = |line: &SpaceLine| {
        let path = Path::polyline(line.points.iter().map(|p| [p[0], p[1]]));
        Some(Shape { path, fill: None, stroke: Some(stroke(line)?) }.into())
    };
    hidden.iter().filter_map(shape).collect()
}

/// How often the camera steps back until signs of one size on the picture are seen whole.
const STEPS_BACK: usize = 4;

/// The camera that sees everything, and planes and symbols at the border whole too.
fn camera(
    scene: &Scene,
    view: View,
    points: &[Point3],
    size: [f64; 2],
    margin: f64,
    sign_size: f64,
) -> Camera {
    let mut camera = Camera::fit(view, points, size, margin);
    let has_size = points.iter().any(|p| points.first().is_some_and(|first| p != first));
    if !has_size {
        return camera;
    }
    for _ in 0..STEPS_BACK {
        let mut all = points.to_vec();
        for thing in &scene.things {
            signs::reach(&camera, &thing.form, sign_size, &mut all);
        }
        if all.len() == points.len() {
            break;
        }
        camera = Camera::fit(view, &all, size, margin);
    }
    camera
}

impl Canvas {
    fn thing(&mut self, thing: &Thing) {
        let look = thing.look;
        match &thing.form {
            Form::Point(p) => self.cross(*p, look.line, look.width),
            Form::Symbol(p, symbol) => self.symbol(*p, symbol),
            Form::Dot(p, size) => self.dot(*p, *size, look.line),
            Form::Lines(points) => self.line(points, look.line, look.width, BEFORE),
            Form::Curve(curve) => {
                let box_ = curve.bounding_box();
                let nearest = box_.corners().into_iter().map(|p| self.camera.unit(p));
                let unit = nearest.fold(f64::INFINITY, f64::min);
                let points = tessellated(curve, SMOOTH * unit);
                self.line(&points, look.line, look.width, BEFORE);
            }
            Form::Mesh(mesh) => self.mesh(mesh, &look),
            Form::Surface(facets) => self.surface(facets, &look),
            Form::Plane(plane) => self.plane(plane, &look),
            Form::Tip(at, way) => self.tip(*at, *way, look.line, look.width),
            Form::Arrow(from, along) => self.arrow(*from, *along, look.line, look.width),
            Form::Tag { at, text, size, place } => {
                if let Some([x, y, _]) = self.camera.project(*at) {
                    self.labels.add([x, y], text, *size, look.line, *place == Place::On);
                }
            }
            Form::Writing { plane, text, size, justification } => {
                self.writing(plane, text, *size, *justification, look.line);
            }
            Form::Tile(corners, colours) => self.tile(corners, colours),
        }
    }

    /// A line through points of the model, `nearer` pixels before where it is.
    pub(crate) fn line(&mut self, points: &[Point3], colour: Colour, width: f64, nearer: f64) {
        for mut part in self.camera.polyline(points) {
            part.iter_mut().for_each(|p| p[2] += nearer);
            part.dedup_by(|b, a| (a[0] - b[0]).abs() < 0.02 && (a[1] - b[1]).abs() < 0.02 && a[2] == b[2]);
            if part.len() == 1 {
                part.extend(part.first().copied());
            }
            self.solids.lines.push(SpaceLine { points: part, colour: self.solid(colour), width });
        }
    }

    /// A colour as it is on the ground when nothing shines through lines.
    pub(crate) fn solid(&self, colour: Colour) -> Colour {
        blend(self.ground, opaque(colour), f64::from(colour.a) / 255.0)
    }

    fn plane(&mut self, plane: &katydid_geometry::Plane, look: &katydid_scene::Look) {
        let r = PLANE * self.sign_size * self.camera.unit(plane.origin);
        let at = |u: f64, v: f64| plane.at(u * r, v * r, 0.0);
        let [a, b, c, d] = signs::corners(&self.camera, plane, self.sign_size);
        let corners = [a, b, c, d, a];
        let faint = blend(self.ground, opaque(look.line), 0.5);
        self.line(&corners, faint, 1.0, BEFORE);
        for k in [-0.5, 0.5] {
            self.line(&[at(k, -1.0), at(k, 1.0)], faint, 0.5, BEFORE);
            self.line(&[at(-1.0, k), at(1.0, k)], faint, 0.5, BEFORE);
        }
        self.line(&[at(0.0, 0.0), at(1.0, 0.0)], furniture::RED, 1.6, BEFORE + 0.5);
        self.line(&[at(0.0, 0.0), at(0.0, 1.0)], furniture::GREEN, 1.6, BEFORE + 0.5);
    }

    fn writing(
        &mut self,
        plane: &katydid_geometry::Plane,
        text: &str,
        size: f64,
        justification: i32,
        colour: Colour,
    ) {
        // A small step along each axis says how the plane lies on the picture around its origin.
        let step = self.camera.unit(plane.origin);
        let origin = self.camera.project(plane.origin);
        let towards = |v: Vector3| self.camera.project(plane.origin + v * step);
        let (Some(o), Some(x), Some(y)) = (origin, towards(plane.x_axis), towards(plane.y_axis)) else {
            return;
        };
        let pixels = size / step;
        let turn = [x[0] - o[0], x[1] - o[1], o[0] - y[0], o[1] - y[1]];
        if !(pixels.is_finite() && pixels > 0.5) {
            return;
        }
        for ([along, up], line) in Block::new(text, justification).lines() {
            let [along, down] = [along * pixels, -up * pixels];
            let at = [o[0] + turn[0] * along + turn[2] * down, o[1] + turn[1] * along + turn[3] * down];
            let mut label = crate::drawing::Label::new(at, line, pixels, colour);
            label.turn = turn;
            self.above.push(label.into());
        }
    }
}
