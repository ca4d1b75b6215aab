//! Clusters that are entered: their inside is a document of its own, kept as bytes in the object.

use katydid_definition::archive::{self, ItemValue, Limits};
use katydid_definition::document::{ClusterContent, Document, Object};
use uuid::Uuid;

use super::Editor;
use crate::{Refusal, edits};

/// The document inside a cluster.
///
/// # Errors
/// The object is no cluster, or one that is locked, lies in another file or is broken.
pub fn content(cluster: &Object) -> Result<Document, Refusal> {
    let unfit =
        |reason: &str| Refusal::Unfit { object: cluster.title().to_owned(), reason: reason.to_owned() };
    match cluster.cluster(&Limits::default()) {
        None => Err(unfit("it is not a cluster")),
        Some(Err(error)) => Err(unfit(&error.to_string())),
        Some(Ok(ClusterContent::Locked)) => Err(unfit("the cluster is locked by a password")),
        Some(Ok(ClusterContent::File(path))) => {
            Err(unfit(&format!("the cluster is in another file, {path}")))
        }
        Some(Ok(ClusterContent::Open { document, .. })) => Ok(*document),
    }
}

/// The cluster with that id.
fn cluster(document: &Document, id: Uuid) -> Result<&Object, Refusal> {
    document.objects.iter().find(|object| object.id == id).ok_or(Refusal::NoObject(id))
}

/// The document that `within` leads to from `outer`.
pub(crate) fn open(outer: &Document, within: &[Uuid]) -> Result<Document, Refusal> {
    let mut document = outer.clone();
    for &id in within {
        document = content(cluster(&document, id)?)?;
    }
    Ok(document)
}

/// `outer` with another document inside the cluster that `within` leads to.
pub(crate) fn close(outer: &Document, within: &[Uuid], inner: Document) -> Result<Document, Refusal> {
    let Some((&id, rest)) = within.split_first() else { return Ok(inner) };
    let mut outer = outer.clone();
    let at = outer.objects.iter().position(|object| object.id == id).ok_or(Refusal::NoObject(id))?;
    let Some(object) = outer.objects.get_mut(at) else { return Err(Refusal::NoObject(id)) };
    let before = content(object)?;
    let after = close(&before, rest, inner)?;
    if before != after {
        put(object, &after)?;
        edits::tie_ports(object, &before, &after);
    }
    Ok(outer)
}

/// Puts a document inside a cluster, whose ports stay as they are.
fn put(cluster: &mut Object, inner: &Document) -> Result<(), Refusal> {
    let bytes = archive::write_gh(&inner.to_archive().root)?;
    cluster.container_mut().set("ClusterDocument", ItemValue::ByteArray(bytes));
    cluster.refresh();
    Ok(())
}

/// Changes an object inside a cluster, or the object itself where `within` is empty: the places of the objects on the way in, each
/// in the document inside the one before. What is changed must not be a hook: the ports of clusters stay as they are.
///
/// # Errors
/// An object on the way is not there, or is no cluster that can be opened.
pub fn edit_inside<R>(
    object: &mut Object,
    within: &[usize],
    change: impl FnOnce(&mut Object) -> R,
) -> Result<R, Refusal> {
    let Some((&at, rest)) = within.split_first() else { return Ok(change(object)) };
    let mut inner = content(object)?;
    let next = inner.objects.get_mut(at).ok_or_else(|| Refusal::Unfit {
        object: object.title().to_owned(),
        reason: format!("there is no object {at} inside"),
    })?;
    let changed = edit_inside(next, rest, change)?;
    put(object, &inner)?;
    Ok(changed)
}

impl Editor {
    /// The document that `within` leads to.
    pub(crate) fn open(&self, within: &[Uuid]) -> Result<Document, Refusal> {
        open(&self.document, within)
    }

    /// The whole document with another one where `within` leads to.
    pub(crate) fn close(&self, within: &[Uuid], inner: Document) -> Result<Document, Refusal> {
        close(&self.document, within, inner)
    }
}
