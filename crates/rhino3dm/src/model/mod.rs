//! A model: what an archive holds, as far as this crate takes it apart.

mod on_data;
mod records;

use std::collections::BTreeMap;

use katydid_geometry::{Tolerance, Units};

use crate::unit_scale::unit_number;
use crate::{
    Attributes, Block, Group, HatchPattern, KeptRecord, Layer, Linetype, Material, Object, Properties,
    Settings, UnitScale, UserData, UserTable, Warning,
};

/// A model with its layers and objects, read from an archive or to be written to one.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// The version of the archive it was read from; 0 for a new model.
    pub archive_version: i32,
    /// The openNURBS version that wrote that archive; 0 for a new model.
    pub opennurbs_version: u32,
    /// The length unit.
    pub units: Units,
    /// A unit that [`Units`] has no name for; `units` is [`Units::None`] then.
    pub unit_scale: Option<UnitScale>,
    /// Absolute tolerance in units, angle tolerance in radians.
    pub tolerance: Tolerance,
    /// Relative tolerance, a fraction.
    pub relative_tolerance: f64,
    /// The notes of the file.
    pub notes: String,
    /// The name of the program that wrote the file.
    pub application: String,
    /// The revision history, the window of the notes, the preview and the like.
    pub properties: Properties,
    /// What new objects get, and how lengths are shown.
    pub settings: Settings,
    /// The materials.
    pub materials: Vec<Material>,
    /// The linetypes besides those that every model has.
    pub linetypes: Vec<Linetype>,
    /// The layers. A model without any is written with one, called Default.
    pub layers: Vec<Layer>,
    /// The groups.
    pub groups: Vec<Group>,
    /// The hatch patterns.
    pub hatch_patterns: Vec<HatchPattern>,
    /// The block definitions. Their members are among the objects.
    pub blocks: Vec<Block>,
    /// The objects in file order.
    pub objects: Vec<ModelObject>,
    /// The lights in file order; [`Object::Kept`] all of them.
    pub lights: Vec<ModelObject>,
    /// Records that are not taken apart: they are written back as they were where the archive version allows.
    pub kept: Vec<KeptRecord>,
    /// What plug-ins store.
    pub user_tables: Vec<UserTable>,
    /// Records that were passed over, by table: they are not in this model and would not be written.
    pub skipped: BTreeMap<String, usize>,
    /// What was odd in the archive but did not stop the reading.
    pub warnings: Vec<Warning>,
}

impl Default for Model {
    fn default() -> Self {
        Self {
            archive_version: 0,
            opennurbs_version: 0,
            units: Units::default(),
            unit_scale: None,
            tolerance: Tolerance::default(),
            relative_tolerance: 0.01,
            notes: String::new(),
            application: String::new(),
            properties: Properties::default(),
            settings: Settings::default(),
            materials: Vec::new(),
            linetypes: Vec::new(),
            layers: Vec::new(),
            groups: Vec::new(),
            hatch_patterns: Vec::new(),
            blocks: Vec::new(),
            objects: Vec::new(),
            lights: Vec::new(),
            kept: Vec::new(),
            user_tables: Vec::new(),
            skipped: BTreeMap::new(),
            warnings: Vec::new(),
        }
    }
}

/// One object of a model.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelObject {
    /// The geometry.
    pub geometry: Object,
    /// Identifier, name, layer, colour and the rest.
    pub attributes: Attributes,
    /// User data on the geometry itself. Of a kept object it is in its bytes, and nothing is here.
    pub user_data: Vec<UserData>,
    /// What its record says of its history, as it was; programs of today keep that in [`Model::history`].
    pub history: Option<Box<KeptRecord>>,
}

impl From<Object> for ModelObject {
    fn from(geometry: Object) -> Self {
        Self { geometry, attributes: Attributes::default(), user_data: Vec::new(), history: None }
    }
}

impl Model {
    /// The number in archives of the length unit.
    pub(crate) fn unit(&self) -> i32 {
        self.unit_scale.as_ref().map_or_else(|| unit_number(self.units).0, |scale| scale.number)
    }

    /// How many objects there are of each class, lights included.
    pub fn counts(&self) -> BTreeMap<String, usize> {
        let mut counts = BTreeMap::new();
        for object in self.objects.iter().chain(&self.lights) {
            *counts.entry(object.geometry.class_name()).or_default() += 1;
        }
        counts
    }
}
