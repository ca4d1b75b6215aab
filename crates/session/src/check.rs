use std::collections::BTreeMap;

use katydid_component::registry;
use katydid_definition::archive::Limits;
use katydid_definition::document::{ClusterContent, Document, Object};
use serde::Serialize;
use uuid::Uuid;

/// What a definition needs, and whether it is there.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Default)]
pub struct Check {
    /// The working objects: clusters opened, annotations left out.
    pub objects: usize,
    /// The component types that are missing, most used first.
    pub unsupported: Vec<Unsupported>,
    /// Whether nothing is missing.
    pub runnable: bool,
}

/// A component type that Katydid does not have.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Unsupported {
    /// Its name.
    pub name: String,
    /// Its type id.
    pub component: Uuid,
    /// The plug-in it comes from.
    pub plugin: Option<String>,
    /// Why it cannot be had, where that is known.
    pub reason: Option<String>,
    /// How many objects are of this type.
    pub count: usize,
}

/// Looks through a document and the clusters in it.
pub fn check(document: &Document) -> Check {
    let mut found = BTreeMap::new();
    let objects = count(document, &mut found);
    let mut unsupported: Vec<Unsupported> = found.into_values().collect();
    unsupported.sort_by(|a, b| b.count.cmp(&a.count).then_with(|| a.name.cmp(&b.name)));
    Check { objects, runnable: unsupported.is_empty(), unsupported }
}

fn count(document: &Document, found: &mut BTreeMap<(Uuid, String), Unsupported>) -> usize {
    let mut objects = 0;
    for object in &document.objects {
        if object.is_annotation() {
            continue;
        }
        let reason = match object.cluster(&Limits::default()) {
            Some(Ok(ClusterContent::Open { document, .. })) => {
                objects += count(&document, found);
                continue;
            }
            Some(Ok(ClusterContent::Locked)) => Some("the cluster is locked by a password".to_owned()),
            Some(Ok(ClusterContent::File(path))) => Some(format!("the cluster is in another file, {path}")),
            Some(Err(error)) => Some(format!("the cluster is broken: {error}")),
            None if registry::by_guid(object.component).is_some() => {
                objects += 1;
                continue;
            }
            None => registry::unsupported(object.component).map(|known| known.reason.to_owned()),
        };
        objects += 1;
        let plugin = plugin(document, object);
        let key = (object.component, plugin.clone().or_else(|| reason.clone()).unwrap_or_default());
        let missing = || Unsupported {
            name: object.name.clone(),
            component: object.component,
            plugin,
            reason,
            count: 0,
        };
        found.entry(key).or_insert_with(missing).count += 1;
    }
    objects
}

fn plugin(document: &Document, object: &Object) -> Option<String> {
    object.lib.and_then(|lib| document.library(lib)).map(|library| library.name.clone())
}
