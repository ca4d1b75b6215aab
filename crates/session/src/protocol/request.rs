use serde::{Deserialize, Serialize};
use uuid::Uuid;

use super::{AnalysisView, Edit, InputPlace, Probe, Target, Want};

/// What a client asks of the session.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Request {
    /// The client's own number of this request; answers name it.
    pub seq: u64,
    /// What is asked.
    pub ask: Ask,
}

/// What can be asked.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "ask", rename_all = "camelCase", rename_all_fields = "camelCase")]
pub enum Ask {
    /// A change. Those of one gesture (a drag, a scroll) have the same number and are one step for Undo. `within`
    /// names the clusters, from the outermost, in which the objects are; empty for the document itself.
    Edit {
        edit: Edit,
        gesture: Option<u64>,
        #[serde(default)]
        within: Vec<Uuid>,
    },
    /// Takes the steps of a gesture back that is still going on: Escape during a drag.
    Abandon { gesture: u64 },
    /// Takes the last step back.
    Undo,
    /// Makes the last step that was taken back again.
    Redo,
    /// Solves everything again.
    Recompute,
    /// Stops the solve that is running.
    Cancel,
    /// Whether edits wait for `Recompute`.
    Lock { on: bool },
    /// Shows the inside of a cluster: its objects and results come as those of `within`.
    Enter { within: Vec<Uuid> },
    /// Part of the data of a port, as a panel shows it, from row `from`; a path counts as a row. With `exact`, numbers,
    /// points and vectors have all their digits: what is kept again from such rows is the same.
    Rows {
        port: Uuid,
        from: u32,
        count: u32,
        #[serde(default)]
        #[cfg_attr(feature = "typescript", ts(optional, as = "Option<bool>"))]
        exact: bool,
        #[serde(default)]
        within: Vec<Uuid>,
    },
    /// The steps by which the result of an object comes about: by the algorithm of that name, or its first.
    Explain { object: Uuid, algorithm: Option<String> },
    /// What moves a number: each slider and number of a gene pool that it hangs on, or those named. With `ranges` also what they
    /// do over their whole ranges, which takes thousands of solves. It ends what the same client asked of this kind, of
    /// `SolveFor` and of `Motion` before.
    Effects { target: Target, with: Option<Vec<InputPlace>>, ranges: bool },
    /// Moves sliders and numbers of gene pools, those named or all that the results hang on, within their ranges until results are as
    /// near as can be to what is wanted. `quick` takes what is best after a tenth of a second: for a drag, whose steps have
    /// one `gesture`.
    SolveFor { wants: Vec<Want>, with: Option<Vec<InputPlace>>, quick: bool, gesture: u64 },
    /// How places of the shown geometry move with an input.
    Motion { input: InputPlace },
    /// Ends what this client asked of effects and wanted results.
    EndStudy,
    /// The control points and knots of the first curve that an output gives.
    Nurbs { port: Uuid },
    /// What an Image Gallery shows of the data of a port.
    Pictures {
        port: Uuid,
        #[serde(default)]
        within: Vec<Uuid>,
    },
    /// The scripts that run only where somebody lets them, those in clusters too.
    Scripts,
    /// Says whether they may run; with `keep`, from now on whenever this file is opened as it is.
    AllowScripts { run: bool, keep: bool },
    /// Objects with the wires between them, as Grasshopper's clipboard has them.
    Copy {
        objects: Vec<Uuid>,
        #[serde(default)]
        within: Vec<Uuid>,
    },
    /// Saves the document where it is kept, or at a path on this machine.
    Save { path: Option<String> },
    /// Takes the Rhino model beside the document away; its file stays as it is.
    DetachModel,
    /// Says whether what was restored from the journal shall stay (`keep`) or make way for the file as it was saved.
    Settle { keep: bool },
    /// The preview as coarse as it may be while a slider is dragged, or as fine as the document says.
    Draft { on: bool },
    /// What of the form of curves and surfaces this client wants to see; nothing ends it.
    Analyse { analysis: Option<AnalysisView> },
    /// The places whose curvature this client wants to know, instead of those before; they come as
    /// [`Event::Probed`](super::Event::Probed), again whenever it has changed.
    /// `round` is the client's own number of the question, which answers name.
    Probe { round: u32, probes: Vec<Probe> },
}

/// The formats that a document is saved in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum SaveFormat {
    /// Grasshopper's binary archive.
    Gh,
    /// Grasshopper's XML archive.
    Ghx,
    /// Katydid's text.
    Kd,
}
