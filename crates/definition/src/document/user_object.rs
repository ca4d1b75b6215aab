use uuid::Uuid;

use super::Object;
use crate::archive::{self, Archive, Chunk, Limits};
use crate::{Error, Result};

/// A .ghuser file: one object that somebody keeps for later, with a place in the ribbon.
#[derive(Debug, Clone, PartialEq)]
pub struct UserObject {
    /// The component type.
    pub component: Uuid,
    /// The user object's own id.
    pub id: Uuid,
    /// The name.
    pub name: String,
    /// The short name.
    pub nickname: String,
    /// What it does.
    pub description: String,
    /// The tab in the ribbon.
    pub category: String,
    /// The panel in the tab.
    pub subcategory: String,
    /// What stands in the object's container.
    pub container: Chunk,
}

impl UserObject {
    /// Reads a .ghuser file.
    ///
    /// # Errors
    /// When the file or the object in it is broken, or there is no user object in it.
    pub fn read(bytes: &[u8], limits: &Limits) -> Result<Self> {
        Self::from_archive(&archive::read(bytes, limits)?, limits)
    }

    /// The user object in an archive.
    ///
    /// # Errors
    /// As for [`read`](Self::read).
    pub fn from_archive(archive: &Archive, limits: &Limits) -> Result<Self> {
        let root = &archive.root;
        // The items stand in the root; look one level down as well.
        let mut places = std::iter::once(root).chain(&root.chunks);
        let chunk = places.find(|chunk| chunk.guid("BaseID").is_some()).unwrap_or(root);
        let missing =
            |what: &str| Error::Document { place: root.name.clone(), reason: format!("it has no {what}") };
        let text = |name| chunk.str(name).unwrap_or_default().to_owned();
        let component = chunk.guid("BaseID").ok_or_else(|| missing("BaseID: it is no user object"))?;
        let inside = chunk.bytes("Object").ok_or_else(|| missing("object inside"))?;
        Ok(Self {
            component,
            id: chunk.guid("InstanceGuid").unwrap_or_default(),
            name: text("Name"),
            nickname: text("NickName"),
            description: text("Description"),
            category: text("Category"),
            subcategory: text("SubCategory"),
            container: archive::read(inside, limits)?.root,
        })
    }

    /// The object as it would be placed on the canvas.
    pub fn to_object(&self) -> Object {
        let mut object = Object::new(self.component, &self.name);
        *object.container_mut() =
            Chunk { name: "Container".to_owned(), index: None, ..self.container.clone() };
        object.refresh();
        object
    }
}
