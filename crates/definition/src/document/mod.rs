//! A definition as objects, ports and wires, over the tree of the archive.
//!
//! [`Document::read`] opens a .gh or .ghx file. Every [`Object`] keeps its own part of the tree, and the
//! document keeps the rest, so that a save writes back what nobody touched exactly as it came.
//!
//! ```
//! use katydid_definition::archive::Limits;
//! use katydid_definition::document::{Document, Object, ids};
//!
//! let mut document = Document::new();
//! let id = uuid::Uuid::from_u128(1);
//! let mut toggle = Object::new_parameter(ids::BOOLEAN_TOGGLE, "Boolean Toggle", "On", id);
//! toggle.set_toggle(true)?;
//! document.objects.push(toggle);
//!
//! let again = Document::read(&document.to_gh()?, &Limits::default())?;
//! assert_eq!(again.objects[0].name, "Boolean Toggle");
//! # Ok::<(), katydid_definition::Error>(())
//! ```

mod build;
mod cluster;
mod difference;
mod edit;
mod header;
mod hints;
pub mod ids;
mod object;
mod on_data;
mod persistent;
mod port;
mod script;
pub mod special;
mod stored;
mod stored_write;
mod user_object;
mod wires;

pub use build::NewPort;
pub use cluster::{ClusterContent, Hook, MOST_NESTED};
pub use difference::{Difference, Misfit};
pub use header::{Header, Library};
pub use hints::TypeHint;
pub use object::{Annotation, Fields, Object, ObjectKind};
pub use on_data::OnData;
pub use persistent::{Branch, Persistent, format_path, parse_path};
pub use port::{Access, Mapping, Modifiers, Port, PortPlace, Side, WireDisplay};
pub use script::{Script, ScriptLanguage};
pub use special::Special;
pub use stored::{LoftOptions, Material, MeshSettings, Stored, StoredGeometry};
pub use user_object::UserObject;
pub use wires::{Lookup, PortRef, Wire};

use std::sync::Arc;

use crate::archive::{self, Archive, Chunk, Encoding, ItemValue, Limits, Version};
use crate::{Error, Result};

/// A definition: what a .gh or .ghx file, or the inside of a cluster, says.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    /// Who wrote it, with what, and how it is shown.
    pub header: Header,
    /// The add-ons that its objects come from.
    pub libraries: Vec<Library>,
    /// The objects in the file's order, which is the order they are drawn in.
    pub objects: Vec<Object>,
    /// The encoding it was read from.
    pub encoding: Encoding,
    /// What was odd about the archive.
    pub notes: Vec<String>,
    /// How many clusters it is inside of.
    nesting: usize,
    /// The tree without the objects.
    tree: Arc<Chunk>,
    /// What else stood between the objects, and where.
    strangers: Vec<(usize, Chunk)>,
    /// How many objects the file said it had.
    announced: Option<i32>,
    /// The numbers of the objects as they came.
    numbers: Vec<Option<i32>>,
}

impl Document {
    /// A document without objects, as a new file of Grasshopper 1.0.8 has it.
    pub fn new() -> Self {
        let version = |major, minor, revision| ItemValue::Version(Version { major, minor, revision });
        let mut definition = Chunk::new("Definition");
        definition.set("plugin_version", version(1, 0, 8));
        let mut header = Chunk::new("DocumentHeader");
        header.set("DocumentID", uuid::Uuid::nil());
        header.set("Preview", "Shaded");
        header.set("PreviewMeshType", 1);
        header.set("PreviewNormal", archive::Colour::new(100, 150, 0, 0));
        header.set("PreviewSelected", archive::Colour::new(100, 0, 150, 0));
        let mut properties = Chunk::new("DefinitionProperties");
        properties.set("Date", ItemValue::Date(0));
        properties.set("Description", "");
        properties.set("Name", "");
        let mut objects = Chunk::new("DefinitionObjects");
        objects.set("ObjectCount", 0);
        definition.chunks = vec![header, properties, objects];
        let mut root = Chunk::new("Root");
        root.set("ArchiveVersion", version(0, 2, 2));
        root.chunks = vec![definition];
        Self::take_apart(root, Encoding::Binary, Vec::new(), 0)
    }

    /// Reads a .gh or .ghx file.
    ///
    /// # Errors
    /// When the bytes are no archive (see [`archive::read`]), or one without a definition in it.
    pub fn read(bytes: &[u8], limits: &Limits) -> Result<Self> {
        Self::from_archive(archive::read(bytes, limits)?)
    }

    /// Reads the byte array of a cluster.
    ///
    /// # Errors
    /// As for [`read`](Self::read).
    pub fn from_cluster(bytes: &[u8], limits: &Limits) -> Result<Self> {
        Self::read(bytes, limits)
    }

