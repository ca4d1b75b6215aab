//! The forms of a definition.

use std::path::Path;

use katydid_definition::archive::{self, Limits};
use katydid_definition::document::Document;
use katydid_definition::kd;
use katydid_geometry::Units;
use katydid_session::Registry;

/// A form of a definition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Grasshopper's binary archive.
    Gh,
    /// Grasshopper's XML archive.
    Ghx,
    /// Katydid's text.
    Kd,
}

impl Form {
    /// The form of files with that extension, without the dot.
    pub fn from_extension(extension: &str) -> Option<Self> {
        match extension.to_lowercase().as_str() {
            "gh" => Some(Self::Gh),
            "ghx" => Some(Self::Ghx),
            "kd" => Some(Self::Kd),
            _ => None,
        }
    }

    /// The form of a file of that name.
    pub fn of(path: &Path) -> Option<Self> {
        Self::from_extension(path.extension()?.to_str()?)
    }

    /// The extension, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Gh => "gh",
            Self::Ghx => "ghx",
            Self::Kd => "kd",
        }
    }
}

/// A definition from bytes, with its unit where a text names one. Objects without a place on the canvas get one.
///
/// # Errors
/// What is wrong with the bytes, and where.
pub fn read(form: Form, bytes: &[u8]) -> Result<(Document, Option<Units>), String> {
    match form {
        Form::Gh | Form::Ghx => {
            let document = Document::read(bytes, &Limits::default()).map_err(|error| error.to_string())?;
            Ok((document, None))
        }
        Form::Kd => {
            let text = std::str::from_utf8(bytes)
                .map_err(|error| format!("byte {} is no UTF-8: this is no text", error.valid_up_to()))?;
            let mut definition = kd::read(text, &Registry).map_err(|problems| problems.to_string())?;
            kd::arrange(&mut definition.document);
            Ok((definition.document, definition.units))
        }
    }
}

/// A definition as bytes, and what the form cannot hold.
///
/// # Errors
/// Why it cannot be written.
pub fn write(form: Form, document: &Document) -> Result<(Vec<u8>, Vec<String>), String> {
    let told = |error: katydid_definition::Error| error.to_string();
    match form {
        Form::Gh => Ok((archive::write_gh(&document.to_archive().root).map_err(told)?, Vec::new())),
        Form::Ghx => {
            let text = archive::write_ghx(&document.to_archive().root).map_err(told)?;
            Ok((text.into_bytes(), Vec::new()))
        }
        Form::Kd => {
            let written = kd::write(document, &Registry).map_err(|error| error.to_string())?;
            Ok((written.text.into_bytes(), written.left_out))
        }
    }
}
