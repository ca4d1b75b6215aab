//! The things of a scene.

use std::sync::Arc as Shared;

use katydid_data::{Colour, Path, Symbol};
use katydid_geometry::{Curve, Mesh, Plane, Point3, PolylineLimits, Vector3};

use crate::colour::opaque;
use crate::{Block, Facets};

/// Everything that is to be seen.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    /// The things.
    pub things: Vec<Thing>,
    /// The legends.
    pub legends: Vec<Legend>,
    /// The branches that things come from; [`Origin::branch`] counts them.
    pub branches: Vec<Path>,
    /// Where what is added next comes from.
    origin: Origin,
}

/// Which item of an object's data a thing is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Origin {
    /// The index of the output; of what a component draws without giving it on, 0.
    pub output: u32,
    /// The branch, as an index into [`Scene::branches`].
    pub branch: u32,
    /// The index of the item in the branch.
    pub index: u32,
}

/// One thing, and how it is painted.
#[derive(Debug, Clone)]
pub struct Thing {
    /// What it is.
    pub form: Form,
    /// Its paint.
    pub look: Look,
    /// Which item of the data it is.
    pub origin: Origin,
}

/// The colours of a thing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// Of lines, points and texts.
    pub line: Colour,
    /// Of faces; its alpha lets shine through what is behind.
    pub fill: Colour,
    /// The width of lines in pixels.
    pub width: f64,
}

/// What a thing is.
#[derive(Debug, Clone)]
pub enum Form {
    /// A cross.
    Point(Point3),
    /// A sign of the given kind.
    Symbol(Point3, Shared<Symbol>),
    /// A dot: its diameter in units of the model.
    Dot(Point3, f64),
    /// A straight line or several in a row.
    Lines(Vec<Point3>),
    /// A curve, drawn as smooth as the picture shows.
    Curve(Shared<Curve>),
    /// A mesh with its edges.
    Mesh(Shared<Mesh>),
    /// A surface with its borders and isocurves.
    Surface(Shared<Facets>),
    /// A plane: a square with its axes, of one size on the picture.
    Plane(Plane),
    /// An arrow from a point.
    Arrow(Point3, Vector3),
    /// The head of an arrow alone: its tip, and the way to it with as much room as there is.
    Tip(Point3, Vector3),
    /// A text that faces the viewer, of this height in pixels.
    Tag {
        /// Its point.
        at: Point3,
        /// The text.
        text: String,
        /// The height in pixels.
        size: f64,
        /// Where it stands about its point.
        place: Place,
    },
    /// A text on a plane, of this height in units of the model; 1 to 9: which part of it is at the origin.
    Writing {
        /// Where it lies: along x, its letters upright along y.
        plane: Plane,
        /// The text.
        text: String,
        /// The height in units of the model.
        size: f64,
        /// 1 top left to 9 bottom right, row by row.
        justification: i32,
    },
    /// A flat quad with a colour at each corner, and no light.
    Tile([Point3; 4], [Colour; 4]),
}

/// Where a tag stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Beside its point, where there is room.
    Beside,
    /// With its middle on the point.
    On,
}

/// Colours and what they mean.
#[derive(Debug, Clone, PartialEq)]
pub enum Legend {
    /// Colours with a text each.
    List(Vec<(Colour, String)>),
    /// Colours that run into one another: the place from 0 to 1 with the colour before and behind, and the texts of
    /// both ends.
    Scale {
        /// What it is called.
        name: String,
        /// The colours.
        grips: Vec<(f64, Colour, Colour)>,
        /// What stands at the start.
        low: String,
        /// What stands at the end.
        high: String,
    },
}

impl Look {
    /// The usual width of curves and arrows, in pixels.
    pub const WIDTH: f64 = 1.6;

    /// That of one colour: lines do not let through what is behind.
    pub fn of(fill: Colour) -> Self {
        Self { line: opaque(fill), fill, width: Self::WIDTH }
    }
}

impl Scene {
    /// Adds a thing, of the item that was named last.
    pub fn add(&mut self, form: Form, look: Look) {
        self.things.push(Thing { form, look, origin: self.origin });
    }

    /// Says which output and branch what comes now is of.
    pub(crate) fn begin_branch(&mut self, output: usize, path: &Path) {
        if self.branches.last() != Some(path) {
            self.branches.push(path.clone());
        }
        let branch = self.branches.len().saturating_sub(1);
        let [output, branch] = [output, branch].map(|n| u32::try_from(n).unwrap_or(u32::MAX));
        self.origin = Origin { output, branch, index: 0 };
    }

    /// Says which item of the branch what comes now is of.
    pub(crate) fn begin_item(&mut self, index: usize) {
        self.origin.index = u32::try_from(index).unwrap_or(u32::MAX);
    }

    /// Points that a camera must see so that everything is seen.
    pub fn extents(&self) -> Vec<Point3> {
        let mut points = Vec::new();
        for thing in &self.things {
            extents(&thing.form, &mut points);
        }
        points.retain(|p| p.is_finite());
        points
    }

    /// Points that say whether everything lies on one height: dots count where they are, not as balls.
    pub fn places(&self) -> Vec<Point3> {
        let mut points = Vec::new();
        for thing in &self.things {
            match thing.form {
                Form::Dot(p, _) => points.push(p),
                _ => extents(&thing.form, &mut points),
            }
        }
        points.retain(|p| p.is_finite());
        points
    }
}

fn extents(form: &Form, out: &mut Vec<Point3>) {
    match form {
        Form::Point(p) | Form::Symbol(p, _) | Form::Tag { at: p, .. } => out.push(*p),
        Form::Dot(p, size) => {
            let r = 0.5 * size;
            for v in [Vector3::X, Vector3::Y, Vector3::Z] {
                out.extend([*p + v * r, *p - v * r]);
            }
        }
        Form::Lines(points) => out.extend(points),
        Form::Curve(curve) => {
            let size = curve.bounding_box().diagonal().length();
            out.extend(tessellated(curve, 5e-3 * size));
        }
        Form::Mesh(mesh) => out.extend(mesh.vertices()),
        Form::Surface(facets) => out.extend(facets.mesh.vertices()),
        Form::Plane(plane) => out.push(plane.origin),
        Form::Arrow(p, v) => out.extend([*p, *p + *v]),
        Form::Tip(p, _) => out.push(*p),
        Form::Writing { plane, text, size, justification } => {
            let [u0, v0, u1, v1] = Block::new(text, *justification).extent().map(|x| x * size);
            out.extend([(u0, v0), (u1, v0), (u1, v1), (u0, v1)].map(|(u, v)| plane.at(u, v, 0.0)));
        }
        Form::Tile(corners, _) => out.extend(corners),
    }
}

/// The curve as a line through points, at most so far from it; coarser when that would take too many.
pub fn tessellated(curve: &Curve, distance: f64) -> Vec<Point3> {
    if distance > 0.0
        && let Ok(polyline) = curve.to_polyline(&PolylineLimits::within(distance))
        && polyline.points().len() < 100_000
    {
        return polyline.points().to_vec();
    }
    let domain = curve.domain();
    (0..=1000).map(|k| curve.point_at(domain.at(f64::from(k) / 1000.0))).collect()
}
