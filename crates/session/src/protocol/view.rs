use serde::{Deserialize, Serialize};
use uuid::Uuid;

use super::Control;

/// A colour: red, green, blue, alpha, each 0 to 255.
pub type Colour = [u8; 4];

/// What the studio shows of a document besides its objects.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct DocumentView {
    /// The name that is shown: that of the file, as a rule.
    pub name: String,
    /// Where it is kept on this machine; none for a document that was never saved.
    pub path: Option<String>,
    /// Who made it.
    pub author: String,
    /// What it is for.
    pub description: String,
    /// The model's unit, in Rhino's words: `Millimeters`.
    pub units: String,
    /// How near is near enough, in those units.
    pub tolerance: f64,
    /// How near is near enough between directions, in degrees.
    pub angle_tolerance: f64,
    /// The colour of geometry.
    pub preview_normal: Colour,
    /// The colour of the geometry of selected objects.
    pub preview_selected: Colour,
    /// Whether something is changed since it was saved.
    pub changed: bool,
    /// What Undo takes back, in words.
    pub undo: Option<String>,
    /// What Redo makes again, in words.
    pub redo: Option<String>,
    /// Whether edits are not solved until somebody says so.
    pub locked: bool,
    /// The inputs that the player shows, in their order; none where it finds them itself.
    pub player: Option<Vec<PlayerInput>>,
    /// The scripts in it that run only where somebody lets them; none where there are none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub scripts: Option<ScriptsView>,
}

/// Scripts that run only where somebody lets them: programs that could do anything.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ScriptsView {
    /// How many there are.
    pub count: u32,
    /// Whether they may run.
    pub permission: ScriptPermission,
}

/// Whether a document's scripts may run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum ScriptPermission {
    /// Nobody has said.
    Asked,
    /// They may.
    Given,
    /// They may not.
    Refused,
}

/// An input that the player shows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct PlayerInput {
    /// The control.
    pub object: Uuid,
    /// What it is called there; empty for its own name.
    #[serde(default)]
    pub label: String,
    /// What is said of it; empty for nothing.
    #[serde(default)]
    pub help: String,
}

/// One thing on the canvas.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ObjectView {
    /// Its id in the document.
    pub id: Uuid,
    /// The id of its component type.
    pub component: Uuid,
    /// What it is drawn as.
    pub kind: ObjectKindView,
    /// The name of its type.
    pub name: String,
    /// The name that its author gave it.
    pub nickname: String,
    /// x, y, width and height on the canvas, in canvas units; y points down.
    pub bounds: [f32; 4],
    /// The inputs from top to bottom. A floating parameter has one, with the object's own id.
    pub inputs: Vec<PortView>,
    /// The outputs from top to bottom. A floating parameter has one, with the object's own id.
    pub outputs: Vec<PortView>,
    /// Whether it is switched off.
    pub disabled: bool,
    /// Whether its preview is off.
    pub hidden: bool,
    /// Whether it has geometry to preview at all.
    pub previews: bool,
    /// Whether inputs can be added and removed.
    pub variable_inputs: bool,
    /// Whether outputs can be added and removed.
    pub variable_outputs: bool,
    /// Whether Katydid can run it.
    pub support: Support,
    /// The line below the capsule: a mode, a unit.
    pub strip: Option<String>,
    /// What is its own: the knob of a slider, the text of a panel.
    pub control: Option<Control>,
}

/// What a thing on the canvas is drawn as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum ObjectKindView {
    /// A capsule with ports.
    Component,
    /// A capsule that is its own port: a floating parameter.
    Parameter,
    /// A control with a face of its own: a slider, a panel. Its [`Control`] says which.
    Control,
    /// A cluster: a capsule that can be entered.
    Cluster,
    /// A frame around objects.
    Group,
    /// A text.
    Scribble,
    /// Drawn lines.
    Sketch,
    /// A dot on a wire.
    Relay,
}

/// Whether Katydid can run an object.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum Support {
    /// It can.
    Yes,
    /// The object is kept with its wires and its bytes, and gives no data.
    No {
        /// The add-on that it comes from, where the file says so.
        plugin: Option<String>,
        /// Why not.
        reason: String,
    },
}

/// An input or output on the canvas.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct PortView {
    /// The id that wires name.
    pub id: Uuid,
    /// The name in full.
    pub name: String,
    /// The short name.
    pub nickname: String,
    /// The type of its items: `Number`, `Curve`.
    pub kind: String,
    /// `item`, `list` or `tree`.
    pub access: String,
    /// Whether the object runs without data here.
    pub optional: bool,
    /// The middle of its grip, in canvas units from the top of the object.
    pub at: f32,
    /// The outputs that an input reads, in order.
    pub sources: Vec<Uuid>,
    /// How its wires are drawn.
    pub wire: WireView,
    /// What becomes of the branches.
    pub mapping: MappingView,
    /// Each list back to front.
    pub reverse: bool,
    /// Shortest paths.
    pub simplify: bool,
    /// Domains become 0 to 1.
    pub reparameterize: bool,
    /// Booleans are inverted.
    pub invert: bool,
    /// Angles are given in degrees.
    pub degrees: bool,
    /// Vectors get length 1.
    pub unitize: bool,
    /// An expression in `x` that each item goes through.
    pub expression: Option<String>,
    /// How many values are kept in the port itself.
    pub kept: u32,
    /// Whether the outputs' paths follow this input's.
    pub principal: bool,
    /// Whether this port can be removed.
    pub removable: bool,
    /// The name of a script input's type hint.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub hint: Option<String>,
}

/// How wires into an input are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum WireView {
    /// In full.
    Normal,
    /// Thin.
    Faint,
    /// Only while one of its ends is selected.
    Hidden,
}

/// What a port does to the branches of its data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum MappingView {
    /// Nothing.
    None,
    /// All items into one list.
    Flatten,
    /// Each item into a branch of its own.
    Graft,
}

/// The shape of a group's frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum BorderView {
    /// A box with round corners.
    Box,
    /// A blob.
    Blob,
    /// A rectangle.
    Rectangle,
}
