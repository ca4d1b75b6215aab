//! The Rhino model that a definition looks into: the objects that its parameters refer to.

use std::collections::HashMap;
use std::sync::Arc as Shared;

use katydid_3dm::{Attributes, BrepSummary, Limits, Model, ObjectMode, RawObject};
use katydid_data::{
    BlockDefinition, ModelLayer, ModelLinetype, ModelMaterial, ModelObject, Value, Visibility,
};
use katydid_geometry::{Tolerance, Units};
use uuid::Uuid;

use crate::rhino_content::{Blocks, Tables};

/// A Rhino model by its objects. Grasshopper works beside an open one; here a file takes its place.
#[derive(Debug, Default)]
pub struct RhinoModel {
    /// The length unit of the model.
    pub units: Units,
    /// Its tolerances, in its unit and in radians.
    pub tolerance: Tolerance,
    /// Its objects in file order; parts of block definitions are not among them.
    objects: Vec<RhinoObject>,
    /// Where each identifier stands.
    places: HashMap<Uuid, usize>,
    /// Where the object stands that a piece of geometry is of.
    marks: HashMap<Mark, usize>,
    layers: Vec<Shared<ModelLayer>>,
    linetypes: Vec<Shared<ModelLinetype>>,
    materials: Vec<Shared<ModelMaterial>>,
    blocks: Vec<Shared<BlockDefinition>>,
}

/// By what geometry is known again.
#[derive(Debug, PartialEq, Eq, Hash)]
enum Mark {
    /// Where it lies in memory.
    Address(usize),
    /// The bits of the coordinates of a point, which has no address.
    Point([u64; 3]),
}

impl Mark {
    fn of(value: &Value) -> Option<Self> {
        match value {
            Value::Point(p) => Some(Self::Point([p.x, p.y, p.z].map(f64::to_bits))),
            other => other.address().map(Self::Address),
        }
    }
}

/// One object of a model.
#[derive(Debug)]
pub struct RhinoObject {
    /// Its identifier.
    pub id: Uuid,
    /// Its name; empty when it has none.
    pub name: String,
    /// Its layer from the outermost one in, joined by `::`.
    pub layer: String,
    /// The place of its layer in the model.
    pub layer_index: usize,
    /// The colour it is seen in as red, green, blue, alpha: its own, else its layer's.
    pub colour: [u8; 4],
    /// The names of its groups.
    pub groups: Vec<String>,
    /// Whether it or its layer is hidden.
    pub is_hidden: bool,
    /// Whether it or its layer is locked.
    pub is_locked: bool,
    /// What it is, as Rhino's filters number it: 1 a point, 2 a point cloud, 4 a curve, 8 a surface, 16 a brep,
    /// 32 a mesh, 0x4_0000 a SubD, 0x4000_0000 an extrusion and so on.
    pub type_flag: u32,
    /// Its class in the words of the format.
    pub class: String,
    /// The geometry; none when no value can hold it.
    pub geometry: Option<Value>,
    /// The object with its attributes, as an item of data.
    pub content: Value,
}

impl RhinoModel {
    /// The model with its geometry as values.
    pub fn new(mut model: Model) -> Self {
        let tables = Tables::new(&model);
        let (members, free): (Vec<_>, Vec<_>) = std::mem::take(&mut model.objects)
            .into_iter()
            .partition(|object| object.attributes.mode == ObjectMode::InDefinition);
        let order: Vec<Uuid> = model.blocks.iter().map(|block| block.id).collect();
        let mut made = Blocks::new(&tables, std::mem::take(&mut model.blocks), members);
        let blocks = order.into_iter().filter_map(|id| made.definition(id)).collect();
        let objects: Vec<RhinoObject> = free
            .into_iter()
            .map(|object| {
                let (type_flag, class) = (object.geometry.object_type(), object.geometry.class_name());
                let geometry = made.geometry(object.geometry, &object.user_data);
                let content = tables.object(&object.attributes, geometry.clone());
                RhinoObject::new(&object.attributes, content, geometry, type_flag, class)
            })
            .collect();
        // Of objects that share an identifier the first counts.
        let places = objects.iter().enumerate().rev().map(|(place, object)| (object.id, place)).collect();
        let mark = |object: &RhinoObject| object.geometry.as_ref().and_then(Mark::of);
        let backwards = objects.iter().enumerate().rev();
        let marks = backwards.filter_map(|(place, object)| Some((mark(object)?, place))).collect();
        let Tables { layers, linetypes, materials, .. } = tables;
        let (units, tolerance) = (model.units, model.tolerance);
        Self { units, tolerance, objects, places, marks, layers, linetypes, materials, blocks }
    }

