use serde::{Deserialize, Serialize};
use uuid::Uuid;

use super::{BorderView, Colour, Control, GeometrySource, MappingView, PlayerInput, Setting, WireView};

/// A change of the document.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "do", rename_all = "camelCase", rename_all_fields = "camelCase")]
pub enum Edit {
    /// Puts a new object of a component type on the canvas, its middle at a point.
    Place { id: Uuid, component: Uuid, at: [f32; 2], with: Option<Initial> },
    /// Puts what Grasshopper or Katydid copied on the canvas, its middle at the point where one is given, else beside
    /// where it was. The new objects get ids made from `seed`, so that sending it twice pastes once.
    Paste { text: String, at: Option<[f32; 2]>, seed: Uuid },
    /// Copies objects with the wires between them and into them, moved by a step. Ids as in `Paste`.
    Duplicate { objects: Vec<Uuid>, by: [f32; 2], seed: Uuid },
    /// Takes objects out, with their wires.
    Remove { objects: Vec<Uuid> },
    /// Takes a relay or a one-in-one-out component out and joins its wires.
    RemoveAndJoin { object: Uuid },
    /// Moves objects to where their top left corners shall be.
    Move { objects: Vec<(Uuid, [f32; 2])> },
    /// Lines objects up, or spreads them evenly.
    Align { objects: Vec<Uuid>, how: Alignment },
    /// Gives a panel, slider or scribble another size: x, y, width, height.
    Resize { object: Uuid, bounds: [f32; 4] },
    /// Draws these objects before (`back`) or behind all others.
    Arrange { objects: Vec<Uuid>, back: bool },
    /// Draws a wire from an output to an input, or takes it away.
    Connect { from: Uuid, to: Uuid, how: Connection },
    /// Takes all wires of a grip to another grip of the same side. Parameters are inputs and outputs of one id: `input`
    /// says which grips are meant; without it outputs, where both have some.
    Rewire {
        from: Uuid,
        to: Uuid,
        #[serde(default)]
        #[cfg_attr(feature = "typescript", ts(optional))]
        input: Option<bool>,
    },
    /// Puts a relay in the middle of a wire.
    InsertRelay { id: Uuid, from: Uuid, to: Uuid, at: [f32; 2] },
    /// Takes all wires into an input away.
    Disconnect { port: Uuid },
    /// Changes names and states of objects.
    Change { objects: Vec<Uuid>, change: ObjectChange },
    /// Changes a port.
    ChangePort { port: Uuid, change: PortChange },
    /// Gives a control a new value.
    Set { object: Uuid, to: Setting },
    /// Gives a control another form: limits, items, colours.
    Reshape { object: Uuid, control: Control },
    /// Changes how a panel looks.
    ChangePanel { object: Uuid, change: PanelChange },
    /// Keeps values in an input, one a line, with `{0;1}` on a line of its own before each branch; none clears it.
    Keep { port: Uuid, values: Option<String> },
    /// Keeps geometry in an input in place of what it kept: what was picked or drawn in a viewport, one item each.
    SetGeometry { port: Uuid, items: Vec<GeometrySource> },
    /// Moves, turns or scales the geometry that inputs keep, by the first three rows of a matrix. Edits of one gesture
    /// are maps from where the gesture began, each in place of the one before.
    Transform { ports: Vec<Uuid>, map: [[f64; 4]; 3] },
    /// Keeps the data that a port has now in a new parameter (or in the port itself when it is an input or parameter),
    /// and takes its wires away.
    Internalise { port: Uuid },
    /// Puts a floating parameter before an input, which takes over what the input keeps and reads.
    Extract { port: Uuid, id: Uuid },
    /// Adds a port to an object that has any number of them, before the one at `index`. With an `id` for it the edit can
    /// be sent twice.
    AddPort {
        object: Uuid,
        input: bool,
        index: u32,
        #[serde(default)]
        #[cfg_attr(feature = "typescript", ts(optional))]
        id: Option<Uuid>,
    },
    /// Takes such a port away.
    RemovePort { port: Uuid },
    /// Puts objects in a new group.
    Group { id: Uuid, objects: Vec<Uuid> },
    /// Changes a group.
    ChangeGroup { group: Uuid, change: GroupChange },
    /// Takes groups away and leaves what is in them.
    Ungroup { groups: Vec<Uuid> },
    /// Makes a cluster of objects.
    MakeCluster { id: Uuid, objects: Vec<Uuid> },
    /// Puts the inside of a cluster in its place.
    ExplodeCluster { cluster: Uuid },
    /// The inputs that the player shows, in their order; none lets it find them itself.
    Publish { inputs: Option<Vec<PlayerInput>> },
    /// The document's units and tolerances; what is not given stays.
    Settings {
        units: Option<String>,
        tolerance: Option<f64>,
        angle_tolerance: Option<f64>,
        preview_normal: Option<Colour>,
        preview_selected: Option<Colour>,
        name: Option<String>,
        author: Option<String>,
        description: Option<String>,
    },
}

