use katydid_data::{Tree, cast::Rules};
use katydid_definition::archive::Chunk;

use crate::{Budget, Files, Kept, Message, Outbox, RhinoModel};

/// Everything one run of a component gets.
#[derive(Debug)]
pub struct Call<'a> {
    /// The data of each input, cast to its type.
    pub inputs: &'a [Tree],
    /// The nicknames of the inputs, which variables of formulas go by.
    pub input_names: &'a [String],
    /// The number of outputs the object has.
    pub output_count: usize,
    /// Which outputs somebody reads; the others may stay empty. Empty when all are wanted.
    pub wanted: &'a [bool],
    /// What the object has stored besides its ports: modes, formulas, switches.
    pub settings: &'a Chunk,
    /// Units and tolerances.
    pub rules: Rules,
    /// What may be used.
    pub budget: &'a Budget,
    /// The files that may be read.
    pub files: &'a Files,
    /// Where files that components write go; none are written where there is none.
    pub outbox: Option<&'a Outbox>,
    /// What components keep from one solve to the next; nothing is kept where there is none.
    pub kept: Option<&'a Kept>,
    /// The Rhino model that the definition looks into, when one is given.
    pub model: Option<&'a RhinoModel>,
}

/// What one run of a component gives.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// The data of each output.
    pub outputs: Vec<Tree>,
    /// What the user should know.
    pub messages: Vec<Message>,
}
