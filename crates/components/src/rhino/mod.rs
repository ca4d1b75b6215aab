//! The Rhino tab: what reads, makes and takes apart the content of a Rhino model.

mod annotation;
mod block;
mod content;
mod linetype;
mod object;
mod query;

use std::sync::Arc;

use katydid_component::{Context, Message, ModelLack, RhinoModel};
use katydid_data::{Content, Kind, ModelLayer, ModelLinetype, ModelObject, Value};

/// The model, or the warning that there is none.
pub(crate) fn model<'a>(context: &Context<'a>) -> Result<&'a RhinoModel, Message> {
    context.model().ok_or_else(|| {
        let lack = ModelLack { kind: Kind::Generic, objects: 0, has_model: false };
        Message::warning("Needs the Rhino model: none is given (katydid run FILE --model MODEL.3dm)")
            .lacking(lack)
    })
}

/// A value as content: geometry out of the model untouched is the object that it is of, other geometry an object
/// without attributes. None for what is no content.
fn content_of(context: &Context<'_>, value: &Value) -> Option<Arc<Content>> {
    let found = context.model().and_then(|model| model.object_of(value)).map(|object| &object.content);
    match found.unwrap_or(value) {
        Value::Content(content) => Some(content.clone()),
        geometry if geometry.kind().is_geometry() => {
            Some(Arc::new(Content::Object(ModelObject::new(geometry.clone()))))
        }
        _ => None,
    }
}

/// A value as an object of a model. A block placed in space is one too.
fn object_of(context: &Context<'_>, value: &Value) -> Result<ModelObject, Message> {
    let content = content_of(context, value);
    match content.as_deref() {
        Some(Content::Object(object)) => Ok(object.clone()),
        Some(Content::Instance(_)) => Ok(ModelObject::new(value.clone())),
        _ => Err(unfit(value, "model object")),
    }
}

/// A value as a layer: a layer, or the path of one, which the model need not have.
fn layer_of(context: &Context<'_>, value: &Value) -> Result<Arc<ModelLayer>, Message> {
    match value {
        Value::Text(path) => {
            let known = context.model().and_then(|model| model.layer(path)).cloned();
            Ok(known.unwrap_or_else(|| Arc::new(ModelLayer::at(path.clone()))))
        }
        Value::Content(content) => match &**content {
            Content::Layer(layer) => Ok(layer.clone()),
            _ => Err(unfit(value, "layer")),
        },
        _ => Err(unfit(value, "layer")),
    }
}

/// A value as a linetype: a linetype, or the name of one that the model has or every model has.
fn linetype_of(context: &Context<'_>, value: &Value) -> Result<Arc<ModelLinetype>, Message> {
    match value {
        Value::Text(name) => {
            let known = context.model().and_then(|model| model.linetype(name)).cloned();
            match known {
                Some(known) => Ok(known),
                None if name.eq_ignore_ascii_case("Continuous") => Ok(Arc::new(ModelLinetype::default())),
                None => Err(Message::warning(format!("The linetype {name} is not known: no model has it"))),
            }
        }
        Value::Content(content) => match &**content {
            Content::Linetype(linetype) => Ok(linetype.clone()),
            _ => Err(unfit(value, "linetype")),
        },
        _ => Err(unfit(value, "linetype")),
    }
}

fn unfit(value: &Value, what: &str) -> Message {
    let kind = match value {
        Value::Content(content) => content.type_name(),
        other => other.kind().name(),
    };
    Message::error(format!("A {kind} is no {what}"))
}
