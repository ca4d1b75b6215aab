//! What a definition shows, as a model that Rhino opens.

mod blocks;
mod content;
mod pieces;
mod valid;

use std::collections::HashSet;

use katydid_3dm::{Attributes, Group, Model, Object as Archived};
use katydid_component::{Access, Matching, Ranges, baker};
use katydid_data::{Colour, Column, Content, Item, Kind, Material, Path, Tree, Value, cast};
use katydid_definition::document::{Document, Object, Special, ids};
use katydid_geometry::CancellationToken;
use katydid_solver::{Engine, Inputs, of_object};
use uuid::{Uuid, uuid};

/// Custom Preview: geometry, and the material that it is seen in.
const CUSTOM_PREVIEW: Uuid = uuid!("537b0419-bbc2-4ff4-bf08-afe526367b2c");

/// How geometry is put into a model.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct BakeOptions {
    /// Geometry that repeats at other places becomes a block and references to it.
    pub blocks: bool,
    /// Only what these objects have, by their ids, whether it is previewed or not.
    pub objects: Option<HashSet<Uuid>>,
}

/// A model, and what of the results it does not hold.
#[derive(Debug)]
pub struct Baked {
    /// The geometry, a layer an object.
    pub model: Model,
    /// What could not be put in, in words.
    pub left_out: Vec<String>,
    /// What is in it and invalid by the rules of openNURBS, in words.
    pub remarks: Vec<String>,
}

/// Bakes the geometry of a solved definition: what is marked as output (Context Bake, a group called `RH_OUT`) and what components
/// bake that are told to (EleFront's Bake Objects), or, where there is neither, all that is previewed. The options may name the
/// objects instead.
///
/// Each object of the definition has a layer of its name, but model objects have what is said of them: name, layer,
/// colour, groups, state and user text; blocks, layers and linetypes go into the tables. What comes out of a Custom Preview has the colour of its
/// material, members of a group of geometry are a group, and user text tells where each piece comes from: `Object`
/// is the id of the object, `Path` and `Index` its place in the data. What components bake has only what its attributes say, and
/// lies on the layer `Default` where they name none. Meshes that openNURBS would call invalid are made
/// valid, or left out where nothing of them is left.
pub fn bake(engine: &Engine, options: BakeOptions) -> Baked {
    let document = engine.document();
    let rules = engine.options().rules;
    let model = Model { units: rules.units, tolerance: rules.tolerance, ..Model::default() };
    let mut baking = Baking {
        engine,
        baked: Baked { model, left_out: Vec::new(), remarks: Vec::new() },
        blocks: content::Blocks::default(),
    };
    let inputs = Inputs::new(engine);
    let bakers = bakers(engine, &inputs);
    let marked = marked(document).or_else(|| (!bakers.is_empty()).then(Vec::new));
    for (index, object) in document.objects.iter().enumerate() {
        let shown = match (&options.objects, &marked) {
            (Some(objects), _) => objects.contains(&object.id),
            (None, Some(marked)) => marked.contains(&index),
            (None, None) => !object.hidden && !object.locked && !object.is_annotation(),
        };
        if let Some((_, values)) = bakers.iter().find(|(at, _)| *at == index) {
            let named = options.objects.as_ref().is_none_or(|objects| objects.contains(&object.id));
            baking.add_values(object, if named { values } else { &[] });
            continue;
        }
        let Some(report) = engine.report(index).filter(|_| shown) else { continue };
        for tree in &report.outputs {
            baking.add_tree(object, tree);
        }
        if object.component == CUSTOM_PREVIEW {
            baking.add_previews(object, &inputs.of(index));
        }
    }
    let mut baked = baking.baked;
    if baked.model.layers.is_empty() {
        baked.model.layer_at(DEFAULT_LAYER);
    }
    valid::make_valid(&mut baked);
    if options.blocks {
        blocks::gather(&mut baked.model);
    }
    baked
}

/// The objects whose data is marked as output, or none when no object is.
fn marked(document: &Document) -> Option<Vec<usize>> {
    let lookup = document.lookup();
    let mut marked = Vec::new();
    for object in &document.objects {
        if object.component == ids::CONTEXT_BAKE {
            let sources = object.inputs.iter().flat_map(|port| &port.sources);
            marked.extend(sources.filter_map(|id| lookup.output(*id)).map(|port| port.object));
        }
        if let Some(Special::Group(group)) = object.special()
            && group.marks_output()
        {
            marked.extend(group.members.iter().filter_map(|id| lookup.object(*id)));
        }
    }
    (!marked.is_empty()).then_some(marked)
}

/// What components bake that are told to, by the places of their objects.
fn bakers(engine: &Engine, inputs: &Inputs<'_>) -> Vec<(usize, Vec<Value>)> {
    let document = engine.document();
    let objects = document.objects.iter().enumerate().filter(|(_, object)| !object.locked);
    let baked = objects.filter_map(|(index, object)| {
        let baker = baker(of_object(document, object)?.component.guid)?;
        let values = (baker.objects)(&inputs.of(index), &engine.options().rules);
        (!values.is_empty()).then_some((index, values))
    });
    baked.collect()
}

/// Where a piece comes from.
struct Source<'a> {
    object: &'a Object,
    path: &'a Path,
    index: usize,
    /// Whether a component bakes it, which alone says what its attributes are.
    is_baked: bool,
}

/// The layer that Rhino's new models have, on which objects are put that name none.
const DEFAULT_LAYER: &str = "Default";

