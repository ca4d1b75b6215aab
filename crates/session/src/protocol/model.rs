use serde::{Deserialize, Serialize};
use uuid::Uuid;

use super::Colour;

/// The Rhino model beside a definition, as a viewport shows it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ModelView {
    /// The name of its file.
    pub name: String,
    /// The layers that objects are on, in the order of the model.
    pub layers: Vec<ModelLayerView>,
    /// What is not shown, in words.
    pub left_out: Vec<String>,
}

/// A layer of a Rhino model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ModelLayerView {
    /// What its geometry goes by: [`PreviewHeader::object`](super::PreviewHeader::object).
    pub id: Uuid,
    /// The names from the outermost layer in, joined by `::`.
    pub path: String,
    /// The colour of the layer.
    pub colour: Colour,
    /// Whether the model has it hidden.
    pub hidden: bool,
    /// Its objects, in the order of the model: item `k` of the geometry's pieces is object `k`.
    pub objects: Vec<ModelObjectView>,
    /// The hash of its geometry; none where nothing of it can be shown.
    pub geometry: Option<String>,
}

/// An object of a Rhino model.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ModelObjectView {
    /// Its id, by which definitions refer to it.
    pub id: Uuid,
    /// Its name; empty when it has none.
    pub name: String,
    /// The type of its geometry as ports name theirs; empty where it has none that can be used.
    pub kind: String,
}
