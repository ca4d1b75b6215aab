//! Results as a file in place of JSON.

use katydid_3dm::Model;
use katydid_exchange::{Conversion, Format, Scene};

use super::refusal::Refusal;
use super::sent::Sent;

/// A format of files that geometry can be had in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// Rhino's own.
    Rhino,
    /// Another program's.
    Exchange(Format),
}

impl Form {
    /// The format of that name; none for `json`.
    pub(crate) fn named(name: &str) -> Result<Option<Self>, Refusal> {
        let name = name.trim().trim_start_matches('.').to_ascii_lowercase();
        if name.is_empty() || name == "json" {
            return Ok(None);
        }
        let exchange = Format::ALL.into_iter().find(|format| format.extension() == name).map(Self::Exchange);
        let rhino = (name == "3dm").then_some(Self::Rhino);
        let unknown = || {
            let mut names: Vec<&str> = Format::ALL.into_iter().map(Format::extension).collect();
            names.sort_unstable();
            Refusal::bad(format!("format is json or one of {}, 3dm", names.join(", ")))
        };
        rhino.or(exchange).map(Some).ok_or_else(unknown)
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
            Self::Exchange(format) => {
                let conversion = Conversion { exact: format.is_exact(), ..Conversion::default() };
                let scene = Scene::from_model_with(model, &conversion);
                let mut bytes = Vec::new();
                katydid_exchange::write(&scene, format, &Default::default(), &mut bytes)
                    .map_err(|error| failed(&error))?;
                Ok(Sent::new(format.media_type(), bytes).named(&format!("result.{}", format.extension())))
            }
        }
    }
}