impl Source<'_> {
    /// Puts what tells where a piece comes from into what its attributes leave open.
    fn complete(&self, attributes: &mut Attributes, model: &mut Model) {
        let title = self.object.title();
        if attributes.layer.is_none() {
            // Colons between names would make a layer inside another.
            let layer = if self.is_baked { DEFAULT_LAYER.to_owned() } else { title.replace("::", ":") };
            attributes.layer = Some(model.layer_at(&layer));
        }
        if self.is_baked {
            return;
        }
        if attributes.name.is_empty() {
            title.clone_into(&mut attributes.name);
        }
        for (key, text) in [
            ("Object", self.object.id.to_string()),
            ("Path", self.path.to_string()),
            ("Index", self.index.to_string()),
        ] {
            if attributes.user_strings.iter().all(|(known, _)| known != key) {
                attributes.user_strings.push((key.to_owned(), text));
            }
        }
    }
}

/// A model being filled.
struct Baking<'a> {
    engine: &'a Engine,
    baked: Baked,
    /// The blocks that objects bring along.
    blocks: content::Blocks,
}

impl Baking<'_> {
    fn add_tree(&mut self, object: &Object, tree: &Tree) {
        let kind = tree.column().kind();
        if !kind.is_geometry() && !matches!(kind, Kind::Generic | Kind::Content) {
            return;
        }
        for (branch, path) in tree.paths().iter().enumerate() {
            for (index, place) in tree.range(branch).enumerate() {
                // Given up by whoever waits for it.
                if CancellationToken::is_over() {
                    return;
                }
                if let Some(value) = tree.column().get(place) {
                    self.add(&value, None, &Source { object, path, index, is_baked: false });
                }
            }
        }
    }

    /// What a component bakes, in its order.
    fn add_values(&mut self, object: &Object, values: &[Value]) {
        let path = Path::zero();
        for (index, value) in values.iter().enumerate() {
            if CancellationToken::is_over() {
                return;
            }
            self.add(value, None, &Source { object, path: &path, index, is_baked: true });
        }
    }

    /// The geometry of a Custom Preview in the colours of its materials, matched as the component matches them.
    fn add_previews(&mut self, object: &Object, inputs: &[Tree]) {
        let matching = Matching::new(inputs, &[Access::Item; 2], None);
        let mut ranges = Ranges::new();
        for (set, path) in matching.paths().iter().enumerate() {
            matching.ranges(set, &mut ranges);
            let [geometry, materials, ..] = ranges.as_slice() else { continue };
            let count = matching.set_range(set).len();
            let column = |k: usize| inputs.get(k).map(Tree::column);
            let (Some(things), Some(colours)) = (column(0), column(1)) else { continue };
            for index in 0..count {
                let value = repeated(geometry, index).and_then(|place| things.get(place));
                let colour = repeated(materials, index).and_then(|place| material(colours, place));
                if let Some(value) = value {
                    self.add(&value, colour, &Source { object, path, index, is_baked: false });
                }
            }
        }
    }

    fn add(&mut self, value: &Value, colour: Option<Colour>, source: &Source<'_>) {
        let rules = &self.engine.options().rules;
        let title = source.object.title();
        let mut pieces = Vec::new();
        let model = &mut self.baked.model;
        let put = pieces::of(value, rules, model, &mut self.blocks, &mut pieces);
        let put = put.and_then(|()| put_table(value, rules, model, &mut self.blocks));
        if let Err(reason) = put {
            let text = format!("{title}: {reason}");
            if !self.baked.left_out.contains(&text) {
                self.baked.left_out.push(text);
            }
        }
        if pieces.is_empty() {
            return;
        }
        let own = match value {
            Value::Content(content) => match &**content {
                Content::Object(object) => Some(content::attributes(model, object)),
                _ => None,
            },
            _ => None,
        };
        // New attributes stand on the first layer.
        let mut attributes = own.unwrap_or_else(|| Attributes { layer: None, ..Attributes::default() });
        // What an object has of its own goes before where it comes from.
        source.complete(&mut attributes, model);
        attributes.colour = colour.map(|c| [c.r, c.g, c.b, 255]).or(attributes.colour);
        if matches!(value, Value::Group(_)) {
            attributes.groups.push(model.groups.len());
            model.groups.push(Group::new(format!("{title} {} {}", source.path, source.index)));
        }
        let texts = content::user_data(value.carried_texts());
        let with_attributes = |geometry: Archived| content::archived(geometry, &attributes, &texts);
        model.objects.extend(pieces.into_iter().map(with_attributes));
    }
}

/// Puts a block, layer or linetype on its own into the tables of the model.
fn put_table(
    value: &Value,
    rules: &cast::Rules,
    model: &mut Model,
    blocks: &mut content::Blocks,
) -> Result<(), String> {
    let Value::Content(content) = value else { return Ok(()) };
    match &**content {
        Content::Block(block) => {
            blocks.put(model, block, rules)?;
        }
        Content::Layer(layer) => {
            content::put_layer(model, layer);
        }
        Content::Linetype(linetype) => content::put_linetype(model, linetype),
        Content::Object(_)
        | Content::Instance(_)
        | Content::Filter(_)
        | Content::Atom(_)
        | Content::Token(_) => {}
    }
    Ok(())
}

/// The place of item `index` of a branch whose last item repeats.
fn repeated(range: &std::ops::Range<usize>, index: usize) -> Option<usize> {
    let last = range.len().checked_sub(1)?;
    Some(range.start + index.min(last))
}

fn material(column: &Column, place: usize) -> Option<Colour> {
    let material = <Material as Item>::get(column, place).map(|material| material.diffuse);
    material.or_else(|| Colour::get(column, place))
}
