use uuid::Uuid;

use crate::archive::{Chunk, Colour, Version};

/// What a file says about itself. Whatever it does not say is absent or empty.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Header {
    /// The version of the archive's layout: 0.2.2 as a rule.
    pub archive_version: Option<Version>,
    /// The version of Grasshopper: 0.9.76 in Rhino 5, 1.0.7 in 6 and 7, 1.0.8 in 8.
    pub plugin_version: Option<Version>,
    /// The document's id.
    pub document_id: Option<Uuid>,
    /// The name; often that of the file.
    pub name: String,
    /// What the document is for.
    pub description: String,
    /// When it was made, in steps of 100 ns since the start of year 1.
    pub date: Option<i64>,
    /// How geometry is shown: `Shaded`, `Wireframe`, `Off`.
    pub preview: String,
    /// The kind of preview meshes: 1 is coarse.
    pub preview_mesh_type: Option<i32>,
    /// The colour of geometry.
    pub preview_normal: Option<Colour>,
    /// The colour of selected geometry.
    pub preview_selected: Option<Colour>,
    /// The author.
    pub author: String,
}

/// An add-on that a document uses.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Library {
    /// The id that objects refer to.
    pub id: Uuid,
    /// The name.
    pub name: String,
    /// Who made it.
    pub author: String,
    /// Its version.
    pub version: String,
}

fn text(chunk: &Chunk, name: &str) -> String {
    chunk.str(name).unwrap_or_default().to_owned()
}

impl Header {
    pub(super) fn read(root: &Chunk, definition: Option<&Chunk>) -> Self {
        let mut header = Self { archive_version: root.version("ArchiveVersion"), ..Self::default() };
        let Some(definition) = definition else { return header };
        header.plugin_version = definition.version("plugin_version");
        if let Some(chunk) = definition.child("DocumentHeader") {
            header.document_id = chunk.guid("DocumentID");
            header.preview = text(chunk, "Preview");
            header.preview_mesh_type = chunk.i32("PreviewMeshType");
            header.preview_normal = chunk.colour("PreviewNormal");
            header.preview_selected = chunk.colour("PreviewSelected");
        }
        if let Some(chunk) = definition.child("DefinitionProperties") {
            header.name = text(chunk, "Name");
            header.description = text(chunk, "Description");
            header.date = chunk.date("Date");
        }
        if let Some(chunk) = definition.child("Author") {
            header.author = text(chunk, "Name");
        }
        header
    }
}

impl Library {
    pub(super) fn read_all(definition: Option<&Chunk>) -> Vec<Self> {
        let list = definition.and_then(|definition| definition.child("GHALibraries"));
        let chunks = list.map(|list| list.children("Library")).unwrap_or_default();
        chunks
            .into_iter()
            .map(|chunk| Self {
                id: chunk.guid("Id").unwrap_or_default(),
                name: text(chunk, "Name"),
                author: text(chunk, "Author"),
                version: text(chunk, "Version"),
            })
            .collect()
    }
}
