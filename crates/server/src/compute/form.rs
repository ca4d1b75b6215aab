//! Results as a file in place of JSON.

use katydid_3dm::Model;
use katydid_exchange::{Conversion, Format, Scene};

use super::refusal::Refusal;
use super::sent::Sent;
use crate::files::content_type;

/// A format of files that geometry can be had in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// Rhino's own.
    Rhino,
    /// Another program's.
    Exchange(Format, &'static str),
}

/// Their names, as they are asked for.
const NAMES: [&str; 8] = ["glb", "gltf", "obj", "ply", "step", "stl", "svg", "3dm"];

impl Form {
    /// The format of that name; none for `json`.
    pub(crate) fn named(name: &str) -> Result<Option<Self>, Refusal> {
        let name = name.trim().trim_start_matches('.').to_ascii_lowercase();
        if name.is_empty() || name == "json" {
            return Ok(None);
        }
        let known = NAMES.into_iter().find(|known| *known == name);
        let form = known.and_then(|known| match known {
            "3dm" => Some(Self::Rhino),
            other => Some(Self::Exchange(Format::from_extension(other)?, other)),
        });
        let unknown = || Refusal::bad(format!("format is json or one of {}", NAMES.join(", ")));
        form.map(Some).ok_or_else(unknown)
    }

    /// A model in this format; Rhino's own in that version.
    pub(crate) fn write(self, model: &Model, version: i32) -> Result<Sent, Refusal> {
        let failed = |error: &dyn std::fmt::Display| {
            Refusal::new(axum::http::StatusCode::UNPROCESSABLE_ENTITY, "failed", error.to_string())
        };
        match self {
            Self::Rhino => {
                let (bytes, _) = model.write_what_fits(version).map_err(|error| failed(&error))?;
                Ok(Sent::new("model/vnd.3dm", bytes).named("result.3dm"))
            }
            Self::Exchange(format, extension) => {
                let conversion = Conversion { exact: format.is_exact(), ..Conversion::default() };
                let scene = Scene::from_model_with(model, &conversion);
                let mut bytes = Vec::new();
                katydid_exchange::write(&scene, format, &Default::default(), &mut bytes)
                    .map_err(|error| failed(&error))?;
                Ok(Sent::new(content_type(format), bytes).named(&format!("result.{extension}")))
            }
        }
    }
}
