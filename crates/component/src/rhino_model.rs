//! The Rhino model that a definition looks into: the objects that its parameters refer to.

use std::collections::HashMap;

use katydid_3dm::{BrepSummary, Limits, Model, ObjectMode, RawObject};
use katydid_data::Value;
use katydid_geometry::{Tolerance, Units};
use uuid::Uuid;

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
}

impl RhinoModel {
    /// The model with its geometry as values.
    pub fn new(model: Model) -> Self {
        let layers = Layers::new(&model);
        let groups: Vec<String> = model.groups.into_iter().map(|group| group.name).collect();
        let objects: Vec<RhinoObject> = (model.objects.into_iter())
            .filter(|object| object.attributes.mode != ObjectMode::InDefinition)
            .map(|object| {
                let attributes = object.attributes;
                let layer = attributes.layer.and_then(|place| layers.0.get(place));
                RhinoObject {
                    id: attributes.id,
                    name: attributes.name,
                    layer: layer.map_or_else(String::new, |layer| layer.path.clone()),
                    layer_index: attributes.layer.unwrap_or_default(),
                    colour: attributes.colour.or(layer.map(|layer| layer.colour)).unwrap_or([0, 0, 0, 255]),
                    groups: attributes
                        .groups
                        .iter()
                        .filter_map(|group| groups.get(*group))
                        .cloned()
                        .collect(),
                    is_hidden: !attributes.visible
                        || attributes.mode == ObjectMode::Hidden
                        || layer.is_some_and(|layer| layer.is_hidden),
                    is_locked: attributes.mode == ObjectMode::Locked
                        || layer.is_some_and(|layer| layer.is_locked),
                    type_flag: object.geometry.object_type(),
                    class: object.geometry.class_name(),
                    geometry: Value::from_object(object.geometry, &object.user_data),
                }
            })
            .collect();
        // Of objects that share an identifier the first counts.
        let places = objects.iter().enumerate().rev().map(|(place, object)| (object.id, place)).collect();
        let mark = |object: &RhinoObject| object.geometry.as_ref().and_then(Mark::of);
        let backwards = objects.iter().enumerate().rev();
        let marks = backwards.filter_map(|(place, object)| Some((mark(object)?, place))).collect();
        Self { units: model.units, tolerance: model.tolerance, objects, places, marks }
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

/// What objects take from their layer.
struct LayerState {
    path: String,
    colour: [u8; 4],
    is_hidden: bool,
    is_locked: bool,
}

struct Layers(Vec<LayerState>);

impl Layers {
    fn new(model: &Model) -> Self {
        let places: HashMap<Uuid, usize> =
            model.layers.iter().enumerate().map(|(place, layer)| (layer.id, place)).collect();
        let state = |place| {
            // Parents that run in a circle end after as many steps as there are layers.
            let parent = |place: &usize| places.get(&model.layers.get(*place)?.parent?).copied();
            let chain = std::iter::successors(Some(place), parent).take(model.layers.len());
            let layers: Vec<_> = chain.filter_map(|place| model.layers.get(place)).collect();
            LayerState {
                path: model.layer_path(place).unwrap_or_default(),
                colour: model.layers.get(place).map_or([0, 0, 0, 255], |layer| layer.colour),
                is_hidden: layers.iter().any(|layer| !layer.visible),
                is_locked: layers.iter().any(|layer| layer.locked),
            }
        };
        Self((0..model.layers.len()).map(state).collect())
    }
}
