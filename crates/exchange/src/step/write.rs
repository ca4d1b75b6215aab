use std::io::Write;

use katydid_geometry::Units;
use katydid_step::{Document, Part, Shape as Exact};

use crate::{Error, LeftOut, Result, Scene, Shape, Thing};

/// Writes a scene; gives what STEP cannot hold.
pub(crate) fn write(scene: &Scene, out: &mut dyn Write) -> Result<Vec<LeftOut>> {
    let mut document = Document { tolerance: scene.tolerance, ..Document::default() };
    // A model without a unit keeps its numbers: the file must name one, and is in millimetres as new models are.
    if scene.units != Units::None || scene.metres != 1.0 {
        document.metres = scene.metres;
    }
    let mut left_out = Vec::new();
    for thing in &scene.things {
        match shapes(&thing.shape) {
            Ok(shapes) => document.parts.extend(shapes.into_iter().map(|shape| part(scene, thing, shape))),
            Err(why) => LeftOut::add(&mut left_out, LeftOut::new(thing.shape.kind(), 1, why)),
        }
    }
    let refused = katydid_step::write(&document, out).map_err(told)?;
    for one in refused {
        LeftOut::add(&mut left_out, LeftOut::new(one.what, 1, one.why));
    }
    Ok(left_out)
}

pub(super) fn told(error: katydid_step::Error) -> Error {
    match error {
        katydid_step::Error::Io(error) => Error::Io(error),
        katydid_step::Error::Syntax { line, why } => Error::malformed("STEP", format!("line {line}"), why),
        katydid_step::Error::Entity { id, why } => Error::malformed("STEP", format!("#{id}"), why),
        katydid_step::Error::TooLarge(what) => Error::TooLarge { format: "STEP", what },
        other => Error::Unsupported(other.to_string()),
    }
}

fn part(scene: &Scene, thing: &Thing, shape: Exact) -> Part {
    let layer = thing.layer.map(|layer| scene.layer_path(layer)).filter(|layer| !layer.is_empty());
    Part { name: thing.name.clone(), layer, colour: thing.colour, shape }
}

/// The exact forms of a shape; meshes and text have none.
fn shapes(shape: &Shape) -> std::result::Result<Vec<Exact>, &'static str> {
    match shape {
        Shape::Points(set) => Ok(vec![Exact::Points(set.points.clone())]),
        Shape::Curve(curve) => Ok(vec![Exact::Curve(curve.clone())]),
        Shape::Brep(brep) => Ok(vec![Exact::Brep(brep.clone())]),
        Shape::Region(region) => Ok(region.boundaries.iter().cloned().map(Exact::Curve).collect()),
        Shape::Faces { facets: None, edges } => Ok(edges.iter().cloned().map(Exact::Curve).collect()),
        Shape::Mesh(_) | Shape::Faces { .. } => {
            Err("STEP is written with exact geometry only, without meshes")
        }
        Shape::Text(_) => Err("only drawings show text"),
    }
}
