//! What a definition needs, whether it is there, and what would be missing without it.

mod causes;
mod hanging;
mod outputs;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use katydid_component::{plugin_of_library, registry};
use katydid_definition::archive::Limits;
use katydid_definition::document::{ClusterContent, Document, Object, Script, ScriptLanguage, Side};
use serde::Serialize;
use uuid::Uuid;

pub use outputs::{MissingOutput, Outputs};

/// What a definition needs, and whether it is there.
#[derive(Debug, Clone, Serialize, Default)]
pub struct Check {
    /// The working objects: clusters opened, annotations left out.
    pub objects: usize,
    /// The component types that are missing, most used first.
    pub unsupported: Vec<Unsupported>,
    /// Whether nothing is missing.
    pub runnable: bool,
    /// Its outputs, and which of them would be missing.
    pub outputs: Outputs,
    /// The scripts, which whoever runs scripts has to look at: they are not missing by themselves.
    #[serde(skip)]
    pub scripts: Vec<ScriptObject>,
}

/// A script component.
#[derive(Debug, Clone)]
pub struct ScriptObject {
    /// Its name on the canvas.
    pub title: String,
    /// Its type id.
    pub component: Uuid,
    /// Its script.
    pub script: Script,
    /// The component, whose inputs and outputs are the variables of the script.
    pub object: Object,
}

impl Check {
    /// Adds what one of the scripts needs and has not. [`Check::look_at_outputs`] takes it into account.
    pub fn lacks(&mut self, object: &ScriptObject, what: &str) {
        let reason = Some(format!("the script {} needs it", object.title));
        match self.unsupported.iter_mut().find(|own| own.name == what && own.reason.is_some()) {
            Some(known) => {
                known.count += 1;
                known.objects.push(object.object.id);
            }
            None => self.unsupported.push(Unsupported {
                name: what.to_owned(),
                component: object.component,
                plugin: None,
                known: None,
                reason,
                count: 1,
                objects: vec![object.object.id],
                outputs: 0,
            }),
        }
        self.runnable = false;
    }

    /// Looks anew which outputs hang on what is missing, in the document that was checked.
    pub fn look_at_outputs(&mut self, document: &Document) {
        self.outputs = Outputs::of(document, &mut self.unsupported);
    }
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
    /// What the file knows of the plug-in and of the component; none for what is of no plug-in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub known: Option<KnownOfPlugin>,
    /// Why it cannot be had, where that is known.
    pub reason: Option<String>,
    /// How many objects are of this type.
    pub count: usize,
    /// The ids of these objects, in the order of the file; some may lie in clusters.
    pub objects: Vec<Uuid>,
    /// How many outputs of the definition would be missing without them.
    pub outputs: usize,
}

/// What a file knows of an object of a plug-in.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct KnownOfPlugin {
    /// Who made the plug-in; empty where the file does not say.
    pub author: String,
    /// The version of the plug-in; empty where the file does not say.
    pub version: String,
    /// What the component does, in its author's words; empty where the file does not say.
    pub description: String,
    /// The names of its inputs.
    pub inputs: Vec<String>,
    /// The names of its outputs.
    pub outputs: Vec<String>,
    /// Whether Katydid stands for other components of the plug-in.
    pub others_run: bool,
}

fn known(document: &Document, object: &Object) -> Option<KnownOfPlugin> {
    let library = document.library(object.lib?)?;
    let names = |side: Side| object.ports(side).iter().map(|port| port.name.clone()).collect();
    Some(KnownOfPlugin {
        author: library.author.clone(),
        version: library.version.clone(),
        description: object.description.clone(),
        inputs: names(Side::Input),
        outputs: names(Side::Output),
        others_run: plugin_of_library(&library.name).is_some(),
    })
}

/// Looks through a document and the clusters in it.
pub fn check(document: &Document) -> Check {
    let (mut found, mut scripts) = (BTreeMap::new(), Vec::new());
    let objects = count(document, &mut found, &mut scripts);
    let mut unsupported: Vec<Unsupported> = found.into_values().collect();
    unsupported.sort_by(|a, b| b.count.cmp(&a.count).then_with(|| a.name.cmp(&b.name)));
    let outputs = Outputs::of(document, &mut unsupported);
    Check { objects, runnable: unsupported.is_empty(), unsupported, outputs, scripts }
}

fn count(
    document: &Document,
    found: &mut BTreeMap<(Uuid, String), Unsupported>,
    scripts: &mut Vec<ScriptObject>,
) -> usize {
    let mut objects = 0;
    for object in &document.objects {
        if object.is_annotation() || katydid_solver::is_note(document, object) {
            continue;
        }
        if let Some(script) = object.script().filter(is_run) {
            objects += 1;
            scripts.push(ScriptObject {
                title: object.title().to_owned(),
                component: object.component,
                script,
                object: object.clone(),
            });
            continue;
        }
        let reason = match object.cluster(&Limits::default()) {
            Some(Ok(ClusterContent::Open { document, .. })) => {
                objects += count(&document, found, scripts);
                continue;
            }
            Some(Ok(ClusterContent::Locked)) => Some("the cluster is locked by a password".to_owned()),
            Some(Ok(ClusterContent::File(path))) => Some(format!("the cluster is in another file, {path}")),
            Some(Err(error)) => Some(format!("the cluster is broken: {error}")),
            None if katydid_solver::of_object(document, object).is_some() => {
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
            known: known(document, object),
            reason,
            count: 0,
            objects: Vec::new(),
            outputs: 0,
        };
        let kind = found.entry(key).or_insert_with(missing);
        kind.count += 1;
        kind.objects.push(object.id);
    }
    objects
}

/// Whether scripts of its language are run.
pub(crate) fn is_run(script: &Script) -> bool {
    script.is_python() || matches!(script.language, ScriptLanguage::CSharp | ScriptLanguage::VisualBasic)
}

fn plugin(document: &Document, object: &Object) -> Option<String> {
    object.lib.and_then(|lib| document.library(lib)).map(|library| library.name.clone())
}
