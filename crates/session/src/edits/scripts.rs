//! Script components: their text, and what their inputs make of their data.

use base64::{Engine, engine::general_purpose::STANDARD as BASE64};
use katydid_definition::archive::Chunk;
use katydid_definition::document::{Object, PortRef, Side, TypeHint, ids};
use uuid::{Uuid, uuid};

use crate::Refusal;
use crate::controls::{short, unfit};
use crate::protocol::AccessView;

/// The parameter type of an input of Grasshopper 1's script components.
const SCRIPT_VARIABLE: Uuid = uuid!("84fa917c-1ed8-4db3-8be1-7bdc4a6495a2");
/// That of inputs and outputs of Rhino 8's.
const RHINO_8_VARIABLE: Uuid = uuid!("08908df5-fa14-4982-9ab2-1aa0927566aa");

/// Gives a script another text, in the form in which its component keeps it. `parts` are its further members and its
/// imports, which only C# and VB of Grasshopper 1 have.
pub(super) fn write(object: &mut Object, text: &str, parts: [Option<&str>; 2]) -> Result<(), Refusal> {
    let Some(script) = object.script() else { return Err(unfit(object, "it is no script")) };
    if script.from_wire {
        return Err(unfit(object, "its text comes in over a wire"));
    }
    short(text)?;
    let is_gh_python = object.component == ids::GH_PYTHON;
    let container = object.container_mut();
    if let Some(chunk) = container.child_mut("Script") {
        if let Some(text) = written(text, &script.text) {
            chunk.set("Text", BASE64.encode(text));
        }
    } else if is_gh_python {
        if let Some(text) = written(text, &script.text) {
            container.set("CodeInput", text);
        }
    } else if let Some(code) = container.child_mut("UserCode") {
        if written(text, &script.text).is_some() {
            lines(code, text);
        }
    } else {
        let [additional, using] = parts;
        for (name, new, old) in [
            ("ScriptSource", Some(text), &script.text),
            ("AdditionalSource", additional, &script.additional),
            ("UsingSource", using, &script.using),
        ] {
            if let Some(text) = new.map(short).transpose()?.and_then(|new| written(new, old)) {
                container.set(name, text);
            }
        }
    }
    object.refresh();
    Ok(())
}

/// A text with the line ends of the one that it replaces; none where they say the same.
fn written(new: &str, old: &str) -> Option<String> {
    let plain = new.replace("\r\n", "\n");
    if plain == old.replace("\r\n", "\n") {
        return None;
    }
    Some(if old.contains("\r\n") { plain.replace('\n', "\r\n") } else { plain })
}

/// Grasshopper 0.8 kept a text line by line.
fn lines(code: &mut Chunk, text: &str) {
    code.remove("Line");
    let mut count = 0;
    for (k, line) in (0..).zip(text.split('\n')) {
        code.set_at("Line", k, line.trim_end_matches('\r'));
        count = k + 1;
    }
    code.set("LineCount", count);
}

/// Gives an input another type hint, by its name.
pub(super) fn hint(object: &mut Object, at: PortRef, name: &str) -> Result<(), Refusal> {
    let found = TypeHint::offered_by(object.component).find(|(hint, _)| hint.is(name));
    let Some((_, id)) = found else { return Err(unfit(object, "its inputs have no hint of that name")) };
    let chunk = input(object, at)?;
    chunk.set("TypeHintID", id);
    // It names the .NET class of the hint that was.
    chunk.remove_children("ConverterData");
    object.refresh();
    Ok(())
}

/// Gives an input another access.
pub(super) fn access(object: &mut Object, at: PortRef, access: AccessView) -> Result<(), Refusal> {
    let chunk = input(object, at)?;
    let access = match access {
        AccessView::Item => 0,
        AccessView::List => 1,
        AccessView::Tree => 2,
    };
    if chunk.i32("Access").is_some() {
        chunk.set("Access", access);
    }
    chunk.set("ScriptParamAccess", access);
    object.refresh();
    Ok(())
}

fn input(object: &mut Object, at: PortRef) -> Result<&mut Chunk, Refusal> {
    let refusal = unfit(object, "only the inputs of a script have that");
    let place = object.inputs.get(at.port).map(|port| port.place);
    let is_variable = matches!(place, Some(katydid_definition::document::PortPlace::Variable(..)));
    if at.side != Side::Input || object.script().is_none() || !is_variable {
        return Err(refusal);
    }
    place.and_then(|place| place.find_mut(object.container_mut())).ok_or(refusal)
}

/// The parameter type of a new port of a script.
pub(super) fn port_type(object: &Object, side: Side) -> Uuid {
    let is_rhino_8 = object.container().child("Script").is_some();
    match side {
        _ if is_rhino_8 => RHINO_8_VARIABLE,
        Side::Input => SCRIPT_VARIABLE,
        Side::Output => ids::DATA,
    }
}

/// Gives the last port of a side what Grasshopper gives a new one.
pub(super) fn equip(object: &mut Object, side: Side) {
    let is_rhino_8 = object.container().child("Script").is_some();
    let place = object.ports(side).last().map(|port| port.place);
    let Some(chunk) = place.and_then(|place| place.find_mut(object.container_mut())) else { return };
    if side == Side::Input {
        chunk.set("AllowTreeAccess", true);
        chunk.set("ScriptParamAccess", 0);
        chunk.set("ShowTypeHints", true);
    }
    if is_rhino_8 {
        chunk.set("ScriptParameterVersion", 1);
    }
    object.refresh();
}
