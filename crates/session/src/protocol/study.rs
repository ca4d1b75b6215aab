//! What moves a result, and which inputs lead to a wanted one.

use serde::{Deserialize, Serialize};
use uuid::Uuid;

/// A result: of an output or an object, all or one item.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Target {
    /// The clusters that it is inside of, the outermost first; none for what is in the definition itself.
    #[serde(default)]
    pub within: Vec<Uuid>,
    /// The output; or an object, for what comes to its first input where it has no outputs, or is a panel.
    pub output: Uuid,
    /// One item alone.
    pub item: Option<ItemPlace>,
}

/// An item of a tree.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ItemPlace {
    /// The path of its branch: `{0;1}`.
    pub path: String,
    /// Its place there, from 0.
    pub index: u32,
}

/// A result that is wanted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Want {
    /// Of what.
    pub target: Target,
    /// The numbers that it is to give; of a point, three.
    pub numbers: Vec<f64>,
}

/// An input that a study moves: a slider, or a number of a gene pool.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct InputPlace {
    /// The clusters that it is inside of, the outermost first; none for what is in the definition itself.
    #[serde(default)]
    pub within: Vec<Uuid>,
    /// The object.
    pub object: Uuid,
    /// The place of the number in a gene pool.
    pub gene: Option<u32>,
}

/// What moves a number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct EffectsView {
    /// The number as the definition stands.
    pub value: f64,
    /// What each input does where it stands; toggles and lists are left out.
    pub here: Vec<HereView>,
    /// What each input does over the ranges of all, where that was asked for.
    pub ranged: Vec<RangedView>,
    /// How many points were solved for that, and how many of them gave no number.
    pub points: [u32; 2],
}

/// What the number does when an input moves from where it stands.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct HereView {
    /// The input.
    pub input: InputPlace,
    /// Its name.
    pub name: String,
    /// The number it stands at.
    pub at: f64,
    /// What the result does.
    pub slope: SlopeView,
    /// From where to where that holds; none for inputs of whole numbers.
    pub holds: Option<[EndView; 2]>,
}

/// How a number changes with an input.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum SlopeView {
    /// By so much for a change of 1.
    Even { by: DerivativeView },
    /// In one way to the left, in another to the right; none where nothing can be said.
    Corner { left: Option<DerivativeView>, right: Option<DerivativeView> },
    /// By so much for a step down and a step up.
    Steps { step: f64, down: Option<f64>, up: Option<f64> },
    /// It jumps where the input stands, or nothing can be said.
    Jump,
}

/// A derivative with a bound of its error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct DerivativeView {
    /// The derivative.
    pub value: f64,
    /// How far it may be off.
    pub error: f64,
}

/// Where an answer stops to hold.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct EndView {
    /// The number of the input there.
    pub at: f64,
    /// Why.
    pub why: String,
    /// Whether it is the end of the input's own range.
    pub is_limit: bool,
}

/// What an input does over the whole ranges.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct RangedView {
    /// The input.
    pub input: InputPlace,
    /// Its name.
    pub name: String,
    /// The share of the variance that it makes alone, and that with others (Sobol); none where the result does not change.
    pub share: Option<ShareView>,
    /// The mean size of the change for a move over its range (Morris).
    pub mean: Option<f64>,
}

/// Shares in a variance, each with the half of its range of confidence of 95 in 100.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ShareView {
    /// By itself.
    pub alone: [f64; 2],
    /// With what it makes together with others.
    pub total: [f64; 2],
}

/// What was found for wanted results; the inputs stand there already.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Solved {
    /// How far the results are from what is wanted, together.
    pub off: f64,
    /// The numbers that the results are, one after another.
    pub numbers: Vec<f64>,
    /// The inputs that were moved.
    pub inputs: Vec<SolvedInput>,
}

/// An input and the number it was set to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct SolvedInput {
    /// The input.
    pub input: InputPlace,
    /// Its name.
    pub name: String,
    /// The number.
    pub value: f64,
}

/// How places of the shown geometry move with an input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct MotionView {
    /// The places that move.
    pub arrows: Vec<ArrowView>,
    /// Objects whose count changes beside where the input stands.
    pub left_out: Vec<Uuid>,
}

/// A place, and how far it moves for a change of the input by 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ArrowView {
    /// The place.
    pub at: [f64; 3],
    /// Its derivative.
    pub by: [f64; 3],
}