    /// The bytes of an archive as such a model.
    ///
    /// # Errors
    /// As for [`Model::read`], in words.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        Model::read(bytes, &Limits::default()).map(Self::new).map_err(|error| error.to_string())
    }

    /// The objects in file order.
    pub fn objects(&self) -> &[RhinoObject] {
        &self.objects
    }

    /// The layers in the order of the table.
    pub fn layers(&self) -> &[Shared<ModelLayer>] {
        &self.layers
    }

    /// The layer of a path (`Outer::Inner`), whatever the case of letters.
    pub fn layer(&self, path: &str) -> Option<&Shared<ModelLayer>> {
        let path = path.to_lowercase();
        self.layers.iter().find(|layer| layer.path.to_lowercase() == path)
    }

    /// The linetypes in the order of the table.
    pub fn linetypes(&self) -> &[Shared<ModelLinetype>] {
        &self.linetypes
    }

    /// The linetype of a name, whatever the case of letters.
    pub fn linetype(&self, name: &str) -> Option<&Shared<ModelLinetype>> {
        let name = name.to_lowercase();
        self.linetypes.iter().find(|linetype| linetype.name.to_lowercase() == name)
    }

    /// The materials in the order of the table.
    pub fn materials(&self) -> &[Shared<ModelMaterial>] {
        &self.materials
    }

    /// The blocks in the order of the table.
    pub fn blocks(&self) -> &[Shared<BlockDefinition>] {
        &self.blocks
    }

    /// The block of a name, whatever the case of letters.
    pub fn block(&self, name: &str) -> Option<&Shared<BlockDefinition>> {
        let name = name.to_lowercase();
        self.blocks.iter().find(|block| block.name.to_lowercase() == name)
    }

    /// The object of an identifier.
    pub fn object(&self, id: Uuid) -> Option<&RhinoObject> {
        self.places.get(&id).and_then(|place| self.objects.get(*place))
    }

    /// The object that a value is the geometry of, as it came out of this model: a copy that was changed on the way is
    /// no object any more. Points have no address; the first point object at the same place is taken for theirs.
    pub fn object_of(&self, value: &Value) -> Option<&RhinoObject> {
        self.objects.get(*self.marks.get(&Mark::of(value)?)?)
    }
}

impl RhinoObject {
    fn new(
        attributes: &Attributes,
        content: ModelObject,
        geometry: Option<Value>,
        type_flag: u32,
        class: String,
    ) -> Self {
        let layer = content.layer.as_deref();
        let colour = content.colour.or_else(|| layer.and_then(|layer| layer.colour));
        Self {
            id: attributes.id,
            name: attributes.name.clone(),
            layer: layer.map_or_else(String::new, |layer| layer.path.to_string()),
            layer_index: attributes.layer.unwrap_or_default(),
            colour: colour.map_or([0, 0, 0, 255], |c| [c.r, c.g, c.b, c.a]),
            groups: content.groups.iter().map(|group| group.to_string()).collect(),
            is_hidden: content.visibility == Visibility::Hidden
                || !attributes.visible
                || layer.is_some_and(|layer| layer.hidden),
            is_locked: content.visibility == Visibility::Locked || layer.is_some_and(|layer| layer.locked),
            type_flag,
            class,
            geometry,
            content: Value::from(content),
        }
    }

    /// Edge `index` of a brep as a curve.
    ///
    /// # Errors
    /// The object is no brep, or has no such edge; in words.
    pub fn edge(&self, index: usize) -> Result<Value, String> {
        let Some(Value::Kept(raw)) = &self.geometry else {
            return Err(format!("object {} is a {} and has no edge {index}", self.id, self.class));
        };
        edge(raw, index).ok_or_else(|| format!("object {} has no edge {index}", self.id))
    }
}

fn edge(raw: &RawObject, index: usize) -> Option<Value> {
    let brep = BrepSummary::read(raw).ok()?;
    let edge = brep.edges.get(index)?;
    let whole = brep.curves.get(edge.curve?)?;
    let part = if edge.part == whole.domain() { whole.clone() } else { whole.trimmed(edge.part).ok()? };
    let part = if edge.reversed { part.reversed() } else { part };
    Some(Value::from(part))
}