    /// The document in an archive.
    ///
    /// # Errors
    /// When there is no definition in the archive: it may be a user object.
    pub fn from_archive(archive: Archive) -> Result<Self> {
        Self::nested(archive, 0)
    }

    pub(super) fn nested(archive: Archive, nesting: usize) -> Result<Self> {
        if definition(&archive.root).is_none() {
            let reason = if archive.root.guid("BaseID").is_some() {
                "it is a user object, not a definition"
            } else {
                "it holds no definition"
            };
            return Err(Error::Document { place: archive.root.name, reason: reason.to_owned() });
        }
        Ok(Self::take_apart(archive.root, archive.encoding, archive.notes, nesting))
    }

    fn take_apart(mut tree: Chunk, encoding: Encoding, notes: Vec<String>, nesting: usize) -> Self {
        let mut document = Self {
            header: Header::read(&tree, definition(&tree)),
            libraries: Library::read_all(definition(&tree)),
            objects: Vec::new(),
            encoding,
            notes,
            nesting,
            tree: Arc::default(),
            strangers: Vec::new(),
            announced: None,
            numbers: Vec::new(),
        };
        if let Some(list) = definition_mut(&mut tree).and_then(|d| d.child_mut("DefinitionObjects")) {
            document.announced = list.i32("ObjectCount");
            for (at, chunk) in std::mem::take(&mut list.chunks).into_iter().enumerate() {
                if chunk.name == "Object" {
                    let mut object = Object::from_chunk(chunk);
                    object.nesting = nesting;
                    document.objects.push(object);
                } else {
                    document.strangers.push((at, chunk));
                }
            }
        }
        document.numbers = document.objects.iter().map(|object| object.chunk().index).collect();
        document.tree = Arc::new(tree);
        document
    }

    /// The archive with everything in its place. Objects are numbered anew when some came, went or moved.
    pub fn to_archive(&self) -> Archive {
        let mut chunks: Vec<Chunk> = self.objects.iter().map(|object| object.chunk().clone()).collect();
        let mut root = Chunk::clone(&self.tree);
        let changed = !chunks.iter().map(|chunk| &chunk.index).eq(&self.numbers);
        if changed {
            for (index, chunk) in (0..).zip(&mut chunks) {
                chunk.index = Some(index);
            }
        }
        for (at, chunk) in &self.strangers {
            chunks.insert((*at).min(chunks.len()), chunk.clone());
        }
        if let Some(definition) = definition_mut(&mut root) {
            if definition.child("DefinitionObjects").is_none() && !chunks.is_empty() {
                definition.set_child(Chunk::new("DefinitionObjects"));
            }
            if let Some(list) = definition.child_mut("DefinitionObjects") {
                list.chunks = chunks;
                if changed {
                    list.set("ObjectCount", i32::try_from(self.objects.len()).unwrap_or(i32::MAX));
                }
            }
        }
        Archive { root, encoding: self.encoding, notes: Vec::new() }
    }

    /// A .gh file.
    ///
    /// # Errors
    /// As for [`archive::write_gh`].
    pub fn to_gh(&self) -> Result<Vec<u8>> {
        archive::write_gh(&self.to_archive().root)
    }

    /// A .ghx file.
    ///
    /// # Errors
    /// As for [`archive::write_ghx`].
    pub fn to_ghx(&self) -> Result<String> {
        archive::write_ghx(&self.to_archive().root)
    }

    /// The file in the encoding it came in.
    ///
    /// # Errors
    /// As for [`to_gh`](Self::to_gh) and [`to_ghx`](Self::to_ghx).
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        self.to_archive().to_bytes()
    }

    /// The tree without the objects, to be looked up in or changed: thumbnail, author, settings of add-ons.
    pub fn tree_mut(&mut self) -> &mut Chunk {
        Arc::make_mut(&mut self.tree)
    }

    /// The tree without the objects.
    pub fn tree(&self) -> &Chunk {
        &self.tree
    }

    /// How many clusters the document is inside of; 0 for a file.
    pub fn nesting(&self) -> usize {
        self.nesting
    }

    /// The library with this id.
    pub fn library(&self, id: uuid::Uuid) -> Option<&Library> {
        self.libraries.iter().find(|library| library.id == id)
    }
}

impl Default for Document {
    fn default() -> Self {
        Self::new()
    }
}

/// The chunk that the definition's parts stand in.
fn definition(root: &Chunk) -> Option<&Chunk> {
    if is_definition(root) { Some(root) } else { root.child("Definition") }
}

fn definition_mut(root: &mut Chunk) -> Option<&mut Chunk> {
    if is_definition(root) { Some(root) } else { root.child_mut("Definition") }
}

/// A cluster's root is the definition itself, and is called Document.
fn is_definition(root: &Chunk) -> bool {
    root.child("Definition").is_none()
        && (root.child("DefinitionObjects").is_some() || root.child("DocumentHeader").is_some())
}
