//! Where a document comes from.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;

use katydid_component::{Origin, RhinoModel};
use katydid_data::DateTime;
use katydid_data::cast::Rules;
use katydid_definition::document::Document;
use katydid_geometry::Units;

use super::Attached;
use crate::files::{self, Form};

/// Files larger than this are not read: no definition comes near.
const LARGEST: u64 = 1 << 30;

/// A document with where it comes from.
#[derive(Debug)]
pub(crate) struct Source {
    pub(crate) document: Document,
    pub(crate) name: String,
    /// Where it is kept.
    pub(crate) path: Option<PathBuf>,
    /// Where a copy was read from, which is kept nowhere yet: it may read the files that its original may.
    pub(crate) copy_of: Option<PathBuf>,
    /// The bytes that it was read from.
    pub(crate) hash: Option<blake3::Hash>,
    /// What trust in its scripts goes by: the hash of the bytes that were read or sent.
    pub(crate) fingerprint: Option<String>,
    /// Its own units and tolerances, or those of its model.
    pub(crate) rules: Rules,
    pub(crate) model: Option<Attached>,
    /// Whether edits, and the definition itself, wait until somebody has them solved.
    pub(crate) is_locked: bool,
    /// Whether it is only shown for a while, as in a figure of the book: nothing of it is kept.
    pub(crate) is_passing: bool,
    /// The id that it is known by.
    pub(crate) id: String,
}

/// The moment by the clock of the machine, in UTC: what the text `Now` stands for in the definition.
fn now() -> Option<DateTime> {
    DateTime::since_1970(SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).ok()?)
}

impl Source {
    /// An empty one.
    pub(crate) fn empty() -> Self {
        Self {
            document: Document::new(),
            name: String::new(),
            path: None,
            copy_of: None,
            hash: None,
            fingerprint: None,
            rules: Rules { now: now(), ..Rules::default() },
            model: None,
            is_locked: false,
            is_passing: false,
            id: chance(),
        }
    }

    /// One that was never saved, of which only the journal is left.
    pub(crate) fn left(id: &str) -> Self {
        Self { name: "Unsaved".to_owned(), id: id.to_owned(), ..Self::empty() }
    }

    /// One that was sent.
    pub(crate) fn sent(name: &str, form: Form, bytes: &[u8]) -> Result<Self, String> {
        let (document, units) = files::read(form, bytes).map_err(|error| format!("{name}: {error}"))?;
        let stem = Path::new(name).file_stem().map(|stem| stem.to_string_lossy().into_owned());
        let fingerprint = Some(katydid_script::fingerprint(bytes));
        let source = Self { document, name: stem.unwrap_or_default(), fingerprint, ..Self::empty() };
        Ok(source.with_units(units))
    }

    /// One of a file of this machine.
    pub(crate) fn file(path: &Path) -> Result<Self, String> {
        let told = |error: &std::io::Error| format!("{}: {}", path.display(), files::plain(error));
        let path = std::fs::canonicalize(path).map_err(|error| told(&error))?;
        let form = Form::of(&path)
            .ok_or_else(|| format!("{}: a definition is a .gh, .ghx or .kd file", path.display()))?;
        let about = std::fs::metadata(&path).map_err(|error| told(&error))?;
        if !about.is_file() || about.len() > LARGEST {
            return Err(format!("{}: this is no definition", path.display()));
        }
        let bytes = std::fs::read(&path).map_err(|error| told(&error))?;
        let (document, units) =
            files::read(form, &bytes).map_err(|error| format!("{}: {error}", path.display()))?;
        let source = Self {
            document,
            name: path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default(),
            hash: Some(blake3::hash(&bytes)),
            fingerprint: Some(katydid_script::fingerprint(&bytes)),
            id: id_of(&path),
            path: Some(path),
            ..Self::empty()
        };
        Ok(source.with_units(units))
    }

    /// The same beside a Rhino model, whose unit and tolerance count.
    pub(crate) fn beside(mut self, name: String, model: RhinoModel) -> Self {
        (self.rules.units, self.rules.tolerance) = (model.units, model.tolerance);
        self.model = Some(Attached { name, model: Arc::new(model) });
        self
    }

    /// The same beside the Rhino model of a file.
    pub(crate) fn with_model(self, path: &Path) -> Result<Self, String> {
        let bytes =
            std::fs::read(path).map_err(|error| format!("{}: {}", path.display(), files::plain(&error)))?;
        let model = RhinoModel::read(&bytes).map_err(|error| format!("{}: {error}", path.display()))?;
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        Ok(self.beside(name, model))
    }

    /// A document of its own with what is in it, under another name: it is not saved over its original.
    pub(crate) fn copied(self, name: String) -> Self {
        let (copy_of, id) = (self.path, chance());
        Self { name, id, copy_of, path: None, hash: None, ..self }
    }

    /// Where it comes from, as far as that decides which files it may read.
    pub(crate) fn origin(&self) -> Origin<'_> {
        self.path.as_deref().or(self.copy_of.as_deref()).map_or(Origin::Sent, Origin::File)
    }

    fn with_units(mut self, units: Option<Units>) -> Self {
        self.rules.units = units.unwrap_or(self.rules.units);
        self
    }
}

/// The id of the document that is kept in a file: the same whenever it is opened, so that a page finds it again.
pub(crate) fn id_of(path: &Path) -> String {
    let hash = blake3::hash(path.as_os_str().as_encoded_bytes()).to_hex();
    hash.get(..20).unwrap_or_default().to_owned()
}

/// An id that nobody guesses.
fn chance() -> String {
    uuid::Uuid::new_v4().simple().to_string()
}
