use serde::{Deserialize, Serialize};
use uuid::Uuid;

use super::{
    Colour, CombMeasure, DocumentView, EffectsView, ExplanationView, ModelView, MotionView, NurbsView,
    ObjectView, Probed, Solved,
};

/// What the session tells a client.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "event", rename_all = "camelCase", rename_all_fields = "camelCase")]
pub enum Event {
    /// Everything, when a client joins or asks for the inside of a cluster.
    Document(DocumentState),
    /// What has changed since the revision before.
    Patch {
        revision: u64,
        within: Vec<Uuid>,
        /// Objects that are new or changed.
        put: Vec<ObjectView>,
        /// Objects that are gone.
        removed: Vec<Uuid>,
        /// The order in which objects are drawn, when it has changed.
        order: Option<Vec<Uuid>>,
        /// The document's own settings and states, when they have changed.
        document: Option<DocumentView>,
    },
    /// A request was carried out. Edits of which nothing came leave the revision as it is.
    Done {
        seq: u64,
        revision: u64,
        /// The ids of objects that a paste or copy made.
        made: Vec<Uuid>,
    },
    /// A request could not be carried out; nothing has changed.
    Refused { seq: u64, reason: String },
    /// Rows of data, in answer to `Rows`.
    Rows { seq: u64, page: Page },
    /// The steps of a result, in answer to `Explain`.
    Explained { seq: u64, explanation: ExplanationView },
    /// What moves a number, in answer to `Effects`.
    Effects { seq: u64, effects: EffectsView },
    /// What inputs were set to, in answer to `SolveFor`.
    Solved { seq: u64, solved: Solved },
    /// How places move, in answer to `Motion`.
    Motion { seq: u64, motion: MotionView },
    /// A curve, in answer to `Nurbs`.
    Nurbs { seq: u64, curve: NurbsView },
    /// Small pictures, in answer to `Pictures`.
    Pictures { seq: u64, pictures: Vec<PictureView> },
    /// The scripts that run only where somebody lets them, in answer to `Scripts`.
    Scripts { seq: u64, scripts: Vec<ScriptView> },
    /// The clipboard's text, in answer to `Copy`.
    Copied { seq: u64, text: String },
    /// A solve has begun or gone on. Solves are numbered; what belongs to an older one can be thrown away.
    Solving {
        solution: u64,
        done: u32,
        total: u32,
        /// The object that was done last.
        name: String,
    },
    /// The results of objects that were solved anew. `finished` with the last of a solve.
    Results {
        solution: u64,
        within: Vec<Uuid>,
        results: Vec<ResultView>,
        finished: bool,
        cancelled: bool,
        milliseconds: f64,
    },
    /// The geometry of objects that changed, by the hash of its bytes: `GET /geometry/<hash>`, unless they came in a
    /// binary frame just before. Such a frame holds the geometry of several, each at a multiple of 8 bytes: the 16 bytes
    /// of the hash, the length (`u32`, little-endian), four zeros, the geometry. Objects without geometry any more have
    /// none.
    Preview { solution: u64, draft: bool, objects: Vec<(Uuid, Option<String>)> },
    /// What [`Ask::Analyse`](super::Ask::Analyse) asked for, of the objects of which it has changed; found like that of
    /// `Preview`. `left_out` says what there was too much of.
    Analysed {
        solution: u64,
        draft: bool,
        objects: Vec<(Uuid, Option<String>)>,
        comb: Option<CombMeasure>,
        left_out: Vec<String>,
    },
    /// What is at the places that [`Ask::Probe`](super::Ask::Probe) of that round named, in their order; none where there
    /// is no such curve or surface.
    Probed { solution: u64, round: u32, probes: Vec<Option<Probed>> },
    /// The Rhino model beside the definition, when a client joins and when another is given; nothing where there is none,
    /// or it is not drawn yet. The geometry of its layers is found by its hash as that of `Preview`.
    Model { model: Option<ModelView> },
    /// Something that people should know.
    Notice(Notice),
}

