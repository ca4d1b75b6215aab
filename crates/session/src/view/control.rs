//! The faces of controls, as the file has them.

use katydid_definition::document::{Object, Script, TypeHint, ids};

use crate::protocol::Control;

/// What an object has of its own; none for an ordinary component.
pub(crate) fn control(object: &Object) -> Option<Control> {
    if let Some(script) = object.script() {
        return Some(scripted(object, script));
    }
    crate::controls::view(object)
}

/// A script, with line feeds alone between its lines.
fn scripted(object: &Object, script: Script) -> Control {
    let plain = |text: String| text.replace("\r\n", "\n");
    let container = object.container();
    let is_in_parts =
        [ids::C_SHARP, ids::VB].contains(&object.component) && container.child("UserCode").is_none();
    Control::Script {
        language: script.language.to_string(),
        text: plain(script.text),
        additional: is_in_parts.then(|| plain(script.additional)),
        using: is_in_parts.then(|| plain(script.using)),
        from_wire: script.from_wire,
        hints: TypeHint::offered_by(object.component).map(|(hint, _)| hint.name.to_owned()).collect(),
    }
}