/// How an object begins.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum Initial {
    /// With a control of this form.
    Control { control: Control },
    /// With values in an input, by its index; text as a panel would hold it.
    Values { values: Vec<(u32, String)> },
    /// With a wire to or from this port: what a wire dropped in the void is for.
    Wire { port: Uuid },
}

/// What a wire that is drawn does with those that are there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Connection {
    /// It takes their place.
    Replace,
    /// It joins them.
    Add,
    /// It is taken away.
    Remove,
}

/// How objects are lined up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Alignment {
    /// Left edges.
    Left,
    /// Middles across.
    Centre,
    /// Right edges.
    Right,
    /// Top edges.
    Top,
    /// Middles down.
    Middle,
    /// Bottom edges.
    Bottom,
    /// Even gaps across.
    SpreadAcross,
    /// Even gaps down.
    SpreadDown,
}

/// A change of objects.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum ObjectChange {
    /// The name that the canvas shows.
    Nickname { text: String },
    /// Whether they run.
    Disabled { on: bool },
    /// Whether their preview is off.
    Hidden { on: bool },
}

/// A change of a port.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum PortChange {
    /// Its short name.
    Nickname { text: String },
    /// Flatten or graft.
    Mapping { mapping: MappingView },
    /// Each list back to front.
    Reverse { on: bool },
    /// Shortest paths.
    Simplify { on: bool },
    /// Domains become 0 to 1.
    Reparameterize { on: bool },
    /// Booleans are inverted.
    Invert { on: bool },
    /// Angles are given in degrees.
    Degrees { on: bool },
    /// Vectors get length 1.
    Unitize { on: bool },
    /// An expression in `x`; none takes it away.
    Expression { text: Option<String> },
    /// How its wires are drawn.
    Wire { wire: WireView },
    /// Whether the outputs' paths follow this input's.
    Principal { on: bool },
    /// The type hint of a script's input, by its name.
    Hint { hint: String },
    /// How much of a tree a script's input takes at once.
    Access { access: AccessView },
}

/// How much of a tree an input takes at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum AccessView {
    /// One item.
    Item,
    /// A list.
    List,
    /// The whole tree.
    Tree,
}

/// A change of how a panel looks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum PanelChange {
    /// Whether its text is one item with line breaks.
    Multiline { on: bool },
    /// Whether paths are shown.
    Paths { on: bool },
    /// Whether indices are shown.
    Indices { on: bool },
    /// Whether long lines are wrapped.
    Wrap { on: bool },
    /// Whether `\n` and the like stand for others.
    SpecialCodes { on: bool },
    /// 0 left, 1 centre, 2 right.
    Alignment { alignment: i32 },
    /// The colour of the paper.
    Colour { colour: Colour },
    /// The file that what it shows is written to, by `katydid run` alone; none stops that.
    Stream { file: Option<String> },
}

/// A change of a group.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum GroupChange {
    /// Its label.
    Label { text: String },
    /// Its colour.
    Colour { colour: Colour },
    /// Its shape.
    Border { border: BorderView },
    /// What is in it.
    Members { members: Vec<Uuid> },
}