/// A document as a client joins it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct DocumentState {
    /// The number of changes since the session began.
    pub revision: u64,
    /// The clusters that lead to what is shown, from the outermost.
    pub within: Vec<Uuid>,
    /// The document's own settings and states.
    pub document: DocumentView,
    /// The objects, in the order they are drawn in.
    pub objects: Vec<ObjectView>,
    /// Set when edits were found that were never saved.
    pub restored: Option<Restored>,
    /// What is odd about the file.
    pub problems: Vec<Problem>,
}

/// Edits that a session before this one left unsaved.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Restored {
    /// How many steps.
    pub steps: u32,
    /// When the last was made, in seconds since 1970.
    pub at: u64,
}

/// A script that is asked about, wherever in the definition it is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ScriptView {
    /// Its component's name.
    pub title: String,
    /// Its language.
    pub language: String,
    /// Its text; empty when it comes in over a wire.
    pub text: String,
    /// The modules that it imports, and the packages that it asks for.
    pub imports: Vec<String>,
}

/// Something odd about a file: a part that could not be read, an add-on that is not here.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Problem {
    /// What is the matter.
    pub text: String,
    /// The object, where it is one.
    pub object: Option<Uuid>,
}

/// A line for people.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Notice {
    /// `remark`, `warning` or `error`.
    pub level: String,
    /// The line.
    pub text: String,
}

/// How an object came out of a solve.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ResultView {
    /// The object.
    pub id: Uuid,
    /// `ok`, `warning`, `error`, `disabled`, `unsupported`, `no-data`.
    pub status: String,
    /// What it tells.
    pub messages: Vec<MessageView>,
    /// What its inputs need of a Rhino model and do not have.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(feature = "typescript", ts(optional, as = "Option<Vec<ModelLackView>>"))]
    pub lacks: Vec<ModelLackView>,
    /// How long it took.
    pub milliseconds: f64,
    /// The data of its outputs in few words.
    pub outputs: Vec<OutputView>,
    /// The first rows of what a panel shows, when it is one.
    pub panel: Option<Page>,
}

/// A message of an object.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct MessageView {
    /// `remark`, `warning` or `error`.
    pub level: String,
    /// The message.
    pub text: String,
    /// The line of the script that it is about.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub line: Option<u32>,
}

/// What an input needs of a Rhino model and does not have.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ModelLackView {
    /// The type of the input.
    pub kind: String,
    /// How many objects; 0 where the model as a whole is asked for.
    pub objects: u32,
    /// Whether there is a model, without those objects.
    pub has_model: bool,
}

/// The data of an output in few words.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct OutputView {
    /// The output.
    pub port: Uuid,
    /// How wires from it are drawn.
    pub structure: Structure,
    /// How many branches.
    pub branches: u32,
    /// How many items in all branches.
    pub items: u32,
}

/// How the wires that carry some data are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Structure {
    /// Nothing: orange.
    Empty,
    /// One item: one line.
    Item,
    /// One list: two lines.
    List,
    /// A tree: two broken lines.
    Tree,
}

/// What an Image Gallery shows of an item.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct PictureView {
    /// The name of the file, or the item in words.
    pub name: String,
    /// A small picture, as an address that holds all of it.
    pub image: Option<String>,
    /// The colour that the item is.
    pub colour: Option<Colour>,
}

/// Rows of data as a panel shows them.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Page {
    /// The number of the first row.
    pub from: u32,
    /// How many rows there are in all.
    pub total: u32,
    /// The rows.
    pub rows: Vec<Row>,
}

/// A row of data: a path, or an item with its index.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum Row {
    /// The head of a branch: `{0;1}`, and how many items it has.
    Path { path: String, items: u32 },
    /// An item.
    Item { index: u32, text: String },
}
