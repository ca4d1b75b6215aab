//! A definition made of one component, which clients name by its type id.

use katydid_component::{Access, registry};
use katydid_data::Kind;
use katydid_definition::document::Document;
use uuid::Uuid;

use super::interface::{ANY_NUMBER, Data, Form, Input, Interface, Output, form};
use crate::Fault;

/// The document with the component, what it asks for and gives, and what it does.
pub(super) fn of(component: Uuid) -> Result<(Document, Interface, &'static str), Fault> {
    let known = registry::by_guid(component).ok_or_else(|| match registry::unsupported(component) {
        Some(known) => Fault::not_supported(known.name),
        None => Fault::not_found(format!("There is no component with the id {component}")),
    })?;
    let object = katydid_session::new_object(component, Uuid::from_u128(1))
        .map_err(|refusal| Fault::not_found(refusal.to_string()))?;
    let mut interface = Interface::default();
    for (k, port) in object.inputs.iter().enumerate() {
        let Some(declared) = known.input(k) else { continue };
        interface.inputs.push(Input {
            type_name: declared.kind.name(),
            prompt: Some(declared.help.to_owned()),
            at_least: i32::from(!declared.optional && declared.default.is_none()),
            at_most: if declared.access == Access::Item { 1 } else { ANY_NUMBER },
            tree_access: declared.access == Access::Tree,
            ..Input::new(port.nickname.clone(), 0, k, form(declared.kind, Form::Of(Kind::Text)))
        });
    }
    for (output, port) in object.outputs.iter().enumerate() {
        interface.outputs.push(Output {
            name: port.nickname.clone(),
            data: Data::Given { object: 0, output },
            type_name: known.output(output).map_or("Generic Data", |port| port.kind.name()),
            height: 0.0,
        });
    }
    let mut document = Document::new();
    document.objects.push(object);
    Ok((document, interface, known.help))
}
