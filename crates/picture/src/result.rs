//! What a solved definition shows: the geometry of every object whose preview is on, and what display components draw.

use katydid_data::Colour;
use katydid_definition::document::{Document, Object};
use katydid_geometry::BoundingBox;
use katydid_scene::colour::of_archive;
use katydid_scene::{Form, Look, Painter, Scene, legends};
use katydid_solver::{Engine, Inputs};

use crate::camera::View;
use crate::drawing::{Anchor, Drawing, Label};
use crate::{Options, project};

/// A picture of a result.
#[derive(Debug, Clone)]
pub struct Picture {
    /// The picture.
    pub drawing: Drawing,
    /// What could not be drawn, in words.
    pub left_out: Vec<String>,
    /// Whether there was nothing to be shown: the picture says so.
    pub is_empty: bool,
}

/// What Grasshopper gives previews in a new document: a clear dark red.
const PREVIEW: Colour = Colour::argb(100, 150, 0, 0);
/// The picture of what a solved definition makes: the geometry of all objects with their preview on, in the document's
/// preview colour or the material of a Custom Preview, and what display components draw.
pub fn result(engine: &Engine, options: &Options) -> Picture {
    result_with(engine, options, |_| Paint::Own)
}

/// How an object is painted in a picture that is made for a purpose: a figure in a text, say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Paint {
    /// As in the studio.
    Own,
    /// In this colour, where it has none of its own.
    Colour(Colour),
    /// Not at all.
    Nothing,
}

/// The same, with what the caller says about each object.
pub fn result_with(engine: &Engine, options: &Options, paint: impl Fn(&Object) -> Paint) -> Picture {
    let document = engine.document();
    let look = Look::of(document.header.preview_normal.map_or(PREVIEW, of_archive));
    let mut painter = Painter::for_picture(&engine.options().rules, look);
    let inputs = Inputs::new(engine);
    for (index, object) in document.objects.iter().enumerate() {
        let Some(report) = engine.report(index) else { continue };
        match paint(object) {
            Paint::Nothing => continue,
            Paint::Own => painter.set_look(look),
            Paint::Colour(colour) => {
                // Faces stay as clear as they would be.
                painter.set_look(Look::of(Colour { a: look.fill.a, ..colour }));
            }
        }
        painter.object(object, &report.outputs, || inputs.of(index));
    }
    if options.legend {
        painter.scene.legends.extend(legends(document, &inputs));
    }
    let is_empty = painter.scene.things.is_empty();
    let view = options.view.unwrap_or_else(|| own_view(&painter.scene));
    let mut drawing = project::draw(&painter.scene, view, options);
    if is_empty {
        say_nothing(&mut drawing);
    }
    drawing.title = title(document, options);
    drawing.description = description(&painter.scene, view);
    Picture { drawing, left_out: painter.left_out().to_vec(), is_empty }
}

/// From above where everything is on one height, else in perspective.
fn own_view(scene: &Scene) -> View {
    let Some(bounds) = BoundingBox::from_points(scene.places()) else { return View::Perspective };
    let size = bounds.diagonal();
    let flat = size.z <= 1e-6 * size.length();
    // Planes and solids stand up even where their middles do not.
    let stands = scene.things.iter().any(|thing| match &thing.form {
        Form::Plane(plane) => plane.z_axis.z.abs() < 1.0 - 1e-9,
        _ => false,
    });
    if flat && !stands { View::Top } else { View::Perspective }
}

pub(crate) fn title(document: &Document, options: &Options) -> String {
    let name = if options.title.is_empty() { &document.header.name } else { &options.title };
    if name.is_empty() { "A Grasshopper definition".to_owned() } else { name.clone() }
}

/// What is to be seen, counted.
fn description(scene: &Scene, view: View) -> String {
    let words = ["point", "curve", "mesh", "surface", "plane", "arrow", "text"];
    let mut counts = [0_usize; 7];
    for thing in &scene.things {
        let place = match thing.form {
            Form::Point(_) | Form::Symbol(..) | Form::Dot(..) => 0,
            Form::Lines(_) | Form::Curve(_) => 1,
            Form::Mesh(_) => 2,
            Form::Surface(_) => 3,
            Form::Plane(_) => 4,
            Form::Arrow(..) => 5,
            Form::Tag { .. } | Form::Writing { .. } => 6,
            Form::Tile(..) | Form::Tip(..) => continue,
        };
        counts[place] += 1;
    }
    let of = |(count, word): (usize, &str)| match (count, word) {
        (1, word) => format!("1 {word}"),
        (n, "mesh") => format!("{n} meshes"),
        (n, word) => format!("{n} {word}s"),
    };
    let list: Vec<String> = counts.into_iter().zip(words).filter(|(n, _)| *n > 0).map(of).collect();
    if list.is_empty() {
        return "The definition shows no geometry.".to_owned();
    }
    format!("The result seen in {} view: {}.", view.word(), list.join(", "))
}

fn say_nothing(drawing: &mut Drawing) {
    let [w, h] = drawing.size;
    let size = (0.04 * w).clamp(9.0, 22.0);
    let grey = Colour::rgb(128, 128, 132);
    let middle =
        |y: f64, text: &str, size: f64| Label::new([0.5 * w, y], text, size, grey).anchored(Anchor::Middle);
    drawing.push(middle(0.5 * h - 0.2 * size, "Nothing to show", size));
    drawing.push(middle(0.5 * h + size, "no object with its preview on gives geometry", 0.6 * size));
}
