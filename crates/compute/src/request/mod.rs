//! What a client sends, read leniently: names in any case, data as JSON or as JSON in a text.

mod body;
mod cache_control;
mod path;
mod scalar;
mod value;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use katydid_3dm::{Limits, Model};
use katydid_component::RhinoModel;
use katydid_data::Path;
use katydid_data::cast::Rules;
use katydid_geometry::{Tolerance, Units};
use serde_json::Value as Json;

use crate::Fault;

pub use cache_control::CacheControl;
pub(crate) use path::{parse as parse_path, shown};
pub(crate) use value::tree;

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
    /// 2 million items, 200 000 branches, 50 MiB as Rhino.Compute has it.
    fn default() -> Self {
        Self { items: 2_000_000, branches: 200_000, bytes: 52_428_800 }
    }
}

/// The body of `POST /grasshopper` and `POST /io`.
#[derive(Debug, Clone, PartialEq)]
pub struct SolveRequest {
    /// How near is near enough, in units of the model. Counts only together with the angle.
    pub absolute_tolerance: Option<f64>,
    /// The tolerance of angles in degrees.
    pub angle_tolerance: Option<f64>,
    /// The units of the model; those of `model`, else millimetres, unless said otherwise.
    pub units: Option<Units>,
    /// The version of Rhino that geometry is written for, 5 to 8; 7 unless said otherwise.
    pub data_version: i32,
    /// The model that the definition looks into: the bytes of a .3dm file in base64. It is read for this request alone.
    pub model: Option<String>,
    /// A definition: .gh bytes or .ghx text in base64.
    pub algo: Option<String>,
    /// Where a definition is: a key from an earlier reply, a component's id, a URL, the path of a file.
    pub pointer: Option<String>,
    /// Whether the reply may be kept for the same request.
    pub cache_solve: bool,
    /// Whether items of types that the clients of Rhino.Compute do not know are in the reply too.
    pub all_types: bool,
    /// What may be taken from earlier requests and left for later ones. No member of the body: a server finds it in the
    /// request's head.
    pub cache: CacheControl,
    /// How many definitions called one another to come here.
    pub recursion_level: u32,
    /// The values of the inputs.
    pub values: Vec<InputTree>,
}

/// The version of Rhino that clients which do not say theirs can read.
pub(crate) const DATA_VERSION: i32 = 7;

impl Default for SolveRequest {
    fn default() -> Self {
        Self {
            absolute_tolerance: None,
            angle_tolerance: None,
            units: None,
            data_version: DATA_VERSION,
            model: None,
            algo: None,
            pointer: None,
            cache_solve: false,
            all_types: false,
            cache: CacheControl::Allowed,
            recursion_level: 0,
            values: Vec::new(),
        }
    }
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
    /// `BadRequest` when it is no JSON or not of this form, `TooLarge` when it brings more than the limits allow.
    pub fn read(body: &[u8], limits: &RequestLimits) -> Result<Self, Fault> {
        body::read(body, limits)
    }

    /// A request that asks for nothing but a definition: what `GET /io?pointer=…` stands for.
    pub fn for_pointer(pointer: impl Into<String>) -> Self {
        Self { pointer: Some(pointer.into()), ..Self::default() }
    }

    /// The units and tolerances that it asks for. Tolerances count only when both are given; what is not asked for is as
    /// in the model, where there is one.
    pub fn rules(&self, model: Option<&RhinoModel>) -> Rules {
        let tolerance = match (self.absolute_tolerance, self.angle_tolerance) {
            (Some(absolute), Some(degrees)) if absolute > 0.0 && degrees > 0.0 => {
                Tolerance { absolute, angle: degrees.to_radians() }
            }
            _ => model.map_or_else(Tolerance::default, |model| model.tolerance),
        };
        let units = self.units.or_else(|| Some(model?.units)).unwrap_or_default();
        Rules { tolerance, units, ..Rules::default() }
    }

    /// The model that it brings, of which no more than so many bytes are unpacked.
    ///
    /// # Errors
    /// `BadRequest` when it is no base64 of a .3dm file.
    pub(crate) fn read_model(&self, unpacked_bytes: u64) -> Result<Option<RhinoModel>, Fault> {
        let Some(text) = self.model.as_deref().filter(|text| !text.trim().is_empty()) else {
            return Ok(None);
        };
        let bytes =
            unpacked(text).map_err(|error| Fault::bad_request(format!("The model is no base64: {error}")))?;
        let limits = Limits { inflated: unpacked_bytes, ..Limits::default() };
        let model = Model::read(&bytes, &limits)
            .map_err(|error| Fault::bad_request(format!("The model cannot be read: {error}")))?;
        Ok(Some(RhinoModel::new(model)))
    }

    /// The version of the archive that geometry is written as.
    pub fn archive(&self) -> i32 {
        10 * if (5..=8).contains(&self.data_version) { self.data_version } else { DATA_VERSION }
    }

    /// The pointer, unless there is none to speak of.
    pub(crate) fn pointer(&self) -> Option<&str> {
        self.pointer.as_deref().map(str::trim).filter(|pointer| !pointer.is_empty())
    }

    /// What tells this request from others on the same definition: all but where the definition came from.
    pub(crate) fn digest(&self) -> [u8; 32] {
        let mut hasher = blake3::Hasher::new();
        let mut number = |bits: u64| {
            hasher.update(&bits.to_le_bytes());
        };
        let rules = self.rules(None);
        number(rules.tolerance.absolute.to_bits());
        number(rules.tolerance.angle.to_bits());
        number(rules.units as u64);
        number(self.units.is_some().into());
        number((self.absolute_tolerance.is_some() && self.angle_tolerance.is_some()).into());
        number(self.all_types.into());
        number(self.data_version as u64);
        number(self.recursion_level.into());
        let model = self.model.as_deref().unwrap_or_default();
        hasher.update(&(model.len() as u64).to_le_bytes());
        hasher.update(model.as_bytes());
        // Lengths stand before contents, so that no two requests read alike.
        for tree in &self.values {
            hasher.update(&(tree.name.len() as u64).to_le_bytes());
            hasher.update(tree.name.as_bytes());
            hasher.update(&(tree.branches.len() as u64).to_le_bytes());
            for (path, items) in &tree.branches {
                hasher.update(&(path.len() as u64).to_le_bytes());
                path.elements().iter().for_each(|element| {
                    hasher.update(&element.to_le_bytes());
                });
                hasher.update(&(items.len() as u64).to_le_bytes());
                for item in items {
                    let text = item.to_string();
                    hasher.update(&(text.len() as u64).to_le_bytes());
                    hasher.update(text.as_bytes());
                }
            }
        }
        *hasher.finalize().as_bytes()
    }
}

/// The bytes in a text of base64; white space in it does not count.
pub(crate) fn unpacked(text: &str) -> Result<Vec<u8>, base64::DecodeError> {
    if text.bytes().any(|byte| byte.is_ascii_whitespace()) {
        let compact: String = text.chars().filter(|c| !c.is_ascii_whitespace()).collect();
        return STANDARD.decode(compact);
    }
    STANDARD.decode(text)
}

#[cfg(test)]
mod tests;
