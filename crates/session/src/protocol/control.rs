use serde::{Deserialize, Serialize};
use uuid::Uuid;

use super::{BorderView, Colour};

/// What an object has of its own, as its face on the canvas shows it. Sent back in an
/// [`Edit::Reshape`](super::Edit::Reshape) it replaces what was there.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase", rename_all_fields = "camelCase")]
pub enum Control {
    /// Number Slider.
    Slider { value: f64, min: f64, max: f64, rounding: RoundingView, digits: u32, expression: Option<String> },
    /// Panel. What it shows when something is wired in comes with the results.
    Panel {
        text: String,
        multiline: bool,
        paths: bool,
        indices: bool,
        wrap: bool,
        special_codes: bool,
        /// 0 left, 1 centre, 2 right.
        alignment: i32,
        colour: Colour,
        /// The file that what it shows is written to, by `katydid run` alone; none where it is not.
        #[serde(default)]
        stream: Option<String>,
    },
    /// Boolean Toggle.
    Toggle { on: bool },
    /// Button: the expressions it gives while up and while held.
    Button { normal: String, pressed: String },
    /// Value List.
    ValueList { mode: ListModeView, items: Vec<ListItemView> },
    /// Colour Swatch and Colour Picker.
    Swatch { colour: Colour },
    /// MD Slider: the place of the grip, 0 to 1 along each axis, and the ranges of the axes.
    MdSlider { value: [f64; 3], domains: [[f64; 2]; 3] },
    /// Control Knob.
    Knob { value: f64, min: f64, max: f64, limited: bool, range: f64, decimals: i32 },
    /// Digit Scroller.
    Digits { value: f64, digits: i32, radix: i32, prefix: String, suffix: String },
    /// Calendar: year, month (1 to 12) and day, and the year and month that it shows.
    Calendar { date: [i32; 3], shown: [i32; 2] },
    /// Clock: seconds since midnight, from 0 to less than 86,400.
    Clock { seconds: f64 },
    /// Gene Pool.
    Genes { values: Vec<f64>, decimals: i32, min: f64, max: f64 },
    /// Graph Mapper: its ranges, its function, and that function drawn as points of the unit square.
    Graph { x: [f64; 2], y: [f64; 2], graph: GraphView, drawn: Vec<[f64; 2]> },
    /// Gradient: its grips and whether colours between them change evenly.
    Gradient { grips: Vec<GripView>, linear: bool },
    /// Image Sampler: the picture, as `GET /image/<hash>`, where there is one.
    Image { file: String, hash: Option<String> },
    /// Expression, Evaluate: the text of the formula.
    Formula { text: String },
    /// A script. Of what is sent back only the texts count.
    Script {
        language: String,
        text: String,
        /// Further members of its class; none where its component keeps none.
        additional: Option<String>,
        /// Its imports, where its component keeps them apart.
        using: Option<String>,
        /// Whether the text comes in over a wire: it cannot be changed here then.
        from_wire: bool,
        /// The names of the type hints that its inputs can have.
        hints: Vec<String>,
    },
    /// Path Mapper: source and target masks.
    Paths { rules: Vec<[String; 2]> },
    /// Cherry Picker: a path and an index.
    Cherry { path: String, index: i32 },
    /// Data Recorder.
    Recorder { recording: bool, limit: Option<i32> },
    /// Get Number and the like: what the caller is asked, and the limits of the answer.
    Contextual { prompt: String, minimum: Option<f64>, maximum: Option<f64> },
    /// Group. Members may be groups.
    Group { label: String, colour: Colour, border: BorderView, members: Vec<Uuid> },
    /// Scribble: its corners go round from the top left; it may be turned.
    Scribble { text: String, font: String, size: f64, bold: bool, italic: bool, corners: [[f32; 2]; 4] },
    /// Sketch.
    Sketch { lines: Vec<Vec<[f64; 2]>>, colour: Colour, width: f64 },
}

/// A new value of a control, as it is dragged or typed. Anything else about a control is an
/// [`Edit::Reshape`](super::Edit::Reshape).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum Setting {
    /// Of a Number Slider, Control Knob or Digit Scroller; it is moved to the nearest value that it can have.
    Number { value: f64 },
    /// Of a Panel.
    Text { text: String },
    /// Of a Boolean Toggle.
    Switch { on: bool },
    /// Of a Button: held or not. It is not kept and cannot be undone.
    Press { down: bool },
    /// Of a Grab of Kangaroo: the particle that is dragged, or that it is let go. It is not kept and cannot be undone.
    Grab { held: Option<HeldPoint> },
    /// Of a Value List: the indices of what is chosen.
    Choose { chosen: Vec<u32> },
    /// Of a Colour Swatch or Picker.
    Colour { colour: Colour },
    /// Of an MD Slider: 0 to 1 along each axis.
    Place { value: [f64; 3] },
    /// Of a Gene Pool: one of its numbers.
    Gene { index: u32, value: f64 },
    /// Of a Calendar: year, month (1 to 12) and day.
    Date { date: [i32; 3] },
    /// Of a Clock: seconds since midnight, from 0 to less than 86,400.
    Time { seconds: f64 },
}

/// A particle of a solver in a hand.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct HeldPoint {
    /// Where the hand took hold: the particle is the one that was nearest then. It tells one drag from the next.
    pub from: [f64; 3],
    /// Where the hand is now.
    pub to: [f64; 3],
    /// How far from `from` the particle may be, in units of the model, where the object has no range of its own.
    pub reach: f64,
}

/// Which numbers a slider takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum RoundingView {
    /// All, to so many digits after the point.
    Float,
    /// Whole numbers.
    Integer,
    /// Even numbers.
    Even,
    /// Odd numbers.
    Odd,
}

/// How a Value List is chosen from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum ListModeView {
    /// Any number of items, each with a box to tick.
    Check,
    /// One, from a menu.
    DropDown,
    /// One, by stepping.
    Sequence,
    /// One, by stepping around.
    Cycle,
}

/// An item of a Value List.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ListItemView {
    /// What its author reads.
    pub name: String,
    /// The expression whose value the list gives.
    pub expression: String,
    /// Whether it is chosen.
    pub selected: bool,
}

/// A place in a gradient.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct GripView {
    /// Where, from 0 at the left to 1 at the right.
    pub at: f64,
    /// The colour just left of it.
    pub left: Colour,
    /// The colour just right of it.
    pub right: Colour,
}

/// The function of a Graph Mapper.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct GraphView {
    /// Its name: `Bezier`, `Linear`, `Parabola`, `Sine`, `Sine Summation`, `Gaussian`, `Perlin`, `Power`, or another
    /// that is kept and cannot be changed here; empty while none is chosen.
    pub name: String,
    /// The places of its handles in the unit square, in the order of the name's own.
    pub handles: Vec<[f64; 2]>,
}
