use std::collections::HashMap;

use katydid_geometry::{Units, Xform};
use katydid_step::{Document, Shape as Exact};

use super::write::told;
use crate::{Layer, LeftOut, Result, Scene, Shape, Thing};

/// Units by their length in metres.
const UNITS: [(f64, Units); 9] = [
    (1e-6, Units::Microns),
    (1e-3, Units::Millimeters),
    (1e-2, Units::Centimeters),
    (1.0, Units::Meters),
    (1e3, Units::Kilometers),
    (0.0254, Units::Inches),
    (0.3048, Units::Feet),
    (0.9144, Units::Yards),
    (1609.344, Units::Miles),
];

/// The scene of a file. A unit that has no name here becomes millimetres.
pub(crate) fn read(bytes: &[u8]) -> Result<Scene> {
    let document = katydid_step::read(bytes).map_err(told)?;
    let known = UNITS.iter().find(|(metres, _)| (metres - document.metres).abs() <= 1e-9 * metres);
    let (metres, units) = known.copied().unwrap_or((1e-3, Units::Millimeters));
    let scale = if known.is_some() { 1.0 } else { document.metres / metres };
    let tolerance = document.tolerance * scale;
    let mut scene = Scene { units, metres, tolerance, ..Scene::default() };
    let mut layers = HashMap::new();
    for one in &document.left_out {
        LeftOut::add(&mut scene.left_out, LeftOut::new(one.what.clone(), 1, one.why.clone()));
    }
    add_parts(&mut scene, document, &mut layers, scale);
    Ok(scene)
}

fn add_parts(scene: &mut Scene, document: Document, layers: &mut HashMap<String, usize>, scale: f64) {
    let motion = Xform::scale(katydid_geometry::Point3::ORIGIN, scale);
    for part in document.parts {
        let shape = match scaled(part.shape, (scale != 1.0).then_some(&motion)) {
            Ok(shape) => shape,
            Err(why) => {
                LeftOut::add(&mut scene.left_out, LeftOut::new("part", 1, why));
                continue;
            }
        };
        let layer = part.layer.map(|path| layer_at(&mut scene.layers, layers, &path));
        scene.things.push(Thing { name: part.name, layer, colour: part.colour, shape });
    }
}

fn scaled(shape: Exact, motion: Option<&Xform>) -> std::result::Result<Shape, String> {
    let told = |error: katydid_geometry::Error| error.to_string();
    Ok(match (shape, motion) {
        (Exact::Points(points), None) => Shape::Points(points.into()),
        (Exact::Points(mut points), Some(motion)) => {
            motion.transform_points(&mut points);
            Shape::Points(points.into())
        }
        (Exact::Curve(curve), None) => Shape::Curve(curve),
        (Exact::Curve(curve), Some(motion)) => Shape::Curve(curve.transformed(motion).map_err(told)?),
        (Exact::Brep(brep), None) => Shape::Brep(brep),
        (Exact::Brep(brep), Some(motion)) => Shape::Brep(brep.transformed(motion).map_err(told)?.into()),
    })
}

/// The layer of a path of names, with those above it.
fn layer_at(all: &mut Vec<Layer>, known: &mut HashMap<String, usize>, path: &str) -> usize {
    if let Some(place) = known.get(path) {
        return *place;
    }
    let (parent, name) = match path.rsplit_once("::") {
        // Each step shortens the path; a path of very many names is one name.
        Some((above, name)) if path.len() < 1000 => (Some(layer_at(all, known, above)), name),
        _ => (None, path),
    };
    all.push(Layer { name: name.to_owned(), parent });
    known.insert(path.to_owned(), all.len() - 1);
    all.len() - 1
}
