//! What a definition shows, as a model that Rhino opens.

use std::collections::HashMap;

use katydid_3dm::{Attributes, Layer, Model, ModelObject, Object as Archived};
use katydid_data::{Kind, Tree, Value, cast};
use katydid_definition::document::{Document, Object, Special};
use katydid_solver::Engine;
use uuid::{Uuid, uuid};

/// Context Bake: what goes in is meant to come out.
const CONTEXT_BAKE: Uuid = uuid!("ae2531b4-bab2-4bb1-b5bf-f2143d10c132");
/// The label of groups that mark an output for Rhino.Compute.
const MARK: &str = "RH_OUT";

/// A model, and what of the results it does not hold.
#[derive(Debug)]
pub struct Baked {
    /// The geometry, a layer an object.
    pub model: Model,
    /// What could not be put in, in words.
    pub left_out: Vec<String>,
}

/// Bakes the geometry of a solved definition: what is marked as output (Context Bake, a group called `RH_OUT`),
/// or, where nothing is, all that is previewed. Each object has a layer of its name.
pub fn bake(engine: &Engine) -> Baked {
    let document = engine.document();
    let rules = engine.options().rules;
    let mut baked = Baked {
        model: Model { units: rules.units, tolerance: rules.tolerance, ..Model::default() },
        left_out: Vec::new(),
    };
    baked.model.layers.clear();
    let mut layers = HashMap::new();
    let marked = marked(document);
    for (index, object) in document.objects.iter().enumerate() {
        let shown = match &marked {
            Some(marked) => marked.contains(&index),
            None => !object.hidden && !object.locked && !object.is_annotation(),
        };
        let Some(report) = engine.report(index).filter(|_| shown) else { continue };
        for tree in &report.outputs {
            add_tree(&mut baked, &mut layers, object, tree, &rules);
        }
    }
    if baked.model.layers.is_empty() {
        baked.model.layers.push(Layer::new("Default"));
    }
    baked
}

/// The objects whose data is marked as output, or none when no object is.
fn marked(document: &Document) -> Option<Vec<usize>> {
    let lookup = document.lookup();
    let mut marked = Vec::new();
    for object in &document.objects {
        if object.component == CONTEXT_BAKE {
            let sources = object.inputs.iter().flat_map(|port| &port.sources);
            marked.extend(sources.filter_map(|id| lookup.output(*id)).map(|port| port.object));
        }
        if let Some(Special::Group(group)) = object.special()
            && group.label.trim().starts_with(MARK)
        {
            marked.extend(group.members.iter().filter_map(|id| lookup.object(*id)));
        }
    }
    (!marked.is_empty()).then_some(marked)
}

fn add_tree(
    baked: &mut Baked,
    layers: &mut HashMap<String, usize>,
    object: &Object,
    tree: &Tree,
    rules: &cast::Rules,
) {
    let kind = tree.column().kind();
    if !kind.is_geometry() && kind != Kind::Generic {
        return;
    }
    for value in tree.column().iter().flatten() {
        let mut pieces = Vec::new();
        if let Err(reason) = archived(&value, rules, &mut pieces) {
            let text = format!("{}: {reason}", object.title());
            if !baked.left_out.contains(&text) {
                baked.left_out.push(text);
            }
        }
        for geometry in pieces {
            let layer = *layers.entry(object.title().to_owned()).or_insert_with(|| {
                baked.model.layers.push(Layer::new(object.title()));
                baked.model.layers.len() - 1
            });
            let attributes =
                Attributes { layer: Some(layer), name: object.title().to_owned(), ..Attributes::default() };
            let mut baked_object = ModelObject::from(geometry);
            baked_object.attributes = attributes;
            baked.model.objects.push(baked_object);
        }
    }
}

/// The objects of a model that a value becomes. Types that Rhino does not draw become none.
fn archived(value: &Value, rules: &cast::Rules, pieces: &mut Vec<Archived>) -> Result<(), String> {
    match value {
        Value::Point(p) => pieces.push(Archived::Point(*p)),
        Value::Line(_) | Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) | Value::Curve(_) => {
            if let Some(Value::Curve(curve)) = cast::value(value, Kind::Curve, rules) {
                pieces.push(Archived::Curve((*curve).clone()));
            }
        }
        Value::Surface(surface) => pieces.push(Archived::Surface((**surface).clone())),
        Value::Mesh(mesh) => pieces.push(Archived::from((**mesh).clone())),
        Value::Box(_) | Value::TwistedBox(_) => match cast::value(value, Kind::Mesh, rules) {
            Some(Value::Mesh(mesh)) => pieces.push(Archived::from((*mesh).clone())),
            _ => return Err("a box without volume".to_owned()),
        },
        Value::Group(group) => {
            for member in group.members.iter().flatten() {
                archived(member, rules, pieces)?;
            }
        }
        Value::Kept(raw) if raw.archive_version >= 50 => pieces.push(Archived::Kept((**raw).clone())),
        Value::Kept(raw) => {
            return Err(format!(
                "a {} of an archive of version {} cannot be rewritten yet",
                raw.class_name(),
                raw.archive_version
            ));
        }
        _ => {}
    }
    Ok(())
}
