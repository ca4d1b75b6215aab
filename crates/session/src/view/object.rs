//! Objects as the canvas shows them.

use katydid_component::{Component, registry};
use katydid_definition::archive::Limits;
use katydid_definition::document::{Annotation, ClusterContent, Document, Object, ObjectKind, Side, ids};

use crate::check::is_run;
use crate::controls;
use crate::protocol::{ObjectKindView, ObjectView, Support};
use crate::view::implied::Names;
use crate::view::{control, port, size, strip};

/// An object as the canvas shows it. Bounds of groups are those of their members: [`super::state`] has them.
pub(super) fn view(document: &Document, object: &Object, names: &Names) -> ObjectView {
    let component = registry::by_guid(object.component);
    let control = control::control(object);
    let kind = match object.kind {
        ObjectKind::Annotation(Annotation::Group) => ObjectKindView::Group,
        ObjectKind::Annotation(Annotation::Scribble) => ObjectKindView::Scribble,
        ObjectKind::Annotation(Annotation::Sketch) => ObjectKindView::Sketch,
        _ if object.component == ids::RELAY => ObjectKindView::Relay,
        _ if object.component == ids::CLUSTER => ObjectKindView::Cluster,
        _ if controls::of(object.component).is_some_and(|row| row.has_face) => ObjectKindView::Control,
        ObjectKind::Parameter => ObjectKindView::Parameter,
        ObjectKind::Component => ObjectKindView::Component,
    };
    ObjectView {
        id: object.id,
        component: object.component,
        kind,
        name: object.name.clone(),
        nickname: names.get(&object.id).unwrap_or(&object.nickname).clone(),
        bounds: size::bounds(object),
        inputs: port::ports(object, Side::Input),
        outputs: port::ports(object, Side::Output),
        disabled: object.locked,
        hidden: object.hidden,
        previews: previews(component, object),
        variable_inputs: port::is_variable(object, component, Side::Input),
        variable_outputs: port::is_variable(object, component, Side::Output),
        support: support(document, object, component),
        strip: strip::strip(object),
        control,
    }
}

/// Whether an object can have geometry to show: one of its outputs gives some, or it draws by itself.
fn previews(component: Option<&Component>, object: &Object) -> bool {
    if object.is_annotation() {
        return false;
    }
    let draws = component.is_some_and(|c| c.tab == "Display" && c.outputs.is_empty());
    let shown = |(k, port): (usize, &katydid_definition::document::Port)| {
        port::kind(port, component.and_then(|c| c.output(k)).map(|d| d.kind)).is_geometry()
    };
    draws || object.component == ids::CLUSTER || object.outputs.iter().enumerate().any(shown)
}

/// Whether Katydid can run an object, and why not.
pub(crate) fn support(document: &Document, object: &Object, component: Option<&Component>) -> Support {
    if object.is_annotation() {
        return Support::Yes;
    }
    let plugin = object.lib.and_then(|lib| document.library(lib)).map(|library| library.name.clone());
    let no = |reason: String| Support::No { plugin: plugin.clone(), reason };
    if object.component == ids::CLUSTER {
        return match object.cluster(&Limits::default()) {
            Some(Ok(ClusterContent::Locked)) => no("the cluster is locked by a password".to_owned()),
            Some(Ok(ClusterContent::File(path))) => no(format!("the cluster is in another file, {path}")),
            Some(Err(error)) => no(format!("the cluster is broken: {error}")),
            _ => Support::Yes,
        };
    }
    // A script says with its result whether it may run.
    if component.is_some() || object.script().is_some_and(|script| is_run(&script)) {
        return Support::Yes;
    }
    let known = registry::unsupported(object.component).map(|known| known.reason.to_owned());
    no(known.unwrap_or_else(|| match &plugin {
        Some(plugin) => format!("it belongs to the plug-in {plugin}"),
        None => "Katydid does not know this component".to_owned(),
    }))
}
